//! Published fits: the parameters of models for whole collections of materials, as BBM (the BSDF benchmark of A. Bieron,
//! P. Peers and others) keeps them, one material in a line:
//!
//! ```text
//! gold = Aggregate(Lambertian(albedo = [0.1, 0.06, 0.01]), NganWard(albedo = [0.2, 0.1, 0.03], roughness = 0.05))
//! ```

use glanz_bsdf::terms::fresnel_dielectric;
use glanz_bsdf::{Angle, Chebyshev, DirectionPair, LayerWeight, ParamError, Shape};
use glanz_math::Vec3;

use crate::ReadError;

/// Terms of Fresnel's reflectance over the cosine.
const FRESNEL_TERMS: usize = 32;
/// Lists and models stand in each other no deeper.
const MOST_DEPTH: usize = 8;

/// The models of a material.
#[derive(Clone, Debug, PartialEq)]
pub struct PublishedFit {
    /// Of the material.
    pub name: String,
    /// The models whose sum it is.
    pub models: Vec<PublishedModel>,
}

/// A model with its parameters, as it is in the file.
#[derive(Clone, Debug, PartialEq)]
pub struct PublishedModel {
    /// The model's name in BBM.
    pub name: String,
    /// The parameters' names and numbers; lists of lists are one list.
    pub parameters: Vec<(String, Vec<f64>)>,
}

/// A published model as a lobe of Glanz: BRDF = tint · weight · shape.
#[derive(Clone, Debug, PartialEq)]
pub struct PublishedLobe {
    /// The shape.
    pub shape: Shape,
    /// Fresnel's term, over the cosine of the half angle.
    pub weight: LayerWeight,
    /// For red, green and blue of the camera of the collection.
    pub tint: [f64; 3],
}

/// A published model that is no lobe of Glanz.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PublishedError {
    /// There is no such model here.
    #[error("Glanz has no model that is BBM's {0}")]
    NoModel(String),
    /// A parameter is missing, or is no number.
    #[error("{model} lacks the parameter {parameter}, of {count} numbers")]
    Missing {
        /// The model.
        model: String,
        /// Its parameter.
        parameter: &'static str,
        /// How many numbers it must have.
        count: usize,
    },
    /// A parameter is beyond what the model here takes.
    #[error("{model}: {error}")]
    Range {
        /// The model.
        model: String,
        /// What is wrong.
        error: ParamError,
    },
}

impl PublishedFit {
    /// The fits of a file.
    ///
    /// ```
    /// use glanz_measure::PublishedFit;
    ///
    /// let text = "gold = Aggregate(Lambertian(albedo = [0.1, 0.06, 0.01]), NganWard(albedo = [0.2, 0.1, 0.03], roughness = 0.05))";
    /// let fits = PublishedFit::read(text)?;
    /// let lobes = fits[0].lobes()?;
    /// assert_eq!((fits[0].name.as_str(), lobes[1].shape.info().name), ("gold", "ward"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn read(text: &str) -> Result<Vec<Self>, ReadError> {
        let mut fits = Vec::new();
        for (number, line) in (1..).zip(text.trim_start_matches('\u{feff}').lines()) {
            let line = line.trim();
            if line.is_empty() || line.starts_with('#') {
                continue;
            }
            let Some((name, rest)) = line.split_once('=') else {
                return Err(ReadError::at(number, "expected 'name = Model(…)'"));
            };
            let mut parser = Parser { rest, line: number };
            let mut models = Vec::new();
            parser.model(&mut models, 0)?;
            if !parser.skipped().is_empty() {
                return Err(parser.wrong("the end of the line"));
            }
            fits.push(Self { name: name.trim().to_owned(), models });
        }
        match fits.is_empty() {
            true => Err(ReadError::broken("there are no fits")),
            false => Ok(fits),
        }
    }

    /// The models as lobes.
    ///
    /// # Errors
    ///
    /// [`PublishedError`] where one of them has no equal here.
    pub fn lobes(&self) -> Result<Vec<PublishedLobe>, PublishedError> {
        self.models.iter().map(PublishedModel::lobe).collect()
    }
}

/// Whether a text has lines of fits: what would be read as a table otherwise.
pub(crate) fn is_fits(text: &str) -> bool {
    text.lines().any(|line| {
        let model = line.split_once('=').map_or("", |(_, rest)| rest.trim());
        ["Aggregate(", "Lambertian("].iter().any(|name| model.starts_with(name))
    })
}

