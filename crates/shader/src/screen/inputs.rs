//! What the inputs of a fragment shader are when no mesh is there: a square over the whole picture.

use crate::{Port, Role, Scalar, attribute_role};

/// Where an input comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Source {
    /// `gl_FragCoord`.
    FragCoord,
    /// 0 … 1 over the picture.
    Unit,
    /// −1 … 1 over the picture, z is 0, w is 1.
    Position,
    /// The same for all pixels.
    Constant([f32; 4]),
    /// Nobody says; 0.
    Nothing,
}

impl Source {
    pub(super) fn of(port: &Port) -> Self {
        if port.builtin {
            return match port.name.as_str() {
                "gl_FragCoord" => Self::FragCoord,
                "gl_PointCoord" => Self::Unit,
                "gl_FrontFacing" | "gl_SampleMask" => Self::Constant([1.0; 4]),
                _ => Self::Constant([0.0; 4]),
            };
        }
        let name = port.name.rsplit('.').next().unwrap_or(&port.name);
        let is_unit = name.to_lowercase().contains("uv") || name.to_lowercase().contains("texcoord");
        match attribute_role(name, port.ty) {
            _ if port.ty.scalar != Scalar::Float || port.ty.columns != 1 => Self::Nothing,
            Some(Role::TexCoord) => Self::Unit,
            Some(Role::Position) => Self::Position,
            Some(Role::Normal) => Self::Constant([0.0, 0.0, 1.0, 0.0]),
            Some(Role::Tangent) => Self::Constant([1.0, 0.0, 0.0, 1.0]),
            Some(Role::Bitangent) => Self::Constant([0.0, 1.0, 0.0, 0.0]),
            Some(Role::Color) => Self::Constant([1.0; 4]),
            _ if name.starts_with("gl_TexCoord") || is_unit => Self::Unit,
            _ if port.ty.rows == 2 => Self::Unit,
            _ => Self::Nothing,
        }
    }

    /// A component at a place, in pixels from the corner from which the program counts.
    pub(super) fn value(&self, component: usize, at: [f32; 2], size: [u32; 2], from_top: bool) -> f32 {
        let part = |axis: usize| at[axis] / size[axis] as f32;
        match (self, component) {
            (Self::FragCoord, axis @ 0..2) => at[axis],
            (Self::FragCoord, 2) => 0.5,
            (Self::FragCoord, _) => 1.0,
            (Self::Unit, axis @ 0..2) => part(axis),
            (Self::Position, axis @ 0..2) => {
                let value = part(axis) * 2.0 - 1.0;
                if axis == 1 && from_top { -value } else { value }
            }
            (Self::Unit | Self::Position, component) => f32::from(u8::from(component == 3)),
            (Self::Constant(values), component) => values.get(component).copied().unwrap_or(0.0),
            (Self::Nothing, _) => 0.0,
        }
    }
}
