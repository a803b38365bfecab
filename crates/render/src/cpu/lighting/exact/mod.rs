//! Extended lights as they are: every lobe with every light by points, in place of what is prepared for them.
//!
//! Points are put in the light, in the lobes, in the hemisphere and where an environment is bright. Each of these ways knows how
//! dense its points are in any direction, so a point counts 1 / Σ_k n_k p_k(ω), the balance heuristic of E. Veach and
//! L. J. Guibas, "Optimally Combining Sampling Techniques for Monte Carlo Rendering", 1995: the sum is right whatever is
//! proposed, and soon where one of the ways is alike. Points are the same for all pixels and pictures.

mod area;
mod brightness;
mod environment;
mod gather;
mod mixture;
mod points;
mod proposal;

use brightness::Brightness;
use points::{Part, Purpose, SquarePoint, spread};

pub(crate) use area::add as add_area;
pub(crate) use environment::add as add_environment;
pub(crate) use proposal::Proposal;

use crate::view::lights::ViewLight;
use crate::view::{ExactLighting, Half};

/// The points of a frame.
pub(crate) struct ExactPoints {
    pub(crate) asked: ExactLighting,
    count: usize,
    light: Vec<SquarePoint>,
    hemisphere: Vec<SquarePoint>,
    lobe: Vec<SquarePoint>,
    /// Where environments are bright, by their numbers; none of those that are the same everywhere.
    brightness: Vec<(usize, Brightness)>,
}

/// How many points each way has: all of them, so that none is at the expense of another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Counts {
    light: usize,
    /// Of each lobe.
    lobe: usize,
    /// Of each side that light can come from.
    hemisphere: usize,
}

impl ExactPoints {
    pub(crate) fn new(exact: ExactLighting, lights: &[ViewLight]) -> Self {
        let part = match exact.half {
            None => Part::Whole,
            Some(Half::First) => Part::Half(0),
            Some(Half::Second) => Part::Half(1),
        };
        let [light, hemisphere, lobe] = [Purpose::Light, Purpose::Hemisphere, Purpose::Lobe]
            .map(|purpose| spread(exact.points.max(2) as usize, part, purpose));
        let count = light.len();
        let bright = |of: &ViewLight| match of {
            ViewLight::Environment { environment, number, .. } => {
                let map = environment.map.as_deref()?;
                Some((*number, Brightness::new(map, &light)))
            }
            _ => None,
        };
        let brightness = lights.iter().filter_map(bright).collect();
        Self { asked: exact, count, light, hemisphere, lobe, brightness }
    }

    /// Where an environment is bright.
    fn brightness(&self, number: usize) -> Option<&Brightness> {
        let known = self.brightness.iter().find(|(own, _)| *own == number);
        known.map(|(_, brightness)| brightness)
    }

    /// The points for a light in which points can be put, or not, on a surface that light reaches from so many sides.
    fn counts(&self, in_light: bool, sides: usize) -> Counts {
        let light = if in_light { self.count } else { 0 };
        Counts { light, lobe: self.count, hemisphere: self.count.div_ceil(sides) }
    }
}
