//! What blocks of statements name, change and cost.

use std::collections::{BTreeSet, HashMap};

use naga::{Block, Expression, Function, Handle, LocalVariable, Statement};

use crate::lower::{Frame, Item, Lowering};

/// Calls `f` for the blocks inside a statement.
pub(crate) fn inner_blocks<'a>(statement: &'a Statement, f: &mut dyn FnMut(&'a Block)) {
    match statement {
        Statement::Block(block) => f(block),
        Statement::If { accept, reject, .. } => {
            f(accept);
            f(reject);
        }
        Statement::Switch { cases, .. } => cases.iter().for_each(|case| f(&case.body)),
        Statement::Loop { body, continuing, .. } => {
            f(body);
            f(continuing);
        }
        _ => {}
    }
}

/// How often a block names each local, calls and loads included.
pub(in crate::lower) fn count_uses(
    function: &Function,
    block: &Block,
    out: &mut HashMap<Handle<LocalVariable>, usize>,
) {
    let mut name = |e: Handle<Expression>| {
        if let Some(local) = local_of(function, e) {
            *out.entry(local).or_default() += 1;
        }
    };
    for statement in block.iter() {
        match statement {
            Statement::Emit(range) => {
                for e in range.clone() {
                    if let Expression::Load { pointer } = function.expressions[e] {
                        name(pointer);
                    }
                }
            }
            Statement::Store { pointer, .. } => name(*pointer),
            Statement::Call { arguments, .. } => arguments.iter().for_each(|a| name(*a)),
            _ => {}
        }
    }
    for statement in block.iter() {
        inner_blocks(statement, &mut |b| count_uses(function, b, out));
    }
}

/// The local that a pointer points into.
pub(in crate::lower) fn local_of(
    function: &Function,
    mut e: Handle<Expression>,
) -> Option<Handle<LocalVariable>> {
    loop {
        match function.expressions[e] {
            Expression::Access { base, .. } | Expression::AccessIndex { base, .. } => e = base,
            Expression::LocalVariable(local) => return Some(local),
            _ => return None,
        }
    }
}

impl Lowering<'_> {
    /// The variables that a block may change, masks of lanes that leave included.
    pub(in crate::lower) fn changed(&self, frame: &Frame<'_>, block: &Block, out: &mut BTreeSet<usize>) {
        for statement in block.iter() {
            match statement {
                Statement::Store { pointer, .. } => out.extend(self.root(frame, *pointer)),
                Statement::Call { function, arguments, .. } => {
                    out.extend(arguments.iter().filter_map(|a| self.root(frame, *a)));
                    self.changed_globals(*function, out);
                }
                Statement::Break => out.extend(self.enclosing.last().map(|l| l.broken)),
                Statement::Continue => out.extend(self.enclosing.last().map(|l| l.continued)),
                Statement::Return { .. } => {
                    out.insert(frame.returned);
                    out.extend(frame.result);
                }
                Statement::Kill => {
                    out.insert(self.discarded);
                }
                other => inner_blocks(other, &mut |b| self.changed(frame, b, out)),
            }
        }
    }

    /// The variable that a pointer points into.
    fn root(&self, frame: &Frame<'_>, e: Handle<Expression>) -> Option<usize> {
        let place = |item: Option<&Item>| match item {
            Some(Item::Place { var, .. }) => Some(*var),
            _ => None,
        };
        match frame.function.expressions[e] {
            Expression::Access { base, .. } | Expression::AccessIndex { base, .. } => self.root(frame, base),
            Expression::LocalVariable(local) => frame.locals.get(&local).copied(),
            Expression::GlobalVariable(global) => place(self.globals.get(&global)),
            Expression::FunctionArgument(i) => place(frame.arguments.get(i as usize)),
            _ => None,
        }
    }

    fn changed_globals(&self, function: Handle<Function>, out: &mut BTreeSet<usize>) {
        let info = &self.info[function];
        for (global, item) in &self.globals {
            if let Item::Place { var, .. } = item
                && info[*global].contains(naga::valid::GlobalUse::WRITE)
            {
                out.insert(*var);
            }
        }
        if self.discarding.contains(&function) {
            out.insert(self.discarded);
        }
    }

    /// Whether a block may discard, in what it calls, too.
    pub(in crate::lower) fn discards(&self, block: &Block) -> bool {
        block.iter().any(|statement| match statement {
            Statement::Kill => true,
            Statement::Call { function, .. } => self.discarding.contains(function),
            other => {
                let mut any = false;
                inner_blocks(other, &mut |b| any |= self.discards(b));
                any
            }
        })
    }

    /// About how many instructions a block becomes.
    pub(in crate::lower) fn cost(&self, block: &Block) -> usize {
        let of = |statement: &Statement| match statement {
            Statement::Emit(range) => range.clone().count(),
            Statement::Loop { .. } | Statement::Call { .. } => 100,
            other => {
                let mut sum = 1;
                inner_blocks(other, &mut |b| sum += 2 + self.cost(b));
                sum
            }
        };
        block.iter().map(of).sum()
    }
}
