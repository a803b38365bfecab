//! `glanz color`: numbers for people and programs, and plots.

use std::io::Cursor;

use serde_json::Value;

use crate::folder::Folder;

pub(crate) fn json(words: &[&str]) -> Value {
    Folder::new().glanz(&[&["color"], words, &["--format", "json"]].concat()).json()
}

pub(crate) fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

pub(crate) fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap_or_else(|| panic!("{value} is no list")).iter().map(number).collect()
}

#[track_caller]
pub(crate) fn assert_near(found: &Value, expected: &[f64], tolerance: f64) {
    let found = numbers(found);
    assert_eq!(found.len(), expected.len());
    for (a, b) in found.iter().zip(expected) {
        assert!((a - b).abs() <= tolerance, "{found:?} is not {expected:?} to {tolerance}");
    }
}

/// A table of two surfaces that match under D65 and part under A: the second is the first and what the
/// observer does not see under D65 (a multiple of a metameric black).
const PAIR: &str = "wavelength (nm),one reflectance,two reflectance\n\
    400,0.40,0.40\n500,0.40,0.52\n600,0.40,0.30\n700,0.40,0.60\n";

#[test]
fn a_color_is_converted_for_people() {
    let words = ["color", "convert", "--from", "hls", "--to", "ac1c2", "210,0.4,0.8"];
    insta::assert_snapshot!(Folder::new().glanz(&words).text());
}

#[test]
fn a_color_is_converted_for_programs() {
    let red = json(&["convert", "--from", "srgb", "--to", "lab", "1,0,0"]);
    // sRGB's red under D65: 53.24, 80.09, 67.20 (Lindbloom, 2017).
    assert_near(&red["values"], &[53.24, 80.09, 67.20], 0.02);
    assert_eq!(number(&red["channels"]["L*"]), numbers(&red["values"])[0]);
}

#[test]
fn negative_numbers_of_a_color_are_no_options() {
    let words = ["color", "convert", "--from", "lab", "--to", "lch", "50,-20,30"];
    assert!(Folder::new().glanz(&words).text().contains("36.0555"));
    assert_near(
        &json(&["convert", "--from", "opponent", "--to", "xyz", "-0.0,0,0"])["values"],
        &[0.0; 3],
        1e-12,
    );
}

#[test]
fn daylight_has_its_known_numbers() {
    let d65 = json(&["spectrum", "D65"]);
    // CIE 15:2018; the last digit printed.
    assert_near(&d65["xy"], &[0.3127, 0.3290], 6e-5);
    assert_near(&d65["xyz"], &[95.047, 100.0, 108.883], 5e-4);
    // colour-science 0.4.7, uv_to_CCT_Ohno2013 of sums by 1 nm; it is of 6504 K by sums of 5 nm.
    assert!((number(&d65["cct_k"]) - 6502.77).abs() < 0.3);
    assert!((number(&d65["drawn_by_5_nm"]["cct_shift_k"]) - 1.0).abs() < 0.2);
    assert!((number(&d65["duv"]) - 0.0032).abs() < 1e-4);
    assert!(number(&d65["ra"]) > 99.9, "daylight shows colours as daylight does");
    assert_eq!(d65["srgb"]["code"], "#ffffff");
    assert_eq!(numbers(&d65["nm"]).len(), 97);
}

#[test]
fn lights_have_their_known_chromaticities() {
    for (name, xy) in [("A", [0.44758, 0.40745]), ("FL2", [0.3721, 0.3751]), ("FL11", [0.3805, 0.3769])] {
        assert_near(&json(&["spectrum", name])["xy"], &xy, 6e-5);
    }
    let ten = json(&["spectrum", "D65", "--observer", "cie1964"]);
    // CIE 15:2018: D65 for 10°.
    assert_near(&ten["xy"], &[0.3138, 0.3310], 6e-5);
}

#[test]
fn a_line_has_its_own_wavelength_and_full_purity() {
    let line = json(&["spectrum", "line(580)"]);
    assert!((number(&line["dominant_nm"]) - 580.0).abs() < 0.1);
    assert!((number(&line["purity"]) - 1.0).abs() < 1e-3);
    assert_eq!(line["cct_is_meaningful"], true, "a yellow line lies near the black bodies");
    let green = json(&["spectrum", "line(520)"]);
    assert_eq!(green["cct_is_meaningful"], false);
    assert!(number(&green["complementary_nm"]) < 0.0, "the complement of green is a purple");
}

