//! Textures from pictures, as Shadertoy and glslViewer look into them.

use glanz_math::Real;

use crate::{CubePlace, Lod, TextureQuery, Textures, panorama_place, turned};

/// A picture as a texture: it repeats, is filtered linearly in and between its levels, and its codes are taken as they
/// are, 0 to 255 for 0 to 1, not decoded from sRGB.
///
/// Its first row lies at v = 0, so v grows upwards: what both Shadertoy and glslViewer make by turning pictures over.
/// Of cube maps the first row of each face is at t = 0, as in OpenGL; filters end at the edges of faces.
#[derive(Clone, Debug, PartialEq)]
pub struct TexturePicture {
    kind: Kind,
    /// One picture, or six of a cube map: their levels, the finest first, down to 1×1.
    faces: Vec<Vec<Level>>,
}

/// How a texture is looked into.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Flat,
    Cube,
    /// By a direction, in equirectangular projection.
    Panorama,
}

/// What happens beyond the border, along u and v.
#[derive(Clone, Copy)]
enum Border {
    Repeat,
    Hold,
}

#[derive(Clone, Debug, PartialEq)]
struct Level {
    size: [usize; 2],
    /// By rows from the bottom.
    texels: Vec<[u8; 4]>,
}

impl TexturePicture {
    /// A texture from RGBA codes by rows from the top; where codes are missing it is white.
    pub fn new(width: u32, height: u32, rgba: &[u8]) -> Self {
        let size = [width.max(1) as usize, height.max(1) as usize];
        let mut texels = rgba.as_chunks::<4>().0.to_vec();
        texels.resize(size[0] * size[1], [255; 4]);
        let texels = texels.chunks(size[0]).rev().collect::<Vec<_>>().concat();
        let mut levels = vec![Level { size, texels }];
        while let Some(last) = levels.last().filter(|level| level.size != [1, 1]) {
            let next = last.halved();
            levels.push(next);
        }
        Self { kind: Kind::Flat, faces: vec![levels] }
    }

    /// A cube map from the pictures of its faces, in OpenGL's order: +X, −X, +Y, −Y, +Z, −Z. `None` if they are not
    /// squares of one size.
    pub fn cube(faces: [Self; 6]) -> Option<Self> {
        let [width, height] = faces[0].size();
        let fits = width == height && faces.iter().all(|face| face.size() == [width, height]);
        let faces = faces.into_iter().flat_map(|face| face.faces.into_iter().take(1)).collect();
        fits.then_some(Self { kind: Kind::Cube, faces })
    }

    /// The same picture, in equirectangular projection, for a cube map's sampler, which looks into it by a direction: −Z in
    /// its middle, +Y at its upper edge.
    #[must_use]
    pub fn panorama(self) -> Self {
        Self { kind: Kind::Panorama, ..self }
    }

    /// Width and height in texels.
    pub fn size(&self) -> [u32; 2] {
        self.faces[0][0].size.map(|side| side as u32)
    }

    /// The texel's value for one fragment.
    fn look(&self, at: [f32; 3], lod: &Lod, lane: usize, offset: [i64; 2]) -> [f32; 4] {
        let of = |d: &[[f32; 16]; 3]| d.map(|row| row[lane]);
        let size = self.faces[0][0].size.map(|side| side as f32);
        let level = |moved: &dyn Fn([f32; 3]) -> f32| match lod {
            Lod::Level(level) => level[lane],
            Lod::Gradient { dx, dy, bias } => level_of(moved(of(dx)).max(moved(of(dy)))) + bias[lane],
            Lod::Texel(_) | Lod::Gather(_) => 0.0,
        };
        let square = |[u, v]: [f32; 2]| (u * size[0]).powi(2) + (v * size[1]).powi(2);
        match self.kind {
            Kind::Flat => {
                let level = level(&|d| square([d[0], d[1]]));
                trilinear(&self.faces[0], [at[0], at[1]], level, offset, [Border::Repeat; 2])
            }
            Kind::Cube => {
                let CubePlace { face, uv: [u, v] } = CubePlace::of(at);
                let level = level(&|d| square(CubePlace::change(at, d)));
                trilinear(&self.faces[face], [u, 1.0 - v], level, [0; 2], [Border::Hold; 2])
            }
            Kind::Panorama => {
                let [u, v] = panorama_place(at);
                let per_radian = 0.5 * size[0] / core::f32::consts::PI;
                let level = level(&|d| (turned(at, d) * per_radian).powi(2));
                trilinear(&self.faces[0], [u, 1.0 - v], level, [0; 2], [Border::Repeat, Border::Hold])
            }
        }
    }

    fn fetch(&self, [x, y]: [i64; 2], level: i32) -> [f32; 4] {
        let level = usize::try_from(level).ok().and_then(|level| self.faces[0].get(level));
        let Some(level) = level else { return [0.0; 4] };
        let inside = |at: i64, side: usize| usize::try_from(at).ok().filter(|at| *at < side);
        match (inside(x, level.size[0]), inside(y, level.size[1])) {
            (Some(x), Some(y)) => values(level.texels[y * level.size[0] + x]),
            _ => [0.0; 4],
        }
    }

    /// A component of the four texels around a place.
    fn gather(&self, uv: [f32; 2], component: usize, offset: [i64; 2]) -> [f32; 4] {
        let level = &self.faces[0][0];
        let at = level.place(uv);
        let texel = |d: i64| level.texel(at, [offset[0] + d % 2, offset[1] + d / 2], [Border::Repeat; 2]);
        [2, 3, 1, 0].map(|d| texel(d)[component & 3])
    }
}

