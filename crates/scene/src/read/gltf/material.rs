//! Materials and textures. The mapping is described in the parent module.

use std::collections::HashMap;

use glanz_bsdf::Shape;
use glanz_color::Rgb;

use super::super::{Context, Model, Place, ReadError, texture};
use super::Source;
use super::container::load_uri;
use super::json::{self, TextureInfo};
use crate::{AlphaMode, Lobe, Material, Texture, TextureFilter, TextureUse, Wrap};

/// Reflectance of dielectrics at normal incidence, for an index of refraction of 1.5.
const DIELECTRIC: f64 = 0.04;
/// The greatest exponent that the shapes take.
const MAX_SHININESS: f64 = 1e5;

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
    let base = &material.pbr_metallic_roughness.base_color_texture;
    [base, &material.normal_texture, &material.emissive_texture].into_iter().flatten()
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
    let left = context.options.max_texture_bytes;
    let (known, decoded) = (HashMap::new(), HashMap::new());
    let mut reader = Reader { source, textures: Vec::new(), known, decoded, left };
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
    /// By number in the file and whether it is a colour.
    known: HashMap<(usize, bool), usize>,
    /// The first texture here of each image of the file.
    decoded: HashMap<usize, usize>,
    /// Bytes that textures may still take.
    left: u64,
}

impl Reader<'_> {
    fn material(
        &mut self,
        json: &json::Material,
        path: &str,
        context: &mut Context<'_>,
    ) -> Result<Material, ReadError> {
        let pbr = &json.pbr_metallic_roughness;
        let finite = |name: &str, values: &[f64]| match values.iter().all(|v| (0.0..=1e30).contains(v)) {
            true => Ok(()),
            false => {
                let place = Place::Path(format!("{path}.{name}"));
                Err(self.source.malformed(place, "numbers from 0 on", format!("{values:?}")))
            }
        };
        finite("pbrMetallicRoughness.baseColorFactor", &pbr.base_color_factor)?;
        finite("pbrMetallicRoughness.metallicFactor", &[pbr.metallic_factor])?;
        finite("pbrMetallicRoughness.roughnessFactor", &[pbr.roughness_factor])?;
        finite("emissiveFactor", &json.emissive_factor)?;
        let strength = json.extensions.emissive.as_ref().and_then(|e| e.emissive_strength).unwrap_or(1.0);
        finite("extensions.KHR_materials_emissive_strength", &[strength])?;
        finite("alphaCutoff", &[json.alpha_cutoff.unwrap_or(0.5)])?;
        let unlit = json.extensions.unlit.is_some();
        let lobes = if unlit {
            let [r, g, b, _] = pbr.base_color_factor;
            vec![lobe("emission", &[], [r, g, b], true)]
        } else {
            context.notes.add("glTF: metallic-roughness is mapped to the nearest classic material");
            let [metallic, roughness] = self.metallic_roughness(json, path, context)?;
            lobes(json, metallic, roughness, strength)
        };
        let mut material = Material::of_lobes(json.name.clone(), lobes);
        self.textures_of(json, unlit, &mut material, path, context)?;
        material.two_sided = json.double_sided;
        material.cull_back = !json.double_sided;
        material.alpha = pbr.base_color_factor[3].min(1.0) as f32;
        material.alpha_mode = match json.alpha_mode.as_deref() {
            None | Some("OPAQUE") => AlphaMode::Opaque,
            Some("MASK") => AlphaMode::Mask { cutoff: json.alpha_cutoff.unwrap_or(0.5) as f32 },
            Some("BLEND") => AlphaMode::Blend,
            Some(other) => {
                let place = Place::Path(format!("{path}.alphaMode"));
                let found = super::super::error::excerpt(other.as_bytes());
                return Err(self.source.malformed(place, "OPAQUE, MASK or BLEND", found));
            }
        };
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
        let base = &json.pbr_metallic_roughness.base_color_texture;
        material.base_color = self.map(base.as_ref(), true, path, context)?;
        if unlit {
            return Ok(());
        }
        material.normal_map = self.map(json.normal_texture.as_ref(), false, path, context)?;
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

    /// Metallic and roughness: the factors times the mean of the texture.
    fn metallic_roughness(
        &mut self,
        json: &json::Material,
        path: &str,
        context: &mut Context<'_>,
    ) -> Result<[f64; 2], ReadError> {
        let pbr = &json.pbr_metallic_roughness;
        let mut mean = [1.0; 2];
        if let Some(info) = &pbr.metallic_roughness_texture {
            context.notes.add("glTF: metallic-roughness textures count by their mean");
            let texture = self.texture(info.index, false, path, context)?;
            let rgba = &self.textures[texture].rgba;
            let sum = rgba
                .chunks_exact(4)
                .fold([0u64; 2], |sum, texel| [sum[0] + u64::from(texel[2]), sum[1] + u64::from(texel[1])]);
            mean = sum.map(|sum| sum as f64 * 4.0 / (255.0 * rgba.len() as f64));
        }
        Ok([(pbr.metallic_factor * mean[0]).min(1.0), (pbr.roughness_factor * mean[1]).min(1.0)])
    }

    /// A texture and how it is applied.
    fn map(
        &mut self,
        info: Option<&TextureInfo>,
        srgb: bool,
        path: &str,
        context: &Context<'_>,
    ) -> Result<Option<TextureUse>, ReadError> {
        let Some(info) = info else { return Ok(None) };
        let texture = self.texture(info.index, srgb, path, context)?;
        let transform = uv_transform(info);
        let scale = info.scale.unwrap_or(1.0) as f32;
        if !transform.as_flattened().iter().chain([&scale]).all(|value| value.is_finite()) {
            let place = Place::Path(format!("{path}.KHR_texture_transform"));
            return Err(self.source.malformed(place, "finite numbers", "others"));
        }
        Ok(Some(TextureUse { texture, transform, scale }))
    }

    /// The number here of a texture of the file.
    fn texture(
        &mut self,
        index: usize,
        srgb: bool,
        path: &str,
        context: &Context<'_>,
    ) -> Result<usize, ReadError> {
        if let Some(known) = self.known.get(&(index, srgb)) {
            return Ok(*known);
        }
        let source = self.source;
        let textures = &source.root.textures;
        let texture = textures.get(index).ok_or_else(|| {
            let expected = format!("one of {} textures", textures.len());
            source.malformed(Place::Path(path.to_owned()), expected, format!("texture {index}"))
        })?;
        let place = || Place::Path(format!("textures[{index}]"));
        let image =
            texture.source.ok_or_else(|| source.malformed(place(), "a source in PNG or JPEG", "none"))?;
        let picture = self.picture(image, place(), context)?;
        let sampler = match texture.sampler {
            Some(sampler) => *source.root.samplers.get(sampler).ok_or_else(|| {
                let expected = format!("one of {} samplers", source.root.samplers.len());
                source.malformed(place(), expected, format!("sampler {sampler}"))
            })?,
            None => json::Sampler::default(),
        };
        let wrap = [wrap(sampler.wrap_s), wrap(sampler.wrap_t)];
        const NEAREST: u32 = 9728;
        let filter = match sampler.mag_filter {
            Some(NEAREST) => TextureFilter::Nearest,
            _ => TextureFilter::Trilinear,
        };
        self.textures.push(Texture { srgb, wrap, filter, ..picture });
        let number = self.textures.len() - 1;
        self.known.insert((index, srgb), number);
        self.decoded.entry(image).or_insert(number);
        Ok(number)
    }

    /// The picture of an image of the file, which is decoded only once.
    fn picture(&mut self, index: usize, user: Place, context: &Context<'_>) -> Result<Texture, ReadError> {
        let Some(known) = self.decoded.get(&index).map(|known| &self.textures[*known]) else {
            return self.image(index, user, context);
        };
        let size = known.rgba.len() as u64;
        texture::spend(size, self.source.file, &user, context.options, &mut self.left)?;
        Ok(known.clone())
    }

    fn image(&mut self, index: usize, user: Place, context: &Context<'_>) -> Result<Texture, ReadError> {
        let source = self.source;
        let images = &source.root.images;
        let image = images.get(index).ok_or_else(|| {
            source.malformed(user, format!("one of {} images", images.len()), format!("image {index}"))
        })?;
        let place = Place::Path(format!("images[{index}]"));
        let loaded;
        let bytes = match (&image.uri, image.buffer_view) {
            (Some(uri), _) => {
                loaded = load_uri(uri, place.clone(), context)?;
                &loaded[..]
            }
            (None, Some(view)) => source.buffers.view(source.root, view, source.file)?.0,
            (None, None) => return Err(source.malformed(place, "a uri or a bufferView", "neither")),
        };
        let picture = texture::decode(bytes, source.file, place, context.options, &mut self.left)?;
        Ok(Texture { name: image.name.chars().take(MAX_NAME).collect(), ..picture })
    }
}

