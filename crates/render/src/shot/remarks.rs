//! Remarks on pictures that are hardly what was meant: black, empty, clipped, or wrong on purpose.

use glanz_bsdf::LightTerm;
use glanz_math::names;
use glanz_picture::output::PictureData;
use glanz_picture::{Frame, ToneMap};
use glanz_scene::{Background, DebugView, Light, LightKind, Material, Scene, Tint};

use super::{Shot, ShotError, unseen};
use crate::view::{Aovs, DrawOptions, Samples, View};
use crate::{draw_observed, takes_several_frames};

/// The share of the pixels with surfaces above which it is told that they are clipped.
const MUCH_CLIPPED: f64 = 0.05;
/// The same where terms add up to more than all light, so that it is known why.
const CLIPPED_BY_SUMS: f64 = 0.01;
/// As many colours may a picture have that shows the background, one colour and the edges between them.
const FEW_COLORS: usize = 64;
/// The most pixels of the picture that is drawn again to look at it.
const PROBE_PIXELS: f64 = 1_000_000.0;
/// Width and height within which it is asked whether lamps reach the front of anything.
const SMALL: f64 = 160.0;
/// Light of 1, but for rounding.
const WHITE: f32 = 1.0 + 1e-4;

/// What is odd about a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum RemarkKind {
    /// A mistake is drawn on purpose, or would change nothing.
    Mistake,
    /// The scene has no objects.
    NoObjects,
    /// The scene has no lights.
    NoLights,
    /// No object is in view.
    NothingInView,
    /// All that is seen is black, or gets ambient light alone.
    Dark,
    /// Much is above white.
    Clipped,
    /// How exact light is that is found by points.
    Lighting,
    /// A uniform or a picture of a program is set by nobody, or a program gives what is no number.
    Program,
}

/// What is to be said about a picture, by [`Shot::remarks`]: what it is about, and a sentence for people.
///
/// ```
/// use glanz_render::{Remark, RemarkKind};
///
/// let remark = Remark { kind: RemarkKind::NoLights, text: "the scene has no lights".to_owned() };
/// assert_eq!(remark.to_string(), "the scene has no lights");
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Remark {
    /// What it is about; its numbers may differ from picture to picture.
    pub kind: RemarkKind,
    /// The sentence, without a full stop.
    pub text: String,
}

impl Remark {
    pub(super) fn new(kind: RemarkKind, text: impl Into<String>) -> Self {
        Self { kind, text: text.into() }
    }
}

impl core::fmt::Display for Remark {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(&self.text)
    }
}

/// What the surfaces of a picture look like.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Surfaces {
    /// Pixels that show one.
    pixels: usize,
    /// Of those, how many are not black.
    lit: usize,
    /// Of those, how many have a channel above white.
    clipped: usize,
    /// The greatest value of a channel, 1 for white.
    most: f32,
}

impl Shot {
    /// What is to be said about the picture of `scene` that was drawn: that it shows nothing or is black, and why; that
    /// it is clipped; which mistake is drawn. Nothing, if all is well.
    ///
    /// A picture that gives reason to doubt is drawn again for this, at most a megapixel of it.
    ///
    /// ```
    /// use glanz_render::Shot;
    /// use glanz_scene::{Light, Mesh, Scene, library};
    ///
    /// let scene = Scene::new().with_mesh(Mesh::builtin("sphere")?, library::material("gold")?).with_size(32, 24);
    /// let mut shot = Shot::new(&scene)?;
    /// let picture = shot.picture(glanz_picture::output::PictureKind::Codes8, &mut |_| ())?;
    /// assert!(shot.remarks(&scene, &picture)?[0].text.starts_with("the scene has no lights"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`Shot::frame`].
    pub fn remarks(&mut self, scene: &Scene, picture: &PictureData) -> Result<Vec<Remark>, ShotError> {
        let mut remarks: Vec<_> = self.mistake_remark().into_iter().collect();
        if scene.objects.is_empty() {
            let text = "the scene has no objects: the picture shows its background alone";
            remarks.push(Remark::new(RemarkKind::NoObjects, text));
            return Ok(remarks);
        }
        remarks.extend(self.program_remarks()?);
        if self.is_drawn_by_programs() {
            return Ok(remarks);
        }
        let is_light = self.sight.draw.show.is_light();
        if is_light && let Some(error) = self.light_error()? {
            remarks.push(Remark::new(RemarkKind::Lighting, error.to_string()));
        }
        if is_light && !has_light(scene) {
            let help = "add [[lights]], or [ambient] light for ambient terms";
            let text = format!("the scene has no lights, so its surfaces are black: {help}");
            remarks.push(Remark::new(RemarkKind::NoLights, text));
        }
        let Some(surfaces) = self.doubts(scene, picture)? else { return Ok(remarks) };
        if surfaces.pixels == 0 {
            remarks.push(Remark::new(RemarkKind::NothingInView, self.nothing_in_view(scene)));
        } else if is_light && has_light(scene) {
            let dark = self.darkness(scene, surfaces)?;
            remarks.extend(dark.map(|text| Remark::new(RemarkKind::Dark, text)));
            // Files of linear light hold what no screen shows.
            if matches!(picture, PictureData::Codes8 { .. } | PictureData::Codes16 { .. }) {
                let clipped = self.clipping(scene, surfaces);
                remarks.extend(clipped.map(|text| Remark::new(RemarkKind::Clipped, text)));
            }
        }
        Ok(remarks)
    }

