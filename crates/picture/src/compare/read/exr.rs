//! OpenEXR: linear light, premultiplied, which is light over black.

use glanz_color::exr::{ExrFile, ExrPart, ExrReadError};
use glanz_color::models::RgbSpace;

use super::super::rows::three_planes;
use super::super::{Picture, Scale};
use super::PLANES;
use super::error::ReadError;
use super::source::Source;

pub(super) fn decode(source: &Source) -> Result<Picture, ReadError> {
    let failed = |error: ExrReadError| match error {
        ExrReadError::Malformed { expected, found } => source.content(expected, found),
        ExrReadError::Unsupported { expected, found } => source.content(expected, found),
        ExrReadError::FeatureOff(off) => ReadError::FeatureOff { name: source.name.to_owned(), off },
    };
    let opened = ExrFile::open(source.bytes).map_err(failed)?;
    for part in opened.parts() {
        source.check_limits(part.width, part.height)?;
    }
    let choice = Choice::of(&opened, source)?;
    let part = opened.parts()[choice.part].clone();
    // Converting primaries makes the planes anew.
    let anew = if part.space.is_some() { PLANES } else { 0 };
    source.check_memory(part.width, part.height, anew)?;
    let planes = opened.planes(choice.part, &choice.channels).map_err(failed)?;
    let rgb = planes.try_into().expect("three channels give three planes");
    let (width, height, notes) = (part.width, part.height, choice.notes(&part));
    let mut picture = Picture { width, height, rgb, scale: Scale::Light, notes };
    if let Some(space) = part.space {
        to_srgb(&mut picture, &space, source)?;
    }
    Ok(picture)
}

/// The part of the file and the channels that are read.
struct Choice {
    part: usize,
    channels: [usize; 3],
    /// The layer's name with its dot; empty for none.
    prefix: String,
}

impl Choice {
    /// Plain R, G, B of the first part that has them, else those of the first layer that has them.
    fn of(file: &ExrFile, source: &Source) -> Result<Self, ReadError> {
        let parts = file.parts();
        let plain = parts.iter().enumerate().find_map(|(index, part)| Self::with(index, part, ""));
        let choice = plain.or_else(|| {
            parts.iter().enumerate().find_map(|(index, part)| {
                let mut names = part.channels.iter().map(|channel| &channel.name);
                names.find_map(|name| Self::with(index, part, name.strip_suffix('R')?))
            })
        });
        let Some(choice) = choice else {
            return Err(source.content("channels R, G and B", file.channel_names()));
        };
        for channel in choice.channels.map(|i| &parts[choice.part].channels[i]) {
            if channel.is_whole_numbers {
                let found = format!("whole numbers in channel {}", channel.name);
                return Err(source.content("half or float samples", found));
            }
        }
        Ok(choice)
    }

    fn with(index: usize, part: &ExrPart, prefix: &str) -> Option<Self> {
        if !prefix.is_empty() && !prefix.ends_with('.') {
            return None;
        }
        let place = |channel: &str| part.channel(&format!("{prefix}{channel}"));
        let channels = [place("R")?, place("G")?, place("B")?];
        Some(Self { part: index, channels, prefix: prefix.to_owned() })
    }

    fn notes(&self, part: &ExrPart) -> Vec<String> {
        let mut notes = Vec::new();
        if !self.prefix.is_empty() {
            notes.push(format!("the layer '{}' is compared", self.prefix.trim_end_matches('.')));
        } else if self.part > 0 {
            let name = part.name.as_deref().unwrap_or_default();
            notes.push(format!("part {} ({name}) is compared", self.part));
        }
        if !part.is_whole {
            notes.push("the data window is compared, which is not the display window".to_owned());
        }
        notes
    }
}

/// Brings a picture of other primaries to those of sRGB; its white becomes D65.
fn to_srgb(picture: &mut Picture, space: &RgbSpace, source: &Source) -> Result<(), ReadError> {
    let Some(matrix) = space.to_linear_srgb_matrix() else { return Ok(()) };
    if !matrix.0.iter().flatten().all(|value| value.is_finite()) {
        let [red, green, blue] = space.primaries;
        let found = format!("red {red:?}, green {green:?}, blue {blue:?}, white {:?}", space.white);
        return Err(source.content("chromaticities of three primaries and a white", found));
    }
    let light = |i: usize| picture.rgb.each_ref().map(|plane| f64::from(plane[i]));
    picture.rgb =
        three_planes(picture.width, picture.height, |i| matrix.apply(light(i)).map(|value| value as f32));
    picture.notes.push("the file's primaries are not those of sRGB; its colours are converted".to_owned());
    Ok(())
}
