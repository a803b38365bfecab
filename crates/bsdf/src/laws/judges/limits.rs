//! Limits: a highlight that narrows becomes a mirror, a diffuse lobe that becomes smooth Lambert's.

use glanz_math::{PI, Vec3};

use crate::laws::grid::direction;
use crate::laws::hemisphere::{Weight, moments};
use crate::laws::subject::Subject;
use crate::laws::verdict::{Finding, Law};
use crate::{DirectionPair, LightTerm};

/// The view angle at which a highlight is followed, in degrees.
const VIEW: f64 = 30.0;
/// A highlight is narrow if the mean of its directions is this long: the cosine of 5°.
const GATHERED: f64 = 0.996;
/// How far the middle may be from the mirror direction, in degrees.
const AWAY: f64 = 1.0;
/// How far a diffuse lobe may be from Lambert's, in parts of it.
const LAMBERT: f64 = 1e-6;

/// Why the law does not apply to transmission.
pub(in crate::laws) const REFRACTED: &str = "where light passes through, it bends";
/// Why it does not apply to wide highlights.
pub(in crate::laws) const NEVER_NARROW: &str = "no parameter narrows it to a mirror";
/// Why it does not apply to diffuse lobes that are never smooth.
pub(in crate::laws) const NEVER_LAMBERT: &str = "no end of a parameter makes it Lambert's";

/// Follows every parameter to the end at which the lobe becomes simpler.
pub(in crate::laws) fn judge(subject: &dyn Subject) -> Finding {
    if let Some(reason) = subject.no_directional_light() {
        return Finding::not_applicable(Law::Limits, reason);
    }
    match (subject.info().term, subject.transmits()) {
        (_, true) => Finding::not_applicable(Law::Limits, REFRACTED),
        (LightTerm::Specular, _) => narrow(subject),
        _ => smooth(subject),
    }
}

/// The parameters for which the score reaches `enough` when one after the other, that which helps most first, is set to its
/// least or greatest value; else the best that are found. With the score.
fn best(subject: &dyn Subject, enough: f64, score: impl Fn(&dyn Subject) -> f64) -> (f64, Vec<f64>) {
    let mut found = (score(subject), subject.params());
    for _ in subject.info().params {
        if found.0 >= enough {
            break;
        }
        let params = found.1.clone();
        let ends =
            subject.info().params.iter().enumerate().flat_map(|(i, info)| [(i, info.min), (i, info.max)]);
        for (index, end) in ends {
            let mut changed = params.clone();
            changed[index] = end;
            let Some(candidate) = subject.with_params(&changed) else { continue };
            let value = score(candidate.as_ref());
            if value > found.0 {
                found = (value, changed);
            }
        }
    }
    found
}

/// What `f` finds for the subject with these parameters.
fn with<T>(subject: &dyn Subject, params: &[f64], f: impl Fn(&dyn Subject) -> T) -> T {
    match subject.with_params(params) {
        Some(other) => f(other.as_ref()),
        None => f(subject),
    }
}

/// The parameters that differ from the subject's, in words.
fn changes(subject: &dyn Subject, changed: &[f64]) -> String {
    let own = subject.params();
    let words = subject.info().params.iter().zip(own.iter().zip(changed)).filter(|(_, (a, b))| a != b);
    let words: Vec<_> = words.map(|(info, (_, value))| format!("{} = {value}", info.name)).collect();
    if words.is_empty() { "as it is".to_owned() } else { words.join(", ") }
}

/// A highlight whose light gathers in one direction must do so in the mirror direction.
fn narrow(subject: &dyn Subject) -> Finding {
    let (together, narrowest) = best(subject, GATHERED, |candidate| middle(candidate).0);
    if together < GATHERED {
        return Finding::not_applicable(Law::Limits, NEVER_NARROW);
    }
    let (_, axis) = with(subject, &narrowest, middle);
    let away = libm::acos(axis.dot(direction(VIEW, 180.0)).clamp(-1.0, 1.0)) * 180.0 / PI;
    let changes = changes(subject, &narrowest);
    let detail = format!("{changes}: the middle of its light is {away:.3}° from the mirror direction");
    Finding::judged(Law::Limits, subject.info(), away <= AWAY, away, detail)
}

/// How far all light comes from one direction (the length of the mean direction, 1 if it does), and which.
fn middle(subject: &dyn Subject) -> (f64, Vec3<f64>) {
    let wo = direction(VIEW, 0.0);
    let weights: [Weight<'_>; 4] =
        [&|_| 1.0, &|pair| pair.tangent_i.0, &|pair| pair.tangent_i.1, &|pair| pair.cos_i];
    let moments = moments(subject, wo, &weights);
    let (all, sum) = (moments[0], Vec3::new(moments[1], moments[2], moments[3]));
    let length = sum.dot(sum).sqrt();
    match all > 0.0 && length.is_finite() && length > 0.0 {
        true => (length / all, sum * (1.0 / length)),
        false => (0.0, Vec3::new(0.0, 0.0, 1.0)),
    }
}

/// A diffuse lobe that becomes smooth becomes Lambert's, whatever its albedo.
fn smooth(subject: &dyn Subject) -> Finding {
    let (score, smoothest) = best(subject, -LAMBERT, |candidate| -from_lambert(candidate));
    let away = -score;
    if away > LAMBERT {
        return Finding::not_applicable(Law::Limits, NEVER_LAMBERT);
    }
    let detail = format!("{}: Lambert's", changes(subject, &smoothest));
    Finding::judged(Law::Limits, subject.info(), true, away, detail)
}

/// How far f_cos / cosθi is from being the same everywhere, in parts of it.
fn from_lambert(subject: &dyn Subject) -> f64 {
    let angles = [0.0, 30.0, 60.0, 80.0];
    let (mut low, mut high) = (f64::MAX, 0.0_f64);
    for theta_o in angles {
        for (theta_i, phi) in angles.iter().flat_map(|theta| [0.0, 70.0, 180.0].map(|phi| (*theta, phi))) {
            let wi = direction(theta_i, phi);
            let value = subject.value(&DirectionPair::new(direction(theta_o, 0.0), wi)) / wi.z;
            (low, high) = (low.min(value), high.max(value));
        }
    }
    if high > 0.0 && high.is_finite() { (high - low) / high } else { f64::MAX }
}
