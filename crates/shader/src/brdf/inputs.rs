//! What the parameters of a BRDF's function stand for.

use crate::intake::is_brdf_file;
use crate::{Port, Program, Scalar, ShaderError, ValueType};

/// A vector that a BRDF may take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Input {
    Light,
    View,
    Normal,
    Tangent,
    Bitangent,
    Half,
}

/// The names of each, folded to small letters.
const NAMES: [(Input, &[&str]); 6] = [
    (Input::Light, &["l", "light", "lightdir", "light_dir", "tolight", "wi"]),
    (Input::View, &["v", "view", "viewdir", "view_dir", "toviewer", "eye", "wo"]),
    (Input::Normal, &["n", "normal"]),
    (Input::Tangent, &["x", "t", "tangent"]),
    (Input::Bitangent, &["y", "b", "bitangent", "binormal"]),
    (Input::Half, &["h", "half", "halfway"]),
];

/// In the order of BRDF Explorer's function, where names say nothing.
const IN_ORDER: [Input; 5] = [Input::Light, Input::View, Input::Normal, Input::Tangent, Input::Bitangent];

/// What the inputs of a program are.
#[derive(Clone, Debug)]
pub(super) struct Inputs {
    list: Vec<Input>,
    /// Whether the tangent or the bitangent is read.
    pub(super) anisotropic: bool,
}

impl Inputs {
    /// What the inputs stand for, by their names; those of a BRDF file by their places where a name says nothing.
    pub(super) fn of(program: &Program, text: &str) -> Result<Self, ShaderError> {
        let ports = &program.interface().inputs;
        let by_place = is_brdf_file(text) && ports.len() <= IN_ORDER.len();
        let named = |port: &Port| {
            let name = port.name.to_lowercase();
            NAMES.iter().find(|(_, names)| names.contains(&name.as_str())).map(|(input, _)| *input)
        };
        let by_place = by_place && ports.iter().any(|port| named(port).is_none());
        let mut list = Vec::with_capacity(ports.len());
        for (place, port) in ports.iter().enumerate() {
            if port.ty != (ValueType { scalar: Scalar::Float, columns: 1, rows: 3 }) {
                return Err(no_direction(port, "is no vec3"));
            }
            let input = if by_place { IN_ORDER.get(place).copied() } else { named(port) };
            list.push(input.ok_or_else(|| no_direction(port, "stands for no direction that is known"))?);
        }
        let tangents =
            ports.iter().zip(&list).filter(|(_, input)| matches!(input, Input::Tangent | Input::Bitangent));
        // Once it stands in the head of the function.
        let anisotropic = tangents.into_iter().any(|(port, _)| occurrences(text, &port.name) > 1);
        Ok(Self { list, anisotropic })
    }

    /// What each input of the program is.
    pub(super) fn in_order(&self) -> impl Iterator<Item = Input> + '_ {
        self.list.iter().copied()
    }

    /// Every vector, by the number of its [`Input`].
    pub(super) fn vectors(light: [f32; 3], view: [f32; 3]) -> [[f32; 3]; 6] {
        let sum: [f32; 3] = std::array::from_fn(|i| light[i] + view[i]);
        let length = (sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]).sqrt().max(1e-12);
        let half = sum.map(|x| x / length);
        [light, view, [0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], half]
    }
}

fn no_direction(port: &Port, what: &str) -> ShaderError {
    let known = "a BRDF takes vec3 L, V, N, and X, Y (tangent and bitangent) or H where it needs them";
    ShaderError::Invalid {
        message: format!("the parameter '{}' of this function {what}", port.name),
        place: port.place.clone(),
        hints: vec![known.to_owned(), "other parameters are uniforms: uniform float n = 20.0;".to_owned()],
    }
}

/// How often a name stands in the code, comments and members aside.
fn occurrences(text: &str, name: &str) -> usize {
    let mut code = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(start) = rest.find("//").into_iter().chain(rest.find("/*")).min() {
        code.push_str(&rest[..start]);
        code.push(' ');
        let end = if rest[start..].starts_with("//") { "\n" } else { "*/" };
        rest = rest[start + 2..].split_once(end).map_or("", |(_, after)| after);
    }
    code.push_str(rest);
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
    code.match_indices(name)
        .filter(|(at, _)| {
            let (before, after) = (code[..*at].trim_end(), &code[at + name.len()..]);
            !before.ends_with('.') && !code[..*at].ends_with(is_word) && !after.starts_with(is_word)
        })
        .count()
}

#[cfg(test)]
mod tests {
    use super::occurrences;

    #[test]
    fn names_are_counted_in_code_only() {
        let text = "vec3 f(vec3 X) { // X\n return a.X + X2 + bX /* X X */ + dot(X, X); }";
        assert_eq!(occurrences(text, "X"), 3);
        assert_eq!(occurrences("/* X", "X"), 0);
    }
}
