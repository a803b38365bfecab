//! A vertex while it is read.

use glam::{DVec3, Vec2, Vec3, Vec4};

use super::header::{Role, Scalar};

/// Its attributes, with what stands for missing ones.
pub(super) struct Vertex {
    pub(super) position: DVec3,
    pub(super) normal: Vec3,
    pub(super) color: Vec4,
    pub(super) uv: Vec2,
}

impl Default for Vertex {
    fn default() -> Self {
        Self { position: DVec3::ZERO, normal: Vec3::ZERO, color: Vec4::ONE, uv: Vec2::ZERO }
    }
}

impl Vertex {
    /// Takes one value in.
    pub(super) fn set(&mut self, role: Role, value: f64, scalar: Scalar) {
        let float = value as f32;
        match role {
            Role::Position(axis) => self.position[axis] = value,
            Role::Normal(axis) => self.normal[axis] = float,
            Role::Uv(0) => self.uv.x = float,
            // PLY counts v from the bottom, textures are stored from the top.
            Role::Uv(_) => self.uv.y = 1.0 - float,
            Role::Color(channel) => self.color[channel] = color(channel, value, scalar),
            Role::Corners | Role::CornerUvs => {}
        }
    }

    /// Replaces what is no number, and tells so. Positions stay as they are: what uses them is left out.
    pub(super) fn clean(&mut self, mut tell: impl FnMut(&str)) {
        if !self.normal.is_finite() {
            tell("PLY: normals that are no finite numbers are computed from the faces");
            self.normal = Vec3::ZERO;
        }
        if !self.uv.is_finite() {
            tell("PLY: texture coordinates that are no finite numbers are taken as 0");
            self.uv = Vec2::ZERO;
        }
        if !self.color.is_finite() {
            tell(NO_COLOR);
            self.color = Vec4::ONE;
        }
    }
}

/// What is said of colours that are no numbers.
pub(super) const NO_COLOR: &str = "PLY: colours that are no finite numbers are taken as white";

/// A channel of a colour, the fourth of which is alpha.
pub(super) fn color(channel: usize, value: f64, scalar: Scalar) -> f32 {
    match channel {
        3 => (value / scalar.one()) as f32,
        _ if scalar.is_integer() => glanz_color::srgb_decode((value / scalar.one()).max(0.0) as f32),
        _ => value as f32,
    }
}
