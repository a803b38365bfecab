//! Why a device does not draw.

use glanz_render::BackendError;
use glanz_shader::ShaderError;

/// Why a device does not draw.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum GpuError {
    /// There is no device.
    #[error(
        "there is no GPU here that a program can use: neither Vulkan, Metal, DirectX 12 nor OpenGL 3.3 answers; --device cpu draws the same"
    )]
    None,
    /// There are only programs on the CPU.
    #[error("there is no GPU here, only programs that play one: {known}")]
    OnlySoftware {
        /// What there is.
        known: String,
    },
    /// No device is called so.
    #[error("no device has '{words}' in its name, interface or driver; there are: {known}")]
    Unknown {
        /// The words.
        words: String,
        /// What there is.
        known: String,
    },
    /// A program cannot be said in WGSL.
    #[error("the GPU cannot run this program: {0}")]
    Program(#[from] ShaderError),
    /// The GPU does not draw such a picture.
    #[error("{what}; --device cpu draws it")]
    Unsupported {
        /// What it does not draw.
        what: String,
    },
    /// The driver refuses, or the device is lost.
    #[error("the device {device} failed: {what}")]
    Failed {
        /// Its name.
        device: String,
        /// What it says.
        what: String,
    },
}

impl GpuError {
    pub(crate) fn unsupported(what: impl Into<String>) -> Self {
        Self::Unsupported { what: what.into() }
    }
}

impl From<GpuError> for BackendError {
    fn from(error: GpuError) -> Self {
        Self::Device { what: error.to_string() }
    }
}
