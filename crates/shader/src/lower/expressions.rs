//! Expressions.

use naga::{
    DerivativeAxis, Expression, Handle, Literal, RelationalFunction, ScalarKind, Span, UnaryOperator,
};

use super::{Choice, Frame, Item, Lowering, Refused, Reg};
use crate::machine::Code;

impl<'a> Lowering<'a> {
    pub(super) fn item(&mut self, frame: &mut Frame<'a>, e: Handle<Expression>) -> Result<Item, Refused> {
        if let Some(item) = frame.items.get(&e) {
            return Ok(item.clone());
        }
        let item = self.expression(frame, e)?;
        frame.items.insert(e, item.clone());
        Ok(item)
    }

    /// The registers of a value; at least one.
    pub(super) fn value(
        &mut self,
        frame: &mut Frame<'a>,
        e: Handle<Expression>,
    ) -> Result<Vec<Reg>, Refused> {
        match self.item(frame, e)? {
            Item::Value(regs) if !regs.is_empty() => Ok(regs),
            // A part of a constant array, which is read where it is needed.
            Item::Uniform { word, dynamic } if !self.is_pointer(frame, e) => {
                let n = self.size(&self.inner(frame, e));
                Ok(self.load_uniform(word, n, dynamic))
            }
            _ => Err(Refused::new("a value is needed here", frame.function.expressions.get_span(e))),
        }
    }

    fn values(&mut self, frame: &mut Frame<'a>, list: &[Handle<Expression>]) -> Result<Vec<Reg>, Refused> {
        let mut all = Vec::new();
        for e in list {
            all.extend(self.value(frame, *e)?);
        }
        Ok(all)
    }

    /// A constant expression of the module.
    pub(super) fn constant(&mut self, e: Handle<Expression>) -> Result<Vec<Reg>, Refused> {
        let arena = &self.module.global_expressions;
        let span = arena.get_span(e);
        match &arena[e] {
            Expression::Literal(literal) => Ok(vec![self.literal(*literal, span)?]),
            Expression::Constant(c) => self.constant(self.module.constants[*c].init),
            Expression::ZeroValue(ty) => {
                let n = self.register_size(*ty, span)?;
                Ok(self.zeros(n))
            }
            Expression::Compose { components, .. } => {
                let mut all = Vec::new();
                for c in components {
                    all.extend(self.constant(*c)?);
                }
                Ok(all)
            }
            Expression::Splat { size, value } => Ok(vec![self.constant(*value)?[0]; *size as usize]),
            Expression::Override(_) => {
                Err(Refused::new("constants that are set from outside are not there", span))
            }
            _ => Err(Refused::new("this is no constant", span)),
        }
    }

    fn literal(&mut self, literal: Literal, span: Span) -> Result<Reg, Refused> {
        let word = match literal {
            Literal::F32(x) => x.to_bits(),
            Literal::AbstractFloat(x) => (x as f32).to_bits(),
            Literal::U32(x) => x,
            Literal::I32(x) => x as u32,
            Literal::Bool(holds) => {
                if holds {
                    u32::MAX
                } else {
                    0
                }
            }
            Literal::AbstractInt(x) => x as u32,
            Literal::F64(_) => return Err(Refused::new("numbers in double precision are not there", span)),
            Literal::F16(_) | Literal::I16(_) | Literal::U16(_) | Literal::I64(_) | Literal::U64(_) => {
                return Err(Refused::new("numbers of 16 or 64 bits are not there", span));
            }
        };
        Ok(self.word(word))
    }

