//! The sum over lights and lobes with all that the classic models do not have: lobes that know a tangent, lie
//! below coats or let light through; area lights and environments; luminaires and shadows.
//!
//! It is the sum of `reflect.rs`: C = Σ_l a_l(x) · Σ_k s_k(wo, wi) · T\[l, k, c\].
//!
//! Its parts are functions of their own, once per kind of number and SIMD level: together they are so long that
//! the compiler would take minutes, and each is long enough to be worth a call.

use glanz_math::Real;

use crate::cpu::lighting::environment::Around;
use crate::cpu::lighting::light_sum::{LightSum, apart};
use crate::cpu::lighting::point::{Reflected, ShadingPoint};
use crate::cpu::lighting::shade_material::{ShadeLights, ShadeMaterial};
use crate::cpu::lighting::{area, environment, exact, punctual};
use crate::view::lights::ViewLight;

/// All light that `material` sends from `point` to the viewer, without its own emission; see
/// [`crate::cpu::lighting::reflect::reflect`].
#[inline(never)]
pub(crate) fn reflect<R: Real>(
    lights: &ShadeLights,
    material: &ShadeMaterial,
    point: &ShadingPoint<R>,
    texel: Option<[R; 3]>,
) -> Reflected<R> {
    let mut sum = LightSum::new(material, point, texel);
    let mut row = 0;
    for light in &lights.list {
        match (light, &lights.exact) {
            (ViewLight::Area(area), Some(points)) => apart(
                point.wo.x,
                #[inline(always)]
                || exact::add_area(&mut sum, lights, points, area, row),
            ),
            (ViewLight::Environment { environment, number, to_map }, Some(points)) => apart(
                point.wo.x,
                #[inline(always)]
                || {
                    let around = Around { environment, number: *number, to_map, row };
                    exact::add_environment(&mut sum, lights, points, around);
                },
            ),
            (ViewLight::Area(area), None) => apart(
                point.wo.x,
                #[inline(always)]
                || area::add(&mut sum, lights, area, row),
            ),
            (ViewLight::Environment { environment, number, to_map }, None) => apart(
                point.wo.x,
                #[inline(always)]
                || environment::add(&mut sum, Around { environment, number: *number, to_map, row }),
            ),
            (ViewLight::Directional { .. } | ViewLight::Point { .. }, _) => apart(
                point.wo.x,
                #[inline(always)]
                || punctual::add(&mut sum, lights, light, row),
            ),
        }
        row += light.rows();
    }
    sum.reflected
}
