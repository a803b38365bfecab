//! A table of a function, as RGL's goniometer would measure it: the distribution of normals from what comes straight back,
//! then the values where the distribution puts the nodes.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use glanz_math::Vec3;

use super::grid::{Grid, Warp};
use super::tensor::Field;
use super::{Rgl, tensor};
use crate::format::LEAST_COSINE;
use crate::format::coordinates::clamped;
use crate::{Channels, ReadError};

/// How fine a table is.
#[derive(Clone, Copy)]
struct Sizes {
    /// Nodes of the distribution along the angle, and of the visible normals along each side.
    nodes: usize,
    /// Azimuths of the distribution: one, or all steps around.
    rows: usize,
    /// Nodes of the values along each side.
    side: usize,
    /// Angles and azimuths of the light.
    lights: usize,
    azimuths: usize,
}

/// What depends on the difference of azimuths alone.
const ISOTROPIC: Sizes = Sizes { nodes: 128, rows: 1, side: 64, lights: 16, azimuths: 1 };
/// What does not: coarser, or the files would have 100 MB.
const ANISOTROPIC: Sizes = Sizes { nodes: 64, rows: AROUND, side: 32, lights: 12, azimuths: 25 };

/// Steps of the power iteration, and of integrals around the normal.
const ROUNDS: usize = 10;
const AROUND: usize = 64;
/// The least of the distribution, as a part of its greatest: no place may be without nodes.
const FLOOR: f64 = 1e-3;

/// A function that gives the BRDF, one number per channel.
type Brdf<'a> = dyn FnMut(Vec3<f64>, Vec3<f64>) -> Vec<f64> + 'a;

/// The distribution of normals, and the area that it shows, row by row, each at the nodes of u.
struct Distribution {
    sizes: Sizes,
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
    pub fn of_function(channels: Channels, description: &str, f: &mut Brdf) -> Result<Self, ReadError> {
        Self::of_sizes(ISOTROPIC, channels, description, f)
    }

    /// A table of any function, as [`Rgl::of_function`]: for 25 azimuths of the light all around.
    ///
    /// ```
    /// use glanz_math::Vec3;
    /// use glanz_measure::{Channels, Rgl};
    ///
    /// let brushed = Rgl::of_anisotropic_function(Channels::Luminance, "brushed", &mut |wi, wo| {
    ///     let half = (wi + wo).normalized();
    ///     vec![0.2 + (-(half.x * half.x + 4.0 * half.y * half.y) / 0.2).exp()]
    /// });
    /// // RGL's files have three colours, or wavelengths.
    /// assert!(brushed.is_err());
    /// ```
    ///
    /// # Errors
    ///
    /// [`ReadError::Broken`] where the channels are neither RGB nor wavelengths.
    pub fn of_anisotropic_function(
        channels: Channels,
        description: &str,
        f: &mut Brdf,
    ) -> Result<Self, ReadError> {
        Self::of_sizes(ANISOTROPIC, channels, description, f)
    }

    fn of_sizes(
        sizes: Sizes,
        channels: Channels,
        description: &str,
        f: &mut Brdf,
    ) -> Result<Self, ReadError> {
        if !matches!(channels, Channels::Rgb | Channels::Wavelengths(_)) {
            return Err(ReadError::broken(format!(
                "RGL's files have RGB or wavelengths, and not {channels}"
            )));
        }
        let distribution = Distribution::of(sizes, f);
        let theta_i: Vec<f32> = distribution.lights().iter().map(|x| *x as f32).collect();
        let phi_i = sizes.phi_i();
        let lights: Vec<[f64; 2]> = phi_i
            .iter()
            .flat_map(|phi| theta_i.iter().map(|theta| [f64::from(*theta), f64::from(*phi)]))
            .collect();
        let visible: Vec<f32> = lights.iter().flat_map(|light| distribution.visible(*light)).collect();
        let parameters = vec![phi_i.clone(), theta_i.clone()];
        let grid = Grid::new([sizes.nodes, sizes.nodes], parameters, visible.clone());
        let warp = Warp::new(grid.ok_or_else(|| ReadError::broken("there are no angles of the light"))?);
        let (count, square) = (channels.count(), sizes.side * sizes.side);
        let (mut values, mut luminance) = (Vec::new(), Vec::new());
        for light in &lights {
            let table = distribution.values(*light, &warp, count, f);
            let mean = |node| (0..count).map(|c| table[c * square + node]).sum::<f32>() / count as f32;
            luminance.extend((0..square).map(mean));
            values.extend(table);
        }
        let tables = Tables { phi_i, theta_i, visible, luminance, values };
        Self::of(fields(&channels, description, &distribution, &tables))
    }
}

