//! Tables with words among their numbers.

use core::fmt::Write;

use super::*;

/// Lines of a table, one for every 10 nm from 400 on.
fn table(head: &str, count: usize, line: impl Fn(usize) -> String) -> String {
    (0..count).fold(head.to_owned() + "\n", |text, at| text + &line(at) + "\n")
}

#[test]
fn the_separator_of_words_is_not_the_comma_of_decimals() {
    let text = table("nm;flag;reflectance (%)", 8, |i| format!("{}0,5;ok;1{i},01", 40 + i));
    let (leaf, found) = points(&text);
    assert_eq!((found.len(), found[0], found[3]), (8, (400.5, 0.1001), (430.5, 0.1301)));
    assert_eq!(leaf.notes[0], "column 2 of words left out, such as 'ok'");
    // Words at the end, a head with more fields, tabs, and no row of headers.
    let last = table("Gerät;X", 6, |i| format!("{}0,5;1{i},01;ok", 40 + i));
    assert_eq!(points(&last).1[1], (410.5, 11.01));
    let tabs = table("nm\tflag\tR", 6, |i| format!("{}0,5\tok\t0,{i}1", 40 + i));
    assert_eq!(points(&tabs).1[1], (410.5, 0.11));
    // A word may hold a semicolon where commas part fields.
    let quoted = table("nm,why,R", 6, |i| format!("{}0,\"good; dry\",0.{i}1", 40 + i));
    assert_eq!(points(&quoted).1[1], (410.0, 0.11));
}

#[test]
fn dates_say_nothing_of_separators_of_thousands() {
    let text = table("Datum;01.02.2026\nGerät;X\nnm;weiss;irradiance", 6, |i| {
        format!("{}0,0;0,{i}00;1.4{i}0,5", 40 + i)
    });
    let lamps = spectra(&text);
    assert_eq!((lamps.len(), lamps[1].values[1], lamps[0].values[1]), (2, 1410.5, 0.1));
    let dated = table("Datum;nm;irradiance", 6, |i| format!("0{}.02.2026;4{i}0;1.4{i}0,5", i + 1));
    assert_eq!(points(&dated).1[1], (410.0, 1410.5));
    // Where the numbers are not of one way, that is the matter.
    let both = table("nm;irradiance", 6, |i| format!("{}0.5;1.4{i}0,5", 40 + i));
    assert!(
        error_of(&both).contains("expected separators of thousands in one way throughout"),
        "{}",
        error_of(&both)
    );
    // Wavelengths with a point of decimals beside values with one of thousands.
    let mixed = error_of(&table("nm;irradiance", 6, |i| format!("{}0.500;1.4{i}0,5", 40 + i)));
    assert!(mixed.contains("found 400500") && mixed.contains("separator of thousands"), "{mixed}");
}

#[test]
fn words_beside_one_spectrum_do_not_cut_it() {
    let flags = |at: usize| ["ok", "ok", "ok", "low", "low", "low", "ok", "ok", "ok"][at];
    let whole = table("nm,reflectance,flag", 9, |i| format!("{}0,0.{i}1,{}", 40 + i, flags(i)));
    let found = spectra(&whole);
    assert_eq!((found.len(), found[0].nm.len(), found[0].name.as_str()), (1, 9, "reflectance"));
    let dates = table("time,nm,reflectance", 9, |i| format!("2026-01-0{},{}0,0.{i}1", 1 + i / 3, 40 + i));
    assert_eq!((spectra(&dates).len(), spectra(&dates)[0].nm.len()), (1, 9));
    let bare = table("", 9, |i| format!("{i},{}0,0.{i}1,{}", 40 + i, flags(i)));
    assert_eq!((spectra(&bare).len(), spectra(&bare)[0].nm.len()), (1, 9));
    // Samples, line by line in turn, and of different steps.
    let turns = table("nm,of,R", 12, |i| format!("{}0,{},0.{}1", 40 + i / 2, ["a", "b"][i % 2], i % 7));
    assert_eq!(spectra(&turns).iter().map(|one| one.nm.len()).collect::<Vec<_>>(), [6, 6]);
    let steps = table("of,nm,R", 24, |i| {
        if i < 21 {
            format!("fine,{},0.5", 400 + 10 * i)
        } else {
            format!("coarse,{},0.25", 400 + 100 * (i - 21))
        }
    });
    assert_eq!(spectra(&steps).iter().map(|one| one.nm.len()).collect::<Vec<_>>(), [21, 3]);
}

#[test]
fn many_samples_under_a_large_head_cost_little() {
    let mut text = "# a line of a long head that says nothing of note\n".repeat(20_000);
    text += "sample,nm,reflectance\n";
    for sample in 0..300 {
        for nm in [400, 500, 600] {
            writeln!(text, "s{sample},{nm},0.5").unwrap();
        }
    }
    let found = spectra(&text);
    assert_eq!((found.len(), found[299].name.as_str(), found[299].nm.len()), (300, "s299", 3));
    assert_eq!(found[299].quantity, Quantity::Reflectance);
    assert!(found[0].notes.iter().any(|note| note.contains("are not read")), "{:?}", found[0].notes);
    // No more lines than that are read for each.
    let wrong = text.replace("s299,600,0.5", "s299,450,0.5");
    assert!(error_of(&wrong).contains("found"));
}

#[test]
fn columns_of_no_numbers_are_named() {
    let (leaf, found) = points(&table("nm,reflectance,u", 6, |i| format!("{}0,0.{i}1,<0.001", 40 + i)));
    assert_eq!(found[1], (410.0, 0.11));
    assert_eq!(leaf.notes[0], "column 3 'u' left out: no value of it is a number, such as '<0.001'");
    let both = spectra(&table("nm,lamp A,lamp B", 6, |i| format!("{}0,<{},0.{i}1", 40 + i, i / 3)));
    assert_eq!((both.len(), both[0].name.as_str()), (1, "lamp B"));
    assert!(both[0].notes[0].contains("column 2 'lamp A' left out"), "{:?}", both[0].notes);
    // What the file is of is not to be had.
    let error = error_of(&table("nm,channel,irradiance", 6, |i| format!("{}0,{i},<5", 40 + i)));
    assert!(
        error.contains("expected numbers in column 3 'irradiance', found no value that is a number"),
        "{error}"
    );
}
