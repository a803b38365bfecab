//! One picture: a scene, prepared, with its camera, its observer and its development.

use std::sync::Arc;

use glanz_eye::{Seen, Viewer};
use glanz_math::{MemoryBudget, SimdLevel};
use glanz_picture::output::PictureKind;
use glanz_picture::{Develop, Frame, develop, develop16};
use glanz_scene::{Camera, Mistake, NoEffect, Scene, White};

use super::{ShotError, ShotOptions, Sight, angles, mistaken};
use crate::cpu::Renderer;
use crate::prepare::{Change, Prepared, memory_beside, prepare};
use crate::view::{Aovs, DrawOptions, Moment, View};
use crate::{Backend, DrawMeter, draw_observed, draw_observed_into, takes_several_frames};

/// A picture of a scene: honours all that the scene says.
///
/// ```
/// use glanz_render::Shot;
/// use glanz_scene::{Light, Mesh, Scene, library};
///
/// let scene = Scene::new()
///     .with_mesh(Mesh::builtin("sphere")?, library::material("gold")?)
///     .with_light(Light::point([1.0, 2.0, 3.0], [1.0; 3]))
///     .with_size(32, 24);
/// let rgba = Shot::new(&scene)?.rgba8()?;
/// assert_eq!(rgba.len(), 4 * 32 * 24);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Shot {
    pub(crate) backend: Box<dyn Backend>,
    pub(crate) prepared: Prepared,
    pub(crate) sight: Sight,
    /// The hash of the scene, unless it changed. Looking from elsewhere does not change it.
    pub(crate) scene_hash: Option<u64>,
    /// The mistake that is drawn, if any.
    pub(crate) mistake: Option<Mistake>,
    /// A frame whose memory is used again, where drawing goes through one.
    pub(crate) scratch: Frame,
    /// What the eye made of the frame that was drawn last.
    pub(crate) seen: Option<Seen>,
    /// What is unusual about its making, as files tell it.
    pub(crate) makings: Vec<(String, String)>,
    /// Whether the mistake changes anything.
    pub(crate) effect: Result<(), NoEffect>,
    /// The budget of which the scene is taken.
    pub(crate) memory: MemoryBudget,
}

/// Tells how much of the work is done, from 0 to 1.
pub type Step<'a> = &'a mut dyn FnMut(f64);

impl Shot {
    /// The picture that the scene asks for.
    ///
    /// # Errors
    /// Where the scene cannot be drawn.
    pub fn new(scene: &Scene) -> Result<Self, ShotError> {
        let shot = Self::with(scene, ShotOptions::of(scene)?)?;
        Ok(Self { scene_hash: Some(scene.content_hash()), ..shot })
    }

    /// The picture with settings in place of the scene's. Its file tells no hash of the scene.
    ///
    /// # Errors
    /// Where the scene cannot be drawn so.
    pub fn with(scene: &Scene, options: ShotOptions) -> Result<Self, ShotError> {
        let (scene, options, effect) = mistaken(scene, &options);
        Ok(Self {
            backend: crate::default_backend(),
            sight: Sight::of(&scene, &options)?,
            prepared: prepare(&scene, &options.prepare)?,
            memory: memory_beside(&scene, &options.prepare)?,
            scene_hash: None,
            scratch: Frame::default(),
            seen: None,
            mistake: options.mistake,
            makings: options.makings(),
            effect,
        })
    }

    /// The same, drawn by another back end.
    #[must_use]
    pub fn on(self, backend: Box<dyn Backend>) -> Self {
        Self { backend, ..self }
    }

    /// The same, drawn by the CPU on chosen SIMD instructions.
    #[must_use]
    pub fn on_level(self, level: SimdLevel) -> Self {
        self.on(Box::new(Renderer::with_level(level)))
    }

    /// How much of a picture is drawn, for another thread while this one draws; nothing where the back end does not know.
    pub fn meter(&self) -> Option<Arc<DrawMeter>> {
        self.backend.meter()
    }

    /// The scene as arrays.
    pub fn prepared(&self) -> &Prepared {
        &self.prepared
    }

    /// Camera and size, as back ends want them.
    pub fn view(&self) -> &View {
        &self.sight.view
    }

