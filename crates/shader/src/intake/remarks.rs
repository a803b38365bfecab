//! What courses get wrong, as far as words show it: cosines that may be negative, degrees, powers, reflections.
//!
//! These are guesses by names and forms, so each asks for a form that is hardly ever meant.

use super::source::Origin;
use super::token::{Kind, Token};

/// A remark and its place.
type Remark = (String, Origin);

pub(super) fn remarks(tokens: &[Token]) -> Vec<Remark> {
    let mut all = Vec::new();
    for at in 0..tokens.len() {
        let Some(call) = Call::at(tokens, at) else { continue };
        all.extend(match call.name {
            "sin" | "cos" | "tan" => degrees(&call),
            "reflect" => reflection(&call, tokens),
            "pow" => power(&call, tokens),
            "dot" => cosine(&call, tokens),
            _ => None,
        });
    }
    all.extend(divisions(tokens));
    all
}

/// A call of a function.
struct Call<'a> {
    name: &'a str,
    origin: Origin,
    /// Place of the name.
    at: usize,
    arguments: Vec<&'a [Token]>,
}

impl<'a> Call<'a> {
    fn at(tokens: &'a [Token], at: usize) -> Option<Self> {
        let name = tokens.get(at).filter(|t| t.is_identifier())?;
        tokens.get(at + 1).filter(|t| t.is("("))?;
        let (mut depth, mut start, mut arguments) = (0usize, at + 2, Vec::new());
        // Calls are short; what is not closed soon is left alone.
        for (i, token) in tokens.iter().enumerate().skip(at + 2).take(400) {
            match &*token.text {
                "(" | "[" => depth += 1,
                ")" if depth == 0 => {
                    arguments.push(&tokens[start..i]);
                    return Some(Self { name: &name.text, origin: name.origin, at, arguments });
                }
                ")" | "]" => depth = depth.saturating_sub(1),
                "," if depth == 0 => {
                    arguments.push(&tokens[start..i]);
                    start = i + 1;
                }
                _ => {}
            }
        }
        None
    }

    /// The only word of an argument.
    fn word(&self, argument: usize) -> Option<&'a Token> {
        match self.arguments.get(argument) {
            Some([token]) => Some(token),
            _ => None,
        }
    }
}

fn degrees(call: &Call<'_>) -> Option<Remark> {
    let path = call.arguments.first()?;
    let is_path = path
        .iter()
        .all(|t| t.is_identifier() || t.kind == Kind::Number || t.is(".") || t.is("[") || t.is("]"));
    let word = path.last().filter(|_| is_path)?;
    let name = word.text.to_lowercase();
    // OpenGL has the cut-off of a spot in degrees.
    let named = word.is_identifier() && (name.contains("deg") || name == "spotcutoff");
    let large = word.kind == Kind::Number
        && word.text.trim_end_matches(['f', 'F']).parse::<f32>().is_ok_and(|x| x >= 10.0 && x % 5.0 == 0.0);
    (named || large).then(|| {
        let whole: String = path.iter().map(|t| &*t.text).collect();
        let message = format!(
            "'{0}' takes radians, and '{1}' looks like degrees: {0}(radians({whole}))",
            call.name, word.text
        );
        (message, call.origin)
    })
}

fn is_light(name: &str) -> bool {
    let name = name.to_lowercase();
    matches!(name.as_str(), "l" | "s" | "light" | "lightdir" | "lightdirection" | "tolight" | "ldir")
}

fn is_normal(name: &str) -> bool {
    let name = name.to_lowercase();
    name == "n" || name == "norm" || name == "nor" || name.contains("normal")
}

/// `reflect(L, N)` where the same L is used towards the light in `dot(N, L)`.
fn reflection(call: &Call<'_>, tokens: &[Token]) -> Option<Remark> {
    let light = call.word(0).filter(|t| t.is_identifier() && is_light(&t.text))?;
    let towards = (0..tokens.len()).filter_map(|at| Call::at(tokens, at)).any(|other| {
        let words = [other.word(0), other.word(1)];
        let has = |f: &dyn Fn(&Token) -> bool| words.iter().flatten().any(|t| f(t));
        other.name == "dot" && has(&|t| t.text == light.text) && has(&|t| is_normal(&t.text))
    });
    towards.then(|| {
        let message = format!(
            "'{0}' points to the light, as dot with the normal needs it, but reflect takes the direction that light \
             comes along: reflect(-{0}, …)",
            light.text
        );
        (message, call.origin)
    })
}