impl Sizes {
    /// The azimuths of the light, the last of several being the first again.
    fn phi_i(self) -> Vec<f32> {
        if self.azimuths == 1 {
            return vec![0.0];
        }
        let step = TAU / (self.azimuths - 1) as f64;
        (0..self.azimuths).map(|i| (i as f64 * step - PI) as f32).collect()
    }

    /// The azimuth of a row of the distribution.
    fn row_phi(self, row: usize) -> f64 {
        row as f64 * TAU / self.rows as f64 - PI
    }
}

/// The numbers of the fields.
struct Tables {
    phi_i: Vec<f32>,
    theta_i: Vec<f32>,
    visible: Vec<f32>,
    luminance: Vec<f32>,
    values: Vec<f32>,
}

/// The fields of a file, in their order.
fn fields(
    channels: &Channels,
    description: &str,
    distribution: &Distribution,
    tables: &Tables,
) -> Vec<Field> {
    let Sizes { nodes, rows, side, lights, azimuths } = distribution.sizes;
    let count = channels.count();
    // The first row comes again at the end of the circle.
    let closed =
        |list: &[f64]| [list, &list[..nodes]].concat().iter().map(|x| *x as f32).collect::<Vec<f32>>();
    let version = [1_u32, 0].iter().flat_map(|n| n.to_le_bytes()).collect();
    let mut fields = vec![
        Field { name: "version".to_owned(), kind: 5, shape: vec![2], bytes: version },
        Field::of_bytes("description", description.as_bytes()),
        Field::of_floats("phi_i", &[azimuths], &tables.phi_i),
        Field::of_floats("theta_i", &[lights], &tables.theta_i),
        Field::of_floats("sigma", &[rows + 1, nodes], &closed(&distribution.area)),
        Field::of_floats("ndf", &[rows + 1, nodes], &closed(&distribution.density)),
        Field::of_floats("vndf", &[azimuths, lights, nodes, nodes], &tables.visible),
        Field::of_floats("luminance", &[azimuths, lights, side, side], &tables.luminance),
    ];
    let name = match channels {
        Channels::Wavelengths(list) => {
            let list: Vec<f32> = list.iter().map(|nm| *nm as f32).collect();
            fields.insert(4, Field::of_floats("wavelengths", &[list.len()], &list));
            "spectra"
        }
        _ => "rgb",
    };
    fields.push(Field::of_floats(name, &[azimuths, lights, count, side, side], &tables.values));
    fields.push(Field::of_bytes("jacobian", &[1]));
    let valid = vec![u8::MAX; (azimuths * lights * side * side).div_ceil(8)];
    fields.push(Field::of_bytes("valid", &valid));
    fields
}

/// The bytes of an RGL file: those of a file that was read are the same.
pub fn write_rgl(table: &Rgl) -> Vec<u8> {
    tensor::write(&table.fields)
}

