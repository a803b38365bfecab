//! `glanz color efficiency`: the error of colours by the number and choice of samples.

use std::fmt::Write;
use std::path::Path;

use clap::Args;
use glanz_color::efficiency::{Errors, Representation};
use glanz_color::{Spectrum, colorchecker, reflectance, reflectances};
use glanz_plot::figure::{EfficiencyLine, EfficiencyPanel};
use glanz_plot::{EfficiencyChart, Lang, Word};
use schemars::JsonSchema;
use serde::Serialize;

use crate::args::{BesidePlotArgs, light_words};
use crate::input::spectra::{light_source, surfaces};
use crate::print::failure::Failure;
use crate::print::{self, FormatArgs};

/// Shown below the help.
pub(crate) const EXAMPLES: &str = "Examples:
  glanz color efficiency
  glanz color efficiency --light D65,A --surfaces samples --plot efficiency.png
  glanz color efficiency --surfaces patches.csv --format json

Each cell is the mean ΔE00 over the set, and the greatest in brackets, against sums over 300 to
780 nm by 5 nm. Each way has its own white, the perfect diffuser computed that way. 'uniform,
300-780 nm' takes the wavelengths of --mode sampled:N; 'sRGB product' multiplies the light's
linear sRGB by the surface's; 'Meyer' takes four wavelengths (Meyer 1988) with the published
weights, or with weights solved for the light. In the plot, errors below 0.02 stand at the
lower edge.";

/// The lights that `all` stands for.
const ALL: &str = "E,D65,A,FL2,FL11,LED-B3";

/// The numbers of uniform samples that the table shows.
const SHOWN: [usize; 8] = [3, 4, 6, 8, 12, 16, 24, 32];

/// Options of `glanz color efficiency`.
#[derive(Args, Debug)]
pub(crate) struct EfficiencyArgs {
    #[command(flatten)]
    what: WhatArgs,

    #[command(flatten)]
    plot: BesidePlotArgs,

    #[command(flatten)]
    format: FormatArgs,
}

/// Which lights and surfaces.
#[derive(Args, Debug)]
pub(crate) struct WhatArgs {
    /// Lights between commas, names or files; all is E,D65,A,FL2,FL11,LED-B3
    #[arg(long, alias = "under", value_name = "LIGHT,…", default_value = "all")]
    light: Vec<String>,

    /// The surfaces: colorchecker, samples (those of colour rendering), all (both), or a file
    #[arg(long, alias = "set", value_name = "SET", default_value = "colorchecker")]
    surfaces: String,
}

/// What was found.
pub(crate) struct Found {
    set: String,
    count: usize,
    lights: Vec<String>,
    /// A representation, and its errors under each light.
    errors: Vec<(Representation, Vec<Errors>)>,
}

/// How wrong colours are that are computed with few samples of the spectrum.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    /// The set of surfaces
    set: String,
    /// How many surfaces there are
    surfaces: usize,
    /// The unit of the errors
    unit: &'static str,
    ways: Vec<WayFacts>,
}

/// A way to compute colours.
#[derive(Debug, Serialize, JsonSchema)]
struct WayFacts {
    /// Its name
    way: String,
    /// The number of samples
    samples: usize,
    /// The errors under each light
    under: Vec<ErrorsFacts>,
}

/// Errors over the surfaces under a light.
#[derive(Debug, Serialize, JsonSchema)]
struct ErrorsFacts {
    light: String,
    mean: f64,
    median: f64,
    p95: f64,
    max: f64,
}

impl EfficiencyArgs {
    /// Computes the errors, and draws them.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let plot = self.plot.target()?;
        let found = self.what.find()?;
        if let Some(plot) = plot {
            plot.save(&mut found.chart(plot.lang()))?;
        }
        match self.format.is_json() {
            true => print::json(&found.document()),
            false => print::text(&found.table()),
        }
    }
}

