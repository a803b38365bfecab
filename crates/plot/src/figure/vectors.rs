//! The directions of the classic lighting equation at a point of a surface: N, L, V, R and H.

use glanz_math::Vec3;

use super::projection::Projection;
use crate::chart::heading;
use crate::data::{DataCurve, DataPanel, PlotData};
use crate::page::style::{CURVES, GRAY, INK, LABEL, NUMBER, Rgb8, WHITE};
use crate::page::{Anchor, Figure, Page, Rect, letters};
use crate::words::{Lang, Word};

/// The width of the page in points.
const WIDTH: f64 = 960.0;
/// The space below the surface.
const BELOW: f64 = 52.0;
/// Where the point of the surface lies on it.
const CENTER: (f64, f64) = (350.0, 456.0);
/// The length of a direction in points.
const RADIUS: f64 = 300.0;
/// How far the eye is above the surface where not all directions are in one plane, in degrees.
const ABOVE: f64 = 22.0;
/// Azimuths that differ by less are the same, in degrees.
const SAME: f64 = 0.5;

/// A direction with its name.
#[derive(Clone, Debug, PartialEq)]
pub struct Arrow {
    /// What stands at its end.
    pub name: String,
    /// The direction, of length 1; z is along the normal.
    pub direction: [f64; 3],
    /// Its colour.
    pub color: Rgb8,
    /// Whether it is dashed: a direction that follows from others.
    pub dashed: bool,
}

/// An arc between two directions with the angle between them.
#[derive(Clone, Debug, PartialEq)]
pub struct Arc {
    /// The symbol of the angle.
    pub name: String,
    /// The directions, of length 1.
    pub ends: [[f64; 3]; 2],
    /// How far from the point it is drawn, 0 … 1.
    pub radius: f64,
}

/// Directions at a point of a surface, with their angles and the cosines of the lighting equation.
///
/// ```
/// use glanz_plot::Figure;
/// use glanz_plot::figure::VectorDrawing;
/// use glanz_plot::words::Lang;
///
/// // The light 50° from the normal, the viewer 30° on the other side.
/// let drawing = VectorDrawing::of_degrees([30.0, 180.0], [50.0, 0.0], Lang::En);
/// assert!(drawing.notes.contains(&"N·L = cos 50° = 0.642788".to_owned()));
/// assert!(drawing.notes.contains(&"R·V = cos 20° = 0.939693".to_owned()));
/// assert!(drawing.svg()?.contains(">H</text>"));
/// # Ok::<_, glanz_plot::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct VectorDrawing {
    /// What is seen.
    pub title: String,
    /// More about it, in one line.
    pub subtitle: String,
    /// The directions.
    pub arrows: Vec<Arrow>,
    /// The angles that are drawn.
    pub arcs: Vec<Arc>,
    /// Lines of text beside the drawing.
    pub notes: Vec<String>,
    /// From where it is seen: the angle above the surface and that around it, in degrees.
    pub seen_from_deg: (f64, f64),
    /// The language of the words.
    pub lang: Lang,
}

impl VectorDrawing {
    /// The directions for a viewer and a light, each by its angle from the normal and its azimuth in degrees.
    pub fn of_degrees(wo: [f64; 2], wi: [f64; 2], lang: Lang) -> Self {
        let unit = |[theta, phi]: [f64; 2]| Vec3::from_angles(theta.to_radians(), phi.to_radians());
        Self::of(unit(wo), unit(wi), lang)
    }

    /// The directions for a viewer and a light, both of length 1; z is along the normal.
    pub fn of(wo: Vec3<f64>, wi: Vec3<f64>, lang: Lang) -> Self {
        let n = Vec3::new(0.0, 0.0, 1.0);
        let r = Vec3::new(-wi.x, -wi.y, wi.z);
        let sum = wo + wi;
        // Opposite directions have no middle.
        let h = (sum.dot(sum) > 1e-18).then(|| sum.normalized());
        let arrow = |name: &str, w: Vec3<f64>, color: usize, dashed| Arrow {
            name: name.to_owned(),
            direction: [w.x, w.y, w.z],
            color: CURVES[color],
            dashed,
        };
        let mut arrows = vec![arrow("N", n, 6, false), arrow("L", wi, 4, false), arrow("V", wo, 0, false)];
        arrows.push(arrow("R", r, 1, true));
        arrows.extend(h.map(|h| arrow("H", h, 2, true)));
        let arc = |name: &str, a: Vec3<f64>, b: Vec3<f64>, radius| Arc {
            name: name.to_owned(),
            ends: [[a.x, a.y, a.z], [b.x, b.y, b.z]],
            radius,
        };
        let mut arcs = vec![arc("θ", n, wi, 0.3), arc("θ", n, r, 0.3), arc("α", r, wo, 0.62)];
        arcs.extend(h.map(|h| arc("δ", n, h, 0.78)));
        let mut notes =
            vec![cosine("N·L", n, wi, lang), cosine("N·V", n, wo, lang), cosine("R·V", r, wo, lang)];
        notes.extend(h.map(|h| cosine("N·H", n, h, lang)));
        notes.extend(h.map(|h| cosine("L·H", wi, h, lang)));
        Self {
            title: lang.say(Word::Vectors, &[]),
            subtitle: lang.say(Word::VectorsLaw, &[]),
            arrows,
            arcs,
            notes,
            seen_from_deg: seen_from(wo, wi),
            lang,
        }
    }
}