fn lobe(shape: &str, params: &[(&str, f64)], tint: [f64; 3], textured: bool) -> Lobe {
    let shape = Shape::named(shape, params).expect("the shape exists and its exponent is within range");
    Lobe { textured, ..Lobe::new(shape, Rgb(tint.map(|channel| channel as f32))) }
}

/// The lobes of a lit material; those whose tint is black are left out.
fn lobes(json: &json::Material, metallic: f64, roughness: f64, strength: f64) -> Vec<Lobe> {
    let [r, g, b, _] = json.pbr_metallic_roughness.base_color_factor;
    let base = [r, g, b];
    let diffuse = base.map(|channel| channel * (1.0 - metallic));
    let specular = base.map(|channel| DIELECTRIC * (1.0 - metallic) + channel * metallic);
    let alpha = roughness * roughness;
    let shininess = (2.0 / (alpha * alpha) - 2.0).clamp(0.0, MAX_SHININESS);
    let emission = json.emissive_factor.map(|channel| channel * strength);
    let lobes = [
        lobe("ambient", &[], diffuse, true),
        lobe("lambert", &[], diffuse, true),
        // The colour of metals is in their highlight.
        lobe("blinn-phong-normalized", &[("shininess", shininess)], specular, metallic > 0.5),
        lobe("emission", &[], emission, false),
    ];
    lobes.into_iter().filter(|lobe| !lobe.tint.is_black()).collect()
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
