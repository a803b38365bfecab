//! BRDFs in a line: `n = 20 in 1..100; pow(max(dot(N, H), 0), n)`.

use std::fmt::Write;

use crate::{Place, ShaderError};

/// The name by which errors know an expression.
pub(super) const NAME: &str = "expression";

/// What a parameter looks like.
const PARAMETER: &str = "a parameter is 'n = 20' or 'n = 20 in 1..100'";

/// The expression as a BRDF file, in which the expression stands in the line and column that it has for the user.
pub(super) fn file(text: &str) -> Result<String, ShaderError> {
    let (parameters, expression) = parts(text);
    if expression.trim().is_empty() {
        return Err(invalid(text, text.len(), "an expression for the value of the BRDF is expected", None));
    }
    let name_before = expression.split_once('=').map(|(name, after)| (name.trim(), after.starts_with('=')));
    if let Some((name, false)) = name_before
        && is_name(name)
    {
        let message = format!("behind the parameter '{name}' the expression is missing");
        return Err(invalid(text, text.len(), &message, None));
    }
    let (mut declared, mut loose) = (String::new(), String::new());
    let mut at = 0;
    for piece in parameters.split_terminator(';') {
        parameter(text, at, piece, &mut declared, &mut loose)?;
        at += piece.len() + 1;
    }
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let half = if expression.split(|c| !is_word(c)).any(|word| word == "H") {
        "vec3 H = normalize(L + V);"
    } else {
        ""
    };
    Ok(format!(
        "::begin parameters\n{declared}::end parameters\n::begin shader\nconst float pi = 3.14159265358979;\n{loose}\
         vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {{ {half} return vec3(\n#line 1\n{}{}\n); }}\n::end shader\n",
        blank(parameters),
        with_points(expression)
    ))
}

/// The parameters with their semicolons, and the expression behind them.
fn parts(text: &str) -> (&str, &str) {
    let code = text.trim_end().trim_end_matches(';');
    code.split_at(code.rfind(';').map_or(0, |at| at + 1))
}

/// As many spaces and lines.
fn blank(parameters: &str) -> String {
    parameters.chars().map(|c| if c == '\n' { '\n' } else { ' ' }).collect()
}

/// A place of the expression's file as one of the user's text.
pub(super) fn place(text: &str, place: &Place) -> Place {
    let (parameters, expression) = parts(text);
    let code = blank(parameters) + expression;
    let line = code.split('\n').nth(place.line.saturating_sub(1) as usize).unwrap_or("");
    // The points of whole numbers are not the user's.
    let reaches = |at: &usize| with_points(&line[..*at]).chars().count() + 1 >= place.column as usize;
    let at = (0..=line.len()).filter(|at| line.is_char_boundary(*at)).find(reaches).unwrap_or(line.len());
    let before: usize =
        text.split('\n').take(place.line.saturating_sub(1) as usize).map(|line| line.len() + 1).sum();
    let (start, column) = (before + at, line[..at].chars().count() as u32 + 1);
    let end = (start + place.end.saturating_sub(place.start)).min(text.len()).max(start);
    Place { file: NAME.to_owned(), line: place.line, column, start, end }
}

/// `n = 20`, or `n = 20 in 1..100`.
fn parameter(
    text: &str,
    at: usize,
    piece: &str,
    declared: &mut String,
    loose: &mut String,
) -> Result<(), ShaderError> {
    let wrong = |message: String| {
        invalid(text, at + piece.len() - piece.trim_start().len(), &message, Some(PARAMETER))
    };
    let (name, value) =
        piece.split_once('=').ok_or_else(|| wrong(format!("'{}' is no parameter", piece.trim())))?;
    let name = name.trim();
    if !is_name(name) || ["L", "V", "N", "H", "X", "Y", "pi", "BRDF"].contains(&name) {
        return Err(wrong(format!("'{name}' is no name for a parameter")));
    }
    let number = |word: &str| {
        let number = word.trim().parse::<f32>().ok().filter(|number| number.is_finite());
        number.ok_or_else(|| wrong(format!("'{}' is no number", word.trim())))
    };
    let written = match value.split_once(" in ") {
        None => writeln!(loose, "uniform float {name} = {:?};", number(value)?),
        Some((value, range)) => {
            let ends =
                range.split_once("..").ok_or_else(|| wrong(format!("'{}' is no range", range.trim())))?;
            let (value, low, high) = (number(value)?, number(ends.0)?, number(ends.1)?);
            if !(low..=high).contains(&value) || low == high {
                return Err(wrong(format!("{value} is not within {low}..{high}")));
            }
            writeln!(declared, "float {name} {low} {high} {value}")
        }
    };
    written.expect("a string takes everything");
    Ok(())
}

fn is_name(name: &str) -> bool {
    name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
        && name.starts_with(|c: char| c.is_ascii_alphabetic())
}

/// Whole numbers with a point, as GLSL wants them beside floats: `2` becomes `2.`; indices stay.
fn with_points(expression: &str) -> String {
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '.';
    let (mut out, mut depth, mut rest) = (String::with_capacity(expression.len()), 0, expression);
    while let Some(first) = rest.chars().next() {
        let end = rest.find(|c| is_word(c) != is_word(first)).unwrap_or(rest.len());
        let (piece, after) = rest.split_at(end);
        out.push_str(piece);
        if depth == 0 && piece.chars().all(|c| c.is_ascii_digit()) {
            out.push('.');
        }
        depth += piece.matches('[').count();
        depth = depth.saturating_sub(piece.matches(']').count());
        rest = after;
    }
    out
}

fn invalid(text: &str, at: usize, message: &str, hint: Option<&str>) -> ShaderError {
    let before = text.get(..at).unwrap_or(text);
    let (line, last) = (before.matches('\n').count() as u32 + 1, before.rsplit('\n').next().unwrap_or(""));
    let column = last.chars().count() as u32 + 1;
    let place = Place { file: NAME.to_owned(), line, column, start: at, end: at };
    let hints = hint.map(str::to_owned).into_iter().collect();
    ShaderError::Invalid { message: message.to_owned(), place: Some(place), hints }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_numbers_get_a_point() {
        assert_eq!(
            with_points("2*x1 + L[0]*3 - 1.5e3 + pow(a, 10)"),
            "2.*x1 + L[0]*3. - 1.5e3 + pow(a, 10.)"
        );
    }

    #[test]
    fn places_are_those_of_the_users_text() {
        let text = "n = 20;\n 2 * 3 * m";
        let in_file = Place { file: NAME.to_owned(), line: 2, column: 12, start: 100, end: 101 };
        let place = place(text, &in_file);
        assert_eq!((place.column, &text[place.start..place.end]), (10, "m"));
    }

    #[test]
    fn parameters_are_read_or_refused_with_their_place() {
        let text = file("n = 20 in 1..100; m=0.5; n * m").unwrap();
        assert!(
            text.contains("\nfloat n 1 100 20\n") && text.contains("\nuniform float m = 0.5;\n"),
            "{text}"
        );
        let error = |text: &str| file(text).unwrap_err().to_string();
        assert_eq!(error("a = 1; b; a"), "expression:1:8: 'b' is no parameter");
        assert_eq!(error("a = x; a"), "expression:1:1: 'x' is no number");
        assert_eq!(error("N = 1; N"), "expression:1:1: 'N' is no name for a parameter");
        assert_eq!(error("a = 5 in 1..2; a"), "expression:1:1: 5 is not within 1..2");
        assert_eq!(error("a = 1;"), "expression:1:7: behind the parameter 'a' the expression is missing");
    }
}
