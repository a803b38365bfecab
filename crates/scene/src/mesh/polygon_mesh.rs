//! Polygon meshes.

use glam::{DVec3, Vec2, Vec3, Vec4};
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// An axis-parallel box, possibly empty.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Bounds {
    /// The corner of least coordinates.
    pub min: DVec3,
    /// The corner of greatest coordinates.
    pub max: DVec3,
}

impl Bounds {
    /// The box that holds nothing.
    pub const EMPTY: Self = Self { min: DVec3::INFINITY, max: DVec3::NEG_INFINITY };

    /// Whether it holds nothing.
    pub fn is_empty(&self) -> bool {
        !self.min.cmple(self.max).all()
    }
    /// Grows the box so that it holds `point`. Points that are not finite are left out.
    pub fn include(&mut self, point: DVec3) {
        if point.is_finite() {
            self.min = self.min.min(point);
            self.max = self.max.max(point);
        }
    }
    /// The middle.
    pub fn center(&self) -> DVec3 {
        (self.min + self.max) * 0.5
    }
    /// The length of the diagonal; 0 where empty.
    pub fn diagonal(&self) -> f64 {
        if self.is_empty() { 0.0 } else { (self.max - self.min).length() }
    }
}

/// A mesh of polygons whose corners share vertices.
///
/// All attribute arrays are empty (the mesh does not have them) or as long as `positions`.
///
/// ```
/// use glanz_scene::{Mesh, Normals, glam::Vec3};
///
/// let corner = |x: f32, y: f32| Vec3::new(x, y, 0.0);
/// let square = Mesh {
///     positions: vec![corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0), corner(0.0, 1.0)],
///     corners: vec![0, 1, 2, 3],
///     face_starts: vec![0, 4],
///     ..Mesh::default()
/// };
/// square.validate()?;
/// assert_eq!((square.face_count(), square.triangle_count()), (1, 2));
/// let square = square.with_normals(Normals::Given);
/// assert_eq!(square.normals[0], Vec3::Z);
/// # Ok::<(), glanz_scene::MeshError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Mesh {
    /// A name for people; may be empty.
    pub name: String,
    /// Vertex positions.
    pub positions: Vec<Vec3>,
    /// Unit normals, outwards.
    pub normals: Vec<Vec3>,
    /// Texture coordinates, v downwards as in glTF.
    pub uvs: Vec<Vec2>,
    /// A second set of them, for textures that ask for it.
    #[serde(default)]
    pub uvs2: Vec<Vec2>,
    /// Unit tangents along +u; w is the sign of the bitangent.
    pub tangents: Vec<Vec4>,
    /// Linear RGB and alpha.
    pub colors: Vec<Vec4>,
    /// The corners of all faces, one after the other: indices of vertices, counter-clockwise seen
    /// from outside.
    pub corners: Vec<u32>,
    /// Where each face begins in `corners`, with a last entry for the end. Empty: all are triangles.
    pub face_starts: Vec<u32>,
}

/// What is wrong with a mesh.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum MeshError {
    /// An index points past the vertices.
    #[error("corner {corner} names vertex {index}, but there are only {vertices} vertices")]
    IndexOutOfRange {
        /// Which entry of `corners`.
        corner: usize,
        /// The vertex that it names.
        index: u32,
        /// How many there are.
        vertices: usize,
    },
    /// An attribute array has another length than the positions.
    #[error("{attribute} has {found} entries for {expected} vertices")]
    AttributeLength {
        /// The attribute's name.
        attribute: &'static str,
        /// Its length.
        found: usize,
        /// The number of vertices.
        expected: usize,
    },
    /// A coordinate is NaN or infinite.
    #[error("vertex {vertex} has a {attribute} that is not a finite number")]
    NotFinite {
        /// The attribute's name.
        attribute: &'static str,
        /// Which vertex.
        vertex: usize,
    },
    /// `corners` cannot be cut into faces.
    #[error("{corners} corners cannot be cut into {what}")]
    Faces {
        /// The length of `corners`.
        corners: usize,
        /// What was expected of them.
        what: &'static str,
    },
}

