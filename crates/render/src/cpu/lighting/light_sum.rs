//! The sum of light at a point of any material, and what adds to it.

use glanz_bsdf::{DirectionPair, FactorTable, LayerWeight, Side};
use glanz_math::{Frame, Real, Vec3};
use glanz_scene::Metalness;

use crate::cpu::lighting::point::{Reflected, ShadingPoint, add, literal, mixed};
use crate::cpu::lighting::shade_material::ShadeMaterial;
use crate::prepare::{DirectLobe, LobeRoughness, MixTints, PreparedMask, TintCoordinate};

/// The least cosine of the view angle: interpolated normals may turn further away than the surface that is seen.
const LEAST_COS_O: f64 = 1e-4;

/// The light that a point sends, so far, and what it takes to add more.
pub(crate) struct LightSum<'a, R> {
    pub material: &'a ShadeMaterial<'a>,
    pub mix: Option<(&'a MixTints, [R; 3])>,
    pub point: &'a ShadingPoint<'a, R>,
    pub cos_o: R,
    /// The axes of lobes that know a tangent.
    pub axes: Option<[Vec3<R>; 2]>,
    /// How much of ambient light and of environments arrives, where a picture says it.
    pub arrives: Option<R>,
    /// The same of ambient light, times how much of the ambient terms there is.
    pub ambient: Option<R>,
    pub reflected: Reflected<R>,
}

impl<'a, R: Real> LightSum<'a, R> {
    /// What ambient light gives.
    #[inline(always)]
    pub(crate) fn new(
        material: &'a ShadeMaterial<'a>,
        point: &'a ShadingPoint<'a, R>,
        texel: Option<[R; 3]>,
    ) -> Self {
        let like = point.normal.x;
        let mix = material.mix.as_deref().zip(texel);
        let mut reflected = Reflected::ambient(like, material, &mix);
        let arrives = material.occlusion.as_ref().map(|mask| masked(material, point, mask));
        let ambient = product(arrives, of_part(material.ambient_metalness, point.metal));
        if let Some(ambient) = ambient {
            for sum in [&mut reflected.textured, &mut reflected.plain] {
                sum.iter_mut().for_each(|value| *value = *value * ambient);
            }
        }
        let cos_o = point.normal.dot(point.wo).max(like.lit(LEAST_COS_O));
        let axes = material.anisotropic.then(|| axes(material, point));
        Self { material, mix, point, cos_o, axes, arrives, ambient, reflected }
    }

    /// The pair of viewer and light.
    #[inline(always)]
    pub(crate) fn pair(&self, wi: Vec3<R>) -> DirectionPair<R> {
        let (wo, normal) = (self.point.wo, self.point.normal);
        let (cos_o, cos_i) = (normal.dot(wo), normal.dot(wi));
        let mut pair = DirectionPair::between((self.cos_o, wo), (cos_i, wi));
        // A view that is lifted to the least cosine has another half vector: else that one's cosine would be above 1 where
        // the light comes from the other side as low.
        let lift = (self.cos_o - cos_o).select(cos_o.zero().lt(cos_o), cos_o.zero());
        pair.half2 = pair.half2 + lift * (cos_o + cos_o + cos_i + cos_i + lift);
        pair.cos_io = pair.cos_io + lift * cos_i;
        pair.alpha_scale = self.point.alpha_scale;
        if let Some([x, y]) = self.axes {
            pair.tangent_o = (x.dot(wo), y.dot(wo));
            pair.tangent_i = (x.dot(wi), y.dot(wi));
        }
        pair
    }

    /// The coordinates of the viewer on the axes of lobes that know a tangent.
    #[inline(always)]
    pub(crate) fn tangent_o(&self) -> Option<[R; 2]> {
        let [x, y] = self.axes?;
        Some([x.dot(self.point.wo), y.dot(self.point.wo)])
    }

    /// The pair of the viewer and light that is mirrored to it by the surface itself.
    #[inline(always)]
    pub(crate) fn mirror_pair(&self) -> DirectionPair<R> {
        let c2 = self.cos_o.sqr();
        let mut pair = DirectionPair::isotropic(self.cos_o, self.cos_o, c2 + c2 - c2.one());
        // 2 + 2 (2 cos²θ − 1), without the rounding of 1.
        pair.half2 = c2 * c2.lit(4.0);
        pair.alpha_scale = self.point.alpha_scale;
        pair
    }

