//! Colour vision without a kind of cones, or with two kinds that are alike.
//!
//! H. Brettel, F. Viénot, J. D. Mollon, "Computerized simulation of color appearance for dichromats", J. Opt. Soc. Am. A 14, 1997,
//! on the cones of this very eye: what a dichromat sees is shown as the colour on two half planes through the white and two
//! wavelengths that dichromats and others see alike. A moved pigment is between: what is left of the difference between the two
//! cones is added to the dichromat's picture.

use glanz_color::{SAMPLES, Spectrum, lambda_nm};

use super::plane::for_each_part_of_three;
use crate::eye::{Cones, Eye};
use crate::screen::cross;

/// What is amiss with the cones.
///
/// ```
/// use glanz_eye::{Defect, Eye};
///
/// assert_eq!(Defect::of(&"protan".parse::<Eye>()?), Some(Defect::Missing(0)));
/// assert_eq!(Defect::of(&"deutan:6".parse::<Eye>()?), Some(Defect::Shifted(1)));
/// assert_eq!(Defect::of(&"age:70".parse::<Eye>()?), None);
/// # Ok::<(), glanz_eye::EyeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Defect {
    /// The cones of this channel (0: L, 1: M, 2: S) are missing.
    Missing(usize),
    /// The pigment of this channel (0 or 1) is moved towards the other's.
    Shifted(usize),
}

impl Defect {
    /// That of an eye; none where it sees all colours.
    pub fn of(eye: &Eye) -> Option<Self> {
        if let Some(channel) = eye.cones.missing() {
            return Some(Self::Missing(channel));
        }
        if eye.cones == Cones::None {
            return None;
        }
        match eye.shift_nm {
            [l, 0.0, 0.0] if l < 0.0 => Some(Self::Shifted(0)),
            [0.0, m, 0.0] if m > 0.0 => Some(Self::Shifted(1)),
            _ => None,
        }
    }

    /// The channel.
    pub fn channel(self) -> usize {
        match self {
            Self::Missing(channel) | Self::Shifted(channel) => channel,
        }
    }
}

/// The map of one pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Projection {
    /// The channel that is replaced.
    channel: usize,
    /// The two channels that are left, those whose quotient decides on the half plane: numerator, denominator.
    numerator: usize,
    denominator: usize,
    /// The quotient's white, as factors of the other side.
    white: [f32; 2],
    /// The channel on either half plane, by numerator and denominator: below the white's quotient, above it.
    planes: [[f32; 2]; 2],
    /// Of a moved pigment: factors of the eye's own channel, of the other cone, and of the projected value.
    left: Option<[f32; 3]>,
}

impl Projection {
    /// For an eye under a white. `usual_white` is the white in the channels of the eye with usual cones, `own_white` in its own;
    /// `scales` what the channels' sensitivities are multiplied by in frames.
    pub(crate) fn new(eye: &Eye, own_white: &[f64], usual_white: &[f64], scales: [f64; 3]) -> Option<Self> {
        let defect = Defect::of(eye)?;
        let channel = defect.channel();
        let usual = eye.with_usual_cones();
        let curves: [Spectrum; 3] = core::array::from_fn(|c| usual.cone(c) * scales[c]);
        let white: [f64; 3] = core::array::from_fn(|c| usual_white[c]);
        // Seen alike by both: 575 and 475 nm without L or M, 660 and 485 nm without S.
        let (numerator, denominator, anchors) = match channel {
            0 => (2, 1, [575.0, 475.0]),
            1 => (2, 0, [575.0, 475.0]),
            _ => (1, 0, [660.0, 485.0]),
        };
        let planes = anchors.map(|nm| {
            let anchor: [f64; 3] = core::array::from_fn(|c| curves[c].at(nm));
            let normal = cross(white, anchor);
            [numerator, denominator].map(|c| (-normal[c] / normal[channel]) as f32)
        });
        let left = match defect {
            Defect::Missing(_) => None,
            Defect::Shifted(_) => {
                let other = 1 - channel;
                let moved = eye.cone(channel) * scales[channel];
                let part = part_left(&moved, &curves, channel, other, own_white[channel], white);
                // L_w · (L′/L′_w − M/M_w − k (L_B/L_w − M/M_w)), and L_B itself; all times L′_w/L_w, so that white
                // stays what it is to this eye.
                let by_other = (part - 1.0) * own_white[channel] / white[other];
                let by_projected = (1.0 - part) * own_white[channel] / white[channel];
                Some([1.0, by_other as f32, by_projected as f32])
            }
        };
        let white = [white[numerator] as f32, white[denominator] as f32];
        Some(Self { channel, numerator, denominator, white, planes, left })
    }

    /// Replaces the channel of all pixels by what is shown for it.
    pub(crate) fn apply(&self, channels: &mut [Vec<f32>; 3]) {
        for_each_part_of_three(channels, |parts| {
            for i in 0..parts[0].len() {
                let pixel: [f32; 3] = core::array::from_fn(|c| parts[c][i]);
                parts[self.channel][i] = self.shown(pixel);
            }
        });
    }

