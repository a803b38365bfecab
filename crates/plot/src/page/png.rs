//! A page as PNG.

use std::io::Write;

use glanz_picture::output::{Effort, Metadata, OutputError, write_png8};
use plotters::prelude::*;

use super::letters;
use super::paint::paint;
use super::shapes::{Page, Raster};
use super::style::Rgb8;

/// Pixels drawn per point, each way; those of a pixel of the file are averaged, which smooths every edge.
const DRAWN: usize = 4;
/// The same for pages of more points than this, which would take much memory.
const COARSE: (usize, usize) = (2, 6_000_000);

/// Writes the page as PNG.
pub(super) fn write(page: &Page, out: impl Write) -> Result<(), OutputError> {
    let density = page.density.clamp(1, 2) as usize;
    let points = page.width as usize * page.height as usize;
    let scale = if points > COARSE.1 { COARSE.0 } else { DRAWN };
    let smooth = scale / density;
    let (width, height) = (page.width as usize * scale, page.height as usize * scale);
    let mut rgb = vec![0xff; width * height * 3];
    for raster in &page.rasters {
        put(raster, scale as f64, &mut rgb, (width, height));
    }
    let area = BitMapBackend::with_buffer(&mut rgb, (width as u32, height as u32)).into_drawing_area();
    paint(page, scale as f64, &area)
        .and_then(|()| area.present())
        .map_err(|error| OutputError::Encode { format: "PNG", message: error.to_string() })?;
    drop(area);
    for text in page.texts() {
        letters::draw(text, scale as f64, |x, y, part| {
            blend(&mut rgb, (width, height), (x, y), text.color, part)
        });
    }
    let rgba = averaged(&rgb, width, smooth);
    write_png8(out, (width / smooth, height / smooth), &rgba, Effort::Best, &Metadata::default())
}

/// Paints the cells of a raster, without smoothing between them.
fn put(raster: &Raster, scale: f64, rgb: &mut [u8], (width, height): (usize, usize)) {
    let rect = raster.rect;
    let edge = |at: f64, most: usize| ((at * scale).round().max(0.0) as usize).min(most);
    let (left, right) = (edge(rect.x, width), edge(rect.right(), width));
    let (top, bottom) = (edge(rect.y, height), edge(rect.bottom(), height));
    for y in top..bottom {
        let row = (y - top) * raster.rows / (bottom - top);
        for x in left..right {
            let column = (x - left) * raster.columns / (right - left);
            let from = 3 * (row * raster.columns + column);
            let to = 3 * (y * width + x);
            rgb[to..to + 3].copy_from_slice(&raster.rgb[from..from + 3]);
        }
    }
}

/// Covers a part of a pixel; what lies outside of the page is not drawn.
fn blend(rgb: &mut [u8], (width, height): (usize, usize), (x, y): (i32, i32), color: Rgb8, part: f32) {
    let (Ok(x), Ok(y)) = (usize::try_from(x), usize::try_from(y)) else { return };
    if x < width && y < height {
        let at = 3 * (y * width + x);
        for (below, above) in rgb[at..at + 3].iter_mut().zip(color) {
            let (from, to) = (f32::from(*below), f32::from(above));
            *below = (from + (to - from) * part.clamp(0.0, 1.0)).round() as u8;
        }
    }
}

/// The mean of each square of drawn pixels, opaque.
fn averaged(rgb: &[u8], width: usize, smooth: usize) -> Vec<u8> {
    let samples = (smooth * smooth) as u32;
    let mut rgba = Vec::with_capacity(rgb.len() / 3 / smooth / smooth * 4);
    for rows in rgb.chunks_exact(3 * width * smooth) {
        for x in 0..width / smooth {
            for channel in 0..3 {
                let at = |dx: usize, dy: usize| u32::from(rows[3 * (dy * width + x * smooth + dx) + channel]);
                let sum: u32 = (0..smooth).flat_map(|dy| (0..smooth).map(move |dx| at(dx, dy))).sum();
                rgba.push(((sum + samples / 2) / samples) as u8);
            }
            rgba.push(0xff);
        }
    }
    rgba
}
