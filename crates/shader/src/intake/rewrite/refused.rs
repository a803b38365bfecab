//! What is refused by name.

use std::collections::{HashMap, HashSet};

use crate::intake::Complaint;
use crate::intake::items::Item;
use crate::intake::token::Token;

/// Why a word is refused.
fn reason(word: &str) -> Option<&'static str> {
    Some(match word {
        "subroutine" => "subroutines are not there: call the function, or switch by a uniform",
        "EmitVertex" | "EndPrimitive" | "gl_in" | "gl_PrimitiveIDIn" => "geometry shaders are not there",
        "gl_TessCoord" | "gl_TessLevelOuter" | "gl_TessLevelInner" | "gl_PatchVerticesIn" => {
            "tessellation shaders are not there"
        }
        "local_size_x" | "gl_GlobalInvocationID" | "gl_LocalInvocationID" | "gl_WorkGroupID" => {
            "compute shaders are not there"
        }
        "imageStore" | "imageLoad" | "imageAtomicAdd" => "images that are written are not there",
        "atomic_uint" | "atomicCounterIncrement" | "atomicCounter" | "atomicAdd" => {
            "atomic counters are not there"
        }
        "double" => "numbers in double precision are not there: use float",
        "samplerBuffer" | "isamplerBuffer" | "usamplerBuffer" | "sampler2DRect" | "sampler2DRectShadow" => {
            "buffer and rectangle textures are not there"
        }
        _ if ["image", "iimage", "uimage"].iter().any(|p| is_dimension(word.strip_prefix(p))) => {
            "images that are written are not there"
        }
        _ if word.strip_prefix("dvec").or(word.strip_prefix("dmat")).is_some_and(is_number) => {
            "numbers in double precision are not there: use vec and mat"
        }
        _ => return None,
    })
}

fn is_dimension(rest: Option<&str>) -> bool {
    matches!(
        rest,
        Some("1D" | "2D" | "3D" | "Cube" | "Buffer" | "2DArray" | "1DArray" | "2DRect" | "CubeArray")
    )
}

fn is_number(rest: &str) -> bool {
    !rest.is_empty() && rest.bytes().all(|b| b.is_ascii_digit() || b == b'x')
}

pub(super) fn check(tokens: &[Token]) -> Result<(), Complaint> {
    for (i, token) in tokens.iter().enumerate().filter(|(_, t)| t.is_identifier()) {
        // A name that the text gives to something of its own, such as a member, is no such word.
        let is_member = i > 0 && tokens[i - 1].is(".");
        if let Some(reason) = reason(&token.text).filter(|_| !is_member) {
            return Err(Complaint::unsupported(format!("'{}': {reason}", token.text), token.origin));
        }
    }
    Ok(())
}

/// GLSL has no recursion.
pub(super) fn check_recursion(items: &[Item]) -> Result<(), Complaint> {
    let mut calls: HashMap<&str, Vec<&Token>> = HashMap::new();
    for item in items {
        if let Item::Function { name, body, .. } = item {
            let called = body.windows(2).filter(|w| w[0].is_identifier() && w[1].is("(")).map(|w| &w[0]);
            calls.entry(&name.text).or_default().extend(called);
        }
    }
    let mut done: HashSet<&str> = HashSet::new();
    let mut names: Vec<&str> = calls.keys().copied().collect();
    names.sort_unstable();
    for name in names {
        // Depth first, without recursion of our own: the names on the way, and how many of their calls are behind.
        let mut way: Vec<(&str, usize)> = vec![(name, 0)];
        while let Some((at, next)) = way.last_mut() {
            let (here, call) = (*at, calls.get(at).and_then(|list| list.get(*next)));
            *next += 1;
            let Some(call) = call else {
                done.insert(here);
                way.pop();
                continue;
            };
            let Some((callee, _)) = calls.get_key_value(&*call.text) else { continue };
            // Functions of one name may differ in their parameters; the same name with as many arguments may not be told
            // apart here, so only what calls the name that it defines is suspected.
            if way.iter().any(|(name, _)| name == callee) && !overloaded(items, callee) {
                let message = format!("'{callee}' calls itself: GLSL has no recursion");
                return Err(Complaint::unsupported(message, call.origin));
            }
            if !done.contains(callee) && way.iter().all(|(name, _)| name != callee) {
                way.push((callee, 0));
            }
        }
    }
    Ok(())
}

/// Whether several functions have this name.
fn overloaded(items: &[Item], wanted: &str) -> bool {
    let defined = items.iter().filter(
        |item| matches!(item, Item::Function { name, body, .. } if name.is(wanted) && body.len() > 1),
    );
    defined.count() > 1
}
