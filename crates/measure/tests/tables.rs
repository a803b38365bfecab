//! Tables over four angles: Zemax, LightTools, UTIA, CSAIL and SSDD.

use glanz_math::Vec3;
use glanz_measure::{
    Channels, Coordinates, Data, Facts, Format, Measured, Quantity, ReadError, ReadOptions, Table,
    write_zemax, zemax_nodes_deg,
};
use proptest::prelude::*;

fn at(theta_deg: f64, phi_deg: f64) -> Vec3<f64> {
    Vec3::from_angles(theta_deg.to_radians(), phi_deg.to_radians())
}

fn read(bytes: impl AsRef<[u8]>) -> Result<Measured, ReadError> {
    Measured::read(bytes.as_ref(), "a.dat", &ReadOptions::default())
}

fn line(error: &ReadError) -> (Option<u32>, String) {
    (error.line(), error.to_string())
}

/// A glossy paint, which depends on the azimuth of the light by `grain`.
fn paint(wi: Vec3<f64>, wo: Vec3<f64>, grain: f64) -> f64 {
    let half = (wi + wo).normalized();
    let slope = (half.x * half.x * (1.0 + grain) + half.y * half.y) / (half.z * half.z);
    0.1 + libm::exp(-slope / 0.04) / (wi.z + wo.z)
}

/// Values of a table at pairs of directions, against a function: the greatest difference as a part of the value.
fn most_error(measured: &Measured, azimuths: &[f64], f: &dyn Fn(Vec3<f64>, Vec3<f64>) -> f64) -> f64 {
    let mut most = 0.0_f64;
    for ti in [20.0, 40.0, 60.0] {
        for to in [10.0, 30.0, 60.0] {
            for phi_i in azimuths {
                for phi in [0.0, 20.0, 120.0, 180.0, -100.0] {
                    let (wi, wo) = (at(ti, *phi_i), at(to, phi_i + phi));
                    let value =
                        measured.value(wi, wo).unwrap_or_else(|| panic!("{ti} {to} {phi_i} {phi}"))[0];
                    most = most.max((value / f(wi, wo) - 1.0).abs());
                }
            }
        }
    }
    most
}

#[test]
fn a_zemax_file_is_read_as_it_was_written() {
    for (rotations, grain, azimuths) in [(1, 0.0, vec![0.0, 77.0]), (36, 0.5, vec![0.0, 50.0, 140.0])] {
        let table = Table::of_function(
            Coordinates::Specular,
            zemax_nodes_deg(rotations),
            Channels::Luminance,
            &mut |wi, wo| vec![paint(wi, wo, grain)],
        )
        .unwrap();
        let text = write_zemax(&table, "a paint\nof two lines").unwrap();
        let measured = read(&text).unwrap();
        assert_eq!((measured.format, measured.description.as_str()), (Format::Zemax, "a paint"));
        let Data::Table(again) = &measured.data else { panic!("it is a table") };
        assert_eq!((again.nodes_deg(), again.is_isotropic()), (table.nodes_deg(), rotations == 1));
        assert!(write_zemax(again, "a paint\nof two lines").unwrap() == text, "byte for byte");
        let most = most_error(&measured, &azimuths, &|wi, wo| paint(wi, wo, grain));
        assert!(most < 0.12, "{most}");
        // The total scatter of the block for 45° is the albedo.
        let tis: Vec<f64> = text.lines().filter_map(|line| line.strip_prefix("TIS ")?.parse().ok()).collect();
        let albedo = Facts::of(&measured).albedos[2].values[0];
        assert!((tis[7] - albedo).abs() < 0.05 * albedo || grain > 0.0, "{} {albedo}", tis[7]);
    }
}

/// Two angles of incidence, three azimuths, two radial angles.
const ZEMAX: &str = "\u{feff}# brown vinyl\r\nSource  Measured\r\nSymmetry  PlaneSymmetrical\r\nSpectralContent  Monochrome\r\n\
    ScatterType  BRDF\r\nSampleRotation  1\r\n0\r\nAngleOfIncidence  2\r\n0\t60\r\nScatterAzimuth 3\r\n0\t90\t180\r\n\
    ScatterRadial 3\r\n0\t20\t60\t\r\n\r\nMonochrome\r\nDataBegin\r\nTIS 0.1\r\n1\t2\t3\r\n1\t4\t5\r\n1\t6\t7\r\n\
    TIS 0.2\r\n10\t2.0D+1\t30\r\n# rim\r\n10\t40\t50\r\n10\t60\t0\r\nDataEnd\r\n";

