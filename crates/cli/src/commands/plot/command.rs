//! `glanz plot` itself, and the commands below it.

use clap::{ArgMatches, Args, Command, FromArgMatches, Subcommand};

use super::PlotArgs;
use super::eye::{self, EyePlotArgs};
use crate::print::failure::Failure;

/// What `glanz plot` is asked for.
#[derive(Debug)]
pub(crate) enum PlotCommand {
    /// A plot of models, media, lights or directions.
    Itself(Box<PlotArgs>),
    /// A plot that has options of its own.
    Own(OwnPlot),
}

/// Plots that have options of their own.
#[derive(Subcommand, Debug)]
pub(crate) enum OwnPlot {
    /// Plot curves of eyes: lens, pupil, dusk, glare, contrast sensitivity and more
    #[command(after_help = eye::EXAMPLES)]
    Eye(EyePlotArgs),
}

impl PlotCommand {
    /// The names that lead to the command.
    pub(crate) fn path(&self) -> Vec<&'static str> {
        match self {
            Self::Itself(_) => vec!["plot"],
            Self::Own(OwnPlot::Eye(_)) => vec!["plot", "eye"],
        }
    }

    /// Makes the plot.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        match self {
            Self::Itself(args) => args.run(),
            Self::Own(OwnPlot::Eye(args)) => args.run(),
        }
    }
}

// By hand: derived, the options of `glanz plot` would be asked for with a command below it, too. An `Option` around them
// does not help, for clap does not see that options in a group within a group are given.
impl Args for PlotCommand {
    fn augment_args(command: Command) -> Command {
        OwnPlot::augment_subcommands(PlotArgs::augment_args(command))
            .args_conflicts_with_subcommands(true)
            .subcommand_negates_reqs(true)
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for PlotCommand {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        match matches.subcommand_name() {
            Some(_) => OwnPlot::from_arg_matches(matches).map(Self::Own),
            None => PlotArgs::from_arg_matches(matches).map(|args| Self::Itself(Box::new(args))),
        }
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}
