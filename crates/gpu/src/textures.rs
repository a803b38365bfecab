//! Pictures of programs on the device.

use glanz_render::prepare::{MipLevel, Mipmap};
use glanz_scene::{TextureFilter, Wrap};

use crate::device::Device;

/// A picture and how it is looked into.
type Texture = (wgpu::TextureView, wgpu::Sampler);

/// The textures of a frame, each once.
#[derive(Default)]
pub(crate) struct Textures {
    /// By where the picture lies in memory; 0 is the black that stands for none.
    all: Vec<(usize, Texture)>,
}

fn key(mipmap: Option<&Mipmap>) -> usize {
    mipmap.map_or(0, |mipmap| core::ptr::from_ref(mipmap) as usize)
}

impl Textures {
    /// Brings a picture to the device, if it is not there.
    pub(crate) fn make(&mut self, device: &Device, mipmap: Option<&Mipmap>) {
        let key = key(mipmap);
        if self.all.iter().all(|(known, _)| *known != key) {
            let black = MipLevel { width: 1, height: 1, rgba: vec![[0, 0, 0, 255]] };
            let made = match mipmap {
                Some(mipmap) => uploaded(device, &mipmap.levels, is_srgb(mipmap), mipmap),
                None => {
                    let decode = core::array::from_fn(|code| code as f32 / 255.0);
                    let (wrap, filter) = ([Wrap::Repeat; 2], TextureFilter::Nearest);
                    let black = Mipmap { levels: vec![black], decode, wrap, filter };
                    uploaded(device, &black.levels, false, &black)
                }
            };
            self.all.push((key, made));
        }
    }

    /// One that was made.
    pub(crate) fn get(&self, mipmap: Option<&Mipmap>) -> &Texture {
        let key = key(mipmap);
        let found = self.all.iter().find(|(known, _)| *known == key);
        &found.expect("what is asked for was made").1
    }
}

/// Whether the codes are sRGB's, rather than linear.
fn is_srgb(mipmap: &Mipmap) -> bool {
    mipmap.decode[128] < 0.4
}

fn uploaded(device: &Device, levels: &[MipLevel], srgb: bool, mipmap: &Mipmap) -> Texture {
    let size = |level: &MipLevel| wgpu::Extent3d {
        width: level.width as u32,
        height: level.height as u32,
        depth_or_array_layers: 1,
    };
    let texture = device.device.create_texture(&wgpu::TextureDescriptor {
        label: Some("picture"),
        size: size(&levels[0]),
        mip_level_count: levels.len() as u32,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: match srgb {
            true => wgpu::TextureFormat::Rgba8UnormSrgb,
            false => wgpu::TextureFormat::Rgba8Unorm,
        },
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    });
    for (mip_level, level) in (0..).zip(levels) {
        let layout = wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(4 * level.width as u32),
            rows_per_image: None,
        };
        let place = wgpu::TexelCopyTextureInfo {
            texture: &texture,
            mip_level,
            origin: wgpu::Origin3d::ZERO,
            aspect: wgpu::TextureAspect::All,
        };
        device.queue.write_texture(place, level.rgba.as_flattened(), layout, size(level));
    }
    let address = |wrap: Wrap| match wrap {
        Wrap::Repeat => wgpu::AddressMode::Repeat,
        Wrap::Mirror => wgpu::AddressMode::MirrorRepeat,
        Wrap::Clamp => wgpu::AddressMode::ClampToEdge,
    };
    let is_smooth = mipmap.filter != TextureFilter::Nearest;
    let filter = if is_smooth { wgpu::FilterMode::Linear } else { wgpu::FilterMode::Nearest };
    let sampler = device.device.create_sampler(&wgpu::SamplerDescriptor {
        label: Some("how it is filtered"),
        address_mode_u: address(mipmap.wrap[0]),
        address_mode_v: address(mipmap.wrap[1]),
        mag_filter: filter,
        min_filter: filter,
        mipmap_filter: match is_smooth {
            true => wgpu::MipmapFilterMode::Linear,
            false => wgpu::MipmapFilterMode::Nearest,
        },
        // As on the CPU: without filtering the finest level counts.
        lod_max_clamp: if is_smooth { 32.0 } else { 0.0 },
        ..Default::default()
    });
    (texture.create_view(&wgpu::TextureViewDescriptor::default()), sampler)
}
