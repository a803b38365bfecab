//! From a prepared scene to a picture.

use glanz_color::exr::{Band, SpectralImage};
use glanz_color::photometry::PHOTOPIC_LM_PER_W;
use glanz_color::{Spectrum, lambda_nm, rgb_spectra};
use glanz_picture::compare::frames::Developed;
use glanz_plot::Canvas;
use glanz_render::{
    Aovs, Develop, DrawOptions, Frame, Observation, PrepareOptions, Prepared, ToScreen, View, develop,
    develop16, draw, draw_observed, draw_rgba8, prepare,
};
use glanz_scene::{Background, Camera, ColorMode, Scene, Shading, White};

use super::args::{CameraArgs, DevelopArgs, LookArgs};
use super::frames::turned;
use super::load::Input;
use super::print::failure::Failure;
use super::print::timings::{Stage, Timings};
use super::progress::Progress;

/// What is kept of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// 8-bit codes.
    Codes8,
    /// 16-bit codes.
    Codes16,
    /// Linear light, with depth, normals and object numbers.
    Light,
    /// The spectrum of each pixel.
    Spectrum,
}

/// A drawn picture.
#[derive(Clone, Debug)]
pub enum Picture {
    /// 8-bit codes.
    Codes8(Canvas),
    /// 16-bit codes, straight RGBA.
    Codes16 {
        /// Width in pixels.
        width: usize,
        /// Height in pixels.
        height: usize,
        /// `4·width·height` codes, rows from the top.
        rgba: Vec<u16>,
    },
    /// Linear light.
    Light(Light),
    /// The spectrum of each pixel.
    Spectrum(SpectralImage),
}

/// Linear light, as a screen shows it and as the observer sees it.
#[derive(Clone, Debug)]
pub struct Light {
    /// Linear sRGB, with depth, normals and object numbers.
    pub screen: Frame,
    /// The observer's channels with their names; none in mode RGB.
    pub channels: Vec<(String, Vec<f32>)>,
}

/// How pictures of one prepared scene are made.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The camera.
    pub camera: Camera,
    /// Camera and size, as the rasteriser wants them.
    pub view: View,
    /// How to draw.
    pub options: DrawOptions,
    /// How to develop.
    pub develop: Develop,
    /// How the scene becomes arrays: colour mode and observer among it.
    pub prepare: PrepareOptions,
    /// The white of the screen.
    white: White,
    /// What is where nothing is, in linear sRGB.
    background: Background,
    /// From the observer's channels to the screen; none where they are the screen's.
    to_screen: Option<ToScreen>,
    /// The scene's lights and materials: all that the tint table depends on.
    colors: Scene,
}

impl Plan {
    /// How the pictures of `input` are made, in this size if not in the scene's own.
    pub fn new(
        input: &Input,
        size: Option<(u32, u32)>,
        look: &LookArgs,
        camera: &CameraArgs,
        develop: DevelopArgs,
    ) -> Result<Self, Failure> {
        let image = look.image(&input.scene, size);
        let camera = camera.resolve(input, (image.width, image.height))?;
        let mut options = look.draw_options(&image, input.show)?;
        let seen = look.color.resolve(&input.scene, options.show)?;
        let to_screen = match options.show.is_light() {
            true => seen.observation.to_screen(&input.scene, seen.white).map_err(Failure::new)?,
            false => None,
        };
        let background = options.background;
        if let (Background::Color(color), Some(to_screen)) = (options.background, &to_screen) {
            options.background = Background::Color(glanz_color::Rgb(to_screen.channels_of(color.0)));
        }
        let mut develop = develop.resolve(input)?;
        develop.to_screen = to_screen.as_ref().and_then(ToScreen::rows);
        let (lights, materials) = (input.scene.lights.clone(), input.scene.materials.clone());
        Ok(Self {
            view: View::new(&camera, image.width, image.height).map_err(Failure::new)?,
            camera,
            options,
            develop,
            prepare: look.prepare_options(seen.observation),
            white: seen.white,
            background,
            to_screen,
            colors: Scene { lights, materials, photometric: input.scene.photometric, ..Scene::default() },
        })
    }

    /// The scene as arrays, for this plan.
    pub fn prepare(&self, scene: &Scene) -> Result<Prepared, Failure> {
        Ok(prepare(scene, &self.prepare)?)
    }

