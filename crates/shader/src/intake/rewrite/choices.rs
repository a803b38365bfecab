//! Calls with a sampler of an array by an index that is no constant: written out for each element.

use std::collections::{HashMap, HashSet};

use super::Rewriter;
use super::circuit::{group, has_effect};
use super::samplers::Found;
use crate::intake::Complaint;
use crate::intake::token::{Kind, Token};

/// Tokens of a function in which indices that are no constants are written out.
const MOST_TOKENS: usize = 100_000;

impl Rewriter {
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
