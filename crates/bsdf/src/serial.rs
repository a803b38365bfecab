//! Shapes and series as serde sees them: a shape is the name of its model and its parameters. A model of a program's own
//! is written so, too, but nothing that reads it knows the name; a user's BRDF has its text beside it, which `glanz_scene` compiles.

use std::collections::BTreeMap;

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::{ModelSource, Shape};

#[derive(Serialize, Deserialize)]
#[serde(rename = "Shape", deny_unknown_fields)]
struct Named {
    model: String,
    #[serde(default)]
    params: BTreeMap<String, f64>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    source: Option<ModelSource>,
}

impl Serialize for Shape {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let info = self.info();
        let names = info.params.iter().map(|param| param.name.to_owned());
        let params = names.zip(self.params()).collect();
        Named { model: info.name.to_owned(), params, source: self.source().cloned() }.serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Shape {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let Named { model, params, source } = Named::deserialize(deserializer)?;
        if source.is_some() {
            return Err(D::Error::custom(format!(
                "'{model}' is a user's BRDF, which this crate does not compile"
            )));
        }
        let params: Vec<(&str, f64)> = params.iter().map(|(name, value)| (name.as_str(), *value)).collect();
        Self::named(&model, &params).map_err(D::Error::custom)
    }
}

/// A Chebyshev series as the list of its coefficients.
pub(crate) mod chebyshev {
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    use crate::Chebyshev;

    pub(crate) fn serialize<S: Serializer>(series: &Chebyshev, serializer: S) -> Result<S::Ok, S::Error> {
        series.terms.iter().map(|[term]| *term).collect::<Vec<f64>>().serialize(serializer)
    }

    pub(crate) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Chebyshev, D::Error> {
        let terms = Vec::<f64>::deserialize(deserializer)?;
        Ok(Chebyshev { terms: terms.into_iter().map(|term| [term]).collect() })
    }
}

#[cfg(test)]
mod tests {
    use crate::{MODELS, Shape};

    #[test]
    fn every_shape_survives_serde() {
        for info in MODELS {
            let shape = Shape::named(info.name, &[]).expect("a name from the list");
            let text = serde_json::to_string(&shape).expect("shapes are plain");
            assert_eq!(serde_json::from_str::<Shape>(&text).expect("it was written so"), shape);
        }
        assert!(serde_json::from_str::<Shape>(r#"{"model": "ggx", "params": {"alpha": 7.0}}"#).is_err());
    }
}
