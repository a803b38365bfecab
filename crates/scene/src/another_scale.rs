//! Colours on the scale of 0 to 255, where 1 is white.

use glanz_color::Rgb;
use thiserror::Error;

/// Beyond this nothing that is no light is meant where 1 is white.
const MOST: f32 = 10.0;

/// A colour of whole numbers up to 255, where 1 is white.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("{} is on another scale: 1 is white", list(codes.map(|code| code.to_string())))]
pub struct AnotherScale {
    /// The numbers that were found.
    pub codes: [u8; 3],
}

impl AnotherScale {
    /// That the colour of a surface or background is on the scale where 1 is white.
    ///
    /// ```
    /// use glanz_color::Rgb;
    /// use glanz_scene::AnotherScale;
    ///
    /// let error = AnotherScale::check(Rgb([51.0, 76.0, 230.0])).unwrap_err();
    /// assert_eq!(error.to_string(), "[51, 76, 230] is on another scale: 1 is white");
    /// assert_eq!(error.help(), "divided by 255 it is [0.2, 0.298, 0.902]; as sRGB codes it is \"#334ce6\"");
    /// assert!(AnotherScale::check(Rgb([1.0, 0.5, 5.0])).is_ok());
    /// ```
    ///
    /// # Errors
    /// If the numbers are whole, and one of them is above 10 and none above 255.
    pub fn check(color: Rgb) -> Result<(), Self> {
        let is_code = |c: &f32| c.fract() == 0.0 && (0.0..=255.0).contains(c);
        match color.0.iter().all(is_code) && color.0.iter().any(|c| *c > MOST) {
            true => Err(Self { codes: color.0.map(|c| c as u8) }),
            false => Ok(()),
        }
    }

    /// What to write in their place.
    pub fn help(&self) -> String {
        let [r, g, b] = self.codes;
        let amounts = list(self.codes.map(|code| format!("{}", (f64::from(code) / 0.255).round() / 1000.0)));
        format!("divided by 255 it is {amounts}; as sRGB codes it is \"#{r:02x}{g:02x}{b:02x}\"")
    }
}

fn list(numbers: [String; 3]) -> String {
    format!("[{}]", numbers.join(", "))
}
