//! Surroundings as a lobe sees them: blurred by its shape.
//!
//! For each direction of mirrored light, the mean of the surroundings weighted with the lobe as it is for
//! a viewer straight above. The pixel loop multiplies it with the lobe's albedo for the true view angle. That
//! keeps the energy for every angle and is exact in uniform surroundings and for viewers above; the
//! lobe's stretching towards grazing views is left out, as in B. Karis, "Real Shading in Unreal Engine 4",
//! SIGGRAPH course, 2013, from which the separation comes. `tests/surroundings` states the error.

use glam::DVec3;
use glanz_bsdf::{Pair, Shape, Side};
use glanz_math::{PI, Vec3};

use super::sky::Sky;

/// Share of a lobe that is left out where it is faintest.
const LEFT_OUT: f64 = 0.003;

/// Pixels of the surroundings from the middle of a lobe to its edge: finer ones are averaged before.
const ACROSS: f64 = 12.0;

/// Pixels of the result over the same length.
const ACROSS_RESULT: f64 = 8.0;

/// Azimuths over which lobes that know a tangent are averaged.
const AZIMUTHS: usize = 8;

/// A lobe's weight over the angle from its middle.
struct Profile {
    /// Angles, from 0 on.
    angles: Vec<f64>,
    weights: Vec<f64>,
}

impl Profile {
    fn of(shape: &Shape) -> Self {
        let info = shape.info();
        let count = if shape.is_anisotropic() { AZIMUTHS } else { 1 };
        let sign = if info.side == Side::Transmission { -1.0 } else { 1.0 };
        let at = |angle: f64| {
            let value = |i: usize| {
                let w = Vec3::from_angles(angle, 2.0 * PI * i as f64 / AZIMUTHS as f64);
                shape.f_cos(&Pair::new(Vec3::new(0.0, 0.0, 1.0), Vec3::new(w.x, w.y, sign * w.z)))
            };
            (0..count).map(value).sum::<f64>() / count as f64
        };
        // Steps that grow with the angle hold the narrowest and the widest lobes.
        let angles: Vec<f64> = (0..=240).map(|i| PI / 2.0 * libm::pow(i as f64 / 240.0, 3.0)).collect();
        let weights: Vec<f64> = angles.iter().map(|angle| at(*angle)).collect();
        let ring = |i: usize| {
            let (a, b) = (angles[i], angles[i + 1]);
            (weights[i] * libm::sin(a) + weights[i + 1] * libm::sin(b)) * (b - a)
        };
        let total: f64 = (0..240).map(ring).sum();
        let (mut sum, mut last) = (0.0, 1);
        while last < 240 && sum < total * (1.0 - LEFT_OUT) {
            sum += ring(last - 1);
            last += 1;
        }
        Self { angles: angles[..=last].to_vec(), weights: weights[..=last].to_vec() }
    }

    /// The angle at which it ends.
    fn end(&self) -> f64 {
        self.angles.last().copied().unwrap_or(0.0)
    }

    fn at(&self, angle: f64) -> f64 {
        let next = self.angles.partition_point(|a| *a <= angle);
        if next == self.angles.len() {
            return 0.0;
        }
        let (a, b) = (self.angles[next - 1], self.angles[next]);
        let t = (angle - a) / (b - a);
        self.weights[next - 1] * (1.0 - t) + self.weights[next] * t
    }
}

/// The surroundings blurred by a lobe. Lobes narrower than a pixel leave them as they are.
pub(super) fn blurred(sky: &Sky, shape: &Shape) -> Sky {
    let profile = Profile::of(shape);
    let end = profile.end();
    let mut source = sky.clone();
    while source.size()[1] > 16 && end * source.size()[1] as f64 / PI > 2.0 * ACROSS {
        source = source.halved();
    }
    let [width, height] = source.size();
    if end * (height as f64) < PI {
        return source;
    }
    let rows = (ACROSS_RESULT * PI / end).ceil().clamp(16.0, height as f64) as usize;
    let columns = (rows * 2).min(width.max(1));
    let directions: Vec<Vec<DVec3>> =
        (0..height).map(|row| (0..width).map(|column| source.direction(row, column)).collect()).collect();
    Sky::from_fn(columns, rows, |middle| mean(&source, &directions, &profile, middle))
}

/// The mean around a direction.
fn mean(sky: &Sky, directions: &[Vec<DVec3>], profile: &Profile, middle: DVec3) -> [f32; 3] {
    let [width, height] = sky.size();
    let end = profile.end();
    let theta = libm::acos(middle.y.clamp(-1.0, 1.0));
    let row_of = |theta: f64| theta / PI * height as f64 - 0.5;
    let first = row_of(theta - end).floor().max(0.0) as usize;
    let last = (row_of(theta + end).ceil().max(0.0) as usize).min(height - 1);
    let center = EnvironmentColumn::of(middle, width);
    let (mut sum, mut weight) = ([0.0; 3], 0.0);
    for row in first..=last {
        let solid = sky.solid_angle(row);
        for column in center.around(PI * (row as f64 + 0.5) / height as f64, theta, end) {
            let cosine = directions[row][column].dot(middle);
            let own = profile.at(libm::acos(cosine.clamp(-1.0, 1.0))) * solid;
            weight += own;
            for (sum, value) in sum.iter_mut().zip(sky.pixel(row, column)) {
                *sum += own * f64::from(value);
            }
        }
    }
    if weight > 0.0 { sum.map(|sum| (sum / weight) as f32) } else { [0.0; 3] }
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
    fn uniform_surroundings_stay_uniform() {
        let sky = Sky::from_fn(64, 32, |_| [0.7, 0.7, 0.7]);
        for exponent in [1.0, 50.0, 1e5] {
            let blurred = blurred(&sky, &shape("phong", "shininess", exponent));
            let got = blurred.at(Vec3::new(0.36f32, 0.48, -0.8));
            assert!((got[0] - 0.7).abs() < 1e-6, "{exponent}: {got:?}");
        }
    }

    #[test]
    fn a_cosine_lobe_makes_a_bright_half_its_share() {
        // Phong with exponent 1 is the clamped cosine: (1 + cosine) / 2 of a bright half.
        let sky = Sky::from_fn(256, 128, |d| [if d.y > 0.0 { 1.0 } else { 0.0 }; 3]);
        let blurred = blurred(&sky, &shape("phong", "shininess", 1.0));
        for degrees in [5.0_f64, 40.0, 90.0, 140.0] {
            let (sin, cos) = libm::sincos(degrees.to_radians());
            let got = f64::from(blurred.at(Vec3::new(sin as f32, cos as f32, 0.0))[0]);
            assert!((got - 0.5 * (1.0 + cos)).abs() < 0.01, "{degrees}°: {got}");
        }
    }
}
