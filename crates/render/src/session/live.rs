//! A scene with all that drawing it again takes.

use std::path::Path;

use glanz_color::Observer;
use glanz_eye::Viewer;
use glanz_math::SimdLevel;
use glanz_picture::{Encoding, Frame, ToneMap};
use glanz_scene::{
    Background, Camera, ColorMode, DebugView, Image, Key, Light, LookupError, Material, Object,
    RenderSettings, Scene, Shading, White,
};

use super::before::{Before, Part};
use crate::Backend;
use crate::prepare::{Change, PrepareError, Prepared, check_background, prepare};
use crate::shot::{SaveError, Shot, ShotError, ShotOptions, Sight};
use crate::view::{Aovs, Samples, View};

/// A scene that changes while it is drawn again and again: of what is prepared, only that is redone which depends on
/// what changed.
///
/// Every setter says by itself what it changes; after [`Session::scene_mut`] it is found by comparing. The next drawing,
/// or [`Session::update`], takes the changes over. Where they make no picture, that is an error, and the scene is again
/// what was drawn last.
///
/// ```
/// use glanz_render::Session;
/// use glanz_scene::{Light, Mesh, Scene, library};
///
/// let scene = Scene::new()
///     .with_mesh(Mesh::builtin("sphere")?, library::material("gold")?)
///     .with_light(Light::point([1.0, 2.0, 3.0], [1.0; 3]).named("lamp"))
///     .with_size(32, 24);
/// let mut session = Session::new(scene)?;
/// let mut rgba = vec![0; 4 * 32 * 24];
/// for step in 0..3 {
///     session.light_mut("lamp")?.set_position([f64::from(step), 2.0, 3.0])?;
///     session.draw_into(&mut rgba)?;
/// }
/// session.material_mut("gold")?.set("alpha", 7.0).unwrap_err();
/// session.set_size(0, 0);
/// assert!(session.rgba8().is_err());
/// assert_eq!(session.rgba8()?, rgba, "as it was");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Session {
    scene: Scene,
    /// Of the scene as it was before the changes.
    shot: Shot,
    before: Before,
}

impl Session {
    /// Prepares a scene.
    ///
    /// # Errors
    /// Where the scene cannot be drawn.
    pub fn new(scene: Scene) -> Result<Self, ShotError> {
        let shot = Shot::with(&scene, ShotOptions::of(&scene)?)?;
        Ok(Self { scene, shot, before: Before::default() })
    }

    /// The same, drawn by another back end.
    #[must_use]
    pub fn on(self, backend: Box<dyn Backend>) -> Self {
        Self { shot: self.shot.on(backend), ..self }
    }

    /// The same, drawn by the CPU on chosen SIMD instructions.
    #[must_use]
    pub fn on_level(self, level: SimdLevel) -> Self {
        Self { shot: self.shot.on_level(level), ..self }
    }

    /// The scene, with what changed.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The scene without what changed since it was drawn or updated last, as arrays.
    pub fn prepared(&self) -> &Prepared {
        self.shot.prepared()
    }

    /// Camera and size without what changed since, as back ends want them.
    pub fn view(&self) -> &View {
        self.shot.view()
    }
}

/// Changes.
impl Session {
    /// The scene, any part of which may be changed. It is copied, meshes and all, to find out later what was.
    pub fn scene_mut(&mut self) -> &mut Scene {
        self.before.keep_all(&self.scene);
        &mut self.scene
    }

