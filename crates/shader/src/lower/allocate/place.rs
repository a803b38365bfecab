//! Linear scan over groups of registers.

use std::collections::BTreeMap;

use crate::lower::{Refused, Reg, State};
use crate::machine::ROWS;

/// First and last instruction at which a group must lie in the file.
type Life = BTreeMap<Reg, (usize, usize)>;

impl State {
    /// The place of each register, and how many places are used.
    pub(super) fn place(&self, given: &[Reg], kept: &[Reg]) -> Result<(Vec<u16>, usize), Refused> {
        let group = |r: Reg| self.groups[r as usize].0;
        let life = self.life(given, kept);
        // What the prologue computes stays for the whole draw.
        let prologue: std::collections::BTreeSet<Reg> = self.prologue.iter().map(|op| group(op.d)).collect();
        let mut order: Vec<(bool, usize, Reg, usize)> =
            life.iter().map(|(g, (from, to))| (!prologue.contains(g), *from, *g, *to)).collect();
        order.sort_unstable();
        let mut free_from = vec![0usize; ROWS];
        let mut places = vec![0u16; self.groups.len()];
        let mut high = 0;
        for (runs_each_time, from, g, to) in order {
            let n = self.groups[g as usize].1 as usize;
            let Some(at) = first_fit(&free_from, n, from) else {
                return Err(Refused::for_lack_of_registers());
            };
            free_from[at..at + n].fill(if runs_each_time { to + 1 } else { usize::MAX });
            high = high.max(at + n);
            (0..n).for_each(|k| places[g as usize + k] = (at + k) as u16);
        }
        Ok((places, high))
    }

    fn life(&self, given: &[Reg], kept: &[Reg]) -> Life {
        let mut life = Life::new();
        let mut touch = |r: Reg, at: usize| {
            let span = life.entry(self.groups[r as usize].0).or_insert((at, at));
            *span = (span.0.min(at), span.1.max(at));
        };
        let end = self.ops.len();
        given.iter().for_each(|r| touch(*r, 0));
        for op in &self.prologue {
            touch(op.d, 0);
            op.reads().chain(self.read_elsewhere(op)).for_each(|r| touch(r, 0));
        }
        for (i, op) in self.ops.iter().enumerate() {
            op.reads().chain(self.read_elsewhere(op)).for_each(|r| touch(r, i));
            if op.written() > 0 {
                touch(op.d, i);
            }
        }
        kept.iter().for_each(|r| touch(*r, end));
        // Inner loops come first, so that outer ones see what they stretched.
        for &(start, back) in &self.loops {
            for span in life.values_mut() {
                if span.0 < start && span.1 >= start && span.1 < back {
                    span.1 = back;
                }
            }
        }
        life
    }
}

/// The first place where `n` registers lie free from instruction `from` on.
fn first_fit(free_from: &[usize], n: usize, from: usize) -> Option<usize> {
    let mut run = 0;
    for (at, free) in free_from.iter().enumerate() {
        run = if *free <= from { run + 1 } else { 0 };
        if run == n {
            return Some(at + 1 - n);
        }
    }
    None
}
