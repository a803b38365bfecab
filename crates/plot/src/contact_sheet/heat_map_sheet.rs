//! Heat-map sheets: two pictures and the maps of their differences, each above its scale.

use glanz_color::srgb_encode;
use glanz_picture::compare::{Measurement, Metric, Pair, heat_color, heat_colors};

use super::canvas::{Canvas, Lettering};
use super::sheet::{ContactSheet, GAP, INK, PAPER};
use crate::{Error, number};

/// Narrower pictures are enlarged to at least this, in pixels, so that captions fit under them.
const LEAST_WIDTH: usize = 300;
/// The widest and highest sheet is 16384 pixels; greater ones are shrunk to this, which leaves space for
/// gaps and texts.
const MOST: usize = 15_000;
/// The height of the bar with the colours of the scale, in pixels.
const BAR: usize = 14;

/// A sheet with both pictures of a pair and a heat map for each measurement. `names` are those of the reference and
/// of the other picture.
///
/// # Errors
/// [`Error::SheetSize`] if the sheet were larger than a picture can be.
pub fn heat_map_sheet(pair: &Pair, names: [String; 2], measured: &[Measurement]) -> Result<Canvas, Error> {
    let shown: Vec<_> = measured.iter().filter(|one| has_panel(one, measured)).collect();
    let count = 2 + shown.len();
    let per_row = if count <= 4 { count } else { count.div_ceil(2) };
    let (width, height) = pair.size();
    let zoom = Zoom::new((width, height), (per_row, count.div_ceil(per_row)));
    let (wide, high) = zoom.size();
    let mut captions: Vec<_> = names.into_iter().map(|name| vec![name]).collect();
    captions.extend(shown.iter().map(|one| caption(one)));
    let cell = (wide, high + GAP + BAR + Lettering::SMALL.height());
    let sheet = ContactSheet { captions, per_row, count, cell, ..ContactSheet::default() };
    let mut canvas = sheet.begin()?;
    for (index, light) in pair.light().iter().enumerate() {
        sheet.put(&mut canvas, index, &panel(cell, &zoom.picture(&codes(light)), None));
    }
    for (index, one) in shown.into_iter().enumerate() {
        let top = top_of_scale(one);
        let map = Canvas { width: wide, height: high, rgba: heat_colors(&zoom.map(&one.map), top) };
        sheet.put(&mut canvas, index + 2, &panel(cell, &map, Some(top)));
    }
    Ok(canvas)
}

/// Whether a map is shown: that of `psnr` is that of `rmse`.
fn has_panel(one: &Measurement, measured: &[Measurement]) -> bool {
    one.metric != Metric::Psnr || measured.iter().all(|other| other.metric != Metric::Rmse)
}

fn caption(one: &Measurement) -> Vec<String> {
    let title = match one.metric {
        Metric::De2000 => "colour difference dE00",
        Metric::Flip => "FLIP",
        Metric::Rmse | Metric::Psnr => "root mean square of channels",
        Metric::Ssim => "1 - SSIM",
    };
    let value = match one.metric {
        Metric::De2000 | Metric::Flip => {
            format!("mean {}, max {}", number(one.value), number(one.spread.max))
        }
        Metric::Psnr => format!("PSNR {} dB", number(one.value)),
        Metric::Rmse | Metric::Ssim => format!("{} {}", one.metric.name().to_uppercase(), number(one.value)),
    };
    vec![title.to_owned(), value]
}

/// The error that gets the brightest colour: 1 where that is the most there can be, else the next of
/// 1, 2, 5, 10, … from the greatest error on.
fn top_of_scale(one: &Measurement) -> f64 {
    let max = one.spread.max;
    if matches!(one.metric, Metric::Flip | Metric::Ssim) || max <= 0.0 || !max.is_finite() {
        return 1.0;
    }
    let power = 10_f64.powi(libm::floor(libm::log10(max)) as i32);
    [1.0, 2.0, 5.0].map(|step| step * power).into_iter().find(|top| *top >= max).unwrap_or(10.0 * power)
}

/// A picture with space below it, in which its scale may stand.
fn panel((width, height): (usize, usize), picture: &Canvas, top: Option<f64>) -> Canvas {
    let mut canvas = Canvas::new(width, height, PAPER);
    canvas.put(0, 0, picture);
    let Some(top) = top else {
        return canvas;
    };
    let colors = (0..width).map(|x| heat_color(x as f32 / (width.max(2) - 1) as f32));
    let row: Vec<u8> = colors.flat_map(|[r, g, b]| [r, g, b, u8::MAX]).collect();
    let bar = picture.height + GAP;
    canvas.put(0, bar, &Canvas { width, height: BAR, rgba: row.repeat(BAR) });
    for (part, fraction) in [(0, 0.0), (1, 0.5), (2, 1.0)] {
        let label = number(top * fraction);
        let x = (width - Lettering::SMALL.width(&label).min(width)) * part / 2;
        canvas.write(x, bar + BAR, &label, Lettering::SMALL, INK);
    }
    canvas
}

