//! A lobe as a body in space: in each direction as far out as it is strong.

use super::projection::Projection;
use crate::chart::heading;
use crate::data::{DataCurve, DataPanel, PlotData};
use crate::page::style::{GRAY, INK, NUMBER, Rgb8};
use crate::page::{Anchor, Figure, Page};
use crate::words::{Lang, Word};

/// The width of a panel in points.
const PANEL: f64 = 440.0;
/// The height of a panel whose bodies are above the surface, and where the middle of the surface lies in it.
const UPPER: (f64, f64) = (330.0, 230.0);
/// The same where light comes from below.
const BOTH: (f64, f64) = (440.0, 220.0);
/// The radius of the greatest value.
const RADIUS: f64 = 180.0;
/// The space above all panels.
const TOP: f64 = 84.0;
/// The space below a panel for its caption.
const CAPTION: f64 = 34.0;
/// The most panels side by side.
const COLUMNS: usize = 3;
/// From where the body is seen: the angle above the surface and that around it, in degrees.
const SEEN_FROM: (f64, f64) = (24.0, -62.0);
/// Where the light that shades the body comes from, in the space of the surface.
const LIGHT: [f64; 3] = [-0.35, -0.65, 0.68];
/// The colour of the body in full light.
const BODY: [f64; 3] = [104.0, 168.0, 222.0];
/// How bright the body is where no light falls.
const SHADE: f64 = 0.38;

/// A lobe as a body: rows and columns of points, whose columns close to a ring.
#[derive(Clone, Debug, PartialEq)]
pub struct LobeBody {
    /// What stands below it.
    pub caption: String,
    /// The points, row by row, x along the plane of incidence, z along the normal; the greatest length is 1.
    pub points: Vec<[f64; 3]>,
    /// What each point stands for: the direction of the light and the value there.
    pub values: Vec<([f64; 3], f64)>,
    /// How many points a row has.
    pub columns: usize,
    /// The direction to the viewer of the surface.
    pub view: [f64; 3],
    /// The mirror direction, or none where light passes through.
    pub mirror: Option<[f64; 3]>,
}

/// Bodies side by side.
#[derive(Clone, Debug, PartialEq)]
pub struct LobeBodies {
    /// What is seen.
    pub title: String,
    /// More about it, in one line.
    pub subtitle: String,
    /// The bodies.
    pub bodies: Vec<LobeBody>,
    /// What the values are, with their unit.
    pub label: String,
    /// The language of the names of directions.
    pub lang: Lang,
}

impl Figure for LobeBodies {
    fn layout(&self, _size: Option<(f64, f64)>) -> Page {
        let columns = self.bodies.len().clamp(1, COLUMNS);
        let rows = self.bodies.len().div_ceil(columns);
        let width = (PANEL * columns as f64 + 40.0).max(640.0);
        let below = self.bodies.iter().any(LobeBody::is_below);
        let panel = if below { BOTH } else { UPPER };
        let height = TOP + (panel.0 + CAPTION) * rows as f64;
        let mut page = Page::new(width as u32, height as u32);
        heading(&mut page, 40.0, &self.title, &self.subtitle);
        for (index, surface) in self.bodies.iter().enumerate() {
            let (row, column) = (index / columns, index % columns);
            let left = 20.0 + PANEL * column as f64;
            let top = TOP + (panel.0 + CAPTION) * row as f64;
            surface.draw(&mut page, (left, top), panel, self.lang);
        }
        page
    }

