//! The sum over lights and lobes: the heart of the pixel loop.
//!
//! C = Σ_l a_l(x) · Σ_k s_k(wo, wi) · T\[l, k, c\]. There is no wavelength here, and no colour but the
//! numbers of the tint table.

use fearless_simd::Simd;
use glanz_bsdf::DirectionPair;
use glanz_math::{Lanes, Real};

use crate::cpu::lighting::general;
use crate::cpu::lighting::incident::arrive;
use crate::cpu::lighting::inlined_models::Inline;
use crate::cpu::lighting::point::{Reflected, ShadingPoint, add, literal, mixed};
use crate::cpu::lighting::shade_material::{ShadeLights, ShadeMaterial};
use crate::prepare::TintCoordinate;
use crate::view::lights::ViewLight;

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
    let mut sum = Reflected::ambient(like, material, &mix);
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
        let pair = DirectionPair::between((cos_o, point.wo), (cos_i, incident.wi));
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
