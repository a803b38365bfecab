//! Surfaces that shine.

use glanz_bsdf::Side;
use glanz_scene::AreaShape;

use super::environments::stated;
use super::*;

pub(super) const VIEWS: [f64; 4] = [0.0, 30.0, 60.0, 80.0];

/// Where the lights are: above, in the mirror direction of flat views, and half below the horizon.
pub(super) const PLACES: [[f64; 3]; 3] = [[0.0, 0.0, 1.5], [-1.2, 0.3, 0.8], [-0.8, -0.6, 0.1]];

pub(super) fn area(form: AreaShape, position: DVec3) -> LightKind {
    LightKind::Area { shape: form, position, direction: -position, up: DVec3::Y, two_sided: false }
}

/// ∫ f_cos dω over the light, by a grid of points.
pub(super) fn by_sum(form: AreaShape, position: DVec3, shape: &Shape, degrees: f64) -> f64 {
    let (sin, cos) = degrees.to_radians().sin_cos();
    by_sum_seen(form, position, shape, Vec3::new(sin, 0.0, cos))
}

fn by_sum_seen(form: AreaShape, position: DVec3, shape: &Shape, wo: Vec3<f64>) -> f64 {
    const N: usize = 240;
    let facing = -position.normalize();
    let across = DVec3::Y.cross(facing).normalize();
    let up = facing.cross(across);
    let at = |i: usize| (i as f64 + 0.5) / N as f64 * 2.0 - 1.0;
    let mut sum = 0.0;
    for i in 0..N {
        for j in 0..N {
            let (u, v) = (at(i), at(j));
            let (half_u, half_v) = match form {
                AreaShape::Rectangle { width, height } => (0.5 * width, 0.5 * height),
                AreaShape::Disk { radius } | AreaShape::Sphere { radius } => (radius, radius),
            };
            let round = !matches!(form, AreaShape::Rectangle { .. });
            if round && u * u + v * v > 1.0 {
                continue;
            }
            let bulge = match form {
                AreaShape::Sphere { radius } => {
                    // The side towards the point, over its projection; its true visible cap ends a little earlier.
                    facing * radius * (1.0 - u * u - v * v).sqrt()
                }
                _ => DVec3::ZERO,
            };
            let to = position + across * (u * half_u) + up * (v * half_v) + bulge;
            let cell = 4.0 * half_u * half_v / (N * N) as f64;
            let normal = if bulge == DVec3::ZERO { facing } else { (to - position).normalize() };
            let direction = to.normalize();
            let cosine = (-direction.dot(normal)).max(0.0);
            // Of a sphere, a cell of the projection is so much more surface.
            let surface = if bulge == DVec3::ZERO { cell } else { cell / normal.dot(facing) };
            let pair = DirectionPair::new(wo, Vec3::new(direction.x, direction.y, direction.z));
            sum += shape.f_cos(&pair) * cosine * surface / to.length_squared();
        }
    }
    sum
}

fn compare(form: AreaShape) {
    let (mut table, mut all_fit) = (String::new(), true);
    for (name, set, [_, allowed]) in stated() {
        let shape = shape(name, set);
        let azimuths: &[f64] = if set.len() > 1 { &[0.0, 30.0, 90.0] } else { &[0.0] };
        let below = shape.info().side == Side::Transmission;
        let mut scene = surface(&shape, 0.0);
        scene.lights.push(white(area(form, DVec3::Z)));
        let mut prepared = prepare(&scene, &PrepareOptions::default()).unwrap();
        let mut worst = Worst::default();
        for place in PLACES {
            let position = DVec3::from_array(place) * DVec3::new(1.0, 1.0, if below { -1.0 } else { 1.0 });
            scene.lights[0] = white(area(form, position));
            prepared.update(&scene, &[Change::Light(0)]).unwrap();
            for (azimuth, degrees) in
                azimuths.iter().flat_map(|azimuth| VIEWS.map(|degrees| (azimuth, degrees)))
            {
                let (cos_o, turn) = (degrees.to_radians().cos(), azimuth.to_radians());
                let wo = Vec3::from_angles(degrees.to_radians(), turn);
                let albedo = glanz_bsdf::albedo_at(&shape, cos_o, turn);
                let (got, expected) = (value_from(&prepared, wo), by_sum_seen(form, position, &shape, wo));
                let error = (got - expected) / albedo;
                worst.note(error, || format!("{azimuth}° {degrees}°, {place:?}: {got:.5} for {expected:.5}"));
            }
        }
        table += &format!("{name} {set:?}: {:.4} of {allowed} at {}\n", worst.0, worst.1);
        all_fit &= worst.0 < allowed;
    }
    eprintln!("{form:?}\n{table}");
    assert!(all_fit, "{form:?}\n{table}");
}

#[test]
fn a_rectangle_gives_its_integral() {
    compare(AreaShape::Rectangle { width: 1.0, height: 0.6 });
}

