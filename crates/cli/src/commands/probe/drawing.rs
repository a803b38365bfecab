//! The directions at a pixel, drawn.

use glanz_math::Vec3;
use glanz_plot::Lang;
use glanz_plot::figure::VectorDrawing;
use glanz_render::{Arrival, Probe, ProbedPoint};
use glanz_scene::Scene;

use super::light;
use crate::print::failure::{Failure, Report};

/// The drawing of a light's directions: that of this number, or the first from one direction that comes from the front.
pub(super) fn of(
    probe: &Probe,
    scene: &Scene,
    wanted: Option<usize>,
    title: String,
) -> Result<VectorDrawing, Failure> {
    let (x, y) = probe.pixel;
    let point = probe.surface.as_ref().and_then(|surface| surface.points.first());
    let point =
        point.ok_or_else(|| Failure::new(format_args!("no surface is seen at {x},{y}: nothing to draw")))?;
    let arrivals = || {
        let lights = point.lights.iter();
        lights.filter_map(|found| Some((light(scene, found.light), found.arrival.as_ref()?)))
    };
    let chosen = match wanted {
        Some(number) => arrivals().find(|((own, _), _)| *own == number),
        None => arrivals().find(|(_, arrival)| arrival.cos_light > 0.0).or(arrivals().next()),
    };
    let Some(((number, kind), arrival)) = chosen else {
        let known: Vec<_> = arrivals().map(|((number, _), _)| number.to_string()).collect();
        let what = wanted.map_or("no light".to_owned(), |number| format!("no light {number}"));
        let report = Report::new(format_args!("{what} comes to {x},{y} from a single direction"));
        let help = if known.is_empty() {
            "areas and environments come from many".to_owned()
        } else {
            format!("those are: {}", known.join(", "))
        };
        return Err(report.help(help).into());
    };
    let mut drawing = directions(point, arrival);
    drawing.title = title;
    drawing.subtitle = format!("lights.{number}, {kind}");
    Ok(drawing)
}

/// N, L, V, R and H about the shading normal.
fn directions(point: &ProbedPoint, arrival: &Arrival) -> VectorDrawing {
    let double = |[x, y, z]: [f32; 3]| Vec3::new(f64::from(x), f64::from(y), f64::from(z));
    let (n, wo, wi) = (double(point.normal), double(point.to_viewer), double(arrival.to_light));
    let frame = glanz_math::Frame::around(n);
    let local = |v: Vec3<f64>| Vec3::new(frame.t.dot(v), frame.b.dot(v), n.dot(v)).normalized();
    VectorDrawing::of(local(wo), local(wi), Lang::En)
}
