//! What holds for all readers: what they read, and that no bytes do harm.

use proptest::prelude::*;

use crate::file::read::*;

mod instruments;
use crate::file::write::{write_csv, write_matrix_csv, write_spdx};
use crate::spectra::{Outside, Spectrum, TableError, lambda_nm};
use crate::surfaces::reradiation::Reradiation;

const CSV: &str = "# a comment\nWavelength (nm),red reflectance (%),\"lamp, warm [W/m2/nm]\"\n\
                   400,10,0.5\n410,12.5,0.25\n420,,0.125\n";
const SPDX: &str = r#"<?xml version="1.0"?>
<IESTM2714 xmlns="iestm2714" version="1.0">
  <Header><Description>Lamp &amp; co</Description></Header>
  <SpectralDistribution>
    <SpectralQuantity>irradiance</SpectralQuantity>
    <SpectralData wavelength="400.0">0.034</SpectralData>
    <SpectralData wavelength="403.1">0.037</SpectralData>
  </SpectralDistribution>
</IESTM2714>"#;
const CGATS: &str = "CGATS.17\rORIGINATOR \"a b\"\rNUMBER_OF_SETS 3\rBEGIN_DATA_FORMAT\r\
                     SAMPLE_ID SAMPLE_NAME LAB_L SPECTRAL_NM400 SPECTRAL_NM_410 nm420\rEND_DATA_FORMAT\r\
                     BEGIN_DATA\r1 \"dark red\" 30 0.1 0.2 0.3\r2 A2 40 0.4 0.5 0.6\rEND_DATA\r";
const CXF: &str = r#"<cc:CxF xmlns:cc="http://colorexchangeformat.com/CxF3-core"><cc:Resources>
  <cc:ObjectCollection>
    <cc:Object ObjectType="Standard" Name="Blau" Id="1"><cc:ColorValues>
      <cc:ReflectanceSpectrum ColorSpecification="CS1" StartWL="400">0.1 0.2 0.3</cc:ReflectanceSpectrum>
      <cc:ColorCIELab ColorSpecification="CS1"><cc:L>50</cc:L></cc:ColorCIELab>
    </cc:ColorValues></cc:Object>
  </cc:ObjectCollection>
  <cc:ColorSpecificationCollection><cc:ColorSpecification Id="CS1">
    <cc:MeasurementSpec><cc:WavelengthRange StartWL="380" Increment="20"/></cc:MeasurementSpec>
  </cc:ColorSpecification></cc:ColorSpecificationCollection>
</cc:Resources></cc:CxF>"#;
const MATRIX: &str = "nm;350;400;410\n400;0,01;0,5;0\n410;0,02;0,1;0,6\n";

/// A small file as the BFC-450 writes it.
fn bfc() -> String {
    let remarks = ";x.BFC\r\n;Orange\r\n;op\r\n;<none>\r\n;a\r\n;b\r\n;06/28/1999\r\n;12:14:30\r\n";
    format!(
        "VEC_01\t6\r\nBFC-450 Matrix File\r\n{remarks}400\t410\t10\t3\t390\t10\t\r\n\
         r:c:\t390\t400\t410\t\r\n400\t0.2\t0.5\t-0.001\t\r\n410\t0.1\t0.05\t0.6\t\r\nEOD\r\n"
    )
}

fn spectra_samples() -> [&'static str; 4] {
    [CSV, SPDX, CGATS, CXF]
}

fn matrix_samples() -> [String; 2] {
    [bfc(), MATRIX.to_owned()]
}

fn spectra(text: &str) -> Vec<NamedSpectrum> {
    read_spectra(text.as_bytes(), "folder/file.txt").unwrap_or_else(|error| panic!("{error}"))
}

/// The message of the one error that reading must give.
fn error_of(text: &str) -> String {
    let error = read_spectra(text.as_bytes(), "f").expect_err(text);
    assert_eq!(error.file(), "f");
    let message = error.to_string();
    assert!(message.starts_with("f: ") && message.contains(": expected "), "{message}");
    message
}

