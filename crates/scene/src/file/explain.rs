//! What the TOML reader says, in the words of scene files.

use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::error::Problem;
use super::near::{did_you_mean, list};

/// Keys that are still read, but no longer told.
const OLD_KEYS: [&str; 1] = ["see_through"];

/// The problem that an error of the TOML reader tells of. `root` is the document that was read, if
/// it could be parsed at all.
pub(crate) fn explain(error: &toml::de::Error, root: Option<&Paths>) -> Problem {
    let message = error.message().trim();
    // An error without a place is one of the whole text.
    let span = error.span().or(Some(0..0));
    let table = span.as_ref().and_then(|span| root?.around(span));
    let quoted = |text: &str| {
        let mut parts = text.split('`');
        let mut names = Vec::new();
        while let (Some(_), Some(name)) = (parts.next(), parts.next()) {
            names.push(name.to_owned());
        }
        names
    };
    for (begin, what) in [("unknown field `", "key"), ("unknown variant `", "name")] {
        if message.starts_with(begin) {
            let names = quoted(message);
            let (name, known) = names.split_first().expect("the message begins with a name");
            return unknown(what, name, known, table, span);
        }
    }
    if message.starts_with("missing field `") {
        let key = quoted(message).join("");
        let message = format!("'{key}' is missing{}", within(table));
        return Problem { span, message, help: None };
    }
    Problem { span, message: in_plain_words(message), help: None }
}

/// The same, with advice where a decimal comma stands.
pub(super) fn with_comma(problem: Problem, text: &str) -> Problem {
    let Some(at) = problem.span.as_ref().map(|span| span.start) else { return problem };
    let (before, after) = match (text.get(..at), text.get(at..)) {
        (Some(before), Some(after)) => (before, after),
        _ => return problem,
    };
    let whole = before.rsplit(|c: char| !c.is_ascii_digit()).next().unwrap_or_default();
    let part: String = after.chars().skip(1).take_while(char::is_ascii_digit).collect();
    match after.starts_with(',') && !whole.is_empty() && !part.is_empty() {
        true => {
            let message = format!("expected a number with a decimal point, found '{whole},{part}'");
            Problem { message, ..problem }.help(format!("write {whole}.{part}"))
        }
        false => problem,
    }
}

/// That what may be there several times is a list of tables: `[[lights]]`, not `[lights]`.
pub(super) fn refuse_single_tables(root: &DeTable<'_>) -> Result<(), Problem> {
    for (key, value) in root.iter() {
        let name = key.get_ref().as_ref();
        if matches!(name, "lights" | "objects") && value.get_ref().is_table() {
            let message = format!("expected a list of tables, found one table [{name}]");
            return Err(Problem::at(&key.span(), message)
                .help(format!("write [[{name}]]: two brackets begin one of several")));
        }
    }
    Ok(())
}

/// What people call things whose name is another, and that name.
const OTHER_NAMES: [(&str, &str); 12] = [
    ("sun", "directional"),
    ("parallel", "directional"),
    ("distant", "directional"),
    ("lamp", "point"),
    ("bulb", "point"),
    ("omni", "point"),
    ("spotlight", "spot"),
    ("area", "rectangle"),
    ("quad", "rectangle"),
    ("sky", "environment"),
    ("hdri", "environment"),
    ("dome", "environment"),
];

/// Names to be suggested: known by another name, longer by a unit such as `_deg`, or near.
fn suggestion<'a>(name: &str, known: impl Iterator<Item = &'a str> + Clone) -> String {
    let other = OTHER_NAMES.iter().find(|(asked, _)| *asked == name).map(|(_, own)| *own);
    let with_unit = |known: &&str| known.strip_prefix(name).is_some_and(|rest| rest.starts_with('_'));
    match known.clone().find(|known| other == Some(known)).or_else(|| known.clone().find(with_unit)) {
        Some(found) => format!("; did you mean '{found}'?"),
        None => did_you_mean(name, known),
    }
}

fn within(table: Option<&str>) -> String {
    table.map(|table| format!(" in [{table}]")).unwrap_or_default()
}

fn unknown(
    what: &str,
    name: &str,
    known: &[String],
    table: Option<&str>,
    span: Option<Range<usize>>,
) -> Problem {
    let known = || known.iter().map(String::as_str).filter(|name| !OLD_KEYS.contains(name));
    let near = suggestion(name, known());
    let place = if what == "key" { within(table) } else { String::new() };
    let help = Some(format!("known {what}s: {}", list(known())));
    Problem { span, message: format!("unknown {what} '{name}'{place}{near}"), help }
}

/// serde's names of types are Rust's.
fn in_plain_words(message: &str) -> String {
    let Some((found, expected)) = message
        .strip_prefix("invalid type: ")
        .or_else(|| message.strip_prefix("invalid value: "))
        .and_then(|rest| rest.rsplit_once(", expected "))
    else {
        return message.to_owned();
    };
    let expected = match expected {
        "a boolean" => "true or false",
        "i64" | "u32" | "u64" | "usize" | "u16" | "u8" | "i32" => "a whole number",
        "f64" | "f32" => "a number",
        "a sequence" => "a list",
        "a map" => "a table",
        other if other.starts_with("struct ") => "a table",
        other => other,
    };
    let found = match found {
        "sequence" => "a list",
        "map" => "a table",
        other => other,
    };
    format!("expected {expected}, found {}", found.replace('`', ""))
}

/// The paths of all tables of a document, by where they stand.
pub(crate) struct Paths {
    tables: Vec<(Range<usize>, String)>,
}

impl Paths {
    /// The paths of the tables below `root`.
    pub(super) fn of(root: &Spanned<DeTable<'_>>) -> Self {
        let mut paths = Self { tables: Vec::new() };
        paths.add_table(root.get_ref(), "");
        paths
    }

    fn add_table(&mut self, table: &DeTable<'_>, path: &str) {
        for (key, value) in table.iter() {
            let key_name = key.get_ref();
            let inner = if path.is_empty() { key_name.to_string() } else { format!("{path}.{key_name}") };
            // A key is not within the bytes of its value, and a table's header not around its keys.
            self.tables.push((key.span(), path.to_owned()));
            self.add_value(value.get_ref(), value.span(), &inner);
        }
    }

    fn add_value(&mut self, value: &DeValue<'_>, span: Range<usize>, path: &str) {
        match value {
            DeValue::Table(table) => {
                self.tables.push((span, path.to_owned()));
                self.add_table(table, path);
            }
            DeValue::Array(array) if array.iter().any(|v| v.get_ref().is_table()) => {
                for (index, value) in array.iter().enumerate() {
                    self.add_value(value.get_ref(), value.span(), &format!("{path}.{index}"));
                }
            }
            _ => {}
        }
    }

    /// The path of the table in which `span` stands; `None` at the top.
    fn around(&self, span: &Range<usize>) -> Option<&str> {
        let holds = |range: &Range<usize>| range.start <= span.start && span.end <= range.end;
        let fitting = self.tables.iter().filter(|(range, _)| holds(range));
        let (_, path) = fitting.min_by_key(|(range, _)| range.end - range.start)?;
        Some(path.as_str()).filter(|path| !path.is_empty())
    }
}
