//! Readings in the plane of incidence, beside what was fitted to them.

use glanz_math::Vec3;

use super::Fit;
use crate::Readings;

/// How far from the plane of incidence a detector may be, in degrees of azimuth.
const BESIDE_PLANE_DEG: f64 = 5.0;
/// Within this angle of the normal, in degrees, a direction lies in every plane.
const AT_NORMAL_DEG: f64 = 1.0;
/// A slice of fewer points says little.
const LEAST_POINTS: usize = 5;

/// A point of a slice.
#[derive(Clone, Debug, PartialEq)]
pub struct SlicePoint {
    /// The angle of the detector from the normal, in degrees: above 0 on the side of the mirror direction, below 0 on the
    /// light's.
    pub theta_o_deg: f64,
    /// The BRDF that was read, in 1/sr, one value per channel.
    pub read: Vec<f64>,
    /// That of the fit.
    pub fitted: Vec<f64>,
}

/// Readings of one angle of incidence in the plane of light and normal, by the angle of the detector.
#[derive(Clone, Debug, PartialEq)]
pub struct FitSlice {
    /// The angle of incidence, in whole degrees.
    pub theta_i_deg: f64,
    /// The points, from the light's side to the mirror direction's.
    pub points: Vec<SlicePoint>,
}

impl Fit {
    /// Slices through readings and fit, of up to `most` angles of incidence that lie far apart: what a plot of a fit shows.
    ///
    /// ```
    /// use glanz_math::Vec3;
    /// use glanz_measure::{Channels, FitOptions, Readings, fit};
    ///
    /// let mut readings = Readings::new(Channels::Luminance);
    /// for theta_o in -60..=60 {
    ///     let wi = Vec3::from_angles(0.5, std::f64::consts::PI);
    ///     readings.push(wi, Vec3::from_angles(f64::from(theta_o).to_radians(), 0.0), &[0.2]);
    /// }
    /// let found = fit(&readings, &["lambert"], &FitOptions::default())?;
    /// let slices = found.slices(&readings, 3);
    /// assert_eq!((slices.len(), slices[0].theta_i_deg, slices[0].points.len()), (1, 29.0, 121));
    /// assert!((slices[0].points[0].theta_o_deg + 60.0).abs() < 1e-9);
    /// # Ok::<(), glanz_measure::FitError>(())
    /// ```
    pub fn slices(&self, readings: &Readings, most: usize) -> Vec<FitSlice> {
        let mut by_degree: Vec<Vec<(f64, usize)>> = vec![Vec::new(); 91];
        for index in 0..readings.len() {
            let [wi, wo] = readings.pair(index);
            let degree = theta_deg(wi).round() as usize;
            if let (Some(theta_o), Some(slice)) = (in_plane(wi, wo), by_degree.get_mut(degree)) {
                slice.push((theta_o, index));
            }
        }
        let known: Vec<usize> = (0..91).filter(|degree| by_degree[*degree].len() >= LEAST_POINTS).collect();
        chosen(&known, most).map(|degree| self.slice(readings, degree, &mut by_degree[degree])).collect()
    }

    fn slice(&self, readings: &Readings, degree: usize, places: &mut [(f64, usize)]) -> FitSlice {
        places.sort_by(|a, b| a.0.total_cmp(&b.0));
        let point = |(theta_o_deg, index): &(f64, usize)| {
            let [wi, wo] = readings.pair(*index);
            let read = readings.values(*index).iter().map(|value| f64::from(*value)).collect();
            SlicePoint { theta_o_deg: *theta_o_deg, read, fitted: self.brdf(wi, wo) }
        };
        FitSlice { theta_i_deg: degree as f64, points: places.iter().map(point).collect() }
    }
}

/// At most so many, the first and the last among them.
fn chosen(known: &[usize], most: usize) -> impl Iterator<Item = usize> {
    let count = known.len().min(most);
    let place = move |k: usize| if count < 2 { 0 } else { k * (known.len() - 1) / (count - 1) };
    (0..count).map(move |k| known[place(k)])
}

fn theta_deg(w: Vec3<f64>) -> f64 {
    libm::atan2(libm::sqrt(w.x * w.x + w.y * w.y), w.z).to_degrees()
}

/// The angle of the detector with its sign, if it is in the plane of light and normal.
fn in_plane(wi: Vec3<f64>, wo: Vec3<f64>) -> Option<f64> {
    let (theta_i, theta_o) = (theta_deg(wi), theta_deg(wo));
    if theta_o < AT_NORMAL_DEG {
        return Some(theta_o);
    }
    // Of light along the normal the plane is that of x.
    let (x, y) = if theta_i < AT_NORMAL_DEG { (-1.0, 0.0) } else { (wi.x, wi.y) };
    let (along, across) = (x * wo.x + y * wo.y, x * wo.y - y * wo.x);
    let off = libm::atan2(across.abs(), along.abs()).to_degrees();
    (off < BESIDE_PLANE_DEG).then_some(if along > 0.0 { -theta_o } else { theta_o })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(theta: f64, phi: f64) -> Vec3<f64> {
        Vec3::from_angles(theta.to_radians(), phi.to_radians())
    }

    #[test]
    fn detectors_are_on_the_side_of_the_light_or_of_the_mirror_direction() {
        let near =
            |found: Option<f64>, expected: f64| (found.expect("it is in the plane") - expected).abs() < 1e-9;
        assert!(near(in_plane(at(30.0, 200.0), at(50.0, 21.0)), 50.0));
        assert!(near(in_plane(at(30.0, 200.0), at(50.0, 199.0)), -50.0));
        assert!(near(in_plane(at(30.0, 200.0), at(0.5, 90.0)), 0.5));
        assert!(near(in_plane(at(0.0, 0.0), at(40.0, 0.0)), 40.0));
        assert_eq!(in_plane(at(30.0, 200.0), at(50.0, 40.0)), None);
    }

    #[test]
    fn angles_of_incidence_lie_far_apart() {
        let pick = |known: &[usize], most| chosen(known, most).collect::<Vec<_>>();
        assert_eq!(pick(&[10, 20, 30, 40, 50], 3), [10, 30, 50]);
        assert_eq!(pick(&[10, 20], 5), [10, 20]);
        assert_eq!(pick(&[10, 20], 1), [10]);
        assert!(pick(&[], 4).is_empty() && pick(&[10], 0).is_empty());
    }
}
