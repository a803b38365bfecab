//! Mach bands along a row of a picture: what cells with a centre and a surround answer to it.

use libm::{ceil, erf, log10, sqrt};

use crate::curves::CenterSurround;

/// A row of a picture, and what is seen of it.
///
/// ```
/// use glanz_eye::MachProfile;
/// use glanz_eye::curves::CenterSurround;
///
/// // A ramp between two plains: bright and dark bands where it begins and ends.
/// let row: Vec<f32> = (0..200).map(|x| 0.2 + 0.01 * (x as f32 - 80.0).clamp(0.0, 40.0)).collect();
/// let profile = MachProfile::new(&row, 200, 0, 60.0, CenterSurround::P_CELL, 10.0);
/// let bands = profile.bands(10.0);
/// let bright = bands.iter().max_by(|a, b| a.height.total_cmp(&b.height)).expect("there are bands");
/// let dark = bands.iter().min_by(|a, b| a.height.total_cmp(&b.height)).expect("there are bands");
/// assert!(dark.height < 0.0 && dark.x.abs_diff(80) < 5 && bright.height > 0.0 && bright.x.abs_diff(120) < 5);
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MachProfile {
    /// The luminance, in the unit of the picture.
    pub luminance: Vec<f64>,
    /// Its decadic logarithm, held at a ten thousandth of the greatest of the row.
    pub log: Vec<f64>,
    /// What is seen: the logarithm, with the bands, each as high as the gain makes it.
    pub seen: Vec<f64>,
}

/// A band, of [`MachProfile::bands`]: a place where something brighter or darker is seen than there is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MachBand {
    /// The column.
    pub x: usize,
    /// How much brighter, in decades of luminance, without gain; darker below 0.
    pub height: f64,
}

/// Below this in decades of luminance there is no band: 0.1 %, a quarter of what people see at best.
const LEAST: f64 = 0.000_434;

impl MachProfile {
    /// Row `y` of a picture of `luminance` in rows of `width`, at so many pixels per degree. Bands are `gain` times as high as cells
    /// make them.
    ///
    /// The Gaussians of the cells are integrated over pixels. Where the picture ends, it is taken to go on as its edge.
    ///
    /// # Panics
    /// If there is no such row.
    pub fn new(
        luminance: &[f32],
        width: usize,
        y: usize,
        px_per_deg: f64,
        cells: CenterSurround,
        gain: f64,
    ) -> Self {
        let height = luminance.len() / width;
        assert!(y < height, "row {y} of {height}");
        let row = |y: usize| &luminance[y * width..(y + 1) * width];
        let most = luminance
            .iter()
            .fold(0.0_f32, |most, value| if value.is_finite() { most.max(*value) } else { most });
        let floor = (f64::from(most) * 1e-4).max(1e-30);
        let logarithm = |value: f32| log10(f64::from(value).max(floor));
        let blurred = |sigma_deg: f64| {
            let weights = weights(sigma_deg * px_per_deg);
            let tall: Vec<f64> = (0..width)
                .map(|x| {
                    sum(&weights, |d| {
                        let y = (y as isize + d).clamp(0, height as isize - 1) as usize;
                        logarithm(row(y)[x])
                    })
                })
                .collect();
            let at = |x: isize| tall[x.clamp(0, width as isize - 1) as usize];
            (0..width).map(|x| sum(&weights, |d| at(x as isize + d))).collect::<Vec<f64>>()
        };
        let (center, surround) = (blurred(cells.center_deg), blurred(cells.surround_deg));
        let log: Vec<f64> = row(y).iter().map(|value| logarithm(*value)).collect();
        let k = cells.surround;
        let seen = center.iter().zip(&surround).zip(&log).map(|((center, surround), log)| {
            let answer = (center - k * surround) / (1.0 - k);
            log + gain * (answer - log)
        });
        Self { luminance: row(y).iter().map(|v| f64::from(*v)).collect(), seen: seen.collect(), log }
    }

