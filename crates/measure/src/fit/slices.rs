//! Readings in the plane of incidence, beside what was fitted to them.

use super::Fit;
use crate::{PlaneSlice, Readings};

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
        readings.plane_slices(most, None).iter().map(|slice| self.slice(readings, slice)).collect()
    }

    fn slice(&self, readings: &Readings, slice: &PlaneSlice) -> FitSlice {
        let point = |(theta_o_deg, index): &(f64, usize)| {
            let [wi, wo] = readings.pair(*index);
            let read = readings.values(*index).iter().map(|value| f64::from(*value)).collect();
            SlicePoint { theta_o_deg: *theta_o_deg, read, fitted: self.brdf(wi, wo) }
        };
        FitSlice { theta_i_deg: slice.theta_i_deg, points: slice.points.iter().map(point).collect() }
    }
}
