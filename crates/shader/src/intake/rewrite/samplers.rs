//! Samplers in arrays and structs: each becomes one of its own, under the name that OpenGL has for it, `maps[1]` or
//! `material.diffuse`.

use std::collections::{HashMap, HashSet};

use super::Rewriter;
use super::bodies::{sampler_type, texture_type};
use super::circuit::{group, has_effect};
use crate::intake::items::{Declarator, Item};
use crate::intake::source::Origin;
use crate::intake::token::{Kind, Token};
use crate::intake::{Complaint, SAMPLER_SUFFIX, TEXTURE_SUFFIX};
use crate::lower::Purpose;

/// Elements of an array of samplers.
const MOST_ELEMENTS: usize = 64;

/// Tokens of a function in which indices that are no constants are written out.
const MOST_TOKENS: usize = 100_000;

/// A uniform that is a struct with samplers, or an array of such.
#[derive(Clone, Debug)]
pub(super) struct Holder {
    /// Its struct.
    structure: String,
    /// How many there are, if it is an array.
    count: Option<usize>,
}

/// A sampler that the text names.
struct Named {
    /// Its name in OpenGL.
    path: String,
    ty: String,
    /// Tokens that belong to it, without the first.
    taken: usize,
}

/// What a name with what is behind it says.
enum Found {
    Nothing,
    Sampler(Named),
    /// An index, from the first token to the last, that is no constant, and how many elements there are.
    Dynamic {
        from: usize,
        to: usize,
        count: usize,
    },
}

/// Whole constants of the text, by name.
pub(super) fn constants(items: &[Item]) -> HashMap<String, i64> {
    let mut all = HashMap::new();
    for item in items {
        let Item::Variables { qualifiers, ty, variables } = item else { continue };
        let whole = ty.first().is_some_and(|t| t.is("int") || t.is("uint"));
        for variable in
            variables.iter().filter(|v| whole && qualifiers.has("const") && v.dimensions.is_empty())
        {
            if let Some(value) = whole_number(&variable.value, &all) {
                all.insert(variable.name.text.to_string(), value);
            }
        }
    }
    all
}

/// The value of numbers, constants, `+`, `-` and `*` from left to right, with `*` first.
fn whole_number(tokens: &[Token], constants: &HashMap<String, i64>) -> Option<i64> {
    if tokens.first().is_some_and(|t| t.is("(")) && group(tokens) == Some(tokens.len()) {
        return whole_number(&tokens[1..tokens.len() - 1], constants);
    }
    if let [token] = tokens {
        return match token.kind {
            Kind::Number => token.text.trim_end_matches(['u', 'U']).parse().ok(),
            _ => constants.get(&*token.text).copied(),
        };
    }
    let (mut depth, mut cut) = (0usize, None);
    for (at, token) in tokens.iter().enumerate() {
        match &*token.text {
            "(" => depth += 1,
            ")" => depth = depth.saturating_sub(1),
            "+" | "-" if depth == 0 && at > 0 => cut = Some(at),
            "*" if depth == 0 && cut.is_none_or(|cut: usize| tokens[cut].is("*")) => cut = Some(at),
            _ => {}
        }
    }
    let (left, right) = (&tokens[..cut?], &tokens[cut? + 1..]);
    let (a, b) = (whole_number(left, constants)?, whole_number(right, constants)?);
    match &*tokens[cut?].text {
        "+" => a.checked_add(b),
        "-" => a.checked_sub(b),
        _ => a.checked_mul(b),
    }
}

/// What stands in the first `[…]`.
fn index(tokens: &[Token]) -> Option<&[Token]> {
    tokens.first().filter(|t| t.is("["))?;
    group(tokens).map(|length| &tokens[1..length - 1])
}

impl Rewriter {
    /// How many elements an array of samplers, or of structs with such, has; `None` of what is no array.
    pub(super) fn element_count(&self, variable: &Declarator) -> Result<Option<usize>, Complaint> {
        let dimensions = &variable.dimensions;
        if dimensions.is_empty() {
            return Ok(None);
        }
        let refused = |message: &str| Err(Complaint::unsupported(message, variable.name.origin));
        match index(dimensions) {
            Some(size) if size.len() + 2 == dimensions.len() => match whole_number(size, &self.constants) {
                Some(count) if (1..=MOST_ELEMENTS as i64).contains(&count) => Ok(Some(count as usize)),
                Some(_) => refused("an array of samplers has 1 to 64 elements here"),
                None => refused("the size of an array of samplers must be a whole constant here"),
            },
            _ => refused("arrays of arrays of samplers are not there"),
        }
    }

