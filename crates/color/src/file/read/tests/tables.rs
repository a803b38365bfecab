//! Tables of text.

use super::*;

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
fn densities_over_frequency_become_densities_over_wavelength() {
    let lamp = spectra("frequency (THz),flux (W/THz)\n500,1\n500.001,1\n").remove(0);
    // Between both frequencies lie 0.001 THz and so 0.001 W.
    let nm = lamp.nm[1] - lamp.nm[0];
    assert!((lamp.values[0] * nm / 0.001 - 1.0).abs() < 1e-5, "{}", lamp.values[0] * nm);
    assert!(spectra("THz,flux\n500,1\n600,1\n")[0].notes[0].contains("taken as densities per nm"));
}
