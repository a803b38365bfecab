//! Eyes by name: `age:70+deutan:10`.

use std::fmt;
use std::str::FromStr;

use crate::eye::{Cones, Eye, EyeError, Lens};

/// The words that parts begin with.
const WORDS: [&str; 14] = [
    "age", "field", "protan", "deutan", "tritan", "aphakic", "rods", "lens", "macula", "iris", "standard",
    "shift", "density", "cie170",
];

impl Eye {
    /// Whether a name is meant to be that of an eye rather than of another observer: its first part begins with the word of an
    /// eye.
    ///
    /// ```
    /// use glanz_eye::Eye;
    ///
    /// assert!(Eye::is_named("age:70") && Eye::is_named("deutan") && Eye::is_named("cie170:age=5o"));
    /// assert!(!Eye::is_named("cie1931") && !Eye::is_named("lms2"));
    /// ```
    pub fn is_named(text: &str) -> bool {
        let first = text.split(['+', ':', '=']).next().unwrap_or_default().trim().to_lowercase();
        WORDS.contains(&first.as_str()) || first == "cie203"
    }
}

impl FromStr for Eye {
    type Err = EyeError;

    fn from_str(text: &str) -> Result<Self, EyeError> {
        let mut eye = Self::default();
        let mut said = Said { text, what: Vec::new() };
        for part in text.split('+') {
            let part = part.trim();
            let (word, rest) = match part.split_once(':') {
                Some((word, rest)) => (word.trim().to_lowercase(), Some(rest.trim())),
                None => (part.to_lowercase(), None),
            };
            match (word.as_str(), rest) {
                ("cie170" | "cie203", rest) => {
                    if word == "cie203" {
                        said.once("the lens")?;
                        eye.lens = Lens::Cie203;
                    }
                    for pair in rest.unwrap_or_default().split(',').filter(|pair| !pair.trim().is_empty()) {
                        let (key, value) = pair.split_once('=').ok_or_else(|| wrong(pair, "key=value"))?;
                        eye.set(&key.trim().to_lowercase(), Some(value.trim()), pair.trim(), &mut said)?;
                    }
                }
                (word, rest) => eye.set(word, rest, part, &mut said)?,
            }
        }
        eye.check()?;
        Ok(eye)
    }
}

/// What a name has said already.
struct Said<'a> {
    text: &'a str,
    what: Vec<&'static str>,
}

impl Said<'_> {
    fn once(&mut self, what: &'static str) -> Result<(), EyeError> {
        if self.what.contains(&what) {
            return Err(EyeError::Twice { text: self.text.to_owned(), what });
        }
        self.what.push(what);
        Ok(())
    }
}

impl Eye {
    /// Takes over one part of a name.
    fn set(&mut self, word: &str, rest: Option<&str>, part: &str, said: &mut Said) -> Result<(), EyeError> {
        match word {
            "age" => {
                said.once("the age")?;
                self.age = number(rest, part, "the age in years, as age:70")?;
            }
            "field" => {
                said.once("the field")?;
                self.field_deg = number(rest, part, "the field in degrees, as field:10")?;
            }
            "macula" => {
                said.once("the macula")?;
                self.macula_density = number(rest, part, "the density in parts of the usual, as macula:0.5")?;
            }
            "iris" => {
                said.once("the iris")?;
                self.iris = number(rest, part, "0 (black) to 1.2 (light blue), as iris:0.5")?;
            }
            "lens" => self.set_lens(rest, part, said)?,
            "shift" => {
                said.once("the cones")?;
                self.shift_nm = three(rest, part, "the shifts of L, M, S in nm, as shift:-2,1,0")?;
            }
            "density" => {
                said.once("the pigments")?;
                let expected = "the densities of L, M, S in parts of the usual, as density:1.1,0.9,1";
                self.pigment_density = three(rest, part, expected)?;
            }
            "aphakic" | "standard" | "rods" | "tritan" if rest.is_some() => {
                return Err(wrong(part, "no number behind this word"));
            }
            "standard" => {}
            "aphakic" => {
                said.once("the lens")?;
                self.lens = Lens::None;
            }
            "protan" | "deutan" | "tritan" | "rods" => {
                said.once("the cones")?;
                self.set_cones(word, rest, part)?;
            }
            _ => return Err(unknown(part, word)),
        }
        Ok(())
    }

