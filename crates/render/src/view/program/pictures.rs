//! What the samplers of a program look into.

use glam::{DMat3, DVec3};
use glanz_scene::{LightKind, Space, UniformValue};
use glanz_shader::TextureInfo;

use super::material;
use crate::prepare::color::in_rgb;
use crate::prepare::{
    EnvironmentLight, EnvironmentMap, LightShape, Mipmap, Prepared, PreparedMaterial, PreparedProgram,
};
use crate::view::View;

/// What a sampler looks into.
#[derive(Clone, Copy, Debug)]
pub enum ProgramPicture<'a> {
    /// A picture of two dimensions.
    Flat(&'a Mipmap),
    /// The faces of a cube map, in OpenGL's order.
    Cube([&'a Mipmap; 6]),
    /// In equirectangular projection, by a direction.
    Panorama(&'a Mipmap),
    /// The scene's environment light, by a direction in the world.
    Environment(EnvironmentPicture<'a>),
}

/// An environment light as it looks.
#[derive(Clone, Copy, Debug)]
pub struct EnvironmentPicture<'a> {
    /// 1 everywhere if there is none.
    pub map: Option<&'a EnvironmentMap>,
    /// Rows of the rotation into the map's own directions.
    pub to_map: [[f32; 3]; 3],
    /// What its values are multiplied by.
    pub color: [f32; 3],
}

/// The pictures of a stage's samplers: what the user sets; of two dimensions the material's map that the name says, of cube
/// maps the environment light, if the name says so.
pub(super) fn of_stage<'a>(
    textures: &[TextureInfo],
    program: &PreparedProgram,
    prepared: &'a Prepared,
    material: &PreparedMaterial,
    view: &View,
) -> Vec<Option<ProgramPicture<'a>>> {
    let picture = |index: usize| prepared.textures.get(index).map(|own| &**own);
    let of = |texture: &TextureInfo| match (program.source.uniforms.get(&texture.name), is_cube(texture)) {
        (Some(UniformValue::Texture(index)), true) => Some(ProgramPicture::Panorama(picture(*index)?)),
        (Some(UniformValue::Texture(index)), false) => Some(ProgramPicture::Flat(picture(*index)?)),
        (Some(UniformValue::Cube(faces)), true) => {
            let faces: Option<Vec<&Mipmap>> = faces.iter().map(|face| picture(*face)).collect();
            Some(ProgramPicture::Cube(faces?.try_into().ok()?))
        }
        (_, true) if is_environment(&texture.name) => environment(prepared, view),
        (_, false) if is_flat(texture) => {
            Some(ProgramPicture::Flat(picture(material::map(&texture.name, material)?)?))
        }
        _ => None,
    };
    textures.iter().map(of).collect()
}

/// Whether a sampler that the user does not set has a picture.
pub(crate) fn has_picture(texture: &TextureInfo, prepared: &Prepared, own: &PreparedMaterial) -> bool {
    let is_environment_light = |light: &LightShape| matches!(light, LightShape::Environment(_));
    match is_cube(texture) {
        true => {
            is_environment(&texture.name)
                && prepared.lights.iter().any(|light| is_environment_light(&light.shape))
        }
        false => is_flat(texture) && material::map(&texture.name, own).is_some(),
    }
}

/// Whether a sampler looks into the six faces of a cube.
pub(crate) fn is_cube(texture: &TextureInfo) -> bool {
    texture.dimension == "cube" && !texture.layered
}

/// Whether a sampler looks into a picture as it is.
pub(crate) fn is_flat(texture: &TextureInfo) -> bool {
    texture.dimension == "2d" && !texture.layered
}

/// Whether a cube map's name says that it is what is around.
fn is_environment(name: &str) -> bool {
    let name = name.to_ascii_lowercase();
    let says = |words: &[&str]| words.iter().any(|word| name.contains(word));
    says(&["sky", "env", "cube", "reflect"]) && !says(&["shadow", "depth", "irradiance", "diffuse"])
}

/// The first environment light.
fn environment<'a>(prepared: &'a Prepared, view: &View) -> Option<ProgramPicture<'a>> {
    let sources = prepared.source.colors.lights.iter().filter(|light| light.kind != LightKind::Ambient);
    prepared.lights.iter().zip(sources).find_map(|(light, source)| match &light.shape {
        LightShape::Environment(environment) => Some(ProgramPicture::Environment(EnvironmentPicture {
            map: environment.map.as_deref(),
            to_map: to_map(environment, light.space, view),
            color: in_rgb::light(&source.colors.diffuse).map(|value| value as f32),
        })),
        _ => None,
    })
}

/// Rows of the rotation into an environment's own directions.
fn to_map(environment: &EnvironmentLight, space: Space, view: &View) -> [[f32; 3]; 3] {
    let to_world = match space {
        Space::World => DMat3::IDENTITY,
        Space::Camera => {
            let [right, up, back] = view.axes.map(DVec3::from_array);
            DMat3::from_cols(right, up, back)
        }
    };
    // The rows of the inverse of a rotation are its columns.
    (to_world * DMat3::from_cols_array_2d(&environment.rotation)).as_mat3().to_cols_array_2d()
}
