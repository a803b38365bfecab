//! Zemax's tabular BSDF (Radiant Imaging's BSDF data interchange format): angles around the mirror direction, in degrees.
//!
//! For each rotation of the sample and each incidence stand the total scatter (TIS) and rows, one per azimuth around the
//! mirror direction, with a value for each angle from it. Azimuth 0 points from the mirror direction to the normal. Numbers
//! of 0 below the horizon are no data.

use super::coordinates::Coordinates;
use super::table::{Axis, Kind, Parts, Table};
use super::text::{Words, first_comment};
use super::{Data, Format, Measured, ReadOptions};
use crate::facts::reflected;
use crate::{Channels, ReadError, WriteError};

/// What stands above the values.
#[derive(Default)]
struct Head {
    is_mirrored: bool,
    is_xyz: bool,
    rotations: Vec<f64>,
    incidences: Vec<f64>,
    azimuths: Vec<f64>,
    radials: Vec<f64>,
    notes: Vec<String>,
}

pub(super) fn read(text: &str, options: &ReadOptions) -> Result<Measured, ReadError> {
    let mut words = Words::new(text);
    let head = Head::read(&mut words)?;
    let channels = if head.is_xyz { Channels::Xyz } else { Channels::Luminance };
    let values = values(&mut words, &head, channels.count())?;
    let mut notes = head.notes;
    let half = head.azimuths.iter().all(|phi| (0.0..=180.0).contains(phi));
    if head.is_mirrored && !half {
        notes.push("the data are PlaneSymmetrical, but have azimuths beyond 180°, which are kept".to_owned());
    }
    let around = if head.is_mirrored && half { Kind::MirroredAzimuth } else { Kind::Azimuth };
    let axes = [
        (&head.incidences, Kind::Polar),
        (&head.rotations, Kind::Azimuth),
        (&head.radials, Kind::Polar),
        (&head.azimuths, around),
    ];
    if head.rotations.len() > 1 {
        notes.push("the rotation of the sample is taken as the azimuth of the light".to_owned());
    }
    let quantity = options.quantity.unwrap_or_default();
    let mut table = Table::new(Parts {
        coordinates: Coordinates::Specular,
        channels,
        axes: axes.map(|(nodes, kind)| Axis::of_degrees(nodes, kind)),
        quantity,
        values,
    })?;
    table.drop_zeros_below_horizon();
    let description = first_comment(text);
    Ok(Measured { format: Format::Zemax, quantity, description, data: Data::Table(Box::new(table)), notes })
}

impl Head {
    fn read(words: &mut Words) -> Result<Self, ReadError> {
        let mut head = Self::default();
        loop {
            match words.word("DataBegin")?.to_lowercase().as_str() {
                "source" => drop(words.word("the source")?),
                "symmetry" => head.symmetry(words)?,
                "spectralcontent" => head.is_xyz = head.spectral_content(words)?,
                "scattertype" => scatter_type(words)?,
                "samplerotation" => {
                    head.rotations = words.list("rotations of the sample", &mut head.notes)?
                }
                "angleofincidence" => head.incidences = words.list("angles of incidence", &mut head.notes)?,
                "scatterazimuth" => head.azimuths = words.list("azimuths", &mut head.notes)?,
                "scatterradial" => head.radials = words.list("radial angles", &mut head.notes)?,
                "monochrome" | "tristimulusx" => {}
                "databegin" => break,
                other => {
                    let expected = "a keyword such as ScatterRadial, or DataBegin";
                    return Err(ReadError::at(words.line, format!("expected {expected}, found '{other}'")));
                }
            }
        }
        if head.rotations.is_empty() {
            head.rotations.push(0.0);
        }
        let lists = [&head.incidences, &head.azimuths, &head.radials];
        for (list, name) in lists.iter().zip(["AngleOfIncidence", "ScatterAzimuth", "ScatterRadial"]) {
            if list.is_empty() {
                return Err(ReadError::at(words.line, format!("there is no {name} above DataBegin")));
            }
        }
        Ok(head)
    }

