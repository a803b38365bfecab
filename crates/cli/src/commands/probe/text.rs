//! A pixel in words and numbers.

use glanz_math::names::shown;
use glanz_render::ToneMap;
use glanz_render::{Arrival, PointPlace, Probe, ProbedLight, ProbedLobe, ProbedPoint, ProbedSurface, Shot};
use glanz_scene::{Scene, Shading};

use super::{light, material_name};
use crate::input::objects::object_name;
use crate::print::{line, number};

/// Values that differ by less than this, in parts of the greater, are the same.
const SAME: f32 = 1e-4;

/// Tells a pixel.
pub(super) fn of(probe: &Probe, scene: &Scene, shot: &Shot) -> String {
    let mut text = String::new();
    let (x, y) = probe.pixel;
    line(&mut text, format_args!("pixel {x},{y}: {}", codes(probe)));
    match &probe.surface {
        Some(found) => surface(&mut text, found, scene, shot),
        None => line(&mut text, format_args!("  no surface: the background")),
    }
    picture(&mut text, probe, shot);
    text
}

fn surface(text: &mut String, found: &ProbedSurface, scene: &Scene, shot: &Shot) {
    let side = if found.back { ", its back" } else { "" };
    let shading = match found.shading {
        Shading::Flat => "flat",
        Shading::Gouraud => "Gouraud",
        Shading::Phong => "Phong",
    };
    let object = shown(&object_name(scene, found.object)).into_owned();
    let material = shown(&material_name(scene, found.material)).into_owned();
    line(
        text,
        format_args!(
            "  object '{object}', material '{material}', {shading} shading, facet {}{side}",
            found.facet
        ),
    );
    line(
        text,
        format_args!(
            "  position {} m, {} m from the plane of the eye",
            vector(found.position),
            single(found.distance)
        ),
    );
    line(text, format_args!("  normal of the facet {}", vector(found.facet_normal)));
    if let Some(uv) = found.uv {
        line(text, format_args!("  texture coordinates {}", color(&uv)));
    }
    for point in &found.points {
        self::point(text, point, found, scene, shot);
    }
    sum(text, found);
}

/// What the points come to.
fn sum(text: &mut String, found: &ProbedSurface) {
    if !found.is_exact() {
        let message = "the points above are the corners of the triangle; the pixel gets the light of the polygon's corners along its scan line";
        line(text, format_args!("  {message}"));
    } else if found.points.len() > 1 {
        let sum: Vec<_> =
            found.points.iter().map(|p| format!("{} {}", single(p.weight), color(&p.light))).collect();
        line(text, format_args!("  interpolated {}", sum.join(" + ")));
    }
    if found.emission != [0.0; 3] {
        line(text, format_args!("  emission {}", color(&found.emission)));
    }
    line(text, format_args!("  light of the surface {}", color(&found.light)));
    if found.transmits {
        line(text, format_args!("  light from behind passes it: the rest of the pixel"));
    } else if found.opacity < 1.0 {
        line(text, format_args!("  opacity {}: the rest is what lies behind", single(found.opacity)));
    }
}

fn point(text: &mut String, point: &ProbedPoint, surface: &ProbedSurface, scene: &Scene, shot: &Shot) {
    let place = match point.place {
        PointPlace::Pixel => "at the pixel".to_owned(),
        PointPlace::Centroid => "at the centroid of the facet".to_owned(),
        PointPlace::Vertex(number) => format!("at vertex {number}, weight {}", single(point.weight)),
    };
    line(text, format_args!("  {place}"));
    if point.place != PointPlace::Pixel {
        line(text, format_args!("    position {} m", vector(point.position)));
    }
    line(
        text,
        format_args!(
            "    N {}   V {}   N·V {}",
            color(&point.normal),
            color(&point.to_viewer),
            single(point.cos_view)
        ),
    );
    if point.color != [1.0; 3] {
        line(text, format_args!("    colour of texture and vertices {}", color(&point.color)));
    }
    if point.alpha_scale != 1.0 {
        line(text, format_args!("    widths of lobes times {}", single(point.alpha_scale)));
    }
    line(text, format_args!("    ambient {}", color(&point.ambient)));
    for light in &point.lights {
        light_of(text, (light, &point.color), surface, scene, shot);
    }
    line(text, format_args!("    sum {}", color(&point.light)));
}

