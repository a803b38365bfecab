//! Light from surfaces that shine.

use std::sync::LazyLock;

use glanz_bsdf::DirectionPair;
use glanz_math::{Frame, PI, Real, Vec3};
use glanz_scene::AreaShape;

use crate::cpu::lighting::form_factor::{above_horizon, form_factor};
use crate::cpu::lighting::light_sum::LightSum;
use crate::cpu::lighting::light_sum::apart;
use crate::cpu::lighting::light_sum::is_transmitting;
use crate::cpu::lighting::light_sum::layered;
use crate::cpu::lighting::light_sum::shape_value;
use crate::cpu::lighting::point::ShadingPoint;
use crate::cpu::lighting::shade_material::ShadeLights;
use crate::cpu::lighting::shadow;
use crate::prepare::{AreaIntegral, DirectLobe, LobeIntegrals, TintCoordinate};
use crate::view::lights::{ViewArea, splat};
use glanz_math::inline::inlined;
use glanz_math::inline::three;

/// Corners of the polygon that stands for a disk, or for what is seen of a sphere.
const ROUND: usize = 16;

/// The extent of a light over its distance below which it counts as a point: the integral is then right to its
/// square, and the rounding of the sum over its edges would be larger.
const SMALL: f64 = 0.01;

/// The extent of a light over its distance beyond which it is as good as without bounds: what it sends is right to the
/// inverse.
const LARGE: f64 = 1e5;

/// Points of the light along each of its directions, for lobes that know a tangent.
const POINTS: usize = 8;

/// The corners of a polygon with the area of the unit circle.
static RIM: LazyLock<[(f64, f64); ROUND]> = LazyLock::new(|| {
    let turn = 2.0 * PI / ROUND as f64;
    let stretch = libm::sqrt(turn / libm::sin(turn));
    core::array::from_fn(|i| {
        let (sin, cos) = libm::sincos(turn * i as f64);
        (cos * stretch, sin * stretch)
    })
});

/// Points of the unit disk that stand for equal areas of it.
static DISK: LazyLock<[(f64, f64); POINTS * POINTS]> = LazyLock::new(|| {
    core::array::from_fn(|i| {
        let step = |i: usize| (i as f64 + 0.5) / POINTS as f64;
        let (sin, cos) = libm::sincos(2.0 * PI * step(i / POINTS));
        let radius = libm::sqrt(step(i % POINTS));
        (radius * cos, radius * sin)
    })
});

/// A light as seen from a point: the corners of its outline relative to it.
struct Outline<R: Real, const N: usize> {
    corners: [Vec3<R>; N],
    /// Unit vector to its middle, and how far that is.
    middle: Vec3<R>,
    distance: R,
    /// 1 where the point is on a side that shines.
    shines: R,
    /// The solid angle of a light that is small or far.
    solid: R,
    /// Where it is so small that the sum over its edges would be rounding alone.
    small: R::Mask,
}

/// Adds what an area gives.
#[inline(always)]
pub(crate) fn add<R: Real>(sum: &mut LightSum<R>, lights: &ShadeLights, area: &ViewArea, row: usize) {
    match area.form {
        AreaShape::Rectangle { .. } => add_outline::<R, 4, 8>(sum, lights, area, row),
        _ => apart(
            sum.cos_o,
            #[inline(always)]
            || add_outline::<R, ROUND, { 2 * ROUND }>(sum, lights, area, row),
        ),
    }
}

