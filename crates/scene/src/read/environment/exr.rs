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
    let planes = opened.planes(index, &channels).map_err(|error| failed(source, error))?;
    let mut pixels = vec![[0.0; 3]; part.width * part.height];
    for (channel, plane) in planes.into_iter().enumerate() {
        pixels.iter_mut().zip(plane).for_each(|(pixel, value)| pixel[channel] = value);
    }
    if !part.is_whole {
        source.notes.add("the data window is taken as the whole picture, which is not the display window");
    }
    if let Some(space) = part.space {
        source.convert_to_srgb(&mut pixels, &space)?;
    }
    Ok(EnvironmentMap { width: part.width, height: part.height, pixels })
}

/// R, G, B of the first part that has them.
fn choose(file: &ExrFile, source: &Source) -> Result<(usize, [usize; 3]), ReadError> {
    let rgb = |part: &ExrPart| Some([part.channel("R")?, part.channel("G")?, part.channel("B")?]);
    let found = file.parts().iter().enumerate().find_map(|(index, part)| Some((index, rgb(part)?)));
    let Some((index, channels)) = found else {
        return Err(source.unsupported("channels R, G and B", file.channel_names()));
    };
    if channels.iter().any(|i| file.parts()[index].channels[*i].is_whole_numbers) {
        return Err(source.unsupported("half or float samples", "whole numbers"));
    }
    Ok((index, channels))
}

fn failed(source: &Source, error: ExrReadError) -> ReadError {
    match error {
        ExrReadError::Malformed { expected, found } => source.malformed(Place::File, expected, found),
        ExrReadError::Unsupported { expected, found } => source.unsupported(expected, found),
        ExrReadError::FeatureOff(off) => ReadError::feature_off(source.file, off),
    }
}
