//! Samplers in arrays and structs: each becomes one of its own, under the name that OpenGL has for it, `maps[1]` or
//! `material.diffuse`.

use std::collections::HashMap;

use super::Rewriter;
use super::bodies::{sampler_type, texture_type};
use super::circuit::group;
use crate::intake::items::{Declarator, Item};
use crate::intake::source::Origin;
use crate::intake::token::{Kind, Token};
use crate::intake::{Complaint, SAMPLER_SUFFIX, TEXTURE_SUFFIX};
use crate::lower::Purpose;

/// Elements of an array of samplers.
const MOST_ELEMENTS: usize = 64;

/// A uniform that is a struct with samplers, or an array of such.
#[derive(Clone, Debug)]
pub(super) struct Holder {
    /// Its struct.
    structure: String,
    /// How many there are, if it is an array.
    pub(super) count: Option<usize>,
}

/// A sampler that the text names.
pub(super) struct Named {
    /// Its name in OpenGL.
    path: String,
    ty: String,
    /// Tokens that belong to it, without the first.
    taken: usize,
}

/// What a name with what is behind it says.
pub(super) enum Found {
    Nothing,
    Sampler(Named),
    /// An index, from the first token to the last, that is no constant, and how many elements there are.
    Dynamic {
        from: usize,
        to: usize,
        count: usize,
    },
}

/// A sampler's name as far as it is read.
struct Path {
    text: String,
    taken: usize,
    dynamic: Option<Found>,
}

impl Path {
    /// Takes an index among `count`, if one comes next; one that is no constant stands for 0.
    fn take_index(&mut self, behind: &[Token], count: usize, constants: &HashMap<String, i64>) {
        let Some(inside) = index(&behind[self.taken..]) else { return };
        let number = whole_number(inside, constants).filter(|i| (0..count as i64).contains(i));
        if number.is_none() && self.dynamic.is_none() {
            let (from, to) = (self.taken, self.taken + inside.len() + 1);
            self.dynamic = Some(Found::Dynamic { from, to, count });
        }
        self.text = format!("{}[{}]", self.text, number.unwrap_or(0));
        self.taken += inside.len() + 2;
    }
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
    pub(super) fn find_sampler(
        &self,
        token: &Token,
        behind: &[Token],
        local: &HashMap<String, String>,
    ) -> Found {
        if let Some(ty) = local.get(&*token.text) {
            return Found::Sampler(Named { path: token.text.to_string(), ty: ty.clone(), taken: 0 });
        }
        let mut path = Path { text: token.text.to_string(), taken: 0, dynamic: None };
        let holder = self.holders.get(&path.text);
        let is_sampler =
            self.sampler_arrays.contains_key(&path.text) || self.samplers.contains_key(&path.text);
        if holder.is_none() && !is_sampler {
            return Found::Nothing;
        }
        if let Some(holder) = holder {
            if let Some(count) = holder.count {
                path.take_index(behind, count, &self.constants);
            }
            let [dot, member, ..] = &behind[path.taken..] else { return Found::Nothing };
            let members = self.struct_samplers.get(&holder.structure);
            let is_sampler =
                members.is_some_and(|all| all.iter().any(|(own, _)| own.name.text == member.text));
            if !dot.is(".") || !is_sampler {
                return Found::Nothing;
            }
            path.text = format!("{}.{}", path.text, member.text);
            path.taken += 2;
        }
        if let Some(count) = self.sampler_arrays.get(&path.text) {
            path.take_index(behind, *count, &self.constants);
        }
        match (path.dynamic, self.samplers.get(&path.text)) {
            (Some(dynamic), _) => dynamic,
            (None, Some(ty)) => Found::Sampler(Named { path: path.text, ty: ty.clone(), taken: path.taken }),
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
}

/// The name of the variable of a sampler.
fn variable(path: &str) -> String {
    path.replace("].", "_").replace('[', "_glanz").replace(']', "").replace('.', "_")
}
