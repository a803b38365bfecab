//! The values of a scene file: numbers with ranges, vectors, colours, and values with their place.
//!
//! Each checks itself while it is read, so that an error points at the value.

use std::borrow::Cow;
use std::fmt;
use std::ops::{Deref, Range};

use glam::DVec3;
use glanz_color::{Rgb, srgb_decode_u8};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Error, IntoDeserializer, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};

/// Positions, lengths and colours beyond this are refused: their squares must fit into `f32`.
pub(crate) const LIMIT: f64 = 1e12;

/// A value and the bytes of the document that it stands in.
#[derive(Clone, Debug)]
pub(crate) struct At<T> {
    pub value: T,
    pub span: Range<usize>,
}

impl<T> Deref for At<T> {
    type Target = T;
    fn deref(&self) -> &T {
        &self.value
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for At<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let spanned = toml::Spanned::<T>::deserialize(deserializer)?;
        Ok(Self { span: spanned.span(), value: spanned.into_inner() })
    }
}

impl<T: JsonSchema> JsonSchema for At<T> {
    fn schema_name() -> Cow<'static, str> {
        T::schema_name()
    }
    fn inline_schema() -> bool {
        T::inline_schema()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        T::json_schema(generator)
    }
}

/// A number within a range.
macro_rules! number {
    ($(#[$doc:meta])* $name:ident, $expected:literal, $test:expr, $schema:tt) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub(crate) struct $name(pub f64);

        impl<'de> Deserialize<'de> for $name {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                deserializer.deserialize_any(NumberVisitor { expected: $expected, test: $test }).map(Self)
            }
        }

        impl JsonSchema for $name {
            fn schema_name() -> Cow<'static, str> {
                stringify!($name).into()
            }
            fn inline_schema() -> bool {
                true
            }
            fn json_schema(_: &mut SchemaGenerator) -> Schema {
                json_schema!($schema)
            }
        }
    };
}

number!(
    /// Any number of reasonable size.
    Number, "a finite number of at most 1e12", |v| v.abs() <= LIMIT,
    { "type": "number", "minimum": -1e12, "maximum": 1e12 }
);

number!(
    /// A length that is not zero.
    Positive, "a length between 1e-12 and 1e12", |v| (1e-12..=LIMIT).contains(&v),
    { "type": "number", "exclusiveMinimum": 0.0, "maximum": 1e12 }
);

number!(
    /// An amount.
    Amount, "a number between 0 and 1e12", |v| (0.0..=LIMIT).contains(&v),
    { "type": "number", "minimum": 0.0, "maximum": 1e12 }
);

number!(
    /// A fraction.
    Fraction, "a number between 0 and 1", |v| (0.0..=1.0).contains(&v),
    { "type": "number", "minimum": 0.0, "maximum": 1.0 }
);

number!(
    /// The vertical field of view of a perspective camera.
    FieldOfView, "degrees between 0.001 and 179.999", |v| (0.001..=179.999).contains(&v),
    { "type": "number", "minimum": 0.001, "maximum": 179.999 }
);

number!(
    /// Half the opening angle of a cone, or an angle between facets.
    HalfTurn, "degrees between 0 and 180", |v| (0.0..=180.0).contains(&v),
    { "type": "number", "minimum": 0.0, "maximum": 180.0 }
);

number!(
    /// The power of a cosine.
    Exponent, "an exponent between 0 and 100000", |v| (0.0..=1e5).contains(&v),
    { "type": "number", "minimum": 0.0, "maximum": 1e5 }
);

number!(
    /// Exposure in stops.
    Stops, "stops between -100 and 100", |v| v.abs() <= 100.0,
    { "type": "number", "minimum": -100.0, "maximum": 100.0 }
);

number!(
    /// Years of an eye.
    Age, "an age between 5 and 100 years", |v| (5.0..=100.0).contains(&v),
    { "type": "number", "minimum": 5.0, "maximum": 100.0 }
);

number!(
    /// The field of an observer.
    FieldSize, "a field between 1 and 10 degrees", |v| (1.0..=10.0).contains(&v),
    { "type": "number", "minimum": 1.0, "maximum": 10.0 }
);

