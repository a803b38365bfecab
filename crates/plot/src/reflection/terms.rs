//! The factors D, G and F of microfacet models.

use glanz_bsdf::terms::fresnel_schlick;
use glanz_bsdf::{DirectionPair, LightTerm, Side};
use glanz_math::Vec3;

use super::lobe::Lobe;
use super::medium::Medium;
use super::plot::{LobePlot, MOST_CURVES};
use crate::Error;
use crate::chart::{Axis, Curve, LineChart, SideBySide, sampled};
use crate::page::{curve_color, curve_dash, dash};
use crate::words::Word;

impl LobePlot {
    /// The factors D and G of microfacet models, and the Fresnel reflectance F of a medium, side by side. G is that
    /// of each viewer ([`theta_deg`](Self::theta_deg)) over the direction of the light.
    ///
    /// # Errors
    /// [`Error::NoFacets`] for a model that is not one of microfacets.
    pub fn terms(&self, medium: &Medium) -> Result<SideBySide, Error> {
        self.check_angles()?;
        self.check_count(self.theta_deg.len(), MOST_CURVES)?;
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
            title: self.title(Word::Factors),
            subtitle: self.subtitle(""),
            charts: vec![self.distribution(), self.shadowing(), self.reflectance(medium)],
            lang: self.lang,
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
        let label = self.lang.say(Word::DLabel, &[]);
        let y = match self.log {
            true => Axis::decades_over(label, values(), most),
            false => Axis::round(label, (0.0, most), 5),
        };
        let x = Axis::quarter_turn(self.lang.say(Word::FacetAngle, &[]));
        let title = self.lang.say(Word::DTitle, &[]);
        LineChart { title, subtitle: String::new(), x, y, curves, marks: Vec::new(), lang: self.lang }
    }

    /// G over the angle of the light in the plane of incidence, while the viewer stays where it is. So half vectors
    /// are tilted; with the light in the mirror direction they would be the normal, where the V-cavities of Torrance
    /// and Sparrow (1967) hide nothing and G is 1 at every angle.
    ///
    /// For transmission the light is below the surface, at 0 straight below.
    fn shadowing(&self) -> LineChart {
        let mut curves = Vec::new();
        for (index, lobe) in self.lobes.iter().enumerate() {
            for (view, theta) in self.theta_deg.iter().enumerate() {
                let wo = self.wo(*theta);
                let transmits = lobe.shape.info().side == Side::Transmission;
                let value = |degrees: f64| {
                    let wi = self.in_plane(if transmits { 180.0 - degrees } else { degrees });
                    lobe.shape.shadowing(&DirectionPair::new(wo, wi)).unwrap_or(f64::NAN)
                };
                curves.push(Curve {
                    name: format!("{}, θo = {}°", lobe.label, self.lang.number(*theta)),
                    points: sampled(value, (-89.99, 89.99), &[*theta, -*theta], |v| v),
                    color: curve_color(index),
                    dash: if self.theta_deg.len() > 1 { dash(view) } else { curve_dash(index) },
                });
            }
        }
        let x = Axis::exact(self.lang.say(Word::GAxis, &[]), (-90.0, 90.0), 6);
        let ticks = (-6..=6).map(|i| 15.0 * f64::from(i)).filter(|tick| tick % 30.0 == 0.0).collect();
        let title = self.lang.say(Word::GTitle, &[]);
        let x = Axis { ticks, decimals: 0, ..x };
        LineChart {
            title,
            subtitle: String::new(),
            x,
            y: Axis::exact("G", (0.0, 1.0), 5),
            curves,
            marks: Vec::new(),
            lang: self.lang,
        }
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
        let exact = self.lang.say(Word::AtNm, &[&medium.name, &self.lang.number(self.lambda_nm)]);
        let curves = vec![
            curve(exact, None, &|c| medium.reflectance(c)),
            curve("Schlick 1994".to_owned(), dash(1), &|c| fresnel_schlick(c, f0)),
        ];
        let title = self.lang.say(Word::FTitle, &[]);
        let y = Axis::exact("F", (0.0, 1.0), 5);
        let x = Axis::quarter_turn(self.lang.say(Word::FacetIncidence, &[]));
        LineChart { title, subtitle: String::new(), x, y, curves, marks: Vec::new(), lang: self.lang }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn g(theta_deg: f64) -> Vec<(f64, f64)> {
        let plot = LobePlot::new(vec![Lobe::named("cook-torrance", &[("m", 0.2)]).unwrap()]);
        let plot = LobePlot { theta_deg: vec![theta_deg], ..plot };
        let terms = plot.terms(&Medium::named("1.5", 550.0).unwrap()).unwrap();
        terms.charts[1].curves[0].points.clone()
    }

    #[test]
    fn v_cavities_shade_and_mask_as_cook_and_torrance_say() {
        for theta in [0.0, 30.0, 60.0_f64] {
            let mut least = 1.0_f64;
            for (degrees, value) in g(theta) {
                // Cook and Torrance (1982), in the plane of incidence: the half vector is midway between both.
                let tilt = (0.5 * (degrees - theta)).to_radians();
                let to_half = (0.5 * (degrees + theta)).to_radians();
                let (view, light) = (theta.to_radians().cos(), degrees.to_radians().cos());
                let expected = (2.0 * tilt.cos() * view.min(light) / to_half.cos()).min(1.0);
                assert!((value - expected).abs() < 1e-9, "{theta}, {degrees}: {value}, not {expected}");
                least = least.min(value);
            }
            assert!(least < 0.01, "nothing is hidden at {theta}: {least}");
        }
    }

    #[test]
    fn the_viewer_decides_where_facets_are_masked() {
        assert!(g(30.0) != g(60.0));
        let plot = LobePlot::new(vec![Lobe::named("ggx", &[]).unwrap()]);
        let plot = LobePlot { theta_deg: vec![30.0, 90.0], ..plot };
        assert!(matches!(plot.terms(&Medium::named("1.5", 550.0).unwrap()), Err(Error::ViewAngle { .. })));
    }

    #[test]
    fn a_model_without_facets_is_refused() {
        let plot = LobePlot::new(vec![Lobe::named("lambert", &[]).unwrap()]);
        let medium = Medium::named("1.5", 550.0).unwrap();
        assert!(matches!(plot.terms(&medium), Err(Error::NoFacets { model: "lambert" })));
    }
}
