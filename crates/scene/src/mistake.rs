//! Mistakes that are drawn on purpose, so that a class sees what each looks like beside the right picture.
//!
//! All but one are a change of the scene, so that the right picture pays nothing for them: [`Mistake::apply`]. Lengths of
//! interpolated normals are not part of a scene; who draws does that mistake.
//!
//! ```
//! use glanz_scene::{Light, Mistake, Scene};
//!
//! let spot = Light::spot([0.0, 3.0, 0.0], [0.0, -1.0, 0.0], 20.0, [1.0; 3]);
//! let scene = Scene::new().with_light(spot);
//! let (wrong, effect) = Mistake::DegreesAsRadians.apply(&scene);
//! assert!(effect.is_ok() && wrong.lights != scene.lights);
//! assert!(Mistake::NormalMatrix.apply(&scene).1.is_err(), "there is no object");
//! ```

use std::collections::HashMap;

use glam::{DMat3, Vec3};
use glanz_bsdf::models::blinn_phong::BlinnPhong;
use glanz_bsdf::models::lambert::Lambert;
use glanz_bsdf::{DirectionPair, LightTerm, Model, ModelInfo, Shape, Side};
use glanz_math::{Exponent, PI, Real};
use thiserror::Error;

use crate::names::names;
use crate::{Encoding, LightKind, Lobe, Mesh, Normals, Scene, Shading};

names! {
    /// A mistake that is drawn on purpose.
    pub Mistake {
        /// Normals are transformed as positions are, without the inverse transpose.
        NormalMatrix = "normal-matrix",
        /// The cosine of Lambert's law is not clamped at 0: light from behind takes light away.
        Unclamped = "unclamped",
        /// The cutoff of a spot in degrees is given to a cosine that takes radians.
        DegreesAsRadians = "degrees-as-radians",
        /// Linear light is written as it is, without the transfer function of the screen.
        NoGamma = "no-gamma",
        /// The interpolated normal is used with the length that interpolation leaves it.
        UnnormalisedNormal = "unnormalised-normal",
        /// The half vector of Blinn's model is the sum of viewer and light, not divided by its length.
        HalfwayUnnormalised = "halfway-unnormalised",
    } default NormalMatrix
}

/// Why a mistake changes nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("the mistake '{mistake}' changes nothing: {reason}")]
pub struct NoEffect {
    /// The mistake.
    pub mistake: Mistake,
    /// What the scene would have to have.
    pub reason: &'static str,
}

impl Mistake {
    /// The scene with the mistake in it, and whether it changes anything.
    ///
    /// Of `UnnormalisedNormal` the scene stays as it is.
    pub fn apply(self, scene: &Scene) -> (Scene, Result<(), NoEffect>) {
        let mut wrong = scene.clone();
        let (changed, reason) = match self {
            Self::NormalMatrix => {
                (mistake_normals(&mut wrong), "no object is scaled by factors that differ between its axes")
            }
            Self::Unclamped => {
                (unclamp(&mut wrong), "no term is of Lambert's law, or no lamp has a direction")
            }
            Self::DegreesAsRadians => (mistake_cutoffs(&mut wrong), "no light is a spot with a cone"),
            Self::NoGamma => {
                let changed = wrong.render.encoding != Encoding::Raw;
                wrong.render.encoding = Encoding::Raw;
                (changed, "the encoding is raw already")
            }
            Self::UnnormalisedNormal => (
                has_curved_facets(scene),
                "no object has the shading 'phong' and normals that differ between the corners of a facet",
            ),
            Self::HalfwayUnnormalised => (unnormalise_halfway(&mut wrong), "no term is of Blinn's model"),
        };
        (wrong, if changed { Ok(()) } else { Err(NoEffect { mistake: self, reason }) })
    }
}

/// Gives objects that are scaled unevenly normals which the right matrix turns to where the wrong one would: it is
/// (M⁻¹)ᵀ, so that MᵀM n becomes M n.
fn mistake_normals(scene: &mut Scene) -> bool {
    let mut made: HashMap<(usize, [u64; 9]), usize> = HashMap::new();
    let Scene { objects, meshes, .. } = scene;
    for object in objects.iter_mut() {
        let linear = DMat3::from_mat4(object.transform);
        let gram = linear.transpose() * linear;
        if is_even(&gram) {
            continue;
        }
        let key = (object.mesh, gram.to_cols_array().map(f64::to_bits));
        object.mesh = *made.entry(key).or_insert_with(|| {
            meshes.push(with_wrong_normals(&meshes[object.mesh], &gram));
            meshes.len() - 1
        });
    }
    !made.is_empty()
}

