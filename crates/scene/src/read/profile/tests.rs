use core::f64::consts::PI;

use proptest::prelude::*;

use super::*;
use crate::Luminaire;

/// Rounding of a few products.
const ROUNDING: f64 = 1e-12;

/// A file of LM-63-2002 with these angles; intensity 100·(plane + 1) + row.
fn ies(head: &str, gamma: &[f64], c: &[f64]) -> String {
    let list = |values: &[f64]| values.iter().map(f64::to_string).collect::<Vec<_>>().join(" ");
    let planes: Vec<String> = (0..c.len())
        .map(|plane| list(&(0..gamma.len()).map(|row| (100 * (plane + 1) + row) as f64).collect::<Vec<_>>()))
        .collect();
    format!(
        "{head}\n1 1000 1 {} {} 1 2 0.1 0.2 0\n1 1 20\n{}\n{}\n{}\n",
        gamma.len(),
        c.len(),
        list(gamma),
        list(c),
        planes.join("\n")
    )
}

const HEAD: &str = "IESNA:LM-63-2002\n[TEST] none\n[MANUFAC] nobody\nTILT=NONE";

/// A EULUMDAT file with this symmetry; intensity 100·(plane + 1) + row, of planes as they stand in it.
fn ldt(isym: u8, all: usize, given: usize) -> String {
    let mut lines = vec!["nobody", "1"].into_iter().map(str::to_owned).collect::<Vec<_>>();
    lines.extend([isym.to_string(), all.to_string(), (360 / all).to_string(), "3".into(), "45".into()]);
    lines.extend((8..=21).map(|line| if line < 13 { format!("text {line}") } else { "100".into() }));
    lines.extend(["100", "80", "1.0", "0", "1", "2", "LED", "2000", "3000 K", "80", "20"].map(str::to_owned));
    lines.extend((0..10).map(|_| "0.5".to_owned()));
    lines.extend((0..all).map(|plane| (plane * 360 / all).to_string()));
    lines.extend(["0", "45", "90"].map(str::to_owned));
    lines
        .extend((0..given).flat_map(|plane| (0..3).map(move |row| format!("{},0", 100 * (plane + 1) + row))));
    lines.join("\r\n")
}

/// Files of all kinds, with their names.
pub(in crate::read) fn samples() -> Vec<(String, &'static str)> {
    vec![
        (ies(HEAD, &[0.0, 45.0, 90.0], &[0.0, 30.0, 90.0]), "a.ies"),
        (ies(HEAD, &[0.0, 90.0, 180.0], &[90.0, 180.0, 270.0]), "a.ies"),
        (ldt(4, 4, 2), "a.ldt"),
        (ldt(3, 8, 5), "a.ldt"),
        (ldt(0, 4, 4), "a.ldt"),
    ]
}

