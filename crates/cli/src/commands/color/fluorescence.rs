//! `glanz color fluorescence`: what a fluorescent material does to light.

use std::fmt::Write;
use std::path::PathBuf;

use clap::Args;
use glanz_color::chromaticity::Chromaticity;
use glanz_color::colorimetry::{lab, relative_xyz};
use glanz_color::difference::ciede2000;
use glanz_color::{EnergyReport, Observer, ObserverKind, Reradiation, Spectrum, fluorescent};
use glanz_plot::{NamedSpectrum, ReradiationMap};
use schemars::JsonSchema;
use serde::Serialize;

use crate::args::{BesidePlotArgs, PlotTarget, check_apart, check_beside, light_words};
use crate::input::dyes::DyeArgs;
use crate::input::spectra::{FluorescentSource, Source, fluorescent_source, light_source, observer_source};
use crate::print::failure::Failure;
use crate::print::files::save_csv;
use crate::print::{self, FormatArgs, decimals, finite, number};

/// Shown below the help.
pub(crate) const EXAMPLES: &str = "Examples:
  glanz color fluorescence paper-note-pink --light D65,A,UV365
  glanz color fluorescence HERPIORA.BFC --plot matrix.png --csv factors.csv
  glanz color fluorescence rhodamine-b --absorbance 2 --base white-9.5
  glanz color fluorescence --excitation ex.csv --emission em.csv --quantum-yield 0.9

XYZ are relative to the perfect diffuser under the same light, whose Y is 100; under light that is
hardly seen, as that of a black light, they grow very large, and the chromaticity tells the
colour. 'reflected' is the diagonal of the matrix alone: the same material without its glow. The
total radiance factor is the light that leaves over the light that arrives, by wavelength. Files:
Labsphere .BFC, CSV with wavelengths of incidence in the first line and of emission in the first
column, and bispectral OpenEXR pictures, of which the pixel in the middle is taken.";

/// The scale of X, Y, Z that are printed: Y of the perfect diffuser.
const WHITE_Y: f64 = 100.0;

/// Where a light has less than this part of its greatest power per nm, light leaving over light arriving says
/// more of rounding than of the material.
const LEAST_POWER: f64 = 1e-3;

/// Options of `glanz color fluorescence`.
#[derive(Args, Debug)]
pub(crate) struct FluorescenceArgs {
    /// A material from `glanz color list fluorescent`, a dye from `glanz color list dyes`, or a file
    #[arg(value_name = "NAME|FILE")]
    material: Option<String>,

    #[command(flatten)]
    dye: DyeArgs,

    /// Lights between commas: names or files
    #[arg(long, alias = "under", value_name = "LIGHT,…", default_value = "D65,A,UV365")]
    light: Vec<String>,

    /// The observer, which must have X, Y and Z
    #[arg(long, value_name = "OBSERVER", default_value = "cie1931")]
    observer: String,

    #[command(flatten)]
    plot: BesidePlotArgs,

    /// Write the total radiance factor under each light, from 300 to 780 nm by 5 nm
    #[arg(long, value_name = "FILE", help_heading = "Output")]
    csv: Option<PathBuf>,

    #[command(flatten)]
    format: FormatArgs,
}

/// The material under one light.
struct Row {
    light: String,
    total: Stimulus,
    reflected: Stimulus,
    de2000: f64,
    factor: Spectrum,
    /// Whether the light has power enough everywhere for the factor to be drawn.
    is_broad: bool,
}

/// Light that reaches the observer.
struct Stimulus {
    xyz: [f64; 3],
    xy: Option<Chromaticity>,
}

