//! The classic block, its model's parameters, and opacity.

use super::{parse, scene};
use crate::AlphaMode;

/// The message and the advice.
fn error(text: &str) -> (String, String) {
    let error = parse(text).expect_err(text);
    (error.message, error.help.unwrap_or_default())
}

/// The parameters of the last lobe of the material `a`.
fn highlight(keys: &str) -> (String, Vec<f64>) {
    let materials = scene(&format!("[materials.a]\nspecular = 0.5\n{keys}")).materials;
    let lobe = materials[0].lobes.last().expect("there is one");
    (lobe.shape.info().name.to_owned(), lobe.shape.params())
}

#[test]
fn the_block_takes_the_parameters_of_its_model() {
    assert_eq!(highlight("model = 'ward'\nalpha = 0.1\nalpha_y = 0.4"), ("ward".to_owned(), vec![0.1, 0.4]));
    assert_eq!(highlight("model = 'cook-torrance'\nm = 0.3").1[0], 0.3);
    assert_eq!(highlight("shininess = 7"), ("phong".to_owned(), vec![7.0]));
    assert_eq!(highlight("alpha_y = 0.3\nmodel = 'ggx'").1[1], 0.3, "the order of keys does not count");
    let matte = "[materials.a]\ndiffuse = 0.5\nmodel = 'oren-nayar'\nsigma_deg = 35";
    let lobes = scene(matte).materials.remove(0).lobes;
    assert_eq!((lobes.len(), lobes[0].shape.info().name), (1, "oren-nayar"));
    assert_eq!(lobes[0].shape.params()[0], 35.0);
}

#[test]
fn alpha_is_a_width_where_the_model_has_one_and_else_opacity() {
    let of = |keys: &str| {
        let loaded = parse(&format!("[materials.a]\ndiffuse = 0.5\nspecular = 0.5\n{keys}")).expect(keys);
        let material = &loaded.scene.materials[0];
        (material.opacity, material.alpha_mode, loaded.notes)
    };
    assert_eq!(of("model = 'ward'\nalpha = 0.1"), (1.0, AlphaMode::Opaque, vec![]));
    assert_eq!(of("model = 'ward'\nalpha = 0.1\nopacity = 0.5"), (0.5, AlphaMode::Blend, vec![]));
    assert_eq!(of("opacity = 0.25"), (0.25, AlphaMode::Blend, vec![]));
    for keys in ["alpha = 0.25", "alpha = 0.25\nmodel = 'blinn-phong'"] {
        let (opacity, mode, notes) = of(keys);
        assert_eq!((opacity, mode, notes.len()), (0.25, AlphaMode::Blend, 1), "{keys}");
        assert!(
            notes[0].starts_with("material 'a': 'alpha' is taken as opacity, whose key is now 'opacity'")
        );
    }
    let lobes =
        parse("[materials.a]\nlobes = [{ shape = 'ward', alpha = 0.3 }]\nalpha = 0.5").expect("valid");
    assert_eq!((lobes.scene.materials[0].opacity, lobes.notes.len()), (0.5, 1));
    let (message, _) = error("[materials.a]\nalpha = 0.5\nopacity = 0.5");
    assert_eq!(message, "'alpha' beside 'opacity', which is its new name");
    let (message, _) = error("[materials.a]\nalpha = 1.5");
    assert_eq!(message, "expected an opacity between 0 and 1, found 1.5");
}

#[test]
fn an_unknown_key_is_told_with_the_parameters_of_the_model() {
    let (message, help) = error("[materials.a]\nmodel = 'ward'\nalpha_z = 1");
    assert_eq!(message, "unknown key 'alpha_z' in [materials.a]; did you mean 'alpha_y'?");
    assert!(
        help.starts_with("parameters of the model 'ward': alpha, alpha_y; known keys: library"),
        "{help}"
    );
    let (_, help) = error("[materials.a]\nmodel = 'ward'\nroughness = 0.3");
    assert!(help.contains("alpha is the square of a slider's roughness"), "{help}");
    let (message, help) = error("[materials.a]\nm = 0.3");
    assert!(message.starts_with("unknown key 'm' in [materials.a]"), "{message}");
    assert!(help.contains("'m' is a parameter of cook-torrance, cook-torrance-gaussian"), "{help}");
    let (_, help) = error("[materials.a]\nlobes = []\nm = 0.3");
    assert!(
        help.starts_with("a parameter stands in its lobe: { shape = \"cook-torrance\", m = … }"),
        "{help}"
    );
    let (message, _) = error("[materials.a]\nmodel = 'ward'\nalpha_y = 'wide'");
    assert_eq!(message, "expected a number for the parameter 'alpha_y'");
    let (message, _) = error("[materials.a]\nmodel = 'ward'\nalpha = 30");
    assert!(message.contains("parameter 'alpha' of model 'ward' is 30, but must be between"), "{message}");
}

#[test]
fn the_block_is_written_with_its_parameters() {
    let text = "[materials.a]\ndiffuse = 0.5\nspecular = 0.5\nmodel = 'ward'\nalpha = 0.1\nopacity = 0.5\n";
    let before = scene(text);
    let written = crate::file::write(&before, "files").expect("it can be written").text;
    assert!(written.contains("alpha = 0.1") && written.contains("opacity = 0.5"), "{written}");
    assert!(!written.contains("lobes"), "{written}");
    assert_eq!(scene(&written), before);
}

#[test]
fn measured_reflectance_lies_as_its_grain_does_and_is_turned_with_the_sample() {
    const FILE: &str = "measured = { file = 'measured/brushed-steel.csv' }";
    let text = format!("[materials.a]\n{FILE}\n[materials.b]\naniso_deg = 40\n{FILE}\n");
    let loaded = super::parse_str(&text, &super::examples(), &super::LoadOptions::default()).unwrap();
    let [a, b] = ["a", "b"].map(|name| {
        loaded.scene.materials.iter().find(|material| material.name == name).expect("it is there")
    });
    // The sample lay at 30°; either width may be the first. Readings have 5 % of noise.
    let off = (a.aniso.to_degrees() - 30.0).rem_euclid(90.0);
    assert!(off.min(90.0 - off) < 1.0, "{}", a.aniso.to_degrees());
    assert!((b.aniso - a.aniso - 40_f64.to_radians()).abs() < 1e-12, "{}", b.aniso);
    assert_eq!(a.lobes, b.lobes);
}
