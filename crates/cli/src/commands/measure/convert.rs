//! `glanz measure convert`: one format into another.

use std::io::Write as _;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum, ValueHint};
use glanz_math::Vec3;
use glanz_measure::{
    Coordinates, Data, Klems, Measured, Merl, Quantity, Rgl, Smoothed, Table, write_csv, write_klems,
    write_merl, write_rgl, write_zemax, zemax_nodes_deg,
};
use glanz_picture::output::{OutputError, write_atomically};
use schemars::JsonSchema;
use serde::Serialize;

use super::tristimulus::Conversion;
use super::written::Written;
use super::{ReadArgs, quantity, read};
use crate::args::check_folder;
use crate::print::failure::{Failure, Report};
use crate::print::{self, FormatArgs};
use crate::progress::Progress;

/// Shown after the help.
pub(crate) const EXAMPLES: &str = "\
Examples:
  glanz measure convert paint.bsdf -o paint.csv
  glanz measure convert paint.bsdf -o paint.binary
  glanz measure convert gold.binary -o gold.bsdf
  glanz measure convert steel.astm -o steel.csv --as reflectance-factor
  glanz measure convert steel.astm -o steel.binary
  glanz measure convert vinyl.bsdf --to zemax -o again.bsdf
  glanz measure convert satin.binary -o satin.xml

The ending of the output names its format: .csv for a table of all readings, .binary for MERL's, .bsdf for
RGL's, .xml for Radiance's and WINDOW's matrix over Klems' patches; --to names it whatever the ending, for
stdout (-o -) and Zemax's .bsdf. All but CSV hold values everywhere: readings alone, which say nothing between them, are
smoothed first, as `glanz measure smooth` does. Where a table has no data MERL and Zemax get none, and the others what lies nearest.
MERL and RGL have red, green and blue (RGL wavelengths, too), Zemax and Klems one channel or X, Y and Z:
others are converted, which is told. MERL is isotropic: the first azimuth of a table that is not stands for
all.";

/// Options of `glanz measure convert`.
#[derive(Args, Debug)]
pub(crate) struct ConvertArgs {
    /// A file of measured reflectance
    #[arg(value_name = "FILE", value_hint = ValueHint::FilePath)]
    file: PathBuf,

    /// The file that is written; its ending is that of its format
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    output: PathBuf,

    /// Its format, whatever the ending is
    #[arg(long, value_enum, value_name = "FORMAT")]
    to: Option<Kind>,

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
    /// csv, merl, rgl, zemax or klems
    pub(super) format: &'static str,
    /// Readings in a table; null of others
    pub(super) readings: Option<usize>,
    /// What is odd, and what was dropped
    pub(super) notes: Vec<String>,
}

