//! Where objects are put: translation, rotation, scale, or a matrix.

use std::fmt;

use glam::{DMat3, DMat4, DVec3, DVec4};
use schemars::JsonSchema;
use serde::de::value::MapAccessDeserializer;
use serde::de::{Error, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};

use crate::file::tables::values::{Direction, Number, Vector};

/// A rotation by the right-hand rule.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Rotation {
    /// The axis; any length but zero.
    pub axis: Direction,
    /// The angle in degrees.
    pub angle: Number,
}

impl Rotation {
    pub(crate) fn matrix(&self) -> DMat4 {
        // Whole turns are taken off in degrees, where that is exact.
        let angle = (self.angle.0 % 360.0).to_radians();
        DMat4::from_axis_angle(self.axis.0.normalize(), angle)
    }
}

/// One rotation or several in their order.
#[derive(Clone, Debug, JsonSchema)]
#[schemars(untagged)]
#[expect(dead_code, reason = "the variants tell the schema what the list is read from")]
enum RotationsForm {
    One(Rotation),
    Several(Vec<Rotation>),
}

/// One rotation or several, in the order in which they are done.
#[derive(Clone, Debug, JsonSchema)]
pub(crate) struct Rotations(#[schemars(with = "RotationsForm")] pub Vec<Rotation>);

impl Rotations {
    /// All of them, one after the other.
    pub(crate) fn matrix(&self) -> DMat3 {
        DMat3::from_mat4(self.0.iter().fold(DMat4::IDENTITY, |all, next| next.matrix() * all))
    }
}

impl<'de> Deserialize<'de> for Rotations {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Form;
        impl<'de> Visitor<'de> for Form {
            type Value = Rotations;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a rotation such as { axis = [0, 1, 0], angle = 20 }, or a list of them")
            }
            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Rotations, A::Error> {
                Rotation::deserialize(MapAccessDeserializer::new(map)).map(|r| Rotations(vec![r]))
            }
            fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<Rotations, A::Error> {
                let list = serde::de::value::SeqAccessDeserializer::new(seq);
                crate::file::tables::table::list(list).map(Rotations)
            }
        }
        deserializer.deserialize_any(Form)
    }
}

/// One factor or three.
#[derive(Clone, Copy, Debug, JsonSchema)]
#[schemars(untagged)]
#[expect(dead_code, reason = "the variants tell the schema what the scale is read from")]
enum ScaleForm {
    One(Number),
    Three(Vector),
}

/// Factors along the axes, none of them zero.
#[derive(Clone, Copy, Debug, JsonSchema)]
pub(crate) struct Scale(#[schemars(with = "ScaleForm")] pub DVec3);

impl<'de> Deserialize<'de> for Scale {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Form;
        impl<'de> Visitor<'de> for Form {
            type Value = DVec3;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a factor, or three of them")
            }
            fn visit_f64<E>(self, factor: f64) -> Result<DVec3, E> {
                Ok(DVec3::splat(factor))
            }
            fn visit_i64<E>(self, factor: i64) -> Result<DVec3, E> {
                Ok(DVec3::splat(factor as f64))
            }
            fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<DVec3, A::Error> {
                Vector::deserialize(serde::de::value::SeqAccessDeserializer::new(seq)).map(|v| v.0)
            }
        }
        let factors = deserializer.deserialize_any(Form)?;
        let sizes = factors.abs();
        match sizes.min_element() >= 1e-9 && sizes.max_element() <= 1e9 {
            true => Ok(Self(factors)),
            false => Err(D::Error::custom(format!(
                "expected factors whose size is between 1e-9 and 1e9, found {factors}; 0 would leave nothing"
            ))),
        }
    }
}

/// The rows of an affine matrix.
#[derive(Clone, Copy, Debug, JsonSchema)]
pub(crate) struct Matrix(#[schemars(with = "Vec<[Number; 4]>", length(min = 3, max = 4))] pub DMat4);

impl<'de> Deserialize<'de> for Matrix {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let rows = Vec::<[Number; 4]>::deserialize(deserializer)?;
        if !matches!(rows.len(), 3 | 4) {
            return Err(D::Error::custom(format!("expected 3 or 4 rows of 4 numbers, found {}", rows.len())));
        }
        let row = |i: usize| rows.get(i).map_or(DVec4::W, |row| DVec4::from_array(row.map(|n| n.0)));
        if row(3) != DVec4::W {
            return Err(D::Error::custom(format!(
                "expected the last row to be 0, 0, 0, 1, found {}",
                row(3)
            )));
        }
        let matrix = DMat4::from_cols(row(0), row(1), row(2), row(3)).transpose();
        let [x, y, z] = [matrix.x_axis, matrix.y_axis, matrix.z_axis].map(|c| c.truncate().length());
        // The determinant over the product of the axes' lengths is the volume of the box of unit
        // axes: below this, they lie in a plane as far as `f32` can tell.
        let flat = matrix.determinant().abs() < 1e-7 * x * y * z;
        match flat || x.min(y).min(z) < 1e-9 || x.max(y).max(z) > 1e9 {
            false => Ok(Self(matrix)),
            true => Err(D::Error::custom("the matrix is singular, or scales by more than 1e9")),
        }
    }
}
