//! Light geometry, and the checks on it.

use std::sync::Arc;

use glam::{DMat3, DVec3};
use glanz_scene::{AreaShape, Attenuation, Light, LightKind, Luminaire};

use crate::prepare::PrepareError;
use crate::prepare::build::integrals::irradiance::irradiance;
use crate::prepare::data::{
    EnvironmentLight, EnvironmentMap, IntensityGrid, Irradiance, LightShape, PreparedLight, PreparedLuminaire,
};

/// The lights that have a direction, in order.
pub(crate) fn prepare(scene_lights: &[Light]) -> Result<Vec<PreparedLight>, PrepareError> {
    let mut lights = Vec::new();
    for (number, light) in scene_lights.iter().enumerate() {
        lights.extend(prepare_one(number, light, None)?);
    }
    Ok(lights)
}

/// A light of this number; none if it has no direction. It takes over the environment map and the luminaire
/// of `before`, which is given where both are the same.
pub(crate) fn prepare_one(
    number: usize,
    light: &Light,
    before: Option<&PreparedLight>,
) -> Result<Option<PreparedLight>, PrepareError> {
    check_colors_of(number, light)?;
    let known = before.and_then(|before| match &before.shape {
        LightShape::Environment(environment) => Some(environment),
        _ => None,
    });
    let shape = match (&light.kind, known) {
        (LightKind::Environment { rotation, .. }, Some(known)) if rotation.is_finite() => {
            let rotation = rotation.to_cols_array_2d();
            Some(LightShape::Environment(EnvironmentLight { rotation, ..known.clone() }))
        }
        (kind, _) => shape(kind).map_err(|what| error(number, what))?,
    };
    let Some(shape) = shape else { return Ok(None) };
    let luminaire = match (&light.luminaire, before.and_then(|before| before.luminaire.as_ref())) {
        (Some(_), Some(known)) => Some(known.clone()),
        (own, _) => own.as_ref().map(luminaire).transpose().map_err(|what| error(number, what))?,
    };
    Ok(Some(PreparedLight { shape, luminaire, space: light.space }))
}

/// The colours of a light must be finite.
fn check_colors_of(number: usize, light: &Light) -> Result<(), PrepareError> {
    let colors = [&light.colors.ambient, &light.colors.diffuse, &light.colors.specular];
    match colors.iter().all(|color| color.is_finite()) {
        true => Ok(()),
        false => Err(error(number, "colors must be finite numbers")),
    }
}

fn error(number: usize, what: &str) -> PrepareError {
    PrepareError::Scene { what: format!("light {}: {what}", number + 1) }
}

fn shape(kind: &LightKind) -> Result<Option<LightShape>, &'static str> {
    Ok(Some(match *kind {
        LightKind::Area { shape, position, direction, up, two_sided } => {
            area(shape, position, direction, up, two_sided)?
        }
        LightKind::Environment { ref map, rotation } => LightShape::Environment(environment(map, rotation)?),
        LightKind::Ambient => return Ok(None),
        LightKind::Directional { direction } => {
            LightShape::Directional { towards: (-unit(direction)?).to_array() }
        }
        LightKind::Point { position, attenuation } => {
            LightShape::Point { position: finite(position)?.to_array(), attenuation: fading(attenuation)? }
        }
        LightKind::Spot { position, direction, cutoff, exponent, smooth_edge, attenuation } => {
            if !(0.0..=core::f64::consts::PI).contains(&cutoff) {
                return Err("the cut-off must be between 0 and 180 degrees");
            }
            if !(exponent >= 0.0 && exponent.is_finite()) {
                return Err("the exponent must be a number >= 0");
            }
            LightShape::Spot {
                position: finite(position)?.to_array(),
                axis: unit(direction)?.to_array(),
                cos_cutoff: libm::cos(cutoff),
                exponent,
                smooth_edge,
                attenuation: fading(attenuation)?,
            }
        }
    }))
}

fn area(
    form: AreaShape,
    position: DVec3,
    direction: DVec3,
    up: DVec3,
    two_sided: bool,
) -> Result<LightShape, &'static str> {
    if !(form.area() > 0.0 && form.area().is_finite()) {
        return Err("the size must be finite and greater than 0");
    }
    let axes = match form {
        AreaShape::Sphere { .. } => [DVec3::X, DVec3::Y, DVec3::Z],
        _ => {
            let facing = unit(direction)?;
            let across = |up: DVec3| up.cross(facing).try_normalize();
            // Disks look the same however they are turned.
            let other = if facing.y.abs() < 0.9 { DVec3::Y } else { DVec3::X };
            let width = match form {
                AreaShape::Rectangle { .. } => {
                    across(up).ok_or("'up' must not be parallel to the direction")?
                }
                _ => across(other).ok_or("the direction must be finite")?,
            };
            [width, facing.cross(width), facing]
        }
    };
    Ok(LightShape::Area {
        form,
        position: finite(position)?.to_array(),
        axes: axes.map(|axis| axis.to_array()),
        two_sided,
    })
}

fn environment(
    map: &Option<Arc<glanz_scene::EnvironmentMap>>,
    rotation: DMat3,
) -> Result<EnvironmentLight, &'static str> {
    if !rotation.is_finite() {
        return Err("the rotation must be finite numbers");
    }
    let map = map.as_ref().map(|map| Arc::new(EnvironmentMap::from(&**map)));
    let light = map.as_ref().map_or_else(Irradiance::uniform, |map| irradiance(map));
    Ok(EnvironmentLight { map, irradiance: light, rotation: rotation.to_cols_array_2d() })
}

fn luminaire(luminaire: &Luminaire) -> Result<PreparedLuminaire, &'static str> {
    let frame = luminaire.frame().ok_or("the luminaire's axis and C0 must be finite and not parallel")?;
    Ok(PreparedLuminaire {
        intensities: Arc::new(IntensityGrid::of(&luminaire.profile)),
        frame: frame.to_cols_array_2d(),
    })
}

fn finite(position: DVec3) -> Result<DVec3, &'static str> {
    if position.is_finite() { Ok(position) } else { Err("the position must be finite numbers") }
}

fn unit(direction: DVec3) -> Result<DVec3, &'static str> {
    direction.try_normalize().ok_or("the direction must be finite and not zero")
}

/// The factors of the denominator; none where nothing fades.
fn fading(attenuation: Attenuation) -> Result<Option<[f64; 3]>, &'static str> {
    let Attenuation { constant, linear, quadratic } = attenuation;
    let factors = [constant, linear, quadratic];
    if !factors.iter().all(|f| f.is_finite() && *f >= 0.0) || factors.iter().sum::<f64>() <= 0.0 {
        return Err("attenuation factors must be numbers >= 0, and not all 0");
    }
    Ok((attenuation != Attenuation::NONE).then_some(factors))
}
