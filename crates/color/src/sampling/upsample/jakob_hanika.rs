//! Smooth reflectances from three coefficients.

use super::{STEP_NM, weights};
use crate::algebra::solve;
use crate::lights::light;
use crate::models::LinearSrgb;
use crate::spectra::Spectrum;

/// The reflectance S(λ) = ½ + U / (2 √(1 + U²)), where U is a parabola over wavelength.
///
/// **Formula.** Jakob and Hanika, "A Low-Dimensional Function Space for Efficient Spectral Upsampling",
/// Computer Graphics Forum 38(2), 2019, eq. 3. Always between 0 and 1 and smooth; three coefficients reach
/// every colour that surfaces can have. The coefficients are solved for the colour at hand, not
/// interpolated from a table, with this crate's observer and D65.
///
/// **Round trip.** Within 1e-6 in linear RGB over the sRGB cube (tested). Greys are constants, white is
/// exactly 1 and black 0.
///
/// **Ultraviolet.** The paper's spectra begin at 360 nm, and what eyes see says nothing of the reflectance below
/// 380 nm. There the wavelength that enters the parabola levels out smoothly towards 360 nm, so S goes on
/// without a kink and without the parabola's growth.
///
/// **Colours brighter than 1** are no reflectances; they are taken as a scale times one: the scale is twice
/// the greatest component, which keeps the spectrum smooth (as lights in Pharr, Jakob, Humphreys 2023).
/// Negative components are outside of the sRGB gamut and refused.
///
/// **Cost.** About 0.1 ms a colour, up to some 10 ms next to black and white.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JakobHanika {
    /// The parabola: c₀ + c₁ t + c₂ t², t = (λ − 570 nm) / 210 nm.
    pub coefficients: [f64; 3],
    /// What S is multiplied by; 1 for reflectances.
    pub scale: f64,
}

/// Why a colour has no spectrum.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum UpsampleError {
    /// Outside of the gamut, or no number.
    #[error("expected linear sRGB of finite components of at least 0, found {0:?}")]
    OutOfGamut([f64; 3]),
    /// The solver did not come near enough.
    #[error("no smooth reflectance found for linear sRGB {rgb:?}: the nearest misses it by {miss:e}")]
    NotFound {
        /// The colour.
        rgb: [f64; 3],
        /// The greatest difference of a component.
        miss: f64,
    },
}

/// How near the solver must come in linear RGB.
const NEAR: f64 = 1e-7;

/// What is near enough where it comes no nearer.
const NEAR_ENOUGH: f64 = 1e-6;

/// A U of this size is 0 or 1 to rounding; larger coefficients change nothing.
const SATURATED: f64 = 1e9;

impl JakobHanika {
    /// The spectrum of a colour.
    ///
    /// # Errors
    ///
    /// Negative or not finite components.
    pub fn fit(LinearSrgb(rgb): LinearSrgb) -> Result<Self, UpsampleError> {
        let most = rgb.into_iter().fold(0.0, f64::max);
        let possible = rgb.iter().all(|c| c.is_finite() && *c >= 0.0);
        if !possible || !(2.0 * most).is_finite() {
            return Err(UpsampleError::OutOfGamut(rgb));
        }
        let scale = if most > 1.0 { 2.0 * most } else { 1.0 };
        let coefficients = coefficients(rgb.map(|c| c / scale))?;
        Ok(Self { coefficients, scale })
    }

    /// The value at a wavelength in nm.
    pub fn at(&self, nm: f64) -> f64 {
        let t = parameter(nm);
        let [c0, c1, c2] = self.coefficients;
        self.scale * sigmoid(c0 + t * (c1 + t * c2))
    }

    /// The reflectance on the grid; more than 1 where [`scale`](Self::scale) is.
    pub fn spectrum(&self) -> Spectrum {
        Spectrum::from_fn(|nm| self.at(nm))
    }

    /// The colour as that of a light: the reflectance's colour under D65, so RGB 1, 1, 1 is D65 on the scale
    /// of [`light`]`("D65")`.
    pub fn light(&self) -> Spectrum {
        self.spectrum() * light("D65").expect("D65 comes with this crate")
    }
}

/// t of a wavelength in nm: −1 … 1 for 360 … 780 nm, levelling out below 380 nm.
fn parameter(nm: f64) -> f64 {
    const LEVEL_FROM_NM: f64 = 380.0;
    const LEVEL_TO_NM: f64 = 360.0;
    const REACH: f64 = LEVEL_FROM_NM - LEVEL_TO_NM;
    let below = LEVEL_FROM_NM - nm;
    let nm = if below <= 0.0 { nm } else { LEVEL_TO_NM + REACH * libm::exp(-below / REACH) };
    (nm - 570.0) / 210.0
}

