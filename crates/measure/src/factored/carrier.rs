//! The model that measured reflectance is a table of factors over.

use glanz_bsdf::{DirectionPair, Shape};
use glanz_math::Vec3;
use rstar::{PointDistance, RTree};

use super::HOLE;
use super::smooth::{Isotropic, Place};
use crate::{Fit, FitError, FitOptions, Readings, fit};

/// Candidates, the simplest first.
const CANDIDATES: [&[&str]; 2] = [&["ggx:iso", "lambert"], &["ggx:iso", "ggx:iso", "lambert"]];

/// Highlights with a grain, of which the one that fits best is taken.
const GRAINED: [&str; 3] = ["ggx:aniso", "beckmann:aniso", "ward:aniso"];

/// More lobes are taken where they leave no more than this part of the error.
const WORTH: f64 = 0.85;

/// A matte part of at least this much of the median reading keeps quotients finite far from the highlight.
const LEAST_MATTE: f64 = 0.05;

/// But, where readings are not all over the hemisphere, of no more than this much of what is read there: instruments read most
/// where it is bright, so that the median may be many times the matte part, which would be drawn wherever nothing was read.
const MOST_OF_DARK: f64 = 0.5;

/// The part of the readings that are no brighter than those far from the highlight.
const FAR_FROM_HIGHLIGHT: f64 = 0.05;

/// Pairs of directions that are looked at for whether there are readings near them.
const PROBES: usize = 256;

/// A lobe counts where its tint is at least this part of the greatest one.
const LEAST_TINT: f64 = 1e-4;

/// Nearer to the horizon products with the cosine are divided by this one.
const LEAST_COSINE: f64 = 0.01;

/// So near to a multiple of a quarter turn, in quarters, a grain runs along an axis, and nothing is turned.
const ALIGNED: f64 = 0.02;

/// A sum of lobes, each with a tint for each channel.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Carrier {
    pub(super) lobes: Vec<(Shape, Vec<f64>)>,
}

impl Carrier {
    /// The one that fits the readings best, of few candidates.
    pub(super) fn fitted(readings: &Readings) -> Result<Self, FitError> {
        let options = FitOptions { most_readings: 6000, ..FitOptions::default() };
        let mut best = fit(readings, CANDIDATES[0], &options)?;
        for candidate in &CANDIDATES[1..] {
            // Too few readings for more lobes are no reason to have none.
            if let Ok(found) = fit(readings, candidate, &options)
                && found.error < WORTH * best.error
            {
                best = found;
            }
        }
        Ok(Self::of(best, readings))
    }

    /// One with a grain along x or y, and the azimuth in radians that its x axis has in the readings' frame; none where nothing
    /// can be fitted.
    pub(super) fn grained(readings: &Readings) -> Option<(Self, f64)> {
        let options = FitOptions { most_readings: 6000, ..FitOptions::default() };
        // Few readings tell a grain of much: the better the model, the less is left to them.
        let fits = GRAINED.iter().filter_map(|model| fit(readings, &[model, "lambert"], &options).ok());
        let mut found = fits.min_by(|a, b| a.error.total_cmp(&b.error))?;
        let azimuth_deg = found.aniso_deg?;
        let quarters = azimuth_deg / 90.0;
        if (quarters - libm::round(quarters)).abs() > ALIGNED {
            return Some((Self::of(found, readings), azimuth_deg.to_radians()));
        }
        if libm::round(quarters) as i64 % 2 != 0 {
            for lobe in found.lobes.iter_mut().filter(|lobe| lobe.shape.info().anisotropic) {
                let [x, y] = ["alpha", "alpha_y"].map(|name| lobe.shape.get(name));
                lobe.shape = lobe.shape.with("alpha", y?).ok()?.with("alpha_y", x?).ok()?;
            }
        }
        Some((Self::of(found, readings), 0.0))
    }

