//! How an eye looks: at which light level, adapted to what, where to, and from how far.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::eye::Eye;

/// Light levels by name: the luminance of a white surface in cd/m².
pub const LEVELS: [(&str, f64); 6] =
    [("sun", 1e4), ("day", 1e3), ("room", 100.0), ("dusk", 1.0), ("moon", 0.01), ("stars", 1e-4)];

/// The luminance of white from which on rods add nothing: CIE 191 ends at 5 cd/m², and what is seen is darker than white.
pub const ROD_LIMIT_CD_M2: f64 = 30.0;

/// Pixels per degree where the camera says nothing: a screen of 96 dots per inch at 60 cm.
pub const SCREEN_PX_PER_DEG: f64 = 40.0;

/// The colour in which light is shown that rods alone see.
///
/// ```
/// use glanz_eye::{RodColor, Viewing};
///
/// let film = Viewing { level_cd_m2: Some(0.01), rods: RodColor::Blue, ..Viewing::default() };
/// assert_eq!(Viewing::default().rods, RodColor::White);
/// # let _ = film;
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum RodColor {
    /// That of white: night has no colours.
    #[default]
    White,
    /// Bluish, x = y = 0.25, as painters and films have the night (H. W. Jensen et al., "Night Rendering", 2000).
    Blue,
}

/// Which stages an eye's picture goes through, and with which numbers. The default is a bright day, seen sharply.
///
/// ```
/// use glanz_eye::{Eye, Viewer, Viewing};
///
/// let dusk = Viewing { level_cd_m2: Some(1.0), glare: true, ..Viewing::default() };
/// let viewer = Viewer { eye: Eye::default(), viewing: dusk };
/// assert!(viewer.needs_rods() && viewer.has_stages());
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Viewing {
    /// The luminance of white in cd/m², where the scene has classic units; scenes in photometric units have their own. None: by day,
    /// without rods.
    pub level_cd_m2: Option<f64>,
    /// How far the cones are adapted to the white as the eye sees it: 0 shows the yellow of an old lens, 1 shows white as white.
    pub adapted: f64,
    /// The luminance in cd/m² that rods and pupil are adapted to; none: the mean of the picture.
    pub adaptation_cd_m2: Option<f64>,
    /// The colour of what rods see.
    pub rods: RodColor,
    /// Whether light is scattered in the eye.
    pub glare: bool,
    /// Whether light of the ends of the spectrum is out of focus, through the pupil that the eye has at this light.
    pub chromatic: bool,
    /// Which noise the photons have that are caught in a tenth of a second; none: their mean.
    pub noise: Option<u32>,
    /// Whether details are lost that the eye does not resolve at this light.
    pub acuity: bool,
    /// The pixel that is looked at, from the top left; details are lost around it.
    pub gaze: Option<[f64; 2]>,
    /// Pixels per degree of sight; none: from the camera if it is perspective, else 40.
    pub px_per_deg: Option<f64>,
    /// Whether the rods are drawn even where nothing says that it is dark: for scenes in photometric units, which know their
    /// luminance.
    pub night: bool,
}

impl Default for Viewing {
    fn default() -> Self {
        Self {
            level_cd_m2: None,
            adapted: 1.0,
            adaptation_cd_m2: None,
            rods: RodColor::White,
            glare: false,
            chromatic: false,
            noise: None,
            acuity: false,
            gaze: None,
            px_per_deg: None,
            night: false,
        }
    }
}

/// The luminance of white of a level: a name of [`LEVELS`], or a number in cd/m².
///
/// ```
/// use glanz_eye::level_cd_m2;
///
/// assert_eq!(level_cd_m2("moon"), Ok(0.01));
/// assert_eq!(level_cd_m2("250"), Ok(250.0));
/// assert!(level_cd_m2("-1").is_err());
/// ```
///
/// # Errors
/// In words, what would be right.
pub fn level_cd_m2(text: &str) -> Result<f64, String> {
    let text = text.trim();
    if let Some((_, level)) = LEVELS.iter().find(|(name, _)| name.eq_ignore_ascii_case(text)) {
        return Ok(*level);
    }
    let number = text.parse::<f64>().ok().filter(|level| (1e-7..=1e7).contains(level));
    number.ok_or_else(|| {
        let names: Vec<&str> = LEVELS.iter().map(|(name, _)| *name).collect();
        format!(
            "expected {} or the luminance of white in cd/m², 1e-7 to 1e7, found '{text}'",
            names.join(", ")
        )
    })
}

/// An eye, and how it looks.
///
/// ```
/// use glanz_eye::{Eye, Viewer};
///
/// let mut viewer: Viewer = "age:70".parse::<Eye>()?.into();
/// assert!(!viewer.has_stages(), "age is in the sensitivities, and takes no further work");
/// viewer.viewing.adapted = 2.0;
/// assert_eq!(viewer.check(), Err("adapted is 0 to 1, found 2".to_owned()));
/// # Ok::<(), glanz_eye::EyeError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Viewer {
    /// The eye.
    pub eye: Eye,
    /// How it looks.
    pub viewing: Viewing,
}

impl From<Eye> for Viewer {
    fn from(eye: Eye) -> Self {
        Self { eye, viewing: Viewing::default() }
    }
}

impl Viewer {
    /// Whether rods are needed for its picture.
    pub fn needs_rods(&self) -> bool {
        let Viewing { level_cd_m2, adaptation_cd_m2, night, .. } = self.viewing;
        let dark = |level: Option<f64>| level.is_some_and(|level| level < ROD_LIMIT_CD_M2);
        self.eye.cones == crate::Cones::None || night || dark(level_cd_m2) || dark(adaptation_cd_m2)
    }

    /// Whether its picture takes more than its channels: whether frames must go through [`see`](crate::Seeing::see).
    pub fn has_stages(&self) -> bool {
        let Viewing { glare, chromatic, noise, acuity, gaze, .. } = self.viewing;
        let deficient = crate::stages::deficiency::Defect::of(&self.eye).is_some();
        deficient || self.needs_rods() || glare || chromatic || noise.is_some() || acuity || gaze.is_some()
    }

    /// The observer by which its pictures are drawn: with rods where they are needed.
    pub fn observer(&self) -> glanz_color::Observer {
        match self.needs_rods() {
            true => self.eye.observer_with_rods(),
            false => self.eye.observer(),
        }
    }

    /// Checks the ranges of all numbers.
    ///
    /// # Errors
    /// In words, which number is wrong and what would be right.
    pub fn check(&self) -> Result<(), String> {
        self.eye.check().map_err(|error| error.to_string())?;
        let Viewing { level_cd_m2, adapted, adaptation_cd_m2, gaze, px_per_deg, .. } = self.viewing;
        let one = |name: &str, value: Option<f64>, least: f64, most: f64, unit: &str| match value {
            Some(value) if !(least..=most).contains(&value) => {
                Err(format!("{name} is {least:e} to {most:e} {unit}, found {value}"))
            }
            _ => Ok(()),
        };
        one("level", level_cd_m2, 1e-7, 1e7, "cd/m²")?;
        one("adaptation", adaptation_cd_m2, 1e-7, 1e7, "cd/m²")?;
        one("px_per_deg", px_per_deg, 0.1, 1e4, "pixels")?;
        one("gaze", gaze.map(|[x, y]| if x.abs() > y.abs() { x } else { y }), -1e6, 1e6, "pixels")?;
        match (0.0..=1.0).contains(&adapted) {
            true => Ok(()),
            false => Err(format!("adapted is 0 to 1, found {adapted}")),
        }
    }
}
