//! What a fit makes small.

use glanz_math::{SimdLevel, at_level};

/// What is made as small as possible: the squares of differences of g(f cosθi).
///
/// ```
/// use glanz_measure::Metric;
///
/// assert_eq!(Metric::named("log"), Some(Metric::Log));
/// assert_eq!(Metric::default().name(), "cube-root");
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Metric {
    /// g(x) = x: the peaks of highlights count most.
    L2,
    /// g(x) = ln(1 + x).
    Log,
    /// g(x) = ∛x, which is nearest to what people see (A. Fores and others 2012).
    #[default]
    CubeRoot,
    /// g(x) = L*(π x) / 100, the lightness of CIELAB of each channel, where a perfect diffuser lit along its normal is white: the
    /// cube root, but a line below a reflectance of 0.9 %, so that dark parts with their noise count for less. It is no
    /// difference of colours.
    Lightness,
    /// CIEDE2000 of the colours of reading and fit, as points of a sphere under one lamp: π x is what is seen, exposed so that
    /// a perfect diffuser that faces the lamp is white, Y = 100 under D65, for the CIE 1931 observer. It is of all channels
    /// together, so tints have no closed form: widths and tints are searched at once, from the best fit by lightness. What two
    /// spectra of one colour differ by stays as the lightness has it. Of one number alone it is the lightness, which
    /// [`Self::of`] gives.
    Rendered,
}

impl Metric {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::L2, Self::Log, Self::CubeRoot, Self::Lightness, Self::Rendered];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::L2 => "l2",
            Self::Log => "log",
            Self::CubeRoot => "cube-root",
            Self::Lightness => "lightness",
            Self::Rendered => "rendered",
        }
    }

    /// The one of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|metric| metric.name() == name)
    }

    /// g(x); below 0 that of 0.
    pub fn of(self, x: f64) -> f64 {
        let mut values = [x];
        self.apply(&mut values);
        values[0]
    }

    /// Puts g(x) in the place of every x.
    pub(super) fn apply(self, values: &mut [f64]) {
        at_level!(SimdLevel::best(), _simd => match self {
            Self::L2 => apply::<Linear>(values),
            Self::Log => apply::<Logarithm>(values),
            Self::CubeRoot => apply::<CubeRoot>(values),
            Self::Lightness | Self::Rendered => apply::<Lightness>(values),
        });
    }
}

#[inline(always)]
fn apply<C: Curve>(values: &mut [f64]) {
    values.iter_mut().for_each(
        #[inline(always)]
        |x| *x = C::of(x.max(0.0)),
    );
}

/// The function g of a metric, without branches, so that loops over it become vector instructions.
pub(super) trait Curve {
    /// g(x) for x of 0 and above.
    fn of(x: f64) -> f64;
    /// g'(x), where g(x) is known.
    fn slope(x: f64, value: f64) -> f64;
}

/// [`Metric::L2`].
pub(super) struct Linear;

impl Curve for Linear {
    #[inline(always)]
    fn of(x: f64) -> f64 {
        x
    }
    #[inline(always)]
    fn slope(_: f64, _: f64) -> f64 {
        1.0
    }
}

/// [`Metric::Log`].
pub(super) struct Logarithm;

impl Curve for Logarithm {
    /// The series of artanh: ln a = 2 (s + s³/3 + s⁵/5 + …), s = (a − 1)/(a + 1), for a between √½ and √2, where 10 terms
    /// leave less than 1e-16.
    #[inline(always)]
    fn of(x: f64) -> f64 {
        // What puts the mantissa between √½ and √2, so that the exponent is rounded.
        const SQRT_HALF: u64 = 0x3fe6_a09e_667f_3bcd;
        let bits = (1.0 + x).to_bits();
        let exponent = (bits.wrapping_sub(SQRT_HALF) as i64) >> 52;
        let mantissa = f64::from_bits(bits.wrapping_sub((exponent << 52) as u64));
        let s = (mantissa - 1.0) / (mantissa + 1.0);
        let square = s * s;
        let mut sum = 1.0 / 19.0;
        for n in [17.0, 15.0, 13.0, 11.0, 9.0, 7.0, 5.0, 3.0, 1.0] {
            sum = sum * square + 1.0 / n;
        }
        exponent as f64 * core::f64::consts::LN_2 + 2.0 * s * sum
    }
    #[inline(always)]
    fn slope(x: f64, _: f64) -> f64 {
        1.0 / (1.0 + x)
    }
}