/// Checks what other code relies on.
fn check(spectra: &[NamedSpectrum]) {
    assert!(!spectra.is_empty());
    for spectrum in spectra {
        assert_eq!(spectrum.nm.len(), spectrum.values.len());
        assert!(!spectrum.nm.is_empty() && !spectrum.name.is_empty());
        assert!(spectrum.nm.windows(2).all(|pair| pair[0] < pair[1]));
        assert!(spectrum.values.iter().all(|value| value.is_finite()));
        match spectrum.to_spectrum(None) {
            Ok((found, _)) => assert!(spectrum.nm.len() > 1 && found.is_finite()),
            // What is told of more than one wavelength is a value that cannot be meant, or none where it counts.
            Err(TableError::OutOfBand { .. } | TableError::Negative { .. } | TableError::Scale { .. }) => {}
            Err(error) => assert!(spectrum.nm.len() == 1, "{error}"),
        }
    }
}

#[test]
fn a_csv_tells_names_units_and_gaps() {
    let [red, lamp] = &spectra(CSV)[..] else { panic!("two spectra") };
    assert_eq!((red.name.as_str(), red.quantity), ("red reflectance", Quantity::Reflectance));
    assert_eq!((&red.nm[..], &red.values[..]), (&[400.0, 410.0][..], &[0.1, 0.125][..]));
    assert_eq!((lamp.name.as_str(), lamp.quantity), ("lamp, warm", Quantity::Light));
    assert_eq!((lamp.unit.as_str(), lamp.values[2]), ("W/m2/nm", 0.125));
    assert!(red.notes.is_empty() && lamp.notes.is_empty());
}

#[test]
fn a_csv_may_be_written_in_many_ways() {
    let values = |text: &str| spectra(text).remove(0).values;
    let nm = |text: &str| spectra(text).remove(0).nm;
    assert_eq!(values("λ (µm);R\n0,40;0,5\n0,41;0,25\n"), [0.5, 0.25]);
    assert_eq!(nm("λ (µm);R\n0,40;0,5\n0,41;0,25\n"), [400.0, 410.0]);
    assert_eq!(values("410 0.25\n400 0.5\n"), [0.5, 0.25]);
    assert_eq!(nm("frequency (THz)\tR\n700\t1\n750\t2\n").len(), 2);
    assert!((nm("m,reflectance\n5.5e-7,1\n5.6e-7,1\n")[0] - 550.0).abs() < 1e-9);
    let titled = spectra("Reflectance of a tile, wavelength in µm\n0.40 0.5\n0.41 0.25\n").remove(0);
    assert_eq!((titled.nm[0], titled.quantity), (400.0, Quantity::Reflectance));
    assert_eq!(values("nm,a\n400,1,\n410,2,,\n"), [1.0, 2.0]);
    let bare = spectra("400,1,2\n410,3,4\n");
    assert_eq!((bare[0].name.as_str(), bare[1].name.as_str()), ("file 1", "file 2"));
    assert_eq!(bare[0].notes, ["no unit of wavelength given: taken as nm"]);
}

#[test]
fn a_csv_may_hold_a_spectrum_in_each_row() {
    let rows = spectra("name,400,410,420nm\nred,0.1,0.2,\nblue,0.3,0.4,0.5\n");
    assert!(rows[0].notes.is_empty());
    assert_eq!(spectra("x,400,410\nred,1,2\n")[0].notes, ["no unit of wavelength given: taken as nm"]);
    assert_eq!((rows[0].name.as_str(), &rows[0].nm[..]), ("red", &[400.0, 410.0][..]));
    assert_eq!((rows[1].name.as_str(), &rows[1].values[..]), ("blue", &[0.3, 0.4, 0.5][..]));
}

#[test]
fn per_cent_is_told_from_shares_for_all_spectra_of_a_file() {
    let table = spectra("nm,black reflectance,white reflectance\n400,1,90\n410,1,95\n");
    assert_eq!((table[0].values[0], table[1].values[1]), (0.01, 0.95));
    assert_eq!(table[0].notes, ["fractions of light up to 95 taken as per cent"]);
    assert_eq!(spectra("nm,lamp\n400,90\n410,95\n")[0].values, [90.0, 95.0]);
}

/// The first spectrum of a text, with its wavelengths and values.
fn points(text: &str) -> (NamedSpectrum, Vec<(f64, f64)>) {
    let first = spectra(text).remove(0);
    let points = first.nm.iter().copied().zip(first.values.iter().copied()).collect();
    (first, points)
}