impl FluorescenceArgs {
    /// Tells the colour of the material under each light.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let plot = self.plot.target()?;
        self.csv.as_deref().map_or(Ok(()), |file| check_beside("--csv", file))?;
        check_apart([("--csv", self.csv.as_deref()), ("--plot", plot.as_ref().and_then(PlotTarget::path))])?;
        let lights = light_words(&self.light)?;
        let material = self.material()?;
        let observer = observer_source(&self.observer)?;
        if observer.kind != ObserverKind::Xyz {
            return Err(Failure::Usage(format!("'{}' has no X, Y, Z, which are told here", observer.name)));
        }
        let rows = lights
            .iter()
            .map(|word| row(&material.matrix, &light_source(word)?, &observer))
            .collect::<Result<Vec<_>, _>>()?;
        self.write_files(&material, &rows, plot.as_ref())?;
        let energy = material.matrix.energy();
        match self.format.is_json() {
            true => print::json(&document(&material, &observer, &rows, &energy)),
            false => print::text(&table(&material, &rows, &energy)),
        }
    }

    fn material(&self) -> Result<FluorescentSource, Failure> {
        // The materials come first: 'quinine' is a vessel of it.
        match self.material.as_deref() {
            Some(word) if fluorescent(word).is_ok() && self.dye.is_default() => fluorescent_source(word),
            word => match (self.dye.layer(word)?, word) {
                (Some(layer), _) => Ok(layer),
                (None, word) => fluorescent_source(word.unwrap_or_default()),
            },
        }
    }

    fn write_files(
        &self,
        material: &FluorescentSource,
        rows: &[Row],
        plot: Option<&PlotTarget>,
    ) -> Result<(), Failure> {
        if let Some(path) = &self.csv {
            let columns: Vec<_> = rows.iter().map(|row| (row.light.as_str(), &row.factor)).collect();
            save_csv(path, &columns)?;
        }
        let Some(plot) = plot else { return Ok(()) };
        let (broad, narrow): (Vec<_>, Vec<_>) = rows.iter().partition(|row| row.is_broad);
        if !narrow.is_empty() {
            let names: Vec<_> = narrow.iter().map(|row| row.light.as_str()).collect();
            print::note(format_args!(
                "note: no total radiance factor is drawn for {}, which has next to no power at some wavelengths",
                names.join(", ")
            ));
        }
        let factors: Vec<_> =
            broad.iter().map(|row| NamedSpectrum { name: row.light.clone(), spectrum: row.factor }).collect();
        let (name, matrix) = (material.name.clone(), material.matrix.clone());
        plot.save(&mut ReradiationMap { name, matrix, factors: Some(factors), lang: plot.lang() })
    }
}

fn row(matrix: &Reradiation, light: &Source, observer: &Observer) -> Result<Row, Failure> {
    let unseen = || Failure::Usage(format!("the observer does not see the light '{}'", light.name));
    let light_spectrum = &light.spectrum;
    let white = relative_xyz(light_spectrum, light_spectrum, observer).ok_or_else(unseen)?;
    let leaving = matrix.apply(light_spectrum);
    let reflected = matrix.without_reradiation().apply(light_spectrum);
    let seen = |spectrum: &Spectrum| {
        let xyz = relative_xyz(spectrum, light_spectrum, observer).ok_or_else(unseen)?;
        Ok::<_, Failure>(Stimulus { xyz, xy: Chromaticity::of_xyz(xyz) })
    };
    let (total, reflected) = (seen(&leaving)?, seen(&reflected)?);
    let seen_values = light_spectrum.points().filter(|(nm, _)| *nm >= 400.0 && *nm <= 700.0);
    let least = seen_values.map(|(_, value)| value).fold(f64::INFINITY, f64::min);
    Ok(Row {
        light: light.name.clone(),
        de2000: ciede2000(lab(total.xyz, white), lab(reflected.xyz, white)),
        total,
        reflected,
        factor: matrix.total_radiance_factor(light_spectrum),
        is_broad: least >= LEAST_POWER * light_spectrum.max(),
    })
}

/// What a fluorescent material makes of each of several lights.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    name: String,
    title: String,
    observer: String,
    energy: EnergyFacts,
    lights: Vec<LightFacts>,
}

