//! Stages that are written for the other one.

use std::fmt::Write;

use crate::{
    Interpolation, Port, Program, Role, Scalar, Shader, ShaderError, Space, ValueType, varying_role,
};

/// What a stand-in calls the outputs, before their numbers.
pub(super) const PREFIX: &str = "glanz_varying_";

/// What a stand-in for a fragment shader calls its input.
pub(super) const COLOR: &str = "glanz_shown_color";

/// A vertex shader that projects positions as always, and gives what a fragment shader takes.
pub(super) fn vertex(fragment: &Program, traced: bool) -> Result<Program, ShaderError> {
    let mut outputs = String::new();
    let mut body = String::new();
    let is_eye = taken_space(fragment) == Space::Eye;
    for (input, port) in super::taken(fragment) {
        let Some(value) = value_of(port) else {
            if port.name.starts_with("gl_") {
                continue;
            }
            return Err(unknown(port));
        };
        let how = match port.interpolation {
            Interpolation::Flat => "flat ",
            Interpolation::Linear => "noperspective ",
            Interpolation::Perspective => "",
        };
        let name = format!("{PREFIX}{input}");
        writeln!(outputs, "{how}out {} {name};", port.ty).expect("a string takes everything");
        writeln!(body, "    {name} = {value};").expect("a string takes everything");
    }
    let (to_space, eye, eye_uniform) = match is_eye {
        true => ("mv", "vec3(0.0)", ""),
        false => ("model", "eyePos", "uniform vec3 eyePos; "),
    };
    let text = format!(
        "#version 330\nin vec3 aPos; in vec3 aNormal; in vec2 aTexCoord; in vec4 aColor; in vec3 aTangent; in vec3 aBitangent;\n\
         {eye_uniform}uniform mat4 {to_space}; uniform mat4 mvp; uniform mat3 normalMatrix;\n{outputs}\
         void main() {{\n    vec4 position = {to_space} * vec4(aPos, 1.0);\n    vec3 normal = normalMatrix * aNormal;\n    \
         vec3 tangent = mat3({to_space}) * aTangent;\n    vec3 bitangent = mat3({to_space}) * aBitangent;\n    \
         vec3 view = {eye} - position.xyz;\n{body}    gl_Position = mvp * vec4(aPos, 1.0);\n}}\n"
    );
    let shader = Shader::vertex(text).named("stand-in.vert");
    if traced { shader.traced() } else { shader }.compile()
}

/// What a fragment shader alone takes its inputs to be relative to.
fn taken_space(fragment: &Program) -> Space {
    let names = fragment.interface().inputs.iter().map(|port| port.name.as_str());
    let says_eye = names.filter_map(Space::of_name).any(|space| space == Space::Eye);
    let roles = fragment.interface().uniforms.iter().filter_map(|own| own.role);
    match says_eye && !roles.into_iter().any(|role| role == Role::EyePosition) {
        true => Space::Eye,
        false => Space::World,
    }
}

/// The value of an input, as its type.
fn value_of(port: &Port) -> Option<String> {
    let of_four = match varying_role(&port.name, port.ty)? {
        Role::Position => "position",
        Role::Normal => "vec4(normal, 0.0)",
        Role::TexCoord => "vec4(aTexCoord, 0.0, 1.0)",
        Role::Color => "aColor",
        Role::Tangent => "vec4(tangent, 0.0)",
        Role::Bitangent => "vec4(bitangent, 0.0)",
        Role::ViewDirection => "vec4(view, 0.0)",
        _ => return None,
    };
    let letters = ["x", "xy", "xyz", "xyzw"].get(port.ty.rows.checked_sub(1)?)?;
    (port.ty.scalar == Scalar::Float && port.ty.columns == 1).then(|| format!("({of_four}).{letters}"))
}