#[test]
fn what_stands_around_a_table_is_passed_over_and_told() {
    let (paint, found) = points(
        "Lab 7\n2 samples\nOperator;A. N. Other\n\nWavelength (nm);Paint reflectance (%)\n400;10,5\n;;\n410;20\n\n;\n\
         Checked by;B\nEnd\n",
    );
    assert_eq!(found, [(400.0, 0.105), (410.0, 0.2)]);
    assert_eq!(
        paint.notes,
        [
            "3 lines above the table skipped, the first of them line 1: 'Lab 7'",
            "2 lines below the table skipped, the first of them line 11: 'Checked by;B'",
        ]
    );
    // Comments of MATLAB, NumPy and others; a per cent sign that begins a line says nothing of per cent.
    let (paint, found) = points("% reflectance of a tile\n! made up\n// 2020\n400 0.5\n500 0.6\n");
    assert_eq!((paint.quantity, &found[..]), (Quantity::Reflectance, &[(400.0, 0.5), (500.0, 0.6)][..]));
    let (paint, _) = points("# wavelength_nm reflectance\n400 0.5\n500 0.6\n");
    assert_eq!((paint.name.as_str(), paint.notes.len()), ("reflectance", 0));
    // A row of units of its own.
    let (lamp, found) = points("Wavelength\tIrradiance\nµm\tW/m²/nm\n0.4\t1\n0.5\t2\n");
    assert_eq!((lamp.name.as_str(), lamp.unit.as_str()), ("Irradiance", "W/m²/nm"));
    assert_eq!(found, [(400.0, 1.0), (500.0, 2.0)]);
}

#[test]
fn spectrometers_write_counts_beside_what_they_mean() {
    let table = spectra(
        "Integration: 9 ms\r\nName\0\0\0\r\nWave   ;Sample  ;Dark    ;Transmittance\r\n[nm]   ;[counts];[counts];[% transmittance]\r\n\
         400.0;57000;30;50.0\r\n401.0;57001;31;25.0\r\n",
    );
    let told: Vec<_> = table.iter().map(|one| (one.name.as_str(), one.quantity)).collect();
    assert_eq!(
        told,
        [
            ("Sample", Quantity::Unknown),
            ("Dark", Quantity::Unknown),
            ("Transmittance", Quantity::Transmittance),
        ]
    );
    assert_eq!((&table[0].values[..], &table[2].values[..]), (&[57000.0, 57001.0][..], &[0.5, 0.25][..]));
}

#[test]
fn meters_write_pairs_of_words_and_values() {
    let (lamp, found) =
        points("Model\tX\nLUX\t486\nCCT\t5461\nR1\t90\n380nm\t0.5\n385nm\t0.75\n390nm\t1\nPeak\t390\n");
    assert_eq!(found, [(380.0, 0.5), (385.0, 0.75), (390.0, 1.0)]);
    // Only light has an illuminance and a colour temperature.
    assert_eq!((lamp.name.as_str(), lamp.quantity), ("file", Quantity::Light));
    assert!(!lamp.notes.iter().any(|note| note.contains("unit")), "{:?}", lamp.notes);
    let (_, found) = points("Date,2020/01/01\nSpectral Data 380[nm],0.5\nSpectral Data 381[nm],0.75\n");
    assert_eq!(found, [(380.0, 0.5), (381.0, 0.75)]);
}

#[test]
fn a_field_without_a_value_may_be_a_word() {
    let (_, found) = points("nm,reflectance\n390,NaN\n400,0.5\n410,NA\n420,0.25\n430,-\n440,---\n");
    assert_eq!(found, [(400.0, 0.5), (420.0, 0.25)]);
}

