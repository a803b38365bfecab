//! Lobes before and after a fit.

use glanz_bsdf::{LightTerm, MODELS, Shape, Side};

use super::FitError;

/// Parameters that are widths, with the range that is searched.
const WIDTHS: [(&str, [f64; 2]); 8] = [
    ("alpha", [0.005, 1.0]),
    ("m", [0.005, 1.0]),
    ("shininess", [1.0, 20_000.0]),
    ("nu", [1.0, 20_000.0]),
    ("n", [1.0, 1000.0]),
    ("sigma_deg", [1.0, 80.0]),
    ("roughness", [0.01, 1.0]),
    ("k", [0.05, 4.0]),
];

/// Widths, and those across them, which are 0 in shapes whose widths are equal.
const ACROSS: [(&str, &str); 2] = [("alpha", "alpha_y"), ("nu", "nv")];

/// A parameter that is searched, in logarithms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Searched {
    pub name: &'static str,
    /// The logarithms of the least and the greatest value.
    pub range: [f64; 2],
}

/// A lobe that is to be fitted: a shape, which of its parameters are searched, and how its tint depends on the angle.
///
/// ```
/// use glanz_bsdf::Shape;
/// use glanz_measure::FitLobe;
///
/// // One width and one tint.
/// let gloss = FitLobe::of(Shape::named("ggx", &[("multiscatter", 0.0)])?)?;
/// assert_eq!(gloss.parameters().collect::<Vec<_>>(), ["alpha"]);
/// // Two widths, a direction of the grain, and Schlick's two tints, at normal incidence and at grazing.
/// assert_eq!(FitLobe::named("ggx:aniso:schlick")?, FitLobe::named("ggx")?.anisotropic()?.with_schlick());
/// // Of a model of one's own: which parameter, and from where to where.
/// let film = FitLobe::of(Shape::named("minnaert", &[])?)?.searching("k", [0.1, 2.0])?;
/// assert!(FitLobe::named("ggx:shiny").is_err() && film.searching("edge", [0.1, 2.0]).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct FitLobe {
    pub(super) shape: Shape,
    pub(super) searched: Vec<Searched>,
    pub(super) across: Option<Searched>,
    pub(super) is_schlick: bool,
    /// Whether two widths are tried where readings may show them.
    pub(super) may_stretch: bool,
}

impl FitLobe {
    /// A lobe of this shape. Its width is searched (`alpha`, `m`, `shininess`, `nu`, `n`, `sigma_deg`, `roughness` or `k`,
    /// whichever it has); other parameters stay.
    ///
    /// # Errors
    ///
    /// [`FitError::Model`] for shapes without values of reflection.
    pub fn of(shape: Shape) -> Result<Self, FitError> {
        let info = shape.info();
        if info.delta || info.side == Side::Transmission {
            let message = format!("{} has no values of reflection that could be fitted", info.name);
            return Err(FitError::Model(message));
        }
        let width = info.params.iter().find_map(|param| {
            let (_, [low, high]) = WIDTHS.iter().find(|(name, _)| *name == param.name)?;
            Some(Searched {
                name: param.name,
                range: [low.max(param.min), high.min(param.max)].map(libm::log),
            })
        });
        Ok(Self {
            shape,
            searched: width.into_iter().collect(),
            across: None,
            is_schlick: false,
            may_stretch: false,
        })
    }

    /// The lobe of a model of the list, with what stands behind colons: `schlick` for Fresnel tints, `aniso` for two widths and
    /// the direction of the grain, `iso` for one width whatever the readings show ([`fit`](super::fit()) tries two otherwise).
    ///
    /// # Errors
    ///
    /// [`FitError::Model`] where there is no such model, or it has no second width.
    pub fn named(name: &str) -> Result<Self, FitError> {
        let mut words = name.split(':').map(str::trim);
        let shape = Shape::named(words.next().unwrap_or(""), &[]);
        let mut lobe = Self::of(shape.map_err(|error| FitError::Model(error.to_string()))?)?;
        lobe.may_stretch = true;
        let (mut is_aniso, mut is_iso) = (false, false);
        for word in words {
            (is_aniso, is_iso) = (is_aniso || word == "aniso", is_iso || word == "iso");
            lobe = match word {
                "schlick" => lobe.with_schlick(),
                "aniso" => lobe.anisotropic()?,
                "iso" => Self { may_stretch: false, ..lobe },
                _ => {
                    let message = format!("'{word}' is nothing of a lobe: expected schlick, aniso or iso");
                    return Err(FitError::Model(message));
                }
            };
        }
        if is_aniso && is_iso {
            return Err(FitError::Model(format!("'{name}': a lobe is either aniso or iso")));
        }
        Ok(lobe)
    }

    /// With a tint in Schlick's form, F0 + (F90 − F0)(1 − wo·h)⁵, where h is the half vector: both are fitted.
    pub fn with_schlick(mut self) -> Self {
        self.is_schlick = true;
        self
    }

    /// With two widths. The direction of the grain is fitted, too, one for all lobes.
    ///
    /// # Errors
    ///
    /// [`FitError::Model`] for models without a second width.
    pub fn anisotropic(mut self) -> Result<Self, FitError> {
        let info = self.shape.info();
        let across = ACROSS.iter().find_map(|(width, across)| {
            let width = self.searched.iter().find(|searched| searched.name == *width)?;
            let param = info.params.iter().find(|param| param.name == *across)?;
            Some(Searched { name: param.name, ..*width })
        });
        if across.is_none() {
            return Err(FitError::Model(format!("{} has no second width", info.name)));
        }
        self.across = across;
        self.may_stretch = false;
        Ok(self)
    }

