//! Light geometry, and the checks on it.

use glam::DVec3;
use glanz_scene::{Attenuation, Light, LightKind, Scene, Space};

use super::PrepareError;

/// How the reach of a point or spot light falls with distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Falloff {
    /// Not at all.
    None,
    /// 1 / (c + l·d + q·d²).
    Polynomial {
        /// Constant part.
        constant: f64,
        /// Factor of the distance.
        linear: f64,
        /// Factor of its square.
        quadratic: f64,
    },
}

/// The geometry of a light with a direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightShape {
    /// Parallel light.
    Directional {
        /// Unit vector towards the light.
        towards: DVec3,
    },
    /// From a point.
    Point {
        /// Where.
        position: DVec3,
        /// How it fades.
        falloff: Falloff,
    },
    /// From a point into a cone.
    Spot {
        /// Where.
        position: DVec3,
        /// Unit axis, away from the light.
        axis: DVec3,
        /// Cosine of the cut-off angle.
        cos_cutoff: f64,
        /// Power of the cosine from the axis.
        exponent: f64,
        /// Instead of the power: cosines of the inner and outer edge.
        smooth_edge: Option<(f64, f64)>,
        /// How it fades.
        falloff: Falloff,
    },
}

/// A light, ready for the pixel loop. Its colour is in the materials' tint tables.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PreparedLight {
    /// Geometry.
    pub shape: LightShape,
    /// Whether positions and directions are the camera's.
    pub space: Space,
}

/// The lights of the scene that have a direction, in order.
pub(super) fn prepare(scene: &Scene) -> Result<Vec<PreparedLight>, PrepareError> {
    let mut lights = Vec::new();
    if scene.render.shadows {
        return Err(PrepareError::Scene { what: "shadows are not drawn yet".to_owned() });
    }
    for (number, light) in scene.lights.iter().enumerate() {
        if light.luminaire.is_some() {
            return Err(error(number, "luminaire profiles are not drawn yet"));
        }
        let colors = [&light.colors.ambient, &light.colors.diffuse, &light.colors.specular];
        if !colors.iter().all(|color| color.is_finite()) {
            return Err(error(number, "colors must be finite numbers"));
        }
        if let Some(shape) = shape(&light.kind).map_err(|what| error(number, what))? {
            lights.push(PreparedLight { shape, space: light.space });
        }
    }
    Ok(lights)
}

/// Whether [`prepare`] keeps a light: all but ambient ones.
pub(super) fn is_directed(light: &Light) -> bool {
    light.kind != LightKind::Ambient
}

/// Whether a light's value is a radiance rather than that of a lamp.
pub(super) fn is_radiance(light: &Light) -> bool {
    let _ = light;
    false
}

/// How many lights of the table a light is.
pub(super) fn rows(light: &Light) -> usize {
    let _ = light;
    1
}

fn error(number: usize, what: &str) -> PrepareError {
    PrepareError::Scene { what: format!("light {}: {what}", number + 1) }
}

fn shape(kind: &LightKind) -> Result<Option<LightShape>, &'static str> {
    Ok(Some(match *kind {
        LightKind::Ambient => return Ok(None),
        LightKind::Directional { direction } => LightShape::Directional { towards: -unit(direction)? },
        LightKind::Point { position, attenuation } => {
            LightShape::Point { position: finite(position)?, falloff: falloff(attenuation)? }
        }
        LightKind::Spot { position, direction, cutoff, exponent, smooth_edge, attenuation } => {
            if !(0.0..=core::f64::consts::PI).contains(&cutoff) {
                return Err("the cut-off must be between 0 and 180 degrees");
            }
            if !(exponent >= 0.0 && exponent.is_finite()) {
                return Err("the exponent must be a number >= 0");
            }
            LightShape::Spot {
                position: finite(position)?,
                axis: unit(direction)?,
                cos_cutoff: libm::cos(cutoff),
                exponent,
                smooth_edge,
                falloff: falloff(attenuation)?,
            }
        }
        LightKind::Area { .. } => return Err("area lights are not drawn yet"),
        LightKind::Environment { .. } => return Err("environment lights are not drawn yet"),
    }))
}

fn finite(position: DVec3) -> Result<DVec3, &'static str> {
    if position.is_finite() { Ok(position) } else { Err("the position must be finite numbers") }
}

fn unit(direction: DVec3) -> Result<DVec3, &'static str> {
    direction.try_normalize().ok_or("the direction must be finite and not zero")
}

fn falloff(attenuation: Attenuation) -> Result<Falloff, &'static str> {
    let Attenuation { constant, linear, quadratic } = attenuation;
    let factors = [constant, linear, quadratic];
    if !factors.iter().all(|f| f.is_finite() && *f >= 0.0) || factors.iter().sum::<f64>() <= 0.0 {
        return Err("attenuation factors must be numbers >= 0, and not all 0");
    }
    Ok(match attenuation == Attenuation::NONE {
        true => Falloff::None,
        false => Falloff::Polynomial { constant, linear, quadratic },
    })
}
