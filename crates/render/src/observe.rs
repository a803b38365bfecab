//! All channels of an observation: one frame for three, several for more, very many for the reference.
//!
//! A back end draws three channels at a time. An observer with more gets several frames, whose only difference is
//! the tint table.

mod reference;

use glanz_color::{ObserverKind, Rgb};
use glanz_picture::Frame;
use glanz_scene::{Background, ColorMode};

use crate::Backend;
use crate::prepare::{Observation, PrepareError, Prepared};
use crate::view::{Aovs, DrawOptions, View};

/// Whether the observation of a prepared scene takes more than one frame of three channels.
pub fn takes_several_frames(prepared: &Prepared) -> bool {
    let observation = prepared.observation();
    observation.mode() == ColorMode::Reference || observation.channel_count() > 3
}

/// Draws every channel of the observation that a scene was prepared for; the first three are the frame's `rgb`, the
/// others its `more`. `step` is told how much of the work is done, from 0 to 1.
///
/// # Errors
/// As [`prepare`](crate::prepare::prepare).
pub fn draw_observed(
    backend: &mut dyn Backend,
    prepared: &Prepared,
    view: &View,
    options: &DrawOptions,
    step: &mut dyn FnMut(f64),
) -> Result<Frame, PrepareError> {
    let mut frame = Frame::default();
    draw_observed_into(backend, prepared, view, options, &mut frame, step)?;
    Ok(frame)
}

/// [`draw_observed`] into a frame that was drawn before, whose memory is used again; all that it held is replaced.
///
/// # Errors
/// As [`draw_observed`]; what the frame then holds is of no use.
pub fn draw_observed_into(
    backend: &mut dyn Backend,
    prepared: &Prepared,
    view: &View,
    options: &DrawOptions,
    frame: &mut Frame,
    step: &mut dyn FnMut(f64),
) -> Result<(), PrepareError> {
    match prepared.observation().mode() {
        ColorMode::Reference => *frame = reference::draw(backend, prepared, view, options, step)?,
        _ => draw_in_threes(backend, prepared, view, options, frame, step)?,
    }
    if options.show.is_light() {
        frame.channels = prepared.all_channels();
    }
    Ok(())
}

fn draw_in_threes(
    backend: &mut dyn Backend,
    prepared: &Prepared,
    view: &View,
    options: &DrawOptions,
    frame: &mut Frame,
    step: &mut dyn FnMut(f64),
) -> Result<(), PrepareError> {
    let count = prepared.observation().channel_count();
    backend.draw_into(prepared, view, options, frame);
    for plane in frame.rgb.iter_mut().skip(count) {
        plane.fill(0.0);
    }
    let bare = DrawOptions {
        background: bare(prepared.observation(), options.background),
        aovs: Aovs::default(),
        ..*options
    };
    for first in (3..count).step_by(3) {
        step(first as f64 / count as f64);
        let next = prepared.channels_from(first)?;
        let planes = backend.draw(&next, view, &bare).rgb;
        frame.more.extend(planes.into_iter().take(count - first));
    }
    Ok(())
}

/// The background of further channels: a colour of three numbers says nothing of them, and adds no light. Rods, which come after the
/// three kinds of cones, see its luminance.
fn bare(observation: &Observation, background: Background) -> Background {
    let is_eye = observation.observer().is_some_and(|eye| eye.kind == ObserverKind::Lms);
    match background {
        Background::Color(Rgb([l, m, _])) if is_eye => {
            Background::Color(Rgb([0.698_134 * l + 0.301_866 * m, 0.0, 0.0]))
        }
        Background::Color(_) => Background::Color(Rgb::BLACK),
        Background::Transparent => Background::Transparent,
        // An environment is seen in every channel.
        Background::Environment => Background::Environment,
    }
}
