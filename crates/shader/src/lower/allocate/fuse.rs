//! A product that only a sum reads joins it: two roundings as before, one instruction.

use std::collections::HashMap;

use crate::lower::{Reg, State, VirtualOp};
use crate::machine::Code;

impl State {
    /// `kept`: registers that are read at the end.
    pub(super) fn fuse(&mut self, kept: &[Reg]) {
        let (readers, writers) = self.count_uses(kept);
        let mut products: HashMap<Reg, usize> = HashMap::new();
        for i in 0..self.ops.len() {
            let op = self.ops[i];
            match op.code {
                Code::Note => {}
                code if code.is_control() => products.clear(),
                Code::FMul => {
                    products.insert(op.d, i);
                }
                Code::FAdd => {
                    // A sum is the same bits with its terms exchanged.
                    let terms =
                        [(op.a, op.s & 1, op.b, op.s >> 1 & 1), (op.b, op.s >> 1 & 1, op.a, op.s & 1)];
                    for (product, moves, other, other_moves) in terms {
                        let Some(&m) = products.get(&product) else { continue };
                        let mul = self.ops[m];
                        if joins(&mul, &op, moves, &readers, &writers) {
                            let s = mul.s & 3 | other_moves << 2;
                            self.ops[i] =
                                VirtualOp { code: Code::FMad, a: mul.a, b: mul.b, c: other, s, ..op };
                            break;
                        }
                    }
                }
                _ => {}
            }
        }
    }

    /// How often each register is read and written.
    fn count_uses(&self, kept: &[Reg]) -> (Vec<u32>, Vec<u32>) {
        let mut readers = vec![0u32; self.groups.len()];
        let mut writers = readers.clone();
        for op in self.prologue.iter().chain(&self.ops) {
            op.reads().for_each(|r| readers[r as usize] += 1);
            self.read_elsewhere(op).into_iter().for_each(|r| readers[r as usize] += 1);
        }
        for op in &self.ops {
            (0..op.written()).for_each(|k| writers[(op.d + k) as usize] += 1);
        }
        kept.iter().for_each(|r| readers[*r as usize] += 1);
        (readers, writers)
    }
}

fn joins(mul: &VirtualOp, add: &VirtualOp, moves: u8, readers: &[u32], writers: &[u32]) -> bool {
    let whole = mul.n == add.n && (moves == 1 || add.n == 1);
    let results = || (0..Reg::from(mul.n)).map(|k| (mul.d + k) as usize);
    let once = results().all(|r| readers[r] == 1 && writers[r] == 1);
    // What the product reads must not change in between.
    let steady = mul.reads().all(|r| writers[r as usize] <= 1);
    whole && once && steady
}