impl Distribution {
    /// From what comes straight back: D(ω) is as f(ω, ω) cos ω times the area that D shows towards ω, so it is the
    /// eigenvector of that (Dupuy and others 2015), found by power iteration.
    fn of(sizes: Sizes, f: &mut Brdf) -> Self {
        let angles: Vec<f64> = (0..sizes.nodes).map(|node| angle(node, sizes.nodes)).collect();
        let mut back = Vec::with_capacity(sizes.rows * sizes.nodes);
        for row in 0..sizes.rows {
            let phi = if sizes.rows == 1 { 0.0 } else { sizes.row_phi(row) };
            for theta in &angles {
                let w = clamped(Vec3::from_angles(*theta, phi));
                let all = f(w, w);
                back.push((all.iter().sum::<f64>() / all.len().max(1) as f64).max(0.0) * w.z);
            }
        }
        let kernel = kernel(&angles, sizes.rows);
        let mut density = vec![1.0; sizes.rows * sizes.nodes];
        for _ in 0..ROUNDS {
            let area = shown(&kernel, &density, sizes);
            density = back.iter().zip(&area).map(|(back, area)| back * area).collect();
            let most = density.iter().copied().fold(0.0, f64::max);
            density.iter_mut().for_each(|d| *d = if most > 0.0 { (*d / most).max(FLOOR) } else { 1.0 });
        }
        let area = shown(&kernel, &density, sizes);
        let scale = 1.0 / area[0];
        let scaled = |list: Vec<f64>| list.into_iter().map(|x| x * scale).collect();
        Self { sizes, density: scaled(density), area: scaled(area) }
    }

    /// The value of a list at a direction, linear between the nodes and the rows.
    fn at(&self, list: &[f64], [theta, phi]: [f64; 2]) -> f64 {
        let (nodes, rows) = (self.sizes.nodes, self.sizes.rows);
        let at = libm::sqrt(theta / FRAC_PI_2).clamp(0.0, 1.0) * (nodes - 1) as f64;
        let node = (at as usize).min(nodes - 2);
        let along = |row: usize| {
            let list = &list[row * nodes..(row + 1) * nodes];
            list[node] + (list[node + 1] - list[node]) * (at - node as f64)
        };
        let turn = ((phi + PI) / TAU * rows as f64).rem_euclid(rows as f64);
        let row = (turn as usize).min(rows - 1);
        let (low, high) = (along(row), along((row + 1) % rows));
        low + (high - low) * (turn - row as f64)
    }

    /// Angles of the light at even steps of the area that is shown, the last at the horizon.
    fn lights(&self) -> Vec<f64> {
        let Sizes { nodes, rows, lights: count, .. } = self.sizes;
        let mean =
            |node: usize| (0..rows).map(|row| self.area[row * nodes + node]).sum::<f64>() / rows as f64;
        let areas: Vec<f64> = (0..nodes).map(mean).collect();
        let (first, last) = (areas[0], areas[nodes - 1]);
        let mut lights: Vec<f64> = Vec::with_capacity(count);
        for light in 0..count {
            let part = light as f64 / (count - 1) as f64;
            let wanted = first + (last - first) * part;
            let node = areas.iter().position(|area| *area <= wanted).unwrap_or(nodes - 1).max(1);
            let (a, b) = (areas[node - 1], areas[node]);
            let along = if a > b { ((a - wanted) / (a - b)).clamp(0.0, 1.0) } else { 1.0 };
            let u = (node as f64 - 1.0 + along) / (nodes - 1) as f64;
            let even = part * FRAC_PI_2;
            // Half way to even angles, so that none is left out where the area stays as it is.
            let theta = 0.5 * (u * u * FRAC_PI_2 + even);
            lights.push(lights.last().map_or(0.0, |before| theta.max(before + 1e-3)));
        }
        lights[count - 1] = FRAC_PI_2;
        lights
    }

