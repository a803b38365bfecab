//! What holds for every material of the library.

use std::collections::BTreeSet;
use std::path::Path;

use super::*;
use crate::file::{LoadOptions, parse_material, parse_str};

#[test]
fn every_material_reads_without_a_remark_and_has_a_source() {
    for info in materials() {
        let text = format!("[materials.{}]\n{}", info.name, info.toml);
        let loaded = parse_str(&text, Path::new("."), &LoadOptions::default());
        let loaded = loaded.unwrap_or_else(|error| panic!("{error}\n{text}"));
        assert_eq!(loaded.notes, Vec::<String>::new(), "{}", info.name);
        assert_eq!(loaded.scene.materials, [info.material()], "{}", info.name);
        assert!(!info.material().lobes.is_empty(), "{}", info.name);
        assert!(info.source.len() > 10 && !info.title.is_empty(), "{}", info.name);
    }
}

#[test]
fn names_are_plain_words_and_no_two_are_the_same() {
    let plain = |name: &str| name.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'-');
    assert!(names().all(plain));
    assert_eq!(names().collect::<BTreeSet<_>>().len(), materials().len());
}

#[test]
fn every_category_has_materials_and_they_lie_together() {
    let mut found: Vec<Category> = materials().iter().map(|info| info.category).collect();
    found.dedup();
    assert_eq!(found, Category::ALL);
    assert!(Category::ALL.iter().all(|category| Category::named(category.name()) == Some(*category)));
}

#[test]
fn the_tables_are_complete() {
    let count = |category| materials().iter().filter(|info| info.category == category).count();
    assert_eq!((count(Category::OpenGl), count(Category::Ward1992), count(Category::Ngan2005)), (24, 10, 2));
    let metals = glanz_color::iors().iter().filter(|info| info.kind == glanz_color::IorKind::Metal);
    assert_eq!(count(Category::Metal), 3 * metals.count());
}

#[test]
fn a_row_of_wards_table_is_two_lobes_with_its_figures() {
    let brass = material("ward-rolled-brass").expect("it is listed");
    let found: Vec<_> = brass.lobes.iter().map(|lobe| (lobe.shape.info().name, lobe.tint.rgb())).collect();
    let gray = |value| Some(glanz_color::Rgb::gray(value));
    assert_eq!(found, [("lambert", gray(0.1)), ("ward", gray(0.33))]);
    assert_eq!(brass.lobes[1].shape.params(), [0.05, 0.16]);
}

#[test]
fn emerald_is_as_opengl_has_it() {
    let emerald = material("gl-emerald").expect("it is listed");
    let names: Vec<_> = emerald.lobes.iter().map(|lobe| lobe.shape.info().name).collect();
    assert_eq!(names, ["ambient", "lambert", "blinn-phong"]);
    assert_eq!(emerald.lobes[2].shape.params(), [76.8]);
}

#[test]
fn no_material_but_those_of_tables_gives_back_more_light_than_it_gets() {
    use crate::Tint;
    for info in materials().iter().filter(|info| info.category != Category::OpenGl) {
        let mut sum = [0.0_f64; 3];
        for lobe in info.material().lobes {
            // Tints by Fresnel's law and what lies under them are bounded by the shapes' own laws.
            if let Tint::Rgb(rgb) = lobe.tint {
                sum.iter_mut().zip(rgb.0).for_each(|(sum, fraction)| *sum += f64::from(fraction));
            }
        }
        assert!(sum.iter().all(|fraction| *fraction <= 1.0), "{}: {sum:?}", info.name);
    }
}

#[test]
fn a_misspelt_name_is_answered_with_a_near_one() {
    let error = material("golt").expect_err("no such material");
    assert_eq!(error.to_string(), "there is no material 'golt' in the library; did you mean 'gold'?");
    let error = material("zzzzzzzzzzz").expect_err("no such material");
    assert_eq!(error.to_string(), "there is no material 'zzzzzzzzzzz' in the library");
}

#[test]
fn keys_that_make_no_material_are_refused_with_their_place() {
    let error = parse_material("a", "lobes = [{ shape = 'lambart' }]").expect_err("no such shape");
    assert_eq!((error.line, error.column), (1, 20));
    assert!(error.message.contains("did you mean 'lambert'"), "{error}");
}
