//! An eye: its age, its field, its pigments, and what it sees by as an observer.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The ages for which CIE 170-1 and CIE 203 hold.
pub const KNOWN_AGES: std::ops::RangeInclusive<f64> = 20.0..=80.0;

/// The ages that are taken; outside of [`KNOWN_AGES`] the formulas are carried on.
pub const AGES: std::ops::RangeInclusive<f64> = 5.0..=100.0;

/// The fields in degrees for which CIE 170-1 holds.
pub const FIELDS_DEG: std::ops::RangeInclusive<f64> = 1.0..=10.0;

/// The shifts of a pigment in nm that are taken: beyond, it is nearer to the other pigment than to its own.
pub const MAX_SHIFT_NM: f64 = 20.0;

/// By which formula the lens yellows.
///
/// ```
/// use glanz_eye::{Eye, Lens};
///
/// let old = |lens| Eye { age: 70.0, lens, ..Eye::default() }.lens_transmittance().at(450.0);
/// assert!(old(Lens::Cie203) < old(Lens::Cie170) && old(Lens::None) == 1.0);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Lens {
    /// CIE 170-1:2006, as in the standard observers.
    #[default]
    Cie170,
    /// CIE 170-1 at 32 years, and its change from there by CIE 203:2012.
    Cie203,
    /// None: an eye whose lens was removed. It sees from 360 nm on.
    None,
}

/// Which cones there are.
///
/// ```
/// use glanz_eye::{Cones, Eye};
///
/// assert_eq!("deutan".parse::<Eye>()?.cones, Cones::NoM);
/// assert_eq!(Cones::NoM.missing(), Some(1));
/// # Ok::<(), glanz_eye::EyeError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Cones {
    /// L, M and S.
    #[default]
    All,
    /// Without L: a protanope.
    NoL,
    /// Without M: a deuteranope.
    NoM,
    /// Without S: a tritanope.
    NoS,
    /// None: sight by rods alone.
    None,
}

impl Cones {
    /// The number of the channel that is missing, if one is.
    pub fn missing(self) -> Option<usize> {
        match self {
            Self::NoL => Some(0),
            Self::NoM => Some(1),
            Self::NoS => Some(2),
            Self::All | Self::None => None,
        }
    }
}

/// An eye. The default is that of the standard observer of 2°: 32 years old, with all cones.
///
/// ```
/// use glanz_eye::Eye;
///
/// let old: Eye = "age:70+deutan:10".parse()?;
/// assert_eq!(old.age, 70.0);
/// assert_eq!(old.shift_nm, [0.0, 10.0, 0.0]);
/// assert_eq!(old.to_string(), "age:70+deutan:10");
/// // Less of short waves comes through an old lens.
/// let s = |eye: &Eye| eye.observer().channels[2].sensitivity;
/// assert!(s(&old).at(450.0) < 0.5 * s(&Eye::default()).at(450.0));
/// # Ok::<(), glanz_eye::EyeError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Eye {
    /// Years, 5 to 100; CIE 170-1 holds for 20 to 80.
    #[schemars(range(min = 5.0, max = 100.0))]
    pub age: f64,
    /// The field in degrees, 1 to 10: pigments are denser at its middle.
    #[schemars(range(min = 1.0, max = 10.0))]
    pub field_deg: f64,
    /// By which formula the lens yellows.
    pub lens: Lens,
    /// The density of the lens over that of its age, in parts; 1 is the mean of people.
    #[schemars(range(min = 0.0, max = 3.0))]
    pub lens_density: f64,
    /// The density of the macular pigment over that of its field, in parts.
    #[schemars(range(min = 0.0, max = 3.0))]
    pub macula_density: f64,
    /// The densities of the pigments of L, M, S over those of the field, in parts.
    pub pigment_density: [f64; 3],
    /// How far the peaks of the pigments of L, M, S are moved, in nm.
    pub shift_nm: [f64; 3],
    /// Which cones there are.
    pub cones: Cones,
    /// The pigment of the iris, by which light is scattered in the eye: 0 black, 0.5 brown, 1 blue-green, 1.2 light blue.
    #[schemars(range(min = 0.0, max = 1.2))]
    pub iris: f64,
}

