//! LightTools' tabular BSDF: blocks for an angle of incidence (AOI), a plane of incidence (POI), a side, a wavelength and a
//! kind of scatter, each with a value for every azimuth and angle of the detector, in degrees from the normal.
//!
//! Light of POI 0 comes from the azimuth 90°.

use super::coordinates::Coordinates;
use super::table::{Axis, Kind, Parts, Table};
use super::text::{Words, first_comment};
use super::{Data, Format, Measured, ReadOptions};
use crate::{Channels, ReadError};

/// The azimuth of the light where POI is 0.
const AZIMUTH_OF_LIGHT: f64 = 90.0;

#[derive(Default)]
struct Head {
    is_mirrored: bool,
    is_xyz: bool,
    azimuths: Vec<f64>,
    radials: Vec<f64>,
    notes: Vec<String>,
}

/// Values for one direction of the light.
#[derive(Clone, Default)]
struct Block {
    incidence: f64,
    plane: f64,
    is_back: bool,
    is_transmitted: bool,
    wavelength_nm: f64,
    /// 0, 1 or 2 for X, Y and Z.
    tristimulus: usize,
    values: Vec<f32>,
}

pub(super) fn read(text: &str, options: &ReadOptions) -> Result<Measured, ReadError> {
    let mut words = Words::new(text);
    let head = Head::read(&mut words)?;
    let mut blocks = Vec::new();
    while let Some(block) = Block::read(&mut words, &head)? {
        blocks.push(block);
    }
    let mut notes = head.notes.clone();
    let blocks = reflected(blocks, &mut notes)?;
    let quantity = options.quantity.unwrap_or_default();
    let table = table(&head, &blocks, quantity, &mut notes)?;
    let description = first_comment(text);
    let data = Data::Table(Box::new(table));
    Ok(Measured { format: Format::LightTools, quantity, description, data, notes })
}

impl Head {
    fn read(words: &mut Words) -> Result<Self, ReadError> {
        let mut head = Self::default();
        loop {
            match words.word("DataBegin")?.to_lowercase().as_str() {
                "symmetry" => {
                    head.is_mirrored = words.word("a symmetry")?.eq_ignore_ascii_case("PlaneSymmetrical");
                }
                "spectralcontent" => {
                    head.is_xyz = words.word("a spectral content")?.eq_ignore_ascii_case("XYZ");
                }
                "scatterazimuth" => head.azimuths = words.list("azimuths", &mut head.notes)?,
                "scatterradial" => head.radials = words.list("radial angles", &mut head.notes)?,
                "databegin" => break,
                // Keywords of no meaning here have one word behind them, or none.
                _ => {}
            }
        }
        match head.azimuths.is_empty() || head.radials.is_empty() {
            true => {
                Err(ReadError::at(words.line, "ScatterAzimuth and ScatterRadial must stand above DataBegin"))
            }
            false => Ok(head),
        }
    }
}

impl Block {
    /// The next block; nothing at the end.
    fn read(words: &mut Words, head: &Head) -> Result<Option<Self>, ReadError> {
        let mut block = Self::default();
        while let Some(word) = words.next() {
            match word.to_lowercase().as_str() {
                "aoi" => block.incidence = words.number("an angle of incidence")?,
                "poi" => block.plane = words.number("a plane of incidence")?,
                "side" => block.is_back = words.word("Front or Back")?.eq_ignore_ascii_case("Back"),
                "wavelength" => block.wavelength_nm = words.number("a wavelength")?,
                "scattertype" => {
                    block.is_transmitted = words.word("BRDF or BTDF")?.eq_ignore_ascii_case("BTDF");
                }
                "tristimulusvalue" => block.tristimulus = tristimulus(words)?,
                "dataend" => return Ok(None),
                "tis" => {
                    words.word("the total scatter")?;
                    for _ in 0..head.azimuths.len().saturating_mul(head.radials.len()) {
                        block.values.push(words.number("a value")? as f32);
                    }
                    return Ok(Some(block));
                }
                other => {
                    let expected = "a keyword such as AOI, or TIS";
                    return Err(ReadError::at(words.line, format!("expected {expected}, found '{other}'")));
                }
            }
        }
        Ok(None)
    }
}

