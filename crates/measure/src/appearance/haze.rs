//! Reflection haze: light beside the mirror direction.

use super::Function;
use super::receptor::{Path, SOURCE_DEG};

/// Steps along the sides of a receptor.
const STEPS: usize = 40;

/// A geometry of haze meters: light and a specular receptor at an angle, and two receptors beside that one.
///
/// Haze is the flux into the receptors beside the mirror direction, by that of the gloss standard into the specular one
/// (ASTM E430, 3.3.1). The angles of all three geometries are those of ASTM E430; the apertures, and whether the flux of both
/// receptors is added, are not verified against a standard.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HazeMeter {
    /// The angle of the light, and of the specular receptor, from the normal.
    pub angle_deg: f64,
    /// The angles of the receptors of haze from the normal.
    pub beside_deg: [f64; 2],
    /// The image of the source: in the plane of measurement and across it.
    pub source_deg: [f64; 2],
    /// The aperture of the specular receptor.
    pub specular_deg: [f64; 2],
    /// The aperture of the receptors of haze.
    pub receptor_deg: [f64; 2],
    /// Whether the flux of both receptors is added; else it is their mean.
    pub is_sum: bool,
}

impl HazeMeter {
    /// ISO 13803 and ASTM E430, method B: light at 20°, receptors at 18.1° and 21.9°.
    pub const ISO_13803: Self = Self {
        angle_deg: 20.0,
        beside_deg: [18.1, 21.9],
        source_deg: SOURCE_DEG,
        specular_deg: [1.8, 3.6],
        receptor_deg: [1.8, 3.6],
        is_sum: true,
    };
    /// ASTM E430, method A, narrow angle: light at 30°, a receptor at 28° or 32°.
    pub const E430_A_NARROW: Self = Self {
        angle_deg: 30.0,
        beside_deg: [28.0, 32.0],
        source_deg: [0.44, 5.0],
        specular_deg: [0.4, 3.0],
        receptor_deg: [0.4, 3.0],
        is_sum: false,
    };
    /// ASTM E430, method A, wide angle: light at 30°, a receptor at 25° or 35°.
    pub const E430_A_WIDE: Self = Self { beside_deg: [25.0, 35.0], ..Self::E430_A_NARROW };

    /// The haze, one number per channel, in haze units: 100 times the flux beside the mirror direction, by that of polished
    /// black glass in it.
    ///
    /// ```
    /// use glanz_measure::HazeMeter;
    ///
    /// // White paper sends as much light into each of the receptors as into the specular one: 1.2 units of gloss.
    /// let white = HazeMeter::ISO_13803.haze(&mut |_, _| vec![1.0 / std::f64::consts::PI]);
    /// assert!((white[0] - 2.0 * 1.203).abs() < 0.01);
    /// ```
    pub fn haze(&self, f: &mut Function<'_>) -> Vec<f64> {
        let path = |angle_deg: f64, receptor_deg: [f64; 2]| Path {
            light_deg: self.angle_deg,
            source_deg: self.source_deg,
            angle_deg,
            receptor_deg,
            steps: STEPS,
        };
        let glass = path(self.angle_deg, self.specular_deg).fraction_of_glass();
        let [below, above] = self.beside_deg.map(|angle| path(angle, self.receptor_deg).fraction(f));
        let scale = if self.is_sum { 100.0 } else { 50.0 };
        below.iter().zip(above).map(|(below, above)| scale * (below + above) / glass).collect()
    }
}

/// Haze on the logarithmic scale of paint laboratories, 1285 log₁₀(haze / 20 + 1), which is nearer to what is seen.
///
/// That instruments have such a scale is told by ISO 13803; its formula is quoted after memory and not verified against a
/// standard.
///
/// ```
/// use glanz_measure::log_haze;
///
/// assert_eq!(log_haze(0.0), 0.0);
/// assert!((log_haze(20.0) - 386.8).abs() < 0.1);
/// ```
pub fn log_haze(haze: f64) -> f64 {
    1285.0 * libm::log10(haze / 20.0 + 1.0)
}

/// The haze index of ASTM D4039, the gloss at 60° less that at 20°; none below 70 units at 60°, where the method does not
/// hold. It is one of surfaces that are not metallic.
///
/// ```
/// use glanz_measure::haze_of_gloss;
///
/// assert_eq!(haze_of_gloss(90.0, 80.0), Some(10.0));
/// assert_eq!(haze_of_gloss(60.0, 30.0), None);
/// ```
pub fn haze_of_gloss(gloss_60: f64, gloss_20: f64) -> Option<f64> {
    (gloss_60 > 70.0).then_some(gloss_60 - gloss_20)
}