#[test]
fn zemax_counts_angles_from_the_mirror_direction() {
    let measured = read(ZEMAX).unwrap();
    assert_eq!(measured.description, "brown vinyl");
    let value = |theta_i: f64, theta_o: f64, phi: f64| {
        Some((measured.value(at(theta_i, 180.0), at(theta_o, phi))?[0] * 1e3).round() / 1e3)
    };
    assert_eq!(value(60.0, 60.0, 0.0), Some(10.0));
    // Towards the normal lies azimuth 0, away from it 180°.
    assert_eq!((value(60.0, 40.0, 0.0), value(60.0, 80.0, 0.0)), (Some(20.0), Some(60.0)));
    assert_eq!(value(60.0, 0.0, 0.0), Some(30.0));
    // On both sides of the plane of the light there is the same.
    assert_eq!((value(0.0, 20.0, 90.0), value(0.0, 20.0, -90.0)), (Some(4.0), Some(4.0)));
    assert_eq!(value(75.0, 75.0, 0.0), Some(10.0), "half a step beyond the last");
    // The 0 lies below the horizon, and is none.
    assert_eq!(measured.readings().len(), 17);
    let mut extended = measured.extended(at(89.5, 180.0), at(70.0, 0.0)).unwrap();
    assert!(extended.remove(0) > 10.0);
}

#[test]
fn what_zemax_files_hold_is_written_as_brdf() {
    let options = ReadOptions { quantity: Some(Quantity::RadianceFactor), ..ReadOptions::default() };
    let measured = Measured::read(ZEMAX.as_bytes(), "a", &options).unwrap();
    let Data::Table(table) = &measured.data else { panic!("it is a table") };
    let again = read(write_zemax(table, "").unwrap()).unwrap();
    let (first, second) = (measured.readings(), again.readings());
    assert_eq!((first.len(), second.len()), (17, 17));
    assert!((0..17).all(|i| first.values(i) == second.values(i)));
    assert!((f64::from(second.values(0)[0]) - std::f64::consts::FRAC_1_PI).abs() < 1e-7);
}

#[test]
fn errors_of_zemax_files_have_their_line() {
    let wrong = |from: &str, to: &str| line(&read(ZEMAX.replacen(from, to, 1)).unwrap_err());
    assert_eq!(wrong("BRDF", "BTDF").0, Some(5));
    assert_eq!(
        wrong("0\t60", "0").1,
        "expected 1 blocks that begin with TIS (1 × 1 rotations × 1 incidences), found 2"
    );
    assert_eq!(
        wrong("0\t60", ""),
        (Some(8), "there are no angles of incidence below their number".to_owned())
    );
    assert_eq!(wrong("0\t60", "60\t0").1, "angles of the table must ascend, and 60 is followed by 0");
    assert_eq!(wrong("1\t4\t5", "1\tx\t5"), (Some(19), "expected a value, found 'x'".to_owned()));
    assert_eq!(wrong("DataBegin", "").0, Some(17));
    // A number that the list does not need, and a total that nobody has.
    let odd = read(
        ZEMAX.replacen("AngleOfIncidence  2", "AngleOfIncidence  99999999999", 1).replacen("0.2", "N/A", 1),
    );
    assert_eq!(odd.unwrap().notes, ["99999999999 angles of incidence are announced, and 2 are there"]);
    let cut = ZEMAX.find("TIS 0.2").unwrap();
    let error = line(&read(&ZEMAX[..cut]).unwrap_err());
    assert!(
        error
            .1
            .starts_with("expected 2 blocks that begin with TIS (1 × 1 rotations × 2 incidences), found 1")
    );
    let odd = read(ZEMAX.replacen("PlaneSymmetrical", "Round", 1)).unwrap();
    assert_eq!(odd.notes, ["the symmetry 'Round' is not known, and taken as Asymmetrical"]);
    let commas =
        read(ZEMAX.replace("2.0D+1", "20").replacen("1\t4\t5", "1,5\t4\t5", 1).replace("0.1\r", "0,1\r"));
    assert_eq!(commas.unwrap().readings().values(1)[0], 1.5);
}

