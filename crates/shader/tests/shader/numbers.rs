//! Numbers: functions, whole numbers, matrices, derivatives, the same bits on all levels.

use glanz_math::SimdLevel;
use glanz_shader::{Lod, Machine, Row, TextureQuery, Textures};

use crate::common::{self, Numbers, expression, fragment, outputs};

/// Sine and cosine within the range of their reduction; other functions by exp2 and log2.
const TOLERANCE: f64 = 2e-6;

#[test]
fn functions_agree_with_double_precision() {
    type Case = (&'static str, fn(f64) -> f64, f32, f32);
    let cases: [Case; 18] = [
        ("sin(x)", f64::sin, -50.0, 50.0),
        ("cos(x)", f64::cos, -50.0, 50.0),
        ("tan(x)", f64::tan, -1.4, 1.4),
        ("asin(x)", f64::asin, -1.0, 1.0),
        ("acos(x)", f64::acos, -1.0, 1.0),
        ("atan(x)", f64::atan, -30.0, 30.0),
        ("exp(x)", f64::exp, -20.0, 20.0),
        ("log(x)", f64::ln, 0.01, 90.0),
        ("exp2(x)", f64::exp2, -20.0, 20.0),
        ("log2(x)", f64::log2, 0.01, 90.0),
        ("sqrt(x)", f64::sqrt, 0.0, 90.0),
        ("sinh(x)", f64::sinh, -4.0, 4.0),
        ("cosh(x)", f64::cosh, -4.0, 4.0),
        ("tanh(x)", f64::tanh, -40.0, 40.0),
        ("fract(x)", |x| x - x.floor(), -5.0, 5.0),
        ("sign(x) * ceil(x)", |x| x.signum() * x.ceil(), -5.0, 5.0),
        ("mod(x, 3.0)", |x| x.rem_euclid(3.0), -9.5, 9.5),
        (
            "smoothstep(0.0, 2.0, x)",
            |x| {
                let t = (x / 2.0).clamp(0.0, 1.0);
                t * t * (3.0 - 2.0 * t)
            },
            -1.0,
            3.0,
        ),
    ];
    for (text, exact, low, high) in cases {
        let shader = format!("#version 330\nin float x; out float y; void main() {{ y = {text}; }}");
        let program = fragment(&shader);
        for block in 0..20 {
            let x = |lane: usize| low + (high - low) * ((block * 16 + lane) as f32 + 0.5) / 320.0;
            let got = outputs(&program, &|_, _, lane| x(lane))[0];
            for (lane, got) in got.into_iter().enumerate() {
                let expected = exact(f64::from(x(lane)));
                let error = (f64::from(got) - expected).abs() / expected.abs().max(1.0);
                assert!(error < TOLERANCE, "{text} at {}: {} for {expected}", x(lane), got);
            }
        }
    }
}

#[test]
fn awkward_arguments_have_defined_values() {
    assert_eq!(expression("pow(x, 2.0)", 0.0), 0.0);
    assert!(expression("pow(x, 2.0)", -1.0).is_nan(), "GLSL leaves it undefined, so it is told by NaN");
    assert_eq!(expression("log(x)", 0.0), f32::NEG_INFINITY);
    assert!(expression("log(x)", -1.0).is_nan());
    assert_eq!(expression("exp(x)", 100.0), f32::INFINITY);
    assert_eq!(expression("1.0 / x", 0.0), f32::INFINITY);
    assert_eq!(expression("int(x)", 1e20), i32::MAX as f32);
    assert_eq!(expression("float(isnan(sqrt(x)))", -1.0), 1.0);
}

#[test]
fn whole_numbers_wrap_and_divide_as_wgsl_says() {
    for (text, x, expected) in [
        ("int(x) / int(x - x)", 7.0, 7.0),
        ("int(x) % int(x - x)", 7.0, 0.0),
        ("int(x) % 4", -7.0, -3.0),
        ("int(x) / 2", -7.0, -3.0),
        ("(int(x) << 3) >> 1", 5.0, 20.0),
        ("int(x) >> 1", -8.0, -4.0),
        ("(int(x) ^ 3) | 8", 5.0, 14.0),
        ("~int(x)", 5.0, -6.0),
        ("bitCount(int(x))", 7.0, 3.0),
        ("findMSB(int(x))", 9.0, 3.0),
        ("findLSB(int(x))", 12.0, 2.0),
        ("bitfieldExtract(int(x), 1, 2)", 6.0, -1.0),
        ("bitfieldInsert(int(x), 3, 1, 2)", 1.0, 7.0),
        ("min(int(x), 3)", 7.0, 3.0),
        ("clamp(int(x), 1, 4)", 7.0, 4.0),
        ("abs(int(x))", -7.0, 7.0),
        ("sign(int(x))", -7.0, -1.0),
        ("uint(x) / 3u", 10.0, 3.0),
        ("2147483647 + int(x)", 1.0, -2147483648.0),
    ] {
        assert_eq!(expression(text, x), expected, "{text} at {x}");
    }
}

#[test]
fn matrices_multiply_by_columns_and_invert() {
    let text = "#version 330
        in float x; out vec4 r; out vec3 s; out float t;
        void main() {
            mat4 m = mat4(2, 0, 0, 1,  0, 3, 0, 0,  x, 0, 1, 0,  5, 6, 7, 1);
            r = inverse(m) * (m * vec4(1, 2, 3, 4));
            mat3 k = mat3(m);
            s = vec3(1, 2, 3) * k;
            t = determinant(m) + transpose(k)[0][2] + outerProduct(vec2(1, 2), vec2(3, 4))[1][0] + (k * k)[2].x;
        }";
    let out = outputs(&fragment(text), &|_, _, _| 0.5);
    for (k, expected) in [1.0, 2.0, 3.0, 4.0].into_iter().enumerate() {
        assert!((out[k][0] - expected).abs() < 1e-5, "{k}: {}", out[k][0]);
    }
    assert_eq!([out[4][0], out[5][0], out[6][0]], [2.0, 6.0, 3.5]);
    // Determinant 2·3·1·1 − 1·(…): by hand −9 + …, here from another order of the same matrix.
    let d = 3.0 * (2.0 * 1.0 * 1.0 - (5.0 * 1.0 - 0.5 * 7.0));
    assert_eq!(out[7][0], d + 0.5 + 4.0 + (2.0 * 0.5 + 0.5));
}

#[test]
fn structs_arrays_and_swizzles_keep_their_parts() {
    let text = "#version 330
        struct Inner { float a[2]; vec2 b; }; struct Outer { Inner i[2]; bool on; };
        uniform Outer u; uniform mat2 m; uniform int k = 1;
        in float x; out vec4 c;
        void change(inout Inner v, const in float f) { v.b.yx = v.b + f; v.a[k] *= 2.0; }
        void main() {
            Outer o = u;
            change(o.i[1], x);
            c.wz = o.i[1].b; c.x = o.i[k].a[k]; c.y = m[1][0] + (u.on ? 1.0 : 0.0);
        }";
    let program = fragment(text);
    let mut uniforms = program.uniforms();
    for (name, values) in [
        ("u.i[1].a[0]", &[1.0][..]),
        ("u.i[1].a[1]", &[3.0]),
        ("u.i[1].b", &[10.0, 20.0]),
        ("m", &[1.0, 2.0, 30.0, 4.0]),
        ("u.on", &[1.0]),
    ] {
        uniforms.set(name, values).unwrap();
    }
    let out = common::outputs_at(&program, &uniforms, SimdLevel::best(), &|_, _, _| 0.5);
    assert_eq!([out[0][0], out[1][0], out[2][0], out[3][0]], [6.0, 31.0, 10.5, 20.5]);
}

#[test]
fn derivatives_are_differences_in_quads() {
    let text = "#version 330
        in float x; out vec3 d; void main() { d = vec3(dFdx(x), dFdy(x), fwidth(x)); }";
    let out = outputs(&fragment(text), &|_, _, lane| ((lane % 4) * (lane % 4) + 10 * (lane / 4)) as f32);
    // Squares along x: 0 1 | 4 9.
    assert_eq!(out[0][..4], [1.0, 1.0, 5.0, 5.0]);
    assert_eq!(out[1], [10.0; 16]);
    assert_eq!(out[2][2], 15.0);
}

/// Tells the coordinates and derivatives that it is asked for.
struct Told;

impl Textures for Told {
    fn sample(&self, query: &TextureQuery, texels: &mut [[f32; 16]; 4]) {
        texels[0] = query.coordinates[0];
        texels[1] = query.coordinates[1];
        match &query.lod {
            Lod::Gradient { dx, bias, .. } => (texels[2], texels[3]) = (dx[0], *bias),
            Lod::Level(level) => texels[2] = *level,
            Lod::Gather(_) => unreachable!("nothing is gathered here"),
            Lod::Texel(level) => texels[2] = level.map(|l| l as f32),
        }
    }
    fn size(&self, texture: usize, level: u32) -> [u32; 3] {
        [64 >> level, 32 >> level, texture as u32]
    }
}

#[test]
fn textures_are_asked_with_coordinates_and_gradients() {
    let text = "#version 330
        struct Material { sampler2D diffuse; float shininess; };
        uniform sampler2D first; uniform Material material; uniform samplerCube sky;
        in vec2 uv; out vec4 a; out vec4 b; out vec4 c; out ivec2 size;
        vec4 look(sampler2D s, vec2 uv) { return texture(s, uv * 2.0, 0.5); }
        void main() {
            a = look(first, uv); b = textureLod(material.diffuse, uv.yx, 3.0);
            c = texture(sky, vec3(uv, 1.0)); size = textureSize(material.diffuse, 1);
        }";
    let program = fragment(text);
    let names: Vec<&str> = program.interface().textures.iter().map(|t| t.name.as_str()).collect();
    assert_eq!(names, ["first", "material.diffuse", "sky"]);
    let uniforms = program.uniforms();
    let mut machine = Machine::<1>::new(&program, &uniforms, &Told, SimdLevel::best());
    let uv = program.interface().input("uv").unwrap();
    machine.input(uv, 0)[0] = Row(std::array::from_fn(|lane| lane as f32));
    machine.input(uv, 1)[0] = Row::splat(0.25);
    machine.run().unwrap();
    let of = |name: &str, k| machine.output(program.interface().output(name).unwrap(), k)[0].0[5];
    assert_eq!([of("a", 0), of("a", 1), of("a", 2), of("a", 3)], [10.0, 0.5, 2.0, 0.5]);
    assert_eq!([of("b", 0), of("b", 1), of("b", 2)], [0.25, 5.0, 3.0]);
    assert_eq!([of("c", 0), of("c", 2)], [5.0, 1.0]);
    assert_eq!([of("size", 0).to_bits(), of("size", 1).to_bits()], [32, 16]);
}

/// Shaders that use much of the language.
const TEXTS: [&str; 3] = [
    include_str!("texts/loops.frag"),
    include_str!("texts/specular.frag"),
    include_str!("texts/specular.vert"),
];

#[test]
fn all_levels_give_the_same_bits() {
    let functions = "#version 330\nin vec3 x; out vec4 c; void main() {
        c = vec4(sin(x.x * 40.0) + pow(abs(x.y), x.z), exp(x.z) / x.x, atan(x.y, x.x) - acos(x.z), tanh(x.x));
        c.x += float(int(x.x * 1e9) % 1000) + refract(x, normalize(x.zyx), 0.7).y + float(uint(abs(x.y) * 4e9) >> 3u); }";
    let mut numbers = Numbers(7);
    for text in TEXTS.into_iter().chain([functions]) {
        let stage = if text.contains("gl_Position") {
            glanz_shader::Stage::Vertex
        } else {
            glanz_shader::Stage::Fragment
        };
        let program = glanz_shader::Shader::new(stage, text).compile().unwrap();
        let mut uniforms = program.uniforms();
        for uniform in &program.interface().uniforms {
            let values: Vec<f32> = (0..uniform.ty.scalars()).map(|_| numbers.unit() * 4.0).collect();
            uniforms.set(&uniform.name, &values).unwrap();
        }
        let inputs: Vec<f32> = (0..4096).map(|_| numbers.unit() * 2.0 - 1.0).collect();
        let results: Vec<Vec<[u32; 16]>> = SimdLevel::available()
            .into_iter()
            .map(|(_, level)| {
                let input = |i: usize, k: usize, lane: usize| inputs[i * 256 + k * 16 + lane];
                let out = common::outputs_at(&program, &uniforms, level, &input);
                out.into_iter()
                    .map(|row| row.map(|x| if x.is_nan() { 0x7fc0_0000 } else { x.to_bits() }))
                    .collect()
            })
            .collect();
        assert!(results.iter().all(|r| *r == results[0]), "{text}");
        assert!(results[0].iter().any(|row| row.iter().any(|x| *x != row[0])), "the lanes differ");
    }
}

