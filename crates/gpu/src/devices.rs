//! Which devices there are, and which one is meant.

use core::fmt;

use crate::GpuError;

/// What kind of device it is, the fastest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum DeviceKind {
    /// A graphics card with its own memory.
    Discrete,
    /// A part of the processor.
    Integrated,
    /// A part of another machine's.
    Virtual,
    /// Unknown.
    Other,
    /// A program on the CPU, like Mesa's llvmpipe.
    Software,
}

impl DeviceKind {
    /// Its name in lower case.
    pub fn name(self) -> &'static str {
        match self {
            Self::Discrete => "discrete",
            Self::Integrated => "integrated",
            Self::Virtual => "virtual",
            Self::Other => "other",
            Self::Software => "software",
        }
    }
}

impl fmt::Display for DeviceKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// A device as its driver describes it.
///
/// ```
/// use glanz_gpu::{DeviceInfo, DeviceKind};
///
/// let info = DeviceInfo {
///     name: "Example 9000".to_owned(),
///     api: "vulkan",
///     kind: DeviceKind::Discrete,
///     driver: String::new(),
///     max_size: 16_384,
/// };
/// assert_eq!(info.to_string(), "Example 9000 (vulkan, discrete)");
/// assert!(info.matches("example VULKAN") && !info.matches("opengl"));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DeviceInfo {
    /// Its name.
    pub name: String,
    /// `vulkan`, `metal`, `dx12` or `opengl`.
    pub api: &'static str,
    /// What kind it is.
    pub kind: DeviceKind,
    /// The driver with its version; empty if it does not tell.
    pub driver: String,
    /// The widest and highest picture.
    pub max_size: u32,
}

impl DeviceInfo {
    pub(crate) fn of(adapter: &wgpu::Adapter) -> Self {
        let info = adapter.get_info();
        let driver = [info.driver, info.driver_info].map(|part| part.trim().to_owned());
        Self {
            name: info.name,
            api: match info.backend {
                wgpu::Backend::Vulkan => "vulkan",
                wgpu::Backend::Metal => "metal",
                wgpu::Backend::Dx12 => "dx12",
                wgpu::Backend::Gl => "opengl",
                wgpu::Backend::BrowserWebGpu => "webgpu",
                wgpu::Backend::Noop => "none",
            },
            kind: match info.device_type {
                wgpu::DeviceType::DiscreteGpu => DeviceKind::Discrete,
                wgpu::DeviceType::IntegratedGpu => DeviceKind::Integrated,
                wgpu::DeviceType::VirtualGpu => DeviceKind::Virtual,
                wgpu::DeviceType::Cpu => DeviceKind::Software,
                wgpu::DeviceType::Other => DeviceKind::Other,
            },
            driver: driver.iter().filter(|part| !part.is_empty()).cloned().collect::<Vec<_>>().join(" "),
            max_size: adapter.limits().max_texture_dimension_2d,
        }
    }

    /// Whether words, in any case, stand in its name, its interface or its driver.
    pub fn matches(&self, words: &str) -> bool {
        let all = format!("{} {} {} {}", self.name, self.api, self.kind, self.driver).to_lowercase();
        words.to_lowercase().split_whitespace().all(|word| all.contains(word))
    }
}

impl fmt::Display for DeviceInfo {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ({}, {})", self.name, self.api, self.kind)
    }
}

/// Which device is to draw.
///
/// ```
/// use glanz_gpu::{Choice, Gpu};
///
/// let error = Gpu::open(&Choice::Named("warp drive".to_owned())).err().expect("there is none");
/// assert!(!error.to_string().is_empty(), "it names those that there are");
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Choice {
    /// The fastest.
    #[default]
    Best,
    /// The fastest that is no program on the CPU.
    Hardware,
    /// The fastest in whose name, interface or driver these words stand.
    Named(String),
}

/// What is asked first; OpenGL answers for the same devices once more.
const FIRST: wgpu::Backends = wgpu::Backends::VULKAN.union(wgpu::Backends::METAL).union(wgpu::Backends::DX12);

/// The adapters of some interfaces, the fastest kinds first, and of those Vulkan before OpenGL.
fn adapters(backends: wgpu::Backends) -> Vec<(wgpu::Adapter, DeviceInfo)> {
    let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
    descriptor.backends = backends;
    let instance = wgpu::Instance::new(descriptor);
    let found = pollster::block_on(instance.enumerate_adapters(backends));
    let mut all: Vec<_> = found
        .into_iter()
        .map(|adapter| {
            let info = DeviceInfo::of(&adapter);
            (adapter, info)
        })
        .collect();
    all.sort_by_key(|(_, info)| (info.kind, info.api == "opengl"));
    all
}

/// The devices of this machine, the fastest first.
///
/// ```
/// for device in glanz_gpu::devices() {
///     println!("{device}: {}", device.driver);
/// }
/// ```
pub fn devices() -> Vec<DeviceInfo> {
    adapters(wgpu::Backends::all()).into_iter().map(|(_, info)| info).collect()
}

pub(crate) fn chosen(choice: &Choice) -> Result<(wgpu::Adapter, DeviceInfo), GpuError> {
    let fits = |info: &DeviceInfo| match choice {
        Choice::Best => true,
        Choice::Hardware => info.kind != DeviceKind::Software,
        Choice::Named(words) => info.matches(words),
    };
    let found = |all: Vec<(wgpu::Adapter, DeviceInfo)>| all.into_iter().find(|(_, info)| fits(info));
    if let Some(found) = found(adapters(FIRST)) {
        return Ok(found);
    }
    let all = adapters(wgpu::Backends::all());
    let known: Vec<String> = all.iter().map(|(_, info)| info.to_string()).collect();
    found(all).ok_or_else(|| match (choice, known.is_empty()) {
        (_, true) => GpuError::None,
        (Choice::Named(words), _) => GpuError::Unknown { words: words.clone(), known: known.join(", ") },
        _ => GpuError::OnlySoftware { known: known.join(", ") },
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_may_stand_anywhere_and_in_any_case() {
        let info = DeviceInfo {
            name: "llvmpipe (LLVM 15.0.6, 256 bits)".to_owned(),
            api: "vulkan",
            kind: DeviceKind::Software,
            driver: "llvmpipe Mesa 22.3.6".to_owned(),
            max_size: 16384,
        };
        for words in ["llvmpipe", "Vulkan", "LLVMPIPE vulkan", "mesa", "software", ""] {
            assert!(info.matches(words), "{words}");
        }
        assert!(!info.matches("llvmpipe opengl"));
        assert_eq!(info.to_string(), "llvmpipe (LLVM 15.0.6, 256 bits) (vulkan, software)");
    }

    #[test]
    fn graphics_cards_come_before_programs() {
        assert!(DeviceKind::Discrete < DeviceKind::Integrated && DeviceKind::Other < DeviceKind::Software);
    }
}
