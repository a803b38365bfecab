//! Light geometry, and the checks on it.

use std::sync::Arc;

use glam::{DMat3, DVec3};
use glanz_scene::{AreaShape, Attenuation, Light, LightKind, Luminaire, Scene, Space};

use crate::prepare::PrepareError;
use crate::prepare::data::environment_map::EnvironmentMap;
use crate::prepare::data::intensity_grid::IntensityGrid;
use crate::prepare::data::irradiance::Irradiance;

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
#[derive(Clone, Debug, PartialEq)]
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
    /// A surface that shines evenly.
    Area {
        /// Its form and size.
        form: AreaShape,
        /// Its centre.
        position: DVec3,
        /// Unit vectors along its width, its height and the way it faces.
        axes: [DVec3; 3],
        /// Whether it shines on its back, too.
        two_sided: bool,
    },
    /// EnvironmentLight.
    Environment(EnvironmentLight),
}

/// EnvironmentLight at infinite distance.
#[derive(Clone, Debug, PartialEq)]
pub struct EnvironmentLight {
    /// What they look like; `None` for 1 everywhere.
    pub map: Option<Arc<EnvironmentMap>>,
    /// What a matte surface gets of them.
    pub irradiance: Irradiance,
    /// From their directions to the light's space.
    pub rotation: DMat3,
}

/// Intensities over directions, and how they are turned.
#[derive(Clone, Debug, PartialEq)]
pub struct PreparedLuminaire {
    /// IntensityGrid of the greatest intensity.
    pub intensities: Arc<IntensityGrid>,
    /// The directions of C 0°, C 90° and γ 0°.
    pub frame: DMat3,
}

/// A light, ready for the pixel loop. Its colour is in the materials' tint tables.
#[derive(Clone, Debug, PartialEq)]
pub struct PreparedLight {
    /// Geometry.
    pub shape: LightShape,
    /// Where it sends more and where less; none where it sends the same everywhere.
    pub luminaire: Option<PreparedLuminaire>,
    /// Whether positions and directions are the camera's.
    pub space: Space,
}

/// The lights of the scene that have a direction, in order.
pub(crate) fn prepare(scene: &Scene) -> Result<Vec<PreparedLight>, PrepareError> {
    check_colors(scene)?;
    let mut lights = Vec::new();
    for (number, light) in scene.lights.iter().enumerate() {
        if let Some(shape) = shape(&light.kind).map_err(|what| error(number, what))? {
            let luminaire = light.luminaire.as_ref().map(luminaire).transpose();
            let luminaire = luminaire.map_err(|what| error(number, what))?;
            lights.push(PreparedLight { shape, luminaire, space: light.space });
        }
    }
    Ok(lights)
}

/// The colours of all lights must be finite.
pub(crate) fn check_colors(scene: &Scene) -> Result<(), PrepareError> {
    for (number, light) in scene.lights.iter().enumerate() {
        let colors = [&light.colors.ambient, &light.colors.diffuse, &light.colors.specular];
        if !colors.iter().all(|color| color.is_finite()) {
            return Err(error(number, "colors must be finite numbers"));
        }
    }
    Ok(())
}

/// Whether [`prepare`] keeps a light: all but ambient ones.
pub(crate) fn is_directed(light: &Light) -> bool {
    light.kind != LightKind::Ambient
}

/// Whether a light's value is a radiance rather than that of a lamp.
pub(crate) fn is_radiance(light: &Light) -> bool {
    matches!(light.kind, LightKind::Area { .. } | LightKind::Environment { .. })
}

/// How many lights of the table a light is.
pub(crate) fn rows(light: &Light) -> usize {
    if matches!(light.kind, LightKind::Environment { .. }) { 3 } else { 1 }
}

impl LightShape {
    /// How many lights of the table it is: surroundings are one for each of the three spectra that their
    /// pixels mix.
    pub fn rows(&self) -> usize {
        if matches!(self, Self::Environment(_)) { 3 } else { 1 }
    }

    /// Whether the pixel loop of the classic models knows it.
    pub fn is_classic(&self) -> bool {
        !matches!(self, Self::Area { .. } | Self::Environment(_))
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
    Ok(LightShape::Area { form, position: finite(position)?, axes, two_sided })
}

fn environment(
    map: &Option<Arc<glanz_scene::EnvironmentMap>>,
    rotation: DMat3,
) -> Result<EnvironmentLight, &'static str> {
    if !rotation.is_finite() {
        return Err("the rotation must be finite numbers");
    }
    let map = map.as_ref().map(|map| Arc::new(EnvironmentMap::from(&**map)));
    let irradiance = map.as_ref().map_or_else(Irradiance::uniform, |map| Irradiance::of(map));
    Ok(EnvironmentLight { map, irradiance, rotation })
}

fn luminaire(luminaire: &Luminaire) -> Result<PreparedLuminaire, &'static str> {
    let frame = luminaire.frame().ok_or("the luminaire's axis and C0 must be finite and not parallel")?;
    Ok(PreparedLuminaire { intensities: Arc::new(IntensityGrid::of(&luminaire.profile)), frame })
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
