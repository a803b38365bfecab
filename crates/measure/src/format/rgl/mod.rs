//! RGL's files: spectra over a square that is warped by the density of visible normals, so that their nodes lie where the
//! light is (J. Dupuy, W. Jakob, An Adaptive Parameterization for Efficient Material Acquisition and Rendering, 2018).
//!
//! The numbers are f times the cosine of the detector.

mod grid;
mod sample;
mod tensor;

use core::f32::consts::{FRAC_PI_2, PI, TAU};

use glanz_math::Vec3;

use self::grid::{Grid, Warp};
use self::tensor::Field;
use super::{Data, Format, Measured, ReadOptions};
use crate::{Channels, Quantity, ReadError, Readings};
pub use sample::write_rgl;

/// The tables of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Rgl {
    channels: Channels,
    theta_i: Vec<f32>,
    phi_i: Vec<f32>,
    ndf: Grid,
    sigma: Grid,
    vndf: Warp,
    /// One table per channel, over the same parameters as `vndf`.
    spectra: Vec<Grid>,
    /// Whether the numbers are those of the table times the Jacobian of the warp.
    jacobian: bool,
    /// As they are in the file.
    fields: Vec<Field>,
}

pub(super) fn is_rgl(bytes: &[u8]) -> bool {
    bytes.starts_with(tensor::MAGIC)
}

pub(super) fn read(bytes: &[u8], options: &ReadOptions) -> Result<Measured, ReadError> {
    let fields = tensor::read(bytes)?;
    let quantity = options.quantity.unwrap_or(Quantity::BrdfCos);
    if quantity != Quantity::BrdfCos {
        let message = "RGL's files hold the BRDF times the cosine, and no other quantity";
        return Err(ReadError::broken(message));
    }
    let description = text(&fields, "description");
    let rgl = Rgl::of(fields)?;
    let mut notes = Vec::new();
    if rgl.phi_i.len() > 2 && (rgl.phi_i[rgl.phi_i.len() - 1] - rgl.phi_i[0]) < 1.9 * PI {
        notes.push("azimuths are those of a part of the circle, and are mirrored".to_owned());
    }
    let data = Data::Rgl(Box::new(rgl));
    Ok(Measured { format: Format::Rgl, quantity, description, data, notes })
}

fn field<'a>(fields: &'a [Field], name: &str) -> Result<&'a Field, ReadError> {
    let found = fields.iter().find(|field| field.name == name);
    found.ok_or_else(|| ReadError::broken(format!("there is no field '{name}', so this is no BRDF of RGL's")))
}

fn text(fields: &[Field], name: &str) -> String {
    let bytes = fields.iter().find(|field| field.name == name).map(|field| field.bytes.as_slice());
    String::from_utf8_lossy(bytes.unwrap_or_default()).trim_end_matches('\0').trim().to_owned()
}

impl Rgl {
    fn of(all: Vec<Field>) -> Result<Self, ReadError> {
        let fields = &all[..];
        let list = |name: &str| {
            let list = field(fields, name)?.floats()?;
            let ascends = list.windows(2).all(|pair| pair[0] < pair[1]) && !list.is_empty();
            match ascends && list.iter().all(|x| x.is_finite()) {
                true => Ok(list),
                false => Err(ReadError::broken(format!("the numbers of '{name}' do not ascend"))),
            }
        };
        let (theta_i, phi_i) = (list("theta_i")?, list("phi_i")?);
        let parameters = || vec![phi_i.clone(), theta_i.clone()];
        let flat = |name: &str| grid(field(fields, name)?, 0, vec![]);
        let (ndf, sigma) = (flat("ndf")?, flat("sigma")?);
        let vndf = Warp::new(grid(field(fields, "vndf")?, 2, parameters())?);
        let (name, channels) = match fields.iter().any(|field| field.name == "spectra") {
            true => {
                ("spectra", Channels::Wavelengths(list("wavelengths")?.into_iter().map(f64::from).collect()))
            }
            false => ("rgb", Channels::Rgb),
        };
        let spectra = spectra(field(fields, name)?, channels.count(), &parameters())?;
        let jacobian = fields.iter().find(|field| field.name == "jacobian");
        let jacobian = jacobian.is_none_or(|field| field.bytes.first() != Some(&0));
        Ok(Self { channels, theta_i, phi_i, ndf, sigma, vndf, spectra, jacobian, fields: all })
    }

    /// What the values belong to.
    pub fn channels(&self) -> &Channels {
        &self.channels
    }

    /// Whether the numbers depend on the difference of azimuths alone.
    pub fn is_isotropic(&self) -> bool {
        self.phi_i.len() <= 2
    }

    /// The angles of the light from the normal for which there are tables, in radians.
    pub fn theta_i(&self) -> &[f32] {
        &self.theta_i
    }