    fn of(fit: Fit, readings: &Readings) -> Self {
        let mut lobes: Vec<_> = fit.lobes.into_iter().map(|lobe| (lobe.shape, lobe.tint)).collect();
        let least = least_values(readings).into_iter().map(|value| value * core::f64::consts::PI);
        // Every candidate ends with its matte lobe.
        if let Some((_, matte)) = lobes.last_mut() {
            matte.iter_mut().zip(least).for_each(|(tint, least)| *tint = tint.max(least));
        }
        let most = |tint: &[f64]| tint.iter().fold(0.0, |most: f64, x| most.max(*x));
        let greatest = lobes.iter().map(|(_, tint)| most(tint)).fold(0.0, f64::max);
        lobes.retain(|(_, tint)| most(tint) > LEAST_TINT * greatest);
        Self { lobes }
    }

    /// Its BRDF, in 1/sr, of each channel.
    pub(super) fn values(&self, wi: Vec3<f64>, wo: Vec3<f64>) -> Vec<f64> {
        let (cos_i, above) = (wi.z.max(LEAST_COSINE), raised(wi));
        let pair = DirectionPair::new(raised(wo), above);
        let channels = self.lobes.first().map_or(0, |(_, tint)| tint.len());
        let mut values = vec![0.0; channels];
        for (shape, tint) in &self.lobes {
            let value = shape.f_cos(&pair) / cos_i;
            values.iter_mut().zip(tint).for_each(|(sum, tint)| *sum += value * tint);
        }
        values
    }
}

/// A direction that is a little above the horizon where it was not.
fn raised(w: Vec3<f64>) -> Vec3<f64> {
    if w.z >= LEAST_COSINE { w } else { Vec3::new(w.x, w.y, LEAST_COSINE).normalized() }
}

/// What a matte part is at least, in 1/sr, of each channel; readings count that are above 0.
fn least_values(readings: &Readings) -> Vec<f64> {
    let is_covered = cover(readings);
    let of = |c: usize| {
        let values = (0..readings.len()).map(|i| f64::from(readings.values(i)[c]));
        let mut values: Vec<f64> = values.filter(|value| *value > 0.0).collect();
        values.sort_by(f64::total_cmp);
        let at = |part: f64| values.get((values.len() as f64 * part) as usize).copied().unwrap_or(0.0);
        let most = if is_covered { f64::MAX } else { MOST_OF_DARK * at(FAR_FROM_HIGHLIGHT) };
        (LEAST_MATTE * at(0.5)).min(most)
    };
    (0..readings.channels().count()).map(of).collect()
}

/// Whether there are readings near all pairs of directions.
fn cover(readings: &Readings) -> bool {
    let place = |[wi, wo]: [Vec3<f64>; 2]| <Isotropic as Place>::of(wi, wo);
    let tree = RTree::bulk_load((0..readings.len()).map(|i| place(readings.pair(i))).collect());
    let is_far = |number: &usize| {
        let place = place(probe(*number));
        tree.nearest_neighbor(&place).is_none_or(|near| near.distance_2(&place) > HOLE * HOLE)
    };
    (0..PROBES).filter(is_far).count() * 10 < PROBES
}

/// One of a sequence of pairs of directions that fills the cap up to 75° from the normal evenly (M. Roberts, The Unreasonable
/// Effectiveness of Quasirandom Sequences, 2018: powers of the root of x⁴ = x + 1, one azimuth being enough).
fn probe(number: usize) -> [Vec3<f64>; 2] {
    const ROOT: f64 = 1.220_744_084_605_759_5;
    let part = |power: i32| (0.5 + (number as f64 + 1.0) * libm::pow(ROOT, -f64::from(power))).fract();
    let theta = |part: f64| libm::acos(1.0 - part * (1.0 - libm::cos(75.0_f64.to_radians())));
    let azimuth = core::f64::consts::TAU * part(3);
    [Vec3::from_angles(theta(part(1)), 0.0), Vec3::from_angles(theta(part(2)), azimuth)]
}
