//! The one writer of OpenEXR: named planes and attributes.

use std::io::{Seek, SeekFrom, Write};

use ::exr::error::Error as ExrError;
use ::exr::meta::attribute::{self, AttributeValue, Chromaticities, Text};
use ::exr::meta::header::Header;
use ::exr::meta::{MetaData, magic_number, sequence_end};
use ::exr::prelude::{
    AnyChannel, AnyChannels, Blocks, Compression, Encoding, FlatSamples, Image, Layer, LayerAttributes,
    LineOrder, SmallVec, Vec2, WritableImage,
};

use super::{Attribute, ExrWriteError};

/// The primaries and the white of sRGB, IEC 61966-2-1.
const SRGB: Chromaticities = Chromaticities {
    red: Vec2(0.64, 0.33),
    green: Vec2(0.30, 0.60),
    blue: Vec2(0.15, 0.06),
    white: Vec2(0.3127, 0.3290),
};
/// The standard attribute that names the program.
const SOFTWARE: &str = "software";

/// Writes one part of scan lines: 32-bit floats, packed as ZIP, with the primaries of sRGB. Takes the planes,
/// so that they need not be copied; each has its channel's name and a value for each pixel, by rows from the
/// top. The same content gives the same bytes.
///
/// The format goes back to fill in a table: for a stream write to a `Cursor<Vec<u8>>` first.
///
/// # Errors
///
/// [`ExrWriteError`]; nothing of use is written then.
pub fn write_planes(
    mut out: impl Write + Seek,
    (width, height): (usize, usize),
    planes: impl IntoIterator<Item = (String, Vec<f32>)>,
    attributes: &[(&str, Attribute)],
) -> Result<(), ExrWriteError> {
    if width == 0 || height == 0 {
        let found = format!("{width}×{height}");
        return Err(ExrWriteError::Content { expected: "at least one pixel", found });
    }
    let encoding = Encoding {
        compression: Compression::ZIP16,
        blocks: Blocks::ScanLines,
        line_order: LineOrder::Increasing,
    };
    let channels = channels(width * height, planes)?;
    let layer = Layer::new(Vec2(width, height), layer_attributes(attributes)?, encoding, channels);
    let mut image = Image::from_layer(layer);
    image.attributes.chromaticities = Some(SRGB);
    image.write().non_parallel().to_buffered(&mut out).map_err(failed)?;
    // The crate writes attributes in the order of a hash map, another one each time. The sorted header is
    // as long, so that the offsets of the blocks stay right.
    let header = sorted_header(&image.write().infer_meta_data()).map_err(failed)?;
    out.seek(SeekFrom::Start(0))?;
    Ok(out.write_all(&header)?)
}

/// A file up to the table of offsets, with the attributes of each part by name.
fn sorted_header(parts: &[Header]) -> Result<Vec<u8>, ExrError> {
    let mut bytes = Vec::new();
    magic_number::write(&mut bytes)?;
    let requirements = MetaData::validate(parts, true)?;
    requirements.write(&mut bytes)?;
    for part in parts {
        let mut attributes: Vec<_> = part.all_named_attributes().collect();
        attributes.sort_by_key(|(name, _)| *name);
        for (name, value) in attributes {
            attribute::write(name, &value, &mut bytes)?;
        }
        sequence_end::write(&mut bytes)?;
    }
    if requirements.is_multilayer() {
        sequence_end::write(&mut bytes)?;
    }
    Ok(bytes)
}

fn channels(
    pixels: usize,
    planes: impl IntoIterator<Item = (String, Vec<f32>)>,
) -> Result<AnyChannels<FlatSamples>, ExrWriteError> {
    let mut list = SmallVec::new();
    for (channel, values) in planes {
        if values.len() != pixels {
            return Err(ExrWriteError::Size { channel, expected: pixels, found: values.len() });
        }
        list.push(AnyChannel::new(text(&channel)?, FlatSamples::F32(values)));
    }
    let channels = AnyChannels::sort(list);
    if let Some(pair) = channels.list.windows(2).find(|pair| pair[0].name == pair[1].name) {
        let found = format!("channel {} twice", pair[0].name);
        return Err(ExrWriteError::Content { expected: "each channel once", found });
    }
    if channels.list.is_empty() {
        return Err(ExrWriteError::Content { expected: "at least one channel", found: "none".to_owned() });
    }
    Ok(channels)
}

