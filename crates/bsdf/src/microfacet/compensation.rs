//! Multiple-scattering compensation (Kulla and Conty 2017): a reciprocal lobe with the energy that single reflections lack.
//!
//! (1 − E(wo)) (1 − E(wi)) cosθi / (π (1 − Eavg)) has the albedo 1 − E(wo): C. Kulla and A. Conty, Revisiting Physically
//! Based Shading at Imageworks, SIGGRAPH course, 2017, after C. Kelemen and L. Szirmay-Kalos 2001.
//!
//! Here 1 − E is the series x Σ pₖ (1 − x)ᵏ, or x Σ pₖ (½ − x)ᵏ, with x = cosθ / (cosθ + c α), c a constant near 2: in x,
//! and not in cosθ, surfaces of all widths are alike, since 1 − E is greatest at cosines about α. On an anisotropic
//! surface α is the width along the direction, and p has a part that goes with the cosine of twice the azimuth. The series
//! lies below 1 − E rather than above it, so that no energy is made.

use core::marker::PhantomData;

use glanz_math::{GaussLegendre, PI, Real};

use super::{Distribution, smith_albedo};
use crate::DirectionPair;

/// Terms of the series.
const TERMS: usize = 7;

/// pₖ of an isotropic GGX surface as polynomials in α, 0.001 … 1, lowest power first.
///
/// By linear programming: the greatest distance to [`smith_albedo`] on 25 widths and 40 cosines is the least
/// possible for coefficients up to 60 whose sum is never above and never below 0.3 of 1 − E. It is 0.0041.
/// `tests/python/fit_ggx.py` finds them again, the tests here what they are worth.
const GGX: [[f64; 6]; TERMS] = [
    [-7.3287927e-08, -0.000253404659, -2.14054226, -0.319312619, 5.85471844, -3.57643332],
    [-6.24737662e-05, 1.33244929, 7.45090315, 35.441814, -60.0, 23.1072418],
    [0.0132322842, -2.52562619, 4.02259811, -60.0, 59.4590532, -5.63388137],
    [0.0269279474, -4.20427331, -40.8543623, -13.7401741, 60.0, -60.0],
    [9.00209102, 32.5369887, 60.0, 60.0, -30.2694241, 40.9445698],
    [-16.2354059, -60.0, -0.651039119, -60.0, -60.0, 13.1108136],
    [7.55169252, 33.1832102, -21.132786, 32.2616261, 26.8632417, -8.43317318],
];

/// The c of [`GGX`], a polynomial in α.
const GGX_CENTER: [f64; 2] = [1.8, -1.3];

/// (1 − Eavg) / α² of the series with [`GGX`], a polynomial in √α: at most 0.7 % too great, never too small. For widths that only the pixel knows.
const GGX_AVERAGE: [f64; 5] = [5.205616, -9.513936, 6.237659, -0.700107, -0.640273];

/// The c of series that are fitted to one surface.
const CENTER: f64 = 2.0;

/// What a fitted series is moved down by beside its own error: the error of [`smith_albedo`].
const MARGIN: f64 = 5e-4;

/// Holds down coefficients that the fitted values hardly tell apart: to some hundreds, so that a sum in `f32` is
/// exact to 1e-5.
const RIDGE: f64 = 1e-10;

/// The lobe of a surface with this distribution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Compensation<D> {
    alpha: (f64, f64),
    /// c α where the width along the direction is α; the width itself is a factor where it is not everywhere the same.
    center: f64,
    /// What is taken off 1 − x before its powers: 0 keeps all digits where 1 − E is small, ½ keeps coefficients small.
    origin: f64,
    /// pₖ, and what goes with the cosine of twice the azimuth.
    series: [[f64; TERMS]; 2],
    /// What is taken off the series.
    less: f64,
    /// weight / (π (1 − Eavg)).
    scale: f64,
    weight: f64,
    distribution: PhantomData<D>,
}

impl<D: Distribution> Compensation<D> {
    /// The lobe times `weight` for a surface of the two widths, 0.001 … 1.
    ///
    /// A series is known for GGX surfaces of one width; for others one is fitted, which takes a millisecond, and
    /// ten where the widths differ.
    pub(super) fn new(alpha: (f64, f64), weight: f64) -> Self {
        let none = Self {
            alpha,
            center: 1.0,
            origin: 0.0,
            series: [[0.0; TERMS]; 2],
            less: 0.0,
            scale: 0.0,
            weight,
            distribution: PhantomData,
        };
        if weight == 0.0 {
            return none;
        }
        let mut lobe = none;
        if D::TABULATED && alpha.0 == alpha.1 {
            lobe.center = (GGX_CENTER[0] + GGX_CENTER[1] * alpha.0) * alpha.0;
            lobe.series[0] = GGX.map(|row| polynomial(&row, alpha.0));
        } else {
            lobe.center = if lobe.is_isotropic() { CENTER * alpha.0 } else { CENTER };
            lobe.origin = 0.5;
            lobe.fit();
        }
        let average = lobe.average();
        lobe.scale = if average > 0.0 { weight / (PI * average) } else { 0.0 };
        lobe
    }

