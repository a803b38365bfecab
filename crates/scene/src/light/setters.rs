//! Lights made and changed in code.

use core::borrow::Borrow;
use std::sync::Arc;

use glam::{DMat3, DVec3};
use glanz_color::{Rgb, Spectrum};
use thiserror::Error;

use crate::{Attenuation, Light, LightColor, LightColors, LightKind, Space};

/// The light has no such place or direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("{kind} light has no {what}")]
pub struct LightError {
    /// The kind, with its article.
    pub kind: &'static str,
    /// What was to be set.
    pub what: &'static str,
}

/// Lights by kind. Colours are in classic units: 1 on a white matte surface that faces the light gives 1.
impl Light {
    /// Light from everywhere, for the ambient terms of materials.
    pub fn ambient(color: impl Into<LightColor>) -> Self {
        Self::new(LightKind::Ambient, LightColors::ambient(color))
    }

    /// Parallel light that travels along `direction`.
    ///
    /// ```
    /// use glanz_scene::{Light, Scene};
    ///
    /// let lamp = Light::directional([-1.0, -1.0, -1.0], [1.0, 0.9, 0.8]).named("key").attached_to_camera();
    /// let scene = Scene::new().with_light(lamp).with_light(Light::ambient([0.1; 3]));
    /// assert_eq!(scene.light("key")?.colors.diffuse, [1.0, 0.9, 0.8].into());
    /// # Ok::<(), glanz_scene::LookupError>(())
    /// ```
    pub fn directional(direction: impl Into<DVec3>, color: impl Into<LightColor>) -> Self {
        Self::new(LightKind::Directional { direction: direction.into() }, LightColors::direct(color))
    }

    /// Light from a point, which does not fade with distance.
    pub fn point(position: impl Into<DVec3>, color: impl Into<LightColor>) -> Self {
        let kind = LightKind::Point { position: position.into(), attenuation: Attenuation::NONE };
        Self::new(kind, LightColors::direct(color))
    }

    /// Light from a point into a cone of this half angle, which does not fade with distance.
    pub fn spot(
        position: impl Into<DVec3>,
        direction: impl Into<DVec3>,
        cutoff_deg: f64,
        color: impl Into<LightColor>,
    ) -> Self {
        let kind = LightKind::Spot {
            position: position.into(),
            direction: direction.into(),
            cutoff: cutoff_deg.to_radians(),
            exponent: 0.0,
            smooth_edge: None,
            attenuation: Attenuation::NONE,
        };
        Self::new(kind, LightColors::direct(color))
    }

    /// The same radiance from all directions.
    pub fn environment(color: impl Into<LightColor>) -> Self {
        let kind = LightKind::Environment { map: None, rotation: DMat3::IDENTITY };
        Self::new(kind, LightColors::direct(color))
    }

    /// The same under a name.
    #[must_use]
    pub fn named(self, name: impl Into<String>) -> Self {
        Self { name: name.into(), ..self }
    }

    /// The same, moving with the camera: position and direction are in its space.
    #[must_use]
    pub fn attached_to_camera(self) -> Self {
        Self { space: Space::Camera, ..self }
    }

    /// The same with another spectrum; see [`Light::set_spectrum`].
    #[must_use]
    pub fn with_spectrum(mut self, spectrum: impl Borrow<Spectrum>) -> Self {
        self.set_spectrum(spectrum);
        self
    }
}

/// Changes.
impl Light {
    /// Gives the light another spectrum. It stays as strong as it is: its luminance is kept, and the scale of the
    /// spectrum means nothing. Terms that get no light get none of this either; a light that sends none at all
    /// becomes a unit light.
    ///
    /// A spectrum without power makes it dark, and one with numbers that are not finite is refused when the scene is
    /// prepared.
    ///
    /// ```
    /// use glanz_scene::Light;
    ///
    /// let mut lamp = Light::point([0.0, 2.0, 0.0], [0.5; 3]);
    /// lamp.set_spectrum(glanz_color::light("A")?);
    /// assert!((lamp.colors.diffuse.strength() - 0.5).abs() < 1e-6);
    /// assert!(lamp.colors.ambient.is_black());
    /// # Ok::<(), glanz_color::UnknownName>(())
    /// ```
    pub fn set_spectrum(&mut self, spectrum: impl Borrow<Spectrum>) {
        let spectrum = spectrum.borrow();
        let unscaled = || LightColor::Spectrum(Arc::new(*spectrum));
        let unit = LightColor::unit(spectrum).unwrap_or_else(unscaled);
        self.recolor(|old| match old {
            Some(old) => unit.scaled(old.strength()),
            None => unit.clone(),
        });
    }

