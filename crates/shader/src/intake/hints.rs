//! What the front end means, in words.

use naga::front::glsl::ErrorKind;

/// An error as it is shown.
pub(super) struct Advice {
    pub(super) message: String,
    pub(super) hints: Vec<String>,
    pub(super) unsupported: bool,
    /// A ';' is missing.
    pub(super) is_missing: bool,
}

/// Of messages that contain the first string, what helps.
const HINTS: [(&str, &str); 13] = [
    (
        "can't work with",
        "both sides must have the same type: 1 is an int, 1.0 a float; mat4 × vec3 needs vec4(v, 1.0)",
    ),
    (
        "Unknown function",
        "is it declared before this line, and are the types of its arguments right? GLSL turns no float into an int by itself",
    ),
    (
        "Wrong operator",
        "both sides must have the same type: 1 is an int, 1.0 a float; mat4 × vec3 needs vec4(v, 1.0)",
    ),
    (
        "Operands",
        "both sides must have the same type: 1 is an int, 1.0 a float; mat4 × vec3 needs vec4(v, 1.0)",
    ),
    (
        "Cannot apply operation",
        "both sides must have the same type: 1 is an int, 1.0 a float; mat4 × vec3 needs vec4(v, 1.0)",
    ),
    ("immutable", "constants, uniforms and inputs cannot be assigned to: copy it to a variable"),
    ("Bad call", "the number or the types of the arguments do not fit"),
    ("InvalidStoreTypes", "the type of the value is not that of the variable: int x = 1.5 needs int(1.5)"),
    ("type constructor", "the components of the arguments must add up: vec4(v3, 1.0)"),
    ("bool", "a condition is a bool: write x != 0"),
    (
        "Invalid swizzle",
        "components are x y z w, r g b a or s t p q, not mixed, and no more than the vector has",
    ),
    ("must be constant", "the size of an array is a constant: a number or a const int"),
    ("already declared", "names are declared once in a block"),
];

pub(super) fn advice(kind: &ErrorKind, found: &str) -> Advice {
    let plain = |message: String, hint: &str| Advice {
        message,
        hints: if hint.is_empty() { vec![] } else { vec![hint.to_owned()] },
        unsupported: false,
        is_missing: false,
    };
    match kind {
        ErrorKind::EndOfFile => plain("the text ends too early".into(), "is a ';' or '}' missing?"),
        ErrorKind::InvalidToken(token, expected) => {
            let wanted: Vec<String> = expected.iter().map(|e| token_text(&e.to_string())).collect();
            let shown =
                if found.is_empty() { token_text(&format!("{token:?}")) } else { format!("'{found}'") };
            let is_missing = wanted.iter().any(|e| e == "';'");
            let hint = if is_missing { "statements and declarations end with ';'" } else { "" };
            Advice {
                is_missing,
                ..plain(format!("{} is expected before {shown}", wanted.join(" or ")), hint)
            }
        }
        ErrorKind::NotImplemented(what) => Advice {
            message: format!("not there: {what}"),
            hints: Vec::new(),
            unsupported: true,
            is_missing: false,
        },
        ErrorKind::UnknownVariable(name) => plain(format!("'{name}' is not declared"), variable_hint(name)),
        ErrorKind::UnknownType(name) => plain(format!("'{name}' is no type"), ""),
        ErrorKind::UnknownField(name) => plain(format!("there is no member or component '{name}' here"), ""),
        ErrorKind::UnknownLayoutQualifier(name) => plain(format!("'{name}' is no layout qualifier"), ""),
        ErrorKind::VariableAlreadyDeclared(name) => plain(format!("'{name}' is declared twice"), ""),
        ErrorKind::SemanticError(message) => {
            Advice { hints: hint(message).into_iter().collect(), ..plain(in_words(message), "") }
        }
        ErrorKind::UnsupportedMatrixWithTwoRowsInStd140 { .. }
        | ErrorKind::UnsupportedF16MatrixInStd140 { .. } => Advice {
            message: "matrices of two rows are not there in structs and blocks with a name: use two vec2"
                .into(),
            hints: Vec::new(),
            unsupported: true,
            is_missing: false,
        },
        ErrorKind::InvalidProfile(_)
        | ErrorKind::InvalidVersion(_)
        | ErrorKind::PreprocessorError(_)
        | ErrorKind::InternalError(_) => plain(kind.to_string(), ""),
    }
}

/// Of a member that is not there: the members of the text's structs.
pub(super) fn members(name: &str, text: &str) -> Option<String> {
    let word = |text: &str| text.trim().split(['[', ' ']).next().unwrap_or("").to_owned();
    let structs: Vec<(String, Vec<String>)> = text
        .split("struct ")
        .skip(1)
        .filter_map(|rest| {
            let (name, rest) = rest.split_once('{')?;
            let (body, _) = rest.split_once('}')?;
            let member = |line: &str| line.trim().split_once(' ').map(|(_, names)| word(names));
            Some((word(name), body.split(';').filter_map(member).filter(|name| !name.is_empty()).collect()))
        })
        .collect();
    let all = structs.iter().flat_map(|(_, members)| members).map(String::as_str);
    let near = glanz_math::names::did_you_mean(name, all);
    let listed = structs.iter().map(|(name, members)| format!("{name} has {}", members.join(", ")));
    let listed = listed.collect::<Vec<_>>().join("; ");
    (!structs.is_empty()).then(|| match near.trim_start_matches(['—', ',', ';', ' ']) {
        "" => listed.clone(),
        near => format!("{near} {listed}"),
    })
}

/// What helps against a message.
pub(super) fn hint(message: &str) -> Option<String> {
    HINTS.iter().find(|(part, _)| message.contains(part)).map(|(_, hint)| (*hint).to_owned())
}

/// naga's messages without the names of its own types.
pub(super) fn in_words(message: &str) -> String {
    match message.split_once('{') {
        Some((before, _)) if before.len() > 12 => before.trim_end_matches([' ', ':', '(']).to_owned(),
        _ => message.to_owned(),
    }
}

fn variable_hint(name: &str) -> &'static str {
    match name {
        "gl_FragColor" | "gl_FragData" => "declare 'out vec4 color;' and assign to it",
        "iTime" | "iResolution" | "iMouse" | "iFrame" => {
            "these names are Shadertoy's, whose shaders have 'void mainImage(out vec4 color, in vec2 place)'"
        }
        _ if name.starts_with("gl_") => "this name belongs to another stage or version",
        _ => "",
    }
}

/// A token by its text instead of naga's name for it.
fn token_text(name: &str) -> String {
    let text = match name {
        "Semicolon" => ";",
        "Comma" => ",",
        "LeftParen" => "(",
        "RightParen" => ")",
        "LeftBrace" => "{",
        "RightBrace" => "}",
        "LeftBracket" => "[",
        "RightBracket" => "]",
        "Assign" => "=",
        "Colon" => ":",
        "Dot" => ".",
        other => {
            let inner = other.strip_prefix("Identifier(\"").and_then(|rest| rest.strip_suffix("\")"));
            return inner.map_or_else(|| other.to_owned(), |name| format!("'{name}'"));
        }
    };
    format!("'{text}'")
}
