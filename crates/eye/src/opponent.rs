//! The channels of the optic nerve: luminance, red against green, yellow against blue.

use crate::stages::LUMINANCE;

/// What the three kinds of cones become on their way to the brain (A. M. Derrington, J. Krauskopf, P. Lennie, 1984, but for scale):
/// luminance, red against green, yellow against blue, from L, M, S and what they are for white.
///
/// Luminance is 1 for white, the two others are 0 for white and all greys. Their ends are cherry and teal, violet and lime, not the
/// four colours that people call pure.
///
/// ```
/// use glanz_color::{colorchecker, light};
/// use glanz_eye::{Eye, opponent};
///
/// let (eye, d65) = (Eye::default().observer(), light("D65")?);
/// let lms = |spectrum| -> [f64; 3] { eye.response(&spectrum).try_into().expect("three cones") };
/// let (_, red) = colorchecker().find(|(name, _)| *name == "red").expect("a patch");
/// let [luminance, red_green, yellow_blue] = opponent(lms(red * d65), lms(d65));
/// assert!((luminance - 0.1215).abs() < 1e-4);
/// assert!((red_green - 0.0710).abs() < 1e-4 && (yellow_blue - 0.0595).abs() < 1e-4);
/// assert_eq!(opponent(lms(d65), lms(d65)), [1.0, 0.0, 0.0]);
/// # Ok::<(), glanz_color::UnknownName>(())
/// ```
pub fn opponent(lms: [f64; 3], white: [f64; 3]) -> [f64; 3] {
    let [l, m, s] = core::array::from_fn(|c| if white[c] > 0.0 { lms[c] / white[c] } else { 0.0 });
    [LUMINANCE[0] * l + LUMINANCE[1] * m, l - m, 0.5 * (l + m) - s]
}