/// The same for a light of so many corners, and twice as many.
#[inline(always)]
fn add_outline<R: Real, const N: usize, const TWICE: usize>(
    sum: &mut LightSum<R>,
    lights: &ShadeLights,
    area: &ViewArea,
    row: usize,
) {
    let outline = Outline::<R, N>::of(area, sum.point.position);
    let attenuation = attenuation(sum.point, lights, &outline);
    if !R::any(attenuation.zero().lt(attenuation)) {
        return;
    }
    let frame = view_frame(sum.point.wo, sum.point.normal, sum.cos_o);
    let mut seen = Seen { corners: outline.corners, middle: frame.to_local(outline.middle) };
    for corner in &mut seen.corners {
        *corner = frame.to_local(*corner);
    }
    let material = sum.material;
    for (k, (lobe, integrals)) in material.lobes.iter().zip(&material.integrals).enumerate() {
        let value = match &integrals.area {
            AreaIntegral::Mirror => apart(
                attenuation,
                #[inline(always)]
                || mirrored(sum, area, lobe),
            ),
            AreaIntegral::Points => apart(
                attenuation,
                #[inline(always)]
                || by_points(sum, area, lobe),
            ),
            AreaIntegral::Cosine | AreaIntegral::Ltc(_) => {
                let fraction = apart(
                    attenuation,
                    #[inline(always)]
                    || filled_fraction::<R, N, TWICE>(sum, &outline, &seen, lobe, integrals),
                );
                fraction * integrals.albedo.at(sum.cos_o, sum.tangent_o())
            }
        };
        let pair = typical_pair(sum, area, lobe);
        sum.add(row, k, value * attenuation, &pair);
    }
}

/// The pair at which the tint of a lobe is taken: of the viewer and the point of the light that is nearest to the mirrored
/// direction, since a Fresnel factor may be a multiple there of what it is towards the light.
#[inline(always)]
fn typical_pair<R: Real>(sum: &LightSum<R>, area: &ViewArea, lobe: &DirectLobe) -> DirectionPair<R> {
    if lobe.coordinate == TintCoordinate::None || is_transmitting(lobe) {
        return sum.typical_pair(lobe);
    }
    apart(
        sum.cos_o,
        #[inline(always)]
        || {
            let to = nearest(area, sum.point.position, sum.point.wo.reflected(sum.point.normal));
            sum.pair(to * to.dot(to).max(sum.cos_o.lit(1e-20)).rsqrt())
        },
    )
}

/// The way to the point of a light that is nearest to a ray, or to its middle where the ray goes away from it.
#[inline(always)]
fn nearest<R: Real>(area: &ViewArea, position: Vec3<R>, ray: Vec3<R>) -> Vec3<R> {
    let zero = position.x.zero();
    let center = splat(zero, &area.center) - position;
    if let AreaShape::Sphere { radius } = area.form {
        let off = ray * center.dot(ray).max(zero) - center;
        let length = off.dot(off).max(zero.lit(1e-20)).sqrt();
        return center + off * (zero.lit(radius) / length).min(zero.one());
    }
    let [x, y, facing] = three(
        area.axes,
        #[inline(always)]
        |axis| splat(zero, &axis),
    );
    let slope = ray.dot(facing);
    let t = center.dot(facing) / slope.select(slope.abs().gt(zero.lit(1e-20)), zero.lit(1e-20));
    // Nearly parallel rays meet the plane far away, which is as good as its rim.
    let t = t.min(zero.lit(1e6));
    let hit = ray * t - center;
    let (u, v) = (hit.dot(x), hit.dot(y));
    let (u, v) = match area.form {
        AreaShape::Rectangle { width, height } => {
            (u.clamp(-0.5 * width, 0.5 * width), v.clamp(-0.5 * height, 0.5 * height))
        }
        _ => {
            let radius = libm::sqrt(area.form.area() / PI);
            let length = (u.sqr() + v.sqr()).max(zero.lit(1e-20)).sqrt();
            let shrink = (zero.lit(radius) / length).min(zero.one());
            (u * shrink, v * shrink)
        }
    };
    let ahead = zero.lt(t);
    center + x * u.select(ahead, zero) + y * v.select(ahead, zero)
}

/// An outline in the frame of normal and viewer.
struct Seen<R, const N: usize> {
    corners: [Vec3<R>; N],
    middle: Vec3<R>,
}

