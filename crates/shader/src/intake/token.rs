//! Tokens of GLSL.

use std::rc::Rc;

use super::source::Origin;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Identifier,
    Number,
    Punctuation,
    /// What stands in quotation marks, without them.
    Text,
}

/// A macro that a token must not expand again, and those before.
#[derive(Debug)]
pub(super) struct Hidden {
    pub(super) name: Rc<str>,
    pub(super) next: Option<Rc<Hidden>>,
}

#[derive(Clone, Debug)]
pub(super) struct Token {
    pub(super) kind: Kind,
    pub(super) text: Rc<str>,
    pub(super) origin: Origin,
    /// White space stands before it.
    pub(super) spaced: bool,
    /// It is the first of its line.
    pub(super) first: bool,
    pub(super) hidden: Option<Rc<Hidden>>,
}

impl Token {
    pub(super) fn is(&self, text: &str) -> bool {
        &*self.text == text && self.kind != Kind::Text
    }

    pub(super) fn is_identifier(&self) -> bool {
        self.kind == Kind::Identifier
    }

    /// A token that stands for `self` in the output.
    pub(super) fn renamed(&self, text: &str) -> Self {
        Self { text: text.into(), ..self.clone() }
    }

    pub(super) fn hides(&self, name: &str) -> bool {
        let mut next = self.hidden.as_ref();
        while let Some(hidden) = next {
            if &*hidden.name == name {
                return true;
            }
            next = hidden.next.as_ref();
        }
        false
    }
}

const TWO: [&str; 20] = [
    "<<", ">>", "<=", ">=", "==", "!=", "&&", "||", "^^", "##", "++", "--", "+=", "-=", "*=", "/=", "%=",
    "&=", "|=", "^=",
];

/// The tokens of a text, comments and continued lines left out. Bytes count from `base` on.
pub(super) fn tokens(text: &str, file: u32, base: usize) -> Vec<Token> {
    let bytes = text.as_bytes();
    let (mut at, mut spaced, mut first) = (0, false, true);
    let mut out = Vec::new();
    while at < bytes.len() {
        let skipped = blank(text, at);
        if skipped > at {
            // Newlines inside a comment end no line of the preprocessor.
            let is_comment = bytes[at] == b'/';
            first |= !is_comment && bytes[at..skipped].contains(&b'\n') && bytes[at] != b'\\';
            (at, spaced) = (skipped, true);
            continue;
        }
        let (kind, end) = one(text, at);
        let origin = Origin { file, start: (base + at) as u32, end: (base + end) as u32 };
        let inner = if kind == Kind::Text { text[at + 1..end].trim_end_matches('"') } else { &text[at..end] };
        out.push(Token { kind, text: inner.into(), origin, spaced, first, hidden: None });
        (at, spaced, first) = (end, false, false);
    }
    out
}

/// The end of white space, a comment or a continuation that starts at `at`; `at` if there is none.
fn blank(text: &str, at: usize) -> usize {
    let rest = &text[at..];
    for (start, end) in [("//", "\n"), ("/*", "*/")] {
        if let Some(inside) = rest.strip_prefix(start) {
            let length = inside.find(end).map_or(inside.len(), |i| if end == "\n" { i } else { i + 2 });
            return at + 2 + length;
        }
    }
    for continuation in ["\\\r\n", "\\\n"] {
        if rest.starts_with(continuation) {
            return at + continuation.len();
        }
    }
    at + rest.chars().next().filter(|c| c.is_whitespace() || *c == '\u{feff}').map_or(0, char::len_utf8)
}

/// Kind and end of the token at `at`.
fn one(text: &str, at: usize) -> (Kind, usize) {
    let rest = &text[at..];
    let Some(c) = rest.chars().next() else { return (Kind::Punctuation, text.len()) };
    let digit = |s: &str| s.bytes().next().is_some_and(|b| b.is_ascii_digit());
    if c.is_ascii_digit() || c == '.' && digit(&rest[1..]) {
        return (Kind::Number, at + number(rest.as_bytes()));
    }
    if c.is_alphabetic() || c == '_' {
        let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
        return (Kind::Identifier, at + end);
    }
    if c == '"' {
        let end = rest[1..]
            .find(['"', '\n'])
            .map_or(rest.len(), |i| if rest.as_bytes()[i + 1] == b'"' { i + 2 } else { i + 1 });
        return (Kind::Text, at + end);
    }
    for three in ["<<=", ">>="] {
        if rest.starts_with(three) {
            return (Kind::Punctuation, at + 3);
        }
    }
    let two = TWO.iter().any(|two| rest.starts_with(two));
    (Kind::Punctuation, at + if two { 2 } else { c.len_utf8() })
}

fn number(bytes: &[u8]) -> usize {
    let hex = bytes.len() > 1 && matches!(bytes[1], b'x' | b'X');
    let mut end = 0;
    while end < bytes.len() {
        let exponent = end > 0 && matches!(bytes[end - 1], b'e' | b'E') && !hex;
        let signed = exponent && matches!(bytes[end], b'+' | b'-');
        if !(bytes[end].is_ascii_alphanumeric() || bytes[end] == b'.' || signed) {
            break;
        }
        end += 1;
    }
    end
}
