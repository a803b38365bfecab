//! Files read and written.

use glanz_math::Vec3;
use glanz_measure::{
    Channels, Data, Facts, Format, Measured, Merl, Quantity, ReadError, ReadOptions, Readings, Rgl,
    write_csv, write_merl, write_rgl,
};
use proptest::prelude::*;

fn at(theta_deg: f64, phi_deg: f64) -> Vec3<f64> {
    Vec3::from_angles(theta_deg.to_radians(), phi_deg.to_radians())
}

fn read(text: &str) -> Result<Measured, ReadError> {
    Measured::read(text.as_bytes(), "a.csv", &ReadOptions::default())
}

/// Cells that the look-up of dj_brdf finds for these pairs of angles, light first, in degrees.
const CELLS: [([f64; 4], [usize; 3]); 8] = [
    ([74.0, 171.4, 7.7, 118.1], [59, 34, 9]),
    ([24.4, -72.9, 24.7, -36.0], [45, 7, 88]),
    ([30.3, 10.0, 41.2, 170.0], [28, 35, 51]),
    ([62.5, -35.0, 20.7, 100.0], [48, 38, 148]),
    ([42.6, 76.6, 7.5, -83.7], [40, 24, 7]),
    ([0.5, -118.9, 61.1, 48.8], [52, 30, 0]),
    ([83.6, -151.1, 24.2, -53.8], [63, 43, 145]),
    ([26.8, -68.5, 20.3, -87.6], [45, 4, 48]),
];

#[test]
fn directions_fall_into_the_cells_of_merl() {
    for ([ti, pi, to, po], cell) in &CELLS {
        assert_eq!(Merl::cell(at(*ti, *pi), at(*to, *po)), *cell);
    }
}

#[test]
fn a_merl_file_is_read_as_it_was_written() {
    let f = |wi: Vec3<f64>, wo: Vec3<f64>| {
        let half = (wi + wo).normalized();
        [0.1, 0.2, 0.3].map(|x| x * half.z + 0.01 * wi.dot(half))
    };
    let bytes = write_merl(&Merl::of(&mut |wi, wo| f(wi, wo)));
    let measured = Measured::read(&bytes, "a.binary", &ReadOptions::default()).unwrap();
    assert_eq!((measured.format, measured.channels()), (Format::Merl, &Channels::Rgb));
    let Data::Merl(table) = &measured.data else { panic!("it is a table") };
    assert!(write_merl(table) == bytes, "byte for byte");
    for (wi, wo) in [(at(30.0, 20.0), at(50.0, 200.0)), (at(5.0, 0.0), at(70.0, 90.0))] {
        let (got, want) = (measured.value(wi, wo).unwrap(), f(wi, wo));
        assert!((got[2] - want[2]).abs() < 0.01 * want[2], "the nearest cell: {got:?} {want:?}");
        assert_eq!(measured.value(wi, wo), measured.value(wo, wi), "reciprocal pairs fall into one cell");
    }
    assert_eq!(measured.value(at(30.0, 0.0), at(95.0, 0.0)), None);
    assert!(measured.notes[0].contains("below the horizon"), "{:?}", measured.notes);
    let error = Measured::read(&bytes[..1000], "a", &ReadOptions::default()).unwrap_err();
    assert_eq!(error.to_string(), "the file ends after 1000 of 34992012 bytes");
}

/// A glossy paint.
fn paint(wi: Vec3<f64>, wo: Vec3<f64>) -> Vec<f64> {
    let half = (wi + wo).normalized();
    let glossy = libm::exp(-(1.0 - half.z * half.z) / (0.04 * half.z * half.z)) / half.z.powi(4);
    [0.2, 0.1, 0.05].map(|x| x + 0.5 * glossy / (wi.z + wo.z)).to_vec()
}

