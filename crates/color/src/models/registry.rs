//! The list of all colour models, and conversion by name.

use glanz_math::names::{nearest, suggestion};

use super::info::{Channel, ColorModel, Limit, ModelInfo};
use super::{
    Ac1c2, AcesCg, AdobeRgb, Cmy, Cmyk, DisplayP3, Hls, Hsv, Lab, Lch, LinearSrgb, Lms, Luv, Oklab, Oklch,
    Opponent, Rec2020, Srgb, XyY, Xyz,
};

/// The one list: from it come the enum, the names and the conversions.
macro_rules! models {
    ($($(#[$doc:meta])* $Name:ident,)*) => {
        /// A colour model, chosen while the program runs.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Model {
            $(#[doc = concat!("[`", stringify!($Name), "`](super::", stringify!($Name), ")")] $Name,)*
        }

        impl Model {
            /// All of them.
            pub const ALL: &[Self] = &[$(Self::$Name),*];

            /// What it is called and what its numbers are.
            pub const fn info(self) -> &'static ModelInfo {
                match self { $(Self::$Name => const { &<$Name as ColorModel>::INFO },)* }
            }

            /// The colour of these numbers in XYZ; numbers beyond the model's channels are not read.
            pub fn to_xyz(self, values: [f64; 4]) -> Xyz {
                match self { $(Self::$Name => $Name(first(values)).to_xyz(),)* }
            }

            /// The numbers of a colour; those beyond the model's channels are 0.
            pub fn from_xyz(self, xyz: Xyz) -> [f64; 4] {
                match self { $(Self::$Name => padded($Name::from_xyz(xyz).0),)* }
            }
        }
    };
}

models! {
    Srgb, LinearSrgb, DisplayP3, Rec2020, AdobeRgb, AcesCg, Cmy, Cmyk, Hls, Hsv, Xyz, XyY, Lab, Lch, Luv,
    Oklab, Oklch, Lms, Opponent, Ac1c2,
}

fn first<const N: usize>(values: [f64; 4]) -> [f64; N] {
    core::array::from_fn(|i| values[i])
}

fn padded<const N: usize>(values: [f64; N]) -> [f64; 4] {
    core::array::from_fn(|i| values.get(i).copied().unwrap_or(0.0))
}

/// Why a colour was not converted.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ConvertError {
    /// No model has this name.
    #[error("unknown colour model '{name}'; known are {}{}", names(), suggestion(near))]
    UnknownModel {
        /// The name that was asked for.
        name: String,
        /// The known names that it is most likely a misspelling of.
        near: Vec<&'static str>,
    },
    /// Too few or too many numbers.
    #[error("colour model `{model}` has {} channels ({}), found {found} numbers", .model.info().channels.len(), .model.channel_names())]
    WrongCount {
        /// The model.
        model: Model,
        /// How many numbers there were.
        found: usize,
    },
    /// A number that means nothing in the model.
    #[error("channel {} of `{model}` goes from {} to {}, found {value}", .channel.name, .channel.range[0], .channel.range[1])]
    OutOfDomain {
        /// The model.
        model: Model,
        /// Its channel.
        channel: Channel,
        /// The number.
        value: f64,
    },
    /// The numbers are no colour, or the model cannot name it.
    #[error("{values:?} in `{from}` is no colour in `{to}`: expected finite numbers, found {found:?}")]
    NotFinite {
        /// The model of the numbers.
        from: Model,
        /// The model asked for.
        to: Model,
        /// The numbers.
        values: Vec<f64>,
        /// What came of them.
        found: Vec<f64>,
    },
    /// The model holds colours of the sRGB cube only.
    #[error(
        "`{to}` holds colours of the sRGB cube 0 to 1 only, found sRGB {}; `srgb` or `cmy` can hold this one",
        rounded(srgb)
    )]
    OutOfGamut {
        /// The model asked for.
        to: Model,
        /// The colour in sRGB, unclipped.
        srgb: [f64; 3],
    },
}

/// Numbers as people read them; rounding of what is 0 is not among them.
fn rounded(numbers: &[f64; 3]) -> String {
    let texts = numbers.map(|number| format!("{:.4}", (number * 1e4).round() / 1e4 + 0.0));
    texts.join(", ")
}

fn names() -> String {
    let names: Vec<_> = Model::ALL.iter().map(|model| model.info().name).collect();
    names.join(", ")
}

impl core::fmt::Display for Model {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(self.info().name)
    }
}

/// How far outside of the cube a code value may lie and still be taken for its border: rounding of
/// printed numbers, far below one step of 16 bits.
const CUBE_TOLERANCE: f64 = 1e-6;

impl Model {
    /// The model of that name, in any case of letters.
    ///
    /// # Errors
    ///
    /// [`ConvertError::UnknownModel`], with a suggestion.
    pub fn from_name(name: &str) -> Result<Self, ConvertError> {
        let lower = name.to_ascii_lowercase();
        if let Some(model) = Self::ALL.iter().find(|model| model.info().name == lower) {
            return Ok(*model);
        }
        let near = nearest(name, Self::ALL.iter().map(|model| model.info().name));
        Err(ConvertError::UnknownModel { name: name.to_owned(), near })
    }

    /// The names of its channels, as in `H, L, S`.
    pub fn channel_names(self) -> String {
        let names: Vec<_> = self.info().channels.iter().map(|channel| channel.name).collect();
        names.join(", ")
    }

    /// The numbers as a colour, after a look at their count and domain.
    fn read(self, values: &[f64]) -> Result<[f64; 4], ConvertError> {
        let channels = self.info().channels;
        if values.len() != channels.len() {
            return Err(ConvertError::WrongCount { model: self, found: values.len() });
        }
        let mut numbers = [0.0; 4];
        for ((number, &value), &channel) in numbers.iter_mut().zip(values).zip(channels) {
            if !channel.accepts(value) {
                return Err(ConvertError::OutOfDomain { model: self, channel, value });
            }
            *number = if channel.limit == Limit::Cyclic { libm::fmod(value, 360.0) } else { value };
        }
        Ok(numbers)
    }
}

/// The numbers of a colour in another model, both by name.
///
/// White is D65 in all of them. Where a model can hold the sRGB cube only (`hls`, `hsv`, `cmyk`), a colour
/// outside of it is an error and not silently another colour.
///
/// # Errors
///
/// An unknown name, a wrong count of numbers, a number outside of its domain or not finite, numbers that
/// are no colour, a colour that the model cannot hold.
pub fn convert(from: &str, to: &str, values: &[f64]) -> Result<Vec<f64>, ConvertError> {
    let (from, to) = (Model::from_name(from)?, Model::from_name(to)?);
    let xyz = from.to_xyz(from.read(values)?);
    let not_finite =
        |found: &[f64]| ConvertError::NotFinite { from, to, values: values.to_vec(), found: found.to_vec() };
    if !xyz.0.iter().all(|v| v.is_finite()) {
        return Err(not_finite(&xyz.0));
    }
    let Srgb(srgb) = Srgb::from_xyz(xyz);
    let in_cube = srgb.iter().all(|c| (-CUBE_TOLERANCE..=1.0 + CUBE_TOLERANCE).contains(c));
    if to.info().srgb_only && !in_cube {
        return Err(ConvertError::OutOfGamut { to, srgb });
    }
    let found = &to.from_xyz(xyz)[..to.info().channels.len()];
    match found.iter().all(|v| v.is_finite()) {
        true => Ok(found.to_vec()),
        false => Err(not_finite(found)),
    }
}