/// The visibility of the light from the point; 0 behind a light with one side, and where there is no normal.
#[inline(always)]
fn attenuation<R: Real, const N: usize>(
    point: &ShadingPoint<R>,
    lights: &ShadeLights,
    outline: &Outline<R, N>,
) -> R {
    let mut attenuation = outline.shines;
    if let Some(bvh) = lights.bvh {
        attenuation = attenuation * shadow::free(bvh, point, outline.middle, Some(outline.distance));
    }
    let normal = point.normal;
    let zero = attenuation.zero();
    attenuation.select(normal.dot(normal).gt(zero.lit(0.25)), zero)
}

/// The fraction of a lobe that the light fills: its transformed cosines over what of the outline is above the horizon.
#[inline(always)]
fn filled_fraction<R: Real, const N: usize, const TWICE: usize>(
    sum: &LightSum<R>,
    outline: &Outline<R, N>,
    seen: &Seen<R, N>,
    lobe: &DirectLobe,
    integrals: &LobeIntegrals,
) -> R {
    let zero = sum.cos_o.zero();
    let below = is_transmitting(lobe);
    let turned = inlined(
        #[inline(always)]
        |v: Vec3<R>| if below { Vec3::new(v.x, v.y, -v.z) } else { v },
    );
    let mut corners = seen.corners;
    let mut lowest = zero.one();
    for corner in &mut corners {
        *corner = turned(*corner);
        lowest = lowest.min(corner.z);
    }
    let middle = turned(seen.middle);
    let lit = outline.small & zero.lt(middle.z);
    let is_cut = R::any(lowest.lt(zero));
    let mut cut = [Vec3::new(zero, zero, zero); TWICE];
    if is_cut {
        // What is below the surface's own horizon must not come up by the map.
        cut[..N].copy_from_slice(&corners);
        above_horizon(&mut cut, N);
    }
    let filled = inlined(
        #[inline(always)]
        |map: Option<&[R; 9]>| {
            let polygon = if is_cut {
                let mut cut = cut;
                for corner in &mut cut {
                    *corner = to_cosine(map, corner);
                }
                form_factor(&cut)
            } else {
                let mut corners = corners;
                for corner in &mut corners {
                    *corner = to_cosine(map, corner);
                }
                form_factor(&corners)
            };
            if !R::any(outline.small) {
                return polygon;
            }
            (density(map, &middle) * outline.solid).select(lit, polygon.select(!outline.small, zero))
        },
    );
    let AreaIntegral::Ltc(table) = &integrals.area else { return filled(None) };
    let place = table.nodes.place(sum.cos_o, sum.tangent_o());
    let (sin, cos) = middle_angle(sum.cos_o, lobe);
    let mut total = zero;
    for number in 0..table.count {
        let [a, b, c, d, e, f, g, h, i, amount] = table.at(&place, number);
        // From the frame of the mirrored direction to that of the normal.
        let row = inlined(
            #[inline(always)]
            |[x, y, z]: [R; 3]| [x * cos - z * sin, y * place.side, x * sin + z * cos],
        );
        let ([a, b, c], [d, e, f], [g, h, i]) = (row([a, b, c]), row([d, e, f]), row([g, h, i]));
        total = total + amount * filled(Some(&[a, b, c, d, e, f, g, h, i]));
    }
    total.max(zero)
}

/// Sine and cosine of the angle from the normal to the middle of a lobe: the mirrored direction, or the refracted one.
#[inline(always)]
pub(crate) fn middle_angle<R: Real>(cos_o: R, lobe: &DirectLobe) -> (R, R) {
    let one = cos_o.one();
    let sine = (one - cos_o.sqr()).max(one.zero()).sqrt();
    match is_transmitting(lobe) {
        true => {
            let sine = (sine * one.lit(1.0 / lobe.shape.eta())).min(one);
            (sine, (one - sine.sqr()).max(one.zero()).sqrt())
        }
        false => (sine, cos_o),
    }
}

/// The vector by the inverse matrix of a linearly transformed cosine; itself where the lobe is the cosine.
#[inline(always)]
fn to_cosine<R: Real>(inverse: Option<&[R; 9]>, v: &Vec3<R>) -> Vec3<R> {
    match inverse {
        Some([a, b, c, d, e, f, g, h, i]) => Vec3::new(
            *a * v.x + *b * v.y + *c * v.z,
            *d * v.x + *e * v.y + *f * v.z,
            *g * v.x + *h * v.y + *i * v.z,
        ),
        None => *v,
    }
}

