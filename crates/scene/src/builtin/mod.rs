//! Meshes that need no file.
//!
//! All are centred on the origin with +Y up, closed ones (cube, sphere, icosphere, torus, capped
//! cylinder and cone) without gap once vertices are welded by position. Faces wind counter-clockwise
//! seen from outside; normals are those of the true surface, not of the facets, so a coarse sphere
//! shaded by interpolated normals looks round. Texture coordinates run rightwards and downwards
//! seen from outside, with the seam of round meshes at the back (−Z).
//!
//! ```
//! use glanz_scene::{Builtin, Mesh};
//!
//! // By name with defaults, or with numbers.
//! assert_eq!(Mesh::builtin("cube")?.positions.len(), 24);
//! let coarse = Builtin::Sphere { radius: 1.0, slices: 8, stacks: 4 }.mesh()?;
//! assert!(coarse.positions.len() < Mesh::builtin("sphere")?.positions.len());
//! # Ok::<_, Box<dyn std::error::Error>>(())
//! ```

mod flat;
mod icosphere;
mod kite;
mod round;
mod teapot;
mod teapot_data;
#[cfg(test)]
mod tests;
mod turn;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::Mesh;
use crate::memory::counted;
use crate::scene::access::known_names;

/// The most triangles that a mesh or a scene may have: so the numbers of their corners, at most three for each, stay below 2³¹.
/// Whether there is memory for them is asked beforehand where a [`MemoryBudget`](glanz_math::MemoryBudget) is known.
pub const MAX_TRIANGLES: u64 = 500_000_000;

/// The least and greatest length that a built-in mesh may have, so that `f32` holds its coordinates
/// and their squares well.
const LENGTHS: [f64; 2] = [1e-15, 1e15];

/// A mesh that is made, not read.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Builtin {
    /// The folded kite of two triangles, with a colour at each of its four points.
    Kite,
    /// A square of side 2 at z = 0 that faces +Z.
    Quad,
    /// A square of side 2 at y = 0 that faces +Y.
    Plane,
    /// A cube with sharp edges.
    Cube {
        /// The length of an edge.
        #[serde(default = "two")]
        size: f64,
    },
    /// A sphere of meridians and parallels, poles on Y.
    Sphere {
        /// The radius.
        #[serde(default = "one")]
        radius: f64,
        /// How many times it is cut around the axis, at least 3.
        #[serde(default = "around")]
        slices: u32,
        /// How many times it is cut along the axis, at least 2.
        #[serde(default = "along")]
        stacks: u32,
    },
    /// A sphere of nearly equal triangles, from an icosahedron.
    Icosphere {
        /// The radius.
        #[serde(default = "one")]
        radius: f64,
        /// How many times each triangle is cut in four; 0 is the icosahedron.
        #[serde(default = "splits")]
        subdivisions: u32,
    },
    /// A ring around Y.
    Torus {
        /// The radius of the circle in the middle of the tube.
        #[serde(default = "one")]
        major: f64,
        /// The radius of the tube, less than `major`.
        #[serde(default = "tube")]
        minor: f64,
        /// How many times the ring is cut, at least 3.
        #[serde(default = "around")]
        segments: u32,
        /// How many sides the tube has, at least 3.
        #[serde(default = "along")]
        sides: u32,
    },
    /// A cylinder around Y.
    Cylinder {
        /// The radius.
        #[serde(default = "one")]
        radius: f64,
        /// The height.
        #[serde(default = "two")]
        height: f64,
        /// How many times it is cut around the axis, at least 3.
        #[serde(default = "around")]
        slices: u32,
        /// Whether its ends are closed.
        #[serde(default = "yes")]
        capped: bool,
    },
    /// A cone around Y with its apex up.
    Cone {
        /// The radius of the base.
        #[serde(default = "one")]
        radius: f64,
        /// The height.
        #[serde(default = "two")]
        height: f64,
        /// How many times it is cut around the axis, at least 3.
        #[serde(default = "around")]
        slices: u32,
        /// Whether its base is closed.
        #[serde(default = "yes")]
        capped: bool,
    },
    /// The Utah teapot: the body has radius 1 around Y, the spout points to +X. It is not closed.
    Teapot {
        /// How many times each side of its 32 patches is cut, at least 1.
        #[serde(default = "cuts")]
        tessellation: u32,
    },
}

