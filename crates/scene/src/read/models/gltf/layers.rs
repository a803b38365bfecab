//! The lobes of a lit material: dielectric and metal, under a sheen, under a clear coat. The parent module says
//! which formula is whose.

use std::sync::Arc;

use glanz_bsdf::models::charlie::Albedo;
use glanz_bsdf::models::ggx::LEAST_ALPHA;
use glanz_bsdf::terms::fresnel_film;
use glanz_bsdf::{Angle, Chebyshev, LayerWeight, Shape};
use glanz_color::{Ior, Rgb, Spectrum, lambda_nm, rgb_spectra};

use super::pbr::{PbrMaterial, greatest};
use crate::{Film, Lobe, Metalness, Pane, Tint, Transmittance};

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

/// The lobes of a material; those whose tint is black are left out.
pub(super) fn lobes(pbr: &PbrMaterial) -> Vec<Lobe> {
    let mut layers = dielectric(pbr);
    layers.extend(metal(pbr));
    if pbr.greatest_sheen() > 0.0 {
        let alpha = pbr.sheen_roughness * pbr.sheen_roughness;
        let alpha = alpha.max(LEAST_ALPHA);
        let layer = LayerWeight::Sheen { strength: pbr.greatest_sheen(), albedo: Albedo::new(alpha) };
        layers = layers.into_iter().map(|lobe| lobe.under(layer.clone())).collect();
        layers.push(Lobe::new(shape("charlie", &[("alpha", alpha)]), rgb(pbr.sheen)));
    }
    if pbr.coat > 0.0 {
        let layer = |at_zero, at_grazing| LayerWeight::Schlick { angle: Angle::View, at_zero, at_grazing };
        let below = layer(1.0 - pbr.coat * COAT_F0, 1.0 - pbr.coat);
        layers = layers.into_iter().map(|lobe| lobe.under(below.clone())).collect();
        let alpha = width(pbr.coat_roughness);
        let gloss = shape("ggx", &[("alpha", alpha), ("multiscatter", 0.0)]);
        layers.push(Lobe::new(gloss, Rgb::WHITE).under(layer(pbr.coat * COAT_F0, pbr.coat)));
    }
    // Metal has no matte part that ambient light could meet. The ambient term does not read the texture of metal, so it
    // takes its mean.
    let matte = 1.0 - pbr.metallic * pbr.mean_metal;
    let ambient = pbr.base.map(|channel| channel * (1.0 - pbr.open()) * matte);
    let mut all = vec![Lobe::new(shape("ambient", &[]), rgb(ambient)).textured()];
    all.extend(layers);
    all.push(Lobe::new(shape("emission", &[]), rgb(pbr.emission)));
    all.retain(|lobe| !lobe.tint.is_black());
    all
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
    let seen: [f64; 3] = core::array::from_fn(|c| open * pbr.base[c] * pbr.left[c]);
    let both_sides = pbr.specular * pbr.greatest_f0();
    let absorption = rgb_spectra::spectrum_of_reflectance(rgb(seen))
        .map(|weight| -libm::log(weight.clamp(LEAST_SEEN, 1.0)));
    let ior = Ior::constant(index(both_sides / (2.0 - both_sides)).max(LEAST_PANE));
    Some(Transmittance::Pane(Arc::new(Pane { ior, thickness: 1.0, absorption })))
}

