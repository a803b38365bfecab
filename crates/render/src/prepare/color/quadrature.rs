//! The colour modes: at which numbers light and surfaces are taken, and how channels are made of them.
//!
//! Every mode is a quadrature. Light and surface become one number per node; the table's entry is
//! T\[c\] = Σ_i W\[c, i\] · light_i · surface_i. In RGB the three nodes are the primaries, in spectra
//! they are wavelengths. So this file is all that the modes differ in.

use glanz_bsdf::terms::fresnel_schlick;
use glanz_color::meyer::{self, MeyerSamples, NODES_NM};
use glanz_color::{Reradiation, SAMPLES, STEP_NM, Spectrum, lambda_nm, rgb_spectra};
use glanz_scene::{CoatedBoundary, ColorMode, LightColor, Tint, Transmittance};

use crate::prepare::color::interfaces;
use crate::prepare::color::observation::Observation;

/// A row of numbers, one per node.
pub(crate) type Row = Vec<f64>;

/// What the nodes are.
#[derive(Clone, Debug, PartialEq)]
enum Nodes {
    /// The linear sRGB primaries.
    Primaries,
    /// The grid of [`Spectrum`].
    Grid,
    /// Some wavelengths in nm. Light between them is unknown; re-radiation takes each to stand for a
    /// band of so many nm, or is left out where there are no bands.
    Wavelengths { nm: Vec<f64>, band_nm: Option<f64> },
    /// Meyer's wavelengths, once for each channel: the weights of a channel depend on the light, so they
    /// are taken for the light itself.
    MeyerPerChannel,
}

/// A way to fill the tint table.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Sampling {
    nodes: Nodes,
    /// Weight of each node in each of three channels.
    weights: [Row; 3],
    /// The three spectra that textures mix, at the nodes.
    basis: [Row; 3],
}

impl Sampling {
    /// Componentwise RGB: the channels are the primaries.
    pub(crate) fn rgb() -> Self {
        let unit = |c: usize| (0..3).map(|i| if i == c { 1.0 } else { 0.0 }).collect::<Row>();
        let units = [unit(0), unit(1), unit(2)];
        Self { nodes: Nodes::Primaries, weights: units.clone(), basis: units }
    }

    /// The sampling of an observation, for three of its channels from `first` on; channels that it
    /// does not have are 0.
    pub(crate) fn new(observation: &Observation, first: usize) -> Self {
        match observation.mode() {
            ColorMode::Rgb => Self::rgb(),
            ColorMode::Spectral | ColorMode::Reference => {
                let weight = |c: usize, i: usize| observation.weight(first + c)[i] * STEP_NM;
                Self::on_nodes(Nodes::Grid, three_rows(SAMPLES, weight))
            }
            ColorMode::Sampled(count) => {
                // The bands share the grid's 97 bands of 5 nm; 97 of them are the grid itself.
                let band = SAMPLES as f64 * STEP_NM / f64::from(count);
                let start = lambda_nm(0) - 0.5 * STEP_NM;
                let nm: Row = (0..count).map(|i| start + band * (f64::from(i) + 0.5)).collect();
                let weight = |c: usize, i: usize| observation.weight(first + c).at(nm[i]) * band;
                let weights = three_rows(nm.len(), weight);
                Self::on_nodes(Nodes::Wavelengths { nm, band_nm: Some(band) }, weights)
            }
            ColorMode::Meyer => {
                let weights = MeyerSamples::published().weights;
                let weight = |c: usize, i: usize| weights[c][i] * rgb_spectra::luminance_of_equal_energy();
                let nm = NODES_NM.to_vec();
                Self::on_nodes(Nodes::Wavelengths { nm, band_nm: None }, three_rows(NODES_NM.len(), weight))
            }
            ColorMode::MeyerAdapted => {
                let count = NODES_NM.len();
                let own = |c: usize, i: usize| if i / count == c { 1.0 } else { 0.0 };
                Self::on_nodes(Nodes::MeyerPerChannel, three_rows(3 * count, own))
            }
        }
    }

    fn on_nodes(nodes: Nodes, weights: [Row; 3]) -> Self {
        let mut sampling = Self { nodes, weights, basis: Default::default() };
        sampling.basis = rgb_spectra::basis().each_ref().map(|spectrum| sampling.at_nodes(spectrum));
        sampling
    }

    /// Whether textures multiply channel by channel, as in RGB, rather than mix spectra.
    pub(crate) fn is_componentwise(&self) -> bool {
        self.nodes == Nodes::Primaries
    }

    /// The light at the nodes.
    pub(crate) fn light(&self, color: &LightColor) -> Row {
        match (&self.nodes, color) {
            (Nodes::Primaries, LightColor::Rgb(rgb)) => rgb.0.map(f64::from).to_vec(),
            (Nodes::Primaries, LightColor::Spectrum(spectrum)) => {
                rgb_spectra::rgb_of_light(spectrum).to_vec()
            }
            (_, LightColor::Rgb(rgb)) => self.light_at_nodes(&rgb_spectra::spectrum_of_light(*rgb)),
            (_, LightColor::Spectrum(spectrum)) => self.light_at_nodes(spectrum),
        }
    }

