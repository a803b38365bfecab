//! Tints in closed form: least squares that are not negative.

/// Lobes of one fit.
pub(super) const MOST: usize = 5;

/// The least squares of one channel: the matrix of the lobes' products, and their products with the values.
pub(super) struct Normal {
    pub(super) matrix: Vec<Vec<f64>>,
}

impl Normal {
    /// The weighted products of columns.
    pub(super) fn new(columns: &[&[f64]], weights: &[f64]) -> Self {
        let product = |a: &[f64], b: &[f64]| {
            weights.iter().zip(a.iter().zip(b)).map(|(w, (a, b))| w * a * b).sum::<f64>()
        };
        let row = |a: &&[f64]| columns.iter().map(|b| product(a, b)).collect();
        Self { matrix: columns.iter().map(row).collect() }
    }

    /// The tints for products with the values, and by how much they lower the sum of squares: the best of all choices of
    /// lobes that are there, of which none is negative.
    pub(super) fn solve(&self, products: &[f64]) -> (Vec<f64>, f64) {
        let n = products.len();
        let mut best = (vec![0.0; n], 0.0);
        for chosen in (1..1_usize << n).rev() {
            let list: Vec<usize> = (0..n).filter(|i| chosen >> i & 1 == 1).collect();
            let Some(x) = self.solve_for(&list, products) else { continue };
            if x.iter().any(|x| *x < 0.0) {
                continue;
            }
            let gain: f64 = list.iter().zip(&x).map(|(i, x)| products[*i] * x).sum();
            if gain > best.1 {
                let mut all = vec![0.0; n];
                list.iter().zip(&x).for_each(|(i, x)| all[*i] = *x);
                best = (all, gain);
            }
            // With all of them positive none is better.
            if list.len() == n {
                break;
            }
        }
        best
    }

    /// An element on the diagonal of the inverse of the matrix; nothing if the matrix is not positive.
    pub(super) fn inverse_at(&self, i: usize) -> Option<f64> {
        let n = self.matrix.len();
        let unit: Vec<f64> = (0..n).map(|k| f64::from(u8::from(k == i))).collect();
        Some(self.solve_for(&(0..n).collect::<Vec<_>>(), &unit)?[i]).filter(|x| *x > 0.0)
    }

    /// Cholesky's way; nothing where two lobes are the same.
    fn solve_for(&self, list: &[usize], products: &[f64]) -> Option<Vec<f64>> {
        let n = list.len();
        let mut low = vec![vec![0.0; n]; n];
        for i in 0..n {
            for j in 0..=i {
                let known: f64 = (0..j).map(|k| low[i][k] * low[j][k]).sum();
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
        let mut y = vec![0.0; n];
        for i in 0..n {
            let known: f64 = (0..i).map(|k| low[i][k] * y[k]).sum();
            y[i] = (products[list[i]] - known) / low[i][i];
        }
        let mut x = vec![0.0; n];
        for i in (0..n).rev() {
            let known: f64 = (i + 1..n).map(|k| low[k][i] * x[k]).sum();
            x[i] = (y[i] - known) / low[i][i];
        }
        Some(x)
    }
}
