//! Textures of materials: pictures that are decoded once, as plain as they are or reckoned into what a material asks for.

use std::collections::{HashMap, HashSet};

use glanz_color::read::{Place, ReadError};
use glanz_color::srgb_decode;
use glanz_math::MemoryBudget;

use super::super::context::Context;
use super::container::{decode_percent, load_uri};
use super::json::{self, TextureInfo};
use super::material::uv_set;
use super::source::Source;
use crate::read::texture;
use crate::{ChannelUse, Texture, TextureChannel, TextureFilter, TextureUse, Wrap};

/// The most characters of a texture's name, which every use of its picture carries.
const MAX_NAME: usize = 256;

/// What becomes of the codes of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Reading {
    /// Colours in sRGB.
    Colors,
    /// Numbers.
    Numbers,
    /// Colours in sRGB, to be multiplied by the numbers of these bits; the greatest channel of that as a number in alpha,
    /// in parts of the greatest factor.
    ColorsAndGreatest([u64; 3]),
    /// The alpha of a picture is glossiness, to be multiplied by the number of these bits: green is the roughness, blue full.
    Glossiness(u64),
}

impl Reading {
    /// Colours that are multiplied by these factors, with the greatest channel of the product.
    pub(super) fn greatest_of(factors: [f64; 3]) -> Self {
        Self::ColorsAndGreatest(factors.map(f64::to_bits))
    }
}

/// The textures of a model.
pub(super) struct Textures<'a> {
    source: &'a Source<'a>,
    pub(super) list: Vec<Texture>,
    /// By number in the file and reading.
    known: HashMap<(usize, Reading), usize>,
    /// Numbers in the file of those that cannot be read.
    unreadable: HashSet<usize>,
    /// The first texture here of each image of the file whose codes are those of the image.
    decoded: HashMap<usize, usize>,
    /// The set of texture coordinates that is the material's first.
    pub(super) first_uvs: u32,
    /// What textures may still take.
    memory: MemoryBudget,
}

impl<'a> Textures<'a> {
    pub(super) fn new(source: &'a Source<'a>, memory: MemoryBudget) -> Self {
        let (known, decoded, unreadable) = (HashMap::new(), HashMap::new(), HashSet::new());
        Self { source, list: Vec::new(), known, unreadable, decoded, first_uvs: 0, memory }
    }

    /// One channel of a texture.
    pub(super) fn channel(
        &mut self,
        info: Option<&TextureInfo>,
        channel: TextureChannel,
        path: &str,
        context: &mut Context<'_>,
    ) -> Result<Option<ChannelUse>, ReadError> {
        let map = self.map(info, Reading::Numbers, path, context)?;
        Ok(map.map(|map| ChannelUse { map: TextureUse { scale: 1.0, ..map }, channel }))
    }

    /// The means of the channels of a texture, as numbers, if it can be read.
    pub(super) fn means(
        &mut self,
        info: Option<&TextureInfo>,
        path: &str,
        context: &mut Context<'_>,
    ) -> Result<Option<[f64; 4]>, ReadError> {
        let Some(info) = info else { return Ok(None) };
        let texture = self.texture(info.index, Reading::Numbers, path, context)?;
        Ok(texture.map(|texture| means(&self.list[texture])))
    }

    /// As [`means`](Self::means), of a texture that nothing else takes.
    pub(super) fn means_alone(
        &mut self,
        info: Option<&TextureInfo>,
        path: &str,
        context: &mut Context<'_>,
    ) -> Result<Option<[f64; 4]>, ReadError> {
        let texture = info.and_then(|info| self.source.root.textures.get(info.index).map(|own| (info, own)));
        let Some((info, texture)) = texture else { return self.means(info, path, context) };
        if self.unreadable.contains(&info.index) || self.known.contains_key(&(info.index, Reading::Numbers)) {
            return self.means(Some(info), path, context);
        }
        let memory = self.memory;
        let picture = self.picture(texture, Place::Path(format!("textures[{}]", info.index)), context)?;
        self.memory = memory;
        Ok(picture.map(|(_, picture)| means(&picture)))
    }

