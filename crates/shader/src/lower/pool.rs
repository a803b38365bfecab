//! Constant arrays with dynamic indices lie behind the uniforms, in their memory: registers would not suffice for long ones.

use naga::{Constant, Expression, Handle, Span, TypeInner};

use super::{Frame, Item, Lowering, Refused};

/// Arrays of so few scalars are chosen from in registers, which is faster.
const FEW_SCALARS: usize = 32;

impl<'a> Lowering<'a> {
    /// Where a constant array lies, if the expression is a long one.
    pub(super) fn pooled(
        &mut self,
        frame: &Frame<'a>,
        e: Handle<Expression>,
        span: Span,
    ) -> Result<Option<Item>, Refused> {
        let Expression::Constant(constant) = frame.function.expressions[e] else { return Ok(None) };
        let ty = self.module.constants[constant].ty;
        if !matches!(self.module.types[ty].inner, TypeInner::Array { .. }) || self.size_of(ty) <= FEW_SCALARS
        {
            return Ok(None);
        }
        let word = self.constant_words(constant, span)?;
        Ok(Some(Item::Uniform { word, dynamic: None }))
    }

    /// The first of the words of a constant, which are added where they are not there yet.
    fn constant_words(&mut self, constant: Handle<Constant>, span: Span) -> Result<usize, Refused> {
        if let Some(word) = self.pool.get(&constant) {
            return Ok(*word);
        }
        let registers = self.constant(self.module.constants[constant].init)?;
        let first = self.layout.defaults.len();
        for register in registers {
            let word = self.state.prologue.iter().find(|op| op.d == register).map_or(0, |op| op.imm);
            self.layout.defaults.push(word);
        }
        self.check_uniforms(span)?;
        self.pool.insert(constant, first);
        Ok(first)
    }

    pub(super) fn is_pointer(&self, frame: &Frame<'_>, e: Handle<Expression>) -> bool {
        matches!(self.inner(frame, e), TypeInner::Pointer { .. } | TypeInner::ValuePointer { .. })
    }
}
