//! The scene that shows a material: a ball in a studio with windows, under two directional lights.

use std::sync::Arc;

use glam::{DMat3, DMat4, DVec3};
use glanz_bsdf::Shape;
use glanz_color::Rgb;

use super::{directional, object, studio};
use crate::builtin::Builtin;
use crate::{
    Background, Camera, ColorMode, EnvironmentMap, Image, Light, LightColor, LightColors, LightKind, Lobe,
    Material, Mesh, Projection, RenderSettings, Scene, Texture, TextureFilter, TextureUse, ToneMap, Wrap,
};

/// The background, linear.
const BACKGROUND: Rgb = Rgb([0.055, 0.055, 0.06]);
/// Vertical field of view, in degrees: narrow, so that balls look round.
const FOV_DEG: f64 = 20.0;
/// The part of the picture's half height that the ball fills.
const FILLED: f64 = 0.92;
/// Directions of the lights and how strong they are: a key light from the upper left, and one from behind, which
/// passes leaves and paper and shows grazing reflection.
const LIGHTS: [([f64; 3], f64); 2] = [([1.0, -1.1, -1.2], 0.35), ([-0.9, -0.5, 1.0], 0.35)];
/// Light for ambient terms, which the environment does not reach.
const AMBIENT: f64 = 0.35;
/// Exposure in stops: polished metal and white paper shall both keep their colours.
const EV: f64 = -0.5;
/// Squares along the side of the checkerboard behind transmitting materials.
const SQUARES: u32 = 10;
/// The side of that board over the radius of the ball.
const BOARD: f64 = 6.0;
/// Codes of its squares.
const BOARD_CODES: [u8; 2] = [225, 60];

/// A ball in a studio, for pictures of materials that can be compared: spectral, tone mapped, a checkerboard behind
/// what transmits light.
#[derive(Clone, Debug)]
pub struct MaterialStage {
    map: Arc<EnvironmentMap>,
    ball: Mesh,
    light: LightColor,
}

impl MaterialStage {
    /// The stage, under lights of this colour.
    pub fn new(light: LightColor) -> Self {
        let ball = Builtin::Sphere { radius: 1.0, slices: 128, stacks: 64 };
        let ball = ball.mesh().expect("the parameters are in range").with_tangents();
        Self { map: Arc::new(studio()), ball, light }
    }

    /// The scene of one material, for pictures of this width and height.
    pub fn scene(&self, material: Material, (width, height): (u32, u32)) -> Scene {
        let mut scene = Scene {
            meshes: vec![self.ball.clone()],
            objects: vec![object(0, 0, DMat4::IDENTITY)],
            lights: self.lights(),
            camera: Some(camera()),
            image: Image { width, height, background: Background::Color(BACKGROUND), ..Image::default() },
            render: RenderSettings {
                mode: ColorMode::Spectral,
                tone_map: ToneMap::KhronosNeutral,
                ev: EV,
                ..RenderSettings::default()
            },
            ..Scene::default()
        };
        if material.transmittance.is_some() {
            add_board(&mut scene);
        }
        scene.materials.insert(0, material);
        scene
    }

    fn lights(&self) -> Vec<Light> {
        let environment =
            LightKind::Environment { map: Some(Arc::clone(&self.map)), rotation: DMat3::IDENTITY };
        let mut lights: Vec<_> = LIGHTS.into_iter().map(|light| directional(&self.light, light)).collect();
        lights.push(Light::new(environment, LightColors::direct(self.light.clone())));
        lights.push(Light::new(LightKind::Ambient, LightColors::ambient(self.light.scaled(AMBIENT))));
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_checkerboard_stands_behind_what_transmits_light() {
        let stage = MaterialStage::new(LightColor::Rgb(Rgb::WHITE));
        let scene_of =
            |name: &str| stage.scene(crate::library::info(name).expect("it is listed").material(), (16, 16));
        let (opaque, film) = (scene_of("gold"), scene_of("soap-film"));
        assert_eq!((opaque.objects.len(), film.objects.len()), (1, 2));
        assert_eq!(film.materials[film.objects[0].material].name, "board");
        assert_eq!(film.materials[film.objects[1].material].name, "soap-film");
    }
}
