//! Lines of a text that tell its host what its channels are, as extensions of editors for Shadertoy read them.

use std::collections::BTreeMap;

use super::levels::Border;

/// What a text says of one of its channels, `iChannel0` and so on.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Channel {
    /// What stands in the quotes of `#iChannel0 "file://noise.png"`; `self` is the shader itself, a frame before.
    pub source: Option<String>,
    /// `#iChannel0::MagFilter "Nearest"`, or `MinFilter`.
    pub nearest: bool,
    /// `#iChannel0::WrapMode "Clamp"`, `"Repeat"` or `"Mirror"`.
    pub border: Option<Border>,
    /// Its line, counted from 1.
    pub line: u32,
}

/// What a text says of its channels.
///
/// ```
/// use glanz_shader::{Border, Channels};
///
/// let text = "#iChannel0 \"file://wood.png\"\n#iChannel0::WrapMode \"Clamp\"\n#iUniform float x = 0.5 in { 0.0, 1.0 }\n";
/// let (rest, channels) = Channels::read(text);
/// assert_eq!(channels.list[&0].source.as_deref(), Some("file://wood.png"));
/// assert_eq!(channels.list[&0].border, Some(Border::Hold));
/// // The lines are gone, and all other bytes are where they were.
/// assert_eq!(rest.len(), text.len());
/// assert_eq!(rest.trim(), "uniform float x = 0.5;");
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Channels {
    /// By their numbers.
    pub list: BTreeMap<u32, Channel>,
    /// Lines that mean something to other hosts and nothing here, with their words.
    pub ignored: Vec<(u32, String)>,
}

impl Channels {
    /// Reads the lines, and gives the text without them: the same bytes at the same places, spaces for the lines, and a
    /// uniform where `#iUniform` declares one.
    pub fn read(text: &str) -> (String, Self) {
        let (mut rest, mut all, mut in_comment) = (String::with_capacity(text.len()), Self::default(), false);
        for (number, line) in (1..).zip(text.split_inclusive('\n')) {
            let words = line.trim();
            let is_directive = !in_comment && words.starts_with("#i") && !words.starts_with("#if") && {
                let name = words[1..].split(|c: char| !c.is_alphanumeric()).next().unwrap_or("");
                name.starts_with("iChannel") || matches!(name, "iKeyboard" | "iUniform" | "iVertex")
            };
            if !is_directive {
                in_comment = is_open(line, in_comment);
                rest.push_str(line);
                continue;
            }
            let declared = all.directive(words, number).unwrap_or_default();
            let content = line.trim_end_matches(['\r', '\n']);
            let fits = declared.len() <= content.len();
            rest.push_str(if fits { &declared } else { "" });
            let left = content.len() - if fits { declared.len() } else { 0 };
            rest.extend(std::iter::repeat_n(' ', left));
            rest.push_str(&line[content.len()..]);
        }
        (rest, all)
    }

    /// Reads a line, and gives the declaration that stands for it.
    fn directive(&mut self, words: &str, line: u32) -> Option<String> {
        if let Some(uniform) = words.strip_prefix("#iUniform") {
            return Some(declaration(uniform));
        }
        let known = words.strip_prefix("#iChannel").and_then(|rest| self.channel(rest, line));
        if known.is_none() {
            self.ignored.push((line, words.to_owned()));
        }
        None
    }

    fn channel(&mut self, rest: &str, line: u32) -> Option<()> {
        let digits = rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len());
        let number: u32 = rest[..digits].parse().ok()?;
        let rest = rest[digits..].trim_start();
        let value = rest.split('"').nth(1)?.trim();
        let channel = self.list.entry(number).or_default();
        let lower = value.to_lowercase();
        let property = rest.strip_prefix("::").map(|rest| rest.split([' ', '\t', '"']).next().unwrap_or(""));
        match property {
            None => (channel.source, channel.line) = (Some(value.to_owned()), line),
            Some("MinFilter" | "MagFilter") => channel.nearest |= lower == "nearest",
            Some("WrapMode") => {
                channel.border = Some(match lower.as_str() {
                    "clamp" => Border::Hold,
                    "mirror" => Border::Mirror,
                    "repeat" => Border::Repeat,
                    _ => return None,
                });
            }
            Some(_) => return None,
        }
        Some(())
    }
}

/// `float x = 0.5 in { 0.0, 1.0 }` as a uniform; colours are vectors.
fn declaration(words: &str) -> String {
    let end = words.find(" in ").unwrap_or(words.len());
    let words = words[..end].trim().trim_end_matches(';');
    let words = words.replace("color3", "vec3").replace("color4", "vec4");
    format!("uniform {words};")
}

/// Whether a comment of many lines is open at the end of a line.
fn is_open(line: &str, was_open: bool) -> bool {
    let (mut open, mut rest) = (was_open, line);
    loop {
        let found = if open {
            rest.find("*/")
        } else {
            // What stands behind // opens nothing.
            let end = rest.find("//").unwrap_or(rest.len());
            rest[..end].find("/*")
        };
        let Some(at) = found else { return open };
        (open, rest) = (!open, &rest[at + 2..]);
    }
}
