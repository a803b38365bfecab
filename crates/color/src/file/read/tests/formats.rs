//! CGATS, XML and matrices.

use super::*;

#[test]
fn cgats_says_what_1_is_and_what_is_measured() {
    let table = |head: &str, fields: &str| {
        format!("{head}\nBEGIN_DATA_FORMAT\n{fields}\nEND_DATA_FORMAT\nBEGIN_DATA\n50 25\nEND_DATA\n")
    };
    let (lamp, found) = points(&table("SPECT\nSPECTRAL_NORM \"100.0\"", "SPEC_400 SPEC_500"));
    assert_eq!((lamp.quantity, &found[..]), (Quantity::Light, &[(400.0, 0.5), (500.0, 0.25)][..]));
    let black = table("SPECT\nMEAS_TYPE \"REFLECTIVE\"\nSPECTRAL_NORM \"5000\"", "400_NM 500_NM");
    let (black, found) = points(&black);
    assert_eq!((black.quantity, &found[..]), (Quantity::Reflectance, &[(400.0, 0.01), (500.0, 0.005)][..]));
    let (screen, _) = points(&table("CCSS\nDEVICE_CLASS \"DISPLAY\"", "R_400 R_500"));
    assert_eq!(screen.quantity, Quantity::Light);
    assert_eq!(points(&table("CGATS.17", "NM400 NM500")).0.quantity, Quantity::Reflectance);
}

#[test]
fn every_xml_and_cgats_tells_its_spectra() {
    let lamp = spectra(SPDX).remove(0);
    assert_eq!((lamp.name.as_str(), lamp.quantity), ("Lamp & co", Quantity::Light));
    assert_eq!((&lamp.nm[..], &lamp.values[..]), (&[400.0, 403.1][..], &[0.034, 0.037][..]));
    let patches = spectra(CGATS);
    assert_eq!((patches[0].name.as_str(), patches[1].name.as_str()), ("dark red", "A2"));
    assert_eq!(
        (&patches[1].nm[..], &patches[1].values[..]),
        (&[400.0, 410.0, 420.0][..], &[0.4, 0.5, 0.6][..])
    );
    assert_eq!(patches[0].notes, ["NUMBER_OF_SETS is 3, but there are 2 samples"]);
    let blue = spectra(CXF).remove(0);
    assert_eq!((blue.name.as_str(), blue.quantity), ("Blau", Quantity::Reflectance));
    assert_eq!((&blue.nm[..], &blue.values[..]), (&[400.0, 420.0, 440.0][..], &[0.1, 0.2, 0.3][..]));
}

#[test]
fn cgats_may_pair_wavelengths_with_values() {
    let text = "BEGIN_DATA_FORMAT\nSAMPLE_ID\tSPECTRAL_NM\tSPECTRAL_PCT\tSPECTRAL_NM\tSPECTRAL_PCT\n\
                END_DATA_FORMAT\nBEGIN_DATA\np 1\t410\t50\t400\t25\nEND_DATA\n";
    let patch = spectra(text).remove(0);
    assert_eq!((patch.name.as_str(), &patch.nm[..]), ("p 1", &[400.0, 410.0][..]));
    assert_eq!(patch.values, [0.25, 0.5]);
}

#[test]
fn matrices_are_read_from_both_formats() {
    let matrix = read_reradiation(bfc().as_bytes(), "a/ORANGE.BFC").unwrap();
    assert_eq!((matrix.name.as_str(), matrix.band_nm), ("ORANGE", 10.0));
    assert_eq!((&matrix.out_nm[..], &matrix.in_nm[..]), (&[400.0, 410.0][..], &[390.0, 400.0, 410.0][..]));
    assert_eq!(matrix.values, [0.2, 0.5, -0.001, 0.1, 0.05, 0.6]);
    assert!(matrix.notes.is_empty(), "remarks in the header change nothing: {:?}", matrix.notes);
    let matrix = read_reradiation(MATRIX.as_bytes(), "m.csv").unwrap();
    assert_eq!((matrix.band_nm, matrix.values[1], matrix.values[4]), (10.0, 0.5, 0.1));
    let grid = matrix.to_reradiation().unwrap();
    let excited: f64 = (0..97).map(|out| grid.get(out, 10)).sum();
    assert!((excited - 0.03).abs() < 1e-12, "{excited}");
}
