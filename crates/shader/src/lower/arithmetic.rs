//! Binary operators.

use naga::{BinaryOperator as B, ScalarKind as K, TypeInner};

use super::{Lowering, Reg};
use crate::machine::Code;

impl Lowering<'_> {
    pub(super) fn binary(&mut self, op: B, l: &TypeInner, r: &TypeInner, a: &[Reg], b: &[Reg]) -> Vec<Reg> {
        if op == B::Multiply
            && let Some(product) = self.matrix_product(l, r, a, b)
        {
            return product;
        }
        let n = a.len().max(b.len());
        let code = match (op, self.kind(l)) {
            (B::Add, K::Float) => Code::FAdd,
            (B::Add, _) => Code::IAdd,
            (B::Subtract, K::Float) => Code::FSub,
            (B::Subtract, _) => Code::ISub,
            (B::Multiply, K::Float) => Code::FMul,
            (B::Multiply, _) => Code::IMul,
            (B::Divide, K::Float) => Code::FDiv,
            (B::Divide, K::Sint) => Code::IDiv,
            (B::Divide, _) => Code::UDiv,
            (B::Modulo, K::Float) => Code::FMod,
            (B::Modulo, K::Sint) => Code::IMod,
            (B::Modulo, _) => Code::UMod,
            (B::Equal, K::Float) => Code::FEq,
            (B::Equal, _) => Code::IEq,
            (B::NotEqual, K::Float) => Code::FNe,
            (B::NotEqual, _) => Code::INe,
            (B::Less, K::Float) => Code::FLt,
            (B::Less, K::Sint) => Code::ILt,
            (B::Less, _) => Code::ULt,
            (B::LessEqual, K::Float) => Code::FLe,
            (B::LessEqual, K::Sint) => Code::ILe,
            (B::LessEqual, _) => Code::ULe,
            (B::Greater, K::Float) => Code::FGt,
            (B::Greater, K::Sint) => Code::IGt,
            (B::Greater, _) => return self.op(Code::ULt, n, &[b, a]),
            (B::GreaterEqual, K::Float) => Code::FGe,
            (B::GreaterEqual, K::Sint) => Code::IGe,
            (B::GreaterEqual, _) => return self.op(Code::ULe, n, &[b, a]),
            (B::And | B::LogicalAnd, _) => Code::And,
            (B::InclusiveOr | B::LogicalOr, _) => Code::Or,
            (B::ExclusiveOr, _) => Code::Xor,
            (B::ShiftLeft, _) => Code::Shl,
            (B::ShiftRight, K::Sint) => Code::ShrI,
            (B::ShiftRight, _) => Code::ShrU,
        };
        self.op(code, n, &[a, b])
    }
}
