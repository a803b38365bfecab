//! How values are spread.

/// Mean, median, 95th percentile and maximum.
///
/// ```
/// use glanz_picture::compare::Spread;
///
/// let spread = Spread::of(&[0.0, 1.0, 2.0, 5.0]);
/// assert_eq!((spread.mean, spread.median, spread.max), (2.0, 1.5, 5.0));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spread {
    /// The mean.
    pub mean: f64,
    /// The 50th percentile.
    pub median: f64,
    /// The 95th percentile.
    pub p95: f64,
    /// The greatest.
    pub max: f64,
}

impl Spread {
    /// The spread of these values; zeros where there are none.
    ///
    /// Percentile p of n values stands at place p (n − 1) of the sorted ones, counted from 0, in between on
    /// the straight line (Hyndman, Fan 1996, definition 7, as in NumPy).
    pub fn of(values: &[f32]) -> Self {
        if values.is_empty() {
            return Self::default();
        }
        let mut sorted = values.to_vec();
        let sum: f64 = values.iter().copied().map(f64::from).sum();
        Self {
            mean: sum / values.len() as f64,
            median: percentile(&mut sorted, 0.5),
            p95: percentile(&mut sorted, 0.95),
            max: values.iter().copied().map(f64::from).fold(f64::NEG_INFINITY, f64::max),
        }
    }
}

/// The percentile of values that are not empty; brings them into another order.
fn percentile(values: &mut [f32], part: f64) -> f64 {
    let place = part * (values.len() - 1) as f64;
    let below = place as usize;
    let (_, &mut low, above) = values.select_nth_unstable_by(below, f32::total_cmp);
    let low = f64::from(low);
    match above.iter().copied().min_by(f32::total_cmp) {
        Some(high) => low + (place - below as f64) * (f64::from(high) - low),
        None => low,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_spread_of_few_values_is_that_of_paper_and_pencil() {
        let spread = Spread::of(&[4.0, 1.0, 2.0, 3.0]);
        assert_eq!((spread.mean, spread.median, spread.max), (2.5, 2.5, 4.0));
        // Place 0.95 · 3 = 2.85, between 3 and 4.
        assert!((spread.p95 - 3.85).abs() < 1e-12, "{}", spread.p95);
        assert_eq!(Spread::of(&[7.0]), Spread { mean: 7.0, median: 7.0, p95: 7.0, max: 7.0 });
        assert_eq!(Spread::of(&[]), Spread::default());
    }
}
