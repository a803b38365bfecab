//! What programs see of the scene's textures and its environment.

use glanz_math::{Real, Vec3};
use glanz_scene::Wrap;
use glanz_shader::{CubePlace, Lod, TextureQuery, Textures, compared, panorama_place, turned};

use crate::prepare::{EnvironmentMap, Mipmap};
use crate::view::program::{EnvironmentPicture, ProgramPicture};

/// Coordinates beyond this have no place between texels left.
const FARTHEST: f32 = 1e7;

/// The pictures of a stage's samplers; those without any are opaque black.
pub(crate) struct ProgramTextures<'a>(pub Vec<Option<ProgramPicture<'a>>>);

impl ProgramTextures<'_> {
    fn of(&self, texture: usize) -> Option<&ProgramPicture<'_>> {
        self.0.get(texture)?.as_ref()
    }
}

impl Textures for ProgramTextures<'_> {
    fn sample(&self, query: &TextureQuery, texels: &mut [[f32; 16]; 4]) {
        let Some(picture) = self.of(query.texture) else { return };
        for lane in 0..16 {
            let at = query.coordinates.map(|row| row[lane]);
            let texel = match picture {
                ProgramPicture::Flat(mipmap) => match &query.compare {
                    Some(depth) => shadow(mipmap, query, [at[0], at[1]], depth[lane]),
                    None => flat(mipmap, query, [at[0], at[1]], lane),
                },
                ProgramPicture::Cube(faces) => cube(faces, at, &query.lod, lane),
                ProgramPicture::Panorama(mipmap) => panorama(mipmap, at, &query.lod, lane),
                ProgramPicture::Environment(environment) => around(environment, at, &query.lod, lane),
            };
            for (row, value) in texels.iter_mut().zip(texel) {
                row[lane] = value;
            }
        }
    }

    fn size(&self, texture: usize, level: u32) -> [u32; 3] {
        let of = |mipmap: &Mipmap| {
            let level = &mipmap.levels[(level as usize).min(mipmap.levels.len() - 1)];
            [level.width as u32, level.height as u32, 1]
        };
        // As many texels as a cube's face would have to look as fine in its middle.
        let face = |width: u32| [width.div_ceil(4), width.div_ceil(4), 1];
        match self.of(texture) {
            Some(ProgramPicture::Flat(mipmap) | ProgramPicture::Cube([mipmap, ..])) => of(mipmap),
            Some(ProgramPicture::Panorama(mipmap)) => face(of(mipmap)[0]),
            Some(ProgramPicture::Environment(EnvironmentPicture { map: Some(map), .. })) => {
                face(map.level(level as usize).width as u32)
            }
            Some(ProgramPicture::Environment(_)) | None => [1; 3],
        }
    }

    fn levels(&self, texture: usize) -> u32 {
        match self.of(texture) {
            Some(
                ProgramPicture::Flat(mipmap)
                | ProgramPicture::Cube([mipmap, ..])
                | ProgramPicture::Panorama(mipmap),
            ) => mipmap.levels.len() as u32,
            Some(ProgramPicture::Environment(environment)) => {
                environment.map.map_or(1, |map| map.level_count() as u32)
            }
            None => 1,
        }
    }
}

fn flat(mipmap: &Mipmap, query: &TextureQuery, [u, v]: [f32; 2], lane: usize) -> [f32; 4] {
    let finest = &mipmap.levels[0];
    let inside = |x: f32| x.clamp(-FARTHEST, FARTHEST);
    match &query.lod {
        Lod::Texel(level) => {
            let level = level[lane].clamp(0, mipmap.levels.len() as i32 - 1) as usize;
            let [x, y] = [u, v].map(|bits| bits.to_bits() as i32);
            mipmap.fetch(level, [x.saturating_add(query.offset[0]), y.saturating_add(query.offset[1])])
        }
        Lod::Gather(component) => mipmap.gather([inside(u), inside(v)], *component, query.offset),
        lod => {
            let uv = [
                inside(u) + query.offset[0] as f32 / finest.width as f32,
                inside(v) + query.offset[1] as f32 / finest.height as f32,
            ];
            let side = finest.width.max(finest.height) as f32;
            let length = |d: [f32; 3]| (d[0] * d[0] + d[1] * d[1]).sqrt();
            mipmap.sample(uv, footprint(lod, lane, side, &length))
        }
    }
}

