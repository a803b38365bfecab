//! A material under one light, as numbers: its BRDF in X, Y and Z.

use glanz_bsdf::{DirectionPair, LayerWeight, Shape, Side};
use glanz_color::{Observer, ObserverKind, Spectrum};
use glanz_math::Vec3;
use glanz_scene::{ColorMode, Light, LightColor, Lobe, Material, Metalness, RoughnessMap, Scene, Tint};

use crate::prepare::{Observation, PrepareError, PrepareOptions, PreparedMaterial, TintCoordinate, prepare};

/// What a material reflects of a light, for an observer: all that a picture has of it, re-radiation, layers and tints by
/// angle, without one being drawn.
///
/// Textures count as 1, and what is no reflection of light with a direction (ambient terms, light of its own, transmission,
/// perfect mirrors but for [`MaterialResponse::mirror`]) as nothing.
///
/// ```
/// use glanz_color::{Observer, light};
/// use glanz_math::Vec3;
/// use glanz_render::MaterialResponse;
/// use glanz_scene::library;
///
/// let d65 = MaterialResponse::new(&library::material("paper-white")?, &light("D65")?, &Observer::default())?;
/// let (wi, wo) = (Vec3::from_angles(0.8, 0.0), Vec3::from_angles(0.0, 0.0));
/// let [_, y, _] = d65.brdf(wi, wo).map(|value| value * std::f64::consts::PI);
/// assert!((0.6..0.9).contains(&y), "white paper reflects most of the light");
/// assert!((d65.white()[1] - 1.0).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct MaterialResponse {
    material: PreparedMaterial,
    /// What divides the channels.
    scale: f64,
    white: [f64; 3],
}

impl MaterialResponse {
    /// A material under a light, on the scale on which the perfect diffuser has Y = 1.
    ///
    /// # Errors
    /// For an observer without X, Y and Z, a light that it does not see, and what [`prepare`] refuses.
    pub fn new(material: &Material, light: &Spectrum, observer: &Observer) -> Result<Self, PrepareError> {
        if observer.kind != ObserverKind::Xyz {
            return Err(PrepareError::Scene {
                what: format!("the observer '{}' has no X, Y and Z", observer.name),
            });
        }
        let unseen = || PrepareError::Scene {
            what: format!("the light has nothing that the observer '{}' sees", observer.name),
        };
        let lamp = LightColor::unit(light).ok_or_else(unseen)?;
        let white = Self { material: prepared(&diffuser(), &lamp, observer)?, scale: 1.0, white: [0.0; 3] };
        let up = Vec3::from_angles(0.0, 0.0);
        let seen = white.brdf(up, up).map(|value| value * core::f64::consts::PI);
        if seen[1].is_nan() || seen[1] <= 0.0 {
            return Err(unseen());
        }
        let scale = seen[1];
        Ok(Self {
            material: prepared(material, &lamp, observer)?,
            scale,
            white: seen.map(|value| value / scale),
        })
    }

    /// X, Y and Z of the perfect diffuser; Y is 1.
    pub fn white(&self) -> [f64; 3] {
        self.white
    }

    /// Whether it has a perfect mirror, which no pair of directions shows.
    pub fn has_mirror(&self) -> bool {
        let infos = self.material.lobes.iter().map(|lobe| lobe.shape.info());
        infos.into_iter().any(|info| info.delta && info.side == Side::Reflection)
    }

    /// The BRDF in 1/sr, in X, Y and Z: 1/π of [`white`](Self::white) for the perfect diffuser. Directions point away from the
    /// surface, whose normal is z and whose tangent is x. 0 below the horizon.
    pub fn brdf(&self, wi: Vec3<f64>, wo: Vec3<f64>) -> [f64; 3] {
        if wi.z <= 0.0 || wo.z <= 0.0 {
            return [0.0; 3];
        }
        let [sin, cos] = self.material.aniso;
        let turned = |w: Vec3<f64>| Vec3::new(w.x * cos + w.y * sin, w.y * cos - w.x * sin, w.z);
        let pair = DirectionPair::new(turned(wo), turned(wi));
        self.sum(&pair, |shape| shape.f_cos(&pair) / wi.z)
    }

