//! Uniforms as the parameters of a model.

use std::ops::Range;

use glanz_bsdf::ParamInfo;

use super::info;
use crate::{Program, Scalar, ShaderError, Uniform, UniformValues};

/// How far a parameter without a range goes, in parts of its value in the text.
const WIDEST: f64 = 1000.0;

/// A uniform and those of the parameters that are its components.
#[derive(Clone, Debug)]
pub(super) struct Parameter {
    uniform: String,
    values: Range<usize>,
}

/// The parameters of a program, and the uniforms that they belong to.
pub(super) fn of(program: &Program) -> Result<(Vec<ParamInfo>, Vec<Parameter>), ShaderError> {
    let defaults = program.uniforms();
    let (mut params, mut parameters) = (Vec::new(), Vec::new());
    for uniform in &program.interface().uniforms {
        if uniform.ty.columns > 1 {
            let message =
                format!("'{}' is a {}, but parameters are numbers and vectors", uniform.name, uniform.ty);
            return Err(ShaderError::Unsupported { message, place: uniform.place.clone() });
        }
        let start = params.len();
        let values = defaults.get(&uniform.name).unwrap_or_default();
        params.extend(values.iter().enumerate().map(|(i, value)| param(uniform, i, decimal(*value))));
        parameters.push(Parameter { uniform: uniform.name.clone(), values: start..params.len() });
    }
    Ok((params, parameters))
}

/// The uniforms of a program with these values of its parameters.
pub(super) fn uniforms(program: &Program, parameters: &[Parameter], values: &[f64]) -> UniformValues {
    let mut uniforms = program.uniforms();
    for Parameter { uniform, values: range } in parameters {
        let words: Vec<f32> =
            values.get(range.clone()).unwrap_or_default().iter().map(|v| *v as f32).collect();
        // The names are the program's own, and so many numbers each has.
        let _ = uniforms.set(uniform, &words);
    }
    uniforms
}

/// The number that people write for it: 0.1 and not 0.10000000149011612.
fn decimal(single: f32) -> f64 {
    single.to_string().parse().unwrap_or(f64::from(single))
}

/// Component `i` of a uniform that the text gives this value.
fn param(uniform: &Uniform, i: usize, default: f64) -> ParamInfo {
    let suffix = match uniform.ty.rows {
        1 => String::new(),
        3 => format!("_{}", ["r", "g", "b"][i]),
        _ => format!("_{}", ["x", "y", "z", "w"].get(i).unwrap_or(&"")),
    };
    let plain = uniform.name.replace(['.', '['], "_").replace(']', "");
    let name = info::text(&format!("{plain}{suffix}"));
    let wide = WIDEST * default.abs().max(1.0);
    let (min, max) = match (uniform.range, uniform.ty.scalar) {
        (Some((least, most)), _) => (decimal(least).min(default), decimal(most).max(default)),
        (None, Scalar::Bool) => (0.0, 1.0),
        (None, _) if uniform.ty.rows == 3 && default >= 0.0 => (0.0, default.max(1.0)),
        (None, Scalar::Uint) => (0.0, wide),
        (None, _) => (if default > 0.0 { 0.0 } else { -wide }, wide),
    };
    let line = uniform.place.as_ref().map_or_else(String::new, |place| format!(", line {}", place.line));
    let doc = info::text(&format!("{} {}{line}", uniform.ty, uniform.name));
    ParamInfo { name, symbol: name, doc, min, max, default }
}
