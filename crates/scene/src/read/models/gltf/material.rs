//! Materials and textures. The mapping is described in the parent module.

use glanz_bsdf::Shape;
use glanz_color::Rgb;
use glanz_color::read::{Place, ReadError, excerpt};

use super::super::context::Context;
use super::super::model::Model;
use super::json::{self, TextureInfo};
use super::layers::{self, Maps};
use super::pbr::{self, Means, PbrMaterial};
use super::source::Source;
use super::textures::{self, Reading, Textures};
use crate::read::notes::Notes;
use crate::{AlphaMode, Lobe, Mask, Material, TextureChannel};

impl Source<'_> {
    /// The sets of texture coordinates that a material uses: that of its first texture, and the next that is another.
    pub(super) fn uv_sets(&self, material: usize) -> [Option<u32>; 2] {
        let Some(material) = self.root.materials.get(material) else { return [Some(0), None] };
        let first = maps(material).next().map_or(0, uv_set);
        [Some(first), maps(material).map(uv_set).find(|set| *set != first)]
    }
}

/// The textures of a material that are applied, the most important first.
fn maps(material: &json::Material) -> impl Iterator<Item = &TextureInfo> {
    let (pbr, more) = (&material.pbr_metallic_roughness, &material.extensions);
    [
        &pbr.base_color_texture,
        &material.normal_texture,
        &pbr.metallic_roughness_texture,
        &material.emissive_texture,
        &material.occlusion_texture,
        &more.clearcoat.clearcoat_texture,
        &more.clearcoat.clearcoat_roughness_texture,
        &more.specular.specular_texture,
        &more.specular.specular_color_texture,
        &more.sheen.sheen_color_texture,
        &more.sheen.sheen_roughness_texture,
        &more.transmission.transmission_texture,
        &more.iridescence.iridescence_texture,
    ]
    .into_iter()
    .chain(more.specular_glossiness.as_ref().map(|old| &old.specular_glossiness_texture))
    .flatten()
}

/// The set that a use of a texture names.
pub(super) fn uv_set(info: &TextureInfo) -> u32 {
    info.extensions.transform.as_ref().and_then(|transform| transform.tex_coord).unwrap_or(info.tex_coord)
}

/// Reads the materials of these numbers, and their textures.
pub(super) fn read(
    source: &Source<'_>,
    used: &[Option<usize>],
    model: &mut Model,
    context: &mut Context<'_>,
) -> Result<(), ReadError> {
    let mut reader = Reader { textures: Textures::new(source, context.options.memory) };
    let standard = json::Material::default();
    for index in used {
        let (json, path) = match index {
            Some(index) => (&source.root.materials[*index], format!("materials[{index}]")),
            None => (&standard, "the default material".to_owned()),
        };
        model.materials.push(reader.material(json, &path, context)?);
    }
    model.textures = reader.textures.list;
    Ok(())
}

struct Reader<'a> {
    textures: Textures<'a>,
}

