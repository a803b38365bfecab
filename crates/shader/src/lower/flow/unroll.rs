//! Loops whose counter is known: turn after turn, so that what an index picks is known, too.
//!
//! A loop over lights, `for (int i = 0; i < nbrLights; i++)`, reads everything by `i`. Written out, these are uniforms at
//! known places, and what follows from them alone goes to the prologue. Whatever is left after [`TURNS`] is a loop as any
//! other.

use std::collections::BTreeSet;

use super::has_continue;
use super::loops::Parts;
use crate::lower::{Enclosing, Frame, Lowering, Refused, Reg};

/// How many turns are written out at most: the first number with which there are registers enough.
pub(in crate::lower) const TURNS: [usize; 3] = [12, 8, 4];

/// Most instructions of all turns together.
const MOST_OPS: usize = 4_000;

impl<'a> Lowering<'a> {
    /// Writes a loop out, if its counter is known and indexes something; `false` where it is to be a loop.
    pub(in crate::lower) fn unrolled(
        &mut self,
        frame: &mut Frame<'a>,
        parts: Parts<'a>,
    ) -> Result<bool, Refused> {
        let mut vars = BTreeSet::new();
        self.changed(frame, parts.body, &mut vars);
        self.changed(frame, parts.continuing, &mut vars);
        let leaves = vars.contains(&frame.returned) || vars.contains(&self.discarded);
        let goes_apart = self.mask.is_some() || leaves || has_continue(parts.body);
        if self.turns == 0 || self.trace || goes_apart || parts.break_if.is_some() {
            return Ok(false);
        }
        if let Some(l) = self.enclosing.last() {
            vars.retain(|v| *v != l.broken && *v != l.continued);
        }
        vars.retain(|v| self.state.variables[*v].homes == 0);
        if !vars.iter().any(|v| self.is_counter(*v)) {
            return Ok(false);
        }
        let outer = (self.state.clone(), frame.items.clone(), self.found.clone());
        let (outer_apart, outer_indexed) =
            (std::mem::take(&mut self.apart), std::mem::take(&mut self.indexed));
        let done = self.turns(frame, parts, &vars)? && !self.apart;
        self.apart = outer_apart;
        self.indexed |= outer_indexed;
        self.dead = false;
        if !done {
            (self.state, frame.items, self.found) = outer;
            self.mask = None;
        }
        Ok(done)
    }

    /// Whether the value of a variable is one known word.
    fn is_counter(&self, var: usize) -> bool {
        matches!(self.state.variables[var].registers[..], [r] if self.constant_word(r).is_some())
    }

    fn turns(
        &mut self,
        frame: &mut Frame<'a>,
        parts: Parts<'a>,
        vars: &BTreeSet<usize>,
    ) -> Result<bool, Refused> {
        // Where variables are after the loop, whichever turn it was left from.
        let exits: Vec<(usize, Vec<Reg>)> = vars
            .iter()
            .map(|v| {
                let d = self.fresh(self.state.variables[*v].registers.len());
                d.iter().for_each(|r| self.state.even[*r as usize] = true);
                (*v, d)
            })
            .collect();
        let unused = self.no_lanes();
        self.enclosing.push(Enclosing {
            broken: unused,
            continued: unused,
            together: Some((vec![], vec![])),
            exits: exits.clone(),
        });
        let done = self.turn_by_turn(frame, parts, vars);
        let (breaks, _) = self.enclosing.pop().and_then(|l| l.together).unwrap_or_default();
        if !done? {
            return Ok(false);
        }
        if !self.dead {
            self.leave_by(&exits);
        }
        breaks.into_iter().for_each(|jump| self.land(jump));
        for (var, registers) in exits {
            self.state.variables[var].registers = registers;
        }
        Ok(true)
    }

    fn turn_by_turn(
        &mut self,
        frame: &mut Frame<'a>,
        parts: Parts<'a>,
        vars: &BTreeSet<usize>,
    ) -> Result<bool, Refused> {
        let (items, first) = (frame.items.clone(), self.state.ops.len());
        for turn in 0..self.turns {
            self.check_work(parts.span)?;
            // What is cached is that of the turn before.
            frame.items = items.clone();
            self.block(frame, parts.body)?;
            if self.dead {
                // It is known that the loop ends here.
                return Ok(!self.apart && (turn > 0 || self.indexed));
            }
            self.apart |= self.mask.is_some();
            self.block(frame, parts.continuing)?;
            let counts = self.indexed && vars.iter().any(|v| self.is_counter(*v));
            if self.apart || self.mask.is_some() || self.dead || !counts {
                return Ok(false);
            }
            if self.state.ops.len() - first > MOST_OPS {
                break;
            }
        }
        frame.items = items;
        self.together(frame, parts)
    }

    /// Brings variables to where they are after the loop.
    pub(in crate::lower) fn leave_by(&mut self, exits: &[(usize, Vec<Reg>)]) {
        for (var, d) in exits {
            let value = self.state.variables[*var].registers.clone();
            self.write(d, &value, None);
            let even = self.is_even(&value);
            d.iter().for_each(|r| self.state.even[*r as usize] &= even);
        }
    }
}
