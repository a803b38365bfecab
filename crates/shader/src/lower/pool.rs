//! Constant arrays with dynamic indices lie behind the uniforms, in their memory: registers would not suffice for long ones.

use std::collections::{HashMap, HashSet};

use naga::{Block, Expression, Function, Handle, LocalVariable, Span, Statement, Type, TypeInner};

use super::flow::uses::{inner_blocks, local_of};
use super::{Frame, Item, Lowering, Refused, Reg};
use crate::machine::Code;

/// Arrays of so few scalars are chosen from in registers, which is faster.
const FEW_SCALARS: usize = 32;

/// The locals that some dynamic index goes into and that nothing is stored to.
pub(super) fn read_by_index(function: &Function) -> HashSet<Handle<LocalVariable>> {
    let dynamic = function.expressions.iter().filter_map(|(_, expression)| match expression {
        Expression::Access { base, .. } => local_of(function, *base),
        _ => None,
    });
    let mut all: HashSet<_> = dynamic.collect();
    if !all.is_empty() {
        let mut written = HashSet::new();
        collect_written(function, &function.body, &mut written);
        all.retain(|local| !written.contains(local));
    }
    all
}

fn collect_written(function: &Function, block: &Block, out: &mut HashSet<Handle<LocalVariable>>) {
    for statement in block.iter() {
        match statement {
            Statement::Store { pointer, .. } => out.extend(local_of(function, *pointer)),
            Statement::Call { arguments, .. } => {
                out.extend(arguments.iter().filter_map(|a| local_of(function, *a)));
            }
            other => inner_blocks(other, &mut |b| collect_written(function, b, out)),
        }
    }
}

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
        if !self.is_long_array(ty, span)? {
            return Ok(None);
        }
        let registers = self.constant(self.module.constants[constant].init)?;
        self.constant_words(&registers, span)
    }

    /// Where a local lies that is a long constant array, and never stored to.
    pub(super) fn pooled_local(
        &mut self,
        frame: &mut Frame<'a>,
        local: Handle<LocalVariable>,
    ) -> Result<Option<Item>, Refused> {
        let function = frame.function;
        let span = function.local_variables.get_span(local);
        let LocalVariable { ty, init: Some(init), .. } = function.local_variables[local] else {
            return Ok(None);
        };
        if !self.is_long_array(ty, span)? {
            return Ok(None);
        }
        let registers = match function.expressions[init] {
            Expression::Constant(constant) => self.constant(self.module.constants[constant].init)?,
            _ => self.value(frame, init)?,
        };
        self.constant_words(&registers, span)
    }

    fn is_long_array(&self, ty: Handle<Type>, span: Span) -> Result<bool, Refused> {
        let is_array = matches!(self.module.types[ty].inner, TypeInner::Array { .. });
        Ok(is_array && self.uniform_size(ty, span)? > FEW_SCALARS)
    }

    /// The place of the words that the registers hold, if all are constants. Equal ones are there once.
    fn constant_words(&mut self, registers: &[Reg], span: Span) -> Result<Option<Item>, Refused> {
        let known = self.state.prologue.iter().filter(|op| op.code == Code::Imm);
        let known: HashMap<Reg, u32> = known.map(|op| (op.d, op.imm)).collect();
        let words: Option<Vec<u32>> = registers.iter().map(|register| known.get(register).copied()).collect();
        let Some(words) = words else { return Ok(None) };
        if let Some(word) = self.pool.get(&words) {
            return Ok(Some(Item::Uniform { word: *word, dynamic: None }));
        }
        let word = self.layout.defaults.len();
        self.layout.defaults.extend(&words);
        self.check_uniforms(span)?;
        self.pool.insert(words, word);
        Ok(Some(Item::Uniform { word, dynamic: None }))
    }

    pub(super) fn is_pointer(&self, frame: &Frame<'_>, e: Handle<Expression>) -> bool {
        matches!(self.inner(frame, e), TypeInner::Pointer { .. } | TypeInner::ValuePointer { .. })
    }
}
