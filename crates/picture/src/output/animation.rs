//! APNG from a row of RGBA pictures, and what it shares with GIF.

use std::io::Write;

use super::error::check_size;
use super::png::{encoder, failed};
use super::{Metadata, OutputError};

/// What all frames of an animation share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Animation {
    /// Width in pixels.
    pub width: usize,
    /// Height in pixels.
    pub height: usize,
    /// How many frames there will be.
    pub frames: usize,
    /// How long each is shown, in seconds. GIF rounds to hundredths, see [`gif_hundredths`](Self::gif_hundredths).
    pub frame_s: f64,
}

impl Animation {
    /// How long a GIF shows each frame, in hundredths of a second: at least 1, since players take 0 as they please.
    pub fn gif_hundredths(&self) -> u16 {
        // The conversion saturates.
        ((100.0 * self.frame_s).round() as u16).max(1)
    }

    /// The same as a fraction of a second, as APNG keeps it: exact for whole numbers of frames a second.
    fn fraction(&self) -> (u16, u16) {
        let whole =
            |number: f64| (0.5..=f64::from(u16::MAX)).contains(&number).then(|| number.round() as u16);
        let rate = 1.0 / self.frame_s;
        match (whole(rate), whole(1000.0 * self.frame_s)) {
            (Some(rate), _) if (f64::from(rate) * self.frame_s - 1.0).abs() < 1e-9 => (1, rate),
            (_, Some(milliseconds)) => (milliseconds, 1000),
            _ => (whole(self.frame_s).unwrap_or(if self.frame_s > 1.0 { u16::MAX } else { 0 }), 1),
        }
    }
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
    let (numerator, denominator) = animation.fraction();
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
            assert_eq!((control.delay_num, control.delay_den), (1, 25));
        }
    }

    #[test]
    fn rates_are_kept_as_well_as_the_format_can() {
        let shown = |frame_s: f64| {
            let animation = Animation { frame_s, ..SHAPE };
            (animation.fraction(), animation.gif_hundredths())
        };
        assert_eq!(shown(1.0 / 60.0), ((1, 60), 2));
        assert_eq!(shown(1.0 / 25.0), ((1, 25), 4));
        assert_eq!(shown(1001.0 / 30000.0), ((33, 1000), 3));
        assert_eq!(shown(0.001), ((1, 1000), 1));
        assert_eq!(shown(2.5), ((2500, 1000), 250));
        assert_eq!(shown(100.25), ((100, 1), 10025));
        assert_eq!(shown(1e9), ((u16::MAX, 1), u16::MAX));
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
