//! The dispatch loop.

use glanz_math::simd::{Bytes, Select, Simd, SimdBase, SimdFloat, SimdInt, SimdMask, i32x16, u32x16};
use glanz_math::{Lanes, Real};

use super::file::{ROWS, RegisterFile, Row, index};
use super::numbers::{
    exp2, floor, from_int, int, log2, mask, pow, remainder, sign, sine, smoothstep, truth, uint,
};
use super::textures::{Lod, Look, LookLod, TextureQuery, Textures};
use super::{Code, Op};

/// What a run reads and tells beside the registers.
pub(crate) struct Host<'a> {
    /// The uniforms, a word per scalar.
    pub(crate) uniforms: &'a [u32],
    pub(crate) textures: &'a dyn Textures,
    pub(crate) looks: &'a [Look<u16>],
    /// Turns of loops that are left.
    pub(crate) fuel: u32,
    /// Whether rows of pixels count from the top.
    pub(crate) down: bool,
}

/// Who hears of the events of a traced program.
pub(crate) trait Recorder {
    /// Event `event` happened; `registers` tells the first 16 lanes of any register.
    fn note<'a>(&mut self, event: usize, registers: &dyn Fn(u16) -> &'a [f32; 16]);
}

/// Nobody.
pub(crate) struct Silent;

impl Recorder for Silent {
    fn note<'a>(&mut self, _: usize, _: &dyn Fn(u16) -> &'a [f32; 16]) {}
}

/// The fuel was used up at this instruction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct OutOfFuel {
    pub(crate) at: usize,
}

type Registers<const G: usize> = [[Row; G]; ROWS];

#[inline(always)]
fn load<S: Simd, const G: usize>(simd: S, file: &Registers<G>, register: u16, g: usize) -> Lanes<S> {
    Lanes::load(simd, &file[index(register)][g].0)
}

#[inline(always)]
fn store<S: Simd, const G: usize>(file: &mut Registers<G>, register: u16, g: usize, value: Lanes<S>) {
    value.store(&mut file[index(register)][g].0);
}

/// The sums of products in the order of the components.
#[inline(always)]
fn dot<S: Simd, const G: usize>(simd: S, file: &Registers<G>, op: &Op, b: u16) -> [Lanes<S>; G] {
    let (x, y) = (&file[index(op.a)], &file[index(b)]);
    let mut sums = [Lanes::splat(simd, 0.0); G];
    for g in 0..G {
        sums[g] = Lanes::load(simd, &x[g].0) * Lanes::load(simd, &y[g].0);
    }
    for k in 1..op.n {
        let (x, y) = (&file[index(op.a + k)], &file[index(b + k)]);
        for g in 0..G {
            sums[g] = sums[g] + Lanes::load(simd, &x[g].0) * Lanes::load(simd, &y[g].0);
        }
    }
    sums
}

#[inline(always)]
fn cross<S: Simd, const G: usize>(simd: S, file: &mut Registers<G>, op: &Op) {
    for g in 0..G {
        let (ax, bx) = (load(simd, file, op.a, g), load(simd, file, op.b, g));
        let (ay, by) = (load(simd, file, op.a + 1, g), load(simd, file, op.b + 1, g));
        let (az, bz) = (load(simd, file, op.a + 2, g), load(simd, file, op.b + 2, g));
        store(file, op.d, g, ay * bz - az * by);
        store(file, op.d + 1, g, az * bx - ax * bz);
        store(file, op.d + 2, g, ax * by - ay * bx);
    }
}

/// Lanes are 4×4 pixels, row by row; quads are 2×2 of them. `bit` is 1 along x and 4 along y. `down`: rows count from the
/// top, so that later ones have the lesser coordinate.
#[expect(clippy::needless_range_loop, reason = "two registers of the file are indexed")]
#[inline(always)]
fn derivative<const G: usize>(file: &mut Registers<G>, op: &Op, bit: usize, down: bool) {
    let [more, less] = if down { [0, bit] } else { [bit, 0] };
    for k in 0..op.n {
        for g in 0..G {
            let x = file[index(op.a + k * (u16::from(op.s) & 1))][g].0;
            let out = &mut file[index(op.d + k)][g].0;
            for (lane, out) in out.iter_mut().enumerate() {
                let first = lane & !bit & 15;
                *out = x[first | more] - x[first | less];
            }
        }
    }
}

