//! What all plots have in common: formats, titles, sizes and languages; and plots of lights and directions.

use std::io::Cursor;

use crate::folder::Folder;

/// A plot of each kind, without the file.
const PLOTS: [&[&str]; 24] = [
    &["plot", "phong"],
    &["plot", "phong", "--kind", "cartesian"],
    &["plot", "phong", "--kind", "lobe3d"],
    &["plot", "phong", "--kind", "albedo"],
    &["plot", "ward", "--kind", "slice"],
    &["plot", "--kind", "fresnel"],
    &["plot", "cook-torrance", "--kind", "terms"],
    &["plot", "--kind", "attenuation"],
    &["plot", "--kind", "spot"],
    &["plot", "--kind", "vectors"],
    &["color", "plot", "spectra", "D65", "A"],
    &["color", "plot", "chromaticity"],
    &["color", "plot", "cones"],
    &["color", "plot", "meyer"],
    &["color", "plot", "matrix", "paper-note-yellow"],
    &["color", "plot", "efficiency", "--light", "D65"],
    &["plot", "eye", "--kind", "lens"],
    &["plot", "eye", "--kind", "rods"],
    &["plot", "eye", "--kind", "pupil"],
    &["plot", "eye", "--kind", "mesopic"],
    &["plot", "eye", "--kind", "glare"],
    &["plot", "eye", "--kind", "csf"],
    &["plot", "eye", "--kind", "response"],
    &["plot", "eye", "--kind", "mosaic"],
];

/// English words that no French plot has.
const ENGLISH: [&str; 10] = [
    "viewer",
    "light ",
    "angle of",
    "wavelength",
    "distance in",
    "reflectance",
    "number of",
    " of the",
    "from",
    "part of",
];

/// The points of a curve of a CSV table: the numbers behind its name.
fn curve(table: &str, name: &str) -> Vec<Vec<f64>> {
    let rows = table.lines().filter_map(|line| line.strip_prefix(name)?.strip_prefix(','));
    rows.map(|row| row.split(',').map(|cell| cell.parse().unwrap_or(f64::NAN)).collect()).collect()
}

/// The value of a curve at the place nearest to `x`.
fn value_at(points: &[Vec<f64>], x: f64) -> f64 {
    points.iter().min_by(|a, b| (a[0] - x).abs().total_cmp(&(b[0] - x).abs())).unwrap()[1]
}

#[test]
fn every_plot_comes_in_every_format_as_a_file_and_on_stdout() {
    let folder = Folder::new();
    for words in PLOTS {
        for (format, head) in [
            ("svg", &b"<svg "[..]),
            ("pdf", b"%PDF-1.7"),
            ("csv", b""),
            ("json", b"{\"version\":1,\"title\":"),
        ] {
            let file = format!("a.{format}");
            assert_eq!(
                folder.glanz(&[words, &["-o", &file]].concat()).stderr,
                format!("wrote {file}\n"),
                "{words:?}"
            );
            let run = folder.glanz(&[words, &["-o", "-", "--format", format]].concat());
            assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{words:?} {format}");
            assert!(run.stdout == folder.read(&file), "{words:?}: another {format} on stdout");
            assert!(run.stdout.starts_with(head), "{words:?} {format}");
            if format == "json" {
                let json = run.json();
                let points = json["panels"][0]["curves"][0]["points"].as_array().unwrap();
                let columns = json["panels"][0]["columns"].as_array().unwrap();
                assert!(
                    !points.is_empty()
                        && points.iter().all(|point| point.as_array().unwrap().len() == columns.len())
                );
            }
        }
    }
}

#[test]
fn every_plot_is_french_where_french_is_asked_for() {
    let folder = Folder::new();
    for words in PLOTS {
        let svg = folder.glanz(&[words, &["-o", "-", "--lang", "fr"]].concat()).text().to_owned();
        let texts = svg.lines().filter(|line| line.starts_with("<text "));
        for text in texts {
            let found = ENGLISH.iter().find(|english| text.contains(*english));
            assert!(found.is_none(), "{words:?}: {text}");
        }
        let csv = folder
            .glanz(&[words, &["-o", "-", "--lang", "fr", "--format", "csv"]].concat())
            .text()
            .to_owned();
        let head = csv.lines().next().unwrap();
        assert!(ENGLISH.iter().all(|english| !head.contains(english)), "{words:?}: {head}");
    }
}