#[test]
fn the_column_of_wavelengths_is_found() {
    let (patch, found) = points(",wavelength (nm),reflectance\n0,400,0.5\n1,410,0.25\n2,420,0.125\n");
    assert_eq!(found, [(400.0, 0.5), (410.0, 0.25), (420.0, 0.125)]);
    assert_eq!(patch.notes, ["1 column before the wavelengths left out"]);
    let (_, found) = points("0 400 0.5\n1 410 0.25\n2 420 0.125\n");
    assert_eq!(found, [(400.0, 0.5), (410.0, 0.25), (420.0, 0.125)]);
    // Pairs of columns, each with wavelengths of its own.
    let pairs = spectra("Wavelength (nm),red,Wavelength (nm),blue\n400,1,405,3\n410,2,415,4\n");
    assert_eq!(pairs.len(), 2);
    assert_eq!((&pairs[0].nm[..], &pairs[1].nm[..]), (&[400.0, 410.0][..], &[405.0, 415.0][..]));
    assert_eq!((pairs[1].name.as_str(), &pairs[1].values[..]), ("blue", &[3.0, 4.0][..]));
    // Several columns before spectra in rows, and a word behind them.
    let rows = spectra("Name,Mode,L*,400nm,410nm,420nm,Remark\nT1,SCI,50.1,8,9,10,ok\nT1,SCE,49,7,8,9,\n");
    assert_eq!((rows[0].name.as_str(), &rows[0].values[..]), ("T1 SCI", &[8.0, 9.0, 10.0][..]));
    assert_eq!((rows[1].name.as_str(), &rows[1].nm[..]), ("T1 SCE", &[400.0, 410.0, 420.0][..]));
    let prefixed = spectra("id,R_400,R_410,R_420\na,0.1,0.2,0.3\n");
    assert_eq!(prefixed[0].nm, [400.0, 410.0, 420.0]);
}

#[test]
fn units_of_the_axis_are_converted_or_refused() {
    let (film, found) = points("Wavenumber (cm-1),transmittance\n25000,0.5\n20000,0.25\n");
    assert_eq!((film.quantity, &found[..]), (Quantity::Transmittance, &[(400.0, 0.5), (500.0, 0.25)][..]));
    let (_, found) = points("Energy (eV) reflectance\n3 0.5\n2 0.25\n");
    assert!((found[0].0 - 413.28).abs() < 0.01 && (found[1].0 - 619.92).abs() < 0.01, "{found:?}");
    let error = error_of("Position (px),reflectance\n400,1\n410,2\n");
    assert!(error.contains("expected a unit of wavelength") && error.contains("'px'"), "{error}");
    let (_, found) = {
        let options = ReadOptions { unit: Some(Scale::Angstroms), ..Default::default() };
        let table = read_spectra_with(b"x (px),reflectance\n4000,1\n5000,2\n", "f", &options).unwrap();
        ((), table[0].nm.clone())
    };
    assert_eq!(found, [400.0, 500.0]);
}

