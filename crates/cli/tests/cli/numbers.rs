//! The numbers of spectra: their resolution, and how lights show colours.

use crate::color::{assert_near, json, number, numbers};
use crate::folder::Folder;

#[test]
fn numbers_do_not_depend_on_the_step_of_a_table() {
    // A narrow blue band and a broad one, by 1 nm and by 5 nm.
    let band = |nm: f64, peak: f64, width: f64| (-((nm - peak) / width) * ((nm - peak) / width)).exp();
    let folder = Folder::new();
    let mut told = Vec::new();
    for step in [1, 5] {
        let lines = (380..=780).step_by(step).map(|nm| {
            let nm = f64::from(nm);
            format!("{nm},{}\n", band(nm, 452.0, 12.0) + 0.6 * band(nm, 560.0, 60.0))
        });
        folder.write("led.csv", format!("nm,power\n{}", lines.collect::<String>()));
        let run = folder.glanz(&["color", "spectrum", "led.csv", "--as", "light", "--format", "json"]);
        told.push(run.json());
    }
    assert_near(&told[0]["xy"], &numbers(&told[1]["xy"]), 2e-5);
    assert!((number(&told[0]["cct_k"]) - number(&told[1]["cct_k"])).abs() < 1.0);
    assert!(number(&told[0]["drawn_by_5_nm"]["de2000"]) > 0.02, "the grid for drawing widens the band");
    assert!(number(&told[1]["drawn_by_5_nm"]["de2000"]) < 0.02);
}

#[test]
fn values_of_a_coarse_table_are_joined_as_is_said() {
    let folder = Folder::new();
    let values =
        [8.1, 8.6, 9.4, 10.2, 12.8, 19.5, 30.2, 38.6, 41.0, 36.4, 29.9, 25.2, 22.8, 21.9, 21.6, 22.4];
    let lines: String =
        values.iter().enumerate().map(|(i, value)| format!("{},{value}\n", 400 + 20 * i)).collect();
    folder.write("patch.csv", format!("nm,reflectance (%)\n{lines}"));
    let told = |words: &[&str]| {
        let words = [&["color", "spectrum", "patch.csv", "--format", "json"], words].concat();
        folder.glanz(&words).json()
    };
    // Sums by 1 nm of colour-science 0.4.7's functions with D65: numpy.interp, and SpragueInterpolator.
    let lines = told(&[]);
    assert_near(&lines["xyz"], &[26.1862, 32.3403, 12.2106], 2e-3);
    assert_eq!(number(&lines["interpolation"]["step_nm"]), 20.0);
    assert!(
        (number(&lines["interpolation"]["sprague_de2000"]) - 0.317).abs() < 0.002,
        "{}",
        lines["interpolation"]
    );
    let smooth = told(&["--interpolation", "sprague"]);
    assert_near(&smooth["xyz"], &[26.2272, 32.5330, 12.0784], 2e-3);
    assert!(smooth["interpolation"].is_null());
    assert!(told(&["--interpolation", "lines"])["interpolation"].is_null());
}

#[test]
fn lights_have_the_indices_of_tm_30() {
    // colour-science 0.4.7 and luxpy 1.12.5 agree to these digits.
    let lamp = json(&["spectrum", "FL2"]);
    assert!((number(&lamp["tm30"]["rf"]) - 70.121).abs() < 0.01);
    assert!((number(&lamp["tm30"]["rg"]) - 86.416).abs() < 0.01);
    let reds = &lamp["tm30"]["bins"][0];
    assert!((number(&reds["rcs"]) + 0.2493).abs() < 1e-4 && (number(&reds["rf"]) - 60.2).abs() < 0.02);
    assert!((number(&lamp["ssi"]) - 64.0).abs() < 1e-9);
    assert!(json(&["spectrum", "line(520)"])["tm30"].is_null(), "no white light");
}

#[test]
fn a_surface_shows_no_colours() {
    let folder = Folder::new();
    let failure = folder.glanz(&["color", "plot", "tm30", "gold", "-o", "v.svg"]).failure();
    assert!(failure.contains("is a surface"), "{failure}");
    folder.glanz(&["color", "plot", "tm30", "LED-B1", "-o", "v.svg"]).text();
    assert!(String::from_utf8_lossy(&folder.read("v.svg")).contains("Colour vector graphic"));
}

