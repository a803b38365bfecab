//! A plot of a fit: readings in the plane of incidence as points, the fit as lines.

use core::f64::consts::PI;
use std::path::Path;

use glanz_math::Vec3;
use glanz_measure::{Fit, FitSlice, Readings};
use glanz_plot::page::curve_color;
use glanz_plot::{Axis, Curve, Lang, RegressionChart};

use crate::args::PlotTarget;
use crate::print::failure::{Failure, Report};

/// Angles of incidence that are shown.
const SLICES: usize = 5;

/// Light and detector are shown up to this angle from the normal.
const MOST_THETA_DEG: f64 = 85.0;

/// Powers of ten that are shown below the greatest value.
const DECADES: f64 = 5.0;

/// Where a report goes, checked before any work is done.
pub(super) fn target(file: Option<&Path>) -> Result<Option<PlotTarget>, Failure> {
    file.map(PlotTarget::of_file).transpose()
}

/// The chart of a fit.
pub(super) fn chart(name: &str, readings: &Readings, fit: &Fit) -> Result<RegressionChart, Failure> {
    let mut slices = fit.slices(readings, SLICES);
    slices.retain(|slice| slice.theta_i_deg <= MOST_THETA_DEG);
    if slices.is_empty() {
        return Err(Report::new("no readings lie in the plane of light and normal, which a report shows")
            .help("leave --report out")
            .into());
    }
    let of_slices = |what: &str, points: &dyn Fn(&FitSlice) -> Vec<(f64, f64)>| -> Vec<Curve> {
        let curve = |(i, slice): (usize, &FitSlice)| Curve {
            name: format!("{what}, light at {}°", slice.theta_i_deg),
            points: points(slice),
            color: curve_color(i),
            dash: None,
        };
        slices.iter().enumerate().map(curve).collect()
    };
    let clouds = of_slices("read", &|slice| {
        slice.points.iter().map(|point| (point.theta_o_deg, mean(&point.read))).collect()
    });
    let lines = of_slices("fitted", &|slice| {
        let wi = Vec3::from_angles(slice.theta_i_deg.to_radians(), PI);
        let at = |theta: f64| {
            let wo = Vec3::from_angles(theta.abs().to_radians(), if theta < 0.0 { PI } else { 0.0 });
            (theta, mean(&fit.brdf(wi, wo)))
        };
        (-MOST_THETA_DEG as i32 * 2..=MOST_THETA_DEG as i32 * 2)
            .map(|half| at(0.5 * f64::from(half)))
            .collect()
    });
    let values = || clouds.iter().chain(&lines).flat_map(|curve| &curve.points).map(|(_, value)| *value);
    let most = values().filter(|value| value.is_finite()).fold(1e-6, f64::max);
    let least = values().filter(|value| *value > 0.0).fold(most, f64::min);
    let top = libm::ceil(libm::log10(most));
    let bottom = libm::floor(libm::log10(least)).clamp(top - DECADES, top - 1.0);
    let ticks: Vec<f64> = (bottom as i32..=top as i32).map(|power| libm::exp10(f64::from(power))).collect();
    let range = (libm::exp10(bottom), libm::exp10(top));
    Ok(RegressionChart {
        title: format!("Fit of {name}"),
        subtitle: format!(
            "mean of the channels; error {:.1} % of {} readings",
            100.0 * fit.relative,
            fit.readings
        ),
        x: Axis::exact(
            "θo of the detector in degrees, above 0 on the side of the mirror direction",
            (-90.0, 90.0),
            6,
        ),
        y: Axis::log("BRDF in 1/sr", range, &ticks),
        clouds,
        lines,
        lang: Lang::En,
    })
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len().max(1) as f64
}
