//! `glanz lesson`: experiments of the course, with numbers and a plot.

pub(super) mod ward;

use clap::Subcommand;

use crate::print::failure::Failure;

/// Which experiment.
#[derive(Subcommand, Debug)]
pub(crate) enum LessonCommand {
    /// Ward's regression: from the readings of a goniometer to the widths of his model
    #[command(after_help = ward::EXAMPLES)]
    Ward(Box<ward::WardArgs>),
}

impl LessonCommand {
    /// The subcommand's name.
    pub(crate) fn name(&self) -> &'static str {
        match self {
            Self::Ward(_) => "ward",
        }
    }

    /// Does it.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        match self {
            Self::Ward(args) => args.run(),
        }
    }
}