fn layer_attributes(attributes: &[(&str, Attribute)]) -> Result<LayerAttributes, ExrWriteError> {
    let mut layer = LayerAttributes::default();
    for (name, value) in attributes {
        match value {
            Attribute::Text(value) if *name == SOFTWARE => layer.software_name = Some(text(value)?),
            Attribute::Text(value) => {
                layer.other.insert(text(name)?, AttributeValue::Text(text(value)?));
            }
            Attribute::Number(value) => {
                layer.other.insert(text(name)?, AttributeValue::F32(*value));
            }
        }
    }
    Ok(layer)
}

fn text(text: &str) -> Result<Text, ExrWriteError> {
    Text::new_or_none(text)
        .ok_or_else(|| ExrWriteError::Content { expected: "Latin text", found: format!("'{text}'") })
}

fn failed(error: ExrError) -> ExrWriteError {
    match error {
        ExrError::Io(error) => ExrWriteError::Stream(error),
        other => {
            ExrWriteError::Content { expected: "a picture that OpenEXR can hold", found: other.to_string() }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use super::super::ExrFile;
    use super::*;

    fn attributes() -> Vec<(&'static str, Attribute)> {
        let text = |text: &str| Attribute::Text(text.to_owned());
        let mut attributes = vec![
            ("software", text("glanz")),
            ("Scene-Hash", text("c0ffee")),
            ("EV", Attribute::Number(1.5)),
            ("zebra", text("")),
        ];
        attributes.extend(["a", "b", "c", "d", "e", "f", "g", "h"].map(|name| (name, text(name))));
        attributes
    }

    fn file(attributes: &[(&str, Attribute)]) -> Vec<u8> {
        let planes = ["R", "depth.Z"].map(|name| (name.to_owned(), vec![0.25; 6]));
        let mut out = Cursor::new(Vec::new());
        write_planes(&mut out, (3, 2), planes, attributes).unwrap();
        out.into_inner()
    }

    #[test]
    fn the_same_content_gives_the_same_bytes() {
        let first = file(&attributes());
        let mut attributes = attributes();
        attributes.reverse();
        for _ in 0..8 {
            assert!(file(&attributes) == first, "the file differs from the first");
        }
    }

    #[test]
    fn attributes_come_back_by_name() {
        let bytes = file(&attributes());
        let file = ExrFile::open(&bytes).unwrap();
        let mut expected = attributes();
        expected.retain(|(name, _)| *name != SOFTWARE);
        expected.sort_by_key(|(name, _)| *name);
        let found = &file.parts()[0].attributes;
        assert!(found.iter().map(|(name, value)| (name.as_str(), value.clone())).eq(expected), "{found:?}");
        assert_eq!(file.planes(0, &[1, 0]).unwrap(), vec![vec![0.25; 6]; 2]);
    }

    #[test]
    fn a_header_of_several_parts_is_as_long_as_the_crate_writes_it() {
        let image = |name: &str| {
            let list = channels(6, [("R".to_owned(), vec![0.5; 6])]).unwrap();
            let mut own = layer_attributes(&attributes()).unwrap();
            own.layer_name = Some(Text::from(name));
            Layer::new(Vec2(3, 2), own, Encoding::default(), list)
        };
        let whole = ::exr::meta::header::ImageAttributes::with_size(Vec2(3, 2));
        let image = Image::empty(whole).with_layer(image("a")).with_layer(image("b"));
        let mut out = Cursor::new(Vec::new());
        image.write().non_parallel().to_buffered(&mut out).unwrap();
        let mut bytes = out.into_inner();
        let header = sorted_header(&image.write().infer_meta_data()).unwrap();
        bytes[..header.len()].copy_from_slice(&header);
        let file = ExrFile::open(&bytes).unwrap();
        assert_eq!(file.parts().len(), 2);
        assert_eq!(file.planes(1, &[0]).unwrap(), [vec![0.5; 6]]);
    }
}
