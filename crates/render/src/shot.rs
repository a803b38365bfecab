//! One picture: a scene, prepared, with its camera, its observer and its development.

use glanz_color::exr::{Band, SpectralImage};
use glanz_color::photometry::PHOTOPIC_LM_PER_W;
use glanz_color::{Rgb, Spectrum, lambda_nm, rgb_spectra};
use glanz_math::SimdLevel;
use glanz_picture::{ChannelError, Develop, Frame, ToScreen, ToneMap, develop, develop16};
use glanz_scene::{Background, Camera, ColorMode, Scene, White};
use thiserror::Error;

use crate::cpu::Renderer;
use crate::prepare::{
    Change, Observation, ObservationError, PrepareError, PrepareOptions, Prepared, prepare,
};
use crate::view::{Aovs, DrawOptions, View, ViewError};
use crate::{Backend, draw_observed, takes_several_frames};

/// Why no picture can be made of a scene.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ShotError {
    /// The scene cannot be prepared.
    #[error(transparent)]
    Prepare(#[from] PrepareError),
    /// The observer, the colour mode and the white do not fit together.
    #[error(transparent)]
    Observation(#[from] ObservationError),
    /// The camera or the size of the picture is unusable.
    #[error(transparent)]
    View(#[from] ViewError),
    /// A frame is not what its development is for.
    #[error(transparent)]
    Channels(#[from] ChannelError),
    /// Spectra were asked for where there are none.
    #[error(
        "a spectrum for each pixel needs spectra of light, but the colour mode is '{mode}'; choose 'spectral'"
    )]
    NoSpectra {
        /// The mode.
        mode: ColorMode,
    },
}

/// What a picture is made with beside the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct ShotOptions {
    /// How the scene becomes arrays: colour mode and observer among it.
    pub prepare: PrepareOptions,
    /// How it is drawn. A background colour is given in linear sRGB.
    pub draw: DrawOptions,
    /// Exposure in stops.
    pub ev: f32,
    /// Tone mapping.
    pub tone_map: ToneMap,
    /// Ordered dithering of 8-bit codes.
    pub dither: bool,
    /// The white that becomes the screen's.
    pub white: White,
    /// Width and height in pixels.
    pub size: (u32, u32),
    /// The camera.
    pub camera: Camera,
}

impl ShotOptions {
    /// What the scene itself asks for.
    ///
    /// # Errors
    /// If the scene's observer does not fit its colour mode.
    pub fn of(scene: &Scene) -> Result<Self, ObservationError> {
        let image = &scene.image;
        Ok(Self {
            prepare: PrepareOptions {
                observation: Observation::new(scene.render.mode, scene.observer.clone())?,
                ..PrepareOptions::default()
            },
            draw: DrawOptions {
                samples: image.samples,
                supersample: image.supersample,
                show: scene.render.show,
                ..DrawOptions::new(image.background)
            },
            ev: scene.render.ev as f32,
            tone_map: scene.render.tone_map,
            dither: false,
            white: scene.render.white,
            size: (image.width, image.height),
            camera: scene.camera_or_framing(f64::from(image.width) / f64::from(image.height)),
        })
    }
}

/// A picture of a scene: honours all that the scene says.
///
/// ```
/// use glanz_render::Shot;
///
/// let text = "[image]\nwidth = 32\nheight = 24\n[[lights]]\nkind = \"point\"\nposition = [1, 2, 3]\n\
///             [[objects]]\nmesh = \"sphere\"\n";
/// let scene = glanz_scene::file::parse_str(text, "".as_ref(), &Default::default())?.scene;
/// let rgba = Shot::new(&scene)?.rgba8()?;
/// assert_eq!(rgba.len(), 4 * 32 * 24);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Shot {
    backend: Box<dyn Backend>,
    prepared: Prepared,
    view: View,
    draw: DrawOptions,
    develop: Develop,
    camera: Camera,
    white: White,
    /// Behind all surfaces, in linear sRGB.
    background: Background,
    /// From the observer's channels to the screen; none where they are the screen's.
    to_screen: Option<ToScreen>,
}