    /// Gives the light another colour, in amounts of the sRGB primaries. Terms that get no light get none of this
    /// either; of a light that sends none at all, those get it that do by default.
    pub fn set_color(&mut self, color: Rgb) {
        self.recolor(|_| color.into());
    }

    /// Changes all colours that are not black; where all are, those that a light of this kind has by default.
    fn recolor(&mut self, new: impl Fn(Option<&LightColor>) -> LightColor) {
        let LightColors { ambient, diffuse, specular } = &mut self.colors;
        let colors = [ambient, diffuse, specular];
        if colors.iter().all(|color| color.is_black()) {
            let default = new(None);
            self.colors = match self.kind {
                LightKind::Ambient => LightColors::ambient(default),
                _ => LightColors::direct(default),
            };
            return;
        }
        for color in colors.into_iter().filter(|color| !color.is_black()) {
            *color = new(Some(color));
        }
    }

    /// Moves the light.
    ///
    /// # Errors
    /// If lights of its kind are nowhere.
    pub fn set_position(&mut self, to: impl Into<DVec3>) -> Result<(), LightError> {
        match &mut self.kind {
            LightKind::Point { position, .. }
            | LightKind::Spot { position, .. }
            | LightKind::Area { position, .. } => *position = to.into(),
            _ => return Err(LightError { kind: self.kind_with_article(), what: "position" }),
        }
        Ok(())
    }

    /// Turns the light: where directional light and that of a spot travel, or where an area faces.
    ///
    /// # Errors
    /// If lights of its kind have no direction.
    pub fn set_direction(&mut self, to: impl Into<DVec3>) -> Result<(), LightError> {
        match &mut self.kind {
            LightKind::Directional { direction }
            | LightKind::Spot { direction, .. }
            | LightKind::Area { direction, .. } => *direction = to.into(),
            _ => return Err(LightError { kind: self.kind_with_article(), what: "direction" }),
        }
        Ok(())
    }

    fn kind_with_article(&self) -> &'static str {
        match self.kind {
            LightKind::Ambient => "an ambient",
            LightKind::Directional { .. } => "a directional",
            LightKind::Point { .. } => "a point",
            LightKind::Spot { .. } => "a spot",
            LightKind::Area { .. } => "an area",
            LightKind::Environment { .. } => "an environment",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_spectrum_keeps_the_strength_of_each_term() {
        let mut light = Light::directional([0.0, 0.0, -1.0], [1.0; 3]);
        light.colors.specular = LightColor::Rgb(Rgb::gray(0.25));
        light.set_spectrum(glanz_color::light("D65").unwrap());
        let strengths = [&light.colors.ambient, &light.colors.diffuse, &light.colors.specular];
        let strengths = strengths.map(LightColor::strength);
        for (found, expected) in strengths.iter().zip([0.0, 1.0, 0.25]) {
            assert!((found - expected).abs() < 1e-6, "{strengths:?}");
        }
        let before = light.clone();
        light.set_spectrum(glanz_color::light("D65").unwrap() * 1000.0);
        let scaled = [&light.colors.diffuse, &before.colors.diffuse].map(LightColor::strength);
        assert!((scaled[0] - scaled[1]).abs() < 1e-12, "its scale means nothing");
    }

    #[test]
    fn a_dark_light_becomes_a_unit_light() {
        let mut light = Light::ambient(Rgb::BLACK);
        light.set_color(Rgb::gray(0.5));
        assert_eq!(light.colors, LightColors::ambient(Rgb::gray(0.5)));
        let mut light = Light::point([0.0; 3], Rgb::BLACK);
        light.set_spectrum(glanz_color::light("A").unwrap());
        assert!(light.colors.ambient.is_black());
        assert!((light.colors.diffuse.strength() - 1.0).abs() < 1e-9);
    }

    #[test]
    fn lights_that_are_nowhere_cannot_be_moved() {
        let mut light = Light::directional([0.0, 0.0, -1.0], Rgb::WHITE);
        let error = light.set_position([1.0, 2.0, 3.0]).unwrap_err();
        assert_eq!(error.to_string(), "a directional light has no position");
        light.set_direction([0.0, -1.0, 0.0]).unwrap();
        let mut point = Light::point([0.0; 3], Rgb::WHITE);
        point.set_position(DVec3::X).unwrap();
        assert!(matches!(point.kind, LightKind::Point { position, .. } if position == DVec3::X));
        assert!(point.set_direction(DVec3::X).is_err());
    }
}
