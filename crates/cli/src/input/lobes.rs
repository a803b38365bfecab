//! Lobes that a command line names: models with lists of parameters, and what lobes are multiplied with.

use clap::builder::{PossibleValue, PossibleValuesParser};
use clap::{Args, ValueEnum};
use glanz_bsdf::{MODELS, ModelInfo, Shape};
use glanz_color::{FIRST_NM, LAST_NM, SpectrumKind};
use glanz_math::names::did_you_mean;
use glanz_plot::reflection::{DEFAULT_NM, Unit, label};
use glanz_plot::{Factor, Lobe, Variation, number};

use super::vary::variation;
use super::{media, models, spectra};
use crate::print::failure::Failure;

/// The most combinations of parameters.
const MAX_LOBES: usize = 1000;

/// Parses the name of a model.
pub(crate) fn model_names() -> PossibleValuesParser {
    PossibleValuesParser::new(MODELS.iter().map(|info| PossibleValue::new(info.name).help(info.title)))
}

/// Parameters of models.
#[derive(Args, Clone, Debug)]
pub(crate) struct SetArgs {
    /// A parameter and its values: NAME=0.05,0.16 or NAME=start:stop:count, for every model that has it, or
    /// MODEL.NAME=… for one; may be repeated, and all combinations are taken
    #[arg(long, value_name = "NAME=VALUES", value_parser = variation)]
    pub set: Vec<Variation>,
}

impl SetArgs {
    /// A lobe for every combination of parameters of these models.
    pub(crate) fn lobes(&self, models: &[String]) -> Result<Vec<Lobe>, Failure> {
        let shapes = models.iter().map(|word| models::shape(word)).collect::<Result<Vec<_>, _>>()?;
        self.of_shapes(&shapes)
    }

    /// A lobe for every combination of parameters of these models.
    pub(crate) fn of_shapes(&self, shapes: &[Shape]) -> Result<Vec<Lobe>, Failure> {
        let infos: Vec<_> = shapes.iter().map(Shape::info).collect();
        self.check_names(&infos)?;
        let mut lobes = Vec::new();
        for shape in shapes {
            let info = shape.info();
            let own: Vec<_> = info
                .params
                .iter()
                .filter_map(|param| Some((param.name, self.of(info, param.name)?)))
                .collect();
            let combinations =
                own.iter().try_fold(1_usize, |count, (_, vary)| count.checked_mul(vary.values.len()));
            let count = combinations
                .filter(|count| count + lobes.len() <= MAX_LOBES)
                .ok_or_else(|| Failure::Usage(format!("--set makes more than {MAX_LOBES} combinations")))?;
            for index in 0..count {
                lobes.push(lobe(shape, &combination(&own, index))?);
            }
        }
        Ok(lobes)
    }

    /// The last option that sets a parameter of a model; one for this model alone comes before one for all.
    fn of(&self, info: &ModelInfo, param: &str) -> Option<&Variation> {
        let own = format!("{}.{param}", info.name);
        let last = |path: &str| self.set.iter().rfind(|vary| vary.path == path);
        last(&own).or_else(|| last(param))
    }

    /// That every option means a parameter of a model that is named.
    fn check_names(&self, infos: &[&ModelInfo]) -> Result<(), Failure> {
        for vary in &self.set {
            // A file's name has points of its own.
            let (model, param) = match vary.path.rsplit_once('.') {
                Some((model, param)) => (Some(model), param),
                None => (None, vary.path.as_str()),
            };
            let mut meant =
                infos.iter().filter(|info| model.is_none_or(|model| info.name == model)).peekable();
            if let (Some(model), None) = (model, meant.peek()) {
                let names = infos.iter().map(|info| info.name).collect::<Vec<_>>();
                let near = did_you_mean(model, names.iter().copied());
                let names = names.join(", ");
                return Err(Failure::Usage(format!(
                    "--set {}: '{model}' is not among {names}{near}",
                    vary.path
                )));
            }
            let known: Vec<_> = meant.flat_map(|info| info.params.iter().map(|param| param.name)).collect();
            if !known.contains(&param) {
                let near = did_you_mean(param, known.iter().copied());
                let known = if known.is_empty() { "none".to_owned() } else { known.join(", ") };
                return Err(Failure::Usage(format!(
                    "--set {}: there is no parameter '{param}' (there are: {known}){near}",
                    vary.path
                )));
            }
        }
        Ok(())
    }
}

/// The value that each parameter has in the combination of that number; the last runs fastest.
fn combination<'a>(own: &[(&'static str, &'a Variation)], index: usize) -> Vec<(&'static str, &'a str)> {
    let mut rest = index;
    let mut values: Vec<_> = own
        .iter()
        .rev()
        .map(|(name, vary)| {
            let value = vary.values[rest % vary.values.len()].as_str();
            rest /= vary.values.len();
            (*name, value)
        })
        .collect();
    values.reverse();
    values
}

