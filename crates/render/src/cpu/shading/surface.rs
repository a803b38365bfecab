//! Where on a triangle pixels look, and what is there.

use glanz_math::Real;
use glanz_scene::Interpolation;

use crate::cpu::frame::{FrameView, ObjectView};
use crate::cpu::shading::triangle_setup::GROUP;
use glanz_math::inline::three;

/// The three values, at barycentric coordinates, of the attribute group with these rows.
#[inline(always)]
pub(crate) fn interpolated<R: Real>(rows: &[R; GROUP], u: R, v: R) -> [R; 3] {
    three(
        [0, 1, 2],
        #[inline(always)]
        |c| rows[c] + u * rows[3 + c] + v * rows[6 + c],
    )
}

/// The place on the surface that pixel positions show: barycentric coordinates and distance. Positions outside the
/// triangle, by rounding or because a pixel is shaded at its centre, are brought to its border.
#[inline(always)]
pub(crate) fn place<R: Real>(
    frame: &FrameView,
    object: &ObjectView,
    rows: &[R; GROUP],
    px: R,
    py: R,
) -> [R; 3] {
    let [x0, y0, ux, uy, vx, vy, ..] = *rows;
    let (dx, dy) = (px - x0, py - y0);
    let u = (dx * ux + dy * uy).clamp(0.0, 1.0);
    let v = (dx * vx + dy * vy).clamp(0.0, 1.0).min(u.one() - u);
    on_surface(frame, object, rows, u, v)
}

/// The place on the surface that shows at barycentric coordinates of the screen.
#[inline(always)]
pub(crate) fn on_surface<R: Real>(
    frame: &FrameView,
    object: &ObjectView,
    rows: &[R; GROUP],
    u: R,
    v: R,
) -> [R; 3] {
    let [.., q0, dq1, dq2] = *rows;
    let depth = q0 + u * dq1 + v * dq2;
    if !frame.camera.perspective {
        return [u, v, -depth];
    }
    let distance = depth.one() / depth;
    match object.interpolation {
        Interpolation::Perspective => [u * (q0 + dq1) * distance, v * (q0 + dq2) * distance, distance],
        _ => [u, v, distance],
    }
}
