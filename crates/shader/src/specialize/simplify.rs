//! What an instruction gives without running it: only what is exact for every number, the sign of zero included.

use crate::lower::Reg;
use crate::machine::Code;

const ALL: u32 = u32::MAX;
const ONE: u32 = 1.0_f32.to_bits();
const ZERO: u32 = 0;
const MINUS_ZERO: u32 = (-0.0_f32).to_bits();

/// What an instruction is in short.
pub(super) enum Short {
    /// Each component is a register that is there.
    Registers(Vec<Reg>),
    /// Each component is this word.
    Word(u32),
    /// Another instruction of the same operands but one fewer, or with its first two exchanged.
    Not,
    Exchanged(Vec<Reg>),
}

/// What is known of registers.
pub(super) struct Facts<'a> {
    pub(super) word: &'a dyn Fn(Reg) -> Option<u32>,
    /// The register that this one is the inverse of.
    pub(super) inverse: &'a dyn Fn(Reg) -> Option<Reg>,
}

impl Facts<'_> {
    /// The word of all registers, if it is one.
    fn common(&self, list: &[Reg]) -> Option<u32> {
        let first = (self.word)(*list.first()?)?;
        list.iter().all(|r| (self.word)(*r) == Some(first)).then_some(first)
    }

    /// The registers that these are the inverses of, if all are known.
    fn inverses(&self, list: &[Reg]) -> Option<Vec<Reg>> {
        list.iter().map(|r| (self.inverse)(*r)).collect()
    }
}

/// The short form of an instruction, if there is one. `lists`: the operands' registers, one per component.
pub(super) fn short(code: Code, lists: &[Vec<Reg>], facts: &Facts<'_>) -> Option<Short> {
    let the = |i: usize| Short::Registers(lists[i].clone());
    let word = |i: usize| lists.get(i).and_then(|list| facts.common(list));
    match code {
        Code::Mov => Some(the(0)),
        Code::Sel => select(lists, facts),
        Code::FMul => match (word(0), word(1)) {
            (Some(ONE), _) => Some(the(1)),
            (_, Some(ONE)) => Some(the(0)),
            _ => None,
        },
        Code::FDiv if word(1) == Some(ONE) => Some(the(0)),
        Code::FSub if word(1) == Some(ZERO) => Some(the(0)),
        Code::FAdd => match (word(0), word(1)) {
            (Some(MINUS_ZERO), _) => Some(the(1)),
            (_, Some(MINUS_ZERO)) => Some(the(0)),
            _ => None,
        },
        Code::And => match (word(0), word(1)) {
            (Some(ALL), _) => Some(the(1)),
            (_, Some(ALL)) => Some(the(0)),
            (Some(0), _) | (_, Some(0)) => Some(Short::Word(0)),
            _ => None,
        },
        Code::Or => match (word(0), word(1)) {
            (Some(0), _) => Some(the(1)),
            (_, Some(0)) => Some(the(0)),
            (Some(ALL), _) | (_, Some(ALL)) => Some(Short::Word(ALL)),
            _ => None,
        },
        Code::AndNot => match (word(0), word(1)) {
            (_, Some(0)) => Some(the(0)),
            (Some(0), _) | (_, Some(ALL)) => Some(Short::Word(0)),
            (Some(ALL), _) => Some(Short::Not),
            _ => None,
        },
        Code::Not => facts.inverses(&lists[0]).map(Short::Registers),
        _ => None,
    }
}

fn select(lists: &[Vec<Reg>], facts: &Facts<'_>) -> Option<Short> {
    let [yes, no, mask] = lists else { return None };
    let each = yes.iter().zip(no).zip(mask);
    let picked = each.map(|((yes, no), mask)| match (facts.word)(*mask) {
        _ if yes == no => Some(*yes),
        Some(word) => Some(if word >> 31 == 1 { *yes } else { *no }),
        None => None,
    });
    if let Some(picked) = picked.collect() {
        return Some(Short::Registers(picked));
    }
    facts.inverses(mask).map(Short::Exchanged)
}
