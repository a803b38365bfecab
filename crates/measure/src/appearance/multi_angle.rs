//! Radiance factors: 45°/0° and multi-angle instruments, and what is made of them.

use core::f64::consts::PI;

use glanz_math::Vec3;

use super::Function;

/// The geometries of an instrument or a standard: the angle of the light from the normal, and that of the detector from the
/// mirror direction towards the light, in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MultiAngle {
    /// Its name.
    pub name: &'static str,
    /// The angles of light and detector.
    pub pairs_deg: &'static [(f64, f64)],
}

impl MultiAngle {
    /// ASTM E2194, of coatings with metal flakes: three angles. That they are 15°, 45° and 110° is not verified against the
    /// standard, which is known by its scope only.
    pub const E2194: Self =
        Self { name: "ASTM E2194", pairs_deg: &[(45.0, 15.0), (45.0, 45.0), (45.0, 110.0)] };
    /// ASTM E2539, of interference pigments: light at 15°, too. The list is not verified against the standard, which is known
    /// by its scope only; instruments have the same angles.
    pub const E2539: Self = Self {
        name: "ASTM E2539",
        pairs_deg: &[
            (45.0, -15.0),
            (45.0, 15.0),
            (45.0, 25.0),
            (45.0, 45.0),
            (45.0, 75.0),
            (45.0, 110.0),
            (15.0, -15.0),
            (15.0, 15.0),
        ],
    };
    /// The lists that there are.
    pub const ALL: [Self; 3] = [Self::E2194, Self::E2539, Self::SIX];

    /// The names of its geometries, as instruments have them: `45as-15` is light at 45° and the detector 15° from the mirror
    /// direction, on the far side of the light.
    ///
    /// ```
    /// use glanz_measure::MultiAngle;
    ///
    /// let names: Vec<String> = MultiAngle::E2194.geometries().collect();
    /// assert_eq!(names, ["45as15", "45as45", "45as110"]);
    /// ```
    pub fn geometries(&self) -> impl Iterator<Item = String> + use<> {
        self.pairs_deg.iter().map(|(light, aspecular)| format!("{light}as{aspecular}"))
    }

    /// The six angles of MA-T12 and BYK-mac.
    pub const SIX: Self = Self {
        name: "MA-T12, BYK-mac",
        pairs_deg: &[(45.0, -15.0), (45.0, 15.0), (45.0, 25.0), (45.0, 45.0), (45.0, 75.0), (45.0, 110.0)],
    };
}

/// The radiance factors πf of a multi-angle instrument: light at an angle from the normal, mostly 45°, and a detector by its
/// angle from the mirror direction towards the light, in degrees, such as −15, 15, 25, 45, 75, 110.
///
/// ```
/// use std::f64::consts::FRAC_1_PI;
///
/// // A perfect diffuser looks the same from everywhere.
/// let factor = glanz_measure::multi_angle(&mut |_, _| vec![FRAC_1_PI], 45.0, 25.0);
/// assert!((factor[0] - 1.0).abs() < 1e-12);
/// ```
pub fn multi_angle(f: &mut Function<'_>, light_deg: f64, aspecular_deg: f64) -> Vec<f64> {
    // The mirror direction lies in the plane on the positive side, the light on the negative one.
    let angle = (light_deg - aspecular_deg).to_radians();
    let wo = Vec3::from_angles(angle.abs(), if angle < 0.0 { PI } else { 0.0 });
    let wi = Vec3::from_angles(light_deg.to_radians(), PI);
    f(wi, wo).into_iter().map(|value| value * PI).collect()
}

/// The radiance factor πf of 45°/0°: light at 45° in the plane of x, the detector above.
///
/// ```
/// use std::f64::consts::FRAC_1_PI;
///
/// assert!((glanz_measure::forty_five_zero(&mut |_, _| vec![0.8 * FRAC_1_PI])[0] - 0.8).abs() < 1e-12);
/// ```
pub fn forty_five_zero(f: &mut Function<'_>) -> Vec<f64> {
    let values = f(Vec3::from_angles(PI / 4.0, PI), Vec3::from_angles(0.0, 0.0));
    values.into_iter().map(|value| value * PI).collect()
}

/// The flop index of D. H. Alman (DuPont) from the lightness L\* at 15°, 45° and 110° from the mirror direction: 2.69 (L\*15 −
/// L\*110)^1.11 / L\*45^0.86. 0 of solid colours, 15 to 17 of coatings with very much flop. None where a surface is darkest
/// near the mirror direction, or black at 45°.
///
/// Formula and constants are quoted after memory and not verified against a publication.
///
/// ```
/// use glanz_measure::flop_index;
///
/// assert_eq!(flop_index(60.0, 60.0, 60.0), Some(0.0));
/// assert!(flop_index(120.0, 60.0, 25.0).expect("it is brighter near the mirror direction") > 12.0);
/// assert_eq!(flop_index(50.0, 60.0, 70.0), None);
/// ```
pub fn flop_index(l_15: f64, l_45: f64, l_110: f64) -> Option<f64> {
    // Rounding makes no flop of a matte surface.
    let fall = if (l_15 - l_110).abs() < 1e-9 { 0.0 } else { l_15 - l_110 };
    (fall >= 0.0 && l_45 > 0.0).then(|| 2.69 * libm::pow(fall, 1.11) / libm::pow(l_45, 0.86))
}