#[test]
fn zemax_has_tristimulus_values() {
    let blocks = "DataBegin\nTIS 0.1\n1 2\n1 4\nDataEnd\n";
    let text = format!(
        "Source Measured\nSymmetry Asymmetrical\nSpectralContent XYZ\nScatterType BRDF\nAngleOfIncidence 1\n30\n\
         ScatterAzimuth 2\n0 180\nScatterRadial 2\n0 10\n\nTristimulusX\n{blocks}TristimulusY\n{}TristimulusZ\n{blocks}",
        blocks.replace("\n1 ", "\n5 ")
    );
    let measured = read(&text).unwrap();
    assert_eq!(measured.channels(), &Channels::Xyz);
    let value = measured.value(at(30.0, 0.0), at(30.0, 180.0)).unwrap();
    assert!(value.iter().zip([1.0, 5.0, 1.0]).all(|(got, want)| (got - want).abs() < 1e-9), "{value:?}");
}

#[test]
fn lighttools_counts_from_the_normal() {
    let block = |aoi: f64, side: &str, kind: &str, first: f64| {
        let row: Vec<String> = (0..8).map(|i| format!("{}", first + f64::from(i))).collect();
        format!(
            "AOI {aoi}\nPOI 0\nSide {side}\nWavelength 550\nScatterType {kind}\nTIS 0.5\n{}\n{}\n",
            row[..4].join(" "),
            row[4..].join(" ")
        )
    };
    let text = format!(
        "# LightTools\nSymmetry Asymmetric\nSpectralContent Monochrome\nScatterAzimuth 4\n0 90 180 270\nScatterRadial 2\n0 40\n\
         DataBegin\n{}{}{}DataEnd\n",
        block(0.0, "Front", "BRDF", 1.0),
        block(40.0, "Front", "BRDF", 11.0),
        block(0.0, "Front", "BTDF", 100.0)
    );
    let measured = read(&text).unwrap();
    assert_eq!((measured.format, measured.channels()), (Format::LightTools, &Channels::Luminance));
    assert!(measured.notes[0].starts_with("1 of 3 blocks"), "{:?}", measured.notes);
    let value = |phi: f64| (measured.value(at(40.0, 180.0), at(40.0, phi)).unwrap()[0] * 1e6).round() / 1e6;
    // Light comes from 90°: azimuth 90° is back to it, 270° the mirror direction.
    assert_eq!((value(180.0), value(0.0), value(90.0), value(-90.0)), (14.0, 18.0, 12.0, 16.0));
    assert_eq!(line(&read(text.replace("AOI 40", "AOI four")).unwrap_err()).0, Some(17));
    assert!(read(text.replace("BRDF", "BTDF")).unwrap_err().to_string().contains("none of 3 blocks"));
    let back = read(text.replace("Front", "Back")).unwrap();
    assert_eq!(back.notes[0], "the data are of the back of the sample");
}

/// A UTIA file of a function.
fn utia(f: &dyn Fn(Vec3<f64>, Vec3<f64>, usize) -> f64) -> Vec<u8> {
    let mut bytes = Vec::new();
    let axis = |step: f64, n: usize| (0..n).map(move |i| step * i as f64);
    for channel in 0..3 {
        for ti in axis(15.0, 6) {
            for pi in axis(7.5, 48) {
                for to in axis(15.0, 6) {
                    for po in axis(7.5, 48) {
                        bytes.extend(f(at(ti, pi), at(to, po), channel).to_le_bytes());
                    }
                }
            }
        }
    }
    bytes
}

