//! glTF 2.0, as JSON with buffers and pictures beside it, or in one binary file.
//!
//! Read: the default scene with all its nodes, triangles of every mode, sparse and normalised
//! accessors, cameras, materials, textures, and the extensions `KHR_lights_punctual`,
//! `KHR_texture_transform`, `KHR_mesh_quantization` and of `KHR_materials_…`: `unlit`,
//! `emissive_strength`, `ior`, `specular`, `clearcoat`, `sheen`, `transmission`, `volume`,
//! `anisotropy`, `iridescence` and `pbrSpecularGlossiness`; `EXT_mesh_gpu_instancing`, `EXT_texture_webp`;
//! `KHR_draco_mesh_compression`, `EXT_meshopt_compression`, `KHR_meshopt_compression`. Other extensions are ignored
//! with a note, also where the file requires them if they are about materials and pictures alone, else refused there.
//! Skins are in the pose of the nodes, morph targets have the weights of the file; animations are ignored.
//!
//! # Materials
//! As Appendix B of the specification (Khronos Group, glTF 2.0, 2021) and the extensions have them.
//! With α = roughness², p = (1 − v·h)⁵ and f0 = min(((ior − 1)/(ior + 1))² · specularColor, 1):
//!
//! - dielectric: `lambert` · base · (1 − F) + `ggx` · specular · (f0 + (1 − f0) p), where F is specular · the
//!   greatest channel of the same;
//! - metal: `ggx` · (base + (1 − base) p); both weighed by metallicFactor times the texture's blue;
//! - sheen: `charlie` of α = sheenRoughness², the rest times 1 − its greatest channel · the greater albedo;
//! - clear coat: the rest times 1 − c, `ggx` times c = clearcoat · (0.04 + 0.96 (1 − n·v)⁵);
//! - transmission t: the dielectric's Lambert part times 1 − t, and `ggx-thin-transmission` · base · t (1 − F);
//! - anisotropy: the width along the tangent, turned by the rotation, is α + (1 − α) strength²;
//! - iridescence: that fraction of each F is a film's.
//!
//! Where a texture multiplies one of these factors, each lobe that changes with it stands once where the factor is 0 and once
//! where it is the whole: all are linear in it. A texture of colours is three such lobes, one for each channel.
//!
//! Where it differs:
//! - Masking is Smith's with correlated heights, as in KHR_materials_anisotropy; the sample code of Appendix B,
//!   which binds nobody, has the product of both directions.
//! - Films are Airy's sum at each wavelength with both polarisations, in air, over a base of the real index that
//!   f0 or the metal's base colour has. The extension takes two orders of it, Schlick's form for the
//!   boundaries, and three Gaussians for the eye (Belcour and Barla 2017). Textures of the base colour do not
//!   change a metal below a film.
//! - The transmittance of a surface is neither blurred nor changed by textures. At normal incidence it is
//!   base · t (1 − F); towards grazing light a pane with that reflectance goes by Fresnel's law and its colour
//!   deepens. Volumes absorb by their `thicknessFactor`, half at each face where both sides are drawn, and do
//!   not bend light.
//! - Textures of thickness, of a film's thickness and of anisotropy count by their mean, clear coats have the normals of
//!   the surface, and how rough a texture says that a sheen is does not change what it leaves to the base.
//! - A roughness texture multiplies both widths where they differ.
//! - A clear coat does not dim light of the surface itself.
//! - Specular and glossiness are a dielectric of that reflectance.
//! - Occlusion dims ambient light and surroundings, none of which glTF itself has.
//!
//! All of these but the first and the last are noted where they matter. Ambient light, which glTF does not have, finds the
//! base colour less what passes through, of metals nothing; a texture of metal counts by its mean. An unlit
//! material is emission alone. Factors above 1 count as 1; negative ones are refused.
//!
//! # Lights
//! A light of intensity I (candela, or lux where directional) on a white Lambert surface facing it
//! at 1 m gives I/π; a classic light of value 1 gives 1. So the classic value is I·colour/π, fading
//! by the inverse square law. Lights and cameras look along −z of their node. Ranges are ignored.
//!
//! The JSON is read into types of this module's own: the validation of the usual crate panics on
//! indices out of range.

mod accessor;
mod budget;
mod compression;
mod container;
mod extensions;
mod json;
mod layers;
mod material;
mod nodes;
mod pbr;
mod pose;
mod primitive;
mod source;
mod specular_glossiness;
mod textures;
mod variants;

use glanz_color::read::{Place, ReadError, excerpt};
use serde::Deserialize;
use serde_json::Value;

use super::context::Context;
use super::model::Model;
use budget::Budget;
use compression::{draco, meshopt};
use container::Buffers;
use json::Root;
use source::Source;

