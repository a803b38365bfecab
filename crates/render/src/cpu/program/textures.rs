//! What programs see of the scene's textures.

use glanz_shader::{Lod, TextureQuery, Textures};

use crate::prepare::Mipmap;

/// Coordinates beyond this have no place between texels left.
const FARTHEST: f32 = 1e7;

/// The textures of a stage's samplers; those without any are opaque black.
pub(crate) struct ProgramTextures<'a>(pub Vec<Option<&'a Mipmap>>);

impl ProgramTextures<'_> {
    fn of(&self, texture: usize) -> Option<&Mipmap> {
        self.0.get(texture).copied().flatten()
    }
}

impl Textures for ProgramTextures<'_> {
    fn sample(&self, query: &TextureQuery, texels: &mut [[f32; 16]; 4]) {
        let Some(mipmap) = self.of(query.texture) else { return };
        let finest = &mipmap.levels[0];
        for lane in 0..16 {
            let [u, v, _] = query.coordinates.map(|row| row[lane]);
            let texel = match &query.lod {
                Lod::Texel(level) => {
                    let level = level[lane].clamp(0, mipmap.levels.len() as i32 - 1) as usize;
                    let [x, y] = [u, v].map(|bits| bits.to_bits() as i32);
                    mipmap
                        .fetch(level, [x.saturating_add(query.offset[0]), y.saturating_add(query.offset[1])])
                }
                lod => {
                    let uv = [
                        u.clamp(-FARTHEST, FARTHEST) + query.offset[0] as f32 / finest.width as f32,
                        v.clamp(-FARTHEST, FARTHEST) + query.offset[1] as f32 / finest.height as f32,
                    ];
                    let side = finest.width.max(finest.height) as f32;
                    mipmap.sample(uv, footprint(lod, lane, side))
                }
            };
            for (row, value) in texels.iter_mut().zip(texel) {
                row[lane] = value;
            }
        }
    }

    fn size(&self, texture: usize, level: u32) -> [u32; 3] {
        let Some(mipmap) = self.of(texture) else { return [1; 3] };
        let level = &mipmap.levels[(level as usize).min(mipmap.levels.len() - 1)];
        [level.width as u32, level.height as u32, 1]
    }

    fn levels(&self, texture: usize) -> u32 {
        self.of(texture).map_or(1, |mipmap| mipmap.levels.len() as u32)
    }
}

/// How much of the texture a pixel covers along the longer axis.
fn footprint(lod: &Lod, lane: usize, side: f32) -> f32 {
    match lod {
        Lod::Gradient { dx, dy, bias } => {
            let length = |d: &[[f32; 16]; 3]| {
                let [u, v] = [d[0][lane], d[1][lane]];
                (u * u + v * v).sqrt()
            };
            length(dx).max(length(dy)) * glanz_math::Real::exp2(bias[lane].clamp(-16.0, 16.0))
        }
        Lod::Level(level) => glanz_math::Real::exp2(level[lane].clamp(0.0, 16.0)) / side,
        Lod::Texel(_) => 0.0,
    }
}
