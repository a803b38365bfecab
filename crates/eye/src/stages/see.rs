//! All stages of an eye, in their order, on a frame.

use glanz_picture::Frame;
use serde::Serialize;

use super::acuity::{Acuity, Angles};
use super::chromatic::Chromatic;
use super::deficiency::Projection;
use super::dusk::{LUMINANCE, Mixture, SCOTOPIC_OF_D65};
use super::glare::Glare;
use super::photons;
use super::plane::{for_each_channel, for_each_row, sum};
use crate::curves::{Eyes, acuity_cutoff, pupil_diameter_mm, trolands};
use crate::{Cones, RodColor, Viewer};

/// An eye that looks at a picture: all that its stages need to know of it.
///
/// A `Shot` of the crate `glanz-render` has one of its own; by itself:
///
/// ```
/// use glanz_eye::{Angles, Eye, Seeing, Viewer};
/// use glanz_picture::Frame;
///
/// let protan: Viewer = "protan".parse::<Eye>()?.into();
/// let seeing = Seeing {
///     viewer: protan,
///     own_white: vec![1.0; 3],
///     usual_white: vec![1.0; 3],
///     gains: [1.0; 3],
///     scales: [1.0; 3],
///     white: [1.0; 3],
///     rod_color: [1.0; 3],
///     unit_cd_m2: 1000.0,
///     angles: Angles { px_per_deg: 40.0, distance_px: None, middle: [0.5, 0.5] },
/// };
/// // What L sees is not what the picture of someone without L is made of.
/// let pixel = |l| Frame { width: 1, height: 1, rgb: [vec![l], vec![0.4], vec![0.3]], alpha: vec![1.0], ..Frame::default() };
/// let (mut a, mut b) = (pixel(0.5), pixel(0.3));
/// let seen = seeing.see(&mut a);
/// seeing.see(&mut b);
/// assert_eq!(a.rgb, b.rgb);
/// assert!(seen.pupil_mm > 2.0 && seen.cones == 1.0);
/// # Ok::<(), glanz_eye::EyeError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Seeing {
    /// The eye, and how it looks.
    pub viewer: Viewer,
    /// A white surface under the light that counts as white, in the channels of frames of this eye.
    pub own_white: Vec<f64>,
    /// The same as the eye with all cones sees it.
    pub usual_white: Vec<f64>,
    /// By what L, M, S are multiplied when the frame is shown, for the eye to be adapted to its white.
    pub gains: [f64; 3],
    /// By what the sensitivities of L, M, S are multiplied in frames.
    pub scales: [f64; 3],
    /// What is white to the standard eye, in its channels, of luminance 1.
    pub white: [f64; 3],
    /// The colour of what rods see, in the channels of the standard eye, of luminance 1.
    pub rod_color: [f64; 3],
    /// The luminance in cd/m² of the value 1.
    pub unit_cd_m2: f64,
    /// How angles belong to pixels.
    pub angles: Angles,
}

/// What an eye made of a picture: what [`Seeing::see`] tells.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Seen {
    /// The photopic luminance that it is adapted to, in cd/m².
    pub adaptation_cd_m2: f64,
    /// The part that cones have in seeing, m of CIE 191; 1 by day.
    pub cones: f64,
    /// The mesopic luminance of what it is adapted to, in cd/m².
    pub mesopic_cd_m2: f64,
    /// The diameter of the pupil in mm, looking with both eyes at a picture of this size.
    pub pupil_mm: f64,
    /// The light on the retina at that luminance, in trolands.
    pub trolands: f64,
    /// The finest grating that is resolved where it looks, in cycles per degree.
    pub cutoff_cpd: f64,
}

impl Seeing {
    /// Takes a frame of the eye's channels through the stages: glare, chromatic aberration, photons, deficiency, dusk, acuity. What comes out are the channels L, M, S
    /// of an eye with all cones that sees by day, whose picture shows what this one sees; white is what it was to this eye.
    pub fn see(&self, frame: &mut Frame) -> Seen {
        let width = frame.width;
        if width == 0 || frame.height == 0 {
            return Seen { cones: 1.0, ..Seen::default() };
        }
        let viewing = &self.viewer.viewing;
        if viewing.glare {
            let glare = Glare::new(&self.viewer.eye, self.angles, [width, frame.height]);
            for_each_channel(channels(frame), |_, channel| glare.apply(channel, width));
        }
        let seen = self.adapted_to(frame);
        if viewing.chromatic {
            let eye = &self.viewer.eye;
            for_each_channel(channels(frame), |c, channel| {
                Chromatic::new(eye, c, seen.pupil_mm, self.angles.px_per_deg).apply(channel, width);
            });
        }
        if let Some(seed) = viewing.noise {
            for_each_channel(channels(frame), |c, channel| {
                let seed = u64::from(seed) | (c as u64) << 32;
                photons::draw(channel, width, self.photons(c, seen.pupil_mm), seed);
            });
        }
        if let Some(projection) =
            Projection::new(&self.viewer.eye, &self.own_white, &self.usual_white, self.scales)
        {
            projection.apply(&mut frame.rgb);
        }
        self.mix(frame, seen.cones);
        if (viewing.acuity || viewing.gaze.is_some())
            && let size = [width, frame.height]
            && let Some(acuity) = Acuity::new(seen.mesopic_cd_m2, viewing.gaze, self.angles, size)
        {
            for_each_channel(frame.rgb.iter_mut(), |_, channel| acuity.apply(channel, width));
        }
        seen
    }

