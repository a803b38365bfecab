//! Texts of readings: pab and ALTA.

use glanz_math::Vec3;
use glanz_measure::{Channels, Format, Measured, Quantity, ReadError, ReadOptions};
use proptest::prelude::*;

fn at(theta: f64, phi: f64) -> Vec3<f64> {
    Vec3::from_angles(theta, phi)
}

fn read(text: &str) -> Result<Measured, ReadError> {
    Measured::read(text.as_bytes(), "a.txt", &ReadOptions::default())
}

fn is_near(a: Vec3<f64>, b: Vec3<f64>) -> bool {
    (a - b).dot(a - b) < 1e-20
}

const PAB: &str = "#Mountain\n#sample_name \"blue film\"\n#incident_angle\t30\t0\n#intheta\t30\n#inphi 0\n#upphi 90\n\
                   #format: theta phi DSF\n30 180 0.5\n60\t0\t0,25\n120 0 9\n";

#[test]
fn pab_has_one_light_for_a_file() {
    let measured = read(&PAB.replace("0,25", "0.25")).unwrap();
    assert_eq!(
        (measured.format, measured.quantity, measured.description.as_str()),
        (Format::Pab, Quantity::BrdfCos, "blue film")
    );
    let readings = measured.readings();
    assert_eq!((readings.len(), readings.channels()), (2, &Channels::Luminance));
    let [wi, wo] = readings.pair(1);
    let degrees = |theta: f64, phi: f64| at(theta.to_radians(), phi.to_radians());
    assert!(is_near(wi, degrees(30.0, 0.0)) && is_near(wo, degrees(60.0, 0.0)));
    assert!((readings.values(1)[0] - 0.5).abs() < 1e-6, "divided by the cosine");
    assert_eq!(measured.notes, ["1 rows of transmitted light were dropped"]);
    assert_eq!(read(PAB).unwrap().readings().values(1), readings.values(1), "a decimal comma");
    // Two files, one behind the other, of colours, light from below.
    let xyz = "#colorimetry: CIE-XYZ\n#format: theta phi BSDF\n#intheta 150\n#inphi 10\n120 0 1 2 3\n#intheta 100\n120 0 4 5 6\n";
    let measured = read(xyz).unwrap();
    let readings = measured.readings();
    assert_eq!((readings.channels(), readings.values(1)), (&Channels::Xyz, &[4.0, 5.0, 6.0][..]));
    assert!(
        is_near(readings.pair(0)[0], degrees(30.0, 10.0))
            && is_near(readings.pair(1)[0], degrees(80.0, 10.0))
    );
    assert!(measured.notes[0].contains("from below"), "{:?}", measured.notes);
}

#[test]
fn errors_of_pab_files_have_their_line() {
    let wrong = |from: &str, to: &str| {
        let error = read(&PAB.replace(from, to)).unwrap_err();
        (error.line(), error.to_string())
    };
    assert_eq!(wrong("0.5", "x"), (Some(8), "expected a row of numbers, found 'x'".to_owned()));
    assert_eq!(
        wrong("180 0.5", "180"),
        (Some(8), "expected two angles and one or three values, found 2 numbers".to_owned())
    );
    assert_eq!(wrong("DSF", "BTDF").0, Some(7));
    // Words for missing numbers are no angles.
    let angles = "the angles of the light and of the row must be finite numbers";
    assert_eq!(wrong("#inphi 0", "#inphi 1.#QNAN").1, angles);
    assert_eq!(wrong("30 180 0.5", "nan 180 0.5"), (Some(8), angles.to_owned()));
    assert_eq!(
        wrong("#incident_angle\t30\t0\n#intheta\t30\n", "").1,
        "#intheta or #incident_angle must stand above the first row"
    );
    assert!(wrong("30 180 0.5\n60\t0\t0,25\n", "").1.contains("no rows of reflected light"));
}

