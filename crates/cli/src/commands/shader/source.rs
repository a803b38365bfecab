//! Files of shaders, and errors with the line that they are in.

use std::collections::BTreeMap;
use std::path::{Component, Path};

use glanz_shader::ShaderError;

use crate::print::failure::{Failure, Report, without_number};

/// A file of a shader is no longer than this.
const MOST_BYTES: u64 = 1 << 20;

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
    let length = std::fs::metadata(file).map_err(io)?.len();
    if length > MOST_BYTES {
        return Err(could_not(&format!("a shader of {length} bytes is more than {MOST_BYTES}")));
    }
    let bytes = std::fs::read(file).map_err(io)?;
    String::from_utf8(bytes).map_err(|_| could_not("expected text in UTF-8"))
}

/// An error with the line that it is in.
pub(crate) fn failure(error: &ShaderError, texts: &BTreeMap<String, String>) -> Failure {
    let (message, hints) = match error {
        ShaderError::Invalid { message, hints, .. } => (message.clone(), hints.as_slice()),
        ShaderError::Unsupported { message, .. } => (message.clone(), [].as_slice()),
        ShaderError::Broken => (error.to_string(), [].as_slice()),
    };
    let Some(place) = error.place() else { return Report::new(message).into() };
    let mut report = Report::new(message).file(Path::new(&place.file));
    report = report.place(place.line.into(), place.column.into());
    if let Some(text) = texts.get(&place.file).filter(|text| text.get(place.start..place.end).is_some()) {
        report = report.source(&place.file, text.clone(), place.start..place.end);
    }
    if !hints.is_empty() {
        report = report.help(hints.join("; "));
    }
    report.into()
}

