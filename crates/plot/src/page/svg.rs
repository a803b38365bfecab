//! A page as SVG.

use std::fmt::Write as _;
use std::io::Write;

use glanz_picture::output::{Effort, Metadata, OutputError, write_png8};
use plotters::prelude::*;

use super::paint::paint;
use super::shapes::{Anchor, Page, Raster, Text};

/// Units of the file per point: `plotters` knows whole numbers only.
const UNITS: f64 = 20.0;

/// The families that are asked for; whoever shows the file takes the first that is there.
const FAMILY: &str = "Noto Sans, DejaVu Sans, sans-serif";

/// Writes the page as SVG.
pub(super) fn write(page: &Page, mut out: impl Write) -> Result<(), OutputError> {
    let units = |points: u32| (f64::from(points) * UNITS) as u32;
    let (width, height) = (units(page.width), units(page.height));
    let mut drawn = String::new();
    {
        let area = SVGBackend::with_string(&mut drawn, (width, height)).into_drawing_area();
        paint(page, UNITS, &area)
            .and_then(|()| area.present())
            .map_err(|error| OutputError::Encode { format: "SVG", message: error.to_string() })?;
    }
    // The first line is the element `svg` in the size of units; ours is in points.
    let body = drawn.split_once('\n').map_or("", |(_, body)| body);
    let body = body.trim_end().strip_suffix("</svg>").unwrap_or(body);
    let mut head = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" viewBox=\"0 0 {width} {height}\" \
         font-family=\"{FAMILY}\" stroke-linejoin=\"round\">\n<rect width=\"100%\" height=\"100%\" fill=\"#FFFFFF\"/>\n",
        page.width, page.height
    );
    for raster in &page.rasters {
        image(&mut head, raster)?;
    }
    out.write_all(head.as_bytes())?;
    out.write_all(body.as_bytes())?;
    let mut tail = String::new();
    page.texts().for_each(|one| text(&mut tail, one));
    out.write_all(tail.as_bytes())?;
    out.write_all(b"</svg>\n")?;
    Ok(())
}

/// Adds a raster as a PNG within the text.
fn image(text: &mut String, raster: &Raster) -> Result<(), OutputError> {
    let rgba: Vec<u8> = raster.rgb.chunks_exact(3).flat_map(|c| [c[0], c[1], c[2], 0xff]).collect();
    let mut png = Vec::new();
    write_png8(&mut png, (raster.columns, raster.rows), &rgba, Effort::Best, &Metadata::default())?;
    let [x, y, width, height] =
        [raster.rect.x, raster.rect.y, raster.rect.width, raster.rect.height].map(|v| v * UNITS);
    writeln!(
        text,
        "<image x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" preserveAspectRatio=\"none\" \
         image-rendering=\"pixelated\" href=\"data:image/png;base64,{}\"/>",
        base64(&png)
    )
    .expect("a string takes everything");
    Ok(())
}

/// Adds a line of text.
fn text(svg: &mut String, text: &Text) {
    let (x, y) = ((text.at.0 * UNITS).round(), (text.at.1 * UNITS).round());
    let anchor = match text.anchor {
        Anchor::Start => "start",
        Anchor::Middle => "middle",
        Anchor::End => "end",
    };
    let [r, g, b] = text.color;
    let turned = if text.upwards { format!(" transform=\"rotate(270, {x}, {y})\"") } else { String::new() };
    let letters = text.text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    writeln!(
        svg,
        "<text x=\"{x}\" y=\"{y}\" font-size=\"{}\" text-anchor=\"{anchor}\" fill=\"#{r:02X}{g:02X}{b:02X}\"{turned}>{letters}</text>",
        text.size * UNITS
    )
    .expect("a string takes everything");
}

/// RFC 4648, section 4.
fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let byte = |i: usize| three.get(i).map_or(0, |byte| u32::from(*byte));
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for digit in 0..4 {
            let value = (bits >> (18 - 6 * digit)) & 63;
            text.push(if digit > three.len() { '=' } else { char::from(DIGITS[value as usize]) });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::base64;

    #[test]
    fn base64_gives_the_examples_of_its_standard() {
        // RFC 4648, section 10.
        for (bytes, text) in
            [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foobar", "Zm9vYmFy")]
        {
            assert_eq!(base64(bytes.as_bytes()), text);
        }
    }
}