    fn mistake_remark(&self) -> Option<Remark> {
        let mistake = self.mistake?;
        let (_, name, about) = *glanz_scene::Mistake::ALL
            .iter()
            .find(|(known, ..)| *known == mistake)
            .expect("all mistakes are in the list");
        let mut about = about.trim_end_matches('.').chars();
        let about: String = about.next().into_iter().flat_map(char::to_lowercase).chain(about).collect();
        let effect = self.effect.map_or_else(
            |error| error.to_string(),
            |()| format!("drawn with the mistake '{name}' on purpose: {about}"),
        );
        Some(Remark::new(RemarkKind::Mistake, effect))
    }

    /// What the surfaces look like, where the picture gives reason to look closer.
    fn doubts(&mut self, scene: &Scene, picture: &PictureData) -> Result<Option<Surfaces>, ShotError> {
        let doubtful = match picture {
            PictureData::Codes8 { rgba, .. } => {
                is_doubtful(rgba.chunks_exact(4).map(|p| [p[0], p[1], p[2]].map(u32::from)), 255)
            }
            PictureData::Codes16 { rgba, .. } => {
                is_doubtful(rgba.chunks_exact(4).map(|p| [p[0], p[1], p[2]].map(u32::from)), 65_535)
            }
            _ => true,
        };
        // Drawing one picture for each pair of wavelengths again would take as long as the picture itself.
        if takes_several_frames(&self.prepared) || !(doubtful || has_lamps_only(scene)) {
            return Ok(None);
        }
        self.surfaces(PROBE_PIXELS, self.sight.draw.show, true).map(Some)
    }

    /// The light on the surfaces in a picture of at most so many pixels.
    fn surfaces(&mut self, pixels: f64, show: DebugView, on_screen: bool) -> Result<Surfaces, ShotError> {
        let View { width, height, .. } = self.sight.view;
        let factor = (pixels / (f64::from(width) * f64::from(height))).sqrt().min(1.0);
        let side = |length: u32| ((f64::from(length) * factor) as u32).max(1);
        let view = View::new(&self.sight.camera, side(width), side(height))?;
        let aovs = Aovs::default();
        // Before nothing, since pixels on edges show what is behind, too.
        let (samples, background) = (Samples::One, Background::Transparent);
        let options = DrawOptions { aovs, show, samples, background, exact: None, ..self.sight.draw };
        let frame = draw_observed(&mut *self.backend, &self.prepared, &view, &options, &mut |_| ())?;
        let frame = if on_screen { self.on_screen(frame)? } else { frame };
        Ok(Surfaces::of(&frame, self.gain()))
    }

    /// The factor of the exposure.
    fn gain(&self) -> f32 {
        libm::exp2(f64::from(self.sight.develop.ev)) as f32
    }

    fn nothing_in_view(&self, scene: &Scene) -> String {
        if let Some(why) = unseen::reason(scene, &self.sight.camera) {
            return why.to_owned();
        }
        let (camera, bounds) = (&self.sight.camera, scene.bounds());
        let point = |v: glam::DVec3| format!("({:.3}, {:.3}, {:.3})", v.x, v.y, v.z);
        format!(
            "no object is in view: the camera at {} looks at {}, the objects are within {} to {}; without [camera] they \
             are framed",
            point(camera.eye),
            point(camera.target),
            point(bounds.min),
            point(bounds.max)
        )
    }

    /// That no lamp reaches the front of what is seen.
    fn darkness(&mut self, scene: &Scene, surfaces: Surfaces) -> Result<Option<String>, ShotError> {
        if !has_lamps_only(scene) {
            let dark = "all surfaces in view are black, although the scene has lights";
            return Ok((surfaces.lit == 0).then(|| dark.to_owned()));
        }
        let shows_all = self.sight.draw.show == DebugView::Shaded;
        if surfaces.lit > 0 && (!shows_all || self.lamps_reach_something()?) {
            return Ok(None);
        }
        if surfaces.lit == 0 && self.lamps_reach_something()? {
            return Ok(Some(
                "all surfaces in view are black, although light reaches them: see their colours".to_owned(),
            ));
        }
        let what = match surfaces.lit {
            0 => "all surfaces in view are black",
            _ => "the surfaces in view get ambient or emitted light only",
        };
        Ok(Some(format!("{what}: no lamp reaches their front; {}", advice(scene))))
    }

    /// Whether a lamp reaches the front of anything in view; a small picture mostly tells.
    fn lamps_reach_something(&mut self) -> Result<bool, ShotError> {
        let small = self.surfaces(SMALL * SMALL, DebugView::Lit, false)?;
        Ok(small.lit > 0 || self.surfaces(PROBE_PIXELS, DebugView::Lit, false)?.lit > 0)
    }

