//! Extended lights by points against sums of other kinds.

use std::sync::Arc;

use glanz_render::prepare::EnvironmentMap as PreparedMap;
use glanz_render::{DrawOptions, ExactLighting, Half, PrepareOptions, View, draw, prepare};
use glanz_scene::{AreaShape, Attenuation, EnvironmentMap};

use super::areas::{PLACES, area};
use super::environments::{environment, map, room};
use super::*;

const VIEWS: [f64; 4] = [0.0, 30.0, 60.0, 80.0];

/// The lobes that errors are stated for, and narrow ones, ones with a grain, and ones that light passes.
fn all_lobes() -> Vec<(&'static str, Shape)> {
    let grained = |name| shape(name, &[("alpha", 0.05), ("alpha_y", 0.3)]);
    let mut all = lobes();
    all.extend([
        ("ggx .02", shape("ggx", &[("alpha", 0.02)])),
        ("beckmann .05", shape("beckmann", &[("alpha", 0.05)])),
        ("ggx .05 × .3", grained("ggx")),
        ("ward .05 × .3", grained("ward")),
        ("charlie .3", shape("charlie", &[("alpha", 0.3)])),
        ("ashikhmin-shirley 1000 × 10", shape("ashikhmin-shirley", &[("nu", 1000.0), ("nv", 10.0)])),
        ("ggx-transmission .1", shape("ggx-transmission", &[("alpha", 0.1), ("eta", 1.5)])),
        ("ggx-thin-transmission .1", shape("ggx-thin-transmission", &[("alpha", 0.1)])),
    ]);
    all
}

fn exact(points: u32) -> DrawOptions {
    DrawOptions { exact: Some(ExactLighting::new(points)), ..transparent() }
}

fn exact_value(scene: &Scene, points: u32) -> f64 {
    exact_values(scene, [points])[0]
}

/// The same by several numbers of points, prepared once.
fn exact_values<const N: usize>(scene: &Scene, points: [u32; N]) -> [f64; N] {
    let prepared = prepare(scene, &PrepareOptions::default()).unwrap();
    let view = View::new(&scene.camera.unwrap(), 1, 1).unwrap();
    points.map(|points| f64::from(draw(&prepared, &view, &exact(points)).rgb[0][0]))
}

/// ∫ L f_cos dω over a grid that is finer than the map and than any of the lobes.
fn by_fine_sum(map: &PreparedMap, shape: &Shape, degrees: f64) -> f64 {
    let narrowest = shape.params().iter().copied().filter(|value| *value > 0.0).fold(1.0, f64::min);
    let rows = if narrowest < 0.03 { 1440 } else { 640 };
    let columns = 2 * rows;
    let mut sum = 0.0;
    for row in 0..rows {
        let edge = |row: usize| libm::cos(std::f64::consts::PI * row as f64 / rows as f64);
        let weight = (edge(row) - edge(row + 1)) * 2.0 * std::f64::consts::PI / columns as f64;
        for column in 0..columns {
            let (u, v) = ((column as f64 + 0.5) / columns as f64, (row as f64 + 0.5) / rows as f64);
            let d = EnvironmentMap::direction(u, v);
            let value = lobe_value(shape, degrees, d);
            if value != 0.0 {
                sum += weight * value * f64::from(map.at(Vec3::new(d.x as f32, d.y as f32, d.z as f32))[0]);
            }
        }
    }
    sum
}

#[test]
fn a_room_is_summed_for_every_lobe() {
    let map = map(room);
    let prepared = PreparedMap::from(&*map);
    let mut table = String::new();
    let mut worst_of_all = [0.0_f64; 2];
    for (name, shape) in all_lobes() {
        let mut worst = [Worst::default(), Worst::default()];
        for degrees in VIEWS {
            let mut scene = surface(&shape, degrees);
            scene.lights.push(environment(Some(Arc::clone(&map))));
            let expected = by_fine_sum(&prepared, &shape, degrees);
            for (worst, got) in worst.iter_mut().zip(exact_values(&scene, [1024, 16384])) {
                let error = (got - expected) / map.mean()[0];
                worst.note(error, || format!("{degrees}°: {got:.5} for {expected:.5}"));
            }
        }
        for (worst, all) in worst.iter().zip(&mut worst_of_all) {
            table += &format!("{name}: {:.5} at {}\n", worst.0, worst.1);
            *all = all.max(worst.0);
        }
    }
    eprintln!("{table}");
    assert!(worst_of_all[0] < 0.06 && worst_of_all[1] < 0.01, "{table}");
}

