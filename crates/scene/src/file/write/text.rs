//! TOML as it is written: numbers that read back to the same bits, strings, inline tables, sections.

use glam::DVec3;
use glanz_color::{Rgb, Spectrum};

/// A number; the shortest text that reads back to the same bits.
pub(super) fn number(value: f64) -> String {
    format!("{value:?}")
}

/// A number of single precision, which is read by way of a double.
pub(super) fn single(value: f32) -> String {
    let short = format!("{value:?}");
    let read = short.parse::<f64>().map(|wide| wide as f32);
    if read.is_ok_and(|read| read.to_bits() == value.to_bits()) { short } else { number(f64::from(value)) }
}

/// A string in quotes.
pub(super) fn string(text: &str) -> String {
    let mut out = String::from("\"");
    for c in text.chars() {
        match c {
            '"' => out.push_str("\\\""),
            '\\' => out.push_str("\\\\"),
            '\n' => out.push_str("\\n"),
            '\t' => out.push_str("\\t"),
            c if c.is_control() => out.push_str(&format!("\\u{:04X}", u32::from(c))),
            c => out.push(c),
        }
    }
    out.push('"');
    out
}

/// A key, in quotes where it needs them.
pub(super) fn key(name: &str) -> String {
    let bare = !name.is_empty() && name.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_' || b == b'-');
    if bare { name.to_owned() } else { string(name) }
}

/// A list of values.
pub(super) fn list(values: impl IntoIterator<Item = String>) -> String {
    format!("[{}]", values.into_iter().collect::<Vec<_>>().join(", "))
}

/// A list of values, each on a line of its own.
pub(super) fn tall_list(values: impl IntoIterator<Item = String>) -> String {
    let lines: String = values.into_iter().map(|value| format!("    {value},\n")).collect();
    format!("[\n{lines}]")
}

/// Numbers.
pub(super) fn numbers(values: &[f64]) -> String {
    list(values.iter().map(|value| number(*value)))
}

/// Numbers of single precision.
pub(super) fn singles(values: &[f32]) -> String {
    list(values.iter().map(|value| single(*value)))
}

/// A vector.
pub(super) fn vector(vector: DVec3) -> String {
    numbers(&vector.to_array())
}

/// A colour; one number for a grey.
pub(super) fn rgb(color: Rgb) -> String {
    let [r, g, b] = color.0;
    if r.to_bits() == g.to_bits() && g.to_bits() == b.to_bits() { single(r) } else { singles(&color.0) }
}

/// The samples of a function of wavelength; one number for a constant.
pub(super) fn samples(spectrum: &Spectrum) -> String {
    let first = spectrum.0[0];
    match spectrum.0.iter().all(|value| value.to_bits() == first.to_bits()) {
        true => number(first),
        false => numbers(&spectrum.0),
    }
}

/// The degrees that become exactly these radians, if there are any; of several those with the shortest text.
pub(super) fn degrees(radians: f64) -> Option<String> {
    let about = radians.to_degrees();
    let rounded = [0, 1, 3, 6, 9, 12].map(|digits: i32| {
        let scale = 10f64.powi(digits);
        (about * scale).round() / scale
    });
    let near = [about, about.next_up(), about.next_down()];
    let exact = |degrees: &f64| degrees.to_radians().to_bits() == radians.to_bits();
    rounded.into_iter().chain(near).find(exact).map(number)
}

/// The keys of a table and their values.
#[derive(Clone, Debug, Default)]
pub(super) struct Table(Vec<(String, String)>);

impl Table {
    /// Adds a key.
    pub(super) fn put(&mut self, name: &str, value: impl Into<String>) {
        self.0.push((key(name), value.into()));
    }

    /// Adds a key unless the value is the default.
    pub(super) fn put_unless(&mut self, is_default: bool, name: &str, value: impl Into<String>) {
        if !is_default {
            self.put(name, value);
        }
    }

    /// The table on one line.
    pub(super) fn inline(&self) -> String {
        let pairs: Vec<String> = self.0.iter().map(|(key, value)| format!("{key} = {value}")).collect();
        format!("{{ {} }}", pairs.join(", "))
    }
}

/// A table with these keys on one line.
pub(super) fn inline<const N: usize>(pairs: [(&str, String); N]) -> String {
    let mut table = Table::default();
    pairs.into_iter().for_each(|(name, value)| table.put(name, value));
    table.inline()
}

/// A scene file as it grows.
#[derive(Debug, Default)]
pub(super) struct Document(String);

impl Document {
    /// Adds a key before all tables.
    pub(super) fn line(&mut self, line: &str) {
        self.0.push_str(line);
        self.0.push('\n');
    }

    /// Adds a table under a header such as `[image]`; an empty one is left out if it may be.
    pub(super) fn section(&mut self, header: &str, table: &Table, optional: bool) {
        if optional && table.0.is_empty() {
            return;
        }
        if !self.0.is_empty() {
            self.0.push('\n');
        }
        self.0.push_str(header);
        self.0.push('\n');
        table.0.iter().for_each(|(key, value)| self.0.push_str(&format!("{key} = {value}\n")));
    }

    /// The text.
    pub(super) fn finish(self) -> String {
        self.0
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn numbers_read_back_to_the_same_bits(bits in any::<u64>(), small in any::<u32>()) {
            let value = f64::from_bits(bits);
            if value.is_finite() {
                prop_assert_eq!(number(value).parse::<f64>().map(f64::to_bits), Ok(bits));
            }
            let value = f32::from_bits(small);
            if value.is_finite() {
                let read = single(value).parse::<f64>().expect("a number") as f32;
                prop_assert_eq!(read.to_bits(), small);
            }
        }

        #[test]
        fn degrees_are_exact_or_none(radians in 0.0..3.2_f64) {
            if let Some(text) = degrees(radians) {
                let read: f64 = text.parse().expect("a number");
                prop_assert_eq!(read.to_radians().to_bits(), radians.to_bits());
            }
        }

        #[test]
        fn strings_read_back(text in any::<String>()) {
            let document = format!("{} = {}", key(&text), string(&text));
            let table: std::collections::BTreeMap<String, String> = toml::from_str(&document).expect("valid");
            prop_assert_eq!(table.get(&text), Some(&text));
        }
    }

    #[test]
    fn whole_degrees_are_written_as_such() {
        assert_eq!(degrees(40f64.to_radians()).as_deref(), Some("40.0"));
        assert_eq!(degrees(22.5f64.to_radians()).as_deref(), Some("22.5"));
    }
}
