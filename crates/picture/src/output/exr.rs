//! OpenEXR: the linear channels as they were drawn.
//!
//! One part, scan lines, ZIP compression, all channels `f32`, named as compositing programs group
//! them: `R G B A` (premultiplied, linear, sRGB primaries), `depth.Z`, `normal.X/Y/Z` and `id`. The
//! object number is written as `f32`, since several readers take no integers; it is exact up to 2^24.

use std::io::{Seek, Write};

use ::exr::error::Error as ExrError;
use ::exr::meta::attribute::{AttributeValue, Chromaticities, Text};
use ::exr::prelude::{
    AnyChannel, AnyChannels, Blocks, Compression, Encoding, FlatSamples, Image, Layer, LayerAttributes,
    LineOrder, SmallVec, Vec2, WritableImage,
};

use super::error::check_size;
use super::{Metadata, OutputError};
use crate::Frame;

/// The primaries and the white of sRGB, IEC 61966-2-1.
const SRGB: Chromaticities = Chromaticities {
    red: Vec2(0.64, 0.33),
    green: Vec2(0.30, 0.60),
    blue: Vec2(0.15, 0.06),
    white: Vec2(0.3127, 0.3290),
};

/// Writes the frame's colour, in linear sRGB, and alpha and what else it holds, and `more` planes under
/// their names. Takes the frame, so that its planes need not be copied. Alpha is left out where the whole picture is opaque.
///
/// The format goes back to fill in a table: for a stream write to a `Cursor<Vec<u8>>` first.
pub fn write_exr(
    out: impl Write + Seek,
    frame: Frame,
    more: Vec<(String, Vec<f32>)>,
    metadata: &Metadata,
) -> Result<(), OutputError> {
    let (width, height) = (frame.width, frame.height);
    if width == 0 || height == 0 {
        let message = format!("both sides must be at least 1 pixel, but are {width}×{height}");
        return Err(OutputError::Encode { format: "OpenEXR", message });
    }
    let mut channels = SmallVec::new();
    let own = planes(frame).map(|(name, samples)| (name.to_owned(), samples));
    for (name, samples) in own.chain(more) {
        check_size(width, height, 1, samples.len())?;
        channels.push(AnyChannel::new(text(&name)?, FlatSamples::F32(samples)));
    }
    let encoding = Encoding {
        compression: Compression::ZIP16,
        blocks: Blocks::ScanLines,
        line_order: LineOrder::Increasing,
    };
    let mut attributes =
        LayerAttributes { software_name: Some(text(&metadata.software)?), ..LayerAttributes::default() };
    for (key, value) in metadata.pairs() {
        attributes.other.insert(text(key)?, AttributeValue::Text(text(value)?));
    }
    let layer = Layer::new(Vec2(width, height), attributes, encoding, AnyChannels::sort(channels));
    let mut image = Image::from_layer(layer);
    image.attributes.chromaticities = Some(SRGB);
    image.write().non_parallel().to_buffered(out).map_err(failed)
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

fn text(text: &str) -> Result<Text, OutputError> {
    Text::new_or_none(text).ok_or_else(|| OutputError::Encode {
        format: "OpenEXR",
        message: format!("metadata must be Latin text, but there is '{text}'"),
    })
}

fn failed(error: ExrError) -> OutputError {
    match error {
        ExrError::Io(error) => OutputError::Stream(error),
        other => OutputError::Encode { format: "OpenEXR", message: other.to_string() },
    }
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use ::exr::prelude::{ReadChannels, ReadLayers, read};

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
            more: Vec::new(),
        }
    }

    type Flat = ::exr::image::FlatImage;

    fn round_trip(frame: Frame, metadata: &Metadata) -> Flat {
        let mut file = Cursor::new(Vec::new());
        write_exr(&mut file, frame, Vec::new(), metadata).unwrap();
        let reader = read().no_deep_data().largest_resolution_level().all_channels().all_layers();
        reader.all_attributes().non_parallel().from_buffered(Cursor::new(file.into_inner())).unwrap()
    }

    fn plane(image: &Flat, name: &str) -> Option<Vec<f32>> {
        let channels = &image.layer_data[0].channel_data.list;
        let channel = channels.iter().find(|c| c.name.to_string() == name)?;
        Some(channel.sample_data.values_as_f32().collect())
    }

    #[test]
    fn every_plane_comes_back_to_the_bit() {
        let image = round_trip(frame(0.5), &Metadata::default());
        assert_eq!(image.layer_data.len(), 1);
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
            assert_eq!(plane(&image, name), Some(values), "{name}");
        }
    }

    #[test]
    fn what_the_frame_does_not_hold_is_not_in_the_file() {
        let bare = Frame { depth: Vec::new(), normal: Default::default(), object: Vec::new(), ..frame(1.0) };
        let image = round_trip(bare, &Metadata::default());
        let names: Vec<_> =
            image.layer_data[0].channel_data.list.iter().map(|c| c.name.to_string()).collect();
        assert_eq!(names, ["B", "G", "R"]);
    }

    #[test]
    fn primaries_and_texts_are_in_the_file() {
        let metadata = Metadata {
            scene_hash: Some("c0ffee".to_owned()),
            entries: vec![("scene".to_owned(), "kite.toml".to_owned())],
            ..Metadata::default()
        };
        let image = round_trip(frame(1.0), &metadata);
        assert_eq!(image.attributes.chromaticities, Some(SRGB));
        let attributes = &image.layer_data[0].attributes;
        assert_eq!(attributes.software_name.as_ref().unwrap().to_string(), metadata.software);
        let other = |key: &str| attributes.other.get(&Text::from(key)).cloned();
        assert_eq!(other("Scene-Hash"), Some(AttributeValue::Text(Text::from("c0ffee"))));
        assert_eq!(other("scene"), Some(AttributeValue::Text(Text::from("kite.toml"))));
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
