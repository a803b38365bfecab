//! The harmonics of an environment map.

use glanz_math::{PI, Vec3};

use crate::parallel;
use crate::prepare::data::EnvironmentMap;
use crate::prepare::data::irradiance::{
    IRRADIANCE_TERMS as TERMS, Irradiance, LAST_DEGREE, first_of, harmonics,
};

/// The fewest rows whose pixels are summed as they are.
const COARSEST: usize = 32;

/// What the clamped cosine over π leaves of each degree.
const KEPT: [f64; LAST_DEGREE + 1] = [1.0, 2.0 / 3.0, 0.25, 0.0, -1.0 / 24.0, 0.0, 1.0 / 64.0];

/// Cosine and sine of each order.
const WAVES: usize = LAST_DEGREE + 1;

/// What a matte surface gets of an environment map.
pub(crate) fn irradiance(map: &EnvironmentMap) -> Irradiance {
    let [width, height] = map.size();
    if height < COARSEST {
        // So few pixels would be lights from single directions.
        let finer = EnvironmentMap::from_fn(2 * COARSEST, COARSEST, |[x, y, z]| {
            map.at(Vec3::new(x as f32, y as f32, z as f32))
        });
        return irradiance(&finer);
    }
    let waves: Vec<[[f64; 2]; WAVES]> = (0..width).map(|column| waves(map, column)).collect();
    let row = |row: usize| {
        let mut sums = [[[0.0f64; 2]; 3]; WAVES];
        for (pixel, waves) in map.pixels[row * width..].iter().zip(&waves) {
            for (sum, wave) in sums.iter_mut().zip(waves) {
                for c in 0..3 {
                    let value = f64::from(pixel[c]);
                    sum[c][0] += wave[0] * value;
                    sum[c][1] += wave[1] * value;
                }
            }
        }
        sums
    };
    let rows = parallel::collect(height, row);
    let mut terms = [[0.0f64; 3]; TERMS];
    for (row, sums) in rows.iter().enumerate() {
        let (sin, cos) = libm::sincos((row as f64 + 0.5) / height as f64 * PI);
        // Where the azimuth of the harmonics is 0, those with the cosine are their factors of the polar angle.
        let factors = harmonics(Vec3::new(0.0, cos, sin));
        let solid = map.solid_angle(row);
        for_each(|term, m, part| {
            let factor = factors[term.max(2 * zonal(term) - term)] * solid;
            for c in 0..3 {
                terms[term][c] += factor * sums[m][c][part];
            }
        });
    }
    let mut scaled = [[0.0; 3]; TERMS];
    for_each(|term, m, _| {
        let degree = degree(term);
        scaled[term] = terms[term].map(|sum| (sum * squared_norm(degree, m) * KEPT[degree]) as f32);
    });
    Irradiance { terms: Box::new(scaled) }
}

/// Cosine and sine of the multiples of a column's azimuth.
fn waves(map: &EnvironmentMap, column: usize) -> [[f64; 2]; WAVES] {
    let [x, _, z] = map.direction(map.size()[1] / 2, column);
    let azimuth = libm::atan2(x, z);
    core::array::from_fn(|m| {
        let (sin, cos) = libm::sincos(m as f64 * azimuth);
        [cos, sin]
    })
}

/// Gives the number of each term, its order, and 1 where it has the sine of its azimuth.
fn for_each(mut give: impl FnMut(usize, usize, usize)) {
    for term in 0..TERMS {
        let zonal = zonal(term);
        give(term, term.abs_diff(zonal), usize::from(term < zonal));
    }
}

/// The degree of a term.
fn degree(term: usize) -> usize {
    let mut degrees = (0..=LAST_DEGREE).rev();
    degrees.find(|degree| first_of(*degree).is_some_and(|first| first <= term)).unwrap_or(0)
}

/// The zonal term of the degree of a term.
fn zonal(term: usize) -> usize {
    let degree = degree(term);
    first_of(degree).unwrap_or(0) + degree
}

/// The square of the factor that makes a term's polynomial a normalised harmonic.
fn squared_norm(degree: usize, order: usize) -> f64 {
    let below: f64 = (degree - order + 1..=degree + order).map(|factor| factor as f64).product();
    let both = if order == 0 { 1.0 } else { 2.0 };
    both * (2 * degree + 1) as f64 / (4.0 * PI * below)
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
                        let norm =
                            |term: usize| squared_norm(degree(term), term.abs_diff(zonal(term))).sqrt();
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
