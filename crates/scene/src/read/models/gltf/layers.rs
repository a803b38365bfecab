//! The lobes of a lit material: dielectric and metal, under a sheen, under a clear coat. The parent module says
//! which formula is whose.

use std::sync::Arc;

use glanz_bsdf::models::charlie::Albedo;
use glanz_bsdf::models::ggx::LEAST_ALPHA;
use glanz_bsdf::terms::fresnel_film;
use glanz_bsdf::{Angle, Chebyshev, LayerWeight, Shape};
use glanz_color::{Ior, Rgb, Spectrum, lambda_nm, rgb_spectra};

use super::pbr::{PbrMaterial, greatest};
use crate::{
    ChannelUse, Film, Lobe, Mask, Metalness, Pane, RoughnessMap, TextureChannel, TextureUse, Tint,
    Transmittance,
};

/// Reflectance of the clear coat at normal incidence: its index is 1.5.
const COAT_F0: f64 = 0.04;

/// The greatest reflectance that a film's base may have: 1 would be an infinite index.
const MAX_BASE: f64 = 0.9999;

/// Terms of the series for what a film leaves to the light below, whose greatest channel has kinks.
const FILM_TERMS: usize = 32;

/// The least index of a pane: in one of index 1 grazing light would never reach the other side.
const LEAST_PANE: f64 = 1.001;

/// The least transmittance of a channel: darker is as good as black.
const LEAST_SEEN: f64 = 1e-6;

/// The textures that say where the layers of a material are, and what they are like.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Maps {
    /// Of metal and roughness.
    pub roughness: Option<TextureUse>,
    /// How much of the boundary's reflection there is.
    pub specular: Option<ChannelUse>,
    /// The colour of what the boundary reflects at normal incidence; its greatest channel in alpha.
    pub f0: Option<TextureUse>,
    pub transmission: Option<ChannelUse>,
    pub iridescence: Option<ChannelUse>,
    /// Its colour; its greatest channel in alpha.
    pub sheen: Option<TextureUse>,
    pub coat: Option<ChannelUse>,
    pub coat_roughness: Option<ChannelUse>,
}

impl Maps {
    /// The roughness of a layer above: the texture of metal and roughness has no say in it.
    fn above(&self, own: Option<ChannelUse>) -> RoughnessMap {
        match own {
            Some(own) => RoughnessMap::Own(own),
            None if self.roughness.is_some() => RoughnessMap::Uniform,
            None => RoughnessMap::Material,
        }
    }
}

/// The lobes of a material; those whose tint is black are left out.
pub(super) fn lobes(pbr: &PbrMaterial, maps: &Maps) -> Vec<Lobe> {
    let mut layers = dielectric(pbr, maps);
    layers.extend(metal(pbr, maps));
    if pbr.greatest_sheen() > 0.0 {
        let alpha = pbr.sheen_roughness * pbr.sheen_roughness;
        let alpha = alpha.max(LEAST_ALPHA);
        let layer = LayerWeight::Sheen { strength: pbr.greatest_sheen(), albedo: Albedo::new(alpha) };
        layers = under(layers, &layer, maps.sheen.map(greatest_of));
        let roughness = maps.above(None);
        let charlie = shape("charlie", &[("alpha", alpha)]);
        layers.extend(colored(&charlie, pbr.sheen, maps.sheen).map(|lobe| Lobe { roughness, ..lobe }));
    }
    if pbr.coat > 0.0 {
        let layer = |at_zero, at_grazing| LayerWeight::Schlick { angle: Angle::View, at_zero, at_grazing };
        let below = layer(1.0 - pbr.coat * COAT_F0, 1.0 - pbr.coat);
        layers = under(layers, &below, maps.coat);
        let alpha = width(pbr.coat_roughness);
        let gloss = shape("ggx", &[("alpha", alpha), ("multiscatter", 0.0)]);
        let coat = Lobe::new(gloss, Rgb::WHITE).under(layer(pbr.coat * COAT_F0, pbr.coat));
        let roughness = maps.above(maps.coat_roughness);
        layers.push(Lobe { roughness, masks: maps.coat.map(Mask::of).into_iter().collect(), ..coat });
    }
    // Metal has no matte part that ambient light could meet.
    let (matte, metalness) = match (pbr.metallic, pbr.metal_varies) {
        (0.0, _) => (1.0, Metalness::Any),
        (factor, false) => (1.0 - factor, Metalness::Any),
        (factor, true) => (1.0, Metalness::Dielectric { factor }),
    };
    let ambient = pbr.base.map(|channel| channel * (1.0 - pbr.open()) * matte);
    let ambient = Lobe::new(shape("ambient", &[]), rgb(ambient)).textured();
    let mut all = vec![Lobe { metalness, ..ambient }];
    all.extend(layers);
    all.push(Lobe::new(shape("emission", &[]), rgb(pbr.emission)));
    all.retain(|lobe| !lobe.tint.is_black());
    all
}

