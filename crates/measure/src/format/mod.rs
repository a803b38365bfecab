//! Files of measured reflectance.

mod alta;
mod astm;
mod coordinates;
mod csail;
mod csv;
mod lighttools;
mod merl;
mod pab;
mod radiance;
mod rgl;
mod ssdd;
mod table;
mod text;
mod utia;
mod zemax;

use std::borrow::Cow;

use glanz_math::Vec3;

use crate::{Channels, Quantity, ReadError, Readings, published};

pub use self::csv::write_csv;
pub use coordinates::Coordinates;
pub(crate) use merl::cells as merl_cells;
pub use merl::{Merl, write_merl};
pub use radiance::{Klems, TensorTree, write_klems};
pub use rgl::{Rgl, write_rgl};
pub use table::Table;
pub use zemax::{write_zemax, zemax_nodes_deg};

/// A kind of file.
///
/// ```
/// use glanz_measure::{Format, Measured};
///
/// // What a file is its content tells, not its name.
/// let text = "VARS theta_i,phi_i,theta_s,phi_s,R,G,B\n0.5,3.14159,0.5,0.0,0.3,0.2,0.1\n";
/// let measured = Measured::read(text.as_bytes(), "paint.txt", &Default::default())?;
/// assert_eq!((measured.format, measured.format.name()), (Format::Astm, "astm"));
/// # Ok::<(), glanz_measure::ReadError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// A table with named columns ([`write_csv`]).
    Csv,
    /// MERL's `.binary`: isotropic, RGB, in half and difference angles (W. Matusik 2003).
    Merl,
    /// RGL's `.bsdf`: an adaptive parametrisation (J. Dupuy and W. Jakob 2018).
    Rgl,
    /// ASTM E1392, as Cornell's files are.
    Astm,
    /// Zemax's tabular `.bsdf`: angles around the mirror direction ([`write_zemax`]).
    Zemax,
    /// LightTools' tabular `.bsdf`.
    LightTools,
    /// The text of pab's goniometers (Mountain).
    Pab,
    /// Radiance's and WINDOW's XML, a matrix over Klems' patches ([`write_klems`]).
    Klems,
    /// Radiance's XML, a tensor tree.
    TensorTree,
    /// UTIA's `.bin` (J. Filip and R. Vávra 2014).
    Utia,
    /// MIT CSAIL's anisotropic tables (A. Ngan, F. Durand and W. Matusik 2005).
    Csail,
    /// libbsdf's `.ssdd`.
    Ssdd,
    /// ALTA's text, or its numbers in binary.
    Alta,
}

impl Format {
    /// All of them.
    pub const ALL: [Self; 13] = [
        Self::Csv,
        Self::Merl,
        Self::Rgl,
        Self::Astm,
        Self::Zemax,
        Self::LightTools,
        Self::Pab,
        Self::Klems,
        Self::TensorTree,
        Self::Utia,
        Self::Csail,
        Self::Ssdd,
        Self::Alta,
    ];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Merl => "merl",
            Self::Rgl => "rgl",
            Self::Astm => "astm",
            Self::Zemax => "zemax",
            Self::LightTools => "lighttools",
            Self::Pab => "pab",
            Self::Klems => "klems",
            Self::TensorTree => "tensor_tree",
            Self::Utia => "utia",
            Self::Csail => "csail",
            Self::Ssdd => "ssdd",
            Self::Alta => "alta",
        }
    }
}

/// How a file is read.
///
/// ```
/// use glanz_measure::{Quantity, ReadOptions};
///
/// // The numbers of a UTIA file as dj_brdf takes them.
/// let options = ReadOptions { srgb_white: Some(140.0), scale: Some(100.0), ..ReadOptions::default() };
/// assert_eq!(options.quantity, None);
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ReadOptions {
    /// What its numbers are, whatever it says itself.
    pub quantity: Option<Quantity>,
    /// A factor of the numbers of UTIA's and CSAIL's files, on whose scale their readers disagree.
    pub scale: Option<f64>,
    /// The number that stands for 1 in a UTIA file whose numbers are encoded as sRGB; they are decoded, then scaled.
    pub srgb_white: Option<f64>,
}

