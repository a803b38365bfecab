//! How bright a model is by its own lamps, whose candela and lux mean bright days and dim rooms alike.

use glam::DVec3;
use glanz_color::Rgb;

use crate::{Attenuation, Light, LightColor, LightKind, Scene};

/// The share of the surface that lamps reach which is at most white.
const SHARE: f64 = 0.95;
/// About so many points of the surface are looked at.
const POINTS: usize = 20_000;
/// The most points of a triangle along each side.
const MOST_PER_SIDE: usize = 12;
/// Stops by which a picture may be darker or brighter and still shows all there is.
const DARKER: f64 = 2.0;
const BRIGHTER: f64 = 0.1;

/// The exposure in stops, a tenth at a time, with which a white matte surface is white where lamps reach it, but for a
/// few points; `None` if that is nearly 0, or if no lamp reaches anything.
pub(crate) fn of_lamps(scene: &Scene) -> Option<f64> {
    let brightness = brightness(scene)?;
    let stops = libm::floor(-libm::log2(brightness) * 10.0) / 10.0;
    (!(-BRIGHTER..=DARKER).contains(&stops)).then_some(stops)
}

/// What a white matte surface is where lamps reach it, 1 for white.
fn brightness(scene: &Scene) -> Option<f64> {
    let count: usize = scene.objects.iter().map(|object| scene.meshes[object.mesh].triangle_count()).sum();
    let stride = count.div_ceil(POINTS).max(1);
    let per_side = (1..=MOST_PER_SIDE).rev().find(|n| count * n * (n + 1) / 2 <= POINTS).unwrap_or(1);
    // Light and area of points, of which the lit ones count.
    let mut points: Vec<(f64, f64)> = Vec::new();
    for object in &scene.objects {
        let mesh = &scene.meshes[object.mesh];
        for triangle in mesh.triangles().step_by(stride) {
            let [a, b, c] =
                triangle.map(|i| object.transform.transform_point3(mesh.positions[i as usize].as_dvec3()));
            let cross = (b - a).cross(c - a);
            let Some(normal) = cross.try_normalize() else { continue };
            for (u, v) in grid(per_side) {
                let point = a + (b - a) * u + (c - a) * v;
                let light: f64 = scene.lights.iter().map(|light| light_at(light, point, normal)).sum();
                if light > 0.0 && light.is_finite() {
                    points.push((light, cross.length()));
                }
            }
        }
    }
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let all: f64 = points.iter().map(|(_, area)| area).sum();
    let mut below = 0.0;
    points.into_iter().find_map(|(light, area)| {
        below += area;
        (below >= SHARE * all).then_some(light)
    })
}

/// Points within a triangle, as parts of two of its sides.
fn grid(per_side: usize) -> impl Iterator<Item = (f64, f64)> {
    let step = 1.0 / per_side as f64;
    let at = move |i: usize| (i as f64 + 1.0 / 3.0) * step;
    (0..per_side).flat_map(move |i| (0..per_side - i).map(move |j| (at(i), at(j))))
}

/// What a lamp gives a matte surface on either side; what is no lamp gives nothing.
fn light_at(light: &Light, point: DVec3, normal: DVec3) -> f64 {
    let LightColor::Rgb(Rgb(channels)) = &light.colors.diffuse else { return 0.0 };
    let strength = channels.iter().copied().fold(0.0, f32::max);
    let from = |position: DVec3| ((position - point).normalize_or_zero(), (position - point).length());
    let share = match &light.kind {
        LightKind::Directional { direction } => normal.dot(direction.normalize_or_zero()).abs(),
        LightKind::Point { position, attenuation } => {
            let (towards, distance) = from(*position);
            normal.dot(towards).abs() * fading(attenuation, distance)
        }
        LightKind::Spot { position, direction, cutoff, attenuation, .. } => {
            let (towards, distance) = from(*position);
            let is_inside = -towards.dot(direction.normalize_or_zero()) > libm::cos(*cutoff);
            if is_inside { normal.dot(towards).abs() * fading(attenuation, distance) } else { 0.0 }
        }
        _ => 0.0,
    };
    f64::from(strength) * share
}

/// 1 / (c + l·d + q·d²).
fn fading(attenuation: &Attenuation, distance: f64) -> f64 {
    1.0 / (attenuation.constant + distance * (attenuation.linear + distance * attenuation.quadratic))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{LightColors, Material, Mesh};

    fn scene(kind: LightKind, intensity: f32) -> Scene {
        let plane = Mesh::builtin("plane").unwrap();
        let light = Light::new(kind, LightColors::direct(Rgb::gray(intensity)));
        Scene::new().with_mesh(plane, Material::default_gray()).with_light(light)
    }

    #[test]
    fn a_lamp_of_many_candela_is_taken_back_to_white() {
        let above = |intensity| scene(LightKind::Directional { direction: DVec3::NEG_Y }, intensity);
        assert_eq!(of_lamps(&above(1024.0)), Some(-10.0));
        assert_eq!(of_lamps(&above(1.0 / 1024.0)), Some(10.0));
        assert_eq!((of_lamps(&above(1.0)), of_lamps(&above(0.3)), of_lamps(&above(0.0))), (None, None, None));
        assert_eq!(of_lamps(&above(1.5)), Some(-0.6));
    }

    #[test]
    fn distance_and_cones_count() {
        let position = DVec3::new(0.0, 40.0, 0.0);
        let attenuation = Attenuation::PHYSICAL;
        let lamp = scene(LightKind::Point { position, attenuation }, 1600.0 * 8.0);
        // The plane is small beside its distance, so that all of it gets nearly 8.
        assert_eq!(of_lamps(&lamp), Some(-3.0));
        let spot = |direction: DVec3| {
            let kind = LightKind::Spot {
                position,
                direction,
                cutoff: 0.3,
                exponent: 0.0,
                smooth_edge: None,
                attenuation,
            };
            of_lamps(&scene(kind, 1600.0 * 8.0))
        };
        assert_eq!((spot(DVec3::NEG_Y), spot(DVec3::X)), (Some(-3.0), None));
    }
}
