//! Every sample inside a surface is covered exactly once: no gaps and no double hits on shared edges.
//!
//! A pane of opacity 1/2 tells how often a pixel is hit: once leaves alpha 1/2, twice 3/4, never 0.

mod common;

use common::{Random, add, camera, empty, glow, picture, pixel_camera, transparent, triangles};
use glam::{DMat4, DVec3, Vec3};
use glanz_color::Rgb;
use glanz_render::Frame;
use glanz_scene::{AlphaMode, Camera, Material, Mesh, Scene};

const SIZE: u32 = 96;
/// Corners are rounded to 1/256 pixel: so much nearer to an outline a pixel may be on either side.
const EDGE: f64 = 1.0 / 128.0;

fn pane() -> Material {
    Material { opacity: 0.5, alpha_mode: AlphaMode::Blend, ..glow(Rgb([1.0, 0.5, 0.25])) }
}

fn scene_of(mesh: Mesh, camera: Camera) -> Scene {
    let mut scene = empty(camera);
    add(&mut scene, mesh, pane(), DMat4::IDENTITY);
    scene
}

/// How often each pixel was hit.
fn hits(frame: &Frame) -> Vec<u32> {
    let hit = |alpha: &f32| {
        let count = (-(1.0 - alpha).log2()).round() as u32;
        assert_eq!(*alpha, 1.0 - 0.5f32.powi(count as i32), "an alpha that no number of panes gives");
        count
    };
    frame.alpha.iter().map(hit).collect()
}

/// Fails unless every pixel is hit `expected(x, y)` times; `None` leaves a pixel out.
fn assert_hits(frame: &Frame, what: &str, expected: impl Fn(f64, f64) -> Option<u32>) {
    let mut compared = 0;
    for (i, found) in hits(frame).into_iter().enumerate() {
        let (x, y) = (i % frame.width, i / frame.width);
        if let Some(wanted) = expected(x as f64 + 0.5, y as f64 + 0.5) {
            compared += 1;
            assert_eq!(found, wanted, "{what}: pixel {x}, {y}");
        }
    }
    assert!(compared > frame.alpha.len() / 2, "{what}: only {compared} pixels compared");
}

/// Signed distance to a polygon's outline that is seen clockwise with y downwards, convex: positive
/// inside.
fn depth_inside(outline: &[[f64; 2]], x: f64, y: f64) -> f64 {
    let edges = (0..outline.len()).map(|i| (outline[i], outline[(i + 1) % outline.len()]));
    let sides = edges.map(|(a, b)| {
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        (dx * (y - a[1]) - dy * (x - a[0])) / (dx * dx + dy * dy).sqrt()
    });
    sides.fold(f64::INFINITY, f64::min)
}

/// Mesh positions (y upwards) of picture coordinates (y downwards).
fn on_picture(points: &[[f64; 2]]) -> Vec<Vec3> {
    points.iter().map(|p| Vec3::new(p[0] as f32, (f64::from(SIZE) - p[1]) as f32, 0.0)).collect()
}

/// Triangles around a shared point inside a convex outline, in both windings alternately.
fn fan_around(middle: [f64; 2], outline: &[[f64; 2]]) -> Mesh {
    let points: Vec<[f64; 2]> = [middle].into_iter().chain(outline.iter().copied()).collect();
    let count = outline.len() as u32;
    let corners = (0..count).flat_map(|i| {
        let (a, b) = (1 + i, 1 + (i + 1) % count);
        if i % 2 == 0 { [0, a, b] } else { [0, b, a] }
    });
    triangles(on_picture(&points), corners.collect())
}

/// Corners of a random convex polygon, clockwise on the screen.
fn outline(random: &mut Random, corners: usize, center: [f64; 2], radius: f64) -> Vec<[f64; 2]> {
    let mut angles: Vec<f64> = (0..corners).map(|_| random.between(0.0, core::f64::consts::TAU)).collect();
    angles.sort_by(f64::total_cmp);
    angles.iter().map(|a| [center[0] + radius * a.cos(), center[1] + radius * a.sin()]).collect()
}