#[test]
fn a_metal_is_told_by_its_reflectance() {
    insta::assert_snapshot!(Folder::new().glanz(&["color", "spectrum", "gold", "--light", "A"]).text());
}

#[test]
fn a_light_is_told_in_words() {
    insta::assert_snapshot!(Folder::new().glanz(&["color", "spectrum", "FL4"]).text());
}

#[test]
fn cones_answer_where_there_is_no_xyz() {
    let words = ["color", "spectrum", "white-9.5", "--observer", "lms2", "--light", "E"];
    let run = Folder::new().glanz(&words);
    assert!(run.text().contains("of the perfect diffuser's"), "{}", run.text());
    let white = json(&["spectrum", "white-9.5", "--observer", "lms2", "--light", "E"]);
    assert!((0.85..0.95).contains(&number(&white["response_L"])));
    assert!(white["xyz"].is_null());
}

#[test]
fn a_written_spectrum_is_read_back_without_loss() {
    let folder = Folder::new();
    let first = folder.glanz(&["color", "spectrum", "FL11", "--csv", "a.csv", "--format", "json"]);
    assert_eq!(first.stderr, "wrote a.csv\n");
    let again = folder.glanz(&["color", "spectrum", "a.csv", "--as", "light", "--format", "json"]).json();
    assert_eq!(again["values"], first.json()["values"]);
    // The table of the lamp begins at 380 nm, the file at 300 nm with 0.
    assert_near(&again["xyz"], &numbers(&first.json()["xyz"]), 1e-3);
}

#[test]
fn what_a_file_does_not_say_is_asked_for() {
    let folder = Folder::new();
    // The same lamp on two scales: the level does not tell what it is of.
    for factor in [1.0, 10.0] {
        folder.write("a.csv", format!("nm,sample\n300,{}\n780,{}\n", 0.2 * factor, 0.8 * factor));
        let failure = folder.glanz(&["color", "spectrum", "a.csv"]).failure();
        assert!(failure.contains("a.csv does not say what 'sample' is of"), "{failure}");
        assert!(failure.contains("say --as light or --as surface"), "{failure}");
    }
    let run = folder.glanz(&["color", "spectrum", "a.csv", "--as", "light"]);
    assert!(run.text().contains("CCT") && !run.stderr.contains("does not say"), "{}", run.stderr);
    // Where a light is wanted, it is one.
    assert!(folder.glanz(&["color", "spectrum", "red", "--light", "a.csv"]).text().contains("sample"));
}

#[test]
fn what_a_file_says_wrongly_can_be_said_otherwise() {
    let folder = Folder::new();
    folder.write("a.csv", "x,dark,light\n4000,1.5,51\n7000,1.5,51\n");
    let xyz = |more: &[&str]| {
        let words =
            [&["color", "spectrum", "a.csv", "--unit", "angstrom", "--format", "json"], more].concat();
        number(&folder.glanz(&words).json()["xyz"][1])
    };
    let dark = xyz(&["--as", "surface", "--column", "dark", "--scale", "percent"]);
    assert!((dark - 1.5).abs() < 1e-9, "{dark}");
    let light = xyz(&["--as", "reflectance", "--column", "2", "--scale", "255"]);
    assert!((light - 20.0).abs() < 1e-9, "{light}");
    let filter = xyz(&["--as", "absorbance", "--column", "1", "--scale", "1.5"]);
    assert!((filter - 10.0).abs() < 1e-9, "{filter}");
    let failure = folder.glanz(&["color", "spectrum", "a.csv", "--scale", "many"]).failure();
    assert!(failure.contains("expected fraction, percent, or a number above 0"), "{failure}");
}

#[test]
fn values_below_0_are_refused_where_they_are_more_than_noise() {
    let folder = Folder::new();
    folder.write("a.csv", "nm,reflectance\n300,0.5\n540,-0.5\n780,0.5\n");
    let failure = folder.glanz(&["color", "spectrum", "a.csv"]).failure();
    assert!(failure.starts_with("3\n") && failure.contains("found -0.5 at 540 nm"), "{failure}");
    folder.write("a.csv", "nm,reflectance\n300,0.5\n540,-0.001\n780,0.5\n");
    let run = folder.glanz(&["color", "spectrum", "a.csv"]);
    assert!(!run.text().is_empty() && run.stderr.contains("taken as noise"), "{}", run.stderr);
    folder.write("eye.csv", "nm,a,b\n300,1,-1\n780,1,-1\n");
    let failure = folder.glanz(&["color", "spectrum", "E", "--observer", "eye.csv"]).failure();
    assert!(failure.contains("channel 'b' of 'eye.csv': expected a sensitivity above 0"), "{failure}");
}