/// Whether MᵀM is that of a rotation and one factor.
fn is_even(gram: &DMat3) -> bool {
    let factor = (gram.x_axis.x + gram.y_axis.y + gram.z_axis.z) / 3.0;
    (*gram - DMat3::from_diagonal(glam::DVec3::splat(factor))).abs_diff_eq(DMat3::ZERO, 1e-9 * factor)
}

fn with_wrong_normals(mesh: &Mesh, gram: &DMat3) -> Mesh {
    let mut mesh = mesh.clone().with_normals(Normals::Given);
    for normal in &mut mesh.normals {
        *normal = (*gram * normal.as_dvec3()).try_normalize().map_or(Vec3::Z, |normal| normal.as_vec3());
    }
    mesh
}

/// Adds to each term of Lambert's law one that is negative, for light from behind.
fn unclamp(scene: &mut Scene) -> bool {
    let is_lamp = |kind: &LightKind| {
        matches!(kind, LightKind::Directional { .. } | LightKind::Point { .. } | LightKind::Spot { .. })
    };
    let mut changed = false;
    for material in &mut scene.materials {
        let is_matte = |lobe: &&Lobe| lobe.shape.info().name == Lambert::INFO.name;
        let negative = |lobe: &Lobe| Lobe { shape: Shape::custom(FromBehind), ..lobe.clone() };
        let more: Vec<Lobe> = material.lobes.iter().filter(is_matte).map(negative).collect();
        changed |= !more.is_empty();
        material.lobes.extend(more);
    }
    changed && scene.lights.iter().any(|light| is_lamp(&light.kind))
}

/// Takes the cutoff of spots in degrees for radians.
fn mistake_cutoffs(scene: &mut Scene) -> bool {
    let mut changed = false;
    for light in &mut scene.lights {
        if let LightKind::Spot { cutoff, smooth_edge: None, .. } = &mut light.kind {
            changed |= *cutoff < PI;
            // Only its cosine counts.
            *cutoff = libm::acos(libm::cos(cutoff.to_degrees()));
        }
    }
    changed
}

fn has_curved_facets(scene: &Scene) -> bool {
    let is_curved = |mesh: &Mesh| {
        let mesh = match mesh.normals.is_empty() {
            true => std::borrow::Cow::Owned(mesh.clone().with_normals(Normals::Given)),
            false => std::borrow::Cow::Borrowed(mesh),
        };
        (0..mesh.face_count()).any(|face| {
            let normal = |corner: u32| mesh.normals[corner as usize];
            mesh.face(face).windows(2).any(|pair| normal(pair[0]) != normal(pair[1]))
        })
    };
    scene.objects.iter().any(|object| {
        object.shading.unwrap_or(scene.render.shading) == Shading::Phong
            && is_curved(&scene.meshes[object.mesh])
    })
}

/// Replaces the terms of Blinn's model.
fn unnormalise_halfway(scene: &mut Scene) -> bool {
    let mut changed = false;
    let lobes = scene.materials.iter_mut().flat_map(|material| &mut material.lobes);
    for lobe in lobes {
        let name = lobe.shape.info().name;
        if !matches!(name, "blinn-phong" | "blinn-phong-normalized") {
            continue;
        }
        let shininess = lobe.shape.get("shininess").unwrap_or_default();
        let along_normal = lobe.shape.f_cos(&DirectionPair::isotropic(1.0, 1.0, 1.0));
        lobe.shape = Shape::custom(LongHalfway { exponent: Exponent::new(shininess), factor: along_normal });
        changed = true;
    }
    changed
}

/// Lambert's law where the light is behind the surface.
#[derive(Clone, Debug)]
struct FromBehind;

impl Model for FromBehind {
    const INFO: ModelInfo = ModelInfo {
        name: "lambert-unclamped",
        title: "Lambert's law, not clamped",
        formula: "min(cosθi, 0) / π",
        side: Side::Transmission,
        ..Lambert::INFO
    };
    fn from_params(_: &[f64]) -> Self {
        Self
    }
    fn params(&self) -> Vec<f64> {
        Vec::new()
    }
    #[inline(always)]
    fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        pair.cos_i.min(pair.cos_i.zero()) * pair.cos_i.lit(1.0 / PI)
    }
}

/// Blinn's highlight of a half vector that is the sum of viewer and light.
#[derive(Clone, Debug)]
struct LongHalfway {
    exponent: Exponent,
    factor: f64,
}

