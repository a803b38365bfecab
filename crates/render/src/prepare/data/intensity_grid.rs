//! Luminous intensity over directions, as the pixel loop looks it up.

use glanz_math::{PI, Real, Vec3};
use glanz_scene::Profile;

/// Steps of C and γ, in degrees: profiles are measured every 2.5° to 15°.
const STEP_DEG: f64 = 1.0;
const COLUMNS: usize = 361;
const ROWS: usize = 181;

/// Fractions of the greatest intensity on a grid of planes C and angles γ.
#[derive(Clone, Debug, PartialEq)]
pub struct IntensityGrid {
    /// By planes C, each from γ = 0° to 180° in steps of 1°.
    pub values: Vec<f32>,
}

impl IntensityGrid {
    /// Those of a profile.
    pub fn of(profile: &Profile) -> Self {
        let max = profile.max();
        let fraction = |c: usize, gamma: usize| match max > 0.0 {
            true => (profile.at(c as f64 * STEP_DEG, gamma as f64 * STEP_DEG) / max) as f32,
            false => 0.0,
        };
        Self { values: (0..COLUMNS * ROWS).map(|i| fraction(i / ROWS, i % ROWS)).collect() }
    }

    /// The fraction along a unit vector in the luminaire's frame.
    #[inline(always)]
    pub fn at<R: Real>(&self, local: Vec3<R>) -> R {
        let degrees = local.x.lit(180.0 / PI);
        let around = local.y.atan2(local.x) * degrees;
        let c = around.lit(360.0).select(around.lt(around.zero()), around.zero()) + around;
        let (c, gamma) = (c.to_array(), (local.z.acos() * degrees).to_array());
        let mut values = [0.0; 16];
        for lane in 0..R::LANES {
            values[lane] = self.between(c[lane], gamma[lane]);
        }
        local.x.with_array(&values)
    }

    fn between(&self, c: f32, gamma: f32) -> f32 {
        let split = |x: f32, last: usize| {
            let x = Real::clamp(x, 0.0, last as f64);
            let whole = (x as usize).min(last - 1);
            (whole, x - whole as f32)
        };
        let ((column, x), (row, y)) = (split(c, COLUMNS - 1), split(gamma, ROWS - 1));
        let plane = |column: usize| {
            let at = column * ROWS + row;
            self.values[at] + (self.values[at + 1] - self.values[at]) * y
        };
        plane(column) + (plane(column + 1) - plane(column)) * x
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_share_is_the_profiles_own_over_its_greatest() {
        let profile = Profile {
            c_deg: vec![0.0, 90.0, 180.0, 270.0, 360.0],
            gamma_deg: vec![0.0, 90.0, 180.0],
            candela: vec![
                100.0, 50.0, 0.0, 100.0, 20.0, 0.0, 100.0, 10.0, 0.0, 100.0, 200.0, 0.0, 100.0, 50.0, 0.0,
            ],
        };
        let intensities = IntensityGrid::of(&profile);
        for (theta, phi) in [(0.0_f64, 0.0_f64), (30.0, 45.0), (90.0, 270.0), (120.0, 200.0), (90.0, 359.0)] {
            let d = Vec3::from_angles(theta.to_radians(), phi.to_radians());
            let got = f64::from(intensities.at(Vec3::new(d.x as f32, d.y as f32, d.z as f32)));
            let expected = profile.at(phi, theta) / 200.0;
            assert!((got - expected).abs() < 1e-5, "{theta}, {phi}: {got} for {expected}");
        }
    }
}