    /// The material of this name or number, to be changed.
    ///
    /// # Errors
    /// [`LookupError`] where there is none, or where several have the name.
    pub fn material_mut<'k>(&mut self, key: impl Into<Key<'k>>) -> Result<&mut Material, LookupError> {
        let number = self.scene.material_number(key)?;
        let part = &mut self.scene.materials[number];
        let is_it = |kept: &Part| matches!(kept, Part::Material(kept, _) if *kept == number);
        self.before.keep(is_it, || Part::Material(number, part.clone()));
        Ok(part)
    }

    /// The light of this name or number, to be changed.
    ///
    /// # Errors
    /// [`LookupError`] where there is none, or where several have the name.
    pub fn light_mut<'k>(&mut self, key: impl Into<Key<'k>>) -> Result<&mut Light, LookupError> {
        let number = self.scene.light_number(key)?;
        let part = &mut self.scene.lights[number];
        let is_it = |kept: &Part| matches!(kept, Part::Light(kept, _) if *kept == number);
        self.before.keep(is_it, || Part::Light(number, part.clone()));
        Ok(part)
    }

    /// The object of this name or number, to be changed.
    ///
    /// # Errors
    /// [`LookupError`] where there is none, or where several have the name.
    pub fn object_mut<'k>(&mut self, key: impl Into<Key<'k>>) -> Result<&mut Object, LookupError> {
        let number = self.scene.object_number(key)?;
        let part = &mut self.scene.objects[number];
        let is_it = |kept: &Part| matches!(kept, Part::Object(kept, _) if *kept == number);
        self.before.keep(is_it, || Part::Object(number, part.clone()));
        Ok(part)
    }

    /// Looks by this camera. Nothing is prepared anew.
    pub fn set_camera(&mut self, camera: Camera) {
        let old = self.scene.camera;
        self.before.keep(|kept| matches!(kept, Part::Camera(_)), || Part::Camera(old));
        self.scene.camera = Some(camera);
    }

    /// Looks with this eye, or with that of the colour mode.
    pub fn set_observer(&mut self, observer: Option<Observer>) {
        let old = core::mem::replace(&mut self.scene.observer, observer);
        let eye = self.scene.eye.take();
        self.before.keep(|kept| matches!(kept, Part::Observer(..)), || Part::Observer(old, eye));
    }

    /// Looks with the eye of a person, which takes the place of an observer; modes with spectra alone have one.
    pub fn set_eye(&mut self, eye: Option<Viewer>) {
        let old = core::mem::replace(&mut self.scene.eye, eye);
        let observer = self.scene.observer.take();
        self.before.keep(|kept| matches!(kept, Part::Observer(..)), || Part::Observer(observer, old));
    }

    /// Sets width and height of the picture, in pixels.
    pub fn set_size(&mut self, width: u32, height: u32) {
        let image = self.image_mut();
        (image.width, image.height) = (width, height);
    }

    /// Sets how many coverage samples a pixel has.
    pub fn set_samples(&mut self, samples: Samples) {
        self.image_mut().samples = samples.count();
    }

    /// Sets what is behind all objects; colours are linear sRGB.
    pub fn set_background(&mut self, background: Background) {
        self.image_mut().background = background;
    }

    /// Sets the exposure, in stops.
    pub fn set_ev(&mut self, ev: f64) {
        self.render_mut().ev = ev;
    }

    /// Sets how light is compressed to the display's range.
    pub fn set_tone_map(&mut self, tone_map: ToneMap) {
        self.render_mut().tone_map = tone_map;
    }

    /// Sets how light becomes the codes of a picture.
    pub fn set_encoding(&mut self, encoding: Encoding) {
        self.render_mut().encoding = encoding;
    }

    /// Sets the white that becomes the screen's.
    pub fn set_white(&mut self, white: White) {
        self.render_mut().white = white;
    }

    /// Sets how colour is treated.
    pub fn set_mode(&mut self, mode: ColorMode) {
        self.render_mut().mode = mode;
    }

    /// Sets what the picture shows.
    pub fn set_show(&mut self, show: DebugView) {
        self.render_mut().show = show;
    }

    /// Sets where the illumination model is evaluated, for objects that do not say it themselves.
    pub fn set_shading(&mut self, shading: Shading) {
        self.render_mut().shading = shading;
    }

    /// Sets whether surfaces stand in each other's light.
    pub fn set_shadows(&mut self, shadows: bool) {
        self.render_mut().shadows = shadows;
    }

    fn image_mut(&mut self) -> &mut Image {
        let image = &mut self.scene.image;
        self.before.keep(|kept| matches!(kept, Part::Image(_)), || Part::Image(*image));
        image
    }

    fn render_mut(&mut self) -> &mut RenderSettings {
        let render = &mut self.scene.render;
        self.before.keep(|kept| matches!(kept, Part::Render(_)), || Part::Render(*render));
        render
    }
}

/// Drawing.
impl Session {
    /// Takes over what changed, as drawing does first.
    ///
    /// # Errors
    /// Where the scene cannot be drawn so. It is then what it was before the changes, and can be drawn.
    pub fn update(&mut self) -> Result<(), ShotError> {
        if self.before.is_empty() {
            return Ok(());
        }
        let before = core::mem::take(&mut self.before);
        let changes = before.changes(&self.scene);
        self.apply(&changes).inspect_err(|_| {
            before.restore(&mut self.scene);
            self.go_back(&changes);
        })
    }

