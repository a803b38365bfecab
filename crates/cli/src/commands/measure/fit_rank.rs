//! The order of fits.

use std::path::Path;

use clap::ValueEnum;
use glanz_color::light;
use glanz_measure::{Channels, Measured};
use glanz_scene::file::{LoadOptions, parse_str};
use glanz_scene::{LightColor, Material};

use super::balls::{Balls, Drawn};
use super::fit_facts::Candidate;
use super::fitted_material::material;
use super::surface::Surface;
use crate::load::failure_of_scene;
use crate::print::failure::{Failure, Report};
use crate::progress::Progress;

/// What fits are ranked by.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(super) enum RankBy {
    /// The error that was made small
    #[default]
    Metric,
    /// The mean CIEDE2000 of readings as points of a sphere
    Rendered,
    /// The mean CIEDE2000 of balls in a studio
    Balls,
}

impl RankBy {
    /// Its name.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Metric => "metric",
            Self::Rendered => "rendered",
            Self::Balls => "balls",
        }
    }
}

/// Width and height of balls, in pixels.
const SIZE: (u32, u32) = (192, 192);

/// Puts the best one first.
pub(super) fn rank(
    fits: &mut [Candidate],
    by: RankBy,
    measured: &Measured,
    file: &Path,
) -> Result<(), Failure> {
    if by == RankBy::Balls {
        draw(fits, measured, file)?;
    }
    let key = |candidate: &Candidate| match by {
        RankBy::Metric => candidate.fit.error,
        RankBy::Rendered => candidate.delta_e.mean,
        RankBy::Balls => candidate.balls.last().map_or(f64::INFINITY, |(_, spread)| spread.mean),
    };
    fits.sort_by(|a, b| key(a).total_cmp(&key(b)));
    Ok(())
}

/// Balls of the data and of each fit, under lamps and in a studio.
fn draw(fits: &mut [Candidate], measured: &Measured, file: &Path) -> Result<(), Failure> {
    let readings = measured.readings();
    if *readings.channels() == Channels::Xyz {
        let report =
            Report::new("readings in XYZ are no colours of a material, of which balls could be drawn");
        return Err(report
            .file(file)
            .help("rank by rendered, or give readings in RGB or wavelengths")
            .into());
    }
    let d65 = light("D65").map_err(Failure::new)?;
    let lamp = LightColor::unit(&d65).ok_or_else(|| Failure::new("D65 sends no light"))?;
    let mut progress = Progress::new(Drawn::PICTURES * (fits.len() + 1), "pictures");
    let surface = Surface::of_measured(measured, file)?;
    let reference = Drawn::of(&surface.material, &lamp, SIZE, &mut progress)?;
    for candidate in fits {
        let own = fitted(readings.channels(), candidate)?;
        let drawn = Drawn::of(&own, &lamp, SIZE, &mut progress)?;
        candidate.balls = Balls::of([reference.clone(), drawn], SIZE)?.spreads().into();
    }
    Ok(())
}

/// The material that a fit is written as.
fn fitted(channels: &Channels, candidate: &Candidate) -> Result<Material, Failure> {
    let text = material(channels, &candidate.fit).unwrap_or_default();
    let loaded = parse_str(&text, Path::new(""), &LoadOptions::default());
    let scene = loaded.map_err(|error| failure_of_scene(error, "--models"))?.scene;
    scene.materials.into_iter().next().ok_or_else(|| Failure::new("a fit has lobes"))
}
