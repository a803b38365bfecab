//! `glanz material`: the library of materials.

mod categories;
pub(super) mod list;
mod sheet;
pub(super) mod show;

use clap::Subcommand;

use crate::print::failure::Failure;

/// What to do with the library.
#[derive(Subcommand, Debug)]
pub(crate) enum MaterialCommand {
    /// All materials, one per line
    #[command(after_help = list::EXAMPLES)]
    List(list::ListArgs),
    /// One material, as it is written in a scene file
    #[command(after_help = show::EXAMPLES)]
    Show(show::ShowArgs),
    /// Draw a sheet of balls of materials
    #[command(after_help = sheet::EXAMPLES)]
    Sheet(Box<sheet::SheetArgs>),
}

impl MaterialCommand {
    /// The subcommand's name.
    pub(crate) fn name(&self) -> &'static str {
        match self {
            Self::List(_) => "list",
            Self::Show(_) => "show",
            Self::Sheet(_) => "sheet",
        }
    }

    /// Does it.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        match self {
            Self::List(args) => args.run(),
            Self::Show(args) => args.run(),
            Self::Sheet(args) => args.run(),
        }
    }
}
