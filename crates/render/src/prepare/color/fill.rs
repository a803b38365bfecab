//! Filling the tint table.

use super::quadrature::Sampling;
use super::tint_table::Table;
use crate::prepare::build::integrals::lobe_integrals;
use crate::prepare::build::{materials, means};
use crate::prepare::data::{Prepared, PreparedMaterial};
use crate::prepare::options::PrepareError;

/// Fills all rows of the table from the prepared scene's source; integrals of lobes are taken over where nothing
/// changed that they depend on.
pub(crate) fn fill_table(prepared: &mut Prepared) -> Result<(), PrepareError> {
    let all: Vec<usize> = (0..prepared.source.colors.materials.len()).collect();
    let filled = rows(prepared, &all)?;
    prepared.materials = filled;
    let source = &prepared.source;
    let colors = &source.colors;
    let observation = &source.options.observation;
    prepared.channels =
        observation.channels(&colors.lights, colors.photometric, colors.white, (source.first_channel, 3));
    let sampling = Sampling::new(observation, source.first_channel);
    prepared.environment_tint = Table::new(&sampling, &colors.lights).environment_tint();
    Ok(())
}

/// Fills the rows of one material.
pub(crate) fn fill_material(prepared: &mut Prepared, number: usize) -> Result<(), PrepareError> {
    let mut filled = rows(prepared, &[number])?;
    prepared.materials[number] = filled.swap_remove(0);
    Ok(())
}

fn rows(prepared: &Prepared, numbers: &[usize]) -> Result<Vec<PreparedMaterial>, PrepareError> {
    let source = &prepared.source;
    let model = source.options.model.as_deref();
    if let Some(model) = model {
        glanz_bsdf::models::info_named(model)?;
    }
    let sampling = Sampling::new(&source.options.observation, source.first_channel);
    let table = Table::new(&sampling, &source.colors.lights);
    let row = |number: &usize| materials::prepare(&source.colors.materials[*number], &table, model);
    let mut filled = numbers.iter().map(row).collect::<Result<Vec<_>, _>>()?;
    filled.iter_mut().for_each(|material| means::set(material, &prepared.textures));
    lobe_integrals::attach(&mut filled, &prepared.lights, &prepared.materials);
    Ok(filled)
}

/// Makes anew what depends on the content of textures.
pub(crate) fn refill_means(prepared: &mut Prepared) {
    let before = core::mem::take(&mut prepared.materials);
    let mut after = before.clone();
    after.iter_mut().for_each(|material| means::set(material, &prepared.textures));
    lobe_integrals::attach(&mut after, &prepared.lights, &before);
    prepared.materials = after;
}
