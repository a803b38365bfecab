//! How many fragments in a second the lane machine makes of shaders, on one core: a line of JSON for each shader and SIMD
//! level, and how long the trace of a block takes. A word that names no file is a default program, whose lights are five of
//! all kinds. With `--turn` one number, of the best level with 64 lanes, for a measurement in turn with others.
//!
//!     cargo run --release -p glanz-shader --example bench -- [--turn] FILE…

#![expect(clippy::print_stdout, reason = "what is measured goes to stdout")]

use std::error::Error;
use std::time::Instant;

use glanz_math::SimdLevel;
use glanz_shader::{DefaultProgram, Machine, NoTextures, Program, Row, Shader, Stage, UniformValues};

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
        let text = match DefaultProgram::named(&file) {
            Some(own) => own.text(Stage::Fragment),
            None => std::fs::read_to_string(&file)?,
        };
        let shader = Shader::fragment(text).named(&file);
        let program = shader.compile()?;
        let uniforms = uniforms(&program)?;
        if is_turn {
            println!("{}", speed!(4, &program, &uniforms, SimdLevel::best()));
            continue;
        }
        let name = file.rsplit('/').next().unwrap_or(&file);
        let micros = trace(&shader.clone().traced().compile()?, &uniforms);
        println!(
            "{{\"table\":\"X-ray of a block of 16 fragments, one core\",\"name\":\"{name}\",\"µs\":{micros:.1}}}"
        );
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

/// Microseconds of the trace of a block: what happened at every line, for all 16 lanes.
fn trace(program: &Program, uniforms: &UniformValues) -> f64 {
    let mut machine = Machine::<1>::new(program, uniforms, &NoTextures, SimdLevel::best());
    let mut times = Vec::new();
    for _ in 0..101 {
        for (i, port) in program.interface().inputs.iter().enumerate() {
            (0..port.ty.scalars()).for_each(|k| machine.input(i, k)[0] = values(i + k));
        }
        let start = Instant::now();
        std::hint::black_box(machine.trace());
        times.push(start.elapsed().as_secs_f64() * 1e6);
    }
    times.sort_by(f64::total_cmp);
    times[50]
}

/// All lights on, each with numbers of its own: what is the same of two lights would be computed once.
fn uniforms(program: &Program) -> Result<UniformValues, Box<dyn Error>> {
    let mut uniforms = program.uniforms();
    for (number, uniform) in program.interface().uniforms.iter().enumerate() {
        let own = |k: usize| 0.4 + 0.01 * ((number * 7 + k * 3) % 31) as f32;
        let mut values: Vec<f32> = match uniform.name.as_str() {
            "nLights" => vec![3.0],
            "lights.nbrLights" => vec![5.0],
            _ => (0..uniform.ty.scalars()).map(own).collect(),
        };
        // Of a default program's lights one is directional, two are points and two are spots.
        if let Some((number, member)) = light(&uniform.name) {
            match member {
                "posDir" => values[3] = if number == 0 { 0.0 } else { 1.0 },
                "spotCutoff" => values[0] = if number < 3 { 180.0 } else { 60.0 },
                "spotDirection" => values = vec![-0.6, 0.0, -0.8],
                _ => {}
            }
        }
        uniforms.set(&uniform.name, &values)?;
    }
    Ok(uniforms)
}

/// Number and member of `lights.source[2].posDir`.
fn light(name: &str) -> Option<(usize, &str)> {
    let (number, member) = name.strip_prefix("lights.source[")?.split_once("].")?;
    Some((number.parse().ok()?, member))
}
