//! `glanz plot`: lobes, albedos and Fresnel reflectance as plots.

mod albedo;
mod fresnel;
mod lobe3d;
mod plane;
mod sample;
mod slice;
mod terms;

use clap::{Args, ValueEnum, ValueHint};
use glanz_bsdf::{DirectionPair, LightTerm, Side};
use glanz_math::Vec3;

use crate::failure::Failure;
use crate::lobes::{Case, Factor, FactorArgs, SetArgs, model_names};
use crate::plot::{Picture, PlotFile, plot_file};
use crate::print;

/// Shown after the help.
pub const EXAMPLES: &str = "\
Examples:
  glanz plot phong --set shininess=8,32 --theta 0,30,60 -o polar.svg
  glanz plot phong blinn-phong --set shininess=32 --set blinn-phong.shininess=128 \\
      --kind cartesian --log -o lobes.png
  glanz plot phong-normalized --set shininess=4:64:4 --kind albedo -o albedo.svg
  glanz plot blinn-phong --kind lobe3d --theta 45 -o lobe.png
  glanz plot --kind fresnel --ior 1.5,Au,Cu -o fresnel.svg

All combinations of models, parameters and angles are curves of one plot. The light is in the
plane of the viewer and the normal, at positive angles on the other side of the normal: the
mirror direction of a viewer at 30° is 30°.";

/// The most curves of a plot.
const MAX_CURVES: usize = 64;

/// The kinds of plots.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
enum Kind {
    /// Values about a point of the surface, in the plane of incidence
    #[default]
    Polar,
    /// The same over the angle of the light
    Cartesian,
    /// The lobe for one view direction as a body
    Lobe3d,
    /// The part of the light that leaves, over the angle of the viewer
    Albedo,
    /// Values over half and difference angle (Rusinkiewicz 1998) at φd = 90°, in false colours
    Slice,
    /// The reflectance of media over the angle of incidence, exact and by Schlick's formula
    Fresnel,
    /// The factors D, G and F of models of facets
    Terms,
}

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
pub struct PlotArgs {
    /// Names of models, from `glanz bsdf list`; none for --kind fresnel
    #[arg(value_name = "MODEL", value_parser = model_names(), hide_possible_values = true)]
    models: Vec<String>,

    #[command(flatten)]
    set: SetArgs,

    /// What kind of plot
    #[arg(long, value_enum, default_value_t, value_name = "KIND")]
    kind: Kind,

    /// Angles of the viewer from the normal, in degrees [default: 30]
    #[arg(long, value_name = "THETA,…", value_delimiter = ',')]
    theta: Vec<f64>,

    /// Azimuth of the viewer from the tangent, in degrees, for models with a grain
    #[arg(long, value_name = "PHI", default_value_t = 0.0, allow_hyphen_values = true)]
    phi: f64,

    /// What is plotted [default: f for slices, else f_cos]
    #[arg(long, value_enum, value_name = "QUANTITY")]
    quantity: Option<Quantity>,

    /// Show ratios rather than differences of values
    #[arg(long)]
    log: bool,

    /// Multiply with the Fresnel reflectance of a medium (a name from `glanz color list metals`, or a refractive
    /// index); for --kind fresnel the media, between commas [default there: 1.5]
    #[arg(long, value_name = "NAME", help_heading = "Tint")]
    ior: Option<String>,

    /// Multiply with a share of light: a number, or a spectrum's name or file, at --lambda-nm
    #[arg(long, value_name = "NAME", conflicts_with = "ior", help_heading = "Tint")]
    tint: Option<String>,

    /// The wavelength at which --ior and --tint are taken, in nm [default: 550]
    #[arg(long, value_name = "NM", value_parser = crate::lobes::wavelength, help_heading = "Tint")]
    lambda_nm: Option<f64>,

    /// For --kind fresnel: also the two polarisations, s across and p in the plane of incidence
    #[arg(long, help_heading = "Tint")]
    polarised: bool,

    /// The plot's file, SVG or PNG by its ending
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath, value_parser = plot_file,
          help_heading = "Output")]
    output: PlotFile,
}