/// ∫ f_cos dω over a light, by a grid of its points that is finer than any of the lobes.
fn by_area_sum(form: AreaShape, position: DVec3, shape: &Shape, degrees: f64) -> f64 {
    const N: usize = 600;
    let facing = -position.normalize();
    let across = DVec3::Y.cross(facing).normalize();
    let up = facing.cross(across);
    let at = |i: usize| (i as f64 + 0.5) / N as f64;
    let mut sum = 0.0;
    for i in 0..N {
        for j in 0..N {
            let (u, v) = (at(i), at(j));
            let (direction, solid) = match form {
                AreaShape::Rectangle { width, height } => {
                    let to = position + across * ((u - 0.5) * width) + up * ((v - 0.5) * height);
                    let (direction, squared) = (to.normalize(), to.length_squared());
                    (direction, -direction.dot(facing) * width * height / squared)
                }
                AreaShape::Disk { radius } => {
                    let (sin, cos) = (2.0 * std::f64::consts::PI * v).sin_cos();
                    let to = position + (across * cos + up * sin) * (radius * u.sqrt());
                    let (direction, squared) = (to.normalize(), to.length_squared());
                    let area = std::f64::consts::PI * radius * radius;
                    (direction, -direction.dot(facing) * area / squared)
                }
                AreaShape::Sphere { radius } => {
                    // The cone under which it is seen, in rings of equal solid angle.
                    let low = 1.0 - (1.0 - radius * radius / position.length_squared()).sqrt();
                    let cosine = 1.0 - low * u;
                    let (sin, cos) = (2.0 * std::f64::consts::PI * v).sin_cos();
                    let sine = (1.0 - cosine * cosine).sqrt();
                    let direction = -facing * cosine + (across * cos + up * sin) * sine;
                    (direction, 2.0 * std::f64::consts::PI * low)
                }
            };
            sum += lobe_value(shape, degrees, direction) * solid.max(0.0) / (N * N) as f64;
        }
    }
    sum
}

#[test]
fn areas_are_summed_for_every_lobe() {
    let forms = [
        AreaShape::Rectangle { width: 1.0, height: 0.6 },
        AreaShape::Disk { radius: 0.4 },
        AreaShape::Sphere { radius: 0.35 },
    ];
    let (mut table, mut worst_of_all) = (String::new(), 0.0_f64);
    for (name, shape) in all_lobes() {
        let mut worst = Worst::default();
        for (degrees, place) in [(0.0_f64, 0), (40.0, 1), (75.0, 2)] {
            let albedo = glanz_bsdf::albedo(&shape, degrees.to_radians().cos());
            let below = shape.info().side == glanz_bsdf::Side::Transmission;
            let side = DVec3::new(1.0, 1.0, if below { -1.0 } else { 1.0 });
            let position = DVec3::from_array(PLACES[place]) * side;
            for form in forms {
                let mut scene = surface(&shape, degrees);
                scene.lights.push(white(area(form, position)));
                let (got, expected) =
                    (exact_value(&scene, 1024), by_area_sum(form, position, &shape, degrees));
                let error = (got - expected) / albedo;
                worst.note(error, || format!("{form:?} from {degrees}°: {got:.5} for {expected:.5}"));
            }
        }
        table += &format!("{name}: {:.5} at {}\n", worst.0, worst.1);
        worst_of_all = worst_of_all.max(worst.0);
    }
    eprintln!("{table}");
    assert!(worst_of_all < 0.005, "{table}");
}

#[test]
fn uniform_environments_are_the_white_furnace() {
    for (name, shape) in all_lobes() {
        // An albedo is a mean over azimuths.
        for degrees in VIEWS.into_iter().filter(|_| !shape.is_anisotropic()) {
            let expected = glanz_bsdf::albedo(&shape, degrees.to_radians().cos());
            // As a picture for the narrowest lobe alone: it is blurred for each lobe that is prepared.
            let maps = [None, (name == "ggx .02").then(|| map(|_| 1.0))];
            for map in maps.into_iter().enumerate().filter(|(i, map)| *i == 0 || map.is_some()) {
                let mut scene = surface(&shape, degrees);
                scene.lights.push(environment(map.1));
                let got = exact_value(&scene, 4096);
                assert!((got - expected).abs() < 3e-3, "{name}, {degrees}°: {got} for {expected}");
            }
        }
    }
}

