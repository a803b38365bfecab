//! Materials.

use std::borrow::Cow;
use std::ops::Deref;

use glanz_bsdf::{LightTerm, MODELS, ModelInfo};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Deserializer};
use serde_json::{Value, json};

use super::layers::{CoatTable, PaneTable};
use super::lobes::LobeTable;
use super::measured::MeasuredTable;
use super::set_aside::{Other, SetAside};
use super::textures::{MaskTable, TextureValue};
use crate::file::tables::colors::ColorValue;
use crate::file::tables::table;
use crate::file::tables::values::{At, Exponent, Fraction, Number};
use crate::names::names;

/// A material: the classic block (`model` with its parameters, `ambient`, `diffuse`, `specular`, `shininess`,
/// `emission`; colours that are missing are black), a list of `lobes`, or one of the `library`.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "MaterialTable")]
pub(crate) struct MaterialKeys {
    /// The name of a material of the library, as `glanz material list` tells them. Its terms are taken as they are; a
    /// `coat` lies over them, and textures multiply those that textures multiply.
    pub library: Option<At<String>>,
    /// Model of the highlight, or of the diffuse term if it is matte; `phong` by default. Its parameters are keys, too.
    #[schemars(with = "Option<HighlightName>")]
    pub model: Option<At<String>>,
    /// Tint of the ambient term.
    pub ambient: Option<At<ColorValue>>,
    /// Tint of the diffuse term.
    pub diffuse: Option<At<ColorValue>>,
    /// Tint of the highlight.
    pub specular: Option<At<ColorValue>>,
    /// Light of its own.
    pub emission: Option<At<ColorValue>>,
    /// Exponent of the highlight: the greater, the smaller it is; 32 by default.
    pub shininess: Option<At<Exponent>>,
    /// The terms of a general material: shapes times tints.
    #[serde(default, deserialize_with = "lobes")]
    pub lobes: Option<At<Vec<LobeTable>>>,
    /// Measured reflectance, from a file; `lobes` may stand beside it, and a `coat` lies over both.
    pub measured: Option<At<MeasuredTable>>,
    /// A clear or coloured layer over all terms: varnish, glaze, the top of car paint.
    pub coat: Option<At<CoatTable>>,
    /// Makes the surface a sheet of glass: it reflects on both sides and transmits what is behind it.
    pub pane: Option<At<PaneTable>>,
    /// How much of the light from behind reaches the viewer: a colour, or a table with `ior` (what a boundary does not
    /// reflect), `film_nm` (what a film in air does not reflect) or `pane`.
    pub transmittance: Option<At<ColorValue>>,
    /// The old name of `transmittance`.
    #[schemars(skip)]
    pub see_through: Option<At<ColorValue>>,
    /// The angle in degrees from the mesh's tangent to the x axis of terms that know one; 0 by default.
    pub aniso_deg: Option<Number>,
    /// Whether the normal is turned to the viewer. If not, back faces get ambient light only.
    #[serde(default = "table::yes")]
    pub two_sided: bool,
    /// Whether back faces are not drawn at all.
    #[serde(default)]
    pub cull_back: bool,
    /// Opacity; 1 by default. Below 1 the surface is blended unless `alpha_mode` says otherwise.
    pub opacity: Option<At<Fraction>>,
    /// The width of a `model` that has one; else the old name of `opacity`.
    pub alpha: Option<At<Number>>,
    /// What the opacity, times the texture's alpha, does; `opaque` by default where `opacity` is 1.
    pub alpha_mode: Option<AlphaModeName>,
    /// The least alpha that a mask draws; 0.5 by default.
    pub alpha_cutoff: Option<At<Fraction>>,
    /// Picture that multiplies the ambient and diffuse tints; its alpha is the surface's.
    pub base_color_texture: Option<At<TextureValue>>,
    /// Picture of tangent-space normals, as glTF has them.
    pub normal_texture: Option<At<TextureValue>>,
    /// Picture that multiplies the emission.
    pub emission_texture: Option<At<TextureValue>>,
    /// Picture whose green scales roughness and whose blue scales metalness, as in glTF.
    pub metal_rough_texture: Option<At<TextureValue>>,
    /// Picture that says how much of ambient light and of surroundings arrives.
    pub occlusion_texture: Option<At<MaskTable>>,
    /// The same in radians, where degrees cannot say it exactly.
    pub aniso_rad: Option<At<Number>>,
    /// A name for people; that of the table by default.
    pub name: Option<String>,
}