number!(
    /// A density over the usual one.
    Density, "a density between 0 and 3 in parts of the usual", |v| (0.0..=3.0).contains(&v),
    { "type": "number", "minimum": 0.0, "maximum": 3.0 }
);

number!(
    /// By how much a pigment is moved.
    PigmentShift, "a shift between -20 and 20 nm", |v| (-20.0..=20.0).contains(&v),
    { "type": "number", "minimum": -20.0, "maximum": 20.0 }
);

number!(
    /// The pigment of an iris.
    IrisPigment, "a number between 0 (black) and 1.2 (light blue)", |v| (0.0..=1.2).contains(&v),
    { "type": "number", "minimum": 0.0, "maximum": 1.2 }
);

number!(
    /// A light level.
    Luminance, "a luminance between 1e-7 and 1e7 cd/m²", |v| (1e-7..=1e7).contains(&v),
    { "type": "number", "minimum": 1e-7, "maximum": 1e7 }
);

number!(
    /// Pixels of a degree of sight.
    PixelsPerDegree, "a number of pixels between 0.1 and 10000", |v| (0.1..=1e4).contains(&v),
    { "type": "number", "minimum": 0.1, "maximum": 1e4 }
);

/// Takes integers and floats, says what was expected in place of others. It tests them itself, since
/// what is said after a visitor has left no longer points at an entry of a list.
struct NumberVisitor {
    expected: &'static str,
    test: fn(f64) -> bool,
}

impl Visitor<'_> for NumberVisitor {
    type Value = f64;
    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.expected)
    }
    fn visit_f64<E: Error>(self, value: f64) -> Result<f64, E> {
        match (self.test)(value) {
            true => Ok(value),
            false => Err(E::custom(format!("expected {}, found {}", self.expected, shown(value)))),
        }
    }
    fn visit_i64<E: Error>(self, value: i64) -> Result<f64, E> {
        self.visit_f64(value as f64)
    }
    fn visit_u64<E: Error>(self, value: u64) -> Result<f64, E> {
        self.visit_f64(value as f64)
    }
}

/// The number as people write it.
fn shown(value: f64) -> String {
    if value != 0.0 && value.is_finite() && !(1e-6..1e12).contains(&value.abs()) {
        format!("{value:e}")
    } else {
        value.to_string()
    }
}

/// Three numbers: a position or an extent.
#[derive(Clone, Copy, Debug, PartialEq, JsonSchema)]
pub(crate) struct Vector(#[schemars(with = "[Number; 3]")] pub DVec3);

impl<'de> Deserialize<'de> for Vector {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(ListVisitor::<Number, 3>::new("three numbers")).map(|v| {
            let [x, y, z] = v.map(|n| n.0);
            Self(DVec3::new(x, y, z))
        })
    }
}

/// Three numbers that are not all zero.
#[derive(Clone, Copy, Debug, PartialEq, JsonSchema)]
pub(crate) struct Direction(#[schemars(with = "[Number; 3]")] pub DVec3);

impl<'de> Deserialize<'de> for Direction {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let Vector(vector) = Vector::deserialize(deserializer)?;
        match vector.length() >= 1e-12 {
            true => Ok(Self(vector)),
            false => Err(D::Error::custom("expected a direction, found three zeros")),
        }
    }
}

/// A linear colour: three amounts, or `"#rrggbb"` in sRGB codes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Color(pub Rgb);

impl Color {
    pub(crate) fn parse_hex(text: &str) -> Option<Self> {
        let digits = text.strip_prefix('#').filter(|d| d.len() == 6 && d.is_ascii())?;
        let mut channels = [0.0; 3];
        for (channel, pair) in channels.iter_mut().zip([0..2, 2..4, 4..6]) {
            let pair = &digits[pair];
            let hex = pair.bytes().all(|b| b.is_ascii_hexdigit());
            *channel = srgb_decode_u8(u8::from_str_radix(pair, 16).ok().filter(|_| hex)?);
        }
        Some(Self(Rgb(channels)))
    }
}