#[test]
fn alta_has_radians_in_columns_that_it_names() {
    let text = |input: &str, sizes: &str, rows: &str| {
        format!("#DIM {sizes}\n#PARAM_IN {input}\n#PARAM_OUT INV_STERADIAN_COSINE_FACTOR\n#VS 1\n\n{rows}")
    };
    let pair =
        |input: &str, sizes: &str, row: &str| read(&text(input, sizes, row)).unwrap().readings().pair(0);
    let [wi, wo] = pair("SPHERICAL_TL_PL_TV_PV", "4 1", "0.1 0.2 0.3 0.4 0.5 0.01\n");
    assert!(is_near(wi, at(0.1, 0.2)) && is_near(wo, at(0.3, 0.4)));
    let [wi, wo] = pair("ISOTROPIC_TV_TL_DPHI", "3 1", "0.3 0.1 2.0 0.5\n");
    assert!(is_near(wi, at(0.1, 0.0)) && is_near(wo, at(0.3, 2.0)));
    let [wi, wo] = pair("ISOTROPIC_TL_TV_PROJ_DPHI", "3 1", "0.1 -0.3 0.4 0.5\n");
    assert!(is_near(wi, at(0.1, 0.0)) && (wo.z - f64::cos(0.5)).abs() < 1e-12);
    // No angle of the half vector: light at θd, the detector opposite.
    let [wi, wo] = pair("RUSIN_TH_TD_PD", "3 1", "0 0.4 1.0 0.5\n");
    assert!(is_near(wi, at(0.4, 1.0)) && is_near(wo, at(0.4, 1.0 + std::f64::consts::PI)));
    let [wi, wo] = pair("CARTESIAN", "6 1", "0 0 1 0.6 0 0.8 0.5\n");
    assert!(is_near(wo, at(0.0, 0.0)) && (wi.x - 0.6).abs() < 1e-12);
    let measured = read(&text("RUSIN_TH_TD", "2 3", "0 0.4 1 2 3\n1.5 0.4 1 2 3\n")).unwrap();
    assert_eq!(
        (measured.format, measured.quantity, measured.channels()),
        (Format::Alta, Quantity::BrdfCos, &Channels::Rgb)
    );
    assert!((f64::from(measured.readings().values(0)[2]) - 3.0 / f64::cos(0.4)).abs() < 1e-6);
    assert_eq!(measured.notes, ["1 rows below the horizon were dropped"]);
    let wrong = |input: &str, sizes: &str, rows: &str| {
        let error = read(&text(input, sizes, rows)).unwrap_err();
        (error.line(), error.to_string())
    };
    assert_eq!(wrong("COS_TK", "1 1", "").0, Some(2));
    assert_eq!(
        wrong("CARTESIAN", "4 1", "1 2\n"),
        (Some(6), "CARTESIAN has 6 numbers, and #DIM says 4".to_owned())
    );
    assert_eq!(
        wrong("RUSIN_TH_TD", "2 1", "0 1\n").1,
        "expected 3 numbers (RUSIN_TH_TD and values), found 2"
    );
    assert_eq!(wrong("RUSIN_TH_TD", "2 31", "0 1\n").1, "#DIM says 31 values, and must say 1 or 3");
}

/// ALTA's head, and rows of numbers of 64 bits.
fn alta_binary(head: &str, rows: &[[f64; 4]], to_bytes: fn(f64) -> [u8; 8]) -> Vec<u8> {
    let numbers = rows.iter().flatten().flat_map(|number| to_bytes(*number));
    format!("#DIM 3 1\n#PARAM_IN ISOTROPIC_TV_TL_DPHI\n#FORMAT binary\n{head}")
        .into_bytes()
        .into_iter()
        .chain(numbers)
        .collect()
}

#[test]
fn a_file_of_nothing_is_told() {
    for text in ["", " \r\n\n"] {
        assert_eq!(
            read(text).unwrap_err().to_string(),
            "this is no file of measured reflectance that is known: 'a.txt' is empty"
        );
    }
}

#[test]
fn alta_in_binary_is_as_its_text() {
    let rows = [[0.3, 0.1, 2.0, 0.5], [0.4, 0.1, 2.0, 0.25]];
    let text = read("#DIM 3 1\n#PARAM_IN ISOTROPIC_TV_TL_DPHI\n0.3 0.1 2.0 0.5\n0.4 0.1 2.0 0.25\n").unwrap();
    let of = |bytes: &[u8]| Measured::read(bytes, "a.alta", &ReadOptions::default());
    let head = "#ENDIAN little\n#SAMPLE_COUNT 2\n#ALTA_END_HEADER\n";
    let little = alta_binary(head, &rows, f64::to_le_bytes);
    assert_eq!(of(&little).unwrap().data, text.data);
    let big = alta_binary("#ENDIAN big\n#SAMPLE_COUNT 2\n#BEGIN_STREAM\n", &rows, f64::to_be_bytes);
    assert_eq!(of(&big).unwrap().data, text.data);
    let wrong = |head: &str| of(&alta_binary(head, &rows, f64::to_le_bytes)).unwrap_err().to_string();
    let many = "#SAMPLE_COUNT 18446744073709551615\n#ALTA_END_HEADER\n";
    assert!(wrong(many).contains("rows, and 2 are there"), "{}", wrong(many));
    assert!(wrong("#ALTA_END_HEADER\n").contains("#SAMPLE_COUNT must say"));
    assert!(wrong("#PRECISION ieee754-single\n#ALTA_END_HEADER\n").contains("ieee754-double"));
    assert!(
        of(&alta_binary("", &[], f64::to_le_bytes)).unwrap_err().to_string().contains("the head must end")
    );
}

#[test]
fn alta_rows_whose_angles_are_no_numbers_are_dropped() {
    let rows = [[0.3, 0.1, 2.0, 0.5], [0.3, 0.1, f64::NAN, 0.5], [f64::INFINITY, 0.1, 2.0, 0.5]];
    let bytes = alta_binary("#SAMPLE_COUNT 3\n#ALTA_END_HEADER\n", &rows, f64::to_le_bytes);
    let measured = Measured::read(&bytes, "a.alta", &ReadOptions::default()).unwrap();
    assert_eq!(measured.readings().len(), 1);
    assert_eq!(measured.notes, ["2 rows with angles that are no numbers were dropped"]);
}

proptest! {
    #[test]
    fn mutated_texts_are_read_or_refused(
        is_pab in any::<bool>(),
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..5),
    ) {
        let alta = "#DIM 3 1\n#PARAM_IN ISOTROPIC_TV_TL_DPHI\n0.3 0.1 2.0 0.5\n";
        let mut bytes = if is_pab { PAB } else { alta }.as_bytes().to_vec();
        for (at, byte) in &changes {
            let at = at.index(bytes.len());
            bytes[at] = *byte;
        }
        let _ = Measured::read(&bytes, "x", &ReadOptions::default());
    }
}
