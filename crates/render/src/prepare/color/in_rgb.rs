//! Lights and tints in linear sRGB, as mode `rgb` takes them, for programs that know nothing else.

use glanz_color::Rgb;
use glanz_scene::{LightColor, Tint};

use super::quadrature::{Sampling, Triple};

/// The colour of a light.
pub(crate) fn light(color: &LightColor) -> Triple {
    triple(&Sampling::rgb().light(color))
}

/// What a tint sends back of white light; at normal incidence, where that changes with the angle.
pub(crate) fn tint(tint: &Tint) -> Triple {
    // Bit by bit what the user wrote.
    if let Tint::Rgb(Rgb(rgb)) = tint {
        return rgb.map(f64::from);
    }
    let sampling = Sampling::rgb();
    let white = sampling.white();
    sampling.response(&sampling.surface(tint, 1.0), None).under(&white)
}

/// What a tint of a surface's own light sends.
pub(crate) fn emitted(tint: &Tint) -> Triple {
    Sampling::rgb().emitted(tint, None)
}

fn triple(row: &[f64]) -> Triple {
    core::array::from_fn(|c| row.get(c).copied().unwrap_or(0.0))
}