    /// The pair of the viewer and light that goes on straight to it, or refracted by a boundary of this index.
    #[inline(always)]
    pub(crate) fn straight_pair(&self, eta: f64) -> DirectionPair<R> {
        let inverse = self.cos_o.lit(1.0 / eta);
        let sin2 = (self.cos_o.one() - self.cos_o.sqr()) * inverse.sqr();
        let cos_t = (self.cos_o.one() - sin2).max(self.cos_o.zero()).sqrt();
        let cos_io = self.cos_o * (self.cos_o * inverse - cos_t) - inverse;
        let mut pair = DirectionPair::isotropic(self.cos_o, -cos_t, cos_io);
        pair.alpha_scale = self.point.alpha_scale;
        pair
    }

    /// The pair that stands for all light that a lobe takes from areas and environments.
    #[inline(always)]
    pub(crate) fn typical_pair(&self, lobe: &DirectLobe) -> DirectionPair<R> {
        match is_transmitting(lobe) {
            true => self.straight_pair(lobe.shape.eta()),
            false => self.mirror_pair(),
        }
    }

    /// How much of a lobe there is at the point.
    #[inline(always)]
    pub(crate) fn fraction(&self, lobe: &DirectLobe) -> Option<R> {
        let mut fraction = of_part(lobe.metalness, self.point.metal);
        for mask in &lobe.masks {
            fraction = product(fraction, Some(masked(self.material, self.point, mask)));
        }
        fraction
    }

    /// The factor of a lobe's width.
    #[inline(always)]
    pub(crate) fn width(&self, lobe: &DirectLobe) -> R {
        match lobe.roughness {
            LobeRoughness::Material => self.point.alpha_scale,
            LobeRoughness::Uniform => self.cos_o.one(),
            // The width of a lobe is the square of its roughness.
            LobeRoughness::Channel(number) => channel(self.material, self.point, number).sqr(),
        }
    }

    /// The pair as a lobe has it that is not as rough as the material's picture says; none where it is.
    #[inline(always)]
    pub(crate) fn own_pair(&self, lobe: &DirectLobe, pair: &DirectionPair<R>) -> Option<DirectionPair<R>> {
        match lobe.roughness {
            LobeRoughness::Material => None,
            _ => Some(DirectionPair { alpha_scale: self.width(lobe), ..*pair }),
        }
    }

    /// Adds a lobe's value for a light of the table; the pair says where a tint that is a curve is taken.
    #[inline(never)]
    pub(crate) fn add(&mut self, row: usize, lobe: usize, value: R, pair: &DirectionPair<R>) {
        value.at_own_level(
            #[inline(always)]
            || self.add_here(row, lobe, value, pair),
        );
    }

    #[inline(always)]
    fn add_here(&mut self, row: usize, lobe: usize, value: R, pair: &DirectionPair<R>) {
        let material = self.material;
        let entry = row * material.lobes.len() + lobe;
        let lobe = &material.lobes[lobe];
        let tint = match &self.mix {
            _ if lobe.coordinate != TintCoordinate::None => {
                material.series[entry].at(lobe.coordinate.at(&lobe.shape, pair))
            }
            Some((mix, texel)) if lobe.textured => mixed(&mix.tints[entry], texel),
            _ => literal(value, &material.tints[entry]),
        };
        let value = match self.fraction(lobe) {
            Some(fraction) => value * fraction,
            None => value,
        };
        let reflected = &mut self.reflected;
        add(if lobe.textured { &mut reflected.textured } else { &mut reflected.plain }, value, tint);
    }
}

/// How much of a part of the surface there is.
#[inline(always)]
fn of_part<R: Real>(part: Metalness, metal: R) -> Option<R> {
    match part {
        Metalness::Any => None,
        Metalness::Metal { factor } => Some(metal * metal.lit(factor)),
        Metalness::Dielectric { factor } => Some(metal.one() - metal * metal.lit(factor)),
    }
}

