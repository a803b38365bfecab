//! Curves in pixels.

use super::*;

/// A spectrum's name, what it is of, and its points.
type Named = (String, Quantity, Vec<(f64, f64)>);

fn named(text: &str) -> Vec<Named> {
    let points = |one: &NamedSpectrum| one.nm.iter().copied().zip(one.values.iter().copied()).collect();
    spectra(text).iter().map(|one| (one.name.clone(), one.quantity, points(one))).collect()
}

#[test]
fn curves_in_pixels_are_placed_by_the_points_that_are_known() {
    // As the R package colorSpec keeps them: 2 pixels for 1 nm, 100 for 1, upwards.
    let text = "# from a figure\n[Control]\nXpx Ypx X Y\n100 500 400 0\n700 500 700 0\n100 400 400 1  # a corner\n\n[Transmittance]\n\
                100 500\n300 450\n700 410\n\n[Emission]\n100 480\n700 460\n";
    let spectra = named(text);
    let near = |found: &[(f64, f64)], expected: &[(f64, f64)]| {
        found.iter().zip(expected).all(|(a, b)| (a.0 - b.0).abs() < 1e-6 && (a.1 - b.1).abs() < 1e-9)
    };
    assert_eq!(
        (spectra[0].0.as_str(), spectra[0].1, spectra[0].2.len()),
        ("Transmittance", Quantity::Transmittance, 3)
    );
    assert!(near(&spectra[0].2, &[(400.0, 0.0), (500.0, 0.5), (700.0, 0.9)]), "{spectra:?}");
    assert!(
        spectra[1].1 == Quantity::Light && near(&spectra[1].2, &[(400.0, 0.2), (700.0, 0.4)]),
        "{spectra:?}"
    );
    let flat = text.replace("100 400 400 1", "100 500 400 1");
    assert!(error_of(&flat).contains("found points on one line"), "{}", error_of(&flat));
    let few = text.replace("100 400 400 1  # a corner", "");
    assert!(error_of(&few).contains("line 2: expected three points with their pixels"));
}

/// Four corners of a figure, of which the last has this pixel and wavelength, and a curve.
fn figure(pixel: f64, nm: f64) -> String {
    let corners = format!("100 500 400 0\n400 500 700 0\n100 100 400 1\n{pixel} 100 {nm} 1\n");
    format!("[Control]\n{corners}[curve reflectance]\n100 300\n200 320\n400 300\n")
}

#[test]
fn points_that_no_map_fits_are_refused() {
    let plain = spectra(&figure(400.0, 700.0)).remove(0);
    assert!((plain.values[0] - 0.5).abs() < 1e-9 && plain.notes.len() == 1, "{:?}", plain.notes);
    // A typing error, and a pixel that was read off badly.
    for text in [figure(400.0, 4000.0), figure(440.0, 700.0), figure(400.0, 740.0)] {
        assert!(
            error_of(&text).contains("expected points of one affine map, found point"),
            "{}",
            error_of(&text)
        );
    }
    let told = spectra(&figure(410.0, 700.0)).remove(0);
    assert!(told.notes[1].contains("of their range off the map"), "{:?}", told.notes);
    // Four points almost on one line say nothing of what is beside it.
    let line = "[Control]\n0 0 400 0\n300 301 500 0.3\n600 601 600 0.6\n900 900 700 1\n[R]\n0 0\n9 9\n";
    assert!(error_of(line).contains("found points on one line"), "{}", error_of(line));
}

#[test]
fn many_curves_are_refused_at_once() {
    let sections = "[a]\n".repeat(200_000);
    let text = figure(400.0, 700.0) + &sections;
    assert!(error_of(&text).contains("expected at most 256 curves, found 200002"));
    assert_eq!(spectra(&(figure(400.0, 700.0) + "[b]\n100 300\n400 300\n")).len(), 2);
}
