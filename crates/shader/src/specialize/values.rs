//! The program read once, from its first instruction to its last.

use std::collections::HashMap;

use super::evaluate::Evaluator;
use super::narrow::is_by_component;
use super::simplify::{Facts, Short, short};
use crate::lower::{Draft, Reg, State, VirtualOp};
use crate::machine::Code;

/// Code, constant, components, operands component by component.
type Key = (Code, u32, u16, Vec<Reg>);

/// What is written while the program is read. "Old" registers are those of the program that is read.
struct Rewriting<'a, 'b> {
    old: &'a State,
    new: State,
    evaluator: &'a mut Evaluator<'b>,
    /// Old register → what holds its value now.
    current: Vec<Option<Reg>>,
    /// Old registers that control flow gives different values, so that they stay registers that are written.
    pinned: Vec<bool>,
    /// Per old register: the last instruction that writes it.
    last_write: Vec<usize>,
    /// Per old instruction: whether a loop is around it.
    in_loop: Vec<bool>,
    /// Of new registers: those that are written more than once.
    varying: Vec<bool>,
    /// Of new registers: constants.
    words: Vec<Option<u32>>,
    constants: HashMap<Vec<u32>, Reg>,
    seen: HashMap<Key, Reg>,
    /// What was seen, in order.
    log: Vec<Key>,
    /// A register → the one that it is the inverse of.
    inverses: HashMap<Reg, Reg>,
}

/// The same program with the numbers that are known of its registers put in, and what is known of the new registers.
pub(super) fn rewrite(
    draft: &Draft,
    known: &[Option<u32>],
    evaluator: &mut Evaluator<'_>,
) -> (Draft, Vec<Option<u32>>) {
    let old = &draft.state;
    let spans = Spans::of(old);
    let (pinned, last_write) = pinned(draft, &spans);
    let mut all = Rewriting {
        old,
        new: State::default(),
        evaluator,
        current: vec![None; old.groups.len()],
        pinned,
        last_write,
        in_loop: spans.in_loop,
        varying: Vec::new(),
        words: Vec::new(),
        constants: HashMap::new(),
        seen: HashMap::new(),
        log: Vec::new(),
        inverses: HashMap::new(),
    };
    for (r, word) in known.iter().enumerate() {
        if let Some(word) = word {
            all.current[r] = Some(all.constant(&[*word]));
        }
    }
    all.pin();
    all.prologue(known);
    let inputs = draft.inputs.iter().map(|port| all.input(port)).collect();
    all.instructions();
    let now = |all: &mut Rewriting<'_, '_>, r: Reg| all.value(r);
    let outputs = draft.outputs.iter().map(|port| port.iter().map(|r| now(&mut all, *r)).collect()).collect();
    let discarded = now(&mut all, draft.discarded);
    (Draft { state: all.new, inputs, outputs, discarded }, all.words)
}

/// Where instructions may be left out or run again.
struct Spans {
    in_branch: Vec<bool>,
    in_loop: Vec<bool>,
}

impl Spans {
    fn of(state: &State) -> Self {
        let n = state.ops.len();
        let (mut in_branch, mut in_loop) = (vec![false; n], vec![false; n]);
        for (at, op) in state.ops.iter().enumerate() {
            let target = op.imm as usize;
            match op.code {
                Code::Jump | Code::JumpNone | Code::JumpAny if target > at => {
                    in_branch[at + 1..target].fill(true)
                }
                Code::Jump | Code::JumpNone | Code::JumpAny => in_loop[target..=at].fill(true),
                _ => {}
            }
        }
        Self { in_branch, in_loop }
    }
}

/// The registers that stay, group by group, and the last instruction that writes each register.
fn pinned(draft: &Draft, spans: &Spans) -> (Vec<bool>, Vec<usize>) {
    let state = &draft.state;
    let n = state.groups.len();
    let (mut writes, mut last, mut may_differ, mut carried) =
        (vec![0; n], vec![0; n], vec![false; n], vec![false; n]);
    draft.inputs.iter().flatten().for_each(|r| writes[*r as usize] = 1);
    for (at, op) in state.ops.iter().enumerate() {
        for r in op.reads().chain(state.read_elsewhere(op)) {
            // A turn of a loop reads what the turn before has written.
            carried[r as usize] |= spans.in_loop[at] && writes[r as usize] == 0;
        }
        for r in op.d..op.d + op.written() {
            writes[r as usize] += 1;
            last[r as usize] = at;
            may_differ[r as usize] |= spans.in_branch[at] || spans.in_loop[at];
        }
    }
    let mut pinned = vec![false; n];
    for r in 0..n {
        if writes[r] > 0 && (may_differ[r] && writes[r] > 1 || carried[r]) {
            let (first, size) = state.groups[r];
            pinned[first as usize..(first + size) as usize].fill(true);
        }
    }
    (pinned, last)
}