    pub(super) fn expression(
        &mut self,
        frame: &mut Frame<'a>,
        e: Handle<Expression>,
    ) -> Result<Item, Refused> {
        let span = frame.function.expressions.get_span(e);
        Ok(match &frame.function.expressions[e] {
            Expression::Literal(literal) => Item::Value(vec![self.literal(*literal, span)?]),
            Expression::Constant(c) => Item::Value(self.constant(self.module.constants[*c].init)?),
            Expression::ZeroValue(ty) => {
                let n = self.register_size(*ty, span)?;
                Item::Value(self.zeros(n))
            }
            Expression::Compose { ty, components } => {
                self.register_size(*ty, span)?;
                Item::Value(self.values(frame, components)?)
            }
            Expression::Splat { size, value } => {
                Item::Value(vec![self.value(frame, *value)?[0]; *size as usize])
            }
            Expression::Swizzle { size, vector, pattern } => {
                let v = self.value(frame, *vector)?;
                let picked = pattern[..*size as usize].iter().filter_map(|c| v.get(*c as usize).copied());
                Item::Value(picked.collect())
            }
            Expression::FunctionArgument(i) => {
                frame.arguments.get(*i as usize).cloned().unwrap_or(Item::Nothing)
            }
            Expression::LocalVariable(local) => match frame.pooled.get(local) {
                Some(item) => item.clone(),
                None => Item::Place { var: frame.locals[local], offset: 0, dynamic: None },
            },
            Expression::GlobalVariable(global) => self.globals.get(global).cloned().unwrap_or(Item::Nothing),
            Expression::AccessIndex { base, index } => {
                let (inner, item) = (self.inner(frame, *base), self.item(frame, *base)?);
                self.access(&item, &inner, *index as usize, None, span)?
            }
            Expression::Access { base, index } => {
                let i = self.value(frame, *index)?[0];
                let inner = self.inner(frame, *base);
                let item = match self.pooled(frame, *base, span)? {
                    Some(item) => item,
                    None => self.item(frame, *base)?,
                };
                self.access(&item, &inner, 0, Some(i), span)?
            }
            Expression::Load { pointer } => Item::Value(self.load_from(frame, *pointer, span)?),
            Expression::Unary { .. }
            | Expression::Binary { .. }
            | Expression::Select { .. }
            | Expression::Derivative { .. }
            | Expression::Relational { .. }
            | Expression::Math { .. }
            | Expression::As { .. } => Item::Value(self.operation(frame, e, span)?),
            Expression::ImageSample { .. } | Expression::ImageLoad { .. } | Expression::ImageQuery { .. } => {
                self.texture(frame, e, span)?
            }
            Expression::CallResult(_) => Item::Nothing,
            Expression::Override(_)
            | Expression::ArrayLength(_)
            | Expression::AtomicResult { .. }
            | Expression::WorkGroupUniformLoadResult { .. }
            | Expression::SubgroupBallotResult
            | Expression::SubgroupOperationResult { .. }
            | Expression::RayQueryVertexPositions { .. }
            | Expression::RayQueryProceedResult
            | Expression::RayQueryGetIntersection { .. }
            | Expression::CooperativeLoad { .. }
            | Expression::CooperativeMultiplyAdd { .. } => {
                return Err(Refused::new(absent(&frame.function.expressions[e]), span));
            }
        })
    }

    /// Operators and functions of values.
    fn operation(
        &mut self,
        frame: &mut Frame<'a>,
        e: Handle<Expression>,
        span: Span,
    ) -> Result<Vec<Reg>, Refused> {
        Ok(match &frame.function.expressions[e] {
            Expression::Unary { op, expr } => {
                let (x, kind) = (self.value(frame, *expr)?, self.kind(&self.inner(frame, *expr)));
                let code = match (op, kind) {
                    (UnaryOperator::Negate, ScalarKind::Float) => Code::FNeg,
                    (UnaryOperator::Negate, _) => Code::INeg,
                    (UnaryOperator::LogicalNot | UnaryOperator::BitwiseNot, _) => Code::Not,
                };
                self.op(code, x.len(), &[&x])
            }
            Expression::Binary { op, left, right } => {
                let (l, r) = (self.inner(frame, *left), self.inner(frame, *right));
                let (a, b) = (self.value(frame, *left)?, self.value(frame, *right)?);
                self.binary(*op, &l, &r, &a, &b)
            }
            Expression::Select { condition, accept, reject } => {
                let c = self.value(frame, *condition)?;
                let (a, b) = (self.value(frame, *accept)?, self.value(frame, *reject)?);
                self.op(Code::Sel, a.len(), &[&a, &b, &c])
            }
            Expression::Derivative { axis, expr, .. } => {
                let x = self.value(frame, *expr)?;
                self.derivative(*axis, &x)
            }
            Expression::Relational { fun, argument } => {
                let x = self.value(frame, *argument)?;
                self.relational(*fun, &x)
            }
            Expression::Math { fun, arg, arg1, arg2, arg3 } => {
                let inner = self.inner(frame, *arg);
                let mut args = [self.value(frame, *arg)?, vec![], vec![], vec![]];
                for (slot, e) in args[1..].iter_mut().zip([arg1, arg2, arg3]) {
                    if let Some(e) = e {
                        *slot = self.value(frame, *e)?;
                    }
                }
                let [a, b, c, d] = &args;
                self.math(*fun, &inner, [a, b, c, d], span)?
            }
            Expression::As { expr, kind, convert } => {
                let from = self.kind(&self.inner(frame, *expr));
                let x = self.value(frame, *expr)?;
                if convert.is_some_and(|width| width != 4 && width != 1) {
                    return Err(Refused::new("numbers of 16 or 64 bits are not there", span));
                }
                if convert.is_none() { x } else { self.convert(from, *kind, x) }
            }
            _ => return Err(Refused::new("this is no operation", span)),
        })
    }

