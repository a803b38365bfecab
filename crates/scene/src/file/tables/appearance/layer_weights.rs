//! Layer weights of a lobe, by their numbers.

use glanz_bsdf::Angle;
use schemars::JsonSchema;
use serde::Deserialize;

use crate::Metalness;
use crate::file::tables::values::{At, Number};
use crate::names::names;

names! {
    /// The angle whose cosine a weight is a function of.
    pub(crate) AngleName {
        /// Between viewer and half vector.
        Half = "half",
        /// Between viewer and the half vector to the light mirrored at the surface, for thin sheets.
        HalfThrough = "half-through",
        /// Between viewer and normal.
        View = "view",
    } default Half
}

impl AngleName {
    /// The angle.
    pub(crate) fn angle(self) -> Angle {
        match self {
            Self::Half => Angle::Half,
            Self::HalfThrough => Angle::HalfThrough,
            Self::View => Angle::View,
        }
    }
}

/// The weight of a layer over a lobe: a factor that depends on the angles alone.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub(crate) enum LayerTable {
    /// The same for all directions.
    Constant(Number),
    /// Schlick's form: from `at_zero` where the cosine is 1 to `at_grazing` where it is 0.
    Schlick(SchlickTable),
    /// A Chebyshev series in a cosine.
    Series(SeriesTable),
    /// A clear coat that light crosses on its way in and out.
    Coat(CoatWeightTable),
    /// A clear coat over a boundary whose tint says what light below it does.
    OverBoundary(OverBoundaryTable),
    /// What a sheen leaves to the layers below.
    Sheen(SheenTable),
    /// A rank of a table over half and difference angles: what measured reflectance is over the lobe.
    Table(FactorsTable),
}

/// A rank of a table of factors.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct FactorsTable {
    /// The file of the table, as saved scenes have it.
    pub file: At<String>,
    /// Which rank, from 0.
    pub rank: usize,
}

/// Schlick's form of a weight.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct SchlickTable {
    /// Which cosine.
    pub angle: AngleName,
    /// The weight where the cosine is 1.
    pub at_zero: Number,
    /// The weight where the cosine is 0.
    pub at_grazing: Number,
}

/// A weight as a series.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct SeriesTable {
    /// Which cosine.
    pub angle: AngleName,
    /// The coefficients over the cosine from 0 to 1, of degree 0 first.
    pub terms: Vec<Number>,
}

/// The weight of a coat.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct CoatWeightTable {
    /// Coefficients of its transmittance over the cosine, of degree 0 first.
    pub terms: Vec<Number>,
    /// What light that the layer throws back to the base adds.
    pub gain: Number,
}

/// The weight of a coat over a boundary whose tint is met below it.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct OverBoundaryTable {
    /// Coefficients of the coat's transmittance over the cosine, of degree 0 first.
    pub terms: Vec<Number>,
}

/// The weight of a sheen.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct SheenTable {
    /// The greatest channel of the sheen's colour.
    pub strength: Number,
    /// The coefficients of the sheen's albedo over the root of the cosine, of degree 0 first.
    pub terms: [Number; 13],
}

/// Which part of a surface a lobe belongs to, as in the metallic-roughness model of glTF.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub(crate) enum MetalnessTable {
    /// The lobe counts by this factor times the blue of `metal_rough_texture`.
    Metal(Number),
    /// It counts by the rest.
    Dielectric(Number),
}

impl MetalnessTable {
    /// The part.
    pub(crate) fn metalness(&self) -> Metalness {
        match self {
            Self::Metal(factor) => Metalness::Metal { factor: factor.0 },
            Self::Dielectric(factor) => Metalness::Dielectric { factor: factor.0 },
        }
    }
}