/// The product of factors that may not be there.
#[inline(always)]
fn product<R: Real>(a: Option<R>, b: Option<R>) -> Option<R> {
    match (a, b) {
        (Some(a), Some(b)) => Some(a * b),
        (one, None) | (None, one) => one,
    }
}

/// What a picture says here, or on the whole.
#[inline(always)]
fn channel<R: Real>(material: &ShadeMaterial, point: &ShadingPoint<R>, number: usize) -> R {
    match point.channels.get(number) {
        Some(value) => *value,
        None => point.metal.lit(f64::from(material.means.channels[number])),
    }
}

/// The factor that a mask is here.
#[inline(always)]
fn masked<R: Real>(material: &ShadeMaterial, point: &ShadingPoint<R>, mask: &PreparedMask) -> R {
    let said = channel(material, point, mask.channel);
    said.lit(mask.from) + said * said.lit(mask.to - mask.from)
}

/// The x and y axis of a lobe's frame: the surface's tangent, laid into the plane of the normal and turned.
/// Without one, x runs around the vertical.
#[inline(always)]
fn axes<R: Real>(material: &ShadeMaterial, point: &ShadingPoint<R>) -> [Vec3<R>; 2] {
    let n = point.normal;
    let zero = n.x.zero();
    let tangent = point.tangent.unwrap_or(Vec3::new(n.z, zero, -n.x));
    let flat = tangent - n * n.dot(tangent);
    let squared = flat.dot(flat);
    let known = squared.lit(1e-12).lt(squared);
    let any = Frame::around(n).t;
    let unit = flat * squared.max(squared.lit(1e-12)).rsqrt();
    let x = Vec3::new(unit.x.select(known, any.x), unit.y.select(known, any.y), unit.z.select(known, any.z));
    let y = n.cross(x);
    let (sin, cos) = (zero.lit(material.aniso[0]), zero.lit(material.aniso[1]));
    [x * cos + y * sin, y * cos - x * sin]
}

/// What `f` gives, as a function of its own at the lanes' SIMD level.
#[inline(never)]
pub(crate) fn apart<R: Real, T>(like: R, f: impl FnOnce() -> T) -> T {
    like.at_own_level(f)
}

/// A lobe's value under its layers, without its tint.
#[inline(never)]
pub(crate) fn layered<R: Real>(lobe: &DirectLobe, mut value: R, pair: &DirectionPair<R>) -> R {
    if lobe.layers.is_empty() {
        return value;
    }
    value.at_own_level(
        #[inline(always)]
        || {
            for layer in &lobe.layers {
                value = value * layer.factor(pair);
            }
            value
        },
    )
}

/// The factors of a table at a pair of directions, looked up once for all ranks.
pub(crate) struct KnownFactors<'a, R> {
    table: Option<&'a FactorTable>,
    factors: [R; FactorTable::MOST_RANKS],
}

impl<'a, R: Real> KnownFactors<'a, R> {
    /// None yet.
    #[inline(always)]
    pub(crate) fn new(like: R) -> Self {
        Self { table: None, factors: [like.zero(); FactorTable::MOST_RANKS] }
    }

    /// As [`layered`], for lobes one after the other at the same pair.
    #[inline(never)]
    pub(crate) fn layered(&mut self, lobe: &'a DirectLobe, mut value: R, pair: &DirectionPair<R>) -> R {
        for layer in &lobe.layers {
            let LayerWeight::Table { table, rank } = layer else {
                value = value.at_own_level(
                    #[inline(always)]
                    || value * layer.factor(pair),
                );
                continue;
            };
            if !self.table.is_some_and(|known| core::ptr::eq(known, &**table)) {
                self.factors = table.factors(pair);
                self.table = Some(table);
            }
            value = value * self.factors[*rank];
        }
        value
    }
}

/// A shape's value.
#[inline(never)]
pub(crate) fn shape_value<R: Real>(lobe: &DirectLobe, pair: &DirectionPair<R>) -> R {
    pair.cos_o.at_own_level(
        #[inline(always)]
        || lobe.shape.f_cos(pair),
    )
}

/// Whether light on the other side of the surface counts for a lobe.
#[inline(always)]
pub(crate) fn is_transmitting(lobe: &DirectLobe) -> bool {
    lobe.shape.info().side == Side::Transmission
}