impl Reader<'_> {
    fn material(
        &mut self,
        json: &json::Material,
        path: &str,
        context: &mut Context<'_>,
    ) -> Result<Material, ReadError> {
        let ([r, g, b, alpha], cutoff) = checked(json, path, &mut context.notes);
        self.textures.first_uvs = maps(json).next().map_or(0, uv_set);
        let mut others = maps(json).map(uv_set).filter(|set| *set != self.textures.first_uvs);
        if let Some(second) = others.next()
            && others.any(|set| set != second)
        {
            context
                .notes
                .add("glTF: all sets of texture coordinates but the first of a material count as its second");
        }
        let pbr = &json.pbr_metallic_roughness;
        let base_color =
            self.textures.map(pbr.base_color_texture.as_ref(), Reading::Colors, path, context)?;
        let mut material = if json.extensions.unlit.is_some() {
            let shape = Shape::named("emission", &[]).expect("the shape exists");
            Material::of_lobes(json.name.clone(), vec![Lobe::new(shape, Rgb([r, g, b])).textured()])
        } else {
            self.lit(json, path, context)?
        };
        material.base_color = base_color;
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

    /// A lit material, but for its base colour's texture.
    fn lit(
        &mut self,
        json: &json::Material,
        path: &str,
        context: &mut Context<'_>,
    ) -> Result<Material, ReadError> {
        let means = self.means(json, path, context)?;
        let mut pbr = pbr::check(json, &means, path, &mut context.notes);
        let maps = self.maps(json, &pbr, path, context)?;
        if json.extensions.specular_glossiness.is_some() {
            context.notes.add("glTF: specular and glossiness are taken as a dielectric of that reflectance");
            if maps.roughness.is_some() {
                // The picture says all of it.
                pbr.roughness = 1.0;
            }
        }
        let mut material = Material::of_lobes(json.name.clone(), layers::lobes(&pbr, &maps));
        material.aniso = json.extensions.anisotropy.anisotropy_rotation + means.grain;
        material.transmittance = layers::transmittance(&pbr);
        let textures = &mut self.textures;
        material.normal_map = textures.map(json.normal_texture.as_ref(), Reading::Numbers, path, context)?;
        material.metal_rough_map = maps.roughness;
        material.emission_map =
            textures.map(json.emissive_texture.as_ref(), Reading::Colors, path, context)?;
        material.occlusion = self.occlusion(json, path, context)?;
        tell(json, &pbr, &maps, context);
        Ok(material)
    }

    /// What the picture of occlusion leaves of ambient light.
    fn occlusion(
        &mut self,
        json: &json::Material,
        path: &str,
        context: &mut Context<'_>,
    ) -> Result<Option<Mask>, ReadError> {
        let info = json.occlusion_texture.as_ref();
        let of = self.textures.channel(info, TextureChannel::Red, path, context)?;
        let strength = info.and_then(|info| info.strength).unwrap_or(1.0);
        if of.is_some() && !(0.0..=1.0).contains(&strength) {
            let place = Place::Path(format!("{path}.occlusionTexture.strength"));
            context
                .notes
                .add_at("glTF: strengths of occlusion beyond 0 to 1 are taken as the nearest", place);
        }
        let strength = if strength.is_nan() { 1.0 } else { strength.clamp(0.0, 1.0) };
        Ok(of.map(|of| Mask { of, from: 1.0 - strength, to: 1.0 }))
    }

    /// What counts by the mean of its texture.
    fn means(
        &mut self,
        json: &json::Material,
        path: &str,
        context: &mut Context<'_>,
    ) -> Result<Means, ReadError> {
        let more = &json.extensions;
        let mut of = |info: &Option<TextureInfo>| self.textures.means(info.as_ref(), path, context);
        let metal = of(&json.pbr_metallic_roughness.metallic_roughness_texture)?.map(|[_, _, blue, _]| blue);
        let transmission = of(&more.transmission.transmission_texture)?.map_or(1.0, |[red, ..]| red);
        let base = match more.transmission.transmission_factor > 0.0 {
            true => of_colors(&mut self.textures, json, path, context)?,
            false => [1.0; 3],
        };
        let mut alone = |info: &Option<TextureInfo>| self.textures.means_alone(info.as_ref(), path, context);
        let thickness = alone(&more.volume.thickness_texture)?.map_or(1.0, |[_, green, ..]| green);
        let film = alone(&more.iridescence.iridescence_thickness_texture)?;
        let film = film.map_or(1.0, |[_, green, ..]| green);
        let grain = alone(&more.anisotropy.anisotropy_texture)?;
        let (anisotropy, grain) = match grain {
            Some([x, y, strength, _]) => (strength, libm::atan2(2.0 * y - 1.0, 2.0 * x - 1.0)),
            None => (1.0, 0.0),
        };
        let sheen = alone(&more.sheen.sheen_roughness_texture)?;
        let sheen_roughness = sheen.map_or(1.0, |[.., alpha]| alpha);
        Ok(Means { metal, base, sheen_roughness, transmission, thickness, film, anisotropy, grain })
    }

    /// The textures that say where the layers of a material are.
    fn maps(
        &mut self,
        json: &json::Material,
        numbers: &PbrMaterial,
        path: &str,
        context: &mut Context<'_>,
    ) -> Result<Maps, ReadError> {
        let (more, textures) = (&json.extensions, &mut self.textures);
        let mut channel = |info: &Option<TextureInfo>, channel: TextureChannel, context: &mut Context<'_>| {
            textures.channel(info.as_ref(), channel, path, context)
        };
        let mut maps = Maps {
            coat: channel(&more.clearcoat.clearcoat_texture, TextureChannel::Red, context)?,
            coat_roughness: channel(
                &more.clearcoat.clearcoat_roughness_texture,
                TextureChannel::Green,
                context,
            )?,
            specular: channel(&more.specular.specular_texture, TextureChannel::Alpha, context)?,
            transmission: channel(&more.transmission.transmission_texture, TextureChannel::Red, context)?,
            iridescence: channel(&more.iridescence.iridescence_texture, TextureChannel::Red, context)?,
            ..Maps::default()
        };
        let (mut f0, mut gloss) = (more.specular.specular_color_texture.as_ref(), None);
        if let Some(old) = &more.specular_glossiness {
            f0 = old.specular_glossiness_texture.as_ref();
            gloss = f0.map(|info| (info, old.glossiness_factor.clamp(0.0, 1.0)));
        }
        maps.f0 = textures.map(f0, Reading::greatest_of(numbers.f0), path, context)?;
        let sheen = more.sheen.sheen_color_texture.as_ref();
        maps.sheen = textures.map(sheen, Reading::greatest_of(numbers.sheen), path, context)?;
        maps.roughness = match gloss {
            Some((info, factor)) => {
                textures.map(Some(info), Reading::Glossiness(factor.to_bits()), path, context)?
            }
            None => {
                let info = json.pbr_metallic_roughness.metallic_roughness_texture.as_ref();
                textures.map(info, Reading::Numbers, path, context)?
            }
        };
        Ok(maps)
    }
}

