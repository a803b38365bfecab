//! Nodes: where meshes, lights and cameras are placed.

use glam::{DMat4, DQuat, DVec3};
use glanz_color::Rgb;
use glanz_color::read::{Place, ReadError, excerpt};

use super::super::model::Model;
use super::json::{self, Node};
use super::pose::Pose;
use super::primitive::Builder;
use super::source::Source;
use crate::read::notes::Notes;
use crate::{Attenuation, Camera, Light, LightColors, LightKind, Object, Projection};

/// Reads the default scene, or all nodes where there is none.
pub(super) fn read(
    source: &Source<'_>,
    builder: &mut Builder<'_>,
    model: &mut Model,
    notes: &mut Notes,
) -> Result<(), ReadError> {
    let nodes = &source.root.nodes;
    // Nodes are a forest: one that is met twice is its own ancestor or has two parents.
    let mut seen = vec![false; nodes.len()];
    let globals = globals(nodes);
    let roots = roots(source, notes)?;
    let mut stack: Vec<(usize, DMat4, Option<usize>)> =
        roots.into_iter().rev().map(|root| (root, DMat4::IDENTITY, None)).collect();
    while let Some((index, parent_transform, parent)) = stack.pop() {
        let place = || match parent {
            Some(parent) => Place::Path(format!("nodes[{parent}].children")),
            None => Place::Path("scenes".to_owned()),
        };
        let node = nodes.get(index).ok_or_else(|| {
            source.malformed(place(), format!("one of {} nodes", nodes.len()), format!("node {index}"))
        })?;
        if std::mem::replace(&mut seen[index], true) {
            let found = format!("node {index}, which is one already");
            return Err(source.malformed(place(), "nodes that are no part of the scene yet", found));
        }
        let transform = parent_transform * local(node);
        if !transform.is_finite() {
            let place = Place::Path(format!("nodes[{index}]"));
            return Err(source.malformed(place, "a finite transform", "one that is not"));
        }
        stack.extend(node.children.iter().rev().map(|&child| (child, transform, Some(index))));
        Visit { source, index, node, transform, globals: &globals }.add(builder, model, notes)?;
    }
    Ok(())
}

/// The nodes at the top.
fn roots(source: &Source<'_>, notes: &mut Notes) -> Result<Vec<usize>, ReadError> {
    let root = source.root;
    if root.scenes.is_empty() {
        let mut is_child = vec![false; root.nodes.len()];
        for &child in root.nodes.iter().flat_map(|node| &node.children) {
            if let Some(flag) = is_child.get_mut(child) {
                *flag = true;
            }
        }
        return Ok((0..root.nodes.len()).filter(|&node| !is_child[node]).collect());
    }
    notes.add_times("glTF: scenes other than the default one are ignored", root.scenes.len() as u64 - 1);
    let index = root.scene.unwrap_or(0);
    root.scenes.get(index).map(|scene| scene.nodes.clone()).ok_or_else(|| {
        let expected = format!("one of {} scenes", root.scenes.len());
        source.malformed(Place::Path("scene".to_owned()), expected, format!("scene {index}"))
    })
}

/// The transforms of all nodes to the world, also of those that the scene does not show. Those of nodes that are
/// their own ancestors are of no use.
fn globals(nodes: &[Node]) -> Vec<DMat4> {
    let mut is_child = vec![false; nodes.len()];
    for &child in nodes.iter().flat_map(|node| &node.children) {
        if let Some(flag) = is_child.get_mut(child) {
            *flag = true;
        }
    }
    let mut globals = vec![None; nodes.len()];
    let mut stack: Vec<(usize, DMat4)> =
        (0..nodes.len()).filter(|&node| !is_child[node]).map(|node| (node, DMat4::IDENTITY)).collect();
    while let Some((index, parent)) = stack.pop() {
        let Some(node) = nodes.get(index).filter(|_| globals[index].is_none()) else { continue };
        let global = parent * local(node);
        globals[index] = Some(global);
        stack.extend(node.children.iter().map(|&child| (child, global)));
    }
    globals.into_iter().map(|global| global.unwrap_or(DMat4::IDENTITY)).collect()
}