impl ConvertArgs {
    /// Reads and writes.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let kind = Kind::of(&self.output, self.to)?;
        check_output(&self.output, self.format)?;
        let measured = read(&self.file, &self.read)?;
        let mut notes = measured.notes.clone();
        let (bytes, readings) = match kind {
            kind if kind != Kind::Csv && matches!(measured.data, Data::Readings(_)) => {
                (self.smoothed(kind, &measured, &mut notes)?, None)
            }
            Kind::Csv => {
                let readings = measured.readings();
                let text = write_csv(&readings, self.written, &measured.description);
                (text.into_bytes(), Some(readings.len()))
            }
            Kind::Merl => (self.merl(&measured, &mut notes)?, None),
            Kind::Rgl => (self.rgl(&measured, &mut notes)?, None),
            Kind::Zemax => (self.zemax(&measured, &mut notes)?, None),
            Kind::Klems => (self.klems(&measured, &mut notes)?, None),
        };
        deliver(&bytes, &self.output, kind, readings, notes, self.format)
    }

    fn merl(&self, measured: &Measured, notes: &mut Vec<String>) -> Result<Vec<u8>, Failure> {
        if let Data::Merl(table) = &measured.data {
            return Ok(write_merl(table));
        }
        let conversion = told(Conversion::to_rgb(measured.channels()), notes);
        let table = Merl::of(&mut |wi, wo| {
            let value = measured.value(wi, wo).map(|value| conversion.apply(value)).unwrap_or_default();
            [0, 1, 2].map(|c| value.get(c).copied().unwrap_or(-1.0))
        });
        Ok(write_merl(&table))
    }

    fn rgl(&self, measured: &Measured, notes: &mut Vec<String>) -> Result<Vec<u8>, Failure> {
        if let Data::Rgl(table) = &measured.data {
            return Ok(write_rgl(table));
        }
        let conversion = told(Conversion::to_rgl(measured.channels()), notes);
        let mut looks = Looks::default();
        let mut f = |wi: Vec3<f64>, wo: Vec3<f64>| conversion.apply(looks.value(measured, wi, wo));
        let (channels, description) = (conversion.channels.clone(), &measured.description);
        let table = match measured.is_isotropic() {
            true => Rgl::of_function(channels, description, &mut f),
            false => Rgl::of_anisotropic_function(channels, description, &mut f),
        };
        looks.tell(notes);
        let table = table.map_err(|error| Failure::from(Report::new(error).file(&self.file)))?;
        Ok(write_rgl(&table))
    }

    fn zemax(&self, measured: &Measured, notes: &mut Vec<String>) -> Result<Vec<u8>, Failure> {
        if let Data::Table(table) = &measured.data
            && let Ok(text) = write_zemax(table, &measured.description)
        {
            return Ok(text.into_bytes());
        }
        let conversion = told(Conversion::to_xyz(measured.channels()), notes);
        let count = conversion.channels.count();
        let nodes = zemax_nodes_deg(if measured.is_isotropic() { 1 } else { ROTATIONS });
        let channels = conversion.channels.clone();
        let table = Table::of_function(Coordinates::Specular, nodes, channels, &mut |wi, wo| {
            let value = measured.extended(wi, wo).map(|value| conversion.apply(value));
            value.unwrap_or_else(|| vec![f64::NAN; count])
        });
        let wrong = |error: &dyn std::fmt::Display| Failure::from(Report::new(error).file(&self.file));
        let table = table.map_err(|error| wrong(&error))?;
        let text = write_zemax(&table, &measured.description).map_err(|error| wrong(&error))?;
        Ok(text.into_bytes())
    }

    fn klems(&self, measured: &Measured, notes: &mut Vec<String>) -> Result<Vec<u8>, Failure> {
        if let Data::Klems(table) = &measured.data
            && let Ok(xml) = write_klems(table, &measured.description)
        {
            return Ok(xml.into_bytes());
        }
        let conversion = told(Conversion::to_xyz(measured.channels()), notes);
        let mut looks = Looks::default();
        let table = Klems::of_function(conversion.channels.clone(), &mut |wi, wo| {
            conversion.apply(looks.value(measured, wi, wo))
        });
        looks.tell(notes);
        let xml = write_klems(&table, &measured.description);
        Ok(xml.map_err(|error| Failure::from(Report::new(error).file(&self.file)))?.into_bytes())
    }

    /// Readings in a format that holds values everywhere: what smoothing tells between them.
    fn smoothed(&self, kind: Kind, measured: &Measured, notes: &mut Vec<String>) -> Result<Vec<u8>, Failure> {
        let smoothed = Smoothed::of(measured, None)
            .map_err(|error| Failure::from(Report::new(error).file(&self.file)))?;
        notes.push(format!(
            "{} readings were smoothed, since the format holds values everywhere; 'glanz measure smooth' tells how far to trust them",
            smoothed.readings()
        ));
        let written = Written {
            channels: smoothed.channels(),
            anisotropic: smoothed.is_anisotropic(),
            description: &measured.description,
            output: &self.output,
        };
        let mut progress = Progress::new(1, "files");
        let mut count = 0_usize;
        written.bytes(kind, notes, &mut |wi, wo| {
            count += 1;
            if count.is_multiple_of(BETWEEN_SHOWS) {
                // How many directions a format asks for differs; most ask for as many as MERL's cells.
                progress.within((count as f64 / MANY).min(1.0));
            }
            smoothed.value(wi, wo).0
        })
    }
}

