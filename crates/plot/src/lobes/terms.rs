//! The factors of models of facets.

use glanz_bsdf::terms::fresnel_schlick;
use glanz_bsdf::{DirectionPair, Side};
use glanz_math::Vec3;

use super::Request;
use super::sample::sampled;
use crate::failure::{Failure, Report};
use crate::lobes::{Case, medium};
use crate::plot::{Axis, Curve, Lines, Picture, color_of_curve, dash_of, dash_of_curve, side_by_side};
use crate::print::number;

impl Request<'_> {
    /// D, G and F of each lobe, side by side.
    pub(super) fn terms(&self, ior: &str) -> Result<Picture, Failure> {
        for case in self.cases {
            if case.shape.distribution(Vec3::new(0.0, 0.0, 1.0)).is_none() {
                let name = case.shape.info().name;
                let report =
                    Report::new(format_args!("'{name}' has no factors D and G: it is not made of facets"));
                return Err(report.help("--kind polar shows its lobe").into());
            }
        }
        let plots = [self.distribution(), self.shadowing(), self.reflectance(ior)?];
        Ok(side_by_side(&self.title("Factors of facet models"), &self.subtitle(""), &plots))
    }

    /// A curve for each lobe of a value by angle.
    fn by_angle(&self, value: impl Fn(&Case, f64) -> f64) -> Vec<Curve> {
        let cases = self.cases.iter().enumerate();
        let curve = |(index, case): (usize, &Case)| Curve {
            name: case.label.clone(),
            points: sampled(|degrees| value(case, degrees.to_radians()), (0.0, 90.0), &[0.0], |v| v),
            color: color_of_curve(index),
            dash: dash_of_curve(index),
        };
        cases.map(curve).collect()
    }

    fn distribution(&self) -> Lines {
        let curves = self.by_angle(|case, theta| {
            case.shape.distribution(Vec3::from_angles(theta, self.phi.to_radians())).unwrap_or(f64::NAN)
        });
        let values = || curves.iter().flat_map(|curve| curve.points.iter().map(|(_, value)| *value));
        let most = values().filter(|value| value.is_finite()).fold(0.0, f64::max);
        let y = match self.log {
            true => super::plane::decades("D in 1/sr", values(), most),
            false => Axis::round("D in 1/sr", (0.0, most), 5),
        };
        let title = "D: facets by their normals".to_owned();
        Lines {
            title,
            subtitle: String::new(),
            x: angle("facet from the normal in °"),
            y,
            curves,
            marks: Vec::new(),
        }
    }

    /// G where viewer and light are equally far from the normal, opposite to each other.
    fn shadowing(&self) -> Lines {
        let curves = self.by_angle(|case, theta| {
            let wo = Vec3::from_angles(theta, self.phi.to_radians());
            let below = case.shape.info().side == Side::Transmission;
            let wi = Vec3::new(-wo.x, -wo.y, if below { -wo.z } else { wo.z });
            case.shape.shadowing(&DirectionPair::new(wo, wi)).unwrap_or(f64::NAN)
        });
        let title = "G: facets seen by both".to_owned();
        let y = Axis::exact("G", (0.0, 1.0), 5);
        let x = angle("viewer and light from the normal in °");
        Lines { title, subtitle: String::new(), x, y, curves, marks: Vec::new() }
    }

    fn reflectance(&self, ior: &str) -> Result<Lines, Failure> {
        let medium = medium(ior, self.nm)?;
        let f0 = medium.reflectance(1.0);
        let cosine = |degrees: f64| libm::cos(degrees.to_radians());
        let curve = |name: String, dash, value: &dyn Fn(f64) -> f64| Curve {
            name,
            points: sampled(|degrees| value(cosine(degrees)), (0.0, 90.0), &[], |v| v),
            color: color_of_curve(6),
            dash,
        };
        let curves = vec![
            curve(format!("{} at {} nm", medium.name, number(self.nm)), None, &|c| medium.reflectance(c)),
            curve("Schlick 1994".to_owned(), dash_of(1), &|c| fresnel_schlick(c, f0)),
        ];
        let title = "F: share that a facet reflects".to_owned();
        let y = Axis::exact("F", (0.0, 1.0), 5);
        let x = angle("light from the facet's normal in °");
        Ok(Lines { title, subtitle: String::new(), x, y, curves, marks: Vec::new() })
    }
}

fn angle(label: &str) -> Axis {
    let ticks = (0..=6).map(|i| 15.0 * f64::from(i)).collect();
    Axis { ticks, decimals: 0, ..Axis::exact(label, (0.0, 90.0), 6) }
}
