//! `&&` and `||` whose right side is evaluated only where the left one asks for it.
//!
//! The front end evaluates both sides, which is the same as long as they only give values. Where the right one does more,
//! `a && b` becomes `(a ? b : false)`, and `a || b` becomes `(a ? true : b)`: of `?:` it evaluates one branch only.

use std::collections::HashSet;

use crate::intake::token::{Kind, Token};

/// Words and signs between which an expression stands.
const ENDS: [&str; 16] =
    [";", ",", "?", ":", "=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>=", "return"];

/// The tokens of a function's body with such operators rewritten. `effects`: functions whose call is more than its value.
pub(super) fn shortened(body: &[Token], effects: &HashSet<String>) -> Option<Vec<Token>> {
    let joins = body.iter().any(|t| t.is("&&") || t.is("||"));
    (joins && has_effect(body, effects)).then(|| {
        let mut out = Vec::with_capacity(body.len());
        Shortener { effects }.level(body, &mut out);
        out
    })
}

/// Whether an expression does more than give a value.
pub(super) fn has_effect(tokens: &[Token], effects: &HashSet<String>) -> bool {
    let writes = |t: &Token| is_assignment(t) || t.is("++") || t.is("--");
    let calls = |w: &[Token]| w[0].is_identifier() && w[1].is("(") && effects.contains(&*w[0].text);
    tokens.iter().any(writes) || tokens.windows(2).any(calls)
}

fn is_assignment(token: &Token) -> bool {
    token.kind == Kind::Punctuation
        && token.text.ends_with('=')
        && !matches!(&*token.text, "==" | "!=" | "<=" | ">=")
}

struct Shortener<'a> {
    effects: &'a HashSet<String>,
}

impl Shortener<'_> {
    /// Writes tokens, brackets by brackets.
    fn level(&self, tokens: &[Token], out: &mut Vec<Token>) {
        let (mut start, mut at) = (0, 0);
        while let Some(token) = tokens.get(at) {
            let group = group(&tokens[at..]);
            let is_head =
                ["if", "while", "for", "switch"].iter().any(|word| token.is(word)) && token.is_identifier();
            if let Some(length) = group.filter(|_| token.is("{")) {
                self.expression(&tokens[start..at], out);
                self.inside(&tokens[at..at + length], out);
                at += length;
                start = at;
            } else if is_head {
                // What stands in the parentheses behind is no part of the expression that follows.
                self.expression(&tokens[start..at], out);
                let length = self::group(&tokens[at + 1..]).unwrap_or(0);
                out.push(token.clone());
                self.inside(&tokens[at + 1..at + 1 + length], out);
                at += 1 + length;
                start = at;
            } else if ENDS.iter().any(|end| token.is(end)) || token.is("else") || token.is("do") {
                self.expression(&tokens[start..at], out);
                out.push(token.clone());
                at += 1;
                start = at;
            } else {
                at += group.unwrap_or(1);
            }
        }
        self.expression(&tokens[start..], out);
    }

    /// A bracket, what stands in it, and the other bracket.
    fn inside(&self, tokens: &[Token], out: &mut Vec<Token>) {
        let [first, inside @ .., last] = tokens else { return out.extend_from_slice(tokens) };
        out.push(first.clone());
        self.level(inside, out);
        out.push(last.clone());
    }

    /// Writes an expression between `ENDS`.
    fn expression(&self, tokens: &[Token], out: &mut Vec<Token>) {
        for operator in ["||", "^^", "&&"] {
            let parts = split(tokens, operator);
            if parts.len() > 1 {
                return self.join(operator, &parts, out);
            }
        }
        let mut at = 0;
        while let Some(token) = tokens.get(at) {
            let length = group(&tokens[at..]).unwrap_or(1);
            if length > 1 {
                self.inside(&tokens[at..at + length], out);
            } else {
                out.push(token.clone());
            }
            at += length;
        }
    }

    /// Writes operands with the operator between them.
    fn join(&self, operator: &str, parts: &[Part<'_>], out: &mut Vec<Token>) {
        // The last operand that must not be evaluated for nothing, nearest to the middle: halves keep the nesting small.
        let middle = parts.len() / 2;
        let cuts =
            (1..parts.len()).filter(|i| operator != "^^" && has_effect(parts[*i].tokens, self.effects));
        let Some(cut) = cuts.min_by_key(|i| i.abs_diff(middle)) else {
            for part in parts {
                out.extend(part.operator.cloned());
                self.expression(part.tokens, out);
            }
            return;
        };
        let (left, right) = parts.split_at(cut);
        let Some(sign) = right[0].operator else { return };
        let generated = |text: &str| Token { spaced: true, first: false, ..sign.renamed(text) };
        out.push(generated("("));
        self.join(operator, &headless(left), out);
        out.push(generated("?"));
        if operator == "||" {
            out.extend([generated("true"), generated(":")]);
        }
        self.join(operator, &headless(right), out);
        if operator == "&&" {
            out.extend([generated(":"), generated("false")]);
        }
        out.push(generated(")"));
    }
}

/// An operand and the operator before it.
#[derive(Clone, Copy)]
struct Part<'a> {
    operator: Option<&'a Token>,
    tokens: &'a [Token],
}

/// The operands without the operator before the first.
fn headless<'a>(parts: &[Part<'a>]) -> Vec<Part<'a>> {
    let mut parts = parts.to_vec();
    parts.iter_mut().take(1).for_each(|part| part.operator = None);
    parts
}

/// The operands of an operator outside all brackets.
fn split<'a>(tokens: &'a [Token], operator: &str) -> Vec<Part<'a>> {
    let (mut parts, mut start, mut at, mut before) = (Vec::new(), 0, 0, None);
    while let Some(token) = tokens.get(at) {
        if token.is(operator) {
            parts.push(Part { operator: before, tokens: &tokens[start..at] });
            (before, start) = (Some(token), at + 1);
        }
        at += group(&tokens[at..]).unwrap_or(1);
    }
    parts.push(Part { operator: before, tokens: &tokens[start..] });
    parts
}

/// How many tokens a bracket with all in it takes that comes next.
pub(super) fn group(tokens: &[Token]) -> Option<usize> {
    let opens = |t: &Token| t.is("(") || t.is("[") || t.is("{");
    tokens.first().filter(|t| opens(t))?;
    let mut depth = 0usize;
    for (at, token) in tokens.iter().enumerate() {
        depth += usize::from(opens(token));
        if token.is(")") || token.is("]") || token.is("}") {
            depth = depth.saturating_sub(1);
            if depth == 0 {
                return Some(at + 1);
            }
        }
    }
    None
}
