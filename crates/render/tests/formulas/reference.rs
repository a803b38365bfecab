//! The picture by the documents' formulas, in `f64`, pixel by pixel, from the scene alone.

use glam::{DMat3, DVec2, DVec3};
use glanz_color::Rgb;
use glanz_scene::{
    Attenuation, Camera, ClassicMaterial, Interpolation, Light, LightColor, LightKind, Projection, Scene,
    Shading, Space, Tint,
};

/// Pixels whose centre is nearer than this to an edge (in pixels) are not compared: corners on a grid
/// of 1/256 pixel may put them on the other side.
const EDGE: f64 = 0.02;
/// Where a value jumps (at cosines of 0 and at the rim of a cone), this far to both sides nothing is
/// compared: single precision may fall on the other side.
const JUMP: f64 = 1e-5;

type Color = [f64; 3];

/// A triangle in the world, of a facet.
struct Triangle {
    corners: [u32; 3],
    at: [DVec3; 3],
    facet: usize,
}

/// What a pixel sees.
pub(crate) struct Hit {
    pub pixel: usize,
    triangle: usize,
    point: DVec3,
    /// Weights of the corners on the surface, and on the screen.
    weights: [[f64; 3]; 2],
    pub back: bool,
    wo: DVec3,
}

/// The visible surface of a scene with one object.
pub(crate) struct Reference {
    camera: Camera,
    axes: [DVec3; 3],
    triangles: Vec<Triangle>,
    /// Vertex normals in the world; not of unit length under uneven scale. Document 003 interpolates
    /// them so and normalises at the pixel, which is the normal that the surface had before the scale.
    normals: Vec<DVec3>,
    /// Centroid and unit normal of each facet in the world.
    facets: Vec<(DVec3, DVec3)>,
    positions: Vec<DVec3>,
    pub hits: Vec<Hit>,
}

/// How light at a point is found.
pub(crate) struct Lighting<'a> {
    pub lights: &'a [Light],
    pub material: &'a ClassicMaterial,
    pub two_sided: bool,
    pub shading: Shading,
    pub interpolation: Interpolation,
}

impl Reference {
    pub(crate) fn new(scene: &Scene, width: usize, height: usize) -> Self {
        let object = &scene.objects[0];
        let (mesh, camera) = (&scene.meshes[object.mesh], scene.camera.unwrap());
        let place = |p: glam::Vec3| object.transform.transform_point3(p.as_dvec3());
        let linear = DMat3::from_mat4(object.transform);
        let normal_matrix = linear.inverse().transpose();
        let outwards = linear.determinant().signum();
        let positions: Vec<DVec3> = mesh.positions.iter().map(|&p| place(p)).collect();
        let triangles: Vec<Triangle> = mesh
            .faces()
            .enumerate()
            .flat_map(|(facet, face)| (2..face.len()).map(move |i| (facet, [face[0], face[i - 1], face[i]])))
            .map(|(facet, corners)| Triangle { corners, at: corners.map(|c| positions[c as usize]), facet })
            .collect();
        let back = (camera.eye - camera.target).normalize();
        let right = camera.up.cross(back).normalize();
        let mut reference = Self {
            camera,
            axes: [right, back.cross(right), back],
            facets: mesh.faces().map(|face| facet(&positions, face, outwards)).collect(),
            normals: mesh.normals.iter().map(|n| normal_matrix * n.as_dvec3()).collect(),
            triangles,
            positions,
            hits: Vec::new(),
        };
        reference.hits =
            (0..width * height).filter_map(|pixel| reference.see(pixel, width, height, outwards)).collect();
        reference
    }

    /// Pixels per metre at distance 1, or everywhere.
    fn scale(&self, height: usize) -> f64 {
        0.5 * height as f64
            / match self.camera.projection {
                Projection::Perspective { fov_y } => (0.5 * fov_y).tan(),
                Projection::Orthographic { height } => 0.5 * height,
            }
    }

    /// The point on the screen relative to the centre, y upwards; in metres at distance 1.
    fn project(&self, p: DVec3) -> DVec2 {
        let [x, y, z] = self.axes.map(|axis| axis.dot(p - self.camera.eye));
        match self.camera.projection {
            Projection::Perspective { .. } => DVec2::new(x, y) / -z,
            Projection::Orthographic { .. } => DVec2::new(x, y),
        }
    }

