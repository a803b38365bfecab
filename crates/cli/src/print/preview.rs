//! A picture in the terminal: in half blocks of 24-bit colour, or as a picture where the terminal knows how.

use std::fmt::Write;
use std::io::{self, IsTerminal};

use clap::ValueEnum;
use glanz_picture::output::{Effort, Metadata, write_png8};
use glanz_plot::Canvas;

use super::failure::Failure;
use super::sixel::sixel;
use super::{bytes, note};

/// Columns and rows where the terminal does not tell.
const DEFAULT_SIZE: (usize, usize) = (80, 24);
/// Bytes of a part of a picture, in the protocol of kitty.
const KITTY_PART: usize = 4096;
/// The pixels of a letter where the terminal does not tell.
const CELL: (usize, usize) = (8, 16);

/// How a picture is shown in the terminal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum PreviewMode {
    /// As a picture where the terminal is known to show one, else in blocks; not into pipes
    Auto,
    /// Two pixels per letter, one above the other
    Blocks,
    /// As a picture, by the sixels of xterm, foot, mlterm, Windows Terminal
    Sixel,
    /// As a picture, by the protocol of kitty, Ghostty, Konsole
    Kitty,
    /// As a picture, by the protocol of iTerm2, WezTerm
    Iterm,
}

impl PreviewMode {
    /// Shows the picture.
    pub(crate) fn show(self, picture: &Canvas) -> Result<(), Failure> {
        let mode = match self {
            Self::Auto if !can_show() => {
                note(
                    "note: --preview needs a terminal that shows colours, so nothing is shown; --preview=blocks does anyway",
                );
                return Ok(());
            }
            Self::Auto => detected(|name| std::env::var(name).ok()),
            mode => mode,
        };
        let (columns, rows) = terminal_size();
        // The last line is for what the shell says next.
        let rows = rows.saturating_sub(1).max(1);
        match mode {
            Self::Sixel => bytes(sixel(&shrunk(picture, (columns * CELL.0, rows * CELL.1))).as_bytes()),
            Self::Kitty => bytes(kitty(&png(picture)?, fitting(picture, columns, rows)).as_bytes()),
            Self::Iterm => bytes(iterm(&png(picture)?, fitting(picture, columns, rows)).as_bytes()),
            _ => bytes(half_blocks(picture, columns, rows).as_bytes()),
        }
    }
}

/// Whether stdout is a terminal that takes more than text.
fn can_show() -> bool {
    io::stdout().is_terminal() && std::env::var("TERM").ok().as_deref() != Some("dumb")
}

/// The best way that the terminal is known to have, by the variables that it sets.
fn detected(variable: impl Fn(&str) -> Option<String>) -> PreviewMode {
    let term = variable("TERM").unwrap_or_default();
    let program = variable("TERM_PROGRAM").unwrap_or_default();
    // A multiplexer passes no pictures on.
    if variable("TMUX").is_some() || term.starts_with("screen") || term.starts_with("tmux") {
        return PreviewMode::Blocks;
    }
    if variable("KITTY_WINDOW_ID").is_some() || term.contains("kitty") || program == "ghostty" {
        return PreviewMode::Kitty;
    }
    match program.as_str() {
        "iTerm.app" | "WezTerm" => PreviewMode::Iterm,
        _ if ["foot", "mlterm", "contour"].iter().any(|name| term.starts_with(name)) => PreviewMode::Sixel,
        _ => PreviewMode::Blocks,
    }
}

/// Columns and rows of the terminal; `COLUMNS` and `LINES` count where it is not asked itself.
fn terminal_size() -> (usize, usize) {
    let from_terminal = terminal_size::terminal_size().map(|(w, h)| (usize::from(w.0), usize::from(h.0)));
    let variable = |name: &str| std::env::var(name).ok()?.parse::<usize>().ok().filter(|n| *n > 0);
    let (columns, rows) = from_terminal.unwrap_or((
        variable("COLUMNS").unwrap_or(DEFAULT_SIZE.0),
        variable("LINES").unwrap_or(DEFAULT_SIZE.1),
    ));
    (columns.max(1), rows.max(1))
}

fn png(picture: &Canvas) -> Result<Vec<u8>, Failure> {
    let mut file = Vec::new();
    write_png8(
        &mut file,
        (picture.width, picture.height),
        &picture.rgba,
        Effort::Fast,
        &Metadata::default(),
    )?;
    Ok(file)
}

/// The columns and rows that a picture takes which fills the terminal in one direction and keeps its form.
fn fitting(picture: &Canvas, columns: usize, rows: usize) -> (usize, usize) {
    let (width, height) = (picture.width.max(1), picture.height.max(1));
    let (cell_width, cell_height) = CELL;
    // As wide as the terminal, in letters high.
    let high = (columns * cell_width * height).div_ceil(width * cell_height);
    match high <= rows {
        true => (columns, high.max(1)),
        false => ((rows * cell_height * width / (height * cell_width)).clamp(1, columns), rows),
    }
}

