//! Materials and textures. The mapping is described in the parent module.

use std::collections::HashMap;

use glanz_bsdf::Shape;
use glanz_color::Rgb;
use glanz_color::read::{Place, ReadError, excerpt};
use glanz_math::MemoryBudget;

use super::super::context::Context;
use super::super::model::Model;
use super::container::{decode_percent, load_uri};
use super::json::{self, TextureInfo};
use super::layers;
use super::pbr::{self, PbrMaterial};
use super::source::Source;
use super::specular_glossiness;
use crate::read::notes::Notes;
use crate::read::texture;
use crate::{AlphaMode, Lobe, Material, Texture, TextureFilter, TextureUse, Wrap};

/// The most characters of a texture's name, which every use of its picture carries.
const MAX_NAME: usize = 256;

impl Source<'_> {
    /// The set of texture coordinates that a material uses: that of its first texture. There is one
    /// set in a mesh.
    pub(super) fn uv_set(&self, material: usize) -> u32 {
        let Some(material) = self.root.materials.get(material) else { return 0 };
        maps(material).next().map_or(0, uv_set)
    }
}

/// The textures of a material that are applied, the most important first.
fn maps(material: &json::Material) -> impl Iterator<Item = &TextureInfo> {
    let pbr = &material.pbr_metallic_roughness;
    let more = [&pbr.metallic_roughness_texture, &material.emissive_texture];
    [&pbr.base_color_texture, &material.normal_texture].into_iter().chain(more).flatten()
}

fn uv_set(info: &TextureInfo) -> u32 {
    info.extensions.transform.as_ref().and_then(|transform| transform.tex_coord).unwrap_or(info.tex_coord)
}

/// Reads the materials of these numbers, and their textures.
pub(super) fn read(
    source: &Source<'_>,
    used: &[Option<usize>],
    model: &mut Model,
    context: &mut Context<'_>,
) -> Result<(), ReadError> {
    let memory = context.options.memory;
    let (known, decoded) = (HashMap::new(), HashMap::new());
    let mut reader = Reader { source, textures: Vec::new(), known, decoded, memory };
    let standard = json::Material::default();
    for index in used {
        let (json, path) = match index {
            Some(index) => (&source.root.materials[*index], format!("materials[{index}]")),
            None => (&standard, "the default material".to_owned()),
        };
        model.materials.push(reader.material(json, &path, context)?);
    }
    model.textures = reader.textures;
    Ok(())
}

struct Reader<'a> {
    source: &'a Source<'a>,
    textures: Vec<Texture>,
    /// By number in the file and whether it is a colour; `None` for those that cannot be read.
    known: HashMap<(usize, bool), Option<usize>>,
    /// The first texture here of each image of the file.
    decoded: HashMap<usize, usize>,
    /// What textures may still take.
    memory: MemoryBudget,
}