impl Rewriting<'_, '_> {
    /// `n` new registers side by side.
    fn group(&mut self, n: usize) -> Reg {
        let first = self.new.groups.len() as Reg;
        self.new.groups.extend((0..n).map(|_| (first, n as u32)));
        self.varying.extend((0..n).map(|_| false));
        self.words.extend((0..n).map(|_| None));
        first
    }

    /// Constants side by side.
    fn constant(&mut self, words: &[u32]) -> Reg {
        if let Some(found) = self.constants.get(words) {
            return *found;
        }
        let first = self.group(words.len());
        for (r, word) in (first..).zip(words) {
            self.new.prologue.push(VirtualOp { n: 1, d: r, ..VirtualOp::plain(Code::Imm, *word) });
            self.words[r as usize] = Some(*word);
        }
        self.constants.insert(words.to_vec(), first);
        first
    }

    /// Gives the pinned registers their places.
    fn pin(&mut self) {
        for r in 0..self.pinned.len() {
            let (first, size) = self.old.groups[r];
            if self.pinned[r] && first as usize == r {
                let new = self.group(size as usize);
                for k in 0..size {
                    self.current[r + k as usize] = Some(new + k);
                    self.varying[(new + k) as usize] = true;
                }
            }
        }
    }

    fn input(&mut self, port: &[Reg]) -> Vec<Reg> {
        port.iter()
            .map(|r| {
                if self.current[*r as usize].is_none() {
                    let (first, size) = self.old.groups[*r as usize];
                    let new = self.group(size as usize);
                    (0..size).for_each(|k| self.current[(first + k) as usize] = Some(new + k));
                }
                self.value(*r)
            })
            .collect()
    }

    /// What holds the value of an old register; 0 is in one that was never written.
    fn value(&mut self, r: Reg) -> Reg {
        match self.current[r as usize] {
            Some(r) => r,
            None => self.constant(&[0]),
        }
    }

    /// Reads what is the same for the whole draw but not known yet.
    fn prologue(&mut self, known: &[Option<u32>]) {
        for op in self.old.prologue.iter().filter(|op| known[op.d as usize].is_none()) {
            self.instruction(0, op);
        }
        self.new.prologue.append(&mut self.new.ops);
    }

    /// Reads all instructions.
    fn instructions(&mut self) {
        let mut new_at = Vec::with_capacity(self.old.ops.len() + 1);
        // Where jumps lead to → how much was seen before the first of them.
        let mut landings: HashMap<usize, usize> = HashMap::new();
        for (at, op) in self.old.ops.iter().enumerate() {
            if let Some(seen) = landings.get(&at) {
                for key in self.log.drain(*seen.min(&self.log.len())..) {
                    self.seen.remove(&key);
                }
            }
            new_at.push(self.new.ops.len());
            if matches!(op.code, Code::Jump | Code::JumpNone | Code::JumpAny) {
                landings.entry(op.imm as usize).or_insert(self.log.len());
            }
            self.instruction(at, op);
        }
        new_at.push(self.new.ops.len());
        for op in &mut self.new.ops {
            if matches!(op.code, Code::Jump | Code::JumpNone | Code::JumpAny) {
                op.imm = new_at[op.imm as usize] as u32;
            }
        }
        let loops = self.old.loops.iter();
        self.new.loops = loops.map(|(start, back)| (new_at[*start], new_at[*back])).collect();
        self.new.counts = self.old.counts.iter().map(|(at, span)| (new_at[*at], *span)).collect();
    }

    fn instruction(&mut self, at: usize, op: &VirtualOp) {
        match op.code {
            Code::Jump | Code::Count | Code::Note => self.new.ops.push(*op),
            Code::JumpNone | Code::JumpAny => {
                let a = self.value(op.a);
                self.new.ops.push(VirtualOp { a, ..*op });
            }
            Code::Texture => self.texture(op),
            Code::LoadU => self.uniforms(op, op.imm as usize),
            Code::LoadUI => self.indexed(op),
            _ => self.computed(at, op),
        }
    }

