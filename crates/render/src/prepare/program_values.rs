//! Giving uniforms what the user says.

use glanz_shader::{Program, UniformError, UniformValues};

/// Sets a uniform by its name, or all elements of an array by the array's.
pub(crate) fn set(
    values: &mut UniformValues,
    program: &Program,
    name: &str,
    numbers: &[f64],
) -> Result<(), UniformError> {
    let numbers: Vec<f32> = numbers.iter().map(|number| *number as f32).collect();
    let element = |path: &str| path.strip_prefix(name).is_some_and(|rest| rest.starts_with('['));
    let elements: Vec<_> =
        program.interface().uniforms.iter().filter(|uniform| element(&uniform.name)).collect();
    if elements.is_empty() {
        return values.set(name, &numbers);
    }
    let wanted: usize = elements.iter().map(|uniform| uniform.ty.scalars()).sum();
    if wanted != numbers.len() {
        let ty = format!("{}[{}]", elements[0].ty, elements.len());
        return Err(UniformError::Count { name: name.to_owned(), ty, wanted, given: numbers.len() });
    }
    let mut rest = &numbers[..];
    for uniform in elements {
        let (own, others) = rest.split_at(uniform.ty.scalars());
        values.set(&uniform.name, own)?;
        rest = others;
    }
    Ok(())
}
