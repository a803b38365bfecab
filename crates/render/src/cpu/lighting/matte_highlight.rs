//! The light loop of the commonest materials: a matte lobe, and at most one highlight.
//!
//! [`reflect_classic`](crate::cpu::lighting::reflect::reflect_classic) knows all that a material of the fast path may
//! have, and so decides for each pixel, light and lobe which model it is and where its light goes. That is as much work as the light itself, and
//! what is chosen by address must live in memory. Here these decisions are made once per frame; a loop is compiled for
//! each model of a highlight, whose sums stay in registers. The operations, and their order, are the same.

use glanz_bsdf::{DirectionPair, Model, ModelInfo, Shape, ShapeVisitor};
use glanz_math::{Real, Vec3};

use crate::cpu::lighting::inlined_models::{is_highlight, is_matte};
use crate::cpu::lighting::point::{Reflected, ShadingPoint, add, literal};
use crate::cpu::lighting::shade_material::{ShadeLights, ShadeMaterial};
use crate::prepare::{DirectLobe, TintCoordinate};
use crate::view::lights::{ViewLight, splat};

/// A material that is made of a matte lobe and a highlight, among punctual lights without cones.
#[derive(Debug)]
pub(crate) struct MatteHighlight {
    ambient: [[f32; 3]; 2],
    matte: Shape,
    highlight: Option<Shape>,
    lights: Vec<LoopLight>,
    /// Whether any light fades with the distance.
    fades: bool,
    /// Whether what the highlight sends is grey, as it is where lights are white and the highlight has no colour.
    gray_highlight: bool,
}

/// A light, and what the lobes make of it.
#[derive(Debug)]
struct LoopLight {
    /// Where it is, or where its light comes from if it is infinitely far.
    place: [f32; 3],
    infinite: bool,
    fade: Option<[f32; 3]>,
    matte: [f32; 3],
    highlight: [f32; 3],
}

impl MatteHighlight {
    /// The loop of a material; none where it has, or meets, anything else.
    pub(crate) fn new(material: &ShadeMaterial, lights: &ShadeLights) -> Option<Self> {
        if !material.fast_path || !lights.fast_path || !material.spot_ambient.is_empty() {
            return None;
        }
        let (matte, highlight) = match &material.lobes[..] {
            [matte] => (matte, None),
            [matte, highlight] => (matte, Some(highlight)),
            _ => return None,
        };
        let fits = |lobe: &DirectLobe, is_it: fn(&ModelInfo) -> bool, textured: bool| {
            is_it(lobe.shape.info()) && lobe.textured == textured && lobe.coordinate == TintCoordinate::None
        };
        if !fits(matte, is_matte, true) || !highlight.is_none_or(|lobe| fits(lobe, is_highlight, false)) {
            return None;
        }
        let rows = material.tints.chunks(material.lobes.len());
        let own = lights.list.iter().zip(rows).map(|(light, tints)| LoopLight::new(light, tints));
        let lights = own.collect::<Option<Vec<_>>>()?;
        Some(Self {
            ambient: material.ambient,
            matte: matte.shape.clone(),
            highlight: highlight.map(|lobe| lobe.shape.clone()),
            fades: lights.iter().any(|light| light.fade.is_some()),
            gray_highlight: is_gray(&material.ambient[1])
                && lights.iter().all(|light| is_gray(&light.highlight)),
            lights,
        })
    }

    /// All light that the material sends from the point to the viewer, without its own emission.
    #[inline(always)]
    pub(crate) fn reflect<R: Real>(&self, point: &ShadingPoint<R>) -> Reflected<R> {
        match self.fades {
            true => self.matte.visit(OnMatte::<R, true> { material: self, point }),
            false => self.matte.visit(OnMatte::<R, false> { material: self, point }),
        }
    }

    #[inline(always)]
    fn ambient_light<R: Real>(&self, like: R) -> Reflected<R> {
        Reflected { textured: literal(like, &self.ambient[0]), plain: literal(like, &self.ambient[1]) }
    }

