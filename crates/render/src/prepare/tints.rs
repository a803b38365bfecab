//! The tint table: T\[l, k, c\] = π · ∫ light_l · lobe_k · sensor_c, one way for all colour modes.
//!
//! π turns a classic light of 1 into radiance units.

use glanz_bsdf::Part;
use glanz_math::PI;
use glanz_scene::{Light, LightKind, Lobe, Scene, Tint};

use super::curve::{self, Curve};
use super::sampling::{Channels, Response, Row, Sampling};
use crate::prepare::lights;

/// A light at the nodes of the colour mode, for the three kinds of lobe; times π for those that have a
/// direction.
struct LightRows {
    ambient: Row,
    diffuse: Row,
    specular: Row,
    is_spot: bool,
    is_directed: bool,
}

/// The scene's lights as a colour mode takes them: one side of every entry of the table.
pub(super) struct Table<'a> {
    sampling: &'a Sampling,
    lights: Vec<LightRows>,
}

/// An entry of the table, or one for each of the three spectra that textures mix.
pub(super) type Entry = [f32; 3];

impl<'a> Table<'a> {
    pub fn new(sampling: &'a Sampling, scene: &Scene) -> Self {
        Self { sampling, lights: scene.lights.iter().map(|light| light_rows(sampling, light)).collect() }
    }

    /// Whether textures mix three spectra, rather than multiply channels.
    pub fn mixes_spectra(&self) -> bool {
        !self.sampling.is_componentwise()
    }

    /// The entries of direct lobes, light after light; `basis` is the number of a spectrum that the
    /// lobes are multiplied with.
    pub fn direct(&self, lobes: &[&Lobe], basis: Option<usize>) -> Vec<Entry> {
        let responses: Vec<Response> = lobes.iter().map(|lobe| self.response(&lobe.tint, basis)).collect();
        let entry = |light: &LightRows, i: usize| short(responses[i].under(light.of(part_of(lobes[i]))));
        self.directed()
            .flat_map(|light| (0..lobes.len()).map(move |i| (light, i)))
            .map(|(l, i)| entry(l, i))
            .collect()
    }

    /// The same for lobes whose tint depends on a cosine; empty curves for the others. Nothing at all
    /// if no lobe is such.
    pub fn curves(&self, lobes: &[&Lobe]) -> Vec<Curve> {
        if !lobes.iter().any(|lobe| is_curved(lobe)) {
            return Vec::new();
        }
        let responses: Vec<Vec<Response>> = lobes.iter().map(|lobe| self.responses(lobe)).collect();
        let curve = |light: &LightRows, i: usize| {
            let row = light.of(part_of(lobes[i]));
            let values: Vec<Channels> = responses[i].iter().map(|response| response.under(row)).collect();
            if values.is_empty() { Curve::default() } else { Curve::through(&values) }
        };
        self.directed()
            .flat_map(|light| (0..lobes.len()).map(move |i| (light, i)))
            .map(|(l, i)| curve(l, i))
            .collect()
    }

    /// What ambient light gives by these tints: that of all lights but spots.
    pub fn ambient(&self, tints: &[&Tint], basis: Option<usize>) -> Entry {
        let responses: Vec<Response> = tints.iter().map(|tint| self.response(tint, basis)).collect();
        let mut sum = [0.0; 3];
        for light in self.lights.iter().filter(|light| !light.is_spot) {
            add(&mut sum, under_all(&responses, &light.ambient));
        }
        short(sum)
    }

    /// The same for each light with a direction: what spots send into their cones, nothing for others.
    pub fn spot_ambient(&self, tints: &[&Tint], basis: Option<usize>) -> Vec<Entry> {
        let responses: Vec<Response> = tints.iter().map(|tint| self.response(tint, basis)).collect();
        let entry = |light: &LightRows| match light.is_spot {
            true => short(under_all(&responses, &light.ambient)),
            false => [0.0; 3],
        };
        self.directed().map(entry).collect()
    }

    /// Light of the surface's own.
    pub fn emission(&self, tints: &[&Tint], basis: Option<usize>) -> Entry {
        let mut sum = [0.0; 3];
        for tint in tints {
            add(&mut sum, self.sampling.emitted(tint, basis));
        }
        short(sum)
    }

    fn response(&self, tint: &Tint, basis: Option<usize>) -> Response {
        self.sampling.response(&self.sampling.surface(tint, 1.0), basis)
    }

    /// Of a lobe whose tint depends on a cosine: at each cosine that its curve goes through.
    fn responses(&self, lobe: &Lobe) -> Vec<Response> {
        let at = |cosine| self.sampling.response(&self.sampling.surface(&lobe.tint, cosine), None);
        if is_curved(lobe) { curve::nodes().map(at).collect() } else { Vec::new() }
    }

    fn directed(&self) -> impl Iterator<Item = &LightRows> {
        self.lights.iter().filter(|light| light.is_directed)
    }
}

impl LightRows {
    fn of(&self, part: Part) -> &Row {
        if part == Part::Diffuse { &self.diffuse } else { &self.specular }
    }
}

fn light_rows(sampling: &Sampling, light: &Light) -> LightRows {
    let times_pi = |color| sampling.light(color).iter().map(|value| PI * value).collect();
    LightRows {
        ambient: sampling.light(&light.colors.ambient),
        diffuse: times_pi(&light.colors.diffuse),
        specular: times_pi(&light.colors.specular),
        is_spot: matches!(light.kind, LightKind::Spot { .. }),
        is_directed: lights::is_directed(light),
    }
}

pub(super) fn part_of(lobe: &Lobe) -> Part {
    lobe.shape.info().part
}

/// Whether a lobe's tint depends on the angle between viewer and half vector: of highlights alone,
/// since light that comes back diffusely has no such angle.
pub(super) fn is_curved(lobe: &Lobe) -> bool {
    part_of(lobe) == Part::Specular && matches!(lobe.tint, Tint::Ior(_))
}

fn under_all(responses: &[Response], light: &Row) -> Channels {
    let mut sum = [0.0; 3];
    responses.iter().for_each(|response| add(&mut sum, response.under(light)));
    sum
}

fn add(sum: &mut Channels, value: Channels) {
    sum.iter_mut().zip(value).for_each(|(sum, value)| *sum += value);
}

fn short(channels: Channels) -> Entry {
    channels.map(|c| c as f32)
}
