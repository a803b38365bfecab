//! Ward's regression: readings as logarithms, and the line through them.

use glanz_measure::{WardFit, WardPoint};

use super::RegressionChart;
use crate::chart::{Axis, Curve};
use crate::page::style::{INK, Rgb8, curve_color};
use crate::words::{Lang, Word};

/// Readings of a smaller part of the greatest weight are drawn in grey.
const LITTLE: f64 = 1e-3;

/// The colour of readings of little weight.
const PALE: Rgb8 = [0xb9, 0xc0, 0xc8];

/// How far the line falls in the drawing, in units of the logarithm: beyond, readings hardly count.
const FALL: f64 = 6.0;

/// The readings of Ward's regression as points, and the line that it found: its slope is −1/αx². With `truth`, ρs and the widths of the
/// model that was measured, its line is dashed.
///
/// ```
/// use glanz_math::Vec3;
/// use glanz_measure::{Channels, Readings, fit_ward, spiral_about_mirror};
/// use glanz_plot::Figure;
///
/// let ward = glanz_bsdf::Shape::named("ward", &[("alpha", 0.1), ("alpha_y", 0.1)])?;
/// let mut readings = Readings::new(Channels::Luminance);
/// for [wi, wo] in spiral_about_mirror() {
///     let f = 0.1 + 0.2 * ward.f_cos(&glanz_bsdf::DirectionPair::new(wo, wi)) / wi.z;
///     readings.push(wi, wo, &[f as f32]);
/// }
/// let chart = glanz_plot::figure::ward(&fit_ward(&readings, 0, false)?, None, Default::default());
/// assert!(chart.csv().contains("slope –1/αx² = –100"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn ward(fit: &WardFit, truth: Option<(f64, [f64; 2])>, lang: Lang) -> RegressionChart {
    let [along, across] = fit.alpha;
    let is_isotropic = along == across;
    let end = FALL * along * along;
    let place = |point: &WardPoint| (fit.abscissa(point), point.value);
    let cloud = |word: Word, color: Rgb8, is_kept: &dyn Fn(f64) -> bool| Curve {
        name: lang.say(word, &[]),
        points: fit.points.iter().filter(|point| is_kept(point.weight)).map(place).collect(),
        color,
        dash: None,
    };
    let line = |name: String, [along, rho]: [f64; 2], across: f64, dash| {
        let (start, slope) = (libm::log(rho / (along * across)), -1.0 / (along * along));
        Curve { name, points: vec![(0.0, start), (end, start + slope * end)], color: INK, dash }
    };
    let slope = format!("{:.0}", -1.0 / (along * along)).replace('-', "–");
    let mut lines = vec![line(lang.say(Word::WardLine, &[&slope]), [along, fit.rho_s], across, None)];
    if let Some((rho_s, [along, across])) = truth {
        let name = lang.say(Word::WardTrue, &[]);
        lines.push(Curve { color: curve_color(1), ..line(name, [along, rho_s], across, Some((7.0, 5.0))) });
    }
    let (top, word) = (fit.intercept(), if is_isotropic { Word::WardX } else { Word::WardXStretched });
    let found = [along, across, fit.rho_s, fit.rho_d].map(|value| lang.decimal(format!("{value:.4}")));
    RegressionChart {
        title: lang.say(Word::Ward, &[]),
        subtitle: lang.say(Word::WardFound, &found.each_ref().map(String::as_str)),
        x: Axis::exact(lang.say(word, &[]), (0.0, end), 6),
        y: Axis::exact(lang.say(Word::WardY, &[]), ((top - FALL - 0.5).floor(), (top + 0.3).ceil()), 8),
        clouds: vec![
            cloud(Word::WardLight, PALE, &|weight| weight < LITTLE),
            cloud(Word::WardReadings, curve_color(0), &|weight| weight >= LITTLE),
        ],
        lines,
        lang,
    }
}
