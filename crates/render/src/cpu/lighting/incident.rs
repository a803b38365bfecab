//! What reaches a point from a punctual light.

use glanz_math::inline::inlined;
use glanz_math::{Real, Vec3};

use crate::cpu::lighting::point::ShadingPoint;
use crate::view::lights::{ViewCone, ViewLight, splat, turned};

/// What reaches the point from a punctual light: direction, reach, and the factor of its cone alone.
pub(crate) struct Incident<R> {
    pub wi: Vec3<R>,
    pub attenuation: Option<R>,
    pub cone: Option<R>,
    /// How far the light is; none if it is infinitely far.
    pub distance: Option<R>,
}

#[inline(always)]
pub(crate) fn arrive<R: Real>(light: &ViewLight, point: &ShadingPoint<R>) -> Incident<R> {
    let like = point.normal.x;
    match light {
        ViewLight::Directional { towards } => {
            Incident { wi: splat(like, towards), attenuation: None, cone: None, distance: None }
        }
        // Areas and environments are not punctual; the loop does not ask.
        ViewLight::Area(_) | ViewLight::Environment { .. } => {
            Incident { wi: point.normal, attenuation: Some(like.zero()), cone: None, distance: None }
        }
        ViewLight::Point { position, attenuation, cone, luminaire } => {
            let to_light = splat(like, position) - point.position;
            // A light on the surface itself: no direction, no light, rather than infinity.
            let squared = to_light.dot(to_light).max(like.lit(1e-30));
            let inverse = squared.rsqrt();
            let wi = to_light * inverse;
            let fade = match attenuation {
                None => None,
                Some([c, l, q]) => {
                    let distance = squared * inverse;
                    let f = inlined(
                        #[inline(always)]
                        |x: &f32| like.lit(f64::from(*x)),
                    );
                    let denominator = f(c) + f(l) * distance + f(q) * squared;
                    // Light 0 m away without a constant part would be infinite; 1e-20 keeps it a number.
                    Some(like.one() / denominator.max(like.lit(1e-20)))
                }
            };
            let cone = cone.as_ref().map(
                #[inline(always)]
                |cone| inside(cone, wi),
            );
            let mut attenuation = match (fade, cone) {
                (Some(a), Some(b)) => Some(a * b),
                (a, b) => a.or(b),
            };
            if let Some(luminaire) = luminaire {
                let fraction = luminaire.intensities.at(turned(&luminaire.frame, -wi));
                attenuation = Some(attenuation.map_or(fraction, |attenuation| attenuation * fraction));
            }
            Incident { wi, attenuation, cone, distance: Some(squared * inverse) }
        }
    }
}

/// The cone factor: (−L·D)^exponent inside the cut-off, 0 outside; or a smooth edge as in glTF.
#[inline(always)]
fn inside<R: Real>(cone: &ViewCone, wi: Vec3<R>) -> R {
    let like = wi.x;
    let cosine = -wi.dot(splat(like, &cone.axis));
    let factor = match cone.smooth_edge {
        Some([outer, inverse_width]) => {
            let t = (cosine - like.lit(f64::from(outer))) * like.lit(f64::from(inverse_width));
            t.clamp(0.0, 1.0).sqr()
        }
        None if cone.exponent == 0.0 => like.one(),
        None => cosine.max(like.zero()).pow(like.lit(f64::from(cone.exponent))),
    };
    factor.select(like.lit(f64::from(cone.cos_cutoff)).le(cosine), like.zero())
}
