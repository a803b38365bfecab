//! From the half planes that a file gives to all of them.

use glanz_color::read::{Place, ReadError};

use super::source::Source;
use crate::Profile;

/// Half planes nearer than this in degrees are the same: files give a few decimals.
const SAME_DEG: f64 = 1e-4;

/// What the half planes of a luminaire have in common.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Symmetry {
    /// Nothing.
    None,
    /// They are all the same.
    Round,
    /// C and −C are the same.
    Across0,
    /// C and 180° − C are the same.
    Across90,
    /// Both.
    Both,
}

impl Symmetry {
    /// The angles of the half planes that are the same as that of C.
    fn images(self, c: f64) -> impl Iterator<Item = f64> {
        let (across0, across90) =
            (matches!(self, Self::Across0 | Self::Both), matches!(self, Self::Across90 | Self::Both));
        let both = across0 && across90;
        let others = [(across0, -c), (across90, 180.0 - c), (both, 180.0 + c)];
        std::iter::once(c).chain(others.into_iter().filter(|(is, _)| *is).map(|(_, c)| c))
    }
}

/// The half planes of a file, as it gives them.
pub(super) struct Planes {
    /// Their angles in degrees.
    pub c_deg: Vec<f64>,
    /// The angles in them in degrees.
    pub gamma_deg: Vec<f64>,
    /// Intensities in cd, by half planes.
    pub candela: Vec<f64>,
    /// What is to be expanded.
    pub symmetry: Symmetry,
}

impl Planes {
    /// The whole profile.
    pub(super) fn expand(mut self, source: &mut Source) -> Result<Profile, ReadError> {
        check_gamma(&self.gamma_deg, source)?;
        source.not_negative(&mut self.candela);
        let Self { c_deg, gamma_deg, candela, symmetry } = self;
        let size = gamma_deg.len();
        if symmetry == Symmetry::Round || c_deg.len() == 1 {
            let candela = candela[..size].to_vec();
            return Ok(Profile { c_deg: vec![0.0], gamma_deg, candela });
        }
        let given = c_deg.iter().enumerate();
        let mut all: Vec<(f64, usize)> =
            given.flat_map(|(plane, c)| symmetry.images(*c).map(move |c| (turn(c), plane))).collect();
        // Stable: of the same planes the first that is given stays.
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        all.dedup_by(|next, kept| next.0 - kept.0 < SAME_DEG);
        if all[0].0 > 0.0 {
            let found = format!("{}° as the first", all[0].0);
            return Err(source.malformed(Place::File, "a half plane at 0°", found));
        }
        all.push((360.0, all[0].1));
        let values = all.iter().flat_map(|(_, plane)| &candela[plane * size..][..size]).copied().collect();
        Ok(Profile { c_deg: all.iter().map(|(c, _)| *c).collect(), gamma_deg, candela: values })
    }
}

/// The angle within 0 to 360, the upper end being the lower.
fn turn(c: f64) -> f64 {
    let c = c.rem_euclid(360.0);
    if (SAME_DEG..=360.0 - SAME_DEG).contains(&c) { c } else { 0.0 }
}

fn check_gamma(gamma_deg: &[f64], source: &Source) -> Result<(), ReadError> {
    if let Some(outside) = gamma_deg.iter().find(|gamma| !(0.0..=180.0).contains(*gamma)) {
        let found = format!("{outside}°");
        return Err(source.malformed(Place::File, "angles from the axis between 0° and 180°", found));
    }
    increasing(gamma_deg, "from the axis", source)
}

/// That angles increase.
pub(super) fn increasing(angles: &[f64], which: &str, source: &Source) -> Result<(), ReadError> {
    match angles.windows(2).find(|pair| pair[0] >= pair[1]) {
        None => Ok(()),
        Some(pair) => {
            let found = format!("{}° after {}°", pair[1], pair[0]);
            Err(source.malformed(Place::File, format!("increasing angles {which}"), found))
        }
    }
}
