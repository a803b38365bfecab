//! What of GLSL and WGSL is read, and what is refused by name.

use glanz_shader::{Interpolation, Role, Shader, ShaderError, Stage};

use crate::common::{self, error, fragment, outputs, value};

#[test]
fn every_version_of_a_small_shader_gives_the_same() {
    for text in [
        "#version 110\nvarying float x; void main() { gl_FragColor = vec4(x * 2.0); }",
        "varying highp float x; void main() { gl_FragColor = vec4(x * 2.0); }",
        "#version 100\nprecision mediump float; varying float x; void main() { gl_FragColor = vec4(x * 2.0); }",
        "#version 300 es\nprecision highp float; in lowp float x; out vec4 c; void main() { c = vec4(x * 2.0); }",
        "#version 330 core\nin float x; layout(location = 0) out vec4 c; void main() { c = vec4(x * 2.0); }",
        "#version 460\nlayout(location = 3) in float x; out vec4 c; void main() { c = vec4(x * 2.0); }",
        "#version 120\n#extension GL_ARB_x : enable\n#pragma debug(on)\nvarying float x;\nvoid main() { gl_FragData[0] = vec4(x * 2.0); }",
        "#version 330\nin Data { float x; } data; out vec4 c; void main() { c = vec4(data.x * 2.0); }",
        "#version 330\nin Data { float x; }; out vec4 c; void main() { c = vec4(x * 2.0); }",
        "float twice(float x) { return x * 2.0; }",
    ] {
        assert_eq!(value(text, 1.5), 3.0, "{text}");
    }
    let wgsl = common::wgsl(
        "@fragment fn main(@location(0) x: f32) -> @location(0) vec4<f32> { return vec4(x * 2.0); }",
    );
    assert_eq!(outputs(&wgsl, &|_, _, _| 1.5)[0][0], 3.0);
    let function = common::wgsl("fn twice(x: f32) -> f32 { return x * 2.0; }");
    assert_eq!((outputs(&function, &|_, _, _| 1.5)[0][0], &*function.interface().inputs[0].name), (3.0, "x"));
}

#[test]
fn uniforms_of_all_kinds_have_names_and_values() {
    let program = fragment(
        "#version 420
        layout(std140) uniform;
        struct Light { vec3 position; bool on; };
        const int N = 2;
        uniform Light lights[N];
        uniform struct Fog { vec4 color; float density; } fog;
        layout(std140, binding = 2) uniform Matrices { mat4 view; layout(row_major) mat3 small; } matrices;
        uniform Loose { float gain; };
        layout(location = 4) uniform float time = 1.5, scale[2];
        out vec4 c;
        void main() { c = lights[1].position.xyzz * gain * time * scale[1] + fog.color * fog.density + matrices.view[0]; }",
    );
    let names: Vec<&str> = program.interface().uniforms.iter().map(|u| u.name.as_str()).collect();
    let expected = [
        "lights[0].position",
        "lights[0].on",
        "lights[1].position",
        "lights[1].on",
        "fog.color",
        "fog.density",
        "Matrices.view",
        "Matrices.small",
        "gain",
        "time",
        "scale[0]",
        "scale[1]",
    ];
    assert_eq!(names, expected);
    let mut uniforms = program.uniforms();
    assert_eq!(uniforms.get("time"), Some(vec![1.5]));
    for (name, values) in
        [("lights[1].position", &[1.0, 2.0, 3.0][..]), ("gain", &[2.0]), ("scale[1]", &[10.0])]
    {
        uniforms.set(name, values).unwrap();
    }
    let out = common::outputs_at(&program, &uniforms, Default::default(), &|_, _, _| 0.0);
    assert_eq!([out[0][0], out[1][0], out[2][0]], [30.0, 60.0, 90.0]);
    assert_eq!(
        program.interface().uniform("lights[1].position").and_then(|u| u.role),
        Some(Role::LightPosition)
    );
    assert_eq!(
        uniforms.set("gian", &[0.0]).unwrap_err().to_string(),
        "there is no uniform 'gian'; did you mean 'gain'?"
    );
    assert!(uniforms.set("gain", &[0.0, 1.0]).unwrap_err().to_string().contains("float of 1 numbers, not 2"));
}

#[test]
fn a_vertex_shader_takes_attributes_and_gives_what_a_fragment_shader_takes() {
    let program = Shader::vertex(
        "#version 330
        layout(location = 1) in vec3 aPos; in mat4 instance; in vec2 uv[2];
        uniform mat4 MVP;
        out Varyings { vec3 normal; flat int id; } v; noperspective out float depth;
        void main() { gl_Position = MVP * instance * vec4(aPos, 1.0); v.normal = aPos; v.id = gl_VertexID; depth = uv[1].y; }",
    )
    .compile()
    .unwrap();
    let interface = program.interface();
    let inputs: Vec<&str> = interface.inputs.iter().map(|p| p.name.as_str()).collect();
    assert_eq!(inputs, ["aPos", "instance", "uv[0]", "uv[1]", "gl_VertexID"]);
    assert_eq!((interface.inputs[0].role, interface.inputs[0].location), (Some(Role::Position), Some(1)));
    let of = |name: &str| &interface.outputs[interface.output(name).unwrap()];
    assert!(of("gl_Position").builtin);
    assert_eq!(of("Varyings.id").interpolation, Interpolation::Flat);
    assert_eq!(of("depth").interpolation, Interpolation::Linear);
    assert_eq!(interface.uniforms[0].role, Some(Role::ModelViewProjection));
}

