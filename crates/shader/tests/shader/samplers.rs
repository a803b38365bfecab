//! Samplers in arrays and structs, cubes, and what is gathered.

use glanz_math::SimdLevel;
use glanz_shader::{Lod, Machine, Program, Row, TextureQuery, Textures};

use crate::common;

/// A texture gives its number, then its coordinates; what is gathered, the component and the offset.
struct Numbered;

impl Textures for Numbered {
    fn sample(&self, query: &TextureQuery, texels: &mut [[f32; 16]; 4]) {
        texels[0] = [query.texture as f32; 16];
        texels[1..].copy_from_slice(&query.coordinates);
        if let Lod::Gather(component) = query.lod {
            texels[3] = [(100 * component) as f32 + query.offset[0] as f32; 16];
        }
    }
}

/// The first output in each lane, whose number is the first input.
fn values(program: &Program) -> Vec<[f32; 16]> {
    let uniforms = program.uniforms();
    let mut machine = Machine::<1>::new(program, &uniforms, &Numbered, SimdLevel::best());
    if !program.interface().inputs.is_empty() {
        machine.input(0, 0)[0] = Row(std::array::from_fn(|lane| lane as f32));
    }
    machine.run().expect("it ends");
    (0..program.interface().outputs[0].ty.scalars()).map(|k| machine.output(0, k)[0].0).collect()
}

/// The names of its textures, and the value of an expression in each lane.
fn look(head: &str, expression: &str) -> (Vec<String>, [f32; 16]) {
    let text = format!(
        "#version 330\nin float x; out float y; const int N = 2, M = N + 1;\n{head}\nvoid main() {{ y = {expression}; }}"
    );
    let program = common::fragment(&text);
    let names = program.interface().textures.iter().map(|own| own.name.clone()).collect();
    (names, values(&program)[0])
}

#[test]
fn elements_of_arrays_are_samplers_of_their_own() {
    let (names, [value, ..]) = look(
        "uniform sampler2D first; uniform sampler2D maps[3];",
        "100.0 * texture(maps[1], vec2(0.0)).x + 10.0 * texture(maps[M - 3], vec2(0.0)).x + texture(maps[N], vec2(0.0)).x",
    );
    assert_eq!(names, ["first", "maps[0]", "maps[1]", "maps[2]"]);
    assert_eq!(value, 213.0);
    let (names, [value, ..]) = look(
        "struct Material { vec3 k; sampler2D diffuse; sampler2D more[2]; float shininess; };
         uniform Material materials[M - 1]; float of(sampler2D s) { return texture(s, vec2(0.0)).x; }",
        "10.0 * of(materials[1].diffuse) + texture(materials[1].more[1], vec2(0.0)).x + materials[1].shininess",
    );
    assert_eq!(names[..3], ["materials[0].diffuse", "materials[0].more[0]", "materials[0].more[1]"]);
    assert_eq!((names.len(), value), (6, 35.0));
}

#[test]
fn other_indices_choose_among_all() {
    let head = "uniform sampler2D maps[M]; uniform sampler2D more[2];
        float of(sampler2D s, float k) { return texture(s, vec2(k)).x + 0.5; }";
    let (_, lanes) = look(head, "texture(maps[int(x) % 3], vec2(x)).x");
    assert_eq!(lanes[..5], [0.0, 1.0, 2.0, 0.0, 1.0]);
    let (_, lanes) = look(head, "of(more[uint(x) & 1u], texture(maps[int(x) / 2], vec2(0.0)).x)");
    assert_eq!(lanes[..4], [3.5, 4.5, 3.5, 4.5]);
    let (_, lanes) = look(head, "texture(more[int(texture(maps[int(x)], vec2(0.0)).x) - 1], vec2(0.0)).x");
    assert_eq!(lanes[1..3], [3.0, 4.0]);
    let program = common::fragment(
        "uniform sampler2D maps[3]; out float y; void main() { for (int i = 0; i < 3; i++) y = 10.0 * y + texture(maps[i], vec2(0.0)).x; }",
    );
    assert_eq!(values(&program)[0][0], 12.0);
}

