//! Fresnel reflectance of smooth boundaries, over the angle of incidence.

use glanz_bsdf::terms::fresnel_schlick;

use super::medium::Medium;
use crate::chart::{Axis, Curve, LineChart, LineMark, sampled};
use crate::page::{curve_color, dash};
use crate::{Error, number};

/// The most media of a plot.
const MOST_MEDIA: usize = 8;

/// The reflectance of smooth boundaries from air to media, exact and by Schlick's formula, over the angle of
/// incidence.
///
/// ```
/// use glanz_plot::{Figure, FresnelPlot, Medium};
///
/// let media = vec![Medium::named("1.5", 550.0)?, Medium::named("Au", 550.0)?];
/// let svg = FresnelPlot::new(media, 550.0).chart()?.svg()?;
/// assert!(svg.contains("Brewster 56.3°"));
/// # Ok::<_, glanz_plot::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct FresnelPlot {
    /// The media, at the wavelength.
    pub media: Vec<Medium>,
    /// The wavelength of the light in nm, for the subtitle.
    pub lambda_nm: f64,
    /// Whether the axis of the reflectance is logarithmic.
    pub log: bool,
    /// Whether the two polarisations are drawn too.
    pub polarized: bool,
}

impl FresnelPlot {
    /// A plot of unpolarised reflectance on a linear axis.
    pub fn new(media: Vec<Medium>, lambda_nm: f64) -> Self {
        Self { media, lambda_nm, log: false, polarized: false }
    }

    /// The chart.
    ///
    /// # Errors
    /// [`Error::TooManyMedia`] for more than eight.
    pub fn chart(&self) -> Result<LineChart, Error> {
        if self.media.len() > MOST_MEDIA {
            return Err(Error::TooManyMedia { found: self.media.len(), most: MOST_MEDIA });
        }
        let (mut curves, mut marks) = (Vec::new(), Vec::new());
        for (index, medium) in self.media.iter().enumerate() {
            curves.extend(curves_of(medium, index, self.polarized));
            if medium.k == 0.0 && medium.eta > 1.0 {
                let x = libm::atan(medium.eta).to_degrees();
                marks.push(LineMark { x, label: format!("Brewster {x:.1}°"), color: curve_color(index) });
            }
        }
        let values = curves.iter().flat_map(|curve| curve.points.iter().map(|(_, value)| *value));
        let y = match self.log {
            true => Axis::decades_over("reflectance", values, 1.0),
            false => Axis::exact("reflectance", (0.0, 1.0), 5),
        };
        let nm = number(self.lambda_nm);
        let below = format!("of unpolarised light of {nm} nm, from air; dashed: Schlick 1994");
        Ok(LineChart {
            title: "Fresnel reflectance".to_owned(),
            subtitle: if self.polarized { format!("{below}; dotted: s above, p below") } else { below },
            x: Axis::quarter_turn("angle of incidence in °"),
            y,
            curves,
            marks,
        })
    }
}

fn curves_of(medium: &Medium, index: usize, polarized: bool) -> Vec<Curve> {
    let color = curve_color(index);
    let f0 = medium.reflectance(1.0);
    let cosine = |degrees: f64| libm::cos(degrees.to_radians());
    let curve = |name: &str, dash, value: &dyn Fn(f64) -> f64| Curve {
        name: name.to_owned(),
        points: sampled(|degrees| value(cosine(degrees)), (0.0, 90.0), &[], |v| v),
        color,
        dash,
    };
    let mut curves = vec![
        curve(&medium.name, None, &|c| medium.reflectance(c)),
        curve(&format!("{}, Schlick", medium.name), dash(1), &|c| fresnel_schlick(c, f0)),
    ];
    if polarized {
        curves.push(curve(&format!("{}, s", medium.name), dash(2), &|c| medium.polarized(c).0));
        curves.push(curve(&format!("{}, p", medium.name), dash(2), &|c| medium.polarized(c).1));
    }
    curves
}