/// Why a built-in mesh cannot be made.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum BuiltinError {
    /// No mesh has this name.
    #[error("there is no built-in mesh '{name}'{}", known_names(name, &Builtin::NAMES.map(str::to_owned)))]
    Name {
        /// The name that was asked for.
        name: String,
    },
    /// A length that is no length.
    #[error("{mesh}: {parameter} must be between {least:e} and {most:e}, but is {found}")]
    Length {
        /// The mesh's name.
        mesh: &'static str,
        /// The parameter's name.
        parameter: &'static str,
        /// What it is.
        found: f64,
        /// The least that it may be.
        least: f64,
        /// The most that it may be.
        most: f64,
    },
    /// Too few parts.
    #[error("{mesh}: {parameter} must be at least {least}, but is {found}")]
    Count {
        /// The mesh's name.
        mesh: &'static str,
        /// The parameter's name.
        parameter: &'static str,
        /// What it is.
        found: u32,
        /// The least that it may be.
        least: u32,
    },
    /// A tube that fills the ring's hole.
    #[error("torus: minor must be less than major ({major}), but is {minor}")]
    NoHole {
        /// The radius of the tube.
        minor: f64,
        /// The radius of the ring.
        major: f64,
    },
    /// Too many triangles.
    #[error("{mesh}: at most {MAX_TRIANGLES} triangles are made, but {} are asked for", counted(*triangles))]
    TooLarge {
        /// The mesh's name.
        mesh: &'static str,
        /// How many there would be (or more).
        triangles: u64,
    },
}

impl Mesh {
    /// The built-in mesh of this name, with the default parameters.
    ///
    /// ```
    /// use glanz_scene::Mesh;
    ///
    /// assert_eq!(Mesh::builtin("cube")?.triangle_count(), 12);
    /// let message = Mesh::builtin("spere").unwrap_err().to_string();
    /// assert!(message.starts_with("there is no built-in mesh 'spere'; did you mean 'sphere'?"));
    /// # Ok::<(), glanz_scene::BuiltinError>(())
    /// ```
    ///
    /// # Errors
    /// If there is none of this name.
    pub fn builtin(name: &str) -> Result<Self, BuiltinError> {
        let builtin = Builtin::named(name).ok_or_else(|| BuiltinError::Name { name: name.to_owned() })?;
        builtin.mesh()
    }
}

impl Builtin {
    /// The names of all built-in meshes, as scene files say them.
    pub const NAMES: [&str; 10] =
        ["kite", "quad", "plane", "cube", "sphere", "icosphere", "torus", "cylinder", "cone", "teapot"];

    /// The mesh of this name with the default parameters.
    pub fn named(name: &str) -> Option<Self> {
        Some(match name {
            "kite" => Self::Kite,
            "quad" => Self::Quad,
            "plane" => Self::Plane,
            "cube" => Self::Cube { size: two() },
            "sphere" => Self::Sphere { radius: one(), slices: around(), stacks: along() },
            "icosphere" => Self::Icosphere { radius: one(), subdivisions: splits() },
            "torus" => Self::Torus { major: one(), minor: tube(), segments: around(), sides: along() },
            "cylinder" => Self::Cylinder { radius: one(), height: two(), slices: around(), capped: yes() },
            "cone" => Self::Cone { radius: one(), height: two(), slices: around(), capped: yes() },
            "teapot" => Self::Teapot { tessellation: cuts() },
            _ => return None,
        })
    }

