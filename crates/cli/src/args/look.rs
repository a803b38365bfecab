//! How it is drawn.

use clap::Args;
use glanz_render::{DebugView, DrawOptions, ExactLighting, Observation, PrepareOptions, SamplesError};
use glanz_scene::{Background, Image, Interpolation, Lighting, Mistake, RenderSettings, Scene, Shading};

use super::{ColorArgs, choices, values};
use crate::print::failure::Failure;

/// What to draw otherwise than the scene says.
#[derive(Args, Clone, Debug, Default)]
#[command(next_help_heading = "Picture")]
pub(crate) struct LookArgs {
    /// Samples per pixel for smooth edges [default: the scene's, else 4]
    #[arg(long, value_name = "N", value_parser = choices::samples())]
    pub samples: Option<u32>,

    /// Shade every sample, not once per pixel and surface
    #[arg(long)]
    pub supersample: bool,

    /// Where light is computed, for all objects
    #[arg(long, value_name = "SHADING", value_parser = choices::shading())]
    pub shading: Option<Shading>,

    /// How values between vertices are found, for all objects
    #[arg(long, value_name = "SCHEME", value_parser = choices::interpolation())]
    pub interpolation: Option<Interpolation>,

    /// The model of all highlights
    #[arg(long, value_name = "MODEL", value_parser = choices::highlight_model())]
    pub model: Option<String>,

    /// What the picture shows [default: shaded]
    #[arg(long, value_name = "VIEW", value_parser = choices::show())]
    pub show: Option<DebugView>,

    /// How light from areas and environments is found, with shadows also what hides them in part [default: the scene's,
    /// else fast]
    #[arg(long, value_name = "HOW", value_parser = choices::lighting())]
    pub lighting: Option<Lighting>,

    /// Points of each area and environment at each pixel with --lighting exact; powers of two are spread best [default:
    /// the scene's, else 1024]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(2..=1 << 20))]
    pub light_samples: Option<u32>,

    /// A mistake to draw on purpose, for teaching
    #[arg(long, value_name = "NAME", value_parser = choices::mistake())]
    pub mistake: Option<Mistake>,

    /// The background: #rrggbb, linear r,g,b, or transparent
    #[arg(long, value_name = "COLOR", value_parser = values::background)]
    pub background: Option<Background>,

    #[command(flatten)]
    pub color: ColorArgs,
}

impl LookArgs {
    /// The picture to be made of this scene, in this size if not in its own.
    pub(crate) fn image(&self, scene: &Scene, size: Option<(u32, u32)>) -> Image {
        let (width, height) = size.unwrap_or((scene.image.width, scene.image.height));
        Image {
            width,
            height,
            samples: self.samples.unwrap_or(scene.image.samples),
            supersample: self.supersample || scene.image.supersample,
            background: self.background.unwrap_or(scene.image.background),
        }
    }

    /// What to change of the scene before it is drawn.
    pub(crate) fn prepare_options(&self, observation: Observation) -> PrepareOptions {
        PrepareOptions {
            shading: self.shading,
            interpolation: self.interpolation,
            model: self.model.clone(),
            observation,
            ..PrepareOptions::default()
        }
    }

    /// How to draw this picture; `own` is what the scene says.
    pub(crate) fn draw_options(&self, image: &Image, own: &RenderSettings) -> Result<DrawOptions, Failure> {
        let lighting = RenderSettings {
            lighting: self.lighting.unwrap_or(own.lighting),
            light_samples: self.light_samples.or(own.light_samples),
            ..*own
        };
        if self.light_samples.is_some() && lighting.lighting != Lighting::Exact {
            let message = "--light-samples are those of exact lighting; expected --lighting exact with it";
            return Err(Failure::Usage(message.to_owned()));
        }
        Ok(DrawOptions {
            samples: image.samples.try_into().map_err(|error: SamplesError| Failure::new(error))?,
            supersample: image.supersample,
            show: self.show.unwrap_or(own.show),
            exact: ExactLighting::of(&lighting),
            ..DrawOptions::new(image.background)
        })
    }
}
