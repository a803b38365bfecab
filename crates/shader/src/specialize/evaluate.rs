//! Instructions whose operands are known, by the machine itself.

use glanz_math::SimdLevel;

use crate::lower::VirtualOp;
use crate::machine::{Code, Host, NoTextures, Op, RegisterFile, Row};
use crate::run::execute_16;

/// Where an operand lies in the file of the evaluator, and the most components of one.
const PART: usize = 64;

pub(super) struct Evaluator<'a> {
    level: SimdLevel,
    words: &'a [u32],
    file: RegisterFile<1>,
}

impl<'a> Evaluator<'a> {
    pub(super) fn new(level: SimdLevel, words: &'a [u32]) -> Self {
        Self { level, words, file: RegisterFile::new() }
    }

    /// The uniform word at a place, 0 where there is none.
    pub(super) fn uniform(&self, at: usize) -> u32 {
        self.words.get(at).copied().unwrap_or(0)
    }

    /// What an instruction gives whose operands have these words, one per component; nothing if it cannot be told.
    pub(super) fn results(&mut self, op: &VirtualOp, operands: &[Vec<u32>]) -> Option<Vec<u32>> {
        let written = op.written() as usize;
        if op.code.is_control() || op.code == Code::Texture || written > PART || op.n as usize > PART {
            return None;
        }
        for (part, words) in operands.iter().enumerate() {
            for (k, word) in words.iter().enumerate() {
                *self.file.get_mut((part * PART + k) as u16) = [Row::splat(f32::from_bits(*word))];
            }
        }
        let at = |part: usize| (part * PART) as u16;
        let op = Op { code: op.code, s: 7, n: op.n, d: at(3), a: at(0), b: at(1), c: at(2), imm: op.imm };
        let host = Host { uniforms: self.words, textures: &NoTextures, looks: &[], fuel: 1, down: false };
        execute_16(self.level, &[op], &mut self.file, &host, &mut crate::machine::Silent).ok()?;
        Some((0..written).map(|k| self.file.get(at(3) + k as u16)[0].0[0].to_bits()).collect())
    }
}
