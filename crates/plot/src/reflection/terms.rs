//! The factors D, G and F of microfacet models.

use glanz_bsdf::terms::fresnel_schlick;
use glanz_bsdf::{DirectionPair, LightTerm, Side};
use glanz_math::Vec3;

use super::lobe::Lobe;
use super::medium::Medium;
use super::plot::{LobePlot, MOST_CURVES};
use crate::chart::{Axis, Curve, LineChart, SideBySide, sampled};
use crate::page::{curve_color, curve_dash, dash};
use crate::{Error, number};

impl LobePlot {
    /// The factors D and G of microfacet models, and the Fresnel reflectance F of a medium, side by side.
    ///
    /// # Errors
    /// [`Error::NoFacets`] for a model that is not one of microfacets.
    pub fn terms(&self, medium: &Medium) -> Result<SideBySide, Error> {
        self.check_count(1, MOST_CURVES)?;
        for lobe in &self.lobes {
            let info = lobe.shape.info();
            if matches!(info.term, LightTerm::Ambient | LightTerm::Emission) {
                return Err(Error::NoDirection { model: info.name });
            }
            if lobe.shape.distribution(Vec3::new(0.0, 0.0, 1.0)).is_none() {
                return Err(Error::NoFacets { model: info.name });
            }
        }
        Ok(SideBySide {
            title: self.title("Factors of facet models"),
            subtitle: self.subtitle(""),
            charts: vec![self.distribution(), self.shadowing(), self.reflectance(medium)],
        })
    }

    /// A curve for each lobe of a value by angle.
    fn by_angle(&self, value: impl Fn(&Lobe, f64) -> f64) -> Vec<Curve> {
        let cases = self.lobes.iter().enumerate();
        let curve = |(index, lobe): (usize, &Lobe)| Curve {
            name: lobe.label.clone(),
            points: sampled(|degrees| value(lobe, degrees.to_radians()), (0.0, 90.0), &[0.0], |v| v),
            color: curve_color(index),
            dash: curve_dash(index),
        };
        cases.map(curve).collect()
    }

    fn distribution(&self) -> LineChart {
        let curves = self.by_angle(|lobe, theta| {
            lobe.shape.distribution(Vec3::from_angles(theta, self.phi_deg.to_radians())).unwrap_or(f64::NAN)
        });
        let values = || curves.iter().flat_map(|curve| curve.points.iter().map(|(_, value)| *value));
        let most = values().filter(|value| value.is_finite()).fold(0.0, f64::max);
        let y = match self.log {
            true => Axis::decades_over("D in 1/sr", values(), most),
            false => Axis::round("D in 1/sr", (0.0, most), 5),
        };
        let title = "D: facets by their normals".to_owned();
        LineChart {
            title,
            subtitle: String::new(),
            x: Axis::quarter_turn("facet from the normal in °"),
            y,
            curves,
            marks: Vec::new(),
        }
    }

    /// G where viewer and light are in the same direction. With the light at the mirror angle the half vector is
    /// the normal, and the V-cavities of Torrance and Sparrow (1967) hide nothing: G would be 1 at every angle.
    ///
    /// For transmission the light goes straight through.
    fn shadowing(&self) -> LineChart {
        let curves = self.by_angle(|lobe, theta| {
            let wo = Vec3::from_angles(theta, self.phi_deg.to_radians());
            let transmits = lobe.shape.info().side == Side::Transmission;
            let wi = if transmits { Vec3::new(-wo.x, -wo.y, -wo.z) } else { wo };
            lobe.shape.shadowing(&DirectionPair::new(wo, wi)).unwrap_or(f64::NAN)
        });
        let transmission = self.lobes.iter().all(|lobe| lobe.shape.info().side == Side::Transmission);
        let title = "G: facets seen by both".to_owned();
        let x = match transmission {
            true => Axis::quarter_turn("viewer from the normal, light straight through, in °"),
            false => Axis::quarter_turn("viewer and light, at the same place, from the normal in °"),
        };
        let y = Axis::exact("G", (0.0, 1.0), 5);
        LineChart { title, subtitle: String::new(), x, y, curves, marks: Vec::new() }
    }

    fn reflectance(&self, medium: &Medium) -> LineChart {
        let f0 = medium.reflectance(1.0);
        let cosine = |degrees: f64| libm::cos(degrees.to_radians());
        let curve = |name: String, dash, value: &dyn Fn(f64) -> f64| Curve {
            name,
            points: sampled(|degrees| value(cosine(degrees)), (0.0, 90.0), &[], |v| v),
            color: curve_color(6),
            dash,
        };
        let exact = format!("{} at {} nm", medium.name, number(self.lambda_nm));
        let curves = vec![
            curve(exact, None, &|c| medium.reflectance(c)),
            curve("Schlick 1994".to_owned(), dash(1), &|c| fresnel_schlick(c, f0)),
        ];
        let title = "F: reflectance of a facet".to_owned();
        let y = Axis::exact("F", (0.0, 1.0), 5);
        let x = Axis::quarter_turn("light from the facet's normal in °");
        LineChart { title, subtitle: String::new(), x, y, curves, marks: Vec::new() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shadowing_of_v_cavities_falls_from_45_degrees_on() {
        let plot = LobePlot::new(vec![Lobe::named("cook-torrance", &[("m", 0.2)]).unwrap()]);
        let terms = plot.terms(&Medium::named("1.5", 550.0).unwrap()).unwrap();
        let points = &terms.charts[1].curves[0].points;
        // Viewer and light at θ: G = min(1, 2 cos² θ), by hand from Cook and Torrance (1982).
        for (degrees, g) in points.iter().filter(|(degrees, _)| *degrees < 89.9) {
            let expected = (2.0 * libm::cos(degrees.to_radians()).powi(2)).min(1.0);
            assert!((g - expected).abs() < 1e-9, "{degrees}: {g}, not {expected}");
        }
    }

    #[test]
    fn a_model_without_facets_is_refused() {
        let plot = LobePlot::new(vec![Lobe::named("lambert", &[]).unwrap()]);
        let medium = Medium::named("1.5", 550.0).unwrap();
        assert!(matches!(plot.terms(&medium), Err(Error::NoFacets { model: "lambert" })));
    }
}
