//! `glanz shader`: programs of users, in GLSL and WGSL.

pub(super) mod check;
mod source;

use clap::Subcommand;

pub(crate) use source::{failure, included, read};

use crate::print::failure::Failure;

/// What to do with a shader.
#[derive(Subcommand, Debug)]
pub(crate) enum ShaderCommand {
    /// Compile shaders, and tell what they take and what is probably not meant
    #[command(after_help = check::EXAMPLES)]
    Check(check::CheckArgs),
}

impl ShaderCommand {
    /// The subcommand's name.
    pub(crate) fn name(&self) -> &'static str {
        match self {
            Self::Check(_) => "check",
        }
    }

    /// Does it.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        match self {
            Self::Check(args) => args.run(),
        }
    }
}
