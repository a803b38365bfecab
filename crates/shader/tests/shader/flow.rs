//! Divergent control flow against plain Rust, lane by lane.

use glanz_math::SimdLevel;
use glanz_shader::{Machine, NoTextures, Program, Row, RunError};
use proptest::prelude::*;

use crate::common;

pub(crate) const WGSL: &str = "
fn f(x: f32, n: i32) -> f32 {
    var s = 0.0;
    for (var i = 0; i < n; i++) {
        if (i == 3) { continue; }
        if (s > 5.0) { break; }
        switch (i % 3) {
            case 0: { s += x; }
            case 1: { s += x * x; }
            default: { if (x > 0.7) { return -s; } s += 0.5; }
        }
        var k = 0;
        loop { k++; if (k > i) { break; } s += 0.125; continuing { break if (k * i > 11); } }
    }
    if (s > 2.5) { return s * 2.0; }
    return s;
}
@fragment fn main(@location(0) v: vec2<f32>) -> @location(0) vec4<f32> {
    let y = f(v.x, i32(v.y * 10.0));
    if (y < -1.0) { discard; }
    return vec4(y, f32(i32(v.y * 10.0) % 4), v);
}";

fn f(x: f32, n: i32) -> f32 {
    let mut s = 0.0f32;
    let mut i = 0;
    while i < n {
        if i == 3 {
            i += 1;
            continue;
        }
        if s > 5.0 {
            break;
        }
        match i % 3 {
            0 => s += x,
            1 => s += x * x,
            _ => {
                if x > 0.7 {
                    return -s;
                }
                s += 0.5;
            }
        }
        let mut k = 0;
        loop {
            k += 1;
            if k > i {
                break;
            }
            s += 0.125;
            if k * i > 11 {
                break;
            }
        }
        i += 1;
    }
    if s > 2.5 { s * 2.0 } else { s }
}

pub(crate) const GLSL: &str = "#version 330
in float x; in float y; out float s;
int steps(int n) {
    int count = 0;
    while (n != 1 && count < 40) { n = (n & 1) == 1 ? 3 * n + 1 : n / 2; count++; }
    return count;
}
float branch(int k, float x) {
    float r = 0.0;
    switch (k) {
        case 0: r += 1.0;
        case 1: r += x; break;
        case 5: if (x > 0.5) return 7.0; r = 3.0;
        default: r += 10.0;
        case 2: r -= 0.25; break;
        case 3: for (int i = 0; i < 4; ++i) { if (i == k - 1) continue; r += float(i); }
    }
    return r;
}
void main() {
    int n = int(y * 20.0) + 1;
    s = float(steps(n)) + branch(int(x * 6.0), x);
    float table[4] = float[4](1.0, 2.0, 4.0, 8.0);
    table[n & 3] += 0.5;
    do { s += table[(n + 1) & 3]; n -= 3; } while (n > 0);
    if (x > 0.9) discard;
}";

fn steps(mut n: i32) -> i32 {
    let mut count = 0;
    while n != 1 && count < 40 {
        n = if n & 1 == 1 { 3 * n + 1 } else { n / 2 };
        count += 1;
    }
    count
}

fn branch(k: i32, x: f32) -> f32 {
    match k {
        0 => 1.0 + x,
        1 => x,
        2 => -0.25,
        3 => [0, 1, 3].into_iter().map(|i| i as f32).sum(),
        5 if x > 0.5 => 7.0,
        5 => 3.0 + 10.0 - 0.25,
        _ => 10.0 - 0.25,
    }
}

fn g(x: f32, y: f32) -> f32 {
    let mut n = (y * 20.0) as i32 + 1;
    let mut s = steps(n) as f32 + branch((x * 6.0) as i32, x);
    let mut table = [1.0, 2.0, 4.0, 8.0];
    table[(n & 3) as usize] += 0.5;
    loop {
        s += table[((n + 1) & 3) as usize];
        n -= 3;
        if n <= 0 {
            return s;
        }
    }
}

