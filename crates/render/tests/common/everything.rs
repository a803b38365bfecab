//! A small scene with all that a scene can have: every kind of light, lobes of every sort, textures, attributes,
//! objects with facets and polygons.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::sync::Arc;

use glam::{DMat3, DMat4, DVec3, Vec2, Vec4};
use glanz_bsdf::Shape;
use glanz_color::{Ior, Rgb, Spectrum};
use glanz_scene::{
    AlphaMode, AreaShape, Attenuation, Builtin, ChannelUse, Coat, EnvironmentMap, Interpolation, Light,
    LightKind, Lobe, Luminaire, Mask, Material, Mesh, Pane, Profile, RoughnessMap, Scene, Shading, Texture,
    TextureChannel, TextureFilter, TextureUse, Tint, Transmittance,
};

use super::{add, builtin, camera, empty, light, rectangle, shiny, sphere};

/// Numbers of the materials and objects of [`everything`]; each object has its own.
pub(crate) const METAL: usize = 0;
pub(crate) const COATED: usize = 1;
pub(crate) const WINDOW: usize = 2;
pub(crate) const TEXTURED: usize = 3;
pub(crate) const GROUND: usize = 4;
pub(crate) const GLASS: usize = 5;
pub(crate) const PHONG: usize = 6;

/// Numbers of its lights.
pub(crate) const AMBIENT: usize = 0;
pub(crate) const DIRECTIONAL: usize = 1;
pub(crate) const POINT: usize = 2;
pub(crate) const SPOT: usize = 3;
pub(crate) const LUMINAIRE: usize = 4;
/// The lights from this one on are not punctual; [`punctual`] has none of them.
pub(crate) const ENVIRONMENT: usize = 5;
pub(crate) const RECTANGLE: usize = 6;
pub(crate) const BALL: usize = 7;

/// The scene without environments and areas, which is much faster to prepare.
pub(crate) fn punctual() -> Scene {
    let mut scene = everything();
    scene.lights.truncate(ENVIRONMENT);
    scene
}

pub(crate) fn everything() -> Scene {
    let mut scene = empty(camera(3.0, 50.0));
    scene.textures.extend([texture(true), texture(false)]);
    add_lamps(&mut scene, Some((0.9, 0.8)));
    scene.lights.push(luminaire());
    add_fields(&mut scene);
    add(&mut scene, sphere(12, 6), metal(), at(-0.9, 0.1, 0.0));
    add(&mut scene, sphere(10, 6), coated(), at(0.9, 0.0, -0.4));
    add(&mut scene, rectangle([0.1, -0.7, 1.1, 0.5], 1.1), window(), DMat4::IDENTITY);
    add(&mut scene, rectangle([-1.0, 0.2, 0.2, 0.9], 1.1), textured(), DMat4::from_rotation_y(0.1));
    add_ground(&mut scene, ground());
    add(&mut scene, colored(sphere(8, 6)), glass(), at(0.3, -0.2, 0.7));
    add(&mut scene, sphere(24, 13), shiny("phong", 12.0), at(0.0, 0.9, -0.5));
    for mesh in &mut scene.meshes {
        mesh.uvs2 = mesh.uvs.iter().map(|uv| Vec2::new(uv.y, 0.3 + 0.5 * uv.x)).collect();
    }
    scene.objects[COATED].shading = Some(Shading::Flat);
    scene.objects[GLASS].shading = Some(Shading::Gouraud);
    scene.objects[GLASS].interpolation = Some(Interpolation::Scanline);
    scene
}

pub(crate) fn at(x: f64, y: f64, z: f64) -> DMat4 {
    DMat4::from_translation(DVec3::new(x, y, z))
}

/// A large plane below all.
pub(crate) fn add_ground(scene: &mut Scene, material: Material) {
    let place = at(0.0, -0.8, 0.0) * DMat4::from_scale(DVec3::splat(8.0));
    add(scene, builtin(Builtin::Plane), material, place);
}

pub(crate) fn of(name: &str, set: &[(&str, f64)]) -> Shape {
    Shape::named(name, set).unwrap()
}

pub(crate) fn matte() -> Lobe {
    Lobe::new(of("lambert", &[]), Rgb([0.5, 0.2, 0.1]))
}

fn gold() -> Tint {
    Tint::Ior(Arc::new(glanz_color::ior("Au").unwrap()))
}

/// Anisotropic, with a tint that depends on the angle.
pub(crate) fn metal() -> Material {
    let ward = of("ward", &[("alpha", 0.1), ("alpha_y", 0.4)]);
    Material { aniso: 0.7, ..Material::of_lobes("metal", vec![Lobe::new(ward, gold()), matte()]) }
}

/// Below layers.
pub(crate) fn coated() -> Material {
    let coat = Coat { absorption_per_mm: Some(Spectrum::constant(5.0)), ..Coat::default() };
    let lobes = vec![matte(), Lobe::new(of("ggx", &[("alpha", 0.3)]), gold())];
    Material::of_lobes("coated", lobes).under_coat(&coat).unwrap()
}

/// With a mirror and a transmittance.
pub(crate) fn window() -> Material {
    let absorption = glanz_color::rgb_spectra::spectrum_of_reflectance(Rgb([0.1, 0.6, 0.9])) * 200.0;
    let pane = Arc::new(Pane { ior: Ior::constant(1.5), thickness: 0.003, absorption });
    let mirror = Lobe::new(of("mirror", &[]), Tint::Pane(pane.clone()));
    Material { transmittance: Some(Transmittance::Pane(pane)), ..Material::of_lobes("window", vec![mirror]) }
}

