//! `glanz measure convert`: one format into another.

use std::io::Write as _;
use std::path::{Path, PathBuf};

use clap::{Args, ValueHint};
use glanz_measure::{Channels, Data, Measured, Merl, Quantity, Rgl, write_csv, write_merl, write_rgl};
use glanz_picture::output::{OutputError, write_atomically};
use schemars::JsonSchema;
use serde::Serialize;

use super::{ReadArgs, quantity, read};
use crate::args::check_folder;
use crate::print::failure::{Failure, Report};
use crate::print::{self, FormatArgs};

/// Shown after the help.
pub(crate) const EXAMPLES: &str = "\
Examples:
  glanz measure convert paint.bsdf -o paint.csv
  glanz measure convert paint.bsdf -o paint.binary
  glanz measure convert gold.binary -o gold.bsdf
  glanz measure convert steel.astm -o steel.csv --as reflectance-factor

The ending of the output names its format: .csv for a table of all readings, .binary for MERL's, .bsdf for
RGL's. MERL and RGL hold values everywhere, so they are made of tables only: readings alone say nothing
between them. Where a table has no data MERL gets none, and RGL gets what lies nearest to it in angle of the
detector. MERL is RGB and isotropic; the first azimuth of a table that is not stands for all.";

/// Options of `glanz measure convert`.
#[derive(Args, Debug)]
pub(crate) struct ConvertArgs {
    /// A file of measured reflectance
    #[arg(value_name = "FILE", value_hint = ValueHint::FilePath)]
    file: PathBuf,

    /// The file that is written; its ending is that of its format
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    output: PathBuf,

    /// What the numbers of a table are: brdf, brdf-cos or reflectance-factor
    #[arg(long = "as", value_name = "QUANTITY", value_parser = quantity, default_value = "brdf")]
    written: Quantity,

    #[command(flatten)]
    read: ReadArgs,
    #[command(flatten)]
    format: FormatArgs,
}

/// What was written.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    pub(super) file: String,
    /// csv, merl or rgl
    pub(super) format: &'static str,
    /// Readings in a table; null of others
    pub(super) readings: Option<usize>,
    /// What is odd, and what was dropped
    pub(super) notes: Vec<String>,
}

impl ConvertArgs {
    /// Reads and writes.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let kind = Kind::of(&self.output)?;
        check_folder(&self.output)?;
        let measured = read(&self.file, &self.read)?;
        let mut notes = measured.notes.clone();
        let (bytes, readings) = match kind {
            Kind::Csv => {
                let readings = measured.readings();
                let text = write_csv(&readings, self.written, &measured.description);
                (text.into_bytes(), Some(readings.len()))
            }
            Kind::Merl => (self.merl(&measured)?, None),
            Kind::Rgl => (self.rgl(&measured, &mut notes)?, None),
        };
        deliver(&bytes, &self.output, kind, readings, notes, self.format)
    }

    fn merl(&self, measured: &Measured) -> Result<Vec<u8>, Failure> {
        if let Data::Merl(table) = &measured.data {
            return Ok(write_merl(table));
        }
        self.needs_table(measured, "MERL")?;
        if !matches!(measured.channels(), Channels::Rgb) {
            let message = format!("MERL's files are RGB, and these data have {}", measured.channels());
            return Err(Report::new(message).file(&self.file).help("write a .csv or a .bsdf").into());
        }
        let table = Merl::of(&mut |wi, wo| {
            let value = measured.value(wi, wo).unwrap_or_default();
            [0, 1, 2].map(|c| value.get(c).copied().unwrap_or(-1.0))
        });
        Ok(write_merl(&table))
    }

    fn rgl(&self, measured: &Measured, notes: &mut Vec<String>) -> Result<Vec<u8>, Failure> {
        if let Data::Rgl(table) = &measured.data {
            return Ok(write_rgl(table));
        }
        self.needs_table(measured, "RGL")?;
        let count = measured.channels().count();
        let (mut holes, mut all) = (0_usize, 0_usize);
        let table = Rgl::of_function(measured.channels().clone(), &measured.description, &mut |wi, wo| {
            all += 1;
            if let Some(value) = measured.value(wi, wo) {
                return value;
            }
            holes += 1;
            // Towards the normal there is something sooner or later.
            let raised = |step: i32| {
                let up = 0.05 * f64::from(step);
                let [wi, wo] = [wi, wo].map(|w| glanz_math::Vec3::new(w.x, w.y, w.z + up).normalized());
                measured.value(wi, wo)
            };
            (1..60).find_map(raised).unwrap_or_else(|| vec![0.0; count])
        });
        if holes > 0 {
            notes.push(format!(
                "{holes} of {all} looks met no data, and took what is next towards the normal"
            ));
        }
        let table = table.map_err(|error| Failure::from(Report::new(error).file(&self.file)))?;
        Ok(write_rgl(&table))
    }

    /// A format that holds values everywhere.
    fn needs_table(&self, measured: &Measured, format: &str) -> Result<(), Failure> {
        match measured.data {
            Data::Readings(_) => {
                let message =
                    format!("{format}'s files hold values everywhere, and these are readings alone");
                Err(Report::new(message).file(&self.file).help("write a .csv").into())
            }
            _ => Ok(()),
        }
    }
}

/// A format that is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Csv,
    Merl,
    Rgl,
}

impl Kind {
    /// That of a file's ending.
    pub(super) fn of(file: &Path) -> Result<Self, Failure> {
        let ending = file.extension().map(|end| end.to_string_lossy().to_lowercase()).unwrap_or_default();
        match ending.as_str() {
            "csv" => Ok(Self::Csv),
            "binary" => Ok(Self::Merl),
            "bsdf" => Ok(Self::Rgl),
            _ => Err(Failure::Usage(format!(
                "'{}' names no format: expected an ending of .csv, .binary (MERL) or .bsdf (RGL)",
                file.display()
            ))),
        }
    }
}

/// Writes a file, and tells it.
pub(super) fn deliver(
    bytes: &[u8],
    file: &Path,
    kind: Kind,
    readings: Option<usize>,
    notes: Vec<String>,
    format: FormatArgs,
) -> Result<(), Failure> {
    write_atomically(file, |out| out.write_all(bytes).map_err(OutputError::Stream))?;
    print::note(format_args!("wrote {}", file.display()));
    notes.iter().for_each(|note| print::note(format_args!("note: {note}")));
    if format.is_json() {
        let format = match kind {
            Kind::Csv => "csv",
            Kind::Merl => "merl",
            Kind::Rgl => "rgl",
        };
        return print::json(&Document { file: file.display().to_string(), format, readings, notes });
    }
    Ok(())
}