    fn see(&self, pixel: usize, width: usize, height: usize, outwards: f64) -> Option<Hit> {
        let scale = self.scale(height);
        let x = ((pixel % width) as f64 + 0.5 - 0.5 * width as f64) / scale;
        let y = (0.5 * height as f64 - (pixel / width) as f64 - 0.5) / scale;
        let [right, up, back] = self.axes;
        let (origin, direction) = match self.camera.projection {
            Projection::Perspective { .. } => (self.camera.eye, right * x + up * y - back),
            Projection::Orthographic { .. } => (self.camera.eye + right * x + up * y, -back),
        };
        let mut nearest: Option<(f64, Hit)> = None;
        for (number, triangle) in self.triangles.iter().enumerate() {
            let screen = triangle.at.map(|p| self.project(p));
            let at = DVec2::new(x, y);
            if (0..3).any(|i| distance_to_edge(at, screen[i], screen[(i + 1) % 3]) * scale < EDGE) {
                return None;
            }
            let Some((distance, on_surface)) = intersect(origin, direction, triangle.at) else { continue };
            if nearest.as_ref().is_some_and(|(before, _)| *before < distance) {
                continue;
            }
            let [a, b, c] = triangle.at;
            let facing = (b - a).cross(c - a) * outwards;
            let point = origin + direction * distance;
            let hit = Hit {
                pixel,
                triangle: number,
                point,
                weights: [on_surface, flat_weights(at, screen)],
                back: facing.dot(direction) > 0.0,
                wo: self.to_viewer(point),
            };
            nearest = Some((distance, hit));
        }
        nearest.map(|(_, hit)| hit)
    }

    fn to_viewer(&self, point: DVec3) -> DVec3 {
        match self.camera.projection {
            Projection::Perspective { .. } => (self.camera.eye - point).normalize(),
            Projection::Orthographic { .. } => self.axes[2],
        }
    }

    /// The colour of a hit, or `None` where a jump is too near to compare.
    pub(crate) fn color(&self, hit: &Hit, lighting: &Lighting) -> Option<Color> {
        let triangle = &self.triangles[hit.triangle];
        let weights = hit.weights[usize::from(lighting.interpolation == Interpolation::ScreenLinear)];
        let side = match (hit.back, lighting.two_sided) {
            (false, _) => 1.0,
            (true, true) => -1.0,
            (true, false) => 0.0,
        };
        let lit = |point, normal: DVec3, wo| self.light(point, normal * side, wo, lighting);
        match lighting.shading {
            Shading::Flat => {
                let (centroid, normal) = self.facets[triangle.facet];
                lit(centroid, normal, self.to_viewer(centroid))
            }
            Shading::Gouraud => {
                let mut sum = [0.0; 3];
                for (corner, weight) in triangle.corners.iter().zip(weights) {
                    let at = self.positions[*corner as usize];
                    let value = lit(at, self.normals[*corner as usize].normalize(), self.to_viewer(at))?;
                    (0..3).for_each(|c| sum[c] += weight * value[c]);
                }
                Some(sum)
            }
            Shading::Phong => {
                let corners = triangle.corners.iter().zip(weights);
                let normal: DVec3 = corners.map(|(corner, w)| self.normals[*corner as usize] * w).sum();
                lit(hit.point, normal.normalize(), hit.wo)
            }
        }
    }

    /// The sum over lights. A normal of zero is a surface that only ambient light reaches.
    fn light(&self, point: DVec3, normal: DVec3, wo: DVec3, lighting: &Lighting) -> Option<Color> {
        let material = lighting.material;
        let mut sum = wide(material.emission.rgb().expect("RGB alone"));
        for light in lighting.lights {
            let (towards, attenuation, cone) = self.arrive(light, point)?;
            let add = |sum: &mut Color, light: &LightColor, tint: &Tint, factor: f64| {
                let (LightColor::Rgb(light), Tint::Rgb(tint)) = (light, tint) else { panic!("RGB alone") };
                (0..3).for_each(|c| sum[c] += wide(*light)[c] * wide(*tint)[c] * factor);
            };
            add(&mut sum, &light.colors.ambient, &material.ambient, cone);
            if light.kind == LightKind::Ambient || normal == DVec3::ZERO {
                continue;
            }
            let cosine = normal.dot(towards);
            if cosine.abs() < JUMP {
                return None;
            }
            if cosine > 0.0 {
                add(&mut sum, &light.colors.diffuse, &material.diffuse, cosine * attenuation * cone);
                let highlight = highlight(material, normal, towards, wo, cosine);
                add(&mut sum, &light.colors.specular, &material.specular, highlight * attenuation * cone);
            }
        }
        Some(sum)
    }