    /// The scene as arrays, with another shading.
    pub fn prepare_shaded(&self, scene: &Scene, shading: Shading) -> Result<Prepared, Failure> {
        Ok(prepare(scene, &PrepareOptions { shading: Some(shading), ..self.prepare.clone() })?)
    }

    /// Colour mode, observer and adaptation, in words; nothing for plain RGB.
    pub fn facts(&self) -> Vec<(String, String)> {
        let observation = &self.prepare.observation;
        let Some(observer) = observation.observer() else { return Vec::new() };
        let adaptation = match self.white {
            White::None => "none".to_owned(),
            white => format!("white {} to D65 by Bradford", white.name()),
        };
        let facts = [
            ("Color-Mode", observation.mode().to_string()),
            ("Observer", observer.name.clone()),
            ("Adaptation", adaptation),
        ];
        facts.map(|(key, value)| (key.to_owned(), value)).to_vec()
    }

    /// The same from a camera turned around its target, by a part of a full turn.
    pub fn turned(&self, part: f64) -> Result<Self, Failure> {
        let camera = turned(&self.camera, part);
        let view = View::new(&camera, self.view.width, self.view.height).map_err(Failure::new)?;
        Ok(Self { view, camera, ..self.clone() })
    }

    /// Draws a picture.
    pub fn picture(
        &self,
        prepared: &Prepared,
        kind: Kind,
        timings: &mut Timings,
    ) -> Result<Picture, Failure> {
        let (width, height) = (self.view.width as usize, self.view.height as usize);
        Ok(match kind {
            Kind::Codes8 => Picture::Codes8(self.codes(prepared, timings)?),
            Kind::Codes16 => {
                let frame = timings.measure(Stage::Draw, || self.frame(prepared, Aovs::default()))?;
                let rgba = timings.measure(Stage::Develop, || {
                    let (frame, develop) = self.developable(frame);
                    develop16(&frame, &develop)
                });
                Picture::Codes16 { width, height, rgba }
            }
            Kind::Spectrum => {
                Picture::Spectrum(timings.measure(Stage::Draw, || self.spectral_image(prepared))?)
            }
            Kind::Light => {
                let layers = Aovs { depth: true, normal: true, object: true };
                let frame = timings.measure(Stage::Draw, || self.frame(prepared, layers))?;
                Picture::Light(self.light(frame))
            }
        })
    }

    /// Draws 8-bit codes. Development is part of the drawing where three channels are all there are.
    pub fn codes(&self, prepared: &Prepared, timings: &mut Timings) -> Result<Canvas, Failure> {
        let (width, height) = (self.view.width as usize, self.view.height as usize);
        if self.takes_several_frames() {
            let frame = timings.measure(Stage::Draw, || self.frame(prepared, Aovs::default()))?;
            let rgba = timings.measure(Stage::Develop, || {
                let (frame, settings) = self.developable(frame);
                develop(&frame, &settings)
            });
            return Ok(Canvas { width, height, rgba });
        }
        let mut rgba = vec![0; 4 * width * height];
        timings.measure(Stage::Draw, || {
            draw_rgba8(prepared, &self.view, &self.options, &self.develop, &mut rgba);
        });
        Ok(Canvas { width, height, rgba })
    }

    /// Draws linear light with object numbers, and develops it.
    pub fn developed(&self, prepared: &Prepared) -> Result<Developed, Failure> {
        let frame = self.frame(prepared, Aovs { object: true, ..Aovs::default() })?;
        let frame = self.on_linear_screen(frame);
        let codes = develop(&frame, &Develop { to_screen: None, ..self.develop });
        Ok(Developed { frame, codes })
    }

    /// All channels that the observer sees.
    pub fn frame(&self, prepared: &Prepared, aovs: Aovs) -> Result<Frame, Failure> {
        let options = DrawOptions { aovs, ..self.options };
        if !self.takes_several_frames() {
            return Ok(draw(prepared, &self.view, &options));
        }
        let mut progress = Progress::new(100, "per cent");
        let mut step = |done: f64| progress.set((100.0 * done) as usize);
        Ok(draw_observed(prepared, &self.colors, &self.prepare, &self.view, &options, &mut step)?)
    }