    /// With another parameter that is searched, or one with another range. The search goes in logarithms.
    ///
    /// # Errors
    ///
    /// [`FitError::Model`] where the shape has no such parameter, or the range is not above 0 and within that of the shape.
    pub fn searching(mut self, name: &str, [low, high]: [f64; 2]) -> Result<Self, FitError> {
        let param = self.shape.info().params.iter().find(|param| param.name == name);
        let known =
            param.filter(|param| param.accepts(low) && param.accepts(high) && low > 0.0 && low < high);
        let Some(param) = known else {
            let model = self.shape.info().name;
            return Err(FitError::Model(format!("{model} has no '{name}' from {low} to {high}")));
        };
        self.searched.retain(|searched| searched.name != name);
        self.searched.push(Searched { name: param.name, range: [low, high].map(libm::log) });
        Ok(self)
    }

    /// The names of the parameters that are searched.
    pub fn parameters(&self) -> impl Iterator<Item = &'static str> {
        self.searched.iter().chain(&self.across).map(|searched| searched.name)
    }

    /// The same with two widths, if it may have them and the model has.
    pub(super) fn stretched(&self) -> Self {
        let lobe = self.clone();
        if self.may_stretch { lobe.anisotropic().unwrap_or_else(|_| self.clone()) } else { lobe }
    }

    /// The same with equal widths.
    pub(super) fn isotropic(&self) -> Self {
        Self { across: None, ..self.clone() }
    }

    /// How many tints it has.
    pub(super) fn columns(&self) -> usize {
        1 + usize::from(self.is_schlick)
    }
}

/// The lists of lobes that these names stand for: `diffuse` is every diffuse model in turn, the simplest first.
pub(super) fn choices(models: &[&str]) -> Result<Vec<Vec<FitLobe>>, FitError> {
    let is_diffuse = |name: &str| name.split(':').next() == Some("diffuse");
    let mut all = vec![Vec::new()];
    for name in models {
        let choices: Vec<FitLobe> = match is_diffuse(name) {
            false => vec![FitLobe::named(name)?],
            true => diffuse_models()
                .map(|model| FitLobe::named(&name.replacen("diffuse", model, 1)))
                .collect::<Result<_, _>>()?,
        };
        all = choices
            .iter()
            .flat_map(|lobe| all.iter().map(|list| [&list[..], std::slice::from_ref(lobe)].concat()))
            .collect();
    }
    all.sort_by_key(|list: &Vec<FitLobe>| list.iter().map(|lobe| lobe.searched.len()).sum::<usize>());
    Ok(all)
}

fn diffuse_models() -> impl Iterator<Item = &'static str> {
    let fits = MODELS.iter().filter(|info| info.term == LightTerm::Diffuse && info.side == Side::Reflection);
    fits.map(|info| info.name)
}

/// A parameter that was searched.
///
/// ```
/// use glanz_bsdf::{DirectionPair, Shape};
/// use glanz_math::Vec3;
/// use glanz_measure::{Channels, FitOptions, Readings, fit};
///
/// // A highlight that was read with an error of 2 %, here above and there below.
/// let gloss = Shape::named("ggx", &[("alpha", 0.3)])?;
/// let mut readings = Readings::new(Channels::Luminance);
/// let wi = Vec3::from_angles(0.5, std::f64::consts::PI);
/// for theta_o in 0..70 {
///     let wo = Vec3::from_angles(f64::from(theta_o).to_radians(), 0.0);
///     let noise = 1.0 + 0.02 * f64::from(theta_o * 7 % 13 - 6) / 6.0;
///     readings.push(wi, wo, &[(0.2 * noise * gloss.f_cos(&DirectionPair::new(wo, wi)) / wi.z) as f32]);
/// }
/// let found = fit(&readings, &["ggx"], &FitOptions::default())?;
/// let width = &found.lobes[0].parameters[0];
/// let error = width.log_error.expect("the readings tell it");
/// assert!(width.name == "alpha" && error < 0.02 && (width.value / 0.3).ln().abs() < 3.0 * error);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct FittedParameter {
    /// Its name.
    pub name: &'static str,
    /// Its value.
    pub value: f64,
    /// The standard error of its logarithm, all others and the tints being free, too; none where it cannot be told.
    pub log_error: Option<f64>,
    /// Whether it is at an end of its range, where a fit is seldom what it seems.
    pub at_bound: bool,
}

/// A lobe that was fitted.
#[derive(Clone, Debug, PartialEq)]
pub struct FittedLobe {
    /// The shape, with its parameters.
    pub shape: Shape,
    /// Those that were searched.
    pub parameters: Vec<FittedParameter>,
    /// The tint of each channel; in Schlick's form that at normal incidence.
    pub tint: Vec<f64>,
    /// In Schlick's form the tint at grazing incidence: the lobe is shape · (tint · (1 − u⁵) + tint_at_grazing · u⁵), u being
    /// 1 − wo·h.
    pub tint_at_grazing: Option<Vec<f64>>,
}

impl FittedLobe {
    /// The tint, and in Schlick's form that at grazing incidence.
    pub fn tints(&self) -> impl Iterator<Item = &[f64]> {
        [Some(&self.tint), self.tint_at_grazing.as_ref()].into_iter().flatten().map(Vec::as_slice)
    }
}
