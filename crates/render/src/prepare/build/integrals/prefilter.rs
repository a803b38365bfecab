//! An environment as a lobe sees it: blurred by its shape.
//!
//! For each direction, the mean of the environment weighted with the lobe as it is for a viewer straight above. The
//! pixel loop takes it in the lobe's mean direction and multiplies it with the lobe's albedo, both for the true
//! view angle. That keeps the energy for every angle and is exact in a uniform environment and for viewers above;
//! the lobe's stretching towards grazing views is left out, as in B. Karis, "Real Shading in Unreal Engine 4",
//! SIGGRAPH course, 2013, from which the separation comes. `tests/lighting` states the error.

use std::sync::Arc;

use glam::DVec3;
use glanz_bsdf::{DirectionPair, Shape, Side};
use glanz_math::{GaussLegendre, PI, Vec3};

use crate::prepare::data::environment_map::EnvironmentMap;

/// Fraction of a lobe that is left out where it is faintest.
const LEFT_OUT: f64 = 0.003;

/// Pixels of the environment from the inner to the outer edge of each ring around the middle, at least: the further
/// out, the coarser the level that is looked at.
const ACROSS: f64 = 6.0;

/// Pixels of the result from the middle of a lobe to where half of it is.
const ACROSS_RESULT: f64 = 4.0;

/// The most rows of the result.
const ROWS: f64 = 160.0;

/// Azimuths over which lobes that know a tangent are averaged.
const AZIMUTHS: usize = 8;

/// Steps of the angle in which a lobe is taken, and of the table that is made of it.
const STEPS: usize = 400;
const ENTRIES: usize = 2048;

/// A lobe's weight over the angle from its middle.
struct Profile {
    /// Over the sine of half the angle, from 0 to `end`.
    table: Vec<f64>,
    /// The angle within which half of it is, and the one at which it ends.
    core: f64,
    end: f64,
}

impl Profile {
    fn of(shape: &Shape) -> Self {
        let angle = |i: usize| PI / 2.0 * libm::pow(i as f64 / STEPS as f64, 3.0);
        let weights: Vec<f64> = (0..=STEPS).map(|i| around(shape, angle(i))).collect();
        let ring = |i: usize| {
            let (a, b) = (angle(i), angle(i + 1));
            (weights[i] * libm::sin(a) + weights[i + 1] * libm::sin(b)) * (b - a)
        };
        let total: f64 = (0..STEPS).map(ring).sum();
        let holds = |fraction: f64| {
            let (mut sum, mut last) = (0.0, 1);
            while last < STEPS && sum < total * fraction {
                sum += ring(last - 1);
                last += 1;
            }
            angle(last)
        };
        let (core, end) = (holds(0.5), holds(1.0 - LEFT_OUT));
        let longest = libm::sin(0.5 * end);
        let entry = |i: usize| around(shape, 2.0 * libm::asin(longest * i as f64 / ENTRIES as f64));
        Self { table: (0..=ENTRIES).map(entry).collect(), core, end }
    }

    /// How much of the lobe is between two angles.
    fn fraction(&self, from: f64, to: f64) -> f64 {
        let rule = GaussLegendre::new(16);
        rule.integrate(from, to, |angle| self.at(libm::cos(angle)) * libm::sin(angle))
    }

    /// The weight at an angle of this cosine.
    fn at(&self, cosine: f64) -> f64 {
        let longest = libm::sin(0.5 * self.end);
        let place = libm::sqrt((0.5 * (1.0 - cosine)).max(0.0)) / longest * ENTRIES as f64;
        let whole = place as usize;
        match self.table.get(whole..whole + 2) {
            Some(pair) => pair[0] + (pair[1] - pair[0]) * (place - whole as f64),
            None => 0.0,
        }
    }
}

/// A lobe for a viewer straight above, at an angle from the mirrored or the straight direction.
fn around(shape: &Shape, angle: f64) -> f64 {
    let count = if shape.is_anisotropic() { AZIMUTHS } else { 1 };
    let sign = if shape.info().side == Side::Transmission { -1.0 } else { 1.0 };
    let value = |i: usize| {
        let w = Vec3::from_angles(angle, 2.0 * PI * i as f64 / AZIMUTHS as f64);
        shape.f_cos(&DirectionPair::new(Vec3::new(0.0, 0.0, 1.0), Vec3::new(w.x, w.y, sign * w.z)))
    };
    (0..count).map(value).sum::<f64>() / count as f64
}