#[test]
fn the_fixed_pipeline_is_there() {
    let program = Shader::vertex(
        "varying vec4 c; void main() { gl_Position = ftransform(); gl_TexCoord[0] = gl_MultiTexCoord0;
         c = gl_LightSource[1].diffuse * gl_FrontMaterial.shininess + vec4(gl_NormalMatrix * gl_Normal, 1.0); }",
    )
    .compile()
    .unwrap();
    let interface = program.interface();
    assert_eq!(
        interface.uniform("gl_ModelViewProjectionMatrix").unwrap().role,
        Some(Role::ModelViewProjection)
    );
    assert_eq!(interface.uniform("gl_LightSource[1].diffuse").unwrap().role, Some(Role::LightColor));
    assert!(interface.output("gl_TexCoord[0]").is_some());
    assert_eq!(interface.inputs[interface.input("gl_Normal").unwrap()].role, Some(Role::Normal));
}

#[test]
fn shadertoy_runs() {
    let text = "void mainImage(out vec4 color, in vec2 place) { vec2 uv = place / iResolution.xy;
        color = vec4(uv, 0.5 + 0.5 * sin(iTime), float(iFrame)) + texture(iChannel0, uv) * 0.0; }";
    let program = fragment(text);
    let mut uniforms = program.uniforms();
    uniforms.set("iResolution", &[8.0, 4.0, 1.0]).unwrap();
    let out = common::outputs_at(&program, &uniforms, Default::default(), &|_, k, _| [2.0, 1.0, 0.0, 1.0][k]);
    assert_eq!([out[0][0], out[1][0], out[2][0]], [0.25, 0.25, 0.5]);
    assert_eq!(program.interface().inputs[0].name, "gl_FragCoord");
}

#[test]
fn a_brdf_file_runs_with_its_parameters() {
    let text = "analytic\n\n# a comment\n::begin parameters\nfloat n 1 100 20\ncolor kd 0.5 0.25 1\nbool on 1\n::end parameters\n\n::begin shader\n\
        vec3 BRDF( vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y )\n{\n  return on ? kd * n : vec3(dot(L, N));\n}\n::end shader\n";
    let program = fragment(text);
    let n = program.interface().uniform("n").unwrap();
    assert_eq!((n.range, n.place.as_ref().unwrap().line), (Some((1.0, 100.0)), 5));
    let names: Vec<&str> = program.interface().inputs.iter().map(|p| p.name.as_str()).collect();
    assert_eq!(names, ["L", "V", "N", "X", "Y"]);
    assert_eq!(outputs(&program, &|_, _, _| 0.0)[1][0], 5.0);
    let wrong = error(&text.replace("kd * n", "kd * m"));
    assert_eq!(wrong.to_string(), "x:13:20: 'm' is not declared");
}

#[test]
fn the_preprocessor_knows_macros_conditions_and_includes() {
    let text = "#version 330\n#define SQUARE(a) ((a) * (a))\n#define ADD(a, b) a + \\\n   b\n#define NAME(n) x ## n\n\
        #if defined(LIGHTS) && LIGHTS > 1 || 0\n#include \"lib/f.glsl\"\n#elif 1 / 0\n#else\n#error no lights\n#endif\n\
        #ifdef OTHER\nbroken(\n#endif\n#undef OTHER\n#define SELF SELF + 1.0\nin float x1; out float y; /* a\n comment */ float SELF_ = 0.0;\n\
        void main() { y = ADD(SQUARE(NAME(1) + 1.0), f(1.0)); }\n";
    let include = |path: &str, from: &str| {
        assert_eq!(from, "main.frag");
        (path == "lib/f.glsl").then(|| "float f(float v) { return v * 100.0; }".to_owned())
    };
    let shader = Shader::fragment(text).named("main.frag").include(&include);
    let program = shader.clone().define("LIGHTS", "2").compile().unwrap();
    assert_eq!(outputs(&program, &|_, _, _| 2.0)[0][0], 109.0);
    let error = shader.compile().unwrap_err();
    assert!(error.to_string().contains("division by 0"), "{error}");
}

