//! Remarks on what a scene file says, where it is hardly what was meant.

use std::collections::BTreeSet;
use std::ops::Range;

use glanz_bsdf::LightTerm;
use glanz_color::Rgb;

use super::builder::Builder;
use crate::file::error::Problem;
use crate::file::tables::geometry::objects::ColorsValue;
use crate::file::tables::lights::{KindName, LightTable};
use crate::file::tables::scene::SceneTable;
use crate::file::tables::values::At;
use crate::{AnotherScale, Background, Lobe, Material, Scene, Tint};

/// So many materials are named.
const FEW: usize = 3;

impl Builder {
    /// Remarks on the scene as a whole.
    pub(super) fn remarks(&mut self, table: &SceneTable) {
        let note = self.dark_ambient_terms(table);
        self.input.notes.extend(note);
        let notes: Vec<String> =
            self.own_materials(table).flat_map(|index| bright_tints(&self.scene, index)).collect();
        self.input.notes.extend(notes);
    }

    /// The scene's own materials, in the order of their names.
    fn own_materials<'a>(&'a self, table: &'a SceneTable) -> impl Iterator<Item = usize> + 'a {
        let own = table.materials.iter().filter(|(_, table)| table.library.is_none());
        own.filter_map(|(name, _)| self.names.materials.get(name).copied())
    }

    /// That colours which are no light are on the scale where 1 is white, but for those of materials.
    pub(super) fn check_scales(&self, table: &SceneTable) -> Result<(), Problem> {
        if let (Some(at), Background::Color(color)) = (&table.image.background, self.scene.image.background) {
            check_scale(color, &at.span)?;
        }
        for object in &table.objects {
            if let Some(At { value: ColorsValue::List(colors), span }) = &object.colors {
                colors.iter().try_for_each(|color| check_scale(color.0, span))?;
            }
        }
        Ok(())
    }

    /// That ambient terms are written, but get no light, because lamps send them none unless they say so. Where some
    /// light does reach them, the scene was written with both in mind.
    fn dark_ambient_terms(&self, table: &SceneTable) -> Option<String> {
        let surrounded = table.lights.iter().any(|light| light.kind == KindName::Environment);
        if surrounded || self.scene.lights.iter().any(|light| !light.colors.ambient.is_black()) {
            return None;
        }
        let is_used = |index: usize| self.scene.objects.iter().any(|object| object.material == index);
        let is_dark = |material: &Material| {
            let is_ambient = |lobe: &Lobe| lobe.shape.info().name == "ambient" && !lobe.tint.is_black();
            material.lobes.iter().any(is_ambient)
        };
        // Nobody wrote the terms of the default material, nor those that come with a model.
        let named = self.names.materials.values().chain(self.names.library.values());
        let named: BTreeSet<usize> = named.copied().filter(|index| is_used(*index)).collect();
        let dark = named.into_iter().map(|index| &self.scene.materials[index]).filter(|own| is_dark(own));
        let materials: Vec<String> = dark.map(|material| format!("'{}'", material.name)).collect();
        let lamps: Vec<String> = table.lights.iter().enumerate().filter_map(lamp_without_ambient).collect();
        if materials.is_empty() || lamps.is_empty() {
            return None;
        }
        let terms = match materials.as_slice() {
            [one] => format!("the ambient term of {one}"),
            few if few.len() <= FEW => format!("the ambient terms of {}", few.join(", ")),
            many => {
                let more = many.len() - FEW;
                format!("the ambient terms of {} and {more} more materials", many[..FEW].join(", "))
            }
        };
        Some(format!(
            "no light reaches {terms}: lamps send ambient terms nothing unless their key 'ambient' says so; \
             give the scene [ambient] light, or, for the picture of Glanz 0.1, {} 'ambient' with the value of 'color'",
            lamps.join(", "),
        ))
    }
}

/// How a lamp is called that would have sent its colour to ambient terms before these got nothing by default.
fn lamp_without_ambient((number, light): (usize, &At<LightTable>)) -> Option<String> {
    let punctual = matches!(light.kind, KindName::Directional | KindName::Point | KindName::Spot);
    (punctual && light.ambient.is_none()).then(|| match light.name.as_str() {
        "" => format!("lights.{number}"),
        name => format!("light '{name}'"),
    })
}

/// That a colour which is no light is on the scale where 1 is white.
pub(super) fn check_scale(color: Rgb, span: &Range<usize>) -> Result<(), Problem> {
    AnotherScale::check(color).map_err(|error| Problem::at(span, error.to_string()).help(error.help()))
}

/// Terms of a material that give more than all light. Spectra are told of where they are read.
fn bright_tints(scene: &Scene, material: usize) -> Vec<String> {
    let material = &scene.materials[material];
    let is_lit = |lobe: &&Lobe| lobe.shape.info().term != LightTerm::Emission;
    let bright = material.lobes.iter().filter(is_lit).filter_map(|lobe| match &lobe.tint {
        Tint::Rgb(rgb) => {
            let most = rgb.0.iter().copied().fold(0.0, f32::max);
            (most > 1.0).then(|| {
                let (name, shape) = (&material.name, lobe.shape.info().name);
                format!("material '{name}': the colour of its term '{shape}' is up to {most}, where 1 gives back all light")
            })
        }
        _ => None,
    });
    bright.collect()
}
