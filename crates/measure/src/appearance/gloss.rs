//! Specular gloss.

use super::Function;
use super::receptor::{GLASS, Path, SOURCE_DEG, reflectance};

/// Steps along the sides of the receptor.
const STEPS: usize = 80;

/// A geometry of gloss meters: the angle of light and receptor from the normal, and the receptor's aperture in the plane of
/// measurement and across it, in degrees (ISO 2813, ASTM D523).
///
/// The 1.8° of the receptor at 20° are those that ISO 13803 tells in its introduction; the other apertures, and the image of
/// the source, 0.75° × 2.5°, are not verified against a standard.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GlossMeter {
    /// The angle from the normal.
    pub angle_deg: f64,
    /// The receptor's aperture.
    pub receptor_deg: [f64; 2],
}

impl GlossMeter {
    /// For high gloss.
    pub const AT_20: Self = Self { angle_deg: 20.0, receptor_deg: [1.8, 3.6] };
    /// For all surfaces.
    pub const AT_60: Self = Self { angle_deg: 60.0, receptor_deg: [4.4, 11.7] };
    /// For low gloss.
    pub const AT_85: Self = Self { angle_deg: 85.0, receptor_deg: [4.0, 6.0] };

    /// The gloss, one number per channel: 100 times the flux from the source into the receptor, by that of polished black
    /// glass of index 1.567.
    ///
    /// ```
    /// use glanz_measure::GlossMeter;
    ///
    /// // White paper without any gloss still sends some light there.
    /// let white = GlossMeter::AT_60.gloss(&mut |_, _| vec![1.0 / std::f64::consts::PI]);
    /// assert!((white[0] - 2.485).abs() < 0.005);
    /// ```
    pub fn gloss(&self, f: &mut Function<'_>) -> Vec<f64> {
        let path = Path {
            light_deg: self.angle_deg,
            source_deg: SOURCE_DEG,
            angle_deg: self.angle_deg,
            receptor_deg: self.receptor_deg,
            steps: STEPS,
        };
        let glass = path.fraction_of_glass();
        path.fraction(f).into_iter().map(|part| 100.0 * part / glass).collect()
    }

    /// The gloss of a polished dielectric of this refractive index over black.
    ///
    /// ```
    /// use glanz_measure::GlossMeter;
    ///
    /// assert!((GlossMeter::AT_60.of_smooth(1.567) - 100.0).abs() < 1e-12);
    /// assert!((GlossMeter::AT_20.of_smooth(1.5) - 82.0).abs() < 0.1);
    /// ```
    pub fn of_smooth(&self, n: f64) -> f64 {
        self.of_mirror(reflectance(n, self.angle_deg.to_radians()))
    }

    /// The gloss of a perfect mirror that reflects this part of the light at the meter's angle: the image of the source lies
    /// within the receptor, as that of the standard does.
    ///
    /// ```
    /// use glanz_measure::GlossMeter;
    ///
    /// assert_eq!(GlossMeter::AT_60.of_mirror(1.0).round(), 999.0);
    /// ```
    pub fn of_mirror(&self, reflected: f64) -> f64 {
        100.0 * reflected / reflectance(GLASS, self.angle_deg.to_radians())
    }

    /// The geometry that tells surfaces of this gloss at 60° apart best: 20° above 70 units, 85° below 10, else 60°
    /// (ASTM D523).
    ///
    /// ```
    /// use glanz_measure::GlossMeter;
    ///
    /// assert_eq!(GlossMeter::chosen(89.0), GlossMeter::AT_20);
    /// assert_eq!(GlossMeter::chosen(3.0), GlossMeter::AT_85);
    /// ```
    pub fn chosen(gloss_60: f64) -> Self {
        match gloss_60 {
            high if high > 70.0 => Self::AT_20,
            low if low < 10.0 => Self::AT_85,
            _ => Self::AT_60,
        }
    }
}
