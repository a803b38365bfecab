//! `glanz relight`: one scene under several light sources side by side.

use clap::Args;
use glanz_color::{Observer, xyz_of_light};
use glanz_plot::{Canvas, ContactSheet};
use glanz_scene::{ColorMode, Light, LightColor, LightColors, Material, Tint, White};
use schemars::JsonSchema;
use serde::Serialize;

use super::side_by_side::SideBySideArgs;
use crate::args::{InputArgs, LookArgs, Target, light_words};
use crate::input::spectra::light_source;
use crate::load::Input;
use crate::pipeline;
use crate::print;
use crate::print::failure::Failure;
use crate::print::remarked::Remarked;
use crate::print::timings::Timings;
use crate::progress::Progress;

/// Shown after the help.
pub(crate) const EXAMPLES: &str = "\
Examples:
  glanz relight scene.toml --light A,D65,FL11,UV365 -o lights.png
  glanz relight scene.toml --light A --light D65 --white scene

Every light of the scene keeps its place and its luminance and gets the spectrum that is named; one that the
eye hardly sees, such as UV365, gets the power of D65 instead. Where something fluoresces, a second row shows
the scene without its fluorescence.";

/// Options of `glanz relight`.
#[derive(Args, Debug)]
pub(crate) struct RelightArgs {
    #[command(flatten)]
    pub(crate) input: InputArgs,

    /// A light source, from `glanz color list lights`, such as A, D50, FL11, D(9300), blackbody(3000),
    /// gaussian(450,20), or a file with its spectrum; several between commas or repeated, one for each column
    #[arg(long, value_name = "LIGHT,…", required = true)]
    light: Vec<String>,

    #[command(flatten)]
    pictures: SideBySideArgs,
}

/// A light source in place of those of the scene.
struct Source {
    name: String,
    color: LightColor,
    /// How its picture is drawn.
    look: LookArgs,
}

impl RelightArgs {
    /// Draws.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let names = light_words(&self.light)?;
        let spectra = spectra(&names)?;
        let (target, mut input) = self.pictures.begin(&self.input, "_lights.png", "a sheet of lights")?;
        let mut look = self.pictures.look.clone();
        if look.color.mode.is_none() && input.scene.render.mode == ColorMode::Rgb {
            look.color.mode = Some(ColorMode::Spectral);
        }
        let mut rows = Vec::new();
        let sources = self.sources(&mut input, &look, names, spectra)?;
        let plain = without_fluorescence(&input.scene.materials);
        let count = sources.len() * if plain.is_some() { 2 } else { 1 };
        let mut progress = Progress::new(count, "pictures");
        let mut remarked = Remarked::default();
        let mut pictures = self.row(&mut input, &sources, &mut progress, Some(&mut remarked))?;
        if let Some(plain) = plain {
            rows = vec!["as it is".to_owned(), "without\nfluorescence".to_owned()];
            input.scene.materials = plain;
            pictures.extend(self.row(&mut input, &sources, &mut progress, None)?);
        }
        drop(progress);
        self.pictures.deliver(sheet(&sources, rows, &pictures)?, &target, &input)?;
        self.tell(&target, &sources, input.notes.into_iter().chain(remarked.tell()).collect())
    }

    /// The sources, with the look of each picture. An eye cannot take every light for white, black light least of all:
    /// such a picture is drawn for daylight, and said to be.
    fn sources(
        &self,
        input: &mut Input,
        look: &LookArgs,
        names: Vec<String>,
        spectra: Vec<LightColor>,
    ) -> Result<Vec<Source>, Failure> {
        let own = input.scene.lights.clone();
        let mut sources = Vec::with_capacity(spectra.len());
        for (color, name) in spectra.into_iter().zip(names) {
            relight(&mut input.scene.lights, &own, &color);
            let mut daylight = look.clone();
            daylight.color.white = Some(White::D65);
            let look = match (self.pictures.plan(input, look), self.pictures.plan(input, &daylight)) {
                // The white is all that differs.
                (Err(_), Ok(_)) => {
                    print::note(format_args!("note: no eye takes {name} for white: drawn for D65"));
                    daylight
                }
                (plan, _) => plan.map(|_| look.clone())?,
            };
            sources.push(Source { name, color, look });
        }
        input.scene.lights = own;
        Ok(sources)
    }

    /// One picture for each light.
    fn row(
        &self,
        input: &mut Input,
        sources: &[Source],
        progress: &mut Progress,
        mut remarked: Option<&mut Remarked>,
    ) -> Result<Vec<Canvas>, Failure> {
        let own = input.scene.lights.clone();
        let mut pictures = Vec::with_capacity(sources.len());
        for Source { name, color, look } in sources {
            relight(&mut input.scene.lights, &own, color);
            let plan = self.pictures.plan(input, look)?.at(self.input.program.moment());
            let mut shot = plan.shot(&input.scene)?;
            let picture = pipeline::codes(&mut shot, &mut Timings::default(), progress)?;
            if let Some(remarked) = &mut remarked {
                remarked.look(&mut shot, &input.scene, &picture.clone().into(), || name.clone())?;
            }
            pictures.push(picture);
            progress.step();
        }
        input.scene.lights = own;
        Ok(pictures)
    }

    fn tell(&self, target: &Target, sources: &[Source], notes: Vec<String>) -> Result<(), Failure> {
        let Target::File(path) = target else { return Ok(()) };
        if self.pictures.format.is_json() {
            let lights = sources.iter().map(describe).collect();
            return print::json(&Document { file: path.display().to_string(), lights, notes });
        }
        Ok(())
    }
}