#[test]
fn fans_around_a_shared_point_cover_every_pixel_once() {
    let mut random = Random(7);
    let radii = [0.4, 3.0, 30.0, 46.0, 400.0, 5e3, 1e5];
    for round in 0..40 {
        for radius in radii {
            let count = 3 + (round % 20);
            let center = [0, 1].map(|_| 48.0 + random.between(-0.5, 0.5));
            let outline = outline(&mut random, count, center, radius);
            // Somewhere inside: a mean of the corners with random weights, so slivers come too.
            let weights: Vec<f64> = outline.iter().map(|_| random.unit().powi(3) + 1e-3).collect();
            let total: f64 = weights.iter().sum();
            let middle = [0, 1]
                .map(|axis| outline.iter().zip(&weights).map(|(p, w)| p[axis] * w / total).sum::<f64>());
            let scene = scene_of(fan_around(middle, &outline), pixel_camera(SIZE, SIZE));
            let frame = picture(&scene, SIZE, SIZE, &transparent());
            assert_hits(&frame, &format!("fan {round} of radius {radius}"), |x, y| {
                // Where f32 cannot hold the corner to 1/256 pixel, the outline is uncertain.
                let unsure = EDGE + radius * 1e-6;
                let inside = depth_inside(&outline, x, y);
                (inside.abs() > unsure).then_some(u32::from(inside > 0.0))
            });
        }
    }
}

#[test]
fn fans_around_pixel_centres_and_along_pixel_rows_cover_every_pixel_once() {
    // All corners on pixel centres: every edge rule is used, at corners, on rows, columns, diagonals.
    let mut random = Random(11);
    for _ in 0..60 {
        let mut center = || random.between(8.0, 80.0).floor() + 0.5;
        let middle = [center(), center()];
        let outline = [[2.5, 2.5], [center(), 2.5], [90.5, 2.5], [90.5, 90.5], [center(), 90.5], [2.5, 90.5]];
        let scene = scene_of(fan_around(middle, &outline), pixel_camera(SIZE, SIZE));
        let frame = picture(&scene, SIZE, SIZE, &transparent());
        // The top-left rule: the top row and the left column of centres are in, the others out.
        let within = |v: f64| (2.5..90.5).contains(&v);
        assert_hits(&frame, "pixel centres", |x, y| Some(u32::from(within(x) && within(y))));
    }
}

/// A grid of cells that fills the picture and more, each cut along a random diagonal.
fn strips(random: &mut Random, cells: usize, jitter: f64) -> Mesh {
    let mut points = Vec::new();
    let at = |i: usize| -4.0 + 104.0 * i as f64 / cells as f64;
    for row in 0..=cells {
        for column in 0..=cells {
            let mut move_by =
                |i: usize| if i == 0 || i == cells { 0.0 } else { random.between(-jitter, jitter) };
            points.push([at(column) + move_by(column), at(row) + move_by(row)]);
        }
    }
    let mut corners = Vec::new();
    for row in 0..cells {
        for column in 0..cells {
            let a = (row * (cells + 1) + column) as u32;
            let (b, c, d) = (a + 1, a + cells as u32 + 1, a + cells as u32 + 2);
            let parts = if random.unit() < 0.5 { [a, c, d, a, d, b] } else { [a, c, b, b, c, d] };
            corners.extend(parts);
        }
    }
    triangles(on_picture(&points), corners)
}

#[test]
fn strips_of_triangles_fill_the_picture_once() {
    let mut random = Random(13);
    // From triangles of 20 pixels to ones of a fifth of a pixel.
    for cells in [4, 9, 33, 100, 500] {
        let jitter = 104.0 / cells as f64 * 0.2;
        let scene = scene_of(strips(&mut random, cells, jitter), pixel_camera(SIZE, SIZE));
        let frame = picture(&scene, SIZE, SIZE, &transparent());
        assert_hits(&frame, &format!("{cells} cells"), |_, _| Some(1));
    }
}

#[test]
fn slivers_between_points_on_a_line_leave_no_gap() {
    // A fan whose outer edge is cut in many by points on it: T-junctions filled by triangles without
    // area, or nearly so once the corners are rounded.
    let mut random = Random(17);
    for round in 0..50 {
        let (top, bottom) = (random.between(-9.0, 90.0), random.between(5.0, 105.0));
        let mut points =
            vec![[-5.0, -5.0], [101.0, -5.0], [-5.0, top], [101.0, bottom], [-5.0, 101.0], [101.0, 101.0]];
        let cuts = 12u32;
        let mut cut: Vec<f64> = (0..cuts).map(|_| random.unit()).collect();
        cut.sort_by(f64::total_cmp);
        points.extend(cut.iter().map(|t| [-5.0 + 106.0 * t, top + (bottom - top) * t]));
        let mut corners = vec![0, 2, 3, 0, 3, 1];
        // The sliver polygon between the straight edge and the points on it, as a fan.
        let line: Vec<u32> = core::iter::once(2).chain(6..6 + cuts).chain([3]).collect();
        for pair in line.windows(2) {
            corners.extend([4, pair[1], pair[0]]);
        }
        for pair in line.windows(2).skip(1) {
            corners.extend([2, pair[0], pair[1]]);
        }
        corners.extend([4, 5, 3]);
        let scene = scene_of(triangles(on_picture(&points), corners), pixel_camera(SIZE, SIZE));
        let frame = picture(&scene, SIZE, SIZE, &transparent());
        common::assert_sane(&frame, "slivers");
        for (i, found) in hits(&frame).into_iter().enumerate() {
            // Rounded slivers may fold over: odd numbers then, but never a gap.
            assert!(found >= 1, "round {round}: pixel {}, {} is not covered", i % 96, i / 96);
        }
    }
}

