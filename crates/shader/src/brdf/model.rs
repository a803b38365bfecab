//! A program as a model.

use std::cell::RefCell;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use glanz_bsdf::{DirectionPair, LaneModel, ModelInfo, ModelSource};
use glanz_math::{Lanes, Real, SimdLevel, Vec3, at_level};

use super::directions::directions;
use super::inputs::{Input, Inputs};
use super::parameters::{self, Parameter};
use crate::machine::{RegisterFile, Row};
use crate::run::{begin, proceed};
use crate::{Place, Program, RunError, ShaderError, UniformValues};

/// Turns of loops in one run. Sums over orders of scattering take some tens.
pub(super) const FUEL: u32 = 1 << 13;

/// Register files that a thread keeps, one for each model that it evaluates in turn.
const KEPT: usize = 16;

/// What models of one text share.
#[derive(Debug)]
pub(super) struct Code {
    pub(super) program: Program,
    pub(super) info: &'static ModelInfo,
    pub(super) inputs: Inputs,
    pub(super) parameters: Vec<Parameter>,
    pub(super) source: ModelSource,
}

impl Code {
    /// The uniforms with these values of all parameters.
    pub(super) fn uniforms(&self, values: &[f64]) -> UniformValues {
        parameters::uniforms(&self.program, &self.parameters, values)
    }
}

/// A BRDF with its parameters.
#[derive(Debug)]
pub(super) struct ProgramModel {
    code: Arc<Code>,
    values: Vec<f64>,
    uniforms: UniformValues,
    /// Its own number, by which threads find its registers.
    id: u64,
}

/// A register file after the prologue, and the number of its model.
struct Kept {
    id: u64,
    file: RegisterFile<1>,
}

thread_local! {
    static FILES: RefCell<Vec<Kept>> = const { RefCell::new(Vec::new()) };
}

impl ProgramModel {
    pub(super) fn new(code: Arc<Code>) -> Self {
        let values = code.info.params.iter().map(|param| param.default).collect();
        Self::with(code, values)
    }

    fn with(code: Arc<Code>, values: Vec<f64>) -> Self {
        static NEXT: AtomicU64 = AtomicU64::new(0);
        let uniforms = code.uniforms(&values);
        Self { code, values, uniforms, id: NEXT.fetch_add(1, Ordering::Relaxed) }
    }

    pub(super) fn code(&self) -> &Code {
        &self.code
    }

    /// Runs the model all over the hemisphere. Whether the channels differ, or an error if it does not end.
    pub(super) fn probe(&self) -> Result<bool, ShaderError> {
        let angles = [0.0_f64, 0.3, 0.8, 1.1, 1.4, 1.55];
        let mut differ = false;
        for theta_o in angles {
            for phi in [0.0, 1.0, 2.5, std::f64::consts::PI] {
                let (wo, mut pairs) = (Vec3::from_angles(theta_o, 0.0), [[0.0; 16]; 6]);
                for (lane, theta_i) in angles.iter().cycle().take(16).enumerate() {
                    let wi = Vec3::from_angles(*theta_i, phi + 0.1 * (lane / angles.len()) as f64);
                    for (column, value) in pairs.iter_mut().zip([wo.x, wo.y, wo.z, wi.x, wi.y, wi.z]) {
                        column[lane] = value as f32;
                    }
                }
                let [ox, oy, cos_o, ix, iy, cos_i] = pairs;
                let (zero, one) = ([0.0; 16], [1.0; 16]);
                let (tangent_o, tangent_i) = ((ox, oy), (ix, iy));
                let pair = DirectionPair {
                    cos_o,
                    cos_i,
                    cos_io: zero,
                    half2: one,
                    tangent_o,
                    tangent_i,
                    alpha_scale: one,
                };
                let channels = self.channels(SimdLevel::best(), &pair).map_err(endless)?;
                differ |=
                    channels.is_some_and(|channels| (0..16).any(|lane| apart(channels.map(|c| c[lane]))));
            }
        }
        Ok(differ)
    }

    /// The channels of 16 pairs, if there are three.
    fn channels(
        &self,
        level: SimdLevel,
        pair: &DirectionPair<[f32; 16]>,
    ) -> Result<Option<[[f32; 16]; 3]>, RunError> {
        self.with_registers(level, |file| {
            self.run(level, pair, file)?;
            let registers = &self.code.program.lowered.layout.outputs[0].registers;
            Ok(registers.get(..3).map(|three| [0, 1, 2].map(|i| file.get(three[i])[0].0)))
        })
    }

    /// Does something with the registers that this thread has for the model.
    #[inline]
    fn with_registers<T>(&self, level: SimdLevel, f: impl FnOnce(&mut RegisterFile<1>) -> T) -> T {
        FILES.with_borrow_mut(|files| {
            match files.iter().position(|kept| kept.id == self.id) {
                Some(0) => {}
                Some(at) => files.swap(0, at),
                None => {
                    let file = begin(level, &self.code.program, &self.uniforms);
                    files.truncate(KEPT - 1);
                    files.insert(0, Kept { id: self.id, file });
                }
            }
            f(&mut files[0].file)
        })
    }