#[test]
fn beyond_the_visible_noise_and_order_do_not_matter() {
    let lamp = spectra("nm,lamp (W/nm)\n200,-60\n250,-50\n300,0\n500,10\n780,1\n900,-5\n").remove(0);
    let (held, notes) = lamp.to_spectrum(None).unwrap();
    assert_eq!((held[0], held[40]), (0.0, 10.0));
    assert_eq!(notes, ["3 of 6 values of 'lamp' lie outside of 300 to 780 nm"]);
    let (lamp, found) = points("nm,lamp (W/nm)\n300,1\n500,10\n780,1\n900,5\n850,5\n");
    assert_eq!(found, [(300.0, 1.0), (500.0, 10.0), (780.0, 1.0)]);
    assert_eq!(lamp.notes, ["2 values beyond 300 to 780 nm are out of order and left out"]);
    let (lamp, found) = points("nm,lamp (W/nm)\n400,1\n400,3\n500,10\n");
    assert_eq!(found, [(400.0, 2.0), (500.0, 10.0)]);
    assert!(lamp.notes[0].starts_with("1 wavelengths stand there more than once"));
    let error = spectra("nm,reflectance\n800,0.5\n900,0.5\n").remove(0).to_spectrum(None).unwrap_err();
    assert!(error.to_string().contains("nothing of it is visible"), "{error}");
}

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
fn densities_over_frequency_become_densities_over_wavelength() {
    let lamp = spectra("frequency (THz),flux (W/THz)\n500,1\n500.001,1\n").remove(0);
    // Between both frequencies lie 0.001 THz and so 0.001 W.
    let nm = lamp.nm[1] - lamp.nm[0];
    assert!((lamp.values[0] * nm / 0.001 - 1.0).abs() < 1e-5, "{}", lamp.values[0] * nm);
    assert!(spectra("THz,flux\n500,1\n600,1\n")[0].notes[0].contains("taken as densities per nm"));
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

#[test]
fn what_is_written_is_read_to_the_bit() {
    let a = Spectrum::from_fn(|nm| (1.0 + (nm / 50.0).sin()) / 3.0);
    let b = Spectrum::from_fn(|nm| 1e-7 * nm * nm);
    let mut file = Vec::new();
    write_csv(&mut file, &[("a, b", &a), ("#1", &b)]).unwrap();
    let back = read_csv(&file, "f").unwrap();
    assert_eq!((back[0].name.as_str(), back[1].name.as_str()), ("a, b", "#1"));
    assert_eq!(back[0].to_spectrum(None).unwrap(), (a, Vec::new()));
    assert_eq!(back[1].to_spectrum(None).unwrap(), (b, Vec::new()));
    let mut file = Vec::new();
    write_spdx(&mut file, "<1 & 2>", Quantity::Relative, &a).unwrap();
    let back = read_spdx(&file, "f").unwrap().remove(0);
    assert_eq!((back.name.as_str(), back.quantity), ("<1 & 2>", Quantity::Relative));
    assert_eq!(back.to_spectrum(None).unwrap().0, a);
    let matrix = Reradiation::from_fn(|out, input| 1.0 / (3.0 + out as f64 + 2.0 * input as f64));
    let mut file = Vec::new();
    write_matrix_csv(&mut file, &matrix).unwrap();
    let back = read_matrix_csv(&file, "f").unwrap();
    let same = (0..97 * 97).all(|i| back.values[i] == matrix.get(i / 97, i % 97));
    assert!(same && back.out_nm[96] == lambda_nm(96) && back.in_nm[0] == lambda_nm(0));
}

#[test]
fn what_the_grid_does_not_hold_is_said() {
    let spectrum = spectra("nm,paint reflectance\n400,0.25\n790,0.5\n").remove(0);
    let (held, notes) = spectrum.to_spectrum(None).unwrap();
    assert_eq!((held[0], notes.len()), (0.25, 2));
    assert!(notes[0].starts_with("'paint reflectance' begins at 400 nm: the value at its end is taken"));
    assert_eq!(notes[1], "1 of 2 values of 'paint reflectance' lie outside of 300 to 780 nm");
    assert_eq!(spectrum.to_spectrum(Some(Outside::Zero)).unwrap().0[0], 0.0);
}

#[test]
fn noise_below_0_is_cut_and_more_is_refused() {
    let read = |text: &str| spectra(text).remove(0).to_spectrum(None);
    let (lamp, notes) = read("nm,lamp (W/nm)\n300,-0.1\n780,10\n").unwrap();
    assert_eq!((lamp[0], lamp[96]), (0.0, 10.0));
    assert_eq!(notes, ["1 values of 'lamp' below 0, down to -0.1, are taken as noise: 0"]);
    let error = read("nm,lamp (W/nm)\n300,-9\n540,-0.5\n780,10\n").unwrap_err();
    assert_eq!(
        error.to_string(),
        "expected values of at least 0 (noise down to -2.000e-1 is taken as 0), found -0.5 at 540 nm"
    );
    // The noise of a reflectance does not shrink with it: black is as noisy as white.
    assert_eq!(read("nm,reflectance\n300,-0.01\n780,0.02\n").unwrap().0[0], 0.0);
    assert_eq!(read("nm,reflectance\n300,-0.5\n780,0.5\n").unwrap().0[0], 0.0, "blind at the end");
    assert!(read("nm,reflectance\n400,-0.5\n780,0.5\n").is_err());
    assert!(read("nm,a\n400,-1\n700,-1\n").is_err());
}

#[test]
fn a_sensitivity_may_be_negative_somewhere_but_not_everywhere() {
    let red = spectra("nm,red\n300,-1\n780,2\n").remove(0);
    assert_eq!(red.to_sensitivity().unwrap().0[0], -1.0);
    let error = spectra("nm,red\n300,-1\n780,0\n").remove(0).to_sensitivity().unwrap_err();
    assert!(error.to_string().contains("found none: -1 at 300 nm"), "{error}");
}

#[test]
fn errors_tell_place_and_expectation() {
    let cases = [
        ("", "f: the file: expected lines of wavelengths and values, found an empty file"),
        ("nm,a\n400,x\n", "f: line 2, field 2: expected a number from -1e30 to 1e30, found 'x'"),
        ("nm,a\n400,nan\n", "f: the file: expected at least one value, found none"),
        ("nm,a\n400,1\n410,x\n420,1", "f: line 3, field 2: expected a number from -1e30 to 1e30, found 'x'"),
        ("400,1\n410,1,2\n", "f: line 2: expected at most 2 fields, found more"),
        ("400\n", "f: line 1: expected a wavelength and at least one value, found one field"),
        ("nm,a\n420,1\n410,2\n430,3\n", "f: line 3: expected wavelengths in rising order, each once"),
        ("nm,a\n0.4,1\n", "f: line 2, field 1: expected a wavelength from 10 nm to 100 µm, found 0.4"),
        ("0.4,1\n", "f: line 1, field 1: expected wavelengths from 100 to 10000 nm, or another unit"),
        ("nm,a\n400,\n", "f: the file: expected at least one value, found none"),
        ("name,400,410\nred,,\n", "f: line 2: expected at least one value, found none for 'red'"),
        (
            "<a/>",
            "f: the file: expected an element 'IESTM2714' or 'CxF' in XML, or a text table, found '<a/>'",
        ),
        ("<a CxF=\"\"/>", "f: line 1, column 1: expected an element 'CxF', found 'a'"),
        ("<CxF>", "f: line 1, column 1: expected well-formed XML"),
        ("<!DOCTYPE a [<!ENTITY b \"c\">]><CxF/>", "f: line 1, column 1: expected well-formed XML"),
        ("BEGIN_DATA_FORMAT\nnm400\n", "f: line 3: expected END_DATA_FORMAT, found the end of the file"),
        ("BEGIN_DATA_FORMAT\nA\nEND_DATA_FORMAT\n", "f: the file: expected samples with spectral fields"),
    ];
    for (text, expected) in cases {
        let message = error_of(text);
        assert!(message.starts_with(expected), "{text:?}: {message}");
    }
    let cut = SPDX.replace("wavelength=\"403.1\"", "wavelength=\"390\"");
    assert!(
        error_of(&cut).contains("line 7, column 5: expected rising wavelengths, found 390 nm after 400 nm")
    );
    let no_step = CXF.replace("Increment", "Step");
    assert!(error_of(&no_step).contains("expected Increment here or in the colour specification 'CS1'"));
    let broken = CGATS.replace("0.5", "0.5 9");
    assert!(error_of(&broken).starts_with("f: line 9: expected 6 fields, found more"));
}

#[test]
fn broken_matrices_tell_place_and_expectation() {
    let error = |text: &str| read_reradiation(text.as_bytes(), "f").expect_err(text).to_string();
    let bfc = bfc();
    assert!(error(&bfc.replace("EOD", "")).contains("line 15: expected EOD after the last emission"));
    assert!(error(&bfc.replace("410\t0.1", "420\t0.1")).contains("line 14: expected 410 nm, found 420"));
    assert!(error(&bfc.replace("0.05\t", "")).contains("line 14: expected 3 values, found 2"));
    assert!(error(&bfc.replace("-0.001", "inf")).contains("line 13, field 4: expected a number"));
    let absurd = bfc.replace("400\t410\t10\t3", "400\t1e30\t10\t3");
    assert!(error(&absurd).contains("line 11: expected first, last and step of emission"));
    assert!(error(&bfc[..bfc.len() / 2]).contains("expected"));
    assert_eq!(
        error(MATRIX.get(..14).unwrap()),
        "f: the file: expected at least 2 wavelengths of emission, found 0"
    );
    assert!(error(&MATRIX.replace("0,6", "")).contains("line 3, field 4: expected a number"));
    assert!(
        error(&MATRIX.replace("\n410", "\n400")).contains("line 3, field 1: expected rising wavelengths")
    );
}

#[test]
fn absurd_files_are_refused_and_cost_little() {
    let wide = format!("nm{}\n400{}\n", ",a".repeat(20_000), ",1".repeat(20_000));
    assert!(error_of(&wide).contains("expected at most 10000 spectra, found 20000"));
    let attributes: String = (0..300).map(|i| format!(" a{i}=\"\"")).collect();
    assert!(
        error_of(&format!("<CxF{attributes}/>")).contains("expected at most 256 attributes of an element")
    );
    let deep = format!("<CxF>{}", "<a>".repeat(500_000));
    assert!(error_of(&deep).contains("expected"));
    let long = "x".repeat(1 << 20);
    assert!(error_of(&long).len() < 300);
    assert!(error_of(&format!("nm,{long}\n400,y")).len() < 300);
    assert_eq!(spectra(&format!("nm,{long}\n400,1\n410,1"))[0].name.len(), 200);
}

#[test]
#[ignore = "writes the seeds of the fuzz targets to fuzz/seeds"]
fn write_fuzz_seeds() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/seeds");
    let write = |target: &str, number: usize, bytes: &[u8]| {
        std::fs::create_dir_all(folder.join(target)).unwrap();
        std::fs::write(folder.join(target).join(format!("{number}")), bytes).unwrap();
    };
    for (number, text) in spectra_samples().into_iter().enumerate() {
        write("spectra", number, text.as_bytes());
    }
    for (number, text) in matrix_samples().into_iter().enumerate() {
        write("reradiation", number, text.as_bytes());
    }
    #[cfg(feature = "exr")]
    write("spectral_exr", 0, &crate::file::exr::tests::bytes_of(crate::file::exr::tests::sample()));
}

