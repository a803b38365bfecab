//! Chebyshev series.

use glanz_math::Chebyshev;

use super::{Packer, Section};
use crate::prepare::data::TintSeries;

impl Packer {
    /// Series of channels; the number of the first.
    pub(super) fn series(&mut self, all: &[TintSeries]) -> u32 {
        let number = self.next(Section::Series);
        for series in all {
            let first = self.floats(Section::Terms, series.terms.as_flattened());
            self.words(Section::Series, &[first, series.len() as u32]);
        }
        number
    }

    /// A series of plain numbers.
    pub(super) fn scalar_series(&mut self, series: &Chebyshev) -> u32 {
        let terms: Vec<f32> = series.terms.iter().map(|[term]| *term as f32).collect();
        let first = self.floats(Section::ScalarTerms, &terms);
        self.words(Section::ScalarSeries, &[first, series.len() as u32])
    }
}
