//! Components that nobody reads.

use crate::lower::{Reg, State, VirtualOp};
use crate::machine::Code;

/// Whether component k of the result follows from component k of the operands alone.
pub(super) fn is_by_component(code: Code) -> bool {
    let whole = matches!(
        code,
        Code::Dot
            | Code::Length
            | Code::Normalize
            | Code::Cross
            | Code::Texture
            | Code::Imm
            | Code::LoadU
            | Code::LoadUI
    );
    !whole && !code.is_control()
}

/// Instructions by component compute no more of them than are read. `kept`: registers that are read at the end.
pub(super) fn narrow(state: &mut State, kept: &[Reg]) {
    let needed = needed(state, kept);
    for op in &mut state.ops {
        if !is_by_component(op.code) {
            continue;
        }
        let is_needed = |k: &Reg| needed[(op.d + k) as usize];
        let all = 0..Reg::from(op.n);
        let (Some(first), Some(last)) = (all.clone().find(is_needed), all.rev().find(is_needed)) else {
            continue;
        };
        let moved = |r: Reg, bit: u8| r + if op.s & bit != 0 { first } else { 0 };
        let (a, b, c) = (moved(op.a, 1), moved(op.b, 2), moved(op.c, 4));
        *op = VirtualOp { n: (last - first + 1) as u16, d: op.d + first, a, b, c, ..*op };
    }
}

/// Which registers are read, by those that are needed themselves.
fn needed(state: &State, kept: &[Reg]) -> Vec<bool> {
    let mut needed = vec![false; state.groups.len()];
    kept.iter().for_each(|r| needed[*r as usize] = true);
    loop {
        let mut added = false;
        let mut need = |needed: &mut Vec<bool>, r: Reg| {
            added |= !std::mem::replace(&mut needed[r as usize], true);
        };
        for op in state.ops.iter().rev() {
            if is_by_component(op.code) {
                for k in (0..Reg::from(op.n)).filter(|k| needed[(op.d + k) as usize]).collect::<Vec<_>>() {
                    op.operands().for_each(|(r, moves)| need(&mut needed, if moves { r + k } else { r }));
                }
            } else if op.code.is_control() || (0..op.written()).any(|k| needed[(op.d + k) as usize]) {
                op.reads().chain(state.read_elsewhere(op)).for_each(|r| need(&mut needed, r));
            }
        }
        if !added {
            return needed;
        }
    }
}
