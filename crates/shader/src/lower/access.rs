//! Members, elements, components; uniform memory, in which every scalar is one word, in the order of the source.

use naga::{Span, TypeInner};

use super::{Choice, Item, Lowering, MOST_SCALARS, Refused, Reg, VirtualOp};
use crate::machine::Code;

/// A part of a type.
struct Part {
    offset: usize,
    size: usize,
    /// How many such parts there are, for dynamic indices.
    count: usize,
}

impl Lowering<'_> {
    fn part(&self, inner: &TypeInner, index: usize) -> Part {
        let even = |size: usize, count: usize| Part { offset: index * size, size, count };
        match inner {
            TypeInner::Pointer { base, .. } => self.part(&self.module.types[*base].inner, index),
            TypeInner::Struct { members, .. } => {
                let before = members.iter().take(index).map(|m| self.size_of(m.ty)).sum();
                Part { offset: before, size: members.get(index).map_or(0, |m| self.size_of(m.ty)), count: 0 }
            }
            TypeInner::Array { base, size, .. } => even(self.size_of(*base), self.count(*size)),
            TypeInner::Matrix { columns, rows, .. } => even(*rows as usize, *columns as usize),
            TypeInner::Vector { size, .. } => even(1, *size as usize),
            TypeInner::ValuePointer { size, .. } => even(1, size.map_or(1, |s| s as usize)),
            _ => even(0, 0),
        }
    }

    pub(super) fn access(
        &mut self,
        item: &Item,
        inner: &TypeInner,
        index: usize,
        dynamic: Option<Reg>,
        span: Span,
    ) -> Result<Item, Refused> {
        if let Some(known) = dynamic.and_then(|r| self.constant_word(r))
            && (known as usize) < self.part(inner, 0).count
        {
            self.indexed = true;
            return self.access(item, inner, known as usize, None, span);
        }
        let part = self.part(inner, index);
        if dynamic.is_some() && part.count == 0 {
            return Err(Refused::new("arrays whose length only the host knows are not there", span));
        }
        match (item, dynamic) {
            (Item::Value(regs), None) => {
                let regs = regs.get(part.offset..part.offset + part.size);
                Ok(Item::Value(regs.map(<[Reg]>::to_vec).unwrap_or_default()))
            }
            (Item::Value(regs), Some(i)) => {
                let parts: Vec<_> = regs.chunks(part.size.max(1)).map(<[Reg]>::to_vec).collect();
                Ok(Item::Value(self.choose(i, &parts)))
            }
            (Item::Place { var, offset, dynamic }, None) => {
                Ok(Item::Place { var: *var, offset: offset + part.offset, dynamic: dynamic.clone() })
            }
            (Item::Place { var, offset, dynamic }, Some(i)) => {
                let dynamic = Some(self.choice(dynamic.as_ref(), i, &part, span)?);
                Ok(Item::Place { var: *var, offset: *offset, dynamic })
            }
            (Item::Uniform { word, dynamic }, None) => {
                Ok(Item::Uniform { word: word + part.offset, dynamic: *dynamic })
            }
            (Item::Uniform { word, dynamic }, Some(i)) => {
                let dynamic = Some(self.uniform_index(*dynamic, i, &part, span)?);
                Ok(Item::Uniform { word: *word, dynamic })
            }
            (Item::Texture(_) | Item::Nothing, _) => {
                Err(Refused::new("arrays of textures are not there", span))
            }
        }
    }

    /// A dynamic index, inside another one or not.
    fn choice(&mut self, outer: Option<&Choice>, i: Reg, part: &Part, span: Span) -> Result<Choice, Refused> {
        let inner: Vec<usize> = (0..part.count).map(|k| k * part.size).collect();
        let Some(outer) = outer else { return Ok(Choice { index: i, offsets: inner }) };
        if outer.offsets.len() * inner.len() > MOST_SCALARS {
            return Err(Refused::new("too many elements to choose from by two indices", span));
        }
        let count = self.word(part.count as u32);
        let row = self.op(Code::IMul, 1, &[&[outer.index], &[count]]);
        let index = self.op(Code::IAdd, 1, &[&row, &[i]])[0];
        let offsets = outer.offsets.iter().flat_map(|o| inner.iter().map(move |k| o + k)).collect();
        Ok(Choice { index, offsets })
    }

    fn uniform_index(
        &mut self,
        outer: Option<(Reg, usize, usize)>,
        i: Reg,
        part: &Part,
        span: Span,
    ) -> Result<(Reg, usize, usize), Refused> {
        let last = part.count.saturating_sub(1);
        let Some((j, stride, outer_last)) = outer else { return Ok((i, part.size, last)) };
        let all = outer_last * stride + last * part.size;
        if all > usize::from(u16::MAX) {
            return Err(Refused::new("this uniform is too large for two indices", span));
        }
        let mut words = |reg: Reg, last: usize, stride: usize| {
            let (last, stride) = (self.word(last as u32), self.word(stride as u32));
            let kept = self.op(Code::UMin, 1, &[&[reg], &[last]]);
            self.op(Code::IMul, 1, &[&kept, &[stride]])
        };
        let (a, b) = (words(j, outer_last, stride), words(i, last, part.size));
        Ok((self.op(Code::IAdd, 1, &[&a, &b])[0], 1, all))
    }

    /// `n` words of uniforms; dynamic: register, stride in words, last index.
    pub(super) fn load_uniform(
        &mut self,
        word: usize,
        n: usize,
        dynamic: Option<(Reg, usize, usize)>,
    ) -> Vec<Reg> {
        if n == 0 {
            return Vec::new();
        }
        let plain = VirtualOp { n: n as u16, ..VirtualOp::plain(Code::LoadU, word as u32) };
        let Some((index, stride, last)) = dynamic else {
            let key = (Code::LoadU, word as u32, [0; 3], n as u16, 0);
            if let Some(known) = self.state.known.get(&key) {
                return known.clone();
            }
            let d = self.fresh(n);
            self.push(true, VirtualOp { d: d[0], ..plain });
            self.state.known.insert(key, d.clone());
            return d;
        };
        let d = self.fresh(n);
        let s = if self.state.even[index as usize] { 8 } else { 0 };
        let (b, c) = (last as Reg, stride as Reg);
        let hoist = self.state.hoisted[index as usize];
        self.push(hoist, VirtualOp { code: Code::LoadUI, s, d: d[0], a: index, b, c, ..plain });
        d
    }
}
