//! Registers and instructions.

use super::{Lowering, MOST_WORK, Refused, Reg, VirtualOp};
use crate::machine::Code;

impl VirtualOp {
    /// An instruction without operands.
    pub(crate) fn plain(code: Code, imm: u32) -> Self {
        Self { code, s: 0, n: 0, d: 0, a: 0, b: 0, c: 0, imm }
    }

    pub(crate) fn copy(d: Reg, a: Reg) -> Self {
        Self { code: Code::Mov, s: 0, n: 1, d, a, b: 0, c: 0, imm: 0 }
    }

    /// The registers that it reads, by a, b and c, and whether they move on with the component.
    pub(crate) fn operands(&self) -> impl Iterator<Item = (Reg, bool)> {
        let all = [(self.a, self.s & 1 != 0), (self.b, self.s & 2 != 0), (self.c, self.s & 4 != 0)];
        all.into_iter().take(self.code.operands())
    }

    /// All registers that it reads by its operands.
    pub(crate) fn reads(&self) -> impl Iterator<Item = Reg> {
        let n = Reg::from(self.n.max(1));
        self.operands().flat_map(move |(r, moves)| (0..if moves { n } else { 1 }).map(move |k| r + k))
    }

    /// How many registers it writes.
    pub(crate) fn written(&self) -> Reg {
        match self.code {
            Code::Dot | Code::Length => 1,
            Code::Cross => 3,
            code if code.is_control() => 0,
            _ => Reg::from(self.n),
        }
    }
}

