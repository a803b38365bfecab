//! Matrices: column by column, in a fixed order of operations.

use naga::{MathFunction, TypeInner};

use super::{Lowering, Reg};
use crate::machine::Code;

impl Lowering<'_> {
    /// A product in which a matrix stands; matrix × scalar is left to the components.
    pub(super) fn matrix_product(
        &mut self,
        l: &TypeInner,
        r: &TypeInner,
        a: &[Reg],
        b: &[Reg],
    ) -> Option<Vec<Reg>> {
        match (l, r) {
            (TypeInner::Matrix { rows, .. }, TypeInner::Vector { .. }) => {
                Some(self.matrix_vector(a, b, *rows as usize))
            }
            (TypeInner::Vector { .. }, TypeInner::Matrix { rows, .. }) => {
                let columns = b.chunks(*rows as usize);
                Some(columns.flat_map(|column| self.whole(Code::Dot, 1, a, column)).collect())
            }
            (TypeInner::Matrix { rows, .. }, TypeInner::Matrix { rows: inner, .. }) => {
                let columns = b.chunks(*inner as usize);
                Some(columns.flat_map(|column| self.matrix_vector(a, column, *rows as usize)).collect())
            }
            _ => None,
        }
    }

    fn matrix_vector(&mut self, m: &[Reg], v: &[Reg], rows: usize) -> Vec<Reg> {
        let mut sum = self.op(Code::FMul, rows, &[&m[..rows], &v[..1]]);
        for (column, x) in m.chunks(rows).zip(v).skip(1) {
            sum = self.op(Code::FMad, rows, &[column, &[*x], &sum]);
        }
        sum
    }

    pub(super) fn matrix_function(
        &mut self,
        fun: MathFunction,
        inner: &TypeInner,
        a: &[Reg],
        b: &[Reg],
    ) -> Option<Vec<Reg>> {
        if fun == MathFunction::Outer {
            return Some(b.iter().flat_map(|x| self.op(Code::FMul, a.len(), &[a, &[*x]])).collect());
        }
        let &TypeInner::Matrix { columns, rows, .. } = inner else { return None };
        let (columns, rows) = (columns as usize, rows as usize);
        let m: Vec<Vec<Reg>> = a.chunks(rows).map(<[Reg]>::to_vec).collect();
        match fun {
            MathFunction::Transpose => {
                Some((0..rows).flat_map(|r| (0..columns).map(move |c| a[c * rows + r])).collect())
            }
            MathFunction::Determinant if rows == columns => Some(vec![self.determinant(&m)]),
            MathFunction::Inverse if rows == columns => Some(self.inverse(&m)),
            _ => None,
        }
    }

    /// The matrix without a column and a row.
    fn minor(m: &[Vec<Reg>], column: usize, row: usize) -> Vec<Vec<Reg>> {
        let kept = m.iter().enumerate().filter(|(c, _)| *c != column);
        kept.map(|(_, col)| col.iter().enumerate().filter(|(r, _)| *r != row).map(|(_, x)| *x).collect())
            .collect()
    }

    /// By the first column (Laplace).
    fn determinant(&mut self, m: &[Vec<Reg>]) -> Reg {
        if let [column] = m {
            return column[0];
        }
        let mut sum: Option<Reg> = None;
        for row in 0..m.len() {
            let rest = self.determinant(&Self::minor(m, 0, row));
            let term = self.op(Code::FMul, 1, &[&[m[0][row]], &[rest]])[0];
            sum = Some(match sum {
                None => term,
                Some(sum) => {
                    let code = if row % 2 == 1 { Code::FSub } else { Code::FAdd };
                    self.op(code, 1, &[&[sum], &[term]])[0]
                }
            });
        }
        sum.unwrap_or(0)
    }

    /// The adjugate over the determinant.
    fn inverse(&mut self, m: &[Vec<Reg>]) -> Vec<Reg> {
        let n = m.len();
        let (determinant, one) = (self.determinant(m), self.float(1.0));
        let scale = self.op(Code::FDiv, 1, &[&one, &[determinant]]);
        let mut cofactors = Vec::new();
        for column in 0..n {
            for row in 0..n {
                // Entry (row, column) of the inverse is the cofactor of (column, row).
                let minor = self.determinant(&Self::minor(m, row, column));
                let odd = (row + column) % 2 == 1;
                cofactors.push(if odd { self.op(Code::FNeg, 1, &[&[minor]])[0] } else { minor });
            }
        }
        self.op(Code::FMul, cofactors.len(), &[&cofactors, &scale])
    }
}
