//! The files beside a scene file.

use std::io::Cursor;

use glanz_color::exr::{SpectralImage, write_spectral_exr};

use super::WriteError;
use crate::scene::hash::Hash;
use crate::{EnvironmentMap, Mesh, Texture};

/// The files so far, each content once.
pub(super) struct SideFiles {
    folder: String,
    files: Vec<(String, Vec<u8>)>,
}

impl SideFiles {
    /// Files in this folder.
    pub(super) fn new(folder: &str) -> Self {
        Self { folder: folder.to_owned(), files: Vec::new() }
    }

    /// Adds a file and tells its name: a number for its content after what it is.
    pub(super) fn add(&mut self, what: &str, ending: &str, bytes: Vec<u8>) -> String {
        let mut hash = Hash::new();
        hash.bytes(&bytes);
        let folder = if self.folder.is_empty() { String::new() } else { format!("{}/", self.folder) };
        let name = format!("{folder}{what}-{:016x}.{ending}", hash.finish());
        if !self.files.iter().any(|(known, _)| *known == name) {
            self.files.push((name.clone(), bytes));
        }
        name
    }

    /// Adds files under names of their own in a folder of their own, and tells where the first is.
    pub(super) fn add_folder(&mut self, what: &str, named: &[(&str, &[u8])]) -> String {
        let mut hash = Hash::new();
        for (name, bytes) in named {
            hash.bytes(name.as_bytes());
            hash.bytes(bytes);
        }
        let before = if self.folder.is_empty() { String::new() } else { format!("{}/", self.folder) };
        let folder = format!("{before}{what}-{:016x}", hash.finish());
        for (name, bytes) in named {
            let name = format!("{folder}/{name}");
            if !self.files.iter().any(|(known, _)| *known == name) {
                self.files.push((name, bytes.to_vec()));
            }
        }
        let first = named.first().map_or("", |(name, _)| name);
        format!("{folder}/{first}")
    }

    /// All files.
    pub(super) fn finish(self) -> Vec<(String, Vec<u8>)> {
        self.files
    }
}

/// A texture as PNG.
pub(super) fn png(texture: &Texture) -> Result<Vec<u8>, WriteError> {
    let wrong =
        |message: String| WriteError::Picture { place: format!("texture '{}'", texture.name), message };
    let expected = texture.width as usize * texture.height as usize * 4;
    let picture = image::RgbaImage::from_raw(texture.width, texture.height, texture.rgba.clone());
    let picture = picture.filter(|_| expected == texture.rgba.len() && expected > 0).ok_or_else(|| {
        wrong(format!("expected {expected} bytes and at least one texel, found {}", texture.rgba.len()))
    })?;
    let mut bytes = Cursor::new(Vec::new());
    picture.write_to(&mut bytes, image::ImageFormat::Png).map_err(|error| wrong(error.to_string()))?;
    Ok(bytes.into_inner())
}

/// An environment map as OpenEXR, in single precision.
pub(super) fn exr(map: &EnvironmentMap) -> Result<Vec<u8>, WriteError> {
    let channel = |c: usize| map.pixels.iter().map(|pixel| pixel[c]).collect::<Vec<f32>>();
    let image = SpectralImage {
        width: map.width,
        height: map.height,
        rgb: Some([channel(0), channel(1), channel(2)]),
        ..SpectralImage::default()
    };
    let mut bytes = Cursor::new(Vec::new());
    write_spectral_exr(&mut bytes, image).map_err(|error| WriteError::Picture {
        place: "an environment map".to_owned(),
        message: error.to_string(),
    })?;
    Ok(bytes.into_inner())
}

/// The arrays of a mesh, one after the other, little-endian.
pub(super) fn mesh_data(mesh: &Mesh) -> Vec<u8> {
    let floats = mesh
        .positions
        .iter()
        .flat_map(|v| v.to_array())
        .chain(mesh.normals.iter().flat_map(|v| v.to_array()))
        .chain(mesh.uvs.iter().chain(&mesh.uvs2).flat_map(|v| v.to_array()))
        .chain(mesh.tangents.iter().flat_map(|v| v.to_array()))
        .chain(mesh.colors.iter().flat_map(|v| v.to_array()));
    let words = floats.map(f32::to_bits).chain(mesh.corners.iter().chain(&mesh.face_starts).copied());
    words.flat_map(u32::to_le_bytes).collect()
}