impl Lowering<'_> {
    /// `n` new registers side by side.
    pub(super) fn fresh(&mut self, n: usize) -> Vec<Reg> {
        let first = self.state.groups.len() as Reg;
        for _ in 0..n {
            self.state.groups.push((first, n as u32));
            self.state.hoisted.push(false);
            self.state.even.push(false);
        }
        (first..first + n as Reg).collect()
    }

    /// Whether there has been too much work.
    pub(super) fn check_work(&mut self, span: naga::Span) -> Result<(), Refused> {
        self.work += 1;
        let made = self.state.ops.len() + self.state.prologue.len() + self.state.groups.len() / 4;
        if self.work > MOST_WORK || made > MOST_WORK / 4 {
            return Err(Refused::new(
                "the shader is too long: calls are inlined, and this one becomes too many instructions",
                span,
            ));
        }
        Ok(())
    }

    pub(super) fn is_hoisted(&self, regs: &[Reg]) -> bool {
        regs.iter().all(|r| self.state.hoisted[*r as usize])
    }

    pub(super) fn is_even(&self, regs: &[Reg]) -> bool {
        regs.iter().all(|r| self.state.even[*r as usize])
    }

    /// A constant.
    pub(super) fn word(&mut self, word: u32) -> Reg {
        let key = (Code::Imm, word, [0; 3], 1, 0);
        if let Some(r) = self.state.known.get(&key) {
            return r[0];
        }
        let r = self.fresh(1);
        self.push(true, VirtualOp { n: 1, d: r[0], ..VirtualOp::plain(Code::Imm, word) });
        self.state.known.insert(key, r.clone());
        self.state.constants.insert(r[0], word);
        r[0]
    }

    /// The word of a register, if it is known.
    pub(super) fn constant_word(&self, r: Reg) -> Option<u32> {
        self.state.constants.get(&r).copied()
    }

    /// What is known of counters, so that loops over lights need not run to be known.
    fn folded(&mut self, code: Code, args: &[&[Reg]]) -> Option<Reg> {
        let [[a], [b]] = args else { return None };
        let (a, b) = (self.constant_word(*a)?, self.constant_word(*b)?);
        let (x, y) = (a as i32, b as i32);
        let truth = |is: bool| if is { u32::MAX } else { 0 };
        let word = match code {
            Code::IAdd => a.wrapping_add(b),
            Code::ISub => a.wrapping_sub(b),
            Code::IMul => a.wrapping_mul(b),
            Code::ILt => truth(x < y),
            Code::ILe => truth(x <= y),
            Code::IGt => truth(x > y),
            Code::IGe => truth(x >= y),
            Code::IEq => truth(x == y),
            Code::INe => truth(x != y),
            _ => return None,
        };
        Some(self.word(word))
    }

    pub(super) fn float(&mut self, x: f32) -> Vec<Reg> {
        vec![self.word(x.to_bits())]
    }

    pub(super) fn zeros(&mut self, n: usize) -> Vec<Reg> {
        vec![self.word(0); n]
    }

    /// Adds an instruction and marks what it writes.
    pub(super) fn push(&mut self, hoist: bool, op: VirtualOp) {
        self.work += 1;
        let even = op.reads().all(|r| self.state.even[r as usize]);
        for k in 0..op.written() {
            self.state.even[(op.d + k) as usize] = even;
            self.state.hoisted[(op.d + k) as usize] |= hoist;
        }
        if hoist {
            self.state.prologue.push(op);
        } else {
            self.state.ops.push(op);
        }
    }

    /// How an operand moves on with the component: 0, 1, or not evenly. Only registers of one group stay together.
    pub(super) fn stride(&self, regs: &[Reg], n: usize) -> Option<u8> {
        let Some(&first) = regs.first() else { return Some(0) };
        if regs.iter().all(|r| *r == first) {
            return Some(0);
        }
        let group = |r: Reg| self.state.groups[r as usize].0;
        let side_by_side =
            regs.len() >= n && (1..n).all(|k| regs[k] == first + k as Reg && group(regs[k]) == group(first));
        side_by_side.then_some(1)
    }

    /// `n` results, component by component, from operands of 1 or `n` registers.
    pub(super) fn op(&mut self, code: Code, n: usize, args: &[&[Reg]]) -> Vec<Reg> {
        if n == 1
            && let Some(known) = self.folded(code, args)
        {
            return vec![known];
        }
        let packed: Vec<Vec<Reg>> = args
            .iter()
            .map(|r| {
                let scattered = r.len() == n && self.stride(r, n).is_none() && self.is_hoisted(r);
                if scattered { self.packed(r) } else { r.to_vec() }
            })
            .collect();
        let [a, b, c] = [0, 1, 2].map(|i| packed.get(i).map_or(&[] as &[Reg], |r| r));
        let hoist = packed.iter().all(|r| self.is_hoisted(r));
        if let (Some(sa), Some(sb), Some(sc)) = (self.stride(a, n), self.stride(b, n), self.stride(c, n)) {
            return self.even_op(code, n, [a, b, c], sa | sb << 1 | sc << 2, hoist);
        }
        self.scattered_op(code, n, [a, b, c], hoist)
    }

    fn even_op(&mut self, code: Code, n: usize, args: [&[Reg]; 3], s: u8, hoist: bool) -> Vec<Reg> {
        let [a, b, c] = args.map(|r| r.first().copied().unwrap_or(0));
        let key = (code, 0, [a, b, c], n as u16, s);
        if hoist && let Some(found) = self.state.known.get(&key) {
            return found.clone();
        }
        let d = self.fresh(n);
        self.push(hoist, VirtualOp { code, s, n: n as u16, d: d[0], a, b, c, imm: 0 });
        if hoist {
            self.state.known.insert(key, d.clone());
        }
        d
    }

    /// Operands that are not side by side: as few runs of components as they allow.
    fn scattered_op(&mut self, code: Code, n: usize, args: [&[Reg]; 3], hoist: bool) -> Vec<Reg> {
        let at = |r: &[Reg], k: usize| r.get(k.min(r.len().saturating_sub(1))).copied().unwrap_or(0);
        fn part(r: &[Reg], from: usize, to: usize) -> &[Reg] {
            if r.len() <= 1 { r } else { r.get(from..to).unwrap_or(r) }
        }
        let d = self.fresh(n);
        let mut from = 0;
        while from < n {
            let (mut to, mut s) = (from + 1, 0);
            for longer in from + 2..=n {
                let strides = args.map(|r| self.stride(part(r, from, longer), longer - from));
                let [Some(sa), Some(sb), Some(sc)] = strides else { break };
                (to, s) = (longer, sa | sb << 1 | sc << 2);
            }
            let [a, b, c] = args.map(|r| at(r, from));
            self.push(hoist, VirtualOp { code, s, n: (to - from) as u16, d: d[from], a, b, c, imm: 0 });
            from = to;
        }
        d
    }

    /// The same values side by side.
    pub(super) fn packed(&mut self, regs: &[Reg]) -> Vec<Reg> {
        if regs.len() <= 1 || self.stride(regs, regs.len()) == Some(1) {
            return regs.to_vec();
        }
        let d = self.fresh(regs.len());
        let hoist = self.is_hoisted(regs);
        for (d, r) in d.iter().zip(regs) {
            self.push(hoist, VirtualOp::copy(*d, *r));
        }
        d
    }

    /// Instructions over whole vectors: dot, length, normalize, cross.
    pub(super) fn whole(&mut self, code: Code, results: usize, a: &[Reg], b: &[Reg]) -> Vec<Reg> {
        let (a, b) = (self.packed(a), self.packed(b));
        let hoist = self.is_hoisted(&a) && self.is_hoisted(&b);
        let d = self.fresh(results);
        let first = |r: &[Reg]| r.first().copied().unwrap_or(0);
        self.push(
            hoist,
            VirtualOp { code, s: 7, n: a.len() as u16, d: d[0], a: first(&a), b: first(&b), c: 0, imm: 0 },
        );
        d
    }

    /// Writes `value` to the fixed registers `d`, in the lanes of the mask.
    pub(super) fn write(&mut self, d: &[Reg], value: &[Reg], mask: Option<Reg>) {
        let n = d.len();
        if value.is_empty() || n == 0 {
            return;
        }
        let (code, c) = (if mask.is_some() { Code::Sel } else { Code::Mov }, mask.unwrap_or(0));
        let selects = u8::from(mask.is_some()) << 1;
        if n > 1
            && self.stride(d, n) == Some(1)
            && value.len() >= n
            && let Some(s) = self.stride(value, n)
        {
            let op =
                VirtualOp { code, s: s | selects, n: n as u16, d: d[0], a: value[0], b: d[0], c, imm: 0 };
            self.work += 1;
            return self.state.ops.push(op);
        }
        for (k, d) in d.iter().enumerate() {
            let a = value[k.min(value.len() - 1)];
            self.work += 1;
            self.state.ops.push(VirtualOp { code, s: 0, n: 1, d: *d, a, b: *d, c, imm: 0 });
        }
    }

    /// A jump whose target is filled in by [`Self::land`].
    pub(super) fn jump(&mut self, code: Code, mask: Reg) -> usize {
        self.state.ops.push(VirtualOp { a: mask, ..VirtualOp::plain(code, 0) });
        self.state.ops.len() - 1
    }

    /// The jump leads to here.
    pub(super) fn land(&mut self, jump: usize) {
        self.state.ops[jump].imm = self.state.ops.len() as u32;
    }
}