impl Reader<'_> {
    fn material(
        &mut self,
        json: &json::Material,
        path: &str,
        context: &mut Context<'_>,
    ) -> Result<Material, ReadError> {
        let ([r, g, b, alpha], cutoff) = checked(json, path, &mut context.notes);
        let unlit = json.extensions.unlit.is_some();
        let mut material = if unlit {
            let shape = Shape::named("emission", &[]).expect("the shape exists");
            Material::of_lobes(json.name.clone(), vec![Lobe::new(shape, Rgb([r, g, b])).textured()])
        } else {
            self.lit(json, path, context)?
        };
        self.textures_of(json, unlit, &mut material, path, context)?;
        material.two_sided = json.double_sided;
        material.cull_back = !json.double_sided;
        material.opacity = alpha.min(1.0);
        material.alpha_mode = match json.alpha_mode.as_deref() {
            None | Some("OPAQUE") => AlphaMode::Opaque,
            Some("MASK") => AlphaMode::Mask { cutoff },
            Some("BLEND") => AlphaMode::Blend,
            Some(other) => {
                let note = format!("glTF: the alphaMode {} is taken as OPAQUE", excerpt(other));
                context.notes.add_at(&note, Place::Path(format!("{path}.alphaMode")));
                AlphaMode::Opaque
            }
        };
        Ok(material)
    }

    /// A lit material, without its textures.
    fn lit(
        &mut self,
        json: &json::Material,
        path: &str,
        context: &mut Context<'_>,
    ) -> Result<Material, ReadError> {
        let metal = self.mean_metal(json, path, context)?;
        let mut pbr = pbr::check(json, metal, path, &mut context.notes);
        if let Some(old) = &json.extensions.specular_glossiness {
            context.notes.add("glTF: specular and glossiness are taken as a dielectric of that reflectance");
            let info = old.specular_glossiness_texture.as_ref();
            if let Some(texture) =
                info.map_or(Ok(None), |info| self.texture(info.index, true, path, context))?
            {
                context.notes.add("glTF: textures of specular and glossiness count by their mean");
                specular_glossiness::apply_mean(&mut pbr, &self.textures[texture]);
            }
        }
        let mut material = Material::of_lobes(json.name.clone(), layers::lobes(&pbr));
        material.aniso = json.extensions.anisotropy.anisotropy_rotation;
        material.transmittance = layers::transmittance(&pbr);
        tell(json, &pbr, context);
        Ok(material)
    }

    fn textures_of(
        &mut self,
        json: &json::Material,
        unlit: bool,
        material: &mut Material,
        path: &str,
        context: &mut Context<'_>,
    ) -> Result<(), ReadError> {
        let pbr = &json.pbr_metallic_roughness;
        material.base_color = self.map(pbr.base_color_texture.as_ref(), true, path, context)?;
        if unlit {
            return Ok(());
        }
        material.normal_map = self.map(json.normal_texture.as_ref(), false, path, context)?;
        let metal_rough = pbr.metallic_roughness_texture.as_ref();
        material.metal_rough_map = self.map(metal_rough, false, path, context)?;
        material.emission_map = self.map(json.emissive_texture.as_ref(), true, path, context)?;
        context
            .notes
            .add_times("glTF: occlusion textures are ignored", u64::from(json.occlusion_texture.is_some()));
        let mut sets = maps(json).map(uv_set);
        let first = sets.next();
        if sets.any(|set| Some(set) != first) {
            context.notes.add("glTF: all textures of a material use the texture coordinates of the first");
        }
        Ok(())
    }

    /// The mean of the texture that says where metal is.
    fn mean_metal(
        &mut self,
        json: &json::Material,
        path: &str,
        context: &mut Context<'_>,
    ) -> Result<Option<f64>, ReadError> {
        let Some(info) = &json.pbr_metallic_roughness.metallic_roughness_texture else { return Ok(None) };
        let Some(texture) = self.texture(info.index, false, path, context)? else { return Ok(None) };
        let rgba = &self.textures[texture].rgba;
        let sum: u64 = rgba.chunks_exact(4).map(|texel| u64::from(texel[2])).sum();
        Ok(Some(sum as f64 * 4.0 / (255.0 * rgba.len() as f64)))
    }

    /// A texture and how it is applied, if it can be read.
    fn map(
        &mut self,
        info: Option<&TextureInfo>,
        srgb: bool,
        path: &str,
        context: &mut Context<'_>,
    ) -> Result<Option<TextureUse>, ReadError> {
        let Some(info) = info else { return Ok(None) };
        let Some(texture) = self.texture(info.index, srgb, path, context)? else { return Ok(None) };
        let transform = uv_transform(info);
        let scale = info.scale.unwrap_or(1.0) as f32;
        if !transform.as_flattened().iter().chain([&scale]).all(|value| value.is_finite()) {
            let note = "glTF: textures that are placed by no finite numbers lie as if they were not moved";
            context.notes.add_at(note, Place::Path(path.to_owned()));
            return Ok(Some(TextureUse::plain(texture)));
        }
        Ok(Some(TextureUse { texture, transform, scale }))
    }

    /// The number here of a texture of the file; `None` with a remark where it cannot be read.
    fn texture(
        &mut self,
        index: usize,
        srgb: bool,
        path: &str,
        context: &mut Context<'_>,
    ) -> Result<Option<usize>, ReadError> {
        if let Some(known) = self.known.get(&(index, srgb)) {
            return Ok(*known);
        }
        if self.known.get(&(index, !srgb)) == Some(&None) {
            return Ok(None);
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
            self.known.insert((index, srgb), None);
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
        self.textures.push(Texture { srgb, wrap, filter, ..picture });
        let number = self.textures.len() - 1;
        self.known.insert((index, srgb), Some(number));
        self.decoded.entry(image).or_insert(number);
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
            if let Some(known) = self.decoded.get(&index).map(|known| &self.textures[*known]) {
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

/// The base colour and the least alpha that is drawn, of lit and unlit materials.
fn checked(json: &json::Material, path: &str, notes: &mut Notes) -> ([f32; 4], f32) {
    let (color, cutoff) = (json.pbr_metallic_roughness.base_color_factor, json.alpha_cutoff.unwrap_or(0.5));
    if !color.iter().chain([&cutoff]).all(|value| (0.0..=1e30).contains(value)) {
        let note = "glTF: base colours and alphaCutoff beyond 0 to 1e30 are taken as the nearest within";
        notes.add_at(note, Place::Path(path.to_owned()));
    }
    let near = |value: f64| value.clamp(0.0, 1e30) as f32;
    (color.map(near), near(cutoff))
}

/// Notes what of a lit material is left out or cannot be had together.
fn tell(json: &json::Material, pbr: &PbrMaterial, context: &mut Context<'_>) {
    let notes = &mut context.notes;
    for name in json.extensions.textures() {
        notes.add(&format!("glTF: {name} textures are ignored, the factors hold everywhere"));
    }
    let has_colors = json.pbr_metallic_roughness.base_color_texture.is_some();
    let (open, iridescent) = (pbr.open() > 0.0, pbr.iridescence > 0.0);
    let varies = pbr.metal_varies;
    let glows = pbr.emission != [0.0; 3];
    let all = [
        (
            iridescent,
            "glTF: thin films are calculated after Airy, over a base of the real index that its reflectance has",
        ),
        (
            iridescent && has_colors && pbr.metallic > 0.0,
            "glTF: base colour textures do not change metals under thin films",
        ),
        (open && json.extensions.volume.thickness_factor > 0.0, "glTF: volumes do not bend light"),
        (
            open && (has_colors || (varies && pbr.metallic > 0.0)),
            "glTF: textures do not change the transmittance of a surface",
        ),
        (varies && pbr.coat > 0.0, "glTF: roughness textures change the clear coat too"),
        (
            varies && pbr.anisotropy > 0.0,
            "glTF: roughness textures multiply both widths of anisotropic highlights",
        ),
        (glows && pbr.coat > 0.0, "glTF: clear coats do not dim light of the surface itself"),
    ];
    all.into_iter().filter(|(holds, _)| *holds).for_each(|(_, note)| notes.add(note));
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