/// A plane of triangles below the eye, from behind it to the horizon.
fn ground(random: &mut Random, cells: usize) -> Mesh {
    let mut points = Vec::new();
    for row in 0..=cells {
        for column in 0..=cells {
            let mut jitter = |i: usize| if i == 0 || i == cells { 0.0 } else { random.between(-0.3, 0.3) };
            let x = (column as f64 + jitter(column)) / cells as f64 * 400.0 - 200.0;
            let z = (row as f64 + jitter(row)) / cells as f64 * 400.0 - 300.0;
            points.push(Vec3::new(x as f32, 0.0, z as f32));
        }
    }
    let mut corners = Vec::new();
    for row in 0..cells as u32 {
        for column in 0..cells as u32 {
            let a = row * (cells as u32 + 1) + column;
            let (b, c, d) = (a + 1, a + cells as u32 + 1, a + cells as u32 + 2);
            corners.extend([a, c, d, a, d, b]);
        }
    }
    triangles(points, corners)
}

#[test]
fn a_plane_that_reaches_behind_the_eye_covers_every_pixel_once() {
    let mut random = Random(19);
    for cells in [1, 2, 5, 16, 40] {
        for height in [0.01, 0.3, 5.0] {
            for up in [DVec3::Y, DVec3::new(0.3, 1.0, 0.1)] {
                let eye = DVec3::new(random.between(-3.0, 3.0), height, random.between(-3.0, 3.0));
                let target = eye + DVec3::new(random.between(-0.3, 0.3), -1.2, -1.0);
                let camera = Camera { eye, target, up, ..camera(1.0, 60.0) };
                let scene = scene_of(ground(&mut random, cells), camera);
                for size in [96, 700] {
                    let frame = picture(&scene, size, size, &transparent());
                    let what = format!("{cells} cells, eye at {height}, {size} pixels");
                    // The camera looks down so far that all of the picture shows the plane.
                    assert_hits(&frame, &what, |_, _| Some(1));
                }
            }
        }
    }
}

#[test]
fn corners_far_outside_the_picture_change_nothing() {
    // The same square as one quad, and cut into triangles whose corners are beyond the guard band.
    for reach in [100.0, 4e4, 1e6, 1e9] {
        let square = [[20.25, 30.75], [70.5, 30.75], [70.5, 80.25], [20.25, 80.25]];
        let mut points = square.to_vec();
        points.extend([[-reach, -reach], [reach, -reach], [reach, reach], [-reach, reach]]);
        let corners = (0..4u32).flat_map(|i| {
            let (a, b) = (i, (i + 1) % 4);
            [a, 4 + a, 4 + b, a, 4 + b, b]
        });
        let mut corners: Vec<u32> = corners.collect();
        corners.extend([0, 1, 2, 0, 2, 3]);
        let scene = scene_of(triangles(on_picture(&points), corners), pixel_camera(SIZE, SIZE));
        let frame = picture(&scene, SIZE, SIZE, &transparent());
        assert_hits(&frame, &format!("reach {reach}"), |_, _| Some(1));
    }
}

#[test]
fn clipped_and_unclipped_triangles_meet_without_gap() {
    // Some corners of these triangles lie behind the eye, those of their neighbours do not.
    let mut random = Random(23);
    for cells in 20..80 {
        let height = random.between(0.5, 12.0);
        let eye = DVec3::new(random.between(-3.0, 3.0), height, random.between(-3.0, 3.0));
        let target = eye + DVec3::new(random.between(-0.3, 0.3), -1.2, -1.0);
        let camera = Camera { eye, target, ..camera(1.0, 60.0) };
        let scene = scene_of(ground(&mut random, cells), camera);
        let frame = picture(&scene, 700, 700, &transparent());
        assert_hits(&frame, &format!("{cells} cells, eye at {height}"), |_, _| Some(1));
    }
}
