//! Corners at equal positions, joined.

use std::collections::HashMap;

use glam::{DVec3, Vec3, Vec4};

use super::super::anchor::Anchor;
use super::super::faces::{close_face, corners_fit};
use crate::Mesh;

/// A mesh that grows facet by facet.
#[derive(Default)]
pub(super) struct Weld {
    pub(super) mesh: Mesh,
    pub(super) anchor: Anchor,
    /// By position and number of the colour.
    vertices: HashMap<([u64; 3], Option<u16>), u32>,
}

/// What became of a facet.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Added {
    /// It was added.
    Facet,
    /// A position is no number.
    NotFinite,
    /// The mesh holds as many corners as it can.
    Full,
}

impl Weld {
    /// Adds a facet of three or more corners, with the number and the value of its colour if it has one.
    pub(super) fn facet(&mut self, corners: &[DVec3], paint: Option<(u16, Vec3)>) -> Added {
        if !corners.iter().all(|corner| corner.as_vec3().is_finite()) {
            return Added::NotFinite;
        }
        if !corners_fit(&self.mesh, corners.len()) {
            return Added::Full;
        }
        let first = self.mesh.corners.len();
        for &corner in corners {
            // Adding zero makes −0 the same point as 0.
            let position = corner + DVec3::ZERO;
            let next = self.mesh.positions.len() as u32;
            let key = (position.to_array().map(f64::to_bits), paint.map(|(number, _)| number));
            let vertex = *self.vertices.entry(key).or_insert(next);
            if vertex == next {
                self.vertex(position, paint);
            }
            self.mesh.corners.push(vertex);
        }
        close_face(&mut self.mesh, first);
        Added::Facet
    }

    fn vertex(&mut self, position: DVec3, paint: Option<(u16, Vec3)>) {
        let Mesh { positions, colors, .. } = &mut self.mesh;
        if paint.is_some() || !colors.is_empty() {
            // Facets without a colour are white.
            colors.resize(positions.len(), Vec4::ONE);
            colors.push(paint.map_or(Vec4::ONE, |(_, color)| color.extend(1.0)));
        }
        self.anchor.push(position, positions);
    }
}