    fn is_isotropic(&self) -> bool {
        self.alpha.0 == self.alpha.1
    }

    /// What `compensation.wgsl` reads, which is for GGX surfaces.
    pub(super) fn numbers(&self) -> Vec<f32> {
        let (x, y) = self.alpha;
        let isotropic = f64::from(u8::from(self.is_isotropic()));
        let mut numbers = vec![isotropic, self.center, self.origin, self.less, self.scale, self.weight / PI];
        numbers.extend([x * x, y * y, libm::sqrt(x * y)]);
        numbers.extend(self.series.as_flattened());
        numbers.into_iter().map(|number| number as f32).collect()
    }

    /// The lobe's `f_cos`, for light and viewer above. The pair's `alpha_scale` multiplies the widths where the distribution
    /// reads it, to a product of 0.001 at least.
    #[inline(always)]
    pub(super) fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        let known = self.at(pair.cos_o, pair.tangent_o) * self.at(pair.cos_i, pair.tangent_i);
        let known = known * pair.cos_i * pair.cos_i.lit(self.scale);
        match D::alpha_scale(pair) {
            Some(w) if R::any(w.lt(w.one())) => self.widened(pair, w).select(w.lt(w.one()), known),
            _ => known,
        }
    }

    /// 1 − E towards one direction.
    #[inline(always)]
    fn at<R: Real>(&self, cosine: R, tangent: (R, R)) -> R {
        let cosine = cosine.max(cosine.zero());
        if self.is_isotropic() {
            let center = cosine.lit(self.center);
            let q = cosine.one() / (cosine + center);
            let sum = series(
                #[inline(always)]
                |k| cosine.lit(self.series[0][k]),
                center * q - cosine.lit(self.origin),
            );
            return (cosine * q * sum - cosine.lit(self.less)).max(cosine.zero());
        }
        let (width, twice) = self.along(tangent);
        let center = cosine.lit(self.center) * width;
        let q = cosine.one() / (cosine + center);
        let sum = series(
            #[inline(always)]
            |k| cosine.lit(self.series[0][k]) + twice * cosine.lit(self.series[1][k]),
            center * q - cosine.lit(self.origin),
        );
        (cosine * q * sum - cosine.lit(self.less)).max(cosine.zero())
    }

    /// The width along a direction, and the cosine of twice its azimuth.
    #[inline(always)]
    fn along<R: Real>(&self, (x, y): (R, R)) -> (R, R) {
        // Along the normal there is no azimuth: the floor makes it a mean of both axes.
        let (x2, y2) = (x.sqr() + x.lit(1e-12), y.sqr() + y.lit(1e-12));
        let q = x.one() / (x2 + y2);
        let squares = (self.alpha.0 * self.alpha.0, self.alpha.1 * self.alpha.1);
        let width = ((x2 * x.lit(squares.0) + y2 * x.lit(squares.1)) * q).sqrt();
        (width, (x2 - y2) * q)
    }

    /// The `f_cos` of a GGX surface whose widths are multiplied by `w`; an anisotropic one is taken as one of the
    /// geometric mean of its widths with the cosines stretched, which is a few parts in a hundred off.
    #[inline(always)]
    fn widened<R: Real>(&self, pair: &DirectionPair<R>, w: R) -> R {
        let mean = (w * w.lit(libm::sqrt(self.alpha.0 * self.alpha.1))).clamp(1e-3, 1.0);
        let c = mean.lit(GGX_CENTER[0]) + mean.lit(GGX_CENTER[1]) * mean;
        let mut terms = [w; TERMS];
        for (term, row) in terms.iter_mut().zip(&GGX) {
            *term = polynomial_of(row, mean);
        }
        let average = polynomial_of(&GGX_AVERAGE, mean.sqrt()) * mean.sqr();
        let (mut both, center) = (w.one(), (c, w, mean));
        for (cosine, tangent) in [(pair.cos_o, pair.tangent_o), (pair.cos_i, pair.tangent_i)] {
            both = both * self.widened_at(&terms, center, cosine, tangent);
        }
        both * pair.cos_i * pair.cos_i.lit(self.weight / PI) / average
    }

    /// 1 − E towards one direction, with c, the alpha_scale and the mean width.
    #[inline(always)]
    fn widened_at<R: Real>(
        &self,
        terms: &[R; TERMS],
        (c, w, mean): (R, R, R),
        cosine: R,
        tangent: (R, R),
    ) -> R {
        let cosine = cosine.max(cosine.zero());
        let width = if self.is_isotropic() { mean } else { self.along(tangent).0 * w };
        let center = c * width.max(w.lit(1e-3));
        let q = cosine.one() / (cosine + center);
        let sum = series(
            #[inline(always)]
            |k| terms[k],
            center * q,
        );
        (cosine * q * sum).max(cosine.zero())
    }

    /// 1 − Eavg: twice the mean over all azimuths of ∫ (1 − E) cosθ dcosθ.
    fn average(&self) -> f64 {
        let rule = GaussLegendre::new(8);
        let azimuths = if self.is_isotropic() { 1 } else { 16 };
        let mean = |cosine: f64| {
            let sine = libm::sqrt(1.0 - cosine * cosine);
            let ring = (0..azimuths).map(|i| {
                let (y, x) = libm::sincos((f64::from(i) + 0.5) * PI / 2.0 / f64::from(azimuths));
                self.at(cosine, (sine * x, sine * y))
            });
            2.0 * cosine * ring.sum::<f64>() / f64::from(azimuths)
        };
        // Cells that double from half the least width on.
        let mut borders = vec![0.0, 0.5 * self.alpha.0.min(self.alpha.1)];
        while borders[borders.len() - 1] < 1.0 {
            borders.push((2.0 * borders[borders.len() - 1]).min(1.0));
        }
        borders.windows(2).map(|cell| rule.integrate(cell[0], cell[1], mean)).sum()
    }

    /// Least squares over cosines spread as the zeros of a Chebyshev polynomial in x, then moved below 1 − E everywhere.
    fn fit(&mut self) {
        let (cosines, azimuths, parts) = if self.is_isotropic() { (20, 1, 1) } else { (12, 7, 2) };
        let mut rows: Vec<Row> = Vec::new();
        let mut points = Vec::new();
        for j in 0..azimuths {
            let azimuth = f64::from(j) / 6.0 * PI / 2.0;
            let (sin, cos) = libm::sincos(azimuth);
            let (width, twice) = self.along((cos, sin));
            let center = if self.is_isotropic() { self.center } else { self.center * width };
            for i in 0..cosines {
                let t = 0.5 - 0.5 * libm::cos((f64::from(i) + 0.5) * PI / f64::from(cosines));
                let x = t / (1.0 + center);
                let cosine = center * x / (1.0 - x);
                let sine = libm::sqrt(1.0 - cosine * cosine);
                points.push((cosine, (sine * cos, sine * sin)));
                let factors = [1.0, twice];
                let row =
                    factors[..parts].iter().flat_map(|f| (0..TERMS).map(move |k| f * x * power(0.5 - x, k)));
                rows.push((row.collect(), 1.0 - smith_albedo::<D>(self.alpha, cosine, azimuth)));
            }
        }
        for (k, value) in least_squares(&rows).into_iter().enumerate() {
            self.series[k / TERMS][k % TERMS] = value;
        }
        let above = points.iter().zip(&rows).map(|((c, t), (_, missing))| self.at(*c, *t) - missing.max(0.0));
        self.less = above.fold(0.0, f64::max) + MARGIN;
    }
}

