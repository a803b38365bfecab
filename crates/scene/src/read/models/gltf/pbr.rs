//! What a lit material is made of: its numbers, checked and brought into their ranges.

use glanz_color::read::Place;

use super::json;
use crate::read::notes::Notes;

/// The thickest film in nm whose fringes the wavelengths, 5 nm apart, still show.
const MAX_FILM_NM: f64 = 1e4;

/// The numbers of a material: factors are from 0 to 1.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct PbrMaterial {
    pub base: [f64; 3],
    pub metallic: f64,
    /// Whether a texture says where metal is.
    pub metal_varies: bool,
    /// The mean of that texture, 1 without one.
    pub mean_metal: f64,
    pub roughness: f64,
    pub emission: [f64; 3],
    /// Reflectance of the dielectric at normal incidence.
    pub f0: [f64; 3],
    /// How much of that reflection there is.
    pub specular: f64,
    pub transmission: f64,
    /// The mean of the texture that says where light is transmitted, 1 without one.
    pub mean_transmission: f64,
    /// The mean of the base colour's texture, 1 without one.
    pub mean_base: [f64; 3],
    /// What its volume leaves of light that crosses it.
    pub left: [f64; 3],
    pub coat: f64,
    pub coat_roughness: f64,
    pub sheen: [f64; 3],
    pub sheen_roughness: f64,
    pub anisotropy: f64,
    pub iridescence: f64,
    pub film_ior: f64,
    pub film_nm: f64,
}

impl PbrMaterial {
    /// The greatest reflectance of the dielectric at normal incidence.
    pub(super) fn greatest_f0(&self) -> f64 {
        greatest(self.f0)
    }

    /// The greatest channel of the sheen.
    pub(super) fn greatest_sheen(&self) -> f64 {
        greatest(self.sheen)
    }

    /// How metallic the surface is on the whole.
    pub(super) fn metal_on_the_whole(&self) -> f64 {
        self.metallic * self.mean_metal
    }

    /// The fraction transmitted of the light that enters its boundary.
    pub(super) fn open(&self) -> f64 {
        self.transmission * self.mean_transmission * (1.0 - self.metal_on_the_whole())
    }
}

/// The greatest channel.
pub(super) fn greatest(rgb: [f64; 3]) -> f64 {
    rgb.into_iter().fold(0.0, f64::max)
}

/// The means of textures whose places do not count; 1 where there is no texture.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Means {
    /// None without a texture.
    pub metal: Option<f64>,
    /// In linear light.
    pub base: [f64; 3],
    pub sheen_roughness: f64,
    pub transmission: f64,
    pub thickness: f64,
    pub film: f64,
    pub anisotropy: f64,
    /// The angle of the grain in radians.
    pub grain: f64,
}

/// The numbers of a lit material, brought into their ranges with a remark.
pub(super) fn check(json: &json::Material, means: &Means, path: &str, notes: &mut Notes) -> PbrMaterial {
    let mut numbers = Numbers { path, beyond: 0, notes };
    let (pbr, more) = (&json.pbr_metallic_roughness, &json.extensions);
    let [r, g, b, _] = pbr.base_color_factor;
    let strength = more.emissive.emissive_strength;
    let [strength] = numbers.least("extensions.KHR_materials_emissive_strength", 0.0, [strength]);
    let emission = numbers.least("emissiveFactor", 0.0, json.emissive_factor).map(|c| c * strength);
    let pbr = PbrMaterial {
        base: numbers.factors("pbrMetallicRoughness.baseColorFactor", [r, g, b]),
        metallic: numbers.factor("pbrMetallicRoughness.metallicFactor", pbr.metallic_factor),
        metal_varies: means.metal.is_some(),
        mean_metal: means.metal.unwrap_or(1.0),
        roughness: numbers.factor("pbrMetallicRoughness.roughnessFactor", pbr.roughness_factor),
        emission: numbers.least("emissiveFactor times its strength", 0.0, emission),
        f0: numbers.f0(json),
        specular: numbers.extension("specular", more.specular.specular_factor),
        transmission: numbers.extension("transmission", more.transmission.transmission_factor),
        mean_transmission: means.transmission,
        mean_base: means.base,
        left: numbers.left(json, means.thickness),
        coat: numbers.extension("clearcoat", more.clearcoat.clearcoat_factor),
        coat_roughness: numbers.extension("clearcoat", more.clearcoat.clearcoat_roughness_factor),
        sheen: numbers.factors("extensions.KHR_materials_sheen", more.sheen.sheen_color_factor),
        sheen_roughness: numbers.extension("sheen", more.sheen.sheen_roughness_factor)
            * means.sheen_roughness,
        anisotropy: numbers.extension("anisotropy", more.anisotropy.anisotropy_strength) * means.anisotropy,
        iridescence: numbers.extension("iridescence", more.iridescence.iridescence_factor),
        film_ior: numbers.film_ior(json),
        film_nm: numbers.film_nm(json, means.film),
    };
    let beyond = numbers.beyond;
    notes.add_times("glTF: factors above 1 count as 1", beyond);
    pbr
}

