//! `glanz plot`: lobes, albedos, Fresnel reflectance, lights, directions and curves of eyes as plots.

mod command;
mod eye;
mod kind;
mod lights;

use clap::{Args, ValueEnum};
use glanz_plot::figure::VectorDrawing;
use glanz_plot::{Factor, Figure, FresnelPlot, Lang, LobePlot};

use self::kind::Kind;
use crate::args::{self, PlotOutputArgs};
use crate::input::lobes::{FactorArgs, SetArgs, UnitName, wavelength};
use crate::input::media;
use crate::input::models::models;
use crate::input::spectra::words;
use crate::print::failure::Failure;

pub(crate) use self::command::PlotCommand;

/// Shown after the help.
pub(super) const EXAMPLES: &str = "\
Examples:
  glanz plot phong --set shininess=8,32 --theta 0,30,60 -o polar.svg
  glanz plot phong blinn-phong --set shininess=32 --set blinn-phong.shininess=128 \\
      --kind cartesian --log -o lobes.png
  glanz plot phong-normalized --set shininess=4:64:4 --kind albedo -o albedo.svg
  glanz plot blinn-phong --kind lobe3d --theta 45 -o lobe.png
  glanz plot --kind fresnel --ior 1.5,Au,Cu -o fresnel.svg
  glanz plot phong --unit course --lang fr --title Phong --size 800x500 -o phong.pdf
  glanz plot my.brdf phong 'n = 20 in 1..100; (n + 8) / (8 * pi) * pow(max(dot(N, H), 0), n)' -o own.svg
  glanz plot cook-torrance --kind terms --theta 0,60 -o - --format csv
  glanz plot --kind attenuation --set 'attenuation=none,{linear=1},physical' -o fade.png
  glanz plot --kind spot --set cutoff_deg=30,60 --set exponent=0,8 -o cone.png
  glanz plot --kind vectors --wo 20,180 --wi 50,0 -o vectors.svg
  glanz plot eye --kind lens --age 20,50,80 -o lens.svg

All combinations of models, parameters and angles are curves of one plot. The light is in the
plane of the viewer and the normal, at positive angles on the other side of the normal: the
mirror direction of a viewer at 30° is 30°. For attenuation and spot, --set takes the keys of
lights in scene files. An option that has no effect on a kind is refused. As .csv and .json the
numbers of the curves come out, with their units.

A BRDF of one's own may stand in the place of a name: a .brdf file, a file with one function in
GLSL or WGSL, or its text; see `glanz shader certify --help`.";

/// Viewer and light of a drawing of directions: angles from the normal and azimuths, in degrees.
const DIRECTIONS: [[f64; 2]; 2] = [[25.0, 180.0], [50.0, 0.0]];

/// What is plotted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
enum Quantity {
    /// The BSDF
    F,
    /// The BSDF times the cosine of the light: what is seen
    #[default]
    #[value(name = "f_cos")]
    FCos,
}

/// Options of `glanz plot`.
#[derive(Args, Debug)]
pub(crate) struct PlotArgs {
    /// Names of models, from `glanz bsdf list`, or BRDFs of one's own; none for fresnel, attenuation, spot and vectors
    #[arg(value_name = "MODEL", value_parser = models(), hide_possible_values = true)]
    models: Vec<String>,

    #[command(flatten)]
    set: SetArgs,

    /// What kind of plot
    #[arg(long, value_enum, default_value_t, value_name = "KIND")]
    kind: Kind,

    /// Angles of the viewer from the normal, in degrees; of polar, cartesian, lobe3d and terms [default: 30]
    #[arg(long, value_name = "THETA,…", value_delimiter = ',')]
    theta: Vec<f64>,

    /// Azimuth of the viewer from the tangent, in degrees, for anisotropic models [default: 0]
    #[arg(long, value_name = "PHI", allow_hyphen_values = true)]
    phi: Option<f64>,

    /// What is plotted, of polar, cartesian, lobe3d and slice [default: f for slices, else f_cos]
    #[arg(long, value_enum, value_name = "QUANTITY")]
    quantity: Option<Quantity>,

    /// The unit of what is plotted [default: sr]
    #[arg(long, value_enum, value_name = "UNIT")]
    unit: Option<UnitName>,

    /// Show ratios rather than differences of values
    #[arg(long)]
    log: bool,

    /// For attenuation: the greatest distance, in metres [default: 10]
    #[arg(long, value_name = "M", allow_hyphen_values = true)]
    distance: Option<f64>,

    /// For vectors: the direction to the viewer, by its angle from the normal and its azimuth, in degrees [default:
    /// 25,180]
    #[arg(long, value_name = "THETA,PHI", value_parser = args::angles, allow_hyphen_values = true)]
    wo: Option<[f64; 2]>,

    /// For vectors: the direction to the light [default: 50,0]
    #[arg(long, value_name = "THETA,PHI", value_parser = args::angles, allow_hyphen_values = true)]
    wi: Option<[f64; 2]>,

