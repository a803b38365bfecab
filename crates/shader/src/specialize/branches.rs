//! Jumps that are decided by what is known, and what they leave out.

use crate::lower::{State, VirtualOp};
use crate::machine::Code;

/// Takes out the branches that no lane takes, and the jumps that all take. Whether there were any.
pub(super) fn decide(state: &mut State, known: &[Option<u32>]) -> bool {
    let mut kept = vec![true; state.ops.len()];
    let mut decided = false;
    for (op, kept) in state.ops.iter_mut().zip(&mut kept) {
        let Some(is_taken) = taken(op, known) else { continue };
        decided = true;
        *op = VirtualOp { code: Code::Jump, a: 0, ..*op };
        *kept = is_taken;
    }
    if !decided {
        return false;
    }
    let reached = reached(&state.ops, &kept);
    for (kept, reached) in kept.iter_mut().zip(&reached) {
        *kept &= reached;
    }
    // A jump over nothing.
    for at in (0..kept.len()).rev() {
        let op = &state.ops[at];
        let over = || kept[at + 1..(op.imm as usize).max(at + 1)].iter().all(|kept| !kept);
        if kept[at] && op.code == Code::Jump && op.imm as usize > at && over() {
            kept[at] = false;
        }
    }
    state.keep(&kept);
    true
}

/// Whether a jump is taken, if that is known.
fn taken(op: &VirtualOp, known: &[Option<u32>]) -> Option<bool> {
    let any = |op: &VirtualOp| Some(known.get(op.a as usize).copied()?? >> 31 == 1);
    match op.code {
        Code::JumpNone => Some(!any(op)?),
        Code::JumpAny => any(op),
        _ => None,
    }
}

/// Which instructions may run; those that are not kept do nothing.
fn reached(ops: &[VirtualOp], kept: &[bool]) -> Vec<bool> {
    let mut reached = vec![false; ops.len()];
    let mut open = vec![0];
    while let Some(mut at) = open.pop() {
        while at < ops.len() && !reached[at] {
            reached[at] = true;
            let op = &ops[at];
            at = match op.code {
                Code::Jump if kept[at] => op.imm as usize,
                Code::JumpNone | Code::JumpAny => {
                    open.push(op.imm as usize);
                    at + 1
                }
                _ => at + 1,
            };
        }
    }
    reached
}
