//! The tint table: T\[l, k, c\] = ∫ light_l · lobe_k · sensor_c, one way for all colour modes.

use glanz_bsdf::LightTerm;
use glanz_math::PI;
use glanz_scene::{Light, LightKind, Lobe, Tint, Transmittance};

use crate::prepare::color::quadrature::{Response, Row, Sampling, Surface, Triple};
use crate::prepare::color::tint_coordinate::{self, coordinate_of};
use crate::prepare::color::tint_series;
use crate::prepare::data::{TintCoordinate, TintSeries};

/// A light at the nodes of the colour mode, for the three kinds of lobe; times π for punctual lights, whose value 1 is
/// an irradiance of π.
struct LightRows {
    ambient: Row,
    diffuse: Row,
    specular: Row,
    is_spot: bool,
    is_directed: bool,
    /// Whether it is one of three.
    is_mixed: bool,
}

/// The scene's lights as a colour mode takes them: one side of every entry of the table. Environments are
/// three lights, one for each of the spectra that their pixels mix.
pub(crate) struct Table<'a> {
    sampling: &'a Sampling,
    lights: Vec<LightRows>,
}

/// An entry of the table, or one for each of the three spectra that textures mix.
pub(crate) type Entry = [f32; 3];

impl<'a> Table<'a> {
    pub(crate) fn new(sampling: &'a Sampling, lights: &[Light]) -> Self {
        let lights = lights.iter().flat_map(|light| light_rows(sampling, light)).collect();
        Self { sampling, lights }
    }

    /// Whether textures mix three spectra, rather than multiply channels.
    pub(crate) fn mixes_spectra(&self) -> bool {
        !self.sampling.is_componentwise()
    }

    /// The entries of direct lobes, light after light; `basis` is the number of a spectrum that the
    /// lobes are multiplied with.
    pub(crate) fn direct(&self, lobes: &[&Lobe], basis: Option<usize>) -> Vec<Entry> {
        let response = |lobe: &&Lobe| {
            self.sampling
                .response(&tint_coordinate::surface(self.sampling, lobe, coordinate_of(lobe), 1.0), basis)
        };
        let responses: Vec<Response> = lobes.iter().map(response).collect();
        let entry = |light: &LightRows, i: usize| short(responses[i].under(light.of(term_of(lobes[i]))));
        let pairs = self.directed().flat_map(|light| (0..lobes.len()).map(move |i| (light, i)));
        // A vector that grows by itself takes up to twice as much.
        let mut entries = Vec::with_capacity(self.directed().count() * lobes.len());
        entries.extend(pairs.map(|(l, i)| entry(l, i)));
        entries
    }

    /// The same for lobes whose tint depends on a cosine; empty curves for the others. Nothing at all
    /// if no lobe is such.
    pub(crate) fn series(&self, lobes: &[&Lobe]) -> Vec<TintSeries> {
        if lobes.iter().all(|lobe| coordinate_of(lobe) == TintCoordinate::None) {
            return Vec::new();
        }
        let responses: Vec<Vec<Response>> = lobes.iter().map(|lobe| self.responses(lobe)).collect();
        let series = |light: &LightRows, i: usize| {
            let row = light.of(term_of(lobes[i]));
            let values: Vec<Triple> = responses[i].iter().map(|response| response.under(row)).collect();
            if values.is_empty() { TintSeries::default() } else { TintSeries::fit(&values) }
        };
        self.directed()
            .flat_map(|light| (0..lobes.len()).map(move |i| (light, i)))
            .map(|(l, i)| series(l, i))
            .collect()
    }

    /// What ambient light gives by these tints: that of all lights but spots.
    pub(crate) fn ambient(&self, tints: &[&Tint], basis: Option<usize>) -> Entry {
        let responses: Vec<Response> = tints.iter().map(|tint| self.response(tint, basis)).collect();
        let mut sum = [0.0; 3];
        for light in self.lights.iter().filter(|light| !light.is_spot) {
            add(&mut sum, under_all(&responses, &light.ambient));
        }
        short(sum)
    }

    /// The same for each light with a direction: what spots send into their cones, nothing for others.
    pub(crate) fn spot_ambient(&self, tints: &[&Tint], basis: Option<usize>) -> Vec<Entry> {
        let responses: Vec<Response> = tints.iter().map(|tint| self.response(tint, basis)).collect();
        let entry = |light: &LightRows| match light.is_spot {
            true => short(under_all(&responses, &light.ambient)),
            false => [0.0; 3],
        };
        self.directed().map(entry).collect()
    }

    /// Light of the surface's own.
    pub(crate) fn emission(&self, tints: &[&Tint], basis: Option<usize>) -> Entry {
        let mut sum = [0.0; 3];
        for tint in tints {
            add(&mut sum, self.sampling.emitted(tint, basis));
        }
        short(sum)
    }

