//! The sum over lights and lobes: the heart of the pixel loop.
//!
//! C = Σ_l a_l(x) · Σ_k s_k(wo, wi) · T\[l, k, c\]. There is no wavelength here, and no colour but the
//! numbers of the tint table.

use fearless_simd::Simd;
use glanz_bsdf::DirectionPair;
use glanz_math::{Lanes, Real, Vec3};

use crate::cpu::lighting::general;
use crate::cpu::lighting::inlined_models::Inline;
use crate::cpu::lighting::shade_material::{ShadeLights, ShadeMaterial};
use crate::prepare::TintCoordinate;
use crate::view::lights::{ViewCone, ViewLight, splat, turned};
use glanz_math::inline::inlined;
use glanz_math::inline::three;

/// A surface point as seen: relative to the eye, along world axes.
#[derive(Clone, Copy)]
pub(crate) struct ShadingPoint<R> {
    pub position: Vec3<R>,
    /// Unit normal; null where the surface shall not be lit.
    pub normal: Vec3<R>,
    /// Unit vector to the viewer.
    pub wo: Vec3<R>,
    /// The surface's tangent, of any length; none where it has none.
    pub tangent: Option<Vec3<R>>,
    /// Multiplies the width of lobes that textures can widen.
    pub alpha_scale: R,
    /// What a texture says of metal.
    pub metal: R,
}

impl<R: Real> ShadingPoint<R> {
    /// A point of a surface without tangents and textures.
    #[inline(always)]
    pub fn plain(position: Vec3<R>, normal: Vec3<R>, wo: Vec3<R>) -> Self {
        let one = normal.x.one();
        Self { position, normal, wo, tangent: None, alpha_scale: one, metal: one }
    }
}

/// Light that textures multiply, and light that they do not.
#[derive(Clone, Copy)]
pub(crate) struct Reflected<R> {
    pub textured: [R; 3],
    pub plain: [R; 3],
}

/// What reaches the point from a punctual light: direction, reach, and the factor of its cone alone.
pub(crate) struct Incident<R> {
    pub wi: Vec3<R>,
    pub attenuation: Option<R>,
    pub cone: Option<R>,
    /// How far the light is; none if it is infinitely far.
    pub distance: Option<R>,
}

/// All light that `material` sends from `point` to the viewer, without its own emission.
///
/// With a texel and a material that mixes spectra, the textured part is already what the texel makes of
/// it; else it is what is still to be multiplied with the texel.
#[inline(always)]
pub(crate) fn reflect<R: Real>(
    lights: &ShadeLights,
    material: &ShadeMaterial,
    point: &ShadingPoint<R>,
    texel: Option<[R; 3]>,
) -> Reflected<R> {
    match material.fast_path && lights.fast_path {
        true => reflect_classic(&lights.list, material, point, texel),
        false => general::reflect(lights, material, point, texel),
    }
}

/// [`reflect`] where there are only classic materials and punctual lights without luminaires or shadows.
#[inline(always)]
pub(crate) fn reflect_classic<R: Real>(
    lights: &[ViewLight],
    material: &ShadeMaterial,
    point: &ShadingPoint<R>,
    texel: Option<[R; 3]>,
) -> Reflected<R> {
    let like = point.normal.x;
    let mix = material.mix.as_deref().zip(texel);
    let mut sum = Reflected {
        textured: match &mix {
            Some((mix, texel)) => mixed(&mix.ambient, texel),
            None => literal(like, &material.ambient[0]),
        },
        plain: literal(like, &material.ambient[1]),
    };
    let cos_o = point.normal.dot(point.wo);
    let lobes = &material.lobes[..];
    for (number, light) in lights.iter().enumerate() {
        let incident = arrive(light, point);
        if let (Some(cone), Some(row)) = (incident.cone, material.spot_ambient.get(number)) {
            let textured = match &mix {
                Some((mix, texel)) => mixed(&mix.spot_ambient[number], texel),
                None => literal(like, &row[0]),
            };
            add(&mut sum.textured, cone, textured);
            add(&mut sum.plain, cone, literal(like, &row[1]));
        }
        let cos_i = point.normal.dot(incident.wi);
        if !R::any(like.zero().lt(cos_i)) {
            continue;
        }
        let pair = DirectionPair::isotropic(cos_o, cos_i, point.wo.dot(incident.wi));
        let first = number * lobes.len();
        let row = &material.tints[first..][..lobes.len()];
        // A factor of 1 rather than none: the compiler multiplies in either case, and where there is
        // none with what happens to be in memory, which is slow where that is a denormal number.
        let attenuation = incident.attenuation.unwrap_or(like.one());
        for (k, (lobe, tint)) in lobes.iter().zip(row).enumerate() {
            let value = lobe.shape.visit(Inline(&pair)) * attenuation;
            let tint = match &mix {
                _ if lobe.coordinate == TintCoordinate::HalfAngle => {
                    material.series[first + k].at(pair.cos_view_half())
                }
                Some((mix, texel)) if lobe.textured => mixed(&mix.tints[first + k], texel),
                _ => literal(like, tint),
            };
            add(if lobe.textured { &mut sum.textured } else { &mut sum.plain }, value, tint);
        }
    }
    sum
}

/// What a texel makes of three spectra.
#[inline(always)]
pub(crate) fn mixed<R: Real>(basis: &[[f32; 3]; 3], texel: &[R; 3]) -> [R; 3] {
    let [r, g, b] = *texel;
    three(
        [0, 1, 2],
        #[inline(always)]
        |c: usize| {
            let lit = inlined(
                #[inline(always)]
                |spectrum: usize| r.lit(f64::from(basis[spectrum][c])),
            );
            r * lit(0) + g * lit(1) + b * lit(2)
        },
    )
}

#[inline(always)]
pub(crate) fn literal<R: Real>(like: R, tint: &[f32; 3]) -> [R; 3] {
    three(
        *tint,
        #[inline(always)]
        |c| like.lit(f64::from(c)),
    )
}

/// [`reflect`] for sixteen pixels, as a function of its own: it is by far the largest piece of code
/// below a dispatch, and exists once per SIMD level rather than once per caller.
#[inline(never)]
pub(crate) fn reflect_lanes<S: Simd>(
    simd: S,
    lights: &ShadeLights,
    material: &ShadeMaterial,
    point: &ShadingPoint<Lanes<S>>,
    texel: Option<[Lanes<S>; 3]>,
) -> Reflected<Lanes<S>> {
    simd.vectorize(
        #[inline(always)]
        || reflect(lights, material, point, texel),
    )
}

#[inline(always)]
pub(crate) fn add<R: Real>(sum: &mut [R; 3], value: R, tint: [R; 3]) {
    for c in 0..3 {
        sum[c] = sum[c] + value * tint[c];
    }
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
