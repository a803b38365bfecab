//! The scene that shows a material: a ball in a room with windows, under a lamp.

use std::sync::Arc;

use glam::{DMat3, DMat4, DVec3};
use glanz_bsdf::Shape;
use glanz_color::Rgb;
use glanz_render::{DebugView, ToneMap};
use glanz_scene::builtin::Builtin;
use glanz_scene::{
    Background, Camera, ColorMode, EnvironmentMap, Image, Light, LightColor, LightColors, LightKind, Lobe,
    Material, Mesh, Object, Projection, RenderSettings, Scene, Space, Texture, TextureFilter, TextureUse,
    Wrap,
};

use super::sky;
use crate::load::Input;
use crate::print::failure::Failure;

/// Behind the ball, linear.
const BACKGROUND: Rgb = Rgb([0.055, 0.055, 0.06]);
/// Vertical field of view, in degrees: narrow, so that balls look round.
const FOV_DEG: f64 = 20.0;
/// The part of the picture's half height that the ball fills.
const FILLED: f64 = 0.92;
/// Directions in which lamps shine and how strong they are: a key from the upper left, and one from behind, which
/// passes leaves and paper and shows grazing reflection.
const LAMPS: [([f64; 3], f64); 2] = [([1.0, -1.1, -1.2], 0.35), ([-0.9, -0.5, 1.0], 0.35)];
/// Light for ambient terms, which the environment map does not light.
const AMBIENT: f64 = 0.35;
/// Exposure in stops: polished metal and white paper shall both keep their colours.
const EV: f32 = -0.5;
/// Squares along the side of the checkerboard behind transparent materials.
const SQUARES: u32 = 10;
/// The side of that board over the radius of the ball.
const BOARD: f64 = 6.0;
/// Codes of its squares.
const BOARD_CODES: [u8; 2] = [225, 60];

/// What all balls have in common.
pub struct Room {
    map: Arc<EnvironmentMap>,
    ball: Mesh,
    lamp: LightColor,
}

impl Room {
    /// The room, under lamps of this colour.
    pub fn new(lamp: LightColor) -> Result<Self, Failure> {
        let ball = Builtin::Sphere { radius: 1.0, slices: 128, stacks: 64 };
        let ball = ball.mesh().map_err(Failure::new)?.with_tangents();
        Ok(Self { map: Arc::new(sky::room()), ball, lamp })
    }

    /// The scene of one material, for pictures of this size.
    pub fn input(&self, material: Material, (width, height): (u32, u32)) -> Input {
        let mut scene = Scene {
            meshes: vec![self.ball.clone()],
            objects: vec![object(0, 0, DMat4::IDENTITY)],
            lights: self.lights(),
            camera: Some(camera()),
            image: Image { width, height, background: Background::Color(BACKGROUND), ..Image::default() },
            render: RenderSettings { mode: ColorMode::Spectral, ..RenderSettings::default() },
            ..Scene::default()
        };
        if material.transmittance.is_some() {
            add_board(&mut scene);
        }
        scene.materials.insert(0, material);
        Input {
            scene,
            show: DebugView::Shaded,
            tone_map: ToneMap::KhronosNeutral,
            ev: EV,
            cameras: Vec::new(),
            notes: Vec::new(),
            hash: 0,
            default_lights: true,
        }
    }

    fn lights(&self) -> Vec<Light> {
        let environment =
            LightKind::Environment { map: Some(Arc::clone(&self.map)), rotation: DMat3::IDENTITY };
        let lamp = |(direction, strength): ([f64; 3], f64)| Light {
            space: Space::Camera,
            ..Light::new(
                LightKind::Directional { direction: DVec3::from_array(direction) },
                LightColors::direct(self.lamp.scaled(strength)),
            )
        };
        let mut lights: Vec<_> = LAMPS.into_iter().map(lamp).collect();
        lights.push(Light::new(environment, LightColors::direct(self.lamp.clone())));
        lights.push(Light::new(LightKind::Ambient, LightColors::ambient(self.lamp.scaled(AMBIENT))));
        lights
    }
}

/// A camera before the ball, a little above it.
fn camera() -> Camera {
    let half = 0.5 * FOV_DEG.to_radians();
    let distance = 1.0 / libm::sin(libm::atan(FILLED * libm::tan(half)));
    let eye = DVec3::new(0.0, 0.2, 1.0).normalize() * distance;
    let projection = Projection::Perspective { fov_y: 2.0 * half };
    Camera { eye, target: DVec3::ZERO, up: DVec3::Y, projection }
}

fn object(mesh: usize, material: usize, transform: DMat4) -> Object {
    Object { name: String::new(), mesh, material, transform, shading: None, interpolation: None }
}

/// Puts a board of squares behind the ball; its material is to be the second one.
fn add_board(scene: &mut Scene) {
    let codes = (0..SQUARES * SQUARES).flat_map(|i| {
        let code = BOARD_CODES[((i % SQUARES + i / SQUARES) % 2) as usize];
        [code, code, code, 255]
    });
    scene.textures.push(Texture {
        name: "board".to_owned(),
        width: SQUARES,
        height: SQUARES,
        rgba: codes.collect(),
        srgb: true,
        wrap: [Wrap::Clamp; 2],
        filter: TextureFilter::Nearest,
    });
    let matte = Shape::named("lambert", &[]).expect("lambert exists");
    let mut board = Material::of_lobes("board", vec![Lobe::new(matte, Rgb::WHITE).textured()]);
    board.base_color = Some(TextureUse::plain(0));
    scene.materials.push(board);
    scene.meshes.push(Builtin::Quad.mesh().expect("a square has no parameters"));
    let place =
        DMat4::from_translation(DVec3::new(0.0, 0.0, -1.5)) * DMat4::from_scale(DVec3::splat(0.5 * BOARD));
    scene.objects.insert(0, object(1, 1, place));
}
