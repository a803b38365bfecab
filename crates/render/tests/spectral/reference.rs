//! The table against the slow truth: one picture per pair of wavelengths.

use std::sync::Arc;

use glam::{DMat4, DVec3, Vec4};
use glanz_bsdf::Shape;
use glanz_color::{Rgb, ior};
use glanz_scene::{
    Attenuation, ColorMode, Interpolation, Light, LightColor, LightColors, LightKind, Lobe, Scene, Shading,
    Texture, TextureUse, Tint,
};

use super::common::{add, camera, empty, rectangle, sphere};
use super::{glowing, lobe, matte, patch, seen, unit};

/// The sums of the table are rounded to f32 once, those of the reference once per picture.
const AGREEMENT: f64 = 3e-6;

fn lamp(kind: LightKind, color: impl Into<LightColor>) -> Light {
    Light::new(kind, LightColors::all(color))
}

/// Spheres and squares with everything that a table can hold.
fn everything() -> Scene {
    let mut scene = empty(camera(6.0, 40.0));
    let at = |x: f64, y: f64| DMat4::from_translation(DVec3::new(x, y, 0.0));
    let shape = Shape::named("phong-normalized", &[("shininess", 12.0)]).unwrap();
    let metal = Lobe::new(shape, Tint::Ior(Arc::new(ior("Cu").unwrap())));
    let mut shiny = matte(Tint::Reradiation(glowing()));
    shiny.lobes.extend([
        metal,
        lobe("ambient", patch("orange")),
        lobe("emission", Rgb([0.02, 0.0, 0.05]).into()),
    ]);
    add(&mut scene, sphere(24, 12), shiny, at(-1.1, 0.9));
    let mut textured = matte(patch("cyan"));
    textured.lobes[0].textured = true;
    textured.base_color = Some(TextureUse::plain(0));
    add(&mut scene, rectangle([-1.0, -1.0, 1.0, 1.0], 0.0), textured, at(1.1, 0.9));
    let mut colored = matte(Rgb::WHITE.into());
    colored.lobes[0].textured = true;
    let mut mesh = rectangle([-1.0, -1.0, 1.0, 1.0], 0.2);
    mesh.colors = vec![Vec4::new(0.9, 0.1, 0.1, 1.0), Vec4::ONE, Vec4::new(0.0, 0.3, 1.0, 1.0), Vec4::ZERO];
    add(&mut scene, mesh, colored, at(-1.1, -1.2));
    add(&mut scene, sphere(16, 8), matte(Rgb([0.2, 0.6, 0.3]).into()), at(1.1, -1.2));
    scene.textures.push(Texture {
        width: 2,
        height: 2,
        rgba: vec![255, 0, 0, 255, 0, 255, 90, 255, 20, 60, 255, 255, 255, 255, 255, 255],
        srgb: true,
        ..Texture::default()
    });
    scene.lights = vec![
        lamp(LightKind::Ambient, Rgb([0.1, 0.2, 0.1])),
        lamp(
            LightKind::Directional { direction: DVec3::new(0.4, -0.5, -1.0) },
            LightColor::Spectrum(Arc::new(unit("FL11"))),
        ),
        lamp(
            LightKind::Point { position: DVec3::new(0.0, 2.0, 4.0), attenuation: Attenuation::NONE },
            LightColor::Spectrum(Arc::new(unit("D65"))),
        ),
    ];
    scene
}

#[test]
fn the_table_gives_what_one_picture_per_wavelength_pair_gives() {
    let mut scene = everything();
    let shadings = [Shading::Phong, Shading::Gouraud, Shading::Flat].map(|s| (s, Interpolation::Perspective));
    for (shading, interpolation) in shadings.into_iter().chain([(Shading::Gouraud, Interpolation::Scanline)])
    {
        scene.render.shading = shading;
        scene.render.interpolation = interpolation;
        let table = seen(&scene, ColorMode::Spectral, 24);
        let truth = seen(&scene, ColorMode::Reference, 24);
        assert_eq!(table.alpha, truth.alpha);
        let mut lit = 0;
        for channel in 0..3 {
            for (i, (a, b)) in table.rgb[channel].iter().zip(&truth.rgb[channel]).enumerate() {
                let error = (f64::from(*a) - f64::from(*b)).abs();
                assert!(error <= AGREEMENT * f64::from(b.abs()).max(0.1), "{shading:?}, {i}: {a} for {b}");
                lit += usize::from(*b > 0.01);
            }
        }
        assert!(lit > 500, "{shading:?}: only {lit} values are lit");
    }
}

/// Texels in RGB and in spectra under daylight must agree, whatever is interpolated and how.
#[test]
fn texels_and_vertex_colours_agree_with_rgb_under_daylight_in_every_scheme() {
    let mut material = matte(Rgb::WHITE.into());
    material.lobes[0].textured = true;
    material.base_color = Some(TextureUse::plain(0));
    let mut mesh = rectangle([0.0, 0.0, 8.0, 8.0], 0.0);
    mesh.colors = [[0.9, 0.2, 0.2], [0.3, 1.0, 0.4], [0.2, 0.3, 1.0], [1.0; 3]]
        .map(|[r, g, b]| Vec4::new(r, g, b, 1.0))
        .to_vec();
    let mut scene = super::faced(material, &unit("D65"));
    scene.meshes[0] = mesh;
    scene.camera = Some(super::common::pixel_camera(8, 8));
    scene.textures = everything().textures;
    for shading in [Shading::Phong, Shading::Gouraud, Shading::Flat] {
        for interpolation in [Interpolation::Perspective, Interpolation::Scanline] {
            scene.render.shading = shading;
            scene.render.interpolation = interpolation;
            let rgb = seen(&scene, ColorMode::Rgb, 8);
            let observation = glanz_render::Observation::new(ColorMode::Spectral, None).unwrap();
            let map = observation.to_screen(&scene, glanz_scene::White::D65).unwrap().unwrap();
            let spectral = super::observed(&scene, observation, 8).on_screen(&map).unwrap();
            for i in 0..64 {
                for c in 0..3 {
                    let (a, b) = (rgb.rgb[c][i], spectral.rgb[c][i]);
                    assert!((a - b).abs() < 1e-5, "{shading:?}, {interpolation:?}, pixel {i}: {a} and {b}");
                }
            }
        }
    }
}