/// What a picture of depths, in its red, gives a shadow sampler. Its rows go down, and v with them.
fn shadow(mipmap: &Mipmap, query: &TextureQuery, [u, v]: [f32; 2], depth: f32) -> [f32; 4] {
    let (texels, part) = mipmap.depths([u, v].map(|x| x.clamp(-FARTHEST, FARTHEST)), query.offset);
    [compared(texels, part, depth), 0.0, 0.0, 1.0]
}

/// A filter ends at the edges of the face.
fn cube(faces: &[&Mipmap; 6], at: [f32; 3], lod: &Lod, lane: usize) -> [f32; 4] {
    let place = CubePlace::of(at);
    let mipmap = faces[place.face];
    let side = mipmap.levels[0].width.max(mipmap.levels[0].height) as f32;
    let length = |d: [f32; 3]| {
        let [u, v] = CubePlace::change(at, d);
        (u * u + v * v).sqrt()
    };
    mipmap.sample_within(place.uv, footprint(lod, lane, side, &length), [Wrap::Clamp; 2])
}

fn panorama(mipmap: &Mipmap, at: [f32; 3], lod: &Lod, lane: usize) -> [f32; 4] {
    let side = mipmap.levels[0].width.max(mipmap.levels[0].height) as f32;
    let footprint = footprint(lod, lane, side, &|d| of_circle(at, d));
    mipmap.sample_within(panorama_place(at), footprint, [Wrap::Repeat, Wrap::Clamp])
}

fn around(environment: &EnvironmentPicture<'_>, at: [f32; 3], lod: &Lod, lane: usize) -> [f32; 4] {
    let value = environment.map.map_or([1.0; 3], |map| {
        let length = (at[0] * at[0] + at[1] * at[1] + at[2] * at[2]).sqrt();
        let direction = environment.to_map.map(|row| {
            let along = row[0] * at[0] + row[1] * at[1] + row[2] * at[2];
            if length > 0.0 { along / length } else { 0.0 }
        });
        let footprint = footprint(lod, lane, map.width as f32, &|d| of_circle(at, d));
        trilinear(map, Vec3::new(direction[0], direction[1], direction[2]), footprint)
    });
    let [r, g, b] = core::array::from_fn(|c| value[c] * environment.color[c]);
    [r, g, b, 1.0]
}

/// The part of a full circle that a direction turns by.
fn of_circle(direction: [f32; 3], change: [f32; 3]) -> f32 {
    turned(direction, change) * (0.5 / core::f32::consts::PI)
}

fn trilinear(map: &EnvironmentMap, direction: Vec3<f32>, footprint: f32) -> [f32; 3] {
    let texels = footprint * map.width as f32;
    // Without a filter none of the coarser ones is made.
    if texels.is_nan() || texels <= 1.0 {
        return map.at(direction);
    }
    let level = Real::log2(texels).min((map.level_count() - 1) as f32);
    let lower = level.floor();
    let fine = map.level(lower as usize).at(direction);
    let coarse = map.level(lower as usize + 1).at(direction);
    core::array::from_fn(|c| fine[c] + (coarse[c] - fine[c]) * (level - lower))
}

/// How much of the texture a pixel covers along the longer axis. `length`: of a change of the coordinates.
fn footprint(lod: &Lod, lane: usize, side: f32, length: &dyn Fn([f32; 3]) -> f32) -> f32 {
    match lod {
        Lod::Gradient { dx, dy, bias } => {
            let of = |d: &[[f32; 16]; 3]| length(d.map(|row| row[lane]));
            of(dx).max(of(dy)) * Real::exp2(bias[lane].clamp(-16.0, 16.0))
        }
        Lod::Level(level) => Real::exp2(level[lane].clamp(0.0, 16.0)) / side,
        Lod::Texel(_) | Lod::Gather(_) => 0.0,
    }
}
