//! CIECAM02 and its uniform space CAM02-UCS in the surround of TM-30.
//!
//! CIE 159:2004 for a background of 20 % and an adapting field of 100 cd/m² in an average surround, adapted wholly to the
//! light; M. R. Luo, G. Cui, C. Li, "Uniform colour spaces based on CIECAM02", Color Research and Application 31(4), 2006.

use crate::algebra::Matrix3;

const CAT02: Matrix3 =
    Matrix3([[0.7328, 0.4296, -0.1624], [-0.7036, 1.6975, 0.0061], [0.0030, 0.0136, 0.9834]]);
/// Hunt, Pointer and Estévez.
const HPE: Matrix3 =
    Matrix3([[0.389_71, 0.688_98, -0.078_68], [-0.229_81, 1.183_40, 0.046_41], [0.0, 0.0, 1.0]]);

/// The luminance of the adapting field in cd/m².
const ADAPTING: f64 = 100.0;
/// The luminance factor of the background over that of the white.
const BACKGROUND: f64 = 0.2;
/// The impact of an average surround, c and N_c.
const SURROUND: (f64, f64) = (0.69, 1.0);

/// An eye that is adapted to a white.
pub(super) struct Adapted {
    /// What brings the cones' signals of the white to 100.
    gain: [f64; 3],
    /// From cone signals of CAT02 to those of Hunt, Pointer and Estévez.
    to_hpe: Matrix3,
    /// F_L.
    level: f64,
    white: f64,
}

impl Adapted {
    /// The eye that sees this white, Y = 100.
    pub(super) fn to(white: [f64; 3]) -> Self {
        let k = 1.0 / (5.0 * ADAPTING + 1.0);
        let fourth = k * k * k * k;
        let rest = (1.0 - fourth) * (1.0 - fourth);
        let level = 0.2 * fourth * 5.0 * ADAPTING + 0.1 * rest * libm::cbrt(5.0 * ADAPTING);
        let gain = CAT02.apply(white).map(|signal| white[1] / signal);
        let mut eye = Self { gain, to_hpe: HPE.times(&CAT02.inverse()), level, white: 1.0 };
        eye.white = achromatic(eye.compressed(white));
        eye
    }

    /// The cones' signals after compression.
    fn compressed(&self, xyz: [f64; 3]) -> [f64; 3] {
        let cat = CAT02.apply(xyz);
        let adapted = core::array::from_fn(|i| cat[i] * self.gain[i]);
        self.to_hpe.apply(adapted).map(|signal| {
            let power = libm::pow(self.level * signal.abs() / 100.0, 0.42);
            (400.0 * power / (power + 27.13)).copysign(signal) + 0.1
        })
    }

    /// J′, a′, b′ of X, Y, Z.
    pub(super) fn jab(&self, xyz: [f64; 3]) -> [f64; 3] {
        let (c, n_c) = SURROUND;
        let [r, g, b] = self.compressed(xyz);
        let (red, yellow) = (r - 12.0 * g / 11.0 + b / 11.0, (r + g - 2.0 * b) / 9.0);
        let hue = libm::atan2(yellow, red);
        let exponent = c * (1.48 + BACKGROUND.sqrt());
        let lightness = 100.0 * libm::pow((achromatic([r, g, b]) / self.white).max(0.0), exponent);
        let eccentricity = 0.25 * (libm::cos(hue + 2.0) + 3.8);
        let t = 50_000.0 / 13.0 * n_c * induction() * eccentricity * libm::hypot(red, yellow)
            / (r + g + 21.0 * b / 20.0);
        let chroma = libm::pow(t, 0.9)
            * (lightness / 100.0).sqrt()
            * libm::pow(1.64 - libm::pow(0.29, BACKGROUND), 0.73);
        let colorfulness = chroma * libm::pow(self.level, 0.25);
        let j = 1.7 * lightness / (1.0 + 0.007 * lightness);
        let m = libm::log(1.0 + 0.0228 * colorfulness) / 0.0228;
        [j, m * libm::cos(hue), m * libm::sin(hue)]
    }
}

/// N_bb and N_cb.
fn induction() -> f64 {
    0.725 * libm::pow(1.0 / BACKGROUND, 0.2)
}

fn achromatic([r, g, b]: [f64; 3]) -> f64 {
    (2.0 * r + g + b / 20.0 - 0.305) * induction()
}
