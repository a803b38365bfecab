//! From the numbers of a pair of directions to the vectors of a BRDF's function.

use glanz_bsdf::DirectionPair;
use glanz_math::{Real, Vec3};

/// The directions to the light and to the viewer, in the frame of normal (z), tangent (x) and bitangent (y).
///
/// Pairs from vectors have their tangential coordinates. Isotropic ones have three cosines alone; then the viewer
/// lies in the plane of normal and tangent, and the light has the azimuth that gives the cosine between both. At normal
/// incidence the azimuth is any: the cosine's rounding decides, and the light stays a unit vector.
#[inline(always)]
pub(super) fn directions<R: Real>(pair: &DirectionPair<R>) -> (Vec3<R>, Vec3<R>) {
    let (cos_o, cos_i) = (pair.cos_o, pair.cos_i);
    let zero = cos_o.zero();
    let (sin_o, sin_i) = (sine(cos_o), sine(cos_i));
    // Far above the rounding of a cosine, far below what a sine in single precision can be.
    let x = (pair.cos_io - cos_o * cos_i) / sin_o.max(cos_o.lit(1e-12));
    let x = x.max(-sin_i).min(sin_i);
    let y = ((sin_i - x) * (sin_i + x)).max(zero).sqrt();
    let ((ox, oy), (ix, iy)) = (pair.tangent_o, pair.tangent_i);
    let given = zero.lt(ox * ox + oy * oy + ix * ix + iy * iy);
    let light = Vec3::new(ix.select(given, x), iy.select(given, y), cos_i);
    let view = Vec3::new(ox.select(given, sin_o), oy.select(given, zero), cos_o);
    (light, view)
}

/// √(1 − cos²), which loses no digits where the cosine is near 1.
#[inline(always)]
fn sine<R: Real>(cosine: R) -> R {
    let one = cosine.one();
    ((one - cosine) * (one + cosine)).max(cosine.zero()).sqrt()
}

#[cfg(test)]
mod tests {
    use glanz_math::PI;

    use super::*;

    #[test]
    fn cosines_alone_give_unit_vectors_with_these_cosines() {
        for theta_o in [0.0, 1e-9, 1e-4, 0.3, 1.2, 1.57, PI / 2.0] {
            for theta_i in [0.0, 1e-6, 0.7, 1.5, PI / 2.0] {
                for phi in [0.0, 0.4, PI / 2.0, 3.0, PI] {
                    let (wo, wi) = (Vec3::from_angles(theta_o, 0.0), Vec3::from_angles(theta_i, phi));
                    let (wo, wi) = (wo, wi).into_singles();
                    let (light, view) = directions(&DirectionPair::isotropic(wo.z, wi.z, wo.dot(wi)));
                    assert!((light.dot(light) - 1.0).abs() < 4e-7, "{light:?}");
                    assert!((view.dot(view) - 1.0).abs() < 4e-7, "{view:?}");
                    // Near the normal the cosine has fewer digits of the angle than the vector.
                    let lost = (wo.x - view.x).abs() + (wi.x.hypot(wi.y) - light.x.hypot(light.y)).abs();
                    let off = (light.dot(view) - wo.dot(wi)).abs();
                    assert!(off < 4e-7 + lost, "{theta_o} {theta_i} {phi}: {off}");
                    assert_eq!((light.z, view.z), (wi.z, wo.z));
                }
            }
        }
    }

    #[test]
    fn tangents_that_are_given_are_taken() {
        let (wo, wi) = (Vec3::from_angles(0.4, 2.0), Vec3::from_angles(1.1, 5.0));
        let (light, view) = directions(&DirectionPair::new(wo, wi));
        assert_eq!((light, view), (wi, wo));
        let up = Vec3::new(0.0, 0.0, 1.0);
        assert_eq!(directions(&DirectionPair::new(up, up)), (up, up));
    }

    trait Singles {
        fn into_singles(self) -> (Vec3<f32>, Vec3<f32>);
    }

    impl Singles for (Vec3<f64>, Vec3<f64>) {
        fn into_singles(self) -> (Vec3<f32>, Vec3<f32>) {
            let single = |w: Vec3<f64>| Vec3::new(w.x as f32, w.y as f32, w.z as f32);
            (single(self.0), single(self.1))
        }
    }
}