    fn set_lens(&mut self, rest: Option<&str>, part: &str, said: &mut Said) -> Result<(), EyeError> {
        let lens = match rest {
            Some("cie170") => Lens::Cie170,
            Some("cie203") => Lens::Cie203,
            Some("none") => Lens::None,
            _ => {
                said.once("the density of the lens")?;
                self.lens_density =
                    number(rest, part, "lens:cie170, lens:cie203, lens:none, or a density in parts")?;
                return Ok(());
            }
        };
        said.once("the lens")?;
        self.lens = lens;
        Ok(())
    }

    /// A deficiency: without a number a kind of cones is missing, with one its pigment is moved towards the other's.
    fn set_cones(&mut self, word: &str, rest: Option<&str>, part: &str) -> Result<(), EyeError> {
        let shift = match rest {
            Some(_) => Some(number(rest, part, "the shift of the pigment, 0 to 20 nm, as deutan:10")?),
            None => None,
        };
        if let Some(shift) = shift
            && !(0.0..=crate::eye::MAX_SHIFT_NM).contains(&shift)
        {
            return Err(wrong(part, "the shift of the pigment, 0 to 20 nm, as deutan:10"));
        }
        match (word, shift) {
            ("protan", Some(shift)) => self.shift_nm[0] = -shift,
            ("deutan", Some(shift)) => self.shift_nm[1] = shift,
            ("protan", None) => self.cones = Cones::NoL,
            ("deutan", None) => self.cones = Cones::NoM,
            ("tritan", _) => self.cones = Cones::NoS,
            _ => self.cones = Cones::None,
        }
        Ok(())
    }
}

fn wrong(part: &str, expected: &'static str) -> EyeError {
    EyeError::Part { part: part.to_owned(), expected }
}

fn unknown(part: &str, word: &str) -> EyeError {
    let close = |known: &&&str| {
        known.len() > 2 && word.len() > 2 && known[..3] == word[..word.floor_char_boundary(3)]
    };
    EyeError::Unknown { part: part.to_owned(), suggestion: WORDS.iter().find(close).copied() }
}

fn number(rest: Option<&str>, part: &str, expected: &'static str) -> Result<f64, EyeError> {
    let value = rest.and_then(|text| text.parse::<f64>().ok()).filter(|value| value.is_finite());
    value.ok_or_else(|| wrong(part, expected))
}

fn three(rest: Option<&str>, part: &str, expected: &'static str) -> Result<[f64; 3], EyeError> {
    let values: Vec<f64> =
        rest.unwrap_or_default().split(',').filter_map(|v| v.trim().parse().ok()).collect();
    let values = <[f64; 3]>::try_from(values).map_err(|_| wrong(part, expected))?;
    if values.iter().all(|v| v.is_finite()) { Ok(values) } else { Err(wrong(part, expected)) }
}

impl fmt::Display for Eye {
    /// The shortest name that is read back as the same eye; `standard` for the default.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let usual = Self::default();
        let mut parts = Vec::new();
        let mut add = |differs: bool, part: String| {
            if differs {
                parts.push(part);
            }
        };
        add(self.age != usual.age, format!("age:{}", self.age));
        add(self.field_deg != usual.field_deg, format!("field:{}", self.field_deg));
        match self.lens {
            Lens::Cie170 => {}
            Lens::Cie203 => add(true, "lens:cie203".to_owned()),
            Lens::None => add(true, "aphakic".to_owned()),
        }
        add(self.lens_density != 1.0, format!("lens:{}", self.lens_density));
        add(self.macula_density != 1.0, format!("macula:{}", self.macula_density));
        let listed = |v: [f64; 3]| format!("{},{},{}", v[0], v[1], v[2]);
        add(self.pigment_density != [1.0; 3], format!("density:{}", listed(self.pigment_density)));
        add(self.iris != usual.iris, format!("iris:{}", self.iris));
        let cones = match (self.cones, self.shift_nm) {
            (Cones::NoL, _) => "protan".to_owned(),
            (Cones::NoM, _) => "deutan".to_owned(),
            (Cones::NoS, _) => "tritan".to_owned(),
            (Cones::None, _) => "rods".to_owned(),
            (Cones::All, [0.0, 0.0, 0.0]) => String::new(),
            (Cones::All, [l, 0.0, 0.0]) if l < 0.0 => format!("protan:{}", -l),
            (Cones::All, [0.0, m, 0.0]) if m > 0.0 => format!("deutan:{m}"),
            (Cones::All, shift) => format!("shift:{}", listed(shift)),
        };
        add(!cones.is_empty(), cones);
        match parts.is_empty() {
            true => f.write_str("standard"),
            false => f.write_str(&parts.join("+")),
        }
    }
}