#[test]
fn colours_that_cannot_be_meant_are_refused_or_remarked() {
    let folder = Folder::new();
    let run = |words: &[&str]| folder.glanz(&[&["color"], words].concat());
    let refused = run(&["convert", "--from", "xyz", "--to", "srgb", "95.047,100,108.883"]).failure();
    assert!(refused.contains("from 0 to 100 it would be 0.95047,1,1.08883"), "{refused}");
    let refused = run(&["convert", "--from", "srgb", "--to", "lab", "255,128,0"]).failure();
    assert!(refused.contains("from 0 to 255"), "{refused}");
    let refused = run(&["convert", "--from", "oklch", "--to", "srgb", "62,0.2,30"]).failure();
    assert!(refused.contains("from 0 to 100"), "{refused}");
    for (words, remark) in [
        (&["convert", "--from", "srgb", "--to", "xyz", "1.5,0,0"][..], "no display shows it"),
        (&["convert", "--from", "lab", "--to", "xyz", "500,0,0"], "brighter than white"),
        (&["xy", "0.1,0.85"], "outside of the spectral locus"),
    ] {
        let told = run(words);
        assert!(!told.text().is_empty() && told.stderr.contains(remark), "{words:?}: {}", told.stderr);
    }
    let fine = run(&["convert", "--from", "lch", "--to", "srgb", "60,40,250"]);
    assert!(!fine.text().is_empty() && fine.stderr.is_empty(), "{}", fine.stderr);
}

#[test]
fn a_dye_of_ones_own_is_made_of_its_spectra() {
    let folder = Folder::new();
    folder.write("ex.csv", "nm,excitation\n350,0\n400,0.2\n450,1\n500,0.05\n520,0\n");
    folder.write("em.csv", "nm,emission\n470,0\n510,100\n560,20\n650,0\n");
    let run = |words: &[&str]| folder.glanz(&[&["color", "fluorescence"], words].concat());
    let told = |words: &[&str]| run(&[&["--format", "json"], words].concat());
    let spectra = ["--excitation", "ex.csv", "--emission", "em.csv", "--quantum-yield", "0.8"];
    let dye = told(&spectra).json();
    assert_eq!(dye["energy"]["ok"], true);
    let lights = dye["lights"].as_array().unwrap();
    assert!(numbers(&lights[0]["total"]["xyz"])[1] > 100.0, "it glows under D65: {}", lights[0]);
    let strong = told(&[&spectra[..], &["--absorbance", "3"]].concat()).json();
    assert!(number(&strong["lights"][0]["de2000"]) > number(&dye["lights"][0]["de2000"]));
    let exchanged = ["--excitation", "em.csv", "--emission", "ex.csv", "--quantum-yield", "0.8"];
    assert!(run(&exchanged).failure().contains("are they exchanged?"));
    assert!(run(&["gold", "--absorbance", "2"]).failure().contains("there is no dye 'gold'"));
    assert!(run(&["pyranine", "--base", "1.5"]).failure().contains("reflects 0 to 1"));
    assert!(run(&[]).failure().contains("say which material"));
    // A scene with it draws.
    let scene = "[render]\nmode = \"spectral\"\n[image]\nwidth = 16\nheight = 16\n[[lights]]\nkind = \"directional\"\n\
                 direction = [0.0, 0.0, -1.0]\nspectrum = \"D65\"\n[materials.ink]\ndiffuse = { dye = { excitation = \"ex.csv\", \
                 emission = \"em.csv\", quantum_yield = 0.8, absorbance = 1.2, base = 0.85 } }\n[[objects]]\nmesh = { sphere = {} }\n\
                 material = \"ink\"\n";
    folder.write("ink.toml", scene);
    folder.glanz(&["render", "ink.toml", "-o", "ink.png"]).text();
    folder.write("no.toml", scene.replace("quantum_yield = 0.8, ", ""));
    assert!(folder.glanz(&["render", "no.toml", "-o", "no.png"]).failure().contains("quantum_yield"));
}

#[test]
fn a_gamut_without_some_hues_has_no_index() {
    let folder = Folder::new();
    let run = folder.glanz(&["color", "spectrum", "blackbody(1000)"]);
    assert!(run.text().contains("100.0, none (no sample has some of the hues"), "{}", run.text());
    assert!(!run.text().contains("NaN"), "{}", run.text());
    let plot = folder.glanz(&["color", "plot", "tm30", "blackbody(1000)", "-o", "-"]);
    assert!(!plot.text().contains("NaN"));
}
