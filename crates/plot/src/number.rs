//! Numbers as they stand in plots and tables.

/// A number for people: up to six significant digits, no trailing zeros.
///
/// ```
/// assert_eq!(glanz_plot::number(0.1 + 0.2), "0.3");
/// assert_eq!(glanz_plot::number(1e12), "1.0000e12");
/// ```
pub fn number(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    if !value.is_finite() {
        return value.to_string();
    }
    let magnitude = libm::log10(value.abs()).floor() as i32;
    if !(-4..9).contains(&magnitude) {
        return format!("{value:.4e}");
    }
    let text = format!("{value:.*}", (5 - magnitude).max(0) as usize);
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_six_digits_and_no_trailing_zeros() {
        let cases = [
            (0.0, "0"),
            (1.0, "1"),
            (0.1 + 0.2, "0.3"),
            (-1.234_567_8, "-1.23457"),
            (1e12, "1.0000e12"),
            (123_456_789.0, "123456789"),
            (0.000_012_3, "1.2300e-5"),
        ];
        for (value, text) in cases {
            assert_eq!(number(value), text);
        }
    }
}
