//! The same scene gives the same bits: for every number of threads, every SIMD level, every order of
//! the triangles, and whether a frame is kept between drawing and development or not.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod common;

use common::everything::{
    add_fields, add_ground, add_lamps, at, coated, colored, glass, ground, luminaire, matte, metal, of,
    texture, window,
};
use common::{ALL_LAYERS, add, ambient_only, camera, empty, light, rectangle, render_as, shiny, sphere};
use glam::{DMat4, DVec3};
use glanz_color::Rgb;
use glanz_math::SimdLevel;
use glanz_picture::{Meaning, ScreenMatrix};
use glanz_render::cpu::Renderer;
use glanz_render::{
    Aovs, Backend, DebugView, Develop, DrawOptions, Encoding, Frame, PrepareOptions, Prepared, Samples,
    ToneMap, View, develop, draw, draw_rgba8, prepare,
};
use glanz_scene::{
    AlphaMode, Background, Interpolation, LightKind, Lobe, Material, Scene, Shading, TextureUse,
};

const WIDTH: u32 = 150;
const HEIGHT: u32 = 101;

/// A scene with what makes drawing take different ways: several objects, all lights, vertices behind
/// the eye, textures, masks and blending.
fn scene(shading: Shading, interpolation: Interpolation) -> Scene {
    let mut scene = empty(camera(3.0, 50.0));
    render_as(&mut scene, shading, interpolation);
    add_lamps(&mut scene, None);
    add(&mut scene, sphere(24, 12), shiny("phong", 12.0), at(-0.6, 0.1, 0.0));
    add(&mut scene, sphere(40, 31), shiny("blinn-phong-normalized", 30.0), at(0.8, 0.0, -0.5));
    scene.textures.push(texture(true));
    let base_color = Some(TextureUse::plain(0));
    add_ground(&mut scene, Material { base_color, ..shiny("blinn-phong", 4.0) });
    let alpha_mode = AlphaMode::Mask { cutoff: 0.5 };
    let holes = Material { base_color, alpha_mode, ..ambient_only(Rgb([0.9, 0.8, 0.2])) };
    add(&mut scene, rectangle([-1.0, 0.2, 0.2, 0.9], 1.1), holes, DMat4::IDENTITY);
    add(&mut scene, colored(sphere(12, 9)), glass(), at(0.3, -0.2, 0.7));
    scene
}

/// A scene of what the classic models do not have: anisotropy, coats, panes and transmittance, under an environment,
/// surfaces that shine, a luminaire, and with shadows.
fn general_materials(shading: Shading) -> Scene {
    let mut scene = empty(camera(3.0, 50.0));
    scene.render.shading = shading;
    scene.render.shadows = true;
    let leaf = Material::of_lobes(
        "leaf",
        vec![
            matte(),
            Lobe::new(of("lambert-transmission", &[]), Rgb([0.1, 0.5, 0.2])),
            Lobe::new(of("ggx-transmission", &[("alpha", 0.3), ("eta", 1.4)]), Rgb::gray(0.3)),
        ],
    );
    add(&mut scene, sphere(24, 12), metal(), at(-0.9, 0.1, 0.0));
    add(&mut scene, sphere(24, 12), coated(), at(0.9, 0.0, -0.4));
    add(&mut scene, rectangle([-0.5, -0.2, 0.4, 0.6], 0.8), leaf, DMat4::IDENTITY);
    add(&mut scene, rectangle([0.1, -0.7, 1.1, 0.5], 1.1), window(), DMat4::IDENTITY);
    add_ground(&mut scene, ground());
    add_fields(&mut scene);
    let direction = DVec3::new(0.2, -0.6, 1.0);
    scene.lights.push(light(LightKind::Directional { direction }, Rgb([0.8, 0.9, 0.7])));
    scene.lights.push(luminaire());
    scene
}

fn view(scene: &Scene) -> View {
    View::new(&scene.camera.unwrap(), WIDTH, HEIGHT).unwrap()
}

fn prepared(scene: &Scene) -> Prepared {
    prepare(scene, &PrepareOptions::default()).unwrap()
}

