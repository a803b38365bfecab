//! Textures from pictures, as Shadertoy and glslViewer look into them.

use std::sync::Arc;

use super::ScreenPicture;
use super::levels::{Border, Level, Sampling, level_of, trilinear};
use crate::{CubePlace, Lod, TextureQuery, Textures, compared, panorama_place, turned};

/// A picture as a texture: it repeats, is filtered linearly in and between its levels, and its codes are taken as they
/// are, 0 to 255 for 0 to 1, not decoded from sRGB.
///
/// Its first row lies at v = 0, so v grows upwards: what both Shadertoy and glslViewer make by turning pictures over.
/// Of cube maps the first row of each face is at t = 0, as in OpenGL; filters end at the edges of faces.
#[derive(Clone, Debug, PartialEq)]
pub struct TexturePicture {
    kind: Kind,
    sampling: Sampling,
    /// One picture, or six of a cube map: their levels, the finest first, down to 1×1.
    faces: Arc<Vec<Vec<Level>>>,
}

/// How a texture is looked into.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Flat,
    Cube,
    /// By a direction, in equirectangular projection.
    Panorama,
}

impl TexturePicture {
    /// A texture from RGBA codes by rows from the top; where codes are missing it is white.
    pub fn new(width: u32, height: u32, rgba: &[u8]) -> Self {
        let size = [width.max(1) as usize, height.max(1) as usize];
        let mut texels = rgba.as_chunks::<4>().0.to_vec();
        texels.resize(size[0] * size[1], [255; 4]);
        let texels = texels.chunks(size[0]).rev().collect::<Vec<_>>().concat();
        Self::flat(Level::of_codes(size, texels), Border::Repeat)
    }

    /// A texture of what another pass drew: its numbers are not cut, and its borders go on.
    pub fn of_pass(picture: &ScreenPicture) -> Self {
        let texels = picture.pixels.chunks(picture.width.max(1)).rev().collect::<Vec<_>>().concat();
        Self::flat(Level::of_numbers([picture.width, picture.height], texels), Border::Hold)
    }

    fn flat(level: Level, border: Border) -> Self {
        let faces = Arc::new(vec![level.with_smaller()]);
        Self { kind: Kind::Flat, sampling: Sampling { borders: [border; 2], nearest: false }, faces }
    }

    /// The same picture with other borders.
    #[must_use]
    pub fn bordered(mut self, border: Border) -> Self {
        self.sampling.borders = [border; 2];
        self
    }

    /// The same picture, of which looks give the nearest texel, not a mean of four.
    #[must_use]
    pub fn nearest(mut self) -> Self {
        self.sampling.nearest = true;
        self
    }

    /// A cube map from the pictures of its faces, in OpenGL's order: +X, −X, +Y, −Y, +Z, −Z. `None` if they are not
    /// squares of one size.
    pub fn cube(faces: [Self; 6]) -> Option<Self> {
        let [width, height] = faces[0].size();
        let fits = width == height && faces.iter().all(|face| face.size() == [width, height]);
        let sampling = Sampling { borders: [Border::Hold; 2], nearest: faces[0].sampling.nearest };
        let faces = Arc::new(faces.iter().flat_map(|face| face.faces.iter().take(1).cloned()).collect());
        fits.then_some(Self { kind: Kind::Cube, sampling, faces })
    }

    /// The same picture, in equirectangular projection, for a cube map's sampler, which looks into it by a direction: −Z in
    /// its middle, +Y at its upper edge.
    #[must_use]
    pub fn panorama(self) -> Self {
        let sampling = Sampling { borders: [Border::Repeat, Border::Hold], ..self.sampling };
        Self { kind: Kind::Panorama, sampling, ..self }
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
                trilinear(&self.faces[0], [at[0], at[1]], level, offset, self.sampling)
            }
            Kind::Cube => {
                let CubePlace { face, uv: [u, v] } = CubePlace::of(at);
                let level = level(&|d| square(CubePlace::change(at, d)));
                trilinear(&self.faces[face], [u, 1.0 - v], level, [0; 2], self.sampling)
            }
            Kind::Panorama => {
                let [u, v] = panorama_place(at);
                let per_radian = 0.5 * size[0] / core::f32::consts::PI;
                let level = level(&|d| (turned(at, d) * per_radian).powi(2));
                trilinear(&self.faces[0], [u, 1.0 - v], level, [0; 2], self.sampling)
            }
        }
    }

    fn fetch(&self, [x, y]: [i64; 2], level: i32) -> [f32; 4] {
        let level = usize::try_from(level).ok().and_then(|level| self.faces[0].get(level));
        let Some(level) = level else { return [0.0; 4] };
        let inside = |at: i64, side: usize| usize::try_from(at).ok().filter(|at| *at < side);
        match (inside(x, level.size[0]), inside(y, level.size[1])) {
            (Some(x), Some(y)) => level.values([x, y]),
            _ => [0.0; 4],
        }
    }

    /// The share of the texels around a place that a depth does not exceed.
    fn compared(&self, uv: [f32; 2], depth: f32, offset: [i64; 2]) -> f32 {
        let part = self.faces[0][0].place(uv, self.sampling.borders).map(|at| at - at.floor());
        let part = if self.sampling.nearest { part.map(f32::round) } else { part };
        compared(self.gather(uv, 0, offset), part.map(|x| if x.is_nan() { 0.0 } else { x }), depth)
    }

    /// A component of the four texels around a place.
    fn gather(&self, uv: [f32; 2], component: usize, offset: [i64; 2]) -> [f32; 4] {
        let level = &self.faces[0][0];
        let borders = self.sampling.borders;
        let at = level.place(uv, borders);
        let texel = |d: i64| level.texel(at, [offset[0] + d % 2, offset[1] + d / 2], borders);
        [2, 3, 1, 0].map(|d| texel(d)[component & 3])
    }
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
                lod => match &query.compare {
                    Some(depth) => [picture.compared([at[0], at[1]], depth[lane], offset), 0.0, 0.0, 1.0],
                    None => picture.look(at, lod, lane, offset),
                },
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
