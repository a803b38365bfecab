//! Colour differences ΔE.
//!
//! ```
//! use glanz_color::difference::{Cie94, cie76, cie94, ciede2000};
//! use glanz_color::models::Lab;
//!
//! // The first pair of the test data of Sharma, Wu and Dalal (2005).
//! let (first, second) = (Lab([50.0, 2.6772, -79.7751]), Lab([50.0, 0.0, -82.7485]));
//! assert!((ciede2000(first, second) - 2.0425).abs() < 5e-5);
//! assert!((cie76(first, second) - 4.0011).abs() < 5e-5);
//! assert!((cie94(first, second, Cie94::GRAPHIC_ARTS) - 1.3950).abs() < 5e-5);
//! ```

use crate::models::{Lab, Oklab};

/// CIE 1976: the distance in L\*a\*b\*.
pub fn cie76(first: Lab, second: Lab) -> f64 {
    distance(first.0, second.0)
}

/// ΔE OK: the distance in OKLab (CSS Color 4). A just noticeable step is about 0.02.
pub fn ok(first: Oklab, second: Oklab) -> f64 {
    distance(first.0, second.0)
}

fn distance(first: [f64; 3], second: [f64; 3]) -> f64 {
    let [x, y, z] = core::array::from_fn(|i| first[i] - second[i]);
    (x * x + y * y + z * z).sqrt()
}

/// The weights of CIE 1994.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cie94 {
    /// k_L.
    pub lightness: f64,
    /// K₁, the growth of the weight of chroma.
    pub chroma: f64,
    /// K₂, the growth of the weight of hue.
    pub hue: f64,
}

impl Cie94 {
    /// For pictures and paint: 1, 0.045, 0.015 (CIE 116-1995).
    pub const GRAPHIC_ARTS: Self = Self { lightness: 1.0, chroma: 0.045, hue: 0.015 };
    /// For textiles: 2, 0.048, 0.014.
    pub const TEXTILES: Self = Self { lightness: 2.0, chroma: 0.048, hue: 0.014 };
}

/// CIE 1994. Not symmetric: the chroma of the reference sets the weights.
pub fn cie94(reference: Lab, sample: Lab, weights: Cie94) -> f64 {
    let ([l1, a1, b1], [l2, a2, b2]) = (reference.0, sample.0);
    let (c1, c2) = (length(a1, b1), length(a2, b2));
    let delta_c = c1 - c2;
    let (delta_a, delta_b) = (a1 - a2, b1 - b2);
    let delta_h_squared = (delta_a * delta_a + delta_b * delta_b - delta_c * delta_c).max(0.0);
    let l = (l1 - l2) / weights.lightness;
    let c = delta_c / (1.0 + weights.chroma * c1);
    let s_h = 1.0 + weights.hue * c1;
    (l * l + c * c + delta_h_squared / (s_h * s_h)).sqrt()
}

/// CIEDE2000 with k_L = k_C = k_H = 1 (CIE 142-2001; Sharma, Wu, Dalal 2005).
///
/// Symmetric. Hues are kept as directions, so that per colour pair only one arc tangent, one exponential
/// and one sine remain; the result is that of the formula with angles.
pub fn ciede2000(first: Lab, second: Lab) -> f64 {
    let ([l, c, h, r_t], _) = weighted_differences(first, second);
    (l * l + c * c + h * h + r_t * c * h).max(0.0).sqrt()
}

/// Three numbers whose squares add up to that of [`ciede2000`]: the difference of lightness, and those along
/// a′ and b, each over the formula's weights. Least squares of differences of colour are those of these numbers, which, other
/// than ΔE00 and the differences of chroma and hue, have slopes where colours are the same and where they are grey.
///
/// ```
/// use glanz_color::difference::{ciede2000, ciede2000_components};
/// use glanz_color::models::Lab;
///
/// let (first, second) = (Lab([50.0, 2.6772, -79.7751]), Lab([48.0, 0.0, -82.7485]));
/// let squares: f64 = ciede2000_components(first, second).iter().map(|x| x * x).sum();
/// assert!((squares.sqrt() - ciede2000(first, second)).abs() < 1e-12);
/// ```
pub fn ciede2000_components(first: Lab, second: Lab) -> [f64; 3] {
    let ([l, c, h, r_t], (cos, sin)) = weighted_differences(first, second);
    // Square to each other; |R_T| is below 2 sin 60°, so the root is real.
    let (c, h) = (c + 0.5 * r_t * h, h * (1.0 - 0.25 * r_t * r_t).sqrt());
    [l, cos * c - sin * h, sin * c + cos * h]
}

/// The differences of lightness, chroma and hue over their weights, the rotation term R_T, and the direction of the mean hue.
fn weighted_differences(first: Lab, second: Lab) -> ([f64; 4], (f64, f64)) {
    let ([l1, a1, b1], [l2, a2, b2]) = (first.0, second.0);
    let mean_chroma = 0.5 * (length(a1, b1) + length(a2, b2));
    let stretch = 1.0 + 0.5 * (1.0 - saturation(mean_chroma));
    let (first, second) = (Hue::new(a1 * stretch, b1), Hue::new(a2 * stretch, b2));
    let mean_c = 0.5 * (first.chroma + second.chroma);
    let (cos, sin) = mean_direction(&first, &second);

    let from_middle = 0.5 * (l1 + l2) - 50.0;
    let s_l = 1.0 + 0.015 * from_middle * from_middle / (20.0 + from_middle * from_middle).sqrt();
    let s_c = 1.0 + 0.045 * mean_c;
    let s_h = 1.0 + 0.015 * mean_c * hue_weight(cos, sin);

    let l = (l2 - l1) / s_l;
    let c = (second.chroma - first.chroma) / s_c;
    let h = hue_difference(&first, &second) / s_h;
    let r_t = -2.0 * saturation(mean_c) * blue_rotation(cos, sin);
    ([l, c, h, r_t], (cos, sin))
}

