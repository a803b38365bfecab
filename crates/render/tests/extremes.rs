//! Scenes at the limits: nothing panics, and every value of the picture is a finite number.

mod common;

use common::{
    ALL_LAYERS, Random, add, assert_sane, camera, empty, glow, light, picture, rectangle, render_as, shiny,
    sphere, triangles,
};
use glam::{DMat4, DVec3, Vec3};
use glanz_color::Rgb;
use glanz_math::MemoryBudget;
use glanz_picture::output::PictureKind;
use glanz_render::{DebugView, DrawOptions, PrepareOptions, Shot, ShotOptions, View, ViewError};
use glanz_scene::{
    AlphaMode, Attenuation, Background, Camera, Interpolation, LightKind, Projection, Scene, Shading,
};

const SHADINGS: [Shading; 3] = [Shading::Flat, Shading::Gouraud, Shading::Phong];
const INTERPOLATIONS: [Interpolation; 3] =
    [Interpolation::Perspective, Interpolation::ScreenLinear, Interpolation::Scanline];

/// Draws the scene in many ways; panics where one gives a value that is no finite number.
fn assert_sane_in_every_way(mut scene: Scene, what: &str) {
    for shading in SHADINGS {
        for interpolation in INTERPOLATIONS {
            render_as(&mut scene, shading, interpolation);
            for (samples, supersample) in [(1, false), (4, false), (4, true)] {
                let base = DrawOptions::new(Background::Color(Rgb::gray(0.1)));
                let options = DrawOptions {
                    samples: samples.try_into().expect("one of those that there are"),
                    supersample,
                    aovs: ALL_LAYERS,
                    ..base
                };
                let frame = picture(&scene, 70, 40, &options);
                let way = format!("{what}, {shading:?}, {interpolation:?}, {samples} samples");
                assert_sane(&frame, &way);
            }
        }
    }
}

fn add_point_light(scene: &mut Scene, position: DVec3, attenuation: Attenuation) {
    scene.lights.push(light(LightKind::Point { position, attenuation }, Rgb::gray(1.0)));
}

#[test]
fn sixty_four_lights_add_up() {
    let mut sum = vec![[0.0f64; 3]; 40 * 40];
    let mut all = empty(camera(3.0, 50.0));
    add(&mut all, sphere(16, 8), shiny("phong", 9.0), DMat4::IDENTITY);
    all.lights.clear();
    let options = DrawOptions::new(Background::Color(Rgb::BLACK));
    let dark = picture(&all, 40, 40, &options);
    for i in 0..64 {
        let angle = f64::from(i) * 0.7;
        let position = DVec3::new(3.0 * angle.cos(), 3.0 * angle.sin(), 2.0 + 0.02 * f64::from(i));
        let mut one = Scene { lights: Vec::new(), ..all.clone() };
        add_point_light(&mut one, position, Attenuation::PHYSICAL);
        add_point_light(&mut all, position, Attenuation::PHYSICAL);
        let frame = picture(&one, 40, 40, &options);
        for (pixel, sum) in sum.iter_mut().enumerate() {
            for (c, sum) in sum.iter_mut().enumerate() {
                *sum += f64::from(frame.rgb[c][pixel]) - f64::from(dark.rgb[c][pixel]);
            }
        }
    }
    let frame = picture(&all, 40, 40, &options);
    for (pixel, sum) in sum.iter().enumerate() {
        for (c, sum) in sum.iter().enumerate() {
            let expected = sum + f64::from(dark.rgb[c][pixel]);
            let found = f64::from(frame.rgb[c][pixel]);
            // 64 sums of values below 4, each rounded to 24 bits.
            assert!((found - expected).abs() < 3e-5, "pixel {pixel}: {found} for {expected}");
        }
    }
    assert!(sum.iter().any(|s| s[0] > 0.5), "the lights reach the sphere");
}

#[test]
fn an_empty_scene_is_its_background() {
    let scene = empty(camera(3.0, 50.0));
    let color = Rgb([0.25, 0.5, 0.75]);
    for samples in [1, 4] {
        let options = DrawOptions {
            samples: samples.try_into().unwrap(),
            aovs: ALL_LAYERS,
            ..DrawOptions::new(Background::Color(color))
        };
        let frame = picture(&scene, 67, 35, &options);
        assert!((0..67 * 35).all(|i| frame.pixel(i % 67, i / 67) == [0.25, 0.5, 0.75, 1.0]));
        assert!(frame.depth.iter().all(|d| *d == f32::INFINITY));
        assert!(frame.object.iter().all(|o| *o == 0));
        let nothing = picture(&scene, 67, 35, &common::sampled(samples));
        assert!((0..67 * 35).all(|i| nothing.pixel(i % 67, i / 67) == [0.0; 4]));
    }
}