#[test]
fn what_is_no_single_sampler_is_refused_with_its_line() {
    for (text, said) in [
        (
            "uniform sampler2D s[2]; vec4 f(sampler2D t) { return texture(t, vec2(0.0)); }\nvoid main() { gl_FragColor = f(s); }",
            "2:32: 's' is an array",
        ),
        (
            "uniform sampler2D s[2]; int i = 0;\nvoid main() { gl_FragColor = texture(s[i++], vec2(0.0)); }",
            "2:38: 's' is an array of samplers, whose index must be a constant",
        ),
        (
            "uniform sampler2D s[2]; void main() { gl_FragColor = vec4(0.0); }\nvec4 f(sampler2D t[2]) { return vec4(0.0); }",
            "2:18: arrays of samplers as parameters",
        ),
        ("uniform int n; uniform sampler2D\n s[n]; void main() { }", "2:2: the size of an array of samplers"),
        ("uniform sampler2D s[2][2]; void main() { }", "arrays of arrays"),
    ] {
        let error = common::error(text).to_string();
        assert!(error.contains(said), "{error}");
    }
}

#[test]
fn cubes_are_looked_into_by_directions_in_old_and_new_texts() {
    for text in [
        "#version 120\nuniform samplerCube sky; varying float x; void main() { gl_FragColor = textureCube(sky, vec3(1.0, x, 2.0)); }",
        "#version 330\nuniform samplerCube sky; in float x; out vec4 c; void main() { c = textureLod(sky, vec3(1.0, x, 2.0), 1.0); }",
    ] {
        let program = common::fragment(text);
        assert_eq!(program.interface().textures[0].dimension, "cube");
        assert_eq!(values(&program).iter().map(|row| row[3]).collect::<Vec<_>>(), [0.0, 1.0, 3.0, 2.0]);
    }
    let program = common::wgsl(
        "@group(0) @binding(0) var sky: texture_cube<f32>; @group(0) @binding(1) var s: sampler;
         @fragment fn main(@location(0) x: f32) -> @location(0) vec4<f32> { return textureSample(sky, s, vec3(1.0, x, 2.0)); }",
    );
    assert_eq!(values(&program).iter().map(|row| row[3]).collect::<Vec<_>>(), [0.0, 1.0, 3.0, 2.0]);
}

#[test]
fn components_are_gathered_in_glsl_and_wgsl() {
    let gathered = |expression: &str| {
        look(
            "uniform sampler2D a; uniform sampler2D b; vec4 of(sampler2D s, vec2 p) { return textureGather(s, p, M - 1); }",
            expression,
        )
        .1[5]
    };
    assert_eq!(gathered("textureGather(b, vec2(x, 0.0), 3).w"), 300.0);
    assert_eq!(gathered("textureGather(b, vec2(x, 0.0)).y"), 5.0);
    assert_eq!(gathered("textureGatherOffset(b, vec2(x, 0.0), ivec2(7, 0), 1).w"), 107.0);
    assert_eq!(gathered("of(b, vec2(x)).w + 1000.0 * of(b, vec2(x)).x"), 1200.0);
    let program = common::wgsl(
        "@group(0) @binding(0) var t: texture_2d<f32>; @group(0) @binding(1) var s: sampler;
         @fragment fn main(@location(0) x: f32) -> @location(0) vec4<f32> { return textureGather(2, t, s, vec2(x, 1.0)); }",
    );
    assert_eq!(values(&program)[3][0], 200.0);
    let own = "vec4 textureGather(sampler2D s, vec2 p) { return vec4(9.0); } uniform sampler2D t;";
    assert_eq!(look(own, "textureGather(t, vec2(x)).x").1[0], 9.0, "a function of the text's own");
    let error = common::error(
        "#version 400\nuniform sampler2D t; uniform int c; out vec4 o;\nvoid main() { o = textureGather(t, vec2(0.0), c); }",
    );
    assert!(
        error.to_string().contains("3:") && error.to_string().contains("the component must be a constant"),
        "{error}"
    );
}
