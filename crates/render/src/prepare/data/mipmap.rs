//! Decoding to linear light, and mip levels.

use glanz_color::{srgb_decode_u8, srgb_encode};
use glanz_scene::{Texture, TextureFilter, Wrap};

/// A texture with all its levels, four channels in 0 … 1.
///
/// Levels are kept as 8-bit codes (sRGB for colours) and decoded by table, so that a texture takes
/// four bytes per texel; averages are made in linear light.
#[derive(Clone, Debug, PartialEq)]
pub struct Mipmap {
    /// The levels, the finest first, down to 1×1.
    pub levels: Vec<MipLevel>,
    /// The linear value of each code of red, green and blue.
    pub decode: [f32; 256],
    /// What happens beyond the border, along u and v.
    pub wrap: [Wrap; 2],
    /// How it is filtered.
    pub filter: TextureFilter,
}

/// One level.
#[derive(Clone, Debug, PartialEq)]
pub struct MipLevel {
    /// Texels in a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Codes by rows from the top.
    pub rgba: Vec<[u8; 4]>,
}

impl Mipmap {
    /// Builds all levels down to 1×1.
    pub fn new(texture: &Texture) -> Self {
        let decode = core::array::from_fn(|code| match texture.srgb {
            true => srgb_decode_u8(code as u8),
            false => code as f32 / 255.0,
        });
        let (width, height) = (texture.width.max(1) as usize, texture.height.max(1) as usize);
        let mut rgba: Vec<[u8; 4]> = texture.rgba.as_chunks::<4>().0.to_vec();
        rgba.resize(width * height, [255; 4]);
        let mut levels = vec![MipLevel { width, height, rgba }];
        while let Some(last) = levels.last().filter(|level| level.width > 1 || level.height > 1) {
            let next = last.halved(&decode, texture.srgb);
            levels.push(next);
        }
        Self { levels, decode, wrap: texture.wrap, filter: texture.filter }
    }

    /// The mean of all texels, as near as 8-bit codes have it.
    pub fn mean(&self) -> [f32; 4] {
        let coarsest = &self.levels[self.levels.len() - 1];
        let [r, g, b, a] = coarsest.rgba[0];
        let [r, g, b] = [r, g, b].map(|code| self.decode[usize::from(code)]);
        [r, g, b, f32::from(a) / 255.0]
    }

    /// The value at texture coordinates `uv`, where a pixel covers `footprint` of them along the
    /// longer axis.
    pub fn sample(&self, uv: [f32; 2], footprint: f32) -> [f32; 4] {
        self.sample_within(uv, footprint, self.wrap)
    }

    /// The same with borders of one's own.
    pub(crate) fn sample_within(&self, uv: [f32; 2], footprint: f32, wrap: [Wrap; 2]) -> [f32; 4] {
        if !(uv[0].is_finite() && uv[1].is_finite()) {
            return [0.0; 4];
        }
        if self.filter == TextureFilter::Nearest {
            let level = &self.levels[0];
            let x = (uv[0] * level.width as f32).floor() as i64;
            let y = (uv[1] * level.height as f32).floor() as i64;
            return self.texel(level, x, y, wrap);
        }
        let finest = &self.levels[0];
        let texels = footprint * finest.width.max(finest.height) as f32;
        let level = if texels > 1.0 { glanz_math::Real::log2(texels) } else { 0.0 };
        let level = level.min((self.levels.len() - 1) as f32);
        let lower = level.floor();
        let fine = self.bilinear(&self.levels[lower as usize], uv, wrap);
        if level == lower {
            return fine;
        }
        let coarse = self.bilinear(&self.levels[lower as usize + 1], uv, wrap);
        mix(fine, coarse, level - lower)
    }

    /// A texel without any filter; black beyond the level.
    pub(crate) fn fetch(&self, level: usize, [x, y]: [i32; 2]) -> [f32; 4] {
        let level = &self.levels[level];
        let inside = |at: i32, size: usize| usize::try_from(at).is_ok_and(|at| at < size);
        match inside(x, level.width) && inside(y, level.height) {
            true => self.texel(level, x.into(), y.into(), self.wrap),
            false => [0.0; 4],
        }
    }

