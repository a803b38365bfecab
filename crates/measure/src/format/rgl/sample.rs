//! A table of a function, as RGL's goniometer would measure it: the distribution of normals from what comes straight back,
//! then the values where the distribution puts the nodes.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use glanz_math::Vec3;

use super::grid::{Grid, Warp};
use super::tensor::Field;
use super::{Rgl, tensor};
use crate::{Channels, ReadError};

/// Nodes of the distribution along the angle, and of the visible ones along each side.
const NODES: usize = 128;
/// Nodes of the values along each side, and angles of the light.
const SIDE: usize = 64;
const LIGHTS: usize = 16;
/// Steps of the power iteration, and of integrals around the normal.
const ROUNDS: usize = 10;
const AROUND: usize = 64;
/// The least of the distribution, as a part of its greatest: no place may be without nodes.
const FLOOR: f64 = 1e-3;
/// The least cosine with which a function is asked.
const LEAST_COSINE: f64 = 0.01;

/// The distribution of normals by its angle, and the area that it shows, both at the nodes of u.
struct Distribution {
    density: Vec<f64>,
    area: Vec<f64>,
}

/// The angle of a node of u: more of them lie near the normal.
fn angle(node: usize, nodes: usize) -> f64 {
    let u = node as f64 / (nodes - 1) as f64;
    u * u * FRAC_PI_2
}

impl Rgl {
    /// A table of a function that depends on the difference of azimuths alone: `f` gives the BRDF in 1/sr, one number per
    /// channel, for a direction to the light and one to the detector, both above the horizon.
    ///
    /// ```
    /// use glanz_math::Vec3;
    /// use glanz_measure::{Channels, Data, Measured, Rgl, write_rgl};
    ///
    /// let white = Rgl::of_function(Channels::Rgb, "white", &mut |_, _| vec![0.3; 3])?;
    /// let again = Measured::read(&write_rgl(&white), "white.bsdf", &Default::default())?;
    /// let at = |theta: f64| Vec3::from_angles(theta, 0.0);
    /// let value = again.value(at(0.5), at(0.8)).expect("both are above the horizon");
    /// assert!((value[0] - 0.3).abs() < 1e-3);
    /// # Ok::<(), glanz_measure::ReadError>(())
    /// ```
    pub fn of_function(
        channels: Channels,
        description: &str,
        f: &mut dyn FnMut(Vec3<f64>, Vec3<f64>) -> Vec<f64>,
    ) -> Result<Self, ReadError> {
        let distribution = Distribution::of(f);
        let theta_i = distribution.lights();
        let theta: Vec<f32> = theta_i.iter().map(|x| *x as f32).collect();
        let visible: Vec<f32> = theta_i.iter().flat_map(|theta| distribution.visible(*theta)).collect();
        let parameters = vec![vec![0.0], theta.clone()];
        let grid = Grid::new([NODES, NODES], parameters, visible.clone());
        let warp = Warp::new(grid.ok_or_else(|| ReadError::broken("there are no angles of the light"))?);
        let count = channels.count();
        let (mut values, mut luminance) = (Vec::new(), Vec::new());
        for theta in &theta_i {
            let table = distribution.values(*theta, &warp, count, f);
            luminance.extend(
                (0..SIDE * SIDE).map(|node| {
                    (0..count).map(|c| table[c * SIDE * SIDE + node]).sum::<f32>() / count as f32
                }),
            );
            values.extend(table);
        }
        let fields = fields(&channels, description, &distribution, [&theta, &visible, &luminance, &values]);
        Self::of(fields)
    }
}

