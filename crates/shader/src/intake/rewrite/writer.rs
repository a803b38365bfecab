//! Tokens to text, with the map back.

use crate::intake::source::Map;
use crate::intake::token::Token;

/// naga reads no version below 440 and needs one.
const HEAD: &str = "#version 450\n";

pub(super) fn write(tokens: &[Token]) -> (String, Map) {
    let (mut text, mut map) = (HEAD.to_owned(), Map::default());
    for token in tokens {
        if token.first {
            text.push('\n');
        } else if token.spaced {
            text.push(' ');
        }
        let start = text.len();
        text.push_str(&token.text);
        map.push(start, text.len(), token.origin);
    }
    text.push('\n');
    (text, map)
}
