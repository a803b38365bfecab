//! The terms of a general material in a scene file.

use std::borrow::Cow;
use std::fmt;
use std::sync::Arc;

use glanz_bsdf::{LayerWeight, LightTerm, MODELS, ParamError, Shape, Side};
use glanz_color::Rgb;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Error, MapAccess, Visitor};
use serde::{Deserialize, Deserializer};
use serde_json::{Map, Value};

use super::build::Builder;
use super::colors::ColorValue;
use super::error::Problem;
use super::layer_weights::{LayerTable, MetalnessTable};
use super::near::{did_you_mean, list};
use super::sampled::AbsorptionTable;
use super::values::{At, Fraction, Number};
use crate::names::names;
use crate::{Absorption, Lobe, Metalness, Tint};

names! {
    /// How a tint depends on the angle.
    pub(crate) FresnelName {
        /// By Fresnel's law where an index of refraction is given, else not.
        Exact = "exact",
        /// In Schlick's form: the tint is the reflectance at normal incidence.
        Schlick = "schlick",
    } default Exact
}

/// The keys of all lobes.
const KEYS: [&str; 8] =
    ["shape", "tint", "textured", "weight", "fresnel", "layers", "absorption", "metalness"];

/// One term of a general material: `shape`, `tint`, `textured`, `weight`, `fresnel`, and the parameters of the
/// shape.
#[derive(Debug)]
pub(crate) struct LobeTable {
    shape: At<String>,
    tint: Option<At<ColorValue>>,
    textured: Option<bool>,
    weight: Option<At<Fraction>>,
    fresnel: Option<At<FresnelName>>,
    layers: Option<At<Vec<LayerTable>>>,
    absorption: Option<AbsorptionTable>,
    metalness: Option<MetalnessTable>,
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
                let (mut shape, mut tint, mut textured) = (None, None, None);
                let (mut weight, mut fresnel, mut params) = (None, None, Vec::new());
                let (mut layers, mut absorption, mut metalness) = (None, None, None);
                while let Some(key) = map.next_key::<At<String>>()? {
                    match key.as_str() {
                        "shape" => shape = Some(map.next_value()?),
                        "tint" => tint = Some(map.next_value()?),
                        "textured" => textured = Some(map.next_value()?),
                        "weight" => weight = Some(map.next_value()?),
                        "fresnel" => fresnel = Some(map.next_value()?),
                        "layers" => layers = Some(map.next_value()?),
                        "absorption" => absorption = Some(map.next_value()?),
                        "metalness" => metalness = Some(map.next_value()?),
                        _ => params.push((key, map.next_value()?)),
                    }
                }
                let shape = shape.ok_or_else(|| A::Error::missing_field("shape"))?;
                Ok(LobeTable {
                    shape,
                    tint,
                    textured,
                    weight,
                    fresnel,
                    layers,
                    absorption,
                    metalness,
                    params,
                })
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
        let layers = generator.subschema_for::<LayerTable>();
        let absorption = generator.subschema_for::<AbsorptionTable>();
        let metalness = generator.subschema_for::<MetalnessTable>();
        let variant = |info: &glanz_bsdf::ModelInfo| {
            let mut properties = Map::new();
            properties.insert("shape".into(), serde_json::json!({ "const": info.name }));
            properties.insert("tint".into(), color.clone().to_value());
            let textured = "Whether textures and vertex colours multiply the tint; for ambient and diffuse shapes by default.";
            properties
                .insert("textured".into(), serde_json::json!({ "type": "boolean", "description": textured }));
            properties.insert(
                "weight".into(),
                serde_json::json!({ "type": "number", "minimum": 0, "maximum": 1, "default": 1,
                    "description": "How much of the term there is." }),
            );
            properties.insert(
                "fresnel".into(),
                serde_json::json!({ "enum": ["exact", "schlick"], "default": "exact",
                    "description": "How the tint depends on the angle: exact for indices of refraction, or Schlick's form, in which any tint is the reflectance at normal incidence." }),
            );
            properties.insert(
                "layers".into(),
                serde_json::json!({ "type": "array", "items": layers.clone().to_value(),
                    "description": "The weights of the layers over the term, from the inner to the outer." }),
            );
            properties.insert("absorption".into(), absorption.clone().to_value());
            properties.insert("metalness".into(), metalness.clone().to_value());
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

impl LobeTable {
    /// The lobe.
    pub fn build(&self, builder: &mut Builder) -> Result<Lobe, Problem> {
        let params: Vec<(&str, f64)> = self.params.iter().map(|(k, v)| (k.as_str(), v.0)).collect();
        let shape = Shape::named(&self.shape, &params).map_err(|error| self.explain(&error))?;
        // Document 003's textures and vertex colours are surface colours: not light, not highlights.
        let textured =
            self.textured.unwrap_or(matches!(shape.info().term, LightTerm::Ambient | LightTerm::Diffuse));
        let tint = match &self.tint {
            None => Rgb::WHITE.into(),
            Some(color) if shape.info().term == LightTerm::Emission => builder.emission(color)?,
            Some(color) => builder.tint(color)?,
        };
        let tint = self.with_fresnel(tint)?;
        if shape.info().term == LightTerm::Specular && textured && tint.depends_on_angle() {
            return Err(Problem::at(&self.shape.span, "a highlight by Fresnel's law cannot be 'textured'"));
        }
        if let (Tint::Ior(ior), Side::Transmission) = (&tint, shape.info().side)
            && ior.k.max() > 0.0
        {
            let message = format!("light does not pass '{}', which is a metal", ior.name);
            return Err(Problem::at(&self.shape.span, message));
        }
        let is_lit = matches!(shape.info().term, LightTerm::Diffuse | LightTerm::Specular);
        if let (Some(weight), false) = (&self.weight, is_lit) {
            return Err(Problem::at(&weight.span, "'weight' is for terms that lights shine on")
                .help("make the tint of this term darker instead"));
        }
        if let (Some(weight), Some(_)) = (&self.weight, &self.layers) {
            return Err(Problem::at(
                &weight.span,
                "'weight' beside 'layers': give it as a layer, { constant = 0.5 }",
            ));
        }
        let weight = self.weight.as_ref().map(|weight| weight.0).filter(|weight| *weight < 1.0);
        let mut layers: Vec<_> = weight.map(LayerWeight::Constant).into_iter().collect();
        layers.extend(self.layers.iter().flat_map(|layers| layers.iter().map(LayerTable::weight)));
        let absorption =
            self.absorption.as_ref().map(|table| Absorption { depth: table.depth.0, eta: table.eta.0 });
        let metalness = self.metalness.as_ref().map_or(Metalness::Any, MetalnessTable::metalness);
        let absorption = absorption.map(Arc::new);
        Ok(Lobe { shape, tint, textured, layers, absorption, metalness })
    }

    /// The tint with the angle dependence that is asked for.
    fn with_fresnel(&self, tint: Tint) -> Result<Tint, Problem> {
        let Some(At { value: FresnelName::Schlick, span }) = &self.fresnel else { return Ok(tint) };
        match tint {
            Tint::Rgb(_) | Tint::Spectrum(_) => Ok(Tint::Schlick(Box::new(tint))),
            Tint::Ior(ior) => {
                let at_normal = Tint::Spectrum(Arc::new(ior.normal_reflectance()));
                Ok(Tint::Schlick(Box::new(at_normal)))
            }
            _ => Err(Problem::at(span, "Schlick's form needs a reflectance, or an index of refraction")),
        }
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
                let near = did_you_mean(name, known.split(", ").chain(KEYS));
                let message = format!("unknown key '{name}' in a lobe of shape '{model}'{near}");
                let help = format!("known keys: {}; parameters of '{model}': {known}", KEYS.join(", "));
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