/// What the coefficients are multiplied with, and the sum that they should come to.
type Row = (Vec<f64>, f64);

/// x to a small power.
fn power(x: f64, k: usize) -> f64 {
    (0..k).fold(1.0, |product, _| product * x)
}

fn polynomial(coefficients: &[f64], x: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c)
}

#[inline(always)]
fn polynomial_of<R: Real, const N: usize>(coefficients: &[f64; N], x: R) -> R {
    let mut sum = x.lit(coefficients[N - 1]);
    for c in coefficients[..N - 1].iter().rev() {
        sum = sum * x + x.lit(*c);
    }
    sum
}

/// Σ pₖ yᵏ.
#[inline(always)]
fn series<R: Real>(term: impl Fn(usize) -> R, y: R) -> R {
    let mut sum = term(TERMS - 1);
    for k in (0..TERMS - 1).rev() {
        sum = sum * y + term(k);
    }
    sum
}

/// The coefficients for which Σ (row · coefficients − value)² is least, those of great size held down a little: by
/// the normal equations and Cholesky's factors.
fn least_squares(rows: &[Row]) -> Vec<f64> {
    let n = rows[0].0.len();
    let sum = |f: &dyn Fn(&Row) -> f64| rows.iter().map(f).sum::<f64>();
    let mut lower = vec![vec![0.0; n]; n];
    for i in 0..n {
        for j in 0..=i {
            let more = if i == j { RIDGE * rows.len() as f64 } else { 0.0 };
            let dot = sum(&|row| row.0[i] * row.0[j]) + more;
            let rest = dot - (0..j).map(|k| lower[i][k] * lower[j][k]).sum::<f64>();
            lower[i][j] = if i == j { libm::sqrt(rest.max(1e-300)) } else { rest / lower[j][j] };
        }
    }
    let mut x = vec![0.0; n];
    for i in 0..n {
        let rest = sum(&|row| row.0[i] * row.1) - (0..i).map(|k| lower[i][k] * x[k]).sum::<f64>();
        x[i] = rest / lower[i][i];
    }
    for i in (0..n).rev() {
        let rest = x[i] - (i + 1..n).map(|k| lower[k][i] * x[k]).sum::<f64>();
        x[i] = rest / lower[i][i];
    }
    x
}

#[cfg(test)]
#[path = "compensation_tests.rs"]
mod tests;
