//! Wavelengths of tables: bands, and units of rows.

use super::*;

/// Bands of 10 nm from 400 on, and their values, under a line of headers.
fn bands(head: &str, ends: impl Fn(f64) -> (f64, f64)) -> String {
    (0..8).fold(head.to_owned(), |text, i| {
        let (first, second) = ends(400.0 + 10.0 * f64::from(i));
        format!("{text}{first},{second},0.{i}1\n")
    })
}

/// The same, from the last band to the first.
fn falling(text: &str, head: &str) -> String {
    let lines: Vec<&str> = text[head.len()..].lines().rev().collect();
    format!("{head}{}\n", lines.join("\n"))
}

#[test]
fn bands_rise_or_fall_and_may_have_gaps() {
    let named = "wavelength min (nm),wavelength max (nm),reflectance\n";
    let whole = |nm: f64| (nm, nm + 10.0);
    let gap = |nm: f64| (nm, nm + 9.5);
    let swapped = |nm: f64| (nm + 10.0, nm);
    let overlapping = |nm: f64| (nm - 5.0, nm + 15.0);
    for head in [named, "lo,hi,reflectance\n", "from (nm),to,reflectance\n", ""] {
        for (text, middle) in [
            (bands(head, whole), 405.0),
            (bands(head, gap), 404.75),
            (bands(head, swapped), 405.0),
            (bands(head, overlapping), 405.0),
        ] {
            for text in [falling(&text, head), text] {
                let found = spectra(&text);
                assert_eq!((found.len(), found[0].nm[0], found[0].values[1]), (1, middle, 0.11), "{text}");
                assert!(
                    found[0].notes.iter().any(|note| note.contains("their middles")),
                    "{:?}",
                    found[0].notes
                );
            }
        }
    }
}

#[test]
fn bands_may_have_their_middles_beside_them() {
    let three = |of: fn(u32) -> String| (0..6).map(of).collect::<String>();
    let found = spectra(&three(|i| format!("4{i}5,4{i}0,{},0.{i}1\n", 410 + 10 * i)));
    assert_eq!((found.len(), found[0].nm[0], found[0].values[1]), (1, 405.0, 0.11));
    // Wavelengths in air and in vacuum are no bands.
    let (_, found) = points(&three(|i| format!("4{i}0,4{i}0.11,0.{i}1\n")));
    assert_eq!(found[1], (410.11, 0.11));
}

#[test]
fn spectra_near_their_wavelengths_stay_spectra() {
    // Reflectances about as great as wavelengths in µm, and counts as great as those in nm.
    let found = spectra("um,a,b\n0.4,0.41,1\n0.5,0.53,1\n0.6,0.64,1\n0.7,0.71,1\n");
    assert_eq!((found.len(), found[0].values[1]), (2, 0.53));
    let found = spectra("nm,a (counts),b\n400,410,1\n410,425,1\n420,405,1\n430,440,1\n");
    assert_eq!((found.len(), found[0].values[1]), (2, 425.0));
    let found = spectra("nm,reflectance (%),b\n400,410,1\n410,420,1\n420,430,1\n430,440,1\n");
    assert_eq!(found.len(), 2);
}

#[test]
fn rows_have_the_unit_that_is_said() {
    let near = |text: &str, unit: Option<Scale>, nm: [f64; 3]| {
        let options = ReadOptions { unit, ..Default::default() };
        let one = read_spectra_with(text.as_bytes(), "f", &options).unwrap().remove(0);
        let is_near = one.nm.iter().zip(nm).all(|(a, b)| (a - b).abs() < 0.01);
        assert!(is_near && one.nm.len() == 3 && one.values == [0.3, 0.2, 0.1], "{text}: {one:?}");
        assert!(!one.notes.iter().any(|note| note.contains("taken as nm")), "{:?}", one.notes);
    };
    let falling = |head: &str, numbers: &str| format!("{head},{numbers}\nleaf reflectance,0.1,0.2,0.3\n");
    let nm = [499.65, 599.58, 697.19];
    near(&falling("Frequency (THz)", "430,500,600"), None, nm);
    near(&falling("x", "430,500,600"), Some(Scale::Terahertz), nm);
    near(&format!("Frequency in THz\n{}", falling("x", "430,500,600")), None, nm);
    near(&falling("Wavenumber (cm-1)", "10000,20000,25000"), None, [400.0, 500.0, 1000.0]);
    near(&falling("Energy [eV]", "2,2.5,3"), None, [413.28, 495.94, 619.92]);
    let rising = |head: &str, numbers: &str| format!("{head},{numbers}\nleaf reflectance,0.3,0.2,0.1\n");
    let nm = [400.0, 500.0, 600.0];
    near(&rising("Wavelength (Angstrom)", "4000,5000,6000"), None, nm);
    near(&rising("x", "4000,5000,6000"), Some(Scale::Angstroms), nm);
    near(&rising("Wavelength (µm)", "0.4,0.5,0.6"), None, nm);
    near(&rising("Wavelength (nm)", "400,500,600"), None, nm);
    // An illuminance is no energy of photons.
    let lamp = spectra("name,Ev,400,500,600\nlamp,20,1,2,3\n").remove(0);
    assert_eq!((&lamp.nm[..], lamp.notes[0].contains("taken as nm")), (&[400.0, 500.0, 600.0][..], true));
    let lamp = spectra("Frequency (THz),430,500,600\nlamp (W/m2/THz),1,1,1\n").remove(0);
    assert!(
        lamp.notes.iter().any(|note| note.contains("THz") || note.contains("per nm")),
        "{:?}",
        lamp.notes
    );
}