    /// A sampler or an array of samplers that the host knows as `path`.
    pub(super) fn declare_samplers(
        &mut self,
        ty: &str,
        path: &str,
        variable: &Declarator,
        origin: Origin,
    ) -> Result<(), Complaint> {
        match self.element_count(variable)? {
            None => self.declare_sampler(ty, path, origin),
            Some(count) => {
                self.sampler_arrays.insert(path.to_owned(), count);
                (0..count).for_each(|i| self.declare_sampler(ty, &format!("{path}[{i}]"), origin));
            }
        }
        Ok(())
    }

    /// A uniform that is a struct with samplers, or an array of such: those stand beside it.
    pub(super) fn hold(&mut self, ty: &str, variable: &Declarator) -> Result<(), Complaint> {
        let Some(members) = self.struct_samplers.get(ty).cloned() else { return Ok(()) };
        let (name, origin) = (variable.name.text.to_string(), variable.name.origin);
        let count = self.element_count(variable)?;
        let of = |i: Option<usize>| i.map_or_else(|| name.clone(), |i| format!("{name}[{i}]"));
        let paths: Vec<String> = match count {
            None => vec![of(None)],
            Some(count) => (0..count).map(|i| of(Some(i))).collect(),
        };
        for path in paths {
            for (member, sampler) in &members {
                self.declare_samplers(sampler, &format!("{path}.{}", member.name.text), member, origin)?;
            }
        }
        self.holders.insert(name, Holder { structure: ty.to_owned(), count });
        Ok(())
    }

    pub(super) fn declare_sampler(&mut self, ty: &str, path: &str, origin: Origin) {
        let (texture, sampler, binding) = (texture_type(ty), sampler_type(ty), self.bindings);
        let name = variable(path);
        self.bindings += 2;
        let text = format!(
            "layout(set=0, binding={binding}) uniform {texture} {name}{TEXTURE_SUFFIX}; \
             layout(set=0, binding={}) uniform {sampler} {name}{SAMPLER_SUFFIX};",
            binding + 1
        );
        self.generated(&text, origin);
        self.given.roles.insert(name, Purpose::Uniform(path.to_owned()));
        self.given.declared.entry(path.to_owned()).or_insert(origin);
        self.samplers.insert(path.to_owned(), ty.to_owned());
    }

    /// The sampler that a name with the tokens behind it says. `local`: those among the function's parameters.
    fn find_sampler(&self, token: &Token, behind: &[Token], local: &HashMap<String, String>) -> Found {
        if let Some(ty) = local.get(&*token.text) {
            return Found::Sampler(Named { path: token.text.to_string(), ty: ty.clone(), taken: 0 });
        }
        let (mut path, mut at) = (token.text.to_string(), 0);
        let holder = self.holders.get(&path);
        let is_known =
            holder.is_some() || self.sampler_arrays.contains_key(&path) || self.samplers.contains_key(&path);
        if !is_known {
            return Found::Nothing;
        }
        let mut dynamic = None;
        let mut take_index = |path: &mut String, at: &mut usize, count: usize| {
            let Some(inside) = index(&behind[*at..]) else { return };
            let number = whole_number(inside, &self.constants).filter(|i| (0..count as i64).contains(i));
            if number.is_none() && dynamic.is_none() {
                dynamic = Some(Found::Dynamic { from: *at, to: *at + inside.len() + 1, count });
            }
            *path = format!("{path}[{}]", number.unwrap_or(0));
            *at += inside.len() + 2;
        };
        if let Some(holder) = holder {
            if let Some(count) = holder.count {
                take_index(&mut path, &mut at, count);
            }
            let [dot, member, ..] = &behind[at..] else { return Found::Nothing };
            let samplers = self.struct_samplers.get(&holder.structure);
            let is_sampler =
                samplers.is_some_and(|all| all.iter().any(|(own, _)| own.name.text == member.text));
            if !dot.is(".") || !is_sampler {
                return Found::Nothing;
            }
            path = format!("{path}.{}", member.text);
            at += 2;
        }
        if let Some(count) = self.sampler_arrays.get(&path) {
            take_index(&mut path, &mut at, *count);
        }
        match (dynamic, self.samplers.get(&path)) {
            (Some(dynamic), _) => dynamic,
            (None, Some(ty)) => Found::Sampler(Named { path, ty: ty.clone(), taken: at }),
            (None, None) => Found::Nothing,
        }
    }

    /// What stands for a sampler, and how many of the tokens behind belong to it.
    pub(super) fn sampler_use(
        &self,
        token: &Token,
        behind: &[Token],
        local: &HashMap<String, String>,
        to_function: bool,
    ) -> Option<(String, usize)> {
        // A sampler may be called `texture`, as the function is.
        if behind.first().is_some_and(|t| t.is("(")) {
            return None;
        }
        let Found::Sampler(Named { path, ty, taken }) = self.find_sampler(token, behind, local) else {
            return None;
        };
        let name = variable(&path);
        let halves = format!("{name}{TEXTURE_SUFFIX}, {name}{SAMPLER_SUFFIX}");
        Some((if to_function { halves } else { format!("{ty}({halves})") }, taken))
    }