/// Every way of drawing that is to be compared.
fn variants() -> Vec<(String, Scene, DrawOptions)> {
    let color = Background::Color(Rgb([0.05, 0.1, 0.2]));
    let base = DrawOptions { aovs: ALL_LAYERS, ..DrawOptions::new(color) };
    let mut variants = Vec::new();
    for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong] {
        variants.push((format!("{shading:?}"), scene(shading, Interpolation::Perspective), base));
    }
    for interpolation in [Interpolation::ScreenLinear, Interpolation::Scanline] {
        variants.push((format!("{interpolation:?}"), scene(Shading::Gouraud, interpolation), base));
    }
    let surrounded = DrawOptions { background: Background::Environment, ..base };
    for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong] {
        variants.push((format!("general, {shading:?}"), general_materials(shading), surrounded));
    }
    for (samples, supersample) in [(4, false), (2, true)] {
        let options = DrawOptions { samples: samples.try_into().unwrap(), supersample, ..surrounded };
        variants.push((format!("general, {samples} samples"), general_materials(Shading::Phong), options));
    }
    let scene = scene(Shading::Phong, Interpolation::Perspective);
    let transparent = Background::Transparent;
    let others = [
        DrawOptions { samples: Samples::Four, ..base },
        DrawOptions { samples: Samples::Eight, background: transparent, ..base },
        DrawOptions { samples: Samples::Two, supersample: true, ..base },
        DrawOptions { show: DebugView::Wireframe, ..base },
        DrawOptions { show: DebugView::Normals, samples: Samples::Four, background: transparent, ..base },
        DrawOptions { show: DebugView::Lit, ..base },
        DrawOptions { show: DebugView::Uv, ..base },
        DrawOptions { show: DebugView::Specular, ..base },
    ];
    for options in others {
        let what = format!("{:?}, {} samples", options.show, options.samples.count());
        variants.push((what, scene.clone(), options));
    }
    variants
}

/// FNV-1a over the bits of all planes, so that −0 and NaN count as they are.
fn hash(frame: &Frame) -> u64 {
    let planes = frame.rgb.iter().chain([&frame.alpha, &frame.depth]).chain(&frame.normal);
    let bits = planes.flatten().map(|v| v.to_bits()).chain(frame.object.iter().copied());
    bits.fold(0xcbf2_9ce4_8422_2325, |hash, bits| (hash ^ u64::from(bits)).wrapping_mul(0x0100_0000_01b3))
}

/// The first plane and pixel where two frames differ.
fn first_difference(a: &Frame, b: &Frame) -> String {
    let planes = |f: &Frame| -> Vec<Vec<f32>> {
        f.rgb.iter().chain([&f.alpha, &f.depth]).chain(&f.normal).cloned().collect()
    };
    for (plane, (x, y)) in planes(a).iter().zip(planes(b)).enumerate() {
        if let Some(i) = (0..x.len()).find(|&i| x[i].to_bits() != y[i].to_bits()) {
            return format!("plane {plane}, pixel {}, {}: {} and {}", i % a.width, i / a.width, x[i], y[i]);
        }
    }
    "object numbers".into()
}

fn in_pool<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> T {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(work)
}

#[test]
fn the_number_of_threads_changes_no_bit() {
    for (what, scene, options) in variants() {
        let (prepared, view) = (prepared(&scene), view(&scene));
        let [one, two, seven] = [1, 2, 7].map(|n| in_pool(n, || draw(&prepared, &view, &options)));
        for other in [two, seven] {
            assert_eq!(hash(&one), hash(&other), "{what}: {}", first_difference(&one, &other));
        }
    }
}

#[test]
fn the_simd_level_changes_no_bit() {
    let levels = SimdLevel::available();
    for (what, scene, options) in variants() {
        let (prepared, view) = (prepared(&scene), view(&scene));
        let best = draw(&prepared, &view, &options);
        common::assert_sane(&best, &what);
        for (name, level) in &levels {
            let other = Renderer::with_level(*level).draw(&prepared, &view, &options);
            assert_eq!(hash(&best), hash(&other), "{what}, {name}: {}", first_difference(&best, &other));
        }
    }
}

#[test]
fn pictures_developed_while_drawing_are_the_bytes_of_developed_frames() {
    let settings = [
        Develop::default(),
        Develop { ev: 0.7, tone_map: ToneMap::Aces, ..Develop::default() },
        Develop { ev: -0.3, tone_map: ToneMap::Agx, dither: true, ..Develop::default() },
        Develop { ev: 0.4, encoding: Encoding::Raw, ..Develop::default() },
        Develop {
            ev: 0.2,
            to_screen: Some(ScreenMatrix {
                from: Meaning::LinearSrgb,
                rows: [[3.2, -1.5, -0.5], [-1.0, 1.9, 0.04], [0.06, -0.2, 1.1]],
            }),
            ..Develop::default()
        },
    ];
    for (what, scene, options) in variants() {
        let (prepared, view) = (prepared(&scene), view(&scene));
        let frame = draw(&prepared, &view, &options);
        for settings in &settings {
            let mut straight = vec![0; (4 * WIDTH * HEIGHT) as usize];
            draw_rgba8(&prepared, &view, &options, settings, &mut straight).unwrap();
            let later = develop(&frame, settings).unwrap();
            let at = straight.iter().zip(&later).position(|(a, b)| a != b);
            assert_eq!(at, None, "{what}, {settings:?}: byte {at:?} differs");
            assert_eq!(straight.len(), later.len());
        }
    }
}

