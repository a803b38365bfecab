//! Published pairs, and CIEDE2000 as it is written with angles.

use proptest::prelude::*;

use super::*;

/// Sharma, Wu, Dalal, "The CIEDE2000 Color-Difference Formula", 2005, table 1: all 34 pairs.
const SHARMA: [([f64; 3], [f64; 3], f64); 34] = [
    ([50.0, 2.6772, -79.7751], [50.0, 0.0, -82.7485], 2.0425),
    ([50.0, 3.1571, -77.2803], [50.0, 0.0, -82.7485], 2.8615),
    ([50.0, 2.8361, -74.02], [50.0, 0.0, -82.7485], 3.4412),
    ([50.0, -1.3802, -84.2814], [50.0, 0.0, -82.7485], 1.0000),
    ([50.0, -1.1848, -84.8006], [50.0, 0.0, -82.7485], 1.0000),
    ([50.0, -0.9009, -85.5211], [50.0, 0.0, -82.7485], 1.0000),
    ([50.0, 0.0, 0.0], [50.0, -1.0, 2.0], 2.3669),
    ([50.0, -1.0, 2.0], [50.0, 0.0, 0.0], 2.3669),
    ([50.0, 2.49, -0.001], [50.0, -2.49, 0.0009], 7.1792),
    ([50.0, 2.49, -0.001], [50.0, -2.49, 0.001], 7.1792),
    ([50.0, 2.49, -0.001], [50.0, -2.49, 0.0011], 7.2195),
    ([50.0, 2.49, -0.001], [50.0, -2.49, 0.0012], 7.2195),
    ([50.0, -0.001, 2.49], [50.0, 0.0009, -2.49], 4.8045),
    ([50.0, -0.001, 2.49], [50.0, 0.001, -2.49], 4.8045),
    ([50.0, -0.001, 2.49], [50.0, 0.0011, -2.49], 4.7461),
    ([50.0, 2.5, 0.0], [50.0, 0.0, -2.5], 4.3065),
    ([50.0, 2.5, 0.0], [73.0, 25.0, -18.0], 27.1492),
    ([50.0, 2.5, 0.0], [61.0, -5.0, 29.0], 22.8977),
    ([50.0, 2.5, 0.0], [56.0, -27.0, -3.0], 31.9030),
    ([50.0, 2.5, 0.0], [58.0, 24.0, 15.0], 19.4535),
    ([50.0, 2.5, 0.0], [50.0, 3.1736, 0.5854], 1.0000),
    ([50.0, 2.5, 0.0], [50.0, 3.2972, 0.0], 1.0000),
    ([50.0, 2.5, 0.0], [50.0, 1.8634, 0.5757], 1.0000),
    ([50.0, 2.5, 0.0], [50.0, 3.2592, 0.335], 1.0000),
    ([60.2574, -34.0099, 36.2677], [60.4626, -34.1751, 39.4387], 1.2644),
    ([63.0109, -31.0961, -5.8663], [62.8187, -29.7946, -4.0864], 1.2630),
    ([61.2901, 3.7196, -5.3901], [61.4292, 2.248, -4.962], 1.8731),
    ([35.0831, -44.1164, 3.7933], [35.0232, -40.0716, 1.5901], 1.8645),
    ([22.7233, 20.0904, -46.694], [23.0331, 14.973, -42.5619], 2.0373),
    ([36.4612, 47.858, 18.3852], [36.2715, 50.5065, 21.2231], 1.4146),
    ([90.8027, -2.0831, 1.441], [91.1528, -1.6435, 0.0447], 1.4441),
    ([90.9257, -0.5406, -0.9208], [88.6381, -0.8985, -0.7239], 1.5381),
    ([6.7747, -0.2908, -2.4247], [5.8714, -0.0985, -2.2286], 0.6377),
    ([2.0776, 0.0795, -1.135], [0.9033, -0.0636, -0.5514], 0.9082),
];

#[test]
fn ciede2000_gives_the_34_pairs_of_sharma_wu_dalal() {
    // Half of the last digit printed, and rounding.
    const PRINTED: f64 = 0.5e-4 + 1e-9;
    for (number, (first, second, expected)) in SHARMA.into_iter().enumerate() {
        for (first, second) in [(first, second), (second, first)] {
            let found = ciede2000(Lab(first), Lab(second));
            assert!((found - expected).abs() < PRINTED, "pair {}: {found}, not {expected}", number + 1);
        }
    }
}

