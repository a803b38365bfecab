//! Expressions and statements of a new function.

use naga::{
    AddressSpace, ArraySize, BinaryOperator, Block, Expression, Function, FunctionArgument, GlobalVariable,
    Handle, Literal, Module, ResourceBinding, Scalar, ScalarKind, Span, Statement, Type, TypeInner,
    VectorSize,
};

use super::refused;
use crate::ShaderError;

type Value = Handle<Expression>;

/// Gives the next scalar, vector or matrix of a type.
pub(super) type Leaf<'a> = dyn FnMut(&mut Build, Handle<Type>) -> Result<Value, ShaderError> + 'a;

/// A function in the making, in its module.
pub(super) struct Build {
    pub(super) module: Module,
    pub(super) function: Function,
    body: Block,
}

impl Build {
    pub(super) fn new(module: Module) -> Self {
        Self { module, function: Function::default(), body: Block::new() }
    }

    /// The module, and the function with its body.
    pub(super) fn finish(mut self, result: Option<Value>) -> (Module, Function) {
        self.statement(Statement::Return { value: result });
        self.function.body = self.body;
        (self.module, self.function)
    }

    pub(super) fn ty(&mut self, inner: TypeInner) -> Handle<Type> {
        self.module.types.insert(Type { name: None, inner }, Span::UNDEFINED)
    }

    pub(super) fn statement(&mut self, statement: Statement) {
        self.body.push(statement, Span::UNDEFINED);
    }

    /// An expression that is there without being evaluated.
    fn given(&mut self, expression: Expression) -> Value {
        self.function.expressions.append(expression, Span::UNDEFINED)
    }

    /// An expression that is evaluated here.
    pub(super) fn value(&mut self, expression: Expression) -> Value {
        let value = self.given(expression);
        self.statement(Statement::Emit(naga::Range::new_from_bounds(value, value)));
        value
    }

    pub(super) fn global(&mut self, global: Handle<GlobalVariable>) -> Value {
        self.given(Expression::GlobalVariable(global))
    }

    pub(super) fn zero(&mut self, ty: Handle<Type>) -> Value {
        self.given(Expression::ZeroValue(ty))
    }

    pub(super) fn number(&mut self, number: f32) -> Value {
        self.given(Expression::Literal(Literal::F32(number)))
    }

    fn whole(&mut self, number: u32) -> Value {
        self.given(Expression::Literal(Literal::U32(number)))
    }

    pub(super) fn load(&mut self, pointer: Value) -> Value {
        self.value(Expression::Load { pointer })
    }

    pub(super) fn member(&mut self, base: Value, index: usize) -> Value {
        self.value(Expression::AccessIndex { base, index: index as u32 })
    }

    pub(super) fn compose(&mut self, ty: Handle<Type>, components: Vec<Value>) -> Value {
        self.value(Expression::Compose { ty, components })
    }

    pub(super) fn binary(&mut self, op: BinaryOperator, left: Value, right: Value) -> Value {
        self.value(Expression::Binary { op, left, right })
    }

    /// A new argument.
    pub(super) fn argument(&mut self, argument: FunctionArgument) -> Value {
        let number = self.function.arguments.len() as u32;
        self.function.arguments.push(argument);
        self.given(Expression::FunctionArgument(number))
    }

    /// Calls a function; gives its result if it has one.
    pub(super) fn call(&mut self, function: Handle<Function>, arguments: Vec<Value>) -> Option<Value> {
        let has_result = self.module.functions[function].result.is_some();
        let result = has_result.then(|| self.given(Expression::CallResult(function)));
        self.statement(Statement::Call { function, arguments, result });
        result
    }

    /// The block of words: rows of four in a group.
    pub(super) fn block(&mut self, group: u32, rows: u32) -> Value {
        let row = self.ty(TypeInner::Vector { size: VectorSize::Quad, scalar: Scalar::U32 });
        let size =
            ArraySize::Constant(core::num::NonZeroU32::new(rows).unwrap_or(core::num::NonZeroU32::MIN));
        let ty = self.ty(TypeInner::Array { base: row, size, stride: 16 });
        let global = GlobalVariable {
            name: Some("glanz_words".to_owned()),
            space: AddressSpace::Uniform,
            binding: Some(ResourceBinding { group, binding: 0 }),
            ty,
            init: None,
            memory_decorations: naga::MemoryDecorations::empty(),
        };
        let global = self.module.global_variables.append(global, Span::UNDEFINED);
        self.global(global)
    }

    /// A word of the block as a scalar.
    pub(super) fn word(&mut self, block: Value, word: usize, scalar: Scalar) -> Value {
        let row = self.member(block, word / 4);
        let place = self.member(row, word % 4);
        let bits = self.load(place);
        self.meant_by(bits, scalar.kind)
    }

    /// Bits of a word, or a vector of them, as what they mean; truth values are not 0.
    pub(super) fn meant_by(&mut self, bits: Value, kind: ScalarKind) -> Value {
        match kind {
            ScalarKind::Uint => bits,
            ScalarKind::Bool => {
                let zero = self.whole(0);
                self.binary(BinaryOperator::NotEqual, bits, zero)
            }
            kind => self.value(Expression::As { expr: bits, kind, convert: None }),
        }
    }

    /// A value of a type out of its scalars, vectors and matrices, which `leaf` gives in their order.
    pub(super) fn out_of(&mut self, ty: Handle<Type>, leaf: &mut Leaf<'_>) -> Result<Value, ShaderError> {
        let parts: Vec<Handle<Type>> = match &self.module.types[ty].inner {
            TypeInner::Struct { members, .. } => members.iter().map(|member| member.ty).collect(),
            TypeInner::Array { base, size, .. } => vec![*base; count(*size)?],
            _ => return leaf(self, ty),
        };
        let mut components = Vec::with_capacity(parts.len());
        for part in parts {
            components.push(self.out_of(part, leaf)?);
        }
        Ok(self.compose(ty, components))
    }

    /// The scalars, vectors and matrices of a value, with their types, in their order.
    pub(super) fn leaves(
        &mut self,
        value: Value,
        ty: Handle<Type>,
        out: &mut Vec<(Value, Handle<Type>)>,
    ) -> Result<(), ShaderError> {
        let parts: Vec<Handle<Type>> = match &self.module.types[ty].inner {
            TypeInner::Struct { members, .. } => members.iter().map(|member| member.ty).collect(),
            TypeInner::Array { base, size, .. } => vec![*base; count(*size)?],
            _ => {
                out.push((value, ty));
                return Ok(());
            }
        };
        for (number, part) in parts.into_iter().enumerate() {
            let value = self.member(value, number);
            self.leaves(value, part, out)?;
        }
        Ok(())
    }
}

fn count(size: ArraySize) -> Result<usize, ShaderError> {
    match size {
        ArraySize::Constant(count) => Ok(count.get() as usize),
        ArraySize::Pending(_) | ArraySize::Dynamic => {
            Err(refused("arrays whose length only the host knows are not there"))
        }
    }
}
