//! Masks, branches and leaving.

pub(super) mod loops;
pub(super) mod unroll;
pub(super) mod uses;

use std::collections::{BTreeSet, HashMap};

use naga::{Block, Expression, Handle, Span, SwitchCase, SwitchValue};

use super::{Enclosing, EventKind, Frame, Lowering, Refused, Reg};
use crate::machine::Code;
use uses::count_uses;

/// Branches of so many expressions are worth a jump where no lane takes them.
const WORTH_A_JUMP: usize = 12;

impl<'a> Lowering<'a> {
    pub(super) fn and(&mut self, mask: Option<Reg>, c: Reg) -> Reg {
        match mask {
            None => c,
            Some(m) => self.op(Code::And, 1, &[&[m], &[c]])[0],
        }
    }

    pub(super) fn and_not(&mut self, mask: Option<Reg>, c: Reg) -> Reg {
        match mask {
            None => self.op(Code::Not, 1, &[&[c]])[0],
            Some(m) => self.op(Code::AndNot, 1, &[&[m], &[c]])[0],
        }
    }

    fn or(&mut self, a: Option<Reg>, b: Reg) -> Reg {
        match a {
            None => b,
            Some(a) => self.op(Code::Or, 1, &[&[a], &[b]])[0],
        }
    }

    /// Lanes that leave: they join `var`, and what follows in this block is dead.
    pub(super) fn leave(&mut self, var: usize) {
        let all = self.word(u32::MAX);
        let mask = self.mask.unwrap_or(all);
        let old = self.load(var, 0, 1);
        let new = self.op(Code::Or, 1, &[&old, &[mask]]);
        self.store(var, 0, &new, None);
        self.dead = true;
    }

    /// The lanes of `mask` that have not left.
    pub(super) fn without(&mut self, mask: Option<Reg>, left: &[usize]) -> Option<Reg> {
        let mut mask = mask;
        for &var in left {
            let gone = self.load(var, 0, 1);
            mask = Some(self.and_not(mask, gone[0]));
        }
        mask
    }

    /// The masks of leaving that a block may change.
    fn leavers(&self, frame: &Frame<'_>, block: &Block, out: &mut BTreeSet<usize>) {
        let mut changed = BTreeSet::new();
        self.changed(frame, block, &mut changed);
        let mut masks = vec![frame.returned, self.discarded];
        masks.extend(self.enclosing.last().iter().flat_map(|l| [l.broken, l.continued]));
        out.extend(masks.into_iter().filter(|m| changed.contains(m)));
    }

    /// One branch of control flow, jumped over where no lane takes it if that is worth it.
    fn branch(&mut self, frame: &mut Frame<'a>, block: &'a Block, mask: Reg) -> Result<(), Refused> {
        if block.is_empty() {
            return Ok(());
        }
        let outer = self.mask.replace(mask);
        let mut inside = HashMap::new();
        count_uses(frame.function, block, &mut inside);
        let own: BTreeSet<usize> = inside
            .iter()
            .filter(|(local, n)| frame.uses.get(local) == Some(n))
            .filter_map(|(local, _)| frame.locals.get(local).copied())
            .collect();
        let before: Vec<_> =
            own.iter().map(|v| (*v, self.state.variables[*v].private.replace(mask))).collect();
        if self.cost(block) > WORTH_A_JUMP {
            let mut vars = BTreeSet::new();
            self.changed(frame, block, &mut vars);
            vars.retain(|v| !own.contains(v));
            self.settle(&vars, false);
            let jump = self.jump(Code::JumpNone, mask);
            self.block(frame, block)?;
            self.land(jump);
            self.unsettle(&vars);
        } else {
            self.block(frame, block)?;
        }
        for (var, private) in before {
            self.state.variables[var].private = private;
        }
        self.dead = false;
        self.mask = outer;
        Ok(())
    }

    pub(super) fn if_else(
        &mut self,
        frame: &mut Frame<'a>,
        condition: Handle<Expression>,
        accept: &'a Block,
        reject: &'a Block,
    ) -> Result<(), Refused> {
        let c = self.value(frame, condition)?[0];
        self.note_branch(frame.function.expressions.get_span(condition), c);
        if let Some(known) = self.constant_word(c) {
            return self.block(frame, if known == 0 { reject } else { accept });
        }
        if self.mask.is_none() && self.state.even[c as usize] && self.stays(frame, accept, reject) {
            return self.even_if(frame, c, accept, reject);
        }
        let mut left = BTreeSet::new();
        self.leavers(frame, accept, &mut left);
        self.leavers(frame, reject, &mut left);
        let outer = self.mask;
        let reject_mask = (!reject.is_empty()).then(|| self.and_not(outer, c));
        let accept_mask = self.and(outer, c);
        self.branch(frame, accept, accept_mask)?;
        if let Some(mask) = reject_mask {
            self.branch(frame, reject, mask)?;
        }
        let left: Vec<usize> = left.into_iter().collect();
        self.mask = self.without(outer, &left);
        Ok(())
    }

