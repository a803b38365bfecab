//! Programs with the uniforms of a draw against the same programs as a trace runs them, where nothing is left out.

use glanz_math::SimdLevel;
use glanz_shader::{DefaultProgram, Machine, NoTextures, Program, Row, Scalar, Shader, Stage, UniformValues};

use crate::common::Numbers;
use crate::flow;

/// Numbers whose sums, products and comparisons are exact, nothing or special.
const ODD: [f32; 12] = [0.0, 0.0, 1.0, 1.0, -0.0, -1.0, 0.5, 2.0, 3.0, 180.0, f32::INFINITY, 1e-30];

fn number(numbers: &mut Numbers) -> f32 {
    match numbers.below(3) {
        0 => numbers.unit() * 4.0 - 2.0,
        _ => ODD[numbers.below(ODD.len())],
    }
}

fn uniforms(program: &Program, numbers: &mut Numbers) -> UniformValues {
    let mut uniforms = program.uniforms();
    for uniform in &program.interface().uniforms {
        let values: Vec<f32> = (0..uniform.ty.scalars())
            .map(|_| match uniform.ty.scalar {
                Scalar::Float => number(numbers),
                Scalar::Bool => numbers.below(2) as f32,
                Scalar::Int | Scalar::Uint => numbers.below(7) as f32,
            })
            .collect();
        uniforms.set(&uniform.name, &values).expect("it is there");
    }
    uniforms
}

/// The bits of all outputs and which lanes were discarded; all NaN are one.
fn results<const G: usize>(machine: &Machine<'_, G>, program: &Program) -> (Vec<u32>, [u16; G]) {
    let bits = |x: f32| if x.is_nan() { f32::NAN.to_bits() } else { x.to_bits() };
    let ports = program.interface().outputs.iter().enumerate();
    let rows = ports.flat_map(|(i, port)| (0..port.ty.scalars()).map(move |k| (i, k)));
    let all = rows.flat_map(|(i, k)| machine.output(i, k).iter().flat_map(|row| row.0).collect::<Vec<f32>>());
    (all.map(bits).collect(), machine.discarded())
}

/// Draws of a text, and how many instructions were left out of all.
fn compare(shader: &Shader<'_>, name: &str, draws: usize, numbers: &mut Numbers) -> (usize, usize) {
    let [plain, traced] =
        [shader.clone(), shader.clone().traced()].map(|shader| shader.compile().expect("it compiles"));
    let (mut left, mut all) = (0, 0);
    for draw in 0..draws {
        let uniforms = uniforms(&plain, numbers);
        let specialized = plain.specialize(&uniforms);
        left += specialized.instructions();
        all += plain.size().0;
        let (mut a, mut b) = (
            Machine::<1>::of(&specialized, &NoTextures, SimdLevel::best()),
            Machine::<1>::new(&traced, &uniforms, &NoTextures, SimdLevel::best()),
        );
        a.set_fuel(2_000);
        b.set_fuel(2_000);
        for _ in 0..4 {
            for (i, port) in plain.interface().inputs.iter().enumerate() {
                for k in 0..port.ty.scalars() {
                    let row = Row(std::array::from_fn(|_| match port.ty.scalar {
                        Scalar::Float => number(numbers),
                        Scalar::Bool => f32::from_bits([0, u32::MAX][numbers.below(2)]),
                        Scalar::Int | Scalar::Uint => f32::from_bits(numbers.below(6) as u32),
                    }));
                    (a.input(i, k)[0], b.input(i, k)[0]) = (row, row);
                }
            }
            let (one, other) = (a.run(), b.run());
            assert_eq!(one.is_ok(), other.is_ok());
            if one.is_ok() {
                assert_eq!(results(&a, &plain), results(&b, &traced), "draw {draw} of {name}");
            }
        }
    }
    (left, all)
}

