//! Errors stand in the user's text.

use glanz_shader::{Shader, ShaderError};

use crate::common::error;

fn line_and_column(text: &str) -> (u32, u32) {
    let error = error(text);
    let place = error.place().unwrap_or_else(|| panic!("{error:?} has no place"));
    (place.line, place.column)
}

#[test]
fn errors_have_the_line_and_column_of_the_source() {
    for (text, place) in [
        ("#version 330\nout vec4 c;\nvoid main() {\n  c = vec4(unknown);\n}", (4, 12)),
        ("#version 330\nout vec4 c;\nvoid main() {\n  c = vec4(1.0)\n}", (4, 15)),
        (
            "#version 330\nuniform vec3 a;\n\n/* two\nlines */ out vec4 c;\nvoid main() { c = vec4(a) + nothing(1.0); }",
            (6, 29),
        ),
        ("void main() {\n  gl_FragColor = vec4(1.0);\n", (1, 13)),
        ("void main() {\n  gl_FragColor = vec4(1.0));\n}", (2, 27)),
        ("#version 331\nvoid main() {}", (1, 2)),
        ("void main() {}\n#if 1\n", (2, 2)),
        ("#define F(a, b) a\nvoid main() {\n  gl_FragColor = vec4(F(1.0));\n}", (3, 23)),
        ("void main() {\n  float é = 1.0; gl_FragColor = vec4(oops);\n}", (2, 38)),
    ] {
        assert_eq!(line_and_column(text), place, "{text}\n{}", error(text));
    }
}

#[test]
fn places_are_right_after_macros_includes_and_line_directives() {
    let include = |_: &str, _: &str| Some("\n\nfloat f() { return missing; }\n".to_owned());
    let text =
        "#define A vec4(1.0) \\\n  + vec4(2.0)\n#include \"f.glsl\"\nvoid main() { gl_FragColor = A; }";
    let error = Shader::fragment(text).include(&include).compile().unwrap_err();
    let place = error.place().unwrap();
    assert_eq!((place.file.as_str(), place.line, place.column), ("f.glsl", 3, 20));
    assert_eq!(
        line_and_column("#define A vec4(1.0) \\\n  + bad\n\nvoid main() {\n  gl_FragColor = A;\n}"),
        (5, 18)
    );
    assert_eq!(line_and_column("void f() {}\n#line 100\nvoid main() {\n  gl_FragColor = bad;\n}").0, 101);
}

#[test]
fn places_of_wgsl_and_of_validation_are_there() {
    let shader = |text: &str| Shader::fragment(text).named("a.wgsl").compile().unwrap_err();
    let error = shader("@fragment fn main() -> @location(0) vec4<f32> {\n  return vec4(x);\n}");
    assert_eq!(error.place().map(|p| (p.line, p.column)), Some((2, 15)), "{error}");
    let error =
        shader("@fragment fn main() -> @location(0) vec4<f32> {\n  let a = vec4(1.0);\n  return 1u;\n}");
    assert!(error.place().is_some_and(|place| place.line >= 1), "{error:?}");
}

#[test]
fn hints_say_what_may_help() {
    let hints = |text: &str| match error(text) {
        ShaderError::Invalid { hints, .. } => hints.join(" "),
        other => panic!("{other:?}"),
    };
    assert!(hints("void main() {\n float x = 1.0\n gl_FragColor = vec4(x); }").contains("end with"));
    assert!(!hints("out vec4 c; void main() { vec3 v; mat4 m; c = m * v; }").is_empty());
}

#[test]
fn a_member_that_is_not_there_comes_with_those_that_are() {
    let text = "#version 330\nstruct LightSource { vec4 posDir; float spotCutoff; };\nuniform LightSource light;\n\
        out vec4 c;\nvoid main() { c = light.position; }";
    match error(text) {
        ShaderError::Invalid { message, hints, .. } => {
            assert!(message.contains("'position'"), "{message}");
            assert!(
                hints.iter().any(|hint| hint.contains("LightSource has posDir, spotCutoff")),
                "{hints:?}"
            );
        }
        other => panic!("{other:?}"),
    }
}
