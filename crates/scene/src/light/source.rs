//! Lights: punctual lights as in F. Lauri, "Modèles d'illumination simples" (course MV52, UTBM) and E. Thiel,
//! "Programmation graphique", lecture 5; area lights, environments and luminaires.

use std::sync::Arc;

use glam::{DMat3, DVec3};
use serde::{Deserialize, Serialize};

use crate::{EnvironmentMap, LightColor, Luminaire};

/// The space in which a light's position and direction are given.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Space {
    /// Fixed in the world.
    #[default]
    World,
    /// Moves with the camera: x to the right, y up, −z along the view.
    Camera,
}

/// How light fades with the distance d: 1 / (constant + linear·d + quadratic·d²).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Attenuation {
    /// The part that does not depend on distance.
    pub constant: f64,
    /// The factor of d, in 1/m.
    pub linear: f64,
    /// The factor of d², in 1/m².
    pub quadratic: f64,
}

impl Attenuation {
    /// No fading: the classic default.
    pub const NONE: Self = Self { constant: 1.0, linear: 0.0, quadratic: 0.0 };
    /// The inverse square law.
    pub const PHYSICAL: Self = Self { constant: 0.0, linear: 0.0, quadratic: 1.0 };
}

/// What a light sends to the three kinds of lobe.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LightColors {
    /// To ambient lobes: unattenuated, from no direction.
    pub ambient: LightColor,
    /// To diffuse lobes.
    pub diffuse: LightColor,
    /// To specular lobes.
    pub specular: LightColor,
}

impl LightColors {
    /// The same for all three.
    pub fn all(color: impl Into<LightColor>) -> Self {
        let color = color.into();
        Self { ambient: color.clone(), diffuse: color.clone(), specular: color }
    }
    /// For diffuse and specular lobes; nothing ambient.
    pub fn direct(color: impl Into<LightColor>) -> Self {
        Self { ambient: LightColor::BLACK, ..Self::all(color) }
    }
    /// For ambient lobes alone.
    pub fn ambient(color: impl Into<LightColor>) -> Self {
        Self { ambient: color.into(), diffuse: LightColor::BLACK, specular: LightColor::BLACK }
    }
    /// The same colours, more or less of them.
    pub fn scaled(&self, factor: f64) -> Self {
        Self {
            ambient: self.ambient.scaled(factor),
            diffuse: self.diffuse.scaled(factor),
            specular: self.specular.scaled(factor),
        }
    }
}

/// The extent of a light that is a surface.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum AreaShape {
    /// A rectangle.
    Rectangle {
        /// In m, across `direction` and `up`.
        width: f64,
        /// In m, along `up`.
        height: f64,
    },
    /// A disk.
    Disk {
        /// In m.
        radius: f64,
    },
    /// A sphere, which shines outwards.
    Sphere {
        /// In m.
        radius: f64,
    },
}

impl AreaShape {
    /// The area of the surface in m², of one side where it has two.
    pub fn area(self) -> f64 {
        use core::f64::consts::PI;
        match self {
            Self::Rectangle { width, height } => width * height,
            Self::Disk { radius } => PI * radius * radius,
            Self::Sphere { radius } => 4.0 * PI * radius * radius,
        }
    }
}

/// The geometry of a light.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum LightKind {
    /// From everywhere, on everything.
    Ambient,
    /// Parallel light.
    Directional {
        /// The way the light travels; any length but zero.
        direction: DVec3,
    },
    /// From a point in all directions.
    Point {
        /// Where it is.
        position: DVec3,
        /// How it fades.
        attenuation: Attenuation,
    },
    /// From a point into a cone.
    Spot {
        /// Where it is.
        position: DVec3,
        /// The axis of the cone, away from the light; any length but zero.
        direction: DVec3,
        /// Half the opening angle of the cone, in radians, up to π (all directions).
        cutoff: f64,
        /// Power of the cosine from the axis by which the light falls off inside the cone.
        exponent: f64,
        /// Cosines `(inner, outer)` of a smooth edge instead of the power, as glTF has it.
        smooth_edge: Option<(f64, f64)>,
        /// How it fades.
        attenuation: Attenuation,
    },
    /// From a surface that shines evenly, with the same radiance into all directions. Its colours are that
    /// radiance: a white Lambert surface that it surrounds gets its value.
    Area {
        /// Its form and size.
        shape: AreaShape,
        /// Its centre.
        position: DVec3,
        /// The way it faces, away from the light; any length but zero. Spheres have none and ignore it.
        direction: DVec3,
        /// Where the height of a rectangle points, less its part along `direction`; not parallel to it.
        /// Disks and spheres ignore it.
        up: DVec3,
        /// Whether it shines on its back, too. Spheres ignore it.
        two_sided: bool,
    },
    /// From an environment at infinite distance. Its colours are the radiance where the map is 1: a uniform
    /// environment of value 1 makes a white Lambert surface 1, and is seen as 1 itself.
    Environment {
        /// What they look like; `None` for the same in all directions.
        map: Option<Arc<EnvironmentMap>>,
        /// From the map's directions to the world's; a rotation.
        rotation: DMat3,
    },
}

/// A light.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Light {
    /// A name for people; may be empty.
    pub name: String,
    /// Its geometry.
    pub kind: LightKind,
    /// What it sends, in classic units: 1 on a white Lambert surface that faces it gives 1. Of areas and
    /// environments it is the radiance, 1 being that of such a surface.
    pub colors: LightColors,
    /// World or camera.
    pub space: Space,
    /// How point and spot lights send more into some directions than into others; other kinds have none.
    pub luminaire: Option<Luminaire>,
}

impl Light {
    /// A light without a name, in the world, that sends the same into all directions that its kind allows.
    pub fn new(kind: LightKind, colors: LightColors) -> Self {
        Self { name: String::new(), kind, colors, space: Space::World, luminaire: None }
    }
}
