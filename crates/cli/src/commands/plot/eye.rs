//! `glanz plot eye`: the curves of eyes.

use clap::{Args, ValueEnum};
use glanz_eye::{Cones as Missing, Eye, EyeError};
use glanz_plot::{EyePlot, Figure, Lang};

use crate::args::PlotOutputArgs;
use crate::print::failure::Failure;

/// Shown after the help.
pub(super) const EXAMPLES: &str = "\
Examples:
  glanz plot eye --kind lens --age 20,50,80 -o lens.svg
  glanz plot eye --kind cones --observer standard,age:70,deutan:10 -o cones.svg
  glanz plot eye --kind glare --age 25,75 --pigment 1.2 -o glare.png
  glanz plot eye --kind csf --luminance 0.1,100 -o csf.svg
  glanz plot eye --kind mesopic --lang fr -o purkinje.pdf
  glanz plot eye --kind pupil -o - --format csv

docs/EYE.md says which formula each kind has. `glanz color plot cones` has the cones of the standard
observer. An option that has no effect on a kind is refused.";

/// The curves of eyes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum EyeKind {
    /// The transmittance of the lens by age, by CIE 170-1 and by CIE 203
    Lens,
    /// The sensitivity of the cones of eyes, and of their rods
    Cones,
    /// Colours that eyes without a kind of cones take for the same
    Confusion,
    /// The sensitivity of the rods by age
    Rods,
    /// The diameter of the pupil over luminance by age
    Pupil,
    /// From day to night: the share of the cones, and how light red, green and blue are
    Mesopic,
    /// Light scattered in the eye by age
    Glare,
    /// Contrast sensitivity over spatial frequency
    Csf,
    /// The response to luminance: logarithm, cube root, cones, just noticeable steps
    Response,
    /// Rods, cones and midget ganglion cells across the retina
    Mosaic,
}

use EyeKind::{Cones, Confusion, Csf, Glare, Lens, Mesopic, Mosaic, Pupil, Response, Rods};

/// Options of `glanz plot eye`.
#[derive(Args, Debug)]
pub(crate) struct EyePlotArgs {
    /// What is plotted
    #[arg(long, value_enum, value_name = "KIND")]
    kind: EyeKind,

    /// Ages in years, 20 to 80, a curve for each; of lens, cones, rods, pupil and glare [default: 20,50,80]
    #[arg(long, value_name = "YEARS,…", value_delimiter = ',', allow_hyphen_values = true)]
    age: Vec<f64>,

    /// Eyes, such as age:70+deutan:10; of cones in place of --age, and of confusion [default: there protan, deutan, tritan]
    #[arg(long, value_name = "EYE,…", value_delimiter = ',')]
    observer: Vec<String>,

    /// Luminances in cd/m²: of the background for csf, of white for response [default: 100]
    #[arg(long, value_name = "CD/M2,…", value_delimiter = ',', allow_hyphen_values = true)]
    luminance: Vec<f64>,

    /// The pigment of iris and wall of the eye, for glare: 0 very dark, 0.5 brown, 1 blue-green, 1.2 very light blue
    /// [default: 0.5]
    #[arg(long, value_name = "P", allow_hyphen_values = true)]
    pigment: Option<f64>,

    #[command(flatten)]
    output: PlotOutputArgs,
}

/// An option, the kinds that it acts on, and whether it is given.
type Effect = (&'static str, &'static [EyeKind], fn(&EyePlotArgs) -> bool);

/// Options that do not act on all kinds.
const EFFECTS: [Effect; 4] = [
    ("--age", &[Lens, Cones, Rods, Pupil, Glare], |args| !args.age.is_empty()),
    ("--observer", &[Cones, Confusion], |args| !args.observer.is_empty()),
    ("--luminance", &[Csf, Response], |args| !args.luminance.is_empty()),
    ("--pigment", &[Glare], |args| args.pigment.is_some()),
];

impl EyeKind {
    /// The name on the command line.
    fn name(self) -> String {
        self.to_possible_value().map_or(String::new(), |value| value.get_name().to_owned())
    }
}

impl EyePlotArgs {
    /// Makes the plot.
    pub(super) fn run(&self) -> Result<(), Failure> {
        let target = self.output.target()?;
        self.check_options()?;
        target.save(self.figure(target.lang())?.as_mut())
    }

    /// That every option acts on the kind.
    fn check_options(&self) -> Result<(), Failure> {
        let useless = EFFECTS.iter().find(|(_, kinds, given)| given(self) && !kinds.contains(&self.kind));
        let Some((option, kinds, _)) = useless else { return Ok(()) };
        let names: Vec<_> = kinds.iter().map(|kind| kind.name()).collect();
        let (kind, names) = (self.kind.name(), super::kind::enumerated(&names));
        Err(Failure::Usage(format!("{option} has no effect on --kind {kind}; it acts on {names}")))
    }

    /// The eyes whose cones are plotted: those that are named, or one of each age.
    fn eyes(&self, ages: &[f64]) -> Result<Vec<Eye>, Failure> {
        if !self.observer.is_empty() && !self.age.is_empty() {
            return Err(Failure::Usage("--observer says the ages: leave out --age".to_owned()));
        }
        let read = |name: &String| name.parse().map_err(|error: EyeError| Failure::Usage(error.to_string()));
        let eyes = match self.observer.is_empty() {
            true => ages.iter().map(|age| Eye { age: *age, ..Eye::default() }).collect(),
            false => self.observer.iter().map(read).collect::<Result<Vec<Eye>, _>>()?,
        };
        let checked = eyes.iter().try_for_each(Eye::check);
        checked.map_err(|error| Failure::Usage(error.to_string()))?;
        Ok(eyes)
    }

    /// The eyes whose confusions are plotted: those that are named, or one of each kind.
    fn dichromats(&self) -> Result<Vec<Eye>, Failure> {
        let eyes = match self.observer.is_empty() {
            false => self.eyes(&[])?,
            true => [Missing::NoL, Missing::NoM, Missing::NoS]
                .map(|cones| Eye { cones, ..Eye::default() })
                .to_vec(),
        };
        match eyes.iter().find(|eye| eye.cones.missing().is_none()) {
            None => Ok(eyes),
            Some(eye) => Err(Failure::Usage(format!(
                "'{eye}' has all kinds of cones; confusion lines are those of protan, deutan or tritan, as age:70+deutan"
            ))),
        }
    }

    fn figure(&self, lang: Lang) -> Result<Box<dyn Figure>, Failure> {
        let standard = EyePlot { lang, ..EyePlot::default() };
        let or = |given: &[f64], usual: &[f64]| if given.is_empty() { usual } else { given }.to_vec();
        let plot = EyePlot {
            ages: or(&self.age, &standard.ages),
            luminances: or(&self.luminance, &standard.luminances),
            pigment: self.pigment.unwrap_or(standard.pigment),
            lang,
        };
        Ok(match self.kind {
            Lens => Box::new(plot.lens()?),
            Cones => Box::new(plot.cones(&self.eyes(&plot.ages)?)?),
            Confusion => Box::new(plot.confusion(&self.dichromats()?)?),
            Rods => Box::new(plot.rods()?),
            Pupil => Box::new(plot.pupil()?),
            Mesopic => Box::new(plot.mesopic()?),
            Glare => Box::new(plot.glare()?),
            Csf => Box::new(plot.contrast()?),
            Response => Box::new(plot.response()?),
            Mosaic => Box::new(plot.mosaic()),
        })
    }
}