    /// The part of light at an angle from the normal that perfect mirrors reflect, in X, Y and Z: [`white`](Self::white) of one
    /// that reflects all. It is a part of the light, not a BRDF, which is without bounds in that direction.
    ///
    /// ```
    /// use glanz_color::{Observer, light};
    /// use glanz_render::MaterialResponse;
    /// use glanz_scene::library;
    ///
    /// let pane = MaterialResponse::new(&library::material("glass-solid")?, &light("D65")?, &Observer::default())?;
    /// let [_, y, _] = pane.mirror(0.0);
    /// assert!((0.035..0.06).contains(&y), "glass reflects 4 % along the normal");
    /// assert!(pane.mirror(80.0_f64.to_radians())[1] > 5.0 * y);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn mirror(&self, theta: f64) -> [f64; 3] {
        let [sin, cos] = self.material.aniso;
        let wo = Vec3::from_angles(theta, 0.0);
        let turned = |x: f64| Vec3::new(x * cos, -x * sin, wo.z);
        let pair = DirectionPair::new(turned(wo.x), turned(-wo.x));
        let is_mirror = |shape: &Shape| shape.info().delta && shape.info().side == Side::Reflection;
        self.sum(&pair, |shape| if is_mirror(shape) { 1.0 } else { 0.0 })
    }

    /// The sum over lobes of a value of each, with its tint and what lies above it.
    fn sum(&self, pair: &DirectionPair<f64>, of: impl Fn(&Shape) -> f64) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for (index, lobe) in self.material.lobes.iter().enumerate() {
            let mut value = of(&lobe.shape) / self.scale;
            for layer in &lobe.layers {
                value *= layer.factor(pair);
            }
            value *= match lobe.metalness {
                Metalness::Any => 1.0,
                Metalness::Metal { factor } => factor,
                Metalness::Dielectric { factor } => 1.0 - factor,
            };
            let tint = match lobe.coordinate {
                TintCoordinate::None => self.material.tints[index],
                coordinate => self.material.series[index].at(coordinate.at(&lobe.shape, pair) as f32),
            };
            sum.iter_mut().zip(tint).for_each(|(sum, tint)| *sum += value * f64::from(tint));
        }
        sum
    }
}

/// A surface that reflects all light, alike into all directions.
fn diffuser() -> Material {
    let lambert = Shape::named("lambert", &[]).expect("the list of models has it");
    Material::of_lobes("white", vec![Lobe::new(lambert, Tint::Spectrum(std::sync::Arc::new(Spectrum::ONE)))])
}

/// The material's rows of the tint table for this light alone.
fn prepared(
    material: &Material,
    lamp: &LightColor,
    observer: &Observer,
) -> Result<PreparedMaterial, PrepareError> {
    let mut plain = Material {
        base_color: None,
        normal_map: None,
        emission_map: None,
        metal_rough_map: None,
        occlusion: None,
        ..material.clone()
    };
    for lobe in &mut plain.lobes {
        let weight: f64 = lobe.masks.drain(..).map(|mask| mask.to).product();
        lobe.roughness = RoughnessMap::Material;
        if weight != 1.0 {
            lobe.layers.push(LayerWeight::Constant(weight));
        }
    }
    let mut scene = Scene::new().with_light(Light::directional([0.0, -1.0, 0.0], lamp.clone()));
    scene.materials.push(plain);
    let observation = Observation::new(ColorMode::Spectral, Some(observer.clone()))?;
    let prepared = prepare(&scene, &PrepareOptions { observation, ..PrepareOptions::default() })?;
    // Materials without objects come in their order, before any that objects without one get.
    Ok(prepared.materials.into_iter().next().expect("the scene has one material"))
}

#[cfg(test)]
mod tests {
    use glanz_color::{fluorescent, light, observer, reflectance, xyz_of_reflectance};
    use glanz_scene::library;

    use super::*;

    fn of_lambert(tint: Tint) -> Material {
        let lambert = Shape::named("lambert", &[]).unwrap();
        Material::of_lobes("matte", vec![Lobe::new(lambert, tint)])
    }

    #[test]
    fn a_matte_surface_has_the_color_of_its_reflectance() {
        let red = reflectance("red").unwrap();
        let material = of_lambert(Tint::Spectrum(std::sync::Arc::new(red)));
        for (lamp, eye) in [("A", "cie1931"), ("FL11", "cie1964"), ("D65", "cie2015-2")] {
            let (lamp, eye) = (light(lamp).unwrap(), observer(eye).unwrap());
            let response = MaterialResponse::new(&material, &lamp, &eye).unwrap();
            let (wi, wo) = (Vec3::from_angles(0.7, 1.0), Vec3::from_angles(0.2, 4.0));
            let found = response.brdf(wi, wo).map(|value| value * core::f64::consts::PI);
            let expected = xyz_of_reflectance(&red, &lamp, &eye);
            for (found, expected) in found.iter().zip(expected) {
                // The table is in f32.
                assert!((found - expected).abs() < 1e-6, "{found} {expected}");
            }
        }
    }

