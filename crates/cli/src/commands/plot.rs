//! `glanz plot`: lobes, albedos and Fresnel reflectance as plots.

use clap::{Args, ValueEnum, ValueHint};
use glanz_plot::{Factor, Figure, FresnelPlot, LobePlot, PlotFile};

use crate::input::lobes::{FactorArgs, SetArgs, model_names, wavelength};
use crate::input::media;
use crate::input::spectra::words;
use crate::print;
use crate::print::failure::Failure;
use crate::print::files::{check_plot, save_plot};

/// Shown after the help.
pub(super) const EXAMPLES: &str = "\
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
    /// The factors D, G and F of microfacet models
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
pub(crate) struct PlotArgs {
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

    /// Azimuth of the viewer from the tangent, in degrees, for anisotropic models
    #[arg(long, value_name = "PHI", default_value_t = 0.0, allow_hyphen_values = true)]
    phi: f64,

    /// What is plotted [default: f for slices, else f_cos]
    #[arg(long, value_enum, value_name = "QUANTITY")]
    quantity: Option<Quantity>,

    /// Show ratios rather than differences of values
    #[arg(long)]
    log: bool,

    /// Multiply with the Fresnel reflectance of a medium (a name from `glanz color list metals`, a refractive index, n and k
    /// as in 0.2+3i, or a file of n and k); for --kind fresnel the media, between commas [default there: 1.5]
    #[arg(long, value_name = "NAME", help_heading = "Tint")]
    ior: Option<String>,

    /// Multiply with a reflectance: a number, or a spectrum's name or file, at --lambda-nm
    #[arg(long, value_name = "NAME", conflicts_with = "ior", help_heading = "Tint")]
    tint: Option<String>,

    /// The wavelength at which --ior and --tint are taken, in nm [default: 550]
    #[arg(long, value_name = "NM", value_parser = wavelength, help_heading = "Tint")]
    lambda_nm: Option<f64>,

    /// For --kind fresnel: also the two polarisations, s across and p in the plane of incidence
    #[arg(long, help_heading = "Tint")]
    polarised: bool,

    /// The plot's file, SVG or PNG by its ending
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath,
          help_heading = "Output")]
    output: PlotFile,
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
    pub(crate) fn run(&self) -> Result<(), Failure> {
        check_plot(Some(&self.output))?;
        save_plot(&self.output, self.figure()?.as_ref())
    }

    fn figure(&self) -> Result<Box<dyn Figure>, Failure> {
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
        let plot = self.plot()?;
        Ok(match self.kind {
            Kind::Polar => Box::new(plot.polar()?),
            Kind::Cartesian => Box::new(plot.cartesian()?),
            Kind::Lobe3d => Box::new(plot.lobe3d()?),
            Kind::Albedo => Box::new(plot.albedo()?),
            Kind::Slice => Box::new(plot.slice()?),
            Kind::Terms => {
                Box::new(plot.terms(&media::medium(self.ior.as_deref().unwrap_or("1.5"), plot.lambda_nm)?)?)
            }
            Kind::Fresnel => self.fresnel()?,
        })
    }

    fn plot(&self) -> Result<LobePlot, Failure> {
        let factor = self.factor();
        let default = if self.kind == Kind::Slice { Quantity::F } else { Quantity::FCos };
        Ok(LobePlot {
            lobes: self.set.lobes(&self.models)?,
            theta_deg: if self.theta.is_empty() { vec![30.0] } else { self.theta.clone() },
            phi_deg: self.phi,
            quantity: self.quantity.unwrap_or(default).into(),
            log: self.log,
            factor: if self.kind == Kind::Terms { Factor::One } else { factor.factor()? },
            lambda_nm: factor.nm(),
        })
    }

    fn factor(&self) -> FactorArgs {
        FactorArgs { ior: self.ior.clone(), tint: self.tint.clone(), lambda_nm: self.lambda_nm }
    }

    fn fresnel(&self) -> Result<Box<dyn Figure>, Failure> {
        if let Some(name) = self.models.first() {
            print::note(format!(
                "--kind fresnel is about media (--ior), whatever the model: '{name}' is not used"
            ));
        }
        let lambda_nm = self.factor().nm();
        let words = words(self.ior.as_deref().unwrap_or("1.5"));
        let words = words.map_err(|message| Failure::Usage(format!("--ior: {message}")))?;
        let media: Result<Vec<_>, _> = words.iter().map(|word| media::medium(word, lambda_nm)).collect();
        let plot = FresnelPlot { media: media?, lambda_nm, log: self.log, polarized: self.polarised };
        Ok(Box::new(plot.chart()?))
    }
}
