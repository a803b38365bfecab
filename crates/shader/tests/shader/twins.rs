//! The twins of models in WGSL have the bits of the models in Rust, at every direction.

use glanz_bsdf::laws::directions;
use glanz_bsdf::wgsl::{self, Twin};
use glanz_bsdf::{DirectionPair, MODELS, ModelInfo, Shape};
use glanz_math::{SimdLevel, Vec3};
use glanz_shader::{Machine, NoTextures, Program};

use crate::common::{self, Numbers};

/// Numbers that the shader holds, of which a shape's begin at [`FIRST`]. The others are NaN.
const HELD: usize = 48;
const FIRST: usize = 5;

/// Random pairs for each set of parameters.
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

    fn numbers(&self) -> [f32; 7] {
        let Self { wo, wi, alpha_scale } = self;
        [wo.x, wo.y, wo.z, wi.x, wi.y, wi.z, *alpha_scale]
    }
}

/// A shader whose function is the twin's, behind the text of all twins.
fn shader(text: &str, twin: &Twin) -> String {
    format!(
        "{text}
        @group(0) @binding(0) var<storage, read> numbers: array<f32, {HELD}>;
        fn number(at: u32) -> f32 {{ return numbers[at]; }}
        fn f_cos(wo: vec3<f32>, wi: vec3<f32>, alpha_scale: f32) -> f32 {{
            var pair = pair_new(wo, wi);
            pair.alpha_scale = alpha_scale;
            return {}(pair, {FIRST}u);
        }}",
        twin.function
    )
}

/// What the program gives at these places.
fn values(program: &Program, numbers: &[f32], places: &[Place]) -> Vec<f32> {
    let mut uniforms = program.uniforms();
    for i in 0..HELD {
        let number = i.checked_sub(FIRST).and_then(|i| numbers.get(i)).copied().unwrap_or(f32::NAN);
        uniforms.set(&format!("numbers[{i}]"), &[number]).unwrap();
    }
    let mut machine = Machine::<4>::new(program, &uniforms, &NoTextures, SimdLevel::best());
    let mut values = Vec::with_capacity(places.len());
    for chunk in places.chunks(64) {
        for (input, port) in program.interface().inputs.iter().enumerate() {
            for component in 0..port.ty.scalars() {
                let rows = machine.input(input, component);
                for (lane, place) in chunk.iter().enumerate() {
                    rows[lane / 16].0[lane % 16] = place.numbers()[3 * input + component];
                }
            }
        }
        machine.run().unwrap();
        values.extend((0..chunk.len()).map(|lane| machine.output(0, 0)[lane / 16].0[lane % 16]));
    }
    values
}

/// The first place where the program has other bits than the shape, in words. NaN is equal to NaN.
fn difference(program: &Program, shape: &Shape, places: &[Place]) -> Option<String> {
    let values = values(program, &shape.numbers(), places);
    let same =
        |got: f32, expected: f32| got.to_bits() == expected.to_bits() || got.is_nan() && expected.is_nan();
    places.iter().zip(values).find_map(|(place, got)| {
        let expected: f32 = shape.f_cos(&place.pair());
        (!same(got, expected)).then(|| {
            let (info, params) = (shape.info(), shape.params());
            format!(
                "{} {params:?} at {place:?}: {got:e} ({:08x}) in WGSL, {expected:e} ({:08x}) in Rust",
                info.name,
                got.to_bits(),
                expected.to_bits()
            )
        })
    })
}

fn in_f32(v: Vec3<f64>) -> Vec3<f32> {
    Vec3::new(v.x as f32, v.y as f32, v.z as f32)
}

/// A unit vector at a distance from another one.
fn near(numbers: &mut Numbers, center: Vec3<f64>, distance: f64) -> Vec3<f64> {
    let mut signed = || distance * (2.0 * f64::from(numbers.unit()) - 1.0);
    (center + Vec3::new(signed(), signed(), signed())).normalized()
}

