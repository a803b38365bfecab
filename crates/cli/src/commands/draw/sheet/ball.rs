//! The lobe of a cell of a sheet, from the keys of the command line.

use std::sync::Arc;

use glanz_bsdf::Shape;
use glanz_color::{Rgb, SpectrumKind};
use glanz_scene::builtin::Builtin;
use glanz_scene::stage::LobeStage;
use glanz_scene::{LightColor, Tint};

use crate::input::{media, spectra};
use crate::load::{Input, input_of_stage};
use crate::print::failure::Failure;

/// A lobe on a mesh.
#[derive(Clone, Debug)]
pub(super) struct Ball(LobeStage);

impl Ball {
    /// A ball from the keys of a command line; the last of a key counts.
    pub(super) fn new(
        model: &Shape,
        values: &[(String, String)],
        mesh: &str,
        light: Option<&str>,
    ) -> Result<Self, Failure> {
        let mut tint = Tint::Rgb(Rgb::WHITE);
        let mut shape = model.clone();
        for (key, text) in values {
            match key.as_str() {
                "ior" => tint = media::tint(text)?,
                "tint" => tint = reflectance_tint(text)?,
                name => match text.parse::<f64>() {
                    Ok(value) => {
                        let set = shape.with(name, value);
                        shape = set.map_err(|error| Failure::Usage(error.to_string()))?;
                    }
                    Err(_) => {
                        let message = format!("parameter '{name}' is '{text}', but must be a number");
                        return Err(Failure::Usage(message));
                    }
                },
            }
        }
        if shape.info().delta {
            return Err(Failure::Usage(format!(
                "'{}' sends light into a single direction: lamps leave it black, it shows environments only",
                shape.info().name
            )));
        }
        let mesh = Builtin::named(mesh).expect("the parser lets only known names through");
        Ok(Self(LobeStage { shape, tint, mesh, light: lamp_color(light)? }))
    }

    /// The scene, for pictures of this size.
    pub(super) fn input(&self, size: (u32, u32)) -> Result<Input, Failure> {
        self.0.scene(size).map(input_of_stage).map_err(Failure::new)
    }
}

/// A reflectance for all wavelengths, or a spectrum of it.
fn reflectance_tint(text: &str) -> Result<Tint, Failure> {
    match text.parse::<f32>() {
        Ok(value) if (0.0..=1.0).contains(&value) => Ok(Tint::Rgb(Rgb::gray(value))),
        Ok(value) => Err(Failure::Usage(format!("tint is {value}, but must be between 0 and 1"))),
        Err(_) => {
            let source = spectra::source(text, Some(SpectrumKind::Surface), &spectra::TableArgs::default())?;
            Ok(Tint::Spectrum(Arc::new(source.spectrum)))
        }
    }
}

/// A lamp of luminance 1.
fn lamp_color(name: Option<&str>) -> Result<LightColor, Failure> {
    let Some(name) = name else { return Ok(LightColor::Rgb(Rgb::WHITE)) };
    let source = spectra::light_source(name)?;
    LightColor::unit(&source.spectrum)
        .ok_or_else(|| Failure::new(format_args!("--light '{name}' sends no light")))
}
