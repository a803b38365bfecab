//! Instructions whose results nobody reads.

use crate::lower::{Reg, State, VirtualOp};
use crate::machine::Code;

impl State {
    /// `kept`: registers that are read at the end.
    pub(super) fn remove_dead(&mut self, kept: &[Reg]) {
        let mut needed = vec![false; self.groups.len()];
        kept.iter().for_each(|r| needed[*r as usize] = true);
        let is_needed = |op: &VirtualOp, needed: &[bool]| {
            op.code.is_control() || (0..op.written()).any(|k| needed[(op.d + k) as usize])
        };
        // Loops carry values backwards, so until nothing is added.
        loop {
            let mut added = false;
            for op in self.prologue.iter().chain(&self.ops).rev() {
                if is_needed(op, &needed) {
                    for r in op.reads().chain(self.read_elsewhere(op)) {
                        added |= !std::mem::replace(&mut needed[r as usize], true);
                    }
                }
            }
            if !added {
                break;
            }
        }
        self.prologue.retain(|op| is_needed(op, &needed));
        let kept: Vec<bool> = self.ops.iter().map(|op| is_needed(op, &needed)).collect();
        self.keep(&kept);
    }

    /// Takes out the instructions that are not kept.
    pub(crate) fn keep(&mut self, kept: &[bool]) {
        let mut moved = vec![0u32; self.ops.len() + 1];
        for (i, kept) in kept.iter().enumerate() {
            moved[i + 1] = moved[i] + u32::from(*kept);
        }
        let mut each = kept.iter();
        self.ops.retain(|_| each.next().is_some_and(|kept| *kept));
        for op in &mut self.ops {
            if matches!(op.code, Code::Jump | Code::JumpAny | Code::JumpNone) {
                op.imm = moved[op.imm as usize];
            }
        }
        self.loops.retain(|(_, back)| kept[*back]);
        for (start, end) in &mut self.loops {
            (*start, *end) = (moved[*start] as usize, moved[*end] as usize);
        }
        self.counts.retain(|(at, _)| kept[*at]);
        for (at, _) in &mut self.counts {
            *at = moved[*at] as usize;
        }
    }
}
