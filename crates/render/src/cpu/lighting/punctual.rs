//! Light from points and from afar.

use glanz_math::Real;

use crate::cpu::lighting::incident::arrive;
use crate::cpu::lighting::light_sum::KnownFactors;
use crate::cpu::lighting::light_sum::LightSum;
use crate::cpu::lighting::light_sum::is_transmitting;
use crate::cpu::lighting::light_sum::layered;
use crate::cpu::lighting::light_sum::shape_value;
use crate::cpu::lighting::point::{add as add_light, literal, mixed};
use crate::cpu::lighting::shade_material::ShadeLights;
use crate::cpu::lighting::shadow;
use crate::view::lights::ViewLight;

/// Adds what a punctual light gives.
#[inline(always)]
pub(crate) fn add<R: Real>(sum: &mut LightSum<R>, lights: &ShadeLights, light: &ViewLight, row: usize) {
    let point = sum.point;
    let like = point.normal.x;
    let incident = arrive(light, point);
    if let (Some(mut cone), Some(row_ambient)) = (incident.cone, sum.material.spot_ambient.get(row)) {
        if let Some(ambient) = sum.ambient {
            cone = cone * ambient;
        }
        let textured = match &sum.mix {
            Some((mix, texel)) => mixed(&mix.spot_ambient[row], texel),
            None => literal(like, &row_ambient[0]),
        };
        add_light(&mut sum.reflected.textured, cone, textured);
        add_light(&mut sum.reflected.plain, cone, literal(like, &row_ambient[1]));
    }
    let pair = sum.pair(incident.wi);
    if !sum.material.transmits && !R::any(like.zero().lt(pair.cos_i)) {
        return;
    }
    let mut attenuation = incident.attenuation.unwrap_or(like.one());
    if let Some(bvh) = lights.bvh {
        attenuation = attenuation * shadow::free(bvh, point, incident.wi, incident.distance);
    }
    let (mut last, mut known) = (like.zero(), KnownFactors::new(like));
    for (k, lobe) in sum.material.lobes.iter().enumerate() {
        let is_lit =
            if is_transmitting(lobe) { pair.cos_i.lt(like.zero()) } else { like.zero().lt(pair.cos_i) };
        if lobe.shape.info().delta || !R::any(is_lit) {
            continue;
        }
        // Lobes of one shape under different layers stand together.
        if !sum.material.repeats[k] {
            let own = sum.own_pair(lobe, &pair);
            last = shape_value(lobe, own.as_ref().unwrap_or(&pair)) * attenuation;
        }
        let value = match sum.material.has_tables {
            true => known.layered(lobe, last, &pair),
            false => layered(lobe, last, &pair),
        };
        sum.add(row, k, value, &pair);
    }
}