/// Whatever bytes are read, the outcome is spectra or one error.
fn survives(bytes: &[u8]) {
    for result in [
        read_spectra(bytes, "f"),
        read_csv(bytes, "f"),
        read_spdx(bytes, "f"),
        read_cgats(bytes, "f"),
        read_cxf(bytes, "f"),
    ] {
        match result {
            Ok(spectra) => check(&spectra),
            Err(error) => assert!(error.to_string().starts_with("f: "), "{error}"),
        }
    }
    for result in [read_bfc(bytes, "f"), read_matrix_csv(bytes, "f")] {
        match result {
            Ok(matrix) => {
                assert_eq!(matrix.values.len(), matrix.out_nm.len() * matrix.in_nm.len());
                let _ = matrix.to_reradiation().map(|matrix| assert!(matrix.is_finite()));
            }
            Err(error) => assert!(error.to_string().starts_with("f: "), "{error}"),
        }
    }
}

/// Pieces of which almost valid files are made.
const PIECES: [&str; 24] = [
    "nm",
    ",",
    ";",
    "\t",
    " ",
    "\n",
    "\r\n",
    "400",
    "410",
    "1e30",
    "-1",
    "0,5",
    "nan",
    "\"",
    "#",
    "%",
    "µm",
    "THz",
    "BEGIN_DATA\n",
    "END_DATA\n",
    "SPECTRAL_NM",
    "<a b=\"c\">",
    "</a>",
    "EOD",
];

