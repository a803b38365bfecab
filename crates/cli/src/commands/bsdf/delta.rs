//! Delta lobes: the one direction that their light comes from, and how much of it arrives.

use glanz_bsdf::{DirectionPair, Shape, Side};
use glanz_math::Vec3;
use glanz_plot::{Factor, number};
use schemars::JsonSchema;
use serde::Serialize;

/// How far two directions may be apart to be the same, in degrees.
const SAME_DEG: f64 = 0.01;

/// The one direction of a delta lobe.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct DeltaFacts {
    /// Angle from the normal and azimuth of the light that goes to the viewer; null where none does
    wi_deg: Option<[f64; 2]>,
    /// The radiance that goes to the viewer, over that which comes from there, with the tint
    factor: f64,
    /// Whether the light that was asked for is in that direction
    is_wi: bool,
}

impl DeltaFacts {
    /// What a delta lobe does with the light that goes to `wo`; none for other lobes.
    pub(super) fn of(shape: &Shape, factor: &Factor, wo: Vec3<f64>, wi: Vec3<f64>) -> Option<Self> {
        if !shape.info().delta {
            return None;
        }
        let Some(from) = source(shape, wo) else {
            return Some(Self { wi_deg: None, factor: 0.0, is_wi: false });
        };
        let scale = match shape.info().side {
            Side::Reflection => 1.0,
            // Radiance is proportional to the square of the index (Veach 1997, §5.2).
            Side::Transmission => 1.0 / (shape.eta() * shape.eta()),
        };
        let theta = libm::acos(from.z.clamp(-1.0, 1.0)).to_degrees();
        let phi =
            if theta.min(180.0 - theta) < 1e-9 { 0.0 } else { libm::atan2(from.y, from.x).to_degrees() };
        let apart = libm::acos(from.dot(wi).clamp(-1.0, 1.0)).to_degrees();
        Some(Self {
            wi_deg: Some([theta, phi.rem_euclid(360.0)]),
            factor: scale * factor.value(shape, &DirectionPair::new(wo, from)),
            is_wi: apart < SAME_DEG,
        })
    }

    /// The same for people.
    pub(super) fn text(&self) -> String {
        let Some([theta, phi]) = self.wi_deg else {
            return "delta  no light goes to the viewer: it would be totally reflected\n".to_owned();
        };
        let tidy = |degrees: f64| number((degrees * 1e4).round() / 1e4);
        let there = if self.is_wi { "as --wi" } else { "not as --wi, from where nothing comes" };
        format!(
            "delta  the light comes from {},{} alone, {there}: a value in 1/sr is 0 elsewhere, unbounded there\n\
             factor {} of that light goes to the viewer\n",
            tidy(theta),
            tidy(phi),
            number(self.factor)
        )
    }
}

/// The direction that light comes from which goes to `wo`.
fn source(shape: &Shape, wo: Vec3<f64>) -> Option<Vec3<f64>> {
    match shape.info().side {
        Side::Reflection => Some(Vec3::new(-wo.x, -wo.y, wo.z)),
        Side::Transmission => {
            let (x, y) = (-wo.x / shape.eta(), -wo.y / shape.eta());
            let squared = 1.0 - x * x - y * y;
            (squared > 0.0).then(|| Vec3::new(x, y, -libm::sqrt(squared)))
        }
    }
}

#[cfg(test)]
mod tests {
    use glanz_plot::Medium;

    use super::*;

    fn of(model: &str, set: &[(&str, f64)], theta: f64) -> DeltaFacts {
        let shape = Shape::named(model, set).unwrap();
        let glass = Factor::Fresnel(Medium::named("1.5", 550.0).unwrap());
        let wo = Vec3::from_angles(theta.to_radians(), 0.0);
        DeltaFacts::of(&shape, &glass, wo, Vec3::new(0.0, 0.0, 1.0)).unwrap()
    }

    #[test]
    fn a_mirror_of_glass_has_the_fresnel_reflectance() {
        let facts = of("mirror", &[], 0.0);
        assert!((facts.factor - 0.04).abs() < 1e-12 && facts.is_wi);
        let facts = of("mirror", &[], 60.0);
        assert!((facts.factor - 0.089_187).abs() < 1e-6 && !facts.is_wi);
        assert_eq!(facts.wi_deg.map(|wi| wi.map(f64::round)), Some([60.0, 180.0]));
    }

    #[test]
    fn refraction_bends_by_snell_and_keeps_what_is_not_reflected() {
        let facts = of("refraction", &[("eta", 1.5)], 30.0);
        let [theta, phi] = facts.wi_deg.unwrap();
        // sin θt = sin 30° / 1.5.
        assert!((180.0 - theta - 19.471_22).abs() < 1e-4 && (phi - 180.0).abs() < 1e-9);
        assert!((facts.factor - (1.0 - 0.041_521) / 2.25).abs() < 1e-5);
    }
}
