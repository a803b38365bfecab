//! A picture taken apart: by kinds of receptors, by the channels of the optic nerve.

use glanz_eye::{Cones, Eye, LUMINANCE, opponent};
use glanz_picture::Frame;
use glanz_plot::Canvas;

use super::code;
use super::source::Looked;
use crate::print::failure::Failure;

/// What each kind of receptors gets, in parts of what it gets from white.
pub(super) fn receptors(frame: &Frame, eye: &Eye, ev: f32) -> Vec<(String, Canvas)> {
    let gain = libm::exp2(f64::from(ev));
    let planes = frame.rgb.iter().chain(&frame.more);
    let pictures = planes.zip(&frame.channels.names).enumerate().map(|(c, (plane, name))| {
        let white = frame.channels.white.get(c).copied().filter(|white| *white > 0.0).unwrap_or(1.0);
        let missing = eye.cones.missing() == Some(c) || (eye.cones == Cones::None && c < 3);
        let title = match (name.as_str(), missing) {
            (name, true) => format!("{name}: missing"),
            ("R", false) => "rods".to_owned(),
            (name, false) => name.to_owned(),
        };
        let factor = if missing { 0.0 } else { gain / white };
        let pixels = plane.iter().map(|value| [(f64::from(*value) * factor) as f32; 3]);
        (title, canvas(frame, pixels))
    });
    pictures.collect()
}

/// A round number that holds all values of a channel: 1, 2 or 5 times a power of ten.
fn round_scale(values: &[[f64; 3]], channel: usize) -> f64 {
    let most = values.iter().map(|v| v[channel].abs()).filter(|v| v.is_finite()).fold(0.0, f64::max);
    let steps =
        (-3..3).flat_map(|power| [1.0, 2.0, 5.0].map(|step| step * libm::pow(10.0, f64::from(power))));
    steps.into_iter().find(|step| *step >= most).unwrap_or(most.max(1e-3))
}

/// The picture itself, and what the optic nerve carries of it.
pub(super) fn nerve(
    looked: &Looked,
    frame: &Frame,
    picture: Canvas,
    ev: f32,
) -> Result<Vec<(String, Canvas)>, Failure> {
    let gain = libm::exp2(f64::from(ev));
    let white: [f64; 3] = core::array::from_fn(|c| frame.channels.white.get(c).copied().unwrap_or(1.0));
    let values: Vec<[f64; 3]> =
        (0..frame.alpha.len()).map(|i| opponent_of(frame, i, white).map(|value| value * gain)).collect();
    let gray = |value: f64| [value.clamp(0.0, 1.0) as f32; 3];
    let mut pictures = vec![("picture".to_owned(), picture)];
    pictures.push(("luminance".to_owned(), canvas(frame, values.iter().map(|v| gray(v[0])))));
    for (channel, name) in [(1, "red - green"), (2, "yellow - blue")] {
        let scale = round_scale(&values, channel);
        let signed = values.iter().map(|v| {
            // Middle grey of the screen is 0.
            let code = 0.5 + 0.5 * (v[channel] / scale).clamp(-1.0, 1.0);
            [glanz_color::srgb_decode(code as f32); 3]
        });
        pictures.push((format!("{name}, +-{scale}"), canvas(frame, signed)));
        pictures
            .push((format!("{name}, in colour"), in_color(looked, frame, &values, channel, scale, white)?));
    }
    Ok(pictures)
}

fn opponent_of(frame: &Frame, i: usize, white: [f64; 3]) -> [f64; 3] {
    opponent([0, 1, 2].map(|c| f64::from(frame.rgb[c][i])), white)
}

/// The colours that differ from grey in one channel alone, at half of white's luminance; as strong as the screen shows them.
fn in_color(
    looked: &Looked,
    frame: &Frame,
    values: &[[f64; 3]],
    channel: usize,
    scale: f64,
    white: [f64; 3],
) -> Result<Canvas, Failure> {
    // What a screen shows of either: cherry and teal differ in L − M by little.
    let most = if channel == 1 { 0.12 } else { 0.45 };
    let strength = most / scale;
    let mut colored = frame.clone();
    for (i, value) in values.iter().enumerate() {
        let v = value[channel] * strength;
        // L and M so that luminance stays, S so that the other channel is 0.
        let [l, m, s] = match channel {
            1 => {
                let (l, m) = (0.5 + LUMINANCE[1] * v, 0.5 - LUMINANCE[0] * v);
                [l, m, 0.5 * (l + m)]
            }
            _ => [0.5, 0.5, 0.5 - v],
        };
        for (plane, (part, white)) in colored.rgb.iter_mut().zip([l, m, s].into_iter().zip(white)) {
            plane[i] = (part * white) as f32;
        }
    }
    let screen = looked.on_screen(colored)?;
    let gain = 1.0 / luminance_scale(&screen);
    let pixels =
        (0..screen.alpha.len()).map(|i| [0, 1, 2].map(|c| (f64::from(screen.rgb[c][i]) * gain) as f32));
    Ok(canvas(frame, pixels))
}

/// Frames in photometric units are shown darker than 1: the factor by which grey of one half is.
fn luminance_scale(screen: &Frame) -> f64 {
    let count = screen.alpha.len().max(1) as f64;
    let sum: f64 = (0..screen.alpha.len())
        .map(|i| {
            0.2126 * f64::from(screen.rgb[0][i])
                + 0.7152 * f64::from(screen.rgb[1][i])
                + 0.0722 * f64::from(screen.rgb[2][i])
        })
        .sum();
    (sum / count / 0.5).max(1e-12)
}

fn canvas(frame: &Frame, pixels: impl Iterator<Item = [f32; 3]>) -> Canvas {
    Canvas { width: frame.width, height: frame.height, rgba: pixels.flat_map(code).collect() }
}
