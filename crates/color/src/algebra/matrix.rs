//! 3 × 3 matrices in f64, computable at compile time.

/// A 3 × 3 matrix, row by row; it multiplies columns from the left.
///
/// Everything is `const`, so that the matrices of colour spaces are worked out by the compiler from
/// primaries and white instead of being copied with rounded digits.
///
/// ```
/// use glanz_color::Matrix3;
///
/// const TURN: Matrix3 = Matrix3([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]);
/// assert_eq!(TURN.apply([1.0, 2.0, 3.0]), [-2.0, 1.0, 3.0]);
/// assert_eq!(TURN.inverse().times(&TURN), Matrix3::IDENTITY);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Matrix3(pub [[f64; 3]; 3]);

impl Matrix3 {
    /// The matrix that changes nothing.
    pub const IDENTITY: Self = Self::diagonal([1.0; 3]);

    /// These values on the diagonal, 0 elsewhere.
    pub const fn diagonal([a, b, c]: [f64; 3]) -> Self {
        Self([[a, 0.0, 0.0], [0.0, b, 0.0], [0.0, 0.0, c]])
    }

    /// The matrix with these columns.
    pub const fn from_columns(columns: [[f64; 3]; 3]) -> Self {
        Self(columns).transposed()
    }

    /// Rows and columns exchanged.
    pub const fn transposed(self) -> Self {
        let [[a, b, c], [d, e, f], [g, h, i]] = self.0;
        Self([[a, d, g], [b, e, h], [c, f, i]])
    }

    /// This matrix times a column.
    pub const fn apply(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let [a, b, c] = self.0;
        [a[0] * x + a[1] * y + a[2] * z, b[0] * x + b[1] * y + b[2] * z, c[0] * x + c[1] * y + c[2] * z]
    }

    /// This matrix times another: first `right`, then this.
    pub const fn times(&self, right: &Self) -> Self {
        let [a, b, c] = right.transposed().0;
        Self::from_columns([self.apply(a), self.apply(b), self.apply(c)])
    }

    /// Every entry times a number.
    pub const fn scaled(&self, by: f64) -> Self {
        self.times(&Self::diagonal([by; 3]))
    }

    /// The determinant.
    pub const fn determinant(&self) -> f64 {
        let [a, b, c] = self.0;
        dot(a, cross(b, c))
    }

    /// The inverse by cofactors; entries are not finite where the determinant is 0.
    pub const fn inverse(&self) -> Self {
        let [a, b, c] = self.0;
        let by = 1.0 / self.determinant();
        Self::from_columns([cross(b, c), cross(c, a), cross(a, b)]).scaled(by)
    }
}

const fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

const fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[cfg(test)]
mod tests {
    use super::*;

    const M: Matrix3 = Matrix3([[2.0, 1.0, 0.0], [0.0, 3.0, -1.0], [4.0, 0.0, 5.0]]);

    #[test]
    fn products_and_determinants_are_those_worked_out_by_hand() {
        assert_eq!(M.apply([1.0, 2.0, 3.0]), [4.0, 3.0, 19.0]);
        assert_eq!(M.determinant(), 26.0);
        assert_eq!(M.times(&M).0, [[4.0, 5.0, -1.0], [-4.0, 9.0, -8.0], [28.0, 4.0, 25.0]]);
    }

    #[test]
    fn a_matrix_times_its_inverse_changes_nothing() {
        let product = M.times(&M.inverse());
        for (row, identity) in product.0.iter().zip(Matrix3::IDENTITY.0) {
            for (entry, expected) in row.iter().zip(identity) {
                assert!((entry - expected).abs() < 1e-15, "{product:?}");
            }
        }
    }
}
