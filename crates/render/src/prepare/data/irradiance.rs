//! What a matte surface gets from an environment, as a polynomial of its normal.
//!
//! The clamped cosine keeps of the spherical harmonics those of degree 0, 1, and even ones, and
//! little beyond degree 6. Source: R. Ramamoorthi and P. Hanrahan, "An Efficient Representation for
//! Irradiance Environment Maps", SIGGRAPH 2001 (degree 2); here 4 and 6 too.

use glanz_math::{Real, Vec3};

/// Harmonics of degree 0, 1, 2, 4 and 6.
pub const IRRADIANCE_TERMS: usize = 1 + 3 + 5 + 9 + 13;

/// The last degree that is kept.
pub(crate) const LAST_DEGREE: usize = 6;

/// The irradiance over π: 1 in a uniform environment of 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Irradiance {
    /// By harmonics, their constants and what the cosine keeps included.
    pub terms: Box<[[f32; 3]; IRRADIANCE_TERMS]>,
}

impl Irradiance {
    /// That of a uniform environment of 1.
    pub fn uniform() -> Self {
        let mut terms = Box::new([[0.0; 3]; IRRADIANCE_TERMS]);
        terms[0] = [1.0; 3];
        Self { terms }
    }

    /// That of a surface with this unit normal.
    #[inline(always)]
    pub fn at<R: Real>(&self, normal: Vec3<R>) -> [R; 3] {
        let zero = normal.x.zero();
        let mut sum = [zero; 3];
        for (y, term) in harmonics(normal).into_iter().zip(self.terms.iter()) {
            for c in 0..3 {
                sum[c] = sum[c] + y * zero.lit(f64::from(term[c]));
            }
        }
        // A short series rings below zero where one side is very bright.
        let [r, g, b] = sum;
        [r.max(zero), g.max(zero), b.max(zero)]
    }
}

/// The harmonics of the degrees kept of a unit vector without their constants, y being the pole as it is of maps: of
/// each degree those with the sine of an azimuth, from the greatest order, the zonal one, and those with the cosine.
#[inline(always)]
pub(crate) fn harmonics<R: Real>(d: Vec3<R>) -> [R; IRRADIANCE_TERMS] {
    let [x, y, z] = [d.z, d.x, d.y];
    let (zero, one) = (x.zero(), x.one());
    let mut terms = [zero; IRRADIANCE_TERMS];
    // Sine and cosine of m times the azimuth, times the m-th power of the sine to the pole.
    let (mut sine, mut cosine) = (zero, one);
    let mut double_factorial = 1.0;
    for m in 0..=LAST_DEGREE {
        let (mut before, mut own) = (zero, one.lit(double_factorial));
        for l in m..=LAST_DEGREE {
            if l > m {
                let (of_l, of_m) = (l as f64, m as f64);
                let next = z * own * one.lit((2.0 * of_l - 1.0) / (of_l - of_m))
                    - before * one.lit((of_l + of_m - 1.0) / (of_l - of_m));
                (before, own) = (own, next);
            }
            if let Some(first) = first_of(l) {
                terms[first + l + m] = own * cosine;
                if m > 0 {
                    terms[first + l - m] = own * sine;
                }
            }
        }
        (sine, cosine) = (sine * x + cosine * y, cosine * x - sine * y);
        double_factorial *= 2.0 * m as f64 + 1.0;
    }
    terms
}

/// The number of the first harmonic of a degree; none of degrees that the cosine does not keep.
#[inline(always)]
pub(crate) const fn first_of(degree: usize) -> Option<usize> {
    match degree {
        0 => Some(0),
        1 => Some(1),
        2 => Some(4),
        4 => Some(9),
        6 => Some(18),
        _ => None,
    }
}