#[test]
fn every_plot_has_the_title_and_the_size_that_are_asked_for() {
    let folder = Folder::new();
    for words in PLOTS {
        for size in [(640, 480), (300, 500)] {
            let wanted = format!("{}x{}", size.0, size.1);
            let more = ["--title", "Ein Titel", "--size", &wanted, "-o"];
            let svg = folder.glanz(&[words, &more, &["-"]].concat()).text().to_owned();
            assert!(svg.contains(">Ein Titel</text>"), "{words:?}");
            let head = format!("width=\"{}\" height=\"{}\"", size.0, size.1);
            assert!(svg.starts_with("<svg ") && svg.contains(&head), "{words:?}: {}", &svg[..120]);
        }
        let json =
            folder.glanz(&[words, &["--title", "Ein Titel", "-o", "-", "--format", "json"]].concat()).json();
        assert_eq!(json["title"], "Ein Titel");
    }
    for (words, size) in [(PLOTS[0], "320x240"), (PLOTS[11], "200x300")] {
        folder.glanz(&[words, &["--size", size, "-o", "a.png"]].concat()).text();
        let reader = png::Decoder::new(Cursor::new(folder.read("a.png"))).read_info().unwrap();
        assert_eq!(format!("{}x{}", reader.info().width, reader.info().height), size);
    }
}

#[test]
fn the_numbers_of_a_fresnel_curve_are_those_of_the_formula() {
    let folder = Folder::new();
    let words = ["plot", "--kind", "fresnel", "--ior", "1.5", "--polarised", "-o", "-", "--format", "csv"];
    let table = folder.glanz(&words).text().to_owned();
    assert!(table.starts_with("curve,angle of incidence in °,reflectance\n"), "{table:.80}");
    // (n - 1)² / (n + 1)², and by hand at 60°: Rs = 0.1769, Rp = 0.0015.
    assert!((value_at(&curve(&table, "n = 1.5"), 0.0) - 0.04).abs() < 1e-12);
    assert!((value_at(&curve(&table, "n = 1.5"), 60.0) - 0.089_187).abs() < 1e-6);
    let [s, p] = ["\"n = 1.5, s\"", "\"n = 1.5, p\""].map(|name| value_at(&curve(&table, name), 60.0));
    assert!((0.5 * (s + p) - 0.089_187).abs() < 1e-6 && s > 0.17 && p < 0.002, "{s} {p}");
}

#[test]
fn attenuation_and_cones_are_those_of_scene_files() {
    let folder = Folder::new();
    let table = |words: &[&str]| {
        folder.glanz(&[&["plot"], words, &["-o", "-", "--format", "csv"]].concat()).text().to_owned()
    };
    let laws = "attenuation=none,{linear=1},{constant=1, quadratic=0.25},\"physical\"";
    let fade = table(&["--kind", "attenuation", "--set", laws, "--distance", "4"]);
    for (name, value) in
        [("none: 1", 1.0), ("1 / d", 0.5), ("1 / (1 + 0.25 d²)", 0.5), ("physical: 1 / d²", 0.25)]
    {
        assert!((value_at(&curve(&fade, name), 2.0) - value).abs() < 1e-9, "{name}");
    }
    let cone = table(&["--kind", "spot", "--set", "cutoff_deg=30,70", "--set", "exponent=2"]);
    let narrow = curve(&cone, "\"cutoff_deg = 30, exponent = 2\"");
    let wide = curve(&cone, "\"cutoff_deg = 70, exponent = 2\"");
    assert_eq!((value_at(&narrow, 60.0), value_at(&narrow, 0.0)), (0.0, 1.0));
    assert!((value_at(&wide, 60.0) - 0.25).abs() < 2e-2, "{}", value_at(&wide, 60.0));
}

#[test]
fn the_directions_are_drawn_with_their_angles() {
    let folder = Folder::new();
    let words = ["plot", "--kind", "vectors", "--wo", "20,180", "--wi", "60,0", "-o", "-"];
    let svg = folder.glanz(&words).text().to_owned();
    for name in ["N", "L", "V", "R", "H"] {
        assert!(svg.contains(&format!(">{name}</text>")), "{name}");
    }
    assert!(svg.contains("N·L = cos 60° = 0.5") && svg.contains("R·V = cos 40° = 0.766044"), "no cosines");
}

