//! `glanz measure sample`: the virtual goniometer.

use std::path::PathBuf;

use clap::{Args, ValueEnum, ValueHint};
use glanz_bsdf::{DirectionPair, Shape};
use glanz_math::Vec3;
use glanz_measure::{Channels, Geometry, Noise, Quantity, Readings, Rgl, write_csv};

use super::convert::{Kind, check_output, deliver};
use super::quantity;
use super::written::Written;
use crate::commands::bsdf::ModelArgs;
use crate::print::FormatArgs;
use crate::print::failure::Failure;

/// Shown after the help.
pub(crate) const EXAMPLES: &str = "\
Examples:
  glanz measure sample ward --set alpha=0.1 -o ward.csv --geometry hemisphere --noise 0.03
  glanz measure sample ward --set alpha=0.088 --set alpha_y=0.13 -o cells.csv --geometry merl --noise 0.03
  glanz measure sample ggx --set alpha=0.2 -o ggx.binary
  glanz measure sample cook-torrance --set m=0.15 -o ct.bsdf --diffuse 0.3
  glanz measure sample ward --set alpha=0.1 --set alpha_y=0.3 -o brushed.xml
  glanz measure sample ggx --set alpha=0.1 --set alpha_y=0.3 --aniso-deg 30 --every 7 --noise 0.05 -o brushed.csv
  glanz measure sample \"n = 20; (n + 2) / (2 * pi) * pow(dot(N, H), n)\" -o own.csv --geometry in-plane

The model is that of `glanz bsdf list`, or a BRDF of one's own; --diffuse adds a matte part, as measured
surfaces have. Readings of a .csv are where --geometry says: in the plane of the light, all over the
hemisphere, or dense about the mirror direction (astm), each for lights at 0, 15, 30, 45, 60 and 75 degrees, or
at MERL's cells or RGL's nodes; what has a grain is turned under them. --noise multiplies each
by a number of a normal distribution about 1, the same ones for the same --seed. MERL (.binary) and RGL
(.bsdf) have nodes of their own and three channels that are the same, Radiance's matrices over Klems' patches
(.xml) and Zemax's tables (--to zemax) have one. MERL takes what depends on the difference of azimuths alone.";

/// Where a goniometer goes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Way {
    /// In the plane of the light, every 5 degrees
    InPlane,
    /// All over the hemisphere, every 5 degrees and 15 around
    #[default]
    Hemisphere,
    /// In the plane of the light, dense about the mirror direction as scatterometers scan: even steps of log |sin o - sin i|
    Astm,
    /// The middles of MERL's cells, about 20000 of them
    Merl,
    /// The nodes of RGL's table of the model, about 20000 of them
    Rgl,
}

/// Of more nodes of a table every n-th counts.
const MOST_NODES: usize = 20_000;

/// Options of `glanz measure sample`.
#[derive(Args, Debug)]
pub(crate) struct SampleArgs {
    #[command(flatten)]
    model: ModelArgs,

    /// The file that is written: .csv, .binary (MERL), .bsdf (RGL) or .xml (Klems)
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    output: PathBuf,

    /// Its format, whatever the ending is
    #[arg(long, value_enum, value_name = "FORMAT")]
    to: Option<Kind>,

    /// Where the goniometer goes; of a .csv
    #[arg(long, value_enum, value_name = "GEOMETRY", default_value_t)]
    geometry: Way,

    /// What the model is multiplied with, as by the tint of a lobe
    #[arg(long, value_name = "TINT", default_value_t = 1.0)]
    tint: f64,

    /// The azimuth of the model's x axis, as of a sample whose grain lies askew
    #[arg(long, value_name = "DEGREES", default_value_t = 0.0, allow_negative_numbers = true)]
    aniso_deg: f64,

    /// Of the readings of a .csv every n-th is made
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..))]
    every: u32,

    /// The albedo of a matte part that is added
    #[arg(long, value_name = "ALBEDO", default_value_t = 0.0)]
    diffuse: f64,

    /// The standard deviation of the noise, as a part of each value
    #[arg(long, value_name = "PART", default_value_t = 0.0)]
    noise: f64,

    /// Which noise
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,

    /// What the numbers of a table are: brdf, brdf-cos or reflectance-factor
    #[arg(long = "as", value_name = "QUANTITY", value_parser = quantity, default_value = "brdf")]
    written: Quantity,

    #[command(flatten)]
    format: FormatArgs,
}

/// Nearer to the horizon no goniometer sees.
const LEAST_COSINE: f64 = 0.01;

