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
                |cone| inside(cone, wi, rim_width(cone, point, wi, inverse)),
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

/// Below this cosine to the viewer a rim is no wider than there: a pixel of a silhouette is not a wide one.
const LEAST_FACING: f64 = 0.2;

/// How much −L·D changes across a pixel, if the cone ends with a hard rim.
///
/// A pixel of width h is seen on the plane across N as the steps h (e − V (e·N) / (V·N)) for e across V, so the slope g of
/// −L·D in space is h |g − N (g·V) / (N·V)| in the picture.
#[inline(always)]
fn rim_width<R: Real>(cone: &ViewCone, point: &ShadingPoint<R>, wi: Vec3<R>, inverse: R) -> Option<R> {
    // A cone that is all around has no rim.
    let [fixed, per_metre] = point.pixel.filter(|_| cone.smooth_edge.is_none() && cone.cos_cutoff > -1.0)?;
    let like = wi.x;
    let axis = splat(like, &cone.axis);
    let slope = (axis - wi * wi.dot(axis)) * inverse;
    let facing = point.normal.dot(point.wo).max(like.lit(LEAST_FACING));
    let seen = slope - point.normal * (slope.dot(point.wo) / facing);
    let distance = length(point.position);
    let pixel = like.lit(f64::from(fixed)) + like.lit(f64::from(per_metre)) * distance;
    Some((pixel * length(seen)).max(like.lit(1e-9)))
}

#[inline(always)]
fn length<R: Real>(v: Vec3<R>) -> R {
    let squared = v.dot(v).max(v.x.lit(1e-30));
    squared * squared.rsqrt()
}

/// The cone factor: (−L·D)^exponent inside the cut-off, 0 outside; or a smooth edge as in glTF. Across a hard rim that is so
/// wide it falls evenly, as if the pixel were covered in part.
#[inline(always)]
fn inside<R: Real>(cone: &ViewCone, wi: Vec3<R>, rim: Option<R>) -> R {
    let like = wi.x;
    let cosine = -wi.dot(splat(like, &cone.axis));
    let cutoff = like.lit(f64::from(cone.cos_cutoff));
    if let Some(rim) = rim {
        let covered = ((cosine - cutoff) / rim + like.lit(0.5)).clamp(0.0, 1.0);
        let factor = match cone.exponent {
            0.0 => like.one(),
            exponent => cosine.max(cutoff).max(like.zero()).pow(like.lit(f64::from(exponent))),
        };
        return factor * covered;
    }
    let factor = match cone.smooth_edge {
        Some([outer, inverse_width]) => {
            let t = (cosine - like.lit(f64::from(outer))) * like.lit(f64::from(inverse_width));
            t.clamp(0.0, 1.0).sqr()
        }
        None if cone.exponent == 0.0 => like.one(),
        None => cosine.max(like.zero()).pow(like.lit(f64::from(cone.exponent))),
    };
    factor.select(cutoff.le(cosine), like.zero())
}
