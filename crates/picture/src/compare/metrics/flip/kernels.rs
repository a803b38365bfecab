//! The filters of ꟻLIP: how the eye blurs colours, and what it takes for edges and points.

use core::f64::consts::PI;

use super::super::filter::Kernel;

/// The contrast sensitivity of a channel as a sum of Gaussians a·√(π/b)·exp(−π²x²/b), x in degrees:
/// pairs of a and b. Table 1 of the paper of 2020; the second Gaussians of the first two are zero there.
const ACHROMATIC: [f64; 2] = [1.0, 0.0047];
const RED_GREEN: [f64; 2] = [1.0, 0.0053];
const BLUE_YELLOW: [[f64; 2]; 2] = [[34.1, 0.04], [13.5, 0.025]];

/// The width of an edge that the eye still finds, in degrees; section 4.2.2 there.
const FEATURE_WIDTH: f64 = 0.082;

/// How each channel is blurred, along rows and columns alike.
pub(super) struct ColorKernels {
    /// For Y.
    pub achromatic: Kernel<f32>,
    /// For Cx.
    pub red_green: Kernel<f32>,
    /// For Cz: the sum of both.
    pub blue_yellow: [Kernel<f32>; 2],
}

impl ColorKernels {
    /// The kernels for so many pixels per degree. Each channel's weights sum to 1 over the square.
    pub(super) fn new(ppd: f64) -> Self {
        let widest = BLUE_YELLOW[0][1];
        let radius = (3.0 * (widest / (2.0 * PI * PI)).sqrt() * ppd).ceil() as i32;
        let gaussian = |b: f64| {
            let weight = move |x: i32| libm::exp(-PI * PI * (f64::from(x) / ppd) * (f64::from(x) / ppd) / b);
            (-radius..=radius).map(weight).collect::<Vec<_>>()
        };
        let alone = |[_, b]: [f64; 2]| scaled(&gaussian(b), 1.0 / gaussian(b).iter().sum::<f64>());
        // Over the square a kernel sums to the square of its sum along one direction.
        let height = |[a, b]: [f64; 2]| a * (PI / b).sqrt();
        let volume = |gauss: [f64; 2]| {
            let sum: f64 = gaussian(gauss[1]).iter().sum();
            height(gauss) * sum * sum
        };
        let total: f64 = BLUE_YELLOW.map(volume).iter().sum();
        let blue_yellow =
            BLUE_YELLOW.map(|gauss| scaled(&gaussian(gauss[1]), (height(gauss) / total).sqrt()));
        Self { achromatic: alone(ACHROMATIC), red_green: alone(RED_GREEN), blue_yellow }
    }
}

fn scaled(weights: &[f64], by: f64) -> Kernel<f32> {
    Kernel::new(weights.iter().map(|weight| (weight * by) as f32).collect())
}

/// Detectors of edges and points in one direction, and the smoothing in the other.
pub(super) struct FeatureKernels {
    /// A Gaussian of sum 1.
    pub smooth: Kernel<f32>,
    /// Its first derivative.
    pub edge: Kernel<f32>,
    /// Its second derivative.
    pub point: Kernel<f32>,
}

impl FeatureKernels {
    /// The kernels for so many pixels per degree. The positive weights of a derivative sum to 1, the
    /// negative ones to −1.
    pub(super) fn new(ppd: f64) -> Self {
        let sigma = 0.5 * FEATURE_WIDTH * ppd;
        let radius = (3.0 * sigma).ceil() as i32;
        let kernel = |weight: &dyn Fn(f64) -> f64| -> Vec<f64> {
            let gaussian = |x: f64| libm::exp(-x * x / (2.0 * sigma * sigma));
            (-radius..=radius).map(f64::from).map(|x| weight(x) * gaussian(x)).collect()
        };
        let smooth = kernel(&|_| 1.0);
        let sum: f64 = smooth.iter().sum();
        Self {
            smooth: scaled(&smooth, 1.0 / sum),
            edge: balanced(&kernel(&|x| -x)),
            point: balanced(&kernel(&|x| x * x / (sigma * sigma) - 1.0)),
        }
    }
}

/// A zero-sum kernel whose weights of either sign sum to 1 in magnitude.
fn balanced(weights: &[f64]) -> Kernel<f32> {
    let positive: f64 = weights.iter().filter(|weight| **weight > 0.0).sum();
    let negative: f64 = -weights.iter().filter(|weight| **weight < 0.0).sum::<f64>();
    let balance = |weight: f64| if weight > 0.0 { weight / positive } else { weight / negative };
    Kernel::of_differences(weights.iter().map(|weight| balance(*weight) as f32).collect())
}
