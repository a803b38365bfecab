//! Several samples per pixel, and the three ways to interpolate.

mod common;

use common::{Random, add, ambient_only, camera, empty, glow, light, picture, pixel_camera, rectangle};
use common::{render_as, sampled, transparent, triangles};
use glam::{DMat4, DQuat, DVec3, Vec2, Vec3};
use glanz_color::Rgb;
use glanz_render::DrawOptions;
use glanz_scene::{Background, Camera, Interpolation, LightKind, Mesh, Projection, Scene, Shading};

const COUNTS: [u32; 5] = [1, 2, 4, 8, 16];

/// A scene of one glowing mesh, a pixel for each metre.
fn glowing(mesh: Mesh, size: u32) -> Scene {
    let mut scene = empty(pixel_camera(size, size));
    add(&mut scene, mesh, glow(Rgb([1.0, 0.5, 0.25])), DMat4::IDENTITY);
    scene
}

#[test]
fn the_coverage_of_an_edge_approaches_its_area() {
    // Half planes through the picture; a pixel's area is counted on a fine grid.
    let mut worst = [0.0f64; 5];
    let mut random = Random(37);
    for _ in 0..30 {
        let angle = random.between(0.0, core::f64::consts::TAU);
        let (normal, offset) = (glam::DVec2::from_angle(angle), random.between(-3.0, 3.0));
        let (middle, along) = (glam::DVec2::splat(8.0) + normal * offset, normal.perp());
        let far = [middle + along * 99.0, middle - along * 99.0, middle - normal * 99.0];
        let positions = far.map(|p| p.extend(0.0).as_vec3()).to_vec();
        let scene = glowing(triangles(positions, vec![0, 2, 1]), 16);
        for (worst, count) in worst.iter_mut().zip(COUNTS) {
            let frame = picture(&scene, 16, 16, &sampled(count));
            for (i, alpha) in frame.alpha.iter().enumerate() {
                let area = (0..4096).filter(|k| {
                    let x = (i % 16) as f64 + (f64::from(k % 64) + 0.5) / 64.0;
                    let y = 16.0 - (i / 16) as f64 - (f64::from(k / 64) + 0.5) / 64.0;
                    (glam::DVec2::new(x, y) - middle).dot(normal) < 0.0
                });
                *worst = worst.max((f64::from(*alpha) - area.count() as f64 / 4096.0).abs());
            }
        }
    }
    // What these lines give with the standard patterns, with little room: worse ones fail.
    for (error, bound) in worst.iter().zip([0.51, 0.48, 0.31, 0.21, 0.18]) {
        assert!(*error <= bound, "the worst errors for {COUNTS:?} samples are {worst:?}");
    }
    assert!(worst.windows(2).all(|w| w[1] < w[0]), "more samples are better: {worst:?}");
}

#[test]
fn colours_are_premultiplied_with_coverage_and_laid_over_the_background() {
    let scene = glowing(
        triangles(vec![Vec3::ZERO, Vec3::new(9.0, 2.0, 0.0), Vec3::new(3.0, 9.0, 0.0)], vec![0, 1, 2]),
        10,
    );
    for count in COUNTS {
        let clear = picture(&scene, 10, 10, &sampled(count));
        let color = Background::Color(Rgb([0.25, 0.75, 0.5]));
        let over = picture(
            &scene,
            10,
            10,
            &DrawOptions { samples: count.try_into().unwrap(), ..DrawOptions::new(color) },
        );
        for i in 0..100 {
            let [r, g, b, a] = clear.pixel(i % 10, i / 10);
            assert_eq!([r, g, b], [a, 0.5 * a, 0.25 * a], "{count} samples: eighths are exact");
            let rest = 1.0 - a;
            let expected = [r + 0.25 * rest, g + 0.75 * rest, b + 0.5 * rest, 1.0];
            assert_eq!(over.pixel(i % 10, i / 10), expected, "{count} samples");
        }
    }
}

#[test]
fn interior_edges_do_not_show_whatever_the_samples() {
    // Many triangles of one colour: inside, every pixel is exactly that colour.
    let mut mesh = rectangle([-1.0, -1.0, 11.0, 11.0], 0.0);
    mesh.positions.push(Vec3::new(4.3, 5.9, 0.0));
    (mesh.corners, mesh.face_starts) = (vec![4, 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0], Vec::new());
    mesh.normals.push(Vec3::Z);
    mesh.uvs.push(Vec2::ZERO);
    let scene = glowing(mesh, 10);
    for samples in COUNTS {
        for supersample in [false, true] {
            let frame = picture(&scene, 10, 10, &DrawOptions { supersample, ..sampled(samples) });
            let all = (0..100).all(|i| frame.pixel(i % 10, i / 10) == [1.0, 0.5, 0.25, 1.0]);
            assert!(all, "{samples} samples, supersampled: {supersample}");
        }
    }
}

