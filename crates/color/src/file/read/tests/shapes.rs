//! Tables in other shapes than lines of a wavelength and its values, and what says of them what they are of.

use super::*;

/// A spectrum's name, what it is of, and its points.
type Named = (String, Quantity, Vec<(f64, f64)>);

/// The spectra of a file of this name.
fn named(text: &str, file: &str) -> Vec<Named> {
    let read = read_spectra(text.as_bytes(), file).unwrap_or_else(|error| panic!("{error}"));
    let points = |one: &NamedSpectrum| one.nm.iter().copied().zip(one.values.iter().copied()).collect();
    read.iter().map(|one| (one.name.clone(), one.quantity, points(one))).collect()
}

#[test]
fn a_value_may_stand_in_the_line_below_its_wavelength() {
    // As Macam's spectroradiometers write it.
    let (lamp, found) = points(
        "@1/2/2003\n@12:00:00\n#No Title\n 4.0E+02\n 1.0E+00\n 5.0E+02\n 3.0E+00\n 6.0E+02\n 2.0E+00\n",
    );
    assert_eq!(found, [(400.0, 1.0), (500.0, 3.0), (600.0, 2.0)]);
    assert!(lamp.notes[0].contains("its value in the next one, from line 4 on"), "{:?}", lamp.notes);
    assert!(error_of("400\n410\n420\n430\n440\n450\n").contains("a wavelength beside each value"));
}

#[test]
fn columns_of_dates_and_words_beside_numbers_are_left_out() {
    // As libRadtran writes it.
    let (sky, found) = points(
        "400.0 2015-05-19 11_00_00 1.0 9\n410.0 2015-05-19 11_00_00 2.0 9\n420.0 2015-05-19 11_00_00 4.0 9\n",
    );
    assert_eq!(found, [(400.0, 1.0), (410.0, 2.0), (420.0, 4.0)]);
    assert_eq!(sky.notes[0], "2 columns of words left out, such as '2015-05-19 11_00_00'");
    let (_, found) = points("band,nm,flag,reflectance\nb1,400,ok,0.1\nb2,500,ok,0.2\nb3,600,low,0.3\n");
    assert_eq!(found, [(400.0, 0.1), (500.0, 0.2), (600.0, 0.3)]);
}

#[test]
fn samples_one_below_the_other_are_spectra_of_their_own() {
    let text = "sample,wavelength (nm),reflectance (%)\nred,400,10\nred,500,20\nred,600,60\nblue,400,70\nblue,500,40\nblue,600,5\n";
    let spectra = named(text, "long.csv");
    assert_eq!(
        spectra[0],
        ("red".to_owned(), Quantity::Reflectance, vec![(400.0, 0.1), (500.0, 0.2), (600.0, 0.6)])
    );
    assert_eq!(
        spectra[1],
        ("blue".to_owned(), Quantity::Reflectance, vec![(400.0, 0.7), (500.0, 0.4), (600.0, 0.05)])
    );
    // A few lines with words in a table of numbers are an error, and no table of their own.
    let table: String = (40..70).map(|nm| format!("{nm}0,0.5,0.5\n")).collect();
    let end = "700,over,0.5\n710,over,0.5\n720,over,0.5\n";
    assert!(error_of(&format!("nm,a,b\n{table}{end}")).contains("expected a number"));
}

#[test]
fn bands_have_their_wavelength_in_the_middle() {
    // As the radiation model TUV writes it.
    let (sky, found) =
        points("IRRADIANCE (W m-2 nm-1):\nLOWER  UPPER  TOTAL\n 400 410 1.0\n 410 420 2.0\n 420 440 4.0\n");
    assert_eq!(found, [(405.0, 1.0), (415.0, 2.0), (430.0, 4.0)]);
    assert!(sky.notes.iter().any(|note| note.contains("their middles are taken")), "{:?}", sky.notes);
}

#[test]
fn wavelengths_that_can_be_nothing_but_micrometres_are() {
    let (rock, found) = points("0.40 0.1\n0.50 0.2\n0.60 0.4\n2.50 0.5\n");
    assert_eq!(found, [(400.0, 0.1), (500.0, 0.2), (600.0, 0.4), (2500.0, 0.5)]);
    assert!(rock.notes[0].contains("taken as µm"), "{:?}", rock.notes);
    let (_, found) = points("ID,0.40,0.50,0.60,2.50\nJPL1,0.1,0.2,0.4,0.5\n");
    assert_eq!(found, [(400.0, 0.1), (500.0, 0.2), (600.0, 0.4), (2500.0, 0.5)]);
}