/// Matte, by two lobes.
pub(crate) fn ground() -> Material {
    Material::of_lobes("ground", vec![matte(), Lobe::new(of("oren-nayar", &[]), Rgb::gray(0.3))])
}

/// Blended with what is behind it.
pub(crate) fn glass() -> Material {
    Material { opacity: 0.4, alpha_mode: AlphaMode::Blend, ..shiny("phong", 3.0) }
}

/// With all four maps, which leaves holes, masks, and roughness by a picture.
fn textured() -> Material {
    let scaled = TextureUse { scale: 0.5, ..TextureUse::plain(1) };
    let second = TextureUse { second_uvs: true, ..TextureUse::plain(1) };
    let channel = |map, channel| ChannelUse { map, channel };
    let by_blue = channel(second, TextureChannel::Blue);
    let shiny = shiny("blinn-phong", 4.0);
    let masked =
        Lobe { roughness: RoughnessMap::Own(by_blue), ..Lobe::new(of("ggx", &[("alpha", 0.3)]), gold()) }
            .masked(Mask { of: channel(TextureUse::plain(1), TextureChannel::Red), from: 0.2, to: 0.9 })
            .masked(Mask::of(by_blue));
    Material {
        lobes: shiny.lobes.iter().cloned().chain([masked]).collect(),
        occlusion: Some(Mask { of: channel(second, TextureChannel::Green), from: 0.5, to: 1.0 }),
        base_color: Some(TextureUse {
            transform: [[2.0, 0.0, 0.1], [0.0, 3.0, 0.2]],
            ..TextureUse::plain(0)
        }),
        normal_map: Some(scaled),
        emission_map: Some(TextureUse { second_uvs: true, ..TextureUse::plain(0) }),
        metal_rough_map: Some(TextureUse::plain(1)),
        alpha_mode: AlphaMode::Mask { cutoff: 0.5 },
        two_sided: true,
        ..shiny
    }
}

/// Ambient, directional, point and spot light.
pub(crate) fn add_lamps(scene: &mut Scene, smooth_edge: Option<(f64, f64)>) {
    let position = DVec3::new(1.5, 2.0, 2.0);
    let attenuation = Attenuation { constant: 0.2, linear: 0.1, quadratic: 0.1 };
    let spot = LightKind::Spot {
        position: -position,
        direction: position,
        cutoff: 0.5,
        exponent: 3.0,
        smooth_edge,
        attenuation: Attenuation::NONE,
    };
    let kinds = [
        LightKind::Ambient,
        LightKind::Directional { direction: DVec3::new(0.3, -1.0, -0.6) },
        LightKind::Point { position, attenuation },
        spot,
    ];
    scene.lights.extend(kinds.map(|kind| light(kind, Rgb([0.5, 0.6, 0.7]))));
}

/// A lamp that sends more to its sides than along its axis.
pub(crate) fn luminaire() -> Light {
    let position = DVec3::new(0.0, 2.0, 2.0);
    let mut lamp = light(LightKind::Point { position, attenuation: Attenuation::PHYSICAL }, Rgb::WHITE);
    let profile = Arc::new(Profile {
        c_deg: vec![0.0],
        gamma_deg: vec![0.0, 40.0, 90.0, 180.0],
        candela: vec![1.0, 3.0, 0.5, 0.0],
    });
    let axis = Luminaire::AXIS;
    lamp.luminaire = Some(Luminaire { profile, axis, c0: Luminaire::c0_for(axis) });
    lamp
}

/// An environment and surfaces that shine.
pub(crate) fn add_fields(scene: &mut Scene) {
    let area = |shape, position: DVec3| LightKind::Area {
        shape,
        position,
        direction: -position,
        up: DVec3::Y,
        two_sided: false,
    };
    let kinds = [
        LightKind::Environment { map: Some(environment_map(0.2)), rotation: DMat3::from_rotation_y(0.4) },
        area(AreaShape::Rectangle { width: 1.0, height: 0.4 }, DVec3::new(-1.0, 2.0, 1.5)),
        area(AreaShape::Sphere { radius: 0.3 }, DVec3::new(2.0, 1.0, 1.0)),
    ];
    scene.lights.extend(kinds.map(|kind| light(kind, Rgb([0.8, 0.9, 0.7]))));
}

/// A map of 16×8 pixels, whose blue is mostly `blue`.
pub(crate) fn environment_map(blue: f32) -> Arc<EnvironmentMap> {
    let pixel = |i: usize| {
        [(i % 7) as f32 * 0.1, (i % 16) as f32 * 0.04, if i.is_multiple_of(50) { 4.0 } else { blue }]
    };
    Arc::new(EnvironmentMap { width: 16, height: 8, pixels: (0..128).map(pixel).collect() })
}

/// A texture of 16×16 texels with holes.
pub(crate) fn texture(srgb: bool) -> Texture {
    let texel = |i: u32| {
        let (x, y) = (i % 16, i / 16);
        [(x * 16) as u8, (y * 16) as u8, (x * y) as u8, if (x ^ y) & 3 == 0 { 0 } else { 255 }]
    };
    Texture {
        width: 16,
        height: 16,
        rgba: (0..256).flat_map(texel).collect(),
        srgb,
        filter: TextureFilter::Trilinear,
        ..Texture::default()
    }
}

/// With colours at its vertices.
pub(crate) fn colored(mut mesh: Mesh) -> Mesh {
    mesh.colors = mesh.positions.iter().map(|p| (p.abs() * 0.5).extend(0.5 + 0.5 * p.x.abs())).collect();
    assert!(mesh.colors.iter().all(|c| c.cmple(Vec4::ONE).all()));
    mesh
}
