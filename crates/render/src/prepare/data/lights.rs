//! The geometry of lights in the world. Their colours are in the tint table.

use std::sync::Arc;

use glanz_scene::{AreaShape, Space};

use super::{EnvironmentMap, IntensityGrid, Irradiance};

/// The geometry of a light with a direction.
#[derive(Clone, Debug, PartialEq)]
pub enum LightShape {
    /// Parallel light.
    Directional {
        /// Unit vector towards the light.
        towards: [f64; 3],
    },
    /// From a point.
    Point {
        /// Where.
        position: [f64; 3],
        /// How it fades with the distance d: 1 / (c + l·d + q·d²); none where it does not.
        attenuation: Option<[f64; 3]>,
    },
    /// From a point into a cone.
    Spot {
        /// Where.
        position: [f64; 3],
        /// Unit axis, away from the light.
        axis: [f64; 3],
        /// Cosine of the cut-off angle.
        cos_cutoff: f64,
        /// Power of the cosine from the axis.
        exponent: f64,
        /// Instead of the power: cosines of the inner and outer edge.
        smooth_edge: Option<(f64, f64)>,
        /// How it fades with the distance d: 1 / (c + l·d + q·d²); none where it does not.
        attenuation: Option<[f64; 3]>,
    },
    /// A surface that shines evenly.
    Area {
        /// Its form and size.
        form: AreaShape,
        /// Its centre.
        position: [f64; 3],
        /// Unit vectors along its width, its height and the way it faces.
        axes: [[f64; 3]; 3],
        /// Whether it shines on its back, too.
        two_sided: bool,
    },
    /// An environment at infinite distance.
    Environment(EnvironmentLight),
}

/// An environment at infinite distance.
#[derive(Clone, Debug, PartialEq)]
pub struct EnvironmentLight {
    /// What it looks like; `None` for 1 everywhere.
    pub map: Option<Arc<EnvironmentMap>>,
    /// What a matte surface gets of it.
    pub irradiance: Irradiance,
    /// From its directions to the light's space.
    pub rotation: [[f64; 3]; 3],
}

/// Intensities over directions, and how they are turned.
#[derive(Clone, Debug, PartialEq)]
pub struct PreparedLuminaire {
    /// Fractions of the greatest intensity.
    pub intensities: Arc<IntensityGrid>,
    /// The directions of C 0°, C 90° and γ 0°.
    pub frame: [[f64; 3]; 3],
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

impl LightShape {
    /// How many lights of the table it is: an environment is one for each of the three spectra that their
    /// pixels mix.
    pub fn rows(&self) -> usize {
        if matches!(self, Self::Environment(_)) { 3 } else { 1 }
    }

    /// Whether its light comes from one direction at each point.
    pub fn is_punctual(&self) -> bool {
        !matches!(self, Self::Area { .. } | Self::Environment(_))
    }
}