    /// A component of the four texels around a place: left and right with the greater v, right and left with the lesser.
    pub(crate) fn gather(&self, uv: [f32; 2], component: usize, offset: [i32; 3]) -> [f32; 4] {
        if !(uv[0].is_finite() && uv[1].is_finite()) {
            return [0.0; 4];
        }
        let level = &self.levels[0];
        let left = (uv[0] * level.width as f32 - 0.5).floor() as i64 + i64::from(offset[0]);
        let top = (uv[1] * level.height as f32 - 0.5).floor() as i64 + i64::from(offset[1]);
        let places = [(left, top + 1), (left + 1, top + 1), (left + 1, top), (left, top)];
        places.map(|(x, y)| self.texel(level, x, y, self.wrap)[component & 3])
    }

    /// The first of the codes of the four texels around a place, from 0 to 1: numbers, not colours. In the order of
    /// `textureGather`, and how far the place lies from the texel at the left and above.
    pub(crate) fn depths(&self, uv: [f32; 2], offset: [i32; 3]) -> ([f32; 4], [f32; 2]) {
        if !(uv[0].is_finite() && uv[1].is_finite()) {
            return ([0.0; 4], [0.0; 2]);
        }
        let level = &self.levels[0];
        let at = [uv[0] * level.width as f32 - 0.5, uv[1] * level.height as f32 - 0.5];
        let [left, top] = [0, 1].map(|i| at[i].floor() as i64 + i64::from(offset[i]));
        let depth = |(x, y): (i64, i64)| {
            let column = wrapped(left + x, level.width, self.wrap[0]);
            let row = wrapped(top + y, level.height, self.wrap[1]);
            f32::from(level.rgba[row * level.width + column][0]) / 255.0
        };
        ([(0, 1), (1, 1), (1, 0), (0, 0)].map(depth), at.map(|at| at - at.floor()))
    }

    fn bilinear(&self, level: &MipLevel, uv: [f32; 2], wrap: [Wrap; 2]) -> [f32; 4] {
        let x = uv[0] * level.width as f32 - 0.5;
        let y = uv[1] * level.height as f32 - 0.5;
        let (left, top) = (x.floor(), y.floor());
        let (column, row) = (left as i64, top as i64);
        let texel = |x: i64, y: i64| self.texel(level, column + x, row + y, wrap);
        let upper = mix(texel(0, 0), texel(1, 0), x - left);
        let below = mix(texel(0, 1), texel(1, 1), x - left);
        mix(upper, below, y - top)
    }

    fn texel(&self, level: &MipLevel, x: i64, y: i64, wrap: [Wrap; 2]) -> [f32; 4] {
        let column = wrapped(x, level.width, wrap[0]);
        let row = wrapped(y, level.height, wrap[1]);
        let [r, g, b, a] = level.rgba[row * level.width + column];
        let color = |code: u8| self.decode[code as usize];
        [color(r), color(g), color(b), f32::from(a) / 255.0]
    }
}

impl MipLevel {
    /// The level at half the size: means of 2×2 texels in linear light.
    fn halved(&self, decode: &[f32; 256], srgb: bool) -> Self {
        let (width, height) = ((self.width / 2).max(1), (self.height / 2).max(1));
        let mut rgba = Vec::with_capacity(width * height);
        for y in 0..height {
            for x in 0..width {
                let block = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(dx, dy)| {
                    let column = (2 * x + dx).min(self.width - 1);
                    let row = (2 * y + dy).min(self.height - 1);
                    self.rgba[row * self.width + column]
                });
                rgba.push(core::array::from_fn(|c| mean(block.map(|texel| texel[c]), c < 3, decode, srgb)));
            }
        }
        Self { width, height, rgba }
    }
}

fn mean(codes: [u8; 4], color: bool, decode: &[f32; 256], srgb: bool) -> u8 {
    if !color {
        return ((codes.iter().map(|&c| u32::from(c)).sum::<u32>() + 2) / 4) as u8;
    }
    let linear = codes.iter().map(|&code| decode[code as usize]).sum::<f32>() * 0.25;
    let code = if srgb { srgb_encode(linear) } else { linear };
    (code * 255.0 + 0.5) as u8
}

fn mix(a: [f32; 4], b: [f32; 4], t: f32) -> [f32; 4] {
    core::array::from_fn(|c| a[c] + (b[c] - a[c]) * t)
}

fn wrapped(i: i64, size: usize, wrap: Wrap) -> usize {
    let n = size as i64;
    let inside = match wrap {
        Wrap::Repeat => i.rem_euclid(n),
        Wrap::Clamp => i.clamp(0, n - 1),
        Wrap::Mirror => {
            let j = i.rem_euclid(2 * n);
            if j < n { j } else { 2 * n - 1 - j }
        }
    };
    inside as usize
}
