//! Files of BRDF Explorer: parameters, then a function `BRDF(L, V, N, X, Y)`.

use super::Complaint;
use super::source::{Origin, Sources};

/// The range that a file gives a parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Range {
    /// The parameter's name.
    pub name: String,
    /// Its least value.
    pub least: f32,
    /// Its greatest value.
    pub most: f32,
}

/// A parameter as a line of GLSL, and where it stands.
pub(super) struct Parameter {
    pub(super) declaration: String,
    pub(super) origin: Origin,
}

/// The parts of a file.
#[derive(Default)]
pub(super) struct BrdfFile {
    pub(super) parameters: Vec<Parameter>,
    pub(super) ranges: Vec<Range>,
    /// First byte and length of the shader's text.
    pub(super) shader: (usize, usize),
}

/// Whether the text is such a file.
pub(crate) fn is_brdf_file(text: &str) -> bool {
    text.lines().any(|line| line.trim() == "::begin shader")
}

pub(super) fn read(sources: &Sources, file: u32) -> Result<BrdfFile, Complaint> {
    let text = sources.text(file);
    let mut found = BrdfFile::default();
    let (mut at, mut section, mut start) = (0, "", None);
    for line in text.split_inclusive('\n') {
        let origin = Origin { file, start: at as u32, end: (at + line.trim_end().len()) as u32 };
        match line.trim() {
            "::begin parameters" => section = "parameters",
            "::begin shader" => (section, start) = ("shader", Some(at + line.len())),
            "::end parameters" => section = "",
            "::end shader" if section == "shader" => {
                let start = start.unwrap_or(at);
                found.shader = (start, at - start);
                return Ok(found);
            }
            words if section == "parameters" && !words.is_empty() && !words.starts_with('#') => {
                parameter(words, origin, &mut found)?;
            }
            _ => {}
        }
        at += line.len();
    }
    Err(Complaint::whole("a BRDF file has its function between '::begin shader' and '::end shader'"))
}

fn parameter(line: &str, origin: Origin, found: &mut BrdfFile) -> Result<(), Complaint> {
    let line = line.split('#').next().unwrap_or("");
    let words: Vec<&str> = line.split_whitespace().collect();
    let [kind, name, values @ ..] = &words[..] else {
        return Err(Complaint::at("a parameter is a type, a name and its values", origin));
    };
    let numbers: Vec<f32> =
        values.iter().filter_map(|v| v.parse().ok()).filter(|v: &f32| v.is_finite()).collect();
    let valid = name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
        && !name.starts_with(|c: char| c.is_ascii_digit());
    if !valid {
        return Err(Complaint::at(format!("'{name}' is no name"), origin));
    }
    let declaration = match (*kind, &numbers[..]) {
        // The file has the least value first, then the greatest, then the value to begin with.
        ("float", [least, most, value]) => {
            found.ranges.push(Range { name: (*name).to_owned(), least: *least, most: *most });
            format!("uniform float {name} = {value:?};")
        }
        ("color", [r, g, b]) => format!("uniform vec3 {name} = vec3({r:?}, {g:?}, {b:?});"),
        ("bool", [value]) => format!("uniform bool {name} = {};", *value != 0.0),
        _ => {
            let message =
                "a parameter is 'float name least greatest value', 'color name r g b' or 'bool name 0'";
            return Err(Complaint::at(message, origin));
        }
    };
    found.parameters.push(Parameter { declaration, origin });
    Ok(())
}