/// Extensions that are read.
const SUPPORTED: [&str; 20] = [
    "KHR_lights_punctual",
    "KHR_materials_unlit",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_specular",
    "KHR_materials_clearcoat",
    "KHR_materials_sheen",
    "KHR_materials_transmission",
    "KHR_materials_volume",
    "KHR_materials_anisotropy",
    "KHR_materials_iridescence",
    "KHR_materials_variants",
    "KHR_texture_transform",
    "KHR_mesh_quantization",
    "KHR_materials_pbrSpecularGlossiness",
    "EXT_mesh_gpu_instancing",
    "EXT_texture_webp",
    "KHR_draco_mesh_compression",
    "EXT_meshopt_compression",
    "KHR_meshopt_compression",
];

/// How the names of extensions begin without which the geometry is what it is: they are of materials, pictures, facts.
const OF_APPEARANCE: [&str; 8] = [
    "KHR_materials_",
    "EXT_materials_",
    "MSFT_texture_",
    "KHR_texture_",
    "EXT_texture_",
    "KHR_xmp",
    "KHR_animation",
    "EXT_lights_",
];

/// Reads a file.
pub(super) fn read(bytes: &[u8], context: &mut Context<'_>) -> Result<Model, ReadError> {
    let (json, binary) = container::split(bytes, context.file)?;
    let json = json.strip_prefix(b"\xef\xbb\xbf").unwrap_or(json);
    check_version(json, context.file)?;
    let mut root: Root = serde_json::from_slice(json).map_err(|error| json_error(&error, context.file))?;
    check_extensions(&root, context)?;
    root.materials.iter_mut().for_each(specular_glossiness::convert);
    variants::choose(&mut root, context)?;
    let buffers = Buffers::load(&root, binary, context)?;
    let budget = Budget::new(bytes.len() as u64 + buffers.total(), compression::is_in(&root));
    let source = Source {
        file: context.file,
        root: &root,
        buffers: &buffers,
        views: &meshopt::Views::new(&root),
        budget: &budget,
        draco: draco::Decoded::default(),
    };
    let variants = root.extensions.variants.variants.iter().map(|own| own.name.clone()).collect();
    let mut model = Model { variants, ..Model::default() };
    let mut builder = primitive::Builder::new(&source);
    nodes::read(&source, &mut builder, &mut model, &mut context.notes)?;
    let used = builder.finish(&mut model);
    material::read(&source, &used, &mut model, context)?;
    if model.objects.is_empty() {
        context.notes.add("the scene holds no triangles: nothing can be drawn");
    }
    if !root.animations.is_empty() {
        context.notes.add_times("animations are ignored", root.animations.len() as u64);
    }
    Ok(model)
}

fn json_error(error: &serde_json::Error, file: &str) -> ReadError {
    let place = Place::Column { line: error.line() as u64, column: error.column() as u64 };
    // The message of the parser says what it expected and found, and repeats the place.
    let text = error.to_string();
    let found = text.rsplit_once(" at line ").map_or(text.as_str(), |(message, _)| message);
    ReadError::malformed(file, place, "glTF 2.0 as JSON", found)
}

/// Looks at the version before all else: in glTF 1.0 lists are objects.
fn check_version(json: &[u8], file: &str) -> Result<(), ReadError> {
    let head: Head = serde_json::from_slice(json).map_err(|error| json_error(&error, file))?;
    let Some(version) = head.asset.unwrap_or_default().version else {
        let (place, expected) = (Place::Path("asset".to_owned()), "the version of glTF");
        return Err(ReadError::malformed(file, place, expected, "none (files of glTF 1.0 may leave it out)"));
    };
    let version = match version {
        Value::String(version) => version,
        other => other.to_string(),
    };
    match version == "2" || version.starts_with("2.") {
        true => Ok(()),
        false => {
            let (place, found) = (Place::Path("asset.version".to_owned()), format!("glTF {version}"));
            Err(ReadError::unsupported(file, place, "version 2 of glTF", clean(&found)))
        }
    }
}

/// The version of a file of any version.
#[derive(Deserialize)]
struct Head {
    asset: Option<HeadAsset>,
}

#[derive(Deserialize, Default)]
struct HeadAsset {
    version: Option<Value>,
}

/// A text of a file, fit for a message.
fn clean(text: &str) -> String {
    excerpt(text).trim_matches('\'').to_owned()
}

fn check_extensions(root: &Root, context: &mut Context<'_>) -> Result<(), ReadError> {
    let unknown = |name: &&String| !SUPPORTED.contains(&name.as_str());
    for name in root.extensions_required.iter().filter(unknown) {
        let place = Place::Path("extensionsRequired".to_owned());
        if !OF_APPEARANCE.iter().any(|start| name.starts_with(start)) {
            let expected = "extensions that docs/FORMATS.md names";
            return Err(ReadError::unsupported(context.file, place, expected, excerpt(name)));
        }
    }
    for name in root.extensions_used.iter().filter(unknown) {
        context.notes.add(&format!("glTF: the extension {name} is ignored"));
    }
    Ok(())
}

#[cfg(test)]
pub(in crate::read) mod tests;
