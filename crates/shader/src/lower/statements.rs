//! Statements, calls and the events of a trace.

use std::collections::HashMap;

use naga::valid::FunctionInfo;
use naga::{Block, Expression, Function, Handle, Span, Statement};

use super::flow::loops::Parts;
use super::flow::uses::count_uses;
use super::pool::read_by_index;
use super::{Choice, Event, EventKind, Frame, Item, Lowering, Refused, Reg, VirtualOp};
use crate::machine::Code;
use crate::{Scalar, ValueType};

/// Calls inside calls. There is no recursion in shaders, so this only bounds the stack.
const MOST_CALLS: usize = 64;

impl<'a> Lowering<'a> {
    pub(super) fn block(&mut self, frame: &mut Frame<'a>, block: &'a Block) -> Result<(), Refused> {
        for (statement, span) in block.span_iter() {
            if self.dead {
                break;
            }
            self.check_work(*span)?;
            self.statement(frame, statement, *span).map_err(|refused| match refused.span.is_defined() {
                true => refused,
                false => Refused { span: *span, ..refused },
            })?;
        }
        Ok(())
    }

    fn statement(
        &mut self,
        frame: &mut Frame<'a>,
        statement: &'a Statement,
        span: Span,
    ) -> Result<(), Refused> {
        match statement {
            Statement::Emit(range) => {
                for e in range.clone() {
                    self.emit(frame, e)?;
                }
            }
            Statement::Block(block) => self.block(frame, block)?,
            Statement::If { condition, accept, reject } => self.if_else(frame, *condition, accept, reject)?,
            Statement::Switch { selector, cases } => self.switch(frame, *selector, cases)?,
            Statement::Loop { body, continuing, break_if } => {
                self.repeat(frame, Parts { body, continuing, break_if: *break_if, span })?;
            }
            Statement::Break => self.leave_loop(false, span)?,
            Statement::Continue => self.leave_loop(true, span)?,
            Statement::Return { value } => self.give_back(frame, *value, span)?,
            Statement::Kill => {
                self.note_leave(span, "discard");
                self.leave(self.discarded);
            }
            Statement::Store { pointer, value } => self.assign(frame, *pointer, *value, span)?,
            Statement::Call { function, arguments, result } => {
                self.call_statement(frame, *function, arguments, *result, span)?;
            }
            // Between lanes that run in step there is nothing to wait for.
            Statement::ControlBarrier(_) | Statement::MemoryBarrier(_) => {}
            Statement::ImageStore { .. }
            | Statement::Atomic { .. }
            | Statement::ImageAtomic { .. }
            | Statement::WorkGroupUniformLoad { .. }
            | Statement::SubgroupBallot { .. }
            | Statement::SubgroupGather { .. }
            | Statement::SubgroupCollectiveOperation { .. }
            | Statement::RayQuery { .. }
            | Statement::RayPipelineFunction(_)
            | Statement::CooperativeStore { .. } => return Err(Refused::new(absent(statement), span)),
        }
        Ok(())
    }

    /// Evaluates an expression where the IR says so.
    fn emit(&mut self, frame: &mut Frame<'a>, e: Handle<Expression>) -> Result<(), Refused> {
        let item = self.expression(frame, e)?;
        if self.trace
            && let Item::Value(regs) = &item
            && let Some(name) = frame.function.named_expressions.get(&e)
        {
            self.note_value(frame, EventKind::Value, name, e, regs);
        }
        frame.items.insert(e, item);
        Ok(())
    }

    fn give_back(
        &mut self,
        frame: &mut Frame<'a>,
        value: Option<Handle<Expression>>,
        span: Span,
    ) -> Result<(), Refused> {
        if let (Some(e), Some(result)) = (value, frame.result) {
            let value = self.value(frame, e)?;
            self.note_at(frame, EventKind::Value, "return", e, &value, span);
            self.store(result, 0, &value, self.mask);
        }
        self.note_leave(span, "return");
        self.leave(frame.returned);
        Ok(())
    }

    fn assign(
        &mut self,
        frame: &mut Frame<'a>,
        pointer: Handle<Expression>,
        value: Handle<Expression>,
        span: Span,
    ) -> Result<(), Refused> {
        let regs = self.value(frame, value)?;
        let Item::Place { var, offset, dynamic } = self.item(frame, pointer)? else {
            return Err(Refused::new("this cannot be assigned to", span));
        };
        if let Some(reason) = self.state.variables[var].constant {
            let name = &self.state.variables[var].name;
            return Err(Refused::new(format!("'{name}' is {reason} and cannot be assigned to"), span));
        }
        match dynamic {
            None => self.store(var, offset, &regs, self.mask),
            Some(Choice { index, offsets }) => {
                for (i, at) in offsets.into_iter().enumerate() {
                    let i = self.word(i as u32);
                    let here = self.op(Code::IEq, 1, &[&[index], &[i]])[0];
                    let mask = self.and(self.mask, here);
                    self.store(var, offset + at, &regs, Some(mask));
                }
            }
        }
        let name = self.state.variables[var].name.clone();
        if !name.is_empty() {
            self.note_at(frame, EventKind::Value, &name, value, &regs, span);
        }
        Ok(())
    }

