//! From a prepared scene to a picture.

use glanz_color::exr::SpectralImage;
use glanz_math::SimdLevel;
use glanz_picture::compare::frames::Developed;
use glanz_picture::{Develop, Frame, develop};
use glanz_plot::Canvas;
use glanz_render::{Aovs, Shot, ShotError, ShotOptions, View, takes_several_frames};
use glanz_scene::{Camera, Scene, Shading, White};

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

/// How pictures of one scene are made, as the command line has it.
#[derive(Clone, Debug)]
pub struct Plan {
    /// What the picture is made with.
    pub options: ShotOptions,
    /// The SIMD instructions that `GLANZ_SIMD` names.
    level: SimdLevel,
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
        let draw = look.draw_options(&image, input.scene.render.show);
        let seen = look.color.resolve(&input.scene, draw.show)?;
        let develop = develop.resolve(&input.scene.render)?;
        let options = ShotOptions {
            prepare: look.prepare_options(seen.observation),
            draw,
            ev: develop.ev,
            tone_map: develop.tone_map,
            dither: develop.dither,
            white: seen.white,
            size: (image.width, image.height),
            camera,
        };
        // What cannot be seen is told before anything is prepared.
        if options.draw.show.is_light() {
            let observation = &options.prepare.observation;
            observation.to_screen(&input.scene, options.white).map_err(Failure::new)?;
        }
        View::new(&options.camera, image.width, image.height).map_err(Failure::new)?;
        Ok(Self { options, level: simd_level()? })
    }

    /// The scene, prepared to be drawn.
    pub fn shot(&self, scene: &Scene) -> Result<Shot, Failure> {
        Ok(Shot::with(scene, self.options.clone())?.on_level(self.level))
    }

    /// The same with another shading.
    pub fn shot_shaded(&self, scene: &Scene, shading: Shading) -> Result<Shot, Failure> {
        let mut options = self.options.clone();
        options.prepare.shading = Some(shading);
        Ok(Shot::with(scene, options)?.on_level(self.level))
    }

    /// Colour mode, observer and adaptation, in words; nothing for plain RGB.
    pub fn facts(&self) -> Vec<(String, String)> {
        let observation = &self.options.prepare.observation;
        let Some(observer) = observation.observer() else { return Vec::new() };
        let adaptation = match self.options.white {
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

    /// Width and height of the pictures.
    pub fn size(&self) -> (usize, usize) {
        (self.options.size.0 as usize, self.options.size.1 as usize)
    }
}

/// The SIMD instructions that `GLANZ_SIMD` names, the machine's best by default.
fn simd_level() -> Result<SimdLevel, Failure> {
    match std::env::var("GLANZ_SIMD").ok().filter(|name| !name.is_empty()) {
        None => Ok(SimdLevel::best()),
        Some(name) => SimdLevel::named(&name).map_err(|error| Failure::Usage(format!("GLANZ_SIMD: {error}"))),
    }
}

/// Points a shot's camera after a part of a full turn around its target.
pub fn turn(shot: &mut Shot, camera: &Camera, part: f64) -> Result<(), Failure> {
    Ok(shot.set_camera(turned(camera, part))?)
}

/// Draws a picture.
pub fn picture(
    shot: &mut Shot,
    kind: Kind,
    timings: &mut Timings,
    progress: &mut Progress,
) -> Result<Picture, Failure> {
    let (width, height) = (shot.view().width as usize, shot.view().height as usize);
    Ok(match kind {
        Kind::Codes8 => Picture::Codes8(codes(shot, timings, progress)?),
        Kind::Codes16 => {
            let frame = timings.measure(Stage::Draw, || frame(shot, Aovs::default(), progress))?;
            let rgba = timings.measure(Stage::Develop, || shot.codes16(frame))?;
            Picture::Codes16 { width, height, rgba }
        }
        Kind::Spectrum => {
            let image =
                timings.measure(Stage::Draw, || shot.spectral_image(&mut |part| progress.within(part)));
            Picture::Spectrum(image.map_err(without_spectra)?)
        }
        Kind::Light => {
            let aovs = Aovs { depth: true, normal: true, object: true };
            let frame = timings.measure(Stage::Draw, || frame(shot, aovs, progress))?;
            Picture::Light(light(shot, frame)?)
        }
    })
}

fn without_spectra(error: ShotError) -> Failure {
    match error {
        ShotError::NoSpectra { mode } => Failure::Usage(format!(
            "--spectral-exr needs spectra of light: add --mode spectral (the mode is {mode})"
        )),
        other => other.into(),
    }
}

/// Draws 8-bit codes.
pub fn codes(shot: &mut Shot, timings: &mut Timings, progress: &mut Progress) -> Result<Canvas, Failure> {
    let (width, height) = (shot.view().width as usize, shot.view().height as usize);
    if takes_several_frames(shot.prepared()) {
        let frame = timings.measure(Stage::Draw, || frame(shot, Aovs::default(), progress))?;
        let rgba = timings.measure(Stage::Develop, || shot.codes8(frame))?;
        return Ok(Canvas { width, height, rgba });
    }
    let mut rgba = vec![0; 4 * width * height];
    timings.measure(Stage::Draw, || shot.draw_into(&mut rgba))?;
    Ok(Canvas { width, height, rgba })
}

/// Draws linear light with object numbers, and develops it.
pub fn developed(shot: &mut Shot, progress: &mut Progress) -> Result<Developed, Failure> {
    let frame = frame(shot, Aovs { object: true, ..Aovs::default() }, progress)?;
    let frame = shot.on_screen(frame)?;
    let codes = codes_of(shot, &frame)?;
    Ok(Developed { frame, codes })
}

/// All channels that the observer sees.
fn frame(shot: &mut Shot, aovs: Aovs, progress: &mut Progress) -> Result<Frame, Failure> {
    Ok(shot.frame_in_steps(aovs, &mut |part| progress.within(part))?)
}

/// A frame that is on the screen already, developed.
fn codes_of(shot: &Shot, screen: &Frame) -> Result<Vec<u8>, Failure> {
    let settings = Develop { to_screen: None, ..*shot.develop_settings() };
    Ok(develop(screen, &settings).map_err(ShotError::from)?)
}

/// The observer's channels beside what the screen shows of them.
fn light(shot: &Shot, frame: Frame) -> Result<Light, Failure> {
    let Some(observer) = frame.channels.observer.clone() else {
        return Ok(Light { screen: shot.on_screen(frame)?, channels: Vec::new() });
    };
    let names = frame.channels.names.iter().map(|name| format!("{observer}.{name}"));
    let channels = names.zip(frame.rgb.iter().chain(&frame.more).cloned()).collect();
    Ok(Light { screen: shot.on_screen(frame)?, channels })
}

/// The picture as a screen shows it.
pub fn on_screen(shot: &Shot, picture: &Picture) -> Result<Canvas, Failure> {
    Ok(match picture {
        Picture::Codes8(canvas) => canvas.clone(),
        Picture::Codes16 { width, height, rgba } => {
            let rgba = rgba.iter().map(|code| (code >> 8) as u8).collect();
            Canvas { width: *width, height: *height, rgba }
        }
        Picture::Spectrum(image) => {
            let SpectralImage { width, height, .. } = *image;
            let rgb = image.rgb.clone().unwrap_or_default();
            let frame = Frame { width, height, rgb, alpha: vec![1.0; width * height], ..Frame::default() };
            Canvas { width, height, rgba: codes_of(shot, &frame)? }
        }
        Picture::Light(Light { screen, .. }) => {
            Canvas { width: screen.width, height: screen.height, rgba: codes_of(shot, screen)? }
        }
    })
}