    /// Writes the inputs and runs the program.
    fn run(
        &self,
        level: SimdLevel,
        pair: &DirectionPair<[f32; 16]>,
        file: &mut RegisterFile<1>,
    ) -> Result<(), RunError> {
        let vectors = vectors(level, pair);
        let layout = &self.code.program.lowered.layout;
        for (slot, input) in layout.inputs.iter().zip(self.code.inputs.in_order()) {
            for (register, row) in slot.registers.iter().zip(vectors[input as usize]) {
                *file.get_mut(*register) = [row];
            }
        }
        proceed(level, &self.code.program, &self.uniforms, file, FUEL)
    }
}

/// Every vector that a function may take, by the number of its [`Input`].
fn vectors(level: SimdLevel, pair: &DirectionPair<[f32; 16]>) -> [[Row; 3]; 6] {
    let mut vectors = [[Row([0.0; 16]); 3]; 6];
    let columns = [&pair.cos_o, &pair.cos_i, &pair.cos_io];
    let tangents = [&pair.tangent_o.0, &pair.tangent_o.1, &pair.tangent_i.0, &pair.tangent_i.1];
    at_level!(level, simd => {
        let [cos_o, cos_i, cos_io] = columns.map(#[inline(always)] |row| Lanes::load(simd, row));
        let [ox, oy, ix, iy] = tangents.map(#[inline(always)] |row| Lanes::load(simd, row));
        let (tangent_o, tangent_i) = ((ox, oy), (ix, iy));
        let (light, view) =
            directions(&DirectionPair { tangent_o, tangent_i, ..DirectionPair::isotropic(cos_o, cos_i, cos_io) });
        let sum = light + view;
        let half = sum * sum.dot(sum).max(cos_o.lit(1e-24)).rsqrt();
        let [l, v, .., h] = &mut vectors;
        for (rows, vector) in [(l, light), (v, view), (h, half)] {
            vector.x.store(&mut rows[0].0);
            vector.y.store(&mut rows[1].0);
            vector.z.store(&mut rows[2].0);
        }
    });
    for (input, axis) in [(Input::Normal, 2), (Input::Tangent, 0), (Input::Bitangent, 1)] {
        vectors[input as usize][axis] = Row::splat(1.0);
    }
    vectors
}

impl LaneModel for ProgramModel {
    fn info(&self) -> &'static ModelInfo {
        self.code.info
    }

    fn params(&self) -> Vec<f64> {
        self.values.clone()
    }

    fn with_values(&self, values: &[f64]) -> Arc<dyn LaneModel> {
        Arc::new(Self::with(Arc::clone(&self.code), values.to_vec()))
    }

    fn f_cos(&self, level: SimdLevel, pair: &DirectionPair<[f32; 16]>) -> [f32; 16] {
        let mut values = [f32::NAN; 16];
        self.with_registers(level, |file| {
            // Of a loop without end no value is right.
            if self.run(level, pair, file).is_err() {
                return;
            }
            let registers = &self.code.program.lowered.layout.outputs[0].registers;
            let row = |i: usize| file.get(registers[i.min(registers.len() - 1)])[0];
            let (r, g, b) = (row(0), row(1), row(2));
            at_level!(level, simd => {
                let [r, g, b] = [r, g, b].map(#[inline(always)] |row| Lanes::load(simd, &row.0));
                let [cos_o, cos_i] = [&pair.cos_o, &pair.cos_i].map(#[inline(always)] |row| Lanes::load(simd, row));
                let same = r.le(g) & g.le(r) & g.le(b) & b.le(g);
                let f_cos = r.select(same, (r + g + b) * r.lit(1.0 / 3.0)) * cos_i;
                let zero = r.zero();
                // Interpolated normals turn a little from the viewer; what is no light there is none.
                let light = zero.le(f_cos) & f_cos.lt(f_cos.lit(f64::INFINITY));
                let counts = zero.lt(cos_i) & (zero.le(cos_o) | light);
                f_cos.select(counts, zero).store(&mut values);
            });
        });
        values
    }

    fn source(&self) -> Option<&ModelSource> {
        Some(&self.code.source)
    }
}

/// Whether channels differ by more than rounding.
fn apart(channels: [f32; 3]) -> bool {
    let (low, high) =
        channels.iter().fold((f32::MAX, f32::MIN), |(low, high), c| (low.min(*c), high.max(*c)));
    high - low > 1e-5 * high.abs()
}

fn endless(error: RunError) -> ShaderError {
    let RunError::EndlessLoop { place, turns } = error;
    let place: Option<Place> = place;
    ShaderError::Invalid {
        message: format!("a loop takes more than {turns} turns"),
        place,
        hints: Vec::new(),
    }
}
