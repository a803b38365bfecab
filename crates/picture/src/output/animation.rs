//! APNG from a row of RGBA pictures, and what it shares with GIF.

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
        let error = write_apng(Vec::new(), &SHAPE, failing(), &Metadata::default()).unwrap_err();
        assert!(error.to_string().contains("broken"), "{error}");
    }
}