/// The greatest number that is taken: far beyond all that means something, and safe to multiply.
const MAX_NUMBER: f64 = 1e30;

struct Numbers<'a> {
    path: &'a str,
    /// How many factors were above 1.
    beyond: u64,
    notes: &'a mut Notes,
}

impl Numbers<'_> {
    /// The values, each of them the nearest that is at least this and can be multiplied.
    fn least<const N: usize>(&mut self, name: &str, least: f64, values: [f64; N]) -> [f64; N] {
        let fine = values.iter().all(|value| (least..=MAX_NUMBER).contains(value));
        if !fine {
            self.tell(
                name,
                format!("expected numbers from {least} on, found {values:?}: the nearest are taken"),
            );
        }
        values.map(|value| if value > least { value.min(MAX_NUMBER) } else { least })
    }

    /// A remark on a value; of several kinds of a material each is told.
    fn tell(&mut self, name: &str, what: String) {
        let place = Place::Path(format!("{}.{name}", self.path));
        self.notes.add_kind_at(&format!("glTF: {name}"), place, || format!("glTF: {what}"));
    }

    fn factors<const N: usize>(&mut self, name: &str, values: [f64; N]) -> [f64; N] {
        let values = self.least(name, 0.0, values);
        self.beyond += values.iter().filter(|value| **value > 1.0).count() as u64;
        values.map(|value| value.min(1.0))
    }

    fn factor(&mut self, name: &str, value: f64) -> f64 {
        let [value] = self.factors(name, [value]);
        value
    }

    /// A factor of the extension of that name.
    fn extension(&mut self, name: &str, value: f64) -> f64 {
        self.factor(&format!("extensions.KHR_materials_{name}"), value)
    }

    /// ((ior − 1) / (ior + 1))² · specular colour. An index of 0 mirrors everything, as the extension has it for
    /// materials that come from an older model.
    fn f0(&mut self, json: &json::Material) -> [f64; 3] {
        let more = &json.extensions;
        let mut ior = more.ior.ior;
        if ior != 0.0 && !(1.0..=MAX_NUMBER).contains(&ior) {
            let what = format!("expected 0 or an index from 1 on, found {ior}: 1.5 is taken");
            self.tell("extensions.KHR_materials_ior", what);
            ior = 1.5;
        }
        let root = (ior - 1.0) / (ior + 1.0);
        let color = more.specular.specular_color_factor;
        let color = self.least("extensions.KHR_materials_specular", 0.0, color);
        color.map(|channel| (root * root * channel).min(1.0))
    }

    /// Beer and Lambert: colour^(thickness / distance). Of a surface that is drawn on both sides, light passes two
    /// faces.
    fn left(&mut self, json: &json::Material, mean: f64) -> [f64; 3] {
        const NAME: &str = "extensions.KHR_materials_volume";
        let volume = &json.extensions.volume;
        let [thickness] = self.least(NAME, 0.0, [volume.thickness_factor * mean]);
        let color = self.factors(NAME, volume.attenuation_color);
        let Some(distance) = volume.attenuation_distance else { return [1.0; 3] };
        if distance <= 0.0 || distance.is_nan() {
            let what =
                format!("expected an attenuationDistance above 0, found {distance}: nothing is absorbed");
            self.tell(NAME, what);
            return [1.0; 3];
        }
        let faces = if json.double_sided { 2.0 } else { 1.0 };
        color.map(|channel| libm::pow(channel, thickness / (faces * distance)))
    }

    fn film_ior(&mut self, json: &json::Material) -> f64 {
        let ior = json.extensions.iridescence.iridescence_ior;
        let [ior] = self.least("extensions.KHR_materials_iridescence", 1.0, [ior]);
        ior
    }

    /// The thickness of the film, where a texture says how much of its range.
    fn film_nm(&mut self, json: &json::Material, mean: f64) -> f64 {
        let film = &json.extensions.iridescence;
        let range = [film.iridescence_thickness_minimum, film.iridescence_thickness_maximum];
        let [least, most] = self.least("extensions.KHR_materials_iridescence", 0.0, range);
        (least + (most - least) * mean).min(MAX_FILM_NM)
    }
}
