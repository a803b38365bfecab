//! Layer weights of a lobe.

use glanz_bsdf::models::charlie;
use glanz_bsdf::{Chebyshev, LayerWeight};

use crate::file::build::builder::Builder;
use crate::file::error::Problem;
use crate::file::tables::appearance::layer_weights::LayerTable;
use crate::file::tables::values::Number;

impl LayerTable {
    /// The weight.
    pub(super) fn weight(&self, builder: &mut Builder) -> Result<LayerWeight, Problem> {
        let series = |terms: &[Number]| Chebyshev { terms: terms.iter().map(|term| [term.0]).collect() };
        Ok(match self {
            Self::Constant(weight) => LayerWeight::Constant(weight.0),
            Self::Schlick(table) => LayerWeight::Schlick {
                angle: table.angle.angle(),
                at_zero: table.at_zero.0,
                at_grazing: table.at_grazing.0,
            },
            Self::Series(table) => {
                LayerWeight::Series { angle: table.angle.angle(), factor: series(&table.terms) }
            }
            Self::Coat(table) => {
                LayerWeight::Coat { transmittance: series(&table.terms), gain: table.gain.0 }
            }
            Self::OverBoundary(table) => LayerWeight::OverBoundary { transmittance: series(&table.terms) },
            Self::Sheen(table) => LayerWeight::Sheen {
                strength: table.strength.0,
                albedo: charlie::Albedo::from_series(table.terms.map(|term| term.0)),
            },
            Self::Table(own) => {
                let (table, rank) = (builder.factor_table(&own.file)?, own.rank);
                if rank >= table.ranks() {
                    let message = format!("rank {rank} of a table that has {}, from 0", table.ranks());
                    return Err(Problem::at(&own.file.span, message));
                }
                LayerWeight::Table { table, rank }
            }
        })
    }
}