    /// How many pixels a degree of sight has in the middle of the picture: by the camera if it is perspective, else those of a screen.
    pub fn px_per_deg(&self) -> f64 {
        angles(&self.sight.camera, &self.sight.view, &Viewer::default()).px_per_deg
    }

    /// How it is drawn.
    pub fn draw_options(&self) -> &DrawOptions {
        &self.sight.draw
    }

    /// The camera.
    pub fn camera(&self) -> &Camera {
        &self.sight.camera
    }

    /// The white that becomes the screen's.
    pub fn white(&self) -> White {
        self.sight.white
    }

    /// How frames become codes.
    pub fn develop_settings(&self) -> &Develop {
        &self.sight.develop
    }

    /// Looks from elsewhere; nothing is prepared anew.
    ///
    /// # Errors
    /// If the camera is unusable.
    pub fn set_camera(&mut self, camera: Camera) -> Result<(), ShotError> {
        let View { width, height, .. } = self.sight.view;
        self.sight.turn(camera, View::new(&camera, width, height)?);
        Ok(())
    }

    /// Another time, or another place of the pointer, for programs; nothing is prepared anew.
    pub fn set_moment(&mut self, moment: Moment) {
        self.sight.draw.moment = moment;
    }

    /// Takes over what changed of the scene, and redoes nothing else.
    ///
    /// # Errors
    /// As [`Prepared::update`].
    pub fn update(&mut self, scene: &Scene, changes: &[Change]) -> Result<(), ShotError> {
        self.scene_hash = None;
        match self.mistake {
            Some(mistake) => {
                let (wrong, effect) = mistake.apply(scene);
                self.prepared.update(&wrong, &[Change::All])?;
                self.effect = effect;
            }
            None => self.prepared.update(scene, changes)?,
        }
        if self.sight.draw.show.is_light() {
            let to_screen = self.prepared.to_screen(self.sight.white)?;
            self.sight.adapt(to_screen);
            if let Some(seeing) = self.sight.seeing.take() {
                let light = (self.prepared.colors().0, self.prepared.is_photometric());
                let observation = self.prepared.observation();
                let anew = observation.seeing(&seeing.viewer, light, self.sight.white, seeing.angles)?;
                self.sight.seeing = Some(anew);
            }
        }
        Ok(())
    }

    /// The observer's channels in linear light, over the background.
    ///
    /// # Errors
    /// If the table cannot be filled for further channels.
    pub fn frame(&mut self) -> Result<Frame, ShotError> {
        self.frame_in_steps(Aovs::default(), &mut |_| ())
    }

    /// The same with depth, normals or object numbers; `step` is told how far it is.
    ///
    /// # Errors
    /// As [`Shot::frame`].
    pub fn frame_in_steps(&mut self, aovs: Aovs, step: Step) -> Result<Frame, ShotError> {
        self.check_memory(PictureKind::Codes16)?;
        let options = DrawOptions { aovs, ..self.sight.draw };
        let mut frame = draw_observed(&mut *self.backend, &self.prepared, &self.sight.view, &options, step)?;
        self.see(&mut frame);
        self.whole(frame)
    }

    /// Takes a frame through the stages of the eye, if there are any.
    fn see(&mut self, frame: &mut Frame) {
        self.seen = self.sight.seeing.as_ref().map(|seeing| seeing.see(frame));
    }

    /// What the eye made of the frame that was drawn last: what it is adapted to, the part of its cones; none where the frame is shown
    /// as it is drawn.
    pub fn seen(&self) -> Option<&Seen> {
        self.seen.as_ref()
    }

    /// The same into a frame that was drawn before, whose memory is used again; all that it held is replaced.
    ///
    /// # Errors
    /// As [`Shot::frame`]; what the frame then holds is of no use.
    pub fn frame_into(&mut self, aovs: Aovs, frame: &mut Frame) -> Result<(), ShotError> {
        let options = DrawOptions { aovs, ..self.sight.draw };
        let (backend, prepared) = (&mut *self.backend, &self.prepared);
        draw_observed_into(backend, prepared, &self.sight.view, &options, frame, &mut |_| ())?;
        self.see(frame);
        self.whole(())
    }

