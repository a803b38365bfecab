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