/// The picture by the protocol of kitty: a PNG in parts.
fn kitty(png: &[u8], (columns, rows): (usize, usize)) -> String {
    let code = base64(png);
    let mut text = String::new();
    let parts = code.as_bytes().chunks(KITTY_PART);
    let last = parts.len().saturating_sub(1);
    for (i, part) in parts.enumerate() {
        let keys = if i == 0 { format!("a=T,f=100,c={columns},r={rows},") } else { String::new() };
        let part = str::from_utf8(part).expect("base64 is ASCII");
        write!(text, "\x1b_G{keys}m={};{part}\x1b\\", u8::from(i < last)).expect("a string takes everything");
    }
    text + "\n"
}

/// The picture by the protocol of iTerm2: a PNG.
fn iterm(png: &[u8], (columns, rows): (usize, usize)) -> String {
    let (size, code) = (png.len(), base64(png));
    format!(
        "\x1b]1337;File=inline=1;size={size};width={columns};height={rows};preserveAspectRatio=1:{code}\x07\n"
    )
}

/// RFC 4648.
fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let word =
            three.iter().fold(0_u32, |word, byte| word << 8 | u32::from(*byte)) << (8 * (3 - three.len()));
        for i in 0..4 {
            let letter = LETTERS[(word >> (18 - 6 * i) & 63) as usize];
            text.push(if i <= three.len() { char::from(letter) } else { '=' });
        }
    }
    text
}

/// The picture within this size.
fn shrunk(picture: &Canvas, (most_wide, most_high): (usize, usize)) -> Canvas {
    let (width, height) = within(picture, most_wide, most_high);
    let mut rgba = Vec::with_capacity(4 * width * height);
    for y in 0..height {
        for x in 0..width {
            let [r, g, b] = mean(picture, (x, y), (width, height));
            rgba.extend([r, g, b, 255]);
        }
    }
    Canvas { width, height, rgba }
}

/// The size of the picture, made smaller if it does not fit.
fn within(picture: &Canvas, most_wide: usize, most_high: usize) -> (usize, usize) {
    let (width, height) = (picture.width.max(1), picture.height.max(1));
    let narrow = width.min(most_wide);
    match (height * narrow).div_ceil(width) {
        high if high <= most_high => (narrow, high.max(1)),
        _ => ((width * most_high / height).max(1), most_high),
    }
}

/// The picture as lines of upper half blocks, not more than fit. Transparent pixels are drawn over black.
fn half_blocks(picture: &Canvas, columns: usize, rows: usize) -> String {
    let (width, height) = within(picture, columns, 2 * rows);
    let height = height.next_multiple_of(2);
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
        assert_eq!(half_blocks(&picture, 80, 24), "\x1b[38;2;1;2;3m\x1b[48;2;4;5;6m▀\x1b[0m\n");
    }

    #[test]
    fn a_picture_shrinks_to_the_columns_and_rows() {
        for (size, terminal, lines, letters) in
            [((300, 200), (30, 99), 10, 30), ((300, 200), (300, 10), 10, 30), ((10, 10), (80, 24), 5, 10)]
        {
            let text = half_blocks(&Canvas::new(size.0, size.1, [7; 3]), terminal.0, terminal.1);
            assert_eq!(text.lines().count(), lines, "{size:?} in {terminal:?}");
            assert!(
                text.lines().all(|line| line.matches('▀').count() == letters),
                "{size:?} in {terminal:?}"
            );
            assert!(!text.contains("48;2;6"), "the mean of equal codes is that code");
        }
    }

    #[test]
    fn any_shape_of_picture_can_be_shown() {
        for (width, height) in [(1, 1), (1, 100), (1000, 1), (7, 3)] {
            let picture = Canvas::new(width, height, [0; 3]);
            assert!(!half_blocks(&picture, 10, 5).is_empty());
            assert!(half_blocks(&picture, 10, 5).lines().count() <= 5);
            let (columns, rows) = fitting(&picture, 10, 5);
            assert!(
                (1..=10).contains(&columns) && (1..=5).contains(&rows),
                "{width}x{height}: {columns}x{rows}"
            );
        }
    }

    #[test]
    fn a_terminal_is_known_by_its_variables() {
        let of = |variables: &'static [(&str, &str)]| {
            detected(move |asked| {
                variables.iter().find(|(name, _)| *name == asked).map(|(_, value)| (*value).to_owned())
            })
        };
        assert_eq!(of(&[("TERM", "xterm-kitty")]), PreviewMode::Kitty);
        assert_eq!(of(&[("TERM", "xterm-256color"), ("TERM_PROGRAM", "iTerm.app")]), PreviewMode::Iterm);
        assert_eq!(of(&[("TERM", "foot-extra")]), PreviewMode::Sixel);
        assert_eq!(of(&[("TERM", "xterm-256color")]), PreviewMode::Blocks);
        assert_eq!(of(&[("TERM", "xterm-kitty"), ("TMUX", "/tmp/tmux")]), PreviewMode::Blocks);
    }

    #[test]
    fn bytes_become_letters_of_base64() {
        // The test vectors of RFC 4648, section 10.
        for (bytes, text) in
            [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foobar", "Zm9vYmFy")]
        {
            assert_eq!(base64(bytes.as_bytes()), text);
        }
    }

    #[test]
    fn a_long_picture_goes_to_kitty_in_parts() {
        let text = kitty(&[7; 7000], (10, 5));
        assert_eq!(text.matches("\x1b_G").count(), 3);
        assert!(text.starts_with("\x1b_Ga=T,f=100,c=10,r=5,m=1;") && text.contains("\x1b_Gm=0;"));
    }
}
