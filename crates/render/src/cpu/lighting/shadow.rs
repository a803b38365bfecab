//! Exact hard shadows: one ray per light and pixel.

use glanz_math::{Real, Vec3};

use crate::cpu::lighting::point::ShadingPoint;
use crate::view::lights::ViewBvh;

/// How far the rounding of positions in `f32` may put a point off its surface, in parts of its distance from the eye:
/// some tens of units of the last place.
const ROUNDING: f32 = 3e-5;

/// 1 where nothing stands between the point and the light, else 0.
#[inline(always)]
pub(crate) fn free<R: Real>(
    ViewBvh { bvh, camera, pixel }: ViewBvh,
    point: &ShadingPoint<R>,
    wi: Vec3<R>,
    distance: Option<R>,
) -> R {
    let arrays = |v: Vec3<R>| [v.x.to_array(), v.y.to_array(), v.z.to_array()];
    let (position, normal, towards) = (arrays(point.position), arrays(point.normal), arrays(wi));
    let distance = distance.map_or([f32::INFINITY; 16], R::to_array);
    let mut values = [0.0; 16];
    for lane in 0..R::LANES {
        let at = |rows: &[[f32; 16]; 3]| [rows[0][lane], rows[1][lane], rows[2][lane]];
        let (p, n, w) = (at(&position), at(&normal), at(&towards));
        let cosine = n[0] * w[0] + n[1] * w[1] + n[2] * w[2];
        // Rays start on the side of the light, for surfaces that light passes too.
        let side = if cosine < 0.0 { -1.0 } else { 1.0 };
        let from = [p[0] + camera[0], p[1] + camera[1], p[2] + camera[2]];
        let from_eye = (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]).sqrt();
        let off = from_eye * ROUNDING + pixel[0] + pixel[1] * from_eye;
        let is_unoccluded = bvh.is_unoccluded((from, off), n.map(|c| c * side), w, distance[lane]);
        values[lane] = if is_unoccluded { 1.0 } else { 0.0 };
    }
    wi.x.with_array(&values)
}