#[test]
fn supersampling_changes_nothing_where_the_colour_is_constant() {
    let mut scene = empty(camera(3.0, 50.0));
    add(&mut scene, common::sphere(12, 7), glow(Rgb([1.0, 0.5, 0.25])), DMat4::IDENTITY);
    for samples in COUNTS {
        let plain = picture(&scene, 40, 40, &sampled(samples));
        let whole = picture(&scene, 40, 40, &DrawOptions { supersample: true, ..sampled(samples) });
        assert_eq!(plain, whole, "{samples} samples");
    }
}

/// A mesh with a gradient of ambient colour, in ambient light of 1.
fn colored(mesh: Mesh, colors: &[[f32; 3]], camera: Camera, transform: DMat4) -> Scene {
    let mut scene = empty(camera);
    let colors = colors.iter().map(|c| Vec3::from_array(*c).extend(1.0)).collect();
    add(&mut scene, Mesh { colors, ..mesh }, ambient_only(Rgb::gray(1.0)), transform);
    scene.lights.push(light(LightKind::Ambient, Rgb::gray(1.0)));
    scene
}

#[test]
fn supersampling_shades_at_the_samples() {
    // A ramp of one pixel's width: the mean over the samples is the value at their mean place, which
    // is the centre for every pattern but those of 8 and 16 samples.
    let ramp = [[0.0; 3], [0.0; 3], [1.0; 3], [1.0; 3]];
    let scene = colored(rectangle([0.0, 0.0, 4.0, 4.0], 0.0), &ramp, pixel_camera(4, 4), DMat4::IDENTITY);
    for samples in [2, 4] {
        let frame = picture(&scene, 4, 4, &DrawOptions { supersample: true, ..sampled(samples) });
        for x in 0..4 {
            assert!((frame.pixel(x, 1)[0] - (x as f32 + 0.5) / 4.0).abs() < 1e-6);
        }
    }
    // The square of a ramp tells the samples apart: a highlight is averaged, not taken at the centre.
    let mut scene = empty(camera(2.0, 50.0));
    add(&mut scene, common::sphere(12, 7), common::shiny("phong", 200.0), DMat4::IDENTITY);
    scene
        .lights
        .push(light(LightKind::Directional { direction: DVec3::new(-0.2, -0.3, -1.0) }, Rgb::gray(1.0)));
    let plain = picture(&scene, 24, 24, &sampled(16));
    let whole = picture(&scene, 24, 24, &DrawOptions { supersample: true, ..sampled(16) });
    assert_eq!(plain.alpha, whole.alpha);
    let most = plain.rgb[0].iter().zip(&whole.rgb[0]).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
    assert!(most > 0.005, "the greatest difference is {most}");
}

const CORNERS: [[f32; 3]; 4] = [[1.0, 0.0, 0.25], [0.0, 1.0, 0.5], [0.25, 0.125, 1.0], [0.75, 0.5, 0.0]];

fn max_difference(a: &glanz_render::Frame, b: &glanz_render::Frame) -> f32 {
    let pairs = a.rgb.iter().flatten().zip(b.rgb.iter().flatten());
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f32::max)
}

#[test]
fn the_scanline_scheme_is_bilinear_on_an_upright_rectangle_in_parallel_projection() {
    let [left, bottom, right, top] = [2.25f32, 3.375, 17.75, 15.125];
    let mesh = rectangle([left, bottom, right, top], 0.0);
    for shading in [Shading::Gouraud, Shading::Phong] {
        let mut scene = colored(mesh.clone(), &CORNERS, pixel_camera(20, 20), DMat4::IDENTITY);
        render_as(&mut scene, shading, Interpolation::Scanline);
        let frame = picture(&scene, 20, 20, &transparent());
        let mut compared = 0;
        for i in 0..400 {
            let (x, y) = ((i % 20) as f32 + 0.5, 19.5 - (i / 20) as f32);
            if frame.alpha[i] == 0.0 {
                continue;
            }
            compared += 1;
            let (s, t) = ((x - left) / (right - left), (top - y) / (top - bottom));
            let [top_left, bottom_left, bottom_right, top_right] = CORNERS.map(Vec3::from_array);
            let at_left = top_left.lerp(bottom_left, t);
            let expected = at_left.lerp(top_right.lerp(bottom_right, t), s).to_array();
            for (plane, expected) in frame.rgb.iter().zip(expected) {
                let found = plane[i];
                assert!((found - expected).abs() < 1e-5, "{shading:?}: {found} for {expected} at {x}, {y}");
            }
        }
        assert_eq!(compared, 16 * 12);
    }
}