impl Default for Eye {
    fn default() -> Self {
        Self {
            age: 32.0,
            field_deg: 2.0,
            lens: Lens::Cie170,
            lens_density: 1.0,
            macula_density: 1.0,
            pigment_density: [1.0; 3],
            shift_nm: [0.0; 3],
            cones: Cones::All,
            iris: 0.5,
        }
    }
}

impl Eye {
    /// The standard observer's eye with the same field, by which the channels of this one are scaled and shown.
    #[must_use]
    pub fn standard(&self) -> Self {
        Self { field_deg: self.field_deg, ..Self::default() }
    }

    /// The same eye with all cones where they usually are: whose sight a deficiency is compared with.
    #[must_use]
    pub fn with_usual_cones(&self) -> Self {
        Self { cones: Cones::All, shift_nm: [0.0; 3], ..self.clone() }
    }

    /// Checks the ranges of all numbers.
    ///
    /// # Errors
    /// [`EyeError::Range`] names the field, the value and the range.
    pub fn check(&self) -> Result<(), EyeError> {
        let one = |name: &'static str, value: f64, least: f64, most: f64, unit: &'static str| match (least
            ..=most)
            .contains(&value)
        {
            true => Ok(()),
            false => Err(EyeError::Range { name, value, least, most, unit }),
        };
        one("age", self.age, *AGES.start(), *AGES.end(), " years")?;
        one("field", self.field_deg, *FIELDS_DEG.start(), *FIELDS_DEG.end(), " degrees")?;
        one("lens density", self.lens_density, 0.0, 3.0, "")?;
        one("macular density", self.macula_density, 0.0, 3.0, "")?;
        for density in self.pigment_density {
            one("pigment density", density, 0.0, 3.0, "")?;
        }
        for shift in self.shift_nm {
            one("shift", shift, -MAX_SHIFT_NM, MAX_SHIFT_NM, " nm")?;
        }
        one("iris", self.iris, 0.0, 1.2, "")
    }

    /// What is odd about it, in words: an age for which the formulas are only carried on.
    pub fn remark(&self) -> Option<String> {
        (!KNOWN_AGES.contains(&self.age)).then(|| {
            format!(
                "an eye of {} years: the lens is known from {} to {} years (CIE 170-1, CIE 203), beyond them the formula is \
                 carried on",
                self.age,
                KNOWN_AGES.start(),
                KNOWN_AGES.end()
            )
        })
    }
}

/// Why there is no such eye.
///
/// ```
/// use glanz_eye::Eye;
///
/// let error = "age:170".parse::<Eye>().unwrap_err();
/// assert_eq!(error.to_string(), "the age of an eye is 5 to 100 years, found 170");
/// ```
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum EyeError {
    /// A number is out of its range.
    #[error("the {name} of an eye is {least} to {most}{unit}, found {value}")]
    Range {
        /// What it is the number of.
        name: &'static str,
        /// The number.
        value: f64,
        /// The least that is taken.
        least: f64,
        /// The most that is taken.
        most: f64,
        /// The unit, behind a space; empty for parts.
        unit: &'static str,
    },
    /// A part of a name of an eye is not known.
    #[error("'{part}' is no part of an eye{}; expected {EXPECTED}", near(.suggestion))]
    Unknown {
        /// What was found.
        part: String,
        /// What may have been meant.
        suggestion: Option<&'static str>,
    },
    /// A part needs a number, or takes none.
    #[error("'{part}': expected {expected}")]
    Part {
        /// What was found.
        part: String,
        /// What would be right.
        expected: &'static str,
    },
    /// Two parts contradict each other.
    #[error("'{text}' says {what} twice")]
    Twice {
        /// The whole.
        text: String,
        /// What.
        what: &'static str,
    },
}

/// The parts of a name of an eye.
const EXPECTED: &str = "age:70, field:10, protan, deutan:10 (nm of shift), tritan, aphakic, rods, lens:cie203, iris:1.2, \
                        cie170:age=50,field=10, joined by +";

fn near(suggestion: &Option<&'static str>) -> String {
    suggestion.map_or_else(String::new, |word| format!(", did you mean '{word}'?"))
}