#[test]
fn a_text_that_is_too_long_is_told_whether_macros_made_it_so() {
    let message = |text: String| error(&text).to_string();
    let plain = format!("#version 330\nvoid main() {{ float x;\n{}}}\n", "x = x + 1.0;\n".repeat(60_000));
    assert!(message(plain).contains("the text is too long: more than 200000 words"));
    let doubled: String = (1..20).map(|i| format!("#define M{i} M{0} M{0}\n", i - 1)).collect();
    let macros = format!("#version 330\n#define M0 x = x + 1.0;\n{doubled}void main() {{ float x; M19 }}\n");
    assert!(message(macros).contains("macros make the text too long"));
}

#[test]
fn what_is_not_there_is_refused_by_name_and_line() {
    for (text, part, line) in [
        ("#version 400\nsubroutine vec4 shade();\nvoid main() {}", "subroutine", 2),
        ("#version 330\nlayout(triangles) in;\nvoid main() {}", "geometry", 2),
        ("#version 430\nlayout(local_size_x = 8) in;\nvoid main() {}", "compute", 2),
        ("#version 400\nout vec4 c;\nvoid main() {\n double x = 1.0; }", "double", 4),
        ("#version 430\nuniform image2D picture;\nvoid main() {}", "image2D", 2),
        ("#version 430\nbuffer Data { float x; };\nvoid main() {}", "storage", 2),
        (
            "float f(float x);\nfloat g(float x) { return f(x); }\nfloat f(float x) { return g(x); }\nvoid main() { f(1.0); }",
            "recursion",
            2,
        ),
        ("uniform sampler2D maps[4][2];\nvoid main() {}", "arrays of arrays of samplers", 1),
        ("out vec4 c;\nvoid main() {\n float a[100000];\n a[0] = 1.0; c = vec4(a[0]); }", "too large", 3),
    ] {
        let error = error(text);
        let place = error.place().map(|place| place.line);
        assert!(matches!(error, ShaderError::Unsupported { .. }), "{error:?}");
        assert!(error.to_string().contains(part), "{error}");
        if !text.contains("recursion") && part != "recursion" {
            assert_eq!(place, Some(line), "{error}");
        }
    }
}

#[test]
fn uniforms_and_inputs_are_not_assigned_to() {
    for text in [
        "uniform float u;\nvoid main() {\n u = 1.0; gl_FragColor = vec4(u); }",
        "varying float u;\nvoid main() {\n u = 1.0; gl_FragColor = vec4(u); }",
    ] {
        let error = error(text);
        assert_eq!(error.place().map(|place| place.line), Some(3), "{error}");
        assert!(error.to_string().contains("assigned"), "{error}");
    }
}

#[test]
fn both_stages_may_stand_in_one_wgsl_text() {
    let text = "struct V { @builtin(position) p: vec4<f32>, @location(0) n: vec3<f32> }
        struct U { m: mat4x4<f32>, k: array<vec4<f32>, 2> } @group(0) @binding(0) var<uniform> u: U;
        @vertex fn vs(@location(0) a: vec3<f32>) -> V { return V(u.m * vec4(a, 1.0), a); }
        @fragment fn fs(v: V) -> @location(0) vec4<f32> { return vec4(normalize(v.n), v.p.x) * u.k[1]; }";
    for (stage, inputs, outputs) in [
        (Stage::Vertex, vec!["a"], vec!["gl_Position", "n"]),
        (Stage::Fragment, vec!["gl_FragCoord", "n"], vec!["result"]),
    ] {
        let program = Shader::new(stage, text).named("both.wgsl").compile().unwrap();
        let names = |ports: &[glanz_shader::Port]| ports.iter().map(|p| p.name.clone()).collect::<Vec<_>>();
        assert_eq!(names(&program.interface().inputs), inputs);
        assert_eq!(names(&program.interface().outputs), outputs);
        assert_eq!(program.interface().uniforms[0].name, "u.m");
    }
}

#[test]
fn a_function_may_end_without_a_return() {
    let text = "float f(float x) { for (int i = 0; i < 9; i++) { if (float(i) > x) return float(i); } }
        struct S { float a; }; S g(float x) { if (x > 1.0) { S s; s.a = x; return s; } else return S(0.5); }
        varying float x; void main() { gl_FragColor = vec4(f(x), g(x).a, 0.0, 0.0); }";
    assert_eq!(value(text, 2.5), 3.0);
    assert_eq!(value(text, 20.0), 0.0, "it is undefined in GLSL, and 0 here");
}

#[test]
fn an_array_takes_its_size_from_its_value() {
    let text = "const vec2 p[] = vec2[](vec2(1.0, 2.0), vec2(3.0, 4.0));
        varying float x; void main() { float[] a = float[](x, max(x, 7.0), 3.0); float b[] = float[3](1.0, x, 5.0);
        gl_FragColor = vec4(a[1] + b[2] + float(a.length()) + p[1].y); }";
    assert_eq!(value(text, 2.5), 7.0 + 5.0 + 3.0 + 4.0);
}
