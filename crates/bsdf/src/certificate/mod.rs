//! The health certificate of a shape: which laws it keeps, how well, and where it keeps them worst.
//!
//! The conformance tests of this crate hold every model to the laws it claims, over its whole range of
//! parameters. The certificate is for users: it looks at one shape with the parameters that it is used with,
//! and tells numbers. A law that the model is known to break (`ModelInfo::exempt`) is still looked at, and
//! still counts as broken: the reason is given beside it.
//!
//! | check | what is looked at | holds within |
//! |---|---|---|
//! | reciprocity | f(wo, wi) = f(wi, wo), in `f64`; from below with the surface turned over | 1e-9 of the greater, 1e-6 where light is bent |
//! | energy | the greatest directional albedo (times η² where light is bent), up to 89.999° | 1 + 2e-4, what quadrature may add |
//! | positivity | f_cos >= 0, and 0 where the light is on the wrong side | exactly |
//! | grazing | finite in `f64` and `f32` up to 89.999° | exactly |
//! | normalization | ∫ D cosθ dω = 1, for models of facets | 1e-3 |
//! | limits | a highlight that narrows becomes a mirror, a matte surface Lambert's | 1° |
//! | precision | `f32` against `f64`, allowing for the rounding of cosines | 1e-4 |
//!
//! The same shape always gets the same certificate: no random numbers, no clock, no platform's mathematics.

mod directional;
mod energy;
mod grid;
mod limits;
mod normalization;
mod precision;
mod reciprocity;
mod report;
mod subject;
#[cfg(test)]
mod tests;
mod values;

pub use report::{Certificate, Check, Finding, Verdict};

use subject::Subject;

use crate::Shape;

/// Looks at a shape under every check.
pub fn certify(shape: &Shape) -> Certificate {
    certify_subject(shape)
}

fn certify_subject(subject: &dyn Subject) -> Certificate {
    let info = subject.info();
    let findings = vec![
        reciprocity::check(subject),
        energy::check(subject),
        values::positivity(subject),
        values::grazing(subject),
        normalization::check(subject),
        limits::check(subject),
        precision::check(subject),
    ];
    let params = info.params.iter().map(|param| param.name).zip(subject.params()).collect();
    Certificate { model: info.name, params, findings }
}