/// A ring around the middle of a lobe, and the level of the environment that it looks at.
struct Ring<'a> {
    from: f64,
    to: f64,
    /// How much of the lobe is in it.
    fraction: f64,
    level: &'a PyramidLevel,
}

/// The environment at all levels, each half as fine as the one before.
pub(crate) struct Pyramid(Vec<PyramidLevel>);

impl Pyramid {
    pub(crate) fn of(map: &Arc<EnvironmentMap>) -> Self {
        let mut levels = vec![PyramidLevel::of(Arc::clone(map))];
        while let Some(last) = levels.last().filter(|level| level.map.size()[1] > 16) {
            let next = PyramidLevel::of(Arc::new(last.map.halved()));
            levels.push(next);
        }
        Self(levels)
    }
}

/// The environment, more or less coarse, with the directions of its pixels by rows and columns.
struct PyramidLevel {
    map: Arc<EnvironmentMap>,
    /// Of each row the radius and the height of its ring.
    rings: Vec<[f64; 2]>,
    /// Of each column x and z on a ring of radius 1.
    columns: Vec<[f64; 2]>,
}

impl PyramidLevel {
    fn of(map: Arc<EnvironmentMap>) -> Self {
        let [width, height] = map.size();
        let ring = |row| {
            let theta = (row as f64 + 0.5) / height as f64 * PI;
            [libm::sin(theta), libm::cos(theta)]
        };
        let column = |column| {
            let phi = ((column as f64 + 0.5) / width as f64 - 0.5) * 2.0 * PI;
            [libm::sin(phi), -libm::cos(phi)]
        };
        Self { rings: (0..height).map(ring).collect(), columns: (0..width).map(column).collect(), map }
    }

    /// The direction of a pixel, to single precision.
    fn direction(&self, row: usize, column: usize) -> DVec3 {
        let ([radius, y], [x, z]) = (self.rings[row], self.columns[column]);
        DVec3::new(radius * x, y, radius * z).as_vec3().as_dvec3()
    }
}

/// The environment blurred by a lobe. Lobes narrower than a pixel leave it as it is.
pub(crate) fn blurred(Pyramid(levels): &Pyramid, shape: &Shape) -> Arc<EnvironmentMap> {
    let profile = Profile::of(shape);
    if profile.core * levels[0].map.size()[1] as f64 / PI < 0.5 {
        return Arc::clone(&levels[0].map);
    }
    let rings = rings(&profile, levels);
    let rows = (ACROSS_RESULT * PI / profile.core).ceil().clamp(16.0, ROWS) as usize;
    Arc::new(EnvironmentMap::from_fn(2 * rows, rows, |middle| {
        let mut sum = [0.0; 3];
        for ring in &rings {
            let mean = mean(ring, &profile, DVec3::from_array(middle));
            sum.iter_mut().zip(mean).for_each(|(sum, mean)| *sum += ring.fraction * mean);
        }
        sum.map(|sum| sum as f32)
    }))
}

/// The rings of a lobe, each twice as wide as the one before.
fn rings<'a>(profile: &Profile, levels: &'a [PyramidLevel]) -> Vec<Ring<'a>> {
    let mut rings = Vec::new();
    let (mut from, mut to) = (0.0, profile.core.min(profile.end));
    while from < profile.end {
        let fine = |level: &&PyramidLevel| PI / (level.map.size()[1] as f64) <= (to - from) / ACROSS;
        let level = levels.iter().rev().find(fine).unwrap_or(&levels[0]);
        rings.push(Ring { from, to, fraction: profile.fraction(from, to), level });
        (from, to) = (to, (2.0 * to).min(profile.end));
    }
    let total: f64 = rings.iter().map(|ring| ring.fraction).sum();
    rings.iter_mut().for_each(|ring| ring.fraction /= total);
    rings
}

