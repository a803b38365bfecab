//! `glanz measure appearance`: the numbers by which engineers name an appearance.

mod document;
mod subject;
mod text;

use clap::Args;
use glanz_color::ObserverKind;

use self::subject::Subject;
use super::ReadArgs;
use crate::args;
use crate::input::lobes::FactorArgs;
use crate::input::spectra::{light_source, observer_source};
use crate::print::failure::Failure;
use crate::print::{self, FormatArgs};

pub(crate) use document::Document;
pub(in crate::commands::measure) use subject::{of_library, of_scene};

/// Shown after the help.
pub(crate) const EXAMPLES: &str = "\
Examples:
  glanz measure appearance paint.bsdf
  glanz measure appearance ggx --set alpha=0.1 --ior 1.5 --diffuse 0.3
  glanz measure appearance car-paint-red --light D65 --observer cie1964
  glanz measure appearance fit.toml --format json
  glanz measure appearance paper-brightened --light FL11

What is measured is a file of measured reflectance (of readings what lies between them, smoothed), a model of `glanz bsdf list` or of one's own, a
material of `glanz material list`, one of a scene file, such as `glanz measure fit -o` writes, or a matte surface of
`glanz color list fluorescent`.

Gloss at 20, 60 and 85 degrees is 100 times the flux that the receptor of a gloss meter gets, by that of black
glass of index 1.567, integrated over the apertures of source and receptor (ISO 2813, ASTM D523). 60 degrees are
for all surfaces; above 70 units 20 degrees, below 10 units 85 degrees tell more. Haze is the flux beside the
mirror direction by the same: of ISO 13803 (light at 20 degrees, receptors at 18.1 and 21.9), and of method A of
ASTM E430 (30 degrees; 28 and 32, 25 and 35); that of ASTM D4039 is the gloss at 60 degrees less that at 20.

Radiance factors are pi times the BRDF: 45/0, and those of multi-angle instruments, with light at 45 or 15
degrees and detectors by their angle from the mirror direction towards the light, as 45as-15. The sphere is 8/d:
with all light (SCI), and without that within 4.1 degrees of the mirror direction (SCE; ports differ from
instrument to instrument, so that number is of this port alone). Channels are those of the data; a model has one,
at --lambda-nm, a material its Y.

Colours are under --light for --observer; L*a*b* are relative to the light. The flop index is made of L* at 15,
45 and 110 degrees, whiteness and tint (CIE 15:2004) and yellowness (ASTM E313 with its four pairs of light and
observer, ASTM D1925) of the colour at 45/0. What glows does so in all of them.";

/// Options of `glanz measure appearance`.
#[derive(Args, Debug)]
pub(crate) struct AppearanceArgs {
    /// A file of measured reflectance, a scene file, or the name of a model, a material or a fluorescent surface
    #[arg(value_name = "NAME|FILE")]
    name: String,

    /// A parameter of a model, such as shininess=32; may be repeated
    #[arg(long, value_name = "NAME=VALUE", value_parser = args::assignment)]
    set: Vec<(String, String)>,

    /// The albedo of a matte part that is added to a model
    #[arg(long, value_name = "ALBEDO", default_value_t = 0.0)]
    diffuse: f64,

    /// The material of a scene file that has several
    #[arg(long, value_name = "NAME")]
    material: Option<String>,

    /// The light of the colours: a name or a file
    #[arg(long, alias = "under", value_name = "LIGHT", default_value = "D65")]
    light: String,

    /// The observer of the colours, who must have X, Y and Z
    #[arg(long, value_name = "OBSERVER", default_value = "cie1931")]
    observer: String,

    #[command(flatten)]
    read: ReadArgs,
    #[command(flatten)]
    factor: FactorArgs,
    #[command(flatten)]
    format: FormatArgs,
}

impl AppearanceArgs {
    /// Tells them.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        if !(0.0..=1.0).contains(&self.diffuse) {
            return Err(Failure::Usage(format!("--diffuse is {}, but must be from 0 to 1", self.diffuse)));
        }
        let observer = observer_source(&self.observer)?;
        if observer.kind != ObserverKind::Xyz {
            return Err(Failure::Usage(format!("'{}' has no X, Y, Z, which are told here", observer.name)));
        }
        let light = light_source(&self.light)?;
        let subject = Subject::of(self)?;
        let document = Document::new(&self.name, &subject, &light, &observer)?;
        if self.format.is_json() {
            return print::json(&document);
        }
        print::text(&text::text(&document))
    }

    /// The first option that is of models alone and is given.
    fn of_models(&self) -> Option<&'static str> {
        let given = [
            ("--set", !self.set.is_empty()),
            ("--diffuse", self.diffuse != 0.0),
            ("--ior", self.factor.ior.is_some()),
            ("--tint", self.factor.tint.is_some()),
            ("--lambda-nm", self.factor.lambda_nm.is_some()),
        ];
        given.into_iter().find(|(_, is)| *is).map(|(option, _)| option)
    }
}