    /// The BRDF times the cosine of the detector's angle, for each channel; nothing below the horizon.
    pub fn f_cos(&self, wi: Vec3<f64>, wo: Vec3<f64>) -> Option<Vec<f64>> {
        if wi.z <= 0.0 || wo.z <= 0.0 {
            return None;
        }
        let (wi, wo) = self.mirrored(wi, wo);
        let half = (wi + wo).normalized();
        let [theta_i, phi_i] = angles(wi);
        let [theta_m, phi_m] = angles(half);
        let of_light = [u_of(theta_i), v_of(phi_i)];
        let turned = if self.is_isotropic() { phi_m - phi_i } else { phi_m };
        let of_half = [u_of(theta_m), v_of(turned) - v_of(turned).floor()];
        let setting = [phi_i, theta_i];
        let (place, _) = self.vndf.invert(of_half, &self.vndf.grid().mix(&setting));
        let scale = if self.jacobian {
            let sigma = self.sigma.at(of_light, &self.sigma.mix(&[]));
            if sigma > 0.0 { self.ndf.at(of_half, &self.ndf.mix(&[])) / (4.0 * sigma) } else { 0.0 }
        } else {
            1.0
        };
        let mix = self.vndf.grid().mix(&setting);
        // Numbers below 0 are colours outside of the gamut, and are kept.
        Some(self.spectra.iter().map(|own| f64::from(own.at(place, &mix) * scale)).collect())
    }

    /// Azimuths of a half or a quarter of the circle stand for those on the other side.
    fn mirrored(&self, wi: Vec3<f64>, wo: Vec3<f64>) -> (Vec3<f64>, Vec3<f64>) {
        let (Some(first), Some(last)) = (self.phi_i.first(), self.phi_i.last()) else { return (wi, wo) };
        let reduction = if self.is_isotropic() { 1.0 } else { (TAU / (last - first)).round() };
        let (mut wi, mut wo) = (wi, wo);
        if reduction >= 2.0 && wi.y >= 0.0 {
            (wi, wo) = (Vec3::new(-wi.x, -wi.y, wi.z), Vec3::new(-wo.x, -wo.y, wo.z));
        }
        if reduction >= 4.0 && wi.x >= 0.0 {
            (wi, wo) = (Vec3::new(-wi.x, wi.y, wi.z), Vec3::new(-wo.x, wo.y, wo.z));
        }
        (wi, wo)
    }

    /// The readings at the nodes of all tables, where the detector is above the horizon.
    pub fn readings(&self) -> Readings {
        let mut readings = Readings::new(self.channels.clone());
        let [width, height] = self.spectra[0].size();
        let azimuths: &[f32] = if self.is_isotropic() { &[PI] } else { &self.phi_i };
        for phi_i in azimuths {
            for theta_i in &self.theta_i {
                let wi = Vec3::from_angles(f64::from(*theta_i).min(1.57), f64::from(*phi_i));
                let mix = self.vndf.grid().mix(&[*phi_i, *theta_i]);
                for node in 0..width * height {
                    let [s, t] = [(node % width, width), (node / width, height)]
                        .map(|(i, n)| i as f32 / (n - 1) as f32);
                    let wo = self.outgoing(wi, *phi_i, self.vndf.place([s, t], &mix));
                    if let Some(f_cos) = self.f_cos(wi, wo).filter(|_| wo.z > 1e-3) {
                        let values: Vec<f32> = f_cos.iter().map(|value| (value / wo.z) as f32).collect();
                        readings.push(wi, wo, &values);
                    }
                }
            }
        }
        readings
    }

    /// The direction to the detector whose half vector lies at a place of the table.
    fn outgoing(&self, wi: Vec3<f64>, phi_i: f32, [u, v]: [f32; 2]) -> Vec3<f64> {
        let theta = f64::from(u * u * FRAC_PI_2);
        let phi = f64::from(v * TAU - PI) + if self.is_isotropic() { f64::from(phi_i) } else { 0.0 };
        let half = Vec3::from_angles(theta, phi);
        half * (2.0 * wi.dot(half)) - wi
    }
}

fn grid(field: &Field, parameters: usize, values: Vec<Vec<f32>>) -> Result<Grid, ReadError> {
    let wrong =
        || ReadError::broken(format!("the field '{}' has the wrong shape: {:?}", field.name, field.shape));
    let [.., height, width] = field.shape[..] else { return Err(wrong()) };
    let outer = &field.shape[..field.shape.len() - 2];
    if outer.len() != parameters || outer.iter().zip(&values).any(|(n, list)| *n != list.len()) {
        return Err(wrong());
    }
    Grid::new([width, height], values, field.floats()?).ok_or_else(wrong)
}

/// One table per channel, of [φi, θi, channel, y, x].
fn spectra(field: &Field, count: usize, parameters: &[Vec<f32>]) -> Result<Vec<Grid>, ReadError> {
    let wrong =
        || ReadError::broken(format!("the field '{}' has the wrong shape: {:?}", field.name, field.shape));
    let [phi, theta, channels, height, width] = field.shape[..] else { return Err(wrong()) };
    if [phi, theta] != [parameters[0].len(), parameters[1].len()] || channels != count {
        return Err(wrong());
    }
    let (all, table) = (field.floats()?, width * height);
    let of = |channel: usize| {
        let mut values = Vec::with_capacity(phi * theta * table);
        for setting in 0..phi * theta {
            let first = (setting * channels + channel) * table;
            values.extend_from_slice(&all[first..first + table]);
        }
        Grid::new([width, height], parameters.to_vec(), values).ok_or_else(wrong)
    };
    (0..count).map(of).collect()
}

fn angles(w: Vec3<f64>) -> [f32; 2] {
    let theta = libm::atan2(libm::sqrt(w.x * w.x + w.y * w.y), w.z);
    [theta as f32, libm::atan2(w.y, w.x) as f32]
}

fn u_of(theta: f32) -> f32 {
    (theta / FRAC_PI_2).max(0.0).sqrt()
}

fn v_of(phi: f32) -> f32 {
    (phi + PI) / TAU
}
