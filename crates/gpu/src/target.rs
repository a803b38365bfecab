//! What is drawn into, and the way back from it.

use std::sync::mpsc;

use half::f16;

use crate::GpuError;
use crate::device::Device;
use crate::pipeline::DEPTH;

/// Rows of a copied picture begin at multiples of so many bytes.
const ROW: u32 = wgpu::COPY_BYTES_PER_ROW_ALIGNMENT;

/// The picture on the device, and the buffer by which it comes back.
pub(crate) struct Target {
    size: [u32; 2],
    color: wgpu::Texture,
    depth: wgpu::TextureView,
    back: wgpu::Buffer,
    bytes_per_row: u32,
}

impl Target {
    pub(crate) fn new(device: &Device, size: [u32; 2]) -> Self {
        let [width, height] = size;
        let texture = |label, format, usage| {
            device.device.create_texture(&wgpu::TextureDescriptor {
                label: Some(label),
                size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count: 1,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage: wgpu::TextureUsages::RENDER_ATTACHMENT | usage,
                view_formats: &[],
            })
        };
        let bytes_per_row = (pixel_bytes(device.format) * width).next_multiple_of(ROW);
        let depth = texture("depth", DEPTH, wgpu::TextureUsages::empty());
        Self {
            size,
            color: texture("colour", device.format, wgpu::TextureUsages::COPY_SRC),
            depth: depth.create_view(&wgpu::TextureViewDescriptor::default()),
            back: device.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("the way back"),
                size: u64::from(bytes_per_row) * u64::from(height),
                usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
                mapped_at_creation: false,
            }),
            bytes_per_row,
        }
    }

    /// Draws into an empty picture and sends it back.
    pub(crate) fn draw(&self, device: &Device, draw: impl FnOnce(&mut wgpu::RenderPass)) {
        let view = self.color.create_view(&wgpu::TextureViewDescriptor::default());
        let mut encoder = device.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let load = wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT);
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("programs"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &view,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations { load, store: wgpu::StoreOp::Store },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &self.depth,
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(1.0),
                    store: wgpu::StoreOp::Discard,
                }),
                stencil_ops: None,
            }),
            timestamp_writes: None,
            occlusion_query_set: None,
            multiview_mask: None,
        });
        draw(&mut pass);
        drop(pass);
        let [width, height] = self.size;
        let layout = wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(self.bytes_per_row),
            rows_per_image: None,
        };
        encoder.copy_texture_to_buffer(
            self.color.as_image_copy(),
            wgpu::TexelCopyBufferInfo { buffer: &self.back, layout },
            wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        );
        device.queue.submit([encoder.finish()]);
    }

    /// The picture that was drawn: each pixel's colour and whether anything is there, rows from the top.
    pub(crate) fn read(
        &self,
        device: &Device,
        mut pixel: impl FnMut(usize, [f32; 4]),
    ) -> Result<(), GpuError> {
        let (tell, hear) = mpsc::channel();
        self.back.map_async(wgpu::MapMode::Read, .., move |mapped| {
            // Nobody listens any more if the wait below failed.
            let _ = tell.send(mapped);
        });
        let waited = device.device.poll(wgpu::PollType::wait_indefinitely());
        waited.map_err(|error| device.failed(error.to_string()))?;
        let mapped = hear.recv().map_err(|_| device.failed("the picture does not come back"))?;
        mapped.map_err(|error| device.failed(error.to_string()))?;
        let bytes = self.back.get_mapped_range(..).map_err(|error| device.failed(error.to_string()))?;
        let [width, height] = self.size.map(|side| side as usize);
        let size = pixel_bytes(device.format) as usize;
        for (row, line) in bytes.chunks(self.bytes_per_row as usize).enumerate().take(height) {
            // It was drawn upside down.
            let first = (height - 1 - row) * width;
            for (column, bytes) in line.chunks_exact(size).take(width).enumerate() {
                pixel(first + column, numbers(bytes));
            }
        }
        drop(bytes);
        self.back.unmap();
        Ok(())
    }
}

fn pixel_bytes(format: wgpu::TextureFormat) -> u32 {
    if format == wgpu::TextureFormat::Rgba32Float { 16 } else { 8 }
}

/// The four numbers of a pixel, in single or half precision.
fn numbers(bytes: &[u8]) -> [f32; 4] {
    core::array::from_fn(|c| match bytes {
        [_, _, _, _, _, _, _, _] => f16::from_le_bytes([bytes[2 * c], bytes[2 * c + 1]]).to_f32(),
        _ => f32::from_le_bytes(core::array::from_fn(|byte| bytes[4 * c + byte])),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_are_numbers_of_single_or_half_precision() {
        let four = [1.0f32, -0.5, 65504.0, f32::INFINITY];
        let single: Vec<u8> = four.iter().flat_map(|number| number.to_le_bytes()).collect();
        let half: Vec<u8> = four.iter().flat_map(|number| f16::from_f32(*number).to_le_bytes()).collect();
        assert_eq!(numbers(&single), four);
        assert_eq!(numbers(&half), four);
    }
}
