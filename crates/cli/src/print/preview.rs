//! A picture in the terminal: two pixels per letter, one above the other, in 24-bit colour.

use std::fmt::Write;

use glanz_plot::Canvas;

/// Columns where the terminal does not tell.
const DEFAULT_COLUMNS: usize = 80;

/// How many columns the terminal has; `COLUMNS` counts where it is not asked itself.
pub(crate) fn columns() -> usize {
    let from_terminal = terminal_size::terminal_size().map(|(width, _)| usize::from(width.0));
    let from_variable = || std::env::var("COLUMNS").ok()?.parse().ok();
    from_terminal.or_else(from_variable).filter(|columns| *columns > 0).unwrap_or(DEFAULT_COLUMNS)
}

/// The picture as lines of upper half blocks, not wider than `columns`. Transparent pixels are drawn
/// over black.
pub(crate) fn half_blocks(picture: &Canvas, columns: usize) -> String {
    let width = picture.width.min(columns).max(1);
    let height = (picture.height * width).div_ceil(picture.width.max(1)).max(1).next_multiple_of(2);
    let mut text = String::new();
    for y in (0..height).step_by(2) {
        for x in 0..width {
            let [r, g, b] = mean(picture, (x, y), (width, height));
            let [lower_r, lower_g, lower_b] = mean(picture, (x, y + 1), (width, height));
            write!(text, "\x1b[38;2;{r};{g};{b}m\x1b[48;2;{lower_r};{lower_g};{lower_b}m▀")
                .expect("a string takes everything");
        }
        text.push_str("\x1b[0m\n");
    }
    text
}

/// The mean of the codes that pixel (x, y) of a picture of `size` covers.
fn mean(picture: &Canvas, (x, y): (usize, usize), (width, height): (usize, usize)) -> [u8; 3] {
    let span = |i: usize, parts: usize, whole: usize| {
        let begin = i * whole / parts;
        begin..((i + 1) * whole / parts).max(begin + 1).min(whole)
    };
    let (mut sum, mut count) = ([0_u64; 3], 0);
    for row in span(y, height, picture.height) {
        for column in span(x, width, picture.width) {
            let pixel = &picture.rgba[4 * (row * picture.width + column)..][..4];
            for (sum, code) in sum.iter_mut().zip(pixel) {
                *sum += u64::from(*code) * u64::from(pixel[3]) / 255;
            }
            count += 1;
        }
    }
    sum.map(|sum| (sum / count.max(1)) as u8)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_rows_of_pixels_make_one_line() {
        let mut picture = Canvas::new(1, 2, [1, 2, 3]);
        picture.rgba[4..7].copy_from_slice(&[4, 5, 6]);
        assert_eq!(half_blocks(&picture, 80), "\x1b[38;2;1;2;3m\x1b[48;2;4;5;6m▀\x1b[0m\n");
    }

    #[test]
    fn a_wide_picture_shrinks_to_the_columns() {
        let text = half_blocks(&Canvas::new(300, 200, [7; 3]), 30);
        assert_eq!(text.lines().count(), 10);
        assert!(text.lines().all(|line| line.matches('▀').count() == 30));
        assert!(!text.contains("48;2;6"), "the mean of equal codes is that code");
    }

    #[test]
    fn any_shape_of_picture_can_be_shown() {
        for (width, height) in [(1, 1), (1, 100), (1000, 1), (7, 3)] {
            assert!(!half_blocks(&Canvas::new(width, height, [0; 3]), 10).is_empty());
        }
    }
}