    /// Multiply with the Fresnel reflectance of a medium (a name from `glanz color list metals`, a refractive index, n and k
    /// as in 0.2+3i, or a file of n and k); for terms the medium of F, for fresnel the media, between commas [default of
    /// both: 1.5]
    #[arg(long, value_name = "NAME", help_heading = "Tint")]
    ior: Option<String>,

    /// Multiply with a reflectance: a number, or a spectrum's name or file, at --lambda-nm
    #[arg(long, value_name = "NAME", conflicts_with = "ior", help_heading = "Tint")]
    tint: Option<String>,

    /// The wavelength at which --ior and --tint are taken, in nm [default: 550]
    #[arg(long, value_name = "NM", value_parser = wavelength, help_heading = "Tint")]
    lambda_nm: Option<f64>,

    /// For fresnel: also the two polarisations, s across and p in the plane of incidence
    #[arg(long, help_heading = "Tint")]
    polarised: bool,

    #[command(flatten)]
    output: PlotOutputArgs,
}

impl From<Quantity> for glanz_plot::Quantity {
    fn from(quantity: Quantity) -> Self {
        match quantity {
            Quantity::F => Self::F,
            Quantity::FCos => Self::FCos,
        }
    }
}

impl PlotArgs {
    /// Makes the plot.
    fn run(&self) -> Result<(), Failure> {
        let target = self.output.target()?;
        self.kind.check_options(self)?;
        if self.lambda_nm.is_some() && self.ior.is_none() && self.tint.is_none() {
            return Err(Failure::Usage("--lambda-nm changes nothing without --ior or --tint".to_owned()));
        }
        target.save(self.figure(target.lang())?.as_mut())
    }

    fn figure(&self, lang: Lang) -> Result<Box<dyn Figure>, Failure> {
        let [wo, wi] = DIRECTIONS;
        let set = &self.set.set;
        Ok(match self.kind {
            Kind::Polar => Box::new(self.plot(lang)?.polar()?),
            Kind::Cartesian => Box::new(self.plot(lang)?.cartesian()?),
            Kind::Lobe3d => Box::new(self.plot(lang)?.lobe3d()?),
            Kind::Albedo => Box::new(self.plot(lang)?.albedo()?),
            Kind::Slice => Box::new(self.plot(lang)?.slice()?),
            Kind::Terms => {
                let plot = self.plot(lang)?;
                let medium = media::medium(self.ior.as_deref().unwrap_or("1.5"), plot.lambda_nm)?;
                Box::new(plot.terms(&medium)?)
            }
            Kind::Fresnel => self.fresnel(lang)?,
            Kind::Attenuation => Box::new(lights::attenuation(set, self.distance, self.log, lang)?),
            Kind::Spot => Box::new(lights::spot(set, self.log, lang)?),
            Kind::Vectors => {
                Box::new(VectorDrawing::of_degrees(self.wo.unwrap_or(wo), self.wi.unwrap_or(wi), lang))
            }
        })
    }

    fn plot(&self, lang: Lang) -> Result<LobePlot, Failure> {
        if self.models.is_empty() {
            return Err(Failure::Usage(
                "name a model, such as phong; 'glanz bsdf list' has them all".to_owned(),
            ));
        }
        let lobes = self.set.lobes(&self.models)?;
        if self.phi.is_some() && !lobes.iter().any(|lobe| lobe.shape.info().anisotropic) {
            let names = self.models.join(", ");
            return Err(Failure::Usage(format!(
                "--phi has no effect on {names}: values do not depend on the azimuth"
            )));
        }
        let factor = self.factor();
        let default = if self.kind == Kind::Slice { Quantity::F } else { Quantity::FCos };
        Ok(LobePlot {
            lobes,
            theta_deg: if self.theta.is_empty() { vec![30.0] } else { self.theta.clone() },
            phi_deg: self.phi.unwrap_or(0.0),
            quantity: self.quantity.unwrap_or(default).into(),
            log: self.log,
            factor: if self.kind == Kind::Terms { Factor::One } else { factor.factor()? },
            lambda_nm: factor.nm(),
            unit: self.unit.unwrap_or_default().into(),
            lang,
        })
    }

    fn factor(&self) -> FactorArgs {
        FactorArgs { ior: self.ior.clone(), tint: self.tint.clone(), lambda_nm: self.lambda_nm }
    }

    fn fresnel(&self, lang: Lang) -> Result<Box<dyn Figure>, Failure> {
        let lambda_nm = self.factor().nm();
        let words = words(self.ior.as_deref().unwrap_or("1.5"));
        let words = words.map_err(|message| Failure::Usage(format!("--ior: {message}")))?;
        let media: Result<Vec<_>, _> = words.iter().map(|word| media::medium(word, lambda_nm)).collect();
        let plot = FresnelPlot { media: media?, lambda_nm, log: self.log, polarized: self.polarised, lang };
        Ok(Box::new(plot.chart()?))
    }
}
