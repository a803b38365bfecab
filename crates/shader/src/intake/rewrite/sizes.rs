//! Sizes of arrays that GLSL takes from their value: `float a[] = float[](1.0, 2.0)`.

use crate::intake::token::{Kind, Token};

/// Tokens of a type with its sizes; more are not looked through.
const MOST_TYPE: usize = 64;

/// The tokens with a number between all `[` and `]` whose array is given a value at once.
pub(super) fn sized(tokens: &[Token]) -> Vec<Token> {
    let mut out = Vec::with_capacity(tokens.len());
    for (at, token) in tokens.iter().enumerate() {
        out.push(token.clone());
        if token.is("[")
            && tokens.get(at + 1).is_some_and(|t| t.is("]"))
            && let Some(n) = elements(&tokens[at + 2..])
        {
            let mut number = token.renamed(&n.to_string());
            number.kind = Kind::Number;
            out.push(number);
        }
    }
    out
}

/// How many elements the value has that follows an array without a size; `None` if none follows.
fn elements(mut rest: &[Token]) -> Option<usize> {
    if let [name, after, ..] = rest
        && name.is_identifier()
        && after.is("=")
    {
        // `float[] a = …`
        rest = &rest[1..];
    }
    if rest.first()?.is("=") {
        // The type of the value, with or without a size.
        let open = rest.iter().take(MOST_TYPE).position(|t| t.is("(") || t.is("{") || t.is(";"))?;
        let is_array = rest[open].is("{") || rest[..open].iter().any(|t| t.is("["));
        rest = if is_array { &rest[open..] } else { return None };
    }
    if !(rest.first()?.is("(") || rest.first()?.is("{")) {
        return None;
    }
    let (mut depth, mut commas) = (0u32, 0);
    for (at, token) in rest.iter().enumerate() {
        match &*token.text {
            "(" | "{" | "[" => depth += 1,
            ")" | "}" | "]" => depth = depth.checked_sub(1)?,
            // One behind the last element counts for nothing.
            "," if depth == 1 && !rest.get(at + 1).is_some_and(|t| t.is("}")) => commas += 1,
            ";" => return None,
            _ => {}
        }
        if depth == 0 {
            return (at > 1).then_some(commas + 1);
        }
    }
    None
}