    /// What is shown for one pixel.
    #[inline(always)]
    fn shown(&self, pixel: [f32; 3]) -> f32 {
        let (numerator, denominator) = (pixel[self.numerator], pixel[self.denominator]);
        let above = numerator * self.white[1] > denominator * self.white[0];
        let [by_numerator, by_denominator] = self.planes[usize::from(above)];
        let projected = by_numerator * numerator + by_denominator * denominator;
        match self.left {
            None => projected,
            Some([by_own, by_other, by_projected]) => {
                let (own, other) = (pixel[self.channel], pixel[usize::from(self.channel == 0)]);
                by_own * own + by_other * other + by_projected * projected
            }
        }
    }
}

/// How much of the difference between two cones is left when one's pigment is moved, over 400 to 700 nm of equal energy: by least
/// squares.
fn part_left(
    moved: &Spectrum,
    curves: &[Spectrum; 3],
    channel: usize,
    other: usize,
    own_white: f64,
    white: [f64; 3],
) -> f64 {
    let (mut product, mut square) = (0.0, 0.0);
    for i in (0..SAMPLES).filter(|i| (400.0..=700.0).contains(&lambda_nm(*i))) {
        let by_other = curves[other].0[i] / white[other];
        let whole = curves[channel].0[i] / white[channel] - by_other;
        let left = moved.0[i] / own_white - by_other;
        product += left * whole;
        square += whole * whole;
    }
    product / square
}

#[cfg(test)]
mod tests {
    use glanz_color::{colorchecker, light};

    use super::*;

    fn d65() -> Spectrum {
        light("D65").unwrap()
    }

    fn white(eye: &Eye) -> Vec<f64> {
        (0..3).map(|c| eye.cone(c).dot(&d65())).collect()
    }

    fn projection(name: &str) -> (Projection, Vec<f64>, Eye) {
        let eye: Eye = name.parse().unwrap();
        let usual = white(&eye.with_usual_cones());
        (Projection::new(&eye, &white(&eye), &usual, [1.0; 3]).unwrap(), usual, eye)
    }

    /// What is shown of a spectrum, over the white of the usual eye.
    fn shown(name: &str, spectrum: &Spectrum) -> [f64; 3] {
        let (projection, white, eye) = projection(name);
        let mut planes: [Vec<f32>; 3] = core::array::from_fn(|c| vec![eye.cone(c).dot(spectrum) as f32]);
        projection.apply(&mut planes);
        let own = self::white(&eye);
        core::array::from_fn(|c| {
            f64::from(planes[c][0]) / if eye.shift_nm[c] == 0.0 { white[c] } else { own[c] }
        })
    }

    fn red() -> Spectrum {
        colorchecker().find(|(name, _)| *name == "red").unwrap().1 * d65()
    }

    #[test]
    fn the_red_patch_is_projected_as_computed_elsewhere() {
        for (name, channel, expected) in
            [("protan", 0, 0.07553), ("deutan", 1, 0.13069), ("tritan", 2, 0.06481)]
        {
            let found = shown(name, &red())[channel];
            assert!((found - expected).abs() < 2e-5, "{name}: {found}");
        }
    }

    #[test]
    fn what_is_left_of_the_difference_is_as_computed_elsewhere() {
        for (shift, expected) in [(10, 0.6748), (20, 0.3360)] {
            let (projection, usual, eye) = projection(&format!("protan:{shift}"));
            let part = 1.0 - f64::from(projection.left.unwrap()[2]) * usual[0] / white(&eye)[0];
            assert!((part - expected).abs() < 1e-4, "{shift} nm: {part}");
        }
    }

    #[test]
    fn without_a_shift_nothing_changes_and_with_more_it_nears_the_dichromat() {
        let usual: Vec<f64> = white(&Eye::default());
        let seen: [f64; 3] = core::array::from_fn(|c| Eye::default().cone(c).dot(&red()) / usual[c]);
        for (kind, channel) in [("protan", 0), ("deutan", 1)] {
            let end = shown(kind, &red())[channel];
            let tiny = shown(&format!("{kind}:0.001"), &red())[channel];
            assert!((tiny - seen[channel]).abs() < 1e-4, "{kind}: {tiny} for {}", seen[channel]);
            let mut last = (seen[channel] - end).abs();
            for shift in [5, 10, 15, 20] {
                let next = (shown(&format!("{kind}:{shift}"), &red())[channel] - end).abs();
                assert!(next < last, "{kind}:{shift}");
                last = next;
            }
        }
    }

    #[test]
    fn white_and_the_anchors_stay_and_the_missing_cone_tells_nothing() {
        for (name, channel, anchors) in
            [("protan", 0, [475.0, 575.0]), ("deutan", 1, [475.0, 575.0]), ("tritan", 2, [485.0, 660.0])]
        {
            let (projection, white, eye) = projection(name);
            for spectrum in [d65(), line(anchors[0]), line(anchors[1])] {
                let seen = eye.cone(channel).dot(&spectrum) / white[channel];
                let found = shown(name, &spectrum)[channel];
                assert!((found - seen).abs() < 1e-5 * (1.0 + seen), "{name}: {found} for {seen}");
            }
            let mut a: [Vec<f32>; 3] = [vec![0.3], vec![0.2], vec![0.4]];
            let mut b = a.clone();
            b[channel][0] = 0.9;
            projection.apply(&mut a);
            projection.apply(&mut b);
            assert_eq!(a, b, "{name}");
        }
    }

    fn line(nm: f64) -> Spectrum {
        Spectrum::from_fn(|at| f64::from(u8::from((at - nm).abs() < 1.0)))
    }
}
