//! The twins of models in WGSL have the bits of the models in Rust, at every direction, and a fault is noticed.

mod cases;
mod faults;
mod helpers;

use glanz_bsdf::models::lambert::Lambert;
use glanz_bsdf::wgsl::{self, Twin};
use glanz_bsdf::{DirectionPair, MODELS, Shape};
use glanz_math::{SimdLevel, Vec3};
use glanz_shader::{Machine, NoTextures, Program, Row};
use naga::valid::{Capabilities, ValidationFlags, Validator};

use crate::common;

/// Numbers that a shader holds, of which an instance's begin at [`FIRST`]. The others are NaN.
const HELD: usize = 48;
const FIRST: usize = 5;

/// Random places for each set of parameters.
const RANDOM: usize = 20_000;

/// Directions to the viewer and to the light, and the factor of a roughness texture.
#[derive(Clone, Copy, Debug)]
struct Place {
    wo: Vec3<f32>,
    wi: Vec3<f32>,
    alpha_scale: f32,
}

impl Place {
    fn pair(&self) -> DirectionPair<f32> {
        DirectionPair { alpha_scale: self.alpha_scale, ..DirectionPair::new(self.wo, self.wi) }
    }

    /// What the inputs of a shader of [`shader`] take.
    fn inputs(&self) -> [f32; 7] {
        let Self { wo, wi, alpha_scale } = self;
        [wo.x, wo.y, wo.z, wi.x, wi.y, wi.z, *alpha_scale]
    }
}

/// A shader that gives `expression` of `pair`, with numbers that the host sets.
fn shader(text: &str, expression: &str) -> String {
    format!(
        "{text}
        @group(0) @binding(0) var<storage, read> numbers: array<f32, {HELD}>;
        fn number(at: u32) -> f32 {{ return numbers[at]; }}
        fn value(wo: vec3<f32>, wi: vec3<f32>, alpha_scale: f32) -> f32 {{
            var pair = pair_new(wo, wi);
            pair.alpha_scale = alpha_scale;
            return {expression};
        }}"
    )
}

/// The call of a twin.
fn call(twin: &Twin) -> String {
    format!("{}(pair, {FIRST}u)", twin.function)
}

/// The program's value for each row of inputs.
fn values<const N: usize>(program: &Program, numbers: &[f32], rows: &[[f32; N]]) -> Vec<f32> {
    let mut uniforms = program.uniforms();
    for i in 0..HELD {
        let number = i.checked_sub(FIRST).and_then(|i| numbers.get(i)).copied().unwrap_or(f32::NAN);
        uniforms.set(&format!("numbers[{i}]"), &[number]).expect("it is declared");
    }
    let mut machine = Machine::<4>::new(program, &uniforms, &NoTextures, SimdLevel::best());
    let ports = program.interface().inputs.iter().enumerate();
    let inputs: Vec<_> = ports.flat_map(|(i, port)| (0..port.ty.scalars()).map(move |k| (i, k))).collect();
    assert_eq!(inputs.len(), N);
    let mut values = Vec::with_capacity(rows.len());
    for chunk in rows.chunks(64) {
        let lane =
            |row: usize, lane: usize, column: usize| chunk.get(16 * row + lane).map_or(0.0, |x| x[column]);
        for (column, (input, component)) in inputs.iter().enumerate() {
            let rows = std::array::from_fn(|row| Row(std::array::from_fn(|l| lane(row, l, column))));
            *machine.input(*input, *component) = rows;
        }
        machine.run().expect("it ends");
        values.extend(machine.output(0, 0).iter().flat_map(|row| row.0).take(chunk.len()));
    }
    values
}

/// Whether both are the same number to the last bit; NaN is equal to NaN.
fn same(a: f32, b: f32) -> bool {
    a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan()
}

/// The first place where the program has other bits than the shape, in words.
fn difference(program: &Program, shape: &Shape, places: &[Place]) -> Option<String> {
    let inputs: Vec<_> = places.iter().map(Place::inputs).collect();
    let values = values(program, &shape.numbers(), &inputs);
    places.iter().zip(values).find_map(|(place, got)| {
        let expected: f32 = shape.f_cos(&place.pair());
        (!same(got, expected)).then(|| {
            format!(
                "{} {:?} at {place:?}: {got:e} ({:08x}) in WGSL, {expected:e} ({:08x}) in Rust",
                shape.info().name,
                shape.params(),
                got.to_bits(),
                expected.to_bits()
            )
        })
    })
}

#[test]
fn every_twin_has_the_bits_of_its_model() {
    for twin in wgsl::twins() {
        let start = std::time::Instant::now();
        // By itself: it names all parts that it needs.
        let program = common::wgsl(&shader(&wgsl::text([twin]), &call(twin)));
        let (mut sets, mut pairs) = (0, 0);
        for (shape, places) in cases::cases(twin, RANDOM) {
            if let Some(difference) = difference(&program, &shape, &places) {
                panic!("{difference}");
            }
            (sets, pairs) = (sets + 1, pairs + places.len());
        }
        let time = start.elapsed().as_secs_f64();
        println!("{}: {sets} sets of parameters, {pairs} pairs, {time:.2} s", twin.model);
    }
}

#[test]
fn all_twins_are_valid_in_one_module_for_any_gpu() {
    let calls: Vec<_> = wgsl::twins().iter().map(call).collect();
    let text = shader(&wgsl::text(wgsl::twins()), &calls.join(" + "))
        + "@compute @workgroup_size(1) fn main() { _ = value(vec3<f32>(), vec3<f32>(), 1.0); }";
    let module =
        naga::front::wgsl::parse_str(&text).unwrap_or_else(|error| panic!("{}", error.emit_to_string(&text)));
    // No capability beyond what every device has.
    let validated = Validator::new(ValidationFlags::all(), Capabilities::empty()).validate(&module);
    validated.unwrap_or_else(|error| panic!("{}", error.emit_to_string(&text)));
}

#[test]
fn a_shape_of_the_list_has_its_models_twin_and_no_other_has_one() {
    for info in MODELS {
        let shape = Shape::named(info.name, &[]).unwrap();
        assert_eq!(shape.twin(), wgsl::twin(info.name));
        assert!(shape.twin().is_none() || shape.numbers().len() <= HELD - FIRST, "{}", info.name);
    }
    // Whatever its name is.
    let own = Shape::custom(Lambert);
    assert_eq!((own.info().name, own.twin()), ("lambert", None));
}
