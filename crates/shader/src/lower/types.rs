//! Sizes and kinds of types.

use naga::{ArraySize, Expression, Handle, ScalarKind, Span, Type, TypeInner};

use super::{Frame, Lowering, MOST_SCALARS, Refused};
use crate::{Scalar, ValueType};

/// Most words of uniforms.
const MOST_UNIFORMS: usize = 1 << 16;

impl Lowering<'_> {
    /// Scalars of a type; `None` beyond all limits.
    fn scalars(&self, inner: &TypeInner) -> Option<usize> {
        let of = |ty: Handle<Type>| self.scalars(&self.module.types[ty].inner);
        let n = match *inner {
            TypeInner::Scalar(_) | TypeInner::Atomic(_) => 1,
            TypeInner::Vector { size, .. } => size as usize,
            TypeInner::Matrix { columns, rows, .. } => columns as usize * rows as usize,
            TypeInner::Array { base, size, .. } => of(base)?.checked_mul(self.count(size))?,
            TypeInner::Struct { ref members, .. } => {
                let mut sum = 0usize;
                for member in members {
                    sum = sum.checked_add(of(member.ty)?)?;
                }
                sum
            }
            TypeInner::Pointer { base, .. } => of(base)?,
            TypeInner::ValuePointer { size, .. } => size.map_or(1, |s| s as usize),
            TypeInner::CooperativeMatrix { .. }
            | TypeInner::Image { .. }
            | TypeInner::Sampler { .. }
            | TypeInner::AccelerationStructure { .. }
            | TypeInner::RayQuery { .. }
            | TypeInner::BindingArray { .. } => 0,
        };
        (n <= MOST_UNIFORMS).then_some(n)
    }

    /// Scalars of a type that is known to be within the limits; 0 of others.
    pub(super) fn size(&self, inner: &TypeInner) -> usize {
        self.scalars(inner).unwrap_or(0)
    }

    pub(super) fn size_of(&self, ty: Handle<Type>) -> usize {
        self.size(&self.module.types[ty].inner)
    }

    /// Scalars of a value or variable, which must lie in registers.
    pub(super) fn register_size(&self, ty: Handle<Type>, span: Span) -> Result<usize, Refused> {
        match self.scalars(&self.module.types[ty].inner) {
            Some(n) if n <= MOST_SCALARS => Ok(n),
            _ => Err(Refused::new(
                format!("this is too large: a variable has at most {MOST_SCALARS} scalars here"),
                span,
            )),
        }
    }

    /// Words of a uniform.
    pub(super) fn uniform_size(&self, ty: Handle<Type>, span: Span) -> Result<usize, Refused> {
        let all = self.scalars(&self.module.types[ty].inner);
        all.ok_or_else(|| {
            Refused::new(format!("this is too large: uniforms have at most {MOST_UNIFORMS} words"), span)
        })
    }

    /// Elements of an array; 0 where only the host knows.
    pub(super) fn count(&self, size: ArraySize) -> usize {
        match size {
            ArraySize::Constant(n) => n.get() as usize,
            ArraySize::Pending(_) | ArraySize::Dynamic => 0,
        }
    }

    pub(super) fn inner(&self, frame: &Frame<'_>, e: Handle<Expression>) -> TypeInner {
        frame.info[e].ty.inner_with(&self.module.types).clone()
    }

    /// The kind of the scalars of numbers; `Float` of structs.
    pub(super) fn kind(&self, inner: &TypeInner) -> ScalarKind {
        match *inner {
            TypeInner::Scalar(s)
            | TypeInner::Vector { scalar: s, .. }
            | TypeInner::Matrix { scalar: s, .. }
            | TypeInner::Atomic(s)
            | TypeInner::ValuePointer { scalar: s, .. } => s.kind,
            TypeInner::Pointer { base, .. } | TypeInner::Array { base, .. } => {
                self.kind(&self.module.types[base].inner)
            }
            _ => ScalarKind::Float,
        }
    }

    /// The type as the interface and the trace tell it. Structs and arrays are as many columns of one row.
    pub(super) fn value_type(&self, inner: &TypeInner) -> ValueType {
        let scalar = match self.kind(inner) {
            ScalarKind::Sint | ScalarKind::AbstractInt => Scalar::Int,
            ScalarKind::Uint => Scalar::Uint,
            ScalarKind::Bool => Scalar::Bool,
            ScalarKind::Float | ScalarKind::AbstractFloat => Scalar::Float,
        };
        let (columns, rows) = match *inner {
            TypeInner::Pointer { base, .. } => return self.value_type(&self.module.types[base].inner),
            TypeInner::Matrix { columns, rows, .. } => (columns as usize, rows as usize),
            TypeInner::Struct { .. } | TypeInner::Array { .. } => (self.size(inner), 1),
            _ => (1, self.size(inner)),
        };
        ValueType { scalar, columns, rows }
    }
}
