//! Redoing only what changed.

use std::sync::Arc;

use glanz_picture::{Channels, ToScreen};
use glanz_scene::{Light, LightKind, Material, Scene, White};

use super::build::bvh::{bvh, is_opaque};
use super::build::objects::{add_objects, move_object, needs_tangents};
use super::build::{check, lights, textures};
use super::color::fill::{fill_material, fill_table};
use super::data::Prepared;
use super::options::{PrepareError, PrepareOptions};
use super::source::Colors;
use super::{Observation, ObservationError};

/// What of a scene has changed since it was prepared or updated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Change {
    /// The camera, or the size of the picture. Nothing is redone: that is the view's.
    Camera,
    /// The light of this number: where it is, how it fades, its colour. Its kind too, which costs more.
    Light(usize),
    /// The material of this number: any parameter, tint or texture use.
    Material(usize),
    /// Where the object of this number is. If its mesh, material or shading changed, that is [`Change::Geometry`].
    Object(usize),
    /// The colours of lights and materials, and the white.
    Colors,
    /// Meshes and objects: how many, of what, shaded how.
    Geometry,
    /// The pictures that textures are.
    Textures,
    /// Anything, the numbers of lights and materials among it.
    All,
}

impl Prepared {
    /// Redoes what these changes of the scene touch, and nothing else. The result is that of preparing the scene
    /// anew, to the last bit.
    ///
    /// # Errors
    /// As [`prepare`](super::prepare), and where a number names nothing. What was changed before the change that
    /// fails stays changed; that one changes nothing.
    pub fn update(&mut self, scene: &Scene, changes: &[Change]) -> Result<(), PrepareError> {
        let mut casters_moved = false;
        let result = changes.iter().try_for_each(|change| self.apply(scene, *change, &mut casters_moved));
        let casts = scene.render.shadows;
        if casters_moved || casts != self.bvh.is_some() {
            self.bvh = casts.then(|| Arc::new(bvh(self)));
        }
        result
    }

    fn apply(&mut self, scene: &Scene, change: Change, casters_moved: &mut bool) -> Result<(), PrepareError> {
        match change {
            Change::Camera => Ok(()),
            Change::Light(number) => self.update_light(scene, number),
            Change::Material(number) => self.update_material(scene, number, casters_moved),
            Change::Object(number) => {
                *casters_moved = true;
                self.update_object(scene, number)
            }
            Change::Colors => self.update_colors(scene),
            Change::Geometry => {
                *casters_moved = true;
                self.update_geometry(scene)
            }
            Change::Textures => {
                check::check(scene)?;
                self.textures = textures(scene);
                Ok(())
            }
            Change::All => {
                *self =
                    super::prepare(scene, &self.source.options)?.channels_from(self.source.first_channel)?;
                Ok(())
            }
        }
    }

    fn update_light(&mut self, scene: &Scene, number: usize) -> Result<(), PrepareError> {
        let colors = &self.source.colors;
        let (Some(new), Some(old)) = (scene.lights.get(number), colors.lights.get(number)) else {
            return Err(missing("light", number));
        };
        if scene.lights.len() != colors.lights.len() || !has_same_rows(new, old) {
            return self.apply(scene, Change::All, &mut false);
        }
        let directed = |light: &&Light| light.kind != LightKind::Ambient;
        let place = colors.lights[..number].iter().filter(directed).count();
        let (recolored, same_map) = (new.colors != old.colors, has_same_map(new, old));
        let unchanged = same_map && new.luminaire == old.luminaire;
        if let Some(light) = lights::prepare_one(number, new, self.lights.get(place).filter(|_| unchanged))? {
            self.lights[place] = light;
        }
        Arc::make_mut(&mut self.source.colors).lights[number] = new.clone();
        match (recolored, same_map) {
            (false, true) => Ok(()),
            (_, true) => fill_table(self),
            (_, false) => {
                // What lobes made of the old map is of no use.
                self.materials.iter_mut().for_each(|material| material.integrals.clear());
                fill_table(self)
            }
        }
    }

    fn update_material(
        &mut self,
        scene: &Scene,
        number: usize,
        casters_moved: &mut bool,
    ) -> Result<(), PrepareError> {
        let Some(new) = scene.materials.get(number).filter(|_| number < self.materials.len()) else {
            return Err(missing("material", number));
        };
        check::check(scene)?;
        let colors = Arc::make_mut(&mut self.source.colors);
        let old = core::mem::replace(&mut colors.materials[number], new.clone());
        let was_opaque = is_opaque(&self.materials[number]);
        if let Err(error) = fill_material(self, number) {
            Arc::make_mut(&mut self.source.colors).materials[number] = old;
            return Err(error);
        }
        *casters_moved |= was_opaque != is_opaque(&self.materials[number]);
        if needs_tangents(new) != needs_tangents(&old) {
            self.update_geometry(scene)?;
        }
        Ok(())
    }

