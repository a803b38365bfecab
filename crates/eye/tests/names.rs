//! Names of eyes.

use glanz_eye::{Eye, EyeError};
use proptest::prelude::*;

#[test]
fn names_of_the_documentation_are_read() {
    for name in [
        "age:70",
        "protan",
        "deutan:10",
        "tritan",
        "aphakic",
        "rods",
        "age:70+deutan:10",
        "cie170:age=50,field=10",
        "standard",
        "age:70+lens:cie203",
        "macula:0.5+iris:1.2",
        "shift:-2,1,0+density:1.1,0.9,1",
    ] {
        let eye: Eye = name.parse().unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(eye.to_string().parse::<Eye>().unwrap(), eye, "{name} as {eye}");
        assert!(Eye::is_named(name), "{name}");
    }
    let by_standard: Eye = "cie170:age=50,field=10".parse().unwrap();
    assert_eq!(by_standard, "age:50+field:10".parse().unwrap());
}

#[test]
fn wrong_names_say_what_would_be_right() {
    for (name, expected) in [
        ("age:700", "the age of an eye is 5 to 100 years, found 700"),
        ("age:old", "'age:old': expected the age in years, as age:70"),
        ("age:nan", "'age:nan': expected the age in years, as age:70"),
        ("deutan:30", "'deutan:30': expected the shift of the pigment, 0 to 20 nm, as deutan:10"),
        ("tritan:4", "'tritan:4': expected no number behind this word"),
        ("protan+deutan", "'protan+deutan' says the cones twice"),
        ("field:0.2", "the field of an eye is 1 to 10 degrees, found 0.2"),
    ] {
        assert_eq!(name.parse::<Eye>().unwrap_err().to_string(), expected);
    }
    let error = "age:70+dutan".parse::<Eye>().unwrap_err();
    assert!(matches!(error, EyeError::Unknown { .. }) && error.to_string().contains("deutan:10"), "{error}");
}

proptest! {
    #[test]
    fn every_eye_is_read_back_from_its_name(
        age in 5.0..100.0_f64, field_deg in 1.0..10.0_f64, shift in 0.0..20.0_f64, kind in 0..4_usize, lens in 0.5..2.0_f64,
    ) {
        let mut eye = Eye { age, field_deg, lens_density: lens, ..Eye::default() };
        match kind {
            0 => eye.shift_nm[0] = -shift,
            1 => eye.shift_nm[1] = shift,
            2 => eye.shift_nm = [shift, -shift, shift],
            _ => {}
        }
        prop_assert_eq!(eye.to_string().parse::<Eye>().unwrap(), eye);
    }

    #[test]
    fn any_text_is_an_eye_or_an_error(text in ".{0,40}") {
        if let Ok(eye) = text.parse::<Eye>() {
            prop_assert!(eye.check().is_ok());
        }
    }
}
