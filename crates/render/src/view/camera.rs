//! The camera of a view in single precision.
//!
//! ```
//! use glanz_render::view::camera::ViewCamera;
//! use glanz_render::{PrepareOptions, View, prepare};
//! use glanz_scene::{Camera, Light, Material, Mesh, Scene};
//!
//! let scene = Scene::new()
//!     .with_mesh(Mesh::builtin("sphere")?, Material::default_gray())
//!     .with_light(Light::point([0.0, 0.0, 3.0], [1.0; 3]));
//! let prepared = prepare(&scene, &PrepareOptions::default())?;
//! let view = View::new(&Camera::new([0.0, 0.0, 5.0], [0.0; 3]), 64, 48)?;
//! let camera = ViewCamera::new(&prepared, &view);
//! // The sphere of radius 1 is 4 to 6 m before the camera.
//! let [near, far] = camera.range;
//! assert!(near <= 4.0 && far >= 6.0 && far < 7.0, "{near} to {far}");
//! assert_eq!(camera.center, [32.0, 24.0]);
//! # Ok::<_, Box<dyn std::error::Error>>(())
//! ```

use glam::DVec3;
use glanz_math::{Real, Vec3};
use glanz_scene::Projection;

use crate::prepare::Prepared;
use crate::prepare::PreparedObject;
use crate::view::View;
use glanz_math::inline::inlined;

/// The least distance at which something is seen, in metres: none but what numbers need. Depth is the inverse of the
/// distance, as precise near as far, so that no plane before the eye has to be given up for it.
const NEAR: f32 = 1e-20;

/// The camera of a view in single precision: its position is the origin, the axes are those of the world.
#[derive(Clone, Debug)]
pub struct ViewCamera {
    /// Width of the picture, in pixels.
    pub width: usize,
    /// Height of the picture, in pixels.
    pub height: usize,
    /// Centre of the picture, in pixels.
    pub center: [f32; 2],
    /// Pixels per metre at distance 1 (perspective) or everywhere (parallel).
    pub scale: f32,
    /// Metres per pixel at distance 1 (perspective) or everywhere (parallel).
    pub inverse_scale: f32,
    /// The unit vector to the right.
    pub right: [f32; 3],
    /// The unit vector up.
    pub up: [f32; 3],
    /// The unit vector against the direction in which the camera looks.
    pub back: [f32; 3],
    /// Whether distances shrink what is seen.
    pub perspective: bool,
    /// The least distance at which something is seen, in metres; all but none.
    pub near: f32,
    /// The least and the greatest distance in the scene, in metres.
    pub range: [f32; 2],
    /// `right`, `up` and `back` in double precision.
    pub(super) axes: [DVec3; 3],
    /// Where the camera is in the world, in metres.
    pub(super) position: DVec3,
}

impl ViewCamera {
    /// The camera of `view` before what has been prepared.
    pub fn new(prepared: &Prepared, view: &View) -> Self {
        let axes = view.axes.map(DVec3::from_array);
        let [right, up, back] = axes;
        let perspective = matches!(view.projection, Projection::Perspective { .. });
        let near = if perspective { NEAR } else { 0.0 };
        let scale = view.pixels_per_unit();
        let mut camera = Self {
            width: view.width as usize,
            height: view.height as usize,
            center: [view.width as f32 * 0.5, view.height as f32 * 0.5],
            scale: scale as f32,
            inverse_scale: (1.0 / scale) as f32,
            right: right.as_vec3().to_array(),
            up: up.as_vec3().to_array(),
            back: back.as_vec3().to_array(),
            perspective,
            near,
            range: [f32::INFINITY, 0.0],
            axes,
            position: DVec3::from_array(view.eye),
        };
        let ranges = prepared.objects.iter().map(|object| camera.range_of(object));
        let whole = ranges.fold([f64::INFINITY, 0.0], |[a, b], [low, high]| [a.min(low), b.max(high)]);
        camera.range = whole.map(|distance| (distance as f32).max(near));
        camera
    }

    /// The least and the greatest distance of the object's box, in metres; below 0 is behind the camera.
    pub fn range_of(&self, object: &PreparedObject) -> [f64; 2] {
        let back = self.axes[2];
        let distances =
            corners(object).map(|c| -back.dot(DVec3::from_array(object.anchor) + c - self.position));
        distances.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], d| [low.min(d), high.max(d)])
    }

    /// The unit vectors to the right, up and against the direction in which the camera looks, in double precision.
    pub fn axes(&self) -> [[f64; 3]; 3] {
        self.axes.map(|axis| axis.to_array())
    }

    /// Where the camera is in the world, in metres.
    pub fn position(&self) -> [f64; 3] {
        self.position.to_array()
    }

    /// The object's anchor along right, up and away from the camera.
    pub fn anchor(&self, object: &PreparedObject) -> [f32; 3] {
        let offset = DVec3::from_array(object.anchor) - self.position;
        let [right, up, back] = self.axes;
        [right.dot(offset) as f32, up.dot(offset) as f32, -back.dot(offset) as f32]
    }

    /// The object's anchor relative to the camera, along world axes.
    pub fn offset(&self, object: &PreparedObject) -> Vec3<f32> {
        let offset = (DVec3::from_array(object.anchor) - self.position).as_vec3();
        Vec3::new(offset.x, offset.y, offset.z)
    }

    /// Whether the camera is outside the box of the object, so that a closed one shows no back face.
    pub fn is_outside(&self, object: &PreparedObject) -> bool {
        let camera = self.position - DVec3::from_array(object.anchor);
        let [low, high] = object.bounds.map(DVec3::from_array);
        let size = high - low;
        let margin = DVec3::splat(size.length() * 1e-3);
        if !self.perspective {
            return corners(object).all(|c| -self.axes[2].dot(c - camera) > 0.0);
        }
        !(camera.cmpge(low - margin).all() && camera.cmple(high + margin).all())
    }

    /// The surface point and the unit vector to the viewer for a pixel position and a distance.
    #[inline(always)]
    pub fn unproject<R: Real>(&self, px: R, py: R, distance: R) -> (Vec3<R>, Vec3<R>) {
        let x = (px - px.lit(f64::from(self.center[0]))) * px.lit(f64::from(self.inverse_scale));
        let y = (px.lit(f64::from(self.center[1])) - py) * px.lit(f64::from(self.inverse_scale));
        let axis = inlined(
            #[inline(always)]
            |a: &[f32; 3]| {
                Vec3::new(px.lit(f64::from(a[0])), px.lit(f64::from(a[1])), px.lit(f64::from(a[2])))
            },
        );
        let across = axis(&self.right) * x + axis(&self.up) * y;
        let back = axis(&self.back);
        if self.perspective {
            let ray = across - back;
            (ray * distance, (-ray).normalized())
        } else {
            (across - back * distance, back)
        }
    }
}

/// The corners of an object's box relative to its anchor.
fn corners(object: &PreparedObject) -> impl Iterator<Item = DVec3> {
    let [low, high] = object.bounds.map(DVec3::from_array);
    (0..8).map(move |i| {
        DVec3::new(
            if i & 1 == 0 { low.x } else { high.x },
            if i & 2 == 0 { low.y } else { high.y },
            if i & 4 == 0 { low.z } else { high.z },
        )
    })
}
