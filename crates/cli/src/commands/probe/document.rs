//! Pixels for programs.

use glanz_render::{Arrival, PointPlace, Probe, ProbedLight, ProbedPoint, ProbedSurface, Shot};
use glanz_scene::Scene;
use schemars::JsonSchema;
use serde::Serialize;

use super::{light, material_name};
use crate::input::objects::object_name;

/// Pixels, taken apart. Colours are linear, in the observer's channels; directions are unit vectors along the world's axes.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    /// Names of the channels of all colours but `screen` and `code`
    channels: Vec<String>,
    pixels: Vec<PixelFacts>,
    /// What is ignored or changed
    notes: Vec<String>,
}

/// A pixel.
#[derive(Debug, Serialize, JsonSchema)]
struct PixelFacts {
    /// Column and row, from 0 at the top left
    pixel: [u32; 2],
    /// What the picture has there
    picture: [f32; 3],
    /// With one sample in the middle of the pixel
    middle: [f32; 3],
    /// In linear sRGB, before exposure
    screen: [f32; 3],
    /// In an 8-bit file, with opacity
    code: [u8; 4],
    /// The nearest surface; null for the background
    surface: Option<SurfaceFacts>,
}

/// A surface.
#[derive(Debug, Serialize, JsonSchema)]
struct SurfaceFacts {
    /// Its name, or its number from 0
    object: String,
    material: String,
    /// flat, gouraud or phong
    shading: String,
    facet: u32,
    /// Whether the back of the facet is seen
    back: bool,
    facet_normal: [f64; 3],
    /// In m
    position: [f64; 3],
    /// From the plane of the eye, in m
    distance: f32,
    /// Texture coordinates
    uv: Option<[f32; 2]>,
    /// Where light is evaluated: the pixel, the centroid of the facet, or the corners of the triangle
    points: Vec<PointFacts>,
    emission: [f32; 3],
    /// The points' light by their weights, and the emission
    light: [f32; 3],
    opacity: f32,
    /// Whether `light` is the sum of `points`: not where values are interpolated along scan lines of whole polygons
    is_sum: bool,
}

/// A point that is lit.
#[derive(Debug, Serialize, JsonSchema)]
struct PointFacts {
    /// pixel, centroid, or vertex
    at: &'static str,
    /// The number of a vertex
    vertex: Option<u32>,
    weight: f32,
    /// In m
    position: [f64; 3],
    n: [f32; 3],
    v: [f32; 3],
    n_v: f32,
    /// What multiplies textured lobes
    color: [f32; 3],
    ambient: [f32; 3],
    lights: Vec<LightFacts>,
    light: [f32; 3],
}

/// What a light gives.
#[derive(Debug, Serialize, JsonSchema)]
struct LightFacts {
    /// Its number in paths such as lights.0.color
    light: usize,
    kind: String,
    /// How it arrives; null for light from many directions
    arrival: Option<ArrivalFacts>,
    lobes: Vec<LobeFacts>,
    /// Ambient light in the cone of a spot
    cone_ambient: [f32; 3],
    /// The sum
    share: [f32; 3],
}

/// How light arrives.
#[derive(Debug, Serialize, JsonSchema)]
struct ArrivalFacts {
    l: [f32; 3],
    r: [f32; 3],
    h: [f32; 3],
    n_l: f32,
    r_v: f32,
    n_h: f32,
    v_h: f32,
    /// In m; null if it is infinitely far
    distance: Option<f32>,
    /// What distance, cone and luminaire leave
    attenuation: f32,
    /// What the cone alone leaves
    cone: Option<f32>,
    /// Null in scenes without shadows
    visible: Option<bool>,
}

/// What a lobe makes of a light.
#[derive(Debug, Serialize, JsonSchema)]
struct LobeFacts {
    /// The name of its model
    model: &'static str,
    /// π times the BSDF times the cosine
    pi_f_cos: Option<f32>,
    /// What layers above leave
    layers: Option<f32>,
    tint: Option<[f32; 3]>,
    /// The product, with attenuation and colour
    share: [f32; 3],
}

impl Document {
    pub(super) fn new(probes: &[Probe], scene: &Scene, shot: &Shot, notes: Vec<String>) -> Self {
        let pixels = probes.iter().map(|probe| PixelFacts {
            pixel: [probe.pixel.0, probe.pixel.1],
            picture: probe.picture,
            middle: probe.middle,
            screen: probe.screen,
            code: probe.code,
            surface: probe.surface.as_ref().map(|surface| SurfaceFacts::new(surface, scene, shot)),
        });
        let names = &shot.prepared().channels.names;
        Self { channels: names.iter().take(3).cloned().collect(), pixels: pixels.collect(), notes }
    }
}

impl SurfaceFacts {
    fn new(surface: &ProbedSurface, scene: &Scene, shot: &Shot) -> Self {
        let lobes = &shot.prepared().materials[surface.material].lobes;
        let models: Vec<_> = lobes.iter().map(|lobe| lobe.shape.info().name).collect();
        let points = surface.points.iter().map(|point| PointFacts::new(point, scene, &models));
        Self {
            object: object_name(scene, surface.object),
            material: material_name(scene, surface.material),
            shading: surface.shading.to_string(),
            facet: surface.facet,
            back: surface.back,
            facet_normal: surface.facet_normal,
            position: surface.position,
            distance: surface.distance,
            uv: surface.uv,
            points: points.collect(),
            emission: surface.emission,
            light: surface.light,
            opacity: surface.opacity,
            is_sum: surface.is_exact(),
        }
    }
}

impl PointFacts {
    fn new(point: &ProbedPoint, scene: &Scene, models: &[&'static str]) -> Self {
        let (at, vertex) = match point.place {
            PointPlace::Pixel => ("pixel", None),
            PointPlace::Centroid => ("centroid", None),
            PointPlace::Vertex(number) => ("vertex", Some(number)),
        };
        Self {
            at,
            vertex,
            weight: point.weight,
            position: point.position,
            n: point.normal,
            v: point.to_viewer,
            n_v: point.cos_view,
            color: point.color,
            ambient: point.ambient,
            lights: point.lights.iter().map(|light| LightFacts::new(light, scene, models)).collect(),
            light: point.light,
        }
    }
}

impl LightFacts {
    fn new(found: &ProbedLight, scene: &Scene, models: &[&'static str]) -> Self {
        let (number, kind) = light(scene, found.light);
        let lobe = |lobe: &glanz_render::ProbedLobe| LobeFacts {
            model: models[lobe.lobe],
            pi_f_cos: lobe.value,
            layers: lobe.layers,
            tint: lobe.tint,
            share: lobe.share,
        };
        Self {
            light: number,
            kind,
            arrival: found.arrival.as_ref().map(ArrivalFacts::of),
            lobes: found.lobes.iter().map(lobe).collect(),
            cone_ambient: found.cone_ambient,
            share: found.share,
        }
    }
}

impl ArrivalFacts {
    fn of(arrival: &Arrival) -> Self {
        Self {
            l: arrival.to_light,
            r: arrival.mirrored,
            h: arrival.half,
            n_l: arrival.cos_light,
            r_v: arrival.cos_mirrored,
            n_h: arrival.cos_half,
            v_h: arrival.cos_view_half,
            distance: arrival.distance,
            attenuation: arrival.attenuation,
            cone: arrival.cone,
            visible: arrival.visible,
        }
    }
}