/// Lobes under a layer that a texture may say the place of: each as it is where the layer is not, and below it where it is.
fn under(lobes: Vec<Lobe>, layer: &LayerWeight, place: Option<ChannelUse>) -> Vec<Lobe> {
    let Some(of) = place else {
        return lobes.into_iter().map(|lobe| lobe.under(layer.clone())).collect();
    };
    let both = |lobe: Lobe| {
        [lobe.clone().masked(Mask { of, from: 1.0, to: 0.0 }), lobe.under(layer.clone()).masked(Mask::of(of))]
    };
    lobes.into_iter().flat_map(both).collect()
}

/// A shape of this colour, which a texture may multiply: then one lobe for each of its channels.
fn colored(shape: &Shape, color: [f64; 3], map: Option<TextureUse>) -> impl Iterator<Item = Lobe> {
    let channels = [TextureChannel::Red, TextureChannel::Green, TextureChannel::Blue];
    let of_channel = |number: usize, map: TextureUse| {
        let mut tint = [0.0; 3];
        tint[number] = color[number];
        Lobe::new(shape.clone(), rgb(tint)).masked(Mask::of(ChannelUse { map, channel: channels[number] }))
    };
    let lobes = match map {
        None => vec![Lobe::new(shape.clone(), rgb(color))],
        Some(map) => (0..3).map(|number| of_channel(number, map)).collect(),
    };
    lobes.into_iter().filter(|lobe| !lobe.tint.is_black())
}

/// The channel with the greatest of a colour's.
fn greatest_of(map: TextureUse) -> ChannelUse {
    ChannelUse { map, channel: TextureChannel::Alpha }
}

/// The transmittance of the surface: a pane whose two sides together reflect at normal incidence what the one
/// boundary of glTF does, coloured as all that light passes there.
pub(super) fn transmittance(pbr: &PbrMaterial) -> Option<Transmittance> {
    if pbr.open() <= 0.0 {
        return None;
    }
    let sheen = match pbr.greatest_sheen() {
        0.0 => 1.0,
        strength => {
            let alpha = pbr.sheen_roughness * pbr.sheen_roughness;
            (1.0 - strength * Albedo::new(alpha).at(1.0_f64)).max(0.0)
        }
    };
    let open = pbr.open() * sheen * (1.0 - pbr.coat * COAT_F0);
    let seen: [f64; 3] = core::array::from_fn(|c| open * pbr.base[c] * pbr.mean_base[c] * pbr.left[c]);
    let both_sides = pbr.specular * pbr.greatest_f0();
    let absorption = rgb_spectra::spectrum_of_reflectance(rgb(seen))
        .map(|weight| -libm::log(weight.clamp(LEAST_SEEN, 1.0)));
    let ior = Ior::constant(index(both_sides / (2.0 - both_sides)).max(LEAST_PANE));
    Some(Transmittance::Pane(Arc::new(Pane { ior, thickness: 1.0, absorption })))
}

