//! Programs of users on GPUs: Vulkan, Metal, DirectX 12 and OpenGL by wgpu, without a window.
//!
//! [`Gpu`] is a [`Backend`](glanz_render::Backend): it takes the same arrays, the same uniforms and the same stages as the
//! CPU, as WGSL, and gives a [`Frame`](glanz_render::Frame) of linear numbers. It draws objects that have a program; scenes
//! of materials are the CPU's. [`devices`] lists what there is.

mod device;
mod devices;
mod error;
mod gpu;
mod mesh;
mod pipeline;
mod target;
mod textures;

pub use devices::{Choice, DeviceInfo, DeviceKind, devices};
pub use error::GpuError;
pub use gpu::Gpu;