/// The fields of a file, in their order; of the tables the angles of the light, the visible normals, the means of the
/// channels, and the values.
fn fields(
    channels: &Channels,
    description: &str,
    distribution: &Distribution,
    [theta, visible, luminance, values]: [&[f32]; 4],
) -> Vec<Field> {
    let count = channels.count();
    let two = |list: &[f64]| [list, list].concat().iter().map(|x| *x as f32).collect::<Vec<f32>>();
    let version = [1_u32, 0].iter().flat_map(|n| n.to_le_bytes()).collect();
    let mut fields = vec![
        Field { name: "version".to_owned(), kind: 5, shape: vec![2], bytes: version },
        Field::of_bytes("description", description.as_bytes()),
        Field::of_floats("phi_i", &[1], &[0.0]),
        Field::of_floats("theta_i", &[LIGHTS], theta),
        Field::of_floats("sigma", &[2, NODES], &two(&distribution.area)),
        Field::of_floats("ndf", &[2, NODES], &two(&distribution.density)),
        Field::of_floats("vndf", &[1, LIGHTS, NODES, NODES], visible),
        Field::of_floats("luminance", &[1, LIGHTS, SIDE, SIDE], luminance),
    ];
    let name = match channels {
        Channels::Wavelengths(list) => {
            let list: Vec<f32> = list.iter().map(|nm| *nm as f32).collect();
            fields.insert(4, Field::of_floats("wavelengths", &[list.len()], &list));
            "spectra"
        }
        _ => "rgb",
    };
    fields.push(Field::of_floats(name, &[1, LIGHTS, count, SIDE, SIDE], values));
    fields.push(Field::of_bytes("jacobian", &[1]));
    fields.push(Field::of_bytes("valid", &vec![u8::MAX; (LIGHTS * SIDE * SIDE).div_ceil(8)]));
    fields
}

/// The bytes of an RGL file: those of a file that was read are the same.
pub fn write_rgl(table: &Rgl) -> Vec<u8> {
    tensor::write(&table.fields)
}

impl Distribution {
    /// From what comes straight back: D(ω) is as f(ω, ω) cos ω times the area that D shows towards ω, so it is the
    /// eigenvector of that (Dupuy and others 2015), found by power iteration.
    fn of(f: &mut dyn FnMut(Vec3<f64>, Vec3<f64>) -> Vec<f64>) -> Self {
        let angles: Vec<f64> = (0..NODES).map(|node| angle(node, NODES)).collect();
        let back: Vec<f64> = angles
            .iter()
            .map(|theta| {
                let w = clamped(Vec3::from_angles(*theta, 0.0));
                let all = f(w, w);
                (all.iter().sum::<f64>() / all.len().max(1) as f64).max(0.0) * w.z
            })
            .collect();
        let kernel = kernel(&angles);
        let mut density = vec![1.0; NODES];
        for _ in 0..ROUNDS {
            let area = shown(&kernel, &density);
            density = back.iter().zip(&area).map(|(back, area)| back * area).collect();
            let most = density.iter().copied().fold(0.0, f64::max);
            density.iter_mut().for_each(|d| *d = if most > 0.0 { (*d / most).max(FLOOR) } else { 1.0 });
        }
        let area = shown(&kernel, &density);
        let scale = 1.0 / area[0];
        let scaled = |list: Vec<f64>| list.into_iter().map(|x| x * scale).collect();
        Self { density: scaled(density), area: scaled(area) }
    }

    fn at(list: &[f64], theta: f64) -> f64 {
        let at = libm::sqrt(theta / FRAC_PI_2).clamp(0.0, 1.0) * (NODES - 1) as f64;
        let node = (at as usize).min(NODES - 2);
        list[node] + (list[node + 1] - list[node]) * (at - node as f64)
    }

    /// Angles of the light at even steps of the area that is shown, the last at the horizon.
    fn lights(&self) -> Vec<f64> {
        let (first, last) = (self.area[0], self.area[NODES - 1]);
        let mut lights: Vec<f64> = Vec::with_capacity(LIGHTS);
        for light in 0..LIGHTS {
            let part = light as f64 / (LIGHTS - 1) as f64;
            let wanted = first + (last - first) * part;
            let node = self.area.iter().position(|area| *area <= wanted).unwrap_or(NODES - 1).max(1);
            let (a, b) = (self.area[node - 1], self.area[node]);
            let along = if a > b { ((a - wanted) / (a - b)).clamp(0.0, 1.0) } else { 1.0 };
            let u = (node as f64 - 1.0 + along) / (NODES - 1) as f64;
            let even = part * FRAC_PI_2;
            // Half way to even angles, so that none is left out where the area stays as it is.
            let theta = 0.5 * (u * u * FRAC_PI_2 + even);
            lights.push(lights.last().map_or(0.0, |before| theta.max(before + 1e-3)));
        }
        lights[LIGHTS - 1] = FRAC_PI_2;
        lights
    }

