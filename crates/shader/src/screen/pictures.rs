//! Textures from pictures, as Shadertoy and glslViewer look into them.

use glanz_math::Real;

use crate::{Lod, TextureQuery, Textures};

/// A picture as a texture: it repeats, is filtered linearly in and between its levels, and its codes are taken as they
/// are, 0 to 255 for 0 to 1, not decoded from sRGB.
///
/// Its first row lies at v = 0, so v grows upwards: what both Shadertoy and glslViewer make by turning pictures over.
#[derive(Clone, Debug, PartialEq)]
pub struct TexturePicture {
    /// The finest first, down to 1×1.
    levels: Vec<Level>,
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
        Self { levels }
    }

    /// Width and height in texels.
    pub fn size(&self) -> [u32; 2] {
        self.levels[0].size.map(|side| side as u32)
    }

    /// The level, as a number, for coordinates that change so from pixel to pixel (OpenGL 4.6, §8.14, by the longer of the
    /// two changes).
    fn level_of(&self, dx: [f32; 2], dy: [f32; 2]) -> f32 {
        let size = self.levels[0].size.map(|side| side as f32);
        let square = |d: [f32; 2]| (d[0] * size[0]).powi(2) + (d[1] * size[1]).powi(2);
        let most = square(dx).max(square(dy));
        if most > 0.0 && most.is_finite() { 0.5 * Real::log2(most) } else { 0.0 }
    }

    fn trilinear(&self, uv: [f32; 2], level: f32, offset: [i64; 2]) -> [f32; 4] {
        let last = (self.levels.len() - 1) as f32;
        let level = if level.is_nan() { 0.0 } else { level.clamp(0.0, last) };
        let (fine, part) = (level.floor(), level - level.floor());
        let near = self.levels[fine as usize].bilinear(uv, offset);
        if part == 0.0 {
            return near;
        }
        mix(near, self.levels[fine as usize + 1].bilinear(uv, offset), part)
    }

    fn fetch(&self, [x, y]: [i64; 2], level: i32) -> [f32; 4] {
        let level = usize::try_from(level).ok().and_then(|level| self.levels.get(level));
        let Some(level) = level else { return [0.0; 4] };
        let inside = |at: i64, side: usize| usize::try_from(at).ok().filter(|at| *at < side);
        match (inside(x, level.size[0]), inside(y, level.size[1])) {
            (Some(x), Some(y)) => values(level.texels[y * level.size[0] + x]),
            _ => [0.0; 4],
        }
    }
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

    fn bilinear(&self, uv: [f32; 2], offset: [i64; 2]) -> [f32; 4] {
        let at: [f32; 2] = std::array::from_fn(|i| {
            // Inside the first repetition, so that no number is too large for a texel's.
            let part = uv[i] - uv[i].floor();
            part * self.size[i] as f32 - 0.5
        });
        let texel = |dx: i64, dy: i64| {
            let along = |i: usize, d: i64| {
                (at[i].floor() as i64 + offset[i] + d).rem_euclid(self.size[i] as i64) as usize
            };
            values(self.texels[along(1, dy) * self.size[0] + along(0, dx)])
        };
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
            let uv = [0, 1].map(|i| query.coordinates[i][lane]);
            let color = match &query.lod {
                Lod::Texel(level) => picture.fetch(uv.map(|x| i64::from(x.to_bits() as i32)), level[lane]),
                Lod::Level(level) => picture.trilinear(uv, level[lane], offset),
                Lod::Gradient { dx, dy, bias } => {
                    let level = picture.level_of([0, 1].map(|i| dx[i][lane]), [0, 1].map(|i| dy[i][lane]));
                    picture.trilinear(uv, level + bias[lane], offset)
                }
            };
            for (row, value) in texels.iter_mut().zip(color) {
                row[lane] = value;
            }
        }
    }

    fn size(&self, texture: usize, level: u32) -> [u32; 3] {
        let side = |side: usize| side as u32;
        let Some(picture) = self.get(texture) else { return [1; 3] };
        picture
            .levels
            .get(level as usize)
            .map_or([0; 3], |level| [side(level.size[0]), side(level.size[1]), 1])
    }

    fn levels(&self, texture: usize) -> u32 {
        self.get(texture).map_or(1, |picture| picture.levels.len() as u32)
    }
}
