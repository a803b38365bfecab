//! Directions with values.

use std::collections::BTreeSet;
use std::fmt;

use glanz_math::Vec3;

/// What the numbers of a file are.
///
/// ```
/// use glanz_measure::Quantity;
///
/// let quantity = Quantity::named("reflectance-factor").expect("it is one");
/// assert_eq!(quantity.brdf(std::f64::consts::PI, 0.5), Some(1.0));
/// assert_eq!(Quantity::BrdfCos.brdf(0.1, 0.5), Some(0.2));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Quantity {
    /// The BRDF f, in 1/sr.
    #[default]
    Brdf,
    /// f times the cosine of the detector's angle (what scatterometers call the cosine-corrected BSDF, or DSF).
    BrdfCos,
    /// π f: the radiance factor, 1 for a perfect diffuser.
    RadianceFactor,
}

impl Quantity {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Brdf, Self::BrdfCos, Self::RadianceFactor];

    /// The word for it in files and on command lines.
    pub fn name(self) -> &'static str {
        match self {
            Self::Brdf => "brdf",
            Self::BrdfCos => "brdf_cos",
            Self::RadianceFactor => "reflectance_factor",
        }
    }

    /// The one of this name; `radiance_factor`, `pi_f`, `f_cos` and `dsf` are understood, too.
    pub fn named(name: &str) -> Option<Self> {
        Some(match name.trim().to_lowercase().replace('-', "_").as_str() {
            "brdf" | "f" => Self::Brdf,
            "brdf_cos" | "f_cos" | "dsf" => Self::BrdfCos,
            "reflectance_factor" | "radiance_factor" | "pi_f" => Self::RadianceFactor,
            _ => return None,
        })
    }

    /// The BRDF, of a number of this kind; `cos_o` is the detector's cosine. Nothing at the horizon, where a product with
    /// the cosine says nothing.
    pub fn brdf(self, value: f64, cos_o: f64) -> Option<f64> {
        match self {
            Self::Brdf => Some(value),
            Self::BrdfCos => (cos_o > 1e-4).then(|| value / cos_o),
            Self::RadianceFactor => Some(value * core::f64::consts::FRAC_1_PI),
        }
    }

    /// A number of this kind, of the BRDF.
    pub fn of_brdf(self, brdf: f64, cos_o: f64) -> f64 {
        match self {
            Self::Brdf => brdf,
            Self::BrdfCos => brdf * cos_o,
            Self::RadianceFactor => brdf * core::f64::consts::PI,
        }
    }
}

/// What the values of a reading belong to.
///
/// ```
/// use glanz_measure::Channels;
///
/// let spectral = Channels::Wavelengths(vec![450.0, 550.0, 650.0]);
/// assert_eq!((spectral.count(), Channels::Rgb.count()), (3, 3));
/// assert_eq!(Channels::Xyz.names(), ["X", "Y", "Z"]);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum Channels {
    /// One number for all light, or for a photometric eye.
    Luminance,
    /// Red, green and blue of some camera.
    Rgb,
    /// Tristimulus values.
    Xyz,
    /// Wavelengths in nm, ascending.
    Wavelengths(Vec<f64>),
}

impl Channels {
    /// How many there are.
    pub fn count(&self) -> usize {
        match self {
            Self::Luminance => 1,
            Self::Rgb | Self::Xyz => 3,
            Self::Wavelengths(list) => list.len(),
        }
    }

    /// Their names, as columns of a table.
    pub fn names(&self) -> Vec<String> {
        match self {
            Self::Luminance => vec!["Y".to_owned()],
            Self::Rgb => ["r", "g", "b"].map(str::to_owned).to_vec(),
            Self::Xyz => ["X", "Y", "Z"].map(str::to_owned).to_vec(),
            Self::Wavelengths(list) => list.iter().map(|nm| format!("{nm}nm")).collect(),
        }
    }
}

impl fmt::Display for Channels {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Luminance => f.write_str("one channel"),
            Self::Rgb => f.write_str("RGB"),
            Self::Xyz => f.write_str("XYZ"),
            Self::Wavelengths(list) => match (list.first(), list.last()) {
                (Some(first), Some(last)) => write!(f, "{} wavelengths, {first} to {last} nm", list.len()),
                _ => f.write_str("no wavelengths"),
            },
        }
    }
}

