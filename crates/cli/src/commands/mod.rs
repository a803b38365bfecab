//! One file per command; those that draw scenes are in `draw`.

mod bsdf;
mod check;
mod color;
mod compare;
mod completions;
mod devices;
mod draw;
mod example;
mod eye;
mod info;
mod lesson;
mod licenses;
mod material;
pub(crate) mod measure;
mod plot;
mod probe;
mod schema;
pub(crate) mod shader;

use std::path::Path;

use clap::{Command as ClapCommand, Subcommand};

use self::draw::{lighting_error, modes, relight, render, shade_compare, sheet, sweep};
use crate::print::failure::Failure;

/// What to do.
#[derive(Subcommand, Debug)]
pub(crate) enum Command {
    /// Draw a scene or a model
    #[command(after_help = render::EXAMPLES)]
    Render(Box<render::RenderArgs>),
    /// Draw a sheet of pictures in which values of the scene vary
    #[command(after_help = sweep::EXAMPLES)]
    Sweep(Box<sweep::SweepArgs>),
    /// Draw with flat, Gouraud and Phong shading side by side, and measure the difference
    #[command(after_help = shade_compare::EXAMPLES)]
    ShadeCompare(Box<shade_compare::ShadeCompareArgs>),
    /// Measure how far fast light from areas and environments is from exact light
    #[command(after_help = lighting_error::EXAMPLES)]
    LightingError(Box<lighting_error::LightingErrorArgs>),
    /// Draw in several colour modes side by side, and measure their errors
    #[command(after_help = modes::EXAMPLES)]
    Modes(Box<modes::ModesArgs>),
    /// Draw under several light sources side by side, with and without fluorescence
    #[command(after_help = relight::EXAMPLES)]
    Relight(Box<relight::RelightArgs>),
    /// See a scene with other eyes: by age, deficiency and light level, side by side
    #[command(after_help = eye::EXAMPLES)]
    Eye(Box<eye::EyeArgs>),
    /// Measure how far two picture files are apart
    #[command(after_help = compare::EXAMPLES)]
    Compare(Box<compare::CompareArgs>),
    /// Tell what is in a scene or a model, and what of it is ignored
    #[command(after_help = info::EXAMPLES)]
    Info(info::InfoArgs),
    /// Take pixels apart: vectors, cosines, and what each light and lobe gives
    #[command(after_help = probe::EXAMPLES)]
    Probe(Box<probe::ProbeArgs>),
    /// The models of reflection and their numbers
    #[command(
        subcommand,
        after_help = "Examples:\n  glanz bsdf list\n  glanz bsdf eval phong --wo 30,0 --wi 45,180"
    )]
    Bsdf(bsdf::BsdfCommand),
    /// Draw a sheet of balls of one model in which its parameters and its metal vary
    #[command(after_help = sheet::EXAMPLES)]
    Sheet(Box<sheet::SheetArgs>),
    /// The library of materials
    #[command(
        subcommand,
        after_help = "Examples:\n  glanz material list\n  glanz material show gold\n  glanz material sheet -o all.png"
    )]
    Material(material::MaterialCommand),
    /// Plot lobes of models, albedos, Fresnel reflectance and curves of eyes
    #[command(after_help = plot::EXAMPLES)]
    Plot(plot::PlotCommand),
    /// Check which laws of physics models keep, and where they break them
    #[command(after_help = check::EXAMPLES)]
    Check(check::CheckArgs),
    /// Spectra, lights and colours, and their numbers
    #[command(
        subcommand,
        after_help = "Examples:\n  glanz color spectrum D65\n  glanz color convert --from hls --to ac1c2 210,0.4,0.8"
    )]
    Color(color::ColorCommand),
    /// Measured reflectance: files of goniometers
    #[command(
        subcommand,
        after_help = "Examples:\n  glanz measure info paint.bsdf\n  glanz measure sample ggx --set alpha=0.2 -o ggx.binary"
    )]
    Measure(measure::MeasureCommand),
    /// Experiments of the course, with numbers and a plot
    #[command(subcommand, after_help = "Example:\n  glanz lesson ward --plot ward.png")]
    Lesson(lesson::LessonCommand),
    /// Programs of users, in GLSL and WGSL
    #[command(
        subcommand,
        after_help = "Examples:\n  glanz shader check phong.vert phong.frag\n  glanz shader run toy.frag -o toy.png"
    )]
    Shader(shader::ShaderCommand),
    /// List what can draw: the CPU and the GPUs
    #[command(after_help = devices::EXAMPLES)]
    Devices(devices::DevicesArgs),
    /// Write an example scene that is part of the program
    #[command(after_help = example::EXAMPLES)]
    Example(example::ExampleArgs),
    /// Print the JSON Schema of scene files, or of what a command prints for programs
    #[command(after_help = schema::EXAMPLES)]
    Schema(schema::SchemaArgs),
    /// Print the licences of the program and of the libraries that it contains
    #[command(after_help = licenses::EXAMPLES)]
    Licenses(licenses::LicensesArgs),
    /// Print what a shell needs to complete command lines
    #[command(
        after_help = "Example:\n  glanz completions bash > ~/.local/share/bash-completion/completions/glanz"
    )]
    Completions(completions::CompletionsArgs),
}

