//! Surfaces that let light through are laid over one another sample by sample.

mod common;

use common::{Random, add, ambient_only, camera, empty, glow, light, picture, pixel_camera, rectangle};
use common::{sampled, sphere, triangles};
use glam::{DMat4, Vec3};
use glanz_color::Rgb;
use glanz_render::{DrawOptions, Frame};
use glanz_scene::{AlphaMode, Background, LightKind, Material, Mesh, Scene};

const COUNTS: [u32; 5] = [1, 2, 4, 8, 16];
const GLASS: Rgb = Rgb([1.0, 0.5, 0.25]);

/// Glowing glass that lets half of what is behind through.
fn glass() -> Material {
    Material { opacity: 0.5, alpha_mode: AlphaMode::Blend, ..glow(GLASS) }
}

/// Draws with each number of samples, shaded once per pixel and once per sample.
fn each_way(scene: &Scene, size: u32, background: Background, check: impl Fn(&Frame, &str)) {
    for samples in COUNTS {
        for supersample in [false, true] {
            let options = DrawOptions {
                samples: samples.try_into().expect("one of those that there are"),
                supersample,
                ..DrawOptions::new(background)
            };
            let what = format!("{samples} samples, supersampled: {supersample}");
            check(&picture(scene, size, size, &options), &what);
        }
    }
}

#[test]
fn a_pane_of_two_triangles_shows_no_diagonal() {
    let mut scene = empty(pixel_camera(10, 10));
    add(&mut scene, rectangle([-1.0, -1.0, 12.0, 11.0], 0.0), glass(), DMat4::IDENTITY);
    each_way(&scene, 10, Background::Transparent, |frame, what| {
        for i in 0..100 {
            let found = frame.pixel(i % 10, i / 10);
            assert_eq!(found, [0.5, 0.25, 0.125, 0.5], "{what}: pixel {}, {}", i % 10, i / 10);
        }
    });
}

#[test]
fn an_opaque_edge_in_front_hides_glass_only_where_it_is() {
    let edge = || {
        let corners = vec![Vec3::new(-9.0, -9.0, 1.0), Vec3::new(18.0, 1.0, 1.0), Vec3::new(-2.0, 19.0, 1.0)];
        triangles(corners, vec![0, 1, 2])
    };
    let opaque = Rgb([0.125, 0.25, 1.0]);
    let behind = [0.25, 1.0, 0.5];
    let mut alone = empty(pixel_camera(10, 10));
    add(&mut alone, edge(), glow(opaque), DMat4::IDENTITY);
    let mut scene = alone.clone();
    add(&mut scene, rectangle([-1.0, -1.0, 12.0, 11.0], 0.0), glass(), DMat4::IDENTITY);
    for samples in COUNTS {
        let coverage = picture(&alone, 10, 10, &sampled(samples));
        let background = Background::Color(Rgb(behind));
        let frame = picture(
            &scene,
            10,
            10,
            &DrawOptions { samples: samples.try_into().unwrap(), ..DrawOptions::new(background) },
        );
        for i in 0..100 {
            let covered = coverage.pixel(i % 10, i / 10)[3];
            let color = frame.pixel(i % 10, i / 10);
            for c in 0..3 {
                let through = 0.5 * GLASS.0[c] + 0.5 * behind[c];
                // Sixteenths of eighths: exact.
                assert_eq!(color[c], covered * opaque.0[c] + (1.0 - covered) * through, "{samples} samples");
            }
        }
    }
}

#[test]
fn glass_in_front_of_an_opaque_edge_keeps_the_share_of_each() {
    let mut scene = empty(pixel_camera(10, 10));
    let corners = vec![Vec3::new(-9.0, -9.0, 0.0), Vec3::new(18.0, 1.0, 0.0), Vec3::new(-2.0, 19.0, 0.0)];
    add(&mut scene, triangles(corners, vec![0, 1, 2]), glow(Rgb([0.0, 0.0, 1.0])), DMat4::IDENTITY);
    let mut plain = scene.clone();
    plain.objects.truncate(1);
    add(&mut scene, rectangle([-1.0, -1.0, 12.0, 11.0], 1.0), glass(), DMat4::IDENTITY);
    for samples in COUNTS {
        let (without, with) =
            (picture(&plain, 10, 10, &sampled(samples)), picture(&scene, 10, 10, &sampled(samples)));
        for i in 0..100 {
            let ([r, g, b, a], found) = (without.pixel(i % 10, i / 10), with.pixel(i % 10, i / 10));
            let over = |value: f32, glass: f32| 0.5 * value + 0.5 * glass;
            assert_eq!(found, [over(r, 1.0), over(g, 0.5), over(b, 0.25), over(a, 1.0)], "{samples} samples");
        }
    }
}

/// Coloured triangles that overlap and pierce one another, in this order.
fn shards(order: &[u32]) -> Mesh {
    let mut random = Random(5);
    let mut vector = |size: f64| {
        let [x, y, z] = [0; 3].map(|_| random.between(-size, size));
        Vec3::new(x as f32, y as f32, z as f32)
    };
    let positions: Vec<Vec3> = (0..order.len() * 3).map(|_| vector(1.2)).collect();
    let colors = positions.iter().map(|_| (vector(0.5) + 0.5).extend(1.0)).collect();
    let corners = order.iter().flat_map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    Mesh { colors, ..triangles(positions, corners) }
}

/// The mesh with its triangles in the opposite order.
fn reversed(mesh: &Mesh) -> Mesh {
    let faces: Vec<&[u32]> = (0..mesh.face_count()).map(|face| mesh.face(face)).collect();
    let corners = faces.iter().rev().flat_map(|face| face.iter().copied()).collect();
    let mut starts = vec![0];
    starts.extend(faces.iter().rev().scan(0, |end, face| {
        *end += face.len() as u32;
        Some(*end)
    }));
    Mesh { corners, face_starts: starts, ..mesh.clone() }
}

/// A ball of many colours.
fn ball() -> Mesh {
    let mut mesh = sphere(23, 14);
    mesh.colors = mesh.positions.iter().map(|p| (p.abs() * 0.9).extend(1.0)).collect();
    mesh
}

#[test]
fn the_order_of_glass_triangles_does_not_matter() {
    let order: Vec<u32> = (0..40).collect();
    for (mesh, opacity) in [(shards(&order), 0.9), (ball(), 0.7)] {
        let [one, other] = [mesh.clone(), reversed(&mesh)].map(|mesh| {
            let mut scene = empty(camera(3.0, 50.0));
            scene.lights.push(light(LightKind::Ambient, Rgb::gray(1.0)));
            let tinted =
                Material { opacity: 0.5, alpha_mode: AlphaMode::Blend, ..ambient_only(Rgb::gray(1.0)) };
            add(&mut scene, mesh, tinted, DMat4::IDENTITY);
            scene
        });
        for samples in COUNTS {
            for supersample in [false, true] {
                let options = DrawOptions { supersample, ..sampled(samples) };
                let frames = [&one, &other].map(|scene| picture(scene, 48, 48, &options));
                assert!(frames[0].alpha.iter().any(|alpha| *alpha > opacity), "it overlaps itself");
                let different =
                    (0..48 * 48).find(|i| frames[0].pixel(i % 48, i / 48) != frames[1].pixel(i % 48, i / 48));
                assert_eq!(different, None, "{samples} samples, supersampled: {supersample}");
            }
        }
    }
}
