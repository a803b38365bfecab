//! `glanz shader`: programs of users, in GLSL and WGSL.

pub(super) mod certify;
pub(super) mod check;

use clap::Subcommand;

use crate::print::failure::Failure;

/// What to do with a shader.
#[derive(Subcommand, Debug)]
pub(crate) enum ShaderCommand {
    /// Compile shaders, and tell what they take and what is probably not meant
    #[command(after_help = check::EXAMPLES)]
    Check(check::CheckArgs),
    /// Judge BRDFs of one's own by the laws of physics, with the line that breaks them
    #[command(after_help = certify::EXAMPLES)]
    Certify(Box<certify::CertifyArgs>),
}

impl ShaderCommand {
    /// The subcommand's name.
    pub(crate) fn name(&self) -> &'static str {
        match self {
            Self::Check(_) => "check",
            Self::Certify(_) => "certify",
        }
    }

    /// Does it.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        match self {
            Self::Check(args) => args.run(),
            Self::Certify(args) => args.run(),
        }
    }
}
