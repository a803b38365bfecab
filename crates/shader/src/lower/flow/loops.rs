//! Loops.

use std::collections::BTreeSet;

use naga::{Block, Expression, Handle, Span};

use crate::lower::{Enclosing, Frame, Lowering, Refused, VirtualOp};
use crate::machine::Code;

/// How often it is tried to lower a loop that all lanes leave together, each time with fewer variables that are believed
/// to be the same in all.
const TRIES: usize = 8;

/// The parts of a loop.
#[derive(Clone, Copy)]
pub(in crate::lower) struct Parts<'a> {
    pub(in crate::lower) body: &'a Block,
    pub(in crate::lower) continuing: &'a Block,
    pub(in crate::lower) break_if: Option<Handle<Expression>>,
    pub(in crate::lower) span: Span,
}

impl<'a> Lowering<'a> {
    pub(in crate::lower) fn repeat(
        &mut self,
        frame: &mut Frame<'a>,
        parts: Parts<'a>,
    ) -> Result<(), Refused> {
        if self.unrolled(frame, parts)? || self.together(frame, parts)? {
            return Ok(());
        }
        self.masked_loop(frame, parts)
    }

    fn count_turn(&mut self, span: Span) -> usize {
        let start = self.state.ops.len();
        self.state.ops.push(VirtualOp::plain(Code::Count, 0));
        self.state.counts.push((start, span));
        start
    }

    /// Lanes leave one by one: masks of those that live, have broken out and go on with the next turn.
    fn masked_loop(&mut self, frame: &mut Frame<'a>, parts: Parts<'a>) -> Result<(), Refused> {
        let (broken, continued) = (self.no_lanes(), self.no_lanes());
        self.enclosing.push(Enclosing { broken, continued, together: None, exits: vec![] });
        let outer = self.mask;
        let all = self.word(u32::MAX);
        let live = self.variable("", vec![outer.unwrap_or(all)]);
        let mut vars = BTreeSet::from([broken, continued, live]);
        self.changed(frame, parts.body, &mut vars);
        self.changed(frame, parts.continuing, &mut vars);
        self.settle(&vars, false);
        let start = self.count_turn(parts.span);
        let zero = self.zeros(1);
        self.store(continued, 0, &zero, None);
        self.mask = Some(self.load(live, 0, 1)[0]);
        let before = self.mask;
        self.block(frame, parts.body)?;
        self.dead = false;
        let mut gone = vec![broken, frame.returned, self.discarded];
        gone.retain(|v| vars.contains(v));
        self.mask = self.without(before, &gone);
        self.block(frame, parts.continuing)?;
        self.dead = false;
        if let Some(c) = parts.break_if {
            let c = self.value(frame, c)?[0];
            self.mask = Some(self.and_not(self.mask, c));
        }
        let mask = self.mask.unwrap_or(all);
        self.store(live, 0, &[mask], None);
        let back = self.jump(Code::JumpAny, mask);
        self.state.ops[back].imm = start as u32;
        self.state.loops.push((start, back));
        self.unsettle(&vars);
        self.enclosing.pop();
        gone.retain(|v| *v != broken);
        self.mask = self.without(outer, &gone);
        Ok(())
    }

    /// A loop that all lanes run and leave together, without masks; `false` where they do not.
    pub(in crate::lower) fn together(
        &mut self,
        frame: &mut Frame<'a>,
        parts: Parts<'a>,
    ) -> Result<bool, Refused> {
        let mut vars = BTreeSet::new();
        self.changed(frame, parts.body, &mut vars);
        self.changed(frame, parts.continuing, &mut vars);
        if self.mask.is_some() || vars.contains(&frame.returned) || vars.contains(&self.discarded) {
            return Ok(false);
        }
        if let Some(l) = self.enclosing.last() {
            vars.retain(|v| *v != l.broken && *v != l.continued);
        }
        let outer_found = std::mem::take(&mut self.found);
        let outer_apart = std::mem::take(&mut self.apart);
        let outer_uneven = self.uneven.clone();
        let before = (self.state.clone(), frame.items.clone());
        for _ in 0..TRIES {
            (self.apart, self.dead) = (false, false);
            self.try_together(frame, parts, &vars)?;
            if !self.apart && self.found.is_empty() {
                (self.found, self.apart) = (outer_found, outer_apart);
                return Ok(true);
            }
            self.uneven.append(&mut self.found);
            (self.state, frame.items) = before.clone();
            self.mask = None;
            if self.apart {
                break;
            }
        }
        (self.apart, self.found, self.uneven) = (outer_apart, outer_found, outer_uneven);
        self.dead = false;
        Ok(false)
    }

    fn try_together(
        &mut self,
        frame: &mut Frame<'a>,
        parts: Parts<'a>,
        vars: &BTreeSet<usize>,
    ) -> Result<(), Refused> {
        self.check_work(parts.span)?;
        self.settle(vars, true);
        let unused = self.no_lanes();
        self.enclosing.push(Enclosing {
            broken: unused,
            continued: unused,
            together: Some((vec![], vec![])),
            exits: vec![],
        });
        let start = self.count_turn(parts.span);
        self.block(frame, parts.body)?;
        self.dead = false;
        // A mask that is left here means that some lanes have gone another way.
        self.apart |= self.mask.is_some();
        self.mask = None;
        let nexts =
            self.enclosing.last_mut().and_then(|l| l.together.as_mut()).map(|t| std::mem::take(&mut t.1));
        nexts.into_iter().flatten().for_each(|jump| self.land(jump));
        self.block(frame, parts.continuing)?;
        self.dead = false;
        self.apart |= self.mask.is_some();
        let back = match parts.break_if {
            None => self.jump(Code::Jump, 0),
            Some(c) => {
                let c = self.value(frame, c)?[0];
                self.apart |= !self.state.even[c as usize];
                self.jump(Code::JumpNone, c)
            }
        };
        self.state.ops[back].imm = start as u32;
        self.state.loops.push((start, back));
        let (breaks, _) = self.enclosing.pop().and_then(|l| l.together).unwrap_or_default();
        breaks.into_iter().for_each(|jump| self.land(jump));
        self.unsettle(vars);
        Ok(())
    }
}