    /// The bands, from left to right; `gain` is the one that the profile was made with.
    pub fn bands(&self, gain: f64) -> Vec<MachBand> {
        let height: Vec<f64> =
            self.seen.iter().zip(&self.log).map(|(seen, log)| (seen - log) / gain).collect();
        let is_band = |x: &usize| {
            let (before, here, after) = (height[x - 1], height[*x], height[x + 1]);
            let peak = here.abs() >= before.abs() && here.abs() > after.abs();
            peak && here.abs() >= LEAST
        };
        (1..height.len().saturating_sub(1))
            .filter(is_band)
            .map(|x| MachBand { x, height: height[x] })
            .collect()
    }
}

/// A Gaussian integrated over pixels, from its middle on, of sum 1 on both sides together.
fn weights(sigma_px: f64) -> Vec<f64> {
    let radius = ceil(4.0 * sigma_px) as usize + 1;
    let edge = |x: f64| 0.5 * (1.0 + erf(x / (sigma_px * sqrt(2.0))));
    let weights: Vec<f64> = (0..=radius).map(|d| edge(d as f64 + 0.5) - edge(d as f64 - 0.5)).collect();
    let all = weights[0] + 2.0 * weights[1..].iter().sum::<f64>();
    weights.into_iter().map(|weight| weight / all).collect()
}

fn sum(weights: &[f64], value: impl Fn(isize) -> f64) -> f64 {
    let sides = weights.iter().enumerate().skip(1);
    sides.fold(weights[0] * value(0), |sum, (d, weight)| {
        sum + weight * (value(d as isize) + value(-(d as isize)))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Bands integrated over pixels: 0.03 % at 240 pixels per degree.
    const PIXELS: f64 = 2e-3;

    fn picture(width: usize, height: usize, log: impl Fn(f64) -> f64, px_per_deg: f64) -> Vec<f32> {
        let value = |x: usize| {
            let deg = (x as f64 + 0.5 - width as f64 / 2.0) / px_per_deg;
            libm::pow(10.0, log(deg)) as f32
        };
        (0..width * height).map(|i| value(i % width)).collect()
    }

    #[test]
    fn a_corner_and_a_step_have_the_bands_of_their_closed_forms() {
        let (cells, px_per_deg, width) = (CenterSurround::P_CELL, 240.0, 480);
        // A slope of 1 per degree that ends, and a step of 0.3.
        let corner = picture(width, 3, |deg| -0.5 + deg.min(0.0), px_per_deg);
        let bands = MachProfile::new(&corner, width, 1, px_per_deg, cells, 10.0).bands(10.0);
        let most = bands.iter().fold(0.0_f64, |most, band| most.max(band.height));
        let (place, height) = cells.corner_band();
        assert!((most - height).abs() < PIXELS * height.max(1.0), "{most} for {height}");
        let at = bands.iter().find(|band| band.height == most).unwrap().x as f64 + 0.5 - 240.0;
        assert!(
            (at / px_per_deg - place.abs()).abs() < 0.02 || (at / px_per_deg + place.abs()).abs() < 0.02,
            "{at}"
        );
        let step = picture(width, 3, |deg| if deg < 0.0 { -0.3 } else { 0.0 }, px_per_deg);
        let bands = MachProfile::new(&step, width, 1, px_per_deg, cells, 1.0);
        let overshoot = bands.seen.iter().fold(f64::MIN, |most, v| most.max(*v));
        let (_, height) = cells.step_band();
        assert!((overshoot / 0.3 - height).abs() < 0.01, "{} for {height}", overshoot / 0.3);
    }

    #[test]
    fn uniform_light_and_even_slopes_have_no_bands() {
        let flat = picture(200, 5, |_| -0.7, 40.0);
        assert!(MachProfile::new(&flat, 200, 2, 40.0, CenterSurround::P_CELL, 10.0).bands(10.0).is_empty());
        let slope = picture(400, 5, |deg| 0.1 * deg, 40.0);
        let bands = MachProfile::new(&slope, 400, 2, 40.0, CenterSurround::P_CELL, 10.0).bands(10.0);
        assert!(bands.iter().all(|band| !(40..360).contains(&band.x)), "{bands:?}");
    }

    #[test]
    fn black_is_no_trouble() {
        let black = vec![0.0; 100];
        let profile = MachProfile::new(&black, 10, 9, 40.0, CenterSurround::M_CELL, 10.0);
        assert!(profile.seen.iter().all(|v| v.is_finite()) && profile.bands(10.0).is_empty());
    }
}
