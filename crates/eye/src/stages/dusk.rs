//! Between day and night, where cones and rods see together: CIE 191:2010.

use crate::curves::{SCOTOPIC_WEIGHT, mesopic};

/// The luminance of L and M, whose values are 1 for D65, in parts of the white's: V_F of CIE 170-2.
pub const LUMINANCE: [f64; 2] = [0.698_134, 0.301_866];

/// The scotopic luminance of D65 over its photopic one.
pub(crate) const SCOTOPIC_OF_D65: f64 = 2.464_63;

/// How cones and rods are mixed in a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Mixture {
    /// The part of the cones, m of CIE 191.
    pub cones: f64,
    /// The mesopic luminance of the adapting light in cd/m².
    pub luminance: f64,
}

impl Mixture {
    /// For an adapting light, in cd/m² by V and by V′.
    pub(crate) fn of(photopic: f64, scotopic: f64) -> Self {
        let found = mesopic(photopic, scotopic);
        Self { cones: found.m, luminance: found.luminance }
    }

    /// The factors of the cones' channels and of the rods, for a white of these photopic and rod responses: that white keeps its
    /// luminance.
    pub(crate) fn factors(self, white_luminance: f64, white_rods: f64) -> [f64; 2] {
        let rods = (1.0 - self.cones) * SCOTOPIC_WEIGHT * SCOTOPIC_OF_D65;
        let white = (self.cones * white_luminance + rods * white_rods) / white_luminance;
        let white = if white > 0.0 && white.is_finite() { white } else { 1.0 };
        [self.cones / white, rods / white]
    }
}

#[cfg(test)]
mod tests {
    use glanz_color::{Observer, colorchecker, light, observer, xyz_of_reflectance};

    use super::*;
    use crate::Eye;

    #[test]
    fn a_red_and_a_blue_flower_change_places() {
        // By Y, by V′, and at a white of 0.1 cd/m²: computed elsewhere.
        let d65 = light("D65").unwrap();
        let rods = Eye::default().rods();
        let white = 0.1;
        let mixture = Mixture::of(white, white * SCOTOPIC_OF_D65);
        assert!((mixture.cones - 0.48606).abs() < 1e-4, "{}", mixture.cones);
        let [by_cones, by_rods] = mixture.factors(1.0, 1.0);
        for (name, day, night, dusk) in
            [("red", 0.11826, 0.04781, 0.08222), ("blue", 0.06230, 0.15423, 0.10932)]
        {
            let (_, patch) = colorchecker().find(|(patch, _)| *patch == name).unwrap();
            let [_, y, _] = xyz_of_reflectance(&patch, &d65, &Observer::default());
            let seen = rods.dot(&(patch * d65)) / rods.dot(&d65);
            assert!((y - day).abs() < 1e-4 && (seen - night).abs() < 1e-4, "{name}: {y} {seen}");
            let mixed = by_cones * y + by_rods * seen;
            assert!((mixed - dusk).abs() < 1e-4, "{name}: {mixed}");
        }
    }

    #[test]
    fn daylight_has_the_scotopic_luminance_that_is_stated() {
        let d65 = light("D65").unwrap();
        let by = |name: &str| observer(name).unwrap().response(&d65)[0];
        let found = 1700.0 / 683.0 * by("scotopic") / by("photopic");
        assert!((found - SCOTOPIC_OF_D65).abs() < 1e-3, "{found}");
    }

    #[test]
    fn by_day_the_cones_see_alone() {
        assert_eq!(Mixture::of(100.0, 246.0).factors(0.8, 0.7), [1.0, 0.0]);
        let night = Mixture::of(1e-4, 2.46e-4);
        assert_eq!(night.cones, 0.0);
        assert!((night.factors(1.0, 1.0)[1] - 1.0).abs() < 1e-12);
    }
}
