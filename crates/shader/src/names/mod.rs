//! Which value of the host's a name stands for.
//!
//! The names are those of 586 stages of courses and books (LearnOpenGL, opengl-tutorial, the tutorials of J. McKesson, the
//! GLSL Cookbook and others): a prefix (`u_`, `a_`, `v_`, `g_`, `m_`, `in`, `mat`) and a suffix (`_modelspace`,
//! `_worldspace`, `Matrix`) say little, upper and lower case nothing, and the type decides where the name is short.

mod table;

use crate::{Scalar, ValueType};
use table::{ATTRIBUTES, UNIFORMS, VARYINGS};

/// What a uniform or vertex input stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Role {
    /// Vertex: position in the object's space.
    Position,
    /// Vertex: normal.
    Normal,
    /// Vertex: texture coordinates.
    TexCoord,
    /// Vertex: colour.
    Color,
    /// Vertex: tangent.
    Tangent,
    /// Vertex: second tangent.
    Bitangent,
    /// Matrix from the object to clip space.
    ModelViewProjection,
    /// Matrix from the object to the eye.
    ModelView,
    /// Matrix from the object to the world.
    Model,
    /// Matrix from the world to the eye.
    View,
    /// Matrix from the eye to clip space.
    Projection,
    /// Matrix from the world to clip space.
    ViewProjection,
    /// Matrix of normals. Of the model's matrix where the same text brings positions to the world by it, else of the
    /// model-view one.
    NormalMatrix,
    /// The eye in the world.
    EyePosition,
    /// A light's place.
    LightPosition,
    /// The direction of a light.
    LightDirection,
    /// The colour or intensity of a light; its diffuse part, where there are several.
    LightColor,
    /// Its ambient part.
    LightAmbient,
    /// Its specular part.
    LightSpecular,
    /// Constant term of a light's attenuation.
    AttenuationConstant,
    /// Its linear term.
    AttenuationLinear,
    /// Its quadratic term.
    AttenuationQuadratic,
    /// The material's ambient reflectance.
    MaterialAmbient,
    /// Its diffuse reflectance, or base colour.
    MaterialDiffuse,
    /// Its specular reflectance.
    MaterialSpecular,
    /// What it emits.
    MaterialEmission,
    /// Its exponent.
    MaterialShininess,
    /// Its metalness.
    MaterialMetallic,
    /// Its roughness.
    MaterialRoughness,
    /// Seconds since the start.
    Time,
    /// Seconds since the last frame.
    TimeDelta,
    /// Number of the frame.
    Frame,
    /// Size of the picture in pixels.
    Resolution,
    /// Place of the pointer in pixels.
    Mouse,
    /// Another parameter of the material's models, by its own name: `alpha`, `sigma`.
    MaterialParameter,
    /// How many lights there are.
    LightCount,
    /// The direction of a spot's axis, away from it.
    SpotDirection,
    /// The angle between a spot's axis and its rim, in degrees; 180 of what is no spot.
    SpotCutoff,
    /// The cosine of that angle.
    SpotCosCutoff,
    /// The exponent of the cosine with which a spot fades from its axis.
    SpotExponent,
    /// Fragment: the direction to the viewer, of any length.
    ViewDirection,
}

/// What positions and directions are relative to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Space {
    /// The object.
    Object,
    /// The world.
    World,
    /// The camera: right, up and backwards.
    Eye,
}

impl Space {
    /// The space that a name says: `LightPosition_worldspace`, `cameraSpaceLightPos`.
    ///
    /// ```
    /// use glanz_shader::Space;
    ///
    /// assert_eq!(Space::of_name("modelSpaceLightPos"), Some(Space::Object));
    /// assert_eq!(Space::of_name("vNormal"), None);
    /// ```
    pub fn of_name(name: &str) -> Option<Self> {
        let name = name.replace('_', "").to_ascii_lowercase();
        let says = |words: &[&str]| words.iter().any(|word| name.contains(word));
        if says(&["modelspace", "objectspace"]) {
            return Some(Self::Object);
        }
        if says(&["world"]) {
            return Some(Self::World);
        }
        says(&["cameraspace", "viewspace", "eyespace", "eyecoord", "eyenorm", "eyeposition"])
            .then_some(Self::Eye)
    }
}