#[test]
fn a_picture_of_one_pixel_shows_what_is_in_the_middle() {
    let mut scene = empty(camera(3.0, 10.0));
    add(&mut scene, rectangle([-1.0, -1.0, 1.0, 1.0], 0.0), glow(Rgb([0.25, 0.5, 1.0])), DMat4::IDENTITY);
    for samples in [1, 2, 4, 8, 16] {
        let frame = picture(&scene, 1, 1, &common::sampled(samples));
        assert_eq!(frame.pixel(0, 0), [0.25, 0.5, 1.0, 1.0], "{samples} samples");
    }
}

#[test]
fn pictures_without_pixels_and_cameras_without_direction_are_errors() {
    let camera = camera(3.0, 50.0);
    assert!(matches!(View::new(&camera, 0, 10), Err(ViewError::Size { width: 0, height: 10 })));
    assert!(matches!(View::new(&camera, 10, 0), Err(ViewError::Size { .. })));
    assert!(matches!(View::new(&camera, 16_385, 10), Err(ViewError::Size { .. })));
    let view = |camera: Camera| View::new(&camera, 10, 10);
    assert!(view(Camera { target: camera.eye, ..camera }).is_err());
    assert!(view(Camera { eye: DVec3::NAN, ..camera }).is_err());
    for fov_y in [0.0, -1.0, 3.2, f64::NAN] {
        assert!(view(Camera { projection: Projection::Perspective { fov_y }, ..camera }).is_err());
    }
    for height in [0.0, -1.0, f64::INFINITY, f64::NAN] {
        assert!(view(Camera { projection: Projection::Orthographic { height }, ..camera }).is_err());
    }
}

#[test]
fn a_camera_inside_an_object_sees_it_all_around() {
    for direction in [DVec3::X, DVec3::Y, DVec3::NEG_Z, DVec3::new(1.0, -2.0, 0.5)] {
        let eye = DVec3::new(0.2, 0.1, -0.3);
        let mut scene = empty(Camera { eye, target: eye + direction, ..camera(1.0, 100.0) });
        add(&mut scene, sphere(16, 9), shiny("phong", 9.0), DMat4::IDENTITY);
        add_point_light(&mut scene, DVec3::new(-0.3, 0.3, 0.2), Attenuation::NONE);
        let frame = picture(&scene, 70, 50, &common::transparent());
        assert!(frame.alpha.iter().all(|a| *a == 1.0), "looking along {direction}");
        assert_sane_in_every_way(scene, "inside");
    }
}

#[test]
fn lights_on_the_surface_and_at_the_eye_give_numbers() {
    for attenuation in [Attenuation::NONE, Attenuation::PHYSICAL] {
        for model in ["phong", "blinn-phong", "phong-normalized", "blinn-phong-normalized"] {
            let mut scene = empty(camera(3.0, 50.0));
            add(&mut scene, rectangle([-1.0, -1.0, 1.0, 1.0], 0.0), shiny(model, 0.0), DMat4::IDENTITY);
            add(&mut scene, sphere(8, 4), shiny(model, 1e5), DMat4::from_scale(DVec3::splat(0.5)));
            // On a corner, on the surface, at a pole, at the eye, and behind everything.
            for position in
                [[-1.0, 1.0, 0.0], [0.7, 0.7, 0.0], [0.0, 0.5, 0.0], [0.0, 0.0, 3.0], [0.0, 0.0, -9.0]]
            {
                add_point_light(&mut scene, DVec3::from_array(position), attenuation);
            }
            assert_sane_in_every_way(scene, model);
        }
    }
}

#[test]
fn lights_very_far_and_very_strong_give_numbers() {
    for distance in [1e10, 1e15, 1e20, 1e25, 1e30] {
        for attenuation in [Attenuation::NONE, Attenuation::PHYSICAL] {
            let mut scene = empty(camera(3.0, 50.0));
            add(&mut scene, sphere(8, 4), shiny("blinn-phong", 10.0), DMat4::IDENTITY);
            add_point_light(&mut scene, DVec3::new(0.3, 0.5, 1.0) * distance, attenuation);
            assert_sane_in_every_way(scene, &format!("light at {distance}"));
        }
    }
}

