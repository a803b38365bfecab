//! What a model tells about itself.

use glanz_math::names::suggestion;
use thiserror::Error;

use crate::laws::Law;

/// Which of a light's colours a lobe answers to, after the classic lighting equation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LightTerm {
    /// Ambient light, the same from all directions.
    Ambient,
    /// Diffusely reflected light.
    Diffuse,
    /// Specularly reflected light.
    Specular,
    /// Light that the surface emits.
    Emission,
}

/// On which side of the surface the light must be.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Side {
    /// On the viewer's.
    #[default]
    Reflection,
    /// On the other: light passes through.
    Transmission,
}

/// One parameter of a model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParamInfo {
    /// Its name in files and on the command line.
    pub name: &'static str,
    /// Its symbol in the literature.
    pub symbol: &'static str,
    /// What it does, in one line.
    pub doc: &'static str,
    /// The least value allowed.
    pub min: f64,
    /// The greatest value allowed.
    pub max: f64,
    /// The value used where none is given.
    pub default: f64,
}

impl ParamInfo {
    /// Whether the value is a number within the range, whose ends belong to it.
    pub fn accepts(&self, value: f64) -> bool {
        (self.min..=self.max).contains(&value)
    }
}

/// All that is known of a model without evaluating it.
///
/// ```
/// use glanz_bsdf::{Law, MODELS};
///
/// let phong = MODELS.iter().find(|info| info.name == "phong").expect("it is in the list");
/// assert_eq!(phong.formula, "max(R·wo, 0)ⁿ / π where cosθi > 0");
/// let [shininess] = phong.params else { panic!("it has one parameter") };
/// assert!(shininess.accepts(1e5) && !shininess.accepts(-1.0) && !shininess.accepts(f64::NAN));
/// // It says that it breaks the law of reciprocity, and why.
/// assert!(phong.exempt.iter().any(|(law, _)| *law == Law::Reciprocity));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ModelInfo {
    /// Its name in files and on the command line.
    pub name: &'static str,
    /// A title for people.
    pub title: &'static str,
    /// The formula of `f_cos`.
    pub formula: &'static str,
    /// Where it comes from.
    pub source: &'static str,
    /// Its parameters, in order.
    pub params: &'static [ParamInfo],
    /// Which of a light's colours it answers to.
    pub term: LightTerm,
    /// On which side of the surface the light must be.
    pub side: Side,
    /// Whether it may read the tangent: only then must [`DirectionPair`](crate::DirectionPair) know it. Whether a shape with its
    /// parameters does is told by [`Shape::is_anisotropic`](crate::Shape::is_anisotropic).
    pub anisotropic: bool,
    /// Whether it is a delta lobe, which sends light into a single direction as a mirror does. Only environments
    /// and areas show in it, not punctual lights: its `f_cos` is 0.
    pub delta: bool,
    /// About how many arithmetic operations one evaluation of a pair takes with the default parameters: sums, products, quotients,
    /// roots and choices as 1, a logarithm as 24, an exponential as 20. A test counts them.
    pub operations: u32,
    /// Laws that it breaks, each with the reason.
    pub exempt: &'static [(Law, &'static str)],
}

impl ModelInfo {
    /// Whether textures may say how rough it is: whether it heeds [`DirectionPair::alpha_scale`](crate::DirectionPair::alpha_scale).
    pub fn takes_roughness_map(&self) -> bool {
        self.name.starts_with("ggx")
    }

    /// The place of the parameter called `name` in [`ModelInfo::params`], after a look at the value meant for it.
    pub(crate) fn place(&self, name: &str, value: f64) -> Result<usize, ParamError> {
        let Some(index) = self.params.iter().position(|param| param.name == name) else {
            let known = self.params.iter().map(|param| param.name).collect::<Vec<_>>().join(", ");
            let known = if known.is_empty() { "none".to_owned() } else { known };
            return Err(ParamError::UnknownParam { model: self.name, name: name.to_owned(), known });
        };
        let ParamInfo { name, min, max, .. } = self.params[index];
        match self.params[index].accepts(value) {
            true => Ok(index),
            false => Err(ParamError::OutOfRange { model: self.name, name, value, min, max }),
        }
    }

    /// The values of all parameters: those in `set`, of several of one name the last, and the defaults for the others.
    pub(crate) fn values(&self, set: &[(&str, f64)]) -> Result<Vec<f64>, ParamError> {
        let mut values: Vec<f64> = self.params.iter().map(|param| param.default).collect();
        for (name, value) in set {
            values[self.place(name, *value)?] = *value;
        }
        Ok(values)
    }
}

/// Why a shape cannot be made.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ParamError {
    /// There is no such model.
    #[error("unknown model '{name}'{}", suggestion(near))]
    UnknownModel {
        /// The name that was asked for.
        name: String,
        /// The known names that it is most likely a misspelling of.
        near: Vec<&'static str>,
    },
    /// The model has no such parameter.
    #[error("model '{model}' has no parameter '{name}'; it has: {known}")]
    UnknownParam {
        /// The model's name.
        model: &'static str,
        /// The parameter that was given.
        name: String,
        /// The parameters that it has.
        known: String,
    },
    /// A parameter is out of its range or not a number.
    #[error("parameter '{name}' of model '{model}' is {value}, but must be between {min} and {max}")]
    OutOfRange {
        /// The model's name.
        model: &'static str,
        /// The parameter's name.
        name: &'static str,
        /// The value given.
        value: f64,
        /// The least value allowed.
        min: f64,
        /// The greatest value allowed.
        max: f64,
    },
}

#[cfg(test)]
mod tests {
    use crate::{DirectionPair, MODELS, Shape};

    #[test]
    fn shapes_that_textures_widen_are_those_that_heed_the_scale() {
        for info in MODELS {
            let shape = Shape::named(info.name, &[]).unwrap();
            let heeds = [(0.9, 0.7, 0.5), (0.5, 0.6, -0.1), (0.8, -0.6, -0.9), (0.6, -0.7, -0.95)]
                .iter()
                .any(|directions| {
                    let &(cos_o, cos_i, cos_io) = directions;
                    let plain: DirectionPair<f64> = DirectionPair::isotropic(cos_o, cos_i, cos_io);
                    let scaled = DirectionPair { alpha_scale: 0.5, ..plain };
                    shape.f_cos(&plain) != shape.f_cos(&scaled)
                });
            assert_eq!(heeds, info.takes_roughness_map(), "{}", info.name);
        }
    }
}
