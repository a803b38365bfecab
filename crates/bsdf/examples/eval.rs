//! Values of a shape for directions from standard input, for comparison with other programs.
//!
//!     eval ggx alpha=0.3 < directions.csv
//!
//! Lines are wo_x,wo_y,wo_z,wi_x,wi_y,wi_z in the local frame (z is the normal); the output has `f_cos` in 1/sr and the
//! cosine that a Fresnel tint is taken at, both in `f64`. `fresnel-dielectric eta=…` and `fresnel-conductor eta=… k=…`
//! give the reflectance for the cosine wo_z instead.

use std::io::{BufRead, BufWriter, Write};

use glanz_bsdf::terms::{fresnel_conductor, fresnel_dielectric};
use glanz_bsdf::{DirectionPair, Shape};
use glanz_math::Vec3;

type Failure = Box<dyn std::error::Error>;

fn main() -> Result<(), Failure> {
    let mut arguments = std::env::args().skip(1);
    let name = arguments.next().ok_or("the name of a model is missing")?;
    let mut set = Vec::new();
    for argument in arguments {
        let (key, value) =
            argument.split_once('=').ok_or_else(|| format!("'{argument}' is not key=value"))?;
        set.push((key.to_owned(), value.parse::<f64>()?));
    }
    let set: Vec<(&str, f64)> = set.iter().map(|(key, value)| (key.as_str(), *value)).collect();
    let value = values(&name, &set)?;
    let mut out = BufWriter::new(std::io::stdout().lock());
    for line in std::io::stdin().lock().lines() {
        let line = line?;
        let numbers: Vec<f64> = line.split(',').map(|word| word.trim().parse()).collect::<Result<_, _>>()?;
        let [ox, oy, oz, ix, iy, iz] = numbers[..] else {
            return Err(format!("'{line}' has {} numbers, not 6", numbers.len()).into());
        };
        let (f_cos, cosine) = value(&DirectionPair::new(Vec3::new(ox, oy, oz), Vec3::new(ix, iy, iz)));
        writeln!(out, "{f_cos:e},{cosine:e}")?;
    }
    Ok(())
}

type Value = Box<dyn Fn(&DirectionPair<f64>) -> (f64, f64)>;

/// What is asked for, as a function.
fn values(name: &str, set: &[(&str, f64)]) -> Result<Value, Failure> {
    let given = |key: &str| set.iter().find(|(k, _)| *k == key).map_or(0.0, |(_, value)| *value);
    let (eta, k) = (given("eta"), given("k"));
    Ok(match name {
        "fresnel-dielectric" => Box::new(move |pair| (fresnel_dielectric(pair.cos_o, eta), pair.cos_o)),
        "fresnel-conductor" => Box::new(move |pair| (fresnel_conductor(pair.cos_o, eta, k), pair.cos_o)),
        _ => {
            let shape = Shape::named(name, set)?;
            Box::new(move |pair| (shape.f_cos(pair), shape.tint_cosine(pair)))
        }
    })
}
