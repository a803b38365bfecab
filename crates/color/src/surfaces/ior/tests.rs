use super::*;
use crate::lights::light;
use crate::observers::{Observer, xyz_of_reflectance};

#[test]
fn every_index_loads_by_both_names_and_is_possible() {
    for info in iors() {
        let found = ior(info.name).expect("a listed index loads");
        assert_eq!(found, ior(info.title).expect("its title is a name, too"));
        assert!(found.eta.is_finite() && found.eta.0.iter().all(|v| *v > 0.0), "{}", info.name);
        assert!(found.k.is_finite() && found.k.0.iter().all(|v| *v >= 0.0), "{}", info.name);
        assert_eq!(found.k.max() > 1.0, info.kind == IorKind::Metal, "{}", info.name);
        assert!(found.normal_reflectance().0.iter().all(|r| (0.0..1.0).contains(r)), "{}", info.name);
        if info.kind == IorKind::Metal {
            assert!(info.range_nm.0 <= 300.0 && info.range_nm.1 >= 780.0, "{}", info.name);
        }
    }
    let error = ior("golt").expect_err("no such metal").to_string();
    assert_eq!(error, "there is no refractive index 'golt'; did you mean 'gold'?");
}

#[test]
fn glasses_have_the_index_and_the_abbe_number_of_their_data_sheets() {
    // n_d and ν_d = (n_d − 1) / (n_F − n_C) at 587.5618, 486.1327 and 656.2725 nm.
    let known = [("BK7", 1.51680, 64.17), ("SF10", 1.72825, 28.41), ("fused-silica", 1.45846, 67.82)];
    for (name, n_d, abbe) in known {
        let found = media::formula(name);
        let [d, f, c] = [587.5618, 486.1327, 656.2725].map(|nm| found.eta(nm));
        assert!((d - n_d).abs() < 5e-6, "{name}: {d}");
        assert!(((d - 1.0) / (f - c) - abbe).abs() < 0.01, "{name}: {}", (d - 1.0) / (f - c));
    }
}

#[test]
fn other_media_have_their_known_indices_for_yellow_light() {
    // At the sodium line, 589.3 nm; to the digits that handbooks agree on.
    let known = [
        ("diamond", 2.417, 1e-3),
        ("water", 1.3334, 1e-4),
        ("sapphire", 1.768, 5e-4),
        ("PMMA", 1.491, 1e-3),
        ("polycarbonate", 1.585, 1e-3),
    ];
    for (name, n, within) in known {
        let found = media::formula(name).eta(589.3);
        assert!((found - n).abs() < within, "{name}: {found}");
    }
}

#[test]
fn cauchys_formula_is_a_sum_of_powers() {
    let formula = Dispersion::Cauchy(&[1.5, 0.004, 1e-4]);
    assert!((formula.eta(500.0) - (1.5 + 0.004 / 0.25 + 1e-4 / 0.0625)).abs() < 1e-15);
    assert_eq!(formula.spectrum().at(500.0), formula.eta(500.0));
}

#[test]
fn gold_and_copper_are_coloured_and_silver_is_not() {
    let d65 = light("D65").expect("a light");
    let xyz = |name| {
        let reflectance = ior(name).expect("a metal").normal_reflectance();
        xyz_of_reflectance(&reflectance, &d65, &Observer::default())
    };
    let white = xyz_of_reflectance(&Spectrum::ONE, &d65, &Observer::default());
    let blue = |name| xyz(name)[2] / white[2];
    // Johnson and Christy: gold reflects about 38 % of blue light, silver more than 95 %.
    assert!((0.34..0.42).contains(&blue("Au")), "{}", blue("Au"));
    assert!(blue("Ag") > 0.95 && xyz("Ag")[1] > 0.95);
    assert!(xyz("Cu")[0] / white[0] > 1.25 * blue("Cu"));
    assert!(xyz("Au")[1] > xyz("Fe")[1] && xyz("Ag")[1] > xyz("Al")[1]);
}

#[test]
fn tables_of_metals_are_those_published() {
    // Johnson and Christy 1972, table I at 2.13 eV (582.1 nm). The grid's samples are means over some nm of
    // the lines between such points.
    for (name, eta, k) in [("Au", 0.29, 2.863), ("Ag", 0.05, 3.858)] {
        let found = ior(name).expect("a metal");
        let at = |spectrum: &Spectrum| spectrum.at(582.1);
        assert!((at(&found.eta) - eta).abs() < 0.02 && (at(&found.k) - k).abs() < 0.02, "{name}");
    }
}

#[test]
fn a_complex_number_is_an_index_of_all_wavelengths() {
    let metal = ior("0.27+2.8i").unwrap();
    assert_eq!((metal.eta.at(400.0), metal.k.at(700.0)), (0.27, 2.8));
    for same in ["0.27-2.8i", " 0.27 + 2.8j", "2.7e-1+2.8e0i"] {
        assert_eq!(ior(same).unwrap().k, metal.k, "{same}");
    }
    for wrong in ["1.5", "3i", "-1+2i", "1.5+i", "nan+1i", "1+99i"] {
        assert!(ior(wrong).is_err(), "{wrong}");
    }
}
