//! The lobes of general materials.

use std::sync::Arc;

use glanz_bsdf::{LayerWeight, LightTerm, MODELS, ParamError, Shape, Side};
use glanz_color::Rgb;

use crate::file::build::builder::Builder;
use crate::file::error::Problem;
use crate::file::near::{did_you_mean, list};
use crate::file::tables::appearance::layer_weights::MetalnessTable;
use crate::file::tables::appearance::lobes::{FresnelName, KEYS, LobeTable};
use crate::file::tables::appearance::shapes::ShapeTable;
use crate::file::tables::values::At;
use crate::{Absorption, Lobe, Metalness, Tint};

impl LobeTable {
    /// The lobe.
    pub(crate) fn build(&self, builder: &mut Builder) -> Result<Lobe, Problem> {
        let shape = self.shape(builder)?;
        // Textures and vertex colours are surface colours (E. Thiel, "Programmation graphique", lecture 5): they multiply
        // neither emitted light nor highlights.
        let textured =
            self.textured.unwrap_or(matches!(shape.info().term, LightTerm::Ambient | LightTerm::Diffuse));
        let tint = match &self.tint {
            None => Rgb::WHITE.into(),
            Some(color) if shape.info().term == LightTerm::Emission => builder.emission(color)?,
            Some(color) => builder.tint(color)?,
        };
        let tint = self.with_fresnel(tint)?;
        if shape.info().term == LightTerm::Specular && textured && tint.depends_on_angle() {
            return Err(Problem::at(&self.shape.span, "a highlight by Fresnel's law cannot be 'textured'"));
        }
        if let (Tint::Ior(ior), Side::Transmission) = (&tint, shape.info().side)
            && ior.k.max() > 0.0
        {
            let message = format!("light does not pass '{}', which is a metal", ior.name);
            return Err(Problem::at(&self.shape.span, message));
        }
        let is_lit = matches!(shape.info().term, LightTerm::Diffuse | LightTerm::Specular);
        if let (Some(weight), false) = (&self.weight, is_lit) {
            return Err(Problem::at(&weight.span, "'weight' is for terms that lights shine on")
                .help("make the tint of this term darker instead"));
        }
        if let (Some(weight), Some(_)) = (&self.weight, &self.layers) {
            return Err(Problem::at(
                &weight.span,
                "'weight' beside 'layers': give it as a layer, { constant = 0.5 }",
            ));
        }
        let weight = self.weight.as_ref().map(|weight| weight.0).filter(|weight| *weight < 1.0);
        let mut layers: Vec<_> = weight.map(LayerWeight::Constant).into_iter().collect();
        for layer in self.layers.iter().flat_map(|layers| &layers.value) {
            layers.push(layer.weight(builder)?);
        }
        let absorption =
            self.absorption.as_ref().map(|table| Absorption { depth: table.depth.0, eta: table.eta.0 });
        let metalness = self.metalness.as_ref().map_or(Metalness::Any, MetalnessTable::metalness);
        let absorption = absorption.map(Arc::new);
        if let (Some(mask), false) = (self.masks.first(), is_lit) {
            return Err(Problem::at(&mask.picture.span, "'masks' are for terms that lights shine on"));
        }
        let masks = self.masks.iter().map(|table| builder.mask(table)).collect::<Result<_, _>>()?;
        if self.rough_texture.is_some() && !shape.info().takes_roughness_map() {
            let takes = || MODELS.iter().filter(|info| info.takes_roughness_map()).map(|info| info.name);
            let message = format!("no texture says how rough the shape '{}' is", shape.info().name);
            return Err(Problem::at(&self.shape.span, message)
                .help(format!("'rough_texture' is for the shapes {}", list(takes()))));
        }
        let roughness = builder.roughness(self.rough_texture.as_ref())?;
        Ok(Lobe { shape, tint, textured, layers, absorption, metalness, masks, roughness })
    }

    fn shape(&self, builder: &mut Builder) -> Result<Shape, Problem> {
        let params: Vec<(&str, f64)> = self.params.iter().map(|(k, v)| (k.as_str(), v.0)).collect();
        match (&self.shape.value, self.params.first()) {
            (ShapeTable::Named(name), _) => Shape::named(name, &params).map_err(|error| self.explain(&error)),
            (ShapeTable::Brdf(brdf), None) => brdf.build(builder),
            (ShapeTable::Brdf(_), Some((key, _))) => {
                let message = format!("unknown key '{}' in a lobe of a BRDF of one's own", key.value);
                Err(Problem::at(&key.span, message)
                    .help("its parameters stand in its table: shape = { file = \"my.brdf\", n = 20 }"))
            }
        }
    }

    /// The tint with the angle dependence that is asked for.
    fn with_fresnel(&self, tint: Tint) -> Result<Tint, Problem> {
        let Some(At { value: FresnelName::Schlick, span }) = &self.fresnel else { return Ok(tint) };
        match tint {
            Tint::Rgb(_) | Tint::Spectrum(_) => Ok(Tint::Schlick(Box::new(tint))),
            Tint::Ior(ior) => {
                let at_normal = Tint::Spectrum(Arc::new(ior.normal_reflectance()));
                Ok(Tint::Schlick(Box::new(at_normal)))
            }
            _ => Err(Problem::at(span, "Schlick's form needs a reflectance, or an index of refraction")),
        }
    }

    fn explain(&self, error: &ParamError) -> Problem {
        match error {
            ParamError::UnknownModel { name, .. } => {
                let names = || MODELS.iter().map(|info| info.name);
                let message = format!("unknown shape '{name}'{}", did_you_mean(name, names()));
                Problem::at(&self.shape.span, message).help(format!("the shapes are: {}", list(names())))
            }
            ParamError::UnknownParam { model, name, known } => {
                let span = self.params.iter().find(|(key, _)| key.value == *name).map(|(key, _)| &key.span);
                let near = did_you_mean(name, known.split(", ").chain(KEYS));
                let message = format!("unknown key '{name}' in a lobe of shape '{model}'{near}");
                let help = format!("known keys: {}; parameters of '{model}': {known}", KEYS.join(", "));
                Problem::at(span.unwrap_or(&self.shape.span), message).help(help)
            }
            ParamError::OutOfRange { name, .. } => {
                let span =
                    self.params.iter().find(|(key, _)| key.value == *name).map(|(_, value)| &value.span);
                Problem::at(span.unwrap_or(&self.shape.span), error.to_string())
            }
        }
    }
}
