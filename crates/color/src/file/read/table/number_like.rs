//! Fields that are no numbers, but begin like one.

/// Whether a field is a number with something that makes it none: `<5`, `1.400,5`, `12 %`, `0.5*`; no date, time or name.
pub(super) fn is_like_number(field: &str) -> bool {
    let field = field.trim();
    let bare = field.trim_start_matches(|c: char| "<>=≤≥~≈±".contains(c)).trim_start();
    let digits = bare.trim_start_matches(['+', '-', '.', ',']);
    if !digits.starts_with(|c: char| c.is_ascii_digit()) {
        return false;
    }
    let may_be = |c: char| c.is_ascii_digit() || ".,'’ \u{a0}\u{202f}eE+-%*±".contains(c);
    bare.len() < field.len() || (bare.chars().all(may_be) && !is_date(bare) && !is_range(bare))
}

/// Whether a field is a date, with points, hyphens or slashes: `01.02.2026`, `2026-02-01`.
pub(super) fn is_date(field: &str) -> bool {
    let date = field.trim().split([' ', 'T']).next().unwrap_or_default();
    let is_part =
        |part: &&str| !part.is_empty() && part.len() <= 4 && part.bytes().all(|c| c.is_ascii_digit());
    ['.', '-', '/'].into_iter().any(|mark| {
        let parts: Vec<&str> = date.split(mark).collect();
        let [first, month, last] = parts.as_slice() else { return false };
        let day_or_year = |a: &str, b: &str| a.len() <= 2 && matches!(b.len(), 2 | 4);
        parts.iter().all(is_part)
            && month.len() <= 2
            && (day_or_year(first, last) || day_or_year(last, first))
    })
}

/// Whether digits stand on both sides of a hyphen, as in names and ranges: `10-2`.
fn is_range(field: &str) -> bool {
    let bytes = field.as_bytes();
    bytes.windows(2).any(|pair| pair[1] == b'-' && pair[0].is_ascii_digit())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_with_marks_are_told_from_dates_and_names() {
        for field in ["<5", "< 0.001", "1.400,5", "12 %", "0.5*", ">=3", "1'400.5", "-1.400,5", "1.5 ± 0.1"]
        {
            assert!(is_like_number(field), "{field}");
        }
        for field in [
            "ok",
            "2015-05-19",
            "11_00_00",
            "12:00:01",
            "01.02.2026",
            "1/2/2020",
            "1a",
            "B1",
            "10-2",
            "",
            "2B-1.5",
        ] {
            assert!(!is_like_number(field), "{field}");
        }
        assert!(is_date("2026-01-01 12:00:00") && is_date("1.2.20") && !is_date("1.234.567"));
    }
}