fn word(uniforms: &[u32], at: usize) -> f32 {
    f32::from_bits(uniforms.get(at).copied().unwrap_or(0))
}

fn load_uniform<const G: usize>(file: &mut Registers<G>, op: &Op, uniforms: &[u32], first: usize) {
    for k in 0..op.n {
        file[index(op.d + k)] = [Row([word(uniforms, first + k as usize); 16]); G];
    }
}

#[expect(clippy::needless_range_loop, reason = "two registers of the file are indexed")]
#[inline(never)]
fn load_uniform_indexed<const G: usize>(file: &mut Registers<G>, op: &Op, uniforms: &[u32]) {
    let first = |i: f32| op.imm as usize + (i.to_bits() as usize).min(op.b as usize) * op.c as usize;
    if op.s & 8 != 0 {
        let at = first(file[index(op.a)][0].0[0]);
        return load_uniform(file, op, uniforms, at);
    }
    for g in 0..G {
        let indices = file[index(op.a)][g].0;
        for (lane, i) in indices.into_iter().enumerate() {
            for k in 0..op.n {
                file[index(op.d + k)][g].0[lane] = word(uniforms, first(i) + k as usize);
            }
        }
    }
}

// Rare and long: out of the loop, whose registers it would take.
#[inline(never)]
fn sample<const G: usize>(file: &mut Registers<G>, op: &Op, host: &Host<'_>) {
    let Some(look) = host.looks.get(op.imm as usize) else { return };
    for g in 0..G {
        let mut texels = [[0.0; 16], [0.0; 16], [0.0; 16], [1.0; 16]];
        answer(file, look, g, host, &mut texels);
        for k in 0..op.n.min(4) {
            file[index(op.d + k)][g].0 = texels[k as usize & 3];
        }
    }
}

fn answer<const G: usize>(
    file: &Registers<G>,
    look: &Look<u16>,
    g: usize,
    host: &Host<'_>,
    texels: &mut [[f32; 16]; 4],
) {
    let row = |r: u16| file[index(r)][g].0;
    let rows = |list: &[u16]| {
        let mut out = [[0.0; 16]; 3];
        out.iter_mut().zip(list).for_each(|(out, r)| *out = row(*r));
        out
    };
    let ints = |r: &Option<u16>| r.map_or([0; 16], |r| row(r).map(|x| x.to_bits() as i32));
    let lod = match &look.lod {
        LookLod::Auto => gradient(rows(&look.coordinates), [0.0; 16]),
        LookLod::Bias(bias) => gradient(rows(&look.coordinates), row(*bias)),
        LookLod::Level(level) => Lod::Level(row(*level)),
        LookLod::Gradient(dx, dy) => Lod::Gradient { dx: rows(dx), dy: rows(dy), bias: [0.0; 16] },
        LookLod::Gather(component) => Lod::Gather(*component),
        LookLod::Texel(level) => Lod::Texel(ints(level)),
        LookLod::Size(level) => {
            let levels = ints(level);
            for lane in 0..16 {
                let size = host.textures.size(look.texture, levels[lane].max(0) as u32);
                size.iter().zip(&mut *texels).for_each(|(n, out)| out[lane] = f32::from_bits(*n));
            }
            return;
        }
        LookLod::Levels => {
            texels[0] = [f32::from_bits(host.textures.levels(look.texture)); 16];
            return;
        }
    };
    let query = TextureQuery {
        texture: look.texture,
        coordinates: rows(&look.coordinates),
        layer: look.layer.map(row),
        lod,
        offset: look.offset,
        compare: look.compare.map(row),
    };
    host.textures.sample(&query, texels);
}

