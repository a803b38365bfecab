//! Reciprocity: f(wo, wi) = f(wi, wo).
//!
//! For refraction f(wo, wi) / η_o² = f(wi, wo) / η_i², where light that passes is viewed from the other side with the
//! surface turned over.

use glanz_math::Vec3;

use crate::DirectionPair;
use crate::laws::grid::{Place, places, to_f32};
use crate::laws::rounding::{COSINE_F32, COSINE_F64, range, to_f64};
use crate::laws::subject::Subject;
use crate::laws::verdict::{Finding, Law};

/// How far both ways may differ, in parts of the greater one: a few units of the last place, since the same products
/// are formed in another order.
const TOLERANCE_F64: f64 = 1e-12;
/// The same in `f32`, whose last place is 6e-8, after a power that multiplies errors.
const TOLERANCE_F32: f64 = 1e-5;
/// Values below this, in 1/sr, are as good as 0: `f32` has them as denormal numbers or not at all.
const FAINTEST: f64 = 1e-20;

/// Looks for the pair of directions whose exchange changes most.
pub(in crate::laws) fn judge(subject: &dyn Subject) -> Finding {
    if let Some(reason) = subject.no_directional_light() {
        return Finding::not_applicable(Law::Reciprocity, reason);
    }
    let Ok(turned) = turned_over(subject) else {
        return Finding::not_applicable(Law::Reciprocity, "the surface turned over is out of its range");
    };
    let turned = turned.as_deref().unwrap_or(subject);
    let mut worst = [(0.0, None); 2];
    for place in places(subject) {
        // What is computed in single precision only has no digits that double precision could ask for.
        let double = if subject.is_single() { 0.0 } else { in_f64(subject, turned, &place) };
        let differences = [double, in_f32(subject, turned, &place).unwrap_or(0.0)];
        for (worst, difference) in worst.iter_mut().zip(differences) {
            // Of a program, values that are no numbers are another law's.
            if difference > worst.0 || difference.is_nan() && !subject.is_single() {
                *worst = (difference, Some(place));
            }
        }
    }
    let holds = [worst[0].0 <= TOLERANCE_F64, worst[1].0 <= TOLERANCE_F32];
    let (precision, (difference, place)) =
        if holds[0] && !holds[1] { (" in f32", worst[1]) } else { ("", worst[0]) };
    let detail = match place {
        Some(place) => {
            let part = match difference {
                much if much > 1e-3 => format!("{:.1} %", 100.0 * much),
                little => format!("{little:.1e}"),
            };
            format!("both ways differ{precision} by up to {part} of the greater: {}", place.words())
        }
        None => "both ways are the same".to_owned(),
    };
    Finding::judged(Law::Reciprocity, subject.info(), holds == [true; 2], difference, detail).at(place)
}

/// The same surface turned over: its parameter `eta` becomes the inverse. `Ok(None)` where it is the surface itself, an
/// error where the inverse is out of range.
fn turned_over(subject: &dyn Subject) -> Result<Option<Box<dyn Subject + '_>>, ()> {
    let Some(index) = subject.info().params.iter().position(|param| param.name == "eta") else {
        return Ok(None);
    };
    let (mut params, range) = (subject.params(), &subject.info().params[index]);
    params[index] = 1.0 / params[index];
    match (range.min..=range.max).contains(&params[index]) {
        true => subject.with_params(&params).map(Some).ok_or(()),
        false => Err(()),
    }
}

/// The pair with viewer and light exchanged, turned over where light passes.
fn exchanged<R: glanz_math::Real>(subject: &dyn Subject, wo: Vec3<R>, wi: Vec3<R>) -> DirectionPair<R> {
    let over = |w: Vec3<R>| if subject.transmits() { Vec3::new(w.x, w.y, -w.z) } else { w };
    DirectionPair::new(over(wi), over(wo))
}

fn in_f64(subject: &dyn Subject, turned: &dyn Subject, place: &Place) -> f64 {
    let pair = place.pair();
    let again = turned.value(&exchanged(subject, place.wo, place.wi));
    difference(
        subject,
        [&pair, &exchanged(subject, place.wo, place.wi)],
        [subject.value(&pair), again],
        COSINE_F64,
    )
}

fn in_f32(subject: &dyn Subject, turned: &dyn Subject, place: &Place) -> Option<f64> {
    let pair = place.pair_f32();
    let exchanged = exchanged(subject, to_f32(place.wo), to_f32(place.wi));
    let (there, again) = (subject.value_f32(&pair)?, turned.value_f32(&exchanged)?);
    let pairs = [&to_f64(&pair), &to_f64(&exchanged)];
    Some(difference(subject, pairs, [there.into(), again.into()], COSINE_F32))
}

/// |f(wo, wi) η_i² − f(wi, wo) η_o²| in parts of the greater, both sides multiplied with both cosines, of the values of
/// f_cos both ways.
///
/// Where light is refracted, the half vector is formed from other numbers both ways, and a program of a user's forms what it
/// likes; what the rounding of the coordinates does is then no difference.
fn difference(
    subject: &dyn Subject,
    [pair, exchanged]: [&DirectionPair<f64>; 2],
    values: [f64; 2],
    rounding: f64,
) -> f64 {
    let factor = pair.cos_o.abs() * subject.eta() * subject.eta();
    let (there, again) = (values[0] * factor, values[1] * pair.cos_i.abs());
    let rounded = |pair: &DirectionPair<f64>, factor: f64| {
        let (low, high) = range(subject, pair, rounding);
        (high - low) * factor
    };
    let allowed = match (subject.eta() == 1.0, subject.is_single() && there != again) {
        (false, _) => rounded(pair, factor),
        (true, false) => 0.0,
        (true, true) => rounded(pair, factor) + rounded(exchanged, pair.cos_i.abs()),
    };
    let beyond = (there - again).abs() - allowed;
    if beyond <= 0.0 { 0.0 } else { beyond / there.abs().max(again.abs()).max(FAINTEST) }
}