/// Whether a variable's sign is looked at somewhere: max(x, …), clamp(x, …), x > …
fn is_guarded(name: &str, tokens: &[Token]) -> bool {
    tokens.windows(3).any(|w| {
        let before = w[0].is("(") || w[0].is(",");
        let compared = w[0].is(name) && matches!(&*w[1].text, ">" | "<" | ">=" | "<=");
        let compared_behind = w[2].is(name) && matches!(&*w[1].text, ">" | "<" | ">=" | "<=");
        compared || compared_behind || before && w[1].is(name) && guards_around(tokens, w[1].origin)
    })
}

/// Whether the token of this place is an argument of a function that ends negative values.
fn guards_around(tokens: &[Token], origin: Origin) -> bool {
    let Some(at) = tokens.iter().position(|t| t.origin == origin) else { return false };
    let mut depth = 0usize;
    for i in (0..at).rev().take(60) {
        match &*tokens[i].text {
            ")" => depth += 1,
            "(" if depth > 0 => depth -= 1,
            "(" => {
                let name = i.checked_sub(1).map_or("", |j| &tokens[j].text);
                if matches!(
                    name,
                    "max" | "clamp" | "abs" | "saturate" | "step" | "smoothstep" | "acos" | "mix"
                ) {
                    return true;
                }
            }
            ";" | "{" | "}" => return false,
            _ => {}
        }
    }
    false
}

/// The variable that the statement around a place gives a value to, if that is all it does: `float x = dot(…);`.
fn receives<'a>(call: &Call<'_>, tokens: &'a [Token]) -> Option<&'a str> {
    let [name, equals] = tokens.get(call.at.checked_sub(2)?..call.at)? else { return None };
    let end: usize = call.at + 3 + call.arguments.iter().map(|a| a.len() + 1).sum::<usize>() - 1;
    let alone = equals.is("=") && tokens.get(end).is_some_and(|t| t.is(";"));
    (alone && name.is_identifier()).then_some(&*name.text)
}

/// A cosine of normal and light that multiplies light although it may be negative.
fn cosine(call: &Call<'_>, tokens: &[Token]) -> Option<Remark> {
    let (a, b) = (call.word(0)?, call.word(1)?);
    let normal_and_light = is_normal(&a.text) && is_light(&b.text) || is_light(&a.text) && is_normal(&b.text);
    if !normal_and_light || guards_around(tokens, call.origin) {
        return None;
    }
    match receives(call, tokens) {
        Some(name) if is_guarded(name, tokens) => return None,
        Some(_) => {}
        None => {
            let next = call.at + 3 + a_length(call);
            let before = call.at.checked_sub(1).and_then(|i| tokens.get(i));
            let multiplied = tokens.get(next).is_some_and(|t| t.is("*")) || before.is_some_and(|t| t.is("*"));
            if !multiplied {
                return None;
            }
        }
    }
    let message = format!(
        "dot({0}, {1}) is negative where the light is behind the surface: max(dot({0}, {1}), 0.0)",
        a.text, b.text
    );
    Some((message, call.origin))
}

/// Tokens between the parentheses of a call, less one.
fn a_length(call: &Call<'_>) -> usize {
    call.arguments.iter().map(|a| a.len() + 1).sum::<usize>().saturating_sub(1)
}

/// pow of a dot product that nothing keeps from being negative.
fn power(call: &Call<'_>, tokens: &[Token]) -> Option<Remark> {
    let base = call.arguments.first()?;
    let direct = base.first().is_some_and(|t| t.is("dot"));
    let named = call.word(0).filter(|t| t.is_identifier()).is_some_and(|word| {
        let from_dot = tokens.windows(3).any(|w| w[0].text == word.text && w[1].is("=") && w[2].is("dot"));
        from_dot && !is_guarded(&word.text, tokens)
    });
    (direct || named).then(|| {
        let message =
            "pow of a negative number is undefined, and a dot product may be negative: pow(max(…, 0.0), …)";
        (message.to_owned(), call.origin)
    })
}

/// Division by a product of cosines, or by one.
fn divisions(tokens: &[Token]) -> Vec<Remark> {
    let mut all = Vec::new();
    for (at, token) in tokens.iter().enumerate().filter(|(_, t)| t.is("/")) {
        let divisor = match tokens.get(at + 1) {
            Some(t) if t.is("(") => tokens[at + 2..].split(|t| t.is(")")).next().unwrap_or_default(),
            Some(t) if t.is("dot") => std::slice::from_ref(t),
            _ => continue,
        };
        let has = |word: &str| divisor.iter().any(|t| t.is(word));
        if has("dot") && !has("max") && !has("clamp") && !has("+") && !has("abs") {
            let message =
                "this divides by a dot product, which is 0 at grazing angles: add a small number or use max";
            all.push((message.to_owned(), token.origin));
        }
    }
    all
}
