use super::*;
use crate::lights::light;

fn xy(light: &Spectrum, observer: &Observer) -> (f64, f64) {
    let [x, y, z] = xyz_of_light(light, observer);
    (x / (x + y + z), y / (x + y + z))
}

#[test]
fn the_sums_of_the_1931_functions_at_1_nm_are_those_of_cie() {
    let within = cie1931_by_1_nm().iter().filter(|(nm, _)| (380.0..=780.0).contains(nm));
    let sums = within.fold([0.0; 3], |sums, (_, xyz)| core::array::from_fn(|i| sums[i] + xyz[i]));
    for (sum, known) in sums.iter().zip([106.8551, 106.8564, 106.8461]) {
        assert!((sum - known).abs() < 5e-5, "{sum} {known}");
    }
}

#[test]
fn the_5_nm_table_holds_values_of_the_1_nm_table() {
    let observer = Observer::default();
    for (nm, xyz) in cie1931_by_1_nm().iter().filter(|(nm, _)| nm % 5.0 == 0.0 && *nm <= 780.0) {
        for (channel, value) in observer.channels.iter().zip(xyz) {
            assert!((channel.sensitivity.at(*nm) - value).abs() < 1e-8, "{nm} nm");
        }
    }
}

/// CIE 15:2004 gives chromaticities from sums over 380 … 780 nm by 5 nm.
fn from_380_nm(light: Spectrum) -> Spectrum {
    light * Spectrum::from_fn(|nm| if nm < 380.0 { 0.0 } else { 1.0 })
}

/// Chromaticities of CIE: name, x, y, digits after the point.
const KNOWN: [(&str, f64, f64, i32); 5] = [
    ("A", 0.44758, 0.40745, 5),
    ("D65", 0.31272, 0.32903, 5),
    ("D50", 0.3457, 0.3585, 4),
    ("FL2", 0.3721, 0.3751, 4),
    ("FL11", 0.3805, 0.3769, 4),
];

#[test]
fn chromaticities_of_lights_are_those_of_cie() {
    for (name, x, y, digits) in KNOWN {
        let light = from_380_nm(light(name).expect("a light"));
        let half = 0.5 * 10f64.powi(-digits);
        let found = xy(&light, &Observer::default());
        assert!((found.0 - x).abs() <= half && (found.1 - y).abs() <= half, "{name}: {found:?}");
    }
}

#[test]
fn the_ultraviolet_end_moves_chromaticities_by_less_than_3_in_the_fifth_digit() {
    for (name, ..) in KNOWN {
        let light = light(name).expect("a light");
        let (whole, cut) = (xy(&light, &Observer::default()), xy(&from_380_nm(light), &Observer::default()));
        assert!(
            (whole.0 - cut.0).abs() < 3e-5 && (whole.1 - cut.1).abs() < 3e-5,
            "{name}: {whole:?} {cut:?}"
        );
    }
}

#[test]
fn the_white_of_d65_is_known() {
    // ISO/CIE 11664-2 sums over 360 … 830 nm by 1 nm; above 780 nm that is beyond the digits given.
    let light = light("D65").expect("a light");
    let sums = cie1931_by_1_nm().iter().fold([0.0; 3], |sums: [f64; 3], (nm, xyz)| {
        core::array::from_fn(|i| sums[i] + light.at(*nm) * xyz[i])
    });
    for (sum, known) in sums.iter().zip([95.047, 100.0, 108.883]) {
        assert!((100.0 * sum / sums[1] - known).abs() < 5e-4, "{sums:?}");
    }
}

#[test]
fn sums_by_5_nm_give_that_white_to_4_digits() {
    let light = light("D65").expect("a light");
    let white = xyz_of_light(&light, &Observer::default());
    for (found, known) in white.iter().zip([0.95047, 1.0, 1.08883]) {
        assert!((found - known).abs() < 2e-4, "{white:?}");
    }
    assert_eq!(white, xyz_of_reflectance(&Spectrum::ONE, &light, &Observer::default()));
}

#[test]
fn every_observer_loads_and_sees() {
    for info in observers() {
        let observer = observer(info.name).expect("a listed observer loads");
        let channels = match info.kind {
            ObserverKind::Xyz | ObserverKind::Lms => 3,
            _ => 1,
        };
        assert_eq!((observer.channels.len(), observer.kind), (channels, info.kind));
        for channel in &observer.channels {
            assert!(channel.sensitivity.is_finite() && channel.sensitivity.0.iter().all(|v| *v >= 0.0));
            assert!(channel.sensitivity.max() > 0.4, "{} {}", info.name, channel.name);
        }
        assert!(observer.response(&Spectrum::ONE).iter().all(|response| *response > 10.0));
    }
    assert_eq!(observer("CIE1964").expect("capitals are fine").name, "cie1964");
    assert!(observer("cie1932").is_err());
}

#[test]
fn the_white_of_equal_energy_is_equal_in_all_xyz_observers() {
    for name in ["cie1931", "cie1964", "cie2015-2", "cie2015-10"] {
        let [x, y, z] = xyz_of_light(&Spectrum::ONE, &observer(name).expect("an observer"));
        // The functions are made so that their integrals are equal; sums at 5 nm differ a little.
        assert!((x - 1.0).abs() < 5e-4 && y == 1.0 && (z - 1.0).abs() < 5e-4, "{name} {x} {z}");
    }
}

#[test]
fn a_camera_is_made_of_its_channels() {
    let red = Channel { name: "R".to_owned(), sensitivity: Spectrum::ONE };
    let camera = Observer::from_channels("camera", vec![red]);
    assert_eq!((camera.kind, camera.response(&Spectrum::ONE)), (ObserverKind::Other, vec![485.0]));
    assert!(xyz_of_light(&Spectrum::ONE, &camera).iter().all(|v| v.is_nan()));
    assert!(xyz_of_light(&Spectrum::ZERO, &Observer::default()).iter().all(|v| v.is_nan()));
}
