//! From a prepared scene to a picture.

use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{self, Thread};
use std::time::Duration;

use glanz_color::exr::SpectralImage;
use glanz_math::SimdLevel;
use glanz_picture::compare::frames::Developed;
use glanz_picture::output::{PictureData, PictureKind};
use glanz_picture::{Develop, Frame, develop};
use glanz_plot::Canvas;
use glanz_render::{
    Aovs, Moment, PrepareOptions, Shot, ShotError, ShotOptions, Step, View, takes_several_frames,
};
use glanz_scene::{Camera, Scene, Shading};

use super::args::{CameraArgs, DevelopArgs, LookArgs};
use super::frames::turned;
use super::load::Input;
use super::print::failure::Failure;
use super::print::timings::{Stage, Timings};
use super::progress::Progress;

/// How pictures of one scene are made, as the command line has it.
#[derive(Clone, Debug)]
pub(crate) struct Plan {
    /// What the picture is made with.
    pub options: ShotOptions,
    /// The SIMD instructions that `GLANZ_SIMD` names.
    level: SimdLevel,
    /// What programs are told.
    moment: Moment,
}

impl Plan {
    /// How the pictures of `input` are made, in this size if not in the scene's own.
    pub(crate) fn new(
        input: &Input,
        size: Option<(u32, u32)>,
        look: &LookArgs,
        camera: &CameraArgs,
        develop: DevelopArgs,
    ) -> Result<Self, Failure> {
        let image = look.image(&input.scene, size);
        let camera = camera.resolve(input, (image.width, image.height))?;
        let draw = look.draw_options(&image, &input.scene.render)?;
        let seen = look.color.resolve(&input.scene, draw.show)?;
        if draw.show.is_light() {
            look.color.check_white(&seen.observation)?;
        }
        let develop = develop.resolve(&input.scene.render)?;
        let options = ShotOptions {
            prepare: PrepareOptions { memory: input.memory, ..look.prepare_options(seen.observation) },
            draw,
            ev: develop.ev,
            tone_map: develop.tone_map,
            encoding: develop.encoding,
            dither: develop.dither,
            white: seen.white,
            size: (image.width, image.height),
            camera,
            viewer: seen.viewer,
            mistake: look.mistake.or(input.scene.render.mistake),
        };
        // What cannot be seen is told before anything is prepared.
        if options.draw.show.is_light() {
            let observation = &options.prepare.observation;
            observation.to_screen(&input.scene, options.white).map_err(ShotError::from)?;
        }
        View::new(&options.camera, image.width, image.height).map_err(ShotError::from)?;
        Ok(Self { options, level: simd_level()?, moment: Moment::default() })
    }

    /// The same with what programs are told.
    pub(crate) fn at(self, moment: Moment) -> Self {
        Self { moment, ..self }
    }

    /// The scene, prepared to be drawn.
    pub(crate) fn shot(&self, scene: &Scene) -> Result<Shot, Failure> {
        self.shot_of(scene, self.options.clone())
    }

    /// The same with another shading.
    pub(crate) fn shot_shaded(&self, scene: &Scene, shading: Shading) -> Result<Shot, Failure> {
        let mut options = self.options.clone();
        options.prepare.shading = Some(shading);
        self.shot_of(scene, options)
    }

    fn shot_of(&self, scene: &Scene, options: ShotOptions) -> Result<Shot, Failure> {
        let mut shot = Shot::with(scene, options)?.on_level(self.level);
        shot.set_moment(self.moment);
        Ok(shot)
    }