fn unknown(port: &Port) -> ShaderError {
    let message = format!(
        "the fragment shader takes '{}', and there is no vertex shader that gives it; without one there are positions, \
         normals, texture coordinates, colours, tangents and the direction to the viewer, by the names that courses use",
        port.name
    );
    let hints = vec![format!(
        "call it position, normal, uv, color, tangent, bitangent or viewDir, or write a vertex shader with 'out {} {}'",
        port.ty, port.name
    )];
    ShaderError::Invalid { message, place: port.place.clone(), hints }
}

/// The output of a vertex shader that is a colour: the one that is called so, or the only one that could be.
pub(super) fn color_of(vertex: &Program) -> Option<(usize, &Port)> {
    let could_be = |ty: ValueType| ty.scalar == Scalar::Float && ty.columns == 1 && ty.rows >= 3;
    let all = || {
        let outputs = vertex.interface().outputs.iter().enumerate();
        outputs.filter(move |(_, port)| !port.builtin && could_be(port.ty))
    };
    let called = all().find(|(_, port)| varying_role(&port.name, port.ty) == Some(Role::Color));
    let with_word = || all().find(|(_, port)| port.name.to_ascii_lowercase().contains("col"));
    called.or_else(with_word).or_else(|| all().next().filter(|_| all().count() == 1))
}

/// A fragment shader that shows the colour that a vertex shader gives.
pub(super) fn fragment(vertex: &Program, traced: bool) -> Result<Program, ShaderError> {
    let Some((_, port)) = color_of(vertex) else {
        let message = "the vertex shader gives no colour, and there is no fragment shader".to_owned();
        let hints = vec!["write 'out vec4 color' in the vertex shader, or a fragment shader".to_owned()];
        return Err(ShaderError::Invalid { message, place: None, hints });
    };
    let shown = if port.ty.rows == 4 { COLOR.to_owned() } else { format!("vec4({COLOR}, 1.0)") };
    let text = format!(
        "#version 330\nin {} {COLOR};\nout vec4 fragColor;\nvoid main() {{ fragColor = {shown}; }}\n",
        port.ty
    );
    let shader = Shader::fragment(text).named("stand-in.frag");
    if traced { shader.traced() } else { shader }.compile()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::uniform_role;

    #[test]
    fn the_names_of_stand_ins_have_their_roles() {
        let matrix = |n| ValueType { scalar: Scalar::Float, columns: n, rows: n };
        assert_eq!(uniform_role("mvp", matrix(4)), Some(Role::ModelViewProjection));
        assert_eq!(uniform_role("mv", matrix(4)), Some(Role::ModelView));
        assert_eq!(uniform_role("model", matrix(4)), Some(Role::Model));
        assert_eq!(uniform_role("normalMatrix", matrix(3)), Some(Role::NormalMatrix));
    }

    #[test]
    fn a_fragment_shader_alone_gets_what_its_names_say() {
        let text = "#version 330\nin vec3 FragPos; in vec3 Normal; in vec2 TexCoords; in vec4 color; out vec4 c;\n\
                    void main() { c = color + vec4(FragPos + Normal, TexCoords.x); }";
        let pair = crate::Pair::new(None, Some(&Shader::fragment(text))).expect("all are known");
        assert_eq!(pair.varyings.len(), 4);
        let alien = Shader::fragment("in vec3 height; out vec4 c; void main() { c = vec4(height, 1.0); }");
        let error = crate::Pair::new(None, Some(&alien)).expect_err("nobody knows a height");
        assert!(error.to_string().contains("takes 'height'"), "{error}");
    }

    #[test]
    fn a_vertex_shader_alone_shows_its_colour() {
        let text = "#version 330\nin vec3 pos; in vec3 normal; out vec3 other; out vec3 fColor; uniform mat4 mvp;\n\
                    void main() { fColor = normal; other = pos; gl_Position = mvp * vec4(pos, 1.0); }";
        let pair = crate::Pair::new(Some(&Shader::vertex(text)), None).expect("it has a colour");
        assert_eq!(pair.varyings.len(), 1);
        assert_eq!(pair.vertex.interface().outputs[pair.varyings[0].output].name, "fColor");
    }
}