/// The transform of a node to its parent.
fn local(node: &Node) -> DMat4 {
    if let Some(matrix) = &node.matrix {
        let mut matrix = DMat4::from_cols_array(matrix);
        // Transforms are affine; what rounding left in the last row is taken out.
        (matrix.x_axis.w, matrix.y_axis.w, matrix.z_axis.w, matrix.w_axis.w) = (0.0, 0.0, 0.0, 1.0);
        return matrix;
    }
    placed(
        node.scale.map_or(DVec3::ONE, DVec3::from),
        node.rotation.map_or(DQuat::IDENTITY, DQuat::from_array),
        node.translation.map_or(DVec3::ZERO, DVec3::from),
    )
}

fn placed(scale: DVec3, rotation: DQuat, translation: DVec3) -> DMat4 {
    // A quaternion of length zero rotates nothing.
    let length = rotation.length();
    let rotation = if length > 0.0 { rotation * (1.0 / length) } else { DQuat::IDENTITY };
    DMat4::from_scale_rotation_translation(scale, rotation, translation)
}

/// A node on the way through the scene.
struct Visit<'a> {
    source: &'a Source<'a>,
    index: usize,
    node: &'a Node,
    /// To the world.
    transform: DMat4,
    /// The same of all nodes.
    globals: &'a [DMat4],
}