/// Whether no more leaves the material than arrives.
#[derive(Debug, Serialize, JsonSchema)]
struct EnergyFacts {
    /// Whether the material is possible
    ok: bool,
    /// The greatest fraction of light that leaves
    max_column_sum: f64,
    /// The wavelength of incidence of that
    at_nm: f64,
    /// The greatest fraction of photons that leave
    max_photon_sum: f64,
    /// The wavelength of incidence of that
    photons_at_nm: f64,
    /// The greatest fraction that leaves at shorter wavelengths
    up_conversion: f64,
}

/// The material under a light.
#[derive(Debug, Serialize, JsonSchema)]
struct LightFacts {
    light: String,
    /// All light that leaves
    total: StimulusFacts,
    /// The light that leaves at the wavelength at which it arrived
    reflected: StimulusFacts,
    /// CIEDE2000 between both
    de2000: f64,
    /// Light leaving over light arriving, from 300 to 780 nm by 5 nm; null where none arrives
    total_radiance_factor: Vec<Option<f64>>,
}

/// Light that reaches the observer.
#[derive(Debug, Serialize, JsonSchema)]
struct StimulusFacts {
    /// X, Y, Z; Y of the perfect diffuser is 100
    xyz: [Option<f64>; 3],
    /// The chromaticity; null of black
    xy: Option<[f64; 2]>,
}

fn document(
    material: &FluorescentSource,
    observer: &Observer,
    rows: &[Row],
    energy: &EnergyReport,
) -> Document {
    let seen = |seen: &Stimulus| StimulusFacts {
        xyz: seen.xyz.map(|v| finite(WHITE_Y * v)),
        xy: seen.xy.map(|xy| [xy.x, xy.y]),
    };
    let light = |row: &Row| LightFacts {
        light: row.light.clone(),
        total: seen(&row.total),
        reflected: seen(&row.reflected),
        de2000: row.de2000,
        total_radiance_factor: row.factor.0.map(finite).to_vec(),
    };
    Document {
        name: material.name.clone(),
        title: material.title.clone(),
        observer: observer.name.clone(),
        energy: EnergyFacts {
            ok: energy.ok,
            max_column_sum: energy.max_column_sum,
            at_nm: energy.at_nm,
            max_photon_sum: energy.max_photon_sum,
            photons_at_nm: energy.photons_at_nm,
            up_conversion: energy.up_conversion,
        },
        lights: rows.iter().map(light).collect(),
    }
}

fn table(material: &FluorescentSource, rows: &[Row], energy: &EnergyReport) -> String {
    let mut text = format!("{}: {}\n", material.name, material.title);
    let mut line = |line: String| writeln!(text, "{}", line.trim_end()).expect("a string takes everything");
    let verdict = if energy.ok { "possible" } else { "NOT possible" };
    line(format!(
        "energy {verdict}: of light at {} nm {} leaves, the greatest fraction; of photons at {} nm {}; \
         at shorter wavelengths {}",
        energy.at_nm,
        number(energy.max_column_sum),
        energy.photons_at_nm,
        number(energy.max_photon_sum),
        number(energy.up_conversion)
    ));
    let width = rows.iter().map(|row| row.light.chars().count()).max().unwrap_or(0).max(5);
    line(format!("{:<width$}  {:<9}  {:<28}  {:<13}  {:>7}", "light", "part", "XYZ", "xy", "ΔE00"));
    for row in rows {
        let parts = [("total", &row.total), ("reflected", &row.reflected)];
        for (index, (name, seen)) in parts.into_iter().enumerate() {
            let xyz = decimals(&seen.xyz.map(|v| WHITE_Y * v), 2);
            let xy = seen.xy.map_or("-".to_owned(), |xy| decimals(&[xy.x, xy.y], 4));
            let (light, error) = match index {
                0 => (row.light.as_str(), format!("{:.2}", row.de2000)),
                _ => ("", String::new()),
            };
            line(format!("{light:<width$}  {name:<9}  {xyz:<28}  {xy:<13}  {error:>7}"));
        }
    }
    text
}