    fn load_from(
        &mut self,
        frame: &mut Frame<'a>,
        pointer: Handle<Expression>,
        span: Span,
    ) -> Result<Vec<Reg>, Refused> {
        let inner = self.inner(frame, pointer);
        let n = self.size(&inner);
        match self.item(frame, pointer)? {
            Item::Place { var, offset, dynamic: None } => Ok(self.load(var, offset, n)),
            Item::Place { var, offset, dynamic: Some(Choice { index, offsets }) } => {
                let parts: Vec<_> = offsets.iter().map(|at| self.load(var, offset + at, n)).collect();
                Ok(self.choose(index, &parts))
            }
            Item::Uniform { word, dynamic } => {
                if n > super::MOST_SCALARS {
                    return Err(Refused::new("this uniform is too large to be read as a whole", span));
                }
                Ok(self.load_uniform(word, n, dynamic))
            }
            Item::Value(_) | Item::Texture(_) | Item::Nothing => {
                Err(Refused::new("nothing can be read from here", span))
            }
        }
    }

    /// The part that the index numbers; the first where there is none.
    pub(super) fn choose(&mut self, index: Reg, parts: &[Vec<Reg>]) -> Vec<Reg> {
        let Some((first, others)) = parts.split_first() else { return Vec::new() };
        let mut chosen = first.clone();
        for (i, part) in others.iter().enumerate() {
            let i = self.word(i as u32 + 1);
            let here = self.op(Code::IEq, 1, &[&[index], &[i]]);
            chosen = self.op(Code::Sel, part.len(), &[part, &chosen, &here]);
        }
        chosen
    }

    fn derivative(&mut self, axis: DerivativeAxis, x: &[Reg]) -> Vec<Reg> {
        let n = x.len();
        match axis {
            DerivativeAxis::X => self.op(Code::DdX, n, &[x]),
            DerivativeAxis::Y => self.op(Code::DdY, n, &[x]),
            DerivativeAxis::Width => {
                let (dx, dy) = (self.op(Code::DdX, n, &[x]), self.op(Code::DdY, n, &[x]));
                let (dx, dy) = (self.op(Code::FAbs, n, &[&dx]), self.op(Code::FAbs, n, &[&dy]));
                self.op(Code::FAdd, n, &[&dx, &dy])
            }
        }
    }

    fn relational(&mut self, fun: RelationalFunction, x: &[Reg]) -> Vec<Reg> {
        let n = x.len();
        let code = match fun {
            RelationalFunction::All => Code::And,
            RelationalFunction::Any => Code::Or,
            RelationalFunction::IsNan => return self.op(Code::FNe, n, &[x, x]),
            RelationalFunction::IsInf => {
                let (size, infinity) = (self.op(Code::FAbs, n, &[x]), self.float(f32::INFINITY));
                return self.op(Code::FEq, n, &[&size, &infinity]);
            }
        };
        let mut all = x[0];
        for r in &x[1..] {
            all = self.op(code, 1, &[&[all], &[*r]])[0];
        }
        vec![all]
    }

    fn convert(&mut self, from: ScalarKind, to: ScalarKind, x: Vec<Reg>) -> Vec<Reg> {
        let (n, zero) = (x.len(), self.zeros(1));
        match (from, to) {
            (ScalarKind::Float, ScalarKind::Sint) => self.op(Code::FToI, n, &[&x]),
            (ScalarKind::Float, ScalarKind::Uint) => self.op(Code::FToU, n, &[&x]),
            (ScalarKind::Sint, ScalarKind::Float) => self.op(Code::IToF, n, &[&x]),
            (ScalarKind::Uint, ScalarKind::Float) => self.op(Code::UToF, n, &[&x]),
            (ScalarKind::Bool, ScalarKind::Float) => self.op(Code::BToF, n, &[&x]),
            (ScalarKind::Bool, ScalarKind::Sint | ScalarKind::Uint) => self.op(Code::BToI, n, &[&x]),
            (ScalarKind::Float, ScalarKind::Bool) => self.op(Code::FNe, n, &[&x, &zero]),
            (ScalarKind::Sint | ScalarKind::Uint, ScalarKind::Bool) => self.op(Code::INe, n, &[&x, &zero]),
            _ => x,
        }
    }
}

/// What an expression that is refused asks for.
fn absent(expression: &Expression) -> &'static str {
    match expression {
        Expression::Override(_) => "constants that are set from outside are not there",
        Expression::ArrayLength(_) => "arrays whose length only the host knows are not there",
        Expression::RayQueryVertexPositions { .. }
        | Expression::RayQueryProceedResult
        | Expression::RayQueryGetIntersection { .. } => "ray queries are not there",
        Expression::CooperativeLoad { .. } | Expression::CooperativeMultiplyAdd { .. } => {
            "cooperative matrices are not there"
        }
        _ => "atomic operations, workgroups and subgroups are not there",
    }
}
