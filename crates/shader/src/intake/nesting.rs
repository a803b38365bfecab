//! Limits of nesting: the front end's stack grows with it.

use super::Complaint;
use super::token::{Kind, Token};

/// Parentheses, braces and signs inside each other.
const MOST_DEPTH: usize = 200;

/// Operators in one expression: the front end's stack grows with them.
const MOST_OPERATORS: usize = 1500;

/// Refuses what nests too deeply for the front end's stack, and braces that do not match.
pub(super) fn check_nesting(tokens: &[Token]) -> Result<(), Complaint> {
    let mut open: Vec<&Token> = Vec::new();
    let (mut operators, mut signs, mut keywords, mut chain) = (0, 0, 0, 0);
    for token in tokens {
        let text = &*token.text;
        if token.kind != Kind::Punctuation {
            signs = 0;
            keywords += usize::from(matches!(text, "if" | "for" | "while" | "do" | "else" | "switch"));
            chain += usize::from(text == "else");
        }
        match text {
            "(" | "{" | "[" => open.push(token),
            ")" | "}" | "]" => {
                let matching = |t: &&Token| matches!((&*t.text, text), ("(", ")") | ("{", "}") | ("[", "]"));
                if open.pop().filter(matching).is_none() {
                    return Err(Complaint::at(format!("this '{text}' closes nothing"), token.origin));
                }
            }
            _ => {}
        }
        match text {
            ";" | "{" | "}" => (operators, signs, keywords) = (0, 0, 0),
            "," => (operators, signs) = (0, 0),
            "-" | "+" | "!" | "~" | "++" | "--" => (operators, signs) = (operators + 1, signs + 1),
            _ if token.kind == Kind::Punctuation => operators += 1,
            _ => {}
        }
        if open.is_empty() {
            chain = 0;
        }
        if open.len().max(signs).max(keywords) > MOST_DEPTH || operators > MOST_OPERATORS || chain > 1000 {
            return Err(Complaint::at(
                "this is nested too deeply, or too long for one expression",
                token.origin,
            ));
        }
    }
    match open.pop() {
        None => Ok(()),
        Some(token) => Err(Complaint::at(format!("this '{}' is never closed", token.text), token.origin)),
    }
}
