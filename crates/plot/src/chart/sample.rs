//! Points of a curve, close together where it bends.

/// How far a point may lie from the line between its neighbours, in parts of the whole height.
const BEND: f64 = 1e-3;
/// How often a step is halved: the finest is 0.25° / 2¹² = 0.00006°.
const HALVINGS: u32 = 12;
/// The widest step, in degrees.
const STEP: f64 = 0.5;
/// Distances from a peak that are looked at, in degrees.
const ABOUT: [f64; 6] = [0.001, 0.005, 0.02, 0.05, 0.1, 0.2];

/// The values of `f` from `low` to `high` degrees, with the peaks that are known of. Straightness is judged in
/// `scale`, such as a logarithm.
pub fn sampled(
    f: impl Fn(f64) -> f64,
    (low, high): (f64, f64),
    peaks: &[f64],
    scale: impl Fn(f64) -> f64,
) -> Vec<(f64, f64)> {
    let steps = ((high - low) / STEP).ceil() as usize;
    let mut places: Vec<f64> =
        (0..=steps).map(|i| low + (high - low) * i as f64 / steps.max(1) as f64).collect();
    for peak in peaks {
        places.push(*peak);
        places.extend(ABOUT.iter().flat_map(|about| [peak - about, peak + about]));
    }
    places.retain(|place| (low..=high).contains(place));
    places.sort_by(f64::total_cmp);
    places.dedup();
    let points: Vec<_> = places.into_iter().map(|place| (place, f(place))).collect();
    let heights = || points.iter().map(|(_, value)| scale(*value)).filter(|height| height.is_finite());
    let (least, most) = (heights().fold(f64::MAX, f64::min), heights().fold(f64::MIN, f64::max));
    let bend = BEND * (most - least).max(f64::MIN_POSITIVE);
    let mut all = Vec::with_capacity(2 * points.len());
    for pair in points.windows(2) {
        all.push(pair[0]);
        between(&f, &scale, bend, (pair[0], pair[1]), HALVINGS, &mut all);
    }
    all.extend(points.last());
    all
}

/// Adds the points between two that are needed.
fn between(
    f: &impl Fn(f64) -> f64,
    scale: &impl Fn(f64) -> f64,
    bend: f64,
    (left, right): ((f64, f64), (f64, f64)),
    halvings: u32,
    all: &mut Vec<(f64, f64)>,
) {
    let place = 0.5 * (left.0 + right.0);
    let middle = (place, f(place));
    let away = scale(middle.1) - 0.5 * (scale(left.1) + scale(right.1));
    if halvings == 0 || away.is_nan() || away.abs() <= bend {
        return;
    }
    between(f, scale, bend, (left, middle), halvings - 1, all);
    all.push(middle);
    between(f, scale, bend, (middle, right), halvings - 1, all);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_needle_is_drawn_to_its_tip_and_a_line_with_few_points() {
        let needle = |x: f64| (-((x - 12.34) / 0.01).powi(2)).exp();
        let points = sampled(needle, (-90.0, 90.0), &[12.34], |v| v);
        let greatest = points.iter().map(|(_, value)| *value).fold(0.0, f64::max);
        assert!(greatest == 1.0 && points.len() < 1200, "{}", points.len());
        assert!(points.windows(2).all(|pair| pair[0].0 < pair[1].0));
        assert_eq!(sampled(|x| x, (0.0, 90.0), &[], |v| v).len(), 181);
    }
}
