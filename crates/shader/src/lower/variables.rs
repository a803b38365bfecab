//! Variables: renamed registers, or a home of fixed ones while control flow may jump.

use std::collections::BTreeSet;

use super::{Lowering, Reg, Variable};
use crate::machine::Code;

impl Lowering<'_> {
    pub(super) fn variable(&mut self, name: &str, registers: Vec<Reg>) -> usize {
        let name = name.to_owned();
        self.state.variables.push(Variable { registers, homes: 0, name, private: None, constant: None });
        self.state.variables.len() - 1
    }

    /// A mask that no lane is in yet.
    pub(super) fn no_lanes(&mut self) -> usize {
        let zero = self.zeros(1);
        self.variable("", zero)
    }

    pub(super) fn store(&mut self, var: usize, offset: usize, value: &[Reg], mask: Option<Reg>) {
        let n = value.len().min(self.state.variables[var].registers.len().saturating_sub(offset));
        let mask = mask.filter(|m| self.state.variables[var].private != Some(*m));
        let old = self.state.variables[var].registers[offset..offset + n].to_vec();
        if self.state.variables[var].homes > 0 {
            let even = self.is_even(value) && mask.is_none_or(|m| self.state.even[m as usize]);
            if !even && old.iter().any(|r| self.state.even[*r as usize]) {
                self.found.insert(var);
            }
            return self.write(&old, value, mask);
        }
        let new = match mask {
            None => value[..n].to_vec(),
            Some(m) => self.op(Code::Sel, n, &[&value[..n], &old, &[m]]),
        };
        self.state.variables[var].registers[offset..offset + n].copy_from_slice(&new);
    }

    pub(super) fn load(&mut self, var: usize, offset: usize, n: usize) -> Vec<Reg> {
        let all = &self.state.variables[var].registers;
        let n = n.min(all.len().saturating_sub(offset));
        let regs = all[offset..offset + n].to_vec();
        if self.state.variables[var].homes == 0 {
            return regs;
        }
        let d = self.fresh(n);
        self.write(&d, &regs, None);
        for (d, r) in d.iter().zip(&regs) {
            self.state.even[*d as usize] = self.state.even[*r as usize];
        }
        d
    }

    /// Gives the variables a home while control flow may jump. `even`: what is the same in all lanes is believed to stay
    /// so, and `found` tells of those that do not.
    pub(super) fn settle(&mut self, vars: &BTreeSet<usize>, even: bool) {
        for &v in vars {
            self.state.variables[v].homes += 1;
            let value = self.state.variables[v].registers.clone();
            if self.state.variables[v].homes == 1 {
                let d = self.fresh(value.len());
                self.write(&d, &value, None);
                let even = even && !self.uneven.contains(&v) && self.is_even(&value);
                d.iter().for_each(|r| self.state.even[*r as usize] = even);
                self.state.variables[v].registers = d;
            } else if !even && value.iter().any(|r| self.state.even[*r as usize]) {
                self.found.insert(v);
            }
        }
    }

    pub(super) fn unsettle(&mut self, vars: &BTreeSet<usize>) {
        for &v in vars {
            self.state.variables[v].homes -= 1;
        }
    }
}
