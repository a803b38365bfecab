//! What draws: the CPU or a GPU.

use std::cell::{Cell, RefCell};

use clap::Args;
use glanz_gpu::{Choice, Gpu};
use glanz_render::Shot;

use crate::print::failure::{Failure, Report};

/// The device.
#[derive(Args, Clone, Debug, Default)]
pub(crate) struct DeviceArgs {
    /// What draws: cpu, gpu (the fastest of `glanz devices`), gpu:WORDS (one with these words in its name, interface or
    /// driver) or auto (a graphics card if there is one that draws the whole scene, else the CPU). GPUs draw shader
    /// programs
    #[arg(long, value_name = "DEVICE", default_value = "cpu", value_parser = device, help_heading = "Program")]
    pub device: Device,
}

/// What draws.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) enum Device {
    /// The CPU.
    #[default]
    Cpu,
    /// A graphics card if it draws the scene, else the CPU.
    Auto,
    /// A GPU.
    Gpu(Choice),
}

fn device(text: &str) -> Result<Device, String> {
    match text.split_once(':').unwrap_or((text, "")) {
        ("cpu", "") => Ok(Device::Cpu),
        ("auto", "") => Ok(Device::Auto),
        ("gpu", "") => Ok(Device::Gpu(Choice::Best)),
        ("gpu", words) => Ok(Device::Gpu(Choice::Named(words.to_owned()))),
        _ => Err("expected cpu, gpu, gpu:WORDS or auto, such as gpu:vulkan".to_owned()),
    }
}

/// Starts the command anew with a folder for what runs, where the system names none: the drivers' libraries complain of
/// that on stderr as if it were an error.
#[cfg(unix)]
pub(crate) fn with_runtime_folder() {
    use std::os::unix::process::CommandExt;

    const NAME: &str = "XDG_RUNTIME_DIR";
    if std::env::var_os(NAME).is_none()
        && let Ok(own) = std::env::current_exe()
    {
        // Returns only if it fails, and then the complaint is all.
        let _ = std::process::Command::new(own)
            .args(std::env::args_os().skip(1))
            .env(NAME, std::env::temp_dir())
            .exec();
    }
}

/// Other systems have no such folder.
#[cfg(not(unix))]
pub(crate) fn with_runtime_folder() {}

impl DeviceArgs {
    /// Before anything is read: sees to what drivers need.
    pub(crate) fn begin(&self) {
        if self.device != Device::Cpu {
            with_runtime_folder();
        }
    }

    /// After all is drawn: drivers do not bear to be left to the end of the process.
    pub(crate) fn end(&self) {
        OPEN.take();
    }

    /// The picture, drawn by the device; and what to tell of that the first time, if it is not the CPU as a matter of course.
    pub(crate) fn apply(&self, shot: Shot) -> Result<(Shot, Option<String>), Failure> {
        let choice = match &self.device {
            Device::Cpu => return Ok((shot, None)),
            Device::Auto => &Choice::Hardware,
            Device::Gpu(choice) => choice,
        };
        let is_first = !TOLD.replace(true);
        let opened = Gpu::check(shot.prepared(), shot.draw_options()).and_then(|()| opened(choice));
        match opened {
            Ok(gpu) => {
                let told = is_first.then(|| format!("drawn by {}", gpu.info()));
                Ok((shot.on(Box::new(gpu)), told))
            }
            Err(error) if self.device == Device::Auto => {
                let why = error.to_string();
                let why = why.trim_end_matches("; --device cpu draws it");
                Ok((shot, is_first.then(|| format!("drawn by the CPU: {why}"))))
            }
            Err(error) => Err(Report::new(format_args!("--device: {error}")).into()),
        }
    }
}

/// The device, which a film opens once.
fn opened(choice: &Choice) -> Result<Gpu, glanz_gpu::GpuError> {
    if let Some(gpu) = OPEN.with_borrow(|open| open.as_ref().map(Gpu::again)) {
        return Ok(gpu);
    }
    let gpu = Gpu::open(choice)?;
    OPEN.set(Some(gpu.again()));
    Ok(gpu)
}

thread_local! {
    /// The device of the pictures before.
    static OPEN: RefCell<Option<Gpu>> = const { RefCell::new(None) };
    /// Whether it was told what draws.
    static TOLD: Cell<bool> = const { Cell::new(false) };
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn devices_have_names() {
        assert_eq!(device("cpu"), Ok(Device::Cpu));
        assert_eq!(device("gpu"), Ok(Device::Gpu(Choice::Best)));
        assert_eq!(
            device("gpu:vulkan llvmpipe"),
            Ok(Device::Gpu(Choice::Named("vulkan llvmpipe".to_owned())))
        );
        for wrong in ["", "GPU", "cpu:1", "cuda", "auto:x"] {
            assert!(device(wrong).unwrap_err().contains("gpu:WORDS"), "{wrong}");
        }
    }
}
