//! What smooth boundaries reflect, over the angle of incidence.

use glanz_bsdf::terms::fresnel_schlick;

use super::sample::sampled;
use crate::failure::Failure;
use crate::lobes::{Medium, medium};
use crate::plot::{Axis, Curve, LineMark, Lines, Picture, color_of_curve, dash_of};
use crate::print::number;
use crate::spectra::words;

/// The most media of a plot.
const MAX_MEDIA: usize = 8;

/// Exact reflectance and Schlick's of media between commas.
pub fn fresnel(media: &str, nm: f64, log: bool, polarised: bool) -> Result<Picture, Failure> {
    let words = words(media).map_err(|message| Failure::Usage(format!("--ior: {message}")))?;
    if words.len() > MAX_MEDIA {
        let found = words.len();
        return Err(Failure::Usage(format!("--ior names {found} media; at most {MAX_MEDIA} are drawn")));
    }
    let media: Vec<_> = words.iter().map(|word| medium(word, nm)).collect::<Result<_, _>>()?;
    let (mut curves, mut marks) = (Vec::new(), Vec::new());
    for (index, medium) in media.iter().enumerate() {
        curves.extend(curves_of(medium, index, polarised));
        if medium.k == 0.0 && medium.eta > 1.0 {
            let x = libm::atan(medium.eta).to_degrees();
            marks.push(LineMark { x, label: format!("Brewster {x:.1}°"), color: color_of_curve(index) });
        }
    }
    let x = Axis::exact("angle of incidence in °", (0.0, 90.0), 6);
    let least = curves.iter().flat_map(|curve| curve.points.iter().map(|(_, value)| *value));
    let y = match log {
        true => super::plane::decades("reflectance", least, 1.0),
        false => Axis::exact("reflectance", (0.0, 1.0), 5),
    };
    let below = format!("of unpolarised light of {} nm, from air; dashed: Schlick 1994", number(nm));
    Ok(Lines {
        title: "Fresnel reflectance".to_owned(),
        subtitle: if polarised { format!("{below}; dotted: s above, p below") } else { below },
        x: Axis { ticks: (0..=6).map(|i| 15.0 * f64::from(i)).collect(), decimals: 0, ..x },
        y,
        curves,
        marks,
    }
    .picture())
}

fn curves_of(medium: &Medium, index: usize, polarised: bool) -> Vec<Curve> {
    let color = color_of_curve(index);
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
        curve(&format!("{}, Schlick", medium.name), dash_of(1), &|c| fresnel_schlick(c, f0)),
    ];
    if polarised {
        curves.push(curve(&format!("{}, s", medium.name), dash_of(2), &|c| medium.polarised(c).0));
        curves.push(curve(&format!("{}, p", medium.name), dash_of(2), &|c| medium.polarised(c).1));
    }
    curves
}