#[test]
fn triangles_without_area_give_numbers() {
    let mut scene = empty(camera(3.0, 50.0));
    let (a, b, c) = (Vec3::ZERO, Vec3::new(1.0, 0.5, 0.0), Vec3::new(2.0, 1.0, 0.0));
    // Points, lines, a line seen from its end, and two triangles that differ in their winding.
    let positions = vec![a, a, a, b, c, a, Vec3::Z, -Vec3::Z, Vec3::X, Vec3::Y, Vec3::X + Vec3::Y];
    let corners = vec![0, 1, 2, 0, 3, 4, 5, 6, 7, 0, 3, 3, 0, 8, 9, 9, 8, 0, 8, 10, 9];
    add(&mut scene, triangles(positions, corners), shiny("phong", 9.0), DMat4::IDENTITY);
    add_point_light(&mut scene, DVec3::ONE, Attenuation::PHYSICAL);
    assert_sane_in_every_way(scene, "no area");
}

#[test]
fn normals_of_zero_and_flattening_transforms_give_numbers() {
    for scale in
        [DVec3::new(1.0, 1.0, 0.0), DVec3::new(1.0, 0.0, 0.0), DVec3::ZERO, DVec3::new(1.0, 1.0, 1e-25)]
    {
        let mut scene = empty(camera(3.0, 50.0));
        let mut mesh = sphere(8, 4);
        mesh.normals.iter_mut().step_by(3).for_each(|n| *n = Vec3::ZERO);
        add(&mut scene, mesh, shiny("blinn-phong", 9.0), DMat4::from_scale(scale));
        add_point_light(&mut scene, DVec3::ONE, Attenuation::PHYSICAL);
        assert_sane_in_every_way(scene, &format!("scale {scale}"));
    }
}

/// Numbers of every size.
fn any_size(random: &mut Random, most: f64) -> f32 {
    let size = 10f64.powf(random.between(-most, most));
    (if random.unit() < 0.5 { -size } else { size }) as f32
}

#[test]
fn huge_and_tiny_coordinates_give_numbers() {
    let mut random = Random(29);
    for most in [3.0, 8.0, 18.0, 30.0] {
        for round in 0..12 {
            let mut scene = empty(camera(3.0, 50.0));
            let mut point = || Vec3::new(0.0, 0.0, 0.0).map(|_| any_size(&mut random, most));
            let positions: Vec<Vec3> = (0..60).map(|_| point()).collect();
            let mesh = triangles(positions, (0..60).collect());
            add(&mut scene, mesh, shiny("phong", 9.0), DMat4::IDENTITY);
            add_point_light(&mut scene, DVec3::ONE, Attenuation::PHYSICAL);
            scene.materials[0].opacity = 0.5;
            if round % 2 == 1 {
                scene.materials[0].alpha_mode = AlphaMode::Blend;
            }
            assert_sane_in_every_way(scene, &format!("coordinates up to 1e{most}, round {round}"));
        }
    }
}

#[test]
fn with_shadows_what_is_out_of_reach_is_refused() {
    let mut scene = empty(camera(3.0, 50.0));
    add(&mut scene, sphere(8, 4), shiny("phong", 9.0), DMat4::IDENTITY);
    add(&mut scene, sphere(8, 4), shiny("phong", 9.0), DMat4::from_scale(DVec3::splat(1e40)));
    scene.render.shadows = true;
    let error = glanz_render::prepare(&scene, &PrepareOptions::default()).unwrap_err();
    assert!(error.to_string().contains("within coordinates of 1e12"), "{error}");
}

/// Why a scene is not prepared within so many bytes.
fn refused(scene: &Scene, bytes: u64) -> String {
    let memory = MemoryBudget::of_bytes(bytes);
    let options = PrepareOptions { memory, ..PrepareOptions::default() };
    glanz_render::prepare(scene, &options).expect_err("it is too large").to_string()
}

#[test]
fn triangles_and_their_shadows_beyond_the_budget_are_refused() {
    let mut scene = empty(camera(3.0, 50.0));
    add(&mut scene, sphere(100, 51), shiny("phong", 9.0), DMat4::IDENTITY);
    scene.objects = vec![scene.objects[0].clone(); 100];
    let found = refused(&scene, 50_000_000);
    assert!(found.contains("for 1000000 triangles"), "{found}");
    scene.render.shadows = true;
    let found = refused(&scene, 200_000_000);
    assert!(found.contains("for the shadows of 1000000 triangles beside"), "{found}");
    scene.render.shadows = false;
    let memory = MemoryBudget::of_bytes(200_000_000);
    assert!(glanz_render::prepare(&scene, &PrepareOptions { memory, ..PrepareOptions::default() }).is_ok());
}

