//! Texts of shaders: reading them, and telling what is wrong in them at the line of the one who wrote it.

use std::collections::BTreeMap;
use std::path::{Component, Path};
use std::sync::{Mutex, PoisonError};

use glanz_shader::ShaderError;

use crate::input::whole_file::read_whole;
use crate::print::failure::{Failure, Report, without_number};

/// A file of a shader is no longer than this.
const MOST_BYTES: u64 = 1 << 20;

/// The texts of a file and of those that it includes, by their names.
pub(crate) struct Texts {
    name: String,
    texts: Mutex<BTreeMap<String, String>>,
}

impl Texts {
    /// Of a text that is no file's.
    pub(crate) fn of(name: &str, text: &str) -> Self {
        Self {
            name: name.to_owned(),
            texts: Mutex::new(BTreeMap::from([(name.to_owned(), text.to_owned())])),
        }
    }

    /// Of texts that are known by their names.
    pub(crate) fn known(texts: &BTreeMap<String, String>) -> Self {
        Self { name: String::new(), texts: Mutex::new(texts.clone()) }
    }

    /// Reads a file.
    pub(crate) fn read(file: &Path) -> Result<Self, Failure> {
        Ok(Self::of(&file.display().to_string(), &read(file)?))
    }

    /// With one more text.
    pub(crate) fn add(&self, name: &str, text: &str) {
        let mut texts = self.texts.lock().unwrap_or_else(PoisonError::into_inner);
        texts.insert(name.to_owned(), text.to_owned());
    }

    /// The name of the file.
    pub(crate) fn name(&self) -> &str {
        &self.name
    }

    /// Its text.
    pub(crate) fn text(&self) -> String {
        self.get(&self.name).unwrap_or_default()
    }

    /// The text of this name.
    pub(crate) fn get(&self, name: &str) -> Option<String> {
        self.texts.lock().unwrap_or_else(PoisonError::into_inner).get(name).cloned()
    }

    /// What `#include` names: a file of the folder or below it.
    pub(crate) fn include(&self, path: &str) -> Option<String> {
        let found = included(Path::new(&self.name), path)?;
        self.texts.lock().unwrap_or_else(PoisonError::into_inner).insert(path.to_owned(), found.clone());
        Some(found)
    }

    /// An error with the line that it is in.
    pub(crate) fn failure(&self, error: &ShaderError) -> Failure {
        let (message, hints) = match error {
            ShaderError::Invalid { message, hints, .. } => (message.clone(), hints.as_slice()),
            ShaderError::Unsupported { message, .. } => (message.clone(), [].as_slice()),
            ShaderError::Broken => (error.to_string(), [].as_slice()),
        };
        let mut report = Report::new(message);
        if let Some(place) = error.place() {
            report = report.file(Path::new(&place.file)).place(place.line.into(), place.column.into());
            let text = self.get(&place.file).filter(|text| text.get(place.start..place.end).is_some());
            if let Some(text) = text {
                report = report.source(&place.file, text, place.start..place.end);
            }
        }
        if !hints.is_empty() {
            report = report.help(hints.join("; "));
        }
        report.into()
    }
}

/// What `#include` finds: a file of the folder of the one that includes it, or below.
pub(crate) fn included(file: &Path, path: &str) -> Option<String> {
    let is_within = Path::new(path).components().all(|part| matches!(part, Component::Normal(_)));
    read(&file.parent()?.join(path)).ok().filter(|_| is_within)
}

/// The text of a file.
pub(crate) fn read(file: &Path) -> Result<String, Failure> {
    let could_not = |why: &str| {
        let message = format!("cannot read '{}': {why}", file.display());
        Failure::from(Report::new(message).file(file))
    };
    let io = |error: std::io::Error| could_not(&without_number(&error.to_string()));
    let bytes = read_whole(file, MOST_BYTES).map_err(io)?;
    String::from_utf8(bytes).map_err(|_| could_not("expected text in UTF-8"))
}