#[test]
fn a_disk_gives_its_integral() {
    compare(AreaShape::Disk { radius: 0.4 });
}

#[test]
fn a_sphere_gives_its_integral() {
    compare(AreaShape::Sphere { radius: 0.35 });
}

#[test]
fn lobes_with_a_grain_are_summed_over_the_light() {
    let brushed = shape("ward", &[("alpha", 0.2), ("alpha_y", 0.4)]);
    let form = AreaShape::Rectangle { width: 0.8, height: 0.8 };
    for (degrees, place) in [(0.0, PLACES[0]), (40.0, PLACES[1])] {
        let position = DVec3::from_array(place);
        let mut scene = surface(&brushed, degrees);
        scene.lights.push(white(area(form, position)));
        let (got, expected) = (value(&scene), by_sum(form, position, &brushed, degrees));
        assert!((got / expected - 1.0).abs() < 0.02, "{degrees}°: {got} for {expected}");
    }
}

#[test]
fn a_light_shines_on_its_front_alone_unless_it_has_two() {
    let lambert = shape("lambert", &[]);
    let away = |two_sided| LightKind::Area {
        shape: AreaShape::Disk { radius: 0.3 },
        position: DVec3::Z,
        direction: DVec3::Z,
        up: DVec3::Y,
        two_sided,
    };
    let with = |two_sided| {
        let mut scene = surface(&lambert, 0.0);
        scene.lights.push(white(away(two_sided)));
        value(&scene)
    };
    assert_eq!(with(false), 0.0);
    assert!((with(true) - 0.09 / 1.09).abs() < 1e-4);
}

#[test]
fn a_mirror_shows_the_light_where_it_is() {
    let mirror = shape("mirror", &[]);
    for (form, size) in [
        (AreaShape::Rectangle { width: 0.4, height: 0.4 }, 0.2),
        (AreaShape::Disk { radius: 0.2 }, 0.2),
        (AreaShape::Sphere { radius: 0.2 }, 0.2),
    ] {
        for (shift, lit) in [(0.0, 1.0), (0.9 * size, 1.0), (1.2 * size, 0.0)] {
            let mut scene = surface(&mirror, 0.0);
            let mut kind = area(form, DVec3::new(0.0, 0.0, 2.0));
            let LightKind::Area { position, .. } = &mut kind else { unreachable!() };
            position.x += shift;
            scene.lights.push(white(kind));
            assert_eq!(value(&scene), lit, "{form:?}, {shift}");
        }
    }
}

#[test]
fn small_and_far_lights_give_what_their_solid_angle_says() {
    let lambert = shape("lambert", &[]);
    for (radius, distance) in [(1e-1, 10.0), (1e-2, 10.0), (1e-4, 10.0), (1e-6, 10.0), (7e8, 1.5e11)] {
        for sphere in [false, true] {
            let form = if sphere { AreaShape::Sphere { radius } } else { AreaShape::Disk { radius } };
            let mut scene = surface(&lambert, 0.0);
            scene.lights.push(white(area(form, DVec3::new(0.6, 0.0, 0.8) * distance)));
            let expected = radius * radius / (distance * distance) * 0.8;
            let got = value(&scene);
            assert!((got / expected - 1.0).abs() < 2e-3, "{form:?} at {distance} m: {got} for {expected}");
        }
    }
}

#[test]
fn light_from_behind_does_not_come_round_in_glossy_lobes() {
    let form = AreaShape::Rectangle { width: 1.0, height: 1.0 };
    for (name, lobe) in lobes().into_iter().filter(|(name, _)| *name != "lambert-transmission") {
        let mut scene = surface(&lobe, 80.0);
        // Upright, so that its edge is well below the horizon.
        let kind = LightKind::Area {
            shape: form,
            position: DVec3::new(-1.2, 0.0, -0.6),
            direction: DVec3::X,
            up: DVec3::Y,
            two_sided: true,
        };
        scene.lights.push(white(kind));
        assert_eq!(value(&scene), 0.0, "{name}");
    }
}

#[test]
fn lights_without_bounds_fill_half_of_what_there_is() {
    let lambert = shape("lambert", &[]);
    for (sin, cos) in [(0.0, 1.0), (0.6, 0.8), (0.96, 0.28)] {
        for size in [1e4, 1e6, 1e8, 1e10, 1e11, 1e12] {
            for form in [AreaShape::Disk { radius: size }, AreaShape::Rectangle { width: size, height: size }]
            {
                let mut scene = surface(&lambert, 0.0);
                scene.lights.push(white(area(form, DVec3::new(sin, 0.0, cos) * 3.0)));
                let (got, expected) = (value(&scene), 0.5 * (1.0 + cos));
                assert!((got - expected).abs() < 5e-4, "{form:?}, {cos}: {got} for {expected}");
            }
        }
    }
}
