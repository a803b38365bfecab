//! The form factor of a polygon: the integral of a clamped cosine over it.
//!
//! Source: J. H. Lambert 1760; D. R. Baum, H. E. Rushmeier and J. M. Winget, "Improving Radiosity Solutions
//! Through the Use of Analytically Determined Form-Factors", SIGGRAPH 1989.

use glanz_math::{PI, Real, Vec3};

/// Edges whose ends are further apart than the angle of this cosine are taken by their cross product.
const NEARLY_OPPOSITE: f64 = -0.9;

/// ∫ cosθ/π over the part of a convex polygon that is above the plane z = 0, seen from the origin. Which way it
/// turns does not matter. There must be corners.
#[inline(always)]
pub(crate) fn form_factor<R: Real>(corners: &[Vec3<R>]) -> R {
    let zero = corners[0].z.zero();
    let mut highest = corners[0].z;
    for corner in corners {
        highest = highest.max(corner.z);
    }
    if !R::any(zero.lt(highest)) {
        return zero;
    }
    let mut sum = zero;
    // Where the outline goes below the horizon, and where it comes up again.
    let (mut down, mut up) = (Vec3::new(zero, zero, zero), Vec3::new(zero, zero, zero));
    let mut is_cut = false;
    // From the first corner on, so that zero edges between corners change no bit.
    let first = End::of(corners[0]);
    let mut from = first;
    for i in 1..=corners.len() {
        let to = if i == corners.len() { first } else { End::of(corners[i]) };
        let (above_from, above_to) = (zero.lt(from.at.z), zero.lt(to.at.z));
        let (goes_down, comes_up) = (above_from & !above_to, above_to & !above_from);
        let (mut start, mut end) = (from, to);
        if R::any(goes_down | comes_up) {
            let span = from.at.z - to.at.z;
            let t = from.at.z / span.select(span.abs().gt(zero.lit(1e-30)), zero.one());
            let crossing = End::of(from.at + (to.at - from.at) * t);
            start = from.or(above_from, crossing);
            end = to.or(above_to, crossing);
            down = choose(goes_down, crossing.at, down);
            up = choose(comes_up, crossing.at, up);
            is_cut = true;
        }
        sum = sum + start.edge(&end).select(above_from | above_to, zero);
        from = to;
    }
    if is_cut {
        sum = sum + edge(down, up);
    }
    (sum * zero.lit(0.5 / PI)).abs().min(zero.one())
}

/// An end of an edge, and the inverse of its distance.
#[derive(Clone, Copy)]
struct End<R> {
    at: Vec3<R>,
    inverse: R,
}

impl<R: Real> End<R> {
    #[inline(always)]
    fn of(at: Vec3<R>) -> Self {
        Self { at, inverse: at.dot(at).max(at.z.lit(1e-36)).rsqrt() }
    }

    /// This one where the mask holds.
    #[inline(always)]
    fn or(&self, mask: R::Mask, other: Self) -> Self {
        Self { at: choose(mask, self.at, other.at), inverse: self.inverse.select(mask, other.inverse) }
    }

    /// The edge's part, as [`edge`].
    #[inline(always)]
    fn edge(&self, to: &Self) -> R {
        let scale = self.inverse * to.inverse;
        let cosine = self.at.dot(to.at) * scale;
        let part = (self.at.x * to.at.y - self.at.y * to.at.x) * scale * angle_over_sine(cosine);
        let opposite = cosine.lt(cosine.lit(NEARLY_OPPOSITE));
        if R::any(opposite) { edge(self.at, to.at).select(opposite, part) } else { part }
    }
}

/// θ / sin θ over cos θ: a polynomial within 2e-8 for cosines above 0.
#[inline(always)]
fn angle_over_sine<R: Real>(cosine: R) -> R {
    const TERMS: [f64; 10] = [
        1.570_796_31,
        -0.999_996_437,
        0.785_274_298,
        -0.664_970_691,
        0.576_982_709,
        -0.482_230_295,
        0.351_092_721,
        -0.194_747_626,
        0.069_269_092_5,
        -0.011_470_094_3,
    ];
    let zero = cosine.zero();
    let x = cosine.abs();
    let mut value = x.lit(TERMS[9]);
    for term in TERMS[..9].iter().rev() {
        value = value * x + x.lit(*term);
    }
    let obtuse = cosine.lt(zero);
    if !R::any(obtuse) {
        return value;
    }
    let sine = (x.one() - x.sqr()).max(x.lit(1e-12)).rsqrt();
    (x.lit(PI) * sine - value).select(obtuse, value)
}

/// What of an edge is above the plane z = 0: where it begins and ends, and whether anything is.
#[inline(always)]
fn kept<R: Real>(a: Vec3<R>, b: Vec3<R>) -> (Vec3<R>, Vec3<R>, R::Mask) {
    let zero = a.z.zero();
    let span = a.z - b.z;
    let t = a.z / span.select(span.abs().gt(zero.lit(1e-30)), zero.one());
    let crossing = a + (b - a) * t;
    let (above_a, above_b) = (zero.lt(a.z), zero.lt(b.z));
    (choose(above_a, a, crossing), choose(above_b, b, crossing), above_a | above_b)
}