    fn light_at_nodes(&self, light: &Spectrum) -> Row {
        match self.nodes {
            Nodes::MeyerPerChannel => {
                let weights = MeyerSamples::adapted(light).weights;
                weights
                    .as_flattened()
                    .iter()
                    .map(|weight| weight * rgb_spectra::luminance_of_equal_energy())
                    .collect()
            }
            _ => self.at_nodes(light),
        }
    }

    /// What light of its own gives in the channels; `basis` is the number of a spectrum that it is
    /// multiplied with.
    pub(crate) fn emitted(&self, tint: &Tint, basis: Option<usize>) -> Triple {
        let color = match tint {
            Tint::Rgb(rgb) => LightColor::Rgb(*rgb),
            Tint::Spectrum(spectrum) => LightColor::Spectrum(spectrum.clone()),
            // Neither is light; the scene's readers refuse them here.
            _ => LightColor::BLACK,
        };
        let ones = vec![1.0; self.len()];
        self.response(&Surface::Reflectance(self.light(&color)), basis).under(&ones)
    }

    /// How the channels answer to light at each node that this tint reflects; `basis` is the number of
    /// a spectrum that the tint is multiplied with on its way out.
    pub(crate) fn response(&self, surface: &Surface, basis: Option<usize>) -> Response {
        let count = self.len();
        let weight = |c: usize, i: usize| {
            let weight = self.weights[c][i];
            basis.map_or(weight, |b| weight * self.basis[b][i])
        };
        Response(match surface {
            Surface::Reflectance(fraction) => three_rows(count, |c, i| weight(c, i) * fraction[i]),
            Surface::Matrix(rows) => {
                let mut response = three_rows(count, |_, _| 0.0);
                for (out, row) in rows.iter().enumerate() {
                    for (c, answer) in response.iter_mut().enumerate() {
                        let weight = weight(c, out);
                        answer.iter_mut().zip(row).for_each(|(sum, entry)| *sum += weight * entry);
                    }
                }
                response
            }
        })
    }

    /// A tint at the nodes; of Fresnel reflection for this cosine.
    pub(crate) fn surface(&self, tint: &Tint, cosine: f64) -> Surface {
        let primaries = self.nodes == Nodes::Primaries;
        match tint {
            Tint::Rgb(rgb) if primaries => Surface::Reflectance(rgb.0.map(f64::from).to_vec()),
            Tint::Rgb(rgb) => {
                Surface::Reflectance(self.at_nodes(&rgb_spectra::spectrum_of_reflectance(*rgb)))
            }
            Tint::Spectrum(spectrum) => Surface::Reflectance(self.reflectance(spectrum)),
            Tint::Ior(ior) => Surface::Reflectance(self.reflectance(&interfaces::boundary(ior, cosine))),
            Tint::Polarized(ior, polarization) => {
                Surface::Reflectance(self.reflectance(&interfaces::polarized(ior, *polarization, cosine)))
            }
            Tint::Film(film) => Surface::Reflectance(self.reflectance(&interfaces::film(film, cosine))),
            Tint::Pane(pane) => Surface::Reflectance(self.reflectance(&interfaces::pane(pane, cosine).0)),
            Tint::Coated(boundary) => self.coated(boundary, cosine, &Spectrum::ONE),
            Tint::Schlick(at_normal) => self.surface(at_normal, 1.0).map(|f0| fresnel_schlick(cosine, f0)),
            Tint::Reradiation(matrix) => self.reradiation(matrix),
        }
    }

    /// A boundary below a coat, of whose absorption so much is left.
    pub(crate) fn coated(&self, boundary: &CoatedBoundary, cosine: f64, left: &Spectrum) -> Surface {
        Surface::Reflectance(self.reflectance(&interfaces::coated(boundary, cosine, left)))
    }

    /// The transmittance of a surface at the nodes, along a line of sight of this cosine.
    pub(crate) fn transmittance(&self, transmittance: &Transmittance, cosine: f64) -> Surface {
        let transmitted = |spectrum: Spectrum| Surface::Reflectance(self.reflectance(&spectrum));
        match transmittance {
            Transmittance::Constant(tint) => self.surface(tint, cosine),
            Transmittance::Boundary(ior) => transmitted(interfaces::boundary(ior, cosine).map(|r| 1.0 - r)),
            Transmittance::Pane(pane) => transmitted(interfaces::pane(pane, cosine).1),
            Transmittance::Film(film) => transmitted(interfaces::film(film, cosine).map(|r| 1.0 - r)),
        }
    }

    /// What a coat leaves of light on a path of so many times its thickness, at the nodes.
    pub(crate) fn left_by(&self, depth: &Spectrum, path: f64) -> Row {
        self.reflectance(&interfaces::left(depth, path))
    }

    /// Unit light at the nodes: D65.
    pub(crate) fn white(&self) -> Row {
        self.light(&LightColor::Rgb(glanz_color::Rgb::WHITE))
    }

