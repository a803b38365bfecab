//! The matrices that a vertex shader gets, as numbers.

use std::fmt::Write;

use glam::{DMat3, DMat4};
use glanz_math::names::shown;
use glanz_plot::number;
use glanz_scene::{Camera, Object, Projection, Scene};
use schemars::JsonSchema;
use serde::Serialize;

/// The most objects whose matrices are printed for people; JSON has all.
const MOST_OBJECTS: usize = 20;
/// The planes where nothing lies before the camera.
const IN_FRONT_OF_NOTHING: [f64; 2] = [0.1, 100.0];
/// Numbers below this part of a matrix' greatest are the rounding of 0.
const ROUNDING: f64 = 1e-14;

/// The matrices of a scene, each as rows, for columns of coordinates.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct MatrixTables {
    /// From world to camera coordinates: x right, y up, z backwards
    view: [[f64; 4]; 4],
    /// From camera to OpenGL's clip coordinates; Glanz has no planes near and far, these lie about the objects
    projection: [[f64; 4]; 4],
    /// The distances of those planes in m
    near_far: [f64; 2],
    /// In the order of the scene
    objects: Vec<ObjectMatrices>,
}

#[derive(Debug, Serialize, JsonSchema)]
struct ObjectMatrices {
    name: String,
    /// M, from the mesh's coordinates to the world
    model: [[f64; 4]; 4],
    /// (M⁻¹)ᵀ of its upper left part, which turns normals into the world; null where M cannot be inverted
    normal: Option<[[f64; 3]; 3]>,
    /// V M, from the mesh's coordinates to those of the camera
    model_view: [[f64; 4]; 4],
    /// ((V M)⁻¹)ᵀ, GLSL's old gl_NormalMatrix
    model_view_normal: Option<[[f64; 3]; 3]>,
}

impl MatrixTables {
    /// Those of a scene, seen by its camera.
    pub(super) fn of(scene: &Scene) -> Self {
        let aspect = f64::from(scene.image.width) / f64::from(scene.image.height);
        let camera = scene.camera_or_framing(aspect);
        let (view, near_far) = (camera.view_matrix(), near_far(scene, &camera));
        let object = |object: &Object| {
            let model_view = view * object.transform;
            ObjectMatrices {
                name: object.name.clone(),
                model: rows(object.transform),
                normal: normal_matrix(object.transform),
                model_view: rows(model_view),
                model_view_normal: normal_matrix(model_view),
            }
        };
        Self {
            view: rows(view),
            projection: rows(camera.projection_matrix(aspect, near_far)),
            near_far,
            objects: scene.objects.iter().map(object).collect(),
        }
    }

    /// For people.
    pub(super) fn text(&self) -> String {
        let [near, far] = self.near_far.map(number);
        let mut text = String::from("  matrices, for columns of coordinates\n");
        matrix(&mut text, "V, from the world to the camera", &self.view);
        matrix(&mut text, &format!("P, to clip coordinates, near {near} m, far {far} m"), &self.projection);
        for object in self.objects.iter().take(MOST_OBJECTS) {
            let name = if object.name.is_empty() { "(unnamed)" } else { &*shown(&object.name) };
            matrix(&mut text, &format!("M of {name}, from its mesh to the world"), &object.model);
            maybe(&mut text, &format!("N of {name} = (M⁻¹)ᵀ, for normals"), object.normal.as_ref());
            matrix(&mut text, &format!("V M of {name}"), &object.model_view);
            maybe(&mut text, &format!("((V M)⁻¹)ᵀ of {name}"), object.model_view_normal.as_ref());
        }
        if self.objects.len() > MOST_OBJECTS {
            let more = self.objects.len() - MOST_OBJECTS;
            writeln!(text, "    and those of {more} more objects; --format json has all")
                .expect("a string takes everything");
        }
        text
    }
}