    /// The density of the normals that a light sees, over u and v.
    fn visible(&self, theta_i: f64) -> Vec<f32> {
        let wi = Vec3::from_angles(theta_i, 0.0);
        let area = Self::at(&self.area, theta_i);
        let mut table = Vec::with_capacity(NODES * NODES);
        for row in 0..NODES {
            let phi = row as f64 / (NODES - 1) as f64 * TAU - PI;
            for node in 0..NODES {
                let (u, theta) = (node as f64 / (NODES - 1) as f64, angle(node, NODES));
                let seen = wi.dot(Vec3::from_angles(theta, phi)).max(0.0);
                let density = 2.0 * PI * PI * u * libm::sin(theta) * seen * self.density[node] / area;
                table.push(density as f32);
            }
        }
        table
    }

    /// The values of all channels at the nodes, channel by channel.
    fn values(
        &self,
        theta_i: f64,
        warp: &Warp,
        count: usize,
        f: &mut dyn FnMut(Vec3<f64>, Vec3<f64>) -> Vec<f64>,
    ) -> Vec<f32> {
        let wi = clamped(Vec3::from_angles(theta_i, 0.0));
        let mix = warp.grid().mix(&[0.0, theta_i as f32]);
        let area = Self::at(&self.area, theta_i);
        let mut table = vec![0.0; count * SIDE * SIDE];
        for node in 0..SIDE * SIDE {
            let [s, t] = [node % SIDE, node / SIDE].map(|i| i as f32 / (SIDE - 1) as f32);
            let [u, v] = warp.place([s, t], &mix).map(f64::from);
            let theta_m = u * u * FRAC_PI_2;
            let half = Vec3::from_angles(theta_m, v * TAU - PI);
            let wo = half * (2.0 * wi.dot(half)) - wi;
            // Below the horizon stands what lies next above it: nodes there may be far from it.
            let all = f(wi, clamped(wo));
            let scale = wo.z.max(LEAST_COSINE) * 4.0 * area / Self::at(&self.density, theta_m);
            for (c, value) in all.iter().take(count).enumerate() {
                table[c * SIDE * SIDE + node] = (value * scale) as f32;
            }
        }
        table
    }
}

/// A direction at or below the horizon, brought a little above it.
fn clamped(w: Vec3<f64>) -> Vec3<f64> {
    if w.z >= LEAST_COSINE {
        return w;
    }
    let around = libm::sqrt(w.x * w.x + w.y * w.y);
    let scale = if around > 0.0 { libm::sqrt(1.0 - LEAST_COSINE * LEAST_COSINE) / around } else { 0.0 };
    Vec3::new(w.x * scale, w.y * scale, LEAST_COSINE)
}

/// How much a distribution of 1 at a node shows towards each angle, by the trapezoidal rule.
fn kernel(angles: &[f64]) -> Vec<Vec<f64>> {
    let around = |a: f64, b: f64| {
        let of = |step: usize| {
            let phi = (step as f64 + 0.5) * TAU / AROUND as f64;
            (libm::cos(a) * libm::cos(b) + libm::sin(a) * libm::sin(b) * libm::cos(phi)).max(0.0)
        };
        (0..AROUND).map(of).sum::<f64>() * TAU / AROUND as f64
    };
    let width = |node: usize| {
        let [before, after] = [node.saturating_sub(1), (node + 1).min(NODES - 1)].map(|node| angles[node]);
        0.5 * (after - before)
    };
    let row = |a: &f64| (0..NODES).map(|b| around(*a, angles[b]) * libm::sin(angles[b]) * width(b)).collect();
    angles.iter().map(row).collect()
}

fn shown(kernel: &[Vec<f64>], density: &[f64]) -> Vec<f64> {
    kernel.iter().map(|row| row.iter().zip(density).map(|(k, d)| k * d).sum()).collect()
}