fn dielectric(pbr: &PbrMaterial, maps: &Maps) -> Vec<Lobe> {
    let metalness = match (pbr.metallic, pbr.metal_varies) {
        (0.0, _) => Metalness::Any,
        (1.0, false) => return Vec::new(),
        (factor, _) => Metalness::Dielectric { factor },
    };
    let (bare, under_film) = parts(pbr, maps);
    let film = film(pbr, pbr.f0);
    let mut lobes = Vec::new();
    for (lobe, angle) in below(pbr, maps) {
        bare.push(&mut lobes, under_boundary(lobe.clone(), angle, pbr, maps));
        if let Some(film) = &film {
            let left = Chebyshev::interpolate(FILM_TERMS, |cosine| 1.0 - greatest_of_film(film, cosine));
            under_film.push(&mut lobes, vec![lobe.under(LayerWeight::Series { angle, factor: left })]);
        }
    }
    let gloss = gloss(pbr);
    let mut reflected = boundary(&gloss, pbr.f0.map(|f0| f0 * pbr.specular), pbr.specular, false, maps.f0);
    if let Some(specular) = maps.specular {
        reflected.iter_mut().for_each(|lobe| lobe.masks.push(Mask::of(specular)));
    }
    bare.push(&mut lobes, reflected);
    under_film.push(&mut lobes, film.map(|film| Lobe::new(gloss, Tint::Film(film))).into_iter().collect());
    lobes.iter_mut().for_each(|lobe| lobe.metalness = metalness);
    lobes
}

/// What lies below the boundary of the dielectric, less what that reflects by the angle in Schlick's form: it is linear in
/// how much of it there is, and in its greatest reflectance at normal incidence, so textures of both choose between lobes.
fn under_boundary(lobe: Lobe, angle: Angle, pbr: &PbrMaterial, maps: &Maps) -> Vec<Lobe> {
    let layer = |f0: f64| LayerWeight::Schlick {
        angle,
        at_zero: 1.0 - pbr.specular * f0,
        at_grazing: 1.0 - pbr.specular,
    };
    let mut lobes = match maps.f0.map(greatest_of) {
        None => vec![lobe.clone().under(layer(pbr.greatest_f0()))],
        Some(of) => vec![
            lobe.clone().under(layer(0.0)).masked(Mask { of, from: 1.0, to: 0.0 }),
            lobe.clone().under(layer(pbr.greatest_f0())).masked(Mask::of(of)),
        ],
    };
    if let Some(of) = maps.specular {
        lobes.iter_mut().for_each(|lobe| lobe.masks.push(Mask::of(of)));
        lobes.insert(0, lobe.masked(Mask { of, from: 1.0, to: 0.0 }));
    }
    lobes
}

fn metal(pbr: &PbrMaterial, maps: &Maps) -> Vec<Lobe> {
    let metalness = match (pbr.metallic, pbr.metal_varies) {
        (0.0, _) => return Vec::new(),
        (1.0, false) => Metalness::Any,
        (factor, _) => Metalness::Metal { factor },
    };
    let gloss = gloss(pbr);
    let (bare, under_film) = parts(pbr, maps);
    let mut lobes = Vec::new();
    bare.push(&mut lobes, boundary(&gloss, pbr.base, 1.0, true, None));
    let film = film(pbr, pbr.base);
    under_film.push(&mut lobes, film.map(|film| Lobe::new(gloss, Tint::Film(film))).into_iter().collect());
    lobes.iter_mut().for_each(|lobe| lobe.metalness = metalness);
    lobes
}

/// What lies below the boundary of the dielectric, with the angle by which light passes it.
fn below(pbr: &PbrMaterial, maps: &Maps) -> Vec<(Lobe, Angle)> {
    let (open, mask) = match maps.transmission {
        // With a texture both are as if they were alone.
        Some(of) => ([1.0, 1.0], Some(of)),
        None => ([1.0 - pbr.transmission, pbr.transmission], None),
    };
    let back = pbr.base.map(|channel| channel * open[0]);
    let on = core::array::from_fn(|c| pbr.base[c] * open[1] * pbr.left[c]);
    let sheet = shape("ggx-thin-transmission", &[("alpha", width(pbr.roughness))]);
    let mut back = Lobe::new(shape("lambert", &[]), rgb(back)).textured();
    let mut on = Lobe::new(sheet, rgb(on)).textured();
    if let Some(of) = mask {
        back.masks.push(Mask { of, from: 1.0, to: 1.0 - pbr.transmission });
        on.masks.push(Mask { of, from: 0.0, to: pbr.transmission });
    }
    let all = [(back, Angle::Half), (on, Angle::HalfThrough)];
    all.into_iter().filter(|(lobe, _)| !lobe.tint.is_black()).collect()
}