/// What all plots of lobes need, checked.
#[derive(Debug)]
struct Request<'a> {
    cases: &'a [Case],
    theta: &'a [f64],
    phi: f64,
    quantity: Quantity,
    log: bool,
    factor: &'a Factor,
    nm: f64,
}

impl PlotArgs {
    /// Makes the plot.
    pub fn run(&self) -> Result<(), Failure> {
        self.output.check()?;
        let picture = self.picture()?;
        self.output.save(&picture)?;
        print::note(format_args!("wrote {}", self.output.path().display()));
        Ok(())
    }

    fn picture(&self) -> Result<Picture, Failure> {
        if self.kind == Kind::Fresnel {
            return self.fresnel();
        }
        if self.polarised {
            return Err(Failure::Usage("--polarised is for --kind fresnel".to_owned()));
        }
        if self.models.is_empty() {
            return Err(Failure::Usage(
                "name a model, such as phong; 'glanz bsdf list' has them all".to_owned(),
            ));
        }
        let cases = self.set.cases(&self.models)?;
        check_directional(&cases, self.kind)?;
        let theta = if self.theta.is_empty() { vec![30.0] } else { self.theta.clone() };
        if let Some(wrong) = theta.iter().find(|theta| !(0.0..90.0).contains(*theta)) {
            return Err(Failure::Usage(format!(
                "--theta holds {wrong}, but must be from 0 to below 90 degrees"
            )));
        }
        if !self.phi.is_finite() {
            return Err(Failure::Usage(format!("--phi is {}, but must be finite", self.phi)));
        }
        let args = FactorArgs { ior: self.ior.clone(), tint: self.tint.clone(), lambda_nm: self.lambda_nm };
        let factor = if self.kind == Kind::Terms { Factor::One } else { args.factor()? };
        let default = if self.kind == Kind::Slice { Quantity::F } else { Quantity::FCos };
        let request = Request {
            cases: &cases,
            theta: &theta,
            phi: self.phi,
            quantity: self.quantity.unwrap_or(default),
            log: self.log,
            factor: &factor,
            nm: args.nm(),
        };
        let views =
            if matches!(self.kind, Kind::Polar | Kind::Cartesian | Kind::Lobe3d) { theta.len() } else { 1 };
        let most = if matches!(self.kind, Kind::Lobe3d | Kind::Slice) { 12 } else { MAX_CURVES };
        if cases.len() * views > most {
            let found = cases.len() * views;
            return Err(Failure::Usage(format!(
                "a plot of {found} lobes cannot be read; at most {most} are drawn"
            )));
        }
        match self.kind {
            Kind::Polar => Ok(request.polar()),
            Kind::Cartesian => Ok(request.cartesian()),
            Kind::Lobe3d => request.lobe3d(),
            Kind::Albedo => Ok(request.albedo()),
            Kind::Slice => request.slice(),
            Kind::Terms => request.terms(self.ior.as_deref().unwrap_or("1.5")),
            Kind::Fresnel => self.fresnel(),
        }
    }

    fn fresnel(&self) -> Result<Picture, Failure> {
        if let Some(name) = self.models.first() {
            print::note(format!(
                "--kind fresnel is about media (--ior), whatever the model: '{name}' is not used"
            ));
        }
        let nm = FactorArgs { lambda_nm: self.lambda_nm, ..FactorArgs::default() }.nm();
        fresnel::fresnel(self.ior.as_deref().unwrap_or("1.5"), nm, self.log, self.polarised)
    }
}

/// That every model answers to light from a direction with values.
fn check_directional(cases: &[Case], kind: Kind) -> Result<(), Failure> {
    for case in cases {
        let info = case.shape.info();
        let name = info.name;
        if matches!(info.term, LightTerm::Ambient | LightTerm::Emission) {
            return Err(Failure::Usage(format!(
                "'{name}' has no lobe to plot: it answers to no light from a direction"
            )));
        }
        if info.delta && kind != Kind::Terms {
            return Err(Failure::Usage(format!(
                "'{name}' has no lobe to plot: it sends light into a single direction"
            )));
        }
    }
    Ok(())
}
