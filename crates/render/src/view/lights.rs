//! The lights in single precision, relative to the camera.
//!
//! ```
//! use glanz_render::view::camera::ViewCamera;
//! use glanz_render::view::lights::ViewLights;
//! use glanz_render::{DrawOptions, PrepareOptions, View, prepare};
//! use glanz_scene::{Background, Camera, Light, Material, Mesh, Scene};
//!
//! let scene = Scene::new()
//!     .with_mesh(Mesh::builtin("sphere")?, Material::default_gray())
//!     .with_light(Light::point([0.0, 0.0, 3.0], [1.0; 3]));
//! let prepared = prepare(&scene, &PrepareOptions::default())?;
//! let view = View::new(&Camera::new([0.0, 0.0, 5.0], [0.0; 3]), 64, 48)?;
//! let camera = ViewCamera::new(&prepared, &view);
//! let lights = ViewLights::new(&prepared, &camera, &DrawOptions::new(Background::Transparent));
//! assert_eq!(lights.list.len(), 1);
//! assert!(lights.bvh.is_none(), "the scene has no shadows");
//! # Ok::<_, Box<dyn std::error::Error>>(())
//! ```

use glam::{DMat3, DVec3};
use glanz_math::{Real, Vec3};
use glanz_scene::{AreaShape, Space};

use crate::prepare::Prepared;
use crate::prepare::{Bvh, EnvironmentLight, IntensityGrid, LightShape, PreparedLight, PreparedLuminaire};
use crate::view::camera::ViewCamera;
use crate::view::{DrawOptions, Samples};

/// The lights of a frame.
pub struct ViewLights<'a> {
    /// Each light of the scene that is not ambient, in its order.
    pub list: Vec<ViewLight<'a>>,
    /// What casts shadows.
    pub bvh: Option<ViewBvh<'a>>,
    /// The width of a pixel where it is shaded once for several samples, in m, and what a metre of distance adds to it:
    /// so far the hard rim of a cone reaches in the picture, as the edge of a surface does. None where each sample is
    /// shaded by itself.
    pub pixel: Option<[f32; 2]>,
}

/// What casts shadows, relative to the camera.
#[derive(Clone, Copy)]
pub struct ViewBvh<'a> {
    /// The tree of the triangles.
    pub bvh: &'a Bvh,
    /// Where the camera is among them.
    pub camera: [f32; 3],
    /// How far a pixel may be off the surface, in m, and what a metre of distance adds to it: at an edge a pixel of
    /// several samples is shaded at its centre, where its triangle may have ended.
    pub pixel: [f32; 2],
}

/// From the centre of a pixel to its corner, in pixels, and a little more.
const HALF_DIAGONAL: f32 = 0.75;

/// A cone, in single precision.
#[derive(Clone, Copy, Debug)]
pub struct ViewCone {
    /// The unit vector along which it shines.
    pub axis: [f32; 3],
    /// Cosine of the angle to the axis beyond which nothing is sent.
    pub cos_cutoff: f32,
    /// The power of the cosine with which it fades away from the axis.
    pub exponent: f32,
    /// Outer cosine and 1 / (inner − outer).
    pub smooth_edge: Option<[f32; 2]>,
}

/// What a luminaire sends into each direction.
#[derive(Clone, Copy, Debug)]
pub struct ViewLuminaire<'a> {
    /// Fractions of the greatest intensity.
    pub intensities: &'a IntensityGrid,
    /// Rows: C 0°, C 90°, γ 0°.
    pub frame: [[f32; 3]; 3],
}

/// A surface that shines.
#[derive(Clone, Copy, Debug)]
pub struct ViewArea {
    /// Its form and size.
    pub form: AreaShape,
    /// Its centre.
    pub center: [f32; 3],
    /// Along its width, its height and the way it faces.
    pub axes: [[f32; 3]; 3],
    /// Whether it shines on its back, too.
    pub two_sided: bool,
}

/// A light relative to the camera, along world axes.
#[derive(Clone, Copy, Debug)]
pub enum ViewLight<'a> {
    /// A light at infinite distance.
    Directional {
        /// The unit vector towards it.
        towards: [f32; 3],
    },
    /// A light at a point.
    Point {
        /// Where it is.
        position: [f32; 3],
        /// The factors of 1, d and d² in the denominator by which it fades; none where it does not.
        attenuation: Option<[f32; 3]>,
        /// What it is limited to.
        cone: Option<ViewCone>,
        /// How much it sends into each direction; the same into all where there is none.
        luminaire: Option<ViewLuminaire<'a>>,
    },
    /// A surface that shines.
    Area(ViewArea),
    /// An environment at infinite distance.
    Environment {
        /// What it looks like.
        environment: &'a EnvironmentLight,
        /// Its number among the environments of the scene.
        number: usize,
        /// Rows of the rotation into its own directions.
        to_map: [[f32; 3]; 3],
    },
}

