//! Tints in closed form: least squares that are not negative.

/// Tints of one channel of one fit.
pub(super) const MOST: usize = 8;

/// The tints of a channel, one for each column.
pub(super) type Tints = [f64; MOST];

/// The least squares of one channel: the matrix of the columns' products, of which the lower half is read, and their products
/// with the values.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Normal {
    pub size: usize,
    pub matrix: [Tints; MOST],
    pub products: Tints,
}

impl Normal {
    /// Of this many columns, all 0.
    pub(super) fn new(size: usize) -> Self {
        Self { size, ..Self::default() }
    }

    /// Adds that of other readings.
    pub(super) fn add(&mut self, other: &Self) {
        for i in 0..self.size {
            self.products[i] += other.products[i];
            (0..=i).for_each(|j| self.matrix[i][j] += other.matrix[i][j]);
        }
    }

    /// The tints that lower the sum of squares most: the best of all choices of columns that are there, of which none is
    /// negative.
    pub(super) fn solve(&self) -> Tints {
        let n = self.size;
        let (mut best, mut most) = ([0.0; MOST], 0.0);
        for chosen in (1..1_usize << n).rev() {
            let Some(x) = self.solve_for(chosen) else { continue };
            if x.iter().any(|x| *x < 0.0) {
                continue;
            }
            let gain: f64 = (0..n).map(|i| self.products[i] * x[i]).sum();
            if gain > most {
                (best, most) = (x, gain);
            }
            // With all of them positive none is better.
            if chosen + 1 == 1 << n {
                break;
            }
        }
        best
    }

    /// An element on the diagonal of the inverse of the matrix of the columns whose bits are set; nothing if it is not positive.
    pub(super) fn inverse_at(&self, i: usize, chosen: usize) -> Option<f64> {
        let mut unit = [0.0; MOST];
        unit[i] = 1.0;
        Some(Self { products: unit, ..*self }.solve_for(chosen)?[i]).filter(|x| *x > 0.0)
    }

    /// The inverse of the matrix of the columns whose bits are set, 0 in the lines and columns of others; nothing where two are the
    /// same.
    pub(super) fn inverse(&self, chosen: usize) -> Option<[Tints; MOST]> {
        let mut inverse = [[0.0; MOST]; MOST];
        for (i, line) in inverse.iter_mut().enumerate().filter(|(i, _)| chosen >> i & 1 == 1) {
            let mut unit = [0.0; MOST];
            unit[i] = 1.0;
            *line = Self { products: unit, ..*self }.solve_for(chosen)?;
        }
        Some(inverse)
    }

    /// The solution for the columns whose bits are set, by Cholesky's way; nothing where two of them are the same.
    pub(super) fn solve_for(&self, chosen: usize) -> Option<Tints> {
        let mut list = [0; MOST];
        let mut n = 0;
        for i in (0..self.size).filter(|i| chosen >> i & 1 == 1) {
            list[n] = i;
            n += 1;
        }
        let low = self.factor(&list[..n])?;
        let mut y = [0.0; MOST];
        for i in 0..n {
            let known: f64 = (0..i).map(|k| low[i][k] * y[k]).sum();
            y[i] = (self.products[list[i]] - known) / low[i][i];
        }
        let mut x = [0.0; MOST];
        for i in (0..n).rev() {
            let known: f64 = (i + 1..n).map(|k| low[k][i] * x[list[k]]).sum();
            x[list[i]] = (y[i] - known) / low[i][i];
        }
        Some(x)
    }

    /// The lower triangle whose product with its transpose is the matrix of these columns.
    fn factor(&self, list: &[usize]) -> Option<[Tints; MOST]> {
        let mut low = [[0.0; MOST]; MOST];
        for i in 0..list.len() {
            for j in 0..=i {
                let known: f64 = (0..j).map(|k| low[i][k] * low[j][k]).sum();
                // Columns ascend, so this one stands in the lower half.
                let rest = self.matrix[list[i]][list[j]] - known;
                if i == j {
                    if rest.is_nan() || rest <= 1e-12 * self.matrix[list[i]][list[i]].abs() {
                        return None;
                    }
                    low[i][i] = rest.sqrt();
                } else {
                    low[i][j] = rest / low[j][j];
                }
            }
        }
        Some(low)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two columns with products 1, and `with` each other.
    fn normal(with: f64, products: [f64; 2]) -> Normal {
        let mut normal = Normal::new(2);
        normal.matrix[0][0] = 1.0;
        normal.matrix[1] = [with, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        normal.products[..2].copy_from_slice(&products);
        normal
    }

    #[test]
    fn tints_are_those_of_least_squares_that_are_not_negative() {
        let free = normal(0.5, [1.0, 0.8]).solve();
        assert!((free[0] - 0.8).abs() < 1e-12 && (free[1] - 0.4).abs() < 1e-12, "{free:?}");
        // Freely they would be 4/3 and −2/3 for products of 1 and 0.
        assert_eq!(normal(0.5, [1.0, 0.0]).solve()[..2], [1.0, 0.0]);
        assert_eq!(normal(0.5, [-1.0, -2.0]).solve()[..2], [0.0, 0.0]);
        // Of two that are the same either is enough.
        assert_eq!(normal(1.0, [2.0, 2.0]).solve()[..2].iter().sum::<f64>(), 2.0);
    }
}