impl PublishedModel {
    fn numbers<const N: usize>(&self, parameter: &'static str) -> Result<[f64; N], PublishedError> {
        let found = self.parameters.iter().find(|(name, _)| name == parameter);
        let numbers = found.and_then(|(_, numbers)| numbers.as_slice().try_into().ok());
        numbers.ok_or_else(|| PublishedError::Missing { model: self.name.clone(), parameter, count: N })
    }

    fn number(&self, parameter: &'static str) -> Result<f64, PublishedError> {
        self.numbers::<1>(parameter).map(|[number]| number)
    }

    fn shape(&self, name: &str, set: &[(&str, f64)]) -> Result<Shape, PublishedError> {
        Shape::named(name, set).map_err(|error| PublishedError::Range { model: self.name.clone(), error })
    }

    /// The lobe of Glanz that has the same BRDF.
    ///
    /// BBM's names are those of the publications: A. Ngan, F. Durand and W. Matusik, Experimental Analysis of BRDF Models,
    /// 2005, and J. Löw and others, BRDF Models for Accurate and Efficient Rendering of Glossy Surfaces, 2012. Ngan's
    /// Blinn–Phong is that of half vectors, as in the paper.
    ///
    /// # Errors
    ///
    /// [`PublishedError`] where there is none, a parameter is missing, or one is beyond the range that it has here.
    pub fn lobe(&self) -> Result<PublishedLobe, PublishedError> {
        let (shape, scale) = match self.name.as_str() {
            "Lambertian" => (self.shape("lambert", &[])?, 1.0),
            "NganWard" => (self.shape("ward", &[("alpha", self.number("roughness")?)])?, 1.0),
            "NganWardDuer" => (self.shape("ward-dur", &[("alpha", self.number("roughness")?)])?, 1.0),
            "NganBlinnPhong" => {
                let n = self.number("sharpness")?;
                // From the paper's (n + 2) / 2π to the factor that keeps the energy.
                let scale = 4.0 * (libm::exp2(-0.5 * n) + n) / (n + 4.0);
                (self.shape("blinn-phong-normalized", &[("shininess", n)])?, scale)
            }
            "NganLafortune" => {
                let (xy, z) = (self.number("Cxy")?, self.number("Cz")?);
                let set = [("cx", xy), ("cy", xy), ("cz", z), ("n", self.number("sharpness")?)];
                (self.shape("lafortune", &set)?, 1.0)
            }
            // With π in the quotient in place of 4; Löw's distribution lacks a π beside.
            "NganCookTorrance" => (
                self.shape("cook-torrance", &[("m", self.number("roughness")?)])?,
                4.0 * core::f64::consts::FRAC_1_PI,
            ),
            "LowCookTorrance" => (self.shape("cook-torrance", &[("m", self.number("roughness")?)])?, 4.0),
            "NganAshikhminShirley" | "LowAshikhminShirley" => {
                (self.shape("ashikhmin-shirley", &[("nu", self.number("sharpness")?)])?, 1.0)
            }
            _ => return Err(PublishedError::NoModel(self.name.clone())),
        };
        let tint = self.numbers::<3>("albedo")?.map(|albedo| albedo * scale);
        Ok(PublishedLobe { shape, weight: self.fresnel()?, tint })
    }

    /// Fresnel's term: Ngan's is Schlick's of a reflectance at normal incidence, Löw's that of an index of refraction.
    fn fresnel(&self) -> Result<LayerWeight, PublishedError> {
        let schlick = |at_zero: f64| LayerWeight::Schlick { angle: Angle::Half, at_zero, at_grazing: 1.0 };
        let exact = |eta: f64| {
            let factor = Chebyshev::interpolate(FRESNEL_TERMS, |cosine| fresnel_dielectric(cosine, eta));
            LayerWeight::Series { angle: Angle::Half, factor }
        };
        Ok(match self.name.as_str() {
            "NganCookTorrance" => schlick(self.number("eta")?),
            "NganAshikhminShirley" => schlick(self.number("fresnelReflectance")?),
            "LowCookTorrance" => exact(self.number("eta")?),
            "LowAshikhminShirley" => exact(self.number("fresnelReflectance")?),
            _ => LayerWeight::Constant(1.0),
        })
    }
}