/// Light as a screen shows it, as 8-bit codes.
fn codes(light: &[Vec<f32>; 3]) -> Vec<[u8; 3]> {
    let code = |light: f32| (srgb_encode(light.clamp(0.0, 1.0)) * 255.0 + 0.5) as u8;
    (0..light[0].len()).map(|i| light.each_ref().map(|plane| code(plane[i]))).collect()
}

/// How pictures become larger or smaller on a sheet, by whole numbers.
struct Zoom {
    width: usize,
    height: usize,
    grow: usize,
    shrink: usize,
}

impl Zoom {
    fn new((width, height): (usize, usize), (columns, rows): (usize, usize)) -> Self {
        let shrink = (width * columns).div_ceil(MOST).max((height * rows).div_ceil(MOST));
        let greatest = (MOST / (columns * width)).min(MOST / (rows * height)).max(1);
        let grow = LEAST_WIDTH.div_ceil(width).min(greatest);
        Self { width, height, grow: if shrink > 1 { 1 } else { grow }, shrink }
    }

    fn size(&self) -> (usize, usize) {
        let side = |n: usize| n.div_ceil(self.shrink) * self.grow;
        (side(self.width), side(self.height))
    }

    /// Every pixel of the sheet with the upper left of those that it stands for.
    fn pixels(&self) -> impl Iterator<Item = (usize, usize)> {
        let (wide, high) = self.size();
        let place = move |n: usize| n / self.grow * self.shrink;
        (0..high).flat_map(move |y| (0..wide).map(move |x| (place(x), place(y))))
    }

    fn picture(&self, codes: &[[u8; 3]]) -> Canvas {
        let (width, height) = self.size();
        let rgba = self.pixels().flat_map(|(x, y)| {
            let [r, g, b] = codes[y * self.width + x];
            [r, g, b, u8::MAX]
        });
        Canvas { width, height, rgba: rgba.collect() }
    }

    /// The errors; where several share a pixel of the sheet, the greatest, so that none is lost.
    fn map(&self, map: &[f32]) -> Vec<f32> {
        let greatest = |(x, y): (usize, usize)| {
            let rows = y..(y + self.shrink).min(self.height);
            let columns = x..(x + self.shrink).min(self.width);
            rows.flat_map(|y| &map[y * self.width..][columns.clone()]).copied().fold(f32::MIN, f32::max)
        };
        self.pixels().map(greatest).collect()
    }
}

#[cfg(test)]
mod tests {
    use glanz_picture::compare::Spread;

    use super::*;

    #[test]
    fn small_pictures_grow_and_great_ones_shrink() {
        let size = |width, height, columns, rows| Zoom::new((width, height), (columns, rows)).size();
        assert_eq!(size(40, 30, 3, 2), (320, 240));
        assert_eq!(size(800, 600, 3, 2), (800, 600));
        assert_eq!(size(8192, 8192, 3, 2), (4096, 4096));
        assert_eq!(size(1, 16_384, 3, 2), (1, 5462));
    }

    #[test]
    fn no_error_is_lost_where_a_picture_shrinks() {
        let zoom = Zoom { width: 3, height: 3, grow: 1, shrink: 2 };
        assert_eq!(zoom.map(&[0.0, 1.0, 2.0, 3.0, 0.0, 5.0, 6.0, 7.0, 4.0]), [3.0, 5.0, 7.0, 4.0]);
        let codes: Vec<[u8; 3]> = (0..9).map(|i| [i; 3]).collect();
        let reds: Vec<_> = zoom.picture(&codes).rgba.chunks(4).map(|pixel| pixel[0]).collect();
        assert_eq!(reds, [0, 2, 6, 8]);
    }

    #[test]
    fn scales_end_at_round_numbers() {
        let top = |metric, max| {
            let spread = Spread { max, ..Spread::default() };
            top_of_scale(&Measurement { metric, value: 0.0, spread, map: Vec::new(), exposures: None })
        };
        for (max, expected) in
            [(0.0, 1.0), (1.0, 1.0), (1.1, 2.0), (3.0, 5.0), (60.0, 100.0), (f64::INFINITY, 1.0)]
        {
            assert_eq!(top(Metric::De2000, max), expected, "{max}");
        }
        assert_eq!(top(Metric::Flip, 0.01), 1.0);
    }
}