#[test]
fn older_differences_agree_with_colour_science() {
    // colour-science 0.4.7, delta_E_CIE1976 and delta_E_CIE1994 (textiles false and true).
    let (first, second) =
        (Lab([48.99183622, -0.10561667, 400.65619925]), Lab([50.65907324, -0.11671910, 402.82235718]));
    assert!((cie76(first, second) - 2.733_503_745).abs() < 1e-8);
    assert!((cie94(first, second, Cie94::GRAPHIC_ARTS) - 1.671_119_131).abs() < 1e-8);
    assert!((cie94(first, second, Cie94::TEXTILES) - 0.840_467_762).abs() < 1e-8);
    let (white, grey) = (Oklab([1.0, 0.0, 0.0]), Oklab([0.4, 0.3, 0.4]));
    assert!((ok(white, grey) - 0.61_f64.sqrt()).abs() < 1e-15);
}

/// The formula as the paper writes it, with angles in degrees.
fn with_angles([l1, a1, b1]: [f64; 3], [l2, a2, b2]: [f64; 3]) -> f64 {
    let seventh = |c: f64| (c.powi(7) / (c.powi(7) + 25_f64.powi(7))).sqrt();
    let g = 0.5 * (1.0 - seventh((a1.hypot(b1) + a2.hypot(b2)) / 2.0));
    let polar = |a: f64, b: f64| {
        let a = a * (1.0 + g);
        (a.hypot(b), if a == 0.0 && b == 0.0 { 0.0 } else { b.atan2(a).to_degrees().rem_euclid(360.0) })
    };
    let ((c1, h1), (c2, h2)) = (polar(a1, b1), polar(a2, b2));
    let apart = h2 - h1;
    let grey = c1 * c2 == 0.0;
    let delta_h = match apart {
        _ if grey => 0.0,
        _ if apart > 180.0 => apart - 360.0,
        _ if apart < -180.0 => apart + 360.0,
        _ => apart,
    };
    let mean_h = match h1 + h2 {
        sum if grey => sum,
        sum if apart.abs() <= 180.0 => sum / 2.0,
        sum if sum < 360.0 => (sum + 360.0) / 2.0,
        sum => (sum - 360.0) / 2.0,
    };
    let (mean_l, mean_c) = ((l1 + l2) / 2.0, (c1 + c2) / 2.0);
    let cos = |degrees: f64| degrees.to_radians().cos();
    let t = 1.0 - 0.17 * cos(mean_h - 30.0) + 0.24 * cos(2.0 * mean_h) + 0.32 * cos(3.0 * mean_h + 6.0)
        - 0.20 * cos(4.0 * mean_h - 63.0);
    let theta = 30.0 * (-((mean_h - 275.0) / 25.0).powi(2)).exp();
    let square = (mean_l - 50.0).powi(2);
    let l = (l2 - l1) / (1.0 + 0.015 * square / (20.0 + square).sqrt());
    let c = (c2 - c1) / (1.0 + 0.045 * mean_c);
    let h = 2.0 * (c1 * c2).sqrt() * (delta_h / 2.0).to_radians().sin() / (1.0 + 0.015 * mean_c * t);
    let r_t = -2.0 * seventh(mean_c) * (2.0 * theta).to_radians().sin();
    (l * l + c * c + h * h + r_t * c * h).sqrt()
}

fn lab() -> impl Strategy<Value = [f64; 3]> {
    let axis = || prop_oneof![-128.0..128.0_f64, Just(0.0)];
    (0.0..100.0_f64, axis(), axis()).prop_map(|(l, a, b)| [l, a, b])
}

proptest! {
    #[test]
    fn ciede2000_is_the_formula_with_angles(first in lab(), second in lab()) {
        let (found, expected) = (ciede2000(Lab(first), Lab(second)), with_angles(first, second));
        prop_assert!((found - expected).abs() < 1e-9, "{found} is not {expected}");
    }

    #[test]
    fn ciede2000_is_a_number_for_any_numbers(
        first in prop::array::uniform3(-1e150..1e150_f64),
        second in prop::array::uniform3(-1e-150..1e150_f64),
    ) {
        prop_assert!(ciede2000(Lab(first), Lab(second)) >= 0.0);
        prop_assert_eq!(ciede2000(Lab(first), Lab(first)), 0.0);
    }
}
