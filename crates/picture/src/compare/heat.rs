//! Colours for errors: from black over purple and orange to pale yellow.

/// Colours at equal steps, in sRGB codes: every fifteenth entry of the colour map "magma" of N. Smith and
/// S. van der Walt (2015, released under CC0), as in matplotlib 3.11. Straight lines between them stay
/// within 3 codes of its 256 entries.
const STEPS: [[u8; 3]; 18] = [
    [0, 0, 4],
    [9, 7, 32],
    [26, 16, 66],
    [49, 17, 101],
    [74, 16, 121],
    [98, 25, 128],
    [121, 34, 130],
    [145, 43, 129],
    [170, 51, 125],
    [194, 59, 117],
    [217, 70, 107],
    [236, 88, 96],
    [247, 114, 92],
    [252, 142, 100],
    [254, 170, 116],
    [254, 198, 138],
    [253, 226, 163],
    [252, 253, 191],
];

/// The colour of a part of the scale, in sRGB codes; what lies outside of 0 … 1 has the colour of its end.
pub fn heat_color(part: f32) -> [u8; 3] {
    let part = if part.is_nan() { 1.0 } else { part.clamp(0.0, 1.0) };
    let place = part * (STEPS.len() - 1) as f32;
    let below = (place as usize).min(STEPS.len() - 2);
    let along = place - below as f32;
    core::array::from_fn(|channel| {
        let (low, high) = (f32::from(STEPS[below][channel]), f32::from(STEPS[below + 1][channel]));
        (low + along * (high - low) + 0.5) as u8
    })
}

/// The map of errors as straight RGBA codes; `top` has the brightest colour.
pub fn heat_colors(map: &[f32], top: f64) -> Vec<u8> {
    let scale = if top > 0.0 { (1.0 / top) as f32 } else { 0.0 };
    map.iter()
        .flat_map(|error| {
            let [r, g, b] = heat_color(error * scale);
            [r, g, b, u8::MAX]
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ends_of_the_scale_hold_what_is_beyond_them() {
        let (first, last) = (STEPS[0], STEPS[17]);
        let cases = [(0.0, first), (-1.0, first), (1.0, last), (7.0, last), (f32::NAN, last)];
        for (part, expected) in cases {
            assert_eq!(heat_color(part), expected, "{part}");
        }
        assert_eq!(heat_color(0.5 / 17.0), [5, 4, 18]);
    }

    #[test]
    fn more_error_is_brighter() {
        let brightness = |part: f32| {
            let [r, g, b] = heat_color(part).map(f32::from);
            0.2126 * r + 0.7152 * g + 0.0722 * b
        };
        assert!((0..100).all(|i| brightness(i as f32 / 100.0) < brightness((i + 1) as f32 / 100.0)));
    }

    #[test]
    fn a_map_without_errors_is_dark() {
        assert_eq!(heat_colors(&[0.0, 0.0], 0.0), [0, 0, 4, 255, 0, 0, 4, 255]);
        assert_eq!(heat_colors(&[2.0], 4.0)[..3], heat_color(0.5));
    }
}
