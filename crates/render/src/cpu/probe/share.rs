//! What one light and one lobe have of the light that a point sends.

use glanz_math::{PI, Real, Vec3};
use std::borrow::Cow;

use super::{Arrival, ProbedLight, ProbedLobe};
use crate::cpu::lighting::incident::arrive;
use crate::cpu::lighting::light_sum::{LightSum, layered, shape_value};
use crate::cpu::lighting::point::{Reflected, ShadingPoint, literal, mixed};
use crate::cpu::lighting::reflect::reflect;
use crate::cpu::lighting::shade_material::{ShadeLights, ShadeMaterial};
use crate::cpu::lighting::shadow;
use crate::prepare::{MixTints, PreparedMaterial, TintCoordinate};
use crate::view::lights::{ViewLight, ViewLights};

/// A point, and what it takes to light it.
pub(super) struct Lit<'a> {
    pub lights: &'a ShadeLights<'a>,
    pub material: &'a PreparedMaterial,
    pub point: &'a ShadingPoint<'a, f32>,
    /// What multiplies textured lobes, or mixes their spectra.
    pub color: [f32; 3],
    /// Whether colours mix spectra here.
    pub mixes: bool,
}

impl Lit<'_> {
    /// The sum over all lights and lobes as the picture has it.
    pub(super) fn whole(&self) -> [f32; 3] {
        self.reflect(self.lights, self.material.clone())
    }

    /// Light from everywhere.
    pub(super) fn ambient(&self) -> [f32; 3] {
        let material =
            PreparedMaterial { lobes: Vec::new(), spot_ambient: Vec::new(), ..self.material.clone() };
        self.reflect(&lights_of(Vec::new(), self.lights), material)
    }

    /// What each light gives.
    pub(super) fn lights(&self) -> Vec<ProbedLight> {
        let mut row = 0;
        let list = self.lights.list.iter().enumerate();
        list.map(|(number, light)| {
            let own = self.light(number, light, row);
            row += light.rows();
            own
        })
        .collect()
    }

    fn light(&self, number: usize, light: &ViewLight, row: usize) -> ProbedLight {
        let one = lights_of(vec![*light], self.lights);
        let rows = row..row + light.rows();
        let arrival = self.arrival(light);
        let lobes = (0..self.material.lobes.len()).map(|lobe| {
            let share = self.reflect(&one, self.only(rows.clone(), Some(lobe)));
            let parts = arrival.map(|arrival| self.parts(row, lobe, &arrival));
            let (value, layers, tint) = match parts {
                Some((value, layers, tint)) => (Some(value), Some(layers), Some(tint)),
                None => (None, None, None),
            };
            let colored = self.material.lobes[lobe].textured && !self.mixes;
            ProbedLobe { lobe, colored, value, layers, tint, share }
        });
        let lobes: Vec<_> = lobes.collect();
        let cone_ambient = self.reflect(&one, self.only(rows, None));
        let mut share = cone_ambient;
        for lobe in &lobes {
            share = add(share, lobe.share);
        }
        ProbedLight { light: number, arrival, lobes, cone_ambient, share }
    }

    /// The material with one lobe, or with none, and the rows of one light of its table.
    fn only(&self, rows: core::ops::Range<usize>, lobe: Option<usize>) -> PreparedMaterial {
        let all = self.material;
        let count = all.lobes.len();
        let entries: Vec<usize> =
            lobe.map_or(Vec::new(), |lobe| rows.clone().map(|row| row * count + lobe).collect());
        let dark = [[0.0; 3]; 3];
        let spots = |list: &[[[f32; 3]; 2]]| match lobe {
            None => list.get(rows.clone()).unwrap_or_default().to_vec(),
            Some(_) => Vec::new(),
        };
        let spots_mix = |list: &[[[f32; 3]; 3]]| match lobe {
            None => list.get(rows.clone()).unwrap_or_default().to_vec(),
            Some(_) => Vec::new(),
        };
        PreparedMaterial {
            lobes: lobe.map(|lobe| all.lobes[lobe].clone()).into_iter().collect(),
            tints: entries.iter().map(|entry| all.tints[*entry]).collect(),
            series: entries.iter().filter_map(|entry| all.series.get(*entry).cloned()).collect(),
            integrals: lobe.and_then(|lobe| all.integrals.get(lobe).cloned()).into_iter().collect(),
            ambient: [[0.0; 3]; 2],
            spot_ambient: spots(&all.spot_ambient),
            emission: [0.0; 3],
            mix: all.mix.as_ref().map(|mix| {
                Box::new(MixTints {
                    tints: entries.iter().map(|entry| mix.tints[*entry]).collect(),
                    ambient: dark,
                    spot_ambient: spots_mix(&mix.spot_ambient),
                    emission: dark,
                })
            }),
            ..all.clone()
        }
    }

    /// The light that lights and a material give here, colours included.
    fn reflect(&self, lights: &ShadeLights, material: PreparedMaterial) -> [f32; 3] {
        let materials = ShadeMaterial::all(Cow::Owned(vec![material]), lights.exact.is_some());
        let texel = self.mixes.then_some(self.color);
        let Reflected { textured, plain } = reflect(lights, &materials[0], self.point, texel);
        core::array::from_fn(|c| {
            let factor = if self.mixes { 1.0 } else { self.color[c] };
            textured[c] * factor + plain[c]
        })
    }

    /// How the light of a point or from afar arrives.
    fn arrival(&self, light: &ViewLight) -> Option<Arrival> {
        if matches!(light, ViewLight::Area(_) | ViewLight::Environment { .. }) {
            return None;
        }
        let (n, wo) = (self.point.normal, self.point.wo);
        let incident = arrive(light, self.point);
        let wi = incident.wi;
        let half = wi + wo;
        let half = half * half.dot(half).max(1e-30).rsqrt();
        let mirrored = n * (2.0 * n.dot(wi)) - wi;
        let free = |bvh| shadow::free(bvh, self.point, wi, incident.distance) > 0.0;
        Some(Arrival {
            to_light: array(wi),
            distance: incident.distance,
            mirrored: array(mirrored),
            half: array(half),
            cos_light: n.dot(wi),
            cos_mirrored: mirrored.dot(wo),
            cos_half: n.dot(half),
            cos_view_half: wo.dot(half),
            attenuation: incident.attenuation.unwrap_or(1.0),
            cone: incident.cone,
            visible: self.lights.bvh.map(free),
        })
    }

    /// A lobe's value, what its layers leave of how much of it there is, and its tint.
    fn parts(&self, row: usize, number: usize, arrival: &Arrival) -> (f32, f32, [f32; 3]) {
        let materials = ShadeMaterial::all(Cow::Borrowed(core::slice::from_ref(self.material)), false);
        let material = &materials[0];
        let lobe = &material.lobes[number];
        let sum = LightSum::new(material, self.point, None);
        let [x, y, z] = arrival.to_light;
        let pair = sum.pair(Vec3::new(x, y, z));
        // A lobe into a single direction has no value for light that comes from one.
        let value = if lobe.shape.info().delta {
            0.0
        } else {
            shape_value(lobe, sum.own_pair(lobe, &pair).as_ref().unwrap_or(&pair))
        };
        let entry = row * material.lobes.len() + number;
        let tint = match &material.mix {
            _ if lobe.coordinate != TintCoordinate::None => {
                material.series[entry].at(lobe.coordinate.at(&lobe.shape, &pair))
            }
            Some(mix) if lobe.textured && self.mixes => mixed(&mix.tints[entry], &self.color),
            _ => literal(0.0, &material.tints[entry]),
        };
        let pi = PI as f32;
        let there = sum.fraction(lobe).unwrap_or(1.0);
        (value * pi, layered(lobe, there, &pair), tint.map(|c| c / pi))
    }
}

/// Some lights with the shadows of all.
fn lights_of<'a>(list: Vec<ViewLight<'a>>, all: &ShadeLights<'a>) -> ShadeLights<'a> {
    let exact = all.exact.as_ref().map(|points| points.asked);
    ShadeLights::new(ViewLights { list, bvh: all.bvh, pixel: all.pixel }, exact)
}

pub(super) fn array(v: Vec3<f32>) -> [f32; 3] {
    [v.x, v.y, v.z]
}

pub(super) fn add(a: [f32; 3], b: [f32; 3]) -> [f32; 3] {
    core::array::from_fn(|c| a[c] + b[c])
}
