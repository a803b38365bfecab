//! Groups of options that commands share. Help, completions and documentation come from here.

mod camera;
pub(crate) mod choices;
mod color;
mod device;
mod input;
mod look;
mod picture;
mod plot;
mod program;
mod target;
pub(crate) mod values;

pub(crate) use camera::CameraArgs;
pub(crate) use color::ColorArgs;
pub(crate) use device::{DeviceArgs, with_runtime_folder};
pub(crate) use input::InputArgs;
pub(crate) use look::LookArgs;
pub(crate) use picture::{BitDepth, DevelopArgs};
pub(crate) use plot::{BesidePlotArgs, PlotOutputArgs, PlotTarget};
pub(crate) use program::{ProgramArgs, cube_faces};
pub(crate) use target::{Target, TargetArgs, check_apart, check_beside, check_folder};
pub(crate) use values::{angles, assignment, numbers, size};

use clap::Args;

use crate::input::spectra::words;
use crate::print::failure::Failure;

/// How large the picture is.
#[derive(Args, Clone, Copy, Debug)]
#[command(next_help_heading = "Picture")]
pub(crate) struct SizeArgs {
    /// Width and height in pixels [default: the scene's, else 800x600]
    #[arg(long, value_name = "WxH", value_parser = size)]
    pub size: Option<(u32, u32)>,
}

/// Lights that `--light` names, between commas, in options that may be repeated.
pub(crate) fn light_words(options: &[String]) -> Result<Vec<String>, Failure> {
    let words = options.iter().map(|option| words(option)).collect::<Result<Vec<_>, _>>();
    Ok(words.map_err(|error| Failure::Usage(format!("--light: {error}")))?.concat())
}

/// How the machine is used.
#[derive(Args, Clone, Copy, Debug)]
#[command(next_help_heading = "Machine")]
pub(crate) struct MachineArgs {
    /// How many threads draw; the picture does not depend on it [default: all processors]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,
}

impl MachineArgs {
    /// Sets the number of threads for the whole process. Threads start when there is work for them.
    pub(crate) fn apply(self) -> Result<(), Failure> {
        let Some(threads) = self.threads else {
            return Ok(());
        };
        rayon::ThreadPoolBuilder::new()
            .num_threads(usize::from(threads))
            .build_global()
            .map_err(|error| Failure::new(format_args!("cannot start {threads} threads: {error}")))
    }
}
