//! `glanz devices`: what can draw.

use clap::Args;
use schemars::JsonSchema;
use serde::Serialize;

use crate::args::with_runtime_folder;
use crate::print::failure::Failure;
use crate::print::{self, Format, FormatArgs};

/// Shown after the help.
pub(super) const EXAMPLES: &str = "\
Examples:
  glanz devices
  glanz devices --format json
  glanz render scene.toml --fs my.frag --device gpu:vulkan -o out.png";

/// Options of `glanz devices`.
#[derive(Args, Debug)]
pub(crate) struct DevicesArgs {
    #[command(flatten)]
    format: FormatArgs,
}

/// What can draw, the fastest first.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    devices: Vec<DeviceFacts>,
}

/// A device.
#[derive(Debug, Serialize, JsonSchema)]
struct DeviceFacts {
    name: String,
    /// What --device takes: cpu, or words that only this GPU has
    device: String,
    /// vulkan, metal, dx12 or opengl; none of the CPU
    api: Option<&'static str>,
    /// cpu, discrete, integrated, virtual, software or other
    kind: &'static str,
    /// The driver with its version, if it tells
    driver: Option<String>,
    /// What it draws: everything, or programs
    draws: &'static str,
    /// The widest and highest picture in pixels
    max_size: u32,
}

impl DevicesArgs {
    /// Lists them.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        with_runtime_folder();
        let document = Document { devices: facts() };
        match self.format.format {
            Format::Json => print::json(&document),
            Format::Text => print::text(&text(&document)),
        }
    }
}

fn facts() -> Vec<DeviceFacts> {
    let gpus = glanz_gpu::devices();
    let of = |gpu: &glanz_gpu::DeviceInfo| {
        let all = format!("{} {}", gpu.name, gpu.api);
        let words = [gpu.api, &gpu.name, &all];
        let is_unique = |words: &&&str| gpus.iter().filter(|other| other.matches(words)).count() == 1;
        DeviceFacts {
            name: gpu.name.clone(),
            device: match gpus.len() {
                1 => "gpu".to_owned(),
                _ => format!("gpu:{}", words.iter().find(is_unique).unwrap_or(&all.as_str())),
            },
            api: Some(gpu.api),
            kind: gpu.kind.name(),
            driver: Some(gpu.driver.clone()).filter(|driver| !driver.is_empty()),
            draws: "programs",
            max_size: gpu.max_size,
        }
    };
    let cpu = DeviceFacts {
        name: format!("CPU ({})", glanz_math::SimdLevel::best().name()),
        device: "cpu".to_owned(),
        api: None,
        kind: "cpu",
        driver: None,
        draws: "everything",
        max_size: glanz_render::view::MAX_SIZE,
    };
    core::iter::once(cpu).chain(gpus.iter().map(of)).collect()
}

fn text(document: &Document) -> String {
    let mut out = String::new();
    for own in &document.devices {
        let api = own.api.map_or_else(String::new, |api| format!(", {api}, {}", own.kind));
        let driver = own.driver.as_ref().map_or_else(String::new, |driver| format!(", {driver}"));
        out += &format!("{}{api}{driver}\n    --device '{}' draws {}\n", own.name, own.device, own.draws);
    }
    if document.devices.len() == 1 {
        out += "no GPU: neither Vulkan, Metal, DirectX 12 nor OpenGL answers\n";
    }
    out
}