    /// One of the three spectra that textures and environments mix, at the nodes.
    pub(crate) fn basis(&self, number: usize) -> &Row {
        &self.basis[number]
    }

    fn reflectance(&self, spectrum: &Spectrum) -> Row {
        match self.nodes {
            Nodes::Primaries => rgb_spectra::rgb_of_reflectance(spectrum).to_vec(),
            _ => self.at_nodes(spectrum),
        }
    }

    fn reradiation(&self, matrix: &Reradiation) -> Surface {
        match &self.nodes {
            // RGB knows no other light than D65 to excite with.
            Nodes::Primaries => Surface::Reflectance(
                rgb_spectra::rgb_of_light(&matrix.apply(&rgb_spectra::daylight())).to_vec(),
            ),
            Nodes::Grid => {
                let row = |out| (0..SAMPLES).map(|input| matrix.get(out, input)).collect();
                Surface::Matrix((0..SAMPLES).map(row).collect())
            }
            Nodes::Wavelengths { nm, band_nm } => Surface::Matrix(sampled(matrix, nm, *band_nm)),
            // Four samples cannot move light between wavelengths; the diagonal is all that they see.
            Nodes::MeyerPerChannel => Surface::Reflectance(self.at_nodes(&matrix.reflectance())),
        }
    }

    fn len(&self) -> usize {
        self.weights[0].len()
    }

    fn at_nodes(&self, spectrum: &Spectrum) -> Row {
        match &self.nodes {
            Nodes::Primaries => unreachable_primaries(spectrum),
            Nodes::Grid => spectrum.0.to_vec(),
            Nodes::Wavelengths { nm, .. } => nm.iter().map(|nm| spectrum.at(*nm)).collect(),
            Nodes::MeyerPerChannel => meyer::sample(spectrum).repeat(3),
        }
    }
}

/// Spectra are reduced to RGB by their own functions for lights and for surfaces.
fn unreachable_primaries(spectrum: &Spectrum) -> Row {
    debug_assert!(false, "RGB has no wavelengths to take a spectrum at");
    rgb_spectra::rgb_of_reflectance(spectrum).to_vec()
}

/// A re-radiation matrix at some wavelengths.
fn sampled(matrix: &Reradiation, nm: &[f64], band_nm: Option<f64>) -> Vec<Row> {
    let nearest = |nm: f64| {
        let position = libm::round((nm - lambda_nm(0)) / STEP_NM).max(0.0) as usize;
        position.min(SAMPLES - 1)
    };
    let reflectance = matrix.reflectance();
    let entry = |out: usize, input: usize| {
        if out == input {
            return reflectance.at(nm[out]);
        }
        // An entry is what one band of 5 nm sends into another; both bands are wider here.
        band_nm.map_or(0.0, |band| {
            let (row, column) = (nearest(nm[out]), nearest(nm[input]));
            if row == column { 0.0 } else { matrix.get(row, column) * band / STEP_NM }
        })
    };
    (0..nm.len()).map(|out| (0..nm.len()).map(|input| entry(out, input)).collect()).collect()
}

/// What a surface does with the light at the nodes.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Surface {
    /// A fraction at each node.
    Reflectance(Row),
    /// What comes out at each node (the row) of what goes in at each.
    Matrix(Vec<Row>),
}

impl Surface {
    /// What is left of it where each node leaves a fraction: of light on its way in and on its way out half each.
    pub(crate) fn dimmed(self, left: &[f64]) -> Self {
        match self {
            Self::Reflectance(row) => Self::Reflectance(row.iter().zip(left).map(|(s, l)| s * l).collect()),
            Self::Matrix(rows) => {
                let half: Row = left.iter().map(|l| libm::sqrt(*l)).collect();
                let dim = |(row, out): (Row, &f64)| row.iter().zip(&half).map(|(s, l)| s * l * out).collect();
                Self::Matrix(rows.into_iter().zip(&half).map(dim).collect())
            }
        }
    }

    /// Another fraction for each; a matrix, which has none, stays as it is.
    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        match self {
            Self::Reflectance(row) => Self::Reflectance(row.into_iter().map(f).collect()),
            Self::Matrix(rows) => Self::Matrix(rows),
        }
    }

    /// What it does not reflect; a matrix stays as it is.
    pub(crate) fn complement(self) -> Self {
        self.map(|fraction| 1.0 - fraction)
    }
}

/// One number for each of three channels.
pub(crate) type Triple = [f64; 3];

/// How three channels answer to light at the nodes.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Response([Row; 3]);

impl Response {
    /// The channels under a light.
    pub(crate) fn under(&self, light: &[f64]) -> Triple {
        self.0.each_ref().map(|row| row.iter().zip(light).map(|(r, l)| l * r).sum())
    }
}

fn three_rows(count: usize, value: impl Fn(usize, usize) -> f64) -> [Row; 3] {
    core::array::from_fn(|c| (0..count).map(|i| value(c, i)).collect())
}
