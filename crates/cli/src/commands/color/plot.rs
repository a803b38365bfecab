//! `glanz color plot`: plots of spectra, observers and colour spaces.

use clap::{Args, Subcommand};
use glanz_color::chromaticity::Chromaticity;
use glanz_color::tm30::evaluate;
use glanz_color::{SpectrumKind, catalog_spectrum};
use glanz_plot::figure::{ColorVectors, Mark};
use glanz_plot::{
    ChromaticityDiagram, Figure, Lang, NamedSpectrum, ReradiationMap, WavelengthChart, Word, cones, meyer,
    spectra,
};

use super::efficiency::WhatArgs;
use crate::args::PlotOutputArgs;
use crate::input::spectra::{
    FluorescentSource, Source, TableArgs, fluorescent_source, light_source, source, words,
};
use crate::print::failure::Failure;

/// Shown below the help.
pub(super) const EXAMPLES: &str = "Examples:
  glanz color plot spectra D65 A FL11 -o lights.svg
  glanz color plot chromaticity --mark D65,A,E -o diagram.png
  glanz color plot cones -o cones.svg";

/// What to draw.
#[derive(Subcommand, Debug)]
pub(crate) enum PlotCommand {
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
    Cones(PlotOutputArgs),
    /// Meyer's basis functions A, C1, C2 and his four wavelengths
    #[command(after_help = "Example:\n  glanz color plot meyer -o meyer.svg")]
    Meyer(PlotOutputArgs),
    /// A re-radiation matrix as a heat map
    #[command(after_help = "Example:\n  glanz color plot matrix paper-note-yellow -o matrix.png")]
    Matrix(MatrixArgs),
    /// How a light shows colours: the colour vector graphic of TM-30
    #[command(after_help = "Example:\n  glanz color plot tm30 FL2 -o vectors.svg

The circle is the reference of the same colour temperature, the red line the light: inside of the
circle colours are duller, outside more saturated, and the arrows tell how hues turn.")]
    Tm30(Tm30Args),
    /// The error of colours over the number of samples of the spectrum
    #[command(after_help = "Example:\n  glanz color plot efficiency --light D65,A,FL11 -o efficiency.svg")]
    Efficiency(EfficiencyArgs),
}

/// Options of `glanz color plot spectra`.
#[derive(Args, Debug)]
pub(crate) struct SpectraArgs {
    /// Lights or surfaces: names from `glanz color list`, or files
    #[arg(value_name = "NAME|FILE", required = true)]
    spectra: Vec<String>,

    #[command(flatten)]
    table: TableArgs,

    /// Divide each spectrum by its greatest value
    #[arg(long)]
    normalize: bool,

    #[command(flatten)]
    output: PlotOutputArgs,
}

/// Options of `glanz color plot chromaticity`.
#[derive(Args, Debug)]
pub(crate) struct ChromaticityArgs {
    /// Lights that are marked, between commas: names or files
    #[arg(long, value_name = "LIGHT,…", default_value = "D65,A,E")]
    mark: String,

    #[command(flatten)]
    output: PlotOutputArgs,
}

/// Options of `glanz color plot matrix`.
#[derive(Args, Debug)]
pub(crate) struct MatrixArgs {
    /// A material from `glanz color list fluorescent`, or a file
    #[arg(value_name = "NAME|FILE")]
    material: String,

    #[command(flatten)]
    output: PlotOutputArgs,
}

/// Options of `glanz color plot tm30`.
#[derive(Args, Debug)]
pub(crate) struct Tm30Args {
    /// A light from `glanz color list lights`, or a file
    #[arg(value_name = "NAME|FILE")]
    light: String,

    #[command(flatten)]
    table: TableArgs,

    #[command(flatten)]
    output: PlotOutputArgs,
}

/// Options of `glanz color plot efficiency`.
#[derive(Args, Debug)]
pub(crate) struct EfficiencyArgs {
    #[command(flatten)]
    what: WhatArgs,

    #[command(flatten)]
    output: PlotOutputArgs,
}

