//! What holds for all readers: what they read, and that no bytes do harm.

use proptest::prelude::*;

use crate::file::read::*;

mod axes;
mod errors;
mod figures;
mod formats;
mod instruments;
mod shapes;
mod tables;
mod values;
mod words;

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

/// The first spectrum of a text, with its wavelengths and values.
fn points(text: &str) -> (NamedSpectrum, Vec<(f64, f64)>) {
    let first = spectra(text).remove(0);
    let points = first.nm.iter().copied().zip(first.values.iter().copied()).collect();
    (first, points)
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