/// [`Metric::CubeRoot`].
pub(super) struct CubeRoot;

impl Curve for CubeRoot {
    /// A third of the exponent, and two steps of Halley's rule, each of which triples the digits: within 1e-13. Numbers below
    /// 1e-30 count as this.
    #[inline(always)]
    fn of(x: f64) -> f64 {
        // A third of the exponent's offset, less what makes the greatest error least (as in FreeBSD's cbrtf).
        const OFFSET: u32 = 709_958_130;
        let x = x.max(1e-30);
        let mut root = f64::from(f32::from_bits((x as f32).to_bits() / 3 + OFFSET));
        for _ in 0..2 {
            let cube = root * root * root;
            root *= (x + x + cube) / (x + cube + cube);
        }
        root
    }
    #[inline(always)]
    fn slope(_: f64, value: f64) -> f64 {
        1.0 / (3.0 * value * value)
    }
}

/// [`Metric::Lightness`].
pub(super) struct Lightness;

impl Lightness {
    /// CIE 15: below (6/29)³ a line goes on from the cube root.
    const TOE: f64 = 216.0 / 24_389.0;
    const TOE_SLOPE: f64 = 24_389.0 / 2700.0;
}

impl Curve for Lightness {
    #[inline(always)]
    fn of(x: f64) -> f64 {
        let reflectance = x * core::f64::consts::PI;
        let root = 1.16 * CubeRoot::of(reflectance) - 0.16;
        if reflectance > Self::TOE { root } else { Self::TOE_SLOPE * reflectance }
    }
    #[inline(always)]
    fn slope(x: f64, value: f64) -> f64 {
        let root = (value + 0.16) / 1.16;
        let slope =
            if x * core::f64::consts::PI > Self::TOE { 1.16 / (3.0 * root * root) } else { Self::TOE_SLOPE };
        slope * core::f64::consts::PI
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn curves_are_the_functions_that_they_approximate() {
        for i in 0..4000 {
            let x = libm::exp2(-60.0 + 0.025 * f64::from(i));
            let root = libm::cbrt(x);
            assert!((CubeRoot::of(x) / root - 1.0).abs() < 1e-13, "{x}: {} for {root}", CubeRoot::of(x));
            // Of small numbers the sum with 1 keeps no more digits.
            let log = libm::log1p(x);
            assert!((Logarithm::of(x) - log).abs() < 3e-16 * (1.0 + log), "{x}: {}", Logarithm::of(x));
        }
        assert!(CubeRoot::of(0.0) < 2e-10 && Logarithm::of(0.0) == 0.0);
        // White, middle gray (CIE 15: L* = 50 at 18.42 %) and both sides of the toe's end, L* = 8.
        for (reflectance, lightness) in [(1.0, 1.0), (0.184187, 0.5), (0.008856, 0.08), (0.008857, 0.08)] {
            let got = Lightness::of(reflectance / core::f64::consts::PI);
            assert!((got - lightness).abs() < 1e-5, "{reflectance}: {got}");
        }
    }

    #[test]
    fn slopes_are_those_of_the_curves() {
        fn check<C: Curve>(x: f64) {
            let step = 1e-6 * x;
            let secant = (C::of(x + step) - C::of(x - step)) / (2.0 * step);
            assert!((C::slope(x, C::of(x)) / secant - 1.0).abs() < 1e-6);
        }
        for x in [1e-3, 1e-2, 0.3, 1.0, 40.0] {
            check::<Linear>(x);
            check::<Logarithm>(x);
            check::<CubeRoot>(x);
            check::<Lightness>(x);
        }
    }
}
