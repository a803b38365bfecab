//! ꟻLIP: the difference that an eye sees which looks at two pictures in turn, 0 … 1.
//!
//! For what a screen shows (LDR-ꟻLIP): P. Andersson, J. Nilsson, T. Akenine-Möller, M. Oskarsson,
//! K. Åström, M. D. Fairchild, "FLIP: A Difference Evaluator for Alternating Images", Proceedings of the
//! ACM on Computer Graphics and Interactive Techniques 3 (2), 2020. For light (HDR-ꟻLIP): P. Andersson,
//! J. Nilsson, P. Shirley, T. Akenine-Möller, "Visualizing Errors in Rendered High Dynamic Range Images",
//! Eurographics Short Papers 2021.
//!
//! The colours of both pictures are blurred as the eye blurs them ([`kernels`]), and their distance is
//! brought to 0 … 1 ([`color`]). Edges and points that one picture alone has ([`feature`]) raise it to a
//! power below 1. Light is looked at in several exposures ([`exposure`]); the greatest error counts.
//!
//! Primaries and white are Glanz's, which differ from the authors' by 1e-5.

mod color;
mod exposure;
mod feature;
mod kernels;
mod planes;
#[cfg(test)]
mod tests;

pub use exposure::Exposures;

use core::ops::Range;

use super::filter::{Kernel, filter};
use crate::compare::bands::in_bands;
use crate::compare::rows::{one_plane, three_planes};
use crate::compare::{CompareError, Pair, Scale};
use color::{color_error, perceived, to_ycxcz};
use kernels::{ColorKernels, FeatureKernels};
use planes::{Planes, pixel};

/// Pixels per degree where the papers' authors sit: 3840 pixels on 0.7 m, seen from 0.7 m.
pub const DEFAULT_PPD: f64 = 67.020_64;
/// The least and the most pixels per degree that are taken.
pub const PPD_RANGE: (f64, f64) = (1.0, 1000.0);

/// The error of every pixel; for light, the exposures too.
pub(crate) fn map(pair: &Pair, ppd: f64) -> Result<(Vec<f32>, Option<Exposures>), CompareError> {
    if !(PPD_RANGE.0..=PPD_RANGE.1).contains(&ppd) {
        return Err(CompareError::PixelsPerDegree { range: PPD_RANGE, found: ppd });
    }
    let (width, height) = pair.size();
    let eye = Eye::new(width, ppd);
    let rows_of = |rows: Range<usize>| {
        let pixels = rows.start * width..rows.end * width;
        pair.light().each_ref().map(|rgb| rgb.each_ref().map(|plane| plane[pixels.clone()].to_vec()))
    };
    if pair.scale() == Scale::Codes {
        let band = |rows: Range<usize>| {
            let [reference, test] = rows_of(rows.clone());
            eye.error(&reference, &test, rows.len())
        };
        return Ok((in_bands(width, height, eye.margin(), band), None));
    }
    let [reference, test] = pair.light();
    let Some(exposures) = Exposures::for_pair(reference, test) else {
        // Neither picture has any light.
        return Ok((vec![0.0; width * height], None));
    };
    let band = |rows: Range<usize>| {
        let light = rows_of(rows.clone());
        let mut greatest = vec![0.0_f32; rows.len() * width];
        for stops in exposures.stops() {
            let [reference, test] =
                light.each_ref().map(|light| exposure::expose(light, width, rows.len(), stops));
            for (greatest, error) in greatest.iter_mut().zip(eye.error(&reference, &test, rows.len())) {
                *greatest = greatest.max(error);
            }
        }
        greatest
    };
    Ok((in_bands(width, height, eye.margin(), band), Some(exposures)))
}

/// Somebody who looks at pictures of one width.
struct Eye {
    width: usize,
    features: FeatureKernels,
    colors: ColorKernels,
}

impl Eye {
    fn new(width: usize, ppd: f64) -> Self {
        Self { width, features: FeatureKernels::new(ppd), colors: ColorKernels::new(ppd) }
    }

    /// The most rows from a pixel to one that its error depends on.
    fn margin(&self) -> usize {
        let ColorKernels { achromatic, red_green, blue_yellow: [narrow, wide] } = &self.colors;
        let FeatureKernels { smooth, edge, point } = &self.features;
        let kernels = [achromatic, red_green, narrow, wide, smooth, edge, point];
        kernels.into_iter().map(Kernel::radius).fold(0, usize::max)
    }

    /// The error of every pixel between two pictures of linear light 0 … 1, of so many rows.
    fn error(&self, reference: &Planes, test: &Planes, height: usize) -> Vec<f32> {
        let see = |light: &Planes| {
            let opponent = three_planes(self.width, height, |i| to_ycxcz(pixel(light, i)));
            let feature = feature::Features::of(&opponent[0], self.width, height, &self.features);
            (self.blurred(opponent, height), feature)
        };
        let ((reference, reference_features), (test, test_features)) = (see(reference), see(test));
        one_plane(self.width, height, |i| {
            let color = color_error(pixel(&reference, i), pixel(&test, i));
            let feature = feature::feature_error(&reference_features, &test_features, i);
            libm::powf(color, 1.0 - feature)
        })
    }

    /// The opponent colours as the eye blurs them, in the space where their distance is measured.
    fn blurred(&self, opponent: Planes, height: usize) -> Planes {
        let kernels = &self.colors;
        let [y, cx, cz] = opponent;
        let blur = |plane: &[f32], kernel| filter(plane, self.width, kernel, kernel);
        let y = blur(&y, &kernels.achromatic);
        let cx = blur(&cx, &kernels.red_green);
        let [narrow, wide] = kernels.blue_yellow.each_ref().map(|kernel| blur(&cz, kernel));
        three_planes(self.width, height, |i| perceived([y[i], cx[i], narrow[i] + wide[i]]))
    }
}
