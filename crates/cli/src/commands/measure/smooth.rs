//! `glanz measure smooth`: readings smoothed by Gaussians.

use std::path::PathBuf;

use clap::{Args, ValueHint};
use glanz_math::Vec3;
use glanz_measure::{Channels, Quantity, Smoothed};
use schemars::JsonSchema;
use serde::Serialize;

use super::convert::{Kind, save};
use super::written::Written;
use super::{ReadArgs, read};
use crate::args::check_beside;
use crate::print::failure::{Failure, Report};
use crate::print::{self, FormatArgs};
use crate::progress::Progress;

/// Shown after the help.
pub(crate) const EXAMPLES: &str = "\
Examples:
  glanz measure smooth readings.csv
  glanz measure smooth readings.csv -o smooth.bsdf
  glanz measure smooth cloth.csv -o cloth.binary
  glanz measure smooth readings.csv --neighbours 128 -o table.csv

Between readings the logarithm of the data over a fitted sum of lobes is that of a plane through the nearest
ones, each weighted by a Gaussian of its distance: noise is averaged, and holes are filled from their rims. As
many neighbours count as tell readings best from the others, unless --neighbours says how many. Far from all
readings the fitted lobes alone remain. A .csv has a line for each direction of a regular grid, and tells in
its column distance how far the nearest reading is in (fourth root of 1 - n·h, root of 1 - wo·h, half the
difference of the cosines); beyond about 0.1 it is a hole.";

/// A direction this far from all readings is a hole.
const HOLE: f64 = 0.1;

/// Directions between two looks at the progress.
const BETWEEN_SHOWS: usize = 512;

/// Options of `glanz measure smooth`.
#[derive(Args, Debug)]
pub(crate) struct SmoothArgs {
    /// A file of measured reflectance
    #[arg(value_name = "FILE", value_hint = ValueHint::FilePath)]
    file: PathBuf,

    /// The file that is written; its ending is that of its format, as convert has them [default: none, and the numbers are told]
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    output: Option<PathBuf>,

    /// Its format, whatever the ending is
    #[arg(long, value_enum, value_name = "FORMAT", requires = "output")]
    to: Option<Kind>,

    /// How many readings tell a direction between them [default: as many as tell readings best]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1000))]
    neighbours: Option<u32>,

    #[command(flatten)]
    read: ReadArgs,
    #[command(flatten)]
    format: FormatArgs,
}

/// What was smoothed, and written.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    /// The file that was written; null of none
    file: Option<String>,
    /// csv, merl, rgl, zemax or klems; null of none
    format: Option<&'static str>,
    /// How many readings count
    readings: usize,
    /// How many tell a direction between them
    neighbours: usize,
    /// The mean difference of the logarithms of readings from what their neighbours tell of them
    noise: f64,
    /// Whether readings are told better where the azimuth of the half vector counts
    anisotropic: bool,
    /// The part of the directions that the file asked for that are far from all readings; of those of a .csv where none is written
    holes: f64,
    /// What is odd, and what was dropped
    notes: Vec<String>,
}

