use proptest::prelude::*;

use super::*;

/// Rounding of sums over a few hundred products, relative to the values.
const ROUNDING: f64 = 1e-11;

fn fine(first: f64, last: f64, step: f64, f: impl Fn(f64) -> f64) -> (Vec<f64>, Vec<f64>) {
    let count = ((last - first) / step).round() as usize;
    (0..=count).map(|i| first + step * i as f64).map(|nm| (nm, f(nm))).unzip()
}

fn trapezoid(nm: &[f64], values: &[f64]) -> f64 {
    nm.windows(2).zip(values.windows(2)).map(|(x, y)| (x[1] - x[0]) * (y[0] + y[1]) / 2.0).sum()
}

#[test]
fn points_on_the_grid_are_kept_and_lines_drawn_between_them() {
    let s = Spectrum::from_table(&[400.0, 420.0, 425.0], &[1.0, 3.0, 0.1], Outside::Zero).expect("a table");
    for (nm, value) in [(395.0, 0.0), (400.0, 1.0), (405.0, 1.5), (420.0, 3.0), (425.0, 0.1), (430.0, 0.0)] {
        assert_eq!(s.at(nm), value, "{nm} nm");
    }
    let held = Spectrum::from_table(&[400.0, 420.0], &[1.0, 3.0], Outside::Hold).expect("a table");
    assert_eq!((held.at(300.0), held.at(780.0)), (1.0, 3.0));
}

#[test]
fn coarse_tables_on_the_grid_keep_the_integral_of_the_trapezoids() {
    let (nm, values) = fine(380.0, 730.0, 10.0, |nm| libm::sin(nm / 31.0) + 1.0);
    let s = Spectrum::from_table(&nm, &values, Outside::Zero).expect("a table");
    let ends = (values[0] + values[values.len() - 1]) / 2.0 * STEP_NM;
    assert!((s.integral() - ends - trapezoid(&nm, &values)).abs() < 1e-9);
}

#[test]
fn a_table_by_1_nm_over_the_whole_grid_loses_nothing_at_its_ends() {
    let (nm, values) = fine(300.0, 780.0, 1.0, |_| 0.7);
    for outside in [Outside::Zero, Outside::Hold] {
        let s = Spectrum::from_table(&nm, &values, outside).expect("a table");
        assert!(s.0.iter().all(|v| (v - 0.7).abs() < ROUNDING), "{outside:?}");
    }
}

#[test]
fn a_table_of_1_nm_of_a_ramp_gives_the_ramp() {
    let (nm, values) = fine(290.0, 790.0, 1.0, |nm| 0.01 * nm - 2.0);
    let s = Spectrum::from_table(&nm, &values, Outside::Zero).expect("a table");
    let ramp = Spectrum::from_fn(|nm| 0.01 * nm - 2.0);
    assert!((s - ramp).0.iter().all(|v| v.abs() < ROUNDING));
}

#[test]
fn tables_beyond_the_grid_are_dropped_or_held() {
    let short = |outside| Spectrum::from_table(&[101.3, 202.4], &[1.0, 2.0], outside).expect("a table");
    assert_eq!(short(Outside::Zero), Spectrum::ZERO);
    assert!(short(Outside::Hold).0.iter().all(|v| (v - 2.0).abs() < ROUNDING));
    let long = |outside| Spectrum::from_table(&[901.3, 1002.4], &[1.0, 2.0], outside).expect("a table");
    assert_eq!(long(Outside::Zero), Spectrum::ZERO);
    assert!(long(Outside::Hold).0.iter().all(|v| (v - 1.0).abs() < ROUNDING));
}

#[test]
fn lines_keep_their_power_and_their_place() {
    let s = Spectrum::from_lines(&[(546.1, 2.0)]).expect("a line");
    assert!((s.integral() - 2.0).abs() < ROUNDING);
    let centre = s.points().map(|(nm, value)| nm * value * STEP_NM).sum::<f64>() / 2.0;
    assert!((centre - 546.1).abs() < 1e-9);
    assert_eq!(s.0.iter().filter(|v| **v > 0.0).count(), 2);
    let at_the_end = Spectrum::from_lines(&[(300.0, 1.0), (250.0, 5.0), (790.0, 5.0)]).expect("lines");
    assert_eq!(at_the_end.integral(), 1.0);
}

