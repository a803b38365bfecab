//! The course's fragment shader against the same formula written by hand.

use crate::common;

use glanz_math::{Lanes, Real, SimdLevel, Vec3, at_level};
use glanz_shader::{Machine, NoTextures, Program, Row};

const SHADER: &str = include_str!("texts/specular.frag");
const BLOCKS: usize = 512;

/// Folded by the front end with divisions, where our own rounds once more.
fn light() -> Vec3<f32> {
    let length = (1.0f32 + 100.0).sqrt();
    Vec3::new(0.0 / length, -1.0 / length, 10.0 / length)
}

#[inline(always)]
fn unit<R: Real>(x: R) -> R {
    x.max(x.lit(0.0)).min(x.lit(1.0))
}

#[inline(always)]
fn direct<R: Real>(light: Vec3<f32>, position: Vec3<R>, normal: Vec3<R>, color: [R; 4]) -> [R; 4] {
    let x = normal.x;
    let lit = |v: f32| x.lit(f64::from(v));
    let light = Vec3::new(lit(light.x), lit(light.y), lit(light.z));
    let n = normal.normalized();
    let cosine = n.dot(light);
    let diffuse = lit(0.6) * cosine.max(lit(0.0));
    let i = -light;
    let d = n.dot(i);
    let r = i - n * (d + d);
    let view = Vec3::new(lit(0.0), lit(0.0), lit(1.0)) - position;
    let gamma = r.normalized().dot(view.normalized());
    let power = lit(1.0) * lit(0.2) * gamma.max(lit(0.0)).pow(lit(32.0));
    let specular = power.select(cosine.gt(lit(0.0)), lit(0.0));
    let sum = diffuse + specular + lit(0.2);
    [unit(sum * color[0]), unit(sum * color[1]), unit(sum * color[2]), unit(lit(1.0) * color[3])]
}

/// Inputs of 16 fragments: colour, position, normal.
fn inputs() -> Vec<[[f32; 16]; 11]> {
    let mut numbers = common::Numbers(1);
    let mut block = || {
        std::array::from_fn(|k| {
            std::array::from_fn(|_| match k {
                0..4 => numbers.unit(),
                10 => numbers.unit() + 0.1,
                _ => numbers.unit() * 2.0 - 1.0,
            })
        })
    };
    (0..BLOCKS).map(|_| block()).collect()
}

/// First row of an input's name in the block.
fn first(name: &str) -> usize {
    match name {
        "color" => 0,
        "trPos" => 4,
        _ => 8,
    }
}

macro_rules! run_wide {
    ($g:literal, $program:expr, $level:expr, $inputs:expr) => {{
        let program: &Program = $program;
        let uniforms = program.uniforms();
        let mut machine = Machine::<$g>::new(program, &uniforms, &NoTextures, $level);
        let mut all = Vec::new();
        for blocks in $inputs.chunks($g) {
            for (i, port) in program.interface().inputs.iter().enumerate() {
                for k in 0..port.ty.scalars() {
                    let row = (first(&port.name) + k).min(10);
                    for (to, from) in machine.input(i, k).iter_mut().zip(blocks) {
                        *to = Row(from[row]);
                    }
                }
            }
            machine.run().unwrap();
            for g in 0..blocks.len() {
                all.push([0, 1, 2, 3].map(|k| machine.output(0, k)[g].0.map(f32::to_bits)));
            }
        }
        all
    }};
}

#[test]
fn the_course_phong_has_the_bits_of_the_formula_by_hand_on_every_level_and_width() {
    let program = common::fragment(SHADER);
    let inputs = inputs();
    for (name, level) in SimdLevel::available() {
        let expected: Vec<_> = inputs
            .iter()
            .map(|rows| {
                at_level!(level, simd => {
                    let l = |k: usize| Lanes::load(simd, &rows[k]);
                    let position = Vec3::new(l(4), l(5), l(6));
                    let color = direct(light(), position, Vec3::new(l(8), l(9), l(10)), [l(0), l(1), l(2), l(3)]);
                    color.map(|c| c.to_array().map(f32::to_bits))
                })
            })
            .collect();
        assert!(run_wide!(1, &program, level, inputs) == expected, "{name}, 16 lanes");
        assert!(run_wide!(4, &program, level, inputs) == expected, "{name}, 64 lanes");
    }
}

#[test]
fn the_highlight_is_in_the_bits() {
    // What the test above compares would be equal without a highlight, too, if no lane had one.
    let program = common::fragment(SHADER);
    let without = common::fragment(&SHADER.replace("spec_S = 0.2", "spec_S = 0.0"));
    let inputs = inputs();
    let level = SimdLevel::best();
    assert!(run_wide!(1, &program, level, inputs) != run_wide!(1, &without, level, inputs));
}

/// Seconds to run all blocks once, inputs and outputs copied as a renderer would; the best of many times.
macro_rules! time_of {
    ($g:literal, $program:expr, $level:expr, $inputs:expr) => {{
        let program: &Program = $program;
        let uniforms = program.uniforms();
        let mut machine = Machine::<$g>::new(program, &uniforms, &NoTextures, $level);
        let rows: Vec<(usize, usize, usize)> = program
            .interface()
            .inputs
            .iter()
            .enumerate()
            .flat_map(|(i, port)| {
                (0..port.ty.scalars()).map(move |k| (i, k, (first(&port.name) + k).min(10)))
            })
            .collect();
        let mut out = vec![[[Row::splat(0.0); $g]; 4]; $inputs.len() / $g];
        let mut best = f64::MAX;
        for _ in 0..200 {
            let start = std::time::Instant::now();
            for (blocks, out) in $inputs.chunks_exact($g).zip(&mut out) {
                for (i, k, row) in &rows {
                    for (to, from) in machine.input(*i, *k).iter_mut().zip(blocks) {
                        to.0 = from[*row];
                    }
                }
                machine.run().expect("it ends");
                for (k, out) in out.iter_mut().enumerate() {
                    *out = *machine.output(0, k);
                }
            }
            best = best.min(start.elapsed().as_secs_f64());
        }
        best
    }};
}

/// Speed: `cargo test --release -p glanz-shader --test shader -- --ignored --nocapture speed`
#[test]
#[ignore = "measures"]
fn speed_of_the_course_phong() {
    let program = common::fragment(SHADER);
    let inputs = inputs();
    println!("{:?} instructions, once per draw, registers", program.size());
    let fragments = (BLOCKS * 16) as f64 * 1e-6;
    for (name, level) in SimdLevel::available() {
        let narrow = fragments / time_of!(1, &program, level, inputs);
        let wide = fragments / time_of!(4, &program, level, inputs);
        println!("{name}: {narrow:.0} Mfragments/s with 16 lanes, {wide:.0} with 64");
    }
}
