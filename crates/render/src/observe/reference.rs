//! The slow truth: one picture per pair of wavelengths, of incidence and of what leaves.
//!
//! Each picture knows one wavelength of light and goes all the way through the rasteriser; nothing is
//! summed before it is drawn. Sums over pictures are in f64. That is what the table of the other modes
//! replaces, so it is what they are measured against; a pixel differs from the sum of its table by the
//! rounding of f32 alone. The pictures themselves are drawn in f32, with the same series for Fresnel's law and
//! the same three spectra for texels; those are tested by themselves.

use std::sync::Arc;

use glanz_color::{SAMPLES, STEP_NM, Spectrum, rgb_spectra};
use glanz_scene::{Background, Light, LightColor, LightColors, Material, Tint};

use glanz_picture::Frame;

use crate::Backend;
use crate::prepare::{Observation, PrepareError, Prepared};
use crate::view::{Aovs, DrawOptions, View};

/// Channels that a picture has.
const AT_ONCE: usize = 3;

/// Lights and materials: all that the table depends on.
type Colors = (Vec<Light>, Vec<Material>);

pub(super) fn draw(
    backend: &mut dyn Backend,
    prepared: &Prepared,
    view: &View,
    options: &DrawOptions,
    step: &mut dyn FnMut(f64),
) -> Result<Frame, PrepareError> {
    let observation = prepared.observation();
    let background = match options.background {
        Background::Environment => Background::Environment,
        _ => Background::Transparent,
    };
    let bare = DrawOptions { background, aovs: Aovs::default(), ..*options };
    let mut sum = ChannelSums::new(observation.channel_count(), view);
    let mut add_frames = |colors: Colors, firsts: &[usize]| -> Result<(), PrepareError> {
        for &first in firsts {
            let own = prepared.recolored(colors.clone(), Observation::spectrum(), first)?;
            sum.add(&backend.draw(&own, view, &bare), observation, first);
        }
        Ok(())
    };
    let (scene_lights, materials) = prepared.colors();
    let lights: Vec<[Spectrum; 3]> = scene_lights.iter().map(spectra).collect();
    for input in 0..SAMPLES {
        step(input as f64 / SAMPLES as f64);
        if !lights.iter().flatten().any(|light| light[input] != 0.0) {
            continue;
        }
        let leaving: Vec<usize> = (0..SAMPLES).filter(|out| answers(materials, *out, input)).collect();
        add_frames(only((scene_lights, materials), &lights, input), &groups(&leaving))?;
    }
    if materials.iter().any(glows) {
        let dark = (without_light(scene_lights), materials.to_vec());
        add_frames(dark, &groups(&Vec::from_iter(0..SAMPLES)))?;
    }
    // Depth, normals and coverage are those of any picture.
    let whole = DrawOptions { background: Background::Transparent, ..*options };
    Ok(sum.over(backend.draw(prepared, view, &whole), options.background))
}

/// The channels so far, in f64.
struct ChannelSums(Vec<Vec<f64>>);

impl ChannelSums {
    fn new(channels: usize, view: &View) -> Self {
        Self(vec![vec![0.0; view.width as usize * view.height as usize]; channels])
    }

    /// Adds what three wavelengths from `first` on give in each channel.
    fn add(&mut self, frame: &Frame, observation: &Observation, first: usize) {
        for (channel, sum) in self.0.iter_mut().enumerate() {
            for (plane, out) in frame.rgb.iter().zip(first..SAMPLES) {
                let weight = observation.weight(channel)[out] * STEP_NM;
                if weight != 0.0 {
                    sum.iter_mut().zip(plane).for_each(|(sum, value)| *sum += weight * f64::from(*value));
                }
            }
        }
    }

    fn over(self, like: Frame, background: Background) -> Frame {
        let (color, opaque) = match background {
            Background::Color(color) => (color.0, true),
            Background::Transparent => ([0.0; 3], false),
            // In every picture already.
            Background::Environment => ([0.0; 3], true),
        };
        let mut planes = self.0.into_iter().enumerate().map(|(channel, sum)| {
            let behind = color.get(channel).copied().unwrap_or(0.0);
            let pixels = sum.iter().zip(&like.alpha);
            pixels.map(|(value, alpha)| *value as f32 + behind * (1.0 - alpha)).collect::<Vec<f32>>()
        });
        let rgb = core::array::from_fn(|_| planes.next().unwrap_or_else(|| vec![0.0; like.alpha.len()]));
        let more = planes.collect();
        let alpha = if opaque { vec![1.0; like.alpha.len()] } else { like.alpha };
        Frame { rgb, more, alpha, ..like }
    }
}

/// The wavelengths of groups of three that hold all of `wanted`.
fn groups(wanted: &[usize]) -> Vec<usize> {
    let mut firsts = Vec::new();
    for &out in wanted {
        if firsts.last().is_none_or(|first| out >= first + AT_ONCE) {
            firsts.push(out);
        }
    }
    firsts
}

fn spectra(light: &Light) -> [Spectrum; 3] {
    let colors = &light.colors;
    [&colors.ambient, &colors.diffuse, &colors.specular].map(|color| match color {
        LightColor::Rgb(rgb) => rgb_spectra::spectrum_of_light(*rgb),
        LightColor::Spectrum(spectrum) => **spectrum,
    })
}

/// The scene's lights and materials, with light at one wavelength only and no light of its own.
fn only((lights, materials): (&[Light], &[Material]), spectra: &[[Spectrum; 3]], input: usize) -> Colors {
    let single = |light: &Spectrum| {
        let mut line = Spectrum::ZERO;
        line.0[input] = light[input];
        LightColor::Spectrum(Arc::new(line))
    };
    let colors = |[ambient, diffuse, specular]: &[Spectrum; 3]| LightColors {
        ambient: single(ambient),
        diffuse: single(diffuse),
        specular: single(specular),
    };
    let (mut lights, mut materials) = (lights.to_vec(), materials.to_vec());
    for (light, own) in lights.iter_mut().zip(spectra) {
        light.colors = colors(own);
    }
    for lobe in materials.iter_mut().flat_map(|material| &mut material.lobes) {
        if is_emission(lobe) {
            lobe.tint = Tint::BLACK;
        }
    }
    (lights, materials)
}

fn without_light(lights: &[Light]) -> Vec<Light> {
    let dark = |light: &Light| Light { colors: LightColors::all(glanz_color::Rgb::BLACK), ..light.clone() };
    lights.iter().map(dark).collect()
}

fn is_emission(lobe: &glanz_scene::Lobe) -> bool {
    lobe.shape.info().term == glanz_bsdf::LightTerm::Emission
}

fn glows(material: &Material) -> bool {
    material.lobes.iter().any(|lobe| is_emission(lobe) && !lobe.tint.is_black())
}

/// Whether any surface sends light out at `out` when it is lit at `input`.
fn answers(materials: &[Material], out: usize, input: usize) -> bool {
    let moves = |tint: &Tint| match tint {
        Tint::Reradiation(matrix) => matrix.get(out, input) != 0.0,
        _ => false,
    };
    out == input || materials.iter().flat_map(|m| &m.lobes).any(|lobe| moves(&lobe.tint))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn groups_of_three_hold_every_wavelength_once() {
        assert_eq!(groups(&[4]), [4]);
        assert_eq!(groups(&[0, 1, 2, 3, 7, 9, 10]), [0, 3, 7, 10]);
        assert!(groups(&[]).is_empty());
    }
}
