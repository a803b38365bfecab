//! Chromaticity: colour without its brightness.

use crate::observers::{Observer, ObserverKind, kept};
use crate::spectra::{Sampled, Spectrum};

/// The colour-matching functions x̄, ȳ, z̄ of the CIE 1931 observer on the grid.
pub(crate) fn cie1931() -> [&'static Spectrum; 3] {
    let channels = &kept("cie1931").channels;
    core::array::from_fn(|i| &channels[i].sensitivity)
}

/// ∫ of a light with each of x̄, ȳ, z̄ of the CIE 1931 observer, not scaled.
pub(crate) fn tristimulus<S: Sampled>(light: &S) -> [f64; 3] {
    let responses = light.responses(kept("cie1931"));
    core::array::from_fn(|i| responses[i])
}

/// A chromaticity x, y: of the CIE 1931 diagram, or of another observer with X, Y, Z ([`Chromaticity::of`]).
///
/// ```
/// use glanz_color::chromaticity::Chromaticity;
/// use glanz_color::{light, observer};
///
/// // Illuminant A for the 2° and the 10° observer (CIE 15:2018, table T.3).
/// let a = light("A")?;
/// let narrow = Chromaticity::of(&a, &observer("cie1931")?).expect("A is seen");
/// assert!((narrow.x - 0.44758).abs() < 1e-5 && (narrow.y - 0.40745).abs() < 1e-5);
/// let wide = Chromaticity::of(&a, &observer("cie1964")?).expect("A is seen");
/// assert!((wide.x - 0.45117).abs() < 2e-5 && (wide.y - 0.40594).abs() < 2e-5);
/// # Ok::<_, glanz_color::UnknownName>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chromaticity {
    /// X / (X + Y + Z).
    pub x: f64,
    /// Y / (X + Y + Z).
    pub y: f64,
}

impl Chromaticity {
    /// Equal energy.
    pub const E: Self = Self { x: 1.0 / 3.0, y: 1.0 / 3.0 };

    /// x, y.
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    /// That of X, Y, Z on any scale; none where their sum is not positive and finite.
    pub fn of_xyz([x, y, z]: [f64; 3]) -> Option<Self> {
        let sum = x + y + z;
        (sum > 0.0 && sum.is_finite()).then(|| Self { x: x / sum, y: y / sum })
    }

    /// That of a light for any observer of kind [`ObserverKind::Xyz`]: X / (X + Y + Z) and Y / (X + Y + Z). None for
    /// observers of another kind, and for a light that is not seen.
    pub fn of<S: Sampled>(light: &S, observer: &Observer) -> Option<Self> {
        let xyz = light.responses(observer).try_into().ok()?;
        if observer.kind == ObserverKind::Xyz { Self::of_xyz(xyz) } else { None }
    }

    /// That of a light for the CIE 1931 observer; none for a light that is not seen.
    pub fn of_light<S: Sampled>(light: &S) -> Option<Self> {
        Self::of_xyz(tristimulus(light))
    }

    /// X, Y, Z with Y = 1; not finite where y is 0.
    pub fn xyz(self) -> [f64; 3] {
        [self.x / self.y, 1.0, (1.0 - self.x - self.y) / self.y]
    }

    /// u, v of the CIE 1960 diagram, in which colour temperatures are defined.
    pub fn uv1960(self) -> [f64; 2] {
        let by = 12.0 * self.y - 2.0 * self.x + 3.0;
        [4.0 * self.x / by, 6.0 * self.y / by]
    }

    /// u′, v′ of the CIE 1976 diagram.
    pub fn uv1976(self) -> [f64; 2] {
        let [u, v] = self.uv1960();
        [u, 1.5 * v]
    }

    /// From u, v of the CIE 1960 diagram.
    pub fn from_uv1960([u, v]: [f64; 2]) -> Self {
        let by = 2.0 * u - 8.0 * v + 4.0;
        Self { x: 3.0 * u / by, y: 2.0 * v / by }
    }

    /// From u′, v′ of the CIE 1976 diagram.
    pub fn from_uv1976([u, v]: [f64; 2]) -> Self {
        Self::from_uv1960([u, v / 1.5])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lights::light;
    use crate::observers::observer;
    use proptest::prelude::*;

    #[test]
    fn lights_have_the_chromaticities_of_the_cie() {
        // CIE 15:2018, tables of illuminants; the last digit printed.
        for (name, x, y) in [
            ("A", 0.447_58, 0.407_45),
            ("D65", 0.312_72, 0.329_03),
            ("D50", 0.3457, 0.3585),
            ("FL2", 0.3721, 0.3751),
            ("FL11", 0.3805, 0.3769),
        ] {
            let found = Chromaticity::of_light(&light(name).unwrap()).unwrap();
            assert!((found.x - x).abs() < 6e-5 && (found.y - y).abs() < 6e-5, "{name}: {found:?}");
        }
    }

    #[test]
    fn the_diagrams_of_1960_and_1976_give_known_values() {
        // D65: u' 0.19783, v' 0.46834 (CIE 15:2018, table T.3).
        let [u, v] = Chromaticity::new(0.312_72, 0.329_03).uv1976();
        assert!((u - 0.197_83).abs() < 1e-5 && (v - 0.468_34).abs() < 1e-5);
    }

    #[test]
    fn every_observer_with_xyz_has_its_own_diagram() {
        // CIE 15:2018, table T.3: the 10° observer.
        for (name, x, y) in
            [("A", 0.451_17, 0.405_94), ("D65", 0.313_82, 0.331_00), ("D50", 0.347_73, 0.359_52)]
        {
            let found = Chromaticity::of(&light(name).unwrap(), &observer("cie1964").unwrap()).unwrap();
            assert!((found.x - x).abs() < 3e-5 && (found.y - y).abs() < 3e-5, "{name}: {found:?}");
        }
        for info in crate::observers::observers() {
            let found = Chromaticity::of(&Spectrum::ONE, &observer(info.name).unwrap());
            match info.kind {
                ObserverKind::Xyz => {
                    let e = found.unwrap();
                    assert!(
                        (e.x - 1.0 / 3.0).abs() < 1e-4 && (e.y - 1.0 / 3.0).abs() < 1e-4,
                        "{}: {e:?}",
                        info.name
                    );
                }
                _ => assert_eq!(found, None, "{}", info.name),
            }
        }
        let d65 = light("D65").unwrap();
        assert_eq!(Chromaticity::of(&d65, &Observer::default()), Chromaticity::of_light(&d65));
    }

    #[test]
    fn what_is_not_seen_has_no_chromaticity() {
        assert_eq!(Chromaticity::of_light(&Spectrum::ZERO), None);
        assert_eq!(Chromaticity::of_xyz([f64::INFINITY, 1.0, 1.0]), None);
    }

    proptest! {
        #[test]
        fn every_diagram_gives_back_what_went_in(x in 0.01..0.7_f64, y in 0.01..0.8_f64) {
            let there = Chromaticity::new(x, y);
            let uv = Chromaticity::from_uv1960(there.uv1960());
            let uv76 = Chromaticity::from_uv1976(there.uv1976());
            for back in [uv, uv76, Chromaticity::of_xyz(there.xyz()).unwrap_or(uv)] {
                prop_assert!((back.x - x).abs() < 1e-12 && (back.y - y).abs() < 1e-12);
            }
        }
    }
}