    fn update_object(&mut self, scene: &Scene, number: usize) -> Result<(), PrepareError> {
        let known = self.objects.get(number).zip(self.source.objects.get(number));
        let Some((object, (own, source))) = scene.objects.get(number).zip(known) else {
            return Err(missing("object", number));
        };
        let options = &self.source.options;
        let same = object.mesh == source.mesh
            && object.mesh < scene.meshes.len()
            && object.material == own.material
            && own.shading == options.shading.or(object.shading).unwrap_or(scene.render.shading)
            && own.interpolation
                == options.interpolation.or(object.interpolation).unwrap_or(scene.render.interpolation);
        if same && move_object(self, scene, number)? {
            return Ok(());
        }
        self.update_geometry(scene)
    }

    fn update_colors(&mut self, scene: &Scene) -> Result<(), PrepareError> {
        let colors = &self.source.colors;
        let same_lights = scene.lights.len() == colors.lights.len()
            && scene.lights.iter().zip(&colors.lights).all(|(new, old)| has_same_rows(new, old));
        if !same_lights || scene.materials.len() != colors.materials.len() {
            return self.apply(scene, Change::All, &mut false);
        }
        lights::check_colors(&scene.lights)?;
        self.refill(Colors::of(scene))
    }

    fn update_geometry(&mut self, scene: &Scene) -> Result<(), PrepareError> {
        check::check(scene)?;
        let mut next = self.clone();
        add_objects(&mut next, scene)?;
        *self = next;
        Ok(())
    }

    /// Fills the table from other colours; they stay as they were where that fails.
    fn refill(&mut self, colors: Colors) -> Result<(), PrepareError> {
        let old = core::mem::replace(&mut self.source.colors, Arc::new(colors));
        fill_table(self).inspect_err(|_| self.source.colors = old)
    }
}

/// Other observers of the same scene. Geometry, textures and integrals of lobes are shared, not copied.
impl Prepared {
    /// Who looks.
    pub fn observation(&self) -> &Observation {
        &self.source.options.observation
    }

    /// The same scene for another observer or colour mode.
    ///
    /// # Errors
    /// As [`prepare`](super::prepare).
    pub fn observed_by(&self, observation: Observation) -> Result<Self, PrepareError> {
        let mut next = self.clone();
        next.source.options = PrepareOptions { observation, ..self.source.options.clone() };
        next.source.first_channel = 0;
        fill_table(&mut next)?;
        Ok(next)
    }

    /// The same with the three channels of the observation from this one on: a frame has three at a time. Those
    /// that the observer does not have are 0.
    ///
    /// # Errors
    /// As [`prepare`](super::prepare).
    pub fn channels_from(&self, first: usize) -> Result<Self, PrepareError> {
        if first == self.source.first_channel {
            return Ok(self.clone());
        }
        let mut next = self.clone();
        next.source.first_channel = first;
        fill_table(&mut next)?;
        Ok(next)
    }

    /// The way from the observer's channels to a screen, for this white; none where they are linear sRGB already.
    ///
    /// # Errors
    /// Where the scene has no such white, or the observer sees none.
    pub fn to_screen(&self, white: White) -> Result<Option<ToScreen>, ObservationError> {
        let colors = &self.source.colors;
        self.observation().to_screen_under(&colors.lights, colors.photometric, white)
    }

    /// Whether frames are in cd/m².
    pub fn is_photometric(&self) -> bool {
        self.source.colors.photometric
    }

    /// The lights and materials that the table was filled from.
    pub(crate) fn colors(&self) -> (&[Light], &[Material]) {
        (&self.source.colors.lights, &self.source.colors.materials)
    }

    /// The same geometry under lights and of materials of other colours, for three channels of another observation.
    pub(crate) fn recolored(
        &self,
        (lights, materials): (Vec<Light>, Vec<Material>),
        observation: Observation,
        first_channel: usize,
    ) -> Result<Self, PrepareError> {
        let mut next = self.clone();
        next.source.options.observation = observation;
        next.source.first_channel = first_channel;
        let Colors { photometric, white, .. } = *self.source.colors;
        next.refill(Colors { lights, materials, photometric, white })?;
        Ok(next)
    }

    /// All channels of the observation.
    pub(crate) fn all_channels(&self) -> Channels {
        let Colors { lights, photometric, white, .. } = &*self.source.colors;
        self.observation().channels(lights, *photometric, *white, (0, usize::MAX))
    }
}

fn missing(what: &str, number: usize) -> PrepareError {
    PrepareError::Scene { what: format!("{what} {number} (counted from 0) is not there") }
}

/// Whether two lights take the same rows of the tint table, by the same rules.
fn has_same_rows(new: &Light, old: &Light) -> bool {
    core::mem::discriminant(&new.kind) == core::mem::discriminant(&old.kind)
}

/// Whether two environments have the same map, and other lights always.
fn has_same_map(new: &Light, old: &Light) -> bool {
    match (&new.kind, &old.kind) {
        (LightKind::Environment { map: Some(new), .. }, LightKind::Environment { map: Some(old), .. }) => {
            Arc::ptr_eq(new, old) || new == old
        }
        (LightKind::Environment { map: new, .. }, LightKind::Environment { map: old, .. }) => {
            new.is_none() == old.is_none()
        }
        _ => true,
    }
}