    /// A texture and how it is applied, if it can be read.
    pub(super) fn map(
        &mut self,
        info: Option<&TextureInfo>,
        reading: Reading,
        path: &str,
        context: &mut Context<'_>,
    ) -> Result<Option<TextureUse>, ReadError> {
        let Some(info) = info else { return Ok(None) };
        let Some(texture) = self.texture(info.index, reading, path, context)? else { return Ok(None) };
        let second_uvs = uv_set(info) != self.first_uvs;
        let transform = uv_transform(info);
        let scale = info.scale.unwrap_or(1.0) as f32;
        if !transform.as_flattened().iter().chain([&scale]).all(|value| value.is_finite()) {
            let note = "glTF: textures that are placed by no finite numbers lie as if they were not moved";
            context.notes.add_at(note, Place::Path(path.to_owned()));
            return Ok(Some(TextureUse { second_uvs, ..TextureUse::plain(texture) }));
        }
        Ok(Some(TextureUse { texture, transform, scale, second_uvs }))
    }

    /// The number here of a texture of the file; `None` with a remark where it cannot be read.
    fn texture(
        &mut self,
        index: usize,
        reading: Reading,
        path: &str,
        context: &mut Context<'_>,
    ) -> Result<Option<usize>, ReadError> {
        if self.unreadable.contains(&index) {
            return Ok(None);
        }
        if let Some(known) = self.known.get(&(index, reading)) {
            return Ok(Some(*known));
        }
        let source = self.source;
        let texture = source.root.textures.get(index);
        let picture = match texture {
            Some(texture) => self.picture(texture, Place::Path(format!("textures[{index}]")), context)?,
            None => {
                let place = Place::Path(path.to_owned());
                context.notes.add_at("glTF: textures that are not there are left out", place);
                None
            }
        };
        let (Some(texture), Some((image, picture))) = (texture, picture) else {
            self.unreadable.insert(index);
            return Ok(None);
        };
        // A sampler that is not there is as none.
        let sampler = texture.sampler.and_then(|sampler| source.root.samplers.get(sampler));
        let sampler = sampler.copied().unwrap_or_default();
        let wrap = [wrap(sampler.wrap_s), wrap(sampler.wrap_t)];
        const NEAREST: u32 = 9728;
        let filter = match sampler.mag_filter {
            Some(NEAREST) => TextureFilter::Nearest,
            _ => TextureFilter::Trilinear,
        };
        let srgb = matches!(reading, Reading::Colors | Reading::ColorsAndGreatest(_));
        self.list.push(Texture { srgb, wrap, filter, ..reckoned(picture, reading) });
        let number = self.list.len() - 1;
        self.known.insert((index, reading), number);
        if matches!(reading, Reading::Colors | Reading::Numbers) {
            self.decoded.entry(image).or_insert(number);
        }
        Ok(Some(number))
    }

    /// The first picture of a texture that can be read, and its number in the file. It is decoded only once.
    fn picture(
        &mut self,
        texture: &json::Texture,
        user: Place,
        context: &mut Context<'_>,
    ) -> Result<Option<(usize, Texture)>, ReadError> {
        let extensions = &texture.extensions;
        let webp = extensions.webp.as_ref().map(|webp| webp.source);
        for index in [webp, texture.source].into_iter().flatten() {
            if let Some(known) = self.decoded.get(&index).map(|known| &self.list[*known]) {
                texture::spend((known.width, known.height), self.source.file, &user, &mut self.memory)?;
                return Ok(Some((index, known.clone())));
            }
            if let Some(picture) = self.image(index, &user, context)? {
                return Ok(Some((index, picture)));
            }
        }
        if webp.or(texture.source).is_none() {
            let what = if extensions.basisu.is_some() {
                "in KTX2 alone (KHR_texture_basisu)"
            } else {
                "without a picture"
            };
            context.notes.add_at(&format!("glTF: a texture {what} is left out"), user);
        }
        Ok(None)
    }

    fn image(
        &mut self,
        index: usize,
        user: &Place,
        context: &mut Context<'_>,
    ) -> Result<Option<Texture>, ReadError> {
        let source = self.source;
        let Some(image) = source.root.images.get(index) else {
            context.notes.add_at("glTF: pictures that are not there are left out", user.clone());
            return Ok(None);
        };
        let place = Place::Path(format!("images[{index}]"));
        let (loaded, bytes);
        let name = match (&image.uri, image.buffer_view) {
            (Some(uri), _) => {
                loaded = self.load(uri, &place, context);
                let Some(loaded) = &loaded else { return Ok(None) };
                bytes = Ok(&loaded[..]);
                if uri.starts_with("data:") { &image.name } else { uri }
            }
            (None, Some(view)) => {
                bytes = source.buffers.view(source.root, view, source.file).map(|(bytes, _)| bytes);
                &image.name
            }
            (None, None) => {
                context.notes.add_at("glTF: pictures without a uri or a bufferView are left out", place);
                return Ok(None);
            }
        };
        let bytes = match bytes {
            Ok(bytes) => bytes,
            Err(error) => {
                context.notes.add_at(&format!("glTF: a picture is left out ({error})"), place);
                return Ok(None);
            }
        };
        let number = format!("images[{index}]");
        let name = if name.is_empty() { &number } else { name };
        let picture = context.decode_picture(bytes, name, &place, &mut self.memory)?;
        Ok(picture.map(|picture| Texture { name: image.name.chars().take(MAX_NAME).collect(), ..picture }))
    }

