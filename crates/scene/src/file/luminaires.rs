//! The profiles of lights of a scene file.

use std::sync::Arc;

use super::build::Builder;
use super::error::Problem;
use super::lights::LightTable;
use super::surfaces::are_parallel;
use super::values::At;
use crate::read::{FolderFiles, MAX_PROFILE_BYTES, ReadOptions, Resolver, read_profile};
use crate::{Luminaire, Profile};

impl LightTable {
    /// How the light sends more into some directions than into others, if it has a profile.
    pub(super) fn luminaire(&self, builder: &mut Builder) -> Result<Option<Luminaire>, Problem> {
        let Some(file) = &self.profile else { return Ok(None) };
        let profile = builder.profile(file)?;
        let axis = self.given_direction()?.unwrap_or(Luminaire::AXIS);
        let c0 = match &self.profile_c0 {
            Some(c0) if are_parallel(c0.0, axis) => {
                return Err(Problem::at(&c0.span, "'profile_c0' is parallel to the axis of the light")
                    .help("it says how the profile is turned about its axis"));
            }
            Some(c0) => c0.0,
            None => Luminaire::c0_for(axis),
        };
        Ok(Some(Luminaire { profile, axis, c0 }))
    }
}

impl Builder {
    /// The profile of a file, read once.
    fn profile(&mut self, file: &At<String>) -> Result<Arc<Profile>, Problem> {
        if let Some(profile) = self.profiles.get(&file.value) {
            return Ok(profile.clone());
        }
        let options = ReadOptions { max_bytes: MAX_PROFILE_BYTES, ..self.options.clone() };
        let bytes = FolderFiles::new(self.base(), &options)
            .read(file)
            .map_err(|error| super::build::unresolved(file, &error, &file.span))?;
        self.hash.bytes(&bytes);
        let (profile, notes) =
            read_profile(&bytes, file).map_err(|error| Problem::at(&file.span, error.to_string()))?;
        if profile.max() <= 0.0 {
            return Err(Problem::at(&file.span, format!("there is no light in '{}'", file.value)));
        }
        self.notes.extend(notes.iter().map(|note| format!("'{}': {note}", file.value)));
        let profile = Arc::new(profile);
        self.profiles.insert(file.value.clone(), profile.clone());
        Ok(profile)
    }
}