#[test]
fn colours_from_0_to_255_are_refused_and_hexadecimal_ones_read() {
    let folder = Folder::new();
    let failure = folder.glanz(&["color", "convert", "--from", "srgb", "--to", "lab", "255,128,0"]).failure();
    assert!(failure.contains("1 is white") && failure.contains("1,0.50196"), "{failure}");
    let convert = |text: &str| {
        let words = ["color", "convert", "--from", "srgb", "--to", "xyz", text, "--format", "json"];
        folder.glanz(&words).json()["values"].clone()
    };
    assert_eq!(convert("#ff8000"), convert(&format!("1,{},0", 128.0 / 255.0)));
    assert_eq!(convert("#f80"), convert(&format!("1,{},0", 136.0 / 255.0)));
    for wrong in ["#ff80", "#gg0000", "#+10000"] {
        assert_eq!(
            folder.glanz(&["color", "convert", "--from", "srgb", "--to", "xyz", wrong]).code,
            2,
            "{wrong}"
        );
    }
}

#[test]
fn a_chromaticity_has_its_numbers() {
    let folder = Folder::new();
    let told = folder.glanz(&["color", "xy", "0.3127,0.3290", "--format", "json"]).json();
    // D65 by the black body of colour-science 0.4.7's uv_to_CCT_Ohno2013.
    assert!((number(&told["cct_k"]) - 6503.5).abs() < 1.5, "{told}");
    assert!((number(&told["duv"]) - 0.0032).abs() < 1e-4, "{told}");
    // colour-science 0.4.7: dominant_wavelength and excitation_purity against D65.
    let told = folder.glanz(&["color", "xy", "0.6,0.35", "--white", "D65", "--format", "json"]).json();
    assert!((number(&told["dominant_nm"]) - 604.0).abs() < 0.6, "{told}");
    assert!((number(&told["purity"]) - 0.8614).abs() < 2e-3, "{told}");
    let same = folder.glanz(&["color", "xy", "0.19784,0.46834", "--from", "uv1976"]).text().to_owned();
    assert!(same.contains("0.3127") && same.contains("0.46834") && same.contains("CCT"), "{same}");
    for wrong in ["0.3", "0.9,0.9", "0.3,0", "a,b"] {
        assert_eq!(folder.glanz(&["color", "xy", wrong]).code, 2, "{wrong}");
    }
}

#[test]
fn a_wave_has_its_numbers() {
    let folder = Folder::new();
    let told = folder.glanz(&["color", "wave", "580nm", "2.1", "eV", "--format", "json"]).json();
    let of = |index: usize, key: &str| number(&told["waves"][index][key]);
    assert!((of(0, "thz") - 516.883).abs() < 1e-3 && (of(0, "ev") - 2.137_66).abs() < 1e-5, "{told}");
    assert!((of(0, "per_cm") - 17_241.379).abs() < 1e-3 && (of(0, "fs") - 1.934_67).abs() < 1e-5, "{told}");
    assert!((of(1, "nm") - 590.401).abs() < 1e-3, "{told}");
    assert_eq!(folder.glanz(&["color", "wave", "580"]).code, 2);
}

#[test]
fn photometric_figures_follow_the_unit() {
    let folder = Folder::new();
    // 683 lm/W times ∫ V = 106.86 nm: 72983 lx of 1 W/(m² nm).
    for (unit, lux) in [("W/m²/nm", 72983.0), ("mW/m²/nm", 72.983), ("µW/cm²/nm", 729.83)] {
        folder.write("a.csv", format!("nm,irradiance ({unit})\n300,1\n780,1\n"));
        let told = folder.glanz(&["color", "spectrum", "a.csv", "--format", "json"]).json();
        assert!((number(&told["luminous"]) / lux - 1.0).abs() < 1e-4, "{unit}: {}", told["luminous"]);
        assert_eq!(told["luminous_unit"], "lx");
    }
    folder.write("a.csv", "nm,irradiance (bananas)\n300,1\n780,1\n");
    let text = folder.glanz(&["color", "spectrum", "a.csv"]).text().to_owned();
    assert!(text.contains("none: the unit 'bananas' is not understood"), "{text}");
    assert!(json(&["spectrum", "FL11"])["luminous"].is_null(), "a relative light has no absolute figure");
}