impl Visit<'_> {
    fn path(&self, field: &str) -> String {
        format!("nodes[{}].{field}", self.index)
    }

    /// Adds what is at the node.
    fn add(&self, builder: &mut Builder<'_>, model: &mut Model, notes: &mut Notes) -> Result<(), ReadError> {
        if let Some(mesh) = self.node.mesh {
            self.add_objects(mesh, builder, model, notes)?;
        }
        if let Some(camera) = self.node.camera {
            match self.camera(camera) {
                Ok(camera) => self.add_camera(camera, builder, model)?,
                Err(error) => {
                    let note = format!("glTF: a camera is left out ({error})");
                    notes.add_at(&note, Place::Path(self.path("camera")));
                }
            }
        }
        if let Some(light) = &self.node.extensions.light {
            match self.light(light.light, notes) {
                Ok(light) => self.add_light(light, builder, model)?,
                Err(error) => {
                    let note = format!("glTF: a light is left out ({error})");
                    notes.add_at(&note, Place::Path(self.path("extensions.KHR_lights_punctual")));
                }
            }
        }
        Ok(())
    }

    fn add_objects(
        &self,
        mesh: usize,
        builder: &mut Builder<'_>,
        model: &mut Model,
        notes: &mut Notes,
    ) -> Result<(), ReadError> {
        let path = self.path("mesh");
        let pose = self.pose(mesh, notes);
        let is_skinned = pose.as_ref().is_some_and(|pose| pose.joints.is_some());
        let pose = pose.as_ref().map(|pose| (self.index, pose));
        let count = builder.mesh(mesh, pose, &path, notes)?.len() as u64;
        let name = match self.node.name.is_empty() {
            true => &self.source.root.meshes[mesh].name,
            false => &self.node.name,
        };
        let instances = self.instances(notes)?;
        let size = (size_of::<Object>() + name.len()) as u64;
        builder.spend(count * instances.len() as u64 * size, || path.clone())?;
        // Joints bring a mesh to the world by themselves.
        let transform = if is_skinned { DMat4::IDENTITY } else { self.transform };
        for instance in instances {
            model.objects.extend(builder.mesh(mesh, pose, &path, notes)?.iter().map(|&(mesh, material)| {
                Object {
                    name: name.clone(),
                    mesh,
                    material,
                    transform: transform * instance,
                    shading: None,
                    interpolation: None,
                    program: None,
                }
            }));
        }
        Ok(())
    }

    /// How the node poses its mesh, if it does so differently from others. A skin that cannot be read is left out.
    fn pose(&self, mesh: usize, notes: &mut Notes) -> Option<Pose> {
        let source = self.source;
        let joints = self.node.skin.and_then(|skin| {
            let path = self.path("skin");
            let skins = &source.root.skins;
            let joints = match skins.get(skin) {
                Some(skin) => Pose::joints(source, skin, self.globals, &path),
                None => {
                    let expected = format!("one of {} skins", skins.len());
                    Err(source.malformed(Place::Path(path.clone()), expected, format!("skin {skin}")))
                }
            };
            joints
                .map_err(|error| {
                    notes.add_at(&format!("glTF: a skin is left out ({error})"), Place::Path(path))
                })
                .ok()
        });
        let own = &self.node.weights;
        let weights = || source.root.meshes.get(mesh).map(|mesh| mesh.weights.clone()).unwrap_or_default();
        (joints.is_some() || own.is_some())
            .then(|| Pose { weights: own.clone().unwrap_or_else(weights), joints })
    }

    /// From each instance of the node's mesh to the node: one, or as many as `EXT_mesh_gpu_instancing` has.
    fn instances(&self, notes: &mut Notes) -> Result<Vec<DMat4>, ReadError> {
        let Some(instancing) = &self.node.extensions.instancing else { return Ok(vec![DMat4::IDENTITY]) };
        let path = self.path("extensions.EXT_mesh_gpu_instancing");
        let (attributes, source) = (&instancing.attributes, self.source);
        let count = match attributes.values().next() {
            Some(&accessor) => source.count(accessor, &path)?,
            None => return Ok(vec![DMat4::IDENTITY]),
        };
        let missing = |name| attributes.get(name).is_none();
        let translations = match missing("TRANSLATION") {
            true => vec![[0.0; 3]; count],
            false => source.floats::<3>(attributes["TRANSLATION"], &["VEC3"], None, &path)?,
        };
        let rotations = match missing("ROTATION") {
            true => vec![[0.0, 0.0, 0.0, 1.0]; count],
            false => source.floats::<4>(attributes["ROTATION"], &["VEC4"], None, &path)?,
        };
        let scales = match missing("SCALE") {
            true => vec![[1.0; 3]; count],
            false => source.floats::<3>(attributes["SCALE"], &["VEC3"], None, &path)?,
        };
        let instances =
            translations.into_iter().zip(rotations).zip(scales).map(|((move_by, turn), scale)| {
                let turn = DQuat::from_array(turn.map(f64::from));
                placed(scale.map(f64::from).into(), turn, move_by.map(f64::from).into())
            });
        let (finite, odd): (Vec<_>, Vec<_>) = instances.partition(DMat4::is_finite);
        notes.add_times(
            "glTF: instances that are not placed by finite numbers are left out",
            odd.len() as u64,
        );
        Ok(finite)
    }

    /// The direction in the world that the node looks along.
    fn forward(&self, field: &str) -> Result<DVec3, ReadError> {
        self.transform.transform_vector3(DVec3::NEG_Z).try_normalize().ok_or_else(|| {
            let place = Place::Path(self.path(field));
            self.source.malformed(place, "a node that is not scaled to nothing", "one that is")
        })
    }

    fn add_camera(
        &self,
        camera: (String, Camera),
        builder: &mut Builder<'_>,
        model: &mut Model,
    ) -> Result<(), ReadError> {
        builder.spend((size_of::<Camera>() + camera.0.len()) as u64, || self.path("camera"))?;
        model.cameras.push(camera);
        Ok(())
    }

    /// The camera at the node, with its name.
    fn camera(&self, index: usize) -> Result<(String, Camera), ReadError> {
        let source = self.source;
        let camera = source.root.cameras.get(index).ok_or_else(|| {
            let expected = format!("one of {} cameras", source.root.cameras.len());
            source.malformed(Place::Path(self.path("camera")), expected, format!("camera {index}"))
        })?;
        let projection = projection(camera).ok_or_else(|| {
            let least = Projection::FOV_MARGIN;
            let expected = format!(
                "a perspective with a yfov above {least} and below π - {least}, or an orthographic with a ymag"
            );
            let found = match &camera.perspective {
                Some(perspective) => format!("a yfov of {}", perspective.yfov),
                None => "neither".to_owned(),
            };
            source.malformed(Place::Path(format!("cameras[{index}]")), expected, found)
        })?;
        let eye = self.transform.w_axis.truncate();
        let target = eye + self.forward("camera")?;
        if target == eye {
            let (expected, place) = ("a camera nearer to the origin", Place::Path(self.path("camera")));
            return Err(source.malformed(place, expected, "one whose direction is lost in rounding"));
        }
        let up = self.transform.transform_vector3(DVec3::Y).try_normalize().unwrap_or(DVec3::Y);
        let name = if camera.name.is_empty() { &self.node.name } else { &camera.name };
        Ok((name.clone(), Camera { eye, target, up, projection }))
    }

    fn add_light(&self, light: Light, builder: &mut Builder<'_>, model: &mut Model) -> Result<(), ReadError> {
        builder.spend((size_of::<Light>() + light.name.len()) as u64, || self.path("extensions"))?;
        model.lights.push(light);
        Ok(())
    }

    /// The light at the node.
    fn light(&self, index: usize, notes: &mut Notes) -> Result<Light, ReadError> {
        let source = self.source;
        let lights = &source.root.extensions.lights.lights;
        let light = lights.get(index).ok_or_else(|| {
            let expected = format!("one of {} lights", lights.len());
            let place = self.path("extensions.KHR_lights_punctual.light");
            source.malformed(Place::Path(place), expected, format!("light {index}"))
        })?;
        let wrong = |expected: &str, found: String| {
            let place = format!("extensions.KHR_lights_punctual.lights[{index}]");
            source.malformed(Place::Path(place), expected, found)
        };
        let kind = self.light_kind(light, wrong)?;
        let strength = light.intensity.unwrap_or(1.0) / std::f64::consts::PI;
        let color = light.color.unwrap_or([1.0; 3]).map(|channel| (channel * strength) as f32);
        if !color.iter().all(|channel| channel.is_finite() && *channel >= 0.0) {
            return Err(wrong("a colour and an intensity from 0 on", format!("{color:?}")));
        }
        notes.add_times("glTF: ranges of lights are ignored", u64::from(light.range.is_some()));
        let name = if light.name.is_empty() { &self.node.name } else { &light.name };
        let colors = LightColors::direct(Rgb(color));
        Ok(Light { name: name.clone(), ..Light::new(kind, colors) })
    }

    /// The geometry of a light at the node.
    fn light_kind(
        &self,
        light: &json::Light,
        wrong: impl Fn(&str, String) -> ReadError,
    ) -> Result<LightKind, ReadError> {
        let position = self.transform.w_axis.truncate();
        let (direction, attenuation) = (self.forward("light")?, Attenuation::PHYSICAL);
        Ok(match light.kind.as_str() {
            "directional" => LightKind::Directional { direction },
            "point" => LightKind::Point { position, attenuation },
            "spot" => {
                let (inner, outer) = cone(light)
                    .ok_or_else(|| wrong("cone angles with 0 ≤ inner < outer ≤ π/2", "others".to_owned()))?;
                let smooth_edge = Some((libm::cos(inner), libm::cos(outer)));
                LightKind::Spot {
                    position,
                    direction,
                    cutoff: outer,
                    exponent: 0.0,
                    smooth_edge,
                    attenuation,
                }
            }
            other => {
                let found = excerpt(other);
                return Err(wrong("the type directional, point or spot", found));
            }
        })
    }
}

/// The cone's inner and outer half angle, in radians.
fn cone(light: &json::Light) -> Option<(f64, f64)> {
    let spot = light.spot.as_ref();
    let inner = spot.map_or(0.0, |spot| spot.inner_cone_angle);
    let outer = spot.and_then(|spot| spot.outer_cone_angle).unwrap_or(std::f64::consts::FRAC_PI_4);
    // Exporters round π/2 in single precision, upwards.
    let right_angle = f64::from(std::f32::consts::FRAC_PI_2);
    (0.0 <= inner && inner < outer && outer <= right_angle).then_some((inner, outer))
}

fn projection(camera: &json::Camera) -> Option<Projection> {
    match (camera.kind.as_str(), &camera.perspective, &camera.orthographic) {
        ("perspective", Some(perspective), _) => {
            let (fov_y, least) = (perspective.yfov, Projection::FOV_MARGIN);
            (least < fov_y && fov_y < std::f64::consts::PI - least)
                .then_some(Projection::Perspective { fov_y })
        }
        ("orthographic", _, Some(orthographic)) => {
            let height = 2.0 * orthographic.ymag.abs();
            (height > 0.0 && height.is_finite()).then_some(Projection::Orthographic { height })
        }
        _ => None,
    }
}
