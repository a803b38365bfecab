//! Warnings of what is right but probably not meant.

use crate::common::fragment;

fn warnings(body: &str) -> Vec<String> {
    let text = format!(
        "#version 330\nin vec3 normal; in vec3 position; uniform vec3 light; uniform float angle_deg;\nout vec4 c;\nvoid main() {{\n{body}\n}}"
    );
    fragment(&text).warnings().iter().map(|w| w.message.clone()).collect()
}

#[test]
fn a_right_shader_has_none() {
    let body = "vec3 N = normalize(normal); vec3 L = normalize(light - position);
        float cosine = max(dot(N, L), 0.0); vec3 R = reflect(-L, N);
        c = vec4(cosine + pow(max(dot(R, normalize(-position)), 0.0), 32.0) + cos(radians(angle_deg)));";
    assert_eq!(warnings(body), Vec::<String>::new());
}

#[test]
fn first_mistakes_are_told_with_their_lines() {
    for (body, part) in [
        ("c = vec4(cos(45.0));", "radians"),
        ("c = vec4(sin(angle_deg));", "radians"),
        ("c = vec4(max(dot(normal, light), 0.0));", "normalize(normal)"),
        ("vec3 N = normal; c = vec4(max(dot(N, light), 0.0));", "normalize(normal)"),
        (
            "vec3 N = normalize(normal); vec3 L = light; c = vec4(max(dot(N, L), 0.0)) + reflect(L, N).xyzz;",
            "reflect(-L",
        ),
        ("vec3 N = normalize(normal); vec3 L = light; c = vec4(1.0) * dot(N, L);", "max(dot(N, L), 0.0)"),
        (
            "vec3 N = normalize(normal); vec3 L = light; float d = dot(N, L); c = vec4(d);",
            "max(dot(N, L), 0.0)",
        ),
        ("c = vec4(pow(dot(light, position), 8.0));", "pow of a negative"),
        ("c = vec4(1.0 / (4.0 * dot(light, position)));", "divides by a dot"),
    ] {
        let found = warnings(body);
        assert!(found.len() == 1 && found[0].contains(part), "{body}\n{found:?}");
    }
    let program = fragment(
        "#version 330\nin vec3 normal;\nout vec4 c;\nout vec4 unused;\nvoid main() {\n c = vec4(dot(normal, vec3(1.0)));\n}",
    );
    let lines: Vec<u32> = program.warnings().iter().map(|w| w.place.as_ref().unwrap().line).collect();
    assert_eq!(lines, [4, 6], "{:?}", program.warnings());
    assert!(program.warnings()[0].message.contains("never written"));
    let old = fragment("#version 330\nvarying float x; void main() { gl_FragColor = vec4(x); }");
    assert!(old.warnings()[0].message.contains("'in' since"));
}