#[test]
fn utia_tables_are_read_and_go_on_beyond_75_degrees() {
    let f = |wi: Vec3<f64>, wo: Vec3<f64>, c: usize| {
        0.3 + 0.1 * c as f64 + 0.1 * wi.x + 0.05 * wo.y + 0.02 * wo.x
    };
    let bytes = utia(&f);
    let measured = read(&bytes).unwrap();
    assert_eq!((measured.format, measured.is_isotropic()), (Format::Utia, false));
    let most = most_error(&measured, &[0.0, 52.0, 200.0], &|wi, wo| f(wi, wo, 0));
    assert!(most < 0.03, "{most}");
    for (ti, pi, to, po) in [(30.0, 60.0, 45.0, 352.5), (75.0, 345.0, 15.0, 7.5)] {
        let (wi, wo) = (at(ti, pi), at(to, po));
        let value = measured.value(wi, wo).unwrap();
        assert!((0..3).all(|c| (value[c] - f(wi, wo, c)).abs() < 1e-6), "nodes: {value:?}");
    }
    let [a, b, c] =
        [60.0, 75.0, 90.0 - 1e-7].map(|to| measured.value(at(30.0, 0.0), at(to, 90.0)).unwrap()[0]);
    assert!((2.0 * b - a - c).abs() < 1e-6, "a line: {a} {b} {c}");
    let options = ReadOptions { scale: Some(100.0), srgb_white: Some(140.0), ..ReadOptions::default() };
    let scaled = Measured::read(&utia(&|_, _, _| 70.0), "a", &options).unwrap();
    // sRGB's 0.5 stands for 0.214.
    assert!((scaled.value(at(10.0, 0.0), at(20.0, 0.0)).unwrap()[0] - 21.404).abs() < 1e-3);
    let negative = read(utia(&|_, _, _| -1.0)).unwrap();
    assert!(
        negative.notes.iter().any(|note| note == "248832 numbers below 0 are taken as 0"),
        "{:?}",
        negative.notes
    );
    let error = Measured::read(ZEMAX.as_bytes(), "a", &options).unwrap_err().to_string();
    assert!(error.contains("this one is of zemax"), "{error}");
}

#[test]
fn utia_takes_any_numbers() {
    let mut state = 1_u64;
    let mut number = || {
        state = state.wrapping_mul(0x9e37_79b9_7f4a_7c15).rotate_left(17);
        state.to_le_bytes()
    };
    let bytes: Vec<u8> = (0..1_990_656 / 8).flat_map(|_| number()).collect();
    use_all(&bytes);
}

/// A file of CSAIL's of a function of the middles of the cells, in degrees.
fn csail(sizes: [i32; 4], half: i32, f: &dyn Fn([f64; 4], usize) -> f64) -> Vec<u8> {
    let mut head = [0_i32; 16];
    head[..4].copy_from_slice(&sizes);
    (head[6], head[9], head[10]) = (1, half, 3);
    let mut bytes: Vec<u8> = head.iter().flat_map(|n| n.to_le_bytes()).collect();
    let [ti, to, d, p] = sizes;
    let middle = |i: i32, n: i32, most: f64| (f64::from(i) + 0.5) * most / f64::from(n);
    for channel in 0..3 {
        for i in 0..ti * to * d * p {
            let angles = [
                middle(i / (to * d * p), ti, 90.0),
                middle(i / (d * p) % to, to, 90.0),
                middle(i / p % d, d, if half == 1 { 180.0 } else { 360.0 }),
                middle(i % p, p, 360.0),
            ];
            bytes.extend((f(angles, channel) as f32).to_le_bytes());
        }
    }
    bytes
}

