//! Tables that hold the same wavelengths more than once.

use super::Source;
use super::lines::Run;

/// Of a table that goes through its wavelengths several times, from one end to the other each time, the piece with the most
/// lines: meters write their spectra by 5 nm and then by 1 nm.
pub(super) fn longest_piece(
    source: &Source<'_>,
    run: Run,
    axis: usize,
    values: &mut [Vec<f64>],
) -> (Run, Option<String>) {
    let known = &values[axis];
    let (Some(first), Some(last)) = (known.first(), known.last()) else { return (run, None) };
    let starts: Vec<usize> =
        (0..known.len()).filter(|i| *i == 0 || known[i - 1] == *last && known[*i] == *first).collect();
    if starts.len() < 2 || first == last {
        return (run, None);
    }
    let ends = starts[1..].iter().copied().chain([known.len()]);
    let pieces = starts.iter().copied().zip(ends);
    let Some((start, end)) = pieces.max_by_key(|(start, end)| (end - start, usize::MAX - start)) else {
        return (run, None);
    };
    let places: Vec<usize> = (run.first..run.end).filter(|at| !source.content[*at].is_comment).collect();
    let told = format!(
        "the wavelengths stand there {} times: the finest table is taken, from line {} on",
        starts.len(),
        source.content[places[start]].number
    );
    let run = Run { first: places[start], end: places[end - 1] + 1, count: end - start, ..run };
    for column in values {
        *column = column[start..end].to_vec();
    }
    (run, Some(told))
}
