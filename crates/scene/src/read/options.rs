//! What a reader may do.

use std::path::PathBuf;

use glanz_math::MemoryBudget;

/// What a reader may do, and how much.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReadOptions {
    /// The folder that the file and its references may not leave. `None`: the references may not
    /// leave the folder of the file itself, which may lie anywhere.
    pub root: Option<PathBuf>,
    /// Whether files outside of `root` are read all the same.
    pub allow_outside: bool,
    /// The most bytes that one file may have.
    pub max_bytes: u64,
    /// The most texels that a texture may have along one side.
    pub max_texture_side: u32,
    /// What textures, environments and triangles may take of memory, in all and by what is drawn of them.
    pub memory: MemoryBudget,
    /// The variant of a glTF file whose materials are taken (`KHR_materials_variants`), in place of the file's own.
    pub variant: Option<String>,
}

impl Default for ReadOptions {
    fn default() -> Self {
        Self {
            root: None,
            allow_outside: false,
            max_bytes: 16 << 30,
            max_texture_side: 16384,
            memory: MemoryBudget::default(),
            variant: None,
        }
    }
}