impl Mesh {
    /// The number of faces.
    pub fn face_count(&self) -> usize {
        if self.face_starts.is_empty() { self.corners.len() / 3 } else { self.face_starts.len() - 1 }
    }

    /// The vertex indices of face `face`.
    pub fn face(&self, face: usize) -> &[u32] {
        if self.face_starts.is_empty() {
            &self.corners[3 * face..3 * face + 3]
        } else {
            &self.corners[self.face_starts[face] as usize..self.face_starts[face + 1] as usize]
        }
    }

    /// All faces in order.
    pub fn faces(&self) -> impl Iterator<Item = &[u32]> {
        (0..self.face_count()).map(|face| self.face(face))
    }

    /// The most triangles that all faces are cut into: two fewer than it has corners of each.
    pub fn triangle_count(&self) -> usize {
        if self.face_starts.is_empty() {
            self.corners.len() / 3
        } else {
            self.face_starts.windows(2).map(|w| (w[1] - w[0]).saturating_sub(2) as usize).sum()
        }
    }

    /// The triangles of all faces: [`Mesh::triangles_of`] each.
    pub fn triangles(&self) -> impl Iterator<Item = [u32; 3]> {
        (0..self.face_count()).flat_map(|face| {
            let corners = self.face(face);
            self.triangles_of(face).map(move |triangle| triangle.map(|place| corners[place as usize]))
        })
    }

    /// The box around the vertices that faces use.
    pub fn bounds(&self) -> Bounds {
        let mut bounds = Bounds::EMPTY;
        for &corner in &self.corners {
            if let Some(position) = self.positions.get(corner as usize) {
                bounds.include(position.as_dvec3());
            }
        }
        bounds
    }

    /// Checks all that other code relies on: lengths, indices, finite numbers.
    pub fn validate(&self) -> Result<(), MeshError> {
        let expected = self.positions.len();
        let lengths = [
            ("normals", self.normals.len()),
            ("texture coordinates", self.uvs.len()),
            ("second texture coordinates", self.uvs2.len()),
            ("tangents", self.tangents.len()),
            ("colors", self.colors.len()),
        ];
        for (attribute, found) in lengths {
            if found != 0 && found != expected {
                return Err(MeshError::AttributeLength { attribute, found, expected });
            }
        }
        self.validate_faces()?;
        let finite = |attribute, vertex: Option<usize>| match vertex {
            Some(vertex) => Err(MeshError::NotFinite { attribute, vertex }),
            None => Ok(()),
        };
        finite("position", self.positions.iter().position(|v| !v.is_finite()))?;
        finite("normal", self.normals.iter().position(|v| !v.is_finite()))?;
        finite("texture coordinate", self.uvs.iter().position(|v| !v.is_finite()))?;
        finite("second texture coordinate", self.uvs2.iter().position(|v| !v.is_finite()))?;
        finite("tangent", self.tangents.iter().position(|v| !v.is_finite()))?;
        finite("color", self.colors.iter().position(|v| !v.is_finite()))
    }

    fn validate_faces(&self) -> Result<(), MeshError> {
        let corners = self.corners.len();
        if self.face_starts.is_empty() {
            if !corners.is_multiple_of(3) {
                return Err(MeshError::Faces { corners, what: "triangles" });
            }
        } else {
            let rising = self.face_starts.windows(2).all(|w| w[0] <= w[1]);
            let ends = self.face_starts[0] == 0 && self.face_starts.last() == Some(&(corners as u32));
            if !rising || !ends {
                return Err(MeshError::Faces { corners, what: "the faces that face_starts tells" });
            }
        }
        let vertices = self.positions.len();
        match self.corners.iter().position(|&index| index as usize >= vertices) {
            Some(corner) => Err(MeshError::IndexOutOfRange { corner, index: self.corners[corner], vertices }),
            None => Ok(()),
        }
    }
}
