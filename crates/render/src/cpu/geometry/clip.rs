//! Triangles that reach behind the eye or far outside the picture.

use glam::DVec3;

use crate::cpu::frame::FrameView;
use crate::cpu::geometry::bins::Bins;
use crate::cpu::geometry::screen::{GUARD, Screen, sample_range};
use crate::view::samples::SUBPIXEL;

/// Names with this bit are indices of [`ClippedTriangle`]s, not triangles of the geometry.
pub(crate) const EXTRA: u32 = 1 << 31;

/// A little outside the guard band of the vertex pass, so that only corners that it marked are cut.
pub(crate) const OUTER_GUARD: f64 = GUARD as f64 * 1.01;

/// A triangle that clipping made of a part of another.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ClippedTriangle {
    /// The name of the triangle it is a part of.
    pub original: u32,
    /// Its corners on the screen.
    pub screen: [Screen; 3],
    /// Its corners as weights of the original's three.
    pub weights: [[f32; 3]; 3],
}

/// A corner during clipping: right, up, distance from the eye plane, and its weights.
#[derive(Clone, Copy)]
struct ClipVertex {
    at: DVec3,
    weights: DVec3,
    /// Where the vertex pass put it; none for what lies outside and for cuts.
    screen: Option<Screen>,
}

/// Cuts the triangle to what is in front of the eye and within the guard band, and bins the parts.
/// `screen` is where the vertex pass put the cluster's vertices: a corner that needs no clipping must
/// stay at exactly that place, or the edge to a neighbour that is not clipped has gaps.
pub(crate) fn clip(
    frame: &FrameView,
    name: u32,
    screen: &[Screen],
    bins: &mut Bins<u32>,
    clipped_triangles: &mut Vec<ClippedTriangle>,
) {
    let mut polygon = corners(frame, name, screen);
    for plane in planes(frame) {
        polygon = cut(&polygon, plane);
        if polygon.len() < 3 {
            return;
        }
    }
    // The farthest corner first: from there depth is interpolated, and small values bear no rounding of great ones.
    let depth = |corner: &ClipVertex| project(frame, corner)[2];
    let farthest = (0..polygon.len()).min_by(|&a, &b| depth(&polygon[a]).total_cmp(&depth(&polygon[b])));
    polygon.rotate_left(farthest.unwrap_or(0));
    let screen: Vec<Screen> = polygon.iter().map(|corner| project(frame, corner)).collect();
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

fn corners(frame: &FrameView, name: u32, screen: &[Screen]) -> Vec<ClipVertex> {
    let geometry = &frame.prepared.geometry;
    let cluster = &geometry.clusters[(name >> 7) as usize];
    let object = &frame.prepared.objects[cluster.object as usize];
    let triangle = geometry.triangles[cluster.first_triangle as usize + (name & 127) as usize];
    let [right, up, back] = frame.camera.axes().map(DVec3::from_array);
    let offset = DVec3::from_array(object.anchor) - DVec3::from_array(frame.camera.position());
    let mut weights = [DVec3::X, DVec3::Y, DVec3::Z].into_iter();
    triangle
        .iter()
        .map(|&v| {
            let vertex = cluster.first_vertex as usize + v as usize;
            let p = offset + DVec3::from_array(geometry.position.each_ref().map(|a| f64::from(a[vertex])));
            let at = DVec3::new(right.dot(p), up.dot(p), -back.dot(p));
            let screen = Some(screen[v as usize]).filter(|screen| !screen[2].is_nan());
            ClipVertex { at, weights: weights.next().expect("a triangle has three corners"), screen }
        })
        .collect()
}

/// Planes (normal, offset) whose positive side is kept: in front of the eye, inside the guard band.
fn planes(frame: &FrameView) -> [(DVec3, f64); 5] {
    let camera = &frame.camera;
    let guard = OUTER_GUARD;
    let scale = f64::from(camera.scale);
    let (cx, cy) = (f64::from(camera.center[0]), f64::from(camera.center[1]));
    let near = (DVec3::Z, -f64::from(camera.near));
    let side = |axis: DVec3, sign: f64, room: f64| match camera.perspective {
        true => (axis * sign * scale + DVec3::Z * room, 0.0),
        false => (axis * sign * scale, room),
    };
    [
        near,
        side(DVec3::X, 1.0, guard + cx),
        side(DVec3::X, -1.0, guard - cx),
        side(DVec3::Y, -1.0, guard + cy),
        side(DVec3::Y, 1.0, guard - cy),
    ]
}

/// Sutherland and Hodgman 1974: the part of the polygon on the positive side of a plane.
fn cut(polygon: &[ClipVertex], (normal, offset): (DVec3, f64)) -> Vec<ClipVertex> {
    let side = |corner: &ClipVertex| normal.dot(corner.at) + offset;
    let mut kept = Vec::with_capacity(polygon.len() + 1);
    for (i, from) in polygon.iter().enumerate() {
        let to = &polygon[(i + 1) % polygon.len()];
        let (a, b) = (side(from), side(to));
        if a >= 0.0 {
            kept.push(*from);
        }
        if (a >= 0.0) != (b >= 0.0) {
            // Always from the inner end, so that both triangles at an edge cut it at the same place.
            let (from, to, t) = if a >= 0.0 { (from, to, a / (a - b)) } else { (to, from, b / (b - a)) };
            let (at, weights) = (from.at.lerp(to.at, t), from.weights.lerp(to.weights, t));
            kept.push(ClipVertex { at, weights, screen: None });
        }
    }
    kept
}

fn project(frame: &FrameView, corner: &ClipVertex) -> Screen {
    if let Some(screen) = corner.screen {
        return screen;
    }
    let camera = &frame.camera;
    // Rounding may put a cut at the eye itself, or farther out than the planes.
    let distance = if camera.perspective { corner.at.z.max(f64::from(camera.near)) } else { corner.at.z };
    let guarded = |place: f64| place.clamp(-OUTER_GUARD, OUTER_GUARD) as f32;
    let (factor, depth) = match camera.perspective {
        true => (f64::from(camera.scale) / distance, 1.0 / distance),
        false => (f64::from(camera.scale), -distance),
    };
    let x = f64::from(camera.center[0]) + corner.at.x * factor;
    let y = f64::from(camera.center[1]) - corner.at.y * factor;
    [guarded(x), guarded(y), depth as f32, 0.0]
}

/// The first and last pixel whose samples the triangle may cover, if any.
pub(crate) fn pixels(frame: &FrameView, screen: &[Screen; 3]) -> Option<([i32; 2], [i32; 2])> {
    let size = [frame.camera.width as i32, frame.camera.height as i32];
    let (mut first, mut last) = ([0; 2], [0; 2]);
    for axis in 0..2 {
        let (least_sample, most_sample) = sample_range(frame.samples, axis);
        let fixed = screen.map(|v| fixed(v[axis]));
        let low = fixed.into_iter().fold(i32::MAX, i32::min);
        let high = fixed.into_iter().fold(i32::MIN, i32::max);
        first[axis] = ((low + SUBPIXEL - 1 - most_sample) >> 8).max(0);
        last[axis] = ((high - least_sample) >> 8).min(size[axis] - 1);
        if first[axis] > last[axis] {
            return None;
        }
    }
    Some((first, last))
}

/// A screen coordinate in 1/256 pixel, rounded as the vertex pass rounds it.
#[inline(always)]
pub(crate) fn fixed(v: f32) -> i32 {
    (v * SUBPIXEL as f32 + 0.5).floor() as i32
}
