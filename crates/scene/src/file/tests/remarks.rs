//! What is hardly meant: a remark, or an error that says what to write.

use super::parse;

const BALL: &str =
    "[materials.ball]\nambient = 0.5\ndiffuse = 0.5\n[[objects]]\nmesh = 'sphere'\nmaterial = 'ball'\n";
const LAMP: &str = "[[lights]]\nkind = 'directional'\ndirection = [0, 0, -1]\n";

fn notes(text: &str) -> Vec<String> {
    parse(text).unwrap_or_else(|error| panic!("{error}\n{text}")).notes
}

#[test]
fn an_ambient_term_without_light_names_the_lamps_and_the_old_picture() {
    let [note] = &notes(&format!("{BALL}{LAMP}"))[..] else { panic!("one remark") };
    assert!(note.starts_with("no light reaches the ambient term of 'ball'"), "{note}");
    assert!(note.ends_with("lights.0 'ambient' with the value of 'color'"), "{note}");
    let [note] = &notes(&format!("{BALL}{LAMP}{LAMP}name = 'key'\n"))[..] else { panic!("one remark") };
    assert!(note.contains("lights.0, light 'key' 'ambient'"), "{note}");
}

#[test]
fn ambient_terms_of_the_library_count_and_many_are_counted() {
    let [note] = &notes(&format!("{LAMP}[[objects]]\nmesh = 'sphere'\nmaterial = 'gl-emerald'\n"))[..] else {
        panic!("one remark")
    };
    assert!(note.starts_with("no light reaches the ambient term of 'gl-emerald'"), "{note}");
    let balls: Vec<String> = (1..=5).map(|number| BALL.replace("ball", &format!("ball{number}"))).collect();
    let [note] = &notes(&format!("{}{LAMP}", balls.concat()))[..] else { panic!("one remark") };
    let many = "no light reaches the ambient terms of 'ball1', 'ball2', 'ball3' and 2 more materials: ";
    assert!(note.starts_with(many), "{note}");
}

#[test]
fn there_is_no_remark_where_the_ambient_term_is_thought_of() {
    let quiet = [
        format!("{BALL}{LAMP}ambient = 0.0\n"),
        format!("{BALL}{LAMP}[ambient]\ncolor = 0.2\n"),
        format!("{BALL}{LAMP}[[lights]]\nkind = 'environment'\n"),
        format!("{LAMP}[[objects]]\nmesh = 'sphere'\n"),
        format!("{LAMP}[[objects]]\nmesh = 'sphere'\nmaterial = 'gold'\n"),
        format!("{LAMP}[materials.unused]\nambient = 0.5\n"),
        format!("{}{LAMP}", BALL.replace("ambient = 0.5", "ambient = 0")),
    ];
    for text in quiet {
        assert_eq!(notes(&text), Vec::<String>::new(), "{text}");
    }
}

#[test]
fn colours_of_0_to_255_are_refused_with_what_to_write() {
    let texts = [
        ("[materials.a]\ndiffuse = [51, 76, 230]", "[51, 76, 230]"),
        ("[materials.a]\nlobes = [{ shape = 'lambert', tint = [51, 76, 230] }]", "[51, 76, 230]"),
        ("[image]\nbackground = [51.0, 76.0, 230.0]", "[51.0, 76.0, 230.0]"),
    ];
    for (text, place) in texts {
        let error = parse(text).expect_err(text);
        assert_eq!(error.message, "[51, 76, 230] is on another scale: 1 is white");
        assert_eq!(&error.text[error.span.expect("it has a place")], place);
        let help = "divided by 255 it is [0.2, 0.298, 0.902]; as sRGB codes it is \"#334ce6\"";
        assert_eq!(error.help.as_deref(), Some(help));
    }
    let quad = "[[objects]]\nmesh = 'quad'\ncolors = [[255, 0, 0], [0, 255, 0], [0, 0, 255], [9, 9, 9]]";
    assert!(parse(quad).is_err());
    assert!(parse(&format!("{LAMP}color = [51, 76, 230]")).is_ok(), "a lamp may be as strong as it likes");
    assert!(parse("[materials.a]\nemission = [51, 76, 230]").is_ok());
}

#[test]
fn a_reflectance_above_1_is_remarked() {
    let expected =
        "material 'a': the colour of its term 'lambert' is up to 1.5, where 1 gives back all light";
    assert_eq!(notes("[materials.a]\ndiffuse = [0.5, 1.5, 1]"), [expected]);
    assert_eq!(notes("[materials.a]\ndiffuse = 1\nspecular = 1\nemission = 7"), Vec::<String>::new());
}