/// Azimuths of the light, in whole degrees, that tell anisotropy.
const LEAST_AZIMUTHS: usize = 3;

/// Readings: pairs of directions with a value for each channel, in any order.
///
/// ```
/// use glanz_math::Vec3;
/// use glanz_measure::{Channels, Readings};
///
/// let mut readings = Readings::new(Channels::Rgb);
/// let up = Vec3::from_angles(0.0, 0.0);
/// readings.push(up, Vec3::from_angles(0.5, 0.0), &[0.2, 0.3, 0.4]);
/// assert_eq!((readings.len(), readings.values(0)), (1, &[0.2, 0.3, 0.4][..]));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Readings {
    channels: Channels,
    pairs: Vec<[Vec3<f64>; 2]>,
    values: Vec<f32>,
    /// One for each reading, or none at all where all are 1.
    weights: Vec<f32>,
}

impl Readings {
    /// None yet.
    pub fn new(channels: Channels) -> Self {
        Self { channels, pairs: Vec::new(), values: Vec::new(), weights: Vec::new() }
    }

    /// Adds the BRDF, in 1/sr, at a pair of directions, to the light and to the detector. Numbers that are missing are
    /// NaN; what there is more than channels counts for nothing.
    pub fn push(&mut self, wi: Vec3<f64>, wo: Vec3<f64>, values: &[f32]) {
        self.push_weighted(wi, wo, values, 1.0);
    }

    /// The same with a weight: how much the reading counts in fits, where 1 is as much as others do, and 0 not at all. A
    /// reading of twice the standard deviation has a quarter of the weight.
    ///
    /// ```
    /// use glanz_math::Vec3;
    /// use glanz_measure::{Channels, Readings};
    ///
    /// let (mut readings, up) = (Readings::new(Channels::Luminance), Vec3::from_angles(0.0, 0.0));
    /// readings.push(up, up, &[0.3]);
    /// readings.push_weighted(up, up, &[0.4], 0.25);
    /// assert_eq!([readings.weight(0), readings.weight(1)], [1.0, 0.25]);
    /// ```
    pub fn push_weighted(&mut self, wi: Vec3<f64>, wo: Vec3<f64>, values: &[f32], weight: f32) {
        if weight != 1.0 && self.weights.is_empty() {
            self.weights.resize(self.pairs.len(), 1.0);
        }
        if weight != 1.0 || !self.weights.is_empty() {
            self.weights.push(weight);
        }
        self.pairs.push([wi, wo]);
        let count = self.channels.count();
        self.values.extend((0..count).map(|c| values.get(c).copied().unwrap_or(f32::NAN)));
    }

    /// What the values belong to.
    pub fn channels(&self) -> &Channels {
        &self.channels
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.pairs.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.pairs.is_empty()
    }

    /// The directions to the light and to the detector of one of them.
    pub fn pair(&self, index: usize) -> [Vec3<f64>; 2] {
        self.pairs[index]
    }

    /// How much it counts in fits.
    pub fn weight(&self, index: usize) -> f32 {
        self.weights.get(index).copied().unwrap_or(1.0)
    }

    /// Whether weights differ from 1.
    pub fn has_weights(&self) -> bool {
        !self.weights.is_empty()
    }

    /// Whether light came from so many azimuths that anisotropy would show.
    pub(crate) fn have_turns(&self) -> bool {
        let azimuth = |[wi, _]: &[Vec3<f64>; 2]| {
            (wi.z < 0.999).then(|| libm::round(libm::atan2(wi.y, wi.x).to_degrees()) as i32)
        };
        let mut azimuths = BTreeSet::new();
        self.pairs.iter().filter_map(azimuth).any(|azimuth| {
            azimuths.insert(azimuth);
            azimuths.len() >= LEAST_AZIMUTHS
        })
    }

    /// The same, of the sample turned about its normal by this angle, in radians.
    pub(crate) fn turned(&self, angle: f64) -> Self {
        let (sin, cos) = libm::sincos(angle);
        let turn = |w: Vec3<f64>| Vec3::new(cos * w.x - sin * w.y, sin * w.x + cos * w.y, w.z);
        Self { pairs: self.pairs.iter().map(|pair| pair.map(turn)).collect(), ..self.clone() }
    }

    /// Its values, one per channel.
    pub fn values(&self, index: usize) -> &[f32] {
        let count = self.channels.count();
        &self.values[index * count..(index + 1) * count]
    }
}
