//! GIF and APNG from a row of RGBA pictures.

use std::io::Write;

use super::error::check_size;
use super::png::{encoder, failed};
use super::{Metadata, OutputError};

/// What all frames of an animation share.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Animation {
    /// Width in pixels.
    pub width: usize,
    /// Height in pixels.
    pub height: usize,
    /// How many frames there will be.
    pub frames: usize,
    /// How long each is shown, in milliseconds. GIF rounds to hundredths of a second.
    pub delay_ms: u32,
}

/// Writes frames of RGBA with straight alpha as a GIF that repeats for ever.
///
/// Each frame has a palette of its own of up to 256 colours. Pixels are opaque or transparent,
/// whichever alpha is nearer to. A frame that fails ends the writing with its error.
///
/// ```
/// use glanz_picture::output::{Animation, OutputError, write_gif};
///
/// let animation = Animation { width: 1, height: 1, frames: 2, delay_ms: 100 };
/// let frames: [Result<Vec<u8>, OutputError>; 2] = [Ok(vec![255; 4]), Ok(vec![0, 0, 0, 255])];
/// let mut file = Vec::new();
/// write_gif(&mut file, &animation, frames)?;
/// assert!(file.starts_with(b"GIF89a"));
/// # Ok::<(), OutputError>(())
/// ```
pub fn write_gif<E: From<OutputError>>(
    out: impl Write,
    animation: &Animation,
    frames: impl IntoIterator<Item = Result<Vec<u8>, E>>,
) -> Result<(), E> {
    let side = |n: usize| u16::try_from(n).ok().filter(|n| *n > 0);
    let (Some(width), Some(height)) = (side(animation.width), side(animation.height)) else {
        let (width, height) = (animation.width, animation.height);
        let message = format!("both sides must be between 1 and 65535 pixels, but are {width}×{height}");
        return Err(OutputError::Encode { format: "GIF", message }.into());
    };
    let mut encoder = gif::Encoder::new(out, width, height, &[]).map_err(gif_failed)?;
    encoder.set_repeat(gif::Repeat::Infinite).map_err(gif_failed)?;
    let delay = u16::try_from(animation.delay_ms.saturating_add(5) / 10).unwrap_or(u16::MAX);
    for frame in frames {
        let mut rgba = frame?;
        check_size(animation.width, animation.height, 4, rgba.len())?;
        for pixel in rgba.chunks_exact_mut(4) {
            pixel[3] = if pixel[3] < 128 { 0 } else { 255 };
        }
        let mut frame = gif::Frame::from_rgba_speed(width, height, &mut rgba, 10);
        frame.delay = delay;
        // Cleared after each frame, so that transparent pixels show no older frame.
        frame.dispose = gif::DisposalMethod::Background;
        encoder.write_frame(&frame).map_err(gif_failed)?;
    }
    encoder.into_inner().map_err(gif_failed)?.flush().map_err(OutputError::Stream)?;
    Ok(())
}

/// Writes frames of RGBA with straight alpha as an animated PNG that repeats for ever.
///
/// `animation.frames` must be the number of frames that come. A frame that fails ends the writing
/// with its error.
pub fn write_apng<E: From<OutputError>>(
    out: impl Write,
    animation: &Animation,
    frames: impl IntoIterator<Item = Result<Vec<u8>, E>>,
    metadata: &Metadata,
) -> Result<(), E> {
    let wrong = |found: usize| {
        let message = format!("{} frames were announced, but {found} came", animation.frames);
        OutputError::Encode { format: "APNG", message }
    };
    let count = u32::try_from(animation.frames).ok().filter(|n| *n > 0).ok_or_else(|| wrong(0))?;
    let mut encoder = encoder(out, (animation.width, animation.height), metadata)?;
    encoder.set_color(::png::ColorType::Rgba);
    encoder.set_depth(::png::BitDepth::Eight);
    encoder.set_deflate_compression(::png::DeflateCompression::FdeflateUltraFast);
    encoder.set_filter(::png::Filter::Up);
    encoder.set_animated(count, 0).map_err(failed)?;
    let (numerator, denominator) = match u16::try_from(animation.delay_ms) {
        Ok(ms) => (ms, 1000),
        Err(_) => (u16::try_from(animation.delay_ms / 1000).unwrap_or(u16::MAX), 1),
    };
    encoder.set_frame_delay(numerator, denominator).map_err(failed)?;
    let mut writer = encoder.write_header().map_err(failed)?;
    let mut found = 0;
    for frame in frames {
        let rgba = frame?;
        found += 1;
        if found > animation.frames {
            return Err(wrong(found).into());
        }
        check_size(animation.width, animation.height, 4, rgba.len())?;
        writer.write_image_data(&rgba).map_err(failed)?;
    }
    if found != animation.frames {
        return Err(wrong(found).into());
    }
    Ok(writer.finish().map_err(failed)?)
}

fn gif_failed(error: gif::EncodingError) -> OutputError {
    match error {
        gif::EncodingError::Io(error) => OutputError::Stream(error),
        other => OutputError::Encode { format: "GIF", message: other.to_string() },
    }
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use super::*;

    const SHAPE: Animation = Animation { width: 4, height: 3, frames: 3, delay_ms: 40 };

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
    fn gif_frames_of_few_colours_come_back() {
        let mut file = Vec::new();
        write_gif(&mut file, &SHAPE, ok(frames())).unwrap();
        let mut options = gif::DecodeOptions::new();
        options.set_color_output(gif::ColorOutput::RGBA);
        let mut reader = options.read_info(Cursor::new(file)).unwrap();
        assert_eq!(reader.repeat(), gif::Repeat::Infinite);
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
    fn apng_frames_come_back() {
        let mut file = Vec::new();
        write_apng(&mut file, &SHAPE, ok(frames()), &Metadata::default()).unwrap();
        let mut reader = ::png::Decoder::new(Cursor::new(file)).read_info().unwrap();
        let control = *reader.info().animation_control().unwrap();
        assert_eq!((control.num_frames, control.num_plays), (3, 0));
        let mut data = vec![0; reader.output_buffer_size().unwrap()];
        for frame in frames() {
            reader.next_frame(&mut data).unwrap();
            assert_eq!(data, frame);
            let control = reader.info().frame_control().unwrap();
            assert_eq!((control.delay_num, control.delay_den), (40, 1000));
        }
    }

    #[test]
    fn the_wrong_number_of_frames_is_an_error() {
        for count in [0, 2, 4] {
            let given = (0..count).map(|_| frames()[0].clone()).collect();
            let error = write_apng(Vec::new(), &SHAPE, ok(given), &Metadata::default()).unwrap_err();
            assert!(
                error.to_string().contains(&format!("3 frames were announced, but {count} came")),
                "{error}"
            );
        }
    }

    #[test]
    fn a_frame_that_fails_ends_the_writing_with_its_error() {
        let failing = || {
            let failure = OutputError::Encode { format: "test", message: "broken".to_owned() };
            vec![Ok(frames()[0].clone()), Err(failure)]
        };
        let gif = write_gif(Vec::new(), &SHAPE, failing()).unwrap_err().to_string();
        let apng = write_apng(Vec::new(), &SHAPE, failing(), &Metadata::default()).unwrap_err().to_string();
        assert!(gif.contains("broken") && apng.contains("broken"));
    }

    #[test]
    fn a_picture_too_wide_for_gif_is_an_error() {
        let wide = Animation { width: 65_536, ..SHAPE };
        let error = write_gif(Vec::new(), &wide, ok(Vec::new())).unwrap_err();
        assert!(error.to_string().contains("65536×3"), "{error}");
    }
}