/// The picture of the four-coloured rectangle turned in its plane.
fn turned(angle: f64, interpolation: Interpolation) -> glanz_render::Frame {
    let turn = DMat4::from_quat(DQuat::from_rotation_z(angle));
    let projection = Projection::Orthographic { height: 3.0 };
    let upright = Camera { projection, ..camera(3.0, 40.0) };
    let mut scene = colored(rectangle([-1.0, -1.0, 1.0, 1.0], 0.0), &CORNERS, upright, turn);
    render_as(&mut scene, Shading::Gouraud, interpolation);
    picture(&scene, 60, 60, &transparent())
}

#[test]
fn only_the_scanline_scheme_depends_on_orientation() {
    // In the middle of the square the corners' mean shows when it stands upright. Turned by 45 degrees
    // the scanline runs from corner to corner, and only those two colours are left.
    let middle = |angle: f64, interpolation| {
        let pixel = turned(angle, interpolation).pixel(30, 30);
        [pixel[0], pixel[1], pixel[2]]
    };
    let near = |a: [f32; 3], b: [f32; 3], within: f32| (0..3).all(|c| (a[c] - b[c]).abs() < within);
    let mean: [f32; 3] = core::array::from_fn(|c| CORNERS.iter().map(|k| k[c]).sum::<f32>() / 4.0);
    // Half a pixel off the middle: 1/40 of the side.
    assert!(near(middle(0.0, Interpolation::Scanline), mean, 0.03));
    let eighth = core::f64::consts::FRAC_PI_4;
    let diagonal: [f32; 3] = core::array::from_fn(|c| 0.5 * (CORNERS[1][c] + CORNERS[3][c]));
    let other: [f32; 3] = core::array::from_fn(|c| 0.5 * (CORNERS[0][c] + CORNERS[2][c]));
    let found = middle(eighth, Interpolation::Scanline);
    assert!(near(found, diagonal, 0.04) || near(found, other, 0.04), "{found:?}");
    assert!(!near(found, mean, 0.04));
    // Over triangles the value in the middle is that of the diagonal, however it is turned.
    let upright = middle(0.0, Interpolation::ScreenLinear);
    assert!(near(upright, middle(eighth, Interpolation::ScreenLinear), 0.04));
}

#[test]
fn the_three_interpolations_differ_on_a_quad_in_perspective() {
    let place = DMat4::from_quat(DQuat::from_rotation_y(0.9) * DQuat::from_rotation_z(0.4));
    let frames =
        [Interpolation::Perspective, Interpolation::ScreenLinear, Interpolation::Scanline].map(|way| {
            let quad = rectangle([-1.0, -1.0, 1.0, 1.0], 0.0);
            let mut scene = colored(quad, &CORNERS, camera(2.5, 50.0), place);
            render_as(&mut scene, Shading::Gouraud, way);
            picture(&scene, 40, 40, &transparent())
        });
    for (a, b) in [(0, 1), (1, 2), (0, 2)] {
        assert_eq!(frames[a].alpha, frames[b].alpha);
        let difference = max_difference(&frames[a], &frames[b]);
        assert!(difference > 0.02, "ways {a} and {b} differ by {difference} at most");
    }
}

#[test]
fn in_parallel_projection_perspective_and_screen_linear_are_the_same() {
    let place = DMat4::from_quat(DQuat::from_rotation_y(0.9) * DQuat::from_rotation_z(0.4));
    let projection = Projection::Orthographic { height: 3.0 };
    let frames = [Interpolation::Perspective, Interpolation::ScreenLinear].map(|way| {
        let view = Camera { projection, ..camera(2.5, 50.0) };
        let mut scene = colored(rectangle([-1.0, -1.0, 1.0, 1.0], 0.0), &CORNERS, view, place);
        render_as(&mut scene, Shading::Gouraud, way);
        picture(&scene, 40, 40, &transparent())
    });
    assert_eq!(frames[0], frames[1]);
}
