//! Draws the benchmark's sphere with the crate euc and prints one JSON line per measurement.
//!
//! The work is that of `cargo xtask bench`: 1920×1080, one sphere whose silhouette is 70 % of the
//! height, Phong shading, Phong's model of 1975, point lights with attenuation, into RGBA8. euc uses
//! one thread and writes linear values as they are; Glanz also encodes sRGB.
//!
//! Build with `-C target-cpu=native`: euc relies on fused multiply-add, which is slow without.

use std::f32::consts::PI;
use std::hint::black_box;
use std::time::Instant;

use euc::buffer::Buffer2d;
use euc::rasterizer::Triangles;
use euc::{Pipeline, Target};
use vek::{Mat4, Vec3, Vec4};

const WIDTH: usize = 1920;
const HEIGHT: usize = 1080;
const FOV_Y: f32 = 40.0 * PI / 180.0;
const SILHOUETTE: f32 = 0.7;
const BACKGROUND: [u8; 4] = [13, 13, 20, 255];
const SHININESS: f32 = 32.0;

/// The scene: one sphere, `N` lights.
struct Sphere<'a, const N: usize> {
    view_projection: Mat4<f32>,
    points: &'a [Vec3<f32>],
    eye: Vec3<f32>,
    lights: [(Vec3<f32>, Vec3<f32>); N],
    attenuation: [f32; 3],
    ambient: Vec3<f32>,
    diffuse: Vec3<f32>,
    specular: Vec3<f32>,
}

impl<const N: usize> Pipeline for Sphere<'_, N> {
    type Vertex = u32;
    /// Position and normal in the world.
    type VsOut = (Vec3<f32>, Vec3<f32>);
    type Pixel = [u8; 4];

    #[inline(always)]
    fn vert(&self, &index: &u32) -> ([f32; 4], Self::VsOut) {
        let point = self.points[index as usize];
        ((self.view_projection * Vec4::from_point(point)).into_array(), (point, point))
    }

    #[inline(always)]
    fn frag(&self, &(world, normal): &Self::VsOut) -> [u8; 4] {
        let mut n = normal / normal.dot(normal).sqrt();
        let to_eye = self.eye - world;
        let v = to_eye / to_eye.dot(to_eye).sqrt();
        if n.dot(v) < 0.0 {
            n = -n;
        }
        let mut sum = self.ambient;
        for (position, color) in &self.lights {
            let to_light = *position - world;
            let d2 = to_light.dot(to_light);
            let d = d2.sqrt();
            let l = to_light / d;
            let n_l = n.dot(l);
            if n_l > 0.0 {
                let [constant, linear, quadratic] = self.attenuation;
                let fade = 1.0 / (constant + linear * d + quadratic * d2);
                let r = n * (2.0 * n_l) - l;
                let highlight = r.dot(v).max(0.0).powf(SHININESS);
                sum += *color * fade * (self.diffuse * n_l + self.specular * highlight);
            }
        }
        let code = |x: f32| (x.clamp(0.0, 1.0) * 255.0 + 0.5) as u8;
        [code(sum.x), code(sum.y), code(sum.z), 255]
    }
}

/// Vertices and triangle corners of a unit sphere with its poles on Y.
fn sphere(slices: u32, stacks: u32) -> (Vec<Vec3<f32>>, Vec<u32>) {
    let mut points = Vec::new();
    for row in 0..=stacks {
        for column in 0..=slices {
            let theta = PI * row as f32 / stacks as f32;
            let phi = 2.0 * PI * column as f32 / slices as f32;
            points.push(Vec3::new(theta.sin() * phi.sin(), theta.cos(), theta.sin() * phi.cos()));
        }
    }
    let mut corners = Vec::new();
    for row in 0..stacks {
        for column in 0..slices {
            let a = row * (slices + 1) + column;
            let (b, c, d) = (a + slices + 1, a + slices + 2, a + 1);
            if row > 0 {
                corners.extend([a, b, d]);
            }
            if row < stacks - 1 {
                corners.extend([b, c, d]);
            }
        }
    }
    (points, corners)
}

