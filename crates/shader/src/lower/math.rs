//! Built-in functions.

use core::f32::consts::{LN_2, LOG2_E};

use naga::{MathFunction as M, ScalarKind as K, Span, TypeInner};

use super::{Lowering, Refused, Reg};
use crate::machine::Code;

impl Lowering<'_> {
    pub(super) fn math(
        &mut self,
        fun: M,
        inner: &TypeInner,
        [a, b, c, d]: [&[Reg]; 4],
        span: Span,
    ) -> Result<Vec<Reg>, Refused> {
        let (n, kind) = (a.len(), self.kind(inner));
        let by_kind = |float, sint, uint| match kind {
            K::Sint | K::AbstractInt => sint,
            K::Uint | K::Bool => uint,
            K::Float | K::AbstractFloat => float,
        };
        Ok(match fun {
            M::Abs => self.op(by_kind(Code::FAbs, Code::IAbs, Code::Mov), n, &[a]),
            M::Min => self.op(by_kind(Code::FMin, Code::IMin, Code::UMin), n, &[a, b]),
            M::Max => self.op(by_kind(Code::FMax, Code::IMax, Code::UMax), n, &[a, b]),
            M::Clamp if kind == K::Float => self.op(Code::FClamp, n, &[a, b, c]),
            M::Clamp => {
                let up = self.op(by_kind(Code::FMax, Code::IMax, Code::UMax), n, &[a, b]);
                self.op(by_kind(Code::FMin, Code::IMin, Code::UMin), n, &[&up, c])
            }
            M::Saturate => {
                let (zero, one) = (self.float(0.0), self.float(1.0));
                self.op(Code::FClamp, n, &[a, &zero, &one])
            }
            M::Sign => self.op(by_kind(Code::FSign, Code::ISign, Code::ISign), n, &[a]),
            M::Cos => self.op(Code::FCos, n, &[a]),
            M::Sin => self.op(Code::FSin, n, &[a]),
            M::Tan => self.op(Code::FTan, n, &[a]),
            M::Acos => self.op(Code::FAcos, n, &[a]),
            M::Asin => self.op(Code::FAsin, n, &[a]),
            M::Atan => self.op(Code::FAtan, n, &[a]),
            M::Atan2 => self.op(Code::FAtan2, n, &[a, b]),
            M::Cosh | M::Sinh | M::Tanh | M::Asinh | M::Acosh | M::Atanh => self.hyperbolic(fun, a),
            M::Radians => self.scaled(a, core::f32::consts::PI / 180.0),
            M::Degrees => self.scaled(a, 180.0 / core::f32::consts::PI),
            M::Ceil => self.op(Code::FCeil, n, &[a]),
            M::Floor => self.op(Code::FFloor, n, &[a]),
            M::Round => self.op(Code::FRound, n, &[a]),
            M::Fract => self.op(Code::FFract, n, &[a]),
            M::Trunc => self.op(Code::FTrunc, n, &[a]),
            M::Modf => {
                let whole = self.op(Code::FTrunc, n, &[a]);
                let mut parts = self.op(Code::FSub, n, &[a, &whole]);
                parts.extend(whole);
                parts
            }
            M::Ldexp => {
                let x = self.op(Code::IToF, n, &[b]);
                let power = self.op(Code::FExp2, n, &[&x]);
                self.op(Code::FMul, n, &[a, &power])
            }
            M::Exp => self.exp(a),
            M::Exp2 => self.op(Code::FExp2, n, &[a]),
            M::Log => self.ln(a),
            M::Log2 => self.op(Code::FLog2, n, &[a]),
            M::Pow => self.op(Code::FPow, n, &[a, b]),
            M::Dot
            | M::Cross
            | M::Distance
            | M::Length
            | M::Normalize
            | M::FaceForward
            | M::Reflect
            | M::Refract => self.geometric(fun, kind, a, b, c),
            M::Fma => self.op(Code::FMad, n, &[a, b, c]),
            M::Mix => self.op(Code::FMix, n, &[a, b, c]),
            M::Step => self.op(Code::FStep, n.max(b.len()), &[a, b]),
            M::SmoothStep => self.op(Code::FSmooth, n.max(c.len()), &[a, b, c]),
            M::Sqrt => self.op(Code::FSqrt, n, &[a]),
            M::InverseSqrt => self.op(Code::FRsqrt, n, &[a]),
            M::Outer | M::Inverse | M::Transpose | M::Determinant => {
                self.matrix_function(fun, inner, a, b)
                    .ok_or_else(|| Refused::new("this function is for square matrices", span))?
            }
            M::CountOneBits => self.op(Code::CountOnes, n, &[a]),
            M::ReverseBits => self.op(Code::ReverseBits, n, &[a]),
            M::CountLeadingZeros => self.op(Code::LeadingZeros, n, &[a]),
            M::CountTrailingZeros => self.op(Code::TrailingZeros, n, &[a]),
            M::FirstTrailingBit | M::FirstLeadingBit => self.first_bit(fun, kind, a),
            M::ExtractBits | M::InsertBits => self.bit_field(fun, kind, [a, b, c, d]),
            M::Frexp
            | M::QuantizeToF16
            | M::Dot4I8Packed
            | M::Dot4U8Packed
            | M::Pack4x8snorm
            | M::Pack4x8unorm
            | M::Pack2x16snorm
            | M::Pack2x16unorm
            | M::Pack2x16float
            | M::Pack4xI8
            | M::Pack4xU8
            | M::Pack4xI8Clamp
            | M::Pack4xU8Clamp
            | M::Unpack4x8snorm
            | M::Unpack4x8unorm
            | M::Unpack2x16snorm
            | M::Unpack2x16unorm
            | M::Unpack2x16float
            | M::Unpack4xI8
            | M::Unpack4xU8 => {
                return Err(Refused::new("packing, half precision and frexp are not there", span));
            }
        })
    }

    /// Functions of whole vectors.
    fn geometric(&mut self, fun: M, kind: K, a: &[Reg], b: &[Reg], c: &[Reg]) -> Vec<Reg> {
        let n = a.len();
        match fun {
            M::Dot if kind == K::Float => self.whole(Code::Dot, 1, a, b),
            M::Dot => self.integer_dot(a, b),
            M::Cross => self.whole(Code::Cross, 3, a, b),
            M::Distance => {
                let difference = self.op(Code::FSub, n, &[a, b]);
                self.whole(Code::Length, 1, &difference, &[])
            }
            M::Length => self.whole(Code::Length, 1, a, &[]),
            M::Normalize => self.whole(Code::Normalize, n, a, &[]),
            M::FaceForward => {
                let d = self.whole(Code::Dot, 1, b, c);
                let (zero, minus) = (self.float(0.0), self.op(Code::FNeg, n, &[a]));
                let front = self.op(Code::FLt, 1, &[&d, &zero]);
                self.op(Code::Sel, n, &[a, &minus, &front])
            }
            M::Reflect => {
                let d = self.whole(Code::Dot, 1, b, a);
                let twice = self.op(Code::FAdd, 1, &[&d, &d]);
                let part = self.op(Code::FMul, n, &[&twice, b]);
                self.op(Code::FSub, n, &[a, &part])
            }
            _ => self.refract(a, b, c),
        }
    }

    fn scaled(&mut self, x: &[Reg], factor: f32) -> Vec<Reg> {
        let factor = self.float(factor);
        self.op(Code::FMul, x.len(), &[x, &factor])
    }

    fn exp(&mut self, x: &[Reg]) -> Vec<Reg> {
        let x = self.scaled(x, LOG2_E);
        self.op(Code::FExp2, x.len(), &[&x])
    }

    fn ln(&mut self, x: &[Reg]) -> Vec<Reg> {
        let x = self.op(Code::FLog2, x.len(), &[x]);
        self.scaled(&x, LN_2)
    }

    /// By exponentials and logarithms, as GLSL defines them.
    fn hyperbolic(&mut self, fun: M, x: &[Reg]) -> Vec<Reg> {
        let n = x.len();
        let one = self.float(1.0);
        match fun {
            M::Asinh | M::Acosh => {
                let square = self.op(Code::FMul, n, &[x, x]);
                let code = if fun == M::Asinh { Code::FAdd } else { Code::FSub };
                let inside = self.op(code, n, &[&square, &one]);
                let root = self.op(Code::FSqrt, n, &[&inside]);
                let sum = self.op(Code::FAdd, n, &[x, &root]);
                self.ln(&sum)
            }
            M::Atanh => {
                let (up, down) = (self.op(Code::FAdd, n, &[&one, x]), self.op(Code::FSub, n, &[&one, x]));
                let ratio = self.op(Code::FDiv, n, &[&up, &down]);
                let log = self.ln(&ratio);
                self.scaled(&log, 0.5)
            }
            _ => {
                let minus = self.op(Code::FNeg, n, &[x]);
                let (up, down) = (self.exp(x), self.exp(&minus));
                let (sum, difference) =
                    (self.op(Code::FAdd, n, &[&up, &down]), self.op(Code::FSub, n, &[&up, &down]));
                match fun {
                    M::Cosh => self.scaled(&sum, 0.5),
                    M::Sinh => self.scaled(&difference, 0.5),
                    _ => self.tanh(x),
                }
            }
        }
    }

    /// 1 − 2 / (e^2x + 1), which has no quotient of infinities.
    fn tanh(&mut self, x: &[Reg]) -> Vec<Reg> {
        let n = x.len();
        let (one, two) = (self.float(1.0), self.float(2.0));
        let twice = self.op(Code::FAdd, n, &[x, x]);
        let power = self.exp(&twice);
        let below = self.op(Code::FAdd, n, &[&power, &one]);
        let part = self.op(Code::FDiv, n, &[&two, &below]);
        self.op(Code::FSub, n, &[&one, &part])
    }

    fn integer_dot(&mut self, a: &[Reg], b: &[Reg]) -> Vec<Reg> {
        let products = self.op(Code::IMul, a.len(), &[a, b]);
        let mut sum = products[0];
        for p in &products[1..] {
            sum = self.op(Code::IAdd, 1, &[&[sum], &[*p]])[0];
        }
        vec![sum]
    }

    fn refract(&mut self, i: &[Reg], normal: &[Reg], eta: &[Reg]) -> Vec<Reg> {
        let n = i.len();
        let (one, zero) = (self.float(1.0), self.float(0.0));
        let d = self.whole(Code::Dot, 1, normal, i);
        let square = self.op(Code::FMul, 1, &[&d, &d]);
        let sine = self.op(Code::FSub, 1, &[&one, &square]);
        let eta_square = self.op(Code::FMul, 1, &[eta, eta]);
        let part = self.op(Code::FMul, 1, &[&eta_square, &sine]);
        let k = self.op(Code::FSub, 1, &[&one, &part]);
        let total = self.op(Code::FLt, 1, &[&k, &zero]);
        let root = self.op(Code::FSqrt, 1, &[&k]);
        let along = self.op(Code::FMul, 1, &[eta, &d]);
        let weight = self.op(Code::FAdd, 1, &[&along, &root]);
        let (x, y) = (self.op(Code::FMul, n, &[i, eta]), self.op(Code::FMul, n, &[normal, &weight]));
        let refracted = self.op(Code::FSub, n, &[&x, &y]);
        self.op(Code::Sel, n, &[&zero, &refracted, &total])
    }

    /// The index of the lowest or highest bit that is set (of negative numbers: that is not), −1 if there is none.
    fn first_bit(&mut self, fun: M, kind: K, a: &[Reg]) -> Vec<Reg> {
        let n = a.len();
        let (none, zero) = (vec![self.word(u32::MAX)], self.zeros(1));
        let mut x = a.to_vec();
        if fun == M::FirstLeadingBit && kind == K::Sint {
            let (sign, inverted) = (self.op(Code::ILt, n, &[a, &zero]), self.op(Code::Not, n, &[a]));
            x = self.op(Code::Sel, n, &[&inverted, a, &sign]);
        }
        let empty = self.op(Code::IEq, n, &[&x, &zero]);
        let place = match fun {
            M::FirstTrailingBit => self.op(Code::TrailingZeros, n, &[&x]),
            _ => {
                let (zeros, top) = (self.op(Code::LeadingZeros, n, &[&x]), vec![self.word(31)]);
                self.op(Code::ISub, n, &[&top, &zeros])
            }
        };
        self.op(Code::Sel, n, &[&none, &place, &empty])
    }

    /// extractBits(e, offset, count) and insertBits(e, new, offset, count), both numbers clamped to the 32 bits.
    fn bit_field(&mut self, fun: M, kind: K, [a, b, c, d]: [&[Reg]; 4]) -> Vec<Reg> {
        let n = a.len();
        let (all, whole) = (vec![self.word(u32::MAX)], vec![self.word(32)]);
        let (offset, count) = if fun == M::ExtractBits { (b, c) } else { (c, d) };
        let offset = self.op(Code::UMin, 1, &[offset, &whole]);
        let room = self.op(Code::ISub, 1, &[&whole, &offset]);
        let count = self.op(Code::UMin, 1, &[count, &room]);
        let rest = self.op(Code::ISub, 1, &[&whole, &count]);
        let (zero, none) = (self.zeros(1), self.op(Code::IEq, 1, &[&count, &whole]));
        let empty = self.op(Code::IEq, 1, &[&count, &zero]);
        if fun == M::ExtractBits {
            let left = self.op(Code::ISub, 1, &[&rest, &offset]);
            let up = self.op(Code::Shl, n, &[a, &left]);
            let code = if kind == K::Sint { Code::ShrI } else { Code::ShrU };
            let down = self.op(code, n, &[&up, &rest]);
            return self.op(Code::Sel, n, &[&zero, &down, &empty]);
        }
        let low = self.op(Code::ShrU, 1, &[&all, &rest]);
        let low = self.op(Code::Sel, 1, &[&all, &low, &none]);
        let mask = self.op(Code::Shl, 1, &[&low, &offset]);
        let mask = self.op(Code::Sel, 1, &[&zero, &mask, &empty]);
        let new = self.op(Code::Shl, n, &[b, &offset]);
        let (new, old) = (self.op(Code::And, n, &[&new, &mask]), self.op(Code::AndNot, n, &[a, &mask]));
        self.op(Code::Or, n, &[&new, &old])
    }
}