/// The mean of a base colour's texture in linear light.
fn of_colors(
    textures: &mut Textures<'_>,
    json: &json::Material,
    path: &str,
    context: &mut Context<'_>,
) -> Result<[f64; 3], ReadError> {
    let info = json.pbr_metallic_roughness.base_color_texture.as_ref();
    let map = textures.map(info, Reading::Colors, path, context)?;
    Ok(map.map_or([1.0; 3], |map| textures::mean_color(&textures.list[map.texture])))
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
fn tell(json: &json::Material, pbr: &PbrMaterial, maps: &Maps, context: &mut Context<'_>) {
    let (notes, more) = (&mut context.notes, &json.extensions);
    let by_mean = [
        ("thickness", more.volume.thickness_texture.is_some() && pbr.open() > 0.0),
        ("sheen roughness", more.sheen.sheen_roughness_texture.is_some() && pbr.greatest_sheen() > 0.0),
        ("anisotropy", more.anisotropy.anisotropy_texture.is_some() && pbr.anisotropy > 0.0),
        (
            "thin films' thickness",
            more.iridescence.iridescence_thickness_texture.is_some() && pbr.iridescence > 0.0,
        ),
    ];
    for (name, _) in by_mean.into_iter().filter(|(_, holds)| *holds) {
        notes.add(&format!("glTF: textures of {name} count by their mean"));
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
        (
            open && more.volume.thickness_factor > 0.0,
            "glTF: volumes do not bend light, and are not scaled with their nodes",
        ),
        (open && pbr.roughness > 0.0, "glTF: what is seen through a rough surface is not blurred"),
        (
            open && (has_colors || maps.transmission.is_some() || (varies && pbr.metallic > 0.0)),
            "glTF: textures change the transmittance of a surface by their mean",
        ),
        (
            pbr.coat > 0.0
                && (more.clearcoat.clearcoat_normal_texture.is_some() || json.normal_texture.is_some()),
            "glTF: clear coats have the normals of the surface below",
        ),
        (
            maps.roughness.is_some() && pbr.anisotropy > 0.0,
            "glTF: roughness textures multiply both widths of anisotropic highlights",
        ),
        (glows && pbr.coat > 0.0, "glTF: clear coats do not dim light of the surface itself"),
    ];
    all.into_iter().filter(|(holds, _)| *holds).for_each(|(_, note)| notes.add(note));
}