impl WhatArgs {
    /// Computes the errors of all representations under all lights.
    pub(crate) fn find(&self) -> Result<Found, Failure> {
        let light = match self.light.as_slice() {
            [only] if only.eq_ignore_ascii_case("all") => light_words(&[ALL.to_owned()]),
            light => light_words(light),
        }?;
        let lights = light.iter().map(|word| light_source(word)).collect::<Result<Vec<_>, _>>()?;
        for light in &lights {
            // Errors are relative to the white of each representation.
            if glanz_color::chromaticity::Chromaticity::of_light(&light.spectrum).is_none() {
                return Err(Failure::Usage(format!("no observer sees the light '{}'", light.name)));
            }
        }
        let surfaces = self.spectra()?;
        let errors = |representation: Representation| {
            lights.iter().map(|light| representation.errors(&surfaces, &light.spectrum)).collect()
        };
        Ok(Found {
            set: self.surfaces.clone(),
            count: surfaces.len(),
            lights: lights.iter().map(|light| light.name.clone()).collect(),
            errors: Representation::all().into_iter().map(|one| (one, errors(one))).collect(),
        })
    }

    fn spectra(&self) -> Result<Vec<Spectrum>, Failure> {
        let checker = || colorchecker().map(|(_, spectrum)| spectrum);
        let known: Vec<_> = colorchecker().map(|(name, _)| name).collect();
        let samples = || {
            let others = reflectances().iter().filter(|info| !known.contains(&info.name));
            others.filter_map(|info| reflectance(info.name).ok())
        };
        match self.surfaces.to_lowercase().as_str() {
            "colorchecker" => Ok(checker().collect()),
            "samples" => Ok(samples().collect()),
            "all" => Ok(checker().chain(samples()).collect()),
            _ if Path::new(&self.surfaces).exists() => surfaces(&self.surfaces),
            _ => {
                let message = "and no file of that name; expected colorchecker, samples, all or a file";
                Err(Failure::Usage(format!("there is no set '{}', {message}", self.surfaces)))
            }
        }
    }
}

impl Found {
    /// The plot: a panel for each light.
    pub(crate) fn chart(&self, lang: Lang) -> EfficiencyChart {
        let kinds = [
            Representation::Uniform(0),
            Representation::UniformVisible(0),
            Representation::Rgb,
            Representation::Meyer,
            Representation::MeyerAdapted,
        ];
        let panel = |(index, light): (usize, &String)| EfficiencyPanel {
            light: light.clone(),
            lines: kinds
                .iter()
                .map(|kind| {
                    let of_kind = self.errors.iter().filter(|(one, _)| one.name() == kind.name());
                    let points = of_kind.map(|(one, errors)| (one.samples(), errors[index].mean));
                    EfficiencyLine { name: lang.name(kind.name()).to_owned(), points: points.collect() }
                })
                .collect(),
        };
        EfficiencyChart {
            title: lang.say(Word::Efficiency, &[]),
            subtitle: lang.say(Word::EfficiencyOver, &[&self.count.to_string(), &self.set]),
            lights: self.lights.iter().enumerate().map(panel).collect(),
            lang,
        }
    }

    fn document(&self) -> Document {
        let under = |(light, errors): (&String, &Errors)| {
            let Errors { mean, median, p95, max } = *errors;
            ErrorsFacts { light: light.clone(), mean, median, p95, max }
        };
        let way = |(one, errors): &(Representation, Vec<Errors>)| WayFacts {
            way: one.name().to_owned(),
            samples: one.samples(),
            under: self.lights.iter().zip(errors).map(under).collect(),
        };
        Document {
            set: self.set.clone(),
            surfaces: self.count,
            unit: "ΔE00",
            ways: self.errors.iter().map(way).collect(),
        }
    }

    fn table(&self) -> String {
        let mut text = format!("ΔE00 over {} surfaces of '{}': mean (greatest)\n", self.count, self.set);
        let mut line =
            |line: String| writeln!(text, "{}", line.trim_end()).expect("a string takes everything");
        let heads: Vec<_> = self.lights.iter().map(|light| format!("{light:>14}")).collect();
        line(format!("{:<20} {:>7} {}", "samples", "number", heads.join(" ")));
        for (one, errors) in &self.errors {
            let uniform = matches!(one, Representation::Uniform(_) | Representation::UniformVisible(_));
            if uniform && !SHOWN.contains(&one.samples()) {
                continue;
            }
            let cells: Vec<_> = errors
                .iter()
                .map(|errors| format!("{:>14}", format!("{:.2} ({:.2})", errors.mean, errors.max)))
                .collect();
            line(format!("{:<20} {:>7} {}", one.name(), one.samples(), cells.join(" ")));
        }
        text
    }
}