#[test]
fn in_the_unit_of_the_course_the_peak_is_1() {
    let folder = Folder::new();
    for model in ["lambert", "phong"] {
        let words = ["plot", model, "--unit", "course", "--theta", "0", "-o", "-", "--format", "csv"];
        let table = folder.glanz(&words).text().to_owned();
        let most = table.lines().skip(1).map(|line| line.rsplit(',').next().unwrap().parse().unwrap());
        assert!((most.fold(0.0, f64::max) - 1.0).abs() < 1e-12, "{model}");
        let words =
            ["bsdf", "eval", model, "--wo", "0,0", "--wi", "0,0", "--unit", "course", "--format", "json"];
        let json = folder.glanz(&words).json();
        assert!(
            (json["f_cos"].as_f64().unwrap() - 1.0).abs() < 1e-12 && json["unit"] == "1/(π sr)",
            "{json}"
        );
    }
    assert!(
        folder.glanz(&["bsdf", "show", "phong", "--unit", "course"]).text().contains("max(R·wo, 0)ⁿ where")
    );
}

#[test]
fn letters_that_the_font_does_not_have_are_told() {
    let folder = Folder::new();
    let run = folder.glanz(&["plot", "phong", "--title", "光 light", "-o", "a.png"]);
    assert!(run.stderr.starts_with("note: the font of plots does not have '光'"), "{}", run.stderr);
    assert_eq!(folder.glanz(&["plot", "phong", "--title", "光", "-o", "a.svg"]).stderr, "wrote a.svg\n");
}

#[test]
fn the_numbers_of_the_curves_of_eyes_are_those_of_their_formulas() {
    let folder = Folder::new();
    let table = |words: &[&str]| {
        let words = [&["plot", "eye"], words, &["-o", "-", "--format", "csv"]].concat();
        folder.glanz(&words).text().to_owned()
    };
    let lens = table(&["--kind", "lens", "--age", "20,80"]);
    assert!(lens.starts_with("curve,wavelength in nm,transmittance\n"), "{lens:.80}");
    // CIE 170-1:2006 and CIE 203:2012 at 450 nm.
    for (name, known) in [
        ("\"20 years, CIE 170-1\"", 0.6297),
        ("\"80 years, CIE 170-1\"", 0.1768),
        ("\"20 years, CIE 203\"", 0.6177),
        ("\"80 years, CIE 203\"", 0.1771),
    ] {
        assert!((value_at(&curve(&lens, name), 450.0) - known).abs() < 5e-5, "{name}");
    }
    // Watson and Yellott at the end of the curve, where 10⁴ cd/m² leave 2.1503 mm.
    let pupil = table(&["--kind", "pupil", "--age", "20"]);
    assert!((value_at(&curve(&pupil, "20 years"), 1e4) - 2.1503).abs() < 5e-5);
    // More light shows finer gratings.
    let csf = table(&["--kind", "csf", "--luminance", "0.1,100"]);
    let at_10 = |luminance: &str| value_at(&curve(&csf, &format!("\"light–dark, {luminance} cd/m²\"")), 10.0);
    assert!(at_10("100") > 20.0 * at_10("0.1"), "{} {}", at_10("100"), at_10("0.1"));
}

#[test]
fn an_option_of_eyes_that_has_no_effect_is_refused() {
    let folder = Folder::new();
    for (kind, option, value, acts) in [
        ("csf", "--age", "20", "it acts on lens, cones, rods, pupil and glare"),
        ("lens", "--luminance", "20", "it acts on csf and response"),
        ("pupil", "--pigment", "1", "it acts on glare"),
    ] {
        let run = folder.glanz(&["plot", "eye", "--kind", kind, option, value, "-o", "a.svg"]);
        assert_eq!(run.code, 2, "{kind}");
        assert!(run.stderr.contains(acts), "{}", run.stderr);
    }
    for (words, told) in [
        (["--kind", "lens", "--age", "19"], "from 20 to 80"),
        (["--kind", "response", "--luminance", "0"], "from 1 to 3993"),
        (["--kind", "glare", "--pigment", "nan"], "from 0 (very dark) to 1.2"),
    ] {
        let run = folder.glanz(&[&["plot", "eye"], &words[..], &["-o", "a.svg"]].concat());
        assert_eq!(run.code, 2, "{words:?}");
        assert!(run.stderr.contains(told), "{}", run.stderr);
    }
    assert!(folder.names().is_empty(), "{:?}", folder.names());
}
