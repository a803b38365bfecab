//! The colours of wavelengths, as near as a screen comes to them.

use std::sync::LazyLock;

use glanz_color::models::RgbSpace;
use glanz_color::{FIRST_NM, LAST_NM, cie1931_by_1_nm};

use super::axes::Axes;
use crate::page::style::{GRAY, NUMBER, Rgb8, WHITE};
use crate::page::{Anchor, Page, Rect};
use crate::words::{Lang, Word};

/// How high a band is, in points.
pub(crate) const HEIGHT: f64 = 16.0;
/// What stands for ultraviolet, which has no colour.
const ULTRAVIOLET: Rgb8 = [0xb4, 0xae, 0xc2];
/// Where ultraviolet ends and light begins; between both the colours are blended.
const SEEN_FROM_NM: (f64, f64) = (380.0, 400.0);
/// The functions by 1 nm begin here.
const TABLE_FROM_NM: f64 = 360.0;

/// The colour of each nm from 300 to 780.
static COLORS: LazyLock<Vec<Rgb8>> =
    LazyLock::new(|| (FIRST_NM as usize..=LAST_NM as usize).map(|nm| of_nm(nm as f64)).collect());

/// The colour that stands for a wavelength.
///
/// No screen shows single wavelengths: negative primaries are left out, and brightness is kept high and
/// falls towards the ends of the spectrum. It is a page, not a measurement.
pub fn color(nm: f64) -> Rgb8 {
    let index = (nm.clamp(FIRST_NM, LAST_NM) - FIRST_NM).round() as usize;
    COLORS[index]
}

fn of_nm(nm: f64) -> Rgb8 {
    let index = (nm.max(TABLE_FROM_NM) - TABLE_FROM_NM) as usize;
    let (_, xyz) = cie1931_by_1_nm()[index];
    let rgb = RgbSpace::SRGB.from_xyz_matrix().apply(xyz);
    let shown = rgb.map(|c| c.max(0.0));
    let most = shown.into_iter().fold(f64::MIN_POSITIVE, f64::max);
    let fall = ((nm - 380.0) / 50.0).min((780.0 - nm) / 110.0).clamp(0.0, 1.0);
    let light = 0.25 + 0.75 * fall;
    let seen = ((nm - SEEN_FROM_NM.0) / (SEEN_FROM_NM.1 - SEEN_FROM_NM.0)).clamp(0.0, 1.0);
    core::array::from_fn(|i| {
        let code = 255.0 * RgbSpace::SRGB.transfer.encode(shown[i] / most * light);
        let dim = f64::from(ULTRAVIOLET[i]);
        (dim + seen * (code - dim)).round().clamp(0.0, 255.0) as u8
    })
}

/// Draws the band below axes whose x are wavelengths in nm.
pub(crate) fn below(page: &mut Page, axes: &Axes, lang: Lang) {
    let (from, to) = axes.x.range;
    let mut nm = from;
    while nm < to {
        let (left, right) = (axes.at(nm, 0.0).0, axes.at((nm + 1.0).min(to), 0.0).0);
        // Each piece reaches under the next: no gap shows between them.
        let width = (right - left + 1.0).min(axes.rect.right() - left);
        page.fill(Rect { x: left, y: axes.rect.bottom(), width, height: HEIGHT }, color(nm + 0.5));
        nm += 1.0;
    }
    let whole = Rect { y: axes.rect.bottom(), height: HEIGHT, ..axes.rect };
    page.outline(whole, GRAY, 1.2);
    if from < 360.0 {
        let at = (0.5 * (axes.at(from, 0.0).0 + axes.at(380.0, 0.0).0), whole.bottom() - 3.5);
        page.text(lang.say(Word::Ultraviolet, &[]), at, Anchor::Middle, NUMBER - 2.0, WHITE);
    }
}

/// Draws the band to the left of axes whose y are wavelengths in nm.
pub(crate) fn beside(page: &mut Page, axes: &Axes) {
    let (from, to) = axes.y.range;
    let x = axes.rect.x - HEIGHT;
    let mut nm = from;
    while nm < to {
        let (bottom, top) = (axes.at(0.0, nm).1, axes.at(0.0, (nm + 1.0).min(to)).1);
        let y = (top - 1.0).max(axes.rect.y);
        page.fill(Rect { x, y, width: HEIGHT, height: bottom - y }, color(nm + 0.5));
        nm += 1.0;
    }
    page.outline(Rect { x, width: HEIGHT, ..axes.rect }, GRAY, 1.2);
}

/// Fills what lies under a curve of wavelengths with their colours.
pub(crate) fn under(page: &mut Page, axes: &Axes, value: impl Fn(f64) -> f64) {
    let (from, to) = axes.x.range;
    let mut nm = from;
    while nm < to {
        let next = (nm + 1.0).min(to);
        let (left, right) = (axes.at(nm, value(nm)), axes.at(next, value(next)));
        let ground = axes.at(nm, 0.0).1;
        let right_edge = (right.0 + 1.0).min(axes.rect.right());
        let corners = [(left.0, ground), left, (right_edge, right.1), (right_edge, ground)];
        page.area(corners, color(nm + 0.5));
        nm += 1.0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wavelengths_have_the_hues_of_their_names() {
        let [r, g, b] = color(450.0);
        assert!(b > r && b > g, "450 nm is blue");
        let [r, g, b] = color(530.0);
        assert!(g > r && g > b, "530 nm is green");
        let [r, g, b] = color(650.0);
        assert!(r > 2 * g.max(b), "650 nm is red");
        assert_eq!(color(320.0), ULTRAVIOLET);
    }
}
