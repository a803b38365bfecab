//! Meshes in the world.

use glam::{DMat3, DMat4, DVec3, Vec3};
use glanz_scene::{Bounds, Mesh};

/// A mesh put into the world: relative to an anchor, so that `f32` keeps its precision far from the
/// origin.
pub(crate) struct Placed {
    /// The point that positions are relative to.
    pub anchor: DVec3,
    /// Box of the vertices relative to the anchor.
    pub bounds: [DVec3; 2],
    /// Whether the transform mirrors, so that triangles change their winding.
    pub mirrored: bool,
    determinant: f64,
    linear: DMat3,
    offset: DVec3,
    normal_matrix: DMat3,
}

impl Placed {
    /// Puts `mesh` into the world by an affine transform.
    pub(crate) fn new(mesh: &Mesh, transform: DMat4) -> Self {
        let linear = DMat3::from_mat4(transform);
        let translation = transform.w_axis.truncate();
        let determinant = linear.determinant();
        let mut bounds = Bounds::EMPTY;
        for position in &mesh.positions {
            bounds.include(linear * position.as_dvec3());
        }
        let center = if bounds.is_empty() { DVec3::ZERO } else { bounds.center() };
        let bounds =
            if bounds.is_empty() { [DVec3::ZERO; 2] } else { [bounds.min - center, bounds.max - center] };
        // A transform that flattens has no inverse; its cofactors still give the normal of the plane.
        let normal_matrix = cofactors(linear) * if determinant < 0.0 { -1.0 } else { 1.0 };
        Self {
            anchor: translation + center,
            bounds,
            mirrored: determinant < 0.0,
            determinant,
            linear,
            offset: -center,
            normal_matrix: normal_matrix * scale_to_unit(normal_matrix),
        }
    }

    /// Of the linear part of the transform; negative where it mirrors.
    pub(crate) fn determinant(&self) -> f64 {
        self.determinant
    }

    /// A mesh position in the world, relative to the anchor.
    pub(crate) fn position(&self, p: Vec3) -> DVec3 {
        self.linear * p.as_dvec3() + self.offset
    }
    /// A mesh normal in the world, not normalised.
    pub(crate) fn normal(&self, n: Vec3) -> DVec3 {
        self.normal_matrix * n.as_dvec3()
    }
    /// A mesh direction in the world, not normalised.
    pub(crate) fn direction(&self, t: Vec3) -> DVec3 {
        self.linear * t.as_dvec3()
    }
}

/// The matrix of cofactors: the determinant times the inverse transpose.
fn cofactors(m: DMat3) -> DMat3 {
    DMat3::from_cols(m.y_axis.cross(m.z_axis), m.z_axis.cross(m.x_axis), m.x_axis.cross(m.y_axis))
}

/// A factor that brings the matrix to ordinary size, so that `f32` normals neither vanish nor overflow.
fn scale_to_unit(m: DMat3) -> f64 {
    let size = m.x_axis.length().max(m.y_axis.length()).max(m.z_axis.length());
    if size > 0.0 && size.is_finite() { 1.0 / size } else { 1.0 }
}