/// `N·L = cos 50° = 0.642788`.
fn cosine(name: &str, a: Vec3<f64>, b: Vec3<f64>, lang: Lang) -> String {
    let cosine = a.dot(b).clamp(-1.0, 1.0);
    format!(
        "{name} = cos {}° = {}",
        rounded(libm::acos(cosine).to_degrees(), lang),
        lang.number(clean(cosine))
    )
}

/// An angle as it is written: two decimals at most.
fn rounded(degrees: f64, lang: Lang) -> String {
    lang.number((degrees * 100.0).round() / 100.0)
}

/// Nothing in place of the rounding of a cosine that is 0.
fn clean(cosine: f64) -> f64 {
    if cosine.abs() < 1e-15 { 0.0 } else { cosine }
}

/// From where directions are seen: across the plane that they lie in, the light to the right; from above where they
/// lie in none.
fn seen_from(wo: Vec3<f64>, wi: Vec3<f64>) -> (f64, f64) {
    let azimuth = |w: Vec3<f64>| libm::atan2(w.y, w.x).to_degrees();
    let upright = |w: Vec3<f64>| libm::hypot(w.x, w.y) < 1e-9;
    match (upright(wi), upright(wo)) {
        (true, true) => return (0.0, -90.0),
        (true, false) => return (0.0, azimuth(wo) + 90.0),
        (false, true) => return (0.0, azimuth(wi) - 90.0),
        (false, false) => {}
    }
    // From the light to what lies opposite the viewer, the shorter way.
    let turn = (azimuth(wo) + 180.0 - azimuth(wi) + 540.0).rem_euclid(360.0) - 180.0;
    let in_plane = turn.abs() < SAME || (turn.abs() - 180.0).abs() < SAME;
    match in_plane {
        true => (0.0, azimuth(wi) - 90.0),
        false => (ABOVE, azimuth(wi) + 0.5 * turn - 90.0),
    }
}

impl Figure for VectorDrawing {
    fn layout(&self, _size: Option<(f64, f64)>) -> Page {
        let below = self.arrows.iter().any(|arrow| arrow.direction[2] < -1e-9);
        let tilt = libm::sin(self.seen_from_deg.0.to_radians());
        let height = CENTER.1 + BELOW + RADIUS * if below { 1.0 } else { tilt };
        let mut page = Page::new(WIDTH as u32, height as u32);
        heading(&mut page, 40.0, &self.title, &self.subtitle);
        let projection = Projection::new(CENTER, RADIUS, self.seen_from_deg);
        projection.ground(&mut page);
        if self.seen_from_deg.0 == 0.0 {
            page.line([(CENTER.0 - RADIUS, CENTER.1), (CENTER.0 + RADIUS, CENTER.1)], INK, 3.0);
        }
        let at = (CENTER.0 - RADIUS, CENTER.1 + 0.7 * RADIUS * tilt + 1.8 * NUMBER);
        page.text(self.lang.say(Word::Surface, &[]), at, Anchor::Start, NUMBER, INK);
        let labels: Vec<_> =
            self.arcs.iter().filter_map(|arc| draw_arc(&mut page, projection, arc, self.lang)).collect();
        for arrow in &self.arrows {
            draw_arrow(&mut page, projection, arrow);
        }
        for (text, at) in labels {
            label(&mut page, &text, at);
        }
        for (index, note) in self.notes.iter().enumerate() {
            let at = (CENTER.0 + RADIUS + 46.0, 120.0 + 28.0 * index as f64);
            page.text(note, at, Anchor::Start, LABEL, INK);
        }
        page
    }