impl PublishedLobe {
    /// Its BRDF in 1/sr for red, green and blue; 0 below the horizon.
    ///
    /// ```
    /// use glanz_math::Vec3;
    /// use glanz_measure::PublishedFit;
    ///
    /// let fits = PublishedFit::read("white = Lambertian(albedo = [0.9, 0.9, 0.8])")?;
    /// let up = Vec3::from_angles(0.0, 0.0);
    /// let value: f64 = fits[0].lobes()?.iter().map(|lobe| lobe.value(up, up)[0]).sum();
    /// assert!((value - 0.9 / std::f64::consts::PI).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn value(&self, wi: Vec3<f64>, wo: Vec3<f64>) -> [f64; 3] {
        if wi.z <= 0.0 || wo.z <= 0.0 {
            return [0.0; 3];
        }
        let pair = DirectionPair::new(wo, wi);
        let value = self.shape.f_cos(&pair) / wi.z * self.weight.factor(&pair);
        self.tint.map(|tint| tint * value)
    }
}

/// Reads models and lists of a line.
struct Parser<'a> {
    rest: &'a str,
    line: u32,
}

impl<'a> Parser<'a> {
    /// What is left, without space before.
    fn skipped(&mut self) -> &'a str {
        self.rest = self.rest.trim_start();
        self.rest
    }

    fn wrong(&mut self, expected: &str) -> ReadError {
        let found: String = self.skipped().chars().take(20).collect();
        let found = if found.is_empty() { "the end".to_owned() } else { format!("'{found}'") };
        ReadError::at(self.line, format!("expected {expected}, found {found}"))
    }

    /// Whether a sign comes next; it is taken.
    fn takes(&mut self, sign: char) -> bool {
        let rest = self.skipped().strip_prefix(sign);
        self.rest = rest.unwrap_or(self.rest);
        rest.is_some()
    }

    fn take(&mut self, sign: char) -> Result<(), ReadError> {
        if self.takes(sign) { Ok(()) } else { Err(self.wrong(&format!("'{sign}'"))) }
    }

    fn name(&mut self, what: &str) -> Result<&'a str, ReadError> {
        let rest = self.skipped();
        let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
        if end == 0 || rest.starts_with(|c: char| c.is_ascii_digit()) {
            return Err(self.wrong(what));
        }
        self.rest = &rest[end..];
        Ok(&rest[..end])
    }

    /// A model, or the models that an aggregate is of.
    fn model(&mut self, models: &mut Vec<PublishedModel>, depth: usize) -> Result<(), ReadError> {
        if depth > MOST_DEPTH {
            return Err(self.wrong(&format!("models at most {MOST_DEPTH} deep")));
        }
        let name = self.name("the name of a model")?;
        self.take('(')?;
        let mut parameters = Vec::new();
        while !self.takes(')') {
            if name == "Aggregate" {
                self.model(models, depth + 1)?;
            } else {
                let parameter = self.name("the name of a parameter")?;
                self.take('=')?;
                let mut numbers = Vec::new();
                self.value(&mut numbers, 0)?;
                parameters.push((parameter.to_owned(), numbers));
            }
            if !self.takes(',') && !self.skipped().starts_with(')') {
                return Err(self.wrong("',' or ')'"));
            }
        }
        if name != "Aggregate" {
            models.push(PublishedModel { name: name.to_owned(), parameters });
        }
        Ok(())
    }

    /// A number, or a list.
    fn value(&mut self, numbers: &mut Vec<f64>, depth: usize) -> Result<(), ReadError> {
        if depth > MOST_DEPTH {
            return Err(self.wrong(&format!("lists at most {MOST_DEPTH} deep")));
        }
        if !self.takes('[') {
            let rest = self.skipped();
            let end = rest.find([',', ']', ')']).unwrap_or(rest.len());
            let number = rest[..end].trim().parse::<f64>().ok().filter(|number| number.is_finite());
            numbers.push(number.ok_or_else(|| self.wrong("a number"))?);
            self.rest = &rest[end..];
            return Ok(());
        }
        while !self.takes(']') {
            self.value(numbers, depth + 1)?;
            if !self.takes(',') && !self.skipped().starts_with(']') {
                return Err(self.wrong("',' or ']'"));
            }
        }
        Ok(())
    }
}
