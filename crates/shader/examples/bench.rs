//! How many fragments in a second the lane machine makes of shaders, on one core: a line of JSON for each shader and SIMD
//! level. With `--turn` one number, of the best level with 64 lanes, for a measurement in turn with others.
//!
//!     cargo run --release -p glanz-shader --example bench -- [--turn] FILE…

#![expect(clippy::print_stdout, reason = "what is measured goes to stdout")]

use std::error::Error;
use std::time::Instant;

use glanz_math::SimdLevel;
use glanz_shader::{Machine, NoTextures, Program, Row, Shader, UniformValues};

/// Fragments of one measurement, and measurements, of which the median counts.
const FRAGMENTS: usize = 1 << 20;
const TIMES: usize = 9;

/// Mfragments in a second, inputs and outputs copied as a renderer would.
macro_rules! speed {
    ($g:literal, $program:expr, $uniforms:expr, $level:expr) => {{
        let program: &Program = $program;
        let mut machine = Machine::<$g>::new(program, $uniforms, &NoTextures, $level);
        let interface = program.interface();
        let ports = interface.inputs.iter().enumerate();
        let inputs: Vec<(usize, usize, Row)> =
            ports.flat_map(|(i, port)| (0..port.ty.scalars()).map(move |k| (i, k, values(i + k)))).collect();
        let outputs = interface.outputs[0].ty.scalars();
        let mut speeds = Vec::new();
        for _ in 0..TIMES {
            let start = Instant::now();
            let mut sum = Row::splat(0.0);
            for _ in 0..FRAGMENTS / (16 * $g) {
                for (i, k, row) in &inputs {
                    *machine.input(*i, *k) = [*row; $g];
                }
                machine.run()?;
                for k in 0..outputs {
                    sum.0[k] += machine.output(0, k)[0].0[k];
                }
            }
            std::hint::black_box(sum);
            speeds.push(FRAGMENTS as f64 * 1e-6 / start.elapsed().as_secs_f64());
        }
        speeds.sort_by(f64::total_cmp);
        speeds[TIMES / 2]
    }};
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut files: Vec<String> = std::env::args().skip(1).collect();
    let is_turn = files.first().is_some_and(|word| word == "--turn");
    files.drain(..usize::from(is_turn));
    for file in files {
        let program = Shader::fragment(std::fs::read_to_string(&file)?).named(&file).compile()?;
        let uniforms = uniforms(&program)?;
        if is_turn {
            println!("{}", speed!(4, &program, &uniforms, SimdLevel::best()));
            continue;
        }
        let name = file.rsplit('/').next().unwrap_or(&file);
        for (level, simd) in SimdLevel::available() {
            let (narrow, wide) = (speed!(1, &program, &uniforms, simd), speed!(4, &program, &uniforms, simd));
            println!(
                "{{\"table\":\"Shaders of users on the lane machine, one core\",\"name\":\"{name}, {level}\",\
                 \"16 lanes, Mfragments/s\":{narrow:.1},\"64 lanes, Mfragments/s\":{wide:.1}}}"
            );
        }
    }
    Ok(())
}

/// Numbers that differ from lane to lane.
fn values(seed: usize) -> Row {
    Row(std::array::from_fn(|lane| ((seed * 7 + lane * 5) % 17) as f32 * 0.1 - 0.6))
}

/// All lights on; the same numbers as `xtask/peers/shaders.py` sets.
fn uniforms(program: &Program) -> Result<UniformValues, Box<dyn Error>> {
    let mut uniforms = program.uniforms();
    for uniform in &program.interface().uniforms {
        let value = if uniform.name == "nLights" { 3.0 } else { 0.5 };
        uniforms.set(&uniform.name, &vec![value; uniform.ty.scalars()])?;
    }
    Ok(uniforms)
}