    fn data(&self) -> PlotData {
        let columns = ["x", "y", "z"].map(str::to_owned).into_iter();
        let angles = [Word::AngleFromNormal, Word::AzimuthInDeg].map(|word| self.lang.say(word, &[]));
        let curve = |arrow: &Arrow| {
            let [x, y, z] = arrow.direction;
            let (theta, phi) = (libm::acos(z.clamp(-1.0, 1.0)), libm::atan2(y, x));
            let points = vec![vec![x, y, z, theta.to_degrees(), phi.to_degrees()]];
            DataCurve { name: arrow.name.clone(), points }
        };
        let panel = DataPanel {
            title: String::new(),
            columns: columns.chain(angles).collect(),
            curves: self.arrows.iter().map(curve).collect(),
        };
        PlotData::new(&self.title, &self.subtitle, vec![panel])
    }

    fn title_mut(&mut self) -> &mut String {
        &mut self.title
    }

    fn lang(&self) -> Lang {
        self.lang
    }
}

fn draw_arrow(page: &mut Page, projection: Projection, arrow: &Arrow) {
    let (from, _) = projection.apply([0.0; 3]);
    let (end, _) = projection.apply(arrow.direction);
    let (dx, dy) = (end.0 - from.0, end.1 - from.1);
    let length = libm::hypot(dx, dy).max(1e-9);
    let (ux, uy) = (dx / length, dy / length);
    match arrow.dashed {
        true => page.dashes(&[from, end], arrow.color, 2.0, (7.0, 5.0)),
        false => page.line([from, end], arrow.color, 2.4),
    }
    let corner = |back: f64, aside: f64| (end.0 - back * ux - aside * uy, end.1 - back * uy + aside * ux);
    page.area([end, corner(14.0, 5.0), corner(14.0, -5.0)], arrow.color);
    let at = (end.0 + 15.0 * ux, end.1 + 15.0 * uy + 0.36 * LABEL);
    page.text(&arrow.name, at, Anchor::Middle, LABEL + 1.0, arrow.color);
}

/// Writes an angle over what is drawn, on a piece of paper.
fn label(page: &mut Page, text: &str, (x, y): (f64, f64)) {
    let size = NUMBER - 1.5;
    let (width, height) = (letters::width(text, size) + 4.0, 1.15 * size);
    page.fill(Rect { x: x - 0.5 * width, y: y - 0.85 * size, width, height }, WHITE);
    page.text(text, (x, y), Anchor::Middle, size, GRAY);
}

/// Draws an arc of a great circle, and gives its angle and where that stands: outside of its middle.
fn draw_arc(page: &mut Page, projection: Projection, arc: &Arc, lang: Lang) -> Option<(String, (f64, f64))> {
    let [a, b] = arc.ends.map(|[x, y, z]| Vec3::new(x, y, z));
    let angle = libm::acos(a.dot(b).clamp(-1.0, 1.0));
    // Opposite directions have no arc of their own, and none is needed between equal ones.
    if !(0.01..3.13).contains(&angle) {
        return None;
    }
    let point = |part: f64| {
        let w = a * (libm::sin((1.0 - part) * angle) / libm::sin(angle))
            + b * (libm::sin(part * angle) / libm::sin(angle));
        projection.apply([arc.radius * w.x, arc.radius * w.y, arc.radius * w.z]).0
    };
    page.line((0..=32).map(|i| point(f64::from(i) / 32.0)), GRAY, 1.4);
    let ((x, y), (from, _)) = (point(0.5), projection.apply([0.0; 3]));
    let (dx, dy) = (x - from.0, y - from.1);
    let length = libm::hypot(dx, dy).max(1e-9);
    let at = (x + 24.0 * dx / length, y + 14.0 * dy / length + 0.36 * NUMBER);
    Some((format!("{} {}°", arc.name, rounded(angle.to_degrees(), lang)), at))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn r_and_h_follow_from_light_and_viewer() {
        let drawing = VectorDrawing::of_degrees([20.0, 180.0], [60.0, 0.0], Lang::En);
        let of = |name: &str| drawing.arrows.iter().find(|arrow| arrow.name == name).unwrap().direction;
        let near = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-12);
        let (sine, cosine) = 60_f64.to_radians().sin_cos();
        assert!(near(of("R"), [-sine, 0.0, cosine]));
        // Midway between 60° on one side and 20° on the other.
        let (sine, cosine) = 20_f64.to_radians().sin_cos();
        assert!(near(of("H"), [sine, 0.0, cosine]));
        assert_eq!(drawing.seen_from_deg.0, 0.0);
    }

    #[test]
    fn directions_out_of_one_plane_are_seen_from_above() {
        let drawing = VectorDrawing::of_degrees([30.0, 90.0], [50.0, 0.0], Lang::En);
        assert!(drawing.seen_from_deg.0 > 10.0);
        let opposite = VectorDrawing::of_degrees([0.0, 0.0], [180.0, 0.0], Lang::En);
        assert!(opposite.arrows.iter().all(|arrow| arrow.name != "H"));
    }
}
