//! Redoing only what changed.

use std::sync::Arc;

use glanz_picture::{Channels, ToScreen};
use glanz_scene::{Light, LightKind, Material, Scene, White};

use super::build::bvh::{bvh, is_opaque};
use super::build::geometry::objects::{add_objects, move_object, needs_tangents};
use super::build::{check, lights, programs, textures};
use super::color::fill::{fill_material, fill_table, refill_means};
use super::data::{Prepared, PreparedObject};
use super::options::{PrepareError, PrepareOptions};
use super::source::{Colors, ObjectSource};
use super::{Change, Observation, ObservationError};

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
        let casts = if result.is_ok() { scene.render.shadows } else { self.bvh.is_some() };
        if casters_moved || casts != self.bvh.is_some() {
            match casts.then(|| bvh(self)).transpose() {
                Ok(tree) => self.bvh = tree.map(Arc::new),
                Err(error) => {
                    self.bvh = None;
                    return result.and(Err(error));
                }
            }
        }
        result
    }

    fn apply(&mut self, scene: &Scene, change: Change, casters_moved: &mut bool) -> Result<(), PrepareError> {
        match change {
            // Whether there are shadows is looked at after every update.
            Change::Camera | Change::Shadows => Ok(()),
            Change::Light(number) => self.update_light(scene, number),
            Change::Material(number) => self.with_textures(scene, casters_moved, |own, casters_moved| {
                own.update_material(scene, number, casters_moved)
            }),
            Change::Object(number) => self.update_object(scene, number, casters_moved),
            Change::Colors => self.with_textures(scene, casters_moved, |own, casters_moved| {
                own.update_colors(scene, casters_moved)
            }),
            Change::Programs => self.update_programs(scene),
            Change::Geometry => self.update_geometry(scene, casters_moved),
            Change::Textures => self.update_textures(scene, casters_moved),
            Change::All => {
                *self =
                    super::prepare(scene, &self.source.options)?.channels_from(self.source.first_channel)?;
                Ok(())
            }
        }
    }

    fn update_light(&mut self, scene: &Scene, number: usize) -> Result<(), PrepareError> {
        let new = scene.lights.get(number).ok_or_else(|| missing("light", number))?;
        let old = self.source.colors.lights.get(number).filter(|old| has_same_rows(new, old));
        let Some(old) = old.filter(|_| scene.lights.len() == self.source.colors.lights.len()) else {
            return self.apply(scene, Change::All, &mut false);
        };
        let recolored = new.colors != old.colors;
        let same_map = self.place_light(number, new)?;
        Arc::make_mut(&mut self.source.colors).lights[number] = new.clone();
        if recolored || !same_map { fill_table(self) } else { Ok(()) }
    }

    /// Gives a light its new geometry, and says whether its environment map is the one that it had.
    fn place_light(&mut self, number: usize, new: &Light) -> Result<bool, PrepareError> {
        let lights = &self.source.colors.lights;
        let directed = |light: &&Light| light.kind != LightKind::Ambient;
        let place = lights[..number].iter().filter(directed).count();
        let (same_map, old) = (has_same_map(new, &lights[number]), &lights[number]);
        let before = self.lights.get(place).filter(|_| same_map && new.luminaire == old.luminaire);
        if let Some(light) = lights::prepare_one(number, new, before)? {
            self.lights[place] = light;
        }
        Ok(same_map)
    }

    fn update_material(
        &mut self,
        scene: &Scene,
        number: usize,
        casters_moved: &mut bool,
    ) -> Result<(), PrepareError> {
        let new = scene.materials.get(number).ok_or_else(|| missing("material", number))?;
        if scene.materials.len() != self.materials.len() {
            return self.apply(scene, Change::All, &mut false);
        }
        check::check_material(scene, new)?;
        if needs_tangents(new) != needs_tangents(&self.source.colors.materials[number]) {
            return self.or_as_before(|own| {
                own.fill_from(new, number, casters_moved)?;
                own.update_geometry(scene, casters_moved)
            });
        }
        self.fill_from(new, number, casters_moved)
    }

    /// Prepares a material anew; it stays as it was where that fails.
    fn fill_from(
        &mut self,
        new: &Material,
        number: usize,
        casters_moved: &mut bool,
    ) -> Result<(), PrepareError> {
        let colors = Arc::make_mut(&mut self.source.colors);
        let old = core::mem::replace(&mut colors.materials[number], new.clone());
        let was_opaque = is_opaque(&self.materials[number]);
        if let Err(error) = fill_material(self, number) {
            Arc::make_mut(&mut self.source.colors).materials[number] = old;
            return Err(error);
        }
        *casters_moved |= was_opaque != is_opaque(&self.materials[number]);
        Ok(())
    }

    /// Compiles what is new; where that fails, all programs stay what they were.
    fn update_programs(&mut self, scene: &Scene) -> Result<(), PrepareError> {
        self.programs = programs::programs(scene, &self.source.options.observation, &self.programs)?;
        for (own, object) in self.objects.iter_mut().zip(&scene.objects) {
            own.program = object.program.or(scene.program);
        }
        Ok(())
    }

    fn update_object(
        &mut self,
        scene: &Scene,
        number: usize,
        casters_moved: &mut bool,
    ) -> Result<(), PrepareError> {
        let object = scene.objects.get(number).ok_or_else(|| missing("object", number))?;
        let options = &self.source.options;
        let is_same = |own: &PreparedObject, source: &ObjectSource| {
            let mesh = scene.meshes.get(object.mesh);
            object.mesh == source.mesh
                && mesh.is_some_and(|mesh| mesh.positions.len() == source.vertices)
                && object.material == own.material
                && own.shading == options.shading.or(object.shading).unwrap_or(scene.render.shading)
                && own.interpolation
                    == options.interpolation.or(object.interpolation).unwrap_or(scene.render.interpolation)
        };
        let mut known = self.objects.get(number).zip(self.source.objects.get(number)).into_iter();
        let same_count = scene.objects.len() == self.objects.len();
        if same_count && known.any(|(own, source)| is_same(own, source)) && move_object(self, scene, number)?
        {
            *casters_moved = true;
            return Ok(());
        }
        self.update_geometry(scene, casters_moved)
    }

    fn update_colors(&mut self, scene: &Scene, casters_moved: &mut bool) -> Result<(), PrepareError> {
        let colors = &self.source.colors;
        let same_lights = scene.lights.len() == colors.lights.len()
            && scene.lights.iter().zip(&colors.lights).all(|(new, old)| has_same_rows(new, old));
        if !same_lights || scene.materials.len() != colors.materials.len() {
            return self.apply(scene, Change::All, &mut false);
        }
        scene.materials.iter().try_for_each(|material| check::check_material(scene, material))?;
        let mut old = scene.materials.iter().zip(&colors.materials);
        let same_tangents = old.all(|(new, old)| needs_tangents(new) == needs_tangents(old));
        let was_opaque: Vec<bool> = self.materials.iter().map(is_opaque).collect();
        self.or_as_before(|own| {
            own.refill_from(scene)?;
            *casters_moved |= own.materials.iter().map(is_opaque).ne(was_opaque);
            if same_tangents { Ok(()) } else { own.update_geometry(scene, casters_moved) }
        })
    }

    /// Takes over all lights and materials of a scene that has as many of the same kinds.
    fn refill_from(&mut self, scene: &Scene) -> Result<(), PrepareError> {
        for (number, light) in scene.lights.iter().enumerate() {
            self.place_light(number, light)?;
        }
        self.refill(Colors::of(scene))
    }

    /// Takes over the textures. Materials that name one that is gone are prepared anew: those of the scene do not.
    fn update_textures(&mut self, scene: &Scene, casters_moved: &mut bool) -> Result<(), PrepareError> {
        check::check(scene, &self.source.options)?;
        let known = &self.source.colors.materials;
        let outdated: Vec<usize> =
            (0..known.len()).filter(|number| !check::has_textures(scene, &known[*number])).collect();
        if outdated.is_empty() {
            self.textures = textures(scene);
            refill_means(self);
            return Ok(());
        }
        if scene.materials.len() != known.len() {
            return self.apply(scene, Change::All, &mut false);
        }
        self.or_as_before(|own| {
            own.textures = textures(scene);
            refill_means(own);
            outdated.into_iter().try_for_each(|number| own.update_material(scene, number, casters_moved))
        })
    }

    /// Makes a change of materials, after that of the textures where their number is another: a material may name a
    /// new one.
    fn with_textures(
        &mut self,
        scene: &Scene,
        casters_moved: &mut bool,
        change: impl FnOnce(&mut Self, &mut bool) -> Result<(), PrepareError>,
    ) -> Result<(), PrepareError> {
        if scene.textures.len() == self.textures.len() {
            return change(self, casters_moved);
        }
        self.or_as_before(|own| {
            own.update_textures(scene, casters_moved)?;
            change(own, casters_moved)
        })
    }

    fn update_geometry(&mut self, scene: &Scene, casters_moved: &mut bool) -> Result<(), PrepareError> {
        if scene.materials.len() != self.materials.len() {
            return self.apply(scene, Change::All, &mut false);
        }
        check::check(scene, &self.source.options)?;
        self.or_as_before(|own| add_objects(own, scene))?;
        *casters_moved = true;
        Ok(())
    }

    /// Does something that may fail halfway; everything is as before where it does. What is shared is not copied.
    fn or_as_before(
        &mut self,
        change: impl FnOnce(&mut Self) -> Result<(), PrepareError>,
    ) -> Result<(), PrepareError> {
        let before = self.clone();
        change(self).inspect_err(|_| *self = before)
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

    /// Which of the observer's channels the first one is: 0 but for the further ones of an observer with more than three.
    pub fn first_channel(&self) -> usize {
        self.source.first_channel
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
