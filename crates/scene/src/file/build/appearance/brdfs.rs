//! Users' BRDFs.

use glanz_bsdf::{ParamError, Shape};

use crate::file::build::builder::Builder;
use crate::file::error::Problem;
use crate::file::tables::appearance::shapes::{BrdfTable, BrdfText};

impl BrdfTable {
    /// The shape.
    pub(super) fn build(&self, builder: &mut Builder) -> Result<Shape, Problem> {
        let mut shape = self.compile(builder)?;
        for (key, value) in &self.params {
            shape = shape.with(key, value.0).map_err(|error| {
                let span =
                    if matches!(error, ParamError::OutOfRange { .. }) { &value.span } else { &key.span };
                Problem::at(span, error.to_string())
            })?;
        }
        Ok(shape)
    }

    #[cfg(not(feature = "shader"))]
    fn compile(&self, _: &mut Builder) -> Result<Shape, Problem> {
        let (BrdfText::File(text) | BrdfText::Function(text)) = &self.text;
        Err(Problem::at(&text.span, crate::material::brdf::OFF))
    }

    #[cfg(feature = "shader")]
    fn compile(&self, builder: &mut Builder) -> Result<Shape, Problem> {
        use glanz_shader::BrdfSource;

        use crate::file::tables::appearance::shapes::TermName;
        use crate::read::{FolderFiles, Resolver};

        let (BrdfText::File(text) | BrdfText::Function(text)) = &self.text;
        let wrong = |error: glanz_shader::ShaderError| problem(&error, &text.span);
        let mut source = match &self.text {
            BrdfText::Function(text) => BrdfSource::word(text).map_err(wrong)?,
            BrdfText::File(file) => {
                let text = String::from_utf8(builder.read_beside(file)?)
                    .map_err(|_| Problem::at(&file.span, format!("'{}' is no text in UTF-8", file.value)))?;
                BrdfSource::new(file.as_str(), text)
            }
        };
        if let Some(name) = &self.name {
            source = source.named(name);
        }
        if self.term == TermName::Diffuse {
            source = source.diffuse();
        }
        let files = FolderFiles::new(builder.base(), &builder.input.options);
        let folder = text.rfind('/').map_or("", |at| &text[..=at]);
        let include = |path: &str, _: &str| {
            let bytes = files.read(&format!("{folder}{path}")).ok()?;
            String::from_utf8(bytes).ok()
        };
        let brdf = source.include(&include).compile().map_err(wrong)?;
        let remarks = brdf.remarks().iter().filter(|remark| remark.place.is_none());
        builder
            .input
            .notes
            .extend(remarks.map(|remark| format!("'{}': {}", brdf.info().name, remark.message)));
        Ok(brdf.shape())
    }
}

/// An error in the text of a BRDF, at the place that names the text.
#[cfg(feature = "shader")]
fn problem(error: &glanz_shader::ShaderError, span: &std::ops::Range<usize>) -> Problem {
    let problem = Problem::at(span, error.to_string());
    match error {
        glanz_shader::ShaderError::Invalid { hints, .. } if !hints.is_empty() => {
            problem.help(hints.join("; "))
        }
        _ => problem,
    }
}