    fn call_statement(
        &mut self,
        frame: &mut Frame<'a>,
        function: Handle<Function>,
        arguments: &[Handle<Expression>],
        result: Option<Handle<Expression>>,
        span: Span,
    ) -> Result<(), Refused> {
        let arguments = arguments.iter().map(|a| self.item(frame, *a)).collect::<Result<Vec<_>, _>>()?;
        let module = self.module;
        let (called, info) = (&module.functions[function], &self.info[function]);
        if self.depth >= MOST_CALLS {
            return Err(Refused::new(format!("more than {MOST_CALLS} calls inside each other"), span));
        }
        let value = match self.gather_call(called, &arguments, span)? {
            Some(texels) => Some(texels),
            None => {
                self.depth += 1;
                let value = self.inline(called, info, arguments)?;
                self.depth -= 1;
                value
            }
        };
        if let (Some(result), Some(value)) = (result, value) {
            frame.items.insert(result, Item::Value(value));
        }
        if self.discarding.contains(&function) {
            self.mask = self.without(self.mask, &[self.discarded]);
        }
        Ok(())
    }

    /// Lowers a function's body here; the registers of its result.
    pub(super) fn inline(
        &mut self,
        function: &'a Function,
        info: &'a FunctionInfo,
        arguments: Vec<Item>,
    ) -> Result<Option<Vec<Reg>>, Refused> {
        let returned = self.no_lanes();
        let result = match &function.result {
            None => None,
            Some(result) => {
                let n = self.register_size(result.ty, Span::UNDEFINED)?;
                let zeros = self.zeros(n);
                let var = self.variable("", zeros);
                self.state.variables[var].private = self.mask;
                Some(var)
            }
        };
        let mut frame = Frame {
            function,
            info,
            items: HashMap::new(),
            locals: HashMap::new(),
            pooled: HashMap::new(),
            uses: HashMap::new(),
            arguments,
            result,
            returned,
        };
        count_uses(function, &function.body, &mut frame.uses);
        self.locals(&mut frame)?;
        let outer = self.mask;
        let enclosing = std::mem::take(&mut self.enclosing);
        self.block(&mut frame, &function.body)?;
        self.enclosing = enclosing;
        self.dead = false;
        self.mask = outer;
        Ok(result.map(|r| self.load(r, 0, self.state.variables[r].registers.len())))
    }

    fn locals(&mut self, frame: &mut Frame<'a>) -> Result<(), Refused> {
        let function = frame.function;
        let read_by_index = read_by_index(function);
        for (handle, local) in function.local_variables.iter() {
            if read_by_index.contains(&handle)
                && let Some(item) = self.pooled_local(frame, handle)?
            {
                frame.pooled.insert(handle, item);
                continue;
            }
            let span = function.local_variables.get_span(handle);
            let n = self.register_size(local.ty, span)?;
            let regs = match local.init {
                Some(init) => self.value(frame, init)?,
                None => self.zeros(n),
            };
            let name = local.name.as_deref().unwrap_or("");
            if self.trace && local.init.is_some() && !name.is_empty() {
                let ty = self.value_type(&self.module.types[local.ty].inner);
                self.note(Event {
                    kind: EventKind::Value,
                    span,
                    name: name.to_owned(),
                    ty,
                    registers: regs.clone(),
                    mask: self.mask,
                });
            }
            let var = self.variable(name, regs);
            self.state.variables[var].private = self.mask;
            frame.locals.insert(handle, var);
        }
        Ok(())
    }

    /// Adds an event where the program is traced. What the front end made up has no place in the source and is left out.
    fn note(&mut self, event: Event<Reg>) {
        if self.trace && event.span.is_defined() {
            self.state.ops.push(VirtualOp::plain(Code::Note, self.state.events.len() as u32));
            self.state.events.push(event);
        }
    }

    pub(super) fn note_branch(&mut self, span: Span, condition: Reg) {
        let ty = ValueType { scalar: Scalar::Bool, columns: 1, rows: 1 };
        let registers = vec![condition];
        self.note(Event { kind: EventKind::Branch, span, name: "if".into(), ty, registers, mask: self.mask });
    }

    pub(super) fn note_leave(&mut self, span: Span, name: &str) {
        let ty = ValueType { scalar: Scalar::Bool, columns: 1, rows: 0 };
        let name = name.to_owned();
        self.note(Event { kind: EventKind::Leave, span, name, ty, registers: vec![], mask: self.mask });
    }

    pub(super) fn note_value(
        &mut self,
        frame: &Frame<'_>,
        kind: EventKind,
        name: &str,
        e: Handle<Expression>,
        regs: &[Reg],
    ) {
        self.note_at(frame, kind, name, e, regs, frame.function.expressions.get_span(e));
    }

    fn note_at(
        &mut self,
        frame: &Frame<'_>,
        kind: EventKind,
        name: &str,
        e: Handle<Expression>,
        regs: &[Reg],
        span: Span,
    ) {
        if self.trace {
            let ty = self.value_type(&self.inner(frame, e));
            let (name, registers) = (name.to_owned(), regs.to_vec());
            self.note(Event { kind, span, name, ty, registers, mask: self.mask });
        }
    }
}

/// What a statement that is refused asks for.
fn absent(statement: &Statement) -> &'static str {
    match statement {
        Statement::ImageStore { .. } => "images cannot be written here",
        Statement::Atomic { .. } | Statement::ImageAtomic { .. } => {
            "atomic operations belong to compute shaders, which are not read here"
        }
        Statement::RayQuery { .. } | Statement::RayPipelineFunction(_) => "ray queries are not there",
        Statement::CooperativeStore { .. } => "cooperative matrices are not there",
        _ => "workgroups and subgroups are not there",
    }
}
