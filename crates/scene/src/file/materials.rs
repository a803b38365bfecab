//! Materials of a scene file.

use std::borrow::Cow;
use std::fmt;
use std::ops::Range;

use glanz_bsdf::{LightTerm, MODELS, ParamError};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::value::MapAccessDeserializer;
use serde::de::{MapAccess, Visitor};
use serde::{Deserialize, Deserializer};

use super::build::Builder;
use super::colors::ColorValue;
use super::error::Problem;
use super::layers::{CoatTable, PaneTable, transmittance};
use super::lobes::LobeTable;
use super::near::{did_you_mean, list};
use super::table;
use super::values::{Amount, At, Exponent, Fraction, Number};
use crate::names::names;
use crate::{AlphaMode, ClassicMaterial, Material, TextureFilter, Tint, Wrap};

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
    /// Makes the surface a sheet of glass: it mirrors, and what is behind it is seen through it.
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
    #[serde(default = "yes")]
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

fn yes() -> bool {
    true
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

/// A picture on a surface.
#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct TextureTable {
    /// A PNG or JPEG file, relative to the scene file.
    pub file: Option<String>,
    /// In place of a file, the name of one of the scene's `textures`.
    pub texture: Option<String>,
    /// What happens outside 0 to 1.
    pub wrap: Option<At<WrapValue>>,
    /// How texels become values.
    pub filter: Option<At<TextureFilter>>,
    /// Repetitions along u and v.
    pub repeat: Option<At<[Number; 2]>>,
    /// In place of `repeat`, the two rows of an affine map of the texture coordinates.
    pub transform: Option<At<[[Number; 3]; 2]>>,
    /// Scale of the x and y of normals; 1 by default.
    pub scale: Option<Amount>,
}

/// A texture that materials call by its name.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct NamedTextureTable {
    /// A name for people; that of the table by default.
    pub name: Option<String>,
    /// A PNG or JPEG file, relative to the scene file.
    pub file: At<String>,
    /// Whether its colours are sRGB codes; plain numbers if not, as in pictures of normals. They are by default.
    #[serde(default = "yes")]
    pub srgb: bool,
    /// What happens outside 0 to 1.
    #[serde(default)]
    pub wrap: WrapValue,
    /// How texels become values.
    #[serde(default)]
    pub filter: TextureFilter,
}

/// What happens outside 0 to 1: the same along u and v, or one for each.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct WrapValue(pub [Wrap; 2]);

impl<'de> Deserialize<'de> for WrapValue {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Form;
        impl<'de> Visitor<'de> for Form {
            type Value = WrapValue;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("\"repeat\", \"mirror\" or \"clamp\", or two of them")
            }
            fn visit_str<E: serde::de::Error>(self, name: &str) -> Result<WrapValue, E> {
                let wrap = Wrap::deserialize(serde::de::value::StrDeserializer::new(name))?;
                Ok(WrapValue([wrap; 2]))
            }
            fn visit_seq<A: serde::de::SeqAccess<'de>>(self, seq: A) -> Result<WrapValue, A::Error> {
                let list = serde::de::value::SeqAccessDeserializer::new(seq);
                <[Wrap; 2]>::deserialize(list).map(WrapValue)
            }
        }
        deserializer.deserialize_any(Form)
    }
}

impl JsonSchema for WrapValue {
    fn schema_name() -> Cow<'static, str> {
        "WrapValue".into()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let one = generator.subschema_for::<Wrap>();
        let two = generator.subschema_for::<[Wrap; 2]>();
        json_schema!({ "anyOf": [one, two] })
    }
}

/// A picture file, with or without how it is applied.
#[derive(Debug)]
pub(crate) struct TextureValue(pub TextureTable);

