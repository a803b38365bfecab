//! OpenEXR: the linear channels as they were drawn.
//!
//! One part, scan lines, ZIP compression, all channels `f32`, named as compositing programs group
//! them: `R G B A` (premultiplied, linear, sRGB primaries), `depth.Z`, `normal.X/Y/Z` and `id`. The
//! object number is written as `f32`, since several readers take no integers; it is exact up to 2^24.

use std::io::{Seek, Write};

use glanz_color::exr::{Attribute, ExrWriteError, write_planes};

use super::error::check_size;
use super::{Metadata, OutputError};
use crate::{Frame, Meaning};

/// Writes the frame's colour, in linear sRGB, and alpha and what else it holds, and `more` planes under
/// their names. Takes the frame, so that its planes need not be copied. Alpha is left out where the whole picture is opaque.
///
/// Needs the feature `exr`. The format goes back to fill in a table: for a stream write to a `Cursor<Vec<u8>>` first.
pub fn write_exr(
    out: impl Write + Seek,
    frame: Frame,
    more: Vec<(String, Vec<f32>)>,
    metadata: &Metadata,
) -> Result<(), OutputError> {
    frame.channels.expect(Meaning::LinearSrgb)?;
    let (width, height) = (frame.width, frame.height);
    let own = planes(frame).map(|(name, samples)| (name.to_owned(), samples));
    let planes: Vec<_> = own.chain(more).collect();
    for (_, samples) in &planes {
        check_size(width, height, 1, samples.len())?;
    }
    let software = ("software", metadata.software.as_str());
    let texts = [software].into_iter().chain(metadata.pairs());
    let attributes: Vec<_> = texts.map(|(key, text)| (key, Attribute::Text(text.to_owned()))).collect();
    write_planes(out, (width, height), planes, &attributes).map_err(OutputError::from)
}

impl From<ExrWriteError> for OutputError {
    fn from(error: ExrWriteError) -> Self {
        match error {
            ExrWriteError::Stream(error) => Self::Stream(error),
            ExrWriteError::FeatureOff(off) => off.into(),
            other => Self::Encode { format: "OpenEXR", message: other.to_string() },
        }
    }
}

/// The planes that the frame has, with the names of their channels.
fn planes(frame: Frame) -> impl Iterator<Item = (&'static str, Vec<f32>)> {
    let [r, g, b] = frame.rgb;
    let opaque = frame.alpha.iter().all(|a| *a == 1.0);
    let alpha = if opaque { Vec::new() } else { frame.alpha };
    let [x, y, z] = frame.normal;
    let id = frame.object.iter().map(|&id| id as f32).collect();
    let always = [("R", r), ("G", g), ("B", b)];
    let if_there = [
        ("A", alpha),
        ("depth.Z", frame.depth),
        ("normal.X", x),
        ("normal.Y", y),
        ("normal.Z", z),
        ("id", id),
    ];
    always.into_iter().chain(if_there.into_iter().filter(|(_, plane)| !plane.is_empty()))
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use glanz_color::exr::{ExrFile, ExrPart};
    use glanz_color::models::RgbSpace;

    use super::*;

    fn frame(alpha: f32) -> Frame {
        let plane = |k: f32| (0..12).map(|i| i as f32 * k).collect::<Vec<_>>();
        Frame {
            width: 4,
            height: 3,
            rgb: [plane(0.1), plane(-1e-3), plane(1e6)],
            alpha: vec![alpha; 12],
            depth: (0..12).map(|i| if i == 5 { f32::INFINITY } else { i as f32 }).collect(),
            normal: [plane(0.01), plane(0.02), plane(0.03)],
            object: (0..12).map(|i| i * 1000).collect(),
            ..Frame::default()
        }
    }

    fn written(frame: Frame, metadata: &Metadata) -> Vec<u8> {
        let mut file = Cursor::new(Vec::new());
        write_exr(&mut file, frame, Vec::new(), metadata).unwrap();
        file.into_inner()
    }

    fn part(bytes: &[u8]) -> ExrPart {
        let file = ExrFile::open(bytes).unwrap();
        assert_eq!(file.parts().len(), 1);
        file.parts()[0].clone()
    }

    fn plane(bytes: &[u8], name: &str) -> Option<Vec<f32>> {
        let channel = part(bytes).channel(name)?;
        ExrFile::open(bytes).unwrap().planes(0, &[channel]).unwrap().pop()
    }

    #[test]
    fn every_plane_comes_back_to_the_bit() {
        let file = written(frame(0.5), &Metadata::default());
        let frame = frame(0.5);
        let [r, g, b] = frame.rgb;
        let [x, y, z] = frame.normal;
        let id = frame.object.iter().map(|i| *i as f32).collect();
        let expected = [
            ("R", r),
            ("G", g),
            ("B", b),
            ("A", frame.alpha),
            ("depth.Z", frame.depth),
            ("normal.X", x),
            ("normal.Y", y),
            ("normal.Z", z),
            ("id", id),
        ];
        for (name, values) in expected {
            assert_eq!(plane(&file, name), Some(values), "{name}");
        }
    }

    #[test]
    fn what_the_frame_does_not_hold_is_not_in_the_file() {
        let bare = Frame { depth: Vec::new(), normal: Default::default(), object: Vec::new(), ..frame(1.0) };
        let part = part(&written(bare, &Metadata::default()));
        let names: Vec<_> = part.channels.iter().map(|channel| channel.name.as_str()).collect();
        assert_eq!(names, ["B", "G", "R"]);
    }

    #[test]
    fn primaries_and_texts_are_in_the_file() {
        let metadata = Metadata {
            scene_hash: Some("c0ffee".to_owned()),
            entries: vec![("scene".to_owned(), "kite.toml".to_owned())],
            ..Metadata::default()
        };
        let file = written(frame(1.0), &metadata);
        let part = part(&file);
        let space = part.space.unwrap();
        assert_eq!(space.to_linear_srgb_matrix(), None, "{space:?}");
        assert!((space.white[0] - RgbSpace::SRGB.white[0]).abs() < 1e-6, "{space:?}");
        let text = |text: &str| Attribute::Text(text.to_owned());
        let expected = [("Scene-Hash", text("c0ffee")), ("scene", text("kite.toml"))];
        assert_eq!(part.attributes, expected.map(|(name, value)| (name.to_owned(), value)));
        let mut software = b"software\0string\0".to_vec();
        software.extend((metadata.software.len() as u32).to_le_bytes());
        software.extend(metadata.software.bytes());
        assert!(file.windows(software.len()).any(|bytes| bytes == software));
    }

    #[test]
    fn a_malformed_frame_is_an_error() {
        let mut short = frame(1.0);
        short.rgb[1].pop();
        let error = write_exr(Cursor::new(Vec::new()), short, Vec::new(), &Metadata::default()).unwrap_err();
        assert!(error.to_string().contains("needs 12 values, but there are 11"), "{error}");
        assert!(
            write_exr(Cursor::new(Vec::new()), Frame::default(), Vec::new(), &Metadata::default()).is_err()
        );
    }
}