#[test]
fn a_unit_of_values_may_stand_behind_each_wavelength() {
    // As the HP330 of Hopoocolor writes it.
    let text = "HP330,1,46\n 57,CCT(K),2933.0\n 319,Transmittance(%) ,100.0\n 380(mW/m2/nm),0.5\n 381(mW/m2/nm),0.75\n 382(mW/m2/nm),1\n";
    let (lamp, found) = points(text);
    assert_eq!(found, [(380.0, 0.5), (381.0, 0.75), (382.0, 1.0)]);
    assert_eq!((lamp.quantity, lamp.unit.as_str()), (Quantity::Light, "mW/m2/nm"));
}

#[test]
fn the_columns_of_known_heads_have_their_names() {
    let text = "/*** Spectra Vista SIG Data ***/\nname= a.sig\nunits= Radiance, Radiance\ndata=\n400.5 200 20 10.0\n402.0 200 40 20.0\n";
    let spectra = read_spectra(text.as_bytes(), "a.sig").unwrap();
    let (leaf, why) = preferred(&spectra).unwrap();
    assert_eq!(
        (leaf.quantity, &leaf.values[..], why),
        (Quantity::Reflectance, &[0.1, 0.2][..], "the only one that says what it is of")
    );
}

#[test]
fn values_without_wavelengths_are_told() {
    let error = error_of(" splib07a Record=1: made up ASDFRa AREF\n 0.1\n 0.2\n -1.23e34\n 0.3\n 0.4\n");
    assert!(error.contains("a wavelength beside each value") && error.contains("paste"), "{error}");
    // What paste makes of both files; the USGS marks a channel that it deleted.
    let (rock, found) = points(
        "splib07a Record=2: Wavelengths\tsplib07a Record=1: rock AREF\n0.40\t0.1\n0.50\t-1.23e34\n0.60\t0.3\n0.70\t0.4\n",
    );
    assert_eq!((rock.nm.len(), &found[..]), (3, &[(400.0, 0.1), (600.0, 0.3), (700.0, 0.4)][..]));
}

#[test]
fn numbers_may_have_separators_of_thousands() {
    let (_, found) = points("nm;lamp (counts)\n400;1.234,5\n500;12.345,0\n600;1.000\n");
    assert_eq!(found, [(400.0, 1234.5), (500.0, 12345.0), (600.0, 1000.0)]);
    let (lamp, found) = points("\"nm\",\"lamp\"\n\"400,5\",\"0,12\"\n\"500,5\",\"1,125\"\n");
    assert_eq!(found, [(400.5, 0.12), (500.5, 1.125)]);
    assert!(lamp.notes.iter().any(|note| note.contains("decimal comma")), "{:?}", lamp.notes);
    // 1.234 or 1234: nothing in the file tells.
    assert!(error_of("nm,lamp\n400,\"1,234\"\n500,\"1,235\"\n").contains("expected"));
}

#[test]
fn cxf_may_have_a_wavelength_at_each_value() {
    let text = r#"<CxF xmlns="http://colorexchangeformat.com/CxF3-core"><Resources><ObjectCollection>
      <Object Name="foil" Id="1"><ColorValues><CustomSpectrum ColorSpecification="S">
        <SpectralPoint WL="500">0.5</SpectralPoint><SpectralPoint WL="400.5">0.2</SpectralPoint>
        <SpectralPoint WL="500">0.7</SpectralPoint></CustomSpectrum></ColorValues></Object></ObjectCollection>
      <ColorSpecificationCollection><ColorSpecification Id="S"><MeasurementSpec>
        <MeasurementType>Spectrum_Transmittance</MeasurementType></MeasurementSpec></ColorSpecification>
      </ColorSpecificationCollection></Resources></CxF>"#;
    let (foil, found) = points(text);
    assert_eq!((foil.quantity, &found[..]), (Quantity::Transmittance, &[(400.5, 0.2), (500.0, 0.6)][..]));
    assert!(foil.notes[0].contains("more than once"), "{:?}", foil.notes);
    let without = text.replace(" WL=\"400.5\"", "");
    assert!(error_of(&without).contains("an attribute 'WL'"));
}

