//! Files of measured reflectance.

mod astm;
mod csv;
mod merl;
mod rgl;

use glanz_math::Vec3;

use crate::{Channels, Quantity, ReadError, Readings};

pub use self::csv::write_csv;
pub use merl::{Merl, write_merl};
pub use rgl::{Rgl, write_rgl};

/// A kind of file.
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
}

impl Format {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Csv, Self::Merl, Self::Rgl, Self::Astm];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Merl => "merl",
            Self::Rgl => "rgl",
            Self::Astm => "astm",
        }
    }
}

/// How a file is read.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ReadOptions {
    /// What its numbers are, whatever it says itself.
    pub quantity: Option<Quantity>,
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
}

/// Nearer to the horizon than half a degree no goniometer sees; there a product with the cosine is divided by this one.
const LEAST_COSINE: f64 = 0.01;

/// A file of measured reflectance.
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
        if rgl::is_rgl(bytes) {
            return rgl::read(bytes, options);
        }
        if merl::is_merl(bytes) {
            return merl::read(bytes, options);
        }
        let text = std::str::from_utf8(bytes).map_err(|_| {
            let head = bytes.iter().take(12).map(|b| format!("{b:02x}")).collect::<Vec<_>>().join(" ");
            ReadError::Unknown(format!("'{name}' begins with {head}"))
        })?;
        match astm::is_astm(text) {
            true => astm::read(text, options),
            false => csv::read(text, name, options),
        }
    }

    /// What the values belong to.
    pub fn channels(&self) -> &Channels {
        match &self.data {
            Data::Readings(readings) => readings.channels(),
            Data::Merl(_) => &Channels::Rgb,
            Data::Rgl(rgl) => rgl.channels(),
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
        }
    }

    /// The readings that are in the file: of tables those at their nodes.
    pub fn readings(&self) -> Readings {
        match &self.data {
            Data::Readings(readings) => readings.clone(),
            Data::Merl(merl) => merl.readings(),
            Data::Rgl(rgl) => rgl.readings(),
        }
    }
}
