//! What a matte surface gets from an environment, as a polynomial of its normal.
//!
//! The clamped cosine keeps of the spherical harmonics those of degree 0, 1, and even ones, and
//! little beyond degree 4. Source: R. Ramamoorthi and P. Hanrahan, "An Efficient Representation for
//! Irradiance Environment Maps", SIGGRAPH 2001 (degree 2); here degree 4 too.

use glanz_math::{Real, Vec3};

/// Harmonics of degree 0, 1, 2 and 4.
pub const IRRADIANCE_TERMS: usize = 1 + 3 + 5 + 9;

/// The irradiance over π: 1 in a uniform environment of 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Irradiance {
    /// By harmonics, their constants and what the cosine keeps included.
    pub terms: [[f32; 3]; IRRADIANCE_TERMS],
}

impl Irradiance {
    /// That of a uniform environment of 1.
    pub fn uniform() -> Self {
        let mut terms = [[0.0; 3]; IRRADIANCE_TERMS];
        terms[0] = [1.0; 3];
        Self { terms }
    }

    /// That of a surface with this unit normal.
    #[inline(always)]
    pub fn at<R: Real>(&self, normal: Vec3<R>) -> [R; 3] {
        let zero = normal.x.zero();
        let mut sum = [zero; 3];
        for (y, term) in harmonics(normal).into_iter().zip(&self.terms) {
            for c in 0..3 {
                sum[c] = sum[c] + y * zero.lit(f64::from(term[c]));
            }
        }
        // A short series rings below zero where one side is very bright.
        let [r, g, b] = sum;
        [r.max(zero), g.max(zero), b.max(zero)]
    }
}

/// The harmonics of degree 0, 1, 2 and 4 of a unit vector without their constants, z being the pole.
#[inline(always)]
pub(crate) fn harmonics<R: Real>(d: Vec3<R>) -> [R; IRRADIANCE_TERMS] {
    let Vec3 { x, y, z } = d;
    let one = x.one();
    let lit = |value: f64| one.lit(value);
    let (x2, y2, z2) = (x.sqr(), y.sqr(), z.sqr());
    let (difference, seven) = (x2 - y2, lit(7.0) * z2);
    [
        one,
        y,
        z,
        x,
        x * y,
        y * z,
        lit(3.0) * z2 - one,
        x * z,
        difference,
        x * y * difference,
        y * z * (lit(3.0) * x2 - y2),
        x * y * (seven - one),
        y * z * (seven - lit(3.0)),
        lit(35.0) * z2.sqr() - lit(30.0) * z2 + lit(3.0),
        x * z * (seven - lit(3.0)),
        difference * (seven - one),
        x * z * (x2 - lit(3.0) * y2),
        x2 * (x2 - lit(3.0) * y2) - y2 * (lit(3.0) * x2 - y2),
    ]
}
