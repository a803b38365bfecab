//! `glanz bsdf`: the models of reflection, and their numbers.

pub(super) mod albedo;
mod delta;
mod directions;
pub(super) mod eval;
pub(super) mod list;
mod model;
mod table;

use clap::Subcommand;

pub(super) use model::{ModelArgs, shape_of};

use crate::print::FormatArgs;
use crate::print::failure::Failure;

/// What to do with the models.
#[derive(Subcommand, Debug)]
pub(crate) enum BsdfCommand {
    /// All models, one per line
    #[command(after_help = "Example:\n  glanz bsdf list --format json")]
    List(FormatArgs),
    /// All that is known of one model: formula, parameters, laws, source
    #[command(after_help = "Example:\n  glanz bsdf show blinn-phong")]
    Show(list::ShowArgs),
    /// The value for one pair of directions, or for each of a table
    #[command(after_help = eval::EXAMPLES)]
    Eval(eval::EvalArgs),
    /// The part of the light that leaves, by the angle that it is seen from
    #[command(after_help = albedo::EXAMPLES)]
    Albedo(albedo::AlbedoArgs),
}

impl BsdfCommand {
    /// The subcommand's name.
    pub(crate) fn name(&self) -> &'static str {
        match self {
            Self::List(_) => "list",
            Self::Show(_) => "show",
            Self::Eval(_) => "eval",
            Self::Albedo(_) => "albedo",
        }
    }

    /// Does it.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        match self {
            Self::List(format) => list::run(*format),
            Self::Show(args) => args.run(),
            Self::Eval(args) => args.run(),
            Self::Albedo(args) => args.run(),
        }
    }
}
