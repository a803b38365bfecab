//! Warnings about two stages that do not fit.

use super::Warning;
use crate::Program;

/// What a fragment shader takes and the vertex shader before it does not give, or gives as another type.
///
/// ```
/// use glanz_shader::{Shader, check_stages};
///
/// let vertex = Shader::vertex("#version 330\nin vec3 p; out vec3 n; void main() { n = p; gl_Position = vec4(p, 1.0); }");
/// let fragment = Shader::fragment("#version 330\nin vec3 normal; out vec4 c; void main() { c = vec4(normal, 1.0); }");
/// let warnings = check_stages(&vertex.compile()?, &fragment.compile()?);
/// assert!(warnings[0].message.starts_with("the fragment shader takes 'normal', which the vertex shader does not give"));
/// # Ok::<(), glanz_shader::ShaderError>(())
/// ```
pub fn check_stages(vertex: &Program, fragment: &Program) -> Vec<Warning> {
    let given = &vertex.interface().outputs;
    let mut all = Vec::new();
    for port in
        fragment.interface().inputs.iter().filter(|port| !port.builtin && !port.name.starts_with("gl_"))
    {
        let same_location = |p: &&crate::Port| p.location.is_some() && p.location == port.location;
        let found = given.iter().find(|p| p.name == port.name).or_else(|| given.iter().find(same_location));
        let message = match found {
            None => {
                let names = given.iter().filter(|p| !p.builtin).map(|p| p.name.as_str());
                let hint = glanz_math::names::did_you_mean(&port.name, names);
                format!(
                    "the fragment shader takes '{}', which the vertex shader does not give{hint}",
                    port.name
                )
            }
            Some(other) if other.ty != port.ty => {
                format!(
                    "'{}' is a {} in the vertex shader and a {} in the fragment shader",
                    port.name, other.ty, port.ty
                )
            }
            Some(_) => continue,
        };
        all.push(Warning { place: port.place.clone(), message });
    }
    all
}