#[test]
fn what_is_stated_alone_comes_before_words_among_others() {
    let (film, _) = points(
        "Technique,Transmission\nLamp Power,100\nPixel,Wavelength,Value\n0,400,0.5\n1,500,0.6\n2,600,0.7\n",
    );
    assert_eq!(film.quantity, Quantity::Transmittance);
    let quantity = |text: &str| spectra(text)[0].quantity;
    assert_eq!(quantity("# quantity    energy\n400 1\n500 2\n"), Quantity::Light);
    assert_eq!(quantity("# quantity    energy->electrical\n400 1\n500 2\n"), Quantity::Unknown);
    let lamps = spectra("nm,energy,photons\n400,1,5\n500,3,2\n600,2,9\n");
    assert_eq!((lamps[0].quantity, lamps.len(), lamps[1].nm.len()), (Quantity::Light, 2, 3));
    assert_eq!(quantity("IT8.7/1\nnm x\n400 1\n500 2\n"), Quantity::Transmittance);
    assert_eq!(quantity("Intensity Corrected,False\nnm,x\n400,1\n500,2\n"), Quantity::Unknown);
    assert_eq!(quantity("Laser Power,100\nnm,x\n400,1\n500,2\n"), Quantity::Unknown);
    assert_eq!(quantity("# CIE Illuminants A, C\nnm A\n400 1\n500 2\n"), Quantity::Light);
    assert_eq!(quantity("# Illuminant: D65\nnm x\n400 1\n500 2\n"), Quantity::Unknown);
    assert_eq!(quantity("wavelength\t%T\n400\t50\n500\t60\n"), Quantity::Transmittance);
}

#[test]
fn a_name_says_what_nothing_else_says() {
    let table = "400 1\n500 2\n";
    for (file, quantity) in [
        ("a/lamp.SSIrrad", Quantity::Light),
        ("CIE_std_illum_A.csv", Quantity::Light),
        ("leaf.Master.Transmission", Quantity::Transmittance),
        ("leaf-reflectance.txt", Quantity::Reflectance),
        ("CIE-F11.csv", Quantity::Light),
        ("colorchecker_n_ohta.csv", Quantity::Reflectance),
        ("glass_indoor_illuminants.csv", Quantity::Unknown),
        ("reflectance/lamp.txt", Quantity::Unknown),
        ("Cu.eta.spd", Quantity::Unknown),
        ("mr16 reflector lamp.csv", Quantity::Unknown),
        ("D65 transmitter test.csv", Quantity::Unknown),
        ("led2-transmission.csv", Quantity::Unknown),
        ("lamp-reflectance.csv", Quantity::Unknown),
        ("reflectometer 3.csv", Quantity::Unknown),
        ("led emission.csv", Quantity::Light),
        ("lamp.csv", Quantity::Unknown),
    ] {
        let one = &read_spectra(table.as_bytes(), file).unwrap()[0];
        assert_eq!(one.quantity, quantity, "{file}");
        assert_eq!(
            one.notes.iter().any(|note| note.contains("by the file's name")),
            quantity != Quantity::Unknown
        );
    }
    // What the file itself says, or who reads it, comes first.
    let said = read_spectra(b"nm,transmittance\n400,0.5\n500,0.5\n", "reflectance.csv").unwrap();
    assert_eq!(said[0].quantity, Quantity::Transmittance);
}

#[test]
fn counts_tell_what_was_made_of_them() {
    let quantity = |text: &str| {
        let spectra = read_spectra(text.as_bytes(), "a.jaz").unwrap();
        let one = processed(&spectra).unwrap().clone();
        (one.quantity, one.values)
    };
    let table = |values: [f64; 4]| {
        let line =
            |(i, value): (usize, f64)| format!("{}\t10\t110\t{}\t{value}\n", 400 + 50 * i, 30 + 20 * i);
        format!("W\tD\tR\tS\tP\n{}", values.into_iter().enumerate().map(line).collect::<String>())
    };
    // (S − D) / (R − D) of 0.2, 0.4, 0.6 and 0.8.
    assert_eq!(quantity(&table([20.0, 40.0, 60.0, 80.0])), (Quantity::Reflectance, vec![0.2, 0.4, 0.6, 0.8]));
    let (absorbing, values) = quantity(&table([0.69897, 0.39794, 0.221849, 0.09691]));
    assert!(absorbing == Quantity::Transmittance && (values[1] - 0.4).abs() < 1e-6, "{values:?}");
    assert_eq!(quantity(&table([1.0, 2.0, 3.0, 4.0])).0, Quantity::Unknown);
}

#[test]
fn files_of_n_and_k_are_told_by_their_names() {
    let has = |file: &str| {
        let one = read_spectra(b"400 1.5\n500 1.4\n", file).unwrap().remove(0);
        one.quantity == Quantity::Unknown && one.notes.iter().any(|note| note.contains("--ior reads both"))
    };
    assert!(has("Cu.eta.spd") && has("a/Cu.k.spd") && !has("Cu.spd.txt"));
}
