//! Readings in the plane of incidence.

use glanz_math::Vec3;

use crate::Readings;

/// How far from the plane of incidence a detector may be, in degrees of azimuth.
const BESIDE_PLANE_DEG: f64 = 5.0;
/// How far the azimuth of the light may be from one that is asked for, in degrees.
const BESIDE_AZIMUTH_DEG: f64 = 2.5;
/// Within this angle of the normal, in degrees, a direction lies in every plane.
const AT_NORMAL_DEG: f64 = 1.0;
/// A slice of fewer points says little.
const LEAST_POINTS: usize = 5;

/// Readings of one angle of incidence in the plane of light and normal.
#[derive(Clone, Debug, PartialEq)]
pub struct PlaneSlice {
    /// The angle of incidence, in whole degrees.
    pub theta_i_deg: f64,
    /// The angle of the detector from the normal in degrees, above 0 on the side of the mirror direction and below 0 on
    /// the light's, and the number of the reading; from the light's side to the mirror direction's.
    pub points: Vec<(f64, usize)>,
}

impl Readings {
    /// Slices of up to `most` angles of incidence that lie far apart; of a surface with a grain only of light from about
    /// one azimuth.
    ///
    /// ```
    /// use glanz_math::Vec3;
    /// use glanz_measure::{Channels, Readings};
    ///
    /// let mut readings = Readings::new(Channels::Luminance);
    /// for theta_o in -60..=60 {
    ///     let wi = Vec3::from_angles(0.5, std::f64::consts::PI);
    ///     readings.push(wi, Vec3::from_angles(f64::from(theta_o).to_radians(), 0.0), &[0.2]);
    /// }
    /// let slices = readings.plane_slices(3, None);
    /// assert_eq!((slices.len(), slices[0].theta_i_deg, slices[0].points.len()), (1, 29.0, 121));
    /// assert!((slices[0].points[0].0 + 60.0).abs() < 1e-9);
    /// assert!(readings.plane_slices(3, Some(90.0)).is_empty());
    /// ```
    pub fn plane_slices(&self, most: usize, azimuth_deg: Option<f64>) -> Vec<PlaneSlice> {
        let mut by_degree: Vec<Vec<(f64, usize)>> = vec![Vec::new(); 91];
        for index in 0..self.len() {
            let [wi, wo] = self.pair(index);
            if azimuth_deg.is_some_and(|azimuth| !is_from(wi, azimuth)) {
                continue;
            }
            let degree = theta_deg(wi).round() as usize;
            if let (Some(theta_o), Some(slice)) = (in_plane(wi, wo), by_degree.get_mut(degree)) {
                slice.push((theta_o, index));
            }
        }
        let known: Vec<usize> = (0..91).filter(|degree| by_degree[*degree].len() >= LEAST_POINTS).collect();
        let slice = |degree: usize| {
            let mut points = core::mem::take(&mut by_degree[degree]);
            points.sort_by(|a, b| a.0.total_cmp(&b.0));
            PlaneSlice { theta_i_deg: degree as f64, points }
        };
        chosen(&known, most).map(slice).collect()
    }

    /// The azimuth from which light comes most often, in whole degrees below 360; none of light along the normal only.
    ///
    /// ```
    /// use glanz_math::Vec3;
    /// use glanz_measure::{Channels, Readings};
    ///
    /// let mut readings = Readings::new(Channels::Luminance);
    /// for azimuth in [90.0_f64, 180.0, 180.0] {
    ///     readings.push(Vec3::from_angles(0.5, azimuth.to_radians()), Vec3::from_angles(0.0, 0.0), &[0.2]);
    /// }
    /// assert_eq!(readings.commonest_azimuth_deg(), Some(180.0));
    /// ```
    pub fn commonest_azimuth_deg(&self) -> Option<f64> {
        let mut counts = [0_usize; 360];
        for index in 0..self.len() {
            let [wi, _] = self.pair(index);
            if theta_deg(wi) >= AT_NORMAL_DEG {
                let azimuth = libm::atan2(wi.y, wi.x).to_degrees().round().rem_euclid(360.0);
                counts[azimuth as usize % 360] += 1;
            }
        }
        // Of those that are equally common the least.
        let (azimuth, count) = counts.iter().enumerate().rev().max_by_key(|(_, count)| **count)?;
        (*count > 0).then_some(azimuth as f64)
    }
}

/// Whether light comes from about an azimuth; light along the normal comes from all.
fn is_from(wi: Vec3<f64>, azimuth_deg: f64) -> bool {
    let off = libm::atan2(wi.y, wi.x).to_degrees() - azimuth_deg;
    let off = (off + 180.0).rem_euclid(360.0) - 180.0;
    theta_deg(wi) < AT_NORMAL_DEG || off.abs() < BESIDE_AZIMUTH_DEG
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
    use crate::Channels;

    fn at(theta: f64, phi: f64) -> Vec3<f64> {
        Vec3::from_angles(theta.to_radians(), phi.to_radians())
    }

    #[test]
    fn of_a_grain_one_azimuth_of_the_light_makes_a_slice() {
        let mut readings = Readings::new(Channels::Luminance);
        for azimuth in [0.0, 45.0, 359.0] {
            for theta_o in 10..20 {
                readings.push(at(30.0, azimuth), at(f64::from(theta_o), azimuth + 180.0), &[0.1]);
            }
        }
        assert_eq!(readings.plane_slices(3, None)[0].points.len(), 30);
        // 359° is 1° from 0°.
        let slices = readings.plane_slices(3, Some(0.0));
        assert_eq!((slices.len(), slices[0].points.len()), (1, 20));
        assert!(slices[0].points.iter().all(|(theta_o, index)| *theta_o > 0.0 && !(10..20).contains(index)));
        assert_eq!(readings.commonest_azimuth_deg(), Some(0.0));
    }

    #[test]
    fn a_detector_beside_the_plane_is_in_no_slice() {
        assert_eq!(in_plane(at(30.0, 200.0), at(50.0, 40.0)), None);
        let near = |found: Option<f64>, expected: f64| found.is_some_and(|f| (f - expected).abs() < 1e-9);
        assert!(near(in_plane(at(30.0, 200.0), at(50.0, 21.0)), 50.0));
        assert!(near(in_plane(at(30.0, 200.0), at(50.0, 199.0)), -50.0));
        assert!(near(in_plane(at(0.0, 0.0), at(40.0, 0.0)), 40.0));
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