#[test]
fn an_rgl_file_is_read_as_it_was_written() {
    let table = Rgl::of_function(Channels::Rgb, "paint", &mut paint).unwrap();
    let bytes = write_rgl(&table);
    let measured = Measured::read(&bytes, "a.bsdf", &ReadOptions::default()).unwrap();
    assert_eq!((measured.format, measured.description.as_str()), (Format::Rgl, "paint"));
    let Data::Rgl(again) = &measured.data else { panic!("it is a table") };
    assert!(write_rgl(again) == bytes, "byte for byte");
    let (mut errors, steps) = (Vec::new(), [5.0, 20.0, 35.0, 50.0, 65.0, 75.0]);
    for ti in steps {
        for to in steps {
            for phi in [0.0, 60.0, 120.0, 175.0] {
                let (wi, wo) = (at(ti, 30.0), at(to, 30.0 + phi));
                let (got, want) = (measured.value(wi, wo).unwrap(), paint(wi, wo));
                errors.push((got[0] - want[0]).abs() / want[0]);
            }
        }
    }
    errors.sort_by(f64::total_cmp);
    let [median, most] = [0.5, 0.9].map(|part| errors[(part * errors.len() as f64) as usize]);
    assert!(median < 0.003 && most < 0.02, "{median} {most}");
    let readings = measured.readings();
    assert!(readings.len() > 30_000 && (0..readings.len()).all(|i| readings.values(i)[0] > 0.0));
}

/// Brushed metal, whose highlight is three times as wide across x as along it.
fn brushed(wi: Vec3<f64>, wo: Vec3<f64>) -> Vec<f64> {
    let half = (wi + wo).normalized();
    let slope = (half.x * half.x / 0.0225 + half.y * half.y / 0.2025) / (half.z * half.z);
    [0.2, 0.1, 0.05].map(|x| x + 0.5 * libm::exp(-slope) / (wi.z * wo.z).sqrt()).to_vec()
}

#[test]
fn an_anisotropic_rgl_file_is_read_as_it_was_written() {
    let table = Rgl::of_anisotropic_function(Channels::Rgb, "brushed", &mut brushed).unwrap();
    let bytes = write_rgl(&table);
    let measured = Measured::read(&bytes, "a.bsdf", &ReadOptions::default()).unwrap();
    assert!(!measured.is_isotropic() && measured.notes.is_empty(), "{:?}", measured.notes);
    let Data::Rgl(again) = &measured.data else { panic!("it is a table") };
    assert!(write_rgl(again) == bytes, "byte for byte");
    let mut errors = Vec::new();
    for ti in [5.0, 20.0, 35.0, 50.0, 65.0, 75.0] {
        for to in [8.0, 25.0, 40.0, 60.0, 72.0] {
            for phi_i in [-170.0, -60.0, 10.0, 77.0, 140.0] {
                for phi in [0.0, 50.0, 120.0, 160.0, 180.0, 200.0] {
                    let (wi, wo) = (at(ti, phi_i), at(to, phi_i + phi));
                    let (got, want) = (measured.value(wi, wo).unwrap(), brushed(wi, wo));
                    errors.push((got[0] - want[0]).abs() / want[0]);
                }
            }
        }
    }
    errors.sort_by(f64::total_cmp);
    let [median, most] = [0.5, 0.9].map(|part| errors[(part * errors.len() as f64) as usize]);
    assert!(median < 0.01 && most < 0.06, "{median} {most}");
    let message = Rgl::of_function(Channels::Luminance, "", &mut |_, _| vec![0.1]).unwrap_err().to_string();
    assert_eq!(message, "RGL's files have RGB or wavelengths, and not one channel");
}

#[test]
fn spectra_are_channels_of_rgl_files() {
    let nm = vec![400.0, 500.0, 600.0, 700.0];
    let table =
        Rgl::of_function(Channels::Wavelengths(nm.clone()), "grey", &mut |_, _| vec![0.1, 0.2, 0.3, 0.25]);
    let measured = Measured::read(&write_rgl(&table.unwrap()), "a", &ReadOptions::default()).unwrap();
    assert_eq!(measured.channels(), &Channels::Wavelengths(nm));
    let value = measured.value(at(40.0, 0.0), at(20.0, 100.0)).unwrap();
    assert!((value[3] - 0.25).abs() < 1e-3 && (value[0] - 0.1).abs() < 1e-3, "{value:?}");
}

