//! The vertex data of a file.

use glam::{Vec2, Vec3};

/// The vertex data of the whole file, which faces refer to.
#[derive(Default)]
pub(super) struct Data {
    pub(super) positions: Vec<Vec3>,
    /// Empty until a vertex has a colour.
    pub(super) colors: Vec<Vec3>,
    pub(super) uvs: Vec<Vec2>,
    pub(super) normals: Vec<Vec3>,
}
