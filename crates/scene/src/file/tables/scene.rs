//! A scene file as a whole.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Deserialize;

use super::appearance::materials::MaterialTable;
use super::appearance::textures::NamedTextureTable;
use super::camera::CameraRef;
use super::colors::{ColorValue, SpectrumValue};
use super::eye::EyeTable;
use super::geometry::meshes::MeshTable;
use super::geometry::objects::ObjectTable;
use super::lights::LightTable;
use super::program::ProgramTable;
use super::settings::{ImageTable, RenderTable};
use super::table;
use super::values::{Amount, At};

/// A Glanz scene: picture, camera, lights, materials and objects.
///
/// Lengths in metres, angles in degrees, right-handed axes with +Y up, linear RGB colours.
#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
#[schemars(title = "Glanz scene")]
pub(crate) struct SceneTable {
    /// The picture to be made.
    #[serde(deserialize_with = "table::table")]
    pub image: ImageTable,
    /// Where the eye is. Without it the scene is framed automatically. The name of a camera of a
    /// glTF file chooses that one.
    pub camera: Option<At<CameraRef>>,
    /// The eye that looks, and how it looks.
    #[serde(default, deserialize_with = "table::optional")]
    pub eye: Option<At<EyeTable>>,
    /// How to draw.
    #[serde(deserialize_with = "table::table")]
    pub render: RenderTable,
    /// Light that comes from everywhere.
    #[serde(default, deserialize_with = "table::optional")]
    pub ambient: Option<At<AmbientTable>>,
    /// The lights. A scene without lights is dark.
    #[serde(deserialize_with = "table::placed_list")]
    pub lights: Vec<At<LightTable>>,
    /// Textures that materials call by name, in the order of the file.
    #[serde(default, deserialize_with = "table::placed_map")]
    pub textures: BTreeMap<String, At<NamedTextureTable>>,
    /// Meshes that objects call by name, in the order of the file.
    #[serde(default, deserialize_with = "table::placed_map")]
    pub meshes: BTreeMap<String, At<MeshTable>>,
    /// The materials, by name.
    #[serde(deserialize_with = "table::placed_map")]
    pub materials: BTreeMap<String, At<MaterialTable>>,
    /// Shaders that draw all objects that have none of their own, in place of their materials.
    #[serde(default, deserialize_with = "table::optional")]
    pub program: Option<At<ProgramTable>>,
    /// The objects.
    #[serde(deserialize_with = "table::placed_list")]
    pub objects: Vec<At<ObjectTable>>,
}

/// Light that comes from everywhere.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct AmbientTable {
    /// What it sends to the ambient term of every material.
    pub color: Option<At<ColorValue>>,
    /// Its spectrum, in place of `color`: the name of a light source, or a table.
    pub spectrum: Option<At<SpectrumValue>>,
    /// How bright the environment is that it comes from, in cd/m², in place of the classic unit.
    pub luminance_cd_m2: Option<At<Amount>>,
}
