//! `glanz color plot`: pictures of what colour is made of.

use clap::{Args, Subcommand};
use glanz_color::chromaticity::Chromaticity;

use super::efficiency::WhatArgs;
use crate::failure::Failure;
use crate::plot::{self, Mark, NamedCurve, Picture, PlotFile, plot_file};
use crate::print;
use crate::spectra::{Kind, Source, fluorescent_source, light_source, source, words};

/// Shown below the help.
pub const EXAMPLES: &str = "Examples:
  glanz color plot spectra D65 A FL11 -o lights.svg
  glanz color plot chromaticity --mark D65,A,E -o diagram.png
  glanz color plot cones -o cones.svg";

/// What to draw.
#[derive(Subcommand, Debug)]
pub enum PlotCommand {
    /// Spectra over the band of the spectral colours
    #[command(after_help = "Examples:
  glanz color plot spectra D65 A FL11 -o lights.svg
  glanz color plot spectra gold copper silver -o metals.png")]
    Spectra(SpectraArgs),
    /// The chromaticity diagram of CIE 1931 with gamuts and black bodies
    #[command(after_help = "Example:\n  glanz color plot chromaticity --mark D65,A,FL11 -o diagram.png")]
    Chromaticity(ChromaticityArgs),
    /// The sensitivities of the cones and the rods
    #[command(after_help = "Example:\n  glanz color plot cones -o cones.svg")]
    Cones(OutputArgs),
    /// Meyer's basis functions A, C1, C2 and his four wavelengths
    #[command(after_help = "Example:\n  glanz color plot meyer -o meyer.svg")]
    Meyer(OutputArgs),
    /// A re-radiation matrix as a heat map
    #[command(after_help = "Example:\n  glanz color plot matrix paper-note-yellow -o matrix.png")]
    Matrix(MatrixArgs),
    /// The error of colours over the number of samples of the spectrum
    #[command(after_help = "Example:\n  glanz color plot efficiency --under D65,A,FL11 -o efficiency.svg")]
    Efficiency(EfficiencyArgs),
}

/// Where the plot goes.
#[derive(Args, Debug)]
pub struct OutputArgs {
    /// The plot's file; .svg or .png
    #[arg(short, long, value_name = "FILE", value_parser = plot_file, help_heading = "Output")]
    output: PlotFile,
}

/// Options of `glanz color plot spectra`.
#[derive(Args, Debug)]
pub struct SpectraArgs {
    /// Lights or surfaces: names from `glanz color list`, or files
    #[arg(value_name = "NAME|FILE", required = true)]
    spectra: Vec<String>,

    /// What the files' spectra are of, where they do not say it
    #[arg(long = "as", value_enum, value_name = "KIND")]
    kind: Option<Kind>,

    /// Divide each spectrum by its greatest value
    #[arg(long)]
    normalize: bool,

    #[command(flatten)]
    output: OutputArgs,
}

/// Options of `glanz color plot chromaticity`.
#[derive(Args, Debug)]
pub struct ChromaticityArgs {
    /// Lights that are marked, between commas: names or files
    #[arg(long, value_name = "LIGHT,…", default_value = "D65,A,E")]
    mark: String,

    #[command(flatten)]
    output: OutputArgs,
}

/// Options of `glanz color plot matrix`.
#[derive(Args, Debug)]
pub struct MatrixArgs {
    /// A material from `glanz color list fluorescent`, or a file
    #[arg(value_name = "NAME|FILE")]
    material: String,

    #[command(flatten)]
    output: OutputArgs,
}

/// Options of `glanz color plot efficiency`.
#[derive(Args, Debug)]
pub struct EfficiencyArgs {
    #[command(flatten)]
    what: WhatArgs,

    #[command(flatten)]
    output: OutputArgs,
}

impl PlotCommand {
    /// The subcommand's name.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Spectra(_) => "spectra",
            Self::Chromaticity(_) => "chromaticity",
            Self::Cones(_) => "cones",
            Self::Meyer(_) => "meyer",
            Self::Matrix(_) => "matrix",
            Self::Efficiency(_) => "efficiency",
        }
    }

    /// Draws it.
    pub fn run(&self) -> Result<(), Failure> {
        let file = &self.output().output;
        file.check()?;
        let picture = match self {
            Self::Spectra(args) => args.picture()?,
            Self::Chromaticity(args) => args.picture()?,
            Self::Cones(_) => plot::cones().map_err(Failure::new)?,
            Self::Meyer(_) => plot::meyer(),
            Self::Matrix(args) => {
                let material = fluorescent_source(&args.material)?;
                plot::matrix(&material.name, &material.matrix)
            }
            Self::Efficiency(args) => args.what.find()?.picture(),
        };
        file.save(&picture)?;
        print::note(format_args!("wrote {}", file.path().display()));
        Ok(())
    }

    fn output(&self) -> &OutputArgs {
        match self {
            Self::Spectra(args) => &args.output,
            Self::Chromaticity(args) => &args.output,
            Self::Cones(output) | Self::Meyer(output) => output,
            Self::Matrix(args) => &args.output,
            Self::Efficiency(args) => &args.output,
        }
    }
}

impl SpectraArgs {
    fn picture(&self) -> Result<Picture, Failure> {
        let sources =
            self.spectra.iter().map(|word| source(word, self.kind)).collect::<Result<Vec<_>, _>>()?;
        let curves: Vec<_> = sources.iter().map(|source| self.curve(source)).collect();
        let surfaces = sources.iter().all(|source| source.kind == Kind::Surface);
        let lights = sources.iter().all(|source| source.kind == Kind::Light);
        let label = match (surfaces, lights) {
            _ if self.normalize => "relative to the greatest value",
            (true, _) => "reflectance",
            (_, true) => "relative power per nm",
            _ => "relative power per nm, or reflectance",
        };
        let (title, subtitle) = match sources.as_slice() {
            [only] => (only.name.clone(), only.title.clone()),
            _ if surfaces => ("Reflectances".to_owned(), "300 to 780 nm".to_owned()),
            _ if lights => ("Lights".to_owned(), "300 to 780 nm".to_owned()),
            _ => ("Spectra".to_owned(), "300 to 780 nm".to_owned()),
        };
        Ok(plot::spectra(&title, &subtitle, label, &curves))
    }

    fn curve(&self, source: &Source) -> NamedCurve {
        let most = source.spectrum.max();
        let divided = self.normalize && most > 0.0;
        let spectrum = if divided { source.spectrum * (1.0 / most) } else { source.spectrum };
        NamedCurve { name: source.name.clone(), spectrum }
    }
}

impl ChromaticityArgs {
    fn picture(&self) -> Result<Picture, Failure> {
        let lights = words(&self.mark).map_err(|error| Failure::Usage(format!("--mark: {error}")))?;
        let mut marks = Vec::new();
        for word in &lights {
            let light = light_source(word)?;
            let xy = Chromaticity::of_light(&light.spectrum)
                .ok_or_else(|| Failure::Usage(format!("no eye sees the light '{word}'")))?;
            marks.push(Mark { name: light.name, xy });
        }
        Ok(plot::chromaticity(&marks))
    }
}