    /// The density of the normals that a light sees, over u and v.
    fn visible(&self, [theta_i, phi_i]: [f64; 2]) -> Vec<f32> {
        let nodes = self.sizes.nodes;
        let wi = Vec3::from_angles(theta_i, phi_i);
        let area = self.at(&self.area, [theta_i, phi_i]);
        let mut table = Vec::with_capacity(nodes * nodes);
        for row in 0..nodes {
            let phi = row as f64 / (nodes - 1) as f64 * TAU - PI;
            for node in 0..nodes {
                let (u, theta) = (node as f64 / (nodes - 1) as f64, angle(node, nodes));
                let seen = wi.dot(Vec3::from_angles(theta, phi)).max(0.0);
                let density = self.at(&self.density, [theta, phi]);
                table.push((2.0 * PI * PI * u * libm::sin(theta) * seen * density / area) as f32);
            }
        }
        table
    }

    /// The values of all channels at the nodes, channel by channel.
    fn values(&self, [theta_i, phi_i]: [f64; 2], warp: &Warp, count: usize, f: &mut Brdf) -> Vec<f32> {
        let side = self.sizes.side;
        let wi = clamped(Vec3::from_angles(theta_i, phi_i));
        let mix = warp.grid().mix(&[phi_i as f32, theta_i as f32]);
        let area = self.at(&self.area, [theta_i, phi_i]);
        let mut table = vec![0.0; count * side * side];
        for node in 0..side * side {
            let [s, t] = [node % side, node / side].map(|i| i as f32 / (side - 1) as f32);
            let [u, v] = warp.place([s, t], &mix).map(f64::from);
            let [theta_m, phi_m] = [u * u * FRAC_PI_2, v * TAU - PI];
            let half = Vec3::from_angles(theta_m, phi_m);
            let wo = half * (2.0 * wi.dot(half)) - wi;
            // Below the horizon stands what lies next above it: nodes there may be far from it.
            let all = f(wi, clamped(wo));
            let scale = wo.z.max(LEAST_COSINE) * 4.0 * area / self.at(&self.density, [theta_m, phi_m]);
            for (c, value) in all.iter().take(count).enumerate() {
                table[c * side * side + node] = (value * scale) as f32;
            }
        }
        table
    }
}

/// How much a distribution of 1 at a node and a step around shows towards each angle, by the trapezoidal rule: for pairs of
/// angles and differences of steps. With one row the steps are one.
fn kernel(angles: &[f64], rows: usize) -> Vec<Vec<Vec<f64>>> {
    let nodes = angles.len();
    let offset = if rows == 1 { 0.5 } else { 0.0 };
    let around = |a: f64, b: f64, step: usize| {
        let phi = (step as f64 + offset) * TAU / AROUND as f64;
        let seen = libm::cos(a) * libm::cos(b) + libm::sin(a) * libm::sin(b) * libm::cos(phi);
        seen.max(0.0) * TAU / AROUND as f64
    };
    let width = |node: usize| {
        let [before, after] = [node.saturating_sub(1), (node + 1).min(nodes - 1)].map(|node| angles[node]);
        0.5 * (after - before)
    };
    let steps = |a: f64, b: usize| {
        let all: Vec<f64> = (0..AROUND).map(|step| around(a, angles[b], step)).collect();
        let all = if rows == 1 { vec![all.iter().sum()] } else { all };
        all.iter().map(|x| x * libm::sin(angles[b]) * width(b)).collect::<Vec<f64>>()
    };
    angles.iter().map(|a| (0..nodes).map(|b| steps(*a, b)).collect()).collect()
}

/// The area that a distribution shows towards each of its nodes.
fn shown(kernel: &[Vec<Vec<f64>>], density: &[f64], sizes: Sizes) -> Vec<f64> {
    let Sizes { nodes, rows, .. } = sizes;
    let mut area = Vec::with_capacity(rows * nodes);
    for row in 0..rows {
        for of_angle in kernel {
            let mut sum = 0.0;
            for (b, steps) in of_angle.iter().enumerate() {
                for (step, k) in steps.iter().enumerate() {
                    sum += k * density[(row + step) % rows * nodes + b];
                }
            }
            area.push(sum);
        }
    }
    area
}
