//! Vertices in the pose of the file: morph targets with their default weights, skins where their joints are.

use std::collections::BTreeMap;

use glam::{DMat3, DMat4, DVec3, Vec3};
use glanz_color::read::{Place, ReadError};

use super::json::{Primitive, Skin};
use super::source::Source;
use crate::Mesh;

/// How the vertices of a mesh are moved.
#[derive(Default)]
pub(super) struct Pose {
    /// How much of each morph target there is.
    pub(super) weights: Vec<f64>,
    /// From the mesh as it was bound to the world, for each joint of its skin.
    pub(super) joints: Option<Vec<DMat4>>,
}

impl Pose {
    /// The joints of a skin, by the transforms of all nodes to the world.
    pub(super) fn joints(
        source: &Source<'_>,
        skin: &Skin,
        globals: &[DMat4],
        user: &str,
    ) -> Result<Vec<DMat4>, ReadError> {
        let inverse = match skin.inverse_bind_matrices {
            Some(accessor) => source.floats::<16>(accessor, &["MAT4"], None, user)?,
            None => vec![DMat4::IDENTITY.as_mat4().to_cols_array(); skin.joints.len()],
        };
        let wrong = |found: String| {
            let expected = "joints that are nodes, with a finite inverse bind matrix each";
            source.malformed(Place::Path(user.to_owned()), expected, found)
        };
        if inverse.len() < skin.joints.len() {
            return Err(wrong(format!("{} matrices for {} joints", inverse.len(), skin.joints.len())));
        }
        let joints = skin.joints.iter().zip(inverse).map(|(&joint, inverse)| {
            let global = globals.get(joint).ok_or_else(|| wrong(format!("node {joint}")))?;
            let matrix = *global * DMat4::from_cols_array(&inverse.map(f64::from));
            matrix.is_finite().then_some(matrix).ok_or_else(|| wrong("others".to_owned()))
        });
        joints.collect()
    }

    /// Moves the vertices of a primitive, all or those that `pick` names.
    pub(super) fn apply(
        &self,
        source: &Source<'_>,
        primitive: &Primitive,
        pick: Option<&[u32]>,
        path: &str,
        mesh: &mut Mesh,
    ) -> Result<(), ReadError> {
        for (number, (target, &weight)) in primitive.targets.iter().zip(&self.weights).enumerate() {
            if weight != 0.0 {
                morph(source, target, weight, pick, &format!("{path}.targets[{number}]"), mesh)?;
            }
        }
        let Some(joints) = &self.joints else { return Ok(()) };
        let matrices = vertex_matrices(source, primitive, joints, pick, path, mesh.positions.len())?;
        for (vertex, matrix) in matrices.into_iter().enumerate() {
            skin(mesh, vertex, &matrix);
        }
        Ok(())
    }
}

/// Adds a morph target.
fn morph(
    source: &Source<'_>,
    target: &BTreeMap<String, usize>,
    weight: f64,
    pick: Option<&[u32]>,
    path: &str,
    mesh: &mut Mesh,
) -> Result<(), ReadError> {
    let moves = |name: &str, count: usize| -> Result<Vec<Vec3>, ReadError> {
        let Some(&accessor) = target.get(name) else { return Ok(Vec::new()) };
        let user = format!("{path}.{name}");
        let moves = source.floats::<3>(accessor, &["VEC3"], pick, &user)?;
        source.budget.spend(size_of_val(&moves[..]) as u64, source.file, || user.clone())?;
        if moves.len() != count {
            let expected = format!("{count} items, as there are positions");
            return Err(source.malformed(Place::Path(user), expected, moves.len().to_string()));
        }
        Ok(moves.into_iter().map(|by| (DVec3::from(by.map(f64::from)) * weight).as_vec3()).collect())
    };
    let count = mesh.positions.len();
    let [positions, normals, tangents] =
        [moves("POSITION", count)?, moves("NORMAL", count)?, moves("TANGENT", count)?];
    mesh.positions.iter_mut().zip(positions).for_each(|(position, by)| *position += by);
    mesh.normals.iter_mut().zip(normals).for_each(|(normal, by)| *normal += by);
    mesh.tangents.iter_mut().zip(tangents).for_each(|(tangent, by)| *tangent += by.extend(0.0));
    Ok(())
}

/// For each vertex the mean of its joints.
fn vertex_matrices(
    source: &Source<'_>,
    primitive: &Primitive,
    joints: &[DMat4],
    pick: Option<&[u32]>,
    path: &str,
    count: usize,
) -> Result<Vec<DMat4>, ReadError> {
    let mut sums = vec![(DMat4::ZERO, 0.0); count];
    for set in 0.. {
        let names = [format!("JOINTS_{set}"), format!("WEIGHTS_{set}")];
        let [Some(&numbers), Some(&weights)] = names.each_ref().map(|name| primitive.attributes.get(name))
        else {
            break;
        };
        let user = format!("{path}.attributes.{}", names[0]);
        let numbers = source.floats::<4>(numbers, &["VEC4"], pick, &user)?;
        let weights = source.floats::<4>(weights, &["VEC4"], pick, &user)?;
        let wrong = |found: String| {
            let expected = format!("{count} weights of {} joints", joints.len());
            source.malformed(Place::Path(user.clone()), expected, found)
        };
        if numbers.len() != count || weights.len() != count {
            return Err(wrong(format!("{} joints and {} weights", numbers.len(), weights.len())));
        }
        for ((sum, total), (numbers, weights)) in sums.iter_mut().zip(numbers.into_iter().zip(weights)) {
            for (number, weight) in numbers.into_iter().zip(weights).filter(|(_, weight)| *weight > 0.0) {
                let joint = joints.get(number as usize).ok_or_else(|| wrong(format!("joint {number}")))?;
                *sum += *joint * f64::from(weight);
                *total += f64::from(weight);
            }
        }
    }
    let mean = |(sum, total): (DMat4, f64)| if total > 0.0 { sum * (1.0 / total) } else { joints[0] };
    if joints.is_empty() {
        return Ok(Vec::new());
    }
    Ok(sums.into_iter().map(mean).collect())
}

/// Moves a vertex.
fn skin(mesh: &mut Mesh, vertex: usize, matrix: &DMat4) {
    let position = &mut mesh.positions[vertex];
    *position = matrix.transform_point3(position.as_dvec3()).as_vec3();
    let linear = DMat3::from_mat4(*matrix);
    if let Some(normal) = mesh.normals.get_mut(vertex) {
        // The cofactors turn normals as the inverse transpose does, and exist without an inverse.
        let cofactors = DMat3::from_cols(
            linear.y_axis.cross(linear.z_axis),
            linear.z_axis.cross(linear.x_axis),
            linear.x_axis.cross(linear.y_axis),
        );
        let sign = if linear.determinant() < 0.0 { -1.0 } else { 1.0 };
        *normal = (cofactors * normal.as_dvec3() * sign).normalize_or_zero().as_vec3();
    }
    if let Some(tangent) = mesh.tangents.get_mut(vertex) {
        let along = (linear * tangent.truncate().as_dvec3()).normalize_or_zero().as_vec3();
        *tangent = along.extend(tangent.w);
    }
}
