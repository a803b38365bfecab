//! The harmonics of an environment map.

use glanz_math::{PI, Vec3};

use crate::prepare::data::EnvironmentMap;
use crate::prepare::data::irradiance::{IRRADIANCE_TERMS as TERMS, Irradiance, harmonics};

/// The fewest rows whose pixels are summed as they are.
const COARSEST: usize = 32;

/// What the clamped cosine over π leaves of the degrees 0, 1, 2 and 4.
const KEPT: [f64; 4] = [1.0, 2.0 / 3.0, 0.25, -1.0 / 24.0];

/// What a matte surface gets of an environment map.
pub(crate) fn irradiance(map: &EnvironmentMap) -> Irradiance {
    if map.size()[1] < COARSEST {
        // So few pixels would be lights from single directions.
        let finer = EnvironmentMap::from_fn(2 * COARSEST, COARSEST, |[x, y, z]| {
            map.at(Vec3::new(x as f32, y as f32, z as f32))
        });
        return irradiance(&finer);
    }
    let mut sums = [[0.0f64; 3]; TERMS];
    let [width, height] = map.size();
    for row in 0..height {
        let weight = map.solid_angle(row);
        for column in 0..width {
            let [x, y, z] = map.direction(row, column);
            let basis = harmonics(Vec3::new(x, y, z));
            for (sum, y) in sums.iter_mut().zip(basis) {
                for (sum, value) in sum.iter_mut().zip(map.pixel(row, column)) {
                    *sum += weight * y * f64::from(value);
                }
            }
        }
    }
    let scale = |i: usize| norm(i) * norm(i) * KEPT[degree(i)];
    Irradiance { terms: core::array::from_fn(|i| sums[i].map(|sum| (sum * scale(i)) as f32)) }
}

/// Which of the degrees kept a term is of.
fn degree(term: usize) -> usize {
    match term {
        0 => 0,
        1..4 => 1,
        4..9 => 2,
        _ => 3,
    }
}

/// The factor that makes a term's polynomial a normalised harmonic: the usual constants.
fn norm(term: usize) -> f64 {
    let over_pi: f64 = match term {
        0 => 1.0 / 4.0,
        1..4 => 3.0 / 4.0,
        4 | 5 | 7 => 15.0 / 4.0,
        6 => 5.0 / 16.0,
        8 => 15.0 / 16.0,
        9 | 17 => 315.0 / 16.0 * if term == 9 { 1.0 } else { 1.0 / 16.0 },
        10 | 16 => 315.0 / 32.0,
        11 | 15 => 45.0 / 16.0 * if term == 11 { 1.0 } else { 0.25 },
        12 | 14 => 45.0 / 32.0,
        _ => 9.0 / 256.0,
    };
    libm::sqrt(over_pi / PI)
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;

    #[test]
    fn the_harmonics_are_orthonormal() {
        let map = EnvironmentMap::from_fn(256, 128, |_| [0.0; 3]);
        let mut gram = [[0.0; TERMS]; TERMS];
        for row in 0..128 {
            for column in 0..256 {
                let [x, y, z] = map.direction(row, column);
                let basis = harmonics(Vec3::new(x, y, z));
                for i in 0..TERMS {
                    for j in 0..TERMS {
                        gram[i][j] += basis[i] * norm(i) * basis[j] * norm(j) * map.solid_angle(row);
                    }
                }
            }
        }
        for (i, row) in gram.iter().enumerate() {
            for (j, value) in row.iter().enumerate() {
                let expected = if i == j { 1.0 } else { 0.0 };
                assert!((value - expected).abs() < 2e-3, "{i}, {j}: {value}");
            }
        }
    }

    #[test]
    fn a_uniform_environment_gives_one_everywhere() {
        let white = irradiance(&EnvironmentMap::from_fn(64, 32, |_| [1.0, 0.5, 0.25]));
        for normal in [DVec3::X, DVec3::NEG_Y, DVec3::new(0.48, 0.6, 0.64)] {
            let got = white.at(Vec3::new(normal.x as f32, normal.y as f32, normal.z as f32));
            for (got, expected) in got.iter().zip([1.0, 0.5, 0.25]) {
                assert!((got - expected).abs() < 1e-3, "{got}");
            }
        }
        assert_eq!(Irradiance::uniform().at(Vec3::new(0.0, 1.0f32, 0.0)), [1.0; 3]);
    }

    #[test]
    fn a_bright_half_gives_its_form_factor() {
        // Light from the upper hemisphere: (1 + cosine) / 2.
        let half = EnvironmentMap::from_fn(256, 128, |[_, y, _]| [if y > 0.0 { 1.0 } else { 0.0 }; 3]);
        let irradiance = irradiance(&half);
        for degrees in [0.0_f64, 30.0, 60.0, 90.0, 120.0, 180.0] {
            let (sin, cos) = libm::sincos(degrees.to_radians());
            let got = irradiance.at(Vec3::new(sin, cos, 0.0))[0];
            assert!((got - 0.5 * (1.0 + cos)).abs() < 2e-3, "{degrees}°: {got}");
        }
    }
}