/// What a type must be for a role.
#[derive(Clone, Copy, PartialEq)]
enum Shape {
    Matrix4,
    /// 3×3 or 4×4.
    Matrix,
    /// Two to four numbers.
    Vector,
    Number,
    /// A number or some.
    Numbers,
}

fn fits(shape: Shape, ty: ValueType) -> bool {
    let number = ty.columns == 1 && ty.rows == 1 && ty.scalar != Scalar::Bool;
    let vector = ty.columns == 1 && (2..=4).contains(&ty.rows);
    match shape {
        Shape::Matrix4 => (ty.columns, ty.rows) == (4, 4),
        Shape::Matrix => ty.columns >= 3 && ty.columns == ty.rows,
        Shape::Vector => vector,
        Shape::Number => number,
        Shape::Numbers => number || vector,
    }
}

/// Lower case, without prefixes, suffixes and underscores.
fn plain(name: &str) -> String {
    let mut name = name;
    for prefix in ["u_", "a_", "v_", "g_", "m_", "in_", "i_", "vertex_"] {
        name = name.strip_prefix(prefix).unwrap_or(name);
    }
    for suffix in ["_modelspace", "_worldspace", "_cameraspace", "_eyespace", "_viewspace"] {
        name = name.strip_suffix(suffix).unwrap_or(name);
    }
    name.chars().filter(|c| *c != '_').flat_map(char::to_lowercase).collect()
}

/// The role that a table gives a name, which may still have `mat` before it or `matrix` behind.
fn look_up(table: &[(&str, Role, Shape)], name: &str, ty: ValueType) -> Option<Role> {
    let bare = plain(name);
    let find =
        |name: &str| table.iter().find(|(n, _, shape)| *n == name && fits(*shape, ty)).map(|row| row.1);
    let shorter = [bare.strip_suffix("matrix"), bare.strip_prefix("mat"), bare.strip_suffix("mat")];
    find(&bare).or_else(|| shorter.into_iter().flatten().filter(|n| !n.is_empty()).find_map(find))
}

/// What the vertex input of this name and type stands for.
///
/// ```
/// use glanz_shader::{Role, Scalar, ValueType, attribute_role};
///
/// let vec3 = ValueType { scalar: Scalar::Float, columns: 1, rows: 3 };
/// assert_eq!(attribute_role("vertexNormal_modelspace", vec3), Some(Role::Normal));
/// assert_eq!(attribute_role("boneWeights", vec3), None);
/// ```
pub fn attribute_role(name: &str, ty: ValueType) -> Option<Role> {
    let last = name.rsplit('.').next().unwrap_or(name);
    look_up(ATTRIBUTES, last, ty)
}

/// What the uniform of this name and type stands for. Members of structs and blocks count by the struct's name and their
/// own: `light.ambient`, `material.ambient`; those of other blocks by their own.
pub fn uniform_role(name: &str, ty: ValueType) -> Option<Role> {
    let Some((before, member)) = name.rsplit_once('.') else {
        // Elements of arrays: lightPositions[2] is a lightPosition.
        let base = name.split('[').next().unwrap_or(name);
        let one = base.strip_suffix('s').filter(|_| base.len() < name.len());
        return look_up(UNIFORMS, base, ty).or_else(|| look_up(UNIFORMS, one?, ty));
    };
    let holders = || before.split('.').map(|holder| plain(holder.split('[').next().unwrap_or(holder)));
    for (word, table) in [("light", table::LIGHT), ("material", table::MATERIAL)] {
        if holders().any(|holder| holder.contains(word) || word == "material" && holder == "mat") {
            let other = (word == "material" && fits(Shape::Number, ty)).then_some(Role::MaterialParameter);
            return look_up(table, member, ty).or(other);
        }
    }
    look_up(UNIFORMS, member, ty)
}