    fn data(&self) -> PlotData {
        let columns = ["x", "y", "z"].map(|axis| self.lang.say(Word::Direction, &[axis]));
        let curve = |body: &LobeBody| DataCurve {
            name: body.caption.clone(),
            points: body.values.iter().map(|([x, y, z], value)| vec![*x, *y, *z, *value]).collect(),
        };
        let panel = DataPanel {
            title: String::new(),
            columns: columns.into_iter().chain([self.label.clone()]).collect(),
            curves: self.bodies.iter().map(curve).collect(),
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

/// A face of the body, on the page.
struct Face {
    corners: [(f64, f64); 4],
    near: f64,
    color: Rgb8,
}

impl LobeBody {
    /// Whether it is below the surface.
    fn is_below(&self) -> bool {
        self.points.iter().any(|point| point[2] < -1e-9)
    }

    fn draw(&self, page: &mut Page, (left, top): (f64, f64), (height, middle): (f64, f64), lang: Lang) {
        let below = self.is_below();
        let projection = Projection::new((left + 0.5 * PANEL, top + middle), RADIUS, SEEN_FROM);
        let mut faces = self.faces(projection);
        faces.sort_by(|a, b| a.near.total_cmp(&b.near));
        // Seen from above, all that is below the surface lies behind it.
        if below {
            faces.iter().for_each(|face| paint(page, face));
        }
        projection.ground(page);
        let arrow = |page: &mut Page, to: [f64; 3], label: &str, dash: Option<(f64, f64)>| {
            let (from, _) = projection.apply([0.0; 3]);
            let (end, _) = projection.apply(to.map(|v| 1.12 * v));
            match dash {
                Some(dash) => page.dashes(&[from, end], GRAY, 1.8, dash),
                None => page.line([from, end], INK, 1.8),
            }
            page.disc(end, 3.5, if dash.is_some() { GRAY } else { INK });
            let anchor = if end.0 < from.0 { Anchor::End } else { Anchor::Start };
            let aside = if end.0 < from.0 { -8.0 } else { 8.0 };
            page.text(label, (end.0 + aside, end.1 + 4.0), anchor, NUMBER, INK);
        };
        arrow(page, self.view, &lang.say(Word::Viewer, &[]), None);
        if let Some(mirror) = self.mirror {
            arrow(page, mirror, &lang.say(Word::Mirror, &[]), Some((4.0, 4.0)));
        }
        if !below {
            faces.iter().for_each(|face| paint(page, face));
        }
        let at = (left + 0.5 * PANEL, top + height + 14.0);
        page.text(&self.caption, at, Anchor::Middle, NUMBER, INK);
    }

    fn faces(&self, projection: Projection) -> Vec<Face> {
        let rows = self.points.len() / self.columns.max(1);
        let at = |row: usize, column: usize| self.points[row * self.columns + column % self.columns];
        let mut faces = Vec::new();
        for row in 1..rows {
            for column in 0..self.columns {
                let corners =
                    [at(row - 1, column), at(row - 1, column + 1), at(row, column + 1), at(row, column)];
                // Faces in the middle, where the lobe is nothing, cover nothing.
                if corners.iter().all(|p| p.iter().map(|v| v * v).sum::<f64>() < 1e-10) {
                    continue;
                }
                let projected = corners.map(|corner| projection.apply(corner));
                faces.push(Face {
                    corners: projected.map(|(point, _)| point),
                    near: projected.iter().map(|(_, near)| near).sum::<f64>() / 4.0,
                    color: shade(corners),
                });
            }
        }
        faces
    }
}

/// Faces are drawn a little larger than they are: no gap shows between neighbours.
fn paint(page: &mut Page, face: &Face) {
    const LARGER: f64 = 0.5;
    let middle = face
        .corners
        .iter()
        .fold((0.0, 0.0), |sum, corner| (sum.0 + 0.25 * corner.0, sum.1 + 0.25 * corner.1));
    let corners = face.corners.map(|(x, y)| {
        let (dx, dy) = (x - middle.0, y - middle.1);
        let length = (dx * dx + dy * dy).sqrt().max(1e-9);
        (x + LARGER * dx / length, y + LARGER * dy / length)
    });
    page.area(corners, face.color);
}

/// The colour of a face by its normal, the same from both sides.
fn shade(corners: [[f64; 3]; 4]) -> Rgb8 {
    let minus = |a: [f64; 3], b: [f64; 3]| [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
    let (u, v) = (minus(corners[2], corners[0]), minus(corners[3], corners[1]));
    let normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let length = dot(normal, normal).sqrt().max(1e-300);
    // Outwards is away from the middle of the surface.
    let outwards = if dot(normal, corners[0]) < 0.0 { -1.0 } else { 1.0 };
    let light = (outwards * dot(normal, LIGHT) / length).max(0.0);
    BODY.map(|code| (code * (SHADE + (1.0 - SHADE) * light) * 1.1).round().clamp(0.0, 255.0) as u8)
}
