//! All channels of an observation: one frame for three, several for more, very many for the reference.
//!
//! The rasteriser draws three channels at a time. An observer with more gets several frames, whose only
//! difference is the tint table.

mod reference;

use glanz_scene::{Background, ColorMode, Scene};

use crate::{Aovs, DrawOptions, Frame, PrepareError, PrepareOptions, Prepared, View, draw};

/// Draws every channel of `options.observation`; the first three are the frame's `rgb`, the others its
/// `more`.
///
/// `prepared` has been made from `scene` with these options; of the scene only lights and materials are
/// read. `step` is told how much of the work is done, from 0 to 1.
pub fn draw_observed(
    prepared: &Prepared,
    scene: &Scene,
    options: &PrepareOptions,
    view: &View,
    draw_options: &DrawOptions,
    step: &mut dyn FnMut(f64),
) -> Result<Frame, PrepareError> {
    if options.observation.mode() == ColorMode::Reference {
        return reference::draw(prepared, scene, options, view, draw_options, step);
    }
    let count = options.observation.channel_count();
    let mut frame = draw(prepared, view, draw_options);
    for plane in frame.rgb.iter_mut().skip(count) {
        plane.fill(0.0);
    }
    for first in (3..count).step_by(3) {
        step(first as f64 / count as f64);
        let own = PrepareOptions { first_channel: first, ..options.clone() };
        let next = prepared.refilled(scene, &own)?;
        // A background of three numbers says nothing of further channels.
        let bare =
            DrawOptions { background: bare(draw_options.background), aovs: Aovs::default(), ..*draw_options };
        let planes = draw(&next, view, &bare).rgb;
        frame.more.extend(planes.into_iter().take(count - first));
    }
    Ok(frame)
}

/// A background that adds no light.
fn bare(background: Background) -> Background {
    match background {
        Background::Color(_) => Background::Color(glanz_color::Rgb::BLACK),
        Background::Transparent => Background::Transparent,
        // Surroundings are seen in every channel.
        Background::Environment => Background::Environment,
    }
}