#[test]
fn a_file_that_says_what_it_is_is_nothing_else() {
    let folder = Folder::new();
    folder.write("paint.csv", "nm,reflectance\n300,0.5\n780,0.5\n");
    folder.write("lamp.csv", "nm,flux (W/nm)\n300,0.5\n780,0.5\n");
    for words in [
        &["spectrum", "gold", "--light", "paint.csv"][..],
        &["efficiency", "--set", "lamp.csv"],
        &["metamers", "lamp.csv", "gold"],
        &["spectrum", "D65", "--as", "surface"],
    ] {
        folder.glanz(&[&["color"], words].concat()).failure();
    }
    folder.write("x.csv", "nm,x\n300,0.5\n780,0.5\n");
    folder.glanz(&["color", "spectrum", "gold", "--light", "x.csv"]).text();
    folder.write("x.csv", "nm,reflectance\n300,0.5\n780,1.5\n");
    let run = folder.glanz(&["color", "spectrum", "x.csv"]);
    assert!(run.stderr.contains("only what glows exceeds 1"), "{}", run.stderr);
    folder.write("x.BFC", "x\nBFC-450 Matrix File\n");
    let failure = folder.glanz(&["color", "spectrum", "x.BFC"]).failure();
    assert!(failure.contains("glanz color fluorescence x.BFC"), "{failure}");
}

#[test]
fn surfaces_of_equal_names_go_by_their_files() {
    let folder = Folder::new();
    for file in ["a.csv", "b.csv"] {
        folder.write(file, "nm,reflectance\n300,0.5\n780,0.5\n");
    }
    let text = folder.glanz(&["color", "metamers", "a.csv", "b.csv"]).text().to_owned();
    assert!(text.starts_with("a.csv and b.csv\n"), "{text}");
}

#[test]
fn greys_have_no_hue_and_colours_outside_are_told() {
    for model in ["oklch", "oklab", "lch", "lab", "hls", "hsv"] {
        let grey = json(&["convert", "--from", "srgb", "--to", model, "0.5,0.5,0.5"]);
        let zeros = numbers(&grey["values"]).into_iter().filter(|value| *value == 0.0).count();
        assert_eq!(zeros, 2, "{grey}");
    }
    let words = ["color", "convert", "--from", "rec2020", "--to", "srgb", "0,1,0"];
    let run = Folder::new().glanz(&words);
    assert!(!run.text().is_empty() && run.stderr.contains("outside of 0 to 1"), "{}", run.stderr);
    let e = Folder::new().glanz(&["color", "spectrum", "E"]).text().to_owned();
    assert!(e.contains("none, it has the chromaticity of equal energy"), "{e}");
}

#[test]
fn of_several_spectra_of_a_file_the_first_is_taken_and_told() {
    let folder = Folder::new();
    folder.write("pair.csv", PAIR);
    let found = folder.glanz(&["color", "spectrum", "pair.csv", "--format", "json"]);
    assert_eq!(found.json()["name"], "one reflectance");
    let told = "pair.csv holds 2 spectra: 'one reflectance' is taken, the first; --column NAME or NUMBER takes another: two \
                reflectance";
    assert!(found.stderr.contains(told), "{}", found.stderr);
    insta::assert_snapshot!(folder.glanz(&["color", "spectrum", "pair.csv:three"]).failure());
    let by = |column: &str| {
        let file = format!("pair.csv:{column}");
        folder.glanz(&["color", "spectrum", &file, "--format", "json"]).json()["values"].clone()
    };
    assert_eq!(by("2"), by("two reflectance"));
    assert_ne!(by("1"), by("2"));
}

#[test]
fn a_sensor_comes_from_a_file() {
    let folder = Folder::new();
    folder.write("camera.csv", "nm,near,far\n400,1,0\n550,1,1\n700,0,1\n");
    let words = ["color", "spectrum", "E", "--observer", "camera.csv", "--format", "json"];
    let json = folder.glanz(&words).json();
    // ∫: 150 nm at 1 and 150 nm falling to 0.
    assert!((number(&json["response_near"]) - 225.0).abs() < 3.0);
    assert!((number(&json["response_far"]) - 225.0).abs() < 3.0);
}