fn gradient(coordinates: [[f32; 16]; 3], bias: [f32; 16]) -> Lod {
    let along = |bit: usize| {
        coordinates.map(|x| core::array::from_fn(|lane| x[(lane | bit) & 15] - x[lane & !bit & 15]))
    };
    Lod::Gradient { dx: along(1), dy: along(4), bias }
}

#[cold]
#[inline(never)]
fn note<const G: usize>(file: &Registers<G>, op: &Op, recorder: &mut dyn Recorder) {
    recorder.note(op.imm as usize, &|r| &file[index(r)][0].0);
}

/// Runs `ops` to their end.
///
/// One function, since the compiler makes one table of jumps of one match.
#[inline(always)]
pub(crate) fn execute<S: Simd, const G: usize>(
    simd: S,
    ops: &[Op],
    file: &mut RegisterFile<G>,
    host: &Host<'_>,
    recorder: &mut dyn Recorder,
) -> Result<(), OutOfFuel> {
    let file: &mut Registers<G> = &mut file.0;
    let mut next = 0;
    let mut fuel = host.fuel;
    while let Some(op) = ops.get(next) {
        next += 1;
        let (sa, sb, sc) = (u16::from(op.s) & 1, u16::from(op.s) >> 1 & 1, u16::from(op.s) >> 2 & 1);
        macro_rules! each {
            (|$x:ident| $e:expr) => {{
                let (mut a, mut d) = (op.a, op.d);
                for _ in 0..op.n {
                    let (from, to) = (index(a), index(d));
                    for g in 0..G {
                        let $x = Lanes::load(simd, &file[from][g].0);
                        let value: Lanes<S> = $e;
                        value.store(&mut file[to][g].0);
                    }
                    (a, d) = (a + sa, d + 1);
                }
            }};
            (|$x:ident, $y:ident| $e:expr) => {{
                let (mut a, mut b, mut d) = (op.a, op.b, op.d);
                for _ in 0..op.n {
                    let (from_a, from_b, to) = (index(a), index(b), index(d));
                    for g in 0..G {
                        let $x = Lanes::load(simd, &file[from_a][g].0);
                        let $y = Lanes::load(simd, &file[from_b][g].0);
                        let value: Lanes<S> = $e;
                        value.store(&mut file[to][g].0);
                    }
                    (a, b, d) = (a + sa, b + sb, d + 1);
                }
            }};
            (|$x:ident, $y:ident, $z:ident| $e:expr) => {{
                let (mut a, mut b, mut c, mut d) = (op.a, op.b, op.c, op.d);
                for _ in 0..op.n {
                    let (from_a, from_b, from_c, to) = (index(a), index(b), index(c), index(d));
                    for g in 0..G {
                        let $x = Lanes::load(simd, &file[from_a][g].0);
                        let $y = Lanes::load(simd, &file[from_b][g].0);
                        let $z = Lanes::load(simd, &file[from_c][g].0);
                        let value: Lanes<S> = $e;
                        value.store(&mut file[to][g].0);
                    }
                    (a, b, c, d) = (a + sa, b + sb, c + sc, d + 1);
                }
            }};
        }
        macro_rules! lanes {
            (|$x:ident, $y:ident| $e:expr) => {{
                for k in 0..op.n {
                    for g in 0..G {
                        let (xs, ys) = (file[index(op.a + k * sa)][g].0, file[index(op.b + k * sb)][g].0);
                        let out = &mut file[index(op.d + k)][g].0;
                        for lane in 0..16 {
                            let ($x, $y) = (xs[lane].to_bits() as i32, ys[lane].to_bits() as i32);
                            out[lane] = f32::from_bits($e as u32);
                        }
                    }
                }
            }};
        }
        match op.code {
            Code::Mov => each!(|x| x),
            Code::FAdd => each!(|x, y| x + y),
            Code::FSub => each!(|x, y| x - y),
            Code::FMul => each!(|x, y| x * y),
            Code::FDiv => each!(|x, y| x / y),
            Code::FMod => each!(|x, y| remainder(x, y)),
            Code::FNeg => each!(|x| -x),
            Code::FAbs => each!(|x| Lanes(x.0.abs())),
            Code::FMin => each!(|x, y| x.min(y)),
            Code::FMax => each!(|x, y| x.max(y)),
            Code::FFloor => each!(|x| floor(x)),
            Code::FCeil => each!(|x| Lanes(x.0.ceil())),
            Code::FFract => each!(|x| x - floor(x)),
            Code::FTrunc => each!(|x| Lanes(x.0.trunc())),
            Code::FRound => each!(|x| Lanes(x.0.round_ties_even())),
            Code::FSign => each!(|x| sign(x)),
            Code::FSqrt => each!(|x| Real::sqrt(x)),
            Code::FRsqrt => each!(|x| x.rsqrt()),
            Code::FExp2 => each!(|x| exp2(x)),
            Code::FLog2 => each!(|x| log2(x)),
            Code::FPow => each!(|x, y| pow(x, y)),
            Code::FSin => each!(|x| sine(x, 0)),
            Code::FCos => each!(|x| sine(x, 1)),
            Code::FTan => each!(|x| sine(x, 0) / sine(x, 1)),
            Code::FAcos => each!(|x| x.acos()),
            Code::FAsin => each!(|x| x.lit(core::f64::consts::FRAC_PI_2) - x.acos()),
            Code::FAtan => each!(|x| x.atan2(x.one())),
            Code::FAtan2 => each!(|y, x| y.atan2(x)),
            Code::FMad => each!(|x, y, z| x * y + z),
            Code::FMix => each!(|x, y, t| x * (t.one() - t) + y * t),
            Code::FClamp => each!(|x, low, high| x.max(low).min(high)),
            Code::FStep => each!(|edge, x| x.zero().select(x.lt(edge), x.one())),
            Code::FSmooth => each!(|low, high, x| smoothstep(low, high, x)),
            Code::FLt => each!(|x, y| truth(simd, x.0.simd_lt(y.0))),
            Code::FLe => each!(|x, y| truth(simd, x.0.simd_le(y.0))),
            Code::FGt => each!(|x, y| truth(simd, x.0.simd_gt(y.0))),
            Code::FGe => each!(|x, y| truth(simd, x.0.simd_ge(y.0))),
            Code::FEq => each!(|x, y| truth(simd, x.0.simd_eq(y.0))),
            Code::FNe => each!(|x, y| truth(simd, !x.0.simd_eq(y.0))),
            Code::IAdd => each!(|x, y| from_int(int(x) + int(y))),
            Code::ISub => each!(|x, y| from_int(int(x) - int(y))),
            Code::IMul => each!(|x, y| from_int(int(x) * int(y))),
            Code::INeg => each!(|x| from_int(simd.splat_i32x16(0) - int(x))),
            Code::IAbs => each!(|x| {
                let negated = simd.splat_i32x16(0) - int(x);
                from_int(mask(x).select(negated, int(x)))
            }),
            Code::ISign => lanes!(|x, _y| x.signum()),
            Code::IMin => each!(|x, y| from_int(int(x).simd_lt(int(y)).select(int(x), int(y)))),
            Code::IMax => each!(|x, y| from_int(int(y).simd_lt(int(x)).select(int(x), int(y)))),
            Code::UMin => lanes!(|x, y| (x as u32).min(y as u32)),
            Code::UMax => lanes!(|x, y| (x as u32).max(y as u32)),
            // As WGSL defines them: x / 0 = x, MIN / −1 = MIN; x % 0 = 0.
            Code::IDiv => lanes!(|x, y| if y == 0 { x } else { x.wrapping_div(y) }),
            Code::IMod => lanes!(|x, y| if y == 0 { 0 } else { x.wrapping_rem(y) }),
            Code::UDiv => lanes!(|x, y| (x as u32).checked_div(y as u32).unwrap_or(x as u32)),
            Code::UMod => lanes!(|x, y| (x as u32).checked_rem(y as u32).unwrap_or(0)),
            Code::ILt => each!(|x, y| truth(simd, int(x).simd_lt(int(y)))),
            Code::ILe => each!(|x, y| truth(simd, int(x).simd_le(int(y)))),
            Code::IGt => each!(|x, y| truth(simd, int(x).simd_gt(int(y)))),
            Code::IGe => each!(|x, y| truth(simd, int(x).simd_ge(int(y)))),
            Code::IEq => each!(|x, y| truth(simd, int(x).simd_eq(int(y)))),
            Code::INe => each!(|x, y| truth(simd, !int(x).simd_eq(int(y)))),
            Code::ULt => each!(|x, y| truth(simd, uint(x).simd_lt(uint(y)))),
            Code::ULe => each!(|x, y| truth(simd, uint(x).simd_le(uint(y)))),
            Code::And => each!(|x, y| from_int(int(x) & int(y))),
            Code::Or => each!(|x, y| from_int(int(x) | int(y))),
            Code::Xor => each!(|x, y| from_int(int(x) ^ int(y))),
            Code::Not => each!(|x| from_int(!int(x))),
            Code::AndNot => each!(|x, y| from_int(int(x) & !int(y))),
            Code::Shl => lanes!(|x, y| x.wrapping_shl(y as u32)),
            Code::ShrI => lanes!(|x, y| x.wrapping_shr(y as u32)),
            Code::ShrU => lanes!(|x, y| (x as u32).wrapping_shr(y as u32)),
            Code::CountOnes => lanes!(|x, _y| x.count_ones()),
            Code::ReverseBits => lanes!(|x, _y| x.reverse_bits()),
            Code::LeadingZeros => lanes!(|x, _y| x.leading_zeros()),
            Code::TrailingZeros => lanes!(|x, _y| x.trailing_zeros()),
            Code::Sel => each!(|x, y, m| Lanes(mask(m).select(x.0, y.0))),
            Code::FToI => each!(|x| from_int(x.0.to_int_precise::<i32x16<S>>())),
            Code::FToU => each!(|x| Lanes(x.0.to_int_precise::<u32x16<S>>().bitcast())),
            Code::IToF => each!(|x| Lanes(int(x).to_float())),
            Code::UToF => each!(|x| Lanes(uint(x).to_float())),
            Code::BToF => each!(|x| Lanes(mask(x).select(x.one().0, x.zero().0))),
            Code::BToI => each!(|x| from_int(int(x) & simd.splat_i32x16(1))),
            Code::Dot => {
                let sums = dot(simd, file, op, op.b);
                let to = &mut file[index(op.d)];
                for g in 0..G {
                    sums[g].store(&mut to[g].0);
                }
            }
            Code::Length => {
                let sums = dot(simd, file, op, op.a);
                let to = &mut file[index(op.d)];
                for g in 0..G {
                    Real::sqrt(sums[g]).store(&mut to[g].0);
                }
            }
            Code::Normalize => {
                let mut scales = dot(simd, file, op, op.a);
                for scale in &mut scales {
                    *scale = scale.rsqrt();
                }
                for k in 0..op.n {
                    let (from, to) = (index(op.a + k), index(op.d + k));
                    for g in 0..G {
                        let value = Lanes::load(simd, &file[from][g].0) * scales[g];
                        value.store(&mut file[to][g].0);
                    }
                }
            }
            Code::Cross => cross(simd, file, op),
            Code::Imm => file[index(op.d)] = [Row([f32::from_bits(op.imm); 16]); G],
            Code::LoadU => load_uniform(file, op, host.uniforms, op.imm as usize),
            Code::LoadUI => load_uniform_indexed(file, op, host.uniforms),
            Code::DdX => derivative(file, op, 1, false),
            Code::DdY => derivative(file, op, 4, host.down),
            Code::Texture => sample(file, op, host),
            Code::Jump => next = op.imm as usize,
            Code::JumpNone | Code::JumpAny => {
                let mut any = false;
                for g in 0..G {
                    any |= mask(load(simd, file, op.a, g)).any_true();
                }
                if any == (op.code == Code::JumpAny) {
                    next = op.imm as usize;
                }
            }
            Code::Count => {
                if fuel == 0 {
                    return Err(OutOfFuel { at: next - 1 });
                }
                fuel -= 1;
            }
            Code::Note => note(file, op, recorder),
        }
    }
    Ok(())
}
