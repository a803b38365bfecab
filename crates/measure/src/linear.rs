//! Small systems of linear equations.

/// Solves a system whose matrix is symmetric and positive, by elimination without a choice of pivots, which such a matrix
/// does not need: `x` holds the right side, then the solution. Of the matrix as many rows and columns count as `x` has
/// numbers; it is used up.
pub(crate) fn solve<R: AsRef<[f64]> + AsMut<[f64]>>(matrix: &mut [R], x: &mut [f64]) {
    let n = x.len();
    for i in 0..n {
        let (above, below) = matrix[..n].split_at_mut(i + 1);
        let above = &above[i].as_ref()[..n];
        for (j, row) in below.iter_mut().enumerate() {
            let row = &mut row.as_mut()[..n];
            let factor = row[i] / above[i];
            row.iter_mut().zip(above).skip(i).for_each(|(own, above)| *own -= factor * above);
            x[i + 1 + j] -= factor * x[i];
        }
    }
    for i in (0..n).rev() {
        let row = matrix[i].as_ref();
        let known: f64 = (i + 1..n).map(|j| row[j] * x[j]).sum();
        x[i] = (x[i] - known) / row[i];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rounding of a system of this size and condition, with room.
    const ROUNDING: f64 = 1e-13;

    #[test]
    fn a_solution_fulfils_its_equations() {
        let matrix = [[4.0, 1.0, 0.5, 9.0], [1.0, 3.0, -1.0, 9.0], [0.5, -1.0, 2.0, 9.0]];
        let right = [1.0, -2.0, 5.0];
        let mut x = right;
        // The fourth column is none of the system's.
        solve(&mut matrix.clone(), &mut x);
        for (row, right) in matrix.iter().zip(right) {
            let found: f64 = row.iter().zip(x).map(|(a, x)| a * x).sum();
            assert!((found - right).abs() < ROUNDING, "{found} {right}");
        }
        let mut of_rows = right;
        solve(&mut matrix.map(|row| row.to_vec()), &mut of_rows);
        assert_eq!(of_rows, x);
    }
}