    /// Unit vector towards the light, attenuation and cone factor; `None` near the rim of a cone.
    fn arrive(&self, light: &Light, point: DVec3) -> Option<(DVec3, f64, f64)> {
        let turn = |d: DVec3| match light.space {
            Space::World => d,
            Space::Camera => self.axes[0] * d.x + self.axes[1] * d.y + self.axes[2] * d.z,
        };
        let place = |p: DVec3| match light.space {
            Space::World => p,
            Space::Camera => self.camera.eye + turn(p),
        };
        Some(match light.kind {
            LightKind::Ambient => (DVec3::ZERO, 0.0, 1.0),
            LightKind::Directional { direction } => (-turn(direction).normalize(), 1.0, 1.0),
            LightKind::Point { position, attenuation } => {
                let way = place(position) - point;
                (way.normalize(), fade(attenuation, way.length()), 1.0)
            }
            LightKind::Spot { position, direction, cutoff, exponent, attenuation, .. } => {
                let way = place(position) - point;
                let cosine = -way.normalize().dot(turn(direction).normalize());
                if (cosine - cutoff.cos()).abs() < JUMP {
                    return None;
                }
                let cone = if cosine < cutoff.cos() { 0.0 } else { cosine.max(0.0).powf(exponent) };
                (way.normalize(), fade(attenuation, way.length()), cone)
            }
            LightKind::Area { .. } | LightKind::Environment { .. } => {
                panic!("lights of the classic kinds alone")
            }
        })
    }
}

fn fade(Attenuation { constant, linear, quadratic }: Attenuation, distance: f64) -> f64 {
    1.0 / (constant + linear * distance + quadratic * distance * distance)
}

/// What the highlight makes of light 1, in classic units: f_cos times π.
fn highlight(material: &ClassicMaterial, normal: DVec3, wi: DVec3, wo: DVec3, cosine: f64) -> f64 {
    let n = material.shininess;
    let mirrored = 2.0 * cosine * normal - wi;
    let phong = mirrored.dot(wo).max(0.0).powf(n);
    let blinn = normal.dot((wi + wo).normalize()).max(0.0).powf(n);
    match &material.model[..] {
        "lambert" => 0.0,
        "phong" => phong,
        "phong-normalized" => (n + 2.0) / 2.0 * phong * cosine,
        "blinn-phong" => blinn,
        "blinn-phong-normalized" => (n + 2.0) * (n + 4.0) / (8.0 * ((-0.5 * n).exp2() + n)) * blinn * cosine,
        other => panic!("no formula for {other}"),
    }
}

fn wide(color: Rgb) -> Color {
    color.0.map(f64::from)
}

/// Area centroid and outward unit normal of a flat convex polygon.
fn facet(positions: &[DVec3], face: &[u32], outwards: f64) -> (DVec3, DVec3) {
    let at = |i: usize| positions[face[i] as usize];
    let (mut area, mut center, mut total) = (DVec3::ZERO, DVec3::ZERO, 0.0);
    for i in 2..face.len() {
        let part = (at(i - 1) - at(0)).cross(at(i) - at(0));
        area += part;
        center += (at(0) + at(i - 1) + at(i)) / 3.0 * part.length();
        total += part.length();
    }
    (center / total, area.normalize() * outwards)
}

/// Distance along the ray, and the weights of the three corners (Möller & Trumbore 1997).
fn intersect(origin: DVec3, direction: DVec3, [a, b, c]: [DVec3; 3]) -> Option<(f64, [f64; 3])> {
    let (ab, ac) = (b - a, c - a);
    let p = direction.cross(ac);
    let determinant = ab.dot(p);
    let s = origin - a;
    let u = s.dot(p) / determinant;
    let q = s.cross(ab);
    let v = direction.dot(q) / determinant;
    let distance = ac.dot(q) / determinant;
    (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && distance > 0.0).then_some((distance, [1.0 - u - v, u, v]))
}

/// Weights of three screen points.
fn flat_weights(p: DVec2, [a, b, c]: [DVec2; 3]) -> [f64; 3] {
    let area = (b - a).perp_dot(c - a);
    let u = (p - a).perp_dot(c - a) / area;
    let v = (b - a).perp_dot(p - a) / area;
    [1.0 - u - v, u, v]
}

fn distance_to_edge(p: DVec2, a: DVec2, b: DVec2) -> f64 {
    let along = b - a;
    let t = ((p - a).dot(along) / along.length_squared().max(1e-300)).clamp(0.0, 1.0);
    (p - a - along * t).length()
}