    /// Width and height of the pictures.
    pub(crate) fn size(&self) -> (usize, usize) {
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
pub(crate) fn turn(shot: &mut Shot, camera: &Camera, part: f64) -> Result<(), Failure> {
    Ok(shot.set_camera(turned(camera, part))?)
}

/// Draws a picture.
pub(crate) fn picture(
    shot: &mut Shot,
    kind: PictureKind,
    timings: &mut Timings,
    progress: &mut Progress,
) -> Result<PictureData, Failure> {
    shot.check_memory(kind)?;
    let (width, height) = (shot.view().width as usize, shot.view().height as usize);
    match kind {
        PictureKind::Codes8 => Ok(codes(shot, timings, progress)?.into()),
        PictureKind::Codes16 => {
            let frame = timings.measure(Stage::Draw, || frame(shot, Aovs::default(), progress))?;
            let rgba = timings.measure(Stage::Develop, || shot.codes16(frame))?;
            Ok(PictureData::Codes16 { width, height, rgba })
        }
        PictureKind::Light | PictureKind::Spectrum => {
            let picture = timings
                .measure(Stage::Draw, || watched(shot, progress, |shot, step| shot.picture(kind, step)));
            picture.map_err(without_spectra)
        }
    }
}

/// How often it is asked how much of a frame is drawn.
const INTERVAL: Duration = Duration::from_millis(100);

/// Draws with progress: where there is one frame alone, and that takes long, as it is drawn.
fn watched<T>(shot: &mut Shot, progress: &mut Progress, draw: impl FnOnce(&mut Shot, Step) -> T) -> T {
    let takes_long = shot.draw_options().exact.is_some() && !takes_several_frames(shot.prepared());
    let Some(meter) = shot.meter().filter(|_| takes_long) else {
        return draw(shot, &mut |part| progress.within(part));
    };
    let is_over = AtomicBool::new(false);
    thread::scope(|scope| {
        let watch = || {
            while !is_over.load(Ordering::Acquire) {
                progress.within(meter.part());
                thread::park_timeout(INTERVAL);
            }
        };
        let watcher = scope.spawn(watch);
        // Dropped by a panic, too, so that nobody waits for a picture that will not come.
        let _ending = Ending { is_over: &is_over, watcher: watcher.thread().clone() };
        draw(shot, &mut |_| ())
    })
}

/// Ends the watch of a frame.
struct Ending<'a> {
    is_over: &'a AtomicBool,
    watcher: Thread,
}

impl Drop for Ending<'_> {
    fn drop(&mut self) {
        self.is_over.store(true, Ordering::Release);
        self.watcher.unpark();
    }
}

fn without_spectra(error: ShotError) -> Failure {
    match error {
        ShotError::NoSpectra { mode } => Failure::Usage(format!(
            "--spectral-exr needs spectra of light: add --mode spectral (the mode is {mode})"
        )),
        other => other.into(),
    }
}

/// Draws 8-bit codes, if there is memory for them.
pub(crate) fn codes(
    shot: &mut Shot,
    timings: &mut Timings,
    progress: &mut Progress,
) -> Result<Canvas, Failure> {
    shot.check_memory(PictureKind::Codes8)?;
    let (width, height) = (shot.view().width as usize, shot.view().height as usize);
    if takes_several_frames(shot.prepared()) {
        let frame = timings.measure(Stage::Draw, || frame(shot, Aovs::default(), progress))?;
        let rgba = timings.measure(Stage::Develop, || shot.codes8(frame))?;
        return Ok(Canvas { width, height, rgba });
    }
    let mut rgba = vec![0; 4 * width * height];
    timings.measure(Stage::Draw, || watched(shot, progress, |shot, _| shot.draw_into(&mut rgba)))?;
    Ok(Canvas { width, height, rgba })
}

/// Draws linear light with object numbers, and develops it.
pub(crate) fn developed(shot: &mut Shot, progress: &mut Progress) -> Result<Developed, Failure> {
    let frame = frame(shot, Aovs { object: true, ..Aovs::default() }, progress)?;
    let frame = shot.on_screen(frame)?;
    let codes = codes_of(shot, &frame)?;
    Ok(Developed { frame, codes })
}

/// All channels that the observer sees.
fn frame(shot: &mut Shot, aovs: Aovs, progress: &mut Progress) -> Result<Frame, Failure> {
    let draw = |shot: &mut Shot, step: Step| shot.frame_in_steps(aovs, step);
    Ok(watched(shot, progress, draw)?)
}

/// A frame that is on the screen already, developed.
fn codes_of(shot: &Shot, screen: &Frame) -> Result<Vec<u8>, Failure> {
    let settings = Develop { to_screen: None, ..*shot.develop_settings() };
    Ok(develop(screen, &settings).map_err(ShotError::from)?)
}

/// The picture as a screen shows it.
pub(crate) fn on_screen(shot: &Shot, picture: &PictureData) -> Result<Canvas, Failure> {
    Ok(match picture {
        PictureData::Codes8 { width, height, rgba } => {
            Canvas { width: *width, height: *height, rgba: rgba.clone() }
        }
        PictureData::Codes16 { width, height, rgba } => {
            let rgba = rgba.iter().map(|code| (code >> 8) as u8).collect();
            Canvas { width: *width, height: *height, rgba }
        }
        PictureData::Spectrum(image) => {
            let SpectralImage { width, height, .. } = *image;
            let rgb = image.rgb.clone().unwrap_or_default();
            let frame = Frame { width, height, rgb, alpha: vec![1.0; width * height], ..Frame::default() };
            Canvas { width, height, rgba: codes_of(shot, &frame)? }
        }
        PictureData::Light { screen, .. } => {
            Canvas { width: screen.width, height: screen.height, rgba: codes_of(shot, screen)? }
        }
    })
}