    /// The tokens of a function's body, in which calls with samplers of indices that are no constants are written out for
    /// each: `texture(maps[i], uv)` becomes `(i == 0 ? texture(maps[0], uv) : texture(maps[1], uv))`. `None` where there
    /// are none.
    pub(super) fn written_out(&self, body: &[Token]) -> Result<Option<Vec<Token>>, Complaint> {
        if self.sampler_arrays.is_empty() && self.holders.values().all(|holder| holder.count.is_none()) {
            return Ok(None);
        }
        let (mut tokens, mut at, mut is_changed) = (body.to_vec(), 0, false);
        while let Some(token) = tokens.get(at) {
            let is_member = at > 0 && tokens[at - 1].is(".");
            if !token.is_identifier() || is_member {
                at += 1;
                continue;
            }
            let is_whole = self.sampler_arrays.contains_key(&*token.text)
                && !tokens.get(at + 1).is_some_and(|t| t.is("["));
            if is_whole {
                let message =
                    format!("'{0}' is an array of samplers, of which one is needed here: {0}[0]", token.text);
                return Err(Complaint::unsupported(message, token.origin));
            }
            let Found::Dynamic { from, to, count } =
                self.find_sampler(token, &tokens[at + 1..], &HashMap::new())
            else {
                at += 1;
                continue;
            };
            let (start, new) = choice(&tokens, at, [at + 1 + from, at + 1 + to], count, &self.effects)?;
            let end = start + group(&tokens[start + 1..]).unwrap_or(0) + 1;
            tokens.splice(start..end, new);
            // The call may have more of them, and so may the index.
            (at, is_changed) = (start, true);
            if tokens.len() > MOST_TOKENS {
                let message = "too many samplers are chosen by indices: write constants";
                return Err(Complaint::unsupported(message, tokens[at].origin));
            }
        }
        Ok(is_changed.then_some(tokens))
    }
}

/// Where the call begins whose argument at `at` has a sampler by the index `[`…`]`, and what stands for it.
fn choice(
    tokens: &[Token],
    at: usize,
    [open, close]: [usize; 2],
    count: usize,
    effects: &HashSet<String>,
) -> Result<(usize, Vec<Token>), Complaint> {
    let name = &tokens[at];
    let refused = |why: &str| {
        let message = format!(
            "'{0}' is an array of samplers, whose index must be a constant here, such as {0}[1]{why}",
            name.text
        );
        Err(Complaint::unsupported(message, name.origin))
    };
    let is_argument = at > 1 && (tokens[at - 1].is("(") || tokens[at - 1].is(","));
    let Some(start) = call_around(tokens, at).filter(|_| is_argument) else { return refused("") };
    let Some(length) = group(&tokens[start + 1..]) else { return refused("") };
    let call = &tokens[start..start + 1 + length];
    if has_effect(call, effects) {
        return refused(": the call does more than give a value, so it cannot be written out for each");
    }
    let generated = |text: &str| Token { spaced: true, first: false, ..name.renamed(text) };
    let mut out = vec![generated("(")];
    for i in 0..count {
        if i + 1 < count {
            out.push(generated("int("));
            out.extend_from_slice(&tokens[open + 1..close]);
            out.push(generated(&format!(") == {i} ?")));
        }
        out.extend_from_slice(&tokens[start..=open]);
        out.push(Token { kind: Kind::Number, ..generated(&i.to_string()) });
        out.extend_from_slice(&tokens[close..start + 1 + length]);
        out.push(generated(if i + 1 < count { ":" } else { ")" }));
    }
    Ok((start, out))
}

/// The name of the function in whose parentheses a token stands.
fn call_around(tokens: &[Token], at: usize) -> Option<usize> {
    let mut depth = 0usize;
    for i in (1..at).rev() {
        match &*tokens[i].text {
            ")" | "]" => depth += 1,
            "(" | "[" if depth > 0 => depth -= 1,
            "(" => {
                let name = &tokens[i - 1];
                let is_word = matches!(&*name.text, "if" | "for" | "while" | "switch" | "return");
                return (name.is_identifier() && !is_word).then_some(i - 1);
            }
            ";" | "{" | "}" | "[" => return None,
            _ => {}
        }
    }
    None
}

/// The name of the variable of a sampler.
fn variable(path: &str) -> String {
    path.replace("].", "_").replace('[', "_glanz").replace(']', "").replace('.', "_")
}