#[test]
fn pictures_beyond_the_budget_are_refused() {
    let scene = empty(camera(3.0, 50.0)).with_size(1000, 1000);
    let mut options = ShotOptions::of(&scene).expect("the settings fit");
    options.prepare.memory = MemoryBudget::of_bytes(20_000_000);
    let mut shot = Shot::with(&scene, options).expect("the scene is small");
    assert!(shot.picture(PictureKind::Codes8, &mut |_| ()).is_ok());
    let found = shot.picture(PictureKind::Codes16, &mut |_| ()).expect_err("it is too large").to_string();
    assert!(found.contains("for a picture of 1000×1000 pixels in 16 bits"), "{found}");
}

#[test]
fn tints_beyond_the_budget_are_refused() {
    let mut scene = empty(camera(3.0, 50.0));
    add(&mut scene, sphere(8, 4), shiny("phong", 9.0), DMat4::IDENTITY);
    add_point_light(&mut scene, DVec3::ONE, Attenuation::PHYSICAL);
    scene.materials = vec![scene.materials[0].clone(); 1000];
    scene.lights = vec![scene.lights[0].clone(); 1000];
    let found = refused(&scene, 10_000_000);
    assert!(found.contains("for the tints of 1000 lights on 1000 materials"), "{found}");
}

#[test]
fn every_view_of_an_awkward_scene_gives_numbers() {
    let mut scene = empty(camera(0.5, 120.0));
    add(&mut scene, sphere(8, 4), shiny("phong", 9.0), DMat4::IDENTITY);
    let far = DMat4::from_translation(DVec3::new(0.0, 0.0, -1e9)) * DMat4::from_scale(DVec3::splat(1e9));
    add(&mut scene, rectangle([-1.0, -1.0, 1.0, 1.0], 0.0), shiny("phong", 9.0), far);
    for show in [
        DebugView::Shaded,
        DebugView::Normals,
        DebugView::Depth,
        DebugView::Ids,
        DebugView::Facets,
        DebugView::Wireframe,
        DebugView::Ambient,
        DebugView::Diffuse,
        DebugView::Specular,
        DebugView::Uv,
        DebugView::Lit,
    ] {
        for samples in [1, 4] {
            let base = DrawOptions::new(Background::Color(Rgb::BLACK));
            let options =
                DrawOptions { show, samples: samples.try_into().unwrap(), aovs: ALL_LAYERS, ..base };
            assert_sane(&picture(&scene, 70, 40, &options), &format!("{show:?}"));
        }
    }
}

#[test]
fn pixels_on_the_rim_of_steep_triangles_stay_within_the_colours_of_their_corners() {
    // Vertex colours and ambient light of 1: no pixel may be brighter than the brightest corner, nor
    // negative, wherever in the pixel its samples lie.
    let mut random = Random(31);
    for round in 0..300 {
        let mut scene = empty(camera(0.0, 70.0));
        scene.camera = Some(Camera { eye: DVec3::ZERO, target: DVec3::NEG_Z, ..camera(1.0, 70.0) });
        let mut point = || {
            let z = 10f64.powf(random.between(-2.0, 3.0));
            Vec3::new(
                (random.between(-0.7, 0.7) * z) as f32,
                (random.between(-0.7, 0.7) * z) as f32,
                -z as f32,
            )
        };
        let mut mesh = triangles((0..30).map(|_| point()).collect(), (0..30).collect());
        mesh.colors =
            (0..30).map(|i| if i % 3 == 0 { [1.0; 4] } else { [0.5, 0.5, 0.5, 1.0] }.into()).collect();
        add(&mut scene, mesh, common::ambient_only(Rgb::gray(1.0)), DMat4::IDENTITY);
        scene.lights.push(light(LightKind::Ambient, Rgb::gray(1.0)));
        for shading in [Shading::Gouraud, Shading::Phong] {
            render_as(&mut scene, shading, Interpolation::Perspective);
            for samples in [1, 8] {
                let options = DrawOptions {
                    samples: samples.try_into().unwrap(),
                    ..DrawOptions::new(Background::Color(Rgb::gray(0.75)))
                };
                let frame = picture(&scene, 64, 64, &options);
                for (i, value) in frame.rgb[0].iter().enumerate() {
                    let (x, y) = (i % 64, i / 64);
                    let within = (0.499_9..1.000_1).contains(value);
                    assert!(
                        within,
                        "round {round}, {shading:?}, {samples} samples: pixel {x}, {y} is {value}"
                    );
                }
            }
        }
    }
}
