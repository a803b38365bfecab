//! Objects.

use glam::{DMat4, DVec3};

use super::mesh::of_object;
use super::names::Names;
use super::text::{Document, Table, list, number, numbers, string, vector};
use crate::Object;

/// Adds one of `[[objects]]`; `programs` are the values of the scene's.
pub(super) fn write(object: &Object, names: &Names, programs: &[String], document: &mut Document) {
    let mut table = Table::default();
    table.put_unless(object.name.is_empty(), "name", string(&object.name));
    let (mesh, has_colors) = of_object(&names.meshes[object.mesh]);
    table.put("mesh", mesh);
    table.put("material", string(&names.materials[object.material]));
    table.put_unless(!has_colors, "colors", string("mesh"));
    put_place(&object.transform, &mut table);
    if let Some(shading) = object.shading {
        table.put("shading", string(shading.name()));
    }
    if let Some(interpolation) = object.interpolation {
        table.put("interpolation", string(interpolation.name()));
    }
    if let Some(program) = object.program {
        table.put("program", programs[program].clone());
    }
    document.section("[[objects]]", &table, false);
}

/// Scale and translation where these give the same matrix, else the matrix.
fn put_place(transform: &DMat4, table: &mut Table) {
    let scale = DVec3::new(transform.x_axis.x, transform.y_axis.y, transform.z_axis.z);
    let translation = transform.w_axis.truncate();
    let mut made = DMat4::IDENTITY;
    if scale != DVec3::ONE {
        made = DMat4::from_scale(scale);
    }
    if translation != DVec3::ZERO {
        made = DMat4::from_translation(translation) * made;
    }
    if made != *transform || !scale.is_finite() {
        let rows = transform.transpose();
        let rows = [rows.x_axis, rows.y_axis, rows.z_axis].map(|row| numbers(&row.to_array()));
        table.put("matrix", list(rows));
        return;
    }
    let factor = if scale.x == scale.y && scale.y == scale.z { number(scale.x) } else { vector(scale) };
    table.put_unless(scale == DVec3::ONE, "scale", factor);
    table.put_unless(translation == DVec3::ZERO, "translate", vector(translation));
}
