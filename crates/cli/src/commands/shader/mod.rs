//! `glanz shader`: programs of users, in GLSL and WGSL.

pub(super) mod check;
pub(super) mod run;

use clap::Subcommand;

use crate::print::failure::Failure;

/// What to do with a shader.
#[derive(Subcommand, Debug)]
pub(crate) enum ShaderCommand {
    /// Compile shaders, and tell what they take and what is probably not meant
    #[command(after_help = check::EXAMPLES)]
    Check(check::CheckArgs),
    /// Draw a fragment shader alone, as Shadertoy and glslViewer do: a picture or a film
    #[command(after_help = run::EXAMPLES)]
    Run(Box<run::RunArgs>),
}

impl ShaderCommand {
    /// The subcommand's name.
    pub(crate) fn name(&self) -> &'static str {
        match self {
            Self::Check(_) => "check",
            Self::Run(_) => "run",
        }
    }

    /// Does it.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        match self {
            Self::Check(args) => args.run(),
            Self::Run(args) => args.run(),
        }
    }
}