fn light_of(
    text: &mut String,
    (found, color_of): (&ProbedLight, &[f32; 3]),
    surface: &ProbedSurface,
    scene: &Scene,
    shot: &Shot,
) {
    let (number, kind) = light(scene, found.light);
    line(text, format_args!("    lights.{number}, {kind}: {}", color(&found.share)));
    if let Some(arrival) = &found.arrival {
        self::arrival(text, arrival);
    }
    if found.cone_ambient != [0.0; 3] {
        line(text, format_args!("      ambient in the cone {}", color(&found.cone_ambient)));
    }
    for lobe in &found.lobes {
        let material = &shot.prepared().materials[surface.material];
        let shape = &material.lobes[lobe.lobe].shape;
        line(text, format_args!("      {}: {}", shape.info().name, formula(lobe, found, color_of)));
    }
}

fn arrival(text: &mut String, arrival: &Arrival) {
    line(
        text,
        format_args!(
            "      L {}   R {}   H {}",
            color(&arrival.to_light),
            color(&arrival.mirrored),
            color(&arrival.half)
        ),
    );
    let [nl, rv, nh, vh] =
        [arrival.cos_light, arrival.cos_mirrored, arrival.cos_half, arrival.cos_view_half].map(single);
    line(text, format_args!("      N·L {nl}   R·V {rv}   N·H {nh}   V·H {vh}"));
    let mut parts = Vec::new();
    if let Some(distance) = arrival.distance {
        parts.push(format!("distance {} m", single(distance)));
    }
    parts.push(format!("attenuation {}", single(arrival.attenuation)));
    if let Some(cone) = arrival.cone {
        parts.push(format!("of which the cone {}", single(cone)));
    }
    match arrival.visible {
        Some(false) => parts.push("in shadow".to_owned()),
        Some(true) => parts.push("not in shadow".to_owned()),
        None => {}
    }
    if arrival.cos_light <= 0.0 {
        parts.push("from behind".to_owned());
    }
    line(text, format_args!("      {}", parts.join(", ")));
}

/// The formula of a lobe's share, with its numbers.
fn formula(lobe: &ProbedLobe, light: &ProbedLight, color_of: &[f32; 3]) -> String {
    let share = color(&lobe.share);
    let (Some(value), Some(layers), Some(tint)) = (lobe.value, lobe.layers, lobe.tint) else {
        return format!("integral over the light, {share}");
    };
    let mut factors = vec![format!("pi f_cos {}", single(value))];
    if layers != 1.0 {
        factors.push(format!("layers {}", single(layers)));
    }
    if let Some(attenuation) = light.arrival.map(|arrival| arrival.attenuation).filter(|a| *a != 1.0) {
        factors.push(format!("attenuation {}", single(attenuation)));
    }
    factors.push(format!("tint {}", color(&tint)));
    if lobe.colored && *color_of != [1.0; 3] {
        factors.push("colour".to_owned());
    }
    format!("{} = {share}", factors.join(" x "))
}

fn picture(text: &mut String, probe: &Probe, shot: &Shot) {
    line(text, format_args!("  middle of the pixel {}", color(&probe.middle)));
    if !same(&probe.middle, &probe.picture) {
        line(
            text,
            format_args!("  picture {}: its samples see more than the middle does", color(&probe.picture)),
        );
    }
    let settings = shot.develop_settings();
    let mut steps = vec![format!("linear sRGB {}", color(&probe.screen))];
    if settings.ev != 0.0 {
        steps.push(format!("exposure {} stops", single(settings.ev)));
    }
    if settings.tone_map != Default::default() {
        steps.push(format!("tone mapping {}", ToneMap::name(settings.tone_map)));
    }
    line(text, format_args!("  development: {} -> {}", steps.join(" -> "), codes(probe)));
}

fn codes(probe: &Probe) -> String {
    let [r, g, b, _] = probe.code;
    format!("{r} {g} {b} (#{r:02x}{g:02x}{b:02x})")
}

fn same(a: &[f32; 3], b: &[f32; 3]) -> bool {
    let most = a.iter().chain(b).fold(0.0f32, |most, c| most.max(c.abs()));
    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= SAME * most)
}

fn single(value: f32) -> String {
    number(f64::from(value))
}

fn vector(v: [f64; 3]) -> String {
    format!("({})", v.map(number).join(", "))
}

fn color(values: &[f32]) -> String {
    let texts: Vec<_> = values.iter().map(|value| single(*value)).collect();
    format!("({})", texts.join(", "))
}