/// The value of a linearly transformed cosine in a unit direction, per steradian.
#[inline(always)]
fn density<R: Real>(inverse: Option<&[R; 9]>, direction: &Vec3<R>) -> R {
    let zero = direction.z.zero();
    let (w, determinant) = match inverse {
        Some([a, b, c, d, e, f, g, h, i]) => {
            let determinant = *a * (*e * *i - *f * *h) + *b * (*f * *g - *d * *i) + *c * (*d * *h - *e * *g);
            (to_cosine(inverse, direction), determinant.abs())
        }
        None => (*direction, zero.one()),
    };
    let squared = w.dot(w).max(zero.lit(1e-30));
    w.z.max(zero) * determinant / squared.sqr() * zero.lit(1.0 / PI)
}

/// The frame around the normal whose x axis is the viewer's tangential direction.
#[inline(always)]
pub(crate) fn view_frame<R: Real>(wo: Vec3<R>, n: Vec3<R>, cos_o: R) -> Frame<R> {
    let flat = wo - n * cos_o;
    let squared = flat.dot(flat);
    let known = squared.lit(1e-10).lt(squared);
    let unit = flat * squared.max(squared.lit(1e-10)).rsqrt();
    let any = Frame::around(n).t;
    let t = Vec3::new(unit.x.select(known, any.x), unit.y.select(known, any.y), unit.z.select(known, any.z));
    Frame { t, b: n.cross(t), n }
}

/// What a perfect mirror shows: 1 where the mirrored line of sight meets the light.
#[inline(always)]
fn mirrored<R: Real>(sum: &LightSum<R>, area: &ViewArea, lobe: &DirectLobe) -> R {
    let point = sum.point;
    let zero = sum.cos_o.zero();
    if is_transmitting(lobe) {
        return zero;
    }
    let ray = point.wo.reflected(point.normal);
    let to_center = splat(zero, &area.center) - point.position;
    let along = |axis: usize, v: Vec3<R>| v.dot(splat(zero, &area.axes[axis]));
    let met = match area.form {
        AreaShape::Sphere { radius } => {
            let nearest = to_center.dot(ray);
            let off = to_center.dot(to_center) - nearest.sqr();
            off.lt(zero.lit(radius * radius)) & zero.lt(nearest)
        }
        AreaShape::Rectangle { .. } | AreaShape::Disk { .. } => {
            let slope = along(2, ray);
            let t = along(2, to_center) / slope.select(slope.abs().gt(zero.lit(1e-20)), zero.lit(1e-20));
            let hit = ray * t - to_center;
            let inside = match area.form {
                AreaShape::Rectangle { width, height } => {
                    along(0, hit).abs().lt(zero.lit(0.5 * width))
                        & along(1, hit).abs().lt(zero.lit(0.5 * height))
                }
                _ => {
                    let radius = area.form.area() / PI;
                    (along(0, hit).sqr() + along(1, hit).sqr()).lt(zero.lit(radius))
                }
            };
            inside & zero.lt(t)
        }
    };
    layered(lobe, zero.one().select(met, zero), &sum.mirror_pair())
}

/// The lobe over points of the light, each standing for its part of the outline.
#[inline(always)]
fn by_points<R: Real>(sum: &LightSum<R>, area: &ViewArea, lobe: &DirectLobe) -> R {
    let zero = sum.cos_o.zero();
    let center = splat(zero, &area.center) - sum.point.position;
    let (axes, size) = disk(area, center);
    let mut total = zero;
    for i in 0..POINTS * POINTS {
        let (u, v) = grid_point(area.form, i);
        let to = center + axes[0] * zero.lit(u) * size[0] + axes[1] * zero.lit(v) * size[1];
        let squared = to.dot(to).max(zero.lit(1e-20));
        let wi = to * squared.rsqrt();
        let facing = wi.dot(axes[2]).abs();
        let solid = size[2] * facing / squared * zero.lit(1.0 / (POINTS * POINTS) as f64);
        let pair = sum.pair(wi);
        let own = sum.own_pair(lobe, &pair);
        total = total + layered(lobe, shape_value(lobe, own.as_ref().unwrap_or(&pair)), &pair) * solid;
    }
    total
}