impl SampleArgs {
    /// Measures.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        if !self.aniso_deg.is_finite() {
            return Err(Failure::Usage(format!("--aniso-deg is {}, but must be a number", self.aniso_deg)));
        }
        for (name, value) in [("--noise", self.noise), ("--diffuse", self.diffuse), ("--tint", self.tint)] {
            if !(0.0..=1.0).contains(&value) {
                return Err(Failure::Usage(format!("{name} is {value}, but must be from 0 to 1")));
            }
        }
        let kind = Kind::of(&self.output, self.to)?;
        check_output(&self.output, self.format)?;
        let shape = self.model.shape()?;
        let mut notes = Vec::new();
        let anisotropic = shape.info().anisotropic && depends_on_azimuth(&shape);
        if kind == Kind::Merl && anisotropic {
            notes.push(
                "the model is anisotropic, and the table is not: the light comes along the grain".to_owned(),
            );
        }
        let mut noise = Noise::new(self.seed);
        let mut value = |wi: Vec3<f64>, wo: Vec3<f64>| {
            let f = self.exact(&shape, wi, wo);
            if self.noise > 0.0 { f * (1.0 + self.noise * noise.normal()).max(0.0) } else { f }
        };
        let description = format!("{}, by the virtual goniometer of Glanz", shape.info().name);
        let (bytes, count) = self.written(kind, anisotropic, &description, &mut value)?;
        deliver(&bytes, &self.output, kind, count, notes, self.format)
    }

    /// The bytes of a file, and how many readings a table has.
    fn written(
        &self,
        kind: Kind,
        anisotropic: bool,
        description: &str,
        value: &mut dyn FnMut(Vec3<f64>, Vec3<f64>) -> f64,
    ) -> Result<(Vec<u8>, Option<usize>), Failure> {
        if kind == Kind::Csv {
            let readings = self.readings(value, anisotropic)?;
            let text = write_csv(&readings, self.written, description);
            return Ok((text.into_bytes(), Some(readings.len())));
        }
        let channels = Channels::Luminance;
        let written = Written { channels: &channels, anisotropic, description, output: &self.output };
        let bytes = written.bytes(kind, &mut Vec::new(), &mut |wi, wo| vec![value(wi, wo)])?;
        Ok((bytes, None))
    }

    /// Readings one by one; a surface with a grain is turned, too.
    fn readings(
        &self,
        value: &mut dyn FnMut(Vec3<f64>, Vec3<f64>) -> f64,
        anisotropic: bool,
    ) -> Result<Readings, Failure> {
        let pairs = match self.geometry {
            Way::InPlane => Geometry::InPlane.pairs(anisotropic),
            Way::Hemisphere => Geometry::Hemisphere.pairs(anisotropic),
            Way::Astm => Geometry::Scatterometer.pairs(anisotropic),
            Way::Merl => Geometry::Merl.pairs(anisotropic),
            Way::Rgl => self.nodes(anisotropic)?,
        };
        let mut readings = Readings::new(Channels::Luminance);
        let pairs = pairs.iter().step_by(self.every as usize);
        pairs.for_each(|[wi, wo]| readings.push(*wi, *wo, &[value(*wi, *wo) as f32]));
        Ok(readings)
    }

    /// The nodes that RGL's table of the model without noise has.
    fn nodes(&self, anisotropic: bool) -> Result<Vec<[Vec3<f64>; 2]>, Failure> {
        let shape = self.model.shape()?;
        let mut f = |wi: Vec3<f64>, wo: Vec3<f64>| vec![self.exact(&shape, wi, wo); 3];
        let table = match anisotropic {
            false => Rgl::of_function(Channels::Rgb, "", &mut f),
            true => Rgl::of_anisotropic_function(Channels::Rgb, "", &mut f),
        };
        let readings = table.map_err(Failure::new)?.readings();
        // An odd step meets all columns of a table of 64.
        let step = readings.len().div_ceil(MOST_NODES) | 1;
        let above = |[wi, wo]: &[Vec3<f64>; 2]| wi.z > LEAST_COSINE && wo.z > LEAST_COSINE;
        Ok((0..readings.len()).step_by(step).map(|i| readings.pair(i)).filter(above).collect())
    }

    /// The BRDF without noise.
    fn exact(&self, shape: &Shape, wi: Vec3<f64>, wo: Vec3<f64>) -> f64 {
        let (sin, cos) = libm::sincos(self.aniso_deg.to_radians());
        let turn = |w: Vec3<f64>| match self.aniso_deg == 0.0 {
            true => w,
            false => Vec3::new(cos * w.x + sin * w.y, cos * w.y - sin * w.x, w.z),
        };
        let model = self.tint * shape.f_cos(&DirectionPair::new(turn(wo), turn(wi)));
        model / wi.z + self.diffuse * core::f64::consts::FRAC_1_PI
    }
}

/// Whether turning both directions changes the value.
fn depends_on_azimuth(shape: &Shape) -> bool {
    let value = |turn: f64| {
        let [wo, wi] = [(0.4, 0.3), (0.6, 2.9)].map(|(theta, phi)| Vec3::from_angles(theta, phi + turn));
        shape.f_cos(&DirectionPair::new(wo, wi))
    };
    let first = value(0.0);
    [0.5, 1.0, 1.5].iter().any(|turn| (value(*turn) - first).abs() > 1e-9 * first.abs())
}