#[test]
fn a_large_file_is_refused_before_it_fills_the_memory() {
    let folder = Folder::new();
    folder.write("large.csv", vec![b'1'; (16 << 20) + 10]);
    let failure = folder.glanz(&["color", "spectrum", "large.csv"]).failure();
    assert!(failure.starts_with("3\n") && failure.contains("expected at most"), "{failure}");
}

#[test]
fn a_surface_is_no_metamer_of_itself_and_light_parts_others() {
    let same = json(&["metamers", "foliage", "foliage"]);
    for row in same["lights"].as_array().unwrap() {
        assert_eq!(number(&row["de2000"]), 0.0);
    }
    let folder = Folder::new();
    folder.write("pair.csv", PAIR);
    let words = ["color", "metamers", "pair.csv:1", "pair.csv:2", "--light", "D65,A"];
    let pair = folder.glanz(&[&words[..], &["--format", "json"]].concat()).json();
    let rows = pair["lights"].as_array().unwrap();
    assert!(rows[0]["metamerism_index"].is_null(), "the first light is the reference");
    assert!(number(&rows[1]["metamerism_index"]) > 1.0);
    insta::assert_snapshot!(folder.glanz(&words).text());
}

#[test]
fn scaled_copies_have_no_metamerism() {
    let folder = Folder::new();
    folder.write("a.csv", "nm,a reflectance,b reflectance\n300,0.2,0.4\n500,0.3,0.6\n780,0.4,0.8\n");
    let words = ["color", "metamers", "a.csv:1", "a.csv:2", "--light", "D65,A,FL11", "--format", "json"];
    let pair = folder.glanz(&words).json();
    for row in &pair["lights"].as_array().unwrap()[1..] {
        // X, Y, Z have the same ratio under every light, which the correction takes out.
        assert!(number(&row["metamerism_index"]) < 1e-9, "{row}");
        assert!(number(&row["de2000"]) > 10.0);
    }
}

#[test]
fn a_paper_note_glows() {
    let words = ["color", "fluorescence", "paper-note-pink", "--light", "D65,A,UV365"];
    let run = Folder::new().glanz(&words);
    insta::assert_snapshot!(run.text());
    let pink = json(&["fluorescence", "paper-note-pink", "--light", "D65"]);
    assert_eq!(pink["energy"]["ok"], true);
    let y = |part: &str| numbers(&pink["lights"][0][part]["xyz"])[1];
    assert!(y("total") > 1.2 * y("reflected"), "{} {}", y("total"), y("reflected"));
    let factors = numbers(&pink["lights"][0]["total_radiance_factor"]);
    assert!(factors.iter().any(|factor| *factor > 1.0), "more light leaves than arrives at some wavelength");
}

#[test]
fn a_matrix_without_glow_is_a_reflectance() {
    let folder = Folder::new();
    let mut table = "emission by excitation (nm),400,500,600,700\n".to_owned();
    for (row, nm) in [400, 500, 600, 700].into_iter().enumerate() {
        let cells: Vec<_> = (0..4).map(|column| if row == column { "0.5" } else { "0" }).collect();
        table += &format!("{nm},{}\n", cells.join(","));
    }
    folder.write("grey.csv", table);
    let words = ["color", "fluorescence", "grey.csv", "--light", "A", "--format", "json"];
    let grey = folder.glanz(&words).json();
    assert_eq!(grey["lights"][0]["total"], grey["lights"][0]["reflected"]);
    assert_eq!(number(&grey["lights"][0]["de2000"]), 0.0);
}

#[test]
fn everything_has_a_name_in_the_lists() {
    let all = json(&["list"]);
    for (kind, least) in [
        ("lights", 40),
        ("observers", 8),
        ("reflectances", 54),
        ("metals", 12),
        ("fluorescent", 6),
        ("models", 20),
    ] {
        let list = json(&["list", kind])[kind].clone();
        assert!(list.as_array().unwrap().len() >= least, "{kind}");
        assert_eq!(all[kind], list);
        let text = Folder::new().glanz(&["color", "list", kind]).text().to_owned();
        assert_eq!(text.lines().count(), 1 + list.as_array().unwrap().len());
    }
    insta::assert_snapshot!(Folder::new().glanz(&["color", "list", "observers"]).text());
    insta::assert_snapshot!(Folder::new().glanz(&["color", "list", "models"]).text());
}