#[test]
fn damaged_rgl_files_are_errors() {
    let bytes = write_rgl(&Rgl::of_function(Channels::Rgb, "", &mut paint).unwrap());
    for end in [12, 17, 40, 200, 400, 1000, bytes.len() - 1] {
        assert!(Measured::read(&bytes[..end], "a", &ReadOptions::default()).is_err(), "{end}");
    }
    // Each byte of the head changed.
    for byte in 12..420 {
        for change in [1, 0x80, 0xff] {
            let mut bytes = bytes.clone();
            bytes[byte] ^= change;
            // No panic; most are errors.
            let _ = Measured::read(&bytes, "a", &ReadOptions::default());
        }
    }
}

#[test]
fn tables_say_what_they_are() {
    let head = "theta_i_deg,phi_i_deg,theta_o_deg,phi_o_deg";
    let measured = read(&format!("# quantity pi_f\n{head},r,g,b\n30,180,20,0,0.3,0.2,0.1\n")).unwrap();
    assert_eq!(measured.quantity, Quantity::RadianceFactor);
    let one = |measured: &Measured| f64::from(measured.readings().values(0)[0]);
    assert!((one(&measured) - 0.3 / std::f64::consts::PI).abs() < 1e-7);
    let measured = read(&format!("# quantity: brdf_cos\n{head},Y\n30,180,60,0,0.1\n")).unwrap();
    assert!((one(&measured) - 0.2).abs() < 1e-6);
    assert_eq!(measured.channels(), &Channels::Luminance);
    // What the reader is told wins.
    let options = ReadOptions { quantity: Some(Quantity::Brdf), ..ReadOptions::default() };
    let measured =
        Measured::read(format!("# quantity pi_f\n{head},Y\n0,0,0,0,2\n").as_bytes(), "a", &options);
    assert_eq!(one(&measured.unwrap()), 2.0);
    // A table of one plane, as from a spreadsheet of a country with decimal commas.
    let measured = read("\u{feff}AOI;theta_o;450nm;550nm\n45;0;0,25;0,5\n45;30;;0,5\n").unwrap();
    assert_eq!(measured.channels(), &Channels::Wavelengths(vec![450.0, 550.0]));
    let readings = measured.readings();
    assert_eq!((readings.values(0), readings.values(1)[0].is_nan()), (&[0.25, 0.5][..], true));
    let [wi, wo] = readings.pair(1);
    assert!(wi.x < 0.0 && wo.x > 0.0, "the mirror direction is on the other side");
}

#[test]
fn angles_whose_unit_nobody_says_are_looked_at() {
    let head = "theta_in,phi_in,theta_out,phi_out,r,g,b\n";
    let measured = read(&format!("{head}0.5,0,1.2,3.14159265,1,1,1\n0.5,0,0.3,0,1,1,1\n")).unwrap();
    let [wi, wo] = measured.readings().pair(0);
    assert!((wi.z - 0.5_f64.cos()).abs() < 1e-12 && (wo.x + 1.2_f64.sin()).abs() < 1e-6);
    assert!(measured.notes[0].contains("taken as radians"), "{:?}", measured.notes);
    let measured = read(&format!("{head}30,0,60,180,1,1,1\n")).unwrap();
    assert!((measured.readings().pair(0)[1].z - 0.5).abs() < 1e-12);
}