/// A material, with the keys that are none of all materials': parameters of the model, if they are right.
#[derive(Debug)]
pub(crate) struct MaterialTable {
    keys: MaterialKeys,
    /// The other keys, with the number that they have, if they have one.
    pub others: Vec<Other>,
    /// The keys of all materials.
    pub known: &'static [&'static str],
}

impl Deref for MaterialTable {
    type Target = MaterialKeys;
    fn deref(&self) -> &MaterialKeys {
        &self.keys
    }
}

impl<'de> Deserialize<'de> for MaterialTable {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let (mut others, mut known): (_, &[&str]) = (Vec::new(), &[]);
        let set_aside = SetAside { inner: deserializer, others: &mut others, fields: &mut known };
        let keys = MaterialKeys::deserialize(set_aside)?;
        Ok(Self { keys, others, known })
    }
}

impl JsonSchema for MaterialTable {
    fn schema_name() -> Cow<'static, str> {
        MaterialKeys::schema_name()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let mut schema = MaterialKeys::json_schema(generator);
        let keys = schema.get_mut("properties").and_then(Value::as_object_mut).expect("it is of a struct");
        for param in MODELS.iter().filter(|info| is_classic(info)).flat_map(|info| info.params) {
            let of =
                |info: &&ModelInfo| is_classic(info) && info.params.iter().any(|own| own.name == param.name);
            let models: Vec<&str> = MODELS.iter().filter(of).map(|info| info.name).collect();
            let description = format!("Parameter of the model {}: {}", models.join(", "), param.doc);
            let entry = json!({ "type": "number", "description": description });
            keys.entry(param.name).or_insert(entry);
        }
        schema
    }
}

fn lobes<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<At<Vec<LobeTable>>>, D::Error> {
    #[derive(Deserialize)]
    #[serde(transparent)]
    struct List(#[serde(deserialize_with = "table::list")] Vec<LobeTable>);
    let At { value, span } = At::<List>::deserialize(deserializer)?;
    Ok(Some(At { value: value.0, span }))
}

names! {
    /// What alpha means.
    pub(crate) AlphaModeName {
        /// Nothing.
        Opaque = "opaque",
        /// Below the cutoff there is no surface.
        Mask = "mask",
        /// The surface lets what is behind it through.
        Blend = "blend",
    } default Opaque
}

/// The names that `model` takes.
struct HighlightName;

impl JsonSchema for HighlightName {
    fn schema_name() -> Cow<'static, str> {
        "Model".into()
    }
    fn inline_schema() -> bool {
        true
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "enum": highlight_names().collect::<Vec<_>>() })
    }
}

/// Whether a classic block can name the model: the highlights, and matte ones for none.
fn is_classic(info: &ModelInfo) -> bool {
    matches!(info.term, LightTerm::Specular | LightTerm::Diffuse)
}

/// The models that a classic block can name.
pub(crate) fn highlight_names() -> impl Iterator<Item = &'static str> {
    MODELS.iter().filter(|info| is_classic(info)).map(|info| info.name)
}

/// The models that a classic block can name and that have this parameter.
pub(crate) fn models_with(parameter: &str) -> Vec<&'static str> {
    let has = |info: &&ModelInfo| info.params.iter().any(|param| param.name == parameter);
    MODELS.iter().filter(|info| is_classic(info)).filter(has).map(|info| info.name).collect()
}
