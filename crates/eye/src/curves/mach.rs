//! Mach bands in closed form: the answer of a receptive field with an excitatory centre and an inhibitory surround.

use core::f64::consts::{FRAC_1_SQRT_2, PI, TAU};

use libm::{erf, exp, log, sqrt};

/// A receptive field whose centre and surround are Gaussians, scaled so that uniform light is answered by itself:
/// B = (G_c − k G_s)/(1 − k).
///
/// **Parameters** as fields, with the defaults of the P cells of the fovea. **Limits** people see bands on ramps, and hardly any on steps, at
/// any scale; this model is largest on steps and has one size (F. A. A. Kingdom, Frontiers in Human Neuroscience, 2014).
/// **Source** H. K. Hartline and F. Ratliff, 1957; radii: L. J. Croner and E. Kaplan, Vision Research 35, 1995. σ is their radius over √2; the
/// radii of P cells are from memory and were not checked against the paper.
///
/// ```
/// use glanz_eye::curves::CenterSurround;
///
/// let cell = CenterSurround::P_CELL;
/// // Beside a step of height 1 the brighter side is answered by 1.33, and the band is 0.048° from the edge.
/// let (place, overshoot) = cell.step_band();
/// assert!((overshoot - 0.329389).abs() < 5e-7 && (place - 0.047962).abs() < 5e-7);
/// assert!((cell.step(place) - 1.0 - overshoot).abs() < 1e-12);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CenterSurround {
    /// The standard deviation of the centre, in degrees, above 0.
    pub center_deg: f64,
    /// The standard deviation of the surround, in degrees, above that of the centre.
    pub surround_deg: f64,
    /// The share k of the surround, 0 to below 1.
    pub surround: f64,
}

impl Default for CenterSurround {
    fn default() -> Self {
        Self::P_CELL
    }
}

impl CenterSurround {
    /// A P cell within 5° of the fovea: radii of 0.03 and 0.18°, k ½.
    pub const P_CELL: Self =
        Self { center_deg: 0.03 * FRAC_1_SQRT_2, surround_deg: 0.18 * FRAC_1_SQRT_2, surround: 0.5 };
    /// An M cell: radii of 0.10 and 0.72°, k 0.4.
    pub const M_CELL: Self =
        Self { center_deg: 0.10 * FRAC_1_SQRT_2, surround_deg: 0.72 * FRAC_1_SQRT_2, surround: 0.4 };

    /// The field, if its numbers are those of one: 0 < centre < surround, all finite, and 0 ≤ k < 1 with k·σ_c < σ_s.
    pub fn checked(self) -> Option<Self> {
        let sizes = self.center_deg > 0.0 && self.surround_deg > self.center_deg && self.surround_deg < 1e6;
        (sizes && (0.0..1.0).contains(&self.surround)).then_some(self)
    }

    /// (a − k b)/(1 − k).
    fn difference(&self, center: f64, surround: f64) -> f64 {
        (center - self.surround * surround) / (1.0 - self.surround)
    }

    /// The answer at x degrees from a step from 0 to 1: (Φ(x/σ_c) − kΦ(x/σ_s))/(1 − k).
    pub fn step(&self, x_deg: f64) -> f64 {
        self.difference(normal(x_deg / self.center_deg), normal(x_deg / self.surround_deg))
    }

    /// The answer at x degrees from a corner, where 0 becomes a slope of 1 per degree.
    pub fn corner(&self, x_deg: f64) -> f64 {
        let smooth = |sigma: f64| x_deg * normal(x_deg / sigma) + sigma * density(x_deg / sigma);
        self.difference(smooth(self.center_deg), smooth(self.surround_deg))
    }

    /// The answer at x degrees from the middle of a ramp from 0 to 1 that is so many degrees wide; of a step where the width is 0.
    pub fn ramp(&self, x_deg: f64, width_deg: f64) -> f64 {
        match width_deg > 0.0 {
            true => (self.corner(x_deg + 0.5 * width_deg) - self.corner(x_deg - 0.5 * width_deg)) / width_deg,
            false => self.step(x_deg),
        }
    }

    /// The gain at a spatial frequency in cycles per degree: (e^(−2π²σ_c²f²) − k e^(−2π²σ_s²f²))/(1 − k).
    pub fn gain(&self, frequency: f64) -> f64 {
        let part = |sigma: f64| {
            let x = PI * sigma * frequency;
            exp(-2.0 * x * x)
        };
        self.difference(part(self.center_deg), part(self.surround_deg))
    }

    /// The band beside a step of height 1: its place in degrees from the edge, and by how much it exceeds 1; as much it falls short of
    /// 0 on the other side.
    ///
    /// The place is x² = 2 ln(σ_s/(kσ_c))/(σ_c⁻² − σ_s⁻²). Both are 0 without a surround.
    pub fn step_band(&self) -> (f64, f64) {
        if self.surround <= 0.0 {
            return (0.0, 0.0);
        }
        let ratio = self.surround_deg / (self.surround * self.center_deg);
        let inverse = |sigma: f64| 1.0 / (sigma * sigma);
        let place = sqrt(2.0 * log(ratio) / (inverse(self.center_deg) - inverse(self.surround_deg)));
        (place, self.step(place) - 1.0)
    }