/// Distances of planes between which all objects lie, with a little room.
fn near_far(scene: &Scene, camera: &Camera) -> [f64; 2] {
    let bounds = scene.bounds();
    let back = camera.axes()[2];
    let corner = |i: usize| {
        let side = |bit: usize, low: f64, high: f64| if i >> bit & 1 == 0 { low } else { high };
        let (min, max) = (bounds.min, bounds.max);
        let at = [side(0, min.x, max.x), side(1, min.y, max.y), side(2, min.z, max.z)];
        back.dot(camera.eye - glam::DVec3::from_array(at))
    };
    let (nearest, farthest) =
        (0..8).map(corner).fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), distance| {
            (least.min(distance), most.max(distance))
        });
    let is_parallel = matches!(camera.projection, Projection::Orthographic { .. });
    match () {
        () if bounds.is_empty() || !is_parallel && farthest <= 0.0 => IN_FRONT_OF_NOTHING,
        // Parallel rays see behind the eye, too.
        () if is_parallel => {
            let room = 0.1 * (farthest - nearest).max(1e-3);
            [nearest - room, farthest + room]
        }
        () => [nearest.max(1e-3 * farthest) * 0.9, farthest * 1.1],
    }
}

fn rows(matrix: DMat4) -> [[f64; 4]; 4] {
    clean(matrix.transpose().to_cols_array_2d())
}

fn normal_matrix(model: DMat4) -> Option<[[f64; 3]; 3]> {
    let linear = DMat3::from_mat4(model);
    // The transpose of the inverse, and of that the rows.
    (linear.determinant() != 0.0).then(|| clean(linear.inverse().to_cols_array_2d()))
}

/// With 0 in place of its rounding.
fn clean<const N: usize>(matrix: [[f64; N]; N]) -> [[f64; N]; N] {
    let most = matrix.as_flattened().iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    matrix.map(|row| row.map(|value| if value.abs() <= most * ROUNDING { 0.0 } else { value }))
}

fn maybe<const N: usize>(text: &mut String, title: &str, rows: Option<&[[f64; N]; N]>) {
    match rows {
        Some(rows) => matrix(text, title, rows),
        None => writeln!(text, "    {title}: none, M cannot be inverted").expect("a string takes everything"),
    }
}

/// A title, and a line for each row.
fn matrix<const N: usize>(text: &mut String, title: &str, rows: &[[f64; N]; N]) {
    writeln!(text, "    {title}").expect("a string takes everything");
    for row in rows {
        let line: String = row.iter().map(|value| format!(" {:>12}", number(*value))).collect();
        writeln!(text, "    {line}").expect("a string takes everything");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normals_stay_perpendicular_under_a_scale_that_is_not_uniform() {
        let model = DMat4::from_scale(glam::DVec3::new(1.0, 1.0, 3.0)) * DMat4::from_rotation_y(0.7);
        let rows = normal_matrix(model).unwrap().map(glam::DVec3::from_array);
        let turned = |n: glam::DVec3| glam::DVec3::from_array(rows.map(|row| row.dot(n)));
        let (normal, along) = (glam::DVec3::new(0.3, -0.2, 0.9), glam::DVec3::new(2.0, 3.0, 0.0));
        assert!(normal.dot(along).abs() < 1e-12);
        assert!(turned(normal).dot(model.transform_vector3(along)).abs() < 1e-12);
        assert_eq!(normal_matrix(DMat4::from_scale(glam::DVec3::new(1.0, 0.0, 1.0))), None);
    }

    #[test]
    fn all_objects_lie_between_the_planes() {
        let gold = glanz_scene::library::material("gold").unwrap();
        let scene = Scene::new().with_mesh(glanz_scene::Mesh::builtin("sphere").unwrap(), gold);
        let behind = Scene { camera: Some(Camera::new([0.0, 0.0, -3.0], [0.0, 0.0, -9.0])), ..scene.clone() };
        assert_eq!(MatrixTables::of(&behind).near_far, IN_FRONT_OF_NOTHING);
        let within = Camera::new([0.0; 3], [0.0, 0.0, -1.0]).orthographic(3.0);
        for scene in [Scene { camera: Some(within), ..scene.clone() }, scene] {
            all_are_in_view(&scene);
        }
    }

    fn all_are_in_view(scene: &Scene) {
        let tables = MatrixTables::of(scene);
        let clip = DMat4::from_cols_array_2d(&tables.projection).transpose()
            * DMat4::from_cols_array_2d(&tables.view).transpose();
        for position in &scene.meshes[0].positions {
            let at = clip.project_point3(position.as_dvec3());
            assert!(at.abs().max_element() <= 1.0, "{at}");
        }
        assert!(tables.text().contains("N of"));
    }
}
