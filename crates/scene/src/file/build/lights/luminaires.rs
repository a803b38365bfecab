//! Luminaires of lights.

use std::ops::Range;
use std::sync::Arc;

use super::surfaces::are_parallel;
use crate::file::build::builder::Builder;
use crate::file::error::Problem;
use crate::file::tables::lights::LightTable;
use crate::file::tables::profile::{ProfileTable, ProfileValue};
use crate::file::tables::values::{At, Number};
use crate::read::{FolderFiles, MAX_PROFILE_BYTES, ReadOptions, Resolver, read_profile};
use crate::{Luminaire, Profile};

impl ProfileTable {
    fn profile(&self, span: &Range<usize>) -> Result<Profile, Problem> {
        let plain = |list: &[Number]| list.iter().map(|number| number.0).collect::<Vec<f64>>();
        let (c_deg, gamma_deg) = (plain(&self.c_deg), plain(&self.gamma_deg));
        let rising = |list: &[f64], most: f64| {
            list.windows(2).all(|pair| pair[0] < pair[1])
                && list.first().is_some_and(|first| *first >= 0.0)
                && list.last().is_some_and(|last| *last <= most)
        };
        let whole = c_deg == [0.0] || c_deg.first() == Some(&0.0) && c_deg.last() == Some(&360.0);
        if !whole || !rising(&c_deg, 360.0) || !rising(&gamma_deg, 180.0) {
            let message =
                "expected increasing angles: c_deg a single 0 or from 0 to 360, gamma_deg within 0 to 180";
            return Err(Problem::at(span, message));
        }
        if self.candela.len() != c_deg.len() || self.candela.iter().any(|list| list.len() != gamma_deg.len())
        {
            let (planes, angles) = (c_deg.len(), gamma_deg.len());
            let message = format!("expected {planes} lists of {angles} values in 'candela'");
            return Err(Problem::at(span, message));
        }
        let candela: Vec<f64> = self.candela.iter().flatten().map(|value| value.0).collect();
        let profile = Profile { c_deg, gamma_deg, candela };
        match profile.max() > 0.0 {
            true => Ok(profile),
            false => Err(Problem::at(span, "there is no light in this profile")),
        }
    }
}

impl LightTable {
    /// How the light sends more into some directions than into others, if it has a profile.
    pub(super) fn luminaire(&self, builder: &mut Builder) -> Result<Option<Luminaire>, Problem> {
        let Some(file) = &self.profile else { return Ok(None) };
        let profile = match &file.value {
            ProfileValue::File(name) => {
                builder.profile(&At { value: name.clone(), span: file.span.clone() })?
            }
            ProfileValue::Table(table) => Arc::new(table.profile(&file.span)?),
        };
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
        if let Some(profile) = self.made.profiles.get(&file.value) {
            return Ok(profile.clone());
        }
        let options = ReadOptions { max_bytes: MAX_PROFILE_BYTES, ..self.input.options.clone() };
        let bytes = FolderFiles::new(self.base(), &options)
            .read(file)
            .map_err(|error| crate::file::build::files::unresolved(file, &error, &file.span))?;
        let (profile, notes) =
            read_profile(&bytes, file).map_err(|error| Problem::at(&file.span, error.to_string()))?;
        if profile.max() <= 0.0 {
            return Err(Problem::at(&file.span, format!("there is no light in '{}'", file.value)));
        }
        self.input.notes.extend(notes.iter().map(|note| format!("'{}': {note}", file.value)));
        let profile = Arc::new(profile);
        self.made.profiles.insert(file.value.clone(), profile.clone());
        Ok(profile)
    }
}
