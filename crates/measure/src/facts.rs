//! What data say of themselves.

use core::f64::consts::{PI, TAU};

use glanz_math::Vec3;

use crate::{Measured, Quantity, Readings};

/// Angles of the light from the normal for which albedos and reciprocity are looked at, in degrees.
const ANGLES: [f64; 6] = [5.0, 20.0, 35.0, 50.0, 65.0, 80.0];
/// Steps of the cosine's square and of the azimuth in an integral over the detector.
const STEPS: [usize; 2] = [96, 192];

/// What data say of themselves.
#[derive(Clone, Debug, PartialEq)]
pub struct Facts {
    /// How many readings, or nodes of a table above the horizon, there are.
    pub readings: usize,
    /// How many different directions to the light there are, to a hundredth of a degree.
    pub lights: usize,
    /// The least and greatest angle of the light from the normal, in degrees.
    pub theta_i_deg: [f64; 2],
    /// The same of the detector.
    pub theta_o_deg: [f64; 2],
    /// How many values are missing.
    pub missing: usize,
    /// How many values are below 0.
    pub negative: usize,
    /// The least and greatest value of the BRDF, in 1/sr.
    pub range: [f64; 2],
    /// Of tables: the part of the light that is reflected.
    pub albedos: Vec<Albedo>,
    /// Of tables: whether light and detector may change places.
    pub reciprocity: Option<Reciprocity>,
    /// What the numbers of the file probably are, and why, where that is not what they were read as.
    pub guess: Option<(Quantity, String)>,
}

/// The directional albedo for one direction of the light: the integral of f times the cosine over all detectors.
#[derive(Clone, Debug, PartialEq)]
pub struct Albedo {
    /// The angle of the light from the normal in degrees, its azimuth being 180°.
    pub theta_i_deg: f64,
    /// The albedo of each channel.
    pub values: Vec<f64>,
    /// The part of the hemisphere of detectors, by its cosine, for which there are data.
    pub known: f64,
}

/// How far f(a, b) and f(b, a) are from each other, as parts of their mean.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reciprocity {
    /// The median of all pairs of directions.
    pub median: f64,
    /// What 95 of 100 pairs stay below.
    pub most: f64,
}

impl Facts {
    /// The facts of a file.
    ///
    /// ```
    /// use glanz_measure::{Facts, Measured};
    ///
    /// let rows = "theta_i_deg,phi_i_deg,theta_o_deg,phi_o_deg,Y\n45,180,0,0,0.29\n45,180,30,90,0.28\n0,0,60,0,0.27\n";
    /// let facts = Facts::of(&Measured::read(rows.as_bytes(), "tile.csv", &Default::default())?);
    /// assert_eq!((facts.readings, facts.lights), (3, 2));
    /// # Ok::<(), glanz_measure::ReadError>(())
    /// ```
    pub fn of(measured: &Measured) -> Self {
        let readings = measured.readings();
        let albedos: Vec<Albedo> = ANGLES.iter().filter_map(|theta| albedo(measured, *theta)).collect();
        let mut facts = Self::of_readings(&readings);
        facts.reciprocity = reciprocity(measured);
        facts.guess = guess(&readings, &albedos, measured.quantity);
        facts.albedos = albedos;
        facts
    }

    fn of_readings(readings: &Readings) -> Self {
        let nothing = [f64::INFINITY, f64::NEG_INFINITY];
        let wider = |range: [f64; 2], x: f64| [range[0].min(x), range[1].max(x)];
        let (mut theta_i, mut theta_o, mut range) = (nothing, nothing, nothing);
        let (mut missing, mut negative) = (0, 0);
        let mut lights = std::collections::BTreeSet::new();
        for index in 0..readings.len() {
            let [wi, wo] = readings.pair(index);
            theta_i = wider(theta_i, theta(wi));
            theta_o = wider(theta_o, theta(wo));
            let round = |x: f64| (x * 6000.0).round() as i64;
            lights.insert([round(wi.x), round(wi.y)]);
            for value in readings.values(index) {
                match value.is_finite() {
                    true => range = wider(range, f64::from(*value)),
                    false => missing += 1,
                }
                negative += usize::from(*value < 0.0);
            }
        }
        Self {
            readings: readings.len(),
            lights: lights.len(),
            theta_i_deg: theta_i,
            theta_o_deg: theta_o,
            missing,
            negative,
            range,
            albedos: Vec::new(),
            reciprocity: None,
            guess: None,
        }
    }
}

/// Degrees from the normal.
fn theta(w: Vec3<f64>) -> f64 {
    libm::atan2(libm::sqrt(w.x * w.x + w.y * w.y), w.z).to_degrees()
}

fn albedo(measured: &Measured, theta_i_deg: f64) -> Option<Albedo> {
    let wi = Vec3::from_angles(theta_i_deg.to_radians(), PI);
    let count = measured.channels().count();
    let (values, known) = reflected(wi, count, &|wi, wo| measured.value(wi, wo));
    (known > 0.0).then_some(Albedo { theta_i_deg, values, known })
}

/// A BRDF, one number per channel, where it is known.
type Known<'a> = &'a dyn Fn(Vec3<f64>, Vec3<f64>) -> Option<Vec<f64>>;

