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
    let near = did_you_mean(name, known());
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