    #[test]
    fn a_mirror_reflects_by_its_tint_and_what_lies_above_it() {
        let (d65, eye) = (light("D65").unwrap(), Observer::default());
        let mirror = |tint: f64| {
            let tint = Tint::Spectrum(std::sync::Arc::new(Spectrum::constant(tint)));
            Material::of_lobes("mirror", vec![Lobe::new(Shape::named("mirror", &[]).unwrap(), tint)])
        };
        let y = |material: &Material| MaterialResponse::new(material, &d65, &eye).unwrap().mirror(1.0)[1];
        // The table is in f32.
        assert!((y(&mirror(1.0)) - 1.0).abs() < 1e-6 && (y(&mirror(0.25)) - 0.25).abs() < 1e-6);
        let mut weighed = mirror(1.0);
        weighed.lobes[0].layers.push(LayerWeight::Constant(0.5));
        assert!((y(&weighed) - 0.5).abs() < 1e-6);
        let matte = of_lambert(Tint::Spectrum(std::sync::Arc::new(Spectrum::ONE)));
        assert_eq!(y(&matte), 0.0);
    }

    #[test]
    fn what_glows_is_brighter_than_it_reflects() {
        let matrix = fluorescent("paper-brightened").unwrap();
        let eye = Observer::default();
        let z = |light_name: &str, matrix: &glanz_color::Reradiation| {
            let material = of_lambert(Tint::Reradiation(std::sync::Arc::new(matrix.clone())));
            let response = MaterialResponse::new(&material, &light(light_name).unwrap(), &eye).unwrap();
            let up = Vec3::from_angles(0.0, 0.0);
            response.brdf(up, up)[2] * core::f64::consts::PI / response.white()[2]
        };
        let reflected = matrix.without_reradiation();
        let [day, lamp] = ["D65", "A"].map(|name| z(name, &matrix) - z(name, &reflected));
        // Daylight has the ultraviolet that a tungsten lamp lacks.
        assert!(lamp > 0.0 && day > 2.0 * lamp, "{day} {lamp}");
    }

    #[test]
    fn a_picture_of_a_plane_has_the_same_light() {
        let (lamp, eye) = (light("FL11").unwrap(), Observer::default());
        let wi = Vec3::from_angles(0.3, 0.0);
        // A metal, a coat over a matte base, a coloured coat, films, a sheen, what glows, and a classic material.
        for name in [
            "gold-satin",
            "paper-glossy",
            "car-paint-red",
            "titanium-blue",
            "glaze-celadon",
            "velvet-red",
            "highlighter-yellow",
            "gl-jade",
        ] {
            let material = library::material(name).unwrap();
            let scene = Scene::new()
                .with_mesh(glanz_scene::Mesh::builtin("quad").unwrap(), material.clone())
                .with_light(Light::directional([-wi.x, -wi.y, -wi.z], LightColor::unit(&lamp).unwrap()))
                .with_camera(glanz_scene::Camera::new([0.0, 0.0, 5.0], [0.0, 0.0, 0.0]).orthographic(0.1))
                .with_size(8, 8)
                .with_mode(ColorMode::Spectral);
            let frame = crate::Shot::new(&scene).unwrap().frame().unwrap();
            let response = MaterialResponse::new(&material, &lamp, &eye).unwrap();
            let expected = response.brdf(wi, Vec3::from_angles(0.0, 0.0));
            for (channel, expected) in expected.iter().enumerate() {
                let drawn = f64::from(frame.pixel(4, 4)[channel]);
                let told = core::f64::consts::PI * wi.z * expected;
                assert!((drawn - told).abs() < 1e-4 * told.max(0.01), "{name}: {drawn} drawn, {told} told");
            }
        }
    }

    #[test]
    fn every_material_of_the_library_has_a_color_and_none_below_the_horizon() {
        let (d65, eye) = (light("D65").unwrap(), Observer::default());
        let (wi, wo) = (Vec3::from_angles(0.5, 0.0), Vec3::from_angles(0.45, core::f64::consts::PI));
        let mut mirrors = 0;
        for info in library::materials() {
            let response = MaterialResponse::new(&info.material(), &d65, &eye).unwrap();
            let seen = response.brdf(wi, wo);
            assert!(seen.iter().all(|value| value.is_finite() && *value >= 0.0), "{}: {seen:?}", info.name);
            mirrors += usize::from(response.has_mirror());
            assert_eq!(response.brdf(wi, Vec3::new(wo.x, wo.y, -wo.z)), [0.0; 3]);
        }
        assert!(mirrors > 0, "panes and glasses have one");
    }

    #[test]
    fn who_sees_no_xyz_and_what_is_not_seen_are_refused() {
        let material = library::material("gold").unwrap();
        let cones = observer("lms2").unwrap();
        assert!(MaterialResponse::new(&material, &light("D65").unwrap(), &cones).is_err());
        assert!(MaterialResponse::new(&material, &Spectrum::ZERO, &Observer::default()).is_err());
    }
}
