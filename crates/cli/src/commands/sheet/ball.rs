//! The scene that shows a lobe: a ball and a few lamps.

use std::sync::Arc;

use glam::{DMat4, DVec3};
use glanz_bsdf::{LightTerm, Shape, Side};
use glanz_color::{Ior, Rgb, SpectrumKind, ior};
use glanz_plot::Medium;
use glanz_render::{DebugView, ToneMap};
use glanz_scene::builtin::Builtin;
use glanz_scene::{
    Background, Camera, ColorMode, Image, Light, LightColor, LightColors, LightKind, Lobe, Material, Object,
    Projection, RenderSettings, Scene, Space, Tint,
};

use crate::input::spectra;
use crate::load::Input;
use crate::print::failure::Failure;

/// Behind the ball, linear.
const BACKGROUND: Rgb = Rgb([0.045, 0.045, 0.05]);
/// Vertical field of view, in degrees: narrow, so that a ball at the edge of a sheet looks round.
const FOV_DEG: f64 = 20.0;
/// The part of the picture's half height that the mesh fills.
const FILLED: f64 = 0.92;
/// Directions in which lamps shine and how strong they are: a key from the upper left, a rim from behind on the
/// right which shows grazing reflection, and a weak one from below.
const LAMPS: [([f64; 3], f64); 3] =
    [([1.0, -1.1, -1.2], 0.9), ([-1.3, -0.25, 1.0], 0.7), ([-0.6, 1.0, -0.8], 0.2)];
/// The same for light that passes through: from behind, left, right and above.
const LAMPS_BEHIND: [([f64; 3], f64); 3] =
    [([0.6, -0.5, 1.0], 0.9), ([-0.9, 0.2, 1.0], 0.6), ([0.0, -1.0, 0.3], 0.5)];
/// Light from everywhere, for lobes that answer to nothing else.
const AMBIENT: f64 = 0.6;
/// The wavelength at which words for media are tried, in nm.
const TRIED_NM: f64 = 550.0;

/// A lobe on a mesh.
#[derive(Clone, Debug)]
pub struct Ball {
    shape: Shape,
    tint: Tint,
    mesh: Builtin,
    light: LightColor,
}

impl Ball {
    /// A ball from the keys of a command line; the last of a key counts.
    pub fn new(
        model: &str,
        values: &[(String, String)],
        mesh: &str,
        light: Option<&str>,
    ) -> Result<Self, Failure> {
        let mut tint = Tint::Rgb(Rgb::WHITE);
        let mut set = Vec::new();
        for (key, text) in values {
            match key.as_str() {
                "ior" => tint = ior_tint(text)?,
                "tint" => tint = reflectance_tint(text)?,
                name => match text.parse::<f64>() {
                    Ok(value) => set.push((name, value)),
                    Err(_) => {
                        let message = format!("parameter '{name}' is '{text}', but must be a number");
                        return Err(Failure::Usage(message));
                    }
                },
            }
        }
        let shape = Shape::named(model, &set).map_err(|error| Failure::Usage(error.to_string()))?;
        if shape.info().delta {
            return Err(Failure::Usage(format!(
                "'{model}' sends light into a single direction: lamps leave it black, it shows environments only"
            )));
        }
        let mesh = Builtin::named(mesh).expect("the parser lets only known names through");
        Ok(Self { shape, tint, mesh: finer(mesh), light: lamp_color(light)? })
    }