    /// What was drawn, if the programs of the scene came to their end.
    fn whole<T>(&mut self, drawn: T) -> Result<T, ShotError> {
        match self.backend.take_error() {
            None => Ok(drawn),
            Some(error) => Err(error.into()),
        }
    }

    /// The picture as 8-bit sRGB, 4 bytes per pixel by rows from the top.
    ///
    /// # Errors
    /// As [`Shot::frame`].
    pub fn rgba8(&mut self) -> Result<Vec<u8>, ShotError> {
        self.rgba8_in_steps(&mut |_| ())
    }

    pub(crate) fn rgba8_in_steps(&mut self, step: Step) -> Result<Vec<u8>, ShotError> {
        self.check_memory(PictureKind::Codes8)?;
        let mut rgba = vec![0; 4 * self.sight.view.width as usize * self.sight.view.height as usize];
        self.draw_into_in_steps(&mut rgba, step)?;
        Ok(rgba)
    }

    /// The same into a buffer of `4·width·height` bytes. Development is part of the drawing where three channels are
    /// all there are.
    ///
    /// # Errors
    /// As [`Shot::frame`], and [`ShotError::Length`] if the buffer has another length.
    pub fn draw_into(&mut self, rgba: &mut [u8]) -> Result<(), ShotError> {
        self.draw_into_in_steps(rgba, &mut |_| ())
    }

    pub(crate) fn draw_into_in_steps(&mut self, rgba: &mut [u8], step: Step) -> Result<(), ShotError> {
        self.check_length(rgba.len())?;
        if takes_several_frames(&self.prepared) || self.sight.seeing.is_some() {
            let mut frame = core::mem::take(&mut self.scratch);
            let (backend, prepared) = (&mut *self.backend, &self.prepared);
            draw_observed_into(backend, prepared, &self.sight.view, &self.sight.draw, &mut frame, step)?;
            self.see(&mut frame);
            self.whole(())?;
            rgba.copy_from_slice(&self.codes8_of(&mut frame)?);
            self.scratch = frame;
            return Ok(());
        }
        let Sight { view, draw, develop, .. } = &self.sight;
        self.backend.draw_rgba8(&self.prepared, view, draw, develop, rgba)?;
        self.whole(())
    }

    fn check_length(&self, found: usize) -> Result<(), ShotError> {
        let View { width, height, .. } = self.sight.view;
        let expected = 4 * width as usize * height as usize;
        match found == expected {
            true => Ok(()),
            false => Err(ShotError::Length { width, height, expected, found }),
        }
    }

    /// The frame as 8-bit sRGB.
    ///
    /// # Errors
    /// If it is not a frame of this observer.
    pub fn codes8(&self, frame: Frame) -> Result<Vec<u8>, ShotError> {
        let (frame, settings) = self.developable(frame)?;
        Ok(develop(&frame, &settings)?)
    }

    /// The same of a frame whose memory is to be used again, which it is for three channels.
    fn codes8_of(&self, frame: &mut Frame) -> Result<Vec<u8>, ShotError> {
        if frame.more.is_empty() {
            return Ok(develop(frame, &self.sight.develop)?);
        }
        self.codes8(core::mem::take(frame))
    }

    /// The frame as 16-bit sRGB.
    ///
    /// # Errors
    /// If it is not a frame of this observer.
    pub fn codes16(&self, frame: Frame) -> Result<Vec<u16>, ShotError> {
        let (frame, settings) = self.developable(frame)?;
        Ok(develop16(&frame, &settings)?)
    }

    /// The frame in linear sRGB.
    ///
    /// # Errors
    /// If it is not a frame of this observer.
    pub fn on_screen(&self, frame: Frame) -> Result<Frame, ShotError> {
        Ok(match &self.sight.to_screen {
            Some(to_screen) => frame.on_screen(to_screen)?,
            None => frame,
        })
    }

    /// A frame, and how it is developed, that give codes together: one of more than three channels is brought to the
    /// screen first.
    fn developable(&self, frame: Frame) -> Result<(Frame, Develop), ShotError> {
        match frame.more.is_empty() {
            true => Ok((frame, self.sight.develop)),
            false => Ok((self.on_screen(frame)?, Develop { to_screen: None, ..self.sight.develop })),
        }
    }
}
