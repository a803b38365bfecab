//! Light from all around.

use glanz_bsdf::LightTerm;
use glanz_math::{Frame, Real, Vec3};

use crate::cpu::lighting::area::{middle_angle, view_frame};
use crate::cpu::lighting::light_sum::LightSum;
use crate::cpu::lighting::light_sum::apart;
use crate::cpu::lighting::light_sum::is_transmitting;
use crate::cpu::lighting::light_sum::layered;
use crate::prepare::{
    DirectLobe, EnvironmentChain, EnvironmentLight, LobeIntegrals, LobeLookups, PreparedMaterial,
};
use crate::view::lights::turned;

/// An environment among the lights.
#[derive(Clone, Copy)]
pub(crate) struct Around<'a> {
    pub environment: &'a EnvironmentLight,
    /// Its number among the environments.
    pub number: usize,
    /// Rows of the rotation into its own directions.
    pub to_map: &'a [[f32; 3]; 3],
    /// The first of its three lights in the table.
    pub row: usize,
}

/// Adds what an environment gives.
#[inline(always)]
pub(crate) fn add<R: Real>(sum: &mut LightSum<R>, around: Around) {
    let material = sum.material;
    for (k, lobe) in material.lobes.iter().enumerate() {
        if !is_seen_through(material, lobe) {
            add_lobe(sum, around, k, None);
        }
    }
}

/// Whether a lobe's light is seen through the surface already.
#[inline(always)]
pub(crate) fn is_seen_through(material: &PreparedMaterial, lobe: &DirectLobe) -> bool {
    is_transmitting(lobe) && lobe.term == LightTerm::Specular && material.transmittance.is_some()
}

/// Adds what an environment gives one lobe, where something stands between them only in part.
#[inline(always)]
pub(crate) fn add_lobe<R: Real>(sum: &mut LightSum<R>, around: Around, k: usize, free: Option<R>) {
    let zero = sum.cos_o.zero();
    let (lobe, integrals) = (&sum.material.lobes[k], &sum.material.integrals[k]);
    // Without a normal there is no surface to light.
    let is_lit = sum.point.normal.dot(sum.point.normal).gt(zero.lit(0.25));
    let pair = sum.typical_pair(lobe);
    let seen = seen(sum, around, lobe, integrals);
    let mut fraction = integrals.albedo.at(pair.cos_o, sum.tangent_o()).select(is_lit, zero);
    for factor in [sum.arrives, free].into_iter().flatten() {
        fraction = fraction * factor;
    }
    if lobe.shape.info().delta {
        fraction = layered(lobe, fraction, &pair);
    }
    for (basis, seen) in seen.into_iter().enumerate() {
        sum.add(around.row + basis, k, seen * fraction, &pair);
    }
}

/// What a lobe sees of the environment, as amounts of the three spectra; 1 where they are uniform.
#[inline(always)]
fn seen<R: Real>(sum: &LightSum<R>, around: Around, lobe: &DirectLobe, integrals: &LobeIntegrals) -> [R; 3] {
    let Around { environment, to_map, .. } = around;
    let one = sum.cos_o.one();
    let Some(map) = &environment.map else { return [one; 3] };
    let normal = sum.point.normal;
    let below = is_transmitting(lobe);
    if lobe.shape.info().delta {
        let direction = match below {
            true => refracted(sum.point.wo, normal, sum.cos_o, lobe.shape.eta()),
            false => sum.point.wo.reflected(normal),
        };
        let direction = turned(to_map, direction);
        return apart(
            one,
            #[inline(always)]
            || map.at(direction),
        );
    }
    let irradiance = || {
        let side = turned(to_map, if below { -normal } else { normal });
        apart(
            one,
            #[inline(always)]
            || environment.irradiance.at(side),
        )
    };
    let (Some(lookups), Some(chain)) = (&integrals.lookups, map.chain()) else { return irradiance() };
    apart(
        one,
        #[inline(always)]
        || looked_up(sum, to_map, lobe, (lookups, chain), irradiance),
    )
}

/// The sum of a lobe's lookups.
#[inline(always)]
fn looked_up<R: Real>(
    sum: &LightSum<R>,
    to_map: &[[f32; 3]; 3],
    lobe: &DirectLobe,
    (lookups, chain): (&LobeLookups, &EnvironmentChain),
    irradiance: impl FnOnce() -> [R; 3],
) -> [R; 3] {
    let (cos_o, normal, wo) = (sum.cos_o, sum.point.normal, sum.point.wo);
    let one = cos_o.one();
    let place = lookups.nodes.place(cos_o, sum.tangent_o());
    // The frame of the lobe.
    let Frame { t, b, n } = view_frame(wo, normal, cos_o);
    let below = is_transmitting(lobe);
    let (sin, cos) = middle_angle(cos_o, lobe);
    let side = if below { -n } else { n };
    let frame = [t * cos + side * sin, b * place.side, side * cos - t * sin].map(
        #[inline(always)]
        |axis| turned(to_map, axis),
    );
    let mut sums = [[0.0; 4]; 16];
    for number in 0..lookups.count {
        let [x, y, z, level, amount] = lookups.at(&place, number);
        let direction = frame[0] * x + frame[1] * y + frame[2] * z;
        let direction = direction * direction.dot(direction).max(one.lit(1e-12)).rsqrt();
        chain.add_to(&mut sums, direction, level, amount, lookups.wide);
    }
    let mut arrays = [[0.0; 16]; 3];
    for (lane, sum) in sums.iter().enumerate() {
        for (array, value) in arrays.iter_mut().zip(sum) {
            array[lane] = *value;
        }
    }
    let mut seen = [one.with_array(&arrays[0]), one.with_array(&arrays[1]), one.with_array(&arrays[2])];
    if let Some(amount) = lookups.cosine_at(&place) {
        let matte = irradiance();
        for (seen, matte) in seen.iter_mut().zip(matte) {
            *seen = *seen + amount * matte;
        }
    }
    seen
}

/// Where a line of sight goes on below a surface; where it is reflected totally, along the surface.
#[inline(always)]
pub(crate) fn refracted<R: Real>(wo: Vec3<R>, normal: Vec3<R>, cos_o: R, eta: f64) -> Vec3<R> {
    let inverse = cos_o.lit(1.0 / eta);
    let sin2 = (cos_o.one() - cos_o.sqr()) * inverse.sqr();
    let cos_t = (cos_o.one() - sin2).max(cos_o.zero()).sqrt();
    let down = normal * (cos_o * inverse - cos_t) - wo * inverse;
    down * down.dot(down).max(cos_o.lit(1e-12)).rsqrt()
}