/// What the input of this name and type of a fragment shader stands for, where no vertex shader says it.
///
/// ```
/// use glanz_shader::{Role, Scalar, ValueType, varying_role};
///
/// let vec3 = ValueType { scalar: Scalar::Float, columns: 1, rows: 3 };
/// assert_eq!(varying_role("FragPos", vec3), Some(Role::Position));
/// assert_eq!(varying_role("fs_in.Normal", vec3), Some(Role::Normal));
/// assert_eq!(varying_role("height", vec3), None);
/// ```
pub fn varying_role(name: &str, ty: ValueType) -> Option<Role> {
    let last = name.rsplit('.').next().unwrap_or(name);
    look_up(VARYINGS, last, ty)
}

#[cfg(test)]
mod tests {
    use super::*;

    const fn ty(columns: usize, rows: usize) -> ValueType {
        ValueType { scalar: Scalar::Float, columns, rows }
    }

    #[test]
    fn the_names_of_courses_have_their_roles() {
        for (name, ty, role) in [
            ("MVP", ty(4, 4), Role::ModelViewProjection),
            ("matMVP", ty(4, 4), Role::ModelViewProjection),
            ("u_modelViewProjectionMatrix", ty(4, 4), Role::ModelViewProjection),
            ("mv", ty(4, 4), Role::ModelView),
            ("matWorld", ty(4, 4), Role::Model),
            ("mat_world", ty(4, 4), Role::Model),
            ("ModelMatrix", ty(4, 4), Role::Model),
            ("V", ty(4, 4), Role::View),
            ("cameraToClipMatrix", ty(4, 4), Role::Projection),
            ("normal_matrix", ty(3, 3), Role::NormalMatrix),
            ("matNor", ty(3, 3), Role::NormalMatrix),
            ("viewPos", ty(1, 3), Role::EyePosition),
            ("LightPosition_worldspace", ty(1, 3), Role::LightPosition),
            ("lights[3].position", ty(1, 4), Role::LightPosition),
            ("light.diffuse", ty(1, 3), Role::LightColor),
            ("lightPositions[2]", ty(1, 3), Role::LightPosition),
            ("lights.source[3].spotCutoff", ty(1, 1), Role::SpotCutoff),
            ("lights.nbrLights", ty(1, 1), Role::LightCount),
            ("material.alpha", ty(1, 1), Role::MaterialParameter),
            ("material.diffuse", ty(1, 3), Role::MaterialDiffuse),
            ("Matrices.projection", ty(4, 4), Role::Projection),
            ("Kd", ty(1, 3), Role::MaterialDiffuse),
            ("iResolution", ty(1, 3), Role::Resolution),
            ("mousePos", ty(1, 4), Role::Mouse),
            ("u_time", ty(1, 1), Role::Time),
        ] {
            assert_eq!(uniform_role(name, ty), Some(role), "{name}");
        }
        for (name, role) in [
            ("aPos", Role::Position),
            ("vPos", Role::Position),
            ("VertexPosition", Role::Position),
            ("vertexPosition_modelspace", Role::Position),
            ("gl_Normal", Role::Normal),
            ("vNor", Role::Normal),
            ("vCol", Role::Color),
            ("VertexTangent", Role::Tangent),
        ] {
            assert_eq!(attribute_role(name, ty(1, 3)), Some(role), "{name}");
        }
        assert_eq!(attribute_role("aTexCoords", ty(1, 2)), Some(Role::TexCoord));
    }

    #[test]
    fn a_name_of_another_type_has_no_role() {
        assert_eq!(uniform_role("view", ty(1, 3)), None, "a vector is no matrix");
        assert_eq!(uniform_role("time", ty(4, 4)), None);
        assert_eq!(uniform_role("threshold", ty(1, 1)), None);
    }
}
