//! The retina by eccentricity: rods, cones, midget ganglion cells, macular pigment, and the resolution that follows.

use libm::{exp, log, pow};

use super::within;

/// The greatest eccentricity of these formulas, in degrees.
const EDGE_DEG: f64 = 90.0;

/// The distance on the retina from the optic axis, in mm, of an eccentricity in degrees, 0 to 90°.
///
/// **Formula** 0.268 e + 0.0003427 e² − 8.3309e-6 e³.
/// **Source** A. B. Watson, "A formula for human retinal ganglion cell receptive field density", Journal of Vision 14(7), 2014,
/// equation A5.
///
/// ```
/// // One degree is about 0.27 mm.
/// assert!((glanz_eye::curves::eccentricity_mm(1.0) - 0.268334).abs() < 1e-6);
/// ```
pub fn eccentricity_mm(eccentricity_deg: f64) -> f64 {
    let e = within(eccentricity_deg, 0.0, EDGE_DEG);
    (0.268 + (0.000_342_7 - 8.3309e-6 * e) * e) * e
}

/// The area of the retina in mm² that sees 1 deg² of the field at an eccentricity in degrees, 0 to 90°.
///
/// **Formula** 0.0752 + 5.846e-5 e − 1.064e-5 e² + 4.116e-8 e³. **Source** Watson 2014, equation A7.
///
/// ```
/// use glanz_eye::curves::{retinal_area_mm2, rod_density_mm2};
///
/// // Rods per deg² where there are most of them, 18° from the fovea.
/// let rods = rod_density_mm2(4.92) * retinal_area_mm2(18.0);
/// assert!((11_000.0..12_000.0).contains(&rods));
/// ```
pub fn retinal_area_mm2(eccentricity_deg: f64) -> f64 {
    let e = within(eccentricity_deg, 0.0, EDGE_DEG);
    0.0752 + (5.846e-5 + (-1.064e-5 + 4.116e-8 * e) * e) * e
}

/// Rods per mm² of the retina at a distance from the fovea in mm, 0 to 21 mm.
///
/// **Formula** 5.855e5 e^(−0.1388r) − 5.989e5 e^(−0.2998r), 0 where that is negative: within 0.14 mm of the fovea.
/// **Limits** a mean over all directions; about 89 million rods out to 21 mm on a sphere. Individuals differ.
/// **Source** a fit to C. A. Curcio et al., "Human photoreceptor topography", Journal of Comparative Neurology 292, 1990, as in a
/// program; 92 million there. The older count of 120 million is G. Østerberg's, 1935.
///
/// ```
/// use glanz_eye::curves::rod_density_mm2;
///
/// assert_eq!(rod_density_mm2(0.1), 0.0);
/// assert!(rod_density_mm2(4.92) > 158_000.0);
/// ```
pub fn rod_density_mm2(distance_mm: f64) -> f64 {
    let r = within(distance_mm, 0.0, 21.0);
    (5.855e5 * exp(-0.1388 * r) - 5.989e5 * exp(-0.2998 * r)).max(0.0)
}

/// Cones per deg² of the visual field at an eccentricity in degrees, 0 to 90°.
///
/// **Formula** 20991(1 + e/0.1342)^−0.7798. **Limits** ± 16 %, a mean over all directions.
/// **Source** a fit to Curcio et al. 1990, as in isetbio.
///
/// ```
/// assert!(glanz_eye::curves::cone_density_deg2(10.0) < 1000.0);
/// ```
pub fn cone_density_deg2(eccentricity_deg: f64) -> f64 {
    20_991.0 * pow(1.0 + within(eccentricity_deg, 0.0, EDGE_DEG) / 0.1342, -0.7798)
}

/// A direction from the fovea in the visual field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Meridian {
    /// Towards the temple.
    Temporal,
    /// Upwards.
    Superior,
    /// Towards the nose.
    Nasal,
    /// Downwards.
    Inferior,
}

/// Receptive fields of midget ganglion cells, on and off, per deg² of the visual field at an eccentricity in degrees, 0 to 90°.
///
/// **Formula** 2·14804.6 (a(1 + e/r2)^−2 + (1 − a)e^(−e/re))/1.12/(1 + e/41.03), with a, r2 and re for each meridian.
/// **Source** Watson 2014, equations 4, 7, 8 and table 1, as in three programs; isetbio has the rows of up and down exchanged.
///
/// ```
/// use glanz_eye::curves::{Meridian, midget_field_density_deg2};
///
/// let fovea = midget_field_density_deg2(0.0, Meridian::Temporal);
/// // Two for a cone, of all fields 1/1.12.
/// assert!((fovea - 2.0 * 14804.6 / 1.12).abs() < 1e-9);
/// ```
pub fn midget_field_density_deg2(eccentricity_deg: f64, meridian: Meridian) -> f64 {
    let e = within(eccentricity_deg, 0.0, EDGE_DEG);
    let (a, r2, re) = match meridian {
        Meridian::Temporal => (0.9851, 1.058, 22.14),
        Meridian::Superior => (0.9935, 1.035, 16.35),
        Meridian::Nasal => (0.9729, 1.084, 7.633),
        Meridian::Inferior => (0.9960, 0.9932, 12.13),
    };
    let near = 1.0 + e / r2;
    2.0 * 14_804.6 * (a / (near * near) + (1.0 - a) * exp(-e / re)) / 1.12 / (1.0 + e / 41.03)
}