#[test]
fn halves_are_about_the_whole_and_more_points_are_nearer() {
    let map = map(room);
    let glossy = shape("ggx", &[("alpha", 0.2)]);
    let mut scene = surface(&glossy, 40.0);
    scene.lights.push(environment(Some(Arc::clone(&map))));
    let truth = by_fine_sum(&PreparedMap::from(&*map), &glossy, 40.0);
    let error = |points: u32| (exact_value(&scene, points) - truth).abs();
    assert!(error(16) < 0.2 * truth && error(16384) < 1e-3 * truth, "{} {}", error(16), error(16384));
    let half = |half| {
        let lighting = ExactLighting { half: Some(half), ..ExactLighting::new(1024) };
        f64::from(picture(&scene, 1, 1, &DrawOptions { exact: Some(lighting), ..transparent() }).rgb[0][0])
    };
    let halves = [half(Half::First), half(Half::Second)];
    assert!(halves[0] != halves[1]);
    assert!((0.5 * (halves[0] + halves[1]) - truth).abs() < 0.01 * truth, "{halves:?} for {truth}");
}

#[test]
fn an_edge_casts_a_half_shadow() {
    // A floor at z = 0 below a wall in the plane y = 0 from z = 0.5 to 1.5, and a square light at y = 2, z = 2 … seen
    // from the floor at y = −a the part of the light above the wall's edge is linear in a.
    let mut scene = surface(&shape("lambert", &[]), 0.0);
    let light = LightKind::Area {
        shape: AreaShape::Rectangle { width: 0.02, height: 1.0 },
        position: DVec3::new(0.0, 0.0, 2.0),
        direction: -DVec3::Z,
        up: DVec3::Y,
        two_sided: false,
    };
    scene.lights.push(white(light));
    let free = exact_value(&scene, 4096);
    let matte = Material::of_lobes("matte", vec![Lobe::new(shape("lambert", &[]), Rgb::WHITE)]);
    // Covers y > 0.05 at half the height: of the light, y > 0.1.
    let to_half = DMat4::from_translation(DVec3::new(0.0, 0.0, 1.0));
    add(&mut scene, rectangle([-4.0, 0.05, 4.0, 4.0], 0.0), matte, to_half);
    scene.render.shadows = true;
    let got = exact_value(&scene, 4096);
    // By hand: the light is a line along y; each of its points counts cos² θ / r², cos θ = 2 / r.
    let sum = |from: f64, to: f64| {
        let count = 10_000;
        let at = |i: usize| from + (to - from) * (i as f64 + 0.5) / count as f64;
        let value = |y: f64| 4.0 / (4.0 + y * y).powi(2);
        (0..count).map(|i| value(at(i))).sum::<f64>() * (to - from) / count as f64
    };
    let expected = sum(-0.5, 0.1) / sum(-0.5, 0.5);
    assert!((got / free - expected).abs() < 2e-3, "{} for {expected}", got / free);
}

#[test]
fn surroundings_are_hidden_by_what_stands_before_them() {
    // Below the middle of a disk-like roof that covers all directions within 45° of the normal: cos² 45° is left.
    let mut scene = surface(&shape("lambert", &[]), 70.0);
    scene.lights.push(environment(None));
    let free = exact_value(&scene, 4096);
    let matte = Material::of_lobes("matte", vec![Lobe::new(shape("lambert", &[]), Rgb::WHITE)]);
    // A disk of radius 1 at height 1, by its 64 corners.
    let disk = glanz_scene::Mesh::builtin("disk");
    let disk = disk.unwrap_or_else(|_| rectangle([-1.0, -1.0, 1.0, 1.0], 0.0));
    let is_disk = disk.positions.len() > 8;
    add(&mut scene, disk, matte, DMat4::from_translation(DVec3::Z));
    scene.render.shadows = true;
    let got = exact_value(&scene, 4096);
    // Of a square of half side 1 at height 1 the form factor is (4 / π) · (1 / √2) · atan(1 / √2).
    let square = 4.0 / std::f64::consts::PI * 0.5f64.sqrt() * 0.5f64.sqrt().atan();
    let expected = if is_disk { 0.5 } else { 1.0 - square };
    assert!((got / free - expected).abs() < 4e-3, "{} for {expected}", got / free);
}

#[test]
fn lamps_are_as_they_are() {
    let mut scene = surface(&shape("ggx", &[("alpha", 0.2)]), 30.0);
    let lamp = LightKind::Point { position: DVec3::new(-1.0, 0.5, 2.0), attenuation: Attenuation::NONE };
    scene.lights.push(white(lamp));
    assert_eq!(exact_value(&scene, 64), value(&scene));
}