fn read(text: &str, file: &str) -> (Profile, Vec<String>) {
    read_profile(text.as_bytes(), file).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn error(text: &str, file: &str) -> String {
    read_profile(text.as_bytes(), file).expect_err(text).to_string()
}

/// The intensities at γ = 0 by half planes.
fn first_row(profile: &Profile) -> Vec<(f64, f64)> {
    let rows = profile.gamma_deg.len();
    profile.c_deg.iter().zip(profile.candela.chunks(rows)).map(|(c, values)| (*c, values[0])).collect()
}

/// Angles of half planes, and intensities at γ = 0 by half planes.
type Expanded<'a> = (&'a [f64], &'a [(f64, f64)]);

#[test]
fn byte_order_marks_and_lines_that_end_with_cr_do_no_harm() {
    for (text, file) in [(ies(HEAD, &[0.0, 90.0], &[0.0]), "l.ies"), (ldt(0, 4, 4), "l.ldt")] {
        let plain = read_profile(text.as_bytes(), file).unwrap();
        let cr = text.replace("\r\n", "\r").replace('\n', "\r");
        for text in [format!("\u{feff}{text}"), cr.clone(), format!("\u{feff}{cr}")] {
            assert_eq!(read_profile(text.as_bytes(), file).unwrap(), plain, "{file}");
        }
    }
}

#[test]
fn every_symmetry_of_lm63_is_expanded_to_the_whole_circle() {
    let gamma = [0.0, 45.0, 90.0];
    let cases: [Expanded; 5] = [
        (&[0.0], &[(0.0, 100.0)]),
        (
            &[0.0, 30.0, 90.0],
            &[
                (0.0, 100.0),
                (30.0, 200.0),
                (90.0, 300.0),
                (150.0, 200.0),
                (180.0, 100.0),
                (210.0, 200.0),
                (270.0, 300.0),
                (330.0, 200.0),
                (360.0, 100.0),
            ],
        ),
        (&[0.0, 60.0, 180.0], &[(0.0, 100.0), (60.0, 200.0), (180.0, 300.0), (300.0, 200.0), (360.0, 100.0)]),
        (
            &[90.0, 180.0, 210.0, 270.0],
            &[
                (0.0, 200.0),
                (90.0, 100.0),
                (180.0, 200.0),
                (210.0, 300.0),
                (270.0, 400.0),
                (330.0, 300.0),
                (360.0, 200.0),
            ],
        ),
        (&[0.0, 90.0, 360.0], &[(0.0, 100.0), (90.0, 200.0), (360.0, 100.0)]),
    ];
    for (c, expected) in cases {
        let (profile, notes) = read(&ies(HEAD, &gamma, c), "a.ies");
        assert_eq!((first_row(&profile), notes), (expected.to_vec(), vec![]), "{c:?}");
        assert_eq!(profile.gamma_deg, gamma);
        assert_eq!(profile.candela[2] - profile.candela[0], 2.0);
    }
    let (open, notes) = read(&ies(HEAD, &gamma, &[0.0, 120.0, 240.0]), "a.ies");
    assert_eq!(first_row(&open), [(0.0, 100.0), (120.0, 200.0), (240.0, 300.0), (360.0, 100.0)]);
    assert_eq!(notes.len(), 1);
}

#[test]
fn every_symmetry_of_eulumdat_is_expanded_to_the_whole_circle() {
    // The lamps have 2000 lm: the intensities, given for 1000 lm, double.
    let cases: [(u8, usize, &[f64]); 5] = [
        (0, 4, &[200.0, 400.0, 600.0, 800.0, 200.0]),
        (1, 1, &[200.0]),
        (2, 3, &[200.0, 400.0, 600.0, 400.0, 200.0]),
        // From C 270° over C 0° to C 90°.
        (3, 3, &[400.0, 600.0, 400.0, 200.0, 400.0]),
        (4, 2, &[200.0, 400.0, 200.0, 400.0, 200.0]),
    ];
    for (isym, given, expected) in cases {
        let (profile, notes) = read(&ldt(isym, 4, given), "a.ldt");
        let values: Vec<f64> = first_row(&profile).iter().map(|(_, value)| *value).collect();
        assert_eq!((values.as_slice(), notes), (expected, vec![]), "{isym}");
        assert_eq!(profile.gamma_deg, [0.0, 45.0, 90.0]);
        assert_eq!(profile.candela[2] - profile.candela[0], 4.0);
    }
}

#[test]
fn the_older_editions_of_lm63_have_labels_and_a_factor_of_the_ballast() {
    let plain = ies(HEAD, &[0.0, 90.0], &[0.0]);
    let factors = plain.replace("1 1000 1 2", "1 1000 2 2").replace("\n1 1 20", "\n0.5 0.8 20");
    let labels = |first: &str| factors.replace("IESNA:LM-63-2002\n[TEST] none", first);
    let cases = [("IESNA91\nlabel", 80.0), ("a lamp\nof 1986", 80.0), ("IESNA:LM-63-1995", 80.0)];
    let reserved = [("IESNA:LM-63-2002", 100.0), ("IES:LM-63-2019", 100.0)];
    for (first, expected) in cases.into_iter().chain(reserved) {
        let (profile, _) = read(&labels(first), "lamp");
        assert!((profile.candela[0] - expected).abs() < ROUNDING, "{first}: {}", profile.candela[0]);
    }
}

#[test]
fn tilt_is_passed_over_with_a_remark() {
    let included = HEAD.replace("NONE", "INCLUDE\n1\n3\n0 90 180\n1.0 0.9, 1.0");
    for head in [&included, &HEAD.replace("NONE", "LAMP.TLT")] {
        let (profile, notes) = read(&ies(head, &[0.0, 90.0], &[0.0]), "a.ies");
        assert_eq!((profile.candela, notes.len()), (vec![100.0, 101.0], 1));
    }
}

#[test]
fn the_flux_of_a_lambertian_luminaire_is_pi_times_its_intensity() {
    let gamma: Vec<f64> = (0..=90).map(f64::from).collect();
    let values: Vec<String> =
        gamma.iter().map(|g| (1000.0 * libm::cos(g.to_radians())).to_string()).collect();
    let angles: Vec<String> = gamma.iter().map(f64::to_string).collect();
    let text =
        format!("{HEAD}\n1 -1 1 91 1 1 2 0 0 0\n1 1 20\n{}\n0\n{}\n", angles.join(" "), values.join("\n"));
    let (profile, _) = read(&text, "a.ies");
    // A chord of the cosine over 1° lies at most 1 − cos 0.5° below it.
    assert!((profile.flux_lm() / (1000.0 * PI) - 1.0).abs() < 4e-5, "{}", profile.flux_lm());
    let axis = Luminaire::AXIS;
    let lamp = Luminaire { profile: profile.into(), axis, c0: Luminaire::c0_for(axis) };
    let slant = glam::DVec3::new(0.0, libm::sin(PI / 3.0), libm::cos(PI / 3.0));
    assert!((lamp.fraction(slant) - 0.5).abs() < ROUNDING);
}

#[test]
fn negative_intensities_and_odd_lines_of_eulumdat_are_told() {
    let text = ldt(1, 4, 1).replace("102,0", "-2,0");
    let (profile, notes) = read(&text, "a.ldt");
    assert_eq!((profile.candela[2], notes.len()), (0.0, 1));
    let mut lines: Vec<&str> = text.split("\r\n").collect();
    (lines[23], lines[24]) = ("0", "15");
    let (_, notes) = read(&lines.join("\n"), "a.ldt");
    assert_eq!(notes.len(), 3, "{notes:?}");
}

#[test]
fn the_lamps_of_the_first_set_count() {
    let mut lines: Vec<String> = ldt(1, 4, 1).split("\r\n").map(str::to_owned).collect();
    lines[25] = "2".to_owned();
    lines.splice(32..32, ["1", "LED", "500", "4000 K", "90", "5"].map(str::to_owned));
    let (profile, notes) = read(&lines.join("\n"), "a.ldt");
    assert_eq!((profile.candela[0], notes.len()), (200.0, 1));
}

#[test]
fn the_format_is_told_by_the_first_bytes_then_by_the_name() {
    let (ies, ldt) = (ies(HEAD, &[0.0, 90.0], &[0.0]), ldt(1, 4, 1));
    for name in ["a.ldt", "a", "a.IES"] {
        assert_eq!(read(&ies, name).0.max(), 101.0, "{name}");
    }
    for name in ["a.ldt", "a", "a.LDT"] {
        assert_eq!(read(&ldt, name).0.max(), 204.0, "{name}");
    }
}

#[test]
fn errors_say_where_and_what_was_expected() {
    let plain = ies(HEAD, &[0.0, 90.0], &[0.0]);
    let cases = [
        ("nothing".to_owned(), "a.ies: the file: expected a line that begins with TILT=, found none"),
        (plain.replace("1 2 0.1", "2 2 0.1"), "photometry of type C, found type B, which is not supported"),
        (plain.replace("1 2 0.1", "3 2 0.1"), "photometry of type C, found type A, which is not supported"),
        (
            plain.replace("0 90", "0 x"),
            "line 7: expected a vertical angle, a number of at most 1e12, found 'x'",
        ),
        (plain.replace("0 90", "0 1e400"), "line 7: expected a vertical angle"),
        (plain.replace("0 90", "90 0"), "increasing angles from the axis, found 0° after 90°"),
        (plain.replace("0 90", "0 190"), "between 0° and 180°, found 190°"),
        (plain.replace("1 2 1 1 2", "1 99999999 1 1 2"), "line 5: expected the number of vertical angles"),
        (plain.replace("1 2 1 1 2", "1 9999999 1 1 2"), "line 9: expected a vertical angle, found the end"),
        (plain.replace("\n1 1 20", "\n0 1 20"), "a ballast factor greater than 0, found 0"),
        (plain.replace("101\n", ""), "line 9: expected an intensity, found the end of the file"),
        (ies(HEAD, &[0.0, 90.0], &[0.0, 45.0]), "or from 90° to 270°, found from 0° to 45°"),
    ];
    for (text, expected) in cases {
        let found = error(&text, "a.ies");
        assert!(found.contains(expected), "{found}\n{expected}");
    }
    let plain = ldt(4, 4, 2);
    let cases = [
        (String::new(), "a.ldt: line 1: expected the maker and the type of the source, found the end"),
        (plain.replacen("\r\n4\r\n", "\r\n5\r\n", 1), "line 3: expected a symmetry from 0 to 4, found 5"),
        (plain.replacen("\r\n4\r\n90", "\r\n6\r\n90", 1), "line 4: expected a number of half planes that 4"),
        (plain.replace("2000", "0"), "line 29: expected a flux of the lamps greater than 0 lm, found 0"),
        (plain.replace("202,0", "2 02"), "expected an intensity, a number of at most 1e12, found '2 02'"),
    ];
    for (text, expected) in cases {
        let found = error(&text, "a.ldt");
        assert!(found.contains(expected), "{found}\n{expected}");
    }
}

/// What holds of every answer.
fn check(bytes: &[u8], file: &str) -> Result<(), TestCaseError> {
    match read_profile(bytes, file) {
        Ok((profile, _)) => {
            let (planes, rows) = (profile.c_deg.len(), profile.gamma_deg.len());
            prop_assert!(planes > 0 && rows > 0 && profile.candela.len() == planes * rows);
            prop_assert!(profile.c_deg.windows(2).all(|pair| pair[0] < pair[1]));
            prop_assert!(profile.gamma_deg.windows(2).all(|pair| pair[0] < pair[1]));
            prop_assert!(profile.c_deg[0] == 0.0 && (planes == 1 || profile.c_deg[planes - 1] == 360.0));
            prop_assert!(profile.candela.iter().all(|value| value.is_finite() && *value >= 0.0));
            prop_assert!(profile.at(123.0, 45.0) <= profile.max() * (1.0 + ROUNDING));
        }
        Err(error) => prop_assert!(error.to_string().contains(": expected ")),
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(300) })]

    #[test]
    fn any_bytes_are_read_or_refused(bytes in prop::collection::vec(any::<u8>(), 0..300), ldt in any::<bool>()) {
        check(&bytes, if ldt { "a.ldt" } else { "a.ies" })?;
    }

    #[test]
    fn damaged_files_are_read_or_refused(
        which in 0usize..5,
        edits in prop::collection::vec((any::<prop::sample::Index>(), "[0-9 .,e-]{0,4}|\n|TILT=|nan|9999999"), 1..4),
        keep in 0.0..1.5,
    ) {
        let (text, file) = samples().swap_remove(which);
        let mut bytes = text.into_bytes();
        for (place, piece) in edits {
            let at = place.index(bytes.len());
            bytes.splice(at..(at + 1).min(bytes.len()), piece.into_bytes());
        }
        bytes.truncate((keep * bytes.len() as f64) as usize);
        check(&bytes, file)?;
    }
}
