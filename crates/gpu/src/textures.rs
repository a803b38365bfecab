//! Pictures of programs on the device.

use glanz_render::prepare::{MipLevel, Mipmap};
use glanz_render::view::program::ProgramPicture;
use glanz_scene::{TextureFilter, Wrap};

use crate::device::Device;

/// A picture and how it is looked into.
type Texture = (wgpu::TextureView, wgpu::Sampler);

/// Where a picture lies in memory, 0 for the black that stands for none, and whether it is a cube map.
type Key = (usize, bool);

/// The textures of a frame, each once.
#[derive(Default)]
pub(crate) struct Textures {
    all: Vec<(Key, Texture)>,
}

/// How a texture is bound.
pub(crate) fn dimension(is_cube: bool) -> wgpu::TextureViewDimension {
    if is_cube { wgpu::TextureViewDimension::Cube } else { wgpu::TextureViewDimension::D2 }
}

/// Whether a GPU can be given the picture.
pub(crate) fn is_there(picture: &ProgramPicture) -> bool {
    match picture {
        ProgramPicture::Flat(_) => true,
        ProgramPicture::Cube(faces) => {
            let size = |face: &Mipmap| (face.levels[0].width, face.levels[0].height, face.levels.len());
            faces.iter().all(|face| size(face) == size(faces[0])) && size(faces[0]).0 == size(faces[0]).1
        }
        ProgramPicture::Panorama(_) | ProgramPicture::Environment(_) => false,
    }
}

fn key(picture: Option<ProgramPicture>, is_cube: bool) -> Key {
    let first = match picture {
        Some(ProgramPicture::Flat(mipmap)) => Some(mipmap),
        Some(ProgramPicture::Cube(faces)) => Some(faces[0]),
        _ => None,
    };
    (first.map_or(0, |mipmap| core::ptr::from_ref(mipmap) as usize), is_cube)
}

impl Textures {
    /// Brings a picture to the device, if it is not there.
    pub(crate) fn make(&mut self, device: &Device, picture: Option<ProgramPicture>, is_cube: bool) {
        let key = key(picture, is_cube);
        if self.all.iter().any(|(known, _)| *known == key) {
            return;
        }
        let black = Mipmap {
            levels: vec![MipLevel { width: 1, height: 1, rgba: vec![[0, 0, 0, 255]] }],
            decode: core::array::from_fn(|code| code as f32 / 255.0),
            wrap: [Wrap::Repeat; 2],
            filter: TextureFilter::Nearest,
        };
        let made = match (picture, is_cube) {
            (Some(ProgramPicture::Flat(mipmap)), false) => uploaded(device, &[mipmap], false),
            (Some(ProgramPicture::Cube(faces)), true) => uploaded(device, &faces, true),
            (_, true) => uploaded(device, &[&black; 6], true),
            (_, false) => uploaded(device, &[&black], false),
        };
        self.all.push((key, made));
    }

    /// One that was made.
    pub(crate) fn get(&self, picture: Option<ProgramPicture>, is_cube: bool) -> &Texture {
        let key = key(picture, is_cube);
        let found = self.all.iter().find(|(known, _)| *known == key);
        &found.expect("what is asked for was made").1
    }
}

/// Whether the codes are sRGB's, rather than linear.
fn is_srgb(mipmap: &Mipmap) -> bool {
    mipmap.decode[128] < 0.4
}

fn size(level: &MipLevel, layers: usize) -> wgpu::Extent3d {
    let [width, height] = [level.width, level.height].map(|side| side as u32);
    wgpu::Extent3d { width, height, depth_or_array_layers: layers as u32 }
}

fn uploaded(device: &Device, layers: &[&Mipmap], is_cube: bool) -> Texture {
    let first = layers[0];
    let texture = device.device.create_texture(&wgpu::TextureDescriptor {
        label: Some("picture"),
        size: size(&first.levels[0], layers.len()),
        mip_level_count: first.levels.len() as u32,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: match is_srgb(first) {
            true => wgpu::TextureFormat::Rgba8UnormSrgb,
            false => wgpu::TextureFormat::Rgba8Unorm,
        },
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    });
    for (z, layer) in (0..).zip(layers) {
        for (mip_level, level) in (0..).zip(&layer.levels) {
            let layout = wgpu::TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some(4 * level.width as u32),
                rows_per_image: None,
            };
            let place = wgpu::TexelCopyTextureInfo {
                texture: &texture,
                mip_level,
                origin: wgpu::Origin3d { x: 0, y: 0, z },
                aspect: wgpu::TextureAspect::All,
            };
            device.queue.write_texture(place, level.rgba.as_flattened(), layout, size(level, 1));
        }
    }
    let view = texture.create_view(&wgpu::TextureViewDescriptor {
        dimension: Some(dimension(is_cube)),
        ..Default::default()
    });
    (view, sampler(device, first))
}

fn sampler(device: &Device, mipmap: &Mipmap) -> wgpu::Sampler {
    let address = |wrap: Wrap| match wrap {
        Wrap::Repeat => wgpu::AddressMode::Repeat,
        Wrap::Mirror => wgpu::AddressMode::MirrorRepeat,
        Wrap::Clamp => wgpu::AddressMode::ClampToEdge,
    };
    let is_smooth = mipmap.filter != TextureFilter::Nearest;
    let filter = if is_smooth { wgpu::FilterMode::Linear } else { wgpu::FilterMode::Nearest };
    device.device.create_sampler(&wgpu::SamplerDescriptor {
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
    })
}