/// A gloss times f0 + (f90 − f0)(1 − cosθ)⁵ in Schlick's form: one lobe where that has no colour, else one for the
/// colour at normal incidence, which textures may multiply, and one for the rest.
fn boundary(gloss: &Shape, f0: [f64; 3], f90: f64, textured: bool, map: Option<TextureUse>) -> Vec<Lobe> {
    let layer = |at_zero, at_grazing| LayerWeight::Schlick { angle: Angle::Half, at_zero, at_grazing };
    if !textured && map.is_none() && f0[0] == f0[1] && f0[1] == f0[2] {
        return vec![Lobe::new(gloss.clone(), Rgb::WHITE).under(layer(f0[0], f90))];
    }
    let at_normal = colored(gloss, f0, map).map(|lobe| Lobe { textured, ..lobe }.under(layer(1.0, 0.0)));
    at_normal.chain([Lobe::new(gloss.clone(), Rgb::WHITE).under(layer(0.0, f90))]).collect()
}

/// A part of a surface: everywhere the same, or where a texture says.
struct Part {
    weight: f64,
    mask: Option<Mask>,
}

/// The bare part of a surface, and that under a thin film.
fn parts(pbr: &PbrMaterial, maps: &Maps) -> (Part, Part) {
    let strength = pbr.iridescence;
    match maps.iridescence {
        Some(of) if strength > 0.0 => {
            let mask = |from, to| Part { weight: 1.0, mask: Some(Mask { of, from, to }) };
            (mask(1.0, 1.0 - strength), mask(0.0, strength))
        }
        _ => (Part { weight: 1.0 - strength, mask: None }, Part { weight: strength, mask: None }),
    }
}

impl Part {
    /// Adds lobes with the weight of this part, if that is not 0.
    fn push(&self, lobes: &mut Vec<Lobe>, more: Vec<Lobe>) {
        if self.weight <= 0.0 {
            return;
        }
        for mut lobe in more.into_iter().filter(|lobe| !lobe.tint.is_black()) {
            if self.weight < 1.0 {
                lobe.layers.push(LayerWeight::Constant(self.weight));
            }
            lobe.masks.extend(self.mask);
            lobes.push(lobe);
        }
    }
}

/// The film over a base of this reflectance at normal incidence, if there is one.
fn film(pbr: &PbrMaterial, base: [f64; 3]) -> Option<Arc<Film>> {
    let base = || {
        let eta = rgb_spectra::spectrum_of_reflectance(rgb(base)).map(index);
        let (name, source) = (format!("{:.3}", index(greatest(base))), "from a reflectance".to_owned());
        Ior { name, eta, k: Spectrum::ZERO, source }
    };
    let film = |base| Film { thickness_nm: pbr.film_nm, film: Ior::constant(pbr.film_ior), base };
    (pbr.iridescence > 0.0).then(|| Arc::new(film(base())))
}

/// The greatest channel of what a film reflects.
fn greatest_of_film(film: &Film, cosine: f64) -> f64 {
    let reflected = Spectrum(core::array::from_fn(|i| {
        let base = (film.base.eta[i], film.base.k[i]);
        fresnel_film(cosine, lambda_nm(i), film.film.eta[i], film.thickness_nm, base)
    }));
    rgb_spectra::rgb_of_reflectance(&reflected).into_iter().fold(0.0, f64::max).min(1.0)
}

/// The real index whose boundary to air has this reflectance at normal incidence.
fn index(f0: f64) -> f64 {
    let root = libm::sqrt(f0.clamp(0.0, MAX_BASE));
    (1.0 + root) / (1.0 - root)
}

/// The reflecting shape: the direction of the tangent is rougher where the material is anisotropic.
fn gloss(pbr: &PbrMaterial) -> Shape {
    let (across, strength) = (pbr.roughness * pbr.roughness, pbr.anisotropy * pbr.anisotropy);
    let along = across * (1.0 - strength) + strength;
    let across = if pbr.anisotropy > 0.0 { across.max(LEAST_ALPHA) } else { 0.0 };
    shape("ggx", &[("alpha", along.max(LEAST_ALPHA)), ("alpha_y", across), ("multiscatter", 0.0)])
}

fn width(roughness: f64) -> f64 {
    (roughness * roughness).max(LEAST_ALPHA)
}

fn shape(name: &str, params: &[(&str, f64)]) -> Shape {
    Shape::named(name, params).expect("the shape exists and its widths are from the least one to 1")
}

fn rgb(channels: [f64; 3]) -> Rgb {
    Rgb(channels.map(|channel| channel as f32))
}

#[cfg(test)]
mod tests;
