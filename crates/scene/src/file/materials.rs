//! Materials of a scene file.

use std::borrow::Cow;
use std::fmt;
use std::ops::Range;

use glanz_bsdf::{MODELS, ParamError, Part, Shape};
use glanz_color::Rgb;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::value::MapAccessDeserializer;
use serde::de::{Error, MapAccess, Visitor};
use serde::{Deserialize, Deserializer};
use serde_json::{Map, Value};

use super::build::Builder;
use super::colors::ColorValue;
use super::error::Problem;
use super::near::{did_you_mean, list};
use super::table;
use super::types::names;
use super::values::{Amount, At, Exponent, Number, Share};
use crate::{AlphaMode, ClassicMaterial, Lobe, Material, Tint};

/// A material: either the classic block (`model`, `ambient`, `diffuse`, `specular`, `shininess`,
/// `emission`; colours that are missing are black) or a list of `lobes`.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct MaterialTable {
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
    /// Whether the normal is turned to the viewer. If not, back faces get ambient light only.
    #[serde(default = "yes")]
    pub two_sided: bool,
    /// Whether back faces are not drawn at all.
    #[serde(default)]
    pub cull_back: bool,
    /// Opacity; 1 by default. Below 1 the surface is blended unless `alpha_mode` says otherwise.
    pub alpha: Option<Share>,
    /// What alpha means; `opaque` by default where `alpha` is 1.
    pub alpha_mode: Option<AlphaModeName>,
    /// The least alpha that a mask draws; 0.5 by default.
    pub alpha_cutoff: Option<At<Share>>,
    /// Picture that multiplies the ambient and diffuse tints; its alpha is the surface's.
    pub base_color_texture: Option<At<TextureValue>>,
    /// Picture of tangent-space normals, as glTF has them.
    pub normal_texture: Option<At<TextureValue>>,
    /// Picture that multiplies the emission.
    pub emission_texture: Option<At<TextureValue>>,
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
        #[default]
        Opaque = "opaque",
        /// Below the cutoff there is no surface.
        Mask = "mask",
        /// The surface lets what is behind it through.
        Blend = "blend",
    }
}

/// A picture on a surface.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct TextureTable {
    /// A PNG or JPEG file, relative to the scene file.
    pub file: String,
    /// What happens outside 0 to 1.
    #[serde(default)]
    pub wrap: WrapName,
    /// How texels become values.
    #[serde(default)]
    pub filter: FilterName,
    /// Repetitions along u and v.
    pub repeat: Option<[Number; 2]>,
    /// Scale of the x and y of normals; 1 by default.
    pub scale: Option<Amount>,
}

names! {
    /// What happens outside 0 to 1.
    pub(crate) WrapName {
        /// The picture repeats.
        #[default]
        Repeat = "repeat",
        /// Every second repetition is mirrored.
        Mirror = "mirror",
        /// The edge continues.
        Clamp = "clamp",
    }
}

names! {
    /// How texels become values.
    pub(crate) FilterName {
        /// Linear between texels and between mip levels.
        #[default]
        Trilinear = "trilinear",
        /// The nearest texel.
        Nearest = "nearest",
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
                let (wrap, filter) = (WrapName::default(), FilterName::default());
                Ok(TextureTable { file: file.to_owned(), wrap, filter, repeat: None, scale: None })
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

/// One term of a general material: `shape`, `tint`, `textured`, and the parameters of the shape.
#[derive(Debug)]
pub(crate) struct LobeTable {
    shape: At<String>,
    tint: Option<At<ColorValue>>,
    textured: Option<bool>,
    params: Vec<(At<String>, At<Number>)>,
}

impl<'de> Deserialize<'de> for LobeTable {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct LobeVisitor;
        impl<'de> Visitor<'de> for LobeVisitor {
            type Value = LobeTable;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a lobe such as { shape = \"lambert\", tint = [0.7, 0.7, 0.2] }")
            }
            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<LobeTable, A::Error> {
                let (mut shape, mut tint, mut textured, mut params) = (None, None, None, Vec::new());
                while let Some(key) = map.next_key::<At<String>>()? {
                    match key.as_str() {
                        "shape" => shape = Some(map.next_value()?),
                        "tint" => tint = Some(map.next_value()?),
                        "textured" => textured = Some(map.next_value()?),
                        _ => params.push((key, map.next_value()?)),
                    }
                }
                let shape = shape.ok_or_else(|| A::Error::missing_field("shape"))?;
                Ok(LobeTable { shape, tint, textured, params })
            }
        }
        deserializer.deserialize_any(LobeVisitor)
    }
}

