//! Lights.

use glam::{DMat3, DVec3};

use super::WriteError;
use super::color::light as light_color;
use super::side_files::{SideFiles, exr};
use super::text::{Document, Table, degrees, inline, list, number, numbers, string, vector};
use crate::{AreaShape, Attenuation, Light, LightColor, LightColors, LightKind, Luminaire, Profile, Space};

/// Adds one of `[[lights]]`.
pub(super) fn write(light: &Light, document: &mut Document, files: &mut SideFiles) -> Result<(), WriteError> {
    let mut table = Table::default();
    table.put_unless(light.name.is_empty(), "name", string(&light.name));
    put_kind(&light.kind, &mut table, files)?;
    let by_distance = matches!(light.kind, LightKind::Point { .. } | LightKind::Spot { .. });
    if let Some(luminaire) = light.luminaire.as_ref().filter(|_| by_distance) {
        put_luminaire(luminaire, matches!(light.kind, LightKind::Point { .. }), &mut table);
    }
    put_colors(&light.colors, &light.kind, &mut table);
    let moves = !matches!(light.kind, LightKind::Ambient | LightKind::Environment { .. });
    table.put_unless(light.space == Space::World || !moves, "attached_to", string("camera"));
    document.section("[[lights]]", &table, false);
    Ok(())
}

fn put_kind(kind: &LightKind, table: &mut Table, files: &mut SideFiles) -> Result<(), WriteError> {
    match kind {
        LightKind::Ambient => table.put("kind", string("ambient")),
        LightKind::Directional { direction } => {
            table.put("kind", string("directional"));
            table.put("direction", vector(*direction));
        }
        LightKind::Point { position, attenuation } => {
            table.put("kind", string("point"));
            table.put("position", vector(*position));
            put_attenuation(attenuation, table);
        }
        LightKind::Spot { position, direction, cutoff, exponent, smooth_edge, attenuation } => {
            table.put("kind", string("spot"));
            table.put("position", vector(*position));
            table.put("direction", vector(*direction));
            match degrees(*cutoff) {
                Some(degrees) => table.put("cutoff_deg", degrees),
                None => table.put("cutoff_rad", number(*cutoff)),
            }
            table.put_unless(*exponent == 0.0, "exponent", number(*exponent));
            if let Some((inner, outer)) = smooth_edge {
                table.put("smooth_edge", numbers(&[*inner, *outer]));
            }
            put_attenuation(attenuation, table);
        }
        LightKind::Area { shape, position, direction, up, two_sided } => {
            put_area(*shape, *direction, *up, *two_sided, table);
            table.put("position", vector(*position));
        }
        LightKind::Environment { map, rotation } => {
            table.put("kind", string("environment"));
            if let Some(map) = map {
                table.put("file", string(&files.add("environment", "exr", exr(map)?)));
            }
            put_rotation(*rotation, table);
        }
    }
    Ok(())
}

fn put_area(shape: AreaShape, direction: DVec3, up: DVec3, two_sided: bool, table: &mut Table) {
    match shape {
        AreaShape::Rectangle { width, height } => {
            table.put("kind", string("rectangle"));
            table.put("size", numbers(&[width, height]));
            table.put("direction", vector(direction));
            table.put("up", vector(up));
        }
        AreaShape::Disk { radius } => {
            table.put("kind", string("disk"));
            table.put("radius", number(radius));
            table.put("direction", vector(direction));
        }
        AreaShape::Sphere { radius } => {
            table.put("kind", string("sphere"));
            table.put("radius", number(radius));
        }
    }
    let has_back = !matches!(shape, AreaShape::Sphere { .. });
    table.put_unless(!(two_sided && has_back), "two_sided", "true");
}

fn put_rotation(rotation: DMat3, table: &mut Table) {
    if rotation == DMat3::IDENTITY {
        return;
    }
    let about = libm::atan2(rotation.z_axis.x, rotation.x_axis.x).to_degrees();
    let rounded = (about * 1e6).round() / 1e6;
    let turned = |degrees: f64| DMat3::from_axis_angle(DVec3::Y, (degrees % 360.0).to_radians());
    match [rounded, about].into_iter().find(|degrees| turned(*degrees) == rotation) {
        Some(degrees) => table.put("rotate_deg", number(degrees)),
        None => {
            let rows = rotation.transpose();
            let rows = [rows.x_axis, rows.y_axis, rows.z_axis];
            table.put("rotation", list(rows.map(vector)));
        }
    }
}

fn put_attenuation(attenuation: &Attenuation, table: &mut Table) {
    match *attenuation {
        Attenuation::NONE => {}
        Attenuation::PHYSICAL => table.put("attenuation", string("physical")),
        Attenuation { constant, linear, quadratic } => {
            let mut factors = Table::default();
            factors.put_unless(constant == 0.0, "constant", number(constant));
            factors.put_unless(linear == 0.0, "linear", number(linear));
            factors.put_unless(quadratic == 0.0, "quadratic", number(quadratic));
            table.put("attenuation", factors.inline());
        }
    }
}

fn put_luminaire(luminaire: &Luminaire, has_axis: bool, table: &mut Table) {
    let Luminaire { profile, axis, c0 } = luminaire;
    table.put_unless(!has_axis || *axis == Luminaire::AXIS, "direction", vector(*axis));
    table.put("profile", profile_table(profile));
    table.put_unless(*c0 == Luminaire::c0_for(*axis), "profile_c0", vector(*c0));
    // Without a strength of its own the light would have the candela of the profile.
    table.put("intensity", "1.0");
}

fn profile_table(profile: &Profile) -> String {
    let planes = profile.candela.chunks(profile.gamma_deg.len().max(1));
    inline([
        ("c_deg", numbers(&profile.c_deg)),
        ("gamma_deg", numbers(&profile.gamma_deg)),
        ("candela", list(planes.map(numbers))),
    ])
}

fn put_colors(colors: &LightColors, kind: &LightKind, table: &mut Table) {
    let white = LightColor::Rgb(glanz_color::Rgb::WHITE);
    if *kind == LightKind::Ambient {
        table.put_unless(colors.ambient == white, "color", light_color(&colors.ambient));
        return;
    }
    let LightColors { ambient, diffuse, specular } = colors;
    table.put_unless(*diffuse == white, "color", light_color(diffuse));
    table.put_unless(ambient.is_black(), "ambient", light_color(ambient));
    table.put_unless(specular == diffuse, "specular", light_color(specular));
}