/// The highest spatial frequency that is resolved at an eccentricity, in cycles per degree.
///
/// **Formula** 2.3 ln 64/(0.106(e + 2.3)). **Parameters** `eccentricity_deg` e, 0 to 90°.
/// **Source** W. S. Geisler and J. S. Perry, "A real-time foveated multiresolution system", SPIE 3299, 1998; from memory, not checked
/// against the paper.
///
/// ```
/// assert!((glanz_eye::curves::geisler_perry_cutoff(0.0) - 39.235).abs() < 5e-4);
/// ```
pub fn geisler_perry_cutoff(eccentricity_deg: f64) -> f64 {
    2.3 * log(64.0) / (0.106 * (within(eccentricity_deg, 0.0, EDGE_DEG) + 2.3))
}

/// The density of the macular pigment at its peak wavelength, 460 nm, at an eccentricity in degrees, 0 to 90°.
///
/// **Formula** 0.35·3.6028/(e² + 3.6028). **Source** a fit by Putnam and Bland, 2014, as in a program; the paper was not at hand.
///
/// ```
/// assert_eq!(glanz_eye::curves::macula_density_at(0.0), 0.35);
/// ```
pub fn macula_density_at(eccentricity_deg: f64) -> f64 {
    let e = within(eccentricity_deg, 0.0, EDGE_DEG);
    0.35 * 3.6028 / (e * e + 3.6028)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curves::assert_digits;

    #[test]
    fn rods_have_their_densities() {
        // eye.md 112–114, which gives whole rods, without what is left over.
        for (mm, known) in [(0.5, 30_714.0), (4.5, 158_122.0), (20.0, 34_978.0), (4.92, 158_753.0)] {
            assert_eq!(libm::floor(rod_density_mm2(mm)), known, "{mm} mm");
        }
        assert!(rod_density_mm2(0.13) == 0.0 && rod_density_mm2(0.15) > 0.0);
        assert!(
            rod_density_mm2(4.92) > rod_density_mm2(4.8) && rod_density_mm2(4.92) > rod_density_mm2(5.05)
        );
    }

    #[test]
    fn the_rods_of_an_eye_are_as_many_as_were_counted() {
        // eye.md §2: 89 million out to 21 mm; Curcio et al. counted 92. A sphere of 22 mm across.
        let radius_mm = 11.0;
        let rule = glanz_math::GaussLegendre::new(64);
        let ring =
            |r: f64| rod_density_mm2(r) * core::f64::consts::TAU * radius_mm * libm::sin(r / radius_mm);
        let all = rule.integrate(0.0, 21.0, ring);
        assert!((all / 89e6 - 1.0).abs() < 0.02, "{all}");
    }

    #[test]
    fn resolution_falls_as_geisler_and_perry_say() {
        // eye.md 115–117.
        for (eccentricity, known) in [(0.0, "39.235"), (5.0, "12.362"), (20.0, "4.047")] {
            assert_digits(geisler_perry_cutoff(eccentricity), known);
        }
    }

    #[test]
    fn midget_fields_are_two_for_a_cone_in_the_fovea_and_fewer_than_cones_outside() {
        for meridian in [Meridian::Temporal, Meridian::Superior, Meridian::Nasal, Meridian::Inferior] {
            assert!(midget_field_density_deg2(0.5, meridian) > cone_density_deg2(0.5), "{meridian:?}");
            assert!(midget_field_density_deg2(20.0, meridian) < cone_density_deg2(20.0), "{meridian:?}");
        }
    }

    #[test]
    fn the_retina_is_flat_near_the_fovea_and_ends() {
        assert_digits(eccentricity_mm(10.0), "2.706");
        assert_eq!(eccentricity_mm(200.0), eccentricity_mm(90.0));
        assert_digits(macula_density_at(2.0), "0.166");
    }

    #[test]
    fn an_area_of_the_retina_is_the_product_of_its_sides_on_a_sphere() {
        // Two fits of one schematic eye, and a sphere of 22 mm across in place of its retina.
        const FITS: f64 = 0.06;
        let radius_mm = 11.0;
        for e in [0.5, 15.0, 30.0, 60.0] {
            let outwards = (eccentricity_mm(e + 0.1) - eccentricity_mm(e - 0.1)) / 0.2;
            let around = radius_mm * libm::sin(eccentricity_mm(e) / radius_mm);
            let around = around / libm::sin(e.to_radians()) * core::f64::consts::PI / 180.0;
            let ratio = retinal_area_mm2(e) / (outwards * around);
            assert!((ratio - 1.0).abs() < FITS, "{e}°: {ratio}");
        }
    }

    #[test]
    fn far_from_the_fovea_the_temporal_field_has_the_most_midget_fields() {
        use Meridian::{Inferior, Nasal, Superior, Temporal};
        for e in [15.0, 30.0, 45.0] {
            let temporal = midget_field_density_deg2(e, Temporal);
            for other in [Superior, Inferior, Nasal] {
                assert!(temporal > 1.3 * midget_field_density_deg2(e, other), "{e}°, {other:?}");
            }
        }
        // The temporal retina, which sees the nasal field, has few.
        assert!(midget_field_density_deg2(30.0, Nasal) < 0.5 * midget_field_density_deg2(30.0, Temporal));
    }
}