impl Model for LongHalfway {
    const INFO: ModelInfo = ModelInfo {
        name: "blinn-phong-halfway-unnormalised",
        title: "Blinn's highlight, the half vector not of length 1",
        formula: "max(n·(v + l), 0)ⁿ",
        params: &[],
        term: LightTerm::Specular,
        ..BlinnPhong::INFO
    };
    fn from_params(_: &[f64]) -> Self {
        Self { exponent: Exponent::new(1.0), factor: 1.0 / PI }
    }
    fn params(&self) -> Vec<f64> {
        Vec::new()
    }
    #[inline(always)]
    fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        let zero = pair.cos_i.zero();
        let cosine = (pair.cos_o + pair.cos_i).max(zero);
        let value = cosine.power(&self.exponent) * zero.lit(self.factor);
        value.select(zero.lt(pair.cos_i), zero)
    }
}

#[cfg(test)]
mod tests {
    use glam::{DMat4, DQuat, DVec3};
    use glanz_color::Rgb;

    use super::*;
    use crate::{ClassicMaterial, Light};

    fn scene() -> Scene {
        let block = ClassicMaterial {
            diffuse: Rgb::gray(0.5).into(),
            specular: Rgb::gray(0.2).into(),
            model: "blinn-phong".to_owned(),
            ..ClassicMaterial::default()
        };
        let mut scene = Scene::new()
            .with_mesh(Mesh::builtin("sphere").unwrap(), block.build("grey").unwrap())
            .with_light(Light::spot([0.0, 0.0, 5.0], [0.0, 0.0, -1.0], 15.0, [1.0; 3]));
        scene.objects[0].transform = DMat4::from_scale_rotation_translation(
            DVec3::new(1.0, 2.0, 3.0),
            DQuat::from_rotation_y(0.4),
            DVec3::X,
        );
        scene
    }

    #[test]
    fn normals_end_where_the_matrix_of_positions_takes_them() {
        let (right, (wrong, effect)) = (scene(), Mistake::NormalMatrix.apply(&scene()));
        assert_eq!(effect, Ok(()));
        let matrix = DMat3::from_mat4(right.objects[0].transform);
        let normal_matrix = matrix.inverse().transpose();
        let (before, after) = (&right.meshes[0].normals, &wrong.meshes[wrong.objects[0].mesh].normals);
        for (before, after) in before.iter().zip(after) {
            let drawn = (normal_matrix * after.as_dvec3()).normalize();
            let mistaken = (matrix * before.as_dvec3()).normalize();
            // Rounding of normals, which are `f32`.
            assert!((drawn - mistaken).length() < 1e-6, "{drawn} {mistaken}");
        }
        assert_eq!(wrong.meshes[0], right.meshes[0], "another object may have it");
    }

    #[test]
    fn a_rotation_and_one_factor_are_no_uneven_scale() {
        let mut scene = scene();
        scene.objects[0].transform =
            DMat4::from_scale_rotation_translation(DVec3::splat(2.5), DQuat::from_rotation_z(1.0), DVec3::Y);
        let (same, effect) = Mistake::NormalMatrix.apply(&scene);
        assert!(effect.is_err() && same == scene);
    }

    #[test]
    fn fifteen_degrees_are_a_cone_of_139() {
        let (wrong, _) = Mistake::DegreesAsRadians.apply(&scene());
        let LightKind::Spot { cutoff, .. } = wrong.lights[0].kind else { panic!("a spot") };
        // cos 15 = −0.7597.
        assert!((cutoff.to_degrees() - 139.437).abs() < 0.001, "{}", cutoff.to_degrees());
    }

    #[test]
    fn the_unclamped_cosine_is_negative_from_behind_and_as_it_was_in_front() {
        let (wrong, _) = Mistake::Unclamped.apply(&scene());
        let sum = |cos_i: f64| -> f64 {
            let pair = DirectionPair::isotropic(1.0, cos_i, cos_i);
            let matte =
                wrong.materials[0].lobes.iter().filter(|lobe| lobe.shape.info().term == LightTerm::Diffuse);
            matte.map(|lobe| lobe.shape.f_cos(&pair)).sum()
        };
        for cos_i in [-1.0, -0.25, 0.0, 0.5, 1.0] {
            assert!((sum(cos_i) - cos_i / PI).abs() < 1e-15, "{cos_i}");
        }
    }

    #[test]
    fn a_long_half_vector_is_the_sum_of_viewer_and_light() {
        let (wrong, _) = Mistake::HalfwayUnnormalised.apply(&scene());
        let shiny = wrong.materials[0].lobes.last().unwrap();
        let value = shiny.shape.f_cos(&DirectionPair::isotropic(0.6, 0.3, 0.1));
        assert!((value * PI / libm::pow(0.9, 32.0) - 1.0).abs() < 1e-9, "{value}");
    }
}
