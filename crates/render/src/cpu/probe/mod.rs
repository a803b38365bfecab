//! The illumination of one pixel, taken apart: what is there, what each light sends there, and what each lobe makes of it.
//!
//! The pixel's normal, textures and place are those of the picture itself: it is drawn once more for each of them, with one
//! sample in the middle of the pixel. What lights and lobes make of these is computed by the functions that draw, one pair at a
//! time, so that the sum is the pixel.

mod pixel;
mod point;
mod record;
mod share;

use glanz_scene::{Interpolation, Shading};

pub(crate) use pixel::{pixel_of, probe};
pub(crate) use record::{Record, replace};

/// What one pixel shows, and how it came about. Colours are in the observer's first three channels, linear, before exposure;
/// directions are unit vectors along the world's axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Probe {
    /// Column and row, from 0 at the top left.
    pub pixel: (u32, u32),
    /// What the picture has there.
    pub picture: [f32; 3],
    /// The same in linear sRGB, before exposure.
    pub screen: [f32; 3],
    /// The same in the file, with opacity.
    pub code: [u8; 4],
    /// What it would have there with one sample in the middle of the pixel. It is another where the pixel lies on an edge.
    pub middle: [f32; 3],
    /// The nearest surface in the middle of the pixel; none where there is none.
    pub surface: Option<ProbedSurface>,
}

/// The surface in the middle of a pixel.
///
/// ```
/// use glanz_render::Shot;
/// use glanz_scene::{Light, Mesh, Scene, library};
///
/// let scene = Scene::new()
///     .with_mesh(Mesh::builtin("sphere")?, library::material("gold")?)
///     .with_light(Light::directional([0.0, 0.0, -1.0], [1.0; 3]))
///     .with_size(33, 33);
/// let surface = Shot::new(&scene)?.probe(16, 16)?.surface.expect("the sphere is in the middle");
/// assert_eq!((surface.object, surface.back, surface.opacity), (0, false, 1.0));
/// assert!(surface.facet_normal[2].abs() > 0.8);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ProbedSurface {
    /// The number of its object in the scene.
    pub object: usize,
    /// The number of its material.
    pub material: usize,
    /// Where the illumination model is evaluated.
    pub shading: Shading,
    /// How values between vertices are found.
    pub interpolation: Interpolation,
    /// The number of the facet in its mesh.
    pub facet: u32,
    /// Whether the back of the facet is seen.
    pub back: bool,
    /// The normal of the plane of the triangle, on the side that is seen.
    pub facet_normal: [f64; 3],
    /// Where it is in the world, in metres.
    pub position: [f64; 3],
    /// How far it is from the plane of the eye, in metres.
    pub distance: f32,
    /// Texture coordinates; none without a texture.
    pub uv: Option<[f32; 2]>,
    /// What multiplies textured lobes at the pixel: the texel, and the vertices' colour where shading is per pixel.
    pub base: [f32; 3],
    /// Where light is evaluated: the pixel itself (Phong shading), the centroid of the facet (flat) or the corners of the triangle
    /// (Gouraud), whose values are interpolated.
    pub points: Vec<ProbedPoint>,
    /// Light of the surface's own.
    pub emission: [f32; 3],
    /// The sum: the points' light by their weights, and the emission.
    pub light: [f32; 3],
    /// What the picture has of it: less than 1 where it is blended with what is behind.
    pub opacity: f32,
    /// Whether light from behind passes it, as it does glass.
    pub transmits: bool,
}

/// Where a point is that is lit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PointPlace {
    /// At the pixel.
    Pixel,
    /// At the centroid of a facet.
    Centroid,
    /// At a vertex of that number in its mesh.
    Vertex(u32),
}

/// A point that is lit.
///
/// ```
/// use glanz_render::Shot;
/// use glanz_scene::{Light, Mesh, Scene, library};
///
/// let scene = Scene::new()
///     .with_mesh(Mesh::builtin("sphere")?, library::material("gold")?)
///     .with_light(Light::directional([0.0, 0.0, -1.0], [1.0; 3]))
///     .with_size(33, 33);
/// let surface = Shot::new(&scene)?.probe(16, 16)?.surface.expect("the sphere is in the middle");
/// let point = &surface.points[0];
/// let cosine: f32 = point.normal.iter().zip(point.to_viewer).map(|(n, v)| n * v).sum();
/// assert!((cosine - point.cos_view).abs() < 1e-6 && point.weight == 1.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ProbedPoint {
    /// Where it is.
    pub place: PointPlace,
    /// How much of its light the pixel gets.
    pub weight: f32,
    /// Where it is in the world, in metres.
    pub position: [f64; 3],
    /// The shading normal N; null where the surface is not lit.
    pub normal: [f32; 3],
    /// The direction V to the viewer.
    pub to_viewer: [f32; 3],
    /// N·V.
    pub cos_view: f32,
    /// What multiplies textured lobes: colours of vertices or facets times the texel.
    pub color: [f32; 3],
    /// Multiplies the width of lobes that textures can widen.
    pub alpha_scale: f32,
    /// Light from everywhere times the ambient tints.
    pub ambient: [f32; 3],
    /// What each light gives, ambient lights left out.
    pub lights: Vec<ProbedLight>,
    /// The sum.
    pub light: [f32; 3],
}

