//! Spectra through the whole pipeline: what a pixel must be, worked out by hand in f64.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

#[path = "../common/mod.rs"]
mod common;
mod eyes;
mod modes;
mod observers;
mod other_ways;
mod reference;

use std::sync::Arc;

use common::{add, empty, pixel_camera, rectangle, transparent};
use glam::{DMat4, DVec3};
use glanz_bsdf::Shape;
use glanz_color::{Fluorophore, Observer, Reradiation, Spectrum, ior, light, reflectance, rgb_spectra};
use glanz_render::{Change, Frame, Observation, PrepareOptions, View, draw, prepare};
use glanz_scene::{ColorMode, Light, LightColor, LightColors, LightKind, Lobe, Material, Scene, Tint};

/// A few roundings of f32.
pub const ROUNDING: f64 = 1e-6;

/// The unit light of that name.
pub fn unit(name: &str) -> Spectrum {
    match LightColor::unit(&light(name).unwrap()) {
        Some(LightColor::Spectrum(spectrum)) => *spectrum,
        other => panic!("a unit light is a spectrum, not {other:?}"),
    }
}

/// A lobe of this shape and tint.
pub fn lobe(shape: &str, tint: Tint) -> Lobe {
    Lobe::new(Shape::named(shape, &[]).unwrap(), tint)
}

/// A Lambert surface.
pub fn matte(tint: Tint) -> Material {
    Material::of_lobes("matte", vec![lobe("lambert", tint)])
}

/// The reflectance of that name.
pub fn patch(name: &str) -> Tint {
    Tint::Spectrum(Arc::new(reflectance(name).unwrap()))
}

/// A dye that glows green, over a grey.
pub fn glowing() -> Arc<Reradiation> {
    Arc::new(
        Fluorophore {
            absorption_nm: 420.0,
            absorption_fwhm_nm: 60.0,
            absorptance: 0.8,
            emission_nm: 520.0,
            emission_fwhm_nm: 40.0,
            quantum_yield: 0.9,
        }
        .over(&Spectrum::constant(0.7))
        .unwrap(),
    )
}

/// A square that fills the picture and faces one directional light.
pub fn faced(material: Material, spectrum: &Spectrum) -> Scene {
    let mut scene = empty(pixel_camera(4, 4));
    add(&mut scene, rectangle([0.0, 0.0, 4.0, 4.0], 0.0), material, DMat4::IDENTITY);
    let kind = LightKind::Directional { direction: -DVec3::Z };
    let color = LightColor::Spectrum(Arc::new(*spectrum));
    scene.lights.push(Light::new(kind, LightColors::all(color)));
    scene
}

/// The scene as this mode draws it, in the channels of the standard observer.
pub fn seen(scene: &Scene, mode: ColorMode, size: u32) -> Frame {
    observed(scene, Observation::new(mode, None).unwrap(), size)
}

/// The scene as this observation draws it.
pub fn observed(scene: &Scene, observation: Observation, size: u32) -> Frame {
    let options = PrepareOptions { observation, ..PrepareOptions::default() };
    let prepared = prepare(scene, &options).unwrap();
    let view = View::new(&scene.camera.unwrap(), size, size).unwrap();
    if options.observation.mode() == ColorMode::Reference || options.observation.channel_count() > 3 {
        let draw_options = transparent();
        let backend = &mut *glanz_render::default_backend();
        return glanz_render::draw_observed(backend, &prepared, &view, &draw_options, &mut |_| ()).unwrap();
    }
    draw(&prepared, &view, &transparent())
}

/// Tristimulus values of light that reaches the eye, in the unit of scenes.
pub fn xyz(light: &Spectrum) -> [f64; 3] {
    let observer = Observer::default();
    [0, 1, 2].map(|c| observer.channels[c].sensitivity.dot(light))
}

/// Panics unless the first three numbers are near, relative to them or to a tenth.
pub fn assert_near(found: [f32; 4], expected: [f64; 3], within: f64, what: &str) {
    for (found, wanted) in found.iter().zip(expected) {
        let error = (f64::from(*found) - wanted).abs();
        assert!(error <= within * wanted.abs().max(0.1), "{what}: {found} for {wanted} of {expected:?}");
    }
}