    /// Its name, as scene files say it.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Kite => "kite",
            Self::Quad => "quad",
            Self::Plane => "plane",
            Self::Cube { .. } => "cube",
            Self::Sphere { .. } => "sphere",
            Self::Icosphere { .. } => "icosphere",
            Self::Torus { .. } => "torus",
            Self::Cylinder { .. } => "cylinder",
            Self::Cone { .. } => "cone",
            Self::Teapot { .. } => "teapot",
        }
    }

    /// How many triangles it has; more than any mesh may have where the number overflows.
    pub fn triangle_count(&self) -> u64 {
        let caps = |capped: bool, ends: u64| if capped { ends } else { 0 };
        match *self {
            Self::Kite | Self::Quad | Self::Plane => 2,
            Self::Cube { .. } => 12,
            Self::Sphere { slices, stacks, .. } => {
                (2 * u64::from(slices)).saturating_mul(u64::from(stacks).saturating_sub(1))
            }
            Self::Icosphere { subdivisions, .. } => {
                4_u64.checked_pow(subdivisions).unwrap_or(u64::MAX).saturating_mul(20)
            }
            Self::Torus { segments, sides, .. } => (2 * u64::from(segments)).saturating_mul(u64::from(sides)),
            Self::Cylinder { slices, capped, .. } => u64::from(slices) * (2 + caps(capped, 2)),
            Self::Cone { slices, capped, .. } => u64::from(slices) * (1 + caps(capped, 1)),
            // Of the 32 patches, 8 have one side that is a point.
            Self::Teapot { tessellation: n } => {
                let n = u64::from(n);
                n.saturating_mul(n).saturating_mul(64).saturating_sub(8 * n)
            }
        }
    }

    /// Makes the mesh, or tells which parameter is out of range.
    pub fn mesh(&self) -> Result<Mesh, BuiltinError> {
        self.check()?;
        let mut mesh = match *self {
            Self::Kite => kite::kite(),
            Self::Quad => flat::quad(),
            Self::Plane => flat::plane(),
            Self::Cube { size } => flat::cube(size),
            Self::Sphere { radius, slices, stacks } => round::sphere(radius, slices, stacks),
            Self::Icosphere { radius, subdivisions } => icosphere::icosphere(radius, subdivisions),
            Self::Torus { major, minor, segments, sides } => round::torus(major, minor, segments, sides),
            Self::Cylinder { radius, height, slices, capped } => {
                round::cylinder(radius, height, slices, capped)
            }
            Self::Cone { radius, height, slices, capped } => round::cone(radius, height, slices, capped),
            Self::Teapot { tessellation } => teapot::teapot(tessellation),
        };
        mesh.name = self.name().to_owned();
        Ok(mesh)
    }

    fn check(&self) -> Result<(), BuiltinError> {
        match *self {
            Self::Kite | Self::Quad | Self::Plane => {}
            Self::Cube { size } => self.check_length("size", size)?,
            Self::Sphere { radius, slices, stacks } => {
                self.check_length("radius", radius)?;
                self.check_count("slices", slices, 3)?;
                self.check_count("stacks", stacks, 2)?;
            }
            Self::Icosphere { radius, .. } => self.check_length("radius", radius)?,
            Self::Torus { major, minor, segments, sides } => {
                self.check_length("major", major)?;
                self.check_length("minor", minor)?;
                self.check_count("segments", segments, 3)?;
                self.check_count("sides", sides, 3)?;
                if minor >= major {
                    return Err(BuiltinError::NoHole { minor, major });
                }
            }
            Self::Cylinder { radius, height, slices, .. } | Self::Cone { radius, height, slices, .. } => {
                self.check_length("radius", radius)?;
                self.check_length("height", height)?;
                self.check_count("slices", slices, 3)?;
            }
            Self::Teapot { tessellation } => self.check_count("tessellation", tessellation, 1)?,
        }
        match self.triangle_count() {
            0..=MAX_TRIANGLES => Ok(()),
            triangles => Err(BuiltinError::TooLarge { mesh: self.name(), triangles }),
        }
    }

    fn check_length(&self, parameter: &'static str, found: f64) -> Result<(), BuiltinError> {
        let [least, most] = LENGTHS;
        if (least..=most).contains(&found) {
            Ok(())
        } else {
            Err(BuiltinError::Length { mesh: self.name(), parameter, found, least, most })
        }
    }

    fn check_count(&self, parameter: &'static str, found: u32, least: u32) -> Result<(), BuiltinError> {
        if found >= least {
            Ok(())
        } else {
            Err(BuiltinError::Count { mesh: self.name(), parameter, found, least })
        }
    }
}

fn one() -> f64 {
    1.0
}
fn two() -> f64 {
    2.0
}
fn tube() -> f64 {
    0.35
}
fn around() -> u32 {
    64
}
fn along() -> u32 {
    32
}
fn splits() -> u32 {
    4
}
fn cuts() -> u32 {
    12
}
fn yes() -> bool {
    true
}