/// What a file holds.
#[derive(Clone, Debug, PartialEq)]
pub enum Data {
    /// Readings one by one.
    Readings(Readings),
    /// MERL's table.
    Merl(Merl),
    /// RGL's tables.
    Rgl(Box<Rgl>),
    /// A table over four angles.
    Table(Box<Table>),
    /// A matrix over patches of the hemisphere.
    Klems(Box<Klems>),
    /// A tensor tree.
    Tree(Box<TensorTree>),
}

/// Nearer to the horizon than half a degree no goniometer sees; there a product with the cosine is divided by this one.
const LEAST_COSINE: f64 = 0.01;

/// A file of measured reflectance.
///
/// ```
/// use glanz_math::Vec3;
/// use glanz_measure::{Channels, Klems, Measured, write_klems};
///
/// // A table has values everywhere above the horizon; of readings one by one `Smoothed` tells what lies between.
/// let grey = Klems::of_function(Channels::Luminance, &mut |_, _| vec![0.2]);
/// let file = Measured::read(write_klems(&grey, "grey")?.as_bytes(), "grey.xml", &Default::default())?;
/// let (wi, wo) = (Vec3::from_angles(0.5, 3.0), Vec3::from_angles(0.8, 0.0));
/// assert!((file.value(wi, wo).expect("both are above the horizon")[0] - 0.2).abs() < 1e-6);
/// assert_eq!((file.description.as_str(), file.readings().len()), ("grey", 145 * 145));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// What kind of file it is.
    pub format: Format,
    /// What its numbers were; here they are BRDF.
    pub quantity: Quantity,
    /// What it says of the sample.
    pub description: String,
    /// What it holds.
    pub data: Data,
    /// What is odd about it, and what of it was dropped.
    pub notes: Vec<String>,
}

impl Measured {
    /// Reads a file; what it is its content tells. `name` is for what is said of it.
    pub fn read(bytes: &[u8], name: &str, options: &ReadOptions) -> Result<Self, ReadError> {
        if bytes.iter().all(u8::is_ascii_whitespace) {
            return Err(ReadError::Unknown(format!("'{name}' is empty")));
        }
        let measured = match read_binary(bytes, options) {
            Some(read) => read?,
            None => {
                let (text, note) = decoded(bytes, name)?;
                let mut measured = read_text(&text, name, options)?;
                measured.notes.extend(note);
                measured
            }
        };
        let is_scaled = options.scale.is_some() && !matches!(measured.format, Format::Utia | Format::Csail);
        if is_scaled || options.srgb_white.is_some() && measured.format != Format::Utia {
            let message = "a scale is for files of UTIA and CSAIL, encoded numbers are for those of UTIA";
            return Err(ReadError::broken(format!("{message}; this one is of {}", measured.format.name())));
        }
        Ok(measured)
    }

    /// What the values belong to.
    pub fn channels(&self) -> &Channels {
        match &self.data {
            Data::Readings(readings) => readings.channels(),
            Data::Merl(_) => &Channels::Rgb,
            Data::Rgl(rgl) => rgl.channels(),
            Data::Table(table) => table.channels(),
            Data::Klems(klems) => klems.channels(),
            Data::Tree(tree) => tree.channels(),
        }
    }

    /// The BRDF at any pair of directions, one number per channel, where the data say it: nothing of readings alone, below
    /// the horizon, and in cells without data.
    pub fn value(&self, wi: Vec3<f64>, wo: Vec3<f64>) -> Option<Vec<f64>> {
        match &self.data {
            Data::Readings(_) => None,
            Data::Merl(merl) => merl.value(wi, wo).map(|rgb| rgb.to_vec()),
            Data::Rgl(rgl) => {
                let cos_o = wo.z.max(LEAST_COSINE);
                Some(rgl.f_cos(wi, wo)?.iter().map(|value| value / cos_o).collect())
            }
            Data::Table(table) => table.value(wi, wo),
            Data::Klems(klems) => klems.value(wi, wo),
            Data::Tree(tree) => tree.value(wi, wo),
        }
    }

    /// As [`Measured::value`], and beyond the nodes of a table over four angles what is at the nearest of them.
    pub fn extended(&self, wi: Vec3<f64>, wo: Vec3<f64>) -> Option<Vec<f64>> {
        match &self.data {
            Data::Table(table) => table.value(wi, wo).or_else(|| table.extended(wi, wo)),
            _ => self.value(wi, wo),
        }
    }

