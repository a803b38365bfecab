//! Where goniometers go: pairs of directions to the light and to the detector.

use glanz_math::Vec3;

use crate::format::merl_cells;

/// Angles of the light from the normal, in degrees.
const LIGHTS_DEG: [f64; 6] = [0.0, 15.0, 30.0, 45.0, 60.0, 75.0];
/// The farthest detector from the normal.
const FARTHEST_DEG: u32 = 85;
/// The step of the detector from the normal, and that around it, in degrees.
const STEP_DEG: u32 = 5;
const AROUND_DEG: u32 = 15;
/// Turns of a sample with a grain, in degrees.
const TURNS_DEG: [f64; 6] = [0.0, 30.0, 60.0, 90.0, 120.0, 150.0];

/// The least |sin θo − sin θi| beside the mirror direction, and how many there are on each side.
const LEAST_SINE: f64 = 0.002;
const BESIDE: u32 = 40;
/// From one of them to the next: the last is 2.
const RATIO: f64 = 1.194;

/// Of more cells every n-th counts.
const MOST_CELLS: usize = 20_000;

/// Where light and detector of a goniometer go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Geometry {
    /// In the plane of light and normal, every 5° to both sides.
    InPlane,
    /// All over the hemisphere, every 5° from the normal and 15° around it.
    Hemisphere,
    /// In the plane of light and normal, dense about the mirror direction: even steps of the logarithm of |sin θo − sin θi|,
    /// as scatterometers scan.
    Scatterometer,
    /// The middles of MERL's cells, every n-th of them, so that there are about 20 000.
    Merl,
}

impl Geometry {
    /// The directions to the light and to the detector. Light comes from 180°, at 0, 15, 30, 45, 60 and 75° from the normal, but
    /// for MERL's cells, where the half vector lies at 0°. A sample with a grain is turned, too: six times where detectors are
    /// all around, else four times.
    ///
    /// ```
    /// use glanz_measure::Geometry;
    ///
    /// let pairs = Geometry::InPlane.pairs(false);
    /// assert_eq!(pairs.len(), 6 * 35);
    /// assert!(pairs.iter().all(|[wi, wo]| wi.z > 0.0 && wo.z > 0.0));
    /// ```
    pub fn pairs(self, has_grain: bool) -> Vec<[Vec3<f64>; 2]> {
        let turns = match (has_grain, self) {
            (false, _) => &TURNS_DEG[..1],
            (true, Self::Hemisphere | Self::Merl) => &TURNS_DEG[..],
            // Along and across alone tell neither the grain's azimuth nor, so, its widths.
            (true, Self::InPlane | Self::Scatterometer) => &[0.0, 45.0, 90.0, 135.0],
        };
        if self == Self::Merl {
            let cells = merl_cells();
            // An odd step meets all azimuths of the difference vector in turn.
            let step = (cells.len() / MOST_CELLS) | 1;
            let turn = |(index, pair): (usize, [Vec3<f64>; 2])| turned(pair, turns[index % turns.len()]);
            return cells.into_iter().step_by(step).enumerate().map(turn).collect();
        }
        let of_light = |theta_i: &f64| {
            let wi = at(*theta_i, 180.0);
            self.detectors(*theta_i).into_iter().map(move |wo| [wi, wo])
        };
        let all: Vec<_> = LIGHTS_DEG.iter().flat_map(of_light).collect();
        turns.iter().flat_map(|turn| all.iter().map(|pair| turned(*pair, *turn))).collect()
    }

    fn detectors(self, theta_i: f64) -> Vec<Vec3<f64>> {
        if self == Self::Scatterometer {
            return beside_mirror(theta_i);
        }
        let around = if self == Self::InPlane { 180 } else { AROUND_DEG };
        let mut all = vec![at(0.0, 0.0)];
        for theta_o in (STEP_DEG..=FARTHEST_DEG).step_by(STEP_DEG as usize) {
            all.extend((0..360 / around).map(|step| at(f64::from(theta_o), f64::from(around * step))));
        }
        all
    }
}

/// Detectors in the plane, from the light's side to the other one.
fn beside_mirror(theta_i: f64) -> Vec<Vec3<f64>> {
    let (mirror, farthest) =
        (libm::sin(theta_i.to_radians()), libm::sin(f64::from(FARTHEST_DEG).to_radians()));
    let off = |step: u32| LEAST_SINE * libm::pow(RATIO, f64::from(step));
    let below = (0..BESIDE).rev().map(|step| mirror - off(step));
    let sines = below.chain([mirror]).chain((0..BESIDE).map(|step| mirror + off(step)));
    let direction = |sine: f64| Vec3::new(sine, 0.0, libm::sqrt(1.0 - sine * sine));
    sines.filter(|sine| sine.abs() <= farthest).map(direction).collect()
}

fn at(theta_deg: f64, phi_deg: f64) -> Vec3<f64> {
    Vec3::from_angles(theta_deg.to_radians(), phi_deg.to_radians())
}

/// Both directions about the normal.
fn turned(pair: [Vec3<f64>; 2], degrees: f64) -> [Vec3<f64>; 2] {
    if degrees == 0.0 {
        return pair;
    }
    let (sin, cos) = libm::sincos(degrees.to_radians());
    pair.map(|w| Vec3::new(w.x * cos - w.y * sin, w.x * sin + w.y * cos, w.z))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_geometry_stays_above_the_horizon_and_turns_what_has_a_grain() {
        for (geometry, count, of_grain) in [
            (Geometry::InPlane, 210, 840),
            (Geometry::Hemisphere, 6 * (1 + 17 * 24), 36 * (1 + 17 * 24)),
            (Geometry::Merl, 19_932, 19_932),
        ] {
            let (plain, grain) = (geometry.pairs(false), geometry.pairs(true));
            assert_eq!((plain.len(), grain.len()), (count, of_grain), "{geometry:?}");
            assert!(plain.iter().chain(&grain).all(|[wi, wo]| wi.z > 0.0 && wo.z > 0.0));
            // Turning changes azimuths alone.
            let angle = |pairs: &[[Vec3<f64>; 2]]| pairs.last().map(|[wi, wo]| wi.dot(*wo));
            assert!((angle(&plain).unwrap() - angle(&grain).unwrap()).abs() < 1e-12);
        }
    }

    #[test]
    fn a_scatterometer_is_dense_about_the_mirror_direction() {
        let pairs = Geometry::Scatterometer.pairs(false);
        let at_45: Vec<f64> = pairs
            .iter()
            .filter(|[wi, _]| (wi.z - libm::cos(45.0_f64.to_radians())).abs() < 1e-12)
            .map(|[_, wo]| libm::asin(wo.x).to_degrees())
            .collect();
        let within = |degrees: f64| at_45.iter().filter(|theta| (**theta - 45.0).abs() < degrees).count();
        assert!(within(1.0) >= 15 && at_45.len() < 80, "{} of {}", within(1.0), at_45.len());
        assert!(at_45.windows(2).all(|pair| pair[0] < pair[1]) && at_45[0] < -60.0, "{at_45:?}");
    }
}
