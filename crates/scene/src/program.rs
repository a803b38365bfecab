//! Programs of the user's own in place of the material's light: a vertex and a fragment shader, and values for them.

use std::collections::BTreeMap;

use glanz_shader::included_path;
use serde::{Deserialize, Serialize};

/// The text of a shader, GLSL or WGSL, with the files that it includes.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct ProgramText {
    /// The name of its file, which errors show; `.wgsl` at its end tells the language.
    pub name: String,
    /// The text.
    pub text: String,
    /// The texts of what it includes, by the paths that `#include` has.
    pub includes: BTreeMap<String, String>,
}

/// What a uniform of a program is set to.
///
/// ```
/// use glanz_scene::{Program, UniformValue};
///
/// let program = Program::default().with_uniform("tint", &[1.0, 0.5, 0.0]);
/// assert_eq!(program.uniforms["tint"], UniformValue::Numbers(vec![1.0, 0.5, 0.0]));
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum UniformValue {
    /// One number per component, column by column of a matrix; a truth value is 0 or 1.
    Numbers(Vec<f64>),
    /// A texture: its index in [`Scene::textures`](crate::Scene::textures). Of a cube map's sampler it is a panorama in
    /// equirectangular projection, as [`EnvironmentMap`](crate::EnvironmentMap).
    Texture(usize),
    /// The faces of a cube map, +X, −X, +Y, −Y, +Z, −Z, each with its first row at t = 0 as in OpenGL: indices in
    /// [`Scene::textures`](crate::Scene::textures).
    Cube([usize; 6]),
}

impl UniformValue {
    /// The textures that it names.
    pub fn textures(&self) -> &[usize] {
        match self {
            Self::Numbers(_) => &[],
            Self::Texture(texture) => std::slice::from_ref(texture),
            Self::Cube(faces) => faces,
        }
    }
}

/// The names that the faces of a cube map may have in place of the `*` in a pattern such as `sky_*.png`, in OpenGL's order;
/// nothing where there is no `*`.
///
/// ```
/// let names = glanz_scene::cube_face_files("sky_*.png");
/// assert_eq!((names[0][0].as_str(), names[1][5].as_str()), ("sky_px.png", "sky_negz.png"));
/// assert!(glanz_scene::cube_face_files("sky.png").is_empty());
/// ```
pub fn cube_face_files(pattern: &str) -> Vec<[String; 6]> {
    const NAMES: [[&str; 6]; 4] = [
        ["px", "nx", "py", "ny", "pz", "nz"],
        ["posx", "negx", "posy", "negy", "posz", "negz"],
        ["right", "left", "top", "bottom", "front", "back"],
        ["0", "1", "2", "3", "4", "5"],
    ];
    let Some((before, behind)) = pattern.split_once('*') else { return Vec::new() };
    NAMES.map(|names| names.map(|name| format!("{before}{name}{behind}"))).to_vec()
}

/// Shaders that draw an object, or a whole scene. What is left out is as the material says: without a vertex shader
/// positions are projected as always, without a fragment shader the colour that the vertex shader gives is shown.
///
/// ```
/// use glanz_scene::{Mesh, Program, ProgramText, Scene, library};
///
/// let normals = "in vec3 normal; out vec4 color; void main() { color = vec4(0.5 + 0.5 * normalize(normal), 1.0); }";
/// let mut scene = Scene::new().with_mesh(Mesh::builtin("sphere")?, library::material("gold")?);
/// scene.set_program(Program::of_fragment(ProgramText::new("normals.frag", normals)));
/// assert_eq!(scene.program_of(0).and_then(|program| program.fragment.as_ref()).map(|text| &*text.name), Some("normals.frag"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Program {
    /// The vertex shader.
    pub vertex: Option<ProgramText>,
    /// The fragment shader.
    pub fragment: Option<ProgramText>,
    /// What uniforms are set to, by the names that the source gives them (`lights[2].position`); others are filled by what
    /// their names stand for.
    pub uniforms: BTreeMap<String, UniformValue>,
}

impl ProgramText {
    /// A text that includes nothing.
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Self {
        Self { name: name.into(), text: text.into(), includes: BTreeMap::new() }
    }

    /// A text with what it includes. `read` gives the text of a path, seen from the text's folder; where it gives none, the
    /// compiler will say so at the line that asks for it.
    pub fn with_includes(
        name: impl Into<String>,
        text: impl Into<String>,
        read: &mut dyn FnMut(&str) -> Option<String>,
    ) -> Self {
        let mut program = Self::new(name, text);
        let mut wanted = included("", &program.text);
        while let Some(paths) = wanted.pop() {
            if paths.iter().any(|path| program.includes.contains_key(path)) {
                continue;
            }
            let found = paths.into_iter().find_map(|path| Some((read(&path)?, path)));
            if let Some((text, path)) = found {
                wanted.extend(included(&path, &text));
                program.includes.insert(path, text);
            }
        }
        program
    }
}

impl Program {
    /// A fragment shader alone.
    pub fn of_fragment(text: ProgramText) -> Self {
        Self { fragment: Some(text), ..Self::default() }
    }

    /// The same with a uniform set to numbers.
    #[must_use]
    pub fn with_uniform(mut self, name: impl Into<String>, values: &[f64]) -> Self {
        self.uniforms.insert(name.into(), UniformValue::Numbers(values.to_vec()));
        self
    }
}

/// The paths of a text's `#include` lines, whether or not these are reached: each seen from the text's own path, then from
/// the first one's folder.
fn included(from: &str, text: &str) -> Vec<Vec<String>> {
    let paths = |line: &str| {
        let rest = line.trim_start().strip_prefix('#')?.trim_start().strip_prefix("include")?.trim_start();
        let end = match rest.chars().next()? {
            quote @ ('"' | '\'') => quote,
            '<' => '>',
            _ => return None,
        };
        let (path, _) = rest[1..].split_once(end)?;
        let mut paths: Vec<String> =
            [included_path(from, path), included_path("", path)].into_iter().flatten().collect();
        paths.dedup();
        Some(paths)
    };
    text.lines().filter_map(paths).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_includes_include_is_read_once() {
        let mut asked = Vec::new();
        let mut read = |path: &str| {
            asked.push(path.to_owned());
            match path {
                "a.glsl" => Some("#include \"b.glsl\"\n#include \"a.glsl\"\n".to_owned()),
                "b.glsl" => Some("float f() { return 1.0; }".to_owned()),
                _ => None,
            }
        };
        let text = "#version 330\n # include <a.glsl>\n#include \"gone.glsl\"\nvoid main() {}";
        let program = ProgramText::with_includes("x.frag", text, &mut read);
        assert_eq!(program.includes.keys().collect::<Vec<_>>(), ["a.glsl", "b.glsl"]);
        asked.sort();
        assert_eq!(asked, ["a.glsl", "b.glsl", "gone.glsl"]);
    }
}