#[test]
fn a_patch_has_the_tristimulus_values_of_light_times_reflectance() {
    for source in ["D65", "A", "FL11", "HP1", "LED-B3"] {
        for name in ["orange", "cyan", "neutral-5"] {
            let frame = seen(&faced(matte(patch(name)), &unit(source)), ColorMode::Spectral, 4);
            let expected = xyz(&(unit(source) * reflectance(name).unwrap()));
            assert_near(frame.pixel(1, 1), expected, ROUNDING, &format!("{name} under {source}"));
        }
    }
}

#[test]
fn a_fluorescent_sheet_sends_what_its_matrix_makes_of_the_light() {
    let matrix = glowing();
    for source in ["D65", "A", "UV365"] {
        let frame =
            seen(&faced(matte(Tint::Reradiation(matrix.clone())), &unit(source)), ColorMode::Spectral, 4);
        let expected = xyz(&matrix.apply(&unit(source)));
        assert_near(frame.pixel(1, 1), expected, ROUNDING, source);
        let plain = xyz(&(unit(source) * matrix.reflectance()));
        assert!(expected[1] > plain[1] * 1.01, "{source} excites the dye");
    }
}

#[test]
fn light_of_its_own_is_its_spectrum() {
    let glow = Material::of_lobes("glow", vec![lobe("emission", Tint::Spectrum(Arc::new(unit("FL2"))))]);
    let frame = seen(&faced(glow, &Spectrum::ZERO), ColorMode::Spectral, 4);
    assert_near(frame.pixel(1, 1), xyz(&unit("FL2")), ROUNDING, "FL2");
}

#[test]
fn ambient_light_of_a_spot_lights_its_cone_in_spectra_too() {
    let ambient = Material::of_lobes("ambient", vec![lobe("ambient", patch("red"))]);
    let mut scene = faced(ambient, &unit("A"));
    scene.lights[0].kind = LightKind::Spot {
        position: DVec3::new(2.0, 2.0, 5.0),
        direction: -DVec3::Z,
        cutoff: 0.5,
        exponent: 0.0,
        smooth_edge: None,
        attenuation: glanz_scene::Attenuation::NONE,
    };
    let frame = seen(&scene, ColorMode::Spectral, 4);
    assert_near(frame.pixel(1, 1), xyz(&(unit("A") * reflectance("red").unwrap())), ROUNDING, "spot");
}

#[test]
fn a_metal_reflects_by_fresnels_law_at_every_wavelength() {
    use glanz_bsdf::terms::fresnel_conductor;
    let gold = ior("Au").unwrap();
    let shape = Shape::named("phong-normalized", &[("shininess", 1.0)]).unwrap();
    for degrees in [0.0, 30.0, 60.0, 80.0, 86.0] {
        let tint = Tint::Ior(Arc::new(gold.clone()));
        let material = Material::of_lobes("metal", vec![Lobe::new(shape.clone(), tint)]);
        let mut scene = faced(material, &unit("D65"));
        let angle = f64::to_radians(degrees);
        // The camera looks along the normal: the half vector is half of the light's angle away.
        let direction = DVec3::new(-libm::sin(angle), 0.0, -libm::cos(angle));
        scene.lights[0].kind = LightKind::Directional { direction };
        let cosine = libm::cos(0.5 * angle);
        let fraction = Spectrum(core::array::from_fn(|i| fresnel_conductor(cosine, gold.eta[i], gold.k[i])));
        // (n + 2)/2 · (R·V) · cosθ for n = 1, where R·V = cosθ.
        let lobe = 1.5 * libm::cos(angle) * libm::cos(angle);
        let expected = xyz(&(unit("D65") * fraction)).map(|v| v * lobe);
        let frame = seen(&scene, ColorMode::Spectral, 4);
        assert_near(frame.pixel(1, 1), expected, 1e-5, &format!("gold at {degrees}°"));
    }
}

#[test]
fn filling_the_table_anew_is_preparing_anew() {
    let options = PrepareOptions {
        observation: Observation::new(ColorMode::Spectral, None).unwrap(),
        ..PrepareOptions::default()
    };
    let first = faced(matte(patch("orange")), &unit("D65"));
    let second = faced(matte(patch("blue")), &unit("A"));
    let prepared = prepare(&first, &options).unwrap();
    let mut refilled = prepared.clone();
    refilled.update(&second, &[Change::Colors]).unwrap();
    let anew = prepare(&second, &options).unwrap();
    assert_eq!(refilled.materials, anew.materials);
    assert_ne!(refilled.materials, prepared.materials);
    assert!(Arc::ptr_eq(&refilled.geometry, &prepared.geometry), "geometry is shared");
    assert!(rgb_spectra::luminance(&unit("A")) > 0.999);
}