    /// That much is clipped, or that terms add up to more than all light.
    fn clipping(&self, scene: &Scene, surfaces: Surfaces) -> Option<String> {
        if self.sight.develop.tone_map != ToneMap::None || surfaces.clipped == 0 {
            return None;
        }
        let share = surfaces.clipped as f64 / surfaces.pixels as f64;
        let sums: Vec<String> =
            scene.materials.iter().enumerate().filter_map(|used| too_much(scene, used)).collect();
        if share < if sums.is_empty() { MUCH_CLIPPED } else { CLIPPED_BY_SUMS } {
            return None;
        }
        // Down to a tenth, so that it does show all.
        let stops = f64::from(self.sight.develop.ev) - libm::log2(f64::from(surfaces.most));
        let stops = (stops * 10.0).floor() / 10.0;
        let cause = match sums.as_slice() {
            [] => "lower the lights or the colours".to_owned(),
            sums => sums.join("; "),
        };
        let percent = share * 100.0;
        Some(format!(
            "{percent:.1} % of the pixels with surfaces are clipped, up to {:.3} where 1 is white: {cause}; --ev {stops:.1} \
             shows all",
            surfaces.most
        ))
    }
}

impl Surfaces {
    fn of(frame: &Frame, gain: f32) -> Self {
        let mut found = Self::default();
        // What covers a pixel in part counts, too: panes, and surfaces of little opacity.
        for (i, _) in frame.alpha.iter().enumerate().filter(|(_, alpha)| **alpha > 0.0) {
            let most = frame.rgb.iter().map(|plane| plane[i] * gain).fold(0.0, f32::max);
            found.pixels += 1;
            found.lit += usize::from(most > 0.0);
            found.clipped += usize::from(most > WHITE);
            found.most = found.most.max(most);
        }
        found
    }
}

/// Whether codes may be those of a black or clipped picture.
fn is_doubtful(mut pixels: impl Iterator<Item = [u32; 3]>, most: u32) -> bool {
    let mut colors = Vec::with_capacity(FEW_COLORS + 1);
    pixels.any(|pixel| {
        if colors.len() <= FEW_COLORS && !colors.contains(&pixel) {
            colors.push(pixel);
        }
        pixel.contains(&most)
    }) || colors.len() <= FEW_COLORS
}

/// Whether anything sends light at all.
fn has_light(scene: &Scene) -> bool {
    let sends = |light: &Light| {
        [&light.colors.ambient, &light.colors.diffuse, &light.colors.specular]
            .iter()
            .any(|color| !color.is_black())
    };
    let glows = |material: &Material| {
        material
            .lobes
            .iter()
            .any(|lobe| lobe.shape.info().term == LightTerm::Emission && !lobe.tint.is_black())
    };
    scene.lights.iter().any(sends) || scene.materials.iter().any(glows)
}

/// Whether there are lamps, and no light from areas and environments, which reach around edges.
fn has_lamps_only(scene: &Scene) -> bool {
    let is_wide =
        |light: &Light| matches!(light.kind, LightKind::Area { .. } | LightKind::Environment { .. });
    let is_lamp = |light: &Light| !is_wide(light) && light.kind != LightKind::Ambient;
    scene.lights.iter().any(is_lamp) && !scene.lights.iter().any(is_wide)
}

/// What to write, where no lamp reaches the front of anything.
fn advice(scene: &Scene) -> String {
    let direction = scene.lights.iter().find_map(|light| match light.kind {
        LightKind::Directional { direction } => Some(direction),
        _ => None,
    });
    match direction {
        Some(direction) => {
            let list = (-direction).to_array().map(|c| (c + 0.0).to_string()).join(", ");
            format!(
                "'direction' is the way the light travels, so the L of a course, which points to the light, is its \
                 opposite: direction = [{list}] lights the other side"
            )
        }
        None => "they are behind the surfaces, or those are outside of their cones".to_owned(),
    }
}

/// A material that is used and whose matte and shiny colours add up to more than 1 in a channel.
fn too_much(scene: &Scene, (index, material): (usize, &Material)) -> Option<String> {
    let is_used = scene.objects.iter().any(|object| object.material == index);
    let sum = |asked: LightTerm| {
        let own =
            material.lobes.iter().filter(|lobe| lobe.shape.info().term == asked && lobe.layers.is_empty());
        own.fold([0.0_f32; 3], |sum, lobe| match &lobe.tint {
            Tint::Rgb(rgb) => [sum[0] + rgb.0[0], sum[1] + rgb.0[1], sum[2] + rgb.0[2]],
            _ => sum,
        })
    };
    let (matte, shiny) = (sum(LightTerm::Diffuse), sum(LightTerm::Specular));
    let most = (0..3).map(|c| matte[c] + shiny[c]).fold(0.0, f32::max);
    (is_used && most > WHITE).then(|| {
        format!(
            "diffuse and specular of material '{}' add up to {most:.3}, where 1 is all light",
            names::shown(&material.name)
        )
    })
}