impl<'a> ViewLights<'a> {
    /// The prepared lights as `camera` sees them.
    pub fn new(prepared: &'a Prepared, camera: &ViewCamera, options: &DrawOptions) -> Self {
        let mut number = 0;
        let list: Vec<_> = prepared
            .lights
            .iter()
            .map(|light| {
                let own = ViewLight::new(light, camera, number);
                number += usize::from(matches!(own, ViewLight::Environment { .. }));
                own
            })
            .collect();
        let bvh = prepared.bvh.as_deref();
        // Where each sample is shaded by itself, or is the centre, it is on its own triangle.
        let pixel = pixel_width(camera, options);
        let bvh = bvh.map(|bvh| ViewBvh {
            bvh,
            camera: (camera.position - DVec3::from_array(bvh.center)).as_vec3().to_array(),
            pixel: pixel.map_or([0.0; 2], |width| width.map(|width| width * HALF_DIAGONAL)),
        });
        Self { list, bvh, pixel }
    }

    /// The environment that is seen behind everything: the first.
    pub fn environment(&self) -> Option<&ViewLight<'a>> {
        self.list.iter().find(|light| matches!(light, ViewLight::Environment { .. }))
    }
}

/// See [`ViewLights::pixel`].
pub(crate) fn pixel_width(camera: &ViewCamera, options: &DrawOptions) -> Option<[f32; 2]> {
    let width = camera.inverse_scale;
    let shades_once = options.samples > Samples::One && !options.supersample;
    shades_once.then_some(if camera.perspective { [0.0, width] } else { [width, 0.0] })
}

impl<'a> ViewLight<'a> {
    fn new(light: &'a PreparedLight, camera: &ViewCamera, number: usize) -> Self {
        let seen = Seen { camera, space: light.space };
        let luminaire = light.luminaire.as_ref().map(|PreparedLuminaire { intensities, frame }| {
            ViewLuminaire { intensities, frame: frame.map(|axis| seen.direction(axis)) }
        });
        match &light.shape {
            LightShape::Directional { towards } => Self::Directional { towards: seen.direction(*towards) },
            LightShape::Point { position, attenuation } => Self::Point {
                position: seen.point(*position),
                attenuation: attenuation.map(|factors| factors.map(|factor| factor as f32)),
                cone: None,
                luminaire,
            },
            LightShape::Spot { position, axis, cos_cutoff, exponent, smooth_edge, attenuation } => {
                Self::Point {
                    position: seen.point(*position),
                    attenuation: attenuation.map(|factors| factors.map(|factor| factor as f32)),
                    cone: Some(ViewCone {
                        axis: seen.direction(*axis),
                        cos_cutoff: *cos_cutoff as f32,
                        exponent: *exponent as f32,
                        smooth_edge: smooth_edge
                            .map(|(inner, outer)| [outer as f32, (1.0 / (inner - outer).max(1e-6)) as f32]),
                    }),
                    luminaire,
                }
            }
            LightShape::Area { form, position, axes, two_sided } => Self::Area(ViewArea {
                form: *form,
                center: seen.point(*position),
                axes: axes.map(|axis| seen.direction(axis)),
                two_sided: *two_sided,
            }),
            LightShape::Environment(environment) => {
                Self::Environment { environment, number, to_map: seen.to_map(environment) }
            }
        }
    }

    /// How many lights of the tint table it is.
    #[inline(always)]
    pub fn rows(&self) -> usize {
        if matches!(self, Self::Environment { .. }) { 3 } else { 1 }
    }
}

/// A light as the camera sees it: relative to the camera, along the world's axes.
struct Seen<'a> {
    camera: &'a ViewCamera,
    /// What the light's own directions and positions are relative to.
    space: Space,
}

impl Seen<'_> {
    fn in_world(&self, direction: DVec3) -> DVec3 {
        let axes = self.camera.axes;
        match self.space {
            Space::World => direction,
            Space::Camera => axes[0] * direction.x + axes[1] * direction.y + axes[2] * direction.z,
        }
    }

    fn direction(&self, direction: [f64; 3]) -> [f32; 3] {
        self.in_world(DVec3::from_array(direction)).as_vec3().to_array()
    }

    fn point(&self, point: [f64; 3]) -> [f32; 3] {
        let point = DVec3::from_array(point);
        let offset = match self.space {
            Space::World => point - self.camera.position,
            Space::Camera => self.in_world(point),
        };
        offset.as_vec3().to_array()
    }

    /// Rows of the rotation into an environment's own directions.
    fn to_map(&self, environment: &EnvironmentLight) -> [[f32; 3]; 3] {
        let world = [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| self.in_world(axis).to_array());
        let world = DMat3::from_cols_array_2d(&world);
        // The rows of the inverse of a rotation are its columns.
        (world * DMat3::from_cols_array_2d(&environment.rotation)).as_mat3().to_cols_array_2d()
    }
}

/// A vector of three constants.
#[inline(always)]
pub fn splat<R: Real>(like: R, v: &[f32; 3]) -> Vec3<R> {
    Vec3::new(like.lit(f64::from(v[0])), like.lit(f64::from(v[1])), like.lit(f64::from(v[2])))
}

/// A vector along other axes.
#[inline(always)]
pub fn turned<R: Real>(rows: &[[f32; 3]; 3], v: Vec3<R>) -> Vec3<R> {
    Vec3::new(v.dot(splat(v.x, &rows[0])), v.dot(splat(v.x, &rows[1])), v.dot(splat(v.x, &rows[2])))
}
