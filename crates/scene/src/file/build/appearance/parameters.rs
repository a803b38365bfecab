//! The parameters of a classic block's model, and what `alpha` is beside them.

use std::collections::BTreeSet;
use std::ops::Range;

use glanz_bsdf::{ParamError, models};

use crate::file::build::builder::Builder;
use crate::file::error::Problem;
use crate::file::near::{did_you_mean, list};
use crate::file::tables::appearance::materials::{MaterialTable, models_with};

impl MaterialTable {
    /// The opacity, if it is given: by the key of that name or by its old one, `alpha`.
    pub(super) fn opacity(&self, name: &str, builder: &mut Builder) -> Result<Option<f64>, Problem> {
        let old = self.alpha.as_ref().filter(|_| !self.alpha_is_width());
        match (&self.opacity, old) {
            (Some(_), Some(old)) => {
                Err(Problem::at(&old.span, "'alpha' beside 'opacity', which is its new name")
                    .help("'alpha' is a width in a classic block whose 'model' has one"))
            }
            (None, Some(old)) if !(0.0..=1.0).contains(&old.0) => {
                let message = format!("expected an opacity between 0 and 1, found {}", old.0);
                Err(Problem::at(&old.span, message))
            }
            (None, Some(old)) => {
                builder.input.notes.push(format!(
                    "material '{name}': 'alpha' is taken as opacity, whose key is now 'opacity'; it is a width where the \
                     'model' has one, such as \"ggx\""
                ));
                Ok(Some(old.0))
            }
            (opacity, None) => Ok(opacity.as_ref().map(|opacity| opacity.0)),
        }
    }

    /// Whether `alpha` is a parameter of the model that a classic block names.
    fn alpha_is_width(&self) -> bool {
        let is_classic = self.library.is_none() && self.lobes.is_none();
        let has_width = |model: &str| models_with("alpha").contains(&model);
        is_classic && self.model.as_ref().is_some_and(|model| has_width(model))
    }

    /// The parameters that the block gives its model, but for the exponent.
    pub(super) fn parameters(&self, name: &str, model: &str) -> Result<Vec<(String, f64)>, Problem> {
        let info = models::info_named(model).map_err(|error| self.unknown(name, &error.to_string()))?;
        let mut parameters = Vec::new();
        for (key, value) in &self.others {
            if !info.params.iter().any(|param| param.name == key.as_str()) {
                return Err(self.unknown_key(name, key, &key.span, Some(model)));
            }
            let number = value.value.ok_or_else(|| {
                Problem::at(&value.span, format!("expected a number for the parameter '{}'", key.value))
            })?;
            parameters.push((key.value.clone(), number));
        }
        let width = self.alpha.as_ref().filter(|_| self.alpha_is_width());
        parameters.extend(width.map(|width| ("alpha".to_owned(), width.0)));
        Ok(parameters)
    }

    /// That there are no keys but those of all materials.
    pub(super) fn refuse_others(&self, name: &str) -> Result<(), Problem> {
        match self.others.first() {
            Some((key, _)) => Err(self.unknown_key(name, key, &key.span, None)),
            None => Ok(()),
        }
    }

    /// Where the number stands that a model does not take.
    pub(super) fn place_of(&self, error: &ParamError) -> Option<&Range<usize>> {
        let ParamError::OutOfRange { name, .. } = error else { return self.model.as_ref().map(|m| &m.span) };
        let other = || Some(&self.others.iter().find(|(key, _)| key.as_str() == *name)?.1.span);
        match *name {
            "shininess" => self.shininess.as_ref().map(|s| &s.span),
            "alpha" => self.alpha.as_ref().map(|a| &a.span),
            _ => other(),
        }
    }

    fn unknown(&self, name: &str, message: &str) -> Problem {
        let span = self.model.as_ref().map(|model| model.span.clone());
        Problem { span, message: format!("material '{name}': {message}"), help: None }
    }

    /// An error about a key that is neither one of all materials nor a parameter of the block's model.
    fn unknown_key(&self, name: &str, key: &str, span: &Range<usize>, model: Option<&str>) -> Problem {
        let own = model.and_then(|model| models::info_named(model).ok());
        let params = || own.iter().flat_map(|info| info.params.iter().map(|param| param.name));
        let keys = || self.known.iter().copied().filter(|key| *key != "see_through");
        let all: BTreeSet<&str> = params().chain(keys()).collect();
        let near = did_you_mean(key, all.iter().copied());
        let message = format!("unknown key '{key}' in [materials.{name}]{near}");
        let parameters = model.map(|model| match params().count() {
            0 => format!("the model '{model}' has no parameters; "),
            _ => format!("parameters of the model '{model}': {}; ", list(params())),
        });
        let others = match models_with(key).as_slice() {
            [] => String::new(),
            models if model.is_some() => {
                format!("'{key}' is a parameter of {}; ", list(models.iter().copied()))
            }
            [first, ..] => format!("a parameter stands in its lobe: {{ shape = \"{first}\", {key} = … }}; "),
        };
        let root = match key {
            "roughness" if params().any(|param| param == "alpha") => {
                "alpha is the square of a slider's roughness; "
            }
            _ => "",
        };
        Problem::at(span, message).help(format!(
            "{}{others}{root}known keys: {}",
            parameters.unwrap_or_default(),
            list(keys())
        ))
    }
}
