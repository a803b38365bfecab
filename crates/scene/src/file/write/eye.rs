//! The eye that looks.

use glanz_eye::{Eye, RodColor, Viewer, Viewing};

use super::text::{Table, list, number, string};

/// All of an eye that is not the default; nothing for the standard one.
pub(super) fn table(viewer: &Viewer) -> Table {
    let mut table = Table::default();
    who(&viewer.eye, &mut table);
    how(&viewer.viewing, &mut table);
    table
}

fn who(eye: &Eye, table: &mut Table) {
    let usual = Eye::default();
    table.put_unless(eye.age == usual.age, "age", number(eye.age));
    table.put_unless(eye.field_deg == usual.field_deg, "field_deg", number(eye.field_deg));
    let shift = list(eye.shift_nm.map(number));
    table.put_unless(eye.shift_nm == usual.shift_nm, "shift_nm", shift);
    let missing = Eye { cones: eye.cones, ..Eye::default() }.to_string();
    table.put_unless(eye.cones == usual.cones, "deficiency", string(&missing));
    let lens = serde_json::to_string(&eye.lens).expect("a name");
    table.put_unless(eye.lens == usual.lens, "lens", lens);
    table.put_unless(eye.lens_density == usual.lens_density, "lens_density", number(eye.lens_density));
    let macula = number(eye.macula_density);
    table.put_unless(eye.macula_density == usual.macula_density, "macula_density", macula);
    let pigments = list(eye.pigment_density.map(number));
    table.put_unless(eye.pigment_density == usual.pigment_density, "pigment_density", pigments);
    table.put_unless(eye.iris == usual.iris, "iris", number(eye.iris));
}

fn how(viewing: &Viewing, table: &mut Table) {
    let usual = Viewing::default();
    let mut optional = |name: &str, value: Option<f64>| {
        if let Some(value) = value {
            table.put(name, number(value));
        }
    };
    optional("level", viewing.level_cd_m2);
    optional("adaptation_cd_m2", viewing.adaptation_cd_m2);
    optional("px_per_deg", viewing.px_per_deg);
    table.put_unless(viewing.adapted == usual.adapted, "adapted", number(viewing.adapted));
    table.put_unless(viewing.rods == RodColor::White, "rods", string("blue"));
    table.put_unless(!viewing.glare, "glare", "true");
    table.put_unless(!viewing.chromatic, "chromatic", "true");
    if let Some(seed) = viewing.noise {
        table.put("noise", seed.to_string());
    }
    table.put_unless(!viewing.acuity, "acuity", "true");
    table.put_unless(!viewing.night, "night", "true");
    if let Some(gaze) = viewing.gaze {
        table.put("gaze", list(gaze.map(number)));
    }
}