    /// The spectrum of each pixel, drawn three wavelengths at a time.
    fn spectral_image(&self, prepared: &Prepared) -> Result<SpectralImage, Failure> {
        let mode = self.prepare.observation.mode();
        if !matches!(mode, ColorMode::Spectral | ColorMode::Reference) || !self.options.show.is_light() {
            let message =
                format!("--spectral-exr needs spectra of light: add --mode spectral (the mode is {mode})");
            return Err(Failure::Usage(message));
        }
        let background = match self.options.background {
            Background::Environment => Background::Environment,
            _ => Background::Transparent,
        };
        let options = DrawOptions { background, ..self.options };
        let own = PrepareOptions { observation: Observation::spectrum(), ..self.prepare.clone() };
        let mut progress = Progress::new(100, "per cent");
        let mut step = |done: f64| progress.set((100.0 * done) as usize);
        let prepared_own = prepared.refilled(&self.colors, &own)?;
        let frame = draw_observed(&prepared_own, &self.colors, &own, &self.view, &options, &mut step)?;
        let unit = if self.colors.photometric { 1.0 / PHOTOPIC_LM_PER_W } else { 1.0 };
        let behind = match self.background {
            Background::Color(color) => rgb_spectra::spectrum_of_light(color),
            Background::Transparent | Background::Environment => Spectrum::ZERO,
        };
        let alpha = &frame.alpha;
        let band = |(i, mut values): (usize, Vec<f32>)| {
            let (behind, unit) = (behind[i] as f32, unit as f32);
            values.iter_mut().zip(alpha).for_each(|(v, a)| *v = (*v + behind * (1.0 - a)) * unit);
            Band { nm: lambda_nm(i), values }
        };
        let emissive = frame.rgb.into_iter().chain(frame.more).enumerate().map(band).collect();
        let preview = self.on_linear_screen(self.frame(prepared, Aovs::default())?);
        Ok(SpectralImage {
            width: frame.width,
            height: frame.height,
            emissive,
            rgb: Some(preview.rgb),
            emissive_units: if self.colors.photometric { "W.m^-2.sr^-1" } else { "relative" }.to_owned(),
            ..SpectralImage::default()
        })
    }

    fn takes_several_frames(&self) -> bool {
        let observation = &self.prepare.observation;
        observation.mode() == ColorMode::Reference || observation.channel_count() > 3
    }

    /// The frame in linear sRGB.
    fn on_linear_screen(&self, frame: Frame) -> Frame {
        match &self.to_screen {
            Some(to_screen) => frame.on_screen(to_screen),
            None => frame,
        }
    }

    /// A frame, and how it is developed, that give codes together.
    fn developable(&self, frame: Frame) -> (Frame, Develop) {
        match frame.more.is_empty() {
            true => (frame, self.develop),
            false => (self.on_linear_screen(frame), Develop { to_screen: None, ..self.develop }),
        }
    }

    /// The observer's channels beside what the screen shows of them.
    fn light(&self, frame: Frame) -> Light {
        let observation = &self.prepare.observation;
        let Some(observer) = observation.observer() else {
            return Light { screen: self.on_linear_screen(frame), channels: Vec::new() };
        };
        let names = observation.channel_names().into_iter().map(|name| format!("{}.{name}", observer.name));
        let planes = frame.rgb.iter().chain(&frame.more).cloned();
        let channels = names.zip(planes).collect();
        Light { screen: self.on_linear_screen(frame), channels }
    }

    /// The picture as a screen shows it.
    pub fn on_screen(&self, picture: &Picture) -> Canvas {
        match picture {
            Picture::Codes8(canvas) => canvas.clone(),
            Picture::Codes16 { width, height, rgba } => {
                let rgba = rgba.iter().map(|code| (code >> 8) as u8).collect();
                Canvas { width: *width, height: *height, rgba }
            }
            Picture::Spectrum(image) => {
                let SpectralImage { width, height, .. } = *image;
                let rgb = image.rgb.clone().unwrap_or_default();
                let frame =
                    Frame { width, height, rgb, alpha: vec![1.0; width * height], ..Frame::default() };
                let rgba = develop(&frame, &Develop { to_screen: None, ..self.develop });
                Canvas { width, height, rgba }
            }
            Picture::Light(Light { screen, .. }) => {
                let rgba = develop(screen, &Develop { to_screen: None, ..self.develop });
                Canvas { width: screen.width, height: screen.height, rgba }
            }
        }
    }
}