#[test]
fn errors_of_tables_have_their_line() {
    let head = "theta_i_deg,phi_i_deg,theta_o_deg,phi_o_deg,r,g,b\n";
    let error = read(&format!("# a tile\n{head}1,2,3,4,0.1,0.2,0.3\n1,2,3,4,0.1,x,0.3\n")).unwrap_err();
    assert_eq!(error.line(), Some(4), "{error}");
    assert_eq!(error.to_string(), "column 'g': expected a number, found 'x'");
    assert!(read("a,b,c\n1,2,3\n").unwrap_err().to_string().starts_with("no columns of directions"));
    assert!(read("theta_i,theta_o,q\n1,2,3\n").unwrap_err().to_string().starts_with("no columns of values"));
    assert!(read(head).unwrap_err().to_string().contains("no rows"));
    assert!(matches!(read("hello"), Err(ReadError::Unknown(_))));
    let binary = Measured::read(&[0xff, 0xfe, 0, 1], "x.bin", &ReadOptions::default());
    assert_eq!(
        binary.unwrap_err().to_string(),
        "this is no file of measured reflectance that is known: 'x.bin' begins with ff fe 00 01"
    );
}

#[test]
fn weights_are_a_column_of_tables() {
    let head = "theta_i_deg,theta_o_deg,weight,Y\n";
    let readings = read(&format!("{head}10,20,0.25,0.3\n10,30,,0.4\n10,40,0,0.5\n")).unwrap().readings();
    assert_eq!([0, 1, 2].map(|i| readings.weight(i)), [0.25, 1.0, 0.0]);
    assert_eq!(readings.values(1), [0.4]);
    let again = read(&write_csv(&readings, Quantity::Brdf, "")).unwrap().readings();
    assert_eq!([0, 1, 2].map(|i| again.weight(i)), [0.25, 1.0, 0.0]);
    let error = read(&format!("{head}10,20,-1,0.3\n")).unwrap_err();
    assert_eq!(
        (error.line(), error.to_string().as_str()),
        (Some(2), "column 'weight': expected 0 or more, found -1")
    );
    let plain = read("theta_i_deg,theta_o_deg,Y\n10,20,0.3\n").unwrap().readings();
    assert!(!plain.has_weights() && !write_csv(&plain, Quantity::Brdf, "").contains("weight"));
}

#[test]
fn rows_without_an_angle_are_no_readings() {
    let head = "theta_i_deg,phi_i_deg,theta_o_deg,phi_o_deg,Y";
    let measured = read(&format!("{head}\n30,180,20,0,0.3\n30,nan,20,0,0.3\n30,180,20,,0.3\n")).unwrap();
    assert_eq!(measured.readings().len(), 1);
}

#[test]
fn astm_tables_are_in_radians() {
    let text = "ASTM E1392\r\nCOMMENT \"blue paint\"\r\nNUM_POINTS 3\r\n\
                VARS theta_i,phi_i,theta_s,phi_s,400nm,500nm\r\n\
                0.5,3.14159265,0.5,0.0,0.5,-0.01\r\n0.5,3.14159265,0.2,1.0,0.25,0.5\r\n";
    let measured = read(text).unwrap();
    assert_eq!((measured.format, measured.description.as_str()), (Format::Astm, "blue paint"));
    assert_eq!(measured.channels(), &Channels::Wavelengths(vec![400.0, 500.0]));
    let [wi, wo] = measured.readings().pair(0);
    assert!((wi.z - wo.z).abs() < 1e-12 && (wi.x + wo.x).abs() < 1e-6);
    assert!(measured.notes.iter().any(|note| note.contains("NUM_POINTS is 3, but there are 2")));
    assert!(measured.notes.iter().any(|note| note.contains("1 readings have negative values")));
    // With three angles the azimuth is the difference, whichever is named.
    let three = "VARS theta_i,phi_i,theta_s,465nm,525nm\n0.5,3.14159265,0.5,0.2,0.3\n";
    let [wi, wo] = read(three).unwrap().readings().pair(0);
    assert!((wi.x + wo.x).abs() < 1e-6 && wo.x > 0.4);
    let error = read(&text.replace("0.25,0.5\r\n", "0.25\r\n")).unwrap_err();
    assert_eq!((error.line(), error.to_string()), (Some(6), "expected 6 numbers, found 5".to_owned()));
    let error = read(&text.replace("0.2,1.0,0.25", "0.2,1.#QNAN,0.25")).unwrap_err();
    assert_eq!(error.line(), Some(6));
    assert!(error.to_string().starts_with("the angles of a row"), "{error}");
}

