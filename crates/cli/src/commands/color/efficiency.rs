//! `glanz color efficiency`: the error of colours by the number and choice of samples.

use std::fmt::Write;
use std::path::Path;

use clap::Args;
use glanz_color::{Spectrum, colorchecker, reflectance, reflectances};
use serde_json::json;

use crate::efficiency::{Errors, Way};
use crate::failure::Failure;
use crate::plot::{self, Line, Picture, PlotFile, plot_file};
use crate::print::{self, FormatArgs};
use crate::spectra::{light_source, surfaces, words};

/// Shown below the help.
pub const EXAMPLES: &str = "Examples:
  glanz color efficiency
  glanz color efficiency --under D65,A --set samples --plot efficiency.png
  glanz color efficiency --set patches.csv --format json

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
pub struct EfficiencyArgs {
    #[command(flatten)]
    what: WhatArgs,

    /// Draw the errors over the number of samples; .svg or .png
    #[arg(long, value_name = "FILE", value_parser = plot_file, help_heading = "Output")]
    plot: Option<PlotFile>,

    #[command(flatten)]
    format: FormatArgs,
}

/// Which lights and surfaces.
#[derive(Args, Debug)]
pub struct WhatArgs {
    /// Lights between commas, names or files; all is E,D65,A,FL2,FL11,LED-B3
    #[arg(long, value_name = "LIGHT,…", default_value = "all")]
    under: String,

    /// The surfaces: colorchecker, samples (those of colour rendering), all (both), or a file
    #[arg(long, value_name = "SET", default_value = "colorchecker")]
    set: String,
}

/// What was found.
pub struct Found {
    set: String,
    count: usize,
    lights: Vec<String>,
    /// A way, and its errors under each light.
    ways: Vec<(Way, Vec<Errors>)>,
}

impl EfficiencyArgs {
    /// Computes the errors, and draws them.
    pub fn run(&self) -> Result<(), Failure> {
        self.plot.as_ref().map_or(Ok(()), PlotFile::check)?;
        let found = self.what.find()?;
        if let Some(file) = &self.plot {
            file.save(&found.picture())?;
            print::note(format_args!("wrote {}", file.path().display()));
        }
        match self.format.is_json() {
            true => print::json(&found.json()),
            false => print::text(&found.table()),
        }
    }
}

impl WhatArgs {
    /// Computes the errors of all ways under all lights.
    pub fn find(&self) -> Result<Found, Failure> {
        let under = if self.under.eq_ignore_ascii_case("all") { ALL } else { &self.under };
        let under = words(under).map_err(|error| Failure::Usage(format!("--under: {error}")))?;
        let lights = under.iter().map(|word| light_source(word)).collect::<Result<Vec<_>, _>>()?;
        for light in &lights {
            // All ways divide by what each makes of the white.
            if glanz_color::chromaticity::Chromaticity::of_light(&light.spectrum).is_none() {
                return Err(Failure::Usage(format!("no eye sees the light '{}'", light.name)));
            }
        }
        let surfaces = self.surfaces()?;
        let errors = |way: Way| lights.iter().map(|light| way.errors(&surfaces, &light.spectrum)).collect();
        Ok(Found {
            set: self.set.clone(),
            count: surfaces.len(),
            lights: lights.iter().map(|light| light.name.clone()).collect(),
            ways: Way::all().into_iter().map(|way| (way, errors(way))).collect(),
        })
    }

    fn surfaces(&self) -> Result<Vec<Spectrum>, Failure> {
        let checker = || colorchecker().map(|(_, spectrum)| spectrum);
        let known: Vec<_> = colorchecker().map(|(name, _)| name).collect();
        let samples = || {
            let others = reflectances().iter().filter(|info| !known.contains(&info.name));
            others.filter_map(|info| reflectance(info.name).ok())
        };
        match self.set.to_lowercase().as_str() {
            "colorchecker" => Ok(checker().collect()),
            "samples" => Ok(samples().collect()),
            "all" => Ok(checker().chain(samples()).collect()),
            _ if Path::new(&self.set).exists() => surfaces(&self.set),
            _ => {
                let message = "and no file of that name; expected colorchecker, samples, all or a file";
                Err(Failure::Usage(format!("there is no set '{}', {message}", self.set)))
            }
        }
    }
}

impl Found {
    /// The plot: a panel for each light.
    pub fn picture(&self) -> Picture {
        let kinds = [Way::Whole(0), Way::Seen(0), Way::Rgb, Way::Meyer, Way::MeyerAdapted];
        let panel = |(index, light): (usize, &String)| plot::Efficiency {
            light: light.clone(),
            lines: kinds
                .iter()
                .map(|kind| {
                    let of_kind = self.ways.iter().filter(|(way, _)| way.name() == kind.name());
                    let points = of_kind.map(|(way, errors)| (way.samples(), errors[index].mean));
                    Line { name: kind.name().to_owned(), points: points.collect() }
                })
                .collect(),
        };
        let subtitle = format!(
            "Mean ΔE₀₀ over the {} surfaces of '{}', against the whole spectrum",
            self.count, self.set
        );
        plot::efficiency(&subtitle, &self.lights.iter().enumerate().map(panel).collect::<Vec<_>>())
    }

    fn json(&self) -> serde_json::Value {
        let ways = self.ways.iter().map(|(way, errors)| {
            let under = self.lights.iter().zip(errors).map(|(light, errors)| {
                let Errors { mean, median, p95, max } = errors;
                json!({ "light": light, "mean": mean, "median": median, "p95": p95, "max": max })
            });
            json!({ "way": way.name(), "samples": way.samples(), "under": under.collect::<Vec<_>>() })
        });
        json!({ "set": self.set, "surfaces": self.count, "unit": "ΔE00", "ways": ways.collect::<Vec<_>>() })
    }

    fn table(&self) -> String {
        let mut text = format!("ΔE00 over {} surfaces of '{}': mean (greatest)\n", self.count, self.set);
        let mut line =
            |line: String| writeln!(text, "{}", line.trim_end()).expect("a string takes everything");
        let heads: Vec<_> = self.lights.iter().map(|light| format!("{light:>14}")).collect();
        line(format!("{:<20} {:>7} {}", "samples", "number", heads.join(" ")));
        for (way, errors) in &self.ways {
            let uniform = matches!(way, Way::Whole(_) | Way::Seen(_));
            if uniform && !SHOWN.contains(&way.samples()) {
                continue;
            }
            let cells: Vec<_> = errors
                .iter()
                .map(|errors| format!("{:>14}", format!("{:.2} ({:.2})", errors.mean, errors.max)))
                .collect();
            line(format!("{:<20} {:>7} {}", way.name(), way.samples(), cells.join(" ")));
        }
        text
    }
}
