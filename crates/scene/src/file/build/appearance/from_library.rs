//! Materials of the library in a scene file.

use crate::file::build::builder::Builder;
use crate::file::error::Problem;
use crate::file::near::{list, nearest};
use crate::file::tables::values::At;
use crate::{Material, library};

impl Builder {
    /// The material that the key `library` names.
    pub(in crate::file::build) fn library_material(
        &mut self,
        name: &At<String>,
    ) -> Result<Material, Problem> {
        let info = library::info(name).map_err(|error| {
            Problem::at(&name.span, error.to_string()).help("`glanz material list` prints the library")
        })?;
        Ok(info.material())
    }

    /// The material of an object that names none of the scene's.
    pub(in crate::file::build) fn found_in_library(
        &mut self,
        name: &At<String>,
    ) -> Result<Material, Problem> {
        if library::info(name).is_ok() {
            return self.library_material(name);
        }
        let own = || self.names.materials.keys().map(String::as_str);
        let first = |names: Vec<&str>| names.first().map(|name| (*name).to_owned());
        let near = match (first(nearest(name, own())), first(nearest(name, library::names()))) {
            (Some(own), Some(other)) => format!("; did you mean '{own}', or '{other}' of the library?"),
            (Some(own), None) => format!("; did you mean '{own}'?"),
            (None, Some(other)) => format!("; did you mean '{other}' of the library?"),
            (None, None) => String::new(),
        };
        let help = format!(
            "the materials of the scene are: {}; `glanz material list` prints the library",
            list(own())
        );
        Err(Problem::at(&name.span, format!("unknown material '{}'{near}", name.value)).help(help))
    }
}