/// The part of light from a direction that is reflected, for each channel, and the part of the hemisphere of detectors, by
/// its cosine, where that is known. The nodes lie densely about the mirror direction, where glossy surfaces have their
/// light: those of half vectors, each counted by the solid angle of its detector.
pub(crate) fn reflected(wi: Vec3<f64>, count: usize, f: Known) -> (Vec<f64>, f64) {
    let mut values = vec![0.0; count];
    let (mut known, mut all) = (0.0, 0.0);
    for a in 0..STEPS[0] {
        // θh grows with the square of the step, so that the middle of a highlight has most of them.
        let u = (a as f64 + 0.5) / STEPS[0] as f64;
        let theta_h = u * u * PI / 2.0;
        let width = PI * u / STEPS[0] as f64;
        for b in 0..STEPS[1] {
            let half = Vec3::from_angles(theta_h, (b as f64 + 0.5) * TAU / STEPS[1] as f64);
            let along = wi.dot(half);
            let wo = half * (2.0 * along) - wi;
            if along <= 0.0 || wo.z <= 0.0 {
                continue;
            }
            // dωo = 4 (wi·h) dωh.
            let solid = 4.0 * along * libm::sin(theta_h) * width * TAU / STEPS[1] as f64;
            all += wo.z * solid;
            if let Some(value) = f(wi, wo) {
                known += wo.z * solid;
                values.iter_mut().zip(value).for_each(|(sum, f)| *sum += f * wo.z * solid);
            }
        }
    }
    (values, if all > 0.0 { known / all } else { 0.0 })
}

fn reciprocity(measured: &Measured) -> Option<Reciprocity> {
    let mut parts = Vec::new();
    for theta_i in ANGLES {
        for theta_o in ANGLES {
            for phi in [0.0, 45.0, 90.0, 135.0, 170.0] {
                let at = |theta: f64, phi: f64| Vec3::from_angles(theta.to_radians(), f64::to_radians(phi));
                let (a, b) = (at(theta_i, 0.0), at(theta_o, phi));
                let (Some(one), Some(other)) = (measured.value(a, b), measured.value(b, a)) else { continue };
                let sum = |values: &[f64]| values.iter().sum::<f64>();
                let (one, other) = (sum(&one), sum(&other));
                if one + other > 0.0 && theta_i != theta_o {
                    parts.push(2.0 * (one - other).abs() / (one + other));
                }
            }
        }
    }
    parts.sort_by(f64::total_cmp);
    let at = |part: f64| parts.get((part * (parts.len().saturating_sub(1)) as f64) as usize).copied();
    Some(Reciprocity { median: at(0.5)?, most: at(0.95)? })
}

/// What the numbers probably are.
fn guess(readings: &Readings, albedos: &[Albedo], read_as: Quantity) -> Option<(Quantity, String)> {
    let matte = matte_albedo(readings).unwrap_or(0.0);
    let most = albedos.iter().filter(|own| own.known > 0.6).flat_map(|own| &own.values).copied();
    let most = most.fold(matte, f64::max);
    if read_as == Quantity::Brdf && most > 1.3 {
        let why = format!("as BRDF they reflect up to {most:.2} of the light, which is more than there is");
        return Some((Quantity::RadianceFactor, why));
    }
    let (near, far) = (mean(readings, [15.0, 45.0])?, mean(readings, [70.0, 82.0])?);
    // The mean of cosines over the second range is a quarter of that over the first.
    if read_as == Quantity::Brdf && far < 0.42 * near && far > 0.15 * near {
        let why = "towards the horizon they fall off as the detector's cosine".to_owned();
        return Some((Quantity::BrdfCos, why));
    }
    None
}

/// The cosine of the angle between the detector and the mirror direction.
fn mirrored(wi: Vec3<f64>, wo: Vec3<f64>) -> f64 {
    Vec3::new(-wi.x, -wi.y, wi.z).dot(wo)
}

/// What lies farther from the mirror direction than by this cosine is away from it.
const AWAY: f64 = 0.75;

/// About the albedo of the matte part of readings, from their medians in rings of the detector's angle, which highlights do
/// not count in. Nothing where fewer than six of the eight rings have readings.
fn matte_albedo(readings: &Readings) -> Option<f64> {
    let mut rings: [Vec<f64>; 8] = Default::default();
    for index in 0..readings.len() {
        let [wi, wo] = readings.pair(index);
        let value = readings.values(index).iter().copied().fold(f32::NAN, f32::max);
        if theta(wi) >= 60.0 || mirrored(wi, wo) > AWAY || !value.is_finite() {
            continue;
        }
        if let Some(ring) = rings.get_mut((theta(wo) / 10.0) as usize) {
            ring.push(f64::from(value));
        }
    }
    let (mut sum, mut known) = (0.0, 0.0);
    for (number, ring) in rings.iter_mut().enumerate().filter(|(_, ring)| ring.len() >= 5) {
        ring.sort_by(f64::total_cmp);
        let [low, high] = [number, number + 1].map(|n| libm::sin((10.0 * n as f64).to_radians()));
        let share = high * high - low * low;
        sum += ring[ring.len() / 2] * share;
        known += share;
    }
    let count = rings.iter().filter(|ring| ring.len() >= 5).count();
    (count >= 6).then(|| PI * sum / known)
}

/// The mean of values away from the mirror direction, whose detectors lie in a range of angles; the light is within 60° of
/// the normal. Nothing of fewer than eight.
fn mean(readings: &Readings, range: [f64; 2]) -> Option<f64> {
    let (mut sum, mut count) = (0.0, 0);
    for index in 0..readings.len() {
        let [wi, wo] = readings.pair(index);
        let value = f64::from(readings.values(index)[0]);
        if theta(wi) < 60.0
            && mirrored(wi, wo) < AWAY
            && (range[0]..range[1]).contains(&theta(wo))
            && value.is_finite()
        {
            (sum, count) = (sum + value, count + 1);
        }
    }
    (count >= 8).then(|| sum / f64::from(count))
}