    /// The bytes of a picture that a URI holds or names.
    fn load(&self, uri: &str, place: &Place, context: &mut Context<'_>) -> Option<Vec<u8>> {
        if uri.starts_with("data:") || uri.contains("://") {
            return match load_uri(uri, place.clone(), context) {
                Ok(bytes) => Some(bytes),
                Err(error) => {
                    context.notes.add_at(&format!("glTF: a picture is left out ({error})"), place.clone());
                    None
                }
            };
        }
        context.find_picture(&[decode_percent(uri)], place)
    }
}

/// The mean of a picture of colours, in linear light.
pub(super) fn mean_color(picture: &Texture) -> [f64; 3] {
    let mut sums = [0.0; 3];
    for [r, g, b, _] in picture.rgba.as_chunks::<4>().0 {
        for (sum, code) in sums.iter_mut().zip([r, g, b]) {
            *sum += f64::from(srgb_decode(f32::from(*code) / 255.0));
        }
    }
    sums.map(|sum| sum * 4.0 / picture.rgba.len() as f64)
}

/// The means of a picture's channels, as numbers.
fn means(picture: &Texture) -> [f64; 4] {
    let mut sums = [0_u64; 4];
    for texel in picture.rgba.as_chunks::<4>().0 {
        sums.iter_mut().zip(texel).for_each(|(sum, code)| *sum += u64::from(*code));
    }
    sums.map(|sum| sum as f64 * 4.0 / (255.0 * picture.rgba.len() as f64))
}

/// A picture's codes as this reading has them.
fn reckoned(mut picture: Texture, reading: Reading) -> Texture {
    let texels = picture.rgba.as_chunks_mut::<4>().0;
    match reading {
        Reading::Colors | Reading::Numbers => {}
        Reading::ColorsAndGreatest(bits) => {
            let factors = bits.map(|bits| f64::from_bits(bits) as f32);
            let most = factors.into_iter().fold(f32::MIN_POSITIVE, f32::max);
            for [r, g, b, a] in texels {
                let linear = [*r, *g, *b].map(|code| srgb_decode(f32::from(code) / 255.0));
                let products = linear.iter().zip(factors).map(|(channel, factor)| channel * factor / most);
                *a = code(products.fold(0.0, f32::max));
            }
        }
        Reading::Glossiness(bits) => {
            let factor = f64::from_bits(bits) as f32;
            for [_, g, b, a] in texels {
                *g = code(1.0 - factor * f32::from(*a) / 255.0);
                *b = 255;
            }
        }
    }
    picture
}

/// The code of a number from 0 to 1.
fn code(number: f32) -> u8 {
    libm::roundf(number.clamp(0.0, 1.0) * 255.0) as u8
}

fn wrap(code: Option<u32>) -> Wrap {
    const CLAMP_TO_EDGE: u32 = 33071;
    const MIRRORED_REPEAT: u32 = 33648;
    match code {
        Some(CLAMP_TO_EDGE) => Wrap::Clamp,
        Some(MIRRORED_REPEAT) => Wrap::Mirror,
        _ => Wrap::Repeat,
    }
}

/// The affine map of texture coordinates. The extension's prose and example turn the coordinates
/// counter-clockwise as seen with v downwards; its line of GLSL, read by columns, would turn them
/// the other way. We follow the example, as viewers do.
fn uv_transform(info: &TextureInfo) -> [[f32; 3]; 2] {
    let Some(transform) = &info.extensions.transform else { return TextureUse::plain(0).transform };
    let (sin, cos) = libm::sincos(transform.rotation);
    let ([scale_u, scale_v], [offset_u, offset_v]) = (transform.scale, transform.offset);
    [[cos * scale_u, sin * scale_v, offset_u], [-sin * scale_u, cos * scale_v, offset_v]]
        .map(|row| row.map(|value| value as f32))
}
