//! Registers.

/// Rows of the register file; a power of two, so that a masked index needs no check.
pub(crate) const ROWS: usize = 1024;

/// One scalar for 16 fragments, on a cache line of its own.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Row(pub [f32; 16]);

impl Row {
    /// The same value in all lanes.
    pub const fn splat(value: f32) -> Self {
        Self([value; 16])
    }
}

/// The registers: each is `G` rows, that is, one scalar for 16·`G` fragments.
#[derive(Clone, Debug)]
pub(crate) struct RegisterFile<const G: usize>(pub(crate) Box<[[Row; G]; ROWS]>);

impl<const G: usize> RegisterFile<G> {
    pub(crate) fn new() -> Self {
        let rows: Box<[[Row; G]]> = vec![[Row([0.0; 16]); G]; ROWS].into_boxed_slice();
        Self(rows.try_into().expect("the length is ROWS"))
    }

    /// The rows of a register.
    pub(crate) fn get(&self, register: u16) -> &[Row; G] {
        &self.0[index(register)]
    }

    pub(crate) fn get_mut(&mut self, register: u16) -> &mut [Row; G] {
        &mut self.0[index(register)]
    }
}

/// The index of a register, surely inside the file.
#[inline(always)]
pub(crate) fn index(register: u16) -> usize {
    register as usize & (ROWS - 1)
}