/// Runs 16 pairs; the first output and which lanes were discarded.
fn run(program: &Program, pairs: &[(f32, f32)], level: SimdLevel) -> ([f32; 16], u16) {
    let uniforms = program.uniforms();
    let mut machine = Machine::<1>::new(program, &uniforms, &NoTextures, level);
    let (x, y) = (std::array::from_fn(|i| pairs[i].0), std::array::from_fn(|i| pairs[i].1));
    if program.interface().inputs.len() == 2 {
        (machine.input(0, 0)[0], machine.input(1, 0)[0]) = (Row(x), Row(y));
    } else {
        (machine.input(0, 0)[0], machine.input(0, 1)[0]) = (Row(x), Row(y));
    }
    machine.run().expect("it ends");
    (machine.output(0, 0)[0].0, machine.discarded()[0])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn loops_switches_returns_and_discard_are_those_of_rust(
        pairs in prop::collection::vec((0.0f32..1.0, 0.0f32..1.0), 16)
    ) {
        thread_local! {
            static PROGRAMS: [Program; 2] = [common::wgsl(WGSL), common::fragment(GLSL)];
        }
        PROGRAMS.with(|[wgsl, glsl]| {
            for (_, level) in SimdLevel::available() {
                let (got, discarded) = run(wgsl, &pairs, level);
                for (lane, (x, y)) in pairs.iter().enumerate() {
                    let expected = f(*x, (y * 10.0) as i32);
                    let is_discarded = discarded >> lane & 1 == 1;
                    prop_assert_eq!(is_discarded, expected < -1.0, "lane {}", lane);
                    prop_assert!(is_discarded || got[lane].to_bits() == expected.to_bits());
                }
                let (got, discarded) = run(glsl, &pairs, level);
                for (lane, (x, y)) in pairs.iter().enumerate() {
                    prop_assert_eq!(discarded >> lane & 1 == 1, *x > 0.9);
                    prop_assert_eq!(got[lane].to_bits(), g(*x, *y).to_bits(), "lane {} {:?}", lane, (x, y));
                }
            }
            Ok(())
        })?;
    }
}

#[test]
fn an_endless_loop_ends_with_its_place() {
    let program = common::fragment(
        "out vec4 c;\nvoid main() {\n  float x = 0.0;\n  while (x < 1.0) { x *= 2.0; }\n  c = vec4(x);\n}",
    );
    let uniforms = program.uniforms();
    let mut machine = Machine::<1>::new(&program, &uniforms, &NoTextures, SimdLevel::best());
    machine.set_fuel(1000);
    let RunError::EndlessLoop { place, turns } = machine.run().unwrap_err();
    assert_eq!((place.map(|place| place.line), turns), (Some(4), 1000));
}

#[test]
fn uniform_loops_have_the_values_of_divergent_ones() {
    // The same loop over a uniform count, and over an input of the same value.
    let body = "int i; float s = 0.0;
        for (i = 0; i < n; i++) { if (i == 4) break; if (i == 1) continue; s += lights[i].y * float(i + 1); }
        color = vec4(s);";
    let head = "#version 330\nuniform vec3 lights[5]; out vec4 color;";
    let even = common::fragment(&format!("{head} uniform int n = 5; void main() {{ {body} }}"));
    let apart = common::fragment(&format!("{head} flat in int n; void main() {{ {body} }}"));
    let values = |program: &Program| {
        let mut uniforms = program.uniforms();
        for i in 0..5 {
            uniforms.set(&format!("lights[{i}]"), &[0.0, i as f32 * 0.3 + 0.1, 0.0]).unwrap();
        }
        common::outputs_at(program, &uniforms, SimdLevel::best(), &|_, _, _| 5.0)[0]
    };
    assert_eq!(values(&even), values(&apart));
    assert_eq!(values(&even)[0], 0.1f32 + 0.7 * 3.0 + 1.0 * 4.0);
    assert!(even.size().0 < apart.size().0, "the uniform one needs no masks");
}