impl Command {
    /// The names that lead to the command.
    pub(crate) fn path(&self) -> Vec<&'static str> {
        match self {
            Self::Render(_) => vec!["render"],
            Self::Sweep(_) => vec!["sweep"],
            Self::ShadeCompare(_) => vec!["shade-compare"],
            Self::LightingError(_) => vec!["lighting-error"],
            Self::Modes(_) => vec!["modes"],
            Self::Relight(_) => vec!["relight"],
            Self::Eye(_) => vec!["eye"],
            Self::Compare(_) => vec!["compare"],
            Self::Info(_) => vec!["info"],
            Self::Probe(_) => vec!["probe"],
            Self::Bsdf(command) => vec!["bsdf", command.name()],
            Self::Sheet(_) => vec!["sheet"],
            Self::Material(command) => vec!["material", command.name()],
            Self::Plot(args) => args.path(),
            Self::Check(_) => vec!["check"],
            Self::Color(command) => [vec!["color"], command.path()].concat(),
            Self::Measure(command) => vec!["measure", command.name()],
            Self::Lesson(command) => vec!["lesson", command.name()],
            Self::Shader(command) => vec!["shader", command.name()],
            Self::Devices(_) => vec!["devices"],
            Self::Example(_) => vec!["example"],
            Self::Schema(_) => vec!["schema"],
            Self::Licenses(_) => vec!["licenses"],
            Self::Completions(_) => vec!["completions"],
        }
    }

    /// Does it. `root` defines the whole command line.
    pub(crate) fn run(&self, root: fn() -> ClapCommand) -> Result<(), Failure> {
        self.do_it(root).map_err(|failure| match self.scene() {
            Some(path) => failure.of_scene(path),
            None => failure,
        })
    }

    /// The file of the scene that it draws.
    fn scene(&self) -> Option<&Path> {
        let input = match self {
            Self::Render(args) => &args.input,
            Self::Sweep(args) => &args.input,
            Self::ShadeCompare(args) => &args.input,
            Self::LightingError(args) => &args.input,
            Self::Modes(args) => &args.input,
            Self::Relight(args) => &args.input,
            Self::Eye(args) => &args.input,
            Self::Probe(args) => &args.input,
            _ => return None,
        };
        Some(&input.input)
    }

    fn do_it(&self, root: fn() -> ClapCommand) -> Result<(), Failure> {
        match self {
            Self::Render(args) => args.run(),
            Self::Sweep(args) => args.run(),
            Self::ShadeCompare(args) => args.run(),
            Self::LightingError(args) => args.run(),
            Self::Modes(args) => args.run(),
            Self::Relight(args) => args.run(),
            Self::Eye(args) => args.run(),
            Self::Compare(args) => args.run(),
            Self::Info(args) => args.run(),
            Self::Probe(args) => args.run(),
            Self::Bsdf(command) => command.run(),
            Self::Sheet(args) => args.run(),
            Self::Material(command) => command.run(),
            Self::Plot(args) => args.run(),
            Self::Check(args) => args.run(),
            Self::Color(command) => command.run(),
            Self::Measure(command) => command.run(),
            Self::Lesson(command) => command.run(),
            Self::Shader(command) => command.run(),
            Self::Devices(args) => args.run(),
            Self::Example(args) => args.run(),
            Self::Schema(args) => args.run(),
            Self::Licenses(args) => args.run(),
            Self::Completions(args) => args.run(root()),
        }
    }
}