impl<'de> Deserialize<'de> for TextureValue {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Texture;
        impl<'de> Visitor<'de> for Texture {
            type Value = TextureTable;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("the name of a picture file, or a table such as { file = \"wood.png\" }")
            }
            fn visit_str<E>(self, file: &str) -> Result<TextureTable, E> {
                Ok(TextureTable { file: Some(file.to_owned()), ..TextureTable::default() })
            }
            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<TextureTable, A::Error> {
                TextureTable::deserialize(MapAccessDeserializer::new(map))
            }
        }
        deserializer.deserialize_any(Texture).map(Self)
    }
}

impl JsonSchema for TextureValue {
    fn schema_name() -> Cow<'static, str> {
        "Texture".into()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let table = generator.subschema_for::<TextureTable>();
        json_schema!({ "anyOf": [{ "type": "string", "description": "A PNG or JPEG file." }, table] })
    }
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
fn highlight_names() -> impl Iterator<Item = &'static str> {
    let highlight = |part| matches!(part, LightTerm::Specular | LightTerm::Diffuse);
    MODELS.iter().filter(move |info| highlight(info.term)).map(|info| info.name)
}

fn place<T>(value: &Option<At<T>>) -> Option<&Range<usize>> {
    value.as_ref().map(|v| &v.span)
}

impl MaterialTable {
    /// The material without its textures; `span` is where the table stands.
    pub fn build(&self, name: &str, builder: &mut Builder) -> Result<Material, Problem> {
        let mut material = match (&self.library, &self.lobes) {
            (Some(library), _) => {
                self.refuse_terms(library)?;
                Material { name: name.to_owned(), ..builder.library_material(library)? }
            }
            (None, Some(lobes)) => {
                self.refuse_classic_keys()?;
                let lobes = lobes.iter().map(|lobe| lobe.build(builder)).collect::<Result<_, _>>()?;
                Material::of_lobes(name, lobes)
            }
            (None, None) => self.classic(name, builder)?,
        };
        if let Some(pane) = &self.pane {
            pane.build(&mut material, builder, &pane.span)?;
        }
        if let Some(value) = self.transmittance(name, builder)? {
            if let Some(pane) = &self.pane {
                let message = "'pane' beside 'transmittance': a pane has its own";
                return Err(Problem::at(&pane.span, message));
            }
            material.transmittance = Some(transmittance(value, builder)?);
        }
        if let (Some(coat), Some(_)) = (&self.coat, &material.transmittance) {
            return Err(Problem::at(
                &coat.span,
                "a 'coat' over a surface with a transmittance: give the 'pane' its colour instead",
            ));
        }
        if let Some(coat) = &self.coat {
            material = coat.build(material, builder, &coat.span)?;
        }
        if let (Some(_), Some(radians)) = (&self.aniso_deg, &self.aniso_rad) {
            return Err(Problem::at(&radians.span, "'aniso_rad' beside 'aniso_deg'"));
        }
        let radians = self.aniso_rad.as_ref().map_or(0.0, |angle| angle.0);
        material.aniso = self.aniso_deg.map_or(radians, |angle| angle.0.to_radians());
        material.name = self.name.clone().unwrap_or_else(|| name.to_owned());
        material.two_sided = self.two_sided;
        material.cull_back = self.cull_back;
        material.alpha = self.alpha.map_or(1.0, |a| a.0 as f32);
        material.alpha_mode = self.alpha_mode()?;
        Ok(material)
    }

    fn transmittance(&self, name: &str, builder: &mut Builder) -> Result<Option<&At<ColorValue>>, Problem> {
        if let (Some(_), Some(old)) = (&self.transmittance, &self.see_through) {
            return Err(Problem::at(
                &old.span,
                "'see_through' beside 'transmittance', which is its new name",
            ));
        }
        if self.see_through.is_some() {
            builder.notes.push(format!("material '{name}': 'see_through' is now 'transmittance'"));
        }
        Ok(self.transmittance.as_ref().or(self.see_through.as_ref()))
    }

