//! Which functions do more than give a value.

use std::collections::{HashMap, HashSet};

use crate::intake::items::{Item, Qualifiers};
use crate::intake::token::Token;

/// Functions of GLSL that write to their parameters.
const WRITING: [&str; 6] = ["modf", "frexp", "uaddCarry", "usubBorrow", "umulExtended", "imulExtended"];

/// Variables of the pipeline that a shader writes.
const OUTPUTS: [&str; 14] = [
    "gl_FragColor",
    "gl_FragData",
    "gl_FragDepth",
    "gl_SampleMask",
    "gl_Position",
    "gl_PointSize",
    "gl_ClipDistance",
    "gl_ClipVertex",
    "gl_FrontColor",
    "gl_BackColor",
    "gl_FrontSecondaryColor",
    "gl_BackSecondaryColor",
    "gl_TexCoord",
    "gl_FogFragCoord",
];

/// Names of the functions whose call is more than its value: they have parameters that are written, may write variables of
/// the whole text, discard, or have loops, which may not end for arguments that they are not meant for; and those that
/// call such ones. A name of several functions counts if one of them does.
pub(super) fn of_functions(items: &[Item]) -> HashSet<String> {
    let globals = written_globals(items);
    let mut found: HashSet<String> = WRITING.iter().map(|name| (*name).to_owned()).collect();
    let mut callers: HashMap<&str, Vec<&str>> = HashMap::new();
    let mut next: Vec<&str> = Vec::new();
    for item in items {
        let Item::Function { name, parameters, body, .. } = item else { continue };
        let writes = |t: &Token| globals.contains(&*t.text) || OUTPUTS.contains(&&*t.text);
        let is_out = |t: &Token| t.is("out") || t.is("inout");
        let does = |t: &Token| matches!(&*t.text, "discard" | "for" | "while" | "do") || writes(t);
        if parameters.iter().any(is_out) || body.iter().any(|t| t.is_identifier() && does(t)) {
            next.push(&name.text);
        }
        for called in calls(body) {
            callers.entry(called).or_default().push(&name.text);
        }
    }
    next.extend(WRITING.iter().flat_map(|name| callers.get(name).cloned().unwrap_or_default()));
    while let Some(name) = next.pop() {
        if found.insert(name.to_owned()) {
            next.extend(callers.get(name).into_iter().flatten());
        }
    }
    found
}

/// The names that are called.
fn calls(tokens: &[Token]) -> impl Iterator<Item = &str> {
    tokens.windows(2).filter(|w| w[0].is_identifier() && w[1].is("(")).map(|w| &*w[0].text)
}

/// Variables of the whole text that can be written.
fn written_globals(items: &[Item]) -> HashSet<&str> {
    let mut all = HashSet::new();
    for item in items {
        match item {
            Item::Struct { qualifiers, variables, .. } | Item::Variables { qualifiers, variables, .. }
                if is_written(qualifiers) =>
            {
                all.extend(variables.iter().map(|v| &*v.name.text));
            }
            Item::Block { qualifiers, members, instance, .. } if is_written(qualifiers) => {
                let members = members.iter().flat_map(|member| &member.declarators);
                all.extend(members.chain(instance).map(|v| &*v.name.text));
            }
            _ => {}
        }
    }
    all
}

fn is_written(qualifiers: &Qualifiers) -> bool {
    !["const", "uniform", "in", "attribute"].iter().any(|word| qualifiers.has(word))
}
