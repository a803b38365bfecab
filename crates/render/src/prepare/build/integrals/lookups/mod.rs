//! Lobes as sums of lookups in the chain of an environment, fitted view by view.
//!
//! Each view begins with the result of its neighbour, the flattest with the best of three guesses. What is made small
//! is the error of the mass of patches that grow with their distance from the middle: light from one window errs as much
//! wherever it is.

mod guess;
mod points;
mod scale;
mod solve;

use glanz_bsdf::{LightTerm, Shape, Side};
use glanz_math::{PI, SimdLevel, Vec3, at_level};

use crate::prepare::data::lookups::{FLATTEST, VIEWS};
use crate::prepare::data::{LobeLookups, Lookup};
use points::Points;
use scale::Scale;
use solve::{Fit, Solution};

/// Lobes narrower than this, in slopes, are seen as their middle.
const NARROWEST: f64 = 0.002;

/// Azimuths of a lobe with a grain, of one quarter.
const AZIMUTHS: usize = 7;

/// Lookups of a round lobe, and the most of one with a grain.
const COUNT: usize = 8;
const MOST: usize = 16;

/// The lookups of a shape that has a width.
pub(crate) fn lookups(shape: &Shape, term: LightTerm) -> LobeLookups {
    let scale = Scale::of(shape, term);
    if scale.slope < NARROWEST {
        let middle = Lookup { direction: [0.0, 0.0, 1.0], place: 0.0, amount: 1.0 };
        return LobeLookups {
            count: 1,
            azimuths: 1,
            quarters: 1,
            lookups: vec![middle; VIEWS],
            cosine: Vec::new(),
            wide: false,
        };
    }
    let grain = scale.grain();
    let count = if shape.is_anisotropic() {
        ((COUNT as f64 * libm::sqrt(grain)) as usize).clamp(COUNT, MOST)
    } else {
        COUNT
    };
    let quarters = if !shape.is_anisotropic() || is_symmetric(shape) { 1 } else { 4 };
    let azimuths = if shape.is_anisotropic() { (AZIMUTHS - 1) * quarters + 1 } else { 1 };
    let (mut lookups, mut cosine) = (Vec::new(), Vec::new());
    let mut before: Option<Vec<Solution>> = None;
    for azimuth in 0..azimuths {
        let phi = azimuth as f64 * 0.5 * PI / (AZIMUTHS - 1) as f64;
        let solutions = views(shape, &scale, phi, count, before.as_deref());
        for (_, (own, rest)) in &solutions {
            lookups.extend(own);
            cosine.extend(*rest);
        }
        before = Some(solutions.into_iter().map(|(solution, _)| solution).collect());
    }
    LobeLookups { count, azimuths, quarters, lookups, cosine, wide: scale.wide }
}

/// The angle of a view.
fn angle(i: usize) -> f64 {
    FLATTEST * i as f64 / (VIEWS - 1) as f64
}

/// The result of a view, and what is kept of it.
type View = (Solution, (Vec<Lookup>, Option<f32>));

/// The results of all views at an azimuth, from the steepest.
fn views(shape: &Shape, scale: &Scale, phi: f64, count: usize, before: Option<&[Solution]>) -> Vec<View> {
    let mut solutions: Vec<View> = Vec::with_capacity(VIEWS);
    for i in (0..VIEWS).rev() {
        let points = Points::of(shape, scale, Vec3::from_angles(angle(i), phi));
        let mut fit = Fit::new(&points, scale, count);
        let start = before.map(|before| &before[i]).or(solutions.last().map(|(solution, _)| solution));
        let solution = match start {
            Some(start) => fit.from(start),
            None => fit.from_guesses(guess::guesses(&points, scale, count)),
        };
        let kept = fit.normalized(&solution);
        solutions.push((solution, kept));
    }
    solutions.reverse();
    solutions
}

/// Whether a lobe is the same on both sides of both of its axes: tried at a few pairs.
fn is_symmetric(shape: &Shape) -> bool {
    let below = if shape.info().side == Side::Transmission { -1.0 } else { 1.0 };
    let tried = [(0.3, 0.4, 0.5, 2.0), (0.9, 1.9, 0.8, -1.2), (1.2, 3.0, 1.1, 0.4), (0.6, -2.0, 0.2, 1.0)];
    tried.into_iter().all(|(theta_o, phi_o, theta_i, phi_i)| {
        let value = |x: f64, y: f64| {
            let (o, i) = (Vec3::from_angles(theta_o, phi_o), Vec3::from_angles(theta_i, phi_i));
            let turned = |v: Vec3<f64>, side: f64| Vec3::new(v.x * x, v.y * y, v.z * side);
            shape.f_cos(&glanz_bsdf::DirectionPair::new(turned(o, 1.0), turned(i, below)))
        };
        let (own, scale) = (value(1.0, 1.0), 1e-9);
        [value(-1.0, 1.0), value(1.0, -1.0)].iter().all(|other| (other - own).abs() <= scale * own.abs().max(1e-9))
    })
}

/// Runs at the best level of this machine; the bits are the same at each.
fn evaluate(fit: &mut Fit, x: &[f64]) -> f64 {
    at_level!(SimdLevel::best(), simd => fit.evaluate(simd, x))
}

/// The same for the products of derivatives.
fn products(fit: &Fit) -> (Vec<f64>, Vec<f64>) {
    at_level!(SimdLevel::best(), simd => fit.products(simd))
}
