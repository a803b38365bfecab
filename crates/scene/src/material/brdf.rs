//! Shapes that are users' BRDFs, from their texts.

use std::collections::BTreeMap;

use glanz_bsdf::{ModelSource, Shape};
use serde::de::Error;
use serde::{Deserialize, Deserializer};

/// What stands where users' BRDFs are not built in.
#[cfg(not(feature = "shader"))]
pub(crate) const OFF: &str = "a BRDF of one's own needs the feature 'shader' of glanz-scene, which is off";

/// A shape as `glanz_bsdf` serialises it.
#[derive(Deserialize)]
#[serde(rename = "Shape", deny_unknown_fields)]
struct Named {
    model: String,
    #[serde(default)]
    params: BTreeMap<String, f64>,
    #[serde(default)]
    source: Option<ModelSource>,
}

/// Reads a shape, which is one of the list or a user's BRDF.
pub(super) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Shape, D::Error> {
    let Named { model, params, source } = Named::deserialize(deserializer)?;
    let params: Vec<(&str, f64)> = params.iter().map(|(name, value)| (name.as_str(), *value)).collect();
    let Some(source) = source else { return Shape::named(&model, &params).map_err(D::Error::custom) };
    let mut shape = compiled(&source).map_err(D::Error::custom)?;
    for (name, value) in params {
        shape = shape.with(name, value).map_err(D::Error::custom)?;
    }
    Ok(shape)
}

#[cfg(feature = "shader")]
fn compiled(source: &ModelSource) -> Result<Shape, glanz_shader::ShaderError> {
    let text = glanz_shader::BrdfSource::new(&source.file, &source.text).named(&source.file);
    let text = if source.diffuse { text.diffuse() } else { text };
    Ok(text.compile()?.shape())
}

#[cfg(not(feature = "shader"))]
fn compiled(_: &ModelSource) -> Result<Shape, &'static str> {
    Err(OFF)
}
