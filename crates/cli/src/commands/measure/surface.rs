//! What is compared: data, a material or a model, as a material that can be drawn.

use std::path::Path;

use glanz_bsdf::MODELS;
use glanz_color::Rgb;
use glanz_math::Vec3;
use glanz_measure::{Data, FactorOptions, Factored, Measured};
use glanz_scene::{Lobe, Material};

use super::appearance::{of_library, of_scene};
use super::{ReadArgs, is_measured, read};
use crate::commands::bsdf::shape_of;
use crate::print::failure::{Failure, Report};

/// A material, and where it was measured.
pub(super) struct Surface {
    pub(super) material: Material,
    /// To light and detector; none of what is no file of readings one by one.
    pub(super) pairs: Vec<[Vec3<f64>; 2]>,
    pub(super) notes: Vec<String>,
}

impl Surface {
    /// The one that a word of the command line means.
    pub(super) fn of(word: &str, args: &ReadArgs) -> Result<Self, Failure> {
        let path = Path::new(word);
        let bare = |material| Self { material, pairs: Vec::new(), notes: Vec::new() };
        if is_measured(path) {
            return Self::of_data(path, args);
        }
        if path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml")) {
            return of_scene(path, None).map(bare);
        }
        if MODELS.iter().any(|info| info.name == word) {
            let lobe = Lobe::new(shape_of(word, &[])?, Rgb::WHITE);
            return Ok(bare(Material::of_lobes(word, vec![lobe])));
        }
        of_library(word).map(bare)
    }

    fn of_data(path: &Path, args: &ReadArgs) -> Result<Self, Failure> {
        Self::of_measured(&read(path, args)?, path)
    }

    /// Data of a file.
    pub(super) fn of_measured(measured: &Measured, path: &Path) -> Result<Self, Failure> {
        let factored = Factored::of(measured, &FactorOptions::default())
            .map_err(|error| Failure::from(Report::new(error).file(path)))?;
        let pairs = match &measured.data {
            Data::Readings(readings) => (0..readings.len()).map(|i| readings.pair(i)).collect(),
            _ => Vec::new(),
        };
        let name = path.display().to_string();
        let notes = measured.notes.iter().map(|note| format!("{name}: {note}")).collect();
        Ok(Self { material: Material::measured(name, &factored), pairs, notes })
    }
}
