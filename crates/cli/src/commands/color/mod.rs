//! `glanz color`: spectra, lights and colours, and their numbers.

pub(super) mod convert;
pub(super) mod efficiency;
pub(super) mod fluorescence;
pub(super) mod list;
pub(super) mod metamers;
mod plot;
pub(super) mod spectrum;
pub(super) mod wave;
pub(super) mod xy;

use clap::Subcommand;

use crate::print::failure::Failure;

/// What to do with colours.
#[derive(Subcommand, Debug)]
pub(crate) enum ColorCommand {
    /// Convert a colour from one model to another
    #[command(after_help = convert::EXAMPLES)]
    Convert(convert::ConvertArgs),
    /// The colour numbers of a light or a surface
    #[command(after_help = spectrum::EXAMPLES)]
    Spectrum(spectrum::SpectrumArgs),
    /// The numbers of a chromaticity: colour temperature, dominant wavelength, purity
    #[command(after_help = xy::EXAMPLES)]
    Xy(xy::XyArgs),
    /// Light by its wavelength, frequency, wavenumber, energy and period
    #[command(after_help = wave::EXAMPLES)]
    Wave(wave::WaveArgs),
    /// How different two surfaces look under each of several lights
    #[command(after_help = metamers::EXAMPLES)]
    Metamers(metamers::MetamersArgs),
    /// What a fluorescent material makes of each of several lights
    #[command(after_help = fluorescence::EXAMPLES)]
    Fluorescence(fluorescence::FluorescenceArgs),
    /// The names of lights, observers, materials and colour models
    #[command(after_help = list::EXAMPLES)]
    List(list::ListArgs),
    /// How wrong colours are that are computed with few samples of the spectrum
    #[command(after_help = efficiency::EXAMPLES)]
    Efficiency(efficiency::EfficiencyArgs),
    /// Draw spectra, the chromaticity diagram, the eye's receptors and more
    #[command(subcommand, after_help = plot::EXAMPLES)]
    Plot(plot::PlotCommand),
}

impl ColorCommand {
    /// The names that lead to the command, from this one on.
    pub(crate) fn path(&self) -> Vec<&'static str> {
        match self {
            Self::Convert(_) => vec!["convert"],
            Self::Spectrum(_) => vec!["spectrum"],
            Self::Xy(_) => vec!["xy"],
            Self::Wave(_) => vec!["wave"],
            Self::Metamers(_) => vec!["metamers"],
            Self::Fluorescence(_) => vec!["fluorescence"],
            Self::List(_) => vec!["list"],
            Self::Efficiency(_) => vec!["efficiency"],
            Self::Plot(command) => vec!["plot", command.name()],
        }
    }

    /// Does it.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        match self {
            Self::Convert(args) => args.run(),
            Self::Spectrum(args) => args.run(),
            Self::Xy(args) => args.run(),
            Self::Wave(args) => args.run(),
            Self::Metamers(args) => args.run(),
            Self::Fluorescence(args) => args.run(),
            Self::List(args) => args.run(),
            Self::Efficiency(args) => args.run(),
            Self::Plot(command) => command.run(),
        }
    }
}