/// The pictures beside each other.
fn sheet(sources: &[Source], rows: Vec<String>, pictures: &[Canvas]) -> Result<Canvas, Failure> {
    let sheet = ContactSheet {
        columns: sources.iter().map(|source| source.name.clone()).collect(),
        rows,
        per_row: sources.len(),
        count: pictures.len(),
        cell: (pictures[0].width, pictures[0].height),
        ..ContactSheet::default()
    };
    let mut canvas = sheet.begin()?;
    for (index, picture) in pictures.iter().enumerate() {
        sheet.put(&mut canvas, index, picture);
    }
    Ok(canvas)
}

/// The spectra of lights by their names.
fn spectra(names: &[String]) -> Result<Vec<LightColor>, Failure> {
    let color = |name: &String| {
        let spectrum = light_source(name)?.spectrum;
        LightColor::unit(&spectrum)
            .ok_or_else(|| Failure::Usage(format!("light '{name}' has no power between 300 and 780 nm")))
    };
    names.iter().map(color).collect()
}

/// A scene under several lights.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    /// The sheet of pictures
    file: String,
    /// In the order of the columns
    lights: Vec<LightFacts>,
    /// What was ignored or changed of the scene's file, and what is odd about the pictures: black, clipped, a mistake
    notes: Vec<String>,
}

#[derive(Debug, Serialize, JsonSchema)]
struct LightFacts {
    name: String,
    /// The chromaticity for the standard observer
    #[serde(skip_serializing_if = "Option::is_none")]
    xy: Option<[f64; 2]>,
}

/// A light for programs.
fn describe(Source { name, color, .. }: &Source) -> LightFacts {
    let name = name.clone();
    let LightColor::Spectrum(spectrum) = color else { return LightFacts { name, xy: None } };
    let [x, y, z] = xyz_of_light(&**spectrum, &Observer::default());
    LightFacts { name, xy: Some([x / (x + y + z), y / (x + y + z)]) }
}

/// Gives the lights another spectrum in place of their own.
fn relight(lights: &mut [Light], own: &[Light], color: &LightColor) {
    for (light, own) in lights.iter_mut().zip(own) {
        light.colors = relit(&own.colors, color);
    }
}

/// The colours of a light with another spectrum in place of its own.
fn relit(own: &LightColors, color: &LightColor) -> LightColors {
    let part = |own: &LightColor| color.scaled(own.strength());
    LightColors { ambient: part(&own.ambient), diffuse: part(&own.diffuse), specular: part(&own.specular) }
}

/// The materials without re-radiation; none where there is no re-radiation in them.
fn without_fluorescence(materials: &[Material]) -> Option<Vec<Material>> {
    let mut plain = materials.to_vec();
    let mut found = false;
    for lobe in plain.iter_mut().flat_map(|material| &mut material.lobes) {
        if let Tint::Reradiation(matrix) = &lobe.tint {
            lobe.tint = Tint::Spectrum(std::sync::Arc::new(matrix.reflectance()));
            found = true;
        }
    }
    found.then_some(plain)
}