impl JsonSchema for Color {
    fn schema_name() -> Cow<'static, str> {
        "Color".into()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let three = <[Amount; 3]>::json_schema(generator);
        let one = Amount::json_schema(generator);
        json_schema!({
            "description": "Linear RGB, three amounts of at least 0, or one for a grey; or \"#rrggbb\" in sRGB codes.",
            "anyOf": [three, one, { "type": "string", "pattern": "^#[0-9a-fA-F]{6}$" }]
        })
    }
}

struct ColorVisitor;

impl<'de> Visitor<'de> for ColorVisitor {
    type Value = Color;
    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a colour: three amounts such as [1.0, 0.5, 0.0], one for a grey, or \"#rrggbb\"")
    }
    fn visit_f64<E: Error>(self, amount: f64) -> Result<Color, E> {
        let Amount(amount) = Amount::deserialize(amount.into_deserializer())?;
        Ok(Color(Rgb::gray(amount as f32)))
    }
    fn visit_i64<E: Error>(self, amount: i64) -> Result<Color, E> {
        self.visit_f64(amount as f64)
    }
    fn visit_u64<E: Error>(self, amount: u64) -> Result<Color, E> {
        self.visit_f64(amount as f64)
    }
    fn visit_str<E: Error>(self, text: &str) -> Result<Color, E> {
        let found = text.chars().take(40).collect::<String>();
        Color::parse_hex(text)
            .ok_or_else(|| E::custom(format!("expected a colour such as \"#ff8000\", found \"{found}\"")))
    }
    fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<Color, A::Error> {
        let amounts = ListVisitor::<Amount, 3>::new("three amounts of red, green and blue").visit_seq(seq)?;
        Ok(Color(Rgb(amounts.map(|v| v.0 as f32))))
    }
}

impl<'de> Deserialize<'de> for Color {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(ColorVisitor)
    }
}

/// A list of exactly `N` values.
struct ListVisitor<T, const N: usize>(&'static str, std::marker::PhantomData<T>);

impl<T, const N: usize> ListVisitor<T, N> {
    fn new(expected: &'static str) -> Self {
        Self(expected, std::marker::PhantomData)
    }
}

impl<'de, T: Deserialize<'de>, const N: usize> Visitor<'de> for ListVisitor<T, N> {
    type Value = [T; N];
    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.0)
    }
    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<[T; N], A::Error> {
        let mut values = Vec::with_capacity(N);
        while let Some(value) = seq.next_element()? {
            values.push(value);
            if values.len() > N {
                break;
            }
        }
        let found = values.len();
        values.try_into().map_err(|_| {
            let more = if found > N { "more" } else { &found.to_string() };
            A::Error::custom(format!("expected {}, found {more}", self.0))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read<T: for<'a> Deserialize<'a>>(text: &str) -> Result<T, String> {
        let de = toml::de::ValueDeserializer::parse(text).map_err(|e| e.to_string())?;
        T::deserialize(de).map_err(|e| e.message().to_owned())
    }

    #[test]
    fn colours_are_linear_amounts_or_srgb_codes() {
        assert_eq!(read::<Color>("[0.25, 1, 2.0]").expect("three").0, Rgb([0.25, 1.0, 2.0]));
        assert_eq!(read::<Color>("'#ff0080'").expect("hex").0, Rgb([1.0, 0.0, srgb_decode_u8(128)]));
        for bad in ["'#+f0080'", "'#ff008'", "'red'", "[1, 1]", "[1, 1, 1, 1]", "[-1, 0, 0]", "[nan, 0, 0]"] {
            assert!(read::<Color>(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn numbers_out_of_range_are_refused_with_what_was_expected() {
        assert_eq!(
            read::<Fraction>("1.5").map(|v| v.0),
            Err("expected a number between 0 and 1, found 1.5".into())
        );
        assert!(read::<Positive>("0").is_err());
        assert!(read::<FieldOfView>("180").is_err());
        assert!(read::<HalfTurn>("180").is_ok());
        for bad in ["nan", "inf", "-inf", "1e13", "'1'", "true", "9223372036854775807"] {
            assert!(read::<Number>(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn directions_have_a_length() {
        assert!(read::<Direction>("[0.0, 0.0, 0.0]").is_err());
        assert!(read::<Direction>("[0.0, -1.0, 0]").is_ok());
    }
}