fn sigmoid(u: f64) -> f64 {
    0.5 + 0.5 * u / (1.0 + u * u).sqrt()
}

/// The U of a constant reflectance.
fn logit(reflectance: f64) -> f64 {
    let root = (reflectance * (1.0 - reflectance)).sqrt();
    ((reflectance - 0.5) / root).clamp(-SATURATED, SATURATED)
}

/// The coefficients of a colour of the cube.
///
/// A path from the grey of the same mean to the colour: each point is solved from the one before, steps
/// are halved where that fails. Gauss–Newton from afar would run into the flat ends of the sigmoid.
fn coefficients(rgb: [f64; 3]) -> Result<[f64; 3], UpsampleError> {
    let grey = rgb.iter().sum::<f64>() / 3.0;
    if rgb.iter().all(|c| *c == rgb[0]) {
        return Ok([logit(rgb[0]), 0.0, 0.0]);
    }
    let target = |along: f64| rgb.map(|c| grey + along * (c - grey));
    let (mut found, mut along, mut step) = ([logit(grey), 0.0, 0.0], 0.0, 0.25);
    while along < 1.0 {
        let next = f64::min(along + step, 1.0);
        let (solved, miss) = solve_from(found, target(next));
        if miss <= NEAR || (next == 1.0 && step < SMALLEST_STEP && miss <= NEAR_ENOUGH) {
            (found, along) = (solved, next);
            step *= 2.0;
        } else if step < SMALLEST_STEP {
            return Err(UpsampleError::NotFound { rgb, miss });
        } else {
            step *= 0.5;
        }
    }
    Ok(found)
}

/// Below this part of the path the solver gives up.
const SMALLEST_STEP: f64 = 1e-4;

/// Levenberg and Marquardt's damped Gauss–Newton from a starting point: coefficients and how far, at most,
/// a component then is from the target.
fn solve_from(mut c: [f64; 3], target: [f64; 3]) -> ([f64; 3], f64) {
    const TURNS: usize = 40;
    let mut damping = 1e-6;
    let mut now = Residual::at(c, target);
    for _ in 0..TURNS {
        if now.greatest() <= NEAR {
            break;
        }
        let next = now.step(damping).map(|step| core::array::from_fn(|i| c[i] - step[i]));
        let tried = next.map(|next: [f64; 3]| (next, Residual::at(next, target)));
        match tried {
            Some((next, tried)) if tried.squares() < now.squares() => {
                (c, now) = (next, tried);
                damping *= 0.1;
            }
            _ => damping *= 10.0,
        }
    }
    (c, now.greatest())
}

/// How far the colour of some coefficients is from the target, and how it changes with them.
struct Residual {
    miss: [f64; 3],
    jacobian: [[f64; 3]; 3],
}

impl Residual {
    fn at([c0, c1, c2]: [f64; 3], target: [f64; 3]) -> Self {
        let mut found = Self { miss: target.map(|t| -t), jacobian: [[0.0; 3]; 3] };
        for (i, (nm, _)) in Spectrum::ZERO.points().enumerate() {
            let t = parameter(nm);
            let u = c0 + t * (c1 + t * c2);
            let root = (1.0 + u * u).sqrt();
            let (value, slope) = (0.5 + 0.5 * u / root, 0.5 / (root * root * root));
            for (channel, weight) in weights().iter().enumerate() {
                let weight = weight[i] * STEP_NM;
                found.miss[channel] += weight * value;
                let by = weight * slope;
                for (entry, power) in found.jacobian[channel].iter_mut().zip([1.0, t, t * t]) {
                    *entry += by * power;
                }
            }
        }
        found
    }

    fn squares(&self) -> f64 {
        self.miss.iter().map(|m| m * m).sum()
    }

    fn greatest(&self) -> f64 {
        self.miss.iter().fold(0.0, |most, m| f64::max(most, m.abs()))
    }

    /// (JᵀJ + damping · diag JᵀJ) step = Jᵀ miss.
    fn step(&self, damping: f64) -> Option<[f64; 3]> {
        let j = &self.jacobian;
        let product = |a: usize, b: usize| (0..3).map(|k| j[k][a] * j[k][b]).sum::<f64>();
        let matrix = core::array::from_fn(|a| {
            core::array::from_fn(|b| product(a, b) * if a == b { 1.0 + damping } else { 1.0 })
        });
        let right = core::array::from_fn(|a| (0..3).map(|k| j[k][a] * self.miss[k]).sum());
        solve(matrix, right).filter(|step| step.iter().all(|s| s.is_finite()))
    }
}
