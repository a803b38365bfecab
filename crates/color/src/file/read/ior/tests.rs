use super::*;

fn index(text: &str, file: &str) -> Result<(Ior, Vec<String>), ReadError> {
    read_ior(text.as_bytes(), file)?.to_ior()
}

/// n, k at 550 nm.
fn at_550(text: &str, file: &str) -> (f64, f64) {
    let (ior, _) = index(text, file).expect("it is read");
    (ior.eta.at(550.0), ior.k.at(550.0))
}

#[test]
fn a_table_of_n_and_k_is_read_whatever_its_units_and_headers() {
    let wanted = (0.53, 2.77);
    for text in [
        "nm,n,k\n450,1.09,1.83\n550,0.53,2.77\n650,0.44,3.69\n",
        "Wavelength(nm)\tn\tk\n450\t1.09\t1.83\n550\t0.53\t2.77\n650\t0.44\t3.69\n",
        "wl;k;n\n0,45;1,83;1,09\n0,55;2,77;0,53\n0,65;3,69;0,44\n",
        "# brass\n0.45 1.09 1.83\n0.55 0.53 2.77\n0.65 0.44 3.69\n",
        "wl,n\n0.45,1.09\n0.55,0.53\n0.65,0.44\n\nwl,k\n0.45,1.83\n0.55,2.77\n0.65,3.69\n",
        "wl\tn\r\n0.45\t1.09\r\n0.55\t0.53\r\n0.65\t0.44\r\nwl\tk\r\n0.45\t1.83\r\n0.55\t2.77\r\n0.65\t3.69\r\n",
        "Wavelength (µm),Refractive index,Extinction coefficient\n0.45,1.09,1.83\n0.55,0.53,2.77\n0.65,0.44,3.69\n",
        "energy (eV) n k\n1.9074 0.44 3.69\n2.25426 0.53 2.77\n2.7552 1.09 1.83\n",
    ] {
        let (n, k) = at_550(text, "x.csv");
        assert!((n - wanted.0).abs() < 1e-4 && (k - wanted.1).abs() < 1e-4, "{n} {k}: {text}");
    }
}

#[test]
fn what_is_assumed_is_told() {
    let (glass, notes) = index("0.4 1.53\n0.7 1.51\n", "glass.txt").expect("it is read");
    assert_eq!(glass.k, Spectrum::ZERO);
    let told = |word: &str| notes.iter().any(|note| note.contains(word));
    assert!(told("taken as n") && told("taken as µm") && told("beyond"), "{notes:?}");
    let (_, notes) = index("nm,n,k,T\n300,1,1,20\n800,1,1,20\n", "x.csv").expect("it is read");
    assert!(notes.iter().any(|note| note.contains("neither n nor k")), "{notes:?}");
}

#[test]
fn noise_below_0_is_no_absorption() {
    let (clear, notes) = index("nm,n,k\n300,1.5,-3e-4\n800,1.5,1e-6\n", "x.csv").expect("it is read");
    assert_eq!(clear.k.at(300.0), 0.0);
    assert!(notes.iter().any(|note| note.contains("noise")), "{notes:?}");
}

#[test]
fn a_record_of_the_database_is_read() {
    let metal = "REFERENCES: \"J. <i>Doe</i>, <a href=\\\"x\\\">Metals</a>\"\nDATA:\n  - type: tabulated nk\n    data: |\n        \
                 0.45 1.09 1.83\n        0.55 0.53 2.77\n        0.65 0.44 3.69\n";
    assert_eq!(at_550(metal, "brass.yml"), (0.53, 2.77));
    assert_eq!(index(metal, "brass.yml").expect("it is read").0.source, "J. Doe, Metals");
    let glass = "DATA:\n  - type: formula 2\n    wavelength_range: 0.3 2.5\n    coefficients: 0 1.03961212 0.00600069867 \
                 0.231792344 0.0200179144 1.01046945 103.560653\n  - type: tabulated k\n    data: |\n        0.3 1e-6\n        0.8 1e-8\n";
    let (n, k) = at_550(glass, "bk7.yml");
    assert!((n - 1.518_52).abs() < 1e-5 && k > 0.0 && k < 1e-6, "{n} {k}");
    let constant = "DATA:\n  - type: formula 5\n    coefficients: 1.5\n";
    assert_eq!(at_550(constant, "c.yml"), (1.5, 0.0));
}

#[test]
fn halves_of_two_files_make_one() {
    let n = "#wl n\n400 1.5\n700 1.2\n";
    let k = "400 2\n700 3\n";
    let metal =
        read_ior_pair((n.as_bytes(), "a/Xx.eta.spd"), (k.as_bytes(), "a/Xx.k.spd")).expect("it is read");
    let (ior, _) = metal.to_ior().expect("it is an index");
    assert_eq!(ior.name, "Xx");
    assert!((ior.eta.at(550.0) - 1.35).abs() < 1e-12 && (ior.k.at(550.0) - 2.5).abs() < 1e-12);
    assert_eq!(ior_partner("metal-Cu-eta.spd").as_deref(), Some("metal-Cu-k.spd"));
    let error = read_ior(k.as_bytes(), "Xx.k.spd").expect_err("n is missing");
    assert!(error.to_string().contains("the file of n"), "{error}");
}

#[test]
fn what_is_no_index_is_refused() {
    for (text, word) in [
        ("nm,reflectance\n400,0.5\n700,0.6\n", "columns named n and k"),
        ("nm,n,k\n400,-1,0\n700,1,0\n", "-1 at 400 nm"),
        ("nm,n,k\n400,1,-3\n700,1,0\n", "-3 at 400 nm"),
        ("nm,k\n400,1\n700,1\n", "k alone"),
        ("um,n\n5,1.5\n9,1.4\n", "5000 to 9000 nm"),
        ("DATA:\n  - type: tabulated nk\n    data: |\n        0.5 1.5\n", "lines of 3 numbers"),
        ("DATA:\n  - type: formula 12\n    coefficients: 1\n", "formula from 1 to 9"),
        ("DATA:\n  - type: [tab\n", "YAML"),
        ("DATA: 3\n", "a list 'DATA'"),
    ] {
        let error = index(text, "x").expect_err(text);
        assert!(error.to_string().contains(word), "{text}: {error}");
    }
    let deep = format!("DATA:\n  - {}", "[".repeat(100_000));
    assert!(index(&deep, "x").is_err());
}

proptest::proptest! {
    #[test]
    fn any_text_is_read_or_refused(text in "(DATA:\n)?( - type: (tabulated nk|formula [0-9])\n   (data|coefficients): )?[-0-9.,;nk \n:|e]{0,200}") {
        let _ = index(&text, "x");
    }
}
