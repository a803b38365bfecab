//! The expressions of `#if` and `#elif`.

use super::Preprocessor;
use crate::intake::Complaint;
use crate::intake::source::Origin;
use crate::intake::token::{Kind, Token};

/// Parentheses and signs inside each other.
const MOST_DEPTH: usize = 200;

impl Preprocessor<'_> {
    /// Whether the condition holds.
    pub(super) fn condition(&mut self, directive: &Token, rest: &[Token]) -> Result<bool, Complaint> {
        let mut plain = Vec::new();
        let mut at = 0;
        while let Some(token) = rest.get(at) {
            at += 1;
            if !token.is("defined") {
                plain.push(token.clone());
                continue;
            }
            let parenthesis = rest.get(at).is_some_and(|t| t.is("("));
            at += usize::from(parenthesis);
            let Some(name) = rest.get(at).filter(|t| t.is_identifier()) else {
                return Err(Complaint::at("'defined' wants the name of a macro", token.origin));
            };
            at += 1 + usize::from(parenthesis);
            let value = if self.is_defined(&name.text) { "1" } else { "0" };
            plain.push(Token { kind: Kind::Number, ..token.renamed(value) });
        }
        let tokens = self.expand(plain, 0)?;
        let mut parser = Parser { tokens: &tokens, at: 0, depth: 0, origin: directive.origin };
        let value = parser.binary(0)?;
        match tokens.get(parser.at) {
            None => Ok(value != 0),
            Some(token) => {
                Err(Complaint::at(format!("'{}' is not expected in a condition", token.text), token.origin))
            }
        }
    }
}

struct Parser<'a> {
    tokens: &'a [Token],
    at: usize,
    depth: usize,
    origin: Origin,
}

impl Parser<'_> {
    fn fail(&self, message: &str) -> Complaint {
        let origin = self.tokens.get(self.at).map_or(self.origin, |t| t.origin);
        Complaint::at(message, origin)
    }

    fn binary(&mut self, least: u8) -> Result<i64, Complaint> {
        let mut left = self.unary()?;
        while let Some(op) = self.tokens.get(self.at) {
            let Some(level) = level(&op.text).filter(|level| *level >= least) else { break };
            self.at += 1;
            let right = self.binary(level + 1)?;
            left = apply(&op.text, left, right).ok_or_else(|| self.fail("division by 0 in a condition"))?;
        }
        Ok(left)
    }

    fn unary(&mut self) -> Result<i64, Complaint> {
        self.depth += 1;
        if self.depth > MOST_DEPTH {
            return Err(self.fail("the condition is nested too deeply"));
        }
        let Some(token) = self.tokens.get(self.at) else {
            return Err(self.fail("the condition ends too early"));
        };
        self.at += 1;
        let value = match (token.kind, &*token.text) {
            (_, "!") => i64::from(self.unary()? == 0),
            (_, "-") => self.unary()?.wrapping_neg(),
            (_, "+") => self.unary()?,
            (_, "~") => !self.unary()?,
            (_, "(") => {
                let value = self.binary(0)?;
                if !self.tokens.get(self.at).is_some_and(|t| t.is(")")) {
                    return Err(self.fail("')' is missing in the condition"));
                }
                self.at += 1;
                value
            }
            (Kind::Number, text) => number(text).ok_or_else(|| self.fail("conditions have whole numbers"))?,
            // As in C, a name that is no macro is 0.
            (Kind::Identifier, _) => 0,
            _ => return Err(self.fail("a number or name is expected in the condition")),
        };
        self.depth -= 1;
        Ok(value)
    }
}

fn number(text: &str) -> Option<i64> {
    let text = text.trim_end_matches(['u', 'U']);
    match text.strip_prefix("0x").or_else(|| text.strip_prefix("0X")) {
        Some(hex) => i64::from_str_radix(hex, 16).ok(),
        None => text.parse().ok(),
    }
}

fn level(op: &str) -> Option<u8> {
    Some(match op {
        "||" => 1,
        "&&" => 2,
        "|" => 3,
        "^" => 4,
        "&" => 5,
        "==" | "!=" => 6,
        "<" | ">" | "<=" | ">=" => 7,
        "<<" | ">>" => 8,
        "+" | "-" => 9,
        "*" | "/" | "%" => 10,
        _ => return None,
    })
}

fn apply(op: &str, a: i64, b: i64) -> Option<i64> {
    Some(match op {
        "||" => i64::from(a != 0 || b != 0),
        "&&" => i64::from(a != 0 && b != 0),
        "|" => a | b,
        "^" => a ^ b,
        "&" => a & b,
        "==" => i64::from(a == b),
        "!=" => i64::from(a != b),
        "<" => i64::from(a < b),
        ">" => i64::from(a > b),
        "<=" => i64::from(a <= b),
        ">=" => i64::from(a >= b),
        "<<" => a.wrapping_shl(b as u32),
        ">>" => a.wrapping_shr(b as u32),
        "+" => a.wrapping_add(b),
        "-" => a.wrapping_sub(b),
        "*" => a.wrapping_mul(b),
        "/" => a.checked_div(b)?,
        _ => a.checked_rem(b)?,
    })
}
