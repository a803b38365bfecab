//! Colours and sizes that all plots share.

/// Red, green and blue as sRGB codes.
pub type Rgb8 = [u8; 3];

/// Titles and what is most important.
pub(crate) const INK: Rgb8 = [0x1f, 0x24, 0x2b];
/// Axes and labels.
pub(crate) const GRAY: Rgb8 = [0x5b, 0x63, 0x6e];
/// The lines of the grid.
pub(crate) const GRID: Rgb8 = [0xe3, 0xe6, 0xea];
/// Paper.
pub(crate) const WHITE: Rgb8 = [0xff; 3];

/// Colours of curves: those of Okabe and Ito (2008), which the colour-blind tell apart, in an order that
/// keeps neighbours different; yellow is left out, for it is too light on white.
pub(crate) const CURVES: [Rgb8; 8] = [
    [0x00, 0x72, 0xb2],
    [0xd5, 0x5e, 0x00],
    [0x00, 0x9e, 0x73],
    [0xcc, 0x79, 0xa7],
    [0xe6, 0x9f, 0x00],
    [0x56, 0xb4, 0xe9],
    [0x1f, 0x24, 0x2b],
    [0x8a, 0x93, 0x9e],
];

/// The size of a title in points.
pub(crate) const TITLE: f64 = 24.0;
/// The size of a line below a title, and of labels of axes.
pub(crate) const LABEL: f64 = 15.5;
/// The size of numbers at axes and of legends.
pub(crate) const NUMBER: f64 = 14.0;

/// How curves are dashed, by how often their colour has been used before.
const DASHES: [Option<(f64, f64)>; 4] = [None, Some((9.0, 6.0)), Some((2.5, 4.0)), Some((16.0, 5.0))];

/// The dashes of the curve with this number, from 0: none until the colours are used up.
pub fn curve_dash(index: usize) -> Option<(f64, f64)> {
    DASHES[index / CURVES.len() % DASHES.len()]
}

/// The dashes with this number, from 0: none for the first.
pub fn dash(number: usize) -> Option<(f64, f64)> {
    DASHES[number % DASHES.len()]
}

/// The colour of the curve with this number, from 0.
pub fn curve_color(index: usize) -> Rgb8 {
    CURVES[index % CURVES.len()]
}