/// A point of a grid over −1 … 1 squared, or over the unit disk with equal areas.
fn grid_point(form: AreaShape, number: usize) -> (f64, f64) {
    let step = |i: usize| 2.0 * (i as f64 + 0.5) / POINTS as f64 - 1.0;
    match form {
        AreaShape::Rectangle { .. } => (step(number % POINTS), step(number / POINTS)),
        _ => DISK[number],
    }
}

/// The flat figure that is seen of a light: its axes, half extents along the first two, and its area.
#[inline(always)]
fn disk<R: Real>(area: &ViewArea, center: Vec3<R>) -> ([Vec3<R>; 3], [R; 3]) {
    let zero = center.x.zero();
    let own = three(
        area.axes,
        #[inline(always)]
        |axis| splat(zero, &axis),
    );
    match area.form {
        AreaShape::Rectangle { width, height } => {
            (own, [zero.lit(0.5 * width), zero.lit(0.5 * height), zero.lit(width * height)])
        }
        AreaShape::Disk { radius } => {
            (own, [zero.lit(radius), zero.lit(radius), zero.lit(PI * radius * radius)])
        }
        AreaShape::Sphere { radius } => {
            // The rim of the visible cap, seen as a disk in front of the centre.
            let squared = center.dot(center).max(zero.lit(radius * radius * 1.000_001));
            let towards = center * squared.rsqrt();
            let frame = Frame::around(towards);
            let shrink = (zero.one() - zero.lit(radius * radius) / squared).sqrt();
            // Moved to the centre it must be larger in proportion.
            let rim = zero.lit(radius) / shrink;
            ([frame.t, frame.b, towards], [rim, rim, rim.sqr() * zero.lit(PI)])
        }
    }
}

impl<R: Real, const N: usize> Outline<R, N> {
    #[inline(always)]
    fn of(area: &ViewArea, position: Vec3<R>) -> Self {
        let zero = position.x.zero();
        let center = splat(zero, &area.center) - position;
        let (axes, size) = disk(area, center);
        let squared = center.dot(center).max(zero.lit(1e-20));
        let middle = center * squared.rsqrt();
        let mut corners = [center; N];
        // In units of the distance, so that squares of far lights stay numbers.
        let inverse = squared.rsqrt();
        // Larger ones would lie in a plane through the point, for all that 32 bits tell, and fill no half of what it sees.
        let most = squared * inverse * zero.lit(LARGE);
        let half = [size[0].min(most), size[1].min(most)];
        match area.form {
            AreaShape::Rectangle { .. } => {
                for (corner, (u, v)) in
                    corners.iter_mut().zip([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)])
                {
                    *corner = center + axes[0] * half[0] * zero.lit(u) + axes[1] * half[1] * zero.lit(v);
                }
            }
            _ => {
                for (corner, (u, v)) in corners.iter_mut().zip(RIM.iter()) {
                    *corner = center + axes[0] * half[0] * zero.lit(*u) + axes[1] * half[1] * zero.lit(*v);
                }
            }
        }
        let always = area.two_sided || matches!(area.form, AreaShape::Sphere { .. });
        let faces = center.dot(splat(zero, &area.axes[2])).lt(zero);
        let shines = if always { zero.one() } else { zero.one().select(faces, zero) };
        for corner in &mut corners {
            *corner = *corner * inverse;
        }
        let extent = size[0].max(size[1]) * inverse;
        let facing = middle.dot(axes[2]).abs();
        let solid = size[2] * inverse * inverse * facing;
        let small = extent.lt(zero.lit(SMALL));
        Self { corners, middle, distance: squared.sqrt(), shines, solid, small }
    }
}