#[test]
fn default_programs_keep_every_bit() {
    let mut numbers = Numbers(7);
    for program in DefaultProgram::all() {
        for stage in [Stage::Vertex, Stage::Fragment] {
            let name = program.file_name(stage);
            let shader = match stage {
                Stage::Vertex => Shader::vertex(program.text(stage)).named(&name),
                Stage::Fragment => Shader::fragment(program.text(stage)).named(&name),
            };
            let (left, all) = compare(&shader, program.name, 40, &mut numbers);
            assert!(left <= all, "{}", program.name);
            if program.name == "phong-330" && stage == Stage::Fragment {
                assert!(left * 2 < all, "branches on uniforms are gone: {left} of {all}");
            }
        }
    }
}

#[test]
fn texts_with_all_kinds_of_flow_keep_every_bit() {
    let mut numbers = Numbers(11);
    for text in [flow::GLSL, flow::INDEXED, FLOW, EXACT] {
        compare(&Shader::fragment(text), text, 60, &mut numbers);
    }
    compare(&Shader::fragment(flow::WGSL).named("flow.wgsl"), "flow.wgsl", 20, &mut numbers);
}

/// Branches on uniforms around and inside of those on inputs and of loops, and values that are written at many places.
const FLOW: &str = "#version 330
uniform int kind; uniform bool on; uniform vec3 tint; uniform float limit; uniform mat3 turn;
in vec3 p; in float t; flat in int n;
out vec4 color; out vec3 more;
vec3 pick(vec3 v, int k) {
    if (k == 0) return v;
    if (v.x > limit) { if (on) return v.zyx; v.y += 1.0; }
    switch (kind) {
        case 0: v *= tint; break;
        case 1: v = turn * v;
        case 2: if (k > 2) v -= tint; else v += tint; break;
        default: v.x = tint.x; v.z = v.x;
    }
    return v;
}
void main() {
    vec3 a = p;
    float last = t;
    vec2 pair = vec2(0.0);
    for (int i = 0; i < n; i++) {
        if (on && i == 1) continue;
        vec3 before = a;
        a = pick(a, kind);
        if (a.x > 4.0 * limit) { last = before.y; break; }
        if (kind > 3) last = a.z; else last = before.x;
        pair.x = last;
    }
    while (kind == 5 && last < 1.0) { last += 0.25; a.yz = a.zy; if (!on) break; }
    if (on) pair.y = t * 1.0 + 0.0; else pair = vec2(t - 0.0, -t);
    if (t > limit) { a = vec3(1.0, a.x, a.x); if (kind == 2) discard; } else if (!on) { a.x = dot(tint, tint); }
    if (t > limit) a += tint * 0.0;
    vec3 q = on ? a : a * vec3(1.0, 2.0, tint.x);
    color = vec4(q, last / tint.x);
    more = normalize(vec3(pair, 1.0)) + cross(tint, a) * (on ? 1.0 : t);
}";

/// Sums, products and choices with numbers of a draw that may be 0, 1 or their negatives, and sums that are made in one
/// branch and again after it.
const EXACT: &str = "#version 330
uniform vec4 u; uniform bool on; uniform int mask;
in vec4 p; in float t; flat in int n;
out vec4 sums; out vec4 products; out vec4 chosen; out vec4 again; flat out int bits;
void main() {
    sums = vec4(p.x + u.x, u.y + p.y, p.z - u.z, u.w - p.w);
    products = vec4(p.x * u.x, u.y * p.y, p.z / u.z, u.w / p.w);
    bool under = t < u.x;
    chosen = vec4(under ? p.x : u.y, !under && on ? p.y : -p.y, (under || on) ? 1.0 : 2.0, !(!under) ? p.z : p.z);
    bits = (n & mask) | (n & ~0) ^ (mask | n);
    again = vec4(0.0);
    if (t > 0.25) {
        for (int i = 0; i < n; i++) again.x += sin(p.x * t) * cos(p.y * t) + sqrt(abs(p.z)) * pow(abs(p.w), t);
        if (n > 2) { again.y = sin(p.x * t) * 2.0; again.z = dot(p.xyz, vec3(t)); }
    }
    again.w = sin(p.x * t) * cos(p.y * t) + dot(p.xyz, vec3(t)) + sqrt(abs(p.z)) * pow(abs(p.w), t);
}";
