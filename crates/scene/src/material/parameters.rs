//! The parameters of a material by their names.

use glanz_bsdf::ParamError;
use thiserror::Error;

use crate::scene::access::{Key, LookupError, known_names, number_of};
use crate::{Lobe, Material};

/// Why a parameter of a material cannot be read or set.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ParameterError {
    /// No lobe has it.
    #[error("material '{material}' has no parameter '{asked}'{}", known_names(asked, known))]
    Unknown {
        /// The material's name.
        material: String,
        /// What was asked for.
        asked: String,
        /// The parameters that there are, as paths or, where one lobe alone has it, as names.
        known: Vec<String>,
    },
    /// Several lobes have it.
    #[error(
        "several lobes of material '{material}' have a parameter '{asked}': say which, {}",
        choice(paths)
    )]
    Several {
        /// The material's name.
        material: String,
        /// What was asked for.
        asked: String,
        /// The paths of all that have the name.
        paths: Vec<String>,
    },
    /// The material has no such lobe.
    #[error("material '{material}': {source}")]
    Lobe {
        /// The material's name.
        material: String,
        /// What was looked for.
        source: LookupError,
    },
    /// The lobe's model has no such parameter, or not with this value.
    #[error("material '{material}': {source}")]
    Value {
        /// The material's name.
        material: String,
        /// What the model says.
        source: ParamError,
    },
}

fn choice(paths: &[String]) -> String {
    let quoted: Vec<String> = paths.iter().map(|path| format!("'{path}'")).collect();
    quoted.join(" or ")
}

/// Parameters by name.
impl Lobe {
    /// The parameter of the shape that has this name; none if the model has no such parameter.
    pub fn get(&self, name: &str) -> Option<f64> {
        self.shape.get(name)
    }

    /// Sets a parameter of the shape.
    ///
    /// ```
    /// use glanz_bsdf::Shape;
    /// use glanz_color::Rgb;
    /// use glanz_scene::Lobe;
    ///
    /// let mut lobe = Lobe::new(Shape::named("ggx", &[])?, Rgb::WHITE);
    /// lobe.set("alpha", 0.3)?;
    /// assert_eq!(lobe.get("alpha"), Some(0.3));
    /// assert!(lobe.set("alpha", 30.0).is_err());
    /// # Ok::<(), glanz_bsdf::ParamError>(())
    /// ```
    ///
    /// # Errors
    /// [`ParamError`] where the model has no such parameter or the value is out of its range.
    pub fn set(&mut self, name: &str, value: f64) -> Result<(), ParamError> {
        self.shape = self.shape.with(name, value)?;
        Ok(())
    }
}

/// Parameters by name.
///
/// A name such as `shininess` is that of a parameter of a lobe, if one lobe alone has it; a path such as
/// `lobes.1.alpha` says which lobe is meant, by number or by the name of its model. The numbers of the material
/// itself, such as its opacity, are fields.
impl Material {
    /// The lobe of this number, or of this model.
    ///
    /// # Errors
    /// [`LookupError`] where there is none, or where several are of the model.
    pub fn lobe<'k>(&self, key: impl Into<Key<'k>>) -> Result<&Lobe, LookupError> {
        Ok(&self.lobes[number_of(&self.lobes, key.into())?])
    }

    /// The lobe of this number, or of this model, to be changed.
    ///
    /// # Errors
    /// [`LookupError`] where there is none, or where several are of the model.
    pub fn lobe_mut<'k>(&mut self, key: impl Into<Key<'k>>) -> Result<&mut Lobe, LookupError> {
        let number = number_of(&self.lobes, key.into())?;
        Ok(&mut self.lobes[number])
    }

    /// The parameter of this name or path.
    ///
    /// # Errors
    /// [`ParameterError`] where there is none, or where several lobes have it.
    pub fn get(&self, name: &str) -> Result<f64, ParameterError> {
        let (lobe, name) = self.find(name)?;
        self.lobes[lobe].get(name).ok_or_else(|| self.unknown(name))
    }

    /// Sets the parameter of this name or path. Layers over other lobes stay as they are.
    ///
    /// ```
    /// use glanz_scene::{ClassicMaterial, Material};
    /// use glanz_color::Rgb;
    ///
    /// let block = ClassicMaterial { specular: Rgb::WHITE.into(), ..ClassicMaterial::default() };
    /// let mut red = block.build("red")?;
    /// red.set("shininess", 64.0)?;
    /// assert_eq!(red.get("lobes.0.shininess")?, 64.0);
    /// assert_eq!(
    ///     red.set("shinyness", 64.0).unwrap_err().to_string(),
    ///     "material 'red' has no parameter 'shinyness'; did you mean 'shininess'? There are: shininess"
    /// );
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`ParameterError`] where there is none, where several lobes have it, or where the value is out of range.
    pub fn set(&mut self, name: &str, value: f64) -> Result<(), ParameterError> {
        let (lobe, name) = self.find(name)?;
        let result = self.lobes[lobe].set(name, value);
        result.map_err(|source| ParameterError::Value { material: self.name.clone(), source })
    }

    /// The names of all parameters; paths where several lobes have one of the same name.
    pub fn parameters(&self) -> Vec<String> {
        let all: Vec<(usize, &str)> = self.all_parameters().collect();
        let is_alone = |name: &str| all.iter().filter(|(_, other)| *other == name).count() == 1;
        let path = |&(lobe, name): &(usize, &str)| match is_alone(name) {
            true => name.to_owned(),
            false => path_of(lobe, name),
        };
        all.iter().map(path).collect()
    }

    fn all_parameters(&self) -> impl Iterator<Item = (usize, &'static str)> {
        let of_lobe = |(number, lobe): (usize, &Lobe)| {
            lobe.shape.info().params.iter().map(move |param| (number, param.name))
        };
        self.lobes.iter().enumerate().flat_map(of_lobe)
    }

    /// The lobe that a name or path is about, and the name within it.
    fn find<'n>(&self, asked: &'n str) -> Result<(usize, &'n str), ParameterError> {
        if let Some((lobe, name)) = asked.strip_prefix("lobes.").and_then(|rest| rest.rsplit_once('.')) {
            let key = lobe.parse().map_or(Key::Name(lobe), Key::Number);
            let number = number_of(&self.lobes, key);
            let number =
                number.map_err(|source| ParameterError::Lobe { material: self.name.clone(), source })?;
            return Ok((number, name));
        }
        let found: Vec<usize> =
            self.all_parameters().filter(|(_, name)| *name == asked).map(|(lobe, _)| lobe).collect();
        match found[..] {
            [lobe] => Ok((lobe, asked)),
            [] => Err(self.unknown(asked)),
            _ => Err(ParameterError::Several {
                material: self.name.clone(),
                asked: asked.to_owned(),
                paths: found.iter().map(|lobe| path_of(*lobe, asked)).collect(),
            }),
        }
    }

    fn unknown(&self, asked: &str) -> ParameterError {
        let (material, asked, known) = (self.name.clone(), asked.to_owned(), self.parameters());
        ParameterError::Unknown { material, asked, known }
    }
}