    /// How many photons of a pixel receptors of a channel answer to, for the value 1.
    fn photons(&self, channel: usize, pupil_mm: f64) -> f64 {
        let pupil_mm2 = core::f64::consts::FRAC_PI_4 * pupil_mm * pupil_mm;
        let pixel_deg2 = 1.0 / (self.angles.px_per_deg * self.angles.px_per_deg);
        let per_second = photons::photons_of_one(&self.viewer.eye, channel) * pupil_mm2 * pixel_deg2;
        per_second * photons::GATHERED_S * self.unit_cd_m2
    }

    /// What the eye is adapted to: the mean of the frame, or what was said.
    fn adapted_to(&self, frame: &Frame) -> Seen {
        let [l, m] = [0, 1].map(|c| mean(&frame.rgb[c], frame.width));
        let mean_luminance = self.unit_cd_m2 * (LUMINANCE[0] * l + LUMINANCE[1] * m);
        let mean_rods =
            frame.more.first().map(|rods| self.unit_cd_m2 * SCOTOPIC_OF_D65 * mean(rods, frame.width));
        let said = self.viewer.viewing.adaptation_cd_m2;
        let photopic = said.unwrap_or(mean_luminance).max(0.0);
        let mixture = match mean_rods {
            None => Mixture { cones: 1.0, luminance: photopic },
            // What was said is photopic: the scotopic luminance follows in the proportion of the picture.
            Some(rods) => {
                let scotopic = if mean_luminance > 0.0 { photopic * rods / mean_luminance } else { photopic };
                Mixture::of(photopic, scotopic)
            }
        };
        let cones = if self.viewer.eye.cones == Cones::None { 0.0 } else { mixture.cones };
        let size = [frame.width, frame.height].map(|px| px as f64 / self.angles.px_per_deg);
        let pupil_mm = pupil_diameter_mm(photopic, size[0] * size[1], self.viewer.eye.age, Eyes::Both);
        Seen {
            adaptation_cd_m2: photopic,
            cones,
            mesopic_cd_m2: mixture.luminance,
            pupil_mm,
            trolands: trolands(photopic, pupil_mm),
            cutoff_cpd: acuity_cutoff(mixture.luminance),
        }
    }

    /// Mixes cones and rods into the channels of the cones.
    fn mix(&self, frame: &mut Frame, cones: f64) {
        let Some(rods) = frame.more.first() else { return };
        let white = LUMINANCE[0] * self.own_white[0] + LUMINANCE[1] * self.own_white[1];
        let rod_white = self.own_white.get(3).copied().unwrap_or(1.0);
        let [by_cones, by_rods] = Mixture { cones, luminance: 0.0 }.factors(white, rod_white);
        let color = match self.viewer.viewing.rods {
            RodColor::White => self.white,
            RodColor::Blue => self.rod_color,
        };
        for (c, channel) in frame.rgb.iter_mut().enumerate() {
            // The gain of adaptation is applied later, and is none of the rods'.
            let (by_cones, by_rods) = (by_cones as f32, (by_rods * color[c] / self.gains[c]) as f32);
            let width = frame.width;
            for_each_row(channel, width, |y, row| {
                for (value, rods) in row.iter_mut().zip(&rods[y * width..]) {
                    *value = by_cones * *value + by_rods * rods;
                }
            });
        }
    }
}

/// All channels of a frame.
fn channels(frame: &mut Frame) -> impl Iterator<Item = &mut Vec<f32>> {
    frame.rgb.iter_mut().chain(&mut frame.more)
}

/// The mean of a channel.
fn mean(channel: &[f32], width: usize) -> f64 {
    sum(channel, width) / channel.len().max(1) as f64
}
