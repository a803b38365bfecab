//! A device that is open.

use std::sync::{Arc, Mutex, PoisonError};

use wgpu::TextureUsages;

use crate::GpuError;
use crate::devices::{Choice, DeviceInfo, chosen};

/// A device with its queue.
pub(crate) struct Device {
    pub(crate) device: wgpu::Device,
    pub(crate) queue: wgpu::Queue,
    pub(crate) info: DeviceInfo,
    /// What pixels are: single precision, or half where a driver draws no other.
    pub(crate) format: wgpu::TextureFormat,
    /// Why it is gone, if it is.
    lost: Arc<Mutex<Option<String>>>,
}

impl Device {
    pub(crate) fn open(choice: &Choice) -> Result<Self, GpuError> {
        let (adapter, info) = chosen(choice)?;
        let draws = |format: wgpu::TextureFormat| {
            let usages = adapter.get_texture_format_features(format).allowed_usages;
            usages.contains(TextureUsages::RENDER_ATTACHMENT | TextureUsages::COPY_SRC)
        };
        let formats = [wgpu::TextureFormat::Rgba32Float, wgpu::TextureFormat::Rgba16Float];
        let failed = |what: String| GpuError::Failed { device: info.to_string(), what };
        let format = formats.into_iter().find(|format| draws(*format));
        let format =
            format.ok_or_else(|| failed("it draws no pixels of floating-point numbers".to_owned()))?;
        let descriptor = wgpu::DeviceDescriptor {
            label: Some("glanz"),
            required_limits: adapter.limits(),
            ..Default::default()
        };
        let (device, queue) = pollster::block_on(adapter.request_device(&descriptor))
            .map_err(|error| failed(error.to_string()))?;
        let lost = Arc::new(Mutex::new(None));
        let told = Arc::clone(&lost);
        device.set_device_lost_callback(move |_, message| {
            *told.lock().unwrap_or_else(PoisonError::into_inner) = Some(message);
        });
        // What no scope catches must not end the program.
        let told = Arc::clone(&lost);
        device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
            *told.lock().unwrap_or_else(PoisonError::into_inner) = Some(error.to_string());
        }));
        Ok(Self { device, queue, info, format, lost })
    }

    pub(crate) fn failed(&self, what: impl Into<String>) -> GpuError {
        GpuError::Failed { device: self.info.to_string(), what: what.into() }
    }

    /// Does some work; what the device says against it is an error.
    pub(crate) fn checked<T>(&self, work: impl FnOnce() -> T) -> Result<T, GpuError> {
        let filters =
            [wgpu::ErrorFilter::Validation, wgpu::ErrorFilter::OutOfMemory, wgpu::ErrorFilter::Internal];
        let scopes = filters.map(|filter| self.device.push_error_scope(filter));
        let done = work();
        let mut first = None;
        for scope in scopes.into_iter().rev() {
            first = first.or(pollster::block_on(scope.pop()));
        }
        if let Some(error) = first {
            return Err(self.failed(in_one_line(&error)));
        }
        match &*self.lost.lock().unwrap_or_else(PoisonError::into_inner) {
            Some(message) => Err(self.failed(format!("it is lost: {message}"))),
            None => Ok(done),
        }
    }

    /// A buffer that holds these bytes.
    pub(crate) fn buffer(&self, label: &str, usage: wgpu::BufferUsages, bytes: &[u8]) -> wgpu::Buffer {
        let size = (bytes.len().max(4) as u64).next_multiple_of(4);
        let usage = usage | wgpu::BufferUsages::COPY_DST;
        let descriptor =
            wgpu::BufferDescriptor { label: Some(label), size, usage, mapped_at_creation: false };
        let buffer = self.device.create_buffer(&descriptor);
        if !bytes.is_empty() {
            self.queue.write_buffer(&buffer, 0, bytes);
        }
        buffer
    }
}

/// The innermost cause, which says most.
fn in_one_line(error: &wgpu::Error) -> String {
    let mut cause: &dyn std::error::Error = error;
    while let Some(next) = cause.source() {
        cause = next;
    }
    cause.to_string().split_whitespace().collect::<Vec<_>>().join(" ")
}