fn tristimulus(words: &mut Words) -> Result<usize, ReadError> {
    let word = words.word("TrisX, TrisY or TrisZ")?;
    let known = ["TrisX", "TrisY", "TrisZ"];
    let found = known.iter().position(|own| own.eq_ignore_ascii_case(word));
    found.ok_or_else(|| ReadError::at(words.line, format!("expected TrisX, TrisY or TrisZ, found '{word}'")))
}

/// The blocks of reflected light at the front, or at the back if there are none.
fn reflected(blocks: Vec<Block>, notes: &mut Vec<String>) -> Result<Vec<Block>, ReadError> {
    let all = blocks.len();
    let (back, front): (Vec<Block>, Vec<Block>) =
        blocks.into_iter().filter(|block| !block.is_transmitted).partition(|block| block.is_back);
    let is_back = front.is_empty();
    let chosen = if is_back { back } else { front };
    if chosen.is_empty() {
        return Err(ReadError::broken(format!(
            "none of {all} blocks of the file holds reflected light (BRDF)"
        )));
    }
    if is_back {
        notes.push("the data are of the back of the sample".to_owned());
    }
    if chosen.len() < all {
        let left = all - chosen.len();
        notes.push(format!(
            "{left} of {all} blocks, of transmitted light or of the other side, were not read"
        ));
    }
    Ok(chosen)
}

fn sorted(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut list: Vec<f64> = values.collect();
    list.sort_by(f64::total_cmp);
    list.dedup();
    list
}

/// The number of a node.
fn place(list: &[f64], x: f64) -> usize {
    list.iter().position(|own| own.total_cmp(&x).is_eq()).unwrap_or(0)
}

fn table(
    head: &Head,
    blocks: &[Block],
    quantity: crate::Quantity,
    notes: &mut Vec<String>,
) -> Result<Table, ReadError> {
    let incidences = sorted(blocks.iter().map(|block| block.incidence));
    let planes = sorted(blocks.iter().map(|block| block.plane));
    let wavelengths = sorted(blocks.iter().map(|block| block.wavelength_nm));
    let channels = match (head.is_xyz, wavelengths.len()) {
        (true, _) => Channels::Xyz,
        (false, 1) => Channels::Luminance,
        (false, _) => Channels::Wavelengths(wavelengths.clone()),
    };
    let count = channels.count();
    let (azimuths, radials) = (head.azimuths.len(), head.radials.len());
    let lights = incidences.len() * planes.len();
    // Lights that are named, but have no block, must not take more memory than the file does.
    if lights * count > 4 * blocks.len() + 8 {
        return Err(ReadError::broken("most pairs of AOI and POI have no block: this is no table"));
    }
    let mut values = vec![f32::NAN; lights * azimuths * radials * count];
    for block in blocks {
        let light = place(&incidences, block.incidence) * planes.len() + place(&planes, block.plane);
        let channel = if head.is_xyz { block.tristimulus } else { place(&wavelengths, block.wavelength_nm) };
        for (at, value) in block.values.iter().enumerate() {
            let (azimuth, radial) = (at / radials, at % radials);
            let node = (light * radials + radial) * azimuths + azimuth;
            values[node * count + channel.min(count - 1)] = *value;
        }
    }
    if planes.len() > 1 {
        notes.push("the azimuth of the light is taken as 90° and the plane of incidence (POI)".to_owned());
    }
    let coordinates = Coordinates::Spherical;
    Table::new(Parts { coordinates, channels, axes: axes(head, &incidences, &planes), quantity, values })
}

fn axes(head: &Head, incidences: &[f64], planes: &[f64]) -> [Axis; 4] {
    let around = if head.is_mirrored { Kind::MirroredAzimuth } else { Kind::Azimuth };
    let planes: Vec<f64> = planes.iter().map(|plane| plane + AZIMUTH_OF_LIGHT).collect();
    [
        Axis::of_degrees(incidences, Kind::Polar),
        Axis::of_degrees(&planes, Kind::Azimuth),
        Axis::of_degrees(&head.radials, Kind::Polar),
        Axis::of_degrees(&head.azimuths, around),
    ]
}