#[test]
fn csail_tables_are_cells() {
    for half in [0, 1] {
        let f = |[ti, to, d, p]: [f64; 4], c: usize| {
            1.0 + ti + 2.0 * to + 0.1 * d.min(360.0 - d) + 0.01 * p + c as f64
        };
        let bytes = csail([9, 9, 12, 8], half, &f);
        let measured = read(&bytes).unwrap();
        assert_eq!((measured.format, measured.channels()), (Format::Csail, &Channels::Rgb));
        let value = |ti: f64, to: f64, d: f64, p: f64| measured.value(at(ti, p), at(to, p + d)).map(|v| v[1]);
        for (ti, to, d, p) in
            [(25.0, 35.0, 45.0, 67.5), (25.0, 35.0, -45.0, 67.5), (50.0, 60.0, 100.0, 200.0)]
        {
            let (got, want) = (value(ti, to, d, p).unwrap(), f([ti, to, f64::abs(d), p], 1));
            assert!((got - want).abs() < 1e-3, "{got} {want}");
        }
        assert!(value(0.1, 89.0, 179.0, 0.0).is_some(), "cells reach to the ends");
    }
    let holes = read(csail([9, 9, 12, 8], 0, &|[ti, ..], _| if ti > 60.0 { -1.0 } else { 2.0 })).unwrap();
    assert_eq!(holes.notes[0], "2592 of 7776 cells have no data");
    assert_eq!(holes.value(at(80.0, 0.0), at(10.0, 0.0)), None);
    assert_eq!(holes.value(at(40.0, 0.0), at(10.0, 0.0)), Some(vec![2.0; 3]));
    // A wrong number makes it something else, and takes no memory.
    let mut bytes = csail([2, 2, 2, 2], 0, &|_, _| 1.0);
    bytes[3] = 0x7f;
    assert!(matches!(read(&bytes), Err(ReadError::Unknown(_))));
    let mut bytes = csail([2, 2, 2, 2], 0, &|_, _| 1.0);
    bytes[24] = 2;
    assert!(read(&bytes).unwrap_err().to_string().contains("are 2 and 0"));
}

/// The head of an SSDD file.
fn ssdd(keys: &str) -> String {
    format!(
        "VERSION 0.3\nSOFTWARE x\n\n# a comment\nDATA_TYPE brdf\nCOLOR_MODEL monochrome\n{keys}NAME a paint\n"
    )
}

#[test]
fn ssdd_tables_are_read_in_all_coordinates() {
    let spherical = "PARAM_TYPE spherical_coordinate_system\nREDUCTION_TYPE bilateral_symmetry\n\
                     PARAM0_LIST 0 60\nPARAM2_LIST 0 80\nPARAM3_LIST 0 180\n";
    let text = ssdd(spherical) + "DATA ascii\n1\n2\n# PARAM2: 80\n3\n4\n5\n6\n7\n8\n";
    let measured = read(&text).unwrap();
    assert_eq!((measured.format, measured.description.as_str()), (Format::Ssdd, "a paint"));
    let value = |wi, wo| measured.value(wi, wo).map(|value| value[0]);
    let is = |got: Option<f64>, want: f64| got.is_some_and(|got| (got - want).abs() < 1e-9);
    assert!(is(value(at(60.0, 30.0), at(80.0, 30.0)), 4.0) && is(value(at(60.0, 0.0), at(80.0, 180.0)), 8.0));
    assert!(is(value(at(60.0, 0.0), at(80.0, 90.0)), 6.0) && is(value(at(60.0, 0.0), at(80.0, -90.0)), 6.0));
    // The same as numbers of four bytes, behind other data.
    let mut bytes = ssdd("PARAM0_LIST 0 90\n").replace("brdf", "specular_reflectance").into_bytes();
    bytes.extend(b"DATA ascii\n0.5\n0.5\n");
    bytes.extend((ssdd(spherical).replace("VERSION 0.3\n", "") + "DATA binary\n").into_bytes());
    (1..=8).for_each(|n| bytes.extend((n as f32).to_le_bytes()));
    let binary = read(&bytes).unwrap();
    assert_eq!(binary.data, measured.data);
    assert_eq!(binary.notes, ["data of the type 'specular_reflectance' were not read"]);
    bytes.pop();
    assert!(read(&bytes).unwrap_err().to_string().starts_with("the file ends after 31 of 32 bytes"));
    let half = ssdd(
        "PARAM_TYPE half_difference_coordinate_system\nREDUCTION_TYPE bilateral_symmetry reciprocity\n\
         PARAM0_LIST 0 30 90\nPARAM2_LIST 0 90\nPARAM3_LIST 0 90\n",
    ) + "DATA ascii\n1\n2\n3\n1\n2\n3\n1\n2\n3\n1\n2\n3\n";
    let half = read(&half).unwrap();
    let [wi, wo] = Coordinates::HalfDifference.pair([15.0, 70.0, 40.0, 250.0].map(f64::to_radians));
    assert!((half.value(wi, wo).unwrap()[0] - 1.5).abs() < 1e-9);
    assert!((half.value(wo, wi).unwrap()[0] - 1.5).abs() < 1e-9, "light and detector change places");
}