#[test]
fn every_listed_light_has_numbers() {
    for light in json(&["list", "lights"])["lights"].as_array().unwrap() {
        let told = json(&["spectrum", light["example"].as_str().unwrap()]);
        assert_eq!(told["kind"], "light");
    }
}

#[test]
fn fewer_samples_err_more() {
    let found = json(&["efficiency", "--light", "D65,A"]);
    let mean = |way: &str, samples: u64| {
        let ways = found["ways"].as_array().unwrap();
        let of = ways.iter().find(|row| row["way"] == way && row["samples"] == samples).unwrap();
        [0, 1].map(|light| number(&of["under"][light]["mean"]))
    };
    for way in ["uniform, 300-780 nm", "uniform, 400-700 nm"] {
        assert!(mean(way, 4)[0] > 3.0 * mean(way, 12)[0], "{way}");
    }
    // The white of sRGB is given with four digits, which is what is left.
    assert!(mean("sRGB product", 3)[0] < 1e-2, "the product of sRGB is made for D65");
    let (published, adapted) = (mean("Meyer, published", 4), mean("Meyer, adapted", 4));
    assert!(published[1] > 2.0 * adapted[1], "weights solved for A help under A");
    insta::assert_snapshot!(Folder::new().glanz(&["color", "efficiency", "--light", "D65,A"]).text());
}

/// The commands that draw, without the file.
const PLOTS: [&[&str]; 9] = [
    &["plot", "spectra", "D65", "A"],
    &["plot", "spectra", "gold", "--normalize"],
    &["plot", "chromaticity", "--mark", "D65"],
    &["plot", "cones"],
    &["plot", "meyer"],
    &["plot", "matrix", "paper-note-yellow"],
    &["plot", "tm30", "FL11"],
    &["plot", "efficiency", "--light", "D65"],
    &["plot", "spectra", "line(500)"],
];

#[test]
fn every_plot_is_an_svg_with_its_words() {
    let folder = Folder::new();
    for words in PLOTS {
        let run = folder.glanz(&[&["color"], words, &["-o", "a.svg"]].concat());
        assert_eq!((run.text(), run.stderr.as_str()), ("", "wrote a.svg\n"), "{words:?}");
        let svg = String::from_utf8(folder.read("a.svg")).unwrap();
        assert!(svg.starts_with("<svg ") && svg.ends_with("</svg>\n"), "{words:?}");
        assert!(svg.matches("<text ").count() > 10, "{words:?} has no words");
        // The letters of an image within may spell anything.
        let drawn = svg.lines().filter(|line| !line.starts_with("<image"));
        assert!(!drawn.into_iter().any(|line| line.contains("NaN") || line.contains("inf")), "{words:?}");
    }
}

#[test]
fn every_plot_is_a_png_that_is_not_blank() {
    let folder = Folder::new();
    for words in &PLOTS[2..6] {
        folder.glanz(&[&["color"], *words, &["-o", "a.png"]].concat()).text();
        let bytes = folder.read("a.png");
        let mut reader = png::Decoder::new(Cursor::new(bytes)).read_info().unwrap();
        let mut data = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut data).unwrap();
        assert!(info.width > 1000 && info.height > 1000, "{words:?}");
        let dark = data.chunks(3).filter(|rgb| rgb.iter().all(|c| *c < 0x60)).count();
        assert!(dark > 2000, "{words:?}: {dark} dark pixels");
    }
}

#[test]
fn commands_of_numbers_draw_too() {
    let folder = Folder::new();
    for words in [
        &["spectrum", "gold"][..],
        &["metamers", "foliage", "dark-skin"],
        &["fluorescence", "paper-note-pink", "--light", "D65"],
        &["efficiency", "--light", "E"],
    ] {
        let run = folder.glanz(&[&["color"], words, &["--plot", "a.svg"]].concat());
        assert!(!run.text().is_empty());
        assert_eq!(run.stderr, "wrote a.svg\n");
        assert!(folder.read("a.svg").starts_with(b"<svg "), "{words:?}");
    }
}