/// The mean over a ring around a direction.
fn mean(ring: &Ring, profile: &Profile, middle: DVec3) -> [f64; 3] {
    let map = &ring.level.map;
    let [width, height] = map.size();
    let theta = libm::acos(middle.y.clamp(-1.0, 1.0));
    let row_of = |theta: f64| theta / PI * height as f64 - 0.5;
    let first = row_of(theta - ring.to).floor().max(0.0) as usize;
    let last = (row_of(theta + ring.to).ceil().max(0.0) as usize).min(height - 1);
    let center = EnvironmentColumn::of(middle, width);
    let (inner, outer) = (libm::cos(ring.from), libm::cos(ring.to));
    let (mut sum, mut weight) = ([0.0; 3], 0.0);
    for row in first..=last {
        let solid = map.solid_angle(row);
        for column in center.around(PI * (row as f64 + 0.5) / height as f64, theta, ring.to) {
            let cosine = ring.level.direction(row, column).dot(middle);
            if cosine > inner || cosine <= outer {
                continue;
            }
            let own = profile.at(cosine) * solid;
            weight += own;
            for (sum, value) in sum.iter_mut().zip(map.pixel(row, column)) {
                *sum += own * f64::from(value);
            }
        }
    }
    if weight > 0.0 {
        return sum.map(|sum| sum / weight);
    }
    // No pixel has its centre in so small a ring.
    let d = Vec3::new(middle.x, middle.y, middle.z);
    map.at(d)
}

/// Columns around a direction.
struct EnvironmentColumn {
    middle: f64,
    width: usize,
}

impl EnvironmentColumn {
    fn of(direction: DVec3, width: usize) -> Self {
        let (u, _) = glanz_scene::EnvironmentMap::place(direction);
        Self { middle: u * width as f64 - 0.5, width }
    }

    /// The columns of a row at polar angle `row` that can be within `end` of a direction at polar angle `theta`.
    fn around(&self, row: f64, theta: f64, end: f64) -> impl Iterator<Item = usize> + use<> {
        // cos end = cos θ cos θ' + sin θ sin θ' cos Δφ
        let sines = libm::sin(row) * libm::sin(theta);
        let cosine = (libm::cos(end) - libm::cos(row) * libm::cos(theta)) / sines.max(1e-12);
        let half = libm::acos(cosine.clamp(-1.0, 1.0)) / (2.0 * PI) * self.width as f64 + 1.0;
        let all = self.width as i64;
        let (first, count) = match 2.0 * half + 1.0 >= all as f64 {
            true => (0, all),
            false => ((self.middle - half).floor() as i64, (2.0 * half).ceil() as i64 + 1),
        };
        (first..first + count).map(move |column| column.rem_euclid(all) as usize)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shape(name: &str, key: &str, value: f64) -> Shape {
        Shape::named(name, &[(key, value)]).expect("the model exists")
    }

    #[test]
    fn a_uniform_environment_stays_uniform() {
        let map = Arc::new(EnvironmentMap::from_fn(64, 32, |_| [0.7, 0.7, 0.7]));
        for exponent in [1.0, 50.0, 1e5] {
            let blurred = blurred(&Pyramid::of(&map), &shape("phong", "shininess", exponent));
            let got = blurred.at(Vec3::new(0.36f32, 0.48, -0.8));
            assert!((got[0] - 0.7).abs() < 1e-6, "{exponent}: {got:?}");
        }
    }

    #[test]
    fn a_cosine_lobe_makes_a_bright_half_its_share() {
        // Phong with exponent 1 is the clamped cosine: (1 + cosine) / 2 of a bright half.
        let map =
            Arc::new(EnvironmentMap::from_fn(256, 128, |[_, y, _]| [if y > 0.0 { 1.0 } else { 0.0 }; 3]));
        let blurred = blurred(&Pyramid::of(&map), &shape("phong", "shininess", 1.0));
        for degrees in [5.0_f64, 40.0, 90.0, 140.0] {
            let (sin, cos) = libm::sincos(degrees.to_radians());
            let got = f64::from(blurred.at(Vec3::new(sin as f32, cos as f32, 0.0))[0]);
            assert!((got - 0.5 * (1.0 + cos)).abs() < 0.01, "{degrees}°: {got}");
        }
    }
}