    /// The sum of light. What lights give is added some lights at a time, first from the matte lobe and then from the
    /// highlight: in a loop over everything at once no register would be left for the sums.
    #[inline(always)]
    fn sum<R: Real, const FADES: bool>(
        &self,
        point: &ShadingPoint<R>,
        matte: impl Fn(&DirectionPair<R>) -> R,
        highlight: Option<impl Fn(&DirectionPair<R>) -> R>,
    ) -> Reflected<R> {
        let like = point.normal.x;
        let Reflected { mut textured, mut plain } = self.ambient_light(like);
        let cos_o = point.normal.dot(point.wo);
        let (mut from_matte, mut from_highlight) = (Shares::new(like), Shares::new(like));
        for lights in self.lights.chunks(AT_ONCE) {
            (from_matte.count, from_highlight.count) = (0, 0);
            for light in lights {
                let (wi, attenuation) = light.at::<R, FADES>(point);
                let cos_i = point.normal.dot(wi);
                if !R::any(like.zero().lt(cos_i)) {
                    continue;
                }
                let pair = DirectionPair::between((cos_o, point.wo), (cos_i, wi));
                // What does not fade is not multiplied: a factor of 1 would change no bit.
                let value = matte(&pair);
                from_matte.push(if FADES { value * attenuation } else { value }, &light.matte);
                if let Some(highlight) = &highlight {
                    let value = highlight(&pair);
                    // Nothing to add, which is so for most; what is no number counts.
                    if R::any(!value.le(like.zero())) {
                        let value = if FADES { value * attenuation } else { value };
                        from_highlight.push(value, &light.highlight);
                    }
                }
            }
            from_matte.add_to(&mut textured);
            match self.gray_highlight {
                true => from_highlight.add_gray_to(&mut plain),
                false => from_highlight.add_to(&mut plain),
            }
        }
        Reflected { textured, plain }
    }
}

/// How many lights are looked at before what they give is added: a power of 2.
const AT_ONCE: usize = 4;

/// What a lobe makes of some lights.
struct Shares<'a, R> {
    values: [R; AT_ONCE],
    tints: [&'a [f32; 3]; AT_ONCE],
    count: usize,
}

impl<'a, R: Real> Shares<'a, R> {
    #[inline(always)]
    fn new(like: R) -> Self {
        Self { values: [like.zero(); AT_ONCE], tints: [&[0.0; 3]; AT_ONCE], count: 0 }
    }

    #[inline(always)]
    fn push(&mut self, value: R, tint: &'a [f32; 3]) {
        self.values[self.count & (AT_ONCE - 1)] = value;
        self.tints[self.count & (AT_ONCE - 1)] = tint;
        self.count += 1;
    }

    /// Calls `add` with each light's value and tint.
    #[inline(always)]
    fn for_each(&self, mut add: impl FnMut(R, &'a [f32; 3])) {
        for i in 0..self.count {
            add(self.values[i & (AT_ONCE - 1)], self.tints[i & (AT_ONCE - 1)]);
        }
    }

    #[inline(always)]
    fn add_to(&self, sum: &mut [R; 3]) {
        self.for_each(
            #[inline(always)]
            |value, tint| add(sum, value, literal(value, tint)),
        );
    }

    /// [`Shares::add_to`] where the three sums are the same.
    #[inline(always)]
    fn add_gray_to(&self, sum: &mut [R; 3]) {
        let mut gray = sum[0];
        self.for_each(
            #[inline(always)]
            |value, tint| gray = gray + value * value.lit(f64::from(tint[0])),
        );
        *sum = [gray; 3];
    }
}

impl LoopLight {
    fn new(light: &ViewLight, tints: &[[f32; 3]]) -> Option<Self> {
        let (place, infinite, fade) = match light {
            ViewLight::Directional { towards } => (*towards, true, None),
            ViewLight::Point { position, attenuation, cone: None, luminaire: None } => {
                (*position, false, *attenuation)
            }
            _ => return None,
        };
        let tint = |lobe: usize| tints.get(lobe).copied().unwrap_or_default();
        Some(Self { place, infinite, fade, matte: tint(0), highlight: tint(1) })
    }

