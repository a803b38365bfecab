//! Colour mode, observer and white.

use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use glanz_eye::{Eye, EyeError, Viewer, Viewing};
use glanz_render::{DebugView, Observation};
use glanz_scene::{ColorMode, Scene, White};

use crate::input::spectra::observer_source;
use crate::print;
use crate::print::failure::Failure;

/// Colour otherwise than the scene says.
#[derive(Args, Clone, Debug, Default)]
#[command(next_help_heading = "Colour")]
pub(crate) struct ColorArgs {
    /// How colour is treated: rgb, spectral, meyer, meyer-adapted, sampled:N (N wavelengths), or
    /// reference (slow) [default: the scene's, else rgb]
    #[arg(long, value_name = "MODE", value_parser = |text: &str| text.parse::<ColorMode>())]
    pub mode: Option<ColorMode>,

    /// The observer, in spectral modes: a name from `glanz color list observers`, an eye such as age:70, deutan:10 or
    /// age:70+protan, or a CSV file with the curves of a sensor [default: the scene's, else cie1931]
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
pub(crate) struct Look {
    /// Observer and colour mode.
    pub observation: Observation,
    /// The white of the screen.
    pub white: White,
    /// The eye that looks, if one does.
    pub viewer: Option<Viewer>,
}

impl ColorArgs {
    /// That the white has an effect.
    pub(crate) fn check_white(&self, observation: &Observation) -> Result<(), Failure> {
        if self.white.is_some() && observation.mode() == ColorMode::Rgb {
            let message =
                "--white has no effect in mode rgb; it acts in modes with spectra: add --mode spectral";
            return Err(Failure::Usage(message.to_owned()));
        }
        Ok(())
    }

    /// Observer, mode and white for a scene. Views that show no light know no colour mode.
    pub(crate) fn resolve(&self, scene: &Scene, show: DebugView) -> Result<Look, Failure> {
        let white = self.white.unwrap_or(scene.render.white);
        let mode = self.mode.unwrap_or(scene.render.mode);
        if !show.is_light() {
            return Ok(Look { observation: Observation::rgb(), white, viewer: None });
        }
        if let Some(viewer) = self.viewer(scene)? {
            return self.look_by(viewer, mode, white);
        }
        if mode == ColorMode::Rgb && self.observer.is_none() && self.mode.is_some() {
            // The scene's own observer belongs to its own mode.
            return Ok(Look { observation: Observation::rgb(), white, viewer: None });
        }
        let chosen = match &self.observer {
            Some(name) => Some(observer_source(name)?),
            None => scene.observer.clone(),
        };
        let observation =
            Observation::new(mode, chosen).map_err(|error| Failure::Usage(error.to_string()))?;
        Ok(Look { observation, white, viewer: None })
    }

    /// The eye that looks: that of the command line, which looks as the scene's does, or else the scene's.
    fn viewer(&self, scene: &Scene) -> Result<Option<Viewer>, Failure> {
        let own = || scene.eye.clone();
        match &self.observer {
            None if self.mode == Some(ColorMode::Rgb) => Ok(None),
            None => Ok(own()),
            Some(name) if Eye::is_named(name) => {
                let eye: Eye =
                    name.parse().map_err(|error: EyeError| Failure::Usage(format!("--observer: {error}")))?;
                if let Some(remark) = eye.remark() {
                    print::note(format_args!("note: {remark}"));
                }
                let viewing = own().map_or_else(Viewing::default, |viewer| viewer.viewing);
                Ok(Some(Viewer { eye, viewing }))
            }
            Some(_) => Ok(None),
        }
    }

    /// How a scene is seen by an eye. Where nobody asked for a mode, it is the one with spectra: an eye sees no RGB.
    fn look_by(&self, viewer: Viewer, mode: ColorMode, white: White) -> Result<Look, Failure> {
        let asked = self.observer.is_some() && self.mode.is_none();
        let mode = if asked && mode == ColorMode::Rgb { ColorMode::Spectral } else { mode };
        let observation =
            Observation::of_viewer(mode, &viewer).map_err(|error| Failure::Usage(error.to_string()))?;
        Ok(Look { observation, white, viewer: Some(viewer) })
    }
}