/// Directions between two shows of progress, and about how many a file has.
const BETWEEN_SHOWS: usize = 4096;
const MANY: f64 = 1.5e6;

/// Rotations of the sample in Zemax's files of anisotropic data.
pub(super) const ROTATIONS: usize = 36;

/// Notes what a conversion takes the channels to be.
fn told(conversion: Conversion, notes: &mut Vec<String>) -> Conversion {
    notes.extend(conversion.note.clone());
    conversion
}

/// Looks into data that need not know every pair of directions.
#[derive(Default)]
struct Looks {
    all: usize,
    holes: usize,
}

impl Looks {
    /// The value, or the nearest that there is.
    fn value(&mut self, measured: &Measured, wi: Vec3<f64>, wo: Vec3<f64>) -> Vec<f64> {
        self.all += 1;
        if let Some(value) = measured.value(wi, wo) {
            return value;
        }
        self.holes += 1;
        // Towards the normal there is something sooner or later.
        let raised = |step: i32| {
            let up = 0.05 * f64::from(step);
            let [wi, wo] = [wi, wo].map(|w| Vec3::new(w.x, w.y, w.z + up).normalized());
            measured.extended(wi, wo)
        };
        (0..60).find_map(raised).unwrap_or_else(|| vec![0.0; measured.channels().count()])
    }

    fn tell(&self, notes: &mut Vec<String>) {
        let Self { all, holes } = self;
        if *holes > 0 {
            notes.push(format!("{holes} of {all} looks met no data, and took what is next to them"));
        }
    }
}

/// A format that is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Kind {
    /// A table of readings with named columns
    Csv,
    /// MERL's table
    Merl,
    /// RGL's adaptive parametrisation
    Rgl,
    /// Zemax's table around the mirror direction
    Zemax,
    /// Radiance's and WINDOW's matrix over Klems' patches
    Klems,
}

impl Kind {
    /// The one that is asked for, or that of a file's ending.
    pub(super) fn of(file: &Path, asked: Option<Self>) -> Result<Self, Failure> {
        if let Some(kind) = asked {
            return Ok(kind);
        }
        let ending = file.extension().map(|end| end.to_string_lossy().to_lowercase()).unwrap_or_default();
        match ending.as_str() {
            "csv" => Ok(Self::Csv),
            "binary" => Ok(Self::Merl),
            "bsdf" => Ok(Self::Rgl),
            "xml" => Ok(Self::Klems),
            _ => Err(Failure::Usage(format!(
                "'{}' names no format: expected an ending of .csv, .binary (MERL), .bsdf (RGL) or .xml (Klems), or --to",
                file.display()
            ))),
        }
    }

    /// Its word in documents.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Merl => "merl",
            Self::Rgl => "rgl",
            Self::Zemax => "zemax",
            Self::Klems => "klems",
        }
    }
}

/// Writes a file.
pub(super) fn save(bytes: &[u8], file: &Path) -> Result<(), Failure> {
    Ok(write_atomically(file, |out| out.write_all(bytes).map_err(OutputError::Stream))?)
}

/// That the file may be written, or that stdout, for `-`, has nothing else to take.
pub(super) fn check_output(file: &Path, format: FormatArgs) -> Result<(), Failure> {
    if file == Path::new("-") && format.is_json() {
        let message = "stdout takes the file, not the document too; name a file with -o";
        return Err(Failure::Usage(message.to_owned()));
    }
    check_folder(file)
}

/// Writes a file, or to stdout for `-`, and tells it.
pub(super) fn deliver(
    bytes: &[u8],
    file: &Path,
    kind: Kind,
    readings: Option<usize>,
    notes: Vec<String>,
    format: FormatArgs,
) -> Result<(), Failure> {
    let told = |notes: &[String]| notes.iter().for_each(|note| print::note(format_args!("note: {note}")));
    if file == Path::new("-") {
        told(&notes);
        return print::bytes(bytes);
    }
    save(bytes, file)?;
    print::note(format_args!("wrote {}", file.display()));
    told(&notes);
    if format.is_json() {
        let format = kind.name();
        return print::json(&Document { file: file.display().to_string(), format, readings, notes });
    }
    Ok(())
}