    /// Where the light comes from at a point, and what is left of it.
    #[inline(always)]
    fn at<R: Real, const FADES: bool>(&self, point: &ShadingPoint<R>) -> (Vec3<R>, R) {
        let like = point.normal.x;
        let wi = splat(like, &self.place);
        if self.infinite {
            return (wi, like.one());
        }
        let to_light = wi - point.position;
        // A light on the surface itself: no direction, no light, rather than infinity.
        let squared = to_light.dot(to_light).max(like.lit(1e-30));
        let inverse = squared.rsqrt();
        let attenuation = match &self.fade {
            Some(fade) if FADES => {
                let distance = squared * inverse;
                let [c, l, q] = literal(like, fade);
                let denominator = c + l * distance + q * squared;
                like.one() / denominator.max(like.lit(1e-20))
            }
            _ => like.one(),
        };
        (to_light * inverse, attenuation)
    }
}

fn is_gray(&[r, g, b]: &[f32; 3]) -> bool {
    [g, b].map(f32::to_bits) == [r.to_bits(); 2]
}

/// The loop for a model of the matte lobe.
struct OnMatte<'a, R, const FADES: bool> {
    material: &'a MatteHighlight,
    point: &'a ShadingPoint<'a, R>,
}

impl<R: Real, const FADES: bool> ShapeVisitor for OnMatte<'_, R, FADES> {
    type Output = Reflected<R>;

    #[inline(always)]
    fn visit<M: Model>(self, matte: &M) -> Reflected<R> {
        let Self { material, point } = self;
        if const { !is_matte(&M::INFO) } {
            return material.ambient_light(point.normal.x);
        }
        let Some(highlight) = &material.highlight else {
            let nothing = None::<fn(&DirectionPair<R>) -> R>;
            return material.sum::<R, FADES>(
                point,
                #[inline(always)]
                |pair| matte.f_cos(pair),
                nothing,
            );
        };
        highlight.visit(WithHighlight::<R, M, FADES> { material, point, matte })
    }
}

/// The loop for a model of the highlight, too.
struct WithHighlight<'a, R, D, const FADES: bool> {
    material: &'a MatteHighlight,
    point: &'a ShadingPoint<'a, R>,
    matte: &'a D,
}

