//! Functions of two directions as files that hold values everywhere.

use std::path::Path;

use glanz_math::Vec3;
use glanz_measure::{
    Channels, Coordinates, Klems, Merl, Rgl, Table, write_klems, write_merl, write_rgl, write_zemax,
    zemax_nodes_deg,
};

use super::convert::{Kind, ROTATIONS};
use super::tristimulus::Conversion;
use crate::print::failure::{Failure, Report};

/// A BRDF that is to be written.
pub(super) struct Written<'a> {
    pub(super) channels: &'a Channels,
    pub(super) anisotropic: bool,
    pub(super) description: &'a str,
    /// Where it goes.
    pub(super) output: &'a Path,
}

impl Written<'_> {
    /// The file of this kind, which is none of readings one by one.
    pub(super) fn bytes(
        &self,
        kind: Kind,
        notes: &mut Vec<String>,
        f: &mut dyn FnMut(Vec3<f64>, Vec3<f64>) -> Vec<f64>,
    ) -> Result<Vec<u8>, Failure> {
        let wrong = |error: &dyn std::fmt::Display| Failure::from(Report::new(error).file(self.output));
        let conversion = match kind {
            Kind::Merl => Conversion::to_rgb(self.channels),
            Kind::Rgl => Conversion::to_rgl(self.channels),
            Kind::Csv | Kind::Zemax | Kind::Klems => Conversion::to_xyz(self.channels),
        };
        notes.extend(conversion.note.clone());
        let channels = conversion.channels.clone();
        let mut f = |wi: Vec3<f64>, wo: Vec3<f64>| conversion.apply(f(wi, wo));
        Ok(match kind {
            Kind::Merl => write_merl(&Merl::of(&mut |wi, wo| {
                let value = f(wi, wo);
                [0, 1, 2].map(|c| value.get(c).copied().unwrap_or(-1.0))
            })),
            Kind::Rgl => {
                let table = match self.anisotropic {
                    false => Rgl::of_function(channels, self.description, &mut f),
                    true => Rgl::of_anisotropic_function(channels, self.description, &mut f),
                };
                write_rgl(&table.map_err(|error| wrong(&error))?)
            }
            Kind::Csv | Kind::Zemax => {
                let nodes = zemax_nodes_deg(if self.anisotropic { ROTATIONS } else { 1 });
                let table = Table::of_function(Coordinates::Specular, nodes, channels, &mut f);
                let table = table.map_err(|error| wrong(&error))?;
                write_zemax(&table, self.description).map_err(|error| wrong(&error))?.into_bytes()
            }
            Kind::Klems => {
                let table = Klems::of_function(channels, &mut f);
                write_klems(&table, self.description).map_err(|error| wrong(&error))?.into_bytes()
            }
        })
    }
}