impl PlotCommand {
    /// The subcommand's name.
    pub(crate) fn name(&self) -> &'static str {
        match self {
            Self::Spectra(_) => "spectra",
            Self::Chromaticity(_) => "chromaticity",
            Self::Cones(_) => "cones",
            Self::Meyer(_) => "meyer",
            Self::Matrix(_) => "matrix",
            Self::Tm30(_) => "tm30",
            Self::Efficiency(_) => "efficiency",
        }
    }

    /// Draws it.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let target = self.output().target()?;
        let lang = target.lang();
        let mut figure: Box<dyn Figure> = match self {
            Self::Spectra(args) => Box::new(args.chart(lang)?),
            Self::Chromaticity(args) => Box::new(args.diagram(lang)?),
            Self::Cones(_) => Box::new(cones(lang).map_err(Failure::new)?),
            Self::Meyer(_) => Box::new(meyer(lang)),
            Self::Matrix(args) => {
                let FluorescentSource { name, matrix, .. } = fluorescent_source(&args.material)?;
                Box::new(ReradiationMap { name, matrix, factors: None, lang })
            }
            Self::Tm30(args) => Box::new(args.vectors(lang)?),
            Self::Efficiency(args) => Box::new(args.what.find()?.chart(lang)),
        };
        target.save(figure.as_mut())
    }

    fn output(&self) -> &PlotOutputArgs {
        match self {
            Self::Spectra(args) => &args.output,
            Self::Chromaticity(args) => &args.output,
            Self::Cones(output) | Self::Meyer(output) => output,
            Self::Matrix(args) => &args.output,
            Self::Tm30(args) => &args.output,
            Self::Efficiency(args) => &args.output,
        }
    }
}

impl SpectraArgs {
    fn chart(&self, lang: Lang) -> Result<WavelengthChart, Failure> {
        self.check_table()?;
        let read = |word: &String| source(word, None, &self.table);
        let sources = self.spectra.iter().map(read).collect::<Result<Vec<_>, _>>()?;
        let curves: Vec<_> = sources.iter().map(|source| self.curve(source)).collect();
        let surfaces = sources.iter().all(|source| source.kind == SpectrumKind::Surface);
        let lights = sources.iter().all(|source| source.kind == SpectrumKind::Light);
        let label = match (surfaces, lights) {
            _ if self.normalize => Word::Normalized,
            (true, _) => Word::Reflectance,
            (_, true) => Word::RelativePower,
            _ => Word::PowerOrReflectance,
        };
        let band = || lang.say(Word::Band, &[]);
        let (title, subtitle) = match sources.as_slice() {
            [only] => (only.name.clone(), only.title.clone()),
            _ if surfaces => (lang.say(Word::Reflectances, &[]), band()),
            _ if lights => (lang.say(Word::Lights, &[]), band()),
            _ => (lang.say(Word::Spectra, &[]), band()),
        };
        let chart = spectra(&title, &subtitle, &lang.say(label, &[]), &curves);
        Ok(WavelengthChart { lang, ..chart })
    }

    /// That there is a file where an option tells how files are read.
    fn check_table(&self) -> Result<(), Failure> {
        let table = &self.table;
        let given = [
            ("--as", table.kind.is_some()),
            ("--unit", table.unit.is_some()),
            ("--scale", table.scale.is_some()),
            ("--column", table.column.is_some()),
            ("--pixel", table.pixel.is_some()),
        ];
        let given = given.into_iter().find(|(_, is)| *is);
        match given.filter(|_| self.spectra.iter().all(|word| catalog_spectrum(word).is_ok())) {
            Some((option, _)) => {
                let names = self.spectra.join(", ");
                Err(Failure::Usage(format!("{option} has no effect on {names}; it acts on files")))
            }
            None => Ok(()),
        }
    }

    fn curve(&self, source: &Source) -> NamedSpectrum {
        let most = source.spectrum.max();
        let divided = self.normalize && most > 0.0;
        let spectrum = if divided { source.spectrum * (1.0 / most) } else { source.spectrum };
        NamedSpectrum { name: source.name.clone(), spectrum }
    }
}

impl Tm30Args {
    fn vectors(&self, lang: Lang) -> Result<ColorVectors, Failure> {
        let light = source(&self.light, Some(SpectrumKind::Light), &self.table)?;
        if light.kind != SpectrumKind::Light {
            return Err(Failure::Usage(format!("'{}' is a surface; lights show colours", self.light)));
        }
        let rendition = evaluate(&light.fine)
            .map_err(|error| Failure::new(format_args!("'{}' has no Rf: {error}", self.light)))?;
        Ok(ColorVectors { name: light.name, rendition, lang })
    }
}

impl ChromaticityArgs {
    fn diagram(&self, lang: Lang) -> Result<ChromaticityDiagram, Failure> {
        let lights = words(&self.mark).map_err(|error| Failure::Usage(format!("--mark: {error}")))?;
        let mut marks = Vec::new();
        for word in &lights {
            let light = light_source(word)?;
            let xy = Chromaticity::of_light(&light.fine)
                .ok_or_else(|| Failure::Usage(format!("no observer sees the light '{word}'")))?;
            marks.push(Mark { name: light.name, xy });
        }
        Ok(ChromaticityDiagram::new(marks, lang))
    }
}