    fn apply(&mut self, changes: &[Change]) -> Result<(), ShotError> {
        let options = ShotOptions::of(&self.scene)?;
        check_background(&self.scene)?;
        if options.mistake.is_some() || self.shot.mistake.is_some() {
            return self.begin_again(options);
        }
        let observation = &options.prepare.observation;
        let sight = Sight::of(&self.scene, &options)?;
        self.shot.makings = options.makings();
        match self.shot.prepared.observation() == observation {
            true => self.shot.prepared.update(&self.scene, changes)?,
            false => self.shot.prepared = self.observed_by(&options, changes)?,
        }
        self.shot.sight = sight;
        Ok(())
    }

    /// Prepares the whole scene: what a mistake changes is not found by comparing scenes that do not have it.
    fn begin_again(&mut self, options: ShotOptions) -> Result<(), ShotError> {
        let Shot { prepared, sight, mistake, makings, effect, .. } = Shot::with(&self.scene, options)?;
        (self.shot.prepared, self.shot.sight) = (prepared, sight);
        (self.shot.mistake, self.shot.makings, self.shot.effect) = (mistake, makings, effect);
        Ok(())
    }

    /// The scene for another observer, with what changed beside.
    fn observed_by(&self, options: &ShotOptions, changes: &[Change]) -> Result<Prepared, PrepareError> {
        let observed = || {
            let mut next = self.shot.prepared.observed_by(options.prepare.observation.clone())?;
            next.update(&self.scene, changes)?;
            Ok(next)
        };
        // What fails on the way need not fail at the end.
        observed().or_else(|_: PrepareError| prepare(&self.scene, &options.prepare))
    }

    /// Undoes changes of which some may have been made, for the scene as it was.
    fn go_back(&mut self, changes: &[Change]) {
        // With a mistake nothing was changed before it was known to be possible.
        if self.shot.mistake.is_some() {
            return;
        }
        if self.shot.prepared.update(&self.scene, changes).is_err()
            && let Ok(options) = ShotOptions::of(&self.scene)
            && let Ok(prepared) = prepare(&self.scene, &options.prepare)
        {
            self.shot.prepared = prepared;
        }
    }

    /// Draws into a buffer of `4·width·height` bytes: 8-bit sRGB by rows from the top.
    ///
    /// # Errors
    /// As [`Session::update`], and [`ShotError::Length`] if the buffer has another length.
    pub fn draw_into(&mut self, rgba: &mut [u8]) -> Result<(), ShotError> {
        self.update()?;
        self.shot.draw_into(rgba)
    }

    /// The picture as 8-bit sRGB, 4 bytes per pixel by rows from the top.
    ///
    /// # Errors
    /// As [`Session::update`].
    pub fn rgba8(&mut self) -> Result<Vec<u8>, ShotError> {
        self.update()?;
        self.shot.rgba8()
    }

    /// The observer's channels in linear light, over the background.
    ///
    /// # Errors
    /// As [`Session::update`].
    pub fn frame(&mut self) -> Result<Frame, ShotError> {
        self.frame_with(Aovs::default())
    }

    /// The same with depth, normals or object numbers.
    ///
    /// # Errors
    /// As [`Session::update`].
    pub fn frame_with(&mut self, aovs: Aovs) -> Result<Frame, ShotError> {
        self.update()?;
        self.shot.frame_in_steps(aovs, &mut |_| ())
    }

    /// The same into a frame that was drawn before, whose memory is used again; all that it held is replaced.
    ///
    /// ```
    /// use glanz_render::{Aovs, Frame, Session};
    /// use glanz_scene::{Camera, Mesh, Scene, library};
    ///
    /// let scene = Scene::new().with_mesh(Mesh::builtin("sphere")?, library::material("gold")?).with_size(32, 24);
    /// let mut session = Session::new(scene)?;
    /// let mut frame = Frame::default();
    /// for step in 0..3 {
    ///     session.set_camera(Camera::new([f64::from(step), 0.0, 5.0], [0.0; 3]));
    ///     session.frame_into(Aovs { depth: true, ..Aovs::default() }, &mut frame)?;
    ///     assert_eq!(frame.depth.len(), 32 * 24);
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`Session::update`]; what the frame then holds is of no use.
    pub fn frame_into(&mut self, aovs: Aovs, frame: &mut Frame) -> Result<(), ShotError> {
        self.update()?;
        self.shot.frame_into(aovs, frame)
    }

    /// Draws the picture into a file; see [`Shot::save`].
    ///
    /// # Errors
    /// As [`Session::update`], and if the file cannot be written.
    pub fn save(&mut self, path: impl AsRef<Path>) -> Result<(), SaveError> {
        self.update()?;
        self.shot.scene_hash = Some(self.scene.content_hash());
        self.shot.save(path)
    }
}
