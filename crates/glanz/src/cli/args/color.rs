//! How colour is treated, and who looks.

use std::path::Path;

use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use glanz_color::Observer;
use glanz_render::{Observation, Show};
use glanz_scene::{ColorMode, Scene, White};

use super::super::failure::{Failure, Report};

/// The largest file of a sensor, in bytes.
const MAX_SENSOR: u64 = 16 << 20;

/// Colour otherwise than the scene says.
#[derive(Args, Clone, Debug, Default)]
#[command(next_help_heading = "Colour")]
pub struct ColorArgs {
    /// How colour is treated: rgb, spectral, meyer, meyer-adapted, sampled:N (N wavelengths), or
    /// reference (slow) [default: the scene's, else rgb]
    #[arg(long, value_name = "MODE", value_parser = |text: &str| text.parse::<ColorMode>())]
    pub mode: Option<ColorMode>,

    /// Who looks, in spectral modes: a name from `glanz color list observers`, or a CSV file with the
    /// curves of a sensor [default: the scene's, else cie1931]
    #[arg(long, value_name = "NAME")]
    pub observer: Option<String>,

    /// The white that becomes the white of the screen, in spectral modes [default: the scene's, else
    /// D65]
    #[arg(long, value_name = "WHITE", value_parser = white())]
    pub white: Option<White>,
}

fn white() -> impl TypedValueParser<Value = White> {
    let names = White::ALL.map(|(_, name, help)| PossibleValue::new(name).help(help));
    PossibleValuesParser::new(names)
        .map(|name| name.parse().expect("the parser lets only known names through"))
}

/// How a scene is seen.
#[derive(Clone, Debug)]
pub struct Look {
    /// Observer and colour mode.
    pub observation: Observation,
    /// The white of the screen.
    pub white: White,
}

impl ColorArgs {
    /// Observer, mode and white for a scene. Views that show no light know no colour mode.
    pub fn resolve(&self, scene: &Scene, show: Show) -> Result<Look, Failure> {
        let white = self.white.unwrap_or(scene.render.white);
        let mode = self.mode.unwrap_or(scene.render.mode);
        if !show.is_light() {
            return Ok(Look { observation: Observation::rgb(), white });
        }
        if mode == ColorMode::Rgb && self.observer.is_none() && self.mode.is_some() {
            // The scene's own observer belongs to its own mode.
            return Ok(Look { observation: Observation::rgb(), white });
        }
        let chosen = match &self.observer {
            Some(name) => Some(observer(name)?),
            None => scene.observer.clone(),
        };
        let observation =
            Observation::new(mode, chosen).map_err(|error| Failure::Usage(error.to_string()))?;
        Ok(Look { observation, white })
    }
}

/// An observer by name, or a sensor from a file.
pub fn observer(name: &str) -> Result<Observer, Failure> {
    let known = match glanz_color::observer(name) {
        Ok(observer) => return Ok(observer),
        Err(error) => error,
    };
    let path = Path::new(name);
    if path.extension().is_none() {
        return Err(Failure::Usage(known.to_string()));
    }
    let problem = |message: String| Failure::from(Report::new(message));
    let length = std::fs::metadata(path).map(|metadata| metadata.len());
    let bytes = match length {
        Ok(length) if length > MAX_SENSOR => {
            return Err(problem(format!("'{name}' has {length} bytes; at most {MAX_SENSOR} are read")));
        }
        Ok(_) => std::fs::read(path),
        Err(error) => Err(error),
    };
    let bytes = bytes.map_err(|error| {
        let error = super::super::failure::without_number(&error.to_string()).to_owned();
        problem(format!("the sensor '{name}' cannot be read: {error}"))
    })?;
    glanz_scene::read::read_sensor(&bytes, name).map_err(problem)
}
