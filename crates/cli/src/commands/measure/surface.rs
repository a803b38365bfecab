//! What is compared: data, a material or a model, as a material that can be drawn.

use std::path::Path;

use glanz_bsdf::MODELS;
use glanz_color::Rgb;
use glanz_math::Vec3;
use glanz_measure::{Data, FactorOptions, Factored, Measured, Readings};
use glanz_scene::{Lobe, Material};

use super::appearance::{of_library, of_scene};
use super::{ReadArgs, is_measured, read};
use crate::commands::bsdf::shape_of;
use crate::print::failure::{Failure, Report};

/// A material, and where it was measured.
pub(super) struct Surface {
    pub(super) material: Material,
    /// None of what is no file of readings one by one.
    pub(super) readings: Option<Readings>,
    pub(super) notes: Vec<String>,
}

impl Surface {
    /// The one that a word of the command line means.
    pub(super) fn of(word: &str, args: &ReadArgs) -> Result<Self, Failure> {
        let path = Path::new(word);
        let bare = |material| Self { material, readings: None, notes: Vec::new() };
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
        let name = path.display().to_string();
        let notes = measured.notes.iter().map(|note| format!("{name}: {note}")).collect();
        let readings = match &measured.data {
            Data::Readings(readings) => Some(readings.clone()),
            _ => None,
        };
        Ok(Self { material: Material::measured(name, &factored), readings, notes })
    }

    /// Directions to light and detector that were measured.
    pub(super) fn pairs(&self) -> Option<Vec<[Vec3<f64>; 2]>> {
        let readings = self.readings.as_ref()?;
        Some((0..readings.len()).map(|index| readings.pair(index)).collect())
    }
}