#[test]
fn errors_of_ssdd_files_have_their_line() {
    let keys = "PARAM_TYPE spherical_coordinate_system\nPARAM0_LIST 0 60\nPARAM3_LIST 0\n";
    let text = ssdd(keys) + "DATA ascii\n1\n2\n";
    let wrong = |from: &str, to: &str| line(&read(text.replace(from, to)).unwrap_err());
    assert_eq!(
        wrong("monochrome", "cmyk").1,
        "COLOR_MODEL is 'cmyk', and must be monochrome, rgb, xyz or spectrum"
    );
    assert_eq!(wrong("\n2\n", "\n"), (Some(12), "the file ends after 1 of 2 values".to_owned()));
    assert_eq!(wrong("\n2\n", "\n2 3\n"), (Some(13), "expected 1 numbers, found 2".to_owned()));
    assert_eq!(wrong("ascii", "hex").0, Some(11));
    assert_eq!(wrong("0.3", "9.3").0, Some(1));
    assert_eq!(wrong("0 60", "0 sixty").0, Some(8));
    assert!(wrong("brdf", "btdf").1.contains("no data of the type brdf"));
}

/// A file of each reader.
fn samples() -> Vec<Vec<u8>> {
    let lighttools = "SpectralContent XYZ\nScatterAzimuth 2\n0 180\nScatterRadial 2\n0 40\nDataBegin\nAOI 0\nPOI 0\nSide Front\n\
                      TristimulusValue TrisX\nScatterType BRDF\nTIS 0.5\n1 2\n3 4\nDataEnd\n";
    let spherical =
        "PARAM_TYPE spherical_coordinate_system\nPARAM0_LIST 0 60\nPARAM2_LIST 0 80\nPARAM3_LIST 0\n";
    let mut ssdd_binary = (ssdd(spherical) + "DATA binary\n").into_bytes();
    (1..=4).for_each(|n| ssdd_binary.extend((n as f32).to_le_bytes()));
    vec![
        ZEMAX.as_bytes().to_vec(),
        lighttools.as_bytes().to_vec(),
        (ssdd(spherical) + "DATA ascii\n1\n2\n3\n4\n").into_bytes(),
        ssdd_binary,
        csail([2, 2, 2, 2], 0, &|_, _| 1.0),
    ]
}

/// Reads a file and looks into it.
fn use_all(bytes: &[u8]) {
    if let Ok(measured) = read(bytes) {
        let readings = measured.readings();
        for index in 0..readings.len() {
            let [wi, wo] = readings.pair(index);
            let _ = (measured.value(wi, wo), measured.extended(wo, wi));
        }
    }
}

proptest! {
    #[test]
    fn mutated_files_are_read_or_refused(
        which in 0usize..5,
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
        cut in any::<prop::sample::Index>(),
        is_cut in any::<bool>(),
    ) {
        let mut bytes = samples().swap_remove(which);
        for (at, byte) in &changes {
            let at = at.index(bytes.len());
            bytes[at] = *byte;
        }
        if is_cut {
            bytes.truncate(cut.index(bytes.len()));
        }
        use_all(&bytes);
    }

    #[test]
    fn mutated_words_are_read_or_refused(
        which in 0usize..3,
        changes in prop::collection::vec((any::<prop::sample::Index>(), 0usize..10), 1..4),
    ) {
        let words = ["", "-1", "1e300", "nan", "99999999999999", "0", "TIS", "#", "DataBegin", "1\u{b0}"];
        let text = String::from_utf8(samples().swap_remove(which)).unwrap();
        let mut parts: Vec<&str> = text.split_inclusive(char::is_whitespace).collect();
        for (at, word) in &changes {
            let at = at.index(parts.len());
            parts[at] = words[*word];
        }
        use_all(parts.join(" ").as_bytes());
    }
}
