//! The laws that a BSDF has to keep, each a function from a lobe to a verdict with the worst case found.
//!
//! They are written once. [`certify`] asks all of them about one lobe with the parameters that it is used with, for
//! `glanz check`; the tests of this crate ask them about every model of the list over its range of parameters. A
//! law that a model is known to break ([`ModelInfo::exempt`](crate::ModelInfo)) is still judged and still counts as broken,
//! with the reason beside it; the tests ask that such an exemption is needed.
//!
//! | law | what is judged | tolerance |
//! |---|---|---|
//! | reciprocity | f(wo, wi) = f(wi, wo) in `f64` and `f32`; for transmission f/η² with the surface turned over | 1e-12 of the greater in `f64`, 1e-5 in `f32` |
//! | energy | the greatest directional albedo (times η² for refraction), up to 89.999° | 1 + 2e-4, the error of the quadrature |
//! | positivity | f_cos >= 0 in `f64` and `f32`; f_cos = 0 for a delta lobe | exact |
//! | side | f_cos = 0 for light on the other side than [`ModelInfo::side`](crate::ModelInfo::side) | exact |
//! | grazing | f_cos is finite in `f64` and `f32`, for grazing, horizontal and opposite directions as well | exact |
//! | normalization | ∫ D cosθ dω = 1, for microfacet models | 1e-3 |
//! | limits | a highlight that narrows becomes a mirror, a diffuse lobe Lambert's | 1°, 1e-6 |
//! | precision | `f32` against `f64`, allowing for the rounding of the cosines | 2e-5 |
//! | lanes | 16 lanes give the bits of scalar `f32`, at every SIMD level of this machine | exact |
//!
//! The same lobe always gets the same verdicts: no random numbers, no clock, no mathematics of the platform.
//!
//! ```
//! use glanz_bsdf::Shape;
//! use glanz_bsdf::laws::{Law, Verdict, certify};
//!
//! let certificate = certify(&Shape::named("phong", &[("shininess", 8.0)])?);
//! let reciprocity = certificate.finding(Law::Reciprocity);
//! // Phong's highlight of 1975 is not reciprocal, and says so.
//! assert!(matches!(reciprocity.verdict, Verdict::Broken { known: Some(_) }));
//! println!("{certificate}");
//! # Ok::<(), glanz_bsdf::ParamError>(())
//! ```

use glanz_math::Vec3;

mod grid;
mod hemisphere;
mod judges;
mod rounding;
mod subject;
#[cfg(test)]
pub(crate) mod suite;
#[cfg(test)]
mod tests;
mod verdict;

use judges::{energy, lanes, limits, normalization, positivity, precision, reciprocity, side};
pub use subject::{Function, Subject};
pub use verdict::{Certificate, Finding, Law, Verdict};

/// Judges a lobe by one law.
pub fn judge(law: Law, subject: &dyn Subject) -> Finding {
    match law {
        Law::Reciprocity => reciprocity::judge(subject),
        Law::Energy => energy::judge(subject),
        Law::Positivity => positivity::judge(subject),
        Law::Side => side::judge(subject),
        Law::Grazing => positivity::judge_finiteness(subject),
        Law::Normalization => normalization::judge(subject),
        Law::Limits => limits::judge(subject),
        Law::Precision => precision::judge(subject),
        Law::Lanes => lanes::judge(subject),
    }
}

/// Judges a lobe by every law.
pub fn certify(subject: &dyn Subject) -> Certificate {
    let info = subject.info();
    let params = info.params.iter().map(|param| param.name).zip(subject.params()).collect();
    let findings = Law::ALL.iter().map(|law| judge(*law, subject)).collect();
    Certificate { model: info.name, params, findings }
}

/// The directions, to the viewer and to the light, that values of a lobe are judged at: in steps over the whole sphere,
/// ever nearer to the horizon and to the mirror direction, equal and opposite ones among them.
///
/// ```
/// use glanz_bsdf::{DirectionPair, Shape, laws::directions};
///
/// let ward = Shape::named("ward", &[])?;
/// let pairs = directions(&ward).into_iter().map(|[wo, wi]| DirectionPair::new(wo, wi));
/// assert!(pairs.clone().count() > 10_000 && pairs.clone().any(|pair| pair.cos_o < 0.0));
/// assert!(pairs.map(|pair| ward.f_cos(&pair)).all(f64::is_finite));
/// # Ok::<(), glanz_bsdf::ParamError>(())
/// ```
pub fn directions(subject: &dyn Subject) -> Vec<[Vec3<f64>; 2]> {
    grid::places_anywhere(subject).iter().map(|place| [place.wo, place.wi]).collect()
}
