//! What a program takes and gives.

use crate::lower::TextureInfo;
use crate::{Interpolation, Place, Role, Scalar, ValueType};

/// An input or output of a program.
///
/// Structs and arrays are their members and elements, each by its own: `lights[2].position`.
#[derive(Clone, Debug, PartialEq)]
pub struct Port {
    /// Its name in the source, that of a block with its members: `Varyings.normal`.
    pub name: String,
    /// Whether the pipeline has it (`gl_Position`, `gl_FragCoord`…).
    pub builtin: bool,
    /// Its type.
    pub ty: ValueType,
    /// What a vertex input stands for, if its name says it.
    pub role: Option<Role>,
    /// `layout(location = …)`, if the source has it.
    pub location: Option<u32>,
    /// How it goes from the vertices to the pixels.
    pub interpolation: Interpolation,
    /// Where it is declared.
    pub place: Option<Place>,
}

/// A uniform: a scalar, vector or matrix, by itself or in a struct, array or block.
#[derive(Clone, Debug, PartialEq)]
pub struct Uniform {
    /// As the source would name it: `material.diffuse`, `lights[2].position`.
    pub name: String,
    /// Its type.
    pub ty: ValueType,
    /// What it stands for, if its name says it; others are the user's to set.
    pub role: Option<Role>,
    /// The range that a BRDF file gives.
    pub range: Option<(f32, f32)>,
    /// Where it is declared.
    pub place: Option<Place>,
    /// Its first word in [`UniformValues`].
    pub(crate) word: usize,
}

/// What a program takes and gives.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Interface {
    /// All uniforms but textures.
    pub uniforms: Vec<Uniform>,
    /// Textures; their place in the list is their number in [`TextureQuery`](crate::TextureQuery).
    pub textures: Vec<TextureInfo>,
    /// What the program takes for each vertex or fragment.
    pub inputs: Vec<Port>,
    /// What it gives.
    pub outputs: Vec<Port>,
}

impl Interface {
    /// The number of the input of this name.
    pub fn input(&self, name: &str) -> Option<usize> {
        self.inputs.iter().position(|port| port.name == name)
    }

    /// The number of the output of this name.
    pub fn output(&self, name: &str) -> Option<usize> {
        self.outputs.iter().position(|port| port.name == name)
    }

    /// The uniform of this name.
    pub fn uniform(&self, name: &str) -> Option<&Uniform> {
        self.uniforms.iter().find(|uniform| uniform.name == name)
    }
}

/// A uniform that cannot be set so.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum UniformError {
    /// There is no uniform of this name.
    #[error("there is no uniform '{name}'{hint}")]
    Unknown {
        /// The name.
        name: String,
        /// Names that are near.
        hint: String,
    },
    /// The number of values is not that of its components.
    #[error("the uniform '{name}' is a {ty} of {wanted} numbers, not {given}")]
    Count {
        /// The name.
        name: String,
        /// Its type.
        ty: String,
        /// How many numbers it has.
        wanted: usize,
        /// How many were given.
        given: usize,
    },
}

/// The values of a program's uniforms, to begin with those of the source.
///
/// ```
/// use glanz_shader::Shader;
///
/// let program = Shader::fragment(
///     "uniform int count = 3; uniform float shininess = 32.0; \
///      void main() { gl_FragColor = vec4(shininess * float(count)); }",
/// )
/// .compile()?;
/// let mut uniforms = program.uniforms();
/// uniforms.set("shininess", &[64.0])?;
/// assert_eq!((uniforms.get("shininess"), uniforms.get("count")), (Some(vec![64.0]), Some(vec![3.0])));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct UniformValues {
    pub(crate) words: Vec<u32>,
    uniforms: Vec<Uniform>,
}

impl UniformValues {
    pub(crate) fn new(uniforms: &[Uniform], defaults: &[u32]) -> Self {
        Self { words: defaults.to_vec(), uniforms: uniforms.to_vec() }
    }

    /// All values as words of 32 bits, in the order of [`Interface::uniforms`]; truth values are 0 or not.
    pub fn words(&self) -> &[u32] {
        &self.words
    }

    /// Sets a uniform: one number per component, column by column of a matrix. Whole numbers are rounded to, and a truth
    /// value is whether the number is not 0.
    pub fn set(&mut self, name: &str, values: &[f32]) -> Result<(), UniformError> {
        let Some(uniform) = self.uniforms.iter().find(|uniform| uniform.name == name) else {
            let names = self.uniforms.iter().map(|uniform| uniform.name.as_str());
            let hint = glanz_math::names::did_you_mean(name, names);
            return Err(UniformError::Unknown { name: name.to_owned(), hint });
        };
        let (wanted, given) = (uniform.ty.scalars(), values.len());
        if wanted != given {
            let (name, ty) = (name.to_owned(), uniform.ty.to_string());
            return Err(UniformError::Count { name, ty, wanted, given });
        }
        for (word, value) in self.words.iter_mut().skip(uniform.word).zip(values) {
            *word = match uniform.ty.scalar {
                Scalar::Float => value.to_bits(),
                Scalar::Int => value.round() as i32 as u32,
                Scalar::Uint => value.round() as u32,
                Scalar::Bool => {
                    if *value == 0.0 {
                        0
                    } else {
                        u32::MAX
                    }
                }
            };
        }
        Ok(())
    }

    /// The numbers of a uniform, as [`Self::set`] takes them.
    pub fn get(&self, name: &str) -> Option<Vec<f32>> {
        let uniform = self.uniforms.iter().find(|uniform| uniform.name == name)?;
        let words = self.words.iter().skip(uniform.word).take(uniform.ty.scalars());
        Some(words.map(|word| number(*word, uniform.ty.scalar)).collect())
    }
}

/// The number that a word is.
pub(crate) fn number(word: u32, scalar: Scalar) -> f32 {
    match scalar {
        Scalar::Float => f32::from_bits(word),
        Scalar::Int => word as i32 as f32,
        Scalar::Uint => word as f32,
        Scalar::Bool => {
            if word == 0 {
                0.0
            } else {
                1.0
            }
        }
    }
}
