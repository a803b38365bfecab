//! Runs shaders for the tests.

use glanz_math::SimdLevel;
use glanz_shader::{Machine, NoTextures, Program, Row, Scalar, Shader, ShaderError, UniformValues};

/// A generator of numbers that is the same everywhere.
pub(crate) struct Numbers(pub(crate) u32);

impl Numbers {
    pub(crate) fn word(&mut self) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        self.0
    }
    /// 0 … 1.
    pub(crate) fn unit(&mut self) -> f32 {
        (self.word() >> 8) as f32 / (1 << 24) as f32
    }
    pub(crate) fn below(&mut self, n: usize) -> usize {
        self.word() as usize % n.max(1)
    }
}

pub(crate) fn fragment(text: &str) -> Program {
    Shader::fragment(text).compile().unwrap_or_else(|error| panic!("{error}\n{text}"))
}

pub(crate) fn wgsl(text: &str) -> Program {
    Shader::fragment(text).named("test.wgsl").compile().unwrap_or_else(|error| panic!("{error}\n{text}"))
}

pub(crate) fn error(text: &str) -> ShaderError {
    Shader::fragment(text).named("x").compile().expect_err("the text is wrong")
}

/// All outputs of one run on a level, with inputs by a function of input, component and lane.
pub(crate) fn outputs_at(
    program: &Program,
    uniforms: &UniformValues,
    level: SimdLevel,
    input: &dyn Fn(usize, usize, usize) -> f32,
) -> Vec<[f32; 16]> {
    let mut machine = Machine::<1>::new(program, uniforms, &NoTextures, level);
    for (i, port) in program.interface().inputs.iter().enumerate() {
        for k in 0..port.ty.scalars() {
            machine.input(i, k)[0] = Row(std::array::from_fn(|lane| {
                let x = input(i, k, lane);
                match port.ty.scalar {
                    Scalar::Float => x,
                    Scalar::Int | Scalar::Uint => f32::from_bits(x as i32 as u32),
                    Scalar::Bool => f32::from_bits(if x > 0.0 { u32::MAX } else { 0 }),
                }
            }));
        }
    }
    machine.run().expect("it ends");
    let outputs = program.interface().outputs.iter().enumerate();
    outputs
        .flat_map(|(i, port)| (0..port.ty.scalars()).map(move |k| (i, k)))
        .map(|(i, k)| machine.output(i, k)[0].0)
        .collect()
}

pub(crate) fn outputs(program: &Program, input: &dyn Fn(usize, usize, usize) -> f32) -> Vec<[f32; 16]> {
    outputs_at(program, &program.uniforms(), SimdLevel::best(), input)
}

/// The first output of a shader whose first input's first component is `x`, in lane 0.
pub(crate) fn value(text: &str, x: f32) -> f32 {
    outputs(&fragment(text), &|_, _, _| x)[0][0]
}

/// The value of an expression of `x`.
pub(crate) fn expression(expression: &str, x: f32) -> f32 {
    value(&format!("#version 330\nin float x; out float y;\nvoid main() {{ y = float({expression}); }}"), x)
}