#[test]
fn planes_beside_colour_change_no_colour_and_kept_memory_no_bit() {
    let mut renderer = Renderer::new();
    let mut kept = Frame::default();
    for (what, scene, options) in variants() {
        let (prepared, view) = (prepared(&scene), view(&scene));
        let all = draw(&prepared, &view, &options);
        // Of another size before, and with other planes.
        let small = View::new(&scene.camera.unwrap(), WIDTH / 2, HEIGHT).unwrap();
        let normals = Aovs { normal: true, ..Aovs::default() };
        renderer.draw_into(&prepared, &small, &DrawOptions { aovs: normals, ..options }, &mut kept);
        renderer.draw_into(&prepared, &view, &options, &mut kept);
        assert_eq!(hash(&all), hash(&kept), "{what}: {}", first_difference(&all, &kept));
        let bare = DrawOptions { aovs: Aovs::default(), ..options };
        renderer.draw_into(&prepared, &view, &bare, &mut kept);
        assert!(kept.depth.is_empty() && kept.normal.iter().all(Vec::is_empty) && kept.object.is_empty());
        let colors = Frame { depth: vec![], normal: Default::default(), object: vec![], ..all };
        assert_eq!(hash(&colors), hash(&kept), "{what}: {}", first_difference(&colors, &kept));
    }
}

/// The scene with the faces of each mesh in the opposite order; each face begins with the same corner.
fn reversed(mut scene: Scene) -> Scene {
    for mesh in &mut scene.meshes {
        let faces: Vec<Vec<u32>> = mesh.faces().map(<[u32]>::to_vec).collect();
        mesh.corners.clear();
        mesh.face_starts = vec![0];
        for face in faces.into_iter().rev() {
            mesh.corners.extend(face);
            mesh.face_starts.push(mesh.corners.len() as u32);
        }
    }
    scene
}

#[test]
fn the_order_of_the_triangles_changes_no_bit() {
    let single = |options: &DrawOptions| options.samples == Samples::One;
    for (what, scene, options) in variants().into_iter().filter(|(_, _, options)| single(options)) {
        let view = view(&scene);
        let straight = draw(&prepared(&scene), &view, &options);
        let backwards = draw(&prepared(&reversed(scene)), &view, &options);
        let difference = first_difference(&straight, &backwards);
        assert_eq!(hash(&straight), hash(&backwards), "{what}: {difference}");
    }
}

/// The samples of a pixel are added in the order of the triangles, each sum rounded to 24 bits.
const ROUNDING_OF_SUMS: f32 = 1e-6;

#[test]
fn the_order_of_the_triangles_changes_sums_of_samples_by_rounding_only() {
    for samples in [2, 4, 8, 16] {
        let mut scene = scene(Shading::Phong, Interpolation::Perspective);
        // Without the glass: where a silhouette's front and back are equally deep, which of them
        // is blended first depends on their numbers.
        scene.objects.pop();
        let (view, options) = (view(&scene), common::sampled(samples));
        let straight = draw(&prepared(&scene), &view, &options);
        let backwards = draw(&prepared(&reversed(scene)), &view, &options);
        for (a, b) in straight.rgb.iter().flatten().zip(backwards.rgb.iter().flatten()) {
            assert!((a - b).abs() <= ROUNDING_OF_SUMS, "{samples} samples: {a} and {b}");
        }
        assert_eq!(straight.alpha, backwards.alpha);
    }
}

#[test]
fn the_order_of_the_objects_changes_no_colour() {
    for (what, mut scene, options) in variants() {
        let view = view(&scene);
        let straight = draw(&prepared(&scene), &view, &options);
        scene.objects.reverse();
        let backwards = draw(&prepared(&scene), &view, &options);
        assert!(straight.rgb == backwards.rgb, "{what}: {}", first_difference(&straight, &backwards));
        assert_eq!(straight.alpha, backwards.alpha, "{what}");
    }
}

#[test]
fn different_scenes_have_different_hashes() {
    let frames = variants().into_iter().map(|(_, scene, options)| {
        let view = view(&scene);
        hash(&draw(&prepared(&scene), &view, &options))
    });
    let mut hashes: Vec<u64> = frames.collect();
    let count = hashes.len();
    hashes.sort_unstable();
    hashes.dedup();
    assert_eq!(hashes.len(), count);
}
