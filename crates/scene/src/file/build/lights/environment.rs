//! Environment lights.

use std::sync::Arc;

use glam::DMat3;

use crate::file::build::builder::Builder;
use crate::file::error::Problem;
use crate::file::tables::lights::LightTable;
use crate::file::tables::settings::BackgroundValue;
use crate::file::tables::values::At;
use crate::memory::environment_bytes;
use crate::read::read_environment;
use crate::{Background, EnvironmentMap, LightKind};

impl LightTable {
    /// The environment.
    pub(super) fn environment(&self, builder: &mut Builder) -> Result<LightKind, Problem> {
        let map = self.file.as_ref().map(|file| builder.environment_map(file)).transpose()?;
        let rotation = match (&self.rotate_deg, &self.rotation) {
            (Some(_), Some(rows)) => return Err(Problem::at(&rows.span, "'rotation' beside 'rotate_deg'")),
            (None, Some(rows)) => {
                let rows_are = rows.value.map(|row| row.map(|number| number.0));
                let matrix = DMat3::from_cols_array_2d(&rows_are).transpose();
                if !(matrix.transpose() * matrix).abs_diff_eq(DMat3::IDENTITY, 1e-6) {
                    return Err(Problem::at(&rows.span, "the rows are not those of a rotation"));
                }
                matrix
            }
            (turn, None) => turn.as_ref().map_or(DMat3::IDENTITY, |turn| turn.0),
        };
        Ok(LightKind::Environment { map, rotation })
    }
}

impl Builder {
    /// The picture of a file, read once. What it takes is taken off the budget.
    fn environment_map(&mut self, file: &At<String>) -> Result<Arc<EnvironmentMap>, Problem> {
        if let Some(map) = self.made.environments.get(&file.value) {
            return Ok(map.clone());
        }
        let bytes = self.read_beside(file)?;
        let (map, notes) = read_environment(&bytes, file, &self.input.options)
            .map_err(|error| Problem::at(&file.span, error.to_string()))?;
        let size = environment_bytes(map.width, map.height);
        self.take(format_args!("'{}'", file.value), size, &file.span)?;
        self.input.notes.extend(notes.iter().map(|note| format!("'{}': {note}", file.value)));
        let map = Arc::new(map);
        self.made.environments.insert(file.value.clone(), map.clone());
        Ok(map)
    }

    /// That there is an environment where the background is to be one.
    pub(in crate::file) fn check_background(
        &self,
        background: Option<&At<BackgroundValue>>,
    ) -> Result<(), Problem> {
        let is_environment = |light: &crate::Light| matches!(light.kind, LightKind::Environment { .. });
        match background {
            Some(At { value: BackgroundValue(Background::Environment), span })
                if !self.scene.lights.iter().any(is_environment) =>
            {
                Err(Problem::at(span, "the background is to be the environment, but there is none")
                    .help("give a light of kind = \"environment\""))
            }
            _ => Ok(()),
        }
    }
}
