//! Objects of a scene as the command line names them.

use glanz_math::names::shown;
use glanz_scene::Scene;

use crate::print::failure::{Failure, Report};

/// The name of an object, or its number.
pub(crate) fn object_name(scene: &Scene, number: usize) -> String {
    let name = scene.objects.get(number).map_or("", |object| object.name.as_str());
    if name.is_empty() { number.to_string() } else { name.to_owned() }
}

/// The number of an object, from its name or its number.
pub(crate) fn object_of(scene: &Scene, name: &str) -> Result<usize, Failure> {
    let named = scene.objects.iter().position(|object| object.name == name);
    let numbered = || name.parse().ok().filter(|number: &usize| *number < scene.objects.len());
    named.or_else(numbered).ok_or_else(|| {
        let names = (0..scene.objects.len()).map(|number| object_name(scene, number));
        let known: Vec<_> = names.map(|name| shown(&name).into_owned()).collect();
        let report = Report::new(format_args!("there is no object '{}'", shown(name)));
        report.help(format_args!("there are: {}", known.join(", "))).into()
    })
}
