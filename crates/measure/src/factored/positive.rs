//! Channels in which no colour is below 0.

use glanz_color::Matrix3;
use glanz_color::models::RgbSpace;

use crate::{Channels, Readings};

/// Between the channels of data and those that logarithms are taken of: red, green and blue of saturated colours may be
/// negative, their tristimulus values are not.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Positive {
    channels: Channels,
}

impl Positive {
    pub(super) fn new(channels: &Channels) -> Self {
        Self { channels: channels.clone() }
    }

    /// Those of the data.
    pub(super) fn own(&self) -> &Channels {
        &self.channels
    }

    /// Those that are positive.
    pub(super) fn positive(&self) -> &Channels {
        match &self.channels {
            Channels::Rgb => &Channels::Xyz,
            other => other,
        }
    }

    /// Values of the data in positive channels.
    pub(super) fn to(&self, values: Vec<f64>) -> Vec<f64> {
        self.by(RgbSpace::LINEAR_SRGB.to_xyz_matrix(), values)
    }

    /// Values in positive channels as those of the data.
    pub(super) fn from(&self, values: Vec<f64>) -> Vec<f64> {
        self.by(RgbSpace::LINEAR_SRGB.from_xyz_matrix(), values)
    }

    fn by(&self, matrix: &Matrix3, values: Vec<f64>) -> Vec<f64> {
        match (&self.channels, values.as_slice()) {
            (Channels::Rgb, [r, g, b]) => matrix.apply([*r, *g, *b]).to_vec(),
            _ => values,
        }
    }

    /// Readings in positive channels.
    pub(super) fn readings(&self, readings: &Readings) -> Readings {
        let mut own = Readings::new(self.positive().clone());
        for i in 0..readings.len() {
            let [wi, wo] = readings.pair(i);
            let values = self.to(readings.values(i).iter().map(|value| f64::from(*value)).collect());
            own.push(wi, wo, &values.iter().map(|value| *value as f32).collect::<Vec<_>>());
        }
        own
    }
}
