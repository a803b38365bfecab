//! Lobes of measured reflectance.

use std::sync::Arc;

use glanz_color::models::RgbSpace;
use glanz_color::{Outside, Spectrum, rgb_spectra};
use glanz_measure::{Channels, Factored};

use crate::{Lobe, Material, Tint};

impl Lobe {
    /// Lobes that are measured reflectance together: each is a rank of a table over a fitted shape. Their tints are spectra,
    /// in parts negative. Of surfaces with an oblique grain their x axis lies at [`Factored::aniso_deg`].
    ///
    /// ```
    /// use glanz_measure::{FactorOptions, Factored, Measured};
    /// use glanz_scene::Lobe;
    ///
    /// let mut text = String::from("theta_i_deg,phi_i_deg,theta_o_deg,phi_o_deg,r,g,b\n");
    /// for (i, o) in (0..16).flat_map(|i| (0..16).map(move |o| (5 * i, 5 * o))) {
    ///     text += &format!("{i},180,{o},0,0.2,0.1,0.05\n{i},180,{o},90,0.2,0.1,0.05\n");
    /// }
    /// let measured = Measured::read(text.as_bytes(), "red.csv", &Default::default())?;
    /// let lobes = Lobe::of_measured(&Factored::of(&measured, &FactorOptions::default())?);
    /// // A matte red is one rank over Lambert's shape.
    /// assert_eq!(lobes.last().map(|lobe| lobe.shape.info().name), Some("lambert"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn of_measured(factored: &Factored) -> Vec<Self> {
        let tint = |values: &[f64]| Tint::Spectrum(Arc::new(spectrum(factored.channels(), values)));
        let lobe = |(shape, layer, values): (_, _, Vec<f64>)| Self::new(shape, tint(&values)).under(layer);
        factored.lobes().into_iter().map(lobe).collect()
    }
}

impl Material {
    /// Measured reflectance; see [`Lobe::of_measured`].
    pub fn measured(name: impl Into<String>, factored: &Factored) -> Self {
        let aniso = factored.aniso_deg().to_radians();
        Self { aniso, ..Self::of_lobes(name, Lobe::of_measured(factored)) }
    }
}

/// The reflectance that channels are: red, green and blue as mixtures of three spectra, which negative amounts do not hurt.
fn spectrum(channels: &Channels, values: &[f64]) -> Spectrum {
    let mixed = |rgb: [f64; 3]| {
        let [r, g, b] = rgb_spectra::basis();
        Spectrum::from_fn(|nm| rgb[0] * r.at(nm) + rgb[1] * g.at(nm) + rgb[2] * b.at(nm))
    };
    match (channels, values) {
        (Channels::Luminance, [value]) => Spectrum::constant(*value),
        (Channels::Rgb, [r, g, b]) => mixed([*r, *g, *b]),
        (Channels::Xyz, [x, y, z]) => mixed(RgbSpace::LINEAR_SRGB.from_xyz_matrix().apply([*x, *y, *z])),
        (Channels::Wavelengths(nm), values) => Spectrum::from_table(nm, values, Outside::Hold)
            .expect("wavelengths of measured reflectance ascend, and tints are finite"),
        _ => Spectrum::ZERO,
    }
}
