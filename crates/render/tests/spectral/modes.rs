//! What the colour modes have in common, and what each must be.

use std::sync::Arc;

use glanz_color::meyer::{MeyerSamples, sample};
use glanz_color::{Rgb, Spectrum, reflectance, rgb_spectra};
use glanz_render::{Frame, Observation};
use glanz_scene::{ColorMode, LightColor, Scene, Texture, TextureFilter, TextureUse, Tint, White};

use super::common::{add, ambient_only, empty, light, pixel_camera, rectangle};
use super::{ROUNDING, assert_near, faced, glowing, matte, observed, patch, seen, unit, xyz};

const MODES: [ColorMode; 6] = [
    ColorMode::Rgb,
    ColorMode::Spectral,
    ColorMode::Meyer,
    ColorMode::MeyerAdapted,
    ColorMode::Sampled(8),
    ColorMode::Sampled(97),
];

/// Jakob and Hanika's spectra miss their RGB by less, and so do sums over the grid.
const ROUND_TRIP: f64 = 2e-5;

fn on_screen(scene: &Scene, mode: ColorMode, white: White) -> Frame {
    let observation = Observation::new(mode, None).unwrap();
    let to_screen = observation.to_screen(scene, white).unwrap();
    let frame = observed(scene, observation, 4);
    match to_screen {
        Some(to_screen) => frame.on_screen(&to_screen).unwrap(),
        None => frame,
    }
}

#[test]
fn white_under_daylight_is_the_white_of_the_screen_in_every_mode() {
    for mode in MODES.into_iter().chain([ColorMode::Reference]) {
        let scene = faced(matte(Rgb::WHITE.into()), &unit("D65"));
        let frame = on_screen(&scene, mode, White::D65);
        assert_near(frame.pixel(2, 2), [1.0; 3], 2e-6, &mode.to_string());
    }
}

#[test]
fn white_in_uniform_white_light_is_white_in_every_mode() {
    for mode in MODES {
        let mut scene = empty(pixel_camera(4, 4));
        let white = ambient_only(Rgb::WHITE);
        add(&mut scene, rectangle([0.0, 0.0, 4.0, 4.0], 0.0), white, glam::DMat4::IDENTITY);
        scene.lights.push(light(glanz_scene::LightKind::Ambient, Rgb::WHITE));
        assert_near(on_screen(&scene, mode, White::D65).pixel(0, 0), [1.0; 3], 2e-6, &mode.to_string());
    }
}

#[test]
fn the_eye_that_is_adapted_to_the_light_sees_white_paper_white() {
    for source in ["A", "FL11", "D50"] {
        for mode in [ColorMode::Spectral, ColorMode::MeyerAdapted, ColorMode::Sampled(16)] {
            for white in [White::Scene, White::Light] {
                let scene = faced(matte(Rgb::WHITE.into()), &unit(source));
                let [r, g, b, _] = on_screen(&scene, mode, white).pixel(1, 2);
                for c in [g / r, b / r] {
                    assert!((c - 1.0).abs() < 2e-6, "{source}, {mode}: {c}");
                }
            }
        }
        let scene = faced(matte(Rgb::WHITE.into()), &unit(source));
        let [r, _, b, _] = on_screen(&scene, ColorMode::Spectral, White::None).pixel(1, 2);
        assert!((r / b - 1.0).abs() > 0.05, "{source} is no daylight");
    }
}

#[test]
fn rgb_scenes_look_the_same_in_spectra() {
    for rgb in [[0.8, 0.1, 0.1], [0.2, 0.5, 0.9], [0.05, 0.6, 0.05], [0.5, 0.5, 0.5]] {
        let mut scene = faced(matte(Rgb(rgb).into()), &unit("D65"));
        scene.lights[0].colors = glanz_scene::LightColors::all(Rgb::gray(0.8));
        let expected = rgb.map(|c| 0.8 * f64::from(c));
        assert_near(on_screen(&scene, ColorMode::Rgb, White::D65).pixel(1, 1), expected, ROUNDING, "rgb");
        let spectral = on_screen(&scene, ColorMode::Spectral, White::D65);
        assert_near(spectral.pixel(1, 1), expected, ROUND_TRIP, "spectral");
    }
}

#[test]
fn spectra_in_an_rgb_picture_have_their_colour_under_daylight() {
    let scene = faced(matte(patch("orange")), &unit("D65"));
    let expected = rgb_spectra::rgb_of_reflectance(&reflectance("orange").unwrap());
    assert_near(on_screen(&scene, ColorMode::Rgb, White::D65).pixel(1, 1), expected, ROUNDING, "rgb");
    assert_near(on_screen(&scene, ColorMode::Spectral, White::D65).pixel(1, 1), expected, 2e-6, "spectral");
}

