//! Lobes to plot: shapes with labels.

use glanz_bsdf::{ParamError, Shape};

/// A shape, and the label that tells it from others.
#[derive(Clone, Debug, PartialEq)]
pub struct Lobe {
    /// The shape.
    pub shape: Shape,
    /// Its model and the parameters that were set, such as `phong shininess=32`.
    pub label: String,
}

impl Lobe {
    /// A lobe of a model with these parameters; the others have their defaults.
    ///
    /// # Errors
    /// [`ParamError`] for unknown names and impossible values.
    pub fn named(model: &str, params: &[(&str, f64)]) -> Result<Self, ParamError> {
        let texts: Vec<_> = params.iter().map(|(name, value)| (*name, value.to_string())).collect();
        let texts: Vec<_> = texts.iter().map(|(name, text)| (*name, text.as_str())).collect();
        Ok(Self { shape: Shape::named(model, params)?, label: label(model, &texts) })
    }
}

/// A lobe whose label names its model and the parameters that differ from their defaults.
impl From<Shape> for Lobe {
    fn from(shape: Shape) -> Self {
        let info = shape.info();
        let values = info.params.iter().zip(shape.params());
        let set: Vec<_> = values
            .filter(|(param, value)| param.default != *value)
            .map(|(param, value)| (param.name, value.to_string()))
            .collect();
        let set: Vec<_> = set.iter().map(|(name, text)| (*name, text.as_str())).collect();
        Self { label: label(info.name, &set), shape }
    }
}

/// The label of a lobe: its model, and what each parameter was set to.
pub fn label(model: &str, params: &[(&str, &str)]) -> String {
    params.iter().fold(model.to_owned(), |label, (name, text)| format!("{label} {name}={text}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_label_names_what_was_set() {
        let lobe = Lobe::named("phong", &[("shininess", 8.0)]).unwrap();
        assert_eq!(lobe.label, "phong shininess=8");
        assert_eq!(Lobe::from(lobe.shape.clone()), lobe);
        assert_eq!(Lobe::from(Shape::named("lambert", &[]).unwrap()).label, "lambert");
        assert!(Lobe::named("phong", &[("n", 8.0)]).is_err());
    }
}
