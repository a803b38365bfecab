//! `glanz shader`: what a shader takes, errors at the line of the one who wrote it, and what can be seen of it.

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

/// A fragment shader of names that stand for something.
pub(crate) const SIGHT: &str = "#version 330
in vec3 normal;
out vec4 color;
uniform float exposure = 1.0;
void main() {
    float up = normalize(normal).y;
    if (up < 0.0) {
        up = -up;
    }
    color = vec4(vec3(exposure * up), 1.0);
}
";

fn drawing() -> Folder {
    let folder = Folder::with_scene();
    folder.write("sight.frag", SIGHT);
    folder
}

#[test]
fn scenes_are_drawn_by_programs_of_the_command_line() {
    let folder = drawing();
    for (name, more) in [
        ("a.png", &["--fs", "sight.frag"][..]),
        // As the courses have it, with one dash.
        ("b.png", &["-fs", "sight.frag"]),
        ("c.png", &["--fs", "sight.frag", "--uniform", "exposure=0.5"]),
    ] {
        let words = [&["render", "scene.toml", "--size", "24x16", "-o", name], more].concat();
        assert_eq!(folder.glanz(&words).code, 0, "{words:?}");
    }
    assert_eq!(folder.read("a.png"), folder.read("b.png"));
    assert_ne!(folder.read("a.png"), folder.read("c.png"));
    let run = folder.glanz(&[
        "render",
        "scene.toml",
        "--fs",
        "sight.frag",
        "--uniform",
        "exposur=2",
        "-o",
        "d.png",
    ]);
    assert_eq!(run.code, 3);
    assert!(run.stderr.contains("did you mean 'exposure'"), "{}", run.stderr);
    assert!(!folder.path("d.png").exists());
    let run = folder.glanz(&["render", "scene.toml", "--uniform", "exposure=2", "-o", "d.png"]);
    assert_eq!(run.code, 2, "{}", run.stderr);
}

#[test]
fn an_error_of_a_program_shows_its_line() {
    let folder = drawing();
    folder.write("wrong.frag", SIGHT.replace("float up =", "float upp ="));
    let run = folder.glanz(&["render", "scene.toml", "--fs", "wrong.frag", "-o", "a.png"]);
    assert_eq!(run.code, 3);
    assert!(run.stderr.contains("wrong.frag:7") && run.stderr.contains("if (up < 0.0)"), "{}", run.stderr);
}

#[test]
fn programs_of_scenes_are_read_beside_them_with_what_they_include() {
    let folder = drawing();
    std::fs::create_dir_all(folder.path("shaders/lib")).unwrap();
    folder.write("shaders/own.frag", "#version 330\n#include \"lib/up.glsl\"\nin vec3 normal; out vec4 color; uniform float exposure;\nvoid main() { color = vec4(exposure * up(normal)); }\n");
    folder.write("shaders/lib/up.glsl", "float up(vec3 n) { return abs(normalize(n).y); }\n");
    let scene = String::from_utf8(folder.read("scene.toml")).unwrap();
    let program = "program = { fragment = 'shaders/own.frag', uniforms = { exposure = 0.5 } }\n";
    folder.write("own.toml", format!("{program}{scene}"));
    assert_eq!(folder.glanz(&["render", "own.toml", "--size", "24x16", "-o", "a.png"]).code, 0);
    let words = [
        "render",
        "scene.toml",
        "--fs",
        "sight.frag",
        "--uniform",
        "exposure=0.5",
        "--size",
        "24x16",
        "-o",
        "b.png",
    ];
    assert_eq!(folder.glanz(&words).code, 0);
    // The files differ by the number of their scene.
    assert_eq!(folder.glanz(&["compare", "a.png", "b.png", "--fail-above", "rmse=0"]).code, 0);
    folder.write("none.toml", format!("program = {{ fragment = 'none.frag' }}\n{scene}"));
    let run = folder.glanz(&["render", "none.toml", "-o", "c.png"]);
    assert!(run.code == 3 && run.stderr.contains("there is no file 'none.frag'"), "{}", run.stderr);
    folder.write("empty.toml", format!("program = {{ uniforms = {{ x = 1 }} }}\n{scene}"));
    let run = folder.glanz(&["render", "empty.toml", "-o", "c.png"]);
    assert!(run.stderr.contains("a program needs 'vertex', 'fragment' or both"), "{}", run.stderr);
}

#[test]
fn every_value_of_a_pixel_is_told_with_its_line() {
    let folder = drawing();
    let words = ["shader", "xray", "scene.toml", "--fs", "sight.frag", "--pixel", "12,8", "--size", "24x16"];
    let text = folder.glanz(&words).text().to_owned();
    assert!(text.contains("    6  up = ") && text.contains("float up = normalize(normal).y;"), "{text}");
    let json = folder.glanz(&[&words[..], &["--format", "json"]].concat()).json();
    let records = json["records"].as_array().unwrap();
    let branch = records.iter().find(|record| record["kind"] == "branch").unwrap();
    assert_eq!((branch["line"].as_u64(), branch["name"].as_str()), (Some(7), Some("if")), "{branch}");
    let run = folder.glanz(&[
        "shader",
        "picture",
        "scene.toml",
        "--fs",
        "sight.frag",
        "--value",
        "upp",
        "-o",
        "v.png",
    ]);
    assert!(run.code == 3 && run.stderr.contains("did you mean 'up'"), "{}", run.stderr);
}

#[test]
fn what_is_exported_draws_the_scene_itself() {
    let folder = drawing();
    folder.glanz(&["shader", "export", "scene.toml", "-o", "program"]).text();
    folder.glanz(&["render", "scene.toml", "-o", "a.exr"]).text();
    let files: Vec<_> =
        std::fs::read_dir(folder.path("program")).unwrap().map(|entry| entry.unwrap().path()).collect();
    let fragments = files.iter().filter(|path| path.extension().is_some_and(|ending| ending != "vert"));
    for path in fragments {
        let path = path.to_str().unwrap();
        folder.glanz(&["render", "scene.toml", "--fs", path, "-o", "b.exr"]).text();
        let run = folder.glanz(&["compare", "a.exr", "b.exr", "--fail-above", "rmse=0.001"]);
        assert_eq!(run.code, 0, "{path}: {}", run.stderr);
    }
}

#[test]
fn the_shaders_of_a_scene_can_be_printed() {
    let folder = drawing();
    let own = folder.glanz(&["render", "scene.toml", "-fs", "sight.frag", "-ps"]);
    assert!(own.text().contains("// sight.frag") && own.text().contains("exposure * up"));
    assert!(folder.glanz(&["render", "scene.toml", "--ps"]).text().contains("reflect(-L, N)"));
    let listed = folder.glanz(&["shader", "list", "--format", "json"]).json();
    for program in listed["programs"].as_array().unwrap() {
        let name = program["name"].as_str().unwrap();
        let text = folder.glanz(&["shader", "print", name, "--stage", "fragment"]).text().to_owned();
        assert!(text.contains("main"), "{name}");
    }
}