/// A model with these values of its parameters.
fn lobe(model: &Shape, texts: &[(&'static str, &str)]) -> Result<Lobe, Failure> {
    let mut shape = model.clone();
    for (name, text) in texts {
        let value = text
            .parse::<f64>()
            .map_err(|_| Failure::Usage(format!("parameter '{name}' is '{text}', but must be a number")))?;
        shape = shape.with(name, value).map_err(|error| Failure::Usage(error.to_string()))?;
    }
    Ok(Lobe { shape, label: label(model.info().name, texts) })
}

/// What lobes are multiplied with.
#[derive(Args, Clone, Debug, Default)]
#[command(next_help_heading = "Tint")]
pub(crate) struct FactorArgs {
    /// Multiply with the Fresnel reflectance of a medium: a name from `glanz color list metals`, a refractive index such
    /// as 1.5, n and k as in 0.2+3i, or a file of n and k (tables, refractiveindex.info YAML, .spd pairs)
    #[arg(long, value_name = "NAME")]
    pub ior: Option<String>,

    /// Multiply with a reflectance: a number, or a spectrum's name or file, at --lambda-nm
    #[arg(long, value_name = "NAME", conflicts_with = "ior")]
    pub tint: Option<String>,

    /// The wavelength at which --ior and --tint are taken, in nm [default: 550]
    #[arg(long, value_name = "NM", value_parser = wavelength)]
    pub lambda_nm: Option<f64>,
}

/// The unit of values of models.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum UnitName {
    /// 1/sr: a white Lambert surface has cosθ / π
    #[default]
    Sr,
    /// Values times π, as in the classic lighting equation: the peak of Lambert and Phong is 1
    Course,
}

impl UnitName {
    /// The unit as it stands in documents.
    pub(crate) fn symbol(self) -> &'static str {
        match self {
            Self::Sr => "1/sr",
            Self::Course => "1/(π sr)",
        }
    }
}

impl From<UnitName> for Unit {
    fn from(unit: UnitName) -> Self {
        match unit {
            UnitName::Sr => Self::PerSr,
            UnitName::Course => Self::Course,
        }
    }
}

/// A wavelength within the grid of spectra.
pub(crate) fn wavelength(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(nm) if (FIRST_NM..=LAST_NM).contains(&nm) => Ok(nm),
        Ok(nm) => Err(format!("{nm} nm is not between {FIRST_NM} and {LAST_NM}")),
        Err(_) => Err("expected a wavelength in nm, such as 550".to_owned()),
    }
}

impl FactorArgs {
    /// The wavelength, in nm.
    pub(crate) fn nm(&self) -> f64 {
        self.lambda_nm.unwrap_or(DEFAULT_NM)
    }

    /// The factor that is meant.
    pub(crate) fn factor(&self) -> Result<Factor, Failure> {
        match (&self.ior, &self.tint) {
            (Some(word), _) => Ok(Factor::Fresnel(media::medium(word, self.nm())?)),
            (None, Some(word)) => match word.trim().parse::<f64>() {
                Ok(value) if value.is_finite() && value >= 0.0 => {
                    Ok(Factor::Reflectance(number(value), value))
                }
                Ok(value) => Err(Failure::Usage(format!("--tint is {value}, but must not be negative"))),
                Err(_) => {
                    let source =
                        spectra::source(word, Some(SpectrumKind::Surface), &spectra::TableArgs::default())?;
                    Ok(Factor::Reflectance(source.name, source.spectrum.at(self.nm())))
                }
            },
            (None, None) if self.lambda_nm.is_some() => {
                Err(Failure::Usage("--lambda-nm changes nothing without --ior or --tint".to_owned()))
            }
            (None, None) => Ok(Factor::One),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lobes(models: &[&str], sets: &[&str]) -> Result<Vec<Lobe>, Failure> {
        let set = SetArgs { set: sets.iter().map(|text| variation(text).unwrap()).collect() };
        set.lobes(&models.iter().map(|name| (*name).to_owned()).collect::<Vec<_>>())
    }

    #[test]
    fn each_model_takes_the_values_that_it_has() {
        let all = lobes(&["phong", "lambert", "blinn-phong"], &["shininess=8,32"]).unwrap();
        let labels: Vec<_> = all.iter().map(|lobe| lobe.label.as_str()).collect();
        let expected = [
            "phong shininess=8",
            "phong shininess=32",
            "lambert",
            "blinn-phong shininess=8",
            "blinn-phong shininess=32",
        ];
        assert_eq!(labels, expected);
    }

    #[test]
    fn a_value_for_one_model_comes_before_a_value_for_all() {
        let all = lobes(&["phong", "blinn-phong"], &["phong.shininess=3", "shininess=7"]).unwrap();
        assert_eq!(all.iter().map(|lobe| lobe.shape.params()[0]).collect::<Vec<_>>(), [3.0, 7.0]);
    }

    #[test]
    fn names_that_mean_nothing_are_refused() {
        for set in ["shinyness=3", "lambert.shininess=3", "phong.n=3", "shininess=high", "shininess=-1"] {
            assert!(lobes(&["phong"], &[set]).is_err(), "{set}");
        }
        assert!(lobes(&["phong"], &["shininess=1:2:1001"]).is_err());
    }
}
