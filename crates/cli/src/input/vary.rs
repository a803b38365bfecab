//! Variations of values of a scene, from the command line.

use glanz_plot::{Variation, number};

/// The most values that one range may count.
const MAX_COUNT: usize = 10_000;

/// `PATH=a,b,c` or `PATH=start:stop:count`. Commas inside brackets or quotes do not separate.
pub(crate) fn variation(text: &str) -> Result<Variation, String> {
    const EXPECTED: &str = "expected PATH=1,4,16 or PATH=start:stop:count";
    let (path, values) = text.split_once('=').ok_or(EXPECTED)?;
    let (path, values) = (path.trim(), values.trim());
    if path.is_empty() || values.is_empty() {
        return Err(EXPECTED.to_owned());
    }
    let values = match range(values)? {
        Some(values) => values,
        None => list(values)?,
    };
    Ok(Variation { path: path.to_owned(), values })
}

/// The values of `start:stop:count`, evenly apart; `None` if the text is no range.
fn range(text: &str) -> Result<Option<Vec<String>>, String> {
    let parts: Vec<_> = text.split(':').map(str::trim).collect();
    if let [start, stop] = parts[..]
        && [start, stop].iter().all(|part| part.parse::<f64>().is_ok())
    {
        return Err(format!("'{text}' says not how many values: give start:stop:count, such as {text}:5"));
    }
    let [start, stop, count] = parts[..] else {
        return Ok(None);
    };
    let (Ok(start), Ok(stop)) = (start.parse::<f64>(), stop.parse::<f64>()) else {
        return Ok(None);
    };
    if !start.is_finite() || !stop.is_finite() {
        return Err("start and stop of a range must be finite numbers".to_owned());
    }
    let count = count.parse::<usize>().ok().filter(|count| (1..=MAX_COUNT).contains(count));
    let count = count.ok_or(format!("the count of a range must be a whole number from 1 to {MAX_COUNT}"))?;
    let last = count.saturating_sub(1).max(1) as f64;
    let value = |i: usize| start + (stop - start) * (i as f64 / last);
    // Six digits name a value that the scene then really has: 0:1:4 is 0.333333, not 1/3.
    Ok(Some((0..count).map(|i| number(value(i))).collect()))
}

/// The values between the commas that stand outside brackets and quotes.
fn list(text: &str) -> Result<Vec<String>, String> {
    let mut values = vec![String::new()];
    let (mut depth, mut quote) = (0_i32, None);
    for c in text.chars() {
        match (c, quote) {
            ('"' | '\'', None) => quote = Some(c),
            (_, Some(open)) if c == open => quote = None,
            ('[' | '{', None) => depth += 1,
            (']' | '}', None) => depth -= 1,
            (',', None) if depth == 0 => {
                values.push(String::new());
                continue;
            }
            _ => {}
        }
        values.last_mut().expect("begins with one value").push(c);
    }
    let values: Vec<_> = values.iter().map(|value| value.trim().to_owned()).collect();
    match values.iter().any(String::is_empty) {
        true => Err(format!("there is an empty value in '{text}'")),
        false => Ok(values),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values(text: &str) -> Vec<String> {
        variation(text).unwrap().values
    }

    #[test]
    fn a_list_keeps_its_values_as_written() {
        assert_eq!(values("a.b=1, 4,16"), ["1", "4", "16"]);
        assert_eq!(values("c=[1,0,0],[0,1,0]"), ["[1,0,0]", "[0,1,0]"]);
        assert_eq!(values("m='a,b',\"c\""), ["'a,b'", "\"c\""]);
        assert_eq!(values("m=phong,blinn-phong"), ["phong", "blinn-phong"]);
    }

    #[test]
    fn a_range_holds_both_ends() {
        assert_eq!(values("a=0:1:5"), ["0", "0.25", "0.5", "0.75", "1"]);
        assert_eq!(values("a=2:-2:3"), ["2", "0", "-2"]);
        assert_eq!(values("a=0:1:4"), ["0", "0.333333", "0.666667", "1"]);
        assert_eq!(values("a=3:9:1"), ["3"]);
    }

    #[test]
    fn what_is_neither_is_refused() {
        for wrong in
            ["a", "a=", "=1", "a=1,,2", "a=0:1:0", "a=0:1:99999999999", "a=0:inf:3", "a=0:1:x", "a=1:100"]
        {
            assert!(variation(wrong).is_err(), "{wrong}");
        }
    }
}
