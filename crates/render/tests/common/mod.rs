//! Small scenes for the tests of the rasteriser.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]
#![allow(dead_code, reason = "each test program uses a part of this")]

pub(crate) mod everything;

use glam::{DMat4, DVec3, Vec2, Vec3};
use glanz_bsdf::Shape;
use glanz_color::Rgb;
use glanz_render::{Aovs, DrawOptions, Frame, PrepareOptions, View, draw, prepare};
use glanz_scene::{
    Background, Builtin, Camera, ClassicMaterial, Interpolation, Light, LightColors, LightKind, Lobe,
    Material, Mesh, Object, Projection, Scene, Shading,
};

/// A camera on the positive Z axis that looks at the origin.
pub(crate) fn camera(distance: f64, fov_deg: f64) -> Camera {
    Camera {
        eye: DVec3::new(0.0, 0.0, distance),
        target: DVec3::ZERO,
        up: DVec3::Y,
        projection: Projection::Perspective { fov_y: fov_deg.to_radians() },
    }
}

/// A camera with parallel rays along −Z that shows `width`×`height` metres as that many pixels, with
/// the world's origin in the lower left corner of the picture.
pub(crate) fn pixel_camera(width: u32, height: u32) -> Camera {
    let (x, y) = (f64::from(width) * 0.5, f64::from(height) * 0.5);
    Camera {
        eye: DVec3::new(x, y, 10.0),
        target: DVec3::new(x, y, 0.0),
        up: DVec3::Y,
        projection: Projection::Orthographic { height: f64::from(height) },
    }
}

/// A built-in mesh.
pub(crate) fn builtin(builtin: Builtin) -> Mesh {
    builtin.mesh().unwrap()
}

/// A sphere of radius 1.
pub(crate) fn sphere(slices: u32, stacks: u32) -> Mesh {
    builtin(Builtin::Sphere { radius: 1.0, slices, stacks })
}

/// A mesh of these triangles, all facing +Z.
pub(crate) fn triangles(positions: Vec<Vec3>, corners: Vec<u32>) -> Mesh {
    let normals = vec![Vec3::Z; positions.len()];
    Mesh { positions, normals, corners, ..Mesh::default() }
}

/// A rectangle at height `z` that faces +Z; u runs to the right, v downwards, each from 0 to 1.
pub(crate) fn rectangle([left, bottom, right, top]: [f32; 4], z: f32) -> Mesh {
    Mesh {
        positions: [[left, top], [left, bottom], [right, bottom], [right, top]]
            .map(|[x, y]| Vec3::new(x, y, z))
            .to_vec(),
        normals: vec![Vec3::Z; 4],
        uvs: [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]].map(Vec2::from_array).to_vec(),
        corners: vec![0, 1, 2, 3],
        face_starts: vec![0, 4],
        ..Mesh::default()
    }
}

/// A material that only glows, whatever shines on it.
pub(crate) fn glow(color: Rgb) -> Material {
    ClassicMaterial { emission: color.into(), ..ClassicMaterial::default() }.build("glow").unwrap()
}

/// A material of one ambient lobe, which textures multiply: its value is light × texture.
pub(crate) fn ambient_only(tint: Rgb) -> Material {
    let shape = Shape::named("ambient", &[]).unwrap();
    Material::of_lobes("ambient", vec![Lobe::new(shape, tint).textured()])
}

/// A red material with all terms.
pub(crate) fn shiny(model: &str, shininess: f64) -> Material {
    ClassicMaterial {
        ambient: Rgb([0.3, 0.1, 0.2]).into(),
        diffuse: Rgb([0.5, 0.2, 0.1]).into(),
        specular: Rgb([0.3, 0.4, 0.35]).into(),
        emission: Rgb([0.01, 0.02, 0.03]).into(),
        shininess,
        model: model.into(),
        ..ClassicMaterial::default()
    }
    .build("shiny")
    .unwrap()
}

/// A light of this kind that sends the same to all lobes.
pub(crate) fn light(kind: LightKind, color: Rgb) -> Light {
    Light::new(kind, LightColors::all(color))
}

/// A scene without objects and lights, seen by this camera.
pub(crate) fn empty(camera: Camera) -> Scene {
    Scene { camera: Some(camera), ..Scene::default() }
}

/// Puts a mesh into the scene, with a material of its own.
pub(crate) fn add(scene: &mut Scene, mesh: Mesh, material: Material, transform: DMat4) {
    scene.objects.push(Object {
        name: String::new(),
        mesh: scene.meshes.len(),
        material: scene.materials.len(),
        transform,
        shading: None,
        interpolation: None,
        program: None,
    });
    scene.meshes.push(mesh);
    scene.materials.push(material);
}

/// Shading and interpolation of the scene's objects.
pub(crate) fn render_as(scene: &mut Scene, shading: Shading, interpolation: Interpolation) {
    scene.render.shading = shading;
    scene.render.interpolation = interpolation;
}

/// One sample over nothing.
pub(crate) fn transparent() -> DrawOptions {
    DrawOptions::new(Background::Transparent)
}

/// `samples` per pixel over nothing.
pub(crate) fn sampled(samples: u32) -> DrawOptions {
    DrawOptions { samples: samples.try_into().unwrap(), ..transparent() }
}

/// Draws the scene with its camera.
pub(crate) fn picture(scene: &Scene, width: u32, height: u32, options: &DrawOptions) -> Frame {
    let prepared = prepare(scene, &PrepareOptions::default()).unwrap();
    let view = View::new(&scene.camera.unwrap(), width, height).unwrap();
    draw(&prepared, &view, options)
}

/// All planes beside colour.
pub(crate) const ALL_LAYERS: Aovs = Aovs { depth: true, normal: true, object: true };

/// Panics unless every colour and alpha is a finite number and every distance a number.
pub(crate) fn assert_sane(frame: &Frame, what: &str) {
    for (name, plane) in ["red", "green", "blue"].iter().zip(&frame.rgb).chain([(&"alpha", &frame.alpha)]) {
        if let Some(at) = plane.iter().position(|v| !v.is_finite()) {
            panic!("{what}: {name} is {} at pixel {}, {}", plane[at], at % frame.width, at / frame.width);
        }
    }
    assert!(frame.depth.iter().all(|d| !d.is_nan()), "{what}: a distance is NaN");
    assert!(frame.normal.iter().flatten().all(|n| n.is_finite()), "{what}: a normal is not finite");
    assert!(frame.alpha.iter().all(|a| (0.0..=1.000_001).contains(a)), "{what}: alpha is out of range");
}

/// A generator of test numbers (Marsaglia 2003, xorshift), the same on every machine.
pub(crate) struct Random(pub u64);

impl Random {
    /// The next number from 0 to 1.
    pub(crate) fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
    /// The next number between two.
    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }
}
