//! Materials.

use std::borrow::Cow;

use glanz_bsdf::{LightTerm, MODELS};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Deserializer};

use super::layers::{CoatTable, PaneTable};
use super::lobes::LobeTable;
use super::textures::TextureValue;
use crate::file::tables::colors::ColorValue;
use crate::file::tables::table;
use crate::file::tables::values::{At, Exponent, Fraction, Number};
use crate::names::names;

/// A material: the classic block (`model`, `ambient`, `diffuse`, `specular`, `shininess`, `emission`; colours
/// that are missing are black), a list of `lobes`, or one of the `library`.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct MaterialTable {
    /// The name of a material of the library, as `glanz material list` tells them. Its terms are taken as they are; a
    /// `coat` lies over them, and textures multiply those that textures multiply.
    pub library: Option<At<String>>,
    /// Model of the highlight; `phong` by default.
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
    pub alpha: Option<Fraction>,
    /// What alpha means; `opaque` by default where `alpha` is 1.
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
    /// The same in radians, where degrees cannot say it exactly.
    pub aniso_rad: Option<At<Number>>,
    /// A name for people; that of the table by default.
    pub name: Option<String>,
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

/// The models that a classic block can name: the highlights, and `lambert` for none.
pub(crate) fn highlight_names() -> impl Iterator<Item = &'static str> {
    let highlight = |part| matches!(part, LightTerm::Specular | LightTerm::Diffuse);
    MODELS.iter().filter(move |info| highlight(info.term)).map(|info| info.name)
}