impl JsonSchema for LobeTable {
    fn schema_name() -> Cow<'static, str> {
        "Lobe".into()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let color = generator.subschema_for::<ColorValue>();
        let variant = |info: &glanz_bsdf::ModelInfo| {
            let mut properties = Map::new();
            properties.insert("shape".into(), serde_json::json!({ "const": info.name }));
            properties.insert("tint".into(), color.clone().to_value());
            let textured = "Whether textures and vertex colours multiply the tint; for ambient and diffuse shapes by default.";
            properties
                .insert("textured".into(), serde_json::json!({ "type": "boolean", "description": textured }));
            for param in info.params {
                let schema = serde_json::json!({
                    "type": "number", "description": param.doc, "default": param.default,
                    "minimum": param.min, "maximum": param.max,
                });
                properties.insert(param.name.into(), schema);
            }
            serde_json::json!({
                "type": "object", "title": info.title, "required": ["shape"],
                "additionalProperties": false, "properties": properties,
            })
        };
        let variants: Vec<Value> = MODELS.iter().map(variant).collect();
        json_schema!({ "description": "A term of a material: a shape times a tint.", "oneOf": variants })
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
    let highlight = |part| matches!(part, Part::Specular | Part::Diffuse);
    MODELS.iter().filter(move |info| highlight(info.part)).map(|info| info.name)
}

impl MaterialTable {
    /// The material without its textures; `span` is where the table stands.
    pub fn build(&self, name: &str, builder: &mut Builder) -> Result<Material, Problem> {
        let mut material = match &self.lobes {
            Some(lobes) => {
                self.refuse_classic_keys()?;
                let lobes = lobes.iter().map(|lobe| lobe.build(builder)).collect::<Result<_, _>>()?;
                Material::of_lobes(name, lobes)
            }
            None => self.classic(name, builder)?,
        };
        material.two_sided = self.two_sided;
        material.cull_back = self.cull_back;
        material.alpha = self.alpha.map_or(1.0, |a| a.0 as f32);
        material.alpha_mode = self.alpha_mode()?;
        Ok(material)
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
            if info.part != Part::Specular && !classic.specular.is_black() {
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

    fn refuse_classic_keys(&self) -> Result<(), Problem> {
        fn place<T>(value: &Option<At<T>>) -> Option<&Range<usize>> {
            value.as_ref().map(|v| &v.span)
        }
        let given = [
            ("model", place(&self.model)),
            ("ambient", place(&self.ambient)),
            ("diffuse", place(&self.diffuse)),
            ("specular", place(&self.specular)),
            ("emission", place(&self.emission)),
            ("shininess", place(&self.shininess)),
        ];
        match given.into_iter().find_map(|(key, span)| Some((key, span?))) {
            Some((key, span)) => {
                let help = "give the classic block or the lobes; a term such as 'ambient' is a lobe too";
                Err(Problem::at(span, format!("'{key}' beside 'lobes'")).help(help))
            }
            None => Ok(()),
        }
    }
}

impl LobeTable {
    fn build(&self, builder: &mut Builder) -> Result<Lobe, Problem> {
        let params: Vec<(&str, f64)> = self.params.iter().map(|(k, v)| (k.as_str(), v.0)).collect();
        let shape = Shape::named(&self.shape, &params).map_err(|error| self.explain(&error))?;
        // Document 003's textures and vertex colours are surface colours: not light, not highlights.
        let textured = self.textured.unwrap_or(matches!(shape.info().part, Part::Ambient | Part::Diffuse));
        let tint = match &self.tint {
            None => Rgb::WHITE.into(),
            Some(color) if shape.info().part == Part::Emission => builder.emission(color)?,
            Some(color) => builder.tint(color)?,
        };
        if let (Tint::Ior(_), Part::Specular, true) = (&tint, shape.info().part, textured) {
            return Err(Problem::at(&self.shape.span, "a highlight by Fresnel's law cannot be 'textured'"));
        }
        Ok(Lobe { textured, ..Lobe::new(shape, tint) })
    }

    fn explain(&self, error: &ParamError) -> Problem {
        match error {
            ParamError::UnknownModel { name, .. } => {
                let names = || MODELS.iter().map(|info| info.name);
                let message = format!("unknown shape '{name}'{}", did_you_mean(name, names()));
                Problem::at(&self.shape.span, message).help(format!("the shapes are: {}", list(names())))
            }
            ParamError::UnknownParam { model, name, known } => {
                let span = self.params.iter().find(|(key, _)| key.value == *name).map(|(key, _)| &key.span);
                let near = did_you_mean(name, known.split(", ").chain(["shape", "tint", "textured"]));
                let message = format!("unknown key '{name}' in a lobe of shape '{model}'{near}");
                let help = format!("known keys: shape, tint, textured; parameters of '{model}': {known}");
                Problem::at(span.unwrap_or(&self.shape.span), message).help(help)
            }
            ParamError::OutOfRange { name, .. } => {
                let span =
                    self.params.iter().find(|(key, _)| key.value == *name).map(|(_, value)| &value.span);
                Problem::at(span.unwrap_or(&self.shape.span), error.to_string())
            }
        }
    }
}
