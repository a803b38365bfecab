//! Yellowness of whites: ASTM E313 and ASTM D1925.
//!
//! ```
//! use glanz_color::yellowness::{E313, d1925};
//!
//! // X, Y and Z on any scale.
//! let xyz = [95.0, 100.0, 105.0];
//! let d65 = E313.iter().find(|pair| (pair.light, pair.observer) == ("D65", "cie1931")).expect("it is one of the four");
//! assert!((d65.yellowness(xyz) - 4.34).abs() < 1e-9);
//! assert!((d1925(xyz) - 10.3).abs() < 1e-9);
//! ```

/// The coefficients of ASTM E313 for a light and an observer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coefficients {
    /// The name of the light.
    pub light: &'static str,
    /// The name of the observer.
    pub observer: &'static str,
    /// Of X.
    pub c_x: f64,
    /// Of Z.
    pub c_z: f64,
}

/// The four pairs of light and observer of ASTM E313.
pub const E313: [Coefficients; 4] = [
    Coefficients { light: "C", observer: "cie1931", c_x: 1.2769, c_z: 1.0592 },
    Coefficients { light: "D65", observer: "cie1931", c_x: 1.2985, c_z: 1.1335 },
    Coefficients { light: "C", observer: "cie1964", c_x: 1.2871, c_z: 1.0781 },
    Coefficients { light: "D65", observer: "cie1964", c_x: 1.3013, c_z: 1.1498 },
];

impl Coefficients {
    /// The yellowness index YI = 100 (Cx X − Cz Z) / Y, of X, Y and Z under this light for this observer: 0 for the perfect
    /// diffuser, positive for yellow, negative for blue. Not finite where Y is 0.
    pub fn yellowness(&self, [x, y, z]: [f64; 3]) -> f64 {
        100.0 * (self.c_x * x - self.c_z * z) / y
    }
}

/// The yellowness index of ASTM D1925, 100 (1.28 X − 1.06 Z) / Y, of X, Y and Z under C for the CIE 1931 observer. The
/// standard is withdrawn; plastics are still told by it. Not finite where Y is 0.
pub fn d1925([x, y, z]: [f64; 3]) -> f64 {
    100.0 * (1.28 * x - 1.06 * z) / y
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lights::fine_light;
    use crate::observers::{observer, xyz_of_light};

    #[test]
    fn the_perfect_diffuser_is_not_yellow() {
        for pair in E313 {
            let (light, observer) = (fine_light(pair.light).unwrap(), observer(pair.observer).unwrap());
            let yellowness = pair.yellowness(xyz_of_light(&light, &observer));
            // The coefficients have four decimals.
            assert!(yellowness.abs() < 0.02, "{pair:?}: {yellowness}");
        }
    }
}
