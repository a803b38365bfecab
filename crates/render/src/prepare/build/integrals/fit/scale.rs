//! How wide a lobe is, and about what.

use glanz_bsdf::{DirectionPair, LightTerm, Shape, Side};
use glanz_math::{PI, Vec3};

/// Steps of the angle in which a lobe is taken, and azimuths.
const STEPS: usize = 200;
const AZIMUTHS: usize = 8;

/// The least angle.
const LEAST: f64 = 1e-4;

/// A lobe that has half of itself beyond this angle, seen from above, is taken about the normal.
const WIDE: f64 = 0.75;

/// The width of a highlight across at 60°, to that at 0°: of lobes about half vectors it is a half, of those about the
/// mirrored direction 1.
const BETWEEN_FORMS: f64 = 0.72;

/// Lobes about half vectors below this slope whose tails are heavy mix levels a whole octave apart.
const WIDE_BELOW: f64 = 0.15;

/// Lobes about half vectors from this slope on take a part of a cosine.
const COSINE_FROM: f64 = 0.45;

/// How much more than half of a lobe is within three times its half: of GGX 0.9, of a Gaussian 0.998.
const HEAVY: f64 = 0.95;

/// What directions of a lobe are about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    /// Half vectors about the normal.
    Half,
    /// The mirrored direction.
    Mirrored,
    /// The normal.
    Normal,
    /// The refracted direction, or the straight one.
    Refracted,
}

/// The width of a lobe.
pub(super) struct Scale {
    pub form: Form,
    /// The slope of half vectors, or the angle, within which half of it is.
    pub slope: f64,
    /// The same along the lobe's axes.
    pub axes: [f64; 2],
    /// Whether it takes a part of a cosine.
    pub takes_cosine: bool,
    /// Whether it mixes levels a whole octave apart.
    pub wide: bool,
    /// The index of what is below, of light that passes.
    pub eta: f64,
}

impl Scale {
    pub(super) fn of(shape: &Shape, term: LightTerm) -> Self {
        let passes = shape.info().side == Side::Transmission;
        let (half, heavy) = quantiles(shape);
        let across = |degrees: f64| half_width(shape, degrees, false);
        let form = match () {
            () if passes => Form::Refracted,
            () if term == LightTerm::Diffuse => Form::Normal,
            () if across(60.0) < BETWEEN_FORMS * across(0.0) && across(0.0) < PI => Form::Half,
            () if half > WIDE || across(0.0) >= PI => Form::Normal,
            () => Form::Mirrored,
        };
        let slope = match form {
            Form::Half => libm::tan(0.5 * half),
            Form::Normal => 0.75,
            _ => half,
        };
        let ratio = match shape.is_anisotropic() {
            true => libm::sqrt(half_width(shape, 0.0, true) / half_width(shape, 0.0, false)),
            false => 1.0,
        };
        Self {
            form,
            slope,
            axes: [slope * ratio, slope / ratio],
            takes_cosine: form == Form::Normal || slope > COSINE_FROM,
            wide: form == Form::Half && slope < WIDE_BELOW && heavy,
            eta: if passes { shape.eta() } else { 1.0 },
        }
    }

    /// The frame that directions are kept in: see [`Lookup::direction`](crate::prepare::data::Lookup::direction).
    pub(super) fn mirrored_frame(&self, wo: Vec3<f64>) -> [Vec3<f64>; 3] {
        let sine = libm::hypot(wo.x, wo.y);
        let towards = match sine > 1e-9 {
            true => Vec3::new(wo.x / sine, wo.y / sine, 0.0),
            false => Vec3::new(1.0, 0.0, 0.0),
        };
        let (sin, cos) = match self.form {
            Form::Refracted => {
                let sin = (sine / self.eta).min(1.0);
                (sin, libm::sqrt(1.0 - sin * sin))
            }
            _ => (sine, wo.z),
        };
        let normal = Vec3::new(0.0, 0.0, 1.0);
        [towards * cos + normal * sin, Vec3::new(-towards.y, towards.x, 0.0), normal * cos - towards * sin]
    }

    /// How many times longer than wide the lobe is.
    pub(super) fn grain(&self) -> f64 {
        let [x, y] = self.axes;
        (x / y).max(y / x)
    }
}

fn value(shape: &Shape, wo: Vec3<f64>, wi: Vec3<f64>) -> f64 {
    let below = shape.info().side == Side::Transmission;
    let wi = if below { Vec3::new(wi.x, wi.y, -wi.z) } else { wi };
    shape.f_cos(&DirectionPair::new(wo, wi)).max(0.0)
}

/// For a viewer above: the angle within which half of a lobe is, and whether its tails are heavy.
fn quantiles(shape: &Shape) -> (f64, bool) {
    let ratio = libm::pow(0.5 * PI / LEAST, 1.0 / STEPS as f64);
    let angle = |i: usize| LEAST * libm::pow(ratio, i as f64 + 0.5);
    let wo = Vec3::new(0.0, 0.0, 1.0);
    let ring = |i: usize| {
        let theta = angle(i);
        let at = |k: usize| value(shape, wo, Vec3::from_angles(theta, 2.0 * PI * k as f64 / AZIMUTHS as f64));
        (0..AZIMUTHS).map(at).sum::<f64>() * libm::sin(theta) * theta
    };
    let rings: Vec<f64> = (0..STEPS).map(ring).collect();
    let total: f64 = rings.iter().sum();
    if !(total > 0.0 && total.is_finite()) {
        return (0.5 * PI, false);
    }
    let within = |fraction: f64| {
        let mut sum = 0.0;
        let found = rings.iter().position(|ring| {
            sum += ring;
            sum >= fraction * total
        });
        angle(found.unwrap_or(STEPS - 1))
    };
    let half = within(0.5);
    (half, within(HEAVY) > 3.0 * half)
}

/// The angle from the mirrored direction at which a lobe is half of what it is there, in the plane of view or across; π
/// where it is nowhere.
fn half_width(shape: &Shape, degrees: f64, along: bool) -> f64 {
    let (sin, cos) = libm::sincos(degrees / 180.0 * PI);
    let wo = Vec3::new(sin, 0.0, cos);
    let (middle, side) =
        (Vec3::new(-sin, 0.0, cos), if along { Vec3::new(cos, 0.0, sin) } else { Vec3::new(0.0, 1.0, 0.0) });
    let at = |angle: f64| value(shape, wo, middle * libm::cos(angle) + side * libm::sin(angle));
    let half = 0.5 * at(0.0);
    let ratio = libm::pow(0.5 * PI / LEAST, 1.0 / STEPS as f64);
    let angles = (0..STEPS).map(|i| LEAST * libm::pow(ratio, i as f64 + 0.5));
    angles.into_iter().find(|angle| at(*angle) < half).unwrap_or(PI)
}
