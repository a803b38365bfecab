//! GIF from a row of RGBA pictures.

use std::io::Write;

#[cfg(not(feature = "gif"))]
use super::Format;
#[cfg(feature = "gif")]
use super::error::check_size;
#[cfg(feature = "gif")]
use super::palette::{Indexed, indexed};
use super::{Animation, Metadata, OutputError};

/// Writes frames of RGBA with straight alpha as a GIF that repeats for ever.
///
/// Each frame has a palette of its own of up to 256 colours, between which more are dithered; what the picture says about
/// its making stands in a comment. Pixels are opaque or transparent,
/// whichever alpha is nearer to. A frame that fails ends the writing with its error. Needs the feature
/// `gif`: without it the error is [`OutputError::FeatureOff`].
///
#[cfg_attr(feature = "gif", doc = "```")]
#[cfg_attr(not(feature = "gif"), doc = "```ignore")]
/// use glanz_picture::output::{Animation, Metadata, OutputError, write_gif};
///
/// let animation = Animation { width: 1, height: 1, frames: 2, frame_s: 0.1 };
/// let frames: [Result<Vec<u8>, OutputError>; 2] = [Ok(vec![255; 4]), Ok(vec![0, 0, 0, 255])];
/// let mut file = Vec::new();
/// write_gif(&mut file, &animation, frames, &Metadata::default())?;
/// assert!(file.starts_with(b"GIF89a"));
/// # Ok::<(), OutputError>(())
/// ```
pub fn write_gif<E: From<OutputError>>(
    out: impl Write,
    animation: &Animation,
    frames: impl IntoIterator<Item = Result<Vec<u8>, E>>,
    metadata: &Metadata,
) -> Result<(), E> {
    encode(out, animation, frames, metadata)
}

#[cfg(not(feature = "gif"))]
fn encode<E: From<OutputError>>(
    _out: impl Write,
    _animation: &Animation,
    _frames: impl IntoIterator<Item = Result<Vec<u8>, E>>,
    _metadata: &Metadata,
) -> Result<(), E> {
    Ok(Format::Gif.check_feature().map_err(OutputError::from)?)
}

#[cfg(feature = "gif")]
fn encode<E: From<OutputError>>(
    out: impl Write,
    animation: &Animation,
    frames: impl IntoIterator<Item = Result<Vec<u8>, E>>,
    metadata: &Metadata,
) -> Result<(), E> {
    let side = |n: usize| u16::try_from(n).ok().filter(|n| *n > 0);
    let (Some(width), Some(height)) = (side(animation.width), side(animation.height)) else {
        let (width, height) = (animation.width, animation.height);
        let message = format!("both sides must be between 1 and 65535 pixels, but are {width}×{height}");
        return Err(OutputError::Encode { format: "GIF", message }.into());
    };
    let mut encoder = ::gif::Encoder::new(out, width, height, &[]).map_err(gif_failed)?;
    encoder.set_repeat(::gif::Repeat::Infinite).map_err(gif_failed)?;
    let comment = ::gif::AnyExtension::from(::gif::Extension::Comment);
    encoder.write_raw_extension(comment, &[metadata.text().as_bytes()]).map_err(gif_failed)?;
    let delay = animation.gif_hundredths();
    for frame in frames {
        let mut rgba = frame?;
        check_size(animation.width, animation.height, 4, rgba.len())?;
        for pixel in rgba.chunks_exact_mut(4) {
            pixel[3] = if pixel[3] < 128 { 0 } else { 255 };
        }
        let Indexed { palette, pixels, transparent } = indexed(&rgba, animation.width);
        let mut frame = ::gif::Frame::from_palette_pixels(width, height, pixels, palette, transparent);
        frame.delay = delay;
        // Cleared after each frame, so that transparent pixels show no older frame.
        frame.dispose = ::gif::DisposalMethod::Background;
        encoder.write_frame(&frame).map_err(gif_failed)?;
    }
    encoder.into_inner().map_err(gif_failed)?.flush().map_err(OutputError::Stream)?;
    Ok(())
}

#[cfg(feature = "gif")]
fn gif_failed(error: ::gif::EncodingError) -> OutputError {
    match error {
        ::gif::EncodingError::Io(error) => OutputError::Stream(error),
        other => OutputError::Encode { format: "GIF", message: other.to_string() },
    }
}

#[cfg(test)]
mod tests {
    #[cfg(feature = "gif")]
    use std::io::Cursor;

    use super::*;

    const SHAPE: Animation = Animation { width: 4, height: 3, frames: 3, frame_s: 0.04 };

    /// Frames of a few flat colours, the last pixel transparent.
    fn frames() -> Vec<Vec<u8>> {
        let frame = |n: u8| {
            let mut rgba: Vec<u8> = (0..12u8).flat_map(|i| [n * 80, (i % 4) * 60, 200, 255]).collect();
            rgba[47] = 0;
            rgba
        };
        (0..3).map(frame).collect()
    }

    fn ok(frames: Vec<Vec<u8>>) -> impl Iterator<Item = Result<Vec<u8>, OutputError>> {
        frames.into_iter().map(Ok)
    }

    #[test]
    #[cfg(not(feature = "gif"))]
    fn without_the_feature_the_error_names_it() {
        let error = write_gif(Vec::new(), &SHAPE, ok(frames()), &Metadata::default()).unwrap_err();
        let expected = "GIF: Glanz was built without the feature `gif`; add features = [\"gif\"]";
        assert_eq!(error.to_string(), expected);
    }

    #[test]
    #[cfg(feature = "gif")]
    fn gif_frames_of_few_colours_come_back() {
        let mut file = Vec::new();
        write_gif(&mut file, &SHAPE, ok(frames()), &Metadata::default()).unwrap();
        let says = |text: &str| file.windows(text.len()).any(|bytes| bytes == text.as_bytes());
        assert!(says("Software: glanz "), "the comment names the program");
        let mut options = ::gif::DecodeOptions::new();
        options.set_color_output(::gif::ColorOutput::RGBA);
        let mut reader = options.read_info(Cursor::new(file)).unwrap();
        assert_eq!(reader.repeat(), ::gif::Repeat::Infinite);
        let mut count = 0;
        while let Some(frame) = reader.read_next_frame().unwrap() {
            assert_eq!((frame.width, frame.height, frame.delay), (4, 3, 4));
            assert_eq!(frame.buffer[..44], frames()[count][..44]);
            assert_eq!(frame.buffer[47], 0);
            count += 1;
        }
        assert_eq!(count, 3);
    }

    #[test]
    #[cfg(feature = "gif")]
    fn a_frame_that_fails_ends_the_writing_with_its_error() {
        let failure = OutputError::Encode { format: "test", message: "broken".to_owned() };
        let failing = vec![Ok(frames()[0].clone()), Err(failure)];
        let error = write_gif(Vec::new(), &SHAPE, failing, &Metadata::default()).unwrap_err();
        assert!(error.to_string().contains("broken"), "{error}");
    }

    #[test]
    #[cfg(feature = "gif")]
    fn a_picture_too_wide_for_gif_is_an_error() {
        let wide = Animation { width: 65_536, ..SHAPE };
        let error = write_gif(Vec::new(), &wide, ok(Vec::new()), &Metadata::default()).unwrap_err();
        assert!(error.to_string().contains("65536×3"), "{error}");
    }
}