impl<R: Real, D: Model, const FADES: bool> ShapeVisitor for WithHighlight<'_, R, D, FADES> {
    type Output = Reflected<R>;

    #[inline(always)]
    fn visit<M: Model>(self, model: &M) -> Reflected<R> {
        if const { !is_highlight(&M::INFO) } {
            return self.material.ambient_light(self.point.normal.x);
        }
        self.material.sum::<R, FADES>(
            self.point,
            #[inline(always)]
            |pair| self.matte.f_cos(pair),
            Some(glanz_math::inline::inlined(
                #[inline(always)]
                |pair: &DirectionPair<R>| model.f_cos(pair),
            )),
        )
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

    use glam::DVec3;
    use glanz_color::Rgb;
    use glanz_math::{Twice, Vec3};
    use glanz_scene::builtin::Builtin;
    use glanz_scene::{
        Attenuation, Background, Camera, ClassicMaterial, Light, LightColors, LightKind, Projection, Scene,
    };

    use super::*;
    use crate::cpu::lighting::reflect::reflect_classic;
    use crate::view::camera::ViewCamera;
    use crate::view::lights::ViewLights;
    use crate::{DrawOptions, PrepareOptions, View, prepare};

    const CAMERA: Camera = Camera {
        eye: DVec3::new(0.0, 0.0, 4.0),
        target: DVec3::ZERO,
        up: DVec3::Y,
        projection: Projection::Perspective { fov_y: 0.7 },
    };

    /// Near and far, before and behind, one of them infinitely far.
    fn scene(model: &str, fades: bool) -> Scene {
        let colors = |gray| LightColors::direct(Rgb::gray(gray));
        let attenuation = Attenuation { constant: 0.5, linear: 0.1, quadratic: 0.2 };
        let attenuation = if fades { attenuation } else { Attenuation::NONE };
        let point = |x, y, z| LightKind::Point { position: DVec3::new(x, y, z), attenuation };
        let material = ClassicMaterial {
            model: model.into(),
            ambient: Rgb([0.05, 0.01, 0.01]).into(),
            diffuse: Rgb([0.8, 0.1, 0.3]).into(),
            specular: Rgb([0.6, 0.5, 0.4]).into(),
            ..ClassicMaterial::default()
        };
        Scene {
            meshes: vec![Builtin::Sphere { radius: 1.0, slices: 16, stacks: 8 }.mesh().unwrap()],
            materials: vec![material.build("it").unwrap()],
            lights: vec![
                Light::new(point(3.0, 1.0, 3.0), colors(0.5)),
                Light::new(point(-2.0, 2.0, -1.0), colors(0.7)),
                Light::new(LightKind::Directional { direction: DVec3::new(0.3, -1.0, -0.5) }, colors(0.2)),
            ],
            ..Scene::default()
        }
    }

    fn points() -> impl Iterator<Item = ShadingPoint<'static, f32>> {
        (0..200).map(|i| {
            let (theta, phi) = (0.0157 * f64::from(i), 2.4 * f64::from(i));
            let of = |v: Vec3<f64>| Vec3::new(v.x as f32, v.y as f32, v.z as f32);
            let normal = of(Vec3::from_angles(theta, phi));
            let position = normal + Vec3::new(0.0, 0.0, -4.0);
            ShadingPoint::plain(position, normal, (-position).normalized())
        })
    }

    #[test]
    fn it_gives_the_bits_of_the_loop_for_all_materials_alone_and_in_step() {
        for model in ["lambert", "phong", "phong-normalized", "blinn-phong", "blinn-phong-normalized"] {
            for fades in [false, true] {
                let prepared = prepare(&scene(model, fades), &PrepareOptions::default()).unwrap();
                let view = View::new(&CAMERA, 100, 100).unwrap();
                let options = DrawOptions::new(Background::Transparent);
                let lights = ViewLights::new(&prepared, &ViewCamera::new(&prepared, &view), &options);
                let lights = ShadeLights::new(lights, None);
                let materials = ShadeMaterial::all(prepared.materials.as_slice().into(), false);
                let material = &materials[0];
                let Some(classic) = MatteHighlight::new(material, &lights) else {
                    assert_eq!(model, "lambert", "its highlight is matte");
                    continue;
                };
                let mut last = None;
                for point in points() {
                    let own = classic.reflect(&point);
                    let other = reflect_classic(&lights.list, material, &point, None);
                    assert_eq!(bits(&own), bits(&other), "{model}");
                    if let Some((before, light)) = last.replace((point, own)) {
                        let twice =
                            classic.reflect(&both(&before, &point)).textured.map(|Twice(a, b)| [a, b]);
                        let alone = [0, 1, 2].map(|c| [light.textured[c], own.textured[c]]);
                        assert_eq!(twice.map(|c| c.map(f32::to_bits)), alone.map(|c| c.map(f32::to_bits)));
                    }
                }
            }
        }
    }

    fn bits(light: &Reflected<f32>) -> [[u32; 3]; 2] {
        [light.textured, light.plain].map(|part| part.map(f32::to_bits))
    }

    fn both(a: &ShadingPoint<f32>, b: &ShadingPoint<f32>) -> ShadingPoint<'static, Twice<f32>> {
        let both = |a: Vec3<f32>, b: Vec3<f32>| Vec3::new(Twice(a.x, b.x), Twice(a.y, b.y), Twice(a.z, b.z));
        ShadingPoint::plain(both(a.position, b.position), both(a.normal, b.normal), both(a.wo, b.wo))
    }
}