proptest! {
    #[test]
    fn broken_files_are_errors_and_no_more(
        which in 0..6usize, cut in 0.0..2.0f64, flips in proptest::collection::vec((0.0..1.0f64, any::<u8>()), 0..6),
    ) {
        let texts: Vec<Vec<u8>> = spectra_samples()
            .into_iter()
            .map(str::to_owned)
            .chain(matrix_samples())
            .map(String::into_bytes)
            .collect();
        let mut bytes = texts[which].clone();
        for (place, byte) in flips {
            let at = (place * bytes.len() as f64) as usize;
            bytes[at] = byte;
        }
        bytes.truncate((cut * bytes.len() as f64) as usize);
        survives(&bytes);
    }

    #[test]
    fn almost_valid_files_are_read_or_refused(pieces in proptest::collection::vec(0..PIECES.len(), 0..60)) {
        let text: String = pieces.into_iter().map(|i| PIECES[i]).collect();
        survives(text.as_bytes());
    }
}

/// Two bytes of a matrix that is no spectrum: values that no reflectance has.
#[test]
fn a_matrix_that_is_taken_for_a_table_survives() {
    let mut bytes = matrix_samples()[0].clone().into_bytes();
    let length = bytes.len() as f64;
    bytes[(0.713_466_095_274_350_1 * length) as usize] = 1;
    bytes.truncate((0.952_845_118_701_186_6 * length) as usize);
    survives(&bytes);
}
