//! Measured reflectance as a shape: what certificates and plots take.

use glanz_bsdf::models::lambert::Lambert;
use glanz_bsdf::{DirectionPair, Law, LightTerm, Model, ModelInfo, Shape};
use glanz_color::{Observer, fine_light};
use glanz_math::Vec3;

use crate::{Channels, Data, FactorError, FactorOptions, Factored, Measured};

/// Nearer to the horizon there are no data.
const LEAST_COSINE: f64 = 1e-3;

impl Measured {
    /// The luminance factor under D65 as a shape: the values of a table as they are, and of readings what they are drawn
    /// as. For laws and plots; to draw in colour, [`Factored`] is the way. Each call keeps a few words of memory for good.
    ///
    /// ```
    /// use glanz_bsdf::{DirectionPair, albedo};
    /// use glanz_measure::{Measured, Merl, write_merl};
    ///
    /// let table = Merl::of(&mut |_, _| [0.2, 0.1, 0.05]);
    /// let measured = Measured::read(&write_merl(&table), "red.binary", &Default::default())?;
    /// let shape = measured.shape("red.binary")?;
    /// // Y of a linear sRGB of π (0.2, 0.1, 0.05).
    /// let y = std::f64::consts::PI * (0.2126 * 0.2 + 0.7152 * 0.1 + 0.0722 * 0.05);
    /// assert!((albedo(&shape, 0.8) - y).abs() < 0.02 * y);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`FactorError`] where readings are too few to be drawn.
    pub fn shape(&self, name: &str) -> Result<Shape, FactorError> {
        let weights = luminance_weights(self.channels());
        let sum = move |values: Vec<f64>| values.iter().zip(&weights).map(|(x, w)| x * w).sum::<f64>();
        if matches!(self.data, Data::Readings(_)) {
            let factored = Factored::of(self, &FactorOptions::default())?;
            let anisotropic = factored.table().is_anisotropic();
            return Ok(shape_of(name, anisotropic, move |wi, wo| sum(factored.value(wi, wo))));
        }
        let own = self.clone();
        let anisotropic = !self.is_isotropic();
        Ok(shape_of(name, anisotropic, move |wi, wo| own.extended(wi, wo).map_or(0.0, &sum)))
    }
}

/// What each channel counts for in Y under D65.
fn luminance_weights(channels: &Channels) -> Vec<f64> {
    let (light, observer) = (fine_light("D65").expect("D65 is in the list of lights"), Observer::default());
    let count = channels.count();
    let weight = |c: usize| {
        let factors: Vec<f64> = (0..count).map(|i| f64::from(u8::from(i == c))).collect();
        channels.xyz(&factors, &light, &observer).map_or(0.0, |[_, y, _]| y)
    };
    (0..count).map(weight).collect()
}

fn shape_of<F>(name: &str, anisotropic: bool, brdf: F) -> Shape
where
    F: Fn(Vec3<f64>, Vec3<f64>) -> f64 + Send + Sync + 'static,
{
    let name: &'static str = Box::leak(name.to_owned().into_boxed_str());
    let info = ModelInfo {
        name,
        title: name,
        formula: "measured",
        source: "a file of measured reflectance",
        params: &[],
        term: LightTerm::Specular,
        anisotropic,
        exempt: &[(
            Law::Precision,
            "data are looked up in f64, where the last bit may choose the cell; pictures take a table of factors",
        )],
        ..Lambert::INFO
    };
    let f_cos = move |_: &[f64], pair: &DirectionPair<f64>| {
        if pair.cos_i <= LEAST_COSINE || pair.cos_o <= LEAST_COSINE {
            return 0.0;
        }
        let [wi, wo] = directions(pair);
        brdf(wi, wo) * pair.cos_i
    };
    Shape::from_function(Box::leak(Box::new(info)), &[], f_cos).expect("no parameters are set")
}

/// The directions to light and viewer; of a pair without tangents the light's azimuth is 180°.
fn directions(pair: &DirectionPair<f64>) -> [Vec3<f64>; 2] {
    let (o, i) = (pair.tangent_o, pair.tangent_i);
    if [o.0, o.1, i.0, i.1].iter().any(|x| *x != 0.0) {
        return [Vec3::new(i.0, i.1, pair.cos_i), Vec3::new(o.0, o.1, pair.cos_o)];
    }
    let sine = |cosine: f64| libm::sqrt((1.0 - cosine * cosine).max(0.0));
    let (sin_i, sin_o) = (sine(pair.cos_i), sine(pair.cos_o));
    let between = (pair.cos_io - pair.cos_i * pair.cos_o) / (sin_i * sin_o).max(1e-12);
    let cosine = between.clamp(-1.0, 1.0);
    [Vec3::new(-sin_i, 0.0, pair.cos_i), Vec3::new(-sin_o * cosine, sin_o * sine(cosine), pair.cos_o)]
}