    fn symmetry(&mut self, words: &mut Words) -> Result<(), ReadError> {
        let symmetry = words.word("a symmetry")?;
        self.is_mirrored = symmetry.eq_ignore_ascii_case("PlaneSymmetrical");
        let known = ["PlaneSymmetrical", "Asymmetrical", "Asymmetrical4D"];
        if !known.iter().any(|own| own.eq_ignore_ascii_case(symmetry)) {
            self.notes.push(format!("the symmetry '{symmetry}' is not known, and taken as Asymmetrical"));
        }
        Ok(())
    }

    /// Whether there are tristimulus values.
    fn spectral_content(&self, words: &mut Words) -> Result<bool, ReadError> {
        match words.word("a spectral content")? {
            word if word.eq_ignore_ascii_case("Monochrome") => Ok(false),
            word if word.eq_ignore_ascii_case("XYZ") => Ok(true),
            word => Err(ReadError::at(words.line, format!("expected Monochrome or XYZ, found '{word}'"))),
        }
    }
}

/// Refuses what is not reflected.
pub(super) fn scatter_type(words: &mut Words) -> Result<(), ReadError> {
    match words.word("BRDF or BTDF")? {
        word if word.eq_ignore_ascii_case("BRDF") => Ok(()),
        word if word.eq_ignore_ascii_case("BTDF") => {
            Err(ReadError::at(words.line, "the file holds transmitted light (BTDF), and only BRDF is read"))
        }
        word => Err(ReadError::at(words.line, format!("expected BRDF or BTDF, found '{word}'"))),
    }
}

/// The values in the order of the table: incidence, rotation, radial angle, azimuth, channel.
fn values(words: &mut Words, head: &Head, channels: usize) -> Result<Vec<f32>, ReadError> {
    let [incidences, rotations] = [head.incidences.len(), head.rotations.len()];
    let [azimuths, radials] = [head.azimuths.len(), head.radials.len()];
    let per_channel = rotations * incidences;
    let blocks = read_blocks(words, azimuths.saturating_mul(radials))?;
    if blocks.len() != channels * per_channel {
        let message = format!(
            "expected {} blocks that begin with TIS ({channels} × {rotations} rotations × {incidences} incidences), \
             found {}",
            channels * per_channel,
            blocks.len()
        );
        return Err(ReadError::at(words.line, message));
    }
    let mut values = Vec::with_capacity(blocks.len() * azimuths * radials);
    for node in 0..per_channel * radials * azimuths {
        let [azimuth, rest] = [node % azimuths, node / azimuths];
        let [radial, rest] = [rest % radials, rest / radials];
        let block = rest % rotations * incidences + rest / rotations;
        let at = azimuth * radials + radial;
        values.extend((0..channels).map(|c| blocks[c * per_channel + block][at]));
    }
    Ok(values)
}

/// The blocks as they come, each with so many numbers in rows by azimuth.
fn read_blocks(words: &mut Words, numbers: usize) -> Result<Vec<Vec<f32>>, ReadError> {
    let mut blocks: Vec<Vec<f32>> = Vec::new();
    while let Some(word) = words.next() {
        match word.to_lowercase().as_str() {
            // Some write that there is none.
            "tis" => drop(words.word("the total scatter")?),
            "databegin" | "dataend" | "monochrome" | "tristimulusx" | "tristimulusy" | "tristimulusz" => {
                continue;
            }
            other => {
                return Err(ReadError::at(words.line, format!("expected TIS or DataEnd, found '{other}'")));
            }
        }
        let mut block = Vec::new();
        for _ in 0..numbers {
            block.push(words.number("a value")? as f32);
        }
        blocks.push(block);
    }
    Ok(blocks)
}

