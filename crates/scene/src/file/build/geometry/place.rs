//! The transforms of objects.

use glam::DMat4;

use crate::file::error::Problem;
use crate::file::tables::geometry::place::{Matrix, Rotations, Scale};
use crate::file::tables::values::{At, Vector};

/// The keys of an object that place it.
pub(crate) struct PlaceKeys<'a> {
    pub translate: Option<&'a At<Vector>>,
    pub rotate_deg: Option<&'a At<Rotations>>,
    pub scale: Option<&'a At<Scale>>,
    pub matrix: Option<&'a At<Matrix>>,
}

impl PlaceKeys<'_> {
    /// From mesh to world coordinates: scaled, then rotated, then moved.
    pub(crate) fn transform(&self) -> Result<DMat4, Problem> {
        if let Some(matrix) = self.matrix {
            if self.translate.is_some() || self.rotate_deg.is_some() || self.scale.is_some() {
                let message = "'matrix' beside 'translate', 'rotate_deg' or 'scale'";
                return Err(Problem::at(&matrix.span, message).help("give one or the other"));
            }
            return Ok(matrix.0);
        }
        let mut transform = DMat4::IDENTITY;
        if let Some(scale) = self.scale {
            transform = DMat4::from_scale(scale.0);
        }
        for rotation in self.rotate_deg.iter().flat_map(|rotations| &rotations.0) {
            transform = rotation.matrix() * transform;
        }
        if let Some(translate) = self.translate {
            transform = DMat4::from_translation(translate.0) * transform;
        }
        Ok(transform)
    }
}
