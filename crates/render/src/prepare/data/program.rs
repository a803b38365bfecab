//! Shaders of the user's own, compiled.

use glanz_scene::Program;
use glanz_shader::Pair;

/// A program of the scene, ready to run.
#[derive(Clone, Debug)]
pub struct PreparedProgram {
    /// What it was compiled from.
    pub source: Program,
    /// Both stages, and what goes from the one to the other.
    pub pair: Pair,
    /// The number of the fragment shader's output that is the colour.
    pub color: Option<usize>,
}

/// Equal texts and values make equal programs.
impl PartialEq for PreparedProgram {
    fn eq(&self, other: &Self) -> bool {
        self.source == other.source
    }
}