    fn response(&self, tint: &Tint, basis: Option<usize>) -> Response {
        self.sampling.response(&self.sampling.surface(tint, 1.0), basis)
    }

    /// Of a lobe whose tint is a curve: at each coordinate that the curve goes through.
    fn responses(&self, lobe: &Lobe) -> Vec<Response> {
        let coordinate = coordinate_of(lobe);
        let at =
            |x| self.sampling.response(&tint_coordinate::surface(self.sampling, lobe, coordinate, x), None);
        if coordinate == TintCoordinate::None { Vec::new() } else { tint_series::nodes().map(at).collect() }
    }

    /// What each spectrum of the first environment gives in the channels, seen directly.
    pub(crate) fn environment_tint(&self) -> Option<[Entry; 3]> {
        let first = self.lights.iter().position(|light| light.is_mixed)?;
        let everything = Surface::Reflectance(vec![1.0; self.sampling.white().len()]);
        let whole = self.sampling.response(&everything, None);
        Some([0, 1, 2].map(|basis: usize| short(whole.under(&self.lights[first + basis].specular))))
    }

    /// The transmittance of a surface in each channel, over the cosine of the line of sight, for
    /// white light from behind.
    pub(crate) fn transmittance(&self, transmittance: &Transmittance) -> TintSeries {
        let white = self.sampling.white();
        let everything = Surface::Reflectance(vec![1.0; white.len()]);
        let whole = self.sampling.response(&everything, None).under(&white);
        let fraction = |cosine| {
            let seen = self
                .sampling
                .response(&self.sampling.transmittance(transmittance, cosine), None)
                .under(&white);
            core::array::from_fn(|c| if whole[c] == 0.0 { 0.0 } else { seen[c] / whole[c] })
        };
        TintSeries::fit(&tint_series::nodes().map(fraction).collect::<Vec<_>>())
    }

    fn directed(&self) -> impl Iterator<Item = &LightRows> {
        self.lights.iter().filter(|light| light.is_directed)
    }
}

/// Whether a light has a direction: all but ambient ones.
pub(crate) fn is_directed(light: &Light) -> bool {
    light.kind != LightKind::Ambient
}

/// Whether a light's value is a radiance rather than a punctual intensity.
pub(crate) fn is_radiance(light: &Light) -> bool {
    matches!(light.kind, LightKind::Area { .. } | LightKind::Environment { .. })
}

/// How many lights of the table a light is.
pub(crate) fn rows(light: &Light) -> usize {
    if matches!(light.kind, LightKind::Environment { .. }) { 3 } else { 1 }
}

impl LightRows {
    fn of(&self, term: LightTerm) -> &Row {
        if term == LightTerm::Diffuse { &self.diffuse } else { &self.specular }
    }
}

fn light_rows(sampling: &Sampling, light: &Light) -> Vec<LightRows> {
    let is_lamp = !is_radiance(light);
    let factor = if is_lamp { PI } else { 1.0 };
    let scaled = |color| sampling.light(color).iter().map(|value| factor * value).collect::<Row>();
    let whole = LightRows {
        ambient: sampling.light(&light.colors.ambient),
        diffuse: scaled(&light.colors.diffuse),
        specular: scaled(&light.colors.specular),
        is_spot: matches!(light.kind, LightKind::Spot { .. }),
        is_directed: is_directed(light),
        is_mixed: rows(light) > 1,
    };
    if rows(light) == 1 {
        return vec![whole];
    }
    (0..3).map(|number| whole.mixed(sampling.basis(number), number)).collect()
}

impl LightRows {
    /// The part of an environment that one spectrum of their pixels makes; the first has the ambient light.
    fn mixed(&self, basis: &Row, number: usize) -> Self {
        let times = |row: &Row| row.iter().zip(basis).map(|(value, b)| value * b).collect();
        let dark = || vec![0.0; self.ambient.len()];
        Self {
            ambient: if number == 0 { self.ambient.clone() } else { dark() },
            diffuse: times(&self.diffuse),
            specular: times(&self.specular),
            ..*self
        }
    }
}

pub(crate) fn term_of(lobe: &Lobe) -> LightTerm {
    lobe.shape.info().term
}

fn under_all(responses: &[Response], light: &Row) -> Triple {
    let mut sum = [0.0; 3];
    responses.iter().for_each(|response| add(&mut sum, response.under(light)));
    sum
}

fn add(sum: &mut Triple, value: Triple) {
    sum.iter_mut().zip(value).for_each(|(sum, value)| *sum += value);
}

fn short(channels: Triple) -> Entry {
    channels.map(|c| c as f32)
}
