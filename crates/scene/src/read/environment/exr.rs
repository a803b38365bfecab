//! OpenEXR pictures.

use glanz_color::exr::{ExrFile, ExrPart, ExrReadError};
use glanz_color::read::{Place, ReadError};

use super::source::Source;
use crate::EnvironmentMap;

/// Reads a file.
pub(super) fn read(source: &mut Source) -> Result<EnvironmentMap, ReadError> {
    let opened = ExrFile::open(source.bytes).map_err(|error| failed(source, error))?;
    let (index, channels) = choose(&opened, source)?;
    let part = opened.parts()[index].clone();
    source.check_size(part.width, part.height)?;
    // A plane of luminance is asked for once.
    let is_gray = channels[0] == channels[1];
    let asked = if is_gray { &channels[..1] } else { &channels[..] };
    let planes = opened.planes(index, asked).map_err(|error| failed(source, error))?;
    let mut pixels = vec![[0.0; 3]; part.width * part.height];
    for (channel, plane) in planes.into_iter().enumerate() {
        pixels.iter_mut().zip(plane).for_each(|(pixel, value)| match is_gray {
            true => *pixel = [value; 3],
            false => pixel[channel] = value,
        });
    }
    if !part.is_whole {
        source.notes.add("the data window is taken as the whole picture, which is not the display window");
    }
    limit_infinite(&mut pixels, source);
    match part.space {
        Some(space) if space.primaries == XYZ => source.convert_xyz(&mut pixels),
        Some(space) => source.convert_to_srgb(&mut pixels, &space),
        None => {}
    }
    Ok(EnvironmentMap { width: part.width, height: part.height, pixels })
}

/// The chromaticities of the primaries of CIE XYZ.
const XYZ: [[f64; 2]; 3] = [[1.0, 0.0], [0.0, 1.0], [0.0, 0.0]];

/// The largest half: what programs that do not write infinity write for more.
const LARGEST_HALF: f32 = 65_504.0;

/// Infinite light becomes the largest light of the picture, or the largest half where that is more.
fn limit_infinite(pixels: &mut [[f32; 3]], source: &mut Source) {
    let finite = pixels.iter().flatten().copied().filter(|value| value.is_finite());
    let most = finite.fold(LARGEST_HALF, f32::max);
    let mut count = 0;
    for value in pixels.as_flattened_mut().iter_mut().filter(|value| value.is_infinite()) {
        *value = most.copysign(*value);
        count += 1;
    }
    source.notes.add_times(&format!("an infinite value is taken as {most}"), count);
}

/// The part and the channels of the picture: R, G, B of the first part that has them, else those of a layer, else
/// the luminance alone.
fn choose(file: &ExrFile, source: &mut Source) -> Result<(usize, [usize; 3]), ReadError> {
    let found = file.parts().iter().enumerate();
    let rgb = |part: &ExrPart| channels(part, "");
    let first = found.clone().find_map(|(index, part)| Some((index, rgb(part)?)));
    let layered = || found.clone().find_map(|(index, part)| layer(part).map(|layer| (index, layer)));
    let gray = || found.clone().find_map(|(index, part)| Some((index, [part.channel("Y")?; 3])));
    let (index, channels) = match (first, layered(), gray()) {
        (Some(found), ..) => found,
        (None, Some((index, (name, channels))), _) => {
            source.notes.add(&format!("the channels R, G and B of the layer '{name}' are taken"));
            (index, channels)
        }
        (None, None, Some((index, channels))) => {
            source.notes.add("the channel Y alone is taken as luminance: the picture is grey");
            (index, channels)
        }
        _ => return Err(source.unsupported("channels R, G and B, or Y", file.channel_names())),
    };
    let part = &file.parts()[index];
    if channels.iter().any(|i| part.channels[*i].is_whole_numbers) {
        return Err(source.unsupported("half or float samples", "whole numbers"));
    }
    if part.is_cube_map {
        let expected = "surroundings in equirectangular projection";
        return Err(source.unsupported(expected, "the six sides of a cube (envmap)"));
    }
    Ok((index, channels))
}

/// R, G and B behind a prefix.
fn channels(part: &ExrPart, prefix: &str) -> Option<[usize; 3]> {
    let channel = |name: &str| part.channel(&format!("{prefix}{name}"));
    Some([channel("R")?, channel("G")?, channel("B")?])
}

/// The name and the channels of the first layer of a part that has R, G and B.
fn layer(part: &ExrPart) -> Option<(String, [usize; 3])> {
    part.channels.iter().find_map(|channel| {
        let layer = channel.name.strip_suffix(".R")?;
        Some((layer.to_owned(), channels(part, &format!("{layer}."))?))
    })
}

fn failed(source: &Source, error: ExrReadError) -> ReadError {
    match error {
        ExrReadError::Malformed { expected, found } => source.malformed(Place::File, expected, found),
        ExrReadError::Unsupported { expected, found } => source.unsupported(expected, found),
        ExrReadError::FeatureOff(off) => ReadError::feature_off(source.file, off),
    }
}