    /// Whether no lane returns or is discarded in the blocks.
    fn stays(&self, frame: &Frame<'_>, accept: &Block, reject: &Block) -> bool {
        let mut vars = BTreeSet::new();
        self.changed(frame, accept, &mut vars);
        self.changed(frame, reject, &mut vars);
        let in_switch = self.enclosing.last().is_some_and(|l| l.together.is_none());
        let leaves =
            self.enclosing.last().is_some_and(|l| vars.contains(&l.broken) || vars.contains(&l.continued));
        !(vars.contains(&frame.returned) || vars.contains(&self.discarded) || in_switch && leaves)
    }

    /// All lanes take the same branch: jumps, no masks.
    fn even_if(
        &mut self,
        frame: &mut Frame<'a>,
        c: Reg,
        accept: &'a Block,
        reject: &'a Block,
    ) -> Result<(), Refused> {
        let mut vars = BTreeSet::new();
        self.changed(frame, accept, &mut vars);
        self.changed(frame, reject, &mut vars);
        if let Some(l) = self.enclosing.last() {
            vars.retain(|v| *v != l.broken && *v != l.continued);
        }
        self.settle(&vars, false);
        let no = self.jump(Code::JumpNone, c);
        self.block(frame, accept)?;
        let accept_dead = std::mem::take(&mut self.dead);
        let end = (!reject.is_empty()).then(|| self.jump(Code::Jump, 0));
        self.land(no);
        self.block(frame, reject)?;
        self.dead = accept_dead && self.dead && !reject.is_empty();
        end.into_iter().for_each(|jump| self.land(jump));
        self.unsettle(&vars);
        self.mask = None;
        Ok(())
    }

    pub(super) fn switch(
        &mut self,
        frame: &mut Frame<'a>,
        selector: Handle<Expression>,
        cases: &'a [SwitchCase],
    ) -> Result<(), Refused> {
        let selected = self.value(frame, selector)?;
        self.note_value(frame, EventKind::Branch, "switch", selector, &selected);
        let broken = self.no_lanes();
        // `continue` inside belongs to the loop around.
        let continued = self.enclosing.last().map_or(broken, |l| l.continued);
        if self.enclosing.last().is_some_and(|l| l.together.is_some()) {
            self.apart |= cases.iter().any(|case| has_continue(&case.body));
        }
        let outer = self.mask;
        self.enclosing.push(Enclosing { broken, continued, together: None, exits: vec![] });
        let (matches, default) = self.matches(&selected, cases);
        let mut falls: Option<Reg> = None;
        for (case, m) in cases.iter().zip(matches) {
            let m = self.or(falls, m.unwrap_or(default));
            falls = case.fall_through.then_some(m);
            let m = self.and(outer, m);
            let left = self.without(Some(m), &[broken, continued, frame.returned, self.discarded]);
            self.branch(frame, &case.body, left.unwrap_or(m))?;
        }
        let mut vars = BTreeSet::new();
        cases.iter().for_each(|case| self.changed(frame, &case.body, &mut vars));
        self.enclosing.pop();
        let mut left = vec![frame.returned, self.discarded];
        left.extend(self.enclosing.last().map(|l| l.continued));
        left.retain(|v| vars.contains(v));
        self.mask = self.without(outer, &left);
        Ok(())
    }

    /// The lanes of each case, and those of the default: all that match no other.
    fn matches(&mut self, selected: &[Reg], cases: &[SwitchCase]) -> (Vec<Option<Reg>>, Reg) {
        let mut hit = None;
        let mut matches = Vec::new();
        for case in cases {
            let value = match case.value {
                SwitchValue::Default => None,
                SwitchValue::I32(v) => Some(self.word(v as u32)),
                SwitchValue::U32(v) => Some(self.word(v)),
            };
            let m = value.map(|v| self.op(Code::IEq, 1, &[selected, &[v]])[0]);
            if let Some(m) = m {
                hit = Some(self.or(hit, m));
            }
            matches.push(m);
        }
        let all = self.word(u32::MAX);
        let default = hit.map_or(all, |h| self.op(Code::Not, 1, &[&[h]])[0]);
        (matches, default)
    }

    pub(super) fn leave_loop(&mut self, continues: bool, span: Span) -> Result<(), Refused> {
        let name = if continues { "continue" } else { "break" };
        self.note_leave(span, name);
        let masked = self.mask.is_some();
        let Some(innermost) = self.enclosing.last() else {
            return Err(Refused::new("there is no loop around", span));
        };
        let var = if continues { innermost.continued } else { innermost.broken };
        if innermost.together.is_none() {
            self.leave(var);
            return Ok(());
        }
        self.apart |= masked;
        let exits = self.enclosing.last().map(|l| l.exits.clone()).unwrap_or_default();
        self.leave_by(&exits);
        let jump = self.jump(Code::Jump, 0);
        if let Some((breaks, nexts)) = self.enclosing.last_mut().and_then(|l| l.together.as_mut()) {
            if continues { nexts.push(jump) } else { breaks.push(jump) }
        }
        self.dead = true;
        Ok(())
    }
}

/// Whether a `continue` of the loop around stands in a block.
fn has_continue(block: &Block) -> bool {
    block.iter().any(|statement| match statement {
        naga::Statement::Continue => true,
        naga::Statement::Loop { .. } => false,
        other => {
            let mut any = false;
            uses::inner_blocks(other, &mut |b| any |= has_continue(b));
            any
        }
    })
}
