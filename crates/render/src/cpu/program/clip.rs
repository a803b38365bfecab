//! Triangles that a program puts beyond the near or the far plane, behind the eye, or far outside the picture.

use glam::{DVec3, DVec4};

use super::ProgramClip;
use crate::cpu::frame::FrameView;
use crate::cpu::geometry::bins::Bins;
use crate::cpu::geometry::clip::{ClippedTriangle, EXTRA, OUTER_GUARD, pixels};
use crate::cpu::geometry::screen::Screen;

/// A corner during clipping.
#[derive(Clone, Copy)]
struct Corner {
    at: DVec4,
    weights: DVec3,
    /// Where the vertex pass put it; none for what lies outside and for cuts.
    screen: Option<Screen>,
}

/// The least w that is before the eye.
const LEAST_W: f64 = 1e-12;

/// Cuts the triangle to what clip space and the guard band hold, and bins the parts.
pub(crate) fn clip(
    frame: &FrameView,
    name: u32,
    place: ProgramClip,
    bins: &mut Bins<u32>,
    clipped_triangles: &mut Vec<ClippedTriangle>,
) {
    let mut polygon = corners(frame, name, place);
    // What is not a number is nowhere.
    if polygon.iter().any(|corner| !corner.at.is_finite()) {
        return;
    }
    for plane in planes(frame) {
        polygon = cut(&polygon, plane);
        if polygon.len() < 3 {
            return;
        }
    }
    let screen: Vec<Screen> =
        polygon.iter().map(|corner| project(frame, corner, place.depth_of_ndc)).collect();
    for i in 2..polygon.len() {
        let corner = [0, i - 1, i];
        let extra = ClippedTriangle {
            original: name,
            screen: corner.map(|c| screen[c]),
            weights: corner.map(|c| polygon[c].weights.as_vec3().to_array()),
        };
        if let Some((first, last)) = pixels(frame, &extra.screen) {
            bins.push(first, last, EXTRA | clipped_triangles.len() as u32);
            clipped_triangles.push(extra);
        }
    }
}

fn corners(frame: &FrameView, name: u32, ProgramClip { screen, clip, .. }: ProgramClip) -> Vec<Corner> {
    let geometry = &frame.prepared.geometry;
    let cluster = &geometry.clusters[(name >> 7) as usize];
    let triangle = geometry.triangles[cluster.first_triangle as usize + (name & 127) as usize];
    let corner = |(v, weights): (u8, DVec3)| {
        let own = screen[v as usize];
        let at = DVec4::from_array(clip[v as usize].map(f64::from));
        Corner { at, weights, screen: (!own[2].is_nan()).then_some(own) }
    };
    triangle.into_iter().zip([DVec3::X, DVec3::Y, DVec3::Z]).map(corner).collect()
}

/// Planes whose positive side is kept: clip space from near to far, the guard band, before the eye.
fn planes(frame: &FrameView) -> [DVec4; 7] {
    let [half_width, half_height] = frame.camera.center.map(f64::from);
    let [x, y] = [OUTER_GUARD / half_width - 1.0, OUTER_GUARD / half_height - 1.0];
    [
        DVec4::new(0.0, 0.0, 1.0, 1.0),
        DVec4::new(0.0, 0.0, -1.0, 1.0),
        DVec4::new(1.0, 0.0, 0.0, x),
        DVec4::new(-1.0, 0.0, 0.0, x),
        DVec4::new(0.0, 1.0, 0.0, y),
        DVec4::new(0.0, -1.0, 0.0, y),
        DVec4::W,
    ]
}

fn project(frame: &FrameView, corner: &Corner, depth_of_ndc: [f32; 2]) -> Screen {
    if let Some(screen) = corner.screen {
        return screen;
    }
    let [half_width, half_height] = frame.camera.center.map(f64::from);
    let inverse = 1.0 / corner.at.w.max(LEAST_W);
    let guarded = |place: f64| place.clamp(-OUTER_GUARD, OUTER_GUARD) as f32;
    let x = guarded(half_width + corner.at.x * inverse * half_width);
    let y = guarded(half_height - corner.at.y * inverse * half_height);
    let depth = (corner.at.z * inverse) as f32 * depth_of_ndc[0] + depth_of_ndc[1];
    [x, y, depth, 0.0]
}

/// Sutherland and Hodgman 1974: the part of the polygon on the positive side of a plane.
fn cut(polygon: &[Corner], plane: DVec4) -> Vec<Corner> {
    let mut kept = Vec::with_capacity(polygon.len() + 1);
    for (i, from) in polygon.iter().enumerate() {
        let to = &polygon[(i + 1) % polygon.len()];
        let (a, b) = (plane.dot(from.at), plane.dot(to.at));
        if a >= 0.0 {
            kept.push(*from);
        }
        if (a >= 0.0) != (b >= 0.0) {
            // Always from the inner end, so that both triangles at an edge cut it at the same place.
            let (from, to, t) = if a >= 0.0 { (from, to, a / (a - b)) } else { (to, from, b / (b - a)) };
            let (at, weights) = (from.at.lerp(to.at, t), from.weights.lerp(to.weights, t));
            kept.push(Corner { at, weights, screen: None });
        }
    }
    kept
}