    /// The scene, for pictures of this size.
    pub fn input(&self, (width, height): (u32, u32)) -> Result<Input, Failure> {
        let mut mesh = self.mesh.mesh().map_err(Failure::new)?;
        if self.shape.info().anisotropic && mesh.tangents.is_empty() {
            mesh = mesh.with_tangents();
        }
        let center = mesh.bounds().center();
        let radius = mesh.positions.iter().map(|p| p.as_dvec3().distance(center)).fold(1e-9, f64::max);
        let lobe = Lobe::new(self.shape.clone(), self.tint.clone());
        let scene = Scene {
            meshes: vec![mesh],
            materials: vec![Material::of_lobes("ball", vec![lobe])],
            lights: self.lights(),
            objects: vec![Object {
                name: String::new(),
                mesh: 0,
                material: 0,
                transform: DMat4::IDENTITY,
                shading: None,
                interpolation: None,
            }],
            camera: Some(camera(center, radius, f64::from(width) / f64::from(height))),
            image: Image { width, height, background: Background::Color(BACKGROUND), ..Image::default() },
            render: RenderSettings { mode: ColorMode::Spectral, ..RenderSettings::default() },
            ..Scene::default()
        };
        Ok(Input {
            scene,
            show: DebugView::Shaded,
            tone_map: ToneMap::KhronosNeutral,
            ev: 0.0,
            cameras: Vec::new(),
            notes: Vec::new(),
            hash: 0,
            default_lights: true,
        })
    }

    fn lights(&self) -> Vec<Light> {
        let lamps = match (self.shape.info().term, self.shape.info().side) {
            (LightTerm::Ambient | LightTerm::Emission, _) => {
                let colors = LightColors::ambient(self.light.scaled(AMBIENT));
                return vec![Light { name: "ambient".to_owned(), ..Light::new(LightKind::Ambient, colors) }];
            }
            (_, Side::Reflection) => LAMPS,
            (_, Side::Transmission) => LAMPS_BEHIND,
        };
        let lamp = |(direction, strength): ([f64; 3], f64)| Light {
            space: Space::Camera,
            ..Light::new(
                LightKind::Directional { direction: DVec3::from_array(direction) },
                LightColors::direct(self.light.scaled(strength)),
            )
        };
        lamps.into_iter().map(lamp).collect()
    }
}

/// A camera before a mesh, a little above it.
fn camera(target: DVec3, radius: f64, aspect: f64) -> Camera {
    let half = 0.5 * FOV_DEG.to_radians();
    let narrower = half.min(libm::atan(libm::tan(half) * aspect));
    let distance = radius / libm::sin(libm::atan(FILLED * libm::tan(narrower)));
    let eye = target + DVec3::new(0.0, 0.3, 1.0).normalize() * distance;
    let projection = Projection::Perspective { fov_y: 2.0 * half };
    Camera { eye, target, up: DVec3::Y, projection }
}

/// A mesh whose outline has no corners in a picture of a few hundred pixels.
fn finer(mesh: Builtin) -> Builtin {
    match mesh {
        Builtin::Sphere { radius, .. } => Builtin::Sphere { radius, slices: 192, stacks: 96 },
        Builtin::Torus { major, minor, .. } => Builtin::Torus { major, minor, segments: 192, sides: 96 },
        other => other,
    }
}

/// Fresnel's law of a metal, a glass or a number.
fn ior_tint(text: &str) -> Result<Tint, Failure> {
    // The words that are no media have their errors there.
    let known = Medium::named(text, TRIED_NM)?;
    Ok(Tint::Ior(Arc::new(match ior(text) {
        Ok(found) => found,
        Err(_) => Ior::constant(known.eta),
    })))
}

/// A reflectance for all wavelengths, or a spectrum of it.
fn reflectance_tint(text: &str) -> Result<Tint, Failure> {
    match text.parse::<f32>() {
        Ok(value) if (0.0..=1.0).contains(&value) => Ok(Tint::Rgb(Rgb::gray(value))),
        Ok(value) => Err(Failure::Usage(format!("tint is {value}, but must be between 0 and 1"))),
        Err(_) => {
            let source = spectra::source(text, Some(SpectrumKind::Surface))?;
            Ok(Tint::Spectrum(Arc::new(source.spectrum)))
        }
    }
}

/// A lamp of luminance 1.
fn lamp_color(name: Option<&str>) -> Result<LightColor, Failure> {
    let Some(name) = name else { return Ok(LightColor::Rgb(Rgb::WHITE)) };
    let source = spectra::light_source(name)?;
    LightColor::unit(&source.spectrum)
        .ok_or_else(|| Failure::new(format_args!("--light '{name}' sends no light")))
}
