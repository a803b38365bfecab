//! `glanz shader`: programs of users, in GLSL and WGSL.

pub(super) mod certify;
pub(super) mod check;
pub(super) mod export;
pub(super) mod picture;
pub(super) mod programs;
pub(super) mod run;
mod scene;
pub(super) mod xray;

use clap::Subcommand;

pub(crate) use programs::print_of;

use crate::print::failure::Failure;

/// What to do with a shader.
#[derive(Subcommand, Debug)]
pub(crate) enum ShaderCommand {
    /// Compile shaders, and tell what they take and what is probably not meant
    #[command(after_help = check::EXAMPLES)]
    Check(check::CheckArgs),
    /// List the programs to begin with
    #[command(after_help = programs::LIST_EXAMPLES)]
    List(programs::ListArgs),
    /// Print a program to begin with, to be changed and drawn with
    #[command(after_help = programs::PRINT_EXAMPLES)]
    Print(programs::PrintArgs),
    /// Tell every value of every line of a program at a pixel or a vertex
    #[command(after_help = xray::EXAMPLES)]
    Xray(Box<xray::XrayArgs>),
    /// Write the lights and materials of a scene as programs with filled structs
    #[command(after_help = export::EXAMPLES)]
    Export(Box<export::ExportArgs>),
    /// Draw a value of a line of a program as a picture
    #[command(after_help = picture::EXAMPLES)]
    Picture(Box<picture::PictureArgs>),
    /// Draw a fragment shader alone, as Shadertoy and glslViewer do: a picture or a film
    #[command(after_help = run::EXAMPLES)]
    Run(Box<run::RunArgs>),
    /// Judge BRDFs of one's own by the laws of physics, with the line that breaks them
    #[command(after_help = certify::EXAMPLES)]
    Certify(Box<certify::CertifyArgs>),
}

impl ShaderCommand {
    /// The subcommand's name.
    pub(crate) fn name(&self) -> &'static str {
        match self {
            Self::Check(_) => "check",
            Self::List(_) => "list",
            Self::Print(_) => "print",
            Self::Xray(_) => "xray",
            Self::Picture(_) => "picture",
            Self::Export(_) => "export",
            Self::Run(_) => "run",
            Self::Certify(_) => "certify",
        }
    }

    /// Does it.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        match self {
            Self::Check(args) => args.run(),
            Self::List(args) => args.run(),
            Self::Print(args) => args.run(),
            Self::Xray(args) => args.run(),
            Self::Picture(args) => args.run(),
            Self::Export(args) => args.run(),
            Self::Run(args) => args.run(),
            Self::Certify(args) => args.run(),
        }
    }
}