/// A random place: anywhere, near the horizon, near the mirror direction, near opposite, or along the normal.
fn random(numbers: &mut Numbers) -> Place {
    let (origin, up) = (Vec3::new(0.0, 0.0, 0.0), Vec3::new(0.0, 0.0, 1.0));
    let (wo, wi) = (near(numbers, origin, 1.0), near(numbers, origin, 1.0));
    let little = 10_f64.powf(-8.0 * f64::from(numbers.unit()));
    let low = |v: Vec3<f64>| Vec3::new(v.x, v.y, v.z * little).normalized();
    let above = Vec3::new(wo.x, wo.y, wo.z.abs());
    let (wo, wi) = match numbers.below(6) {
        0 => (wo, wi),
        1 => (low(wo), wi),
        2 => (low(wo), low(wi)),
        3 => (above, near(numbers, above.reflected(up), little)),
        4 => (wo, near(numbers, -wo, little)),
        _ => (near(numbers, up, little), near(numbers, up, little)),
    };
    let alpha_scale = if numbers.below(2) == 0 { 1.0 } else { numbers.unit() };
    Place { wo: in_f32(wo), wi: in_f32(wi), alpha_scale }
}

/// The grid of the laws, and random places.
fn places(shape: &Shape, seed: u32) -> Vec<Place> {
    let grid = directions(shape).into_iter();
    let grid = grid.map(|[wo, wi]| Place { wo: in_f32(wo), wi: in_f32(wi), alpha_scale: 1.0 });
    let mut numbers = Numbers(seed);
    grid.chain(std::iter::repeat_with(|| random(&mut numbers)).take(RANDOM)).collect()
}

/// Sets of parameters: the defaults, all ends of all ranges, some at random, and what the model has paths for.
fn parameters(info: &ModelInfo) -> Vec<Vec<f64>> {
    let defaults: Vec<f64> = info.params.iter().map(|param| param.default).collect();
    let mut sets = vec![defaults.clone()];
    for end in 0..1 << info.params.len() {
        let at = |(i, param): (usize, &glanz_bsdf::ParamInfo)| {
            if end >> i & 1 == 0 { param.min } else { param.max }
        };
        sets.push(info.params.iter().enumerate().map(at).collect());
    }
    let mut numbers = Numbers(7);
    for _ in 0..4 {
        let within =
            |param: &glanz_bsdf::ParamInfo| param.min + f64::from(numbers.unit()) * (param.max - param.min);
        sets.push(info.params.iter().map(within).collect());
    }
    if defaults.is_empty() {
        sets.truncate(1);
    }
    sets.extend(
        special(info)
            .into_iter()
            .map(|first| first.iter().chain(defaults.iter().skip(first.len())).copied().collect()),
    );
    sets
}

/// First parameters that are worth a look.
fn special(info: &ModelInfo) -> Vec<Vec<f64>> {
    match info.params.first().map(|param| param.name) {
        // Products of every kind up to the greatest, powers beyond and between.
        Some("shininess") => {
            [0.25, 1.0, 1.5, 2.0, 3.0, 6.0, 7.0, 11.0, 20.0, 64.0, 100.0, 127.0, 128.0, 128.5, 129.0, 1e4]
                .map(|n| vec![n])
                .to_vec()
        }
        // Widths that differ, hardly do, and do in double precision alone.
        Some("alpha") => {
            [(0.05, 0.16), (0.6, 0.2), (0.9, 1e-4), (0.3, 0.3), (0.2, 0.2 + 1e-7), (0.2, 0.2 + 1e-12)]
                .map(|(x, y)| vec![x, y])
                .to_vec()
        }
        Some("m") => vec![vec![0.1, 0.4, 0.3], vec![0.3, 0.3, 1e-9]],
        _ => vec![],
    }
}

fn shapes(twin: &Twin) -> Vec<Shape> {
    let info = MODELS.iter().find(|info| info.name == twin.model).unwrap();
    let names = info.params.iter().map(|param| param.name);
    let set = |values: Vec<f64>| names.clone().zip(values).collect::<Vec<_>>();
    parameters(info).into_iter().map(|values| Shape::named(info.name, &set(values)).unwrap()).collect()
}

#[test]
fn every_twin_has_the_bits_of_its_model() {
    let text = wgsl::text(wgsl::twins());
    for twin in wgsl::twins() {
        let start = std::time::Instant::now();
        let program = common::wgsl(&shader(&text, twin));
        let (mut sets, mut pairs) = (0, 0);
        for (seed, shape) in shapes(twin).iter().enumerate() {
            let places = places(shape, seed as u32 + 1);
            if let Some(difference) = difference(&program, shape, &places) {
                panic!("{difference}");
            }
            (sets, pairs) = (sets + 1, pairs + places.len());
        }
        println!(
            "{}: {sets} sets of parameters, {pairs} pairs, {:.2} s",
            twin.model,
            start.elapsed().as_secs_f64()
        );
    }
}
