//! naga's front ends and validation, and the way back from their errors.

use naga::front::{glsl, wgsl};
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};
use naga::{Module, ShaderStage, Span, WithSpan};

use super::brdf::{self, Range};
use super::hints;
use super::preprocess::Preprocessor;
use super::remarks::remarks;
use super::rewrite::{Given, rewrite};
use super::token::tokens;
use super::{Complaint, Include, Map, Origin, Sources};
use crate::{Language, Stage};

/// What the text became.
pub(crate) struct Front {
    pub(crate) module: Module,
    pub(crate) info: ModuleInfo,
    pub(crate) map: Map,
    pub(crate) given: Given,
    pub(crate) ranges: Vec<Range>,
}

/// Bytes of a text; more would be no shader.
const MOST_BYTES: usize = 1 << 20;

/// What is read.
pub(crate) struct Texts<'a> {
    /// The number of the file among the sources.
    pub(crate) file: u32,
    /// Of the one that stands in front of it.
    pub(crate) common: Option<u32>,
    pub(crate) defines: &'a [(String, String)],
    pub(crate) include: Option<Include<'a>>,
    /// Whether Shadertoy's names are there, whatever the text has.
    pub(crate) is_toy: bool,
}

/// Reads a file of the sources.
pub(crate) fn read(
    sources: &mut Sources,
    texts: &Texts<'_>,
    stage: Stage,
    language: Language,
) -> Result<Front, Complaint> {
    if sources.text(texts.file).len() > MOST_BYTES {
        return Err(Complaint::whole("the text is longer than 1 MiB"));
    }
    match language {
        Language::Wgsl => read_wgsl(sources, texts.file, stage),
        Language::Glsl => read_glsl(sources, texts, stage),
    }
}

fn read_glsl(sources: &mut Sources, texts: &Texts<'_>, stage: Stage) -> Result<Front, Complaint> {
    let file = texts.file;
    let mut part = (0, sources.text(file).len());
    let (mut head, mut ranges) = (Vec::new(), Vec::new());
    if brdf::is_brdf_file(sources.text(file)) {
        let found = brdf::read(sources, file)?;
        for parameter in found.parameters {
            head.extend(tokens(&parameter.declaration, file, 0).into_iter().map(|mut token| {
                token.origin = parameter.origin;
                token
            }));
        }
        (part, ranges) = (found.shader, found.ranges);
    }
    let mut preprocessor = Preprocessor::new(sources, texts.include);
    texts.defines.iter().for_each(|(name, text)| preprocessor.define(name, text));
    if let Some(common) = texts.common {
        preprocessor.before(common)?;
    }
    let (all, version) = preprocessor.run(file, part.0, part.1)?;
    head.extend(all);
    let mut rewritten = rewrite(&head, stage, version, texts.is_toy)?;
    rewritten.given.remarks.extend(remarks(&head));
    let options = glsl::Options::from(match stage {
        Stage::Vertex => ShaderStage::Vertex,
        Stage::Fragment => ShaderStage::Fragment,
    });
    let module = glsl::Frontend::default()
        .parse(&options, &rewritten.text)
        .map_err(|errors| glsl_complaint(&errors, &rewritten.text, &rewritten.map))?;
    let info = validate(&module, &rewritten.map)?;
    Ok(Front { module, info, map: rewritten.map, given: rewritten.given, ranges })
}

fn read_wgsl(sources: &Sources, file: u32, stage: Stage) -> Result<Front, Complaint> {
    let text = sources.text(file);
    let mut map = Map::default();
    map.push(0, text.len(), Origin { file, start: 0, end: text.len() as u32 });
    let mut module = wgsl::parse_str(text).map_err(|error| {
        let span = error.labels().next().map_or(Span::UNDEFINED, |label| label.0);
        let labels = error.labels().map(|label| label.1.to_owned()).filter(|label| !label.is_empty());
        Complaint { hints: labels.collect(), ..complaint(error.message().to_owned(), span, &map) }
    })?;
    let wanted = match stage {
        Stage::Vertex => ShaderStage::Vertex,
        Stage::Fragment => ShaderStage::Fragment,
    };
    if module.entry_points.iter().any(|entry| entry.stage == wanted) {
        module.entry_points.retain(|entry| entry.stage == wanted);
        module.entry_points.truncate(1);
    } else if !module.entry_points.is_empty() {
        return Err(Complaint::whole(format!("the text has no entry point for the {} stage", stage.name())));
    }
    let info = validate(&module, &map)?;
    Ok(Front { module, info, map, given: Given::default(), ranges: Vec::new() })
}

fn validate(module: &Module, map: &Map) -> Result<ModuleInfo, Complaint> {
    let mut validator = Validator::new(ValidationFlags::all(), Capabilities::all());
    validator.validate(module).map_err(|error| validation_complaint(&error, map))
}

/// The error with the messages of its causes, the last of which says most, and its narrowest place.
fn validation_complaint<E: std::error::Error>(error: &WithSpan<E>, map: &Map) -> Complaint {
    let mut messages = Vec::new();
    let mut cause: Option<&dyn std::error::Error> = Some(error.as_inner());
    while let Some(error) = cause {
        messages.push(error.to_string());
        cause = error.source();
    }
    let span = error.spans().map(|s| s.0).filter(Span::is_defined).last().unwrap_or(Span::UNDEFINED);
    let message = messages.pop().unwrap_or_default();
    let mut complaint = complaint(message, span, map);
    // Outer messages name functions by numbers of naga's, so they stand behind.
    complaint.hints = messages.into_iter().filter(|m| !m.contains('[')).collect();
    complaint.hints.extend(hints::hint(&complaint.message));
    complaint.message = hints::in_words(&complaint.message);
    complaint
}

/// Where a span of the output stems from.
pub(crate) fn origin_of(span: Span, map: &Map) -> Option<Origin> {
    let range = span.to_range()?;
    map.origin(range.start, range.end)
}

fn complaint(message: String, span: Span, map: &Map) -> Complaint {
    Complaint { message, origin: origin_of(span, map), hints: Vec::new(), unsupported: false }
}

fn glsl_complaint(errors: &glsl::ParseErrors, text: &str, map: &Map) -> Complaint {
    let Some(first) = errors.errors.iter().min_by_key(|e| e.meta.to_range().map_or(usize::MAX, |r| r.start))
    else {
        return Complaint::whole("the text is no GLSL");
    };
    let range = first.meta.to_range().unwrap_or(0..0);
    let found = text.get(range).unwrap_or("");
    let mut advice = hints::advice(&first.kind, found);
    if let glsl::ErrorKind::UnknownField(name) = &first.kind {
        advice.hints.extend(hints::members(name, text));
    }
    // A missing ';' is looked for behind what stands before.
    if advice.is_missing
        && let Some(range) = first.meta.to_range()
        && let Some(origin) = map.before(range.start)
    {
        return Complaint { hints: advice.hints, ..Complaint::at(advice.message, origin) };
    }
    Complaint {
        hints: advice.hints,
        unsupported: advice.unsupported,
        ..complaint(advice.message, first.meta, map)
    }
}