/// Tells how much of the work is done, from 0 to 1.
pub type Step<'a> = &'a mut dyn FnMut(f64);

/// The part of the work that drawing all wavelengths is, beside three channels to look at.
const SPECTRUM_PART: f64 = 33.0 / 34.0;

impl Shot {
    /// The picture that the scene asks for.
    ///
    /// # Errors
    /// Where the scene cannot be drawn.
    pub fn new(scene: &Scene) -> Result<Self, ShotError> {
        Self::with(scene, ShotOptions::of(scene)?)
    }

    /// The picture with settings in place of the scene's.
    ///
    /// # Errors
    /// Where the scene cannot be drawn so.
    pub fn with(scene: &Scene, options: ShotOptions) -> Result<Self, ShotError> {
        let ShotOptions { prepare: prepare_options, mut draw, ev, tone_map, dither, white, size, camera } =
            options;
        let view = View::new(&camera, size.0, size.1)?;
        let to_screen = match draw.show.is_light() {
            true => prepare_options.observation.to_screen(scene, white)?,
            false => None,
        };
        let background = draw.background;
        if let (Background::Color(color), Some(to_screen)) = (background, &to_screen) {
            draw.background = Background::Color(Rgb(to_screen.channels_of(color.0)));
        }
        let to_screen_matrix = to_screen.as_ref().and_then(ToScreen::matrix);
        Ok(Self {
            backend: crate::default_backend(),
            prepared: prepare(scene, &prepare_options)?,
            view,
            draw,
            develop: Develop { ev, tone_map, dither, to_screen: to_screen_matrix },
            camera,
            white,
            background,
            to_screen,
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

    /// The scene as arrays.
    pub fn prepared(&self) -> &Prepared {
        &self.prepared
    }

    /// Camera and size, as back ends want them.
    pub fn view(&self) -> &View {
        &self.view
    }

    /// The camera.
    pub fn camera(&self) -> &Camera {
        &self.camera
    }

    /// The white that becomes the screen's.
    pub fn white(&self) -> White {
        self.white
    }

    /// How frames become codes.
    pub fn develop_settings(&self) -> &Develop {
        &self.develop
    }

    /// Looks from elsewhere; nothing is prepared anew.
    ///
    /// # Errors
    /// If the camera is unusable.
    pub fn set_camera(&mut self, camera: Camera) -> Result<(), ShotError> {
        self.view = View::new(&camera, self.view.width, self.view.height)?;
        self.camera = camera;
        Ok(())
    }

    /// Takes over what changed of the scene, and redoes nothing else.
    ///
    /// # Errors
    /// As [`Prepared::update`].
    pub fn update(&mut self, scene: &Scene, changes: &[Change]) -> Result<(), ShotError> {
        self.prepared.update(scene, changes)?;
        if self.draw.show.is_light() {
            self.to_screen = self.prepared.to_screen(self.white)?;
            self.develop.to_screen = self.to_screen.as_ref().and_then(ToScreen::matrix);
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
        let options = DrawOptions { aovs, ..self.draw };
        Ok(draw_observed(&mut *self.backend, &self.prepared, &self.view, &options, step)?)
    }

    /// The picture as 8-bit sRGB, 4 bytes per pixel by rows from the top.
    ///
    /// # Errors
    /// As [`Shot::frame`].
    pub fn rgba8(&mut self) -> Result<Vec<u8>, ShotError> {
        let mut rgba = vec![0; 4 * self.view.width as usize * self.view.height as usize];
        self.draw_into(&mut rgba)?;
        Ok(rgba)
    }

    /// The same into a buffer of `4·width·height` bytes. Development is part of the drawing where three channels are
    /// all there are.
    ///
    /// # Errors
    /// As [`Shot::frame`].
    ///
    /// # Panics
    /// If the buffer has another length.
    pub fn draw_into(&mut self, rgba: &mut [u8]) -> Result<(), ShotError> {
        if takes_several_frames(&self.prepared) {
            let frame = self.frame()?;
            rgba.copy_from_slice(&self.codes8(frame)?);
            return Ok(());
        }
        self.backend.draw_rgba8(&self.prepared, &self.view, &self.draw, &self.develop, rgba)?;
        Ok(())
    }

    /// The frame as 8-bit sRGB.
    ///
    /// # Errors
    /// If it is not a frame of this observer.
    pub fn codes8(&self, frame: Frame) -> Result<Vec<u8>, ShotError> {
        let (frame, settings) = self.developable(frame)?;
        Ok(develop(&frame, &settings)?)
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
        Ok(match &self.to_screen {
            Some(to_screen) => frame.on_screen(to_screen)?,
            None => frame,
        })
    }

    /// A frame, and how it is developed, that give codes together: one of more than three channels is brought to the
    /// screen first.
    fn developable(&self, frame: Frame) -> Result<(Frame, Develop), ShotError> {
        match frame.more.is_empty() {
            true => Ok((frame, self.develop)),
            false => Ok((self.on_screen(frame)?, Develop { to_screen: None, ..self.develop })),
        }
    }

    /// The spectrum of each pixel, drawn three wavelengths at a time, with a picture to look at.
    ///
    /// # Errors
    /// If the colour mode has no spectra, or the picture does not show light.
    pub fn spectral_image(&mut self, step: Step) -> Result<SpectralImage, ShotError> {
        let mode = self.prepared.observation().mode();
        if !matches!(mode, ColorMode::Spectral | ColorMode::Reference) || !self.draw.show.is_light() {
            return Err(ShotError::NoSpectra { mode });
        }
        // The reference draws all wavelengths for the preview too.
        let part = if mode == ColorMode::Reference { 0.5 } else { SPECTRUM_PART };
        let spectra = self.spectral_frame(&mut |done| step(part * done))?;
        let preview = self.frame_in_steps(Aovs::default(), &mut |done| step(part + (1.0 - part) * done))?;
        let (width, height) = (spectra.width, spectra.height);
        let unit = if self.prepared.is_photometric() { "W.m^-2.sr^-1" } else { "relative" };
        Ok(SpectralImage {
            width,
            height,
            emissive: self.bands(spectra),
            rgb: Some(self.on_screen(preview)?.rgb),
            emissive_units: unit.to_owned(),
            ..SpectralImage::default()
        })
    }

    /// A channel for each wavelength, over nothing.
    fn spectral_frame(&mut self, step: Step) -> Result<Frame, ShotError> {
        let background = match self.draw.background {
            Background::Environment => Background::Environment,
            _ => Background::Transparent,
        };
        let options = DrawOptions { background, ..self.draw };
        let prepared = self.prepared.observed_by(Observation::spectrum())?;
        Ok(draw_observed(&mut *self.backend, &prepared, &self.view, &options, step)?)
    }

    /// The wavelengths of a frame over the background, in the unit of the file.
    fn bands(&self, frame: Frame) -> Vec<Band> {
        let unit = if self.prepared.is_photometric() { 1.0 / PHOTOPIC_LM_PER_W } else { 1.0 } as f32;
        let behind = match self.background {
            Background::Color(color) => rgb_spectra::spectrum_of_light(color),
            Background::Transparent | Background::Environment => Spectrum::ZERO,
        };
        let alpha = &frame.alpha;
        let band = |(i, mut values): (usize, Vec<f32>)| {
            let behind = behind[i] as f32;
            values.iter_mut().zip(alpha).for_each(|(v, a)| *v = (*v + behind * (1.0 - a)) * unit);
            Band { nm: lambda_nm(i), values }
        };
        frame.rgb.into_iter().chain(frame.more).enumerate().map(band).collect()
    }
}