    fn texture(&mut self, op: &VirtualOp) {
        let Some(look) = self.old.looks.get(op.imm as usize) else { return };
        for r in look.reads() {
            self.value(r);
        }
        let zero = self.constant(&[0]);
        let look = look.map(|r| self.current[r as usize].unwrap_or(zero));
        self.new.looks.push(look);
        let imm = self.new.looks.len() as u32 - 1;
        self.push(op, &[], imm);
    }

    fn uniforms(&mut self, op: &VirtualOp, first: usize) {
        for k in 0..op.n as usize {
            let word = self.evaluator.uniform(first + k);
            let value = self.constant(&[word]);
            self.set(op.d + k as Reg, &[value]);
        }
    }

    /// Of the uniforms those that an index picks.
    fn indexed(&mut self, op: &VirtualOp) {
        let index = self.value(op.a);
        match self.words[index as usize] {
            Some(word) => {
                self.uniforms(op, op.imm as usize + (word as usize).min(op.b as usize) * op.c as usize)
            }
            None => {
                let result = self.result(op.d, op.n as usize);
                self.new.ops.push(VirtualOp { d: result, a: index, ..*op });
                self.written(op.d, result, op.n as usize);
            }
        }
    }

    /// All other instructions.
    fn computed(&mut self, at: usize, op: &VirtualOp) {
        let n = op.n as usize;
        let lists: Vec<Vec<Reg>> = op
            .operands()
            .map(|(r, moves)| (0..n as Reg).map(|k| self.value(if moves { r + k } else { r })).collect())
            .collect();
        if let Some(values) = self.folded(op, &lists) {
            return self.set(op.d, &values);
        }
        let facts = Facts { word: &|r| self.words[r as usize], inverse: &|r| self.inverses.get(&r).copied() };
        match short(op.code, &lists, &facts) {
            None => self.seen_or_pushed(op, &lists),
            // What is written again later must be copied now.
            Some(Short::Registers(values)) if !self.is_steady(at, op, &values) => {
                self.push(&VirtualOp { code: Code::Mov, ..*op }, &[values], 0);
            }
            Some(Short::Registers(values)) => self.set(op.d, &values),
            Some(Short::Word(word)) => {
                let value = self.constant(&[word]);
                self.set(op.d, &vec![value; n]);
            }
            Some(Short::Not) => self.seen_or_pushed(&VirtualOp { code: Code::Not, ..*op }, &lists[1..2]),
            Some(Short::Exchanged(mask)) => {
                self.seen_or_pushed(op, &[lists[1].clone(), lists[0].clone(), mask]);
            }
        }
    }

    /// Whether the values stay in their registers as long as the result may be read.
    fn is_steady(&self, at: usize, op: &VirtualOp, values: &[Reg]) -> bool {
        if values.iter().all(|r| !self.varying[*r as usize]) {
            return true;
        }
        // A pinned register that is not written again, read at one place or more.
        let sources = op
            .operands()
            .flat_map(|(r, moves)| (0..Reg::from(op.n)).map(move |k| if moves { r + k } else { r }));
        !self.in_loop[at]
            && sources.into_iter().all(|r| !self.pinned[r as usize] || self.last_write[r as usize] < at)
    }

    /// The result as constants, where all operands are.
    fn folded(&mut self, op: &VirtualOp, lists: &[Vec<Reg>]) -> Option<Vec<Reg>> {
        let words =
            |list: &Vec<Reg>| list.iter().map(|r| self.words[*r as usize]).collect::<Option<Vec<u32>>>();
        let operands: Vec<Vec<u32>> = lists.iter().map(words).collect::<Option<_>>()?;
        let results = self.evaluator.results(op, &operands)?;
        Some(results.iter().map(|word| self.constant(&[*word])).collect())
    }

    fn seen_or_pushed(&mut self, op: &VirtualOp, lists: &[Vec<Reg>]) {
        let is_steady = lists.iter().flatten().all(|r| !self.varying[*r as usize]);
        let key = (op.code, op.imm, op.n, lists.concat());
        if is_steady && let Some(&found) = self.seen.get(&key) {
            let values: Vec<Reg> = (found..found + op.written()).collect();
            return self.set(op.d, &values);
        }
        let result = self.push(op, lists, op.imm);
        if is_steady && !self.varying[result as usize] {
            self.log.push(key.clone());
            self.seen.insert(key, result);
            if op.code == Code::Not && op.n == 1 {
                self.inverses.insert(result, lists[0][0]);
            }
        }
    }

