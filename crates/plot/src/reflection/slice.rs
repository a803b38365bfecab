//! Slices of BRDFs over half and difference angle.

use glanz_bsdf::Side;
use glanz_math::Vec3;

use super::lobe::Lobe;
use super::plot::{LobePlot, MOST_PANELS};
use crate::Error;
use crate::chart::Axis;
use crate::figure::{CELLS, Slice, SliceMaps};
use crate::words::Word;

/// The least cosine of directions that decide on the scale: 5° above the horizon.
const CLEAR: f64 = 0.087;

impl LobePlot {
    /// A map in false colours for each lobe.
    ///
    /// Coordinates of Rusinkiewicz (1998): the half vector θh from the normal at the azimuth phi, the light θd
    /// from it, across the plane of both (φd = 90°). [`theta_deg`](Self::theta_deg) does not matter.
    ///
    /// # Errors
    /// Those of lobes that have no direction, and [`Error::Transmission`].
    pub fn slice(&self) -> Result<SliceMaps, Error> {
        self.check_lobes(1, MOST_PANELS)?;
        if let Some(lobe) = self.lobes.iter().find(|lobe| lobe.shape.info().side == Side::Transmission) {
            return Err(Error::Transmission { model: lobe.shape.info().name });
        }
        let slices: Vec<_> = self
            .lobes
            .iter()
            .map(|lobe| Slice { caption: lobe.label.clone(), values: self.cells(lobe) })
            .collect();
        let values = || slices.iter().flat_map(|slice| slice.values.iter().copied());
        let most = slices.iter().map(|slice| self.greatest(slice)).fold(0.0, f64::max);
        let scale = match self.log {
            true => Axis::decades_over(self.quantity_name(), values(), most),
            false => Axis::round(self.quantity_name(), (0.0, most), 6),
        };
        let below = self.lang.say(Word::SliceAxes, &[]);
        Ok(SliceMaps {
            title: self.title(Word::Slices),
            subtitle: self.subtitle_of_values(&below),
            scale,
            slices,
            lang: self.lang,
        })
    }

    /// The greatest value of a slice that is not seen or lit at grazing angles, where f may grow without bound.
    fn greatest(&self, slice: &Slice) -> f64 {
        let clear = |index: usize| {
            let (wo, wi) = self.of_cell(index / CELLS, index % CELLS);
            wo.z > CLEAR && wi.z > CLEAR
        };
        let values =
            slice.values.iter().enumerate().filter(|(index, value)| value.is_finite() && clear(*index));
        values.map(|(_, value)| *value).fold(0.0, f64::max)
    }

    fn cells(&self, lobe: &Lobe) -> Vec<f64> {
        let value = |index: usize| {
            let (wo, wi) = self.of_cell(index / CELLS, index % CELLS);
            if wo.z > 0.0 && wi.z > 0.0 { self.value(lobe, wo, wi) } else { f64::NAN }
        };
        (0..CELLS * CELLS).map(value).collect()
    }

    /// Viewer and light of a cell; rows run downwards from a difference of 90°.
    fn of_cell(&self, row: usize, column: usize) -> (Vec3<f64>, Vec3<f64>) {
        let angle = |index: usize| (90.0 * (index as f64 + 0.5) / CELLS as f64).to_radians();
        self.directions(angle(column), angle(CELLS - 1 - row))
    }

    /// Viewer and light of a half and a difference angle, in radians.
    fn directions(&self, theta_h: f64, theta_d: f64) -> (Vec3<f64>, Vec3<f64>) {
        let phi = self.phi_deg.to_radians();
        let half = Vec3::from_angles(theta_h, phi);
        // Across the plane of normal and half vector.
        let across = Vec3::from_angles(std::f64::consts::FRAC_PI_2, phi + std::f64::consts::FRAC_PI_2);
        let (sine, cosine) = libm::sincos(theta_d);
        (half * cosine - across * sine, half * cosine + across * sine)
    }
}