/// A constant array of lights, and a sum over all by the index `i + k`.
fn with_many_lights(count: usize) -> String {
    let light = |i: usize| format!("Light(vec3({i}.0, 0.5, -{i}.25), {i}.5, {i})");
    let lights: Vec<String> = (0..count).map(light).collect();
    format!(
        "#version 330\nstruct Light {{ vec3 at; float power; int number; }}; flat in int k; out vec4 c;
         const Light lights[{count}] = Light[{count}]({});
         float twice(Light light) {{ return 2.0 * light.at.z; }}
         void main() {{
            vec4 sum = vec4(0.0);
            for (int i = 0; i < {count} - 16; i++) {{
                Light light = lights[i + k];
                sum += vec4(light.at.x, lights[i + k].power, lights[i + k].at[1 + k % 2], light.number);
            }}
            c = sum + twice(lights[k]);
         }}",
        lights.join(", ")
    )
}

#[test]
fn long_constant_arrays_need_no_registers() {
    for count in [18, 64, 85] {
        let program = fragment(&with_many_lights(count));
        assert!(program.size().2 < 120, "{count} lights take {} registers", program.size().2);
        let got = outputs(&program, &|_, _, lane| lane as f32);
        let lanes = |k: usize| [0, 1, 2, 3].map(|c: usize| got[c][k]);
        for (k, values) in (0..16).map(lanes).enumerate() {
            let mut expected = [-2.0 * (k as f32 + 0.25); 4];
            for i in k..k + count - 16 {
                let z = if k % 2 == 0 { 0.5 } else { -(i as f32 + 0.25) };
                let light = [i as f32, i as f32 + 0.5, z, i as f32];
                expected.iter_mut().zip(light).for_each(|(sum, value)| *sum += value);
            }
            assert_eq!(values, expected, "{count} lights, lane {k}");
        }
    }
}