/// What one light gives at a point: the sum of what the lobes make of it.
///
/// ```
/// use glanz_render::Shot;
/// use glanz_scene::{Light, Mesh, Scene, library};
///
/// let scene = Scene::new()
///     .with_mesh(Mesh::builtin("sphere")?, library::material("gold")?)
///     .with_light(Light::directional([0.0, 0.0, -1.0], [1.0; 3]))
///     .with_size(33, 33);
/// let surface = Shot::new(&scene)?.probe(16, 16)?.surface.expect("the sphere is in the middle");
/// let light = &surface.points[0].lights[0];
/// let arrival = light.arrival.expect("a lamp's light comes from one direction");
/// assert!(arrival.cos_light > 0.8 && arrival.distance.is_none() && arrival.visible.is_none());
/// let sum: f32 = light.lobes.iter().map(|lobe| lobe.share[0]).sum();
/// assert!((sum - light.share[0]).abs() < 1e-5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ProbedLight {
    /// Its number among the lights of the scene that are not ambient.
    pub light: usize,
    /// How it arrives; none of areas and environments, which come from many directions.
    pub arrival: Option<Arrival>,
    /// What each lobe of the material gives.
    pub lobes: Vec<ProbedLobe>,
    /// Ambient light in the cone of a spot.
    pub cone_ambient: [f32; 3],
    /// The sum.
    pub share: [f32; 3],
}

/// How light from one direction arrives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arrival {
    /// The direction L to the light.
    pub to_light: [f32; 3],
    /// How far the light is, in metres; none if it is infinitely far.
    pub distance: Option<f32>,
    /// The direction R of mirrored light, 2 (N·L) N − L.
    pub mirrored: [f32; 3],
    /// The half vector H of L and V.
    pub half: [f32; 3],
    /// N·L.
    pub cos_light: f32,
    /// R·V.
    pub cos_mirrored: f32,
    /// N·H.
    pub cos_half: f32,
    /// V·H.
    pub cos_view_half: f32,
    /// What distance, cone and luminaire leave of the light.
    pub attenuation: f32,
    /// What the cone alone leaves; none of what is no spot.
    pub cone: Option<f32>,
    /// Whether nothing stands between; none where the scene has no shadows.
    pub visible: Option<bool>,
}

/// What one lobe makes of one light.
///
/// ```
/// use glanz_render::Shot;
/// use glanz_scene::{Light, Mesh, Scene, library};
///
/// let scene = Scene::new()
///     .with_mesh(Mesh::builtin("sphere")?, library::material("gold")?)
///     .with_light(Light::directional([0.0, 0.0, -1.0], [1.0; 3]))
///     .with_size(33, 33);
/// let surface = Shot::new(&scene)?.probe(16, 16)?.surface.expect("the sphere is in the middle");
/// let lobe = &surface.points[0].lights[0].lobes[0];
/// let (value, layers) = (lobe.value.expect("of a lamp"), lobe.layers.expect("of a lamp"));
/// let tint = lobe.tint.expect("of a lamp");
/// assert!((value * layers * tint[0] - lobe.share[0]).abs() < 1e-5 * value);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProbedLobe {
    /// Its number among the lobes of the prepared material.
    pub lobe: usize,
    /// Whether the point's colour multiplies it, or is in its tint already.
    pub colored: bool,
    /// The shape's value with the cosine, in 1/sr, times π: 1 is a matte white surface that faces a light of value 1. None for
    /// light from many directions, of which only the integral is known.
    pub value: Option<f32>,
    /// What layers above leave of how much of it there is here: by metal, and by masks.
    pub layers: Option<f32>,
    /// The tint under this light, over π where [`ProbedLobe::value`] is times it.
    pub tint: Option<[f32; 3]>,
    /// value · layers · attenuation · tint · colour.
    pub share: [f32; 3],
}