/// Nodes in degrees for [`Table::of_function`] with [`Coordinates::Specular`], as files of Zemax have them: dense about the
/// mirror direction. With `rotations` of the sample, azimuths go all around.
///
/// ```
/// use glanz_measure::{Channels, Coordinates, Measured, Table, write_zemax, zemax_nodes_deg};
///
/// let nodes = zemax_nodes_deg(1);
/// let white = Table::of_function(Coordinates::Specular, nodes, Channels::Luminance, &mut |_, _| vec![0.3])?;
/// let text = write_zemax(&white, "white")?;
/// let again = Measured::read(text.as_bytes(), "white.bsdf", &Default::default())?;
/// assert_eq!(again.description, "white");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn zemax_nodes_deg(rotations: usize) -> [Vec<f64>; 4] {
    let every = |step: usize, last: usize| (0..=last).step_by(step).map(|x| x as f64).collect::<Vec<f64>>();
    let near = [0.0, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0];
    let radials = near.into_iter().chain(every(5, 175).into_iter().skip(2)).collect();
    let turns = (0..rotations.max(1)).map(|turn| turn as f64 * 360.0 / rotations.max(1) as f64).collect();
    [every(5, 85), turns, radials, every(10, if rotations > 1 { 350 } else { 180 })]
}

/// The text of a Zemax file: a table in [`Coordinates::Specular`], of one channel or XYZ. Nodes without data are 0.
///
/// # Errors
///
/// [`WriteError`] where the table has other coordinates or channels.
pub fn write_zemax(table: &Table, description: &str) -> Result<String, WriteError> {
    if table.coordinates() != Coordinates::Specular {
        return Err(WriteError::Coordinates {
            format: "Zemax",
            expected: "angles around the mirror direction",
        });
    }
    let indicators: &[&str] = match table.channels() {
        Channels::Luminance => &["Monochrome"],
        Channels::Xyz => &["TristimulusX", "TristimulusY", "TristimulusZ"],
        other => {
            return Err(WriteError::Channels {
                format: "Zemax",
                expected: "one or XYZ",
                found: other.to_string(),
            });
        }
    };
    let mut text = head(table, description);
    for (channel, indicator) in indicators.iter().enumerate() {
        text += &format!("\n{indicator}\nDataBegin\n");
        blocks(&mut text, table, channel);
        text += "DataEnd\n";
    }
    Ok(text)
}

fn head(table: &Table, description: &str) -> String {
    let mut text = String::new();
    description.lines().for_each(|line| text += &format!("# {}\n", line.trim()));
    let symmetry = match (table.is_mirrored(), table.is_isotropic()) {
        (true, _) => "PlaneSymmetrical",
        (false, true) => "Asymmetrical",
        (false, false) => "ASymmetrical4D",
    };
    let content = if table.channels() == &Channels::Xyz { "XYZ" } else { "Monochrome" };
    text +=
        &format!("Source\tMeasured\nSymmetry\t{symmetry}\nSpectralContent\t{content}\nScatterType\tBRDF\n");
    let nodes = table.nodes_deg();
    let names = [("SampleRotation", 1), ("AngleOfIncidence", 0), ("ScatterAzimuth", 3), ("ScatterRadial", 2)];
    for (name, axis) in names {
        let list: Vec<String> = nodes[axis].iter().map(f64::to_string).collect();
        text += &format!("{name}\t{}\n{}\n", list.len(), list.join("\t"));
    }
    text
}

/// The blocks of a channel, one for each rotation and incidence.
fn blocks(text: &mut String, table: &Table, channel: usize) {
    let [incidences, rotations, radials, azimuths] = table.nodes_deg().map(|nodes| nodes.len());
    for rotation in 0..rotations {
        for incidence in 0..incidences {
            let first = (incidence * rotations + rotation) * radials * azimuths;
            let [wi, _] = table.pair(first);
            let tis = reflected(wi, table.channels().count(), &|wi, wo| table.extended(wi, wo)).0[channel];
            *text += &format!("TIS {}\n", tis as f32);
            for azimuth in 0..azimuths {
                let of = |radial: usize| {
                    let value = table.brdf(first + radial * azimuths + azimuth, channel);
                    format!("{:e}", if value.is_nan() { 0.0 } else { value })
                };
                *text += &(0..radials).map(of).collect::<Vec<String>>().join("\t");
                text.push('\n');
            }
        }
    }
}