#[test]
fn texels_mix_three_spectra_and_show_their_own_rgb_under_daylight() {
    let code = |x: u32, y: u32| [(16 * x) as u8, (30 * y) as u8, (7 * x + 5 * y) as u8, 255];
    let texels = (0..16).flat_map(|i: u32| code(i % 4, i / 4)).collect();
    let mut material = matte(Rgb::WHITE.into());
    material.lobes[0].textured = true;
    material.base_color = Some(TextureUse::plain(0));
    let mut scene = faced(material, &unit("D65"));
    scene.textures.push(Texture {
        width: 4,
        height: 4,
        rgba: texels,
        srgb: true,
        filter: TextureFilter::Nearest,
        ..Texture::default()
    });
    for shading in [glanz_scene::Shading::Phong, glanz_scene::Shading::Gouraud, glanz_scene::Shading::Flat] {
        scene.render.shading = shading;
        let rgb = on_screen(&scene, ColorMode::Rgb, White::D65);
        let spectral = on_screen(&scene, ColorMode::Spectral, White::D65);
        for (x, y) in [(0, 0), (1, 2), (3, 3), (3, 0)] {
            let [r, g, b, _] = rgb.pixel(x, y).map(f64::from);
            assert_near(spectral.pixel(x, y), [r, g, b], 5e-6, &format!("{shading:?} at {x}, {y}"));
        }
    }
    // Under another light they are not what RGB makes of them, but what their spectra say.
    scene.lights[0].colors = glanz_scene::LightColors::all(LightColor::Spectrum(Arc::new(unit("A"))));
    scene.render.shading = glanz_scene::Shading::Phong;
    let frame = seen(&scene, ColorMode::Spectral, 4);
    let texel = code(3, 2).map(glanz_color::srgb_decode_u8);
    let [r, g, b] = rgb_spectra::basis();
    let fraction = *r * f64::from(texel[0]) + *g * f64::from(texel[1]) + *b * f64::from(texel[2]);
    assert_near(frame.pixel(3, 2), xyz(&(unit("A") * fraction)), 5e-6, "a texel under A");
}

#[test]
fn meyers_samples_are_four_products_and_their_weights() {
    let scene = faced(matte(patch("orange")), &unit("A"));
    let light = sample(&unit("A"));
    let fraction = sample(&reflectance("orange").unwrap());
    let scale = rgb_spectra::luminance_of_equal_energy();
    let products = core::array::from_fn(|i| light[i] * fraction[i]);
    let published = MeyerSamples::published().xyz(products).map(|v| v * scale);
    assert_near(seen(&scene, ColorMode::Meyer, 4).pixel(1, 1), published, ROUNDING, "published");
    let adapted = MeyerSamples::adapted(&unit("A")).xyz(fraction).map(|v| v * scale);
    assert_near(seen(&scene, ColorMode::MeyerAdapted, 4).pixel(1, 1), adapted, ROUNDING, "adapted");
}

#[test]
fn adapted_weights_are_each_lights_own() {
    let mut scene = faced(matte(patch("cyan")), &unit("A"));
    let mut other = scene.lights[0].clone();
    other.colors = glanz_scene::LightColors::all(LightColor::Spectrum(Arc::new(unit("D75"))));
    scene.lights.push(other);
    let fraction = sample(&reflectance("cyan").unwrap());
    let scale = rgb_spectra::luminance_of_equal_energy();
    let mut expected = [0.0; 3];
    for source in ["A", "D75"] {
        let xyz = MeyerSamples::adapted(&unit(source)).xyz(fraction);
        expected.iter_mut().zip(xyz).for_each(|(sum, v)| *sum += v * scale);
    }
    assert_near(seen(&scene, ColorMode::MeyerAdapted, 4).pixel(1, 1), expected, ROUNDING, "two lights");
}

#[test]
fn ninety_seven_samples_are_the_whole_spectrum() {
    for tint in [patch("red"), Tint::Reradiation(glowing())] {
        let scene = faced(matte(tint), &unit("D65"));
        let [x, y, z, _] = seen(&scene, ColorMode::Spectral, 4).pixel(1, 1).map(f64::from);
        assert_near(seen(&scene, ColorMode::Sampled(97), 4).pixel(1, 1), [x, y, z], ROUNDING, "sampled:97");
    }
}

#[test]
fn more_samples_come_nearer() {
    let scene = faced(matte(patch("purple")), &unit("D65"));
    let right = xyz(&(unit("D65") * reflectance("purple").unwrap()));
    let error = |count: u8| {
        let pixel = seen(&scene, ColorMode::Sampled(count), 4).pixel(1, 1);
        (0..3).map(|c| (f64::from(pixel[c]) - right[c]).abs()).fold(0.0, f64::max)
    };
    let errors = [4, 12, 48].map(error);
    assert!(errors[0] > 2.0 * errors[1] && errors[1] > 2.0 * errors[2], "{errors:?}");
}

#[test]
fn four_samples_see_no_fluorescence_and_bands_do() {
    let matrix = glowing();
    let with = faced(matte(Tint::Reradiation(matrix.clone())), &unit("D65"));
    let without = faced(matte(Tint::Spectrum(Arc::new(matrix.reflectance()))), &unit("D65"));
    for mode in [ColorMode::Meyer, ColorMode::MeyerAdapted] {
        assert_eq!(seen(&with, mode, 4).rgb, seen(&without, mode, 4).rgb, "{mode}");
    }
    let [plain, bands] = [&without, &with].map(|scene| seen(scene, ColorMode::Sampled(24), 4).pixel(0, 0)[1]);
    let right = xyz(&matrix.apply(&unit("D65")))[1] as f32;
    assert!(bands > plain && (bands - right).abs() < 0.05 * right, "{plain}, {bands}, {right}");
}

#[test]
fn black_light_shows_what_glows_and_nothing_else() {
    let glow = faced(matte(Tint::Reradiation(glowing())), &unit("UV365"));
    let gray = faced(matte(Tint::Spectrum(Arc::new(Spectrum::constant(0.7)))), &unit("UV365"));
    let [glow, gray] = [glow, gray].map(|scene| seen(&scene, ColorMode::Spectral, 4).pixel(0, 0)[1]);
    assert!(glow > 0.05 && gray < 1e-3 && gray > 0.0, "{glow}, {gray}");
}
