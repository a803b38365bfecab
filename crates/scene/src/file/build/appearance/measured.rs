//! Measured reflectance as lobes.

use std::sync::Arc;

use glanz_bsdf::FactorTable;
use glanz_measure::{Channels, FactorOptions, Factored, Measured, Quantity, ReadOptions};

use crate::Material;
use crate::file::build::builder::Builder;
use crate::file::error::Problem;
use crate::file::factors;
use crate::file::tables::appearance::measured::{MeasuredTable, QuantityName};
use crate::file::tables::values::At;

/// Remarks are made of holes that are more than this part of all directions.
const MANY_HOLES: f64 = 0.1;

/// The visible range that data in wavelengths should cover, in nm.
const VISIBLE_NM: [f64; 2] = [400.0, 700.0];

impl MeasuredTable {
    /// The lobes of the file and the azimuth of its grain as a material, made once for all materials that name it.
    pub(super) fn build(&self, material: &str, builder: &mut Builder) -> Result<Material, Problem> {
        let quantity = self.quantity.as_ref().map(|quantity| match quantity.value {
            QuantityName::Brdf => Quantity::Brdf,
            QuantityName::BrdfCos => Quantity::BrdfCos,
            QuantityName::ReflectanceFactor => Quantity::RadianceFactor,
        });
        let ranks = self.ranks.as_ref().and_then(|ranks| ranks.0);
        let neighbours = self.neighbours.as_ref().map(|neighbours| neighbours.0);
        let key = format!("{} {ranks:?} {} {neighbours:?} {quantity:?}", self.file.value, self.smooth);
        if let Some(known) = builder.made.measured.get(&key) {
            return Ok(known.clone());
        }
        let bytes = builder.read_beside(&self.file)?;
        let wrong =
            |message: String| Problem::at(&self.file.span, format!("'{}': {message}", self.file.value));
        let options = ReadOptions { quantity, ..ReadOptions::default() };
        let measured = Measured::read(&bytes, &self.file, &options).map_err(|error| {
            let place = error.line().map(|line| format!("line {line}: ")).unwrap_or_default();
            wrong(format!("{place}{error}")).help("`glanz measure info` tells what a file holds")
        })?;
        let options = FactorOptions { ranks, smooth: self.smooth, neighbours, ..FactorOptions::default() };
        let factored = Factored::of(&measured, &options).map_err(|error| {
            let span = self.ranks.as_ref().map_or(&self.file.span, |ranks| &ranks.span);
            Problem::at(span, format!("'{}': {error}", self.file.value))
        })?;
        let notes = measured.notes.iter().cloned().chain(remarks(&factored));
        builder.input.notes.extend(notes.map(|note| format!("material '{material}': {note}")));
        let built = Material::measured(material, &factored);
        builder.made.measured.insert(key, built.clone());
        Ok(built)
    }
}

/// What someone who sees the picture should know of the data.
fn remarks(factored: &Factored) -> Vec<String> {
    let mut notes = Vec::new();
    let holes = factored.facts.holes;
    if holes > MANY_HOLES {
        let percent = 100.0 * holes;
        notes.push(format!(
            "{percent:.0} % of the directions are far from all readings; a fitted model stands there"
        ));
    }
    if let Channels::Wavelengths(nm) = factored.channels()
        && let (Some(first), Some(last)) = (nm.first(), nm.last())
        && (*first > VISIBLE_NM[0] || *last < VISIBLE_NM[1])
    {
        notes.push(format!("wavelengths from {first} to {last} nm: beyond them the values at the ends hold"));
    }
    notes
}

impl Builder {
    /// A table of factors, read once.
    pub(in crate::file) fn factor_table(&mut self, file: &At<String>) -> Result<Arc<FactorTable>, Problem> {
        if let Some(known) = self.made.factors.get(&file.value) {
            return Ok(Arc::clone(known));
        }
        let bytes = self.read_beside(file)?;
        let table = factors::table(&bytes)
            .map_err(|message| Problem::at(&file.span, format!("'{}': {message}", file.value)))?;
        let table = Arc::new(table);
        self.made.factors.insert(file.value.clone(), Arc::clone(&table));
        Ok(table)
    }
}