    /// Where the result of an instruction goes.
    fn result(&mut self, d: Reg, n: usize) -> Reg {
        match self.pinned[d as usize] {
            true => self.value(d),
            false => self.group(n),
        }
    }

    /// The old registers from `d` on are the new ones from `result` on.
    fn written(&mut self, d: Reg, result: Reg, n: usize) {
        for k in 0..n as Reg {
            self.current[(d + k) as usize] = Some(result + k);
        }
    }

    /// The old registers from `d` on have these values.
    fn set(&mut self, d: Reg, values: &[Reg]) {
        if self.pinned[d as usize] {
            let n = values.len() as u16;
            self.push(
                &VirtualOp { code: Code::Mov, s: 1, n, d, a: 0, b: 0, c: 0, imm: 0 },
                &[values.to_vec()],
                0,
            );
            return;
        }
        for (k, value) in (0..).zip(values) {
            self.current[(d + k) as usize] = Some(*value);
        }
    }

    /// Writes an instruction with operands in these registers. Where its result is.
    fn push(&mut self, op: &VirtualOp, lists: &[Vec<Reg>], imm: u32) -> Reg {
        let written = op.written() as usize;
        let result = self.result(op.d, written);
        if is_by_component(op.code) {
            self.push_by_component(op, lists, result, imm);
        } else {
            let [a, b] = [0, 1].map(|i| lists.get(i).map_or(0, |list| self.side_by_side(list)));
            self.new.ops.push(VirtualOp { d: result, a, b, c: 0, imm, ..*op });
        }
        self.written(op.d, result, written);
        result
    }

    /// As few instructions as the places of the operands allow.
    fn push_by_component(&mut self, op: &VirtualOp, lists: &[Vec<Reg>], result: Reg, imm: u32) {
        let lists: Vec<Vec<Reg>> = lists.iter().map(|list| self.with_constants_together(list)).collect();
        let n = op.n as usize;
        let mut from = 0;
        while from < n {
            let mut to = from + 1;
            while to < n && lists.iter().all(|list| self.stride(&list[from..=to]).is_some()) {
                to += 1;
            }
            let (mut s, mut first) = (0, [0; 3]);
            for (i, list) in lists.iter().enumerate() {
                s |= self.stride(&list[from..to]).unwrap_or(0) << i;
                first[i] = list[from];
            }
            let [a, b, c] = first;
            let part =
                VirtualOp { code: op.code, s, n: (to - from) as u16, d: result + from as Reg, a, b, c, imm };
            self.new.ops.push(part);
            from = to;
        }
    }

    /// How registers move on with the component: 0, 1, or not evenly.
    fn stride(&self, list: &[Reg]) -> Option<u8> {
        if list.iter().all(|r| *r == list[0]) {
            return Some(0);
        }
        let group = |r: Reg| self.new.groups[r as usize].0;
        let follows = |pair: &[Reg]| pair[1] == pair[0] + 1 && group(pair[1]) == group(pair[0]);
        list.windows(2).all(follows).then_some(1)
    }

    /// Constants that differ, in registers side by side.
    fn with_constants_together(&mut self, list: &[Reg]) -> Vec<Reg> {
        let words: Option<Vec<u32>> = list.iter().map(|r| self.words[*r as usize]).collect();
        match words {
            Some(words) if self.stride(list).is_none() => {
                let first = self.constant(&words);
                (first..first + words.len() as Reg).collect()
            }
            _ => list.to_vec(),
        }
    }

    /// The first of registers side by side with these values.
    fn side_by_side(&mut self, list: &[Reg]) -> Reg {
        if list.len() == 1 || self.stride(list) == Some(1) {
            return list[0];
        }
        let words: Option<Vec<u32>> = list.iter().map(|r| self.words[*r as usize]).collect();
        if let Some(words) = words {
            return self.constant(&words);
        }
        let is_steady = list.iter().all(|r| !self.varying[*r as usize]);
        let key = (Code::Mov, 0, list.len() as u16, list.to_vec());
        if is_steady && let Some(&found) = self.seen.get(&key) {
            return found;
        }
        let first = self.group(list.len());
        let copy = VirtualOp { n: list.len() as u16, d: first, ..VirtualOp::plain(Code::Mov, 0) };
        self.push_by_component(&copy, &[list.to_vec()], first, 0);
        if is_steady {
            self.log.push(key.clone());
            self.seen.insert(key, first);
        }
        first
    }
}
