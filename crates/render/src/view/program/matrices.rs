//! The matrices of OpenGL's pipeline, for an object before a camera.

use glam::{DMat3, DMat4, DVec3};
use glanz_scene::Projection;
use glanz_shader::{Role, Space};

use crate::prepare::PreparedObject;
use crate::view::View;

/// The planes between which clip space lies: those that hold the whole scene.
#[derive(Clone, Copy, Debug)]
pub struct DepthRange {
    /// Distance of the nearer plane from the camera, in metres; below 0 behind it.
    pub near: f64,
    /// Distance of the farther one.
    pub far: f64,
    /// Whether distances shrink what is seen.
    pub perspective: bool,
}

/// The farthest plane is at most so many times as far as the nearest.
const MOST_RATIO: f64 = 1e4;

impl DepthRange {
    /// Around the distances of a scene.
    pub(crate) fn new(view: &View, [near, far]: [f32; 2]) -> Self {
        let perspective = matches!(view.projection, Projection::Perspective { .. });
        let far = f64::from(far).max(1e-6) * 1.01;
        let near = match perspective {
            true => (f64::from(near) * 0.99).clamp(far / MOST_RATIO, far * 0.99),
            false if f64::from(near).is_finite() => f64::from(near).min(far) - 0.01 * far,
            false => -far,
        };
        Self { near, far, perspective }
    }

    /// The depth of the CPU's tiles, greater when nearer, from z/w of clip space: a·z/w + b. That is 1/distance, or the
    /// negative distance of parallel projections.
    pub fn depth_of_ndc(&self) -> [f64; 2] {
        let Self { near, far, perspective } = *self;
        match perspective {
            true => [-(far - near) / (2.0 * far * near), (far + near) / (2.0 * far * near)],
            false => [-(far - near) / 2.0, -(far + near) / 2.0],
        }
    }
}

/// What a program may ask for.
pub(crate) struct Matrices {
    model: DMat4,
    view: DMat4,
    projection: DMat4,
    eye: DVec3,
}

impl Matrices {
    pub(crate) fn new(view: &View, range: &DepthRange, object: &PreparedObject) -> Self {
        let [right, up, back] = view.axes.map(DVec3::from_array);
        let eye = DVec3::from_array(view.eye);
        let rotation = DMat3::from_cols(right, up, back).transpose();
        Self {
            model: DMat4::from_cols_array_2d(&object.placement),
            view: DMat4::from_mat3(rotation) * DMat4::from_translation(-eye),
            projection: projection(view, range),
            eye,
        }
    }

    /// The matrix of a role, column by column.
    pub(crate) fn of(&self, role: Role, space: Space) -> Option<[f64; 16]> {
        let matrix = match role {
            Role::Model => self.model,
            Role::View => self.view,
            Role::Projection => self.projection,
            Role::ModelView => self.view * self.model,
            Role::ViewProjection => self.projection * self.view,
            Role::ModelViewProjection => self.projection * self.view * self.model,
            Role::NormalMatrix => self.normal(space),
            _ => return None,
        };
        Some(matrix.to_cols_array())
    }

    /// The inverse transpose of the matrix that brings positions into this space.
    fn normal(&self, space: Space) -> DMat4 {
        let matrix = match space {
            Space::Eye => self.view * self.model,
            Space::World => self.model,
            Space::Object => DMat4::IDENTITY,
        };
        let linear = DMat3::from_mat4(matrix);
        let normal = if linear.determinant() == 0.0 { linear } else { linear.inverse().transpose() };
        DMat4::from_mat3(normal)
    }

    /// The eye in a space.
    pub(crate) fn eye(&self, space: Space) -> [f64; 4] {
        self.point(self.eye, space)
    }

    /// A point of the world in a space.
    pub(crate) fn point(&self, point: DVec3, space: Space) -> [f64; 4] {
        let to = match space {
            Space::World => return point.extend(1.0).to_array(),
            Space::Eye => self.view,
            Space::Object => self.model.inverse(),
        };
        to.transform_point3(point).extend(1.0).to_array()
    }

    /// A direction of the world in a space.
    pub(crate) fn direction(&self, direction: DVec3, space: Space) -> [f64; 4] {
        let to = match space {
            Space::World => return direction.extend(0.0).to_array(),
            Space::Eye => self.view,
            Space::Object => self.model.inverse(),
        };
        to.transform_vector3(direction).normalize_or_zero().extend(0.0).to_array()
    }
}

/// From the eye to clip space, as OpenGL has it: −w ≤ x, y, z ≤ w.
fn projection(view: &View, range: &DepthRange) -> DMat4 {
    let DepthRange { near, far, .. } = *range;
    let per_unit = view.pixels_per_unit();
    let (x, y) = (2.0 * per_unit / f64::from(view.width), 2.0 * per_unit / f64::from(view.height));
    let columns = match range.perspective {
        true => [
            [x, 0.0, 0.0, 0.0],
            [0.0, y, 0.0, 0.0],
            [0.0, 0.0, -(far + near) / (far - near), -1.0],
            [0.0, 0.0, -2.0 * far * near / (far - near), 0.0],
        ],
        false => [
            [x, 0.0, 0.0, 0.0],
            [0.0, y, 0.0, 0.0],
            [0.0, 0.0, -2.0 / (far - near), 0.0],
            [0.0, 0.0, -(far + near) / (far - near), 1.0],
        ],
    };
    DMat4::from_cols_array_2d(&columns)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glanz_scene::Camera;

    #[test]
    fn depths_of_clip_space_are_those_of_the_tiles() {
        let mut camera = Camera::new([1.0, 2.0, 7.0], [0.0; 3]);
        for projected in [Projection::Perspective { fov_y: 0.7 }, Projection::Orthographic { height: 4.0 }] {
            camera.projection = projected;
            let view = View::new(&camera, 320, 200).expect("it can be drawn");
            let range = DepthRange::new(&view, [3.0, 12.0]);
            let object = PreparedObject { placement: DMat4::IDENTITY.to_cols_array_2d(), ..blank() };
            let matrices = Matrices::new(&view, &range, &object);
            let mvp = matrices.of(Role::ModelViewProjection, Space::World).expect("it is a matrix");
            let point = DVec3::new(0.3, -0.4, 0.5);
            let clip = DMat4::from_cols_array(&mvp) * point.extend(1.0);
            let pixels = DMat4::from_cols_array_2d(&view.world_to_pixels()) * point.extend(1.0);
            let [x, y] = [(clip.x / clip.w + 1.0) * 160.0, (1.0 - clip.y / clip.w) * 100.0];
            assert!((x - pixels.x / pixels.w).abs() < 1e-9 && (y - pixels.y / pixels.w).abs() < 1e-9);
            let [a, b] = range.depth_of_ndc();
            let depth = if range.perspective { 1.0 / pixels.z } else { -pixels.z };
            assert!((a * clip.z / clip.w + b - depth).abs() < 1e-9);
        }
    }

    fn blank() -> PreparedObject {
        let scene = glanz_scene::Scene::new().with_mesh(
            glanz_scene::Mesh::builtin("cube").expect("it is listed"),
            glanz_scene::Material::default_gray(),
        );
        let prepared = crate::prepare(&scene, &crate::PrepareOptions::default()).expect("it is whole");
        prepared.objects[0].clone()
    }
}
