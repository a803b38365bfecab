//! Both stages as WGSL, for GPUs.
//!
//! The modules are those that the machine runs, so that a program means the same on both. Each gets an entry point of
//! ours around the user's: it fills uniforms from a block of words that has the order of
//! [`UniformValues`](crate::UniformValues), takes inputs and gives outputs by location, and brings the places of vertices
//! from OpenGL's clip space to that of WebGPU. Pictures are drawn upside down: rows from the bottom, as in OpenGL, so that
//! `gl_FragCoord` and derivatives along y need no care.

mod build;
mod ports;
mod stage;

use std::collections::HashMap;
use std::sync::Arc;

use naga::valid::{Capabilities, ValidationFlags, Validator};
use naga::{Module, back};

use crate::lower::Purpose;
use crate::{Pair, ShaderError, Stage, ValueType};
use stage::Wrapped;

/// The name of the entry points.
pub const ENTRY: &str = "glanz_main";

/// What stands in front of all texts: GLSL asks for no derivatives where lanes go apart either, but does not forbid it.
const HEAD: &str = "diagnostic(off, derivative_uniformity);\n\n";

/// The module of a text, with what its variables stand for.
#[derive(Clone, Debug)]
pub(crate) struct Kept {
    pub(crate) module: Arc<Module>,
    pub(crate) roles: Arc<HashMap<String, Purpose>>,
}

/// An attribute of the vertices: a scalar, a vector, or one column of a matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GpuAttribute {
    /// Number of the vertex shader's input.
    pub input: usize,
    /// Which of its columns.
    pub column: usize,
    /// Its location.
    pub location: u32,
    /// Its type, of one column. Truth values are unsigned numbers.
    pub ty: ValueType,
}

/// A texture or a sampler of a stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GpuBinding {
    /// Its binding in the group of the stage.
    pub binding: u32,
    /// Number of the texture among the stage's; of a sampler that stands by itself, none.
    pub texture: Option<usize>,
    /// Whether it is a sampler.
    pub is_sampler: bool,
    /// Whether it is a cube map.
    pub is_cube: bool,
}

/// A stage as WGSL.
///
/// Its resources are in group 0 (vertex) or 1 (fragment). Binding 0 is a uniform block of rows of four words: the host's
/// own row ([`GpuStage::host_row`]), and then [`UniformValues::words`](crate::UniformValues::words).
///
/// ```
/// use glanz_shader::gpu::{ENTRY, GpuStage};
/// use glanz_shader::{Pair, Shader};
///
/// let text = "in vec2 uv; uniform sampler2D image; uniform vec3 tint; out vec4 c;
///     void main() { c = vec4(tint, 1.0) * texture(image, uv); }";
/// let stage = Pair::new(None, Some(&Shader::fragment(text)))?.to_gpu(0)?.fragment;
/// assert!(stage.text.contains(ENTRY));
/// assert_eq!(stage.rows, 2, "the host's and one of three words for the tint");
/// let kinds: Vec<_> = stage.bindings.iter().map(|own| (own.binding, own.texture, own.is_sampler)).collect();
/// assert_eq!(kinds, [(1, Some(0), false), (2, Some(0), true)]);
/// assert_eq!(GpuStage::host_row([0.0, 0.0]), [0; 4]);
/// # Ok::<(), glanz_shader::ShaderError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GpuStage {
    /// The text; its entry point is [`ENTRY`].
    pub text: String,
    /// Rows of the uniform block, 16 bytes each.
    pub rows: usize,
    /// What a vertex has; empty of the fragment stage.
    pub attributes: Vec<GpuAttribute>,
    /// Textures and samplers.
    pub bindings: Vec<GpuBinding>,
}

impl GpuStage {
    /// The host's row: by how much places in clip space are moved, in units of half a picture, for the samples of a pixel.
    pub fn host_row(shift: [f32; 2]) -> [u32; 4] {
        [shift[0].to_bits(), shift[1].to_bits(), 0, 0]
    }
}

/// Both stages as WGSL.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GpuPair {
    /// The vertex stage.
    pub vertex: GpuStage,
    /// The fragment stage. Its only colour is at location 0: red, green and blue, and 1, which says that there is something.
    pub fragment: GpuStage,
}

impl Pair {
    /// Both stages as WGSL; `color` is the number of the fragment shader's output that is drawn.
    ///
    /// ```
    /// use glanz_shader::{Pair, Shader};
    ///
    /// let fragment = Shader::fragment("in vec3 normal; out vec4 c; void main() { c = vec4(normalize(normal), 1.0); }");
    /// let pair = Pair::new(None, Some(&fragment))?;
    /// let gpu = pair.to_gpu(0)?;
    /// assert!(gpu.fragment.text.contains("@fragment"));
    /// assert!(gpu.vertex.text.contains("@vertex") && !gpu.vertex.attributes.is_empty());
    /// # Ok::<(), glanz_shader::ShaderError>(())
    /// ```
    ///
    /// # Errors
    /// If a stage needs what GPUs do not have by WebGPU.
    pub fn to_gpu(&self, color: usize) -> Result<GpuPair, ShaderError> {
        Ok(GpuPair {
            vertex: written(Wrapped::vertex(self)?, Stage::Vertex)?,
            fragment: written(Wrapped::fragment(self, color)?, Stage::Fragment)?,
        })
    }
}

fn written(wrapped: Wrapped, stage: Stage) -> Result<GpuStage, ShaderError> {
    let mut validator = Validator::new(ValidationFlags::all(), Capabilities::default());
    let info = validator.validate(&wrapped.module).map_err(|error| {
        let mut cause: &dyn std::error::Error = error.as_inner();
        while let Some(next) = cause.source() {
            cause = next;
        }
        refused(format!("the {} stage does not fit WebGPU: {cause}", stage.name()))
    })?;
    let text = back::wgsl::write_string(&wrapped.module, &info, back::wgsl::WriterFlags::empty())
        .map_err(|error| refused(format!("the {} stage cannot be said in WGSL: {error}", stage.name())))?;
    Ok(GpuStage {
        text: format!("{HEAD}{text}"),
        rows: wrapped.rows,
        attributes: wrapped.attributes,
        bindings: wrapped.bindings,
    })
}

/// What a GPU cannot do.
fn refused(message: impl Into<String>) -> ShaderError {
    ShaderError::Unsupported { message: message.into(), place: None }
}
