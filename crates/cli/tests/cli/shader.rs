//! `glanz shader check`: what a shader takes, and errors at the line of the one who wrote it.

use crate::folder::Folder;

pub(crate) const VERTEX: &str = "\
#version 330
uniform mat4 modelViewProjection;
layout(location = 0) in vec3 aPos;
layout(location = 1) in vec3 aNormal;
out vec3 normal;
void main() {
    normal = aNormal;
    gl_Position = modelViewProjection * vec4(aPos, 1.0);
}
";

pub(crate) const FRAGMENT: &str = "\
#version 330
uniform vec3 lightPos = vec3(0.0, 0.0, 1.0);
uniform float exposure = 1.5;
in vec3 normal;
out vec4 color;
void main() {
    float cosTheta = max(dot(normalize(normal), normalize(lightPos)), 0.0);
    color = vec4(vec3(exposure * cosTheta), 1.0);
}
";

fn folder() -> Folder {
    let folder = Folder::new();
    folder.write("a.vert", VERTEX);
    folder.write("a.frag", FRAGMENT);
    folder
}

#[test]
fn what_a_shader_takes_is_told_with_what_it_stands_for() {
    let run = folder().glanz(&["shader", "check", "a.vert", "a.frag"]);
    let text = run.text();
    for line in [
        "  in       aPos vec3 = position",
        "  uniform  modelViewProjection mat4 = model view projection",
        "  uniform  lightPos vec3 = light position",
        "  uniform  exposure float",
        "  out      color vec4",
    ] {
        assert!(text.lines().any(|own| own == line), "{line}\n{text}");
    }
    assert!(!text.contains("warning"), "{text}");
}

#[test]
fn what_is_probably_not_meant_is_a_warning_with_its_line() {
    let folder = folder();
    folder.write("raw.frag", FRAGMENT.replace("normalize(normal)", "normal"));
    folder.write(
        "other.frag",
        FRAGMENT.replace("in vec3 normal;", "in vec3 norm;").replace("(normal)", "(norm)"),
    );
    let run = folder.glanz(&["shader", "check", "raw.frag", "--format", "json"]);
    let json = run.json();
    assert_eq!(json["shaders"][0]["warnings"][0]["line"], 7, "{json}");
    let run = folder.glanz(&["shader", "check", "a.vert", "other.frag", "--format", "json"]);
    let json = run.json();
    let message = json["between"][0]["message"].as_str().unwrap();
    assert!(message.starts_with("the fragment shader takes 'norm'"), "{message}");
}

#[test]
fn an_error_has_the_line_of_the_file_that_it_is_in() {
    let folder = folder();
    folder.write("light.glsl", "float light(vec3 n) {\n  return n.z * half;\n}\n");
    folder.write(
        "b.frag",
        "#version 330\n#include \"light.glsl\"\nout vec4 c;\nvoid main() { c = vec4(light(vec3(1.0))); }\n",
    );
    let run = folder.glanz(&["shader", "check", "b.frag"]);
    assert_eq!(run.code, 3, "{}", run.stderr);
    assert!(run.stderr.contains("light.glsl:2:"), "{}", run.stderr);
    folder.write("c.frag", "#version 330\n#include \"../light.glsl\"\nvoid main() {}\n");
    let run = folder.glanz(&["shader", "check", "c.frag"]);
    assert!(run.code == 3 && run.stderr.contains("../light.glsl"), "{}", run.stderr);
}