impl SmoothArgs {
    /// Reads, smooths and writes.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let kind = self.output.as_deref().map(|output| Kind::of(output, self.to)).transpose()?;
        self.output.as_deref().map_or(Ok(()), |output| check_beside("-o", output))?;
        let measured = read(&self.file, &self.read)?;
        let mut notes = measured.notes.clone();
        let smoothed = Smoothed::of(&measured, self.neighbours.map(|count| count as usize))
            .map_err(|error| Failure::from(Report::new(error).file(&self.file)))?;
        let description = format!("{}, smoothed by Glanz", measured.description);
        let (bytes, looks) = self.written(kind.unwrap_or(Kind::Csv), &smoothed, &description, &mut notes)?;
        self.output.as_deref().map(|output| save(&bytes, output)).transpose()?;
        let document = Document {
            file: self.output.as_deref().map(|output| output.display().to_string()),
            format: kind.map(Kind::name),
            readings: smoothed.readings(),
            neighbours: smoothed.neighbours(),
            noise: smoothed.noise(),
            anisotropic: smoothed.is_anisotropic(),
            holes: looks[1] as f64 / looks[0].max(1) as f64,
            notes,
        };
        self.tell(&document)
    }

    /// The bytes of the file, how many directions it asked for, and how many of them are far from all readings.
    fn written(
        &self,
        kind: Kind,
        smoothed: &Smoothed,
        description: &str,
        notes: &mut Vec<String>,
    ) -> Result<(Vec<u8>, [usize; 2]), Failure> {
        let channels = smoothed.channels();
        let written = Written {
            channels,
            anisotropic: smoothed.is_anisotropic(),
            description: description.trim_start_matches(", "),
            output: self.output.as_deref().unwrap_or(&self.file),
        };
        let bytes = |notes: &mut Vec<String>, f: &mut dyn FnMut(Vec3<f64>, Vec3<f64>) -> (Vec<f64>, f64)| {
            match kind {
                Kind::Csv => Ok(table(channels, smoothed.is_anisotropic(), f).into_bytes()),
                _ => written.bytes(kind, notes, &mut |wi, wo| f(wi, wo).0),
            }
        };
        // How many directions a format asks for is told by a white, which takes no time.
        let (mut total, white) = (0_usize, vec![1.0; channels.count()]);
        bytes(&mut Vec::new(), &mut |_, _| {
            total += 1;
            (white.clone(), 0.0)
        })?;
        let (mut looks, mut progress) = ([0_usize; 2], Progress::new(1, "files"));
        let bytes = bytes(notes, &mut |wi, wo| {
            let (values, nearest) = smoothed.value(wi, wo);
            looks[0] += 1;
            looks[1] += usize::from(nearest > HOLE);
            if looks[0] % BETWEEN_SHOWS == 0 {
                progress.within(looks[0] as f64 / total as f64);
            }
            (values, nearest)
        })?;
        Ok((bytes, looks))
    }

    fn tell(&self, document: &Document) -> Result<(), Failure> {
        if let Some(file) = &document.file {
            print::note(format_args!("wrote {file}"));
        }
        document.notes.iter().for_each(|note| print::note(format_args!("note: {note}")));
        if self.format.is_json() {
            return print::json(document);
        }
        let Document { readings, neighbours, noise, holes, anisotropic, .. } = document;
        let grain = if *anisotropic { ", with a grain" } else { "" };
        print::text(&format!(
            "{readings} readings{grain}; {neighbours} tell a direction; readings are off by {:.1} % from what the others tell\n\
             {:.1} % of the directions are far from all readings\n",
            100.0 * noise,
            100.0 * holes
        ))
    }
}

/// A line for each direction of a regular grid.
fn table(
    channels: &Channels,
    anisotropic: bool,
    f: &mut dyn FnMut(Vec3<f64>, Vec3<f64>) -> (Vec<f64>, f64),
) -> String {
    let names = channels.names().join(",");
    let mut text = format!(
        "# quantity {}\n# Readings smoothed by Glanz.\ntheta_i_deg,phi_i_deg,theta_o_deg,phi_o_deg,{names},distance\n",
        Quantity::Brdf.name()
    );
    let at =
        |theta: u32, phi: u32| Vec3::from_angles(f64::from(theta).to_radians(), f64::from(phi).to_radians());
    let lights: Vec<u32> = if anisotropic { (0..360).step_by(15).collect() } else { vec![180] };
    for theta_i in (0..=85).step_by(5) {
        for phi_i in &lights {
            for theta_o in (0..=85).step_by(5) {
                for phi_o in (0..360).step_by(15).take(if theta_o == 0 { 1 } else { 24 }) {
                    let (values, distance) = f(at(theta_i, *phi_i), at(theta_o, phi_o));
                    let values: Vec<String> =
                        values.iter().map(|value| format!("{}", *value as f32)).collect();
                    text += &format!(
                        "{theta_i},{phi_i},{theta_o},{phi_o},{},{:.4}\n",
                        values.join(","),
                        distance.min(9.0)
                    );
                }
            }
        }
    }
    text
}