/// Positions on a circle before the sphere; together they are as bright as one white light.
fn lights<const N: usize>() -> [(Vec3<f32>, Vec3<f32>); N] {
    std::array::from_fn(|i| {
        let angle = 2.0 * PI * (i as f32 + 0.125) / N as f32;
        (Vec3::new(3.0 * angle.cos(), 3.0 * angle.sin(), 3.0), Vec3::broadcast(1.0 / N as f32))
    })
}

/// Measures one sphere under `N` lights.
fn measure<const N: usize>(slices: u32, stacks: u32, frames: usize) {
    let (points, corners) = sphere(slices, stacks);
    // The distance at which a unit sphere's outline covers that part of the height.
    let distance = (1.0 / (SILHOUETTE * (FOV_Y / 2.0).tan())).hypot(1.0);
    let scene = Sphere::<N> {
        view_projection: Mat4::perspective_fov_rh_no(FOV_Y, WIDTH as f32, HEIGHT as f32, 0.1, 100.0)
            * Mat4::translation_3d(Vec3::new(0.0, 0.0, -distance)),
        points: &points,
        eye: Vec3::new(0.0, 0.0, distance),
        lights: lights(),
        attenuation: black_box([1.0, 0.0, 0.0]),
        ambient: Vec3::new(0.05, 0.01, 0.01),
        diffuse: Vec3::new(0.8, 0.1, 0.1),
        specular: Vec3::new(0.6, 0.6, 0.6),
    };
    let mut color = Buffer2d::new([WIDTH, HEIGHT], BACKGROUND);
    let mut depth = Buffer2d::new([WIDTH, HEIGHT], 1.0);
    let mut times = Vec::new();
    for frame in 0..frames + frames / 4 {
        let start = Instant::now();
        color.clear(BACKGROUND);
        depth.clear(1.0);
        scene.draw::<Triangles<_>, _>(&corners, &mut color, Some(&mut depth));
        black_box(color.as_ref());
        if frame >= frames / 4 {
            times.push(1e3 * start.elapsed().as_secs_f64());
        }
    }
    check(color.as_ref(), slices);
    print_times(times, &format!("{slices}x{stacks}"), corners.len() / 3, N);
}

/// Prints what was measured as a line of JSON.
fn print_times(mut times: Vec<f64>, sphere: &str, triangles: usize, lights: usize) {
    times.sort_by(f64::total_cmp);
    let round = |ms: f64| (ms * 1e3).round() / 1e3;
    let result = serde_json::json!({
        "program": "euc",
        "version": "0.5.3",
        "threads": 1,
        "sphere": sphere,
        "triangles": triangles,
        "lights": lights,
        "frames": times.len(),
        "median_ms": round(times[times.len() / 2]),
        "min_ms": round(times[0]),
        "max_ms": round(times[times.len() - 1]),
    });
    println!("{result}");
}

/// Stops where the picture is not the one that everybody draws.
fn check(picture: &[[u8; 4]], slices: u32) {
    let covered = picture.iter().filter(|pixel| **pixel != BACKGROUND).count() as f32;
    let fraction = covered / (PI * (SILHOUETTE * HEIGHT as f32 / 2.0).powi(2));
    // A polygon with this many corners covers less than the circle around it.
    let corner = 2.0 * PI / slices as f32;
    let expected = corner.sin() / corner;
    assert!(
        (expected - 0.02..1.01).contains(&fraction),
        "the sphere covers {fraction:.3} of its circle; {expected:.3} was expected"
    );
}

fn main() {
    let quick = std::env::args().any(|arg| arg == "--quick");
    for (slices, stacks, frames) in [(64, 32, 60), (1024, 512, 20)] {
        let frames = if quick { frames / 4 } else { frames };
        measure::<1>(slices, stacks, frames);
        measure::<4>(slices, stacks, frames);
        measure::<8>(slices, stacks, frames);
    }
}
