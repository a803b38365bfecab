//! Systems of linear equations of any size.

/// Sums of products of slopes with each other, of which the lower half is kept, and with differences.
#[derive(Clone, Debug)]
pub(super) struct Dense {
    pub size: usize,
    /// Row by row.
    pub matrix: Vec<f64>,
    pub products: Vec<f64>,
}

impl Dense {
    /// All 0.
    pub(super) fn new(size: usize) -> Self {
        Self { size, matrix: vec![0.0; size * size], products: vec![0.0; size] }
    }

    /// Adds that of other readings.
    pub(super) fn add(&mut self, other: &Self) {
        self.matrix.iter_mut().zip(&other.matrix).for_each(|(sum, x)| *sum += x);
        self.products.iter_mut().zip(&other.products).for_each(|(sum, x)| *sum += x);
    }

    /// Adds a difference, with its slopes.
    #[inline]
    pub(super) fn add_row(&mut self, weight: f64, slopes: &[f64], difference: f64) {
        for (i, slope) in slopes.iter().enumerate() {
            let weighted = weight * slope;
            self.products[i] += weighted * difference;
            let row = &mut self.matrix[i * self.size..][..=i];
            row.iter_mut().zip(slopes).for_each(|(sum, other)| *sum += weighted * other);
        }
    }

    /// An element of the diagonal.
    pub(super) fn diagonal(&self, i: usize) -> f64 {
        self.matrix[i * self.size + i]
    }

    /// The solution for the unknowns that are chosen, by Cholesky's way, the others being 0; nothing where the matrix is not
    /// positive.
    pub(super) fn solve_for(&self, chosen: &[usize]) -> Option<Vec<f64>> {
        let low = self.factor(chosen)?;
        let n = chosen.len();
        let mut y = vec![0.0; n];
        for i in 0..n {
            let known: f64 = (0..i).map(|k| low[i * n + k] * y[k]).sum();
            y[i] = (self.products[chosen[i]] - known) / low[i * n + i];
        }
        let mut x = vec![0.0; self.size];
        for i in (0..n).rev() {
            let known: f64 = (i + 1..n).map(|k| low[k * n + i] * x[chosen[k]]).sum();
            x[chosen[i]] = (y[i] - known) / low[i * n + i];
        }
        Some(x)
    }

    /// An element on the diagonal of the inverse of the matrix of the chosen unknowns.
    pub(super) fn inverse_at(&self, i: usize, chosen: &[usize]) -> Option<f64> {
        let mut products = vec![0.0; self.size];
        products[i] = 1.0;
        let unit = Self { products, ..self.clone() };
        unit.solve_for(chosen).map(|x| x[i]).filter(|x| *x > 0.0)
    }

    /// The lower triangle whose product with its transpose is the matrix of the chosen unknowns, which ascend.
    fn factor(&self, chosen: &[usize]) -> Option<Vec<f64>> {
        let n = chosen.len();
        let mut low = vec![0.0; n * n];
        for i in 0..n {
            for j in 0..=i {
                let known: f64 = (0..j).map(|k| low[i * n + k] * low[j * n + k]).sum();
                let whole = self.matrix[chosen[i] * self.size + chosen[j]];
                let rest = whole - known;
                if i != j {
                    low[i * n + j] = rest / low[j * n + j];
                } else if rest > 1e-13 * whole {
                    low[i * n + i] = rest.sqrt();
                } else {
                    return None;
                }
            }
        }
        Some(low)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equations_of_chosen_unknowns_are_solved() {
        let mut sums = Dense::new(3);
        // Rows of slopes whose products with (2, −1, 0.5) are the differences.
        for row in [[1.0, 0.0, 2.0], [0.5, 1.0, 0.0], [0.0, 3.0, 1.0], [1.0, 1.0, 1.0]] {
            sums.add_row(2.0, &row, 2.0 * row[0] - row[1] + 0.5 * row[2]);
        }
        let x = sums.solve_for(&[0, 1, 2]).expect("it is positive");
        assert!(x.iter().zip([2.0, -1.0, 0.5]).all(|(x, exact)| (x - exact).abs() < 1e-12), "{x:?}");
        // Of the second alone: least squares, Σ row·difference / Σ row².
        let alone = sums.solve_for(&[1]).expect("it is positive");
        let exact = (0.0 + 3.0 * -2.5 + 1.5) / 11.0;
        assert!((alone[1] - exact).abs() < 1e-12 && alone[0] == 0.0, "{alone:?}");
        assert!((sums.inverse_at(1, &[1]).expect("it is positive") - 1.0 / 22.0).abs() < 1e-12);
        assert_eq!(Dense::new(2).solve_for(&[0, 1]), None);
    }
}
