//! What becomes of the values that are read.

use super::*;

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
