//! What instruments write.

use crate::file::read::*;

#[test]
fn of_two_tables_of_the_same_wavelengths_the_finer_is_taken() {
    // As Sekonic's meters write them.
    let coarse = (0..=4).map(|i| format!("Spectral Data {}[nm],{}\n", 400 + 5 * i, i));
    let fine = (0..=20).map(|i| format!("Spectral Data {}[nm],{}\n", 400 + i, i));
    let text = format!(
        "Illuminance [lx],12\nCCT [K],3000\n{}\n{}",
        coarse.collect::<String>(),
        fine.collect::<String>()
    );
    let spectra = read_spectra(text.as_bytes(), "meter.csv").unwrap();
    assert_eq!((spectra.len(), spectra[0].nm.len(), spectra[0].values[20]), (1, 21, 20.0));
    assert_eq!(spectra[0].quantity, Quantity::Light, "only light has a colour temperature");
    assert!(
        spectra[0].notes.iter().any(|note| note.contains("the finest table is taken, from line 9 on")),
        "{:?}",
        spectra[0].notes
    );
    // Wavelengths out of order are still wrong.
    assert!(read_spectra(b"nm,a\n400,1\n420,2\n410,3\n430,4\n", "x.csv").is_err());
}

#[test]
fn photons_of_the_li_1800_become_power() {
    let text = "\"REM: SUN (QNTM)\"\n 400  1.0E+00\n 600  1.0E+00\n 800  1.0E+00\n";
    let sun = &read_spectra(text.as_bytes(), "sun.prn").unwrap()[0];
    assert_eq!(sun.quantity, Quantity::Light);
    assert!(
        (sun.values[0] / sun.values[1] - 1.5).abs() < 1e-12,
        "a photon of 400 nm has more energy: {sun:?}"
    );
    let leaf =
        &read_spectra(b"\"REM: REFL GREEN\"\n 400  5.0E-02\n 600  1.0E-01\n 800  4.0E-01\n", "leaf.prn")
            .unwrap()[0];
    assert_eq!(leaf.quantity, Quantity::Reflectance);
}

#[test]
fn what_an_instrument_made_of_its_counts_is_found() {
    let spectra = read_spectra(b"W\tD\tR\tS\tP\n400\t1\t9\t5\t0.5\n500\t1\t9\t5\t0.6\n", "a.jaz").unwrap();
    assert_eq!(processed(&spectra).map(|one| one.values.clone()), Some(vec![0.5, 0.6]));
    let spectra = read_spectra(b"nm\tProcessed\tRaw\n400\t1\t9\n500\t1\t9\n", "a.txt").unwrap();
    assert_eq!(processed(&spectra).map(|one| one.name.as_str()), Some("Processed"));
    assert_eq!(processed(&read_spectra(b"nm\tS\tM\n400\t1\t9\n500\t1\t9\n", "a.txt").unwrap()), None);
}

#[test]
fn numbers_in_the_head_are_no_wavelengths_of_rows() {
    // As the radiation model TUV writes it.
    let text = " w-grid:  141  280.0  420.0\n z-grid:  81  2.0  80.0\n IRRADIANCE (W m-2 nm-1):\n LOWER  UPPER  DIRECT\n \
                400.0 401.0 1.0\n 401.0 402.0 2.0\n 402.0 403.0 3.0\n 403.0 404.0 4.0\n";
    let spectra = read_spectra(text.as_bytes(), "tuv.txt").unwrap();
    assert_eq!(spectra.last().map(|one| one.values.clone()), Some(vec![1.0, 2.0, 3.0, 4.0]));
}

#[test]
fn files_that_are_no_text_are_named() {
    for (bytes, word) in [
        (&b"TM25\x01\0\0\0"[..], "TM-25"),
        (b"PK\x03\x04\x14\0", "ZIP"),
        (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", "spreadsheet"),
        (b"MATLAB 5.0 MAT-file, Platform: GLNXA64", "MATLAB"),
        (b"\x89HDF\r\n\x1a\n", "HDF5"),
    ] {
        let error = read_spectra(bytes, "a.bin").unwrap_err().to_string();
        assert!(error.contains(word) && error.contains("text"), "{error}");
    }
}

#[test]
fn counts_that_a_file_calls_per_cent_are_refused() {
    let spectra = read_spectra(b"nm,transmission (%)\n400,2000\n500,3900\n600,3000\n", "counts.csv").unwrap();
    let error = spectra[0].to_spectrum(None).unwrap_err();
    assert!(error.to_string().contains("which value is all light"), "{error}");
}

/// Logs of a hand-held spectrometer: a row for each measurement, with its mode before the values.
#[test]
fn each_row_may_say_what_it_is_of() {
    let log = "Date,Mode,Tag,400,500,600\n3/8/2022,Reflectance,leaf,5,12,40\n3/8/2022,Absorbance,leaf,1,0,2\n\
               3/8/2022,Power,leaf,1,0,2\n";
    let spectra = read_spectra(log.as_bytes(), "log.csv").unwrap();
    let kinds: Vec<_> = spectra.iter().map(|spectrum| spectrum.quantity).collect();
    assert_eq!(kinds, [Quantity::Reflectance, Quantity::Transmittance, Quantity::Unknown]);
    assert_eq!((spectra[0].values[1], spectra[1].values[0]), (0.12, 0.1));
}

/// Logs of meters, such as the CL-500A of Konica Minolta: a row for each measurement, its photometric values before the spectrum.
#[test]
fn a_row_with_a_colour_temperature_is_of_light() {
    let log = "Date,Time,Ev[lx],Tcp[K],360nm,361nm,362nm\n21/03/01,10:00:00,500,4000,0.1,0.2,0.3\n";
    let spectra = read_spectra(log.as_bytes(), "log.csv").unwrap();
    assert_eq!((spectra[0].quantity, &spectra[0].values[..]), (Quantity::Light, &[0.1, 0.2, 0.3][..]));
    let samples = "Name,L*,Tcp[K],400nm,410nm,420nm\nred,50,4000,8,9,10\n";
    assert_eq!(read_spectra(samples.as_bytes(), "log.csv").unwrap()[0].quantity, Quantity::Unknown);
}
