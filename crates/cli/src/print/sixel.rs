//! Pictures as sixels: rows of six pixels, colour by colour (DEC VT340).

use std::fmt::Write;

use glanz_plot::Canvas;

/// Steps of red, green and blue in the palette, which has 6·7·6 colours: terminals have 256 registers.
const STEPS: [usize; 3] = [6, 7, 6];
/// Bayer's matrix of 4×4, whose fractions of a step are added before rounding.
const BAYER: [[usize; 4]; 4] = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]];

/// The picture for a terminal; what is transparent is as its codes say.
pub(super) fn sixel(picture: &Canvas) -> String {
    let (width, height) = (picture.width, picture.height);
    let mut text = format!("\x1bPq\"1;1;{width};{height}");
    for register in 0..STEPS.iter().product() {
        let [r, g, b] = levels(register);
        let percent = |level: usize, steps: usize| (100 * level + (steps - 1) / 2) / (steps - 1);
        let [r, g, b] = [percent(r, STEPS[0]), percent(g, STEPS[1]), percent(b, STEPS[2])];
        write!(text, "#{register};2;{r};{g};{b}").expect("a string takes everything");
    }
    for top in (0..height).step_by(6) {
        band(picture, top, &mut text);
    }
    text + "\x1b\\\n"
}

/// Six rows of the picture.
fn band(picture: &Canvas, top: usize, text: &mut String) {
    let rows = top..(top + 6).min(picture.height);
    let registers: Vec<Vec<usize>> =
        rows.map(|y| (0..picture.width).map(|x| register(picture, x, y)).collect()).collect();
    let mut used: Vec<usize> = registers.iter().flatten().copied().collect();
    used.sort_unstable();
    used.dedup();
    for color in used {
        write!(text, "#{color}").expect("a string takes everything");
        let bits = |x: usize| {
            let rows = registers.iter().enumerate();
            rows.fold(0, |bits, (i, row)| bits | u8::from(row[x] == color) << i)
        };
        let mut x = 0;
        while x < picture.width {
            let value = bits(x);
            let count = (x..picture.width).take_while(|x| bits(*x) == value).count();
            let letter = char::from(b'?' + value);
            match count {
                1..=3 => (0..count).for_each(|_| text.push(letter)),
                _ => write!(text, "!{count}{letter}").expect("a string takes everything"),
            }
            x += count;
        }
        // Back to the left, for the next colour.
        text.push('$');
    }
    text.push('-');
}

/// The number of a pixel's colour in the palette, dithered.
fn register(picture: &Canvas, x: usize, y: usize) -> usize {
    let pixel = &picture.rgba[4 * (y * picture.width + x)..][..3];
    let threshold = 2 * BAYER[y % 4][x % 4] + 1;
    let level = |code: u8, steps: usize| {
        // In 32nds of a step.
        let scaled = usize::from(code) * (steps - 1) * 32 / 255;
        ((scaled + threshold) / 32).min(steps - 1)
    };
    let [r, g, b] = [level(pixel[0], STEPS[0]), level(pixel[1], STEPS[1]), level(pixel[2], STEPS[2])];
    (r * STEPS[1] + g) * STEPS[2] + b
}

/// The steps of red, green and blue of a colour of the palette.
fn levels(register: usize) -> [usize; 3] {
    [register / (STEPS[1] * STEPS[2]), register / STEPS[2] % STEPS[1], register % STEPS[2]]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn white_and_black_are_the_ends_of_the_palette() {
        let text = sixel(&Canvas::new(10, 6, [255; 3]));
        assert!(text.starts_with("\x1bPq\"1;1;10;6#0;2;0;0;0"), "{text}");
        assert!(text.ends_with("#251!10~$-\x1b\\\n"), "{text}");
        assert!(sixel(&Canvas::new(2, 1, [0; 3])).ends_with("#0@@$-\x1b\\\n"));
    }

    #[test]
    fn a_grey_between_two_steps_is_dithered_in_proportion() {
        let picture = Canvas::new(4, 4, [25; 3]);
        let red = |x, y| levels(register(&picture, x, y))[0];
        let sum: usize = (0..16).map(|i| red(i % 4, i / 4)).sum();
        // 25 of 255 is 0.49 of a step of fifths.
        assert_eq!(sum, 8);
    }
}
