//! What becomes of the drawn light.

use clap::{Args, ValueEnum};
use glanz_render::{Develop, Encoding, ToneMap};
use glanz_scene::RenderSettings;

use super::choices;
use crate::print::failure::Failure;

/// Bits per channel of a PNG.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum BitDepth {
    /// 256 steps
    #[default]
    #[value(name = "8")]
    Eight,
    /// 65536 steps
    #[value(name = "16")]
    Sixteen,
}

/// From linear light to a picture.
#[derive(Args, Clone, Copy, Debug, Default)]
#[command(next_help_heading = "Development")]
pub(crate) struct DevelopArgs {
    /// Exposure in stops: 1 doubles the light; not for .exr
    #[arg(long, value_name = "STOPS", allow_hyphen_values = true)]
    pub ev: Option<f32>,

    /// Tone mapping: how light above the white of the screen is compressed; not for .exr
    #[arg(long, value_name = "NAME", value_parser = choices::tone_map())]
    pub tone_map: Option<ToneMap>,

    /// How light becomes codes: srgb, or raw, the linear value itself, as a shader's output in OpenGL's framebuffer; not
    /// for .exr, which holds linear light
    #[arg(long, value_name = "NAME", value_parser = choices::encoding())]
    pub encoding: Option<Encoding>,

    /// Dither before rounding to 8 bits; not for .exr
    #[arg(long)]
    pub dither: bool,
}

impl DevelopArgs {
    /// The settings, checked: those of the scene where the command line has none.
    pub(crate) fn resolve(self, settings: &RenderSettings) -> Result<Develop, Failure> {
        let ev = self.ev.unwrap_or(settings.ev as f32);
        if !(-64.0..=64.0).contains(&ev) {
            return Err(Failure::Usage(format!("--ev is {ev}, but must be between -64 and 64 stops")));
        }
        Ok(Develop {
            ev,
            tone_map: self.tone_map.unwrap_or(settings.tone_map),
            dither: self.dither,
            encoding: self.encoding.unwrap_or(settings.encoding),
            to_screen: None,
        })
    }
}
