//! A pixel taken apart is the pixel: on every example, for every shading.

#![allow(clippy::expect_used, reason = "a test")]

use std::path::Path;

use glanz_render::{Probe, Samples, Shot, ShotOptions};
use glanz_scene::{Scene, Shading, open};

/// The sum of the parts may differ from the pixel by the rounding of f32, in parts of the brightest.
const ROUNDING: f32 = 1e-6;

/// Width and height of the pictures: all that the examples show is seen in a few pixels.
const SIZE: (u32, u32) = (48, 36);

fn examples() -> Vec<(String, Scene)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let entries = std::fs::read_dir(folder).expect("the examples are there");
    let mut paths: Vec<_> = entries.map(|entry| entry.expect("it is listed").path()).collect();
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "toml"));
    paths.sort();
    let scene = |path: &std::path::PathBuf| {
        let name = path.file_stem().expect("it has a name").to_string_lossy().into_owned();
        (name, open(path, &Default::default()).expect("it is a scene").scene)
    };
    // Programs draw without lights and lobes that could be told apart.
    paths
        .iter()
        .map(scene)
        .filter(|(_, scene)| {
            scene.programs.is_empty() && scene.objects.iter().all(|own| own.program.is_none())
        })
        .collect()
}

fn shot(scene: &Scene, shading: Option<Shading>) -> Shot {
    let mut options = ShotOptions::of(scene).expect("it can be drawn");
    options.size = SIZE;
    options.draw.samples = Samples::One;
    options.draw.supersample = false;
    options.prepare.shading = shading;
    Shot::with(scene, options).expect("it can be drawn")
}

/// That the parts of a pixel add up to it, and whether a surface is there.
fn check(name: &str, probe: &Probe) -> bool {
    let same = |what: &str, a: [f32; 3], b: [f32; 3]| {
        let most = a.iter().chain(&b).fold(1e-3f32, |most, c| most.max(c.abs()));
        let off = a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
        assert!(off <= ROUNDING * most, "{name} {:?}, {what}: {a:?} for {b:?}", probe.pixel);
    };
    same("the middle is the picture's one sample", probe.middle, probe.picture);
    let Some(surface) = &probe.surface else { return false };
    for point in &surface.points {
        let mut sum = point.ambient;
        for light in &point.lights {
            let mut share = light.cone_ambient;
            for lobe in &light.lobes {
                (0..3).for_each(|c| share[c] += lobe.share[c]);
                if let (Some(value), Some(layers), Some(tint), Some(arrival)) =
                    (lobe.value, lobe.layers, lobe.tint, light.arrival)
                    && arrival.visible != Some(false)
                    && surface.points.len() == 1
                    && point.color == [1.0; 3]
                    && arrival.cos_light > 0.0
                {
                    let product = tint.map(|tint| value * layers * arrival.attenuation * tint);
                    same("the product of a lobe", lobe.share, product);
                }
            }
            same("the lobes of a light", light.share, share);
            (0..3).for_each(|c| sum[c] += share[c]);
        }
        same("the lights of a point", point.light, sum);
    }
    if surface.opacity == 1.0 && surface.is_exact() && !passes(probe) {
        same("the light of the surface", surface.light, probe.middle);
    }
    true
}

/// Whether what is behind the surface is seen, too.
fn passes(probe: &Probe) -> bool {
    probe.surface.as_ref().is_some_and(|surface| surface.transmits)
}

fn check_all(shading: Option<Shading>) {
    let mut seen = 0;
    for (name, scene) in examples() {
        let mut shot = shot(&scene, shading);
        for (x, y) in [(24, 18), (12, 18), (36, 18), (24, 9), (24, 30), (18, 22), (30, 14)] {
            seen += usize::from(check(&name, &shot.probe(x, y).expect("the pixel is there")));
        }
    }
    assert!(seen > 80, "{seen} pixels with a surface");
}

#[test]
fn the_parts_of_every_example_add_up_to_its_pixels() {
    check_all(None);
}

#[test]
fn so_they_do_with_light_at_vertices() {
    check_all(Some(Shading::Gouraud));
}

#[test]
fn so_they_do_with_light_at_facets() {
    check_all(Some(Shading::Flat));
}

#[test]
fn a_pixel_outside_is_an_error_that_tells_the_size() {
    let (_, scene) = examples().swap_remove(0);
    let error = shot(&scene, None).probe(48, 0).expect_err("there is none");
    assert!(error.to_string().contains("48×36"), "{error}");
}

#[test]
fn a_point_of_an_object_is_found_by_its_texture_coordinates() {
    let scene = Scene::new()
        .with_mesh(
            glanz_scene::Mesh::builtin("sphere").expect("it is built in"),
            glanz_scene::Material::default_gray(),
        )
        .with_light(glanz_scene::Light::directional([0.0, 0.0, -1.0], [1.0; 3]));
    let shot = shot(&scene, None);
    let (pixel, _) = shot.pixel_of(0, [0.5, 0.5]).or(shot.pixel_of(0, [0.25, 0.5])).expect("it is seen");
    let (again, uv) =
        shot.pixel_of(0, shot.pixel_of(0, [0.4, 0.5]).expect("it is seen").1).expect("it is seen");
    assert!(uv[1] > 0.4 && uv[1] < 0.6, "{uv:?} at {again:?}");
    assert!(pixel.1 > 12 && pixel.1 < 24, "{pixel:?}");
    assert_eq!(shot.pixel_of(7, [0.5, 0.5]), None);
}
