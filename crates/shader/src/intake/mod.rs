//! From the user's text to naga's IR, with every byte's way back.
//!
//! naga reads GLSL of version 440 and more, with bindings and locations everywhere and without samplers as the courses
//! write them. So a preprocessor of our own comes first (`preprocess`), then a reader of top-level items (`items`), then
//! what they are rewritten to (`rewrite`). Uniforms, inputs and outputs become private variables: nothing about them has to
//! be laid out for a GPU, so booleans, 2×2 matrices, arrays and structs are all the same to it. `front` runs naga and leads
//! its errors back.

mod brdf;
mod front;
mod hints;
mod items;
mod nesting;
mod preprocess;
mod remarks;
mod rewrite;
mod source;
#[cfg(feature = "fuzz")]
mod steps;
mod token;

pub use brdf::Range;
pub(crate) use brdf::is_brdf_file;
pub(crate) use front::{Front, Texts, origin_of, read};
pub use preprocess::included_path;
pub(crate) use source::{Map, Origin, Sources};
#[cfg(feature = "fuzz")]
pub(crate) use steps::{expand, rewrite_text};

/// Texture `x` of a sampler `x` is called so in the IR.
pub(crate) const TEXTURE_SUFFIX: &str = "_glanz_texture";

/// Its sampler.
pub(crate) const SAMPLER_SUFFIX: &str = "_glanz_sampler";

/// The text of a file that is included: its path as written, and the name of the file that includes it.
pub(crate) type Include<'a> = &'a (dyn Fn(&str, &str) -> Option<String> + Sync);

/// What is wrong, before its place is looked up.
#[derive(Clone, Debug)]
pub(crate) struct Complaint {
    pub(crate) message: String,
    pub(crate) origin: Option<Origin>,
    pub(crate) hints: Vec<String>,
    pub(crate) unsupported: bool,
}

impl Complaint {
    fn at(message: impl Into<String>, origin: Origin) -> Self {
        Self { message: message.into(), origin: Some(origin), hints: Vec::new(), unsupported: false }
    }

    fn whole(message: impl Into<String>) -> Self {
        Self { message: message.into(), origin: None, hints: Vec::new(), unsupported: false }
    }

    fn unsupported(message: impl Into<String>, origin: Origin) -> Self {
        Self { unsupported: true, ..Self::at(message, origin) }
    }

    /// The error with its place.
    pub(crate) fn into_error(self, sources: &Sources) -> crate::ShaderError {
        let place = self.origin.map(|origin| sources.place(origin));
        if self.unsupported {
            crate::ShaderError::Unsupported { message: self.message, place }
        } else {
            crate::ShaderError::Invalid { message: self.message, place, hints: self.hints }
        }
    }
}