/// Cuts away what a convex polygon has below the plane z = 0; there must be room for twice its corners. Where nothing
/// of it is above, its corners come together in one point. Returns how many corners it has now.
#[inline(always)]
pub(crate) fn above_horizon<R: Real>(corners: &mut [Vec3<R>], count: usize) -> usize {
    let zero = corners[0].z.zero();
    // Edges that are wholly below stand where the outline was left before; for the first that is the last.
    let mut at = Vec3::new(zero, zero, zero);
    for i in 0..count {
        let (_, end, any) = kept(corners[i], corners[(i + 1) % count]);
        at = choose(any, end, at);
    }
    let first = corners[0];
    let mut edges = [Vec3::new(zero, zero, zero); 32];
    for i in 0..count {
        let next = if i + 1 == count { first } else { corners[i + 1] };
        let (start, end, any) = kept(corners[i], next);
        edges[2 * i] = choose(any, start, at);
        edges[2 * i + 1] = choose(any, end, at);
        at = edges[2 * i + 1];
    }
    corners[..2 * count].copy_from_slice(&edges[..2 * count]);
    2 * count
}

/// An edge's part: its angle seen from the origin times the z component of the normal of its plane.
#[inline(always)]
fn edge<R: Real>(a: Vec3<R>, b: Vec3<R>) -> R {
    let normal = a.cross(b);
    let squared = normal.dot(normal);
    let zero = squared.zero();
    let length = squared.max(zero.lit(1e-36)).sqrt();
    let angle = length.atan2(a.dot(b));
    (normal.z * angle / length).select(zero.lit(1e-34).lt(squared), zero)
}

#[inline(always)]
fn choose<R: Real>(mask: R::Mask, a: Vec3<R>, b: Vec3<R>) -> Vec3<R> {
    Vec3::new(a.x.select(mask, b.x), a.y.select(mask, b.y), a.z.select(mask, b.z))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(height: f64, half: f64, shift: f64) -> [Vec3<f64>; 4] {
        [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
            .map(|(x, y)| Vec3::new(x * half + shift, y * half, height))
    }

    /// ∫ cosθ/π dω by the midpoint rule.
    fn by_points(height: f64, half: f64, shift: f64) -> f64 {
        let n = 400;
        let at = |i: usize| ((i as f64 + 0.5) / n as f64 * 2.0 - 1.0) * half;
        let patch = 4.0 * half * half / (n * n) as f64;
        let mut sum = 0.0;
        for i in 0..n {
            for j in 0..n {
                let r2 = (at(i) + shift) * (at(i) + shift) + at(j) * at(j) + height * height;
                sum += height * height / (r2 * r2) * patch / PI;
            }
        }
        sum
    }

    #[test]
    fn a_square_above_has_the_form_factor_of_its_integral() {
        for (height, half, shift) in [(1.0, 0.5, 0.0), (0.2, 1.0, 0.7), (2.0, 0.01, 1.0)] {
            let (got, expected) = (form_factor(&square(height, half, shift)), by_points(height, half, shift));
            assert!((got / expected - 1.0).abs() < 1e-4, "{got} for {expected}");
        }
    }

    #[test]
    fn what_is_below_the_horizon_does_not_count() {
        // A wall that reaches from below to above the plane is its upper part.
        let wall = |low: f64| {
            [
                Vec3::new(1.0, -1.0, low),
                Vec3::new(1.0, 1.0, low),
                Vec3::new(1.0, 1.0, 2.0),
                Vec3::new(1.0, -1.0, 2.0),
            ]
        };
        let whole = form_factor(&wall(0.0));
        assert!(whole > 0.1);
        assert!((form_factor(&wall(-3.0)) - whole).abs() < 1e-12);
        let below = [Vec3::new(1.0, -1.0, -2.0), Vec3::new(1.0, 1.0, -2.0), Vec3::new(1.0, 0.0, -1.0)];
        assert_eq!(form_factor::<f64>(&below), 0.0);
    }

    #[test]
    fn cutting_at_the_horizon_changes_no_form_factor_and_leaves_nothing_below() {
        let low = [(1.0, -1.0, -1.0), (2.0, 1.0, 0.5), (1.0, 1.5, 2.0), (0.5, -1.0, 1.0)];
        let corners = low.map(|(x, y, z)| Vec3::new(x, y, z));
        let mut cut = [Vec3::new(0.0, 0.0, 0.0); 8];
        cut[..4].copy_from_slice(&corners);
        let count = above_horizon(&mut cut, 4);
        assert!(cut[..count].iter().all(|corner| corner.z >= -1e-12));
        assert!((form_factor(&cut[..count]) - form_factor(&corners)).abs() < 1e-12);
        let mut below = corners.map(|v| Vec3::new(v.x, v.y, v.z - 5.0)).to_vec();
        below.resize(8, below[0]);
        let count = above_horizon(&mut below, 4);
        assert_eq!(form_factor(&below[..count]), 0.0);
    }

    #[test]
    fn a_sky_wide_polygon_is_one_and_single_precision_follows() {
        assert!((form_factor(&square(1e-4, 10.0, 0.0)) - 1.0).abs() < 1e-6);
        let short = square(1.0, 0.001, 0.3).map(|v| Vec3::new(v.x as f32, v.y as f32, v.z as f32));
        let expected = form_factor(&square(1.0, 0.001, 0.3));
        assert!((f64::from(form_factor(&short)) / expected - 1.0).abs() < 1e-3);
    }
}
