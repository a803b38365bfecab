//! Readings smoothed by Gaussians, for any pair of directions.

use glanz_math::Vec3;

use super::carrier::Carrier;
use super::positive::Positive;
use super::smooth::{Grained, Isotropic, Smooth};
use crate::{Channels, FitError, Measured};

/// Differences that are this part of the isotropic ones are those of a grain.
const GRAIN: f64 = 0.7;

/// Readings smoothed by Gaussians: kernel regression, local and linear, of the logarithm of readings over a fitted sum of
/// lobes. Far from all readings the lobes alone remain.
///
/// ```
/// use glanz_math::Vec3;
/// use glanz_measure::{Measured, Smoothed};
///
/// let mut text = String::from("theta_i_deg,phi_i_deg,theta_o_deg,phi_o_deg,Y\n");
/// for theta_i in (0..80).step_by(5) {
///     for theta_o in (-80..80).step_by(5) {
///         let phi = if theta_o < 0 { 180 } else { 0 };
///         // A matte surface, read with an error of 2 % that has no rule.
///         let noise = 1.0 + 0.02 * f64::from(i32::rem_euclid(theta_i * 7 + theta_o * 11, 13) - 6) / 6.0;
///         text += &format!("{theta_i},180,{},{phi},{}\n", i32::abs(theta_o), 0.2 * noise);
///     }
/// }
/// let measured = Measured::read(text.as_bytes(), "matte.csv", &Default::default())?;
/// let smoothed = Smoothed::of(&measured, None)?;
/// let (wi, wo) = (Vec3::from_angles(0.4, std::f64::consts::PI), Vec3::from_angles(0.63, 0.0));
/// let (values, _) = smoothed.value(wi, wo);
/// assert!((values[0] - 0.2).abs() < 0.002);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Smoothed {
    channels: Positive,
    carrier: Carrier,
    kernel: Kernel,
    /// The azimuth of the x axis of carrier and kernel, in radians.
    azimuth: f64,
}

/// By whether there is a grain.
#[derive(Clone, Debug)]
enum Kernel {
    Isotropic(Smooth<Isotropic>),
    Grained(Smooth<Grained>),
}

impl Smoothed {
    /// The readings of a file, of tables those at their nodes. The neighbourhood of a direction has so many readings, or as
    /// many as tell readings best from the others where nothing is said.
    ///
    /// # Errors
    ///
    /// [`FitError`] where no sum of lobes can be fitted.
    pub fn of(measured: &Measured, neighbours: Option<usize>) -> Result<Self, FitError> {
        let neighbours = neighbours.map(|count| count.max(1));
        let readings = measured.readings();
        let channels = Positive::new(readings.channels());
        let readings = channels.readings(&readings);
        let carrier = Carrier::fitted(&readings)?;
        let kernel = Kernel::Isotropic(Smooth::new(&readings, &carrier, neighbours));
        let isotropic = Self { channels, carrier, kernel, azimuth: 0.0 };
        if measured.is_isotropic() || !readings.have_turns() {
            return Ok(isotropic);
        }
        let grained = Carrier::grained(&readings);
        let (carrier, azimuth) = grained.unwrap_or_else(|| (isotropic.carrier.clone(), 0.0));
        let turned = if azimuth == 0.0 { readings } else { readings.turned(-azimuth) };
        let kernel = Kernel::Grained(Smooth::new(&turned, &carrier, neighbours));
        let grained = Self { channels: isotropic.channels.clone(), carrier, kernel, azimuth };
        Ok(if grained.noise() < GRAIN * isotropic.noise() { grained } else { isotropic })
    }

    /// What the values belong to.
    pub fn channels(&self) -> &Channels {
        self.channels.own()
    }

    /// Whether the readings show a grain: they are told better where the azimuth of the half vector counts.
    pub fn is_anisotropic(&self) -> bool {
        matches!(self.kernel, Kernel::Grained(_))
    }

    /// How many readings count.
    pub fn readings(&self) -> usize {
        match &self.kernel {
            Kernel::Isotropic(smooth) => smooth.len(),
            Kernel::Grained(smooth) => smooth.len(),
        }
    }

    /// How many readings the neighbourhoods have that tell readings best from the others.
    pub fn neighbours(&self) -> usize {
        match &self.kernel {
            Kernel::Isotropic(smooth) => smooth.neighbours,
            Kernel::Grained(smooth) => smooth.neighbours,
        }
    }

    /// The mean difference of the logarithms of readings from what their neighbours tell of them: noise, and what the
    /// neighbourhood is too wide for.
    pub fn noise(&self) -> f64 {
        self.kernel.error()
    }

    /// The BRDF in 1/sr at a pair of directions above the horizon, by channels, and how far the nearest reading is in
    /// (⁴√(1 − n·h), √(1 − wo·h), (cosθi − cosθo) / 2).
    pub fn value(&self, wi: Vec3<f64>, wo: Vec3<f64>) -> (Vec<f64>, f64) {
        let [wi, wo] = [wi, wo].map(|w| turned(w, -self.azimuth));
        let (mut factors, nearest) = self.factors(wi, wo);
        factors.iter_mut().zip(self.carrier.values(wi, wo)).for_each(|(factor, carrier)| *factor *= carrier);
        (self.channels.from(factors), nearest)
    }

    /// The azimuth of the x axis of what is known of the surface, in radians: that of an oblique grain, else 0.
    pub(super) fn azimuth(&self) -> f64 {
        self.azimuth
    }

    pub(super) fn positive(&self) -> &Positive {
        &self.channels
    }

    pub(super) fn carrier(&self) -> &Carrier {
        &self.carrier
    }

    /// What the BRDF is over the carrier, by positive channels, and how far the nearest reading is; directions are those of the
    /// carrier's axes.
    pub(super) fn factors(&self, wi: Vec3<f64>, wo: Vec3<f64>) -> (Vec<f64>, f64) {
        match &self.kernel {
            Kernel::Isotropic(smooth) => smooth.factors(wi, wo),
            Kernel::Grained(smooth) => smooth.factors(wi, wo),
        }
    }
}

impl Kernel {
    fn error(&self) -> f64 {
        match self {
            Self::Isotropic(smooth) => smooth.error,
            Self::Grained(smooth) => smooth.error,
        }
    }
}

/// A direction turned about the normal by an angle in radians.
pub(super) fn turned(w: Vec3<f64>, angle: f64) -> Vec3<f64> {
    if angle == 0.0 {
        return w;
    }
    let (sin, cos) = libm::sincos(angle);
    Vec3::new(cos * w.x - sin * w.y, sin * w.x + cos * w.y, w.z)
}