/// The level, as a number, for a square of the way in texels from one pixel to the next (OpenGL 4.6, §8.14, by the longer
/// of the two).
fn level_of(square: f32) -> f32 {
    if square > 0.0 && square.is_finite() { 0.5 * Real::log2(square) } else { 0.0 }
}

fn trilinear(levels: &[Level], uv: [f32; 2], level: f32, offset: [i64; 2], borders: [Border; 2]) -> [f32; 4] {
    let last = (levels.len() - 1) as f32;
    let level = if level.is_nan() { 0.0 } else { level.clamp(0.0, last) };
    let (fine, part) = (level.floor(), level - level.floor());
    let near = levels[fine as usize].bilinear(uv, offset, borders);
    if part == 0.0 {
        return near;
    }
    mix(near, levels[fine as usize + 1].bilinear(uv, offset, borders), part)
}

impl Level {
    /// At half the size: means of 2×2 texels.
    fn halved(&self) -> Self {
        let size = self.size.map(|side| (side / 2).max(1));
        let mut texels = Vec::with_capacity(size[0] * size[1]);
        for y in 0..size[1] {
            for x in 0..size[0] {
                let block = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(dx, dy)| {
                    let column = (2 * x + dx).min(self.size[0] - 1);
                    let row = (2 * y + dy).min(self.size[1] - 1);
                    self.texels[row * self.size[0] + column]
                });
                let mean = |c: usize| (block.iter().map(|texel| u32::from(texel[c])).sum::<u32>() + 2) / 4;
                texels.push(std::array::from_fn(|c| mean(c) as u8));
            }
        }
        Self { size, texels }
    }

    /// A place in texels, 0 being the centre of the first.
    fn place(&self, uv: [f32; 2]) -> [f32; 2] {
        std::array::from_fn(|i| {
            // Inside the first repetition, so that no number is too large for a texel's.
            let part = if (0.0..=1.0).contains(&uv[i]) { uv[i] } else { uv[i] - uv[i].floor() };
            part * self.size[i] as f32 - 0.5
        })
    }

    /// The texel so far from a place.
    fn texel(&self, at: [f32; 2], d: [i64; 2], borders: [Border; 2]) -> [f32; 4] {
        let along = |i: usize| {
            let (at, side) = (at[i].floor() as i64 + d[i], self.size[i] as i64);
            match borders[i] {
                Border::Repeat => at.rem_euclid(side) as usize,
                Border::Hold => at.clamp(0, side - 1) as usize,
            }
        };
        values(self.texels[along(1) * self.size[0] + along(0)])
    }

    fn bilinear(&self, uv: [f32; 2], offset: [i64; 2], borders: [Border; 2]) -> [f32; 4] {
        let at = self.place(uv);
        let texel = |dx: i64, dy: i64| self.texel(at, [offset[0] + dx, offset[1] + dy], borders);
        let part = at.map(|at| if at.is_nan() { 0.0 } else { at - at.floor() });
        let below = mix(texel(0, 0), texel(1, 0), part[0]);
        mix(below, mix(texel(0, 1), texel(1, 1), part[0]), part[1])
    }
}

fn values(texel: [u8; 4]) -> [f32; 4] {
    texel.map(|code| f32::from(code) / 255.0)
}

fn mix(a: [f32; 4], b: [f32; 4], t: f32) -> [f32; 4] {
    std::array::from_fn(|c| a[c] + (b[c] - a[c]) * t)
}

/// The pictures of a program's textures, in their order; opaque black where there is none.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Pictures(pub Vec<Option<TexturePicture>>);

impl Pictures {
    fn get(&self, texture: usize) -> Option<&TexturePicture> {
        self.0.get(texture)?.as_ref()
    }
}

impl Textures for Pictures {
    fn sample(&self, query: &TextureQuery, texels: &mut [[f32; 16]; 4]) {
        let Some(picture) = self.get(query.texture) else { return };
        let offset = [query.offset[0], query.offset[1]].map(i64::from);
        for lane in 0..16 {
            let at = query.coordinates.map(|row| row[lane]);
            let color = match &query.lod {
                Lod::Texel(level) => {
                    picture.fetch([at[0], at[1]].map(|x| i64::from(x.to_bits() as i32)), level[lane])
                }
                Lod::Gather(component) => picture.gather([at[0], at[1]], *component, offset),
                lod => picture.look(at, lod, lane, offset),
            };
            for (row, value) in texels.iter_mut().zip(color) {
                row[lane] = value;
            }
        }
    }

    fn size(&self, texture: usize, level: u32) -> [u32; 3] {
        let Some(picture) = self.get(texture) else { return [1; 3] };
        let Some(level) = picture.faces[0].get(level as usize) else { return [0; 3] };
        let [width, height] = level.size.map(|side| side as u32);
        match picture.kind {
            Kind::Flat | Kind::Cube => [width, height, 1],
            // As many texels as a cube's face would have to look as fine in its middle.
            Kind::Panorama => [width.div_ceil(4), width.div_ceil(4), 1],
        }
    }

    fn levels(&self, texture: usize) -> u32 {
        self.get(texture).map_or(1, |picture| picture.faces[0].len() as u32)
    }
}