    /// The readings that are in the file: of tables those at their nodes.
    pub fn readings(&self) -> Readings {
        match &self.data {
            Data::Readings(readings) => readings.clone(),
            Data::Merl(merl) => merl.readings(),
            Data::Rgl(rgl) => rgl.readings(),
            Data::Table(table) => table.readings(),
            Data::Klems(klems) => klems.readings(),
            Data::Tree(tree) => tree.readings(),
        }
    }

    /// Whether the data depend on differences of azimuths alone, as far as their format tells; readings tell nothing.
    pub fn is_isotropic(&self) -> bool {
        match &self.data {
            Data::Readings(_) | Data::Klems(_) => false,
            Data::Merl(_) => true,
            Data::Rgl(rgl) => rgl.is_isotropic(),
            Data::Table(table) => table.is_isotropic(),
            Data::Tree(tree) => tree.is_isotropic(),
        }
    }
}

/// Reads a file as one of this format, whatever its content is.
#[cfg(feature = "fuzz")]
pub(crate) fn read_as(
    format: Format,
    bytes: &[u8],
    name: &str,
    options: &ReadOptions,
) -> Result<Measured, ReadError> {
    match format {
        Format::Merl => return merl::read(bytes, options),
        Format::Rgl => return rgl::read(bytes, options),
        Format::Utia => return utia::read(bytes, options),
        Format::Csail => return csail::read(bytes, options),
        Format::Ssdd => return ssdd::read(bytes, options),
        Format::Alta if alta::is_binary(bytes) => return alta::read_binary(bytes, options),
        _ => (),
    }
    let (text, _) = decoded(bytes, name)?;
    match format {
        Format::Astm => astm::read(&text, options),
        Format::Zemax => zemax::read(&text, options),
        Format::LightTools => lighttools::read(&text, options),
        Format::Pab => pab::read(&text, options),
        Format::Klems | Format::TensorTree => radiance::read(&text, options),
        Format::Alta => alta::read(&text, options),
        _ => csv::read(&text, name, options),
    }
}

/// Reads what is no text; nothing of what is one.
fn read_binary(bytes: &[u8], options: &ReadOptions) -> Option<Result<Measured, ReadError>> {
    if rgl::is_rgl(bytes) {
        return Some(rgl::read(bytes, options));
    }
    if ssdd::is_ssdd(bytes) {
        return Some(ssdd::read(bytes, options));
    }
    if alta::is_binary(bytes) {
        return Some(alta::read_binary(bytes, options));
    }
    if merl::is_merl(bytes) {
        return Some(merl::read(bytes, options));
    }
    if utia::is_utia(bytes) {
        return Some(utia::read(bytes, options));
    }
    csail::is_csail(bytes).then(|| csail::read(bytes, options))
}

/// The text of a file, and what is odd about it.
fn decoded<'a>(bytes: &'a [u8], name: &str) -> Result<(Cow<'a, str>, Option<String>), ReadError> {
    if let Ok(text) = std::str::from_utf8(bytes) {
        return Ok((Cow::Borrowed(text.trim_start_matches('\u{feff}')), None));
    }
    let is_control = |byte: &u8| *byte < 9 || (14..32).contains(byte);
    if bytes.iter().any(is_control) {
        let head = bytes.iter().take(12).map(|b| format!("{b:02x}")).collect::<Vec<_>>().join(" ");
        return Err(ReadError::Unknown(format!("'{name}' begins with {head}")));
    }
    let note = "the text is not UTF-8, and is read as Latin-1".to_owned();
    Ok((bytes.iter().map(|byte| char::from(*byte)).collect(), Some(note)))
}

fn read_text(text: &str, name: &str, options: &ReadOptions) -> Result<Measured, ReadError> {
    if radiance::is_radiance(text) {
        return radiance::read(text, options);
    }
    if text::has_keyword(text, "AngleOfIncidence") {
        return zemax::read(text, options);
    }
    if text::has_keyword(text, "AOI") && text::has_keyword(text, "DataBegin") {
        return lighttools::read(text, options);
    }
    if published::is_fits(text) {
        let message = "the file holds fitted models, not readings; PublishedFit::read takes it";
        return Err(ReadError::broken(message));
    }
    if alta::is_alta(text) {
        return alta::read(text, options);
    }
    if pab::is_pab(text) {
        return pab::read(text, options);
    }
    match astm::is_astm(text) {
        true => astm::read(text, options),
        false => csv::read(text, name, options),
    }
}
