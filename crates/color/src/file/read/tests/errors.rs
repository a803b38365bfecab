//! Messages of what cannot be read.

use super::*;

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
