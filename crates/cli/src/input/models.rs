//! Models that a command line names: those of the list, files of BRDFs, BRDFs in a word, and files of measured reflectance.

use std::ffi::OsStr;
use std::path::Path;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Arg, Command, Error};
use glanz_bsdf::{MODELS, Shape};
use glanz_shader::{Brdf, BrdfSource};

use super::shader_text::Texts;
use crate::commands::measure::{ReadArgs, is_measured, read};
use crate::print::failure::{Failure, Report};

/// How names of files end that hold a BRDF.
const ENDINGS: [&str; 6] = ["brdf", "glsl", "wgsl", "frag", "fs", "txt"];

/// Parses a model: a name of the list, or what can be no name.
pub(crate) fn models() -> ModelParser {
    ModelParser(super::lobes::model_names())
}

/// See [`models`].
#[derive(Clone)]
pub(crate) struct ModelParser(PossibleValuesParser);

impl TypedValueParser for ModelParser {
    type Value = String;

    fn parse_ref(&self, command: &Command, arg: Option<&Arg>, value: &OsStr) -> Result<String, Error> {
        match value.to_str() {
            Some(text) if !is_like_a_name(text) => Ok(text.to_owned()),
            _ => self.0.parse_ref(command, arg, value),
        }
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        self.0.possible_values()
    }
}

fn is_like_a_name(text: &str) -> bool {
    text.is_empty() || text.chars().all(|c| c.is_ascii_alphanumeric() || c == '-' || c == '_')
}

/// A model with the defaults of its parameters.
pub(crate) struct Model {
    pub shape: Shape,
    /// The program, if it is one's own text, and its texts.
    pub own: Option<(Brdf, Texts)>,
}

/// The model that a word of the command line means.
pub(crate) fn model(word: &str) -> Result<Model, Failure> {
    if MODELS.iter().any(|info| info.name == word) || is_like_a_name(word) {
        let shape = Shape::named(word, &[]).map_err(|error| Failure::Usage(error.to_string()))?;
        return Ok(Model { shape, own: None });
    }
    let path = Path::new(word);
    let ending = path.extension().and_then(OsStr::to_str).unwrap_or("");
    if is_measured(path) {
        let measured = read(path, &ReadArgs::default())?;
        measured.notes.iter().for_each(|note| crate::print::note(format_args!("note: {word}: {note}")));
        let name = path.file_name().and_then(OsStr::to_str).unwrap_or(word);
        let shape = measured.shape(name).map_err(|error| Report::new(error).file(path))?;
        return Ok(Model { shape, own: None });
    }
    let (source, texts) = match ENDINGS.contains(&ending) || path.is_file() {
        true => {
            let texts = Texts::read(path)?;
            (Ok(BrdfSource::new(texts.name(), texts.text())), texts)
        }
        false => (
            BrdfSource::word(word),
            Texts::of(if word.contains('{') { "function" } else { "expression" }, word),
        ),
    };
    let include = |path: &str, _: &str| texts.include(path);
    let compiled = source.and_then(|source| source.include(&include).compile());
    let brdf = compiled.map_err(|error| texts.failure(&error))?;
    Ok(Model { shape: brdf.shape(), own: Some((brdf, texts)) })
}

/// The shape that a word means. What happens to its colours is told on stderr; what may be wrong in its text, a certificate
/// says.
pub(crate) fn shape(word: &str) -> Result<Shape, Failure> {
    let Model { shape, own } = model(word)?;
    let remarks = own.iter().flat_map(|(brdf, _)| brdf.remarks());
    for remark in remarks.filter(|remark| remark.place.is_none()) {
        crate::print::note(told(shape.info().name, remark));
    }
    Ok(shape)
}

/// A remark with its place, or with the name of its model.
pub(crate) fn told(model: &str, remark: &glanz_shader::Warning) -> String {
    match &remark.place {
        Some(place) => format!("{place}: {}", remark.message),
        None => format!("{model}: {}", remark.message),
    }
}