fn path_of(lobe: usize, name: &str) -> String {
    format!("lobes.{lobe}.{name}")
}

#[cfg(test)]
mod tests {
    use glanz_bsdf::Shape;
    use glanz_color::Rgb;

    use super::*;

    fn two_widths() -> Material {
        let lobe = |model: &str| Lobe::new(Shape::named(model, &[]).unwrap(), Rgb::WHITE);
        Material::of_lobes("metal", vec![lobe("ggx"), lobe("lambert"), lobe("beckmann"), lobe("phong")])
    }

    #[test]
    fn a_name_that_several_lobes_have_needs_a_path() {
        let mut metal = two_widths();
        let error = metal.set("alpha", 0.5).unwrap_err();
        assert_eq!(
            error.to_string(),
            "several lobes of material 'metal' have a parameter 'alpha': say which, 'lobes.0.alpha' or \
             'lobes.2.alpha'"
        );
        assert_eq!(metal, two_widths(), "an error changes nothing");
        metal.set("lobes.2.alpha", 0.5).unwrap();
        metal.set("lobes.ggx.alpha", 0.25).unwrap();
        assert_eq!(
            (metal.get("lobes.0.alpha").unwrap(), metal.get("lobes.beckmann.alpha").unwrap()),
            (0.25, 0.5)
        );
    }

    #[test]
    fn what_is_set_is_what_the_model_is_made_of() {
        let mut metal = two_widths();
        metal.lobe_mut(0).unwrap().set("alpha", 0.6).unwrap();
        assert_eq!(metal.lobes[0].shape, Shape::named("ggx", &[("alpha", 0.6)]).unwrap());
    }

    #[test]
    fn errors_name_what_there_is() {
        let mut metal = two_widths();
        let known = metal.parameters();
        assert!(known.contains(&"shininess".to_owned()) && known.contains(&"lobes.2.alpha".to_owned()));
        let message = |result: Result<(), ParameterError>| result.unwrap_err().to_string();
        assert!(message(metal.set("colour", 1.0)).starts_with("material 'metal' has no parameter 'colour'"));
        assert_eq!(
            message(metal.set("lobes.7.alpha", 1.0)),
            "material 'metal': there is no lobe 7: there are 4, counted from 0"
        );
        assert_eq!(
            message(metal.set("shininess", -1.0)),
            "material 'metal': parameter 'shininess' of model 'phong' is -1, but must be between 0 and 100000"
        );
        assert!(
            message(metal.set("lobes.1.alpha", 1.0)).contains("model 'lambert' has no parameter 'alpha'")
        );
        assert!(metal.get("lobes.1.alpha").is_err());
        assert!(metal.get("lobes.").is_err() && metal.get("lobes..").is_err() && metal.get("").is_err());
        assert_eq!(metal, two_widths());
    }
}
