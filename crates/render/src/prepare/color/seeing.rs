//! What the stages of an eye need to know of the light of a scene.

use glanz_color::Observer;
use glanz_eye::{Angles, LEVELS, Seeing, Viewer};
use glanz_scene::{Light, White};

use super::observation::{Observation, ObservationError, scaled};
use super::white::ToXyz;

/// x and y of the colour that H. W. Jensen et al. (2000) give to what rods see.
const NIGHT_BLUE: [f64; 2] = [0.25, 0.25];

impl Observation {
    /// An eye that looks at frames of this observation, which must be its own.
    ///
    /// # Errors
    /// If the scene has no light that could be a white.
    pub(crate) fn seeing(
        &self,
        viewer: &Viewer,
        (lights, photometric): (&[Light], bool),
        white: White,
        angles: Angles,
    ) -> Result<Seeing, ObservationError> {
        let own = self.own_white(lights, white)?;
        let gains: Vec<f64> = own.gains().collect();
        let gains = core::array::from_fn(|c| gains.get(c).copied().unwrap_or(1.0));
        let usual = viewer.eye.with_usual_cones().observer();
        let usual_white = Self { weights: scaled(&usual), observer: Some(usual.clone()), ..self.clone() }
            .white(lights, white)?;
        let standard = viewer.eye.standard().observer();
        let (white, rod_color) = whites(&standard, &own.reference);
        let day = LEVELS.iter().find(|(name, _)| *name == "day").map_or(1e3, |(_, level)| *level);
        Ok(Seeing {
            viewer: viewer.clone(),
            own_white: own.own,
            usual_white,
            gains,
            scales: scales(&usual),
            white,
            rod_color,
            unit_cd_m2: if photometric { 1.0 } else { viewer.viewing.level_cd_m2.unwrap_or(day) },
            angles,
        })
    }
}

/// What is white, and what the night is, in the channels of the standard eye, of luminance 1.
fn whites(standard: &Observer, reference: &[f64]) -> ([f64; 3], [f64; 3]) {
    let to_xyz = ToXyz::new(standard);
    let columns: [[f64; 3]; 3] = core::array::from_fn(|c| to_xyz.column(c));
    let by_y = |channels: [f64; 3]| {
        let y: f64 = channels.iter().zip(&columns).map(|(value, column)| value * column[1]).sum();
        channels.map(|value| value / y)
    };
    let seen: [f64; 3] = core::array::from_fn(|c| reference.get(c).copied().unwrap_or(1.0));
    let [x, y] = NIGHT_BLUE;
    let night = glanz_color::Matrix3::from_columns(columns).inverse().apply([x / y, 1.0, (1.0 - x - y) / y]);
    // Bluer than the white by as much as it is bluer than daylight, for which all channels are 1.
    (by_y(seen), by_y(core::array::from_fn(|c| night[c] * seen[c])))
}

/// By what the sensitivities of an observer's channels are multiplied in frames.
fn scales(observer: &Observer) -> [f64; 3] {
    let weights = scaled(observer);
    core::array::from_fn(|c| {
        let (scaled, own) = (weights[c].max(), observer.channels[c].sensitivity.max());
        scaled / own
    })
}
