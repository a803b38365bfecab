//! Stages, languages and types of values.

/// A stage of the pipeline.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Stage {
    /// Once per vertex.
    Vertex,
    /// Once per pixel of a triangle.
    Fragment,
}

impl Stage {
    /// `vertex` or `fragment`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Vertex => "vertex",
            Self::Fragment => "fragment",
        }
    }
}

/// The language of a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Language {
    /// GLSL of any version from 1.10 to 4.60, GLSL ES, Shadertoy's, and BRDF Explorer's files.
    Glsl,
    /// WGSL.
    Wgsl,
}

impl Language {
    /// The language that the end of a file's name says; GLSL if it says nothing.
    pub fn of_file(name: &str) -> Self {
        if name.ends_with(".wgsl") { Self::Wgsl } else { Self::Glsl }
    }
}

/// What the bits of a scalar mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Scalar {
    /// A number in single precision.
    Float,
    /// A whole number of 32 bits.
    Int,
    /// One without sign.
    Uint,
    /// All bits or none.
    Bool,
}

/// The type of a scalar, vector or matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ValueType {
    /// Of its components.
    pub scalar: Scalar,
    /// 1, or more of a matrix.
    pub columns: usize,
    /// Components of a vector or of a column.
    pub rows: usize,
}

impl ValueType {
    /// How many scalars there are.
    pub fn scalars(self) -> usize {
        self.columns * self.rows
    }
}

impl core::fmt::Display for ValueType {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let (prefix, name) = match self.scalar {
            Scalar::Float => ("", "float"),
            Scalar::Int => ("i", "int"),
            Scalar::Uint => ("u", "uint"),
            Scalar::Bool => ("b", "bool"),
        };
        match (self.columns, self.rows) {
            (1, 1) => write!(f, "{name}"),
            (1, rows) => write!(f, "{prefix}vec{rows}"),
            (columns, 1) => write!(f, "{name}[{columns}]"),
            (columns, rows) if columns == rows => write!(f, "mat{rows}"),
            (columns, rows) => write!(f, "mat{columns}x{rows}"),
        }
    }
}

/// How a value goes from the vertices to the pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Interpolation {
    /// Correct in perspective.
    #[default]
    Perspective,
    /// Linear on the screen (`noperspective`).
    Linear,
    /// That of the last vertex (`flat`).
    Flat,
}