fn dielectric(pbr: &PbrMaterial) -> Vec<Lobe> {
    let metalness = match (pbr.metallic, pbr.metal_varies) {
        (0.0, _) => Metalness::Any,
        (1.0, false) => return Vec::new(),
        (factor, _) => Metalness::Dielectric { factor },
    };
    let film = film(pbr, pbr.f0);
    let mut lobes = Vec::new();
    for (lobe, angle) in below(pbr) {
        let below = LayerWeight::Schlick {
            angle,
            at_zero: 1.0 - pbr.specular * pbr.greatest_f0(),
            at_grazing: 1.0 - pbr.specular,
        };
        push(&mut lobes, 1.0 - pbr.iridescence, lobe.clone().under(below));
        if let Some(film) = &film {
            let left = Chebyshev::interpolate(FILM_TERMS, |cosine| 1.0 - greatest_of_film(film, cosine));
            push(&mut lobes, pbr.iridescence, lobe.under(LayerWeight::Series { angle, factor: left }));
        }
    }
    let gloss = gloss(pbr);
    for lobe in boundary(&gloss, pbr.f0.map(|f0| f0 * pbr.specular), pbr.specular, false) {
        push(&mut lobes, 1.0 - pbr.iridescence, lobe);
    }
    lobes.extend(iridescent(pbr, film, &gloss));
    lobes.iter_mut().for_each(|lobe| lobe.metalness = metalness);
    lobes
}

fn metal(pbr: &PbrMaterial) -> Vec<Lobe> {
    let metalness = match (pbr.metallic, pbr.metal_varies) {
        (0.0, _) => return Vec::new(),
        (1.0, false) => Metalness::Any,
        (factor, _) => Metalness::Metal { factor },
    };
    let gloss = gloss(pbr);
    let mut lobes = Vec::new();
    for lobe in boundary(&gloss, pbr.base, 1.0, true) {
        push(&mut lobes, 1.0 - pbr.iridescence, lobe);
    }
    lobes.extend(iridescent(pbr, film(pbr, pbr.base), &gloss));
    lobes.iter_mut().for_each(|lobe| lobe.metalness = metalness);
    lobes
}

/// What lies below the boundary of the dielectric, with the angle by which light passes it.
fn below(pbr: &PbrMaterial) -> [(Lobe, Angle); 2] {
    let back = pbr.base.map(|channel| channel * (1.0 - pbr.transmission));
    let on = core::array::from_fn(|c| pbr.base[c] * pbr.transmission * pbr.left[c]);
    let sheet = shape("ggx-thin-transmission", &[("alpha", width(pbr.roughness))]);
    [
        (Lobe::new(shape("lambert", &[]), rgb(back)).textured(), Angle::Half),
        (Lobe::new(sheet, rgb(on)).textured(), Angle::HalfThrough),
    ]
}

/// A gloss times f0 + (f90 − f0)(1 − cosθ)⁵ in Schlick's form: one lobe where that has no colour, else one for the
/// colour at normal incidence, which textures may multiply, and one for the rest.
fn boundary(gloss: &Shape, f0: [f64; 3], f90: f64, textured: bool) -> Vec<Lobe> {
    let layer = |at_zero, at_grazing| LayerWeight::Schlick { angle: Angle::Half, at_zero, at_grazing };
    if !textured && f0[0] == f0[1] && f0[1] == f0[2] {
        return vec![Lobe::new(gloss.clone(), Rgb::WHITE).under(layer(f0[0], f90))];
    }
    let colored = Lobe { textured, ..Lobe::new(gloss.clone(), rgb(f0)) };
    vec![colored.under(layer(1.0, 0.0)), Lobe::new(gloss.clone(), Rgb::WHITE).under(layer(0.0, f90))]
}

/// Adds a lobe with a weight, if that is not 0.
fn push(lobes: &mut Vec<Lobe>, weight: f64, lobe: Lobe) {
    if lobe.tint.is_black() || weight <= 0.0 {
        return;
    }
    lobes.push(if weight < 1.0 { lobe.under(LayerWeight::Constant(weight)) } else { lobe });
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

fn iridescent(pbr: &PbrMaterial, film: Option<Arc<Film>>, gloss: &Shape) -> Option<Lobe> {
    let mut lobes = Vec::new();
    push(&mut lobes, pbr.iridescence, Lobe::new(gloss.clone(), Tint::Film(film?)));
    lobes.pop()
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