/// A point of the plane a′, b by its direction and its distance from the grey axis.
struct Hue {
    a: f64,
    b: f64,
    chroma: f64,
}

impl Hue {
    fn new(a: f64, b: f64) -> Self {
        Self { a, b, chroma: length(a, b) }
    }

    /// The direction; 0, 0 for grey.
    fn direction(&self) -> (f64, f64) {
        let by = if self.chroma == 0.0 { 0.0 } else { 1.0 / self.chroma };
        (self.a * by, self.b * by)
    }

    /// The cosine and the sine of the angle to another, times both chromas.
    fn products(&self, other: &Self) -> (f64, f64) {
        (self.a * other.a + self.b * other.b, self.a * other.b - self.b * other.a)
    }

    /// Whether the hues are exactly 180° apart.
    fn is_opposite_to(&self, other: &Self) -> bool {
        let (dot, cross) = self.products(other);
        cross == 0.0 && dot < 0.0
    }

    /// Whether the hue angle is in 0 … 180°, 180 itself not included.
    fn is_upper(&self) -> bool {
        self.b > 0.0 || (self.b == 0.0 && self.a > 0.0)
    }
}

fn length(a: f64, b: f64) -> f64 {
    (a * a + b * b).sqrt()
}

/// √(C⁷/(C⁷ + 25⁷)), equations 4 and 19 there.
fn saturation(chroma: f64) -> f64 {
    const TWENTY_FIVE_TO_7: f64 = 6_103_515_625.0;
    let cube = chroma * chroma * chroma;
    let power = cube * cube * chroma;
    // Beyond any colour the power is infinite, and the limit is 1.
    if power.is_infinite() { 1.0 } else { (power / (power + TWENTY_FIVE_TO_7)).sqrt() }
}

/// Cosine and sine of the mean hue h̄′, equation 14: the bisector of the two directions.
///
/// The formula adds 180° where hues are more than 180° apart, which is what the bisector does; exactly
/// opposite hues have their mean 90° after the lesser of the two angles. A grey leaves the other's hue.
fn mean_direction(first: &Hue, second: &Hue) -> (f64, f64) {
    let ((a1, b1), (a2, b2)) = (first.direction(), second.direction());
    if first.is_opposite_to(second) {
        return if first.is_upper() { (-b1, a1) } else { (-b2, a2) };
    }
    let (a, b) = (a1 + a2, b1 + b2);
    let size = length(a, b);
    if size > 0.0 { (a / size, b / size) } else { (1.0, 0.0) }
}

/// T, equation 15, with the cosines of multiples from those of the angle.
fn hue_weight(cos: f64, sin: f64) -> f64 {
    /// Cosine and sine of 30°, 6°, 63°.
    const AT_30: (f64, f64) = (0.866_025_403_784_438_6, 0.5);
    const AT_6: (f64, f64) = (0.994_521_895_368_273_3, 0.104_528_463_267_653_46);
    const AT_63: (f64, f64) = (0.453_990_499_739_546_8, 0.891_006_524_188_367_9);
    let (cos2, sin2) = (cos * cos - sin * sin, 2.0 * sin * cos);
    let (cos3, sin3) = (cos2 * cos - sin2 * sin, sin2 * cos + cos2 * sin);
    let (cos4, sin4) = (cos2 * cos2 - sin2 * sin2, 2.0 * sin2 * cos2);
    1.0 - 0.17 * (cos * AT_30.0 + sin * AT_30.1) + 0.24 * cos2 + 0.32 * (cos3 * AT_6.0 - sin3 * AT_6.1)
        - 0.20 * (cos4 * AT_63.0 + sin4 * AT_63.1)
}

/// ΔH′ = 2 √(C₁C₂) sin(Δh/2), equation 11, from products of the two points.
///
/// Half angles come from sin Δh / (2 cos(Δh/2)) up to 90° and from √((1 − cos Δh)/2) beyond, each where it
/// loses no digits.
fn hue_difference(first: &Hue, second: &Hue) -> f64 {
    let product = first.chroma * second.chroma;
    if product == 0.0 {
        return 0.0;
    }
    let (dot, cross) = first.products(second);
    if dot > 0.0 {
        return cross / (0.5 * (product + dot)).sqrt();
    }
    let size = (2.0 * (product - dot)).sqrt();
    let forwards = cross > 0.0 || (cross == 0.0 && first.is_upper());
    if forwards { size } else { -size }
}

/// sin 2Δθ, equations 16 and 21: the turn of the ellipses in the blue.
fn blue_rotation(cos: f64, sin: f64) -> f64 {
    let degrees = libm::atan2(sin, cos).to_degrees();
    let degrees = if degrees < 0.0 { degrees + 360.0 } else { degrees };
    let from_blue = (degrees - 275.0) / 25.0;
    libm::sin((60.0 * libm::exp(-from_blue * from_blue)).to_radians())
}

#[cfg(test)]
mod tests;