    /// The band at a corner, where the slope changes by 1 per degree: its place in degrees, towards the flat side where it is negative,
    /// and its depth D in degrees. At a corner of Δ per degree the band is Δ·D deep.
    ///
    /// The place is where Φ(x/σ_c) = kΦ(x/σ_s), and D = (kσ_s φ(x/σ_s) − σ_c φ(x/σ_c))/(1 − k).
    pub fn corner_band(&self) -> (f64, f64) {
        if self.surround <= 0.0 {
            return (0.0, 0.0);
        }
        // From far on the flat side, where the surround answers alone, to the corner, where the centre has won.
        let place = bisect((-40.0 * self.center_deg, 0.0), |x| self.step(x));
        (place, -self.corner(place))
    }

    /// The band beside the end of a ramp of height 1 that is so many degrees wide: its place in degrees from the middle of the ramp, and
    /// by how much it exceeds 1.
    pub fn ramp_band(&self, width_deg: f64) -> (f64, f64) {
        let (beside_step, overshoot) = self.step_band();
        let half = 0.5 * width_deg.max(0.0);
        if half == 0.0 || overshoot == 0.0 {
            return (beside_step, overshoot);
        }
        let slope = |x: f64| self.step(x - half) - self.step(x + half);
        let place = bisect((0.0, half + beside_step), slope);
        (place, self.ramp(place, width_deg) - 1.0)
    }
}

/// Where a function that grows through 0 is 0.
fn bisect((mut low, mut high): (f64, f64), f: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        match f(middle) < 0.0 {
            true => low = middle,
            false => high = middle,
        }
    }
    0.5 * (low + high)
}

/// The normal distribution function Φ.
fn normal(x: f64) -> f64 {
    0.5 * (1.0 + erf(x * FRAC_1_SQRT_2))
}

/// The normal density φ.
fn density(x: f64) -> f64 {
    exp(-0.5 * x * x) / sqrt(TAU)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curves::assert_digits;

    #[test]
    fn the_bands_of_p_cells_have_their_sizes_and_places() {
        // eye.md 84–88.
        let (place, depth) = CenterSurround::P_CELL.corner_band();
        assert_digits(depth, "0.0376535");
        assert_digits(place, "-0.016029");
        let (place, overshoot) = CenterSurround::P_CELL.step_band();
        assert_digits(overshoot, "0.329389");
        assert_digits(place, "0.047962");
        assert_digits(CenterSurround::P_CELL.ramp_band(0.2).1, "0.17675");
    }

    #[test]
    fn the_bands_of_m_cells_have_their_sizes() {
        // eye.md 89–90.
        assert_digits(CenterSurround::M_CELL.corner_band().1, "0.1034167");
        assert_digits(CenterSurround::M_CELL.step_band().1, "0.232665");
    }

    #[test]
    fn the_bands_of_ramps_fall_with_their_width() {
        // eye.md §2: for widths of 0.02 to 1°.
        for (width, known) in [
            (0.02, "0.3245"),
            (0.05, "0.3039"),
            (0.1, "0.2581"),
            (0.2, "0.1768"),
            (0.5, "0.0753"),
            (1.0, "0.0377"),
        ] {
            assert_digits(CenterSurround::P_CELL.ramp_band(width).1, known);
        }
        // Wide ramps have two corners that know nothing of each other.
        let (_, depth) = CenterSurround::P_CELL.corner_band();
        assert!((CenterSurround::P_CELL.ramp_band(4.0).1 - depth / 4.0).abs() < 1e-12);
    }

    #[test]
    fn the_gain_has_its_peak() {
        // eye.md §2: 1.790 at 3.05 cycles per degree.
        let cell = CenterSurround::P_CELL;
        assert_digits(cell.gain(3.05), "1.790");
        assert!(cell.gain(3.05) > cell.gain(2.95) && cell.gain(3.05) > cell.gain(3.15));
        assert_eq!(cell.gain(0.0), 1.0);
    }

    #[test]
    fn a_ramp_is_the_mean_of_steps_and_a_corner_their_sum() {
        let cell = CenterSurround::P_CELL;
        let rule = glanz_math::GaussLegendre::new(40);
        for x in [-0.1, 0.0, 0.03, 0.2] {
            let mean = rule.integrate(-0.05, 0.05, |t| cell.step(x - t)) / 0.1;
            assert!((cell.ramp(x, 0.1) - mean).abs() < 1e-12, "{x}");
        }
        assert_eq!(cell.ramp(0.01, 0.0), cell.step(0.01));
    }

    #[test]
    fn a_field_without_a_surround_has_no_bands_and_an_impossible_one_is_refused() {
        let blur = CenterSurround { surround: 0.0, ..CenterSurround::P_CELL };
        assert_eq!((blur.step_band().1, blur.corner_band().1, blur.ramp_band(0.1).1), (0.0, 0.0, 0.0));
        let p = CenterSurround::P_CELL;
        for wrong in [
            CenterSurround { surround: 1.0, ..p },
            CenterSurround { center_deg: 0.0, ..p },
            CenterSurround { surround_deg: 0.01, ..p },
            CenterSurround { surround: f64::NAN, ..p },
            CenterSurround { surround_deg: f64::INFINITY, ..p },
        ] {
            assert_eq!(wrong.checked(), None, "{wrong:?}");
        }
        assert_eq!(p.checked(), Some(p));
    }
}