    fn alpha_mode(&self) -> Result<AlphaMode, Problem> {
        let translucent = self.alpha.is_some_and(|a| a.0 < 1.0);
        let default = if translucent { AlphaModeName::Blend } else { AlphaModeName::Opaque };
        let mode = self.alpha_mode.unwrap_or(default);
        if let (Some(cutoff), false) = (&self.alpha_cutoff, mode == AlphaModeName::Mask) {
            return Err(Problem::at(&cutoff.span, "'alpha_cutoff' needs alpha_mode = \"mask\""));
        }
        Ok(match mode {
            AlphaModeName::Opaque => AlphaMode::Opaque,
            AlphaModeName::Blend => AlphaMode::Blend,
            AlphaModeName::Mask => {
                AlphaMode::Mask { cutoff: self.alpha_cutoff.as_ref().map_or(0.5, |c| c.0 as f32) }
            }
        })
    }

    fn classic(&self, name: &str, builder: &mut Builder) -> Result<Material, Problem> {
        let mut tint = |color: &Option<At<ColorValue>>| {
            color.as_ref().map_or(Ok(Tint::BLACK), |color| builder.tint(color))
        };
        let defaults = ClassicMaterial::default();
        let mut classic = ClassicMaterial {
            ambient: tint(&self.ambient)?,
            diffuse: tint(&self.diffuse)?,
            specular: tint(&self.specular)?,
            emission: self.emission.as_ref().map_or(Ok(Tint::BLACK), |color| builder.emission(color))?,
            shininess: self.shininess.as_ref().map_or(defaults.shininess, |s| s.0),
            model: self.model.as_ref().map_or(defaults.model, |m| m.value.clone()),
        };
        if let Some(model) = &self.model {
            let Some(info) =
                MODELS.iter().find(|info| highlight_names().any(|n| n == info.name && n == **model))
            else {
                let near = did_you_mean(model, highlight_names());
                let known = format!("the models are: {}", list(highlight_names()));
                return Err(
                    Problem::at(&model.span, format!("unknown model '{}'{near}", model.value)).help(known)
                );
            };
            if info.term != LightTerm::Specular && !classic.specular.is_black() {
                classic.specular = Tint::BLACK;
                builder.notes.push(format!(
                    "material '{name}': '{}' has no highlight; 'specular' is not used",
                    info.name
                ));
            }
        }
        classic.build(name).map_err(|error| {
            let span = match &error {
                ParamError::OutOfRange { .. } => self.shininess.as_ref().map(|s| s.span.clone()),
                _ => self.model.as_ref().map(|m| m.span.clone()),
            };
            Problem { span, message: error.to_string(), help: None }
        })
    }

    fn classic_keys(&self) -> [(&'static str, Option<&Range<usize>>); 6] {
        [
            ("model", place(&self.model)),
            ("ambient", place(&self.ambient)),
            ("diffuse", place(&self.diffuse)),
            ("specular", place(&self.specular)),
            ("emission", place(&self.emission)),
            ("shininess", place(&self.shininess)),
        ]
    }

    /// That nothing stands beside `library` that would say again what the material is made of.
    fn refuse_terms(&self, library: &At<String>) -> Result<(), Problem> {
        let others = [
            ("lobes", place(&self.lobes)),
            ("pane", place(&self.pane)),
            ("transmittance", place(&self.transmittance)),
            ("see_through", place(&self.see_through)),
        ];
        match self.classic_keys().into_iter().chain(others).find_map(|(key, span)| Some((key, span?))) {
            Some((key, span)) => {
                let name = &library.value;
                let help = format!(
                    "`glanz material show {name}` prints the keys of '{name}', to be changed in its place"
                );
                Err(Problem::at(span, format!("'{key}' beside 'library'")).help(help))
            }
            None => Ok(()),
        }
    }

    fn refuse_classic_keys(&self) -> Result<(), Problem> {
        match self.classic_keys().into_iter().find_map(|(key, span)| Some((key, span?))) {
            Some((key, span)) => {
                let help = "give the classic block or the lobes; a term such as 'ambient' is a lobe too";
                Err(Problem::at(span, format!("'{key}' beside 'lobes'")).help(help))
            }
            None => Ok(()),
        }
    }
}
