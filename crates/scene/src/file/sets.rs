//! Overrides: values set from outside, by their path, before the document is understood.
//!
//! `materials.ball.shininess=64`, `lights.0.color=[1, 0, 0]`, `render.shading=flat`. The value is
//! TOML; what is not TOML is taken as a string. Lists are counted from 0; objects and lights can
//! also be called by their `name`.

use std::borrow::Cow;
use std::ops::Range;

use toml::Spanned;
use toml::de::{DeArray, DeTable, DeValue};

use super::error::{Problem, Source};
use super::near::{did_you_mean, list};

/// The longest override. Values are numbers and colours.
const MAX_LENGTH: usize = 1 << 16;

/// An override whose place in the extended document is known.
pub(crate) struct Override {
    path: String,
    /// The value as `v=…`, with so many spaces in front that the parser finds it at its place in
    /// the extended document.
    padded: String,
    /// Where the path stands.
    span: Range<usize>,
}

/// Gives the overrides their places.
pub(crate) fn collect(source: &mut Source, sets: &[(String, String)]) -> Result<Vec<Override>, Problem> {
    let place = |(path, value): &(String, String)| {
        let length = path.len() + value.len();
        if length > MAX_LENGTH {
            let begin = source.add_override("");
            let message = format!("expected an override of at most {MAX_LENGTH} bytes, found {length}");
            return Err(Problem::at(&(begin..begin), message));
        }
        // The space keeps room for `v=` in front of a value whose path is empty.
        let begin = source.add_override(&format!("{path} = {value}"));
        let span = begin..begin + path.len();
        let padded = format!("{}v={value}", " ".repeat(span.end + 1));
        Ok(Override { path: path.clone(), padded, span })
    };
    sets.iter().map(place).collect()
}

fn entries(count: usize) -> String {
    if count == 1 { "1 entry".to_owned() } else { format!("{count} entries") }
}

impl Override {
    /// Sets the value in the document.
    pub(super) fn apply<'i>(&'i self, root: &mut DeTable<'i>) -> Result<(), Problem> {
        let keys: Vec<&'i str> = self.path.split('.').map(str::trim).collect();
        if keys.iter().any(|key| key.is_empty()) {
            let message = format!("expected a path such as materials.ball.shininess, found '{}'", self.path);
            return Err(Problem::at(&self.span, message));
        }
        self.in_table(root, &keys, 0)
    }

    /// The value, at its place.
    fn value(&self) -> Spanned<DeValue<'_>> {
        let value_begin = self.span.end + 3;
        if let Ok(table) = DeTable::parse(&self.padded) {
            let mut table = table.into_inner();
            if let (Some(value), true) = (table.remove("v"), table.is_empty()) {
                return value;
            }
        }
        let text = &self.padded[value_begin..];
        Spanned::new(value_begin..self.padded.len(), DeValue::String(Cow::Borrowed(text.trim())))
    }

    fn in_table<'i>(
        &'i self,
        table: &mut DeTable<'i>,
        keys: &[&'i str],
        depth: usize,
    ) -> Result<(), Problem> {
        let key = keys[depth];
        if depth + 1 == keys.len() {
            table.insert(Spanned::new(self.span.clone(), Cow::Borrowed(key)), self.value());
            return Ok(());
        }
        if !table.contains_key(key) {
            // A missing table is one whose keys all have their defaults. Materials, lights and objects
            // are others' names: to set a value of one that is not there would do nothing.
            let named = depth == 1 && keys[0] == "materials";
            let of_list = depth == 0 && matches!(key, "lights" | "objects");
            // A whole material may be new: an object can be made to use it.
            let of_material = depth == 0 && key == "materials" && keys.len() > 2;
            if named || of_list || of_material {
                let known: Vec<&str> = table.keys().map(|known| known.get_ref().as_ref()).collect();
                return Err(self.unknown(key, known.into_iter()));
            }
            let empty = Spanned::new(self.span.clone(), DeValue::Table(DeTable::new()));
            table.insert(Spanned::new(self.span.clone(), Cow::Borrowed(key)), empty);
        }
        let value = table.get_mut(key).expect("it was there or has been put there");
        self.in_value(value.get_mut(), keys, depth + 1)
    }

    fn in_value<'i>(
        &'i self,
        value: &mut DeValue<'i>,
        keys: &[&'i str],
        depth: usize,
    ) -> Result<(), Problem> {
        match value {
            DeValue::Table(table) => self.in_table(table, keys, depth),
            DeValue::Array(array) => self.in_array(array, keys, depth),
            other => {
                let path = keys[..depth].join(".");
                let message = format!(
                    "there is no '{}' in '{path}', which is of type {}",
                    keys[depth],
                    other.type_str()
                );
                Err(Problem::at(&self.span, message))
            }
        }
    }

    fn in_array<'i>(
        &'i self,
        array: &mut DeArray<'i>,
        keys: &[&'i str],
        depth: usize,
    ) -> Result<(), Problem> {
        let key = keys[depth];
        let names = |value: &Spanned<DeValue<'_>>| {
            let name = value.get_ref().as_table()?.get("name")?.get_ref().as_str()?;
            Some(name.to_owned())
        };
        let index = match key.parse::<usize>() {
            Ok(index) => Some(index).filter(|index| *index < array.len()),
            Err(_) => array.iter().position(|value| names(value).as_deref() == Some(key)),
        };
        let Some(entry) = index.and_then(|index| array.get_mut(index)) else {
            let known: Vec<String> = array.iter().filter_map(names).collect();
            let mut problem = self.unknown(key, known.iter().map(String::as_str));
            problem.help =
                Some(format!("'{}' has {}, counted from 0", keys[..depth].join("."), entries(array.len())));
            return Err(problem);
        };
        if depth + 1 == keys.len() {
            *entry = self.value();
            return Ok(());
        }
        self.in_value(entry.get_mut(), keys, depth + 1)
    }

    fn unknown<'a>(&self, key: &str, known: impl Iterator<Item = &'a str> + Clone) -> Problem {
        let message =
            format!("unknown path '{}': there is no '{key}'{}", self.path, did_you_mean(key, known.clone()));
        Problem::at(&self.span, message).help(format!("known here: {}", list(known)))
    }
}