#[test]
fn sixty_four_lanes_give_the_bits_of_four_times_sixteen() {
    let program = common::fragment(GLSL);
    let mut numbers = common::Numbers(11);
    for _ in 0..100 {
        let pairs: Vec<(f32, f32)> = (0..64).map(|_| (numbers.unit(), numbers.unit())).collect();
        let uniforms = program.uniforms();
        let mut machine = Machine::<4>::new(&program, &uniforms, &NoTextures, SimdLevel::best());
        for (lane, (x, y)) in pairs.iter().enumerate() {
            machine.input(0, 0)[lane / 16].0[lane % 16] = *x;
            machine.input(1, 0)[lane / 16].0[lane % 16] = *y;
        }
        machine.run().expect("it ends");
        for (g, pairs) in pairs.chunks(16).enumerate() {
            let (values, discarded) = run(&program, pairs, SimdLevel::best());
            assert_eq!(machine.output(0, 0)[g].0, values);
            assert_eq!(machine.discarded()[g], discarded);
        }
    }
}

/// Loops over elements of uniforms and arrays, which are written out as far as their turns are known.
pub(crate) const INDEXED: &str = "#version 330
in float x; in float y; out vec4 c;
struct Light { vec3 color; float power; bool on; };
uniform Light lights[6]; uniform int count; uniform int first; uniform float steps[20];
const float table[4] = float[4](0.5, 0.25, 2.0, 1.0);
float look(int i, float at) { if (at < 0.2) return lights[i].power; return lights[i].power * at + table[i % 4]; }
void main() {
    vec3 sum = vec3(0.0);
    int last = -1;
    for (int i = 0; i < count; i++) {
        if (i < first) sum.z += 0.25;
        if (!lights[i].on) { if (lights[i].power > 3.0) break; sum.x += 0.5; }
        for (int k = 0; k < 3; k++) { sum += lights[i].color * look(i, x + float(k)); if (steps[k] > 1.5) break; }
        float own[3] = float[3](x, y, 1.0);
        for (int k = 2; k >= 0; k--) own[k] += steps[i + k];
        sum.y += own[0] * own[2];
        last = i;
    }
    int at = 0;
    for (int i = 0; i < 20; i++) { if (steps[i] > sum.x) at = i; }
    c = vec4(sum, float(last) + 100.0 * float(at));
}";

/// The same program as a trace runs it: loops are loops there.
#[test]
fn loops_that_are_written_out_give_the_same_bits_as_loops() {
    let shader = glanz_shader::Shader::fragment(INDEXED);
    let [plain, looped] = [shader.clone(), shader.traced()].map(|shader| shader.compile().unwrap());
    let results = |program: &Program, count: i32, first: i32, seed: usize| {
        let mut uniforms = program.uniforms();
        for uniform in &program.interface().uniforms {
            let of = |k: usize| ((uniform.name.len() * 7 + k * 5 + seed * 3) % 11) as f32 * 0.4;
            let values: Vec<f32> = match uniform.name.as_str() {
                "count" => vec![count as f32],
                "first" => vec![first as f32],
                name => {
                    let digits = name.bytes().map(usize::from).sum::<usize>();
                    (0..uniform.ty.scalars())
                        .map(|k| if name.ends_with("on") { of(digits) - 1.3 } else { of(digits + k) })
                        .map(|v| v.max(0.0))
                        .collect()
                }
            };
            uniforms.set(&uniform.name, &values).unwrap();
        }
        let mut machine = Machine::<1>::new(program, &uniforms, &NoTextures, SimdLevel::best());
        for port in 0..2 {
            machine.input(port, 0)[0] =
                Row(std::array::from_fn(|lane| (lane * (port + 2)) as f32 * 0.07 - 0.3));
        }
        machine.run().unwrap();
        (0..4).flat_map(|k| machine.output(0, k)[0].0.map(f32::to_bits)).collect::<Vec<_>>()
    };
    assert!(plain.size().0 > looped.size().0, "it is written out: {:?} {:?}", plain.size(), looped.size());
    for count in -1..9 {
        for first in 0..3 {
            for seed in 0..4 {
                let (a, b) = (results(&plain, count, first, seed), results(&looped, count, first, seed));
                assert_eq!(a, b, "from {first} to {count}, {seed}");
            }
        }
    }
}
