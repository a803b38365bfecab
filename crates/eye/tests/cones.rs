//! The cones against the published fundamentals and other people's figures.

use glanz_color::{colorchecker, light, observer};
use glanz_eye::{Eye, Lens};

fn eye(name: &str) -> Eye {
    name.parse().expect("a name of an eye")
}

/// The fundamentals are published to six digits.
const DIGITS: f64 = 1e-6;

#[test]
fn eyes_of_32_years_are_the_standard_observers() {
    for (name, field) in [("lms2", "field:2"), ("lms10", "field:10")] {
        let (published, ours) = (observer(name).unwrap(), eye(field).observer());
        for (published, ours) in published.channels.iter().zip(&ours.channels) {
            assert_eq!(published.name, ours.name);
            for (i, (a, b)) in published.sensitivity.0.iter().zip(&ours.sensitivity.0).enumerate() {
                // S is not tabulated above 615 nm.
                if *a > 0.0 {
                    assert!((a - b).abs() < DIGITS, "{name} {} at {}: {a} {b}", ours.name, 300 + 5 * i);
                } else {
                    assert!(*b < 1e-5, "{name} {} at {}: {b}", ours.name, 300 + 5 * i);
                }
            }
        }
        assert_eq!(ours.reference, None, "the standard eye is its own reference");
    }
}

#[test]
fn the_lens_yellows_as_cie_170_1_has_it() {
    let expected = [
        ("age:20", [0.2391, 0.6297, 0.7642, 0.8605, 0.9945]),
        ("age:80", [0.0292, 0.1768, 0.3591, 0.5643, 0.9790]),
    ];
    for (name, values) in expected {
        let transmittance = eye(name).lens_transmittance();
        for (nm, value) in [420.0, 450.0, 500.0, 550.0, 650.0].into_iter().zip(values) {
            assert!((transmittance.at(nm) - value).abs() < 6e-5, "{name} at {nm}: {}", transmittance.at(nm));
        }
    }
}

#[test]
fn cie_203_changes_otherwise_with_age() {
    // From 32 to 70 years at 450 and 550 nm, in density.
    let density = |name: &str, nm: f64| -libm::log10(eye(name).lens_transmittance().at(nm));
    let grown =
        |lens: &str, nm| density(&format!("age:70{lens}"), nm) - density(&format!("age:32{lens}"), nm);
    for (lens, blue, green) in [("+lens:cie203", 0.3505, 0.0623), ("", 0.3172, 0.1054)] {
        assert!((grown(lens, 450.0) - blue).abs() < 1e-4, "{lens} {}", grown(lens, 450.0));
        assert!((grown(lens, 550.0) - green).abs() < 1e-4, "{lens} {}", grown(lens, 550.0));
    }
    let (same, standard) = (eye("lens:cie203"), Eye::default());
    assert!(
        (same.lens_transmittance().at(450.0) / standard.lens_transmittance().at(450.0) - 1.0).abs() < 1e-12
    );
}

#[test]
fn an_old_eye_gets_less_of_daylight_and_least_of_it_with_s() {
    // Sums by 5 nm from 390 to 780 nm; ours begin there, too.
    let expected = [("D65", [0.8129, 0.7561, 0.46777]), ("A", [0.85511, 0.79501, 0.49423])];
    for (name, values) in expected {
        let source = light(name).unwrap();
        let (old, young) =
            (eye("age:70").observer().response(&source), Eye::default().observer().response(&source));
        for (c, value) in values.into_iter().enumerate() {
            let part = old[c] / young[c];
            assert!((part - value).abs() < 1e-4, "{name} {c}: {part}");
        }
    }
}

#[test]
fn a_red_patch_stimulates_the_cones_as_computed_elsewhere() {
    let (d65, observer) = (light("D65").unwrap(), Eye::default().observer());
    let (_, patch) = colorchecker().find(|(name, _)| *name == "red").unwrap();
    let (seen, white) = (observer.response(&(patch * d65)), observer.response(&d65));
    for (c, expected) in [0.14294, 0.07197, 0.04794].into_iter().enumerate() {
        assert!((seen[c] / white[c] - expected).abs() < 1e-4, "{}", seen[c] / white[c]);
    }
}

#[test]
fn without_a_lens_ultraviolet_is_seen_and_with_one_it_is_not() {
    let lamp = light("UV365").unwrap();
    let seen = |name: &str| eye(name).observer().response(&lamp)[2];
    assert!(seen("aphakic") > 100.0 * seen("age:20"));
    let curve = eye("aphakic").cone(2);
    assert_eq!(curve.at(355.0), 0.0);
    assert!(curve.at(360.0) > 0.05 && curve.at(390.0) > 1.0, "most of it is let through");
    assert_eq!(eye("aphakic").lens, Lens::None);
}

#[test]
fn shifted_pigments_come_near_to_the_other_cones() {
    let distance = |a: &Eye, channel: usize, other: usize| {
        let (a, b) = (a.cone(channel), Eye::default().cone(other));
        a.0.iter().zip(&b.0).map(|(a, b)| (a - b) * (a - b)).sum::<f64>()
    };
    let mut last = distance(&Eye::default(), 1, 0);
    for shift in [5, 10, 15, 20] {
        let next = distance(&eye(&format!("deutan:{shift}")), 1, 0);
        assert!(next < last, "M moved by {shift} nm is nearer to L");
        last = next;
    }
    assert!(distance(&eye("protan:20"), 0, 1) < 0.1 * distance(&Eye::default(), 0, 1));
    assert_eq!(eye("deutan:0").observer().channels, Eye::default().observer().channels);
}

#[test]
fn rods_of_the_standard_eye_are_cie_1951_and_old_ones_get_less() {
    let scotopic = observer("scotopic").unwrap().channels[0].sensitivity;
    assert_eq!(Eye::default().rods(), scotopic);
    let d65 = light("D65").unwrap();
    let part = eye("age:70").rods().dot(&d65) / scotopic.dot(&d65);
    assert!((0.5..0.75).contains(&part), "{part}");
}

#[test]
fn fields_between_the_standards_lie_between_them() {
    let at = |field: &str| eye(field).cone(2).at(450.0) / eye(field).cone(2).at(500.0);
    assert!(at("field:2") < at("field:4") && at("field:4") < at("field:10"), "less macular pigment");
    for field in ["field:2.001", "field:9.999"] {
        let near = if field.starts_with("field:2") { "field:2" } else { "field:10" };
        for c in 0..3 {
            assert!((eye(field).cone(c).at(550.0) - eye(near).cone(c).at(550.0)).abs() < 2e-3, "{field} {c}");
        }
    }
}