#[test]
fn facts_tell_albedo_reciprocity_and_a_wrong_quantity() {
    let white = |wi: Vec3<f64>, wo: Vec3<f64>| vec![0.25 + 0.0 * wi.z * wo.z; 3];
    let table = Rgl::of_function(Channels::Rgb, "", &mut |wi, wo| white(wi, wo)).unwrap();
    let facts = Facts::of(&Measured::read(&write_rgl(&table), "a", &ReadOptions::default()).unwrap());
    for albedo in &facts.albedos[..4] {
        let expected = 0.25 * std::f64::consts::PI;
        assert!((albedo.values[0] - expected).abs() < 0.004, "{albedo:?}");
        assert!(albedo.known > 0.999);
    }
    assert!(facts.reciprocity.is_some_and(|own| own.most < 0.02), "{:?}", facts.reciprocity);
    assert_eq!(facts.guess, None);
    // A reflectance factor of 0.9 as if it were a BRDF.
    let table = Merl::of(&mut |_, _| [0.9; 3]);
    let facts = Facts::of(&Measured::read(&write_merl(&table), "a", &ReadOptions::default()).unwrap());
    assert_eq!(facts.guess.map(|guess| guess.0), Some(Quantity::RadianceFactor));
    // A BRDF times the cosine, in a table that says nothing.
    let mut readings = Readings::new(Channels::Luminance);
    for theta in (0..85).step_by(5) {
        for phi in [60.0, 120.0, 200.0] {
            let wo = at(f64::from(theta), phi);
            readings.push(at(40.0, 180.0), wo, &[(0.25 * wo.z) as f32]);
        }
    }
    let text = write_csv(&readings, Quantity::Brdf, "");
    assert_eq!(Facts::of(&read(&text).unwrap()).guess.map(|guess| guess.0), Some(Quantity::BrdfCos));
}

proptest! {
    #[test]
    fn readings_come_back_from_tables(
        rows in prop::collection::vec((0.0f64..89.0, -180.0f64..180.0, 0.0f64..89.0, -180.0f64..180.0, 0.0f32..1e4), 1..40),
        kind in 0usize..3,
    ) {
        let mut readings = Readings::new(Channels::Luminance);
        for (ti, pi, to, po, value) in &rows {
            readings.push(at(*ti, *pi), at(*to, *po), &[*value]);
        }
        let again = read(&write_csv(&readings, Quantity::ALL[kind], "a\nb")).unwrap().readings();
        prop_assert_eq!(again.len(), readings.len());
        for index in 0..again.len() {
            let ([a, b], [c, d]) = (readings.pair(index), again.pair(index));
            prop_assert!((a - c).dot(a - c) < 1e-14 && (b - d).dot(b - d) < 1e-14);
            let (x, y) = (readings.values(index)[0], again.values(index)[0]);
            prop_assert!((x - y).abs() <= 1e-6 * x.abs());
        }
    }

    #[test]
    fn any_bytes_are_read_or_refused(bytes in prop::collection::vec(any::<u8>(), 0..300), text in "[ -~\n]{0,200}") {
        let _ = Measured::read(&bytes, "x", &ReadOptions::default());
        let _ = Measured::read(text.as_bytes(), "x", &ReadOptions::default());
        let _ = Measured::read(format!("theta_i_deg,theta_o_deg,Y\n{text}").as_bytes(), "x", &ReadOptions::default());
        let _ = Measured::read(format!("VARS theta_i,theta_s,phi_s,R,G,B\n{text}").as_bytes(), "x", &ReadOptions::default());
    }
}
