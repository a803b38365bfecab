//! The formats of models.

use std::path::Path;

/// A file format that can be read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// glTF 2.0, as JSON or in one binary file.
    Gltf,
    /// Wavefront OBJ, with MTL.
    Obj,
    /// The Stanford polygon format, as text or binary.
    Ply,
    /// Stereolithography triangles, as text or binary.
    Stl,
}

impl Format {
    /// The file name endings that are known, for messages.
    pub const EXTENSIONS: &'static str = ".glb, .gltf, .obj, .ply or .stl";

    /// The format of a file of this name that begins with these bytes: unmistakable first bytes
    /// count more than the name, the name more than other first bytes.
    pub fn detect(path: &Path, head: &[u8]) -> Option<Self> {
        if head.starts_with(b"glTF") {
            return Some(Self::Gltf);
        }
        let head = head.strip_prefix(b"\xef\xbb\xbf").unwrap_or(head);
        if head.starts_with(b"ply\n") || head.starts_with(b"ply\r") {
            return Some(Self::Ply);
        }
        let extension = path.extension().map(|extension| extension.to_string_lossy().to_ascii_lowercase());
        match extension.as_deref() {
            Some("gltf" | "glb") => Some(Self::Gltf),
            Some("obj") => Some(Self::Obj),
            Some("ply") => Some(Self::Ply),
            Some("stl") => Some(Self::Stl),
            _ if head.trim_ascii_start().starts_with(b"{") => Some(Self::Gltf),
            _ if head.get(..5).is_some_and(|word| word.eq_ignore_ascii_case(b"solid")) => Some(Self::Stl),
            _ => None,
        }
    }
}