#[test]
fn what_is_no_table_is_told_with_its_place() {
    let error = |nm: &[f64], values: &[f64]| {
        Spectrum::from_table(nm, values, Outside::Zero).expect_err("no table").to_string()
    };
    assert_eq!(error(&[400.0], &[]), "expected a value for each of 1 wavelengths, found 0 values");
    assert_eq!(error(&[400.0], &[1.0]), "expected at least 2 wavelengths, found 1");
    assert_eq!(
        error(&[400.0, 400.0], &[1.0, 1.0]),
        "expected increasing wavelengths, found 400 nm at index 1 after 400 nm"
    );
    assert_eq!(error(&[400.0, f64::NAN], &[1.0; 2]), "expected a wavelength in nm at index 1, found NaN");
    assert_eq!(error(&[-4.0, 5.0], &[1.0; 2]), "expected a wavelength in nm at index 0, found -4");
    assert_eq!(
        error(&[400.0, 410.0], &[1.0, f64::INFINITY]),
        "expected a finite value at index 1 (410 nm), found inf"
    );
    assert!(Spectrum::from_lines(&[(500.0, f64::NAN)]).is_err());
}

/// Increasing wavelengths with values, away from the grid's ends.
fn table_inside() -> impl Strategy<Value = (Vec<f64>, Vec<f64>)> {
    (310.0..400.0f64, prop::collection::vec((0.01..40.0f64, -1.0..1.0f64), 2..60)).prop_map(
        |(first, steps)| {
            let mut nm = first;
            let mut place = |step: f64| {
                nm += step;
                nm
            };
            steps.into_iter().map(|(step, value)| (place(step), value)).filter(|(nm, _)| *nm < 770.0).unzip()
        },
    )
}

proptest! {
    #[test]
    fn any_table_keeps_its_energy((nm, values) in table_inside()) {
        prop_assume!(nm.len() > 1);
        let s = Spectrum::from_table(&nm, &values, Outside::Zero).expect("a table");
        prop_assert!((s.integral() - trapezoid(&nm, &values)).abs() < 1e-9);
    }

    #[test]
    fn constants_and_ramps_stay_what_they_are(
        (nm, _) in table_inside(), slope in -1.0..1.0f64, level in -1.0..1.0f64,
    ) {
        prop_assume!(nm.len() > 1);
        let ramp = |nm: f64| level + slope * (nm - 540.0) / 240.0;
        let values: Vec<f64> = nm.iter().map(|nm| ramp(*nm)).collect();
        let s = Spectrum::from_table(&nm, &values, Outside::Hold).expect("a table");
        let inside = nm[0] + STEP_NM..=nm[nm.len() - 1] - STEP_NM;
        for (at, value) in s.points().filter(|(at, _)| inside.contains(at)) {
            prop_assert!((value - ramp(at)).abs() < 1e-9, "{value} at {at} nm");
        }
    }

    #[test]
    fn any_numbers_give_a_finite_spectrum_or_an_error(
        points in prop::collection::vec((any::<f64>(), any::<f64>()), 0..6), hold: bool,
    ) {
        let (nm, values): (Vec<f64>, Vec<f64>) = points.iter().copied().unzip();
        let outside = if hold { Outside::Hold } else { Outside::Zero };
        prop_assert!(Spectrum::from_table(&nm, &values, outside).map_or(true, |s| s.is_finite()));
        // Few random numbers are in order: these are.
        let mut sorted: Vec<f64> = nm.iter().map(|nm| nm.abs()).collect();
        sorted.sort_by(f64::total_cmp);
        let small: Vec<f64> = values.iter().map(|value| value.clamp(-1e100, 1e100)).collect();
        prop_assert!(Spectrum::from_table(&sorted, &small, outside).map_or(true, |s| s.is_finite()));
        prop_assert!(Spectrum::from_lines(&points).map_or(true, |s| s.is_finite()));
    }
}
