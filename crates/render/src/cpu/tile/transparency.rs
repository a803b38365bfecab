//! Surfaces that let through what is behind them.
//!
//! Each is shaded once per pixel, like any other surface, but laid over what is behind it sample by
//! sample, from the nearest to the farthest (Porter and Duff 1984): so two triangles that share the
//! samples of a pixel join without a seam, and the order in which triangles come does not matter. What
//! is left for the opaque surfaces of a sample is the fraction of light that all in front let through.

use fearless_simd::Simd;
use glanz_math::{Lanes, Real};

use crate::cpu::block::Grid;
use crate::cpu::block::{self, BLOCK};
use crate::cpu::frame::FrameView;
use crate::cpu::geometry::bins::TILE_PIXELS;
use crate::cpu::shading::shade;
use crate::cpu::shading::shade_block::Shaded;
use crate::cpu::shading::triangle_setup::{Projected, TriangleSetups};
use crate::cpu::visibility::coverage_layers::Run;
use crate::cpu::visibility::raster::cover;
use crate::cpu::visibility::visible::{Visible, object_of, triangle};
use crate::view::samples::SUBPIXEL;

/// A triangle at a pixel, or at one of its samples: what is shaded once.
#[derive(Clone, Copy, Debug)]
struct Piece {
    /// The pixel's place in the tile's arrays.
    place: u32,
    setup: u32,
    /// Where it is shaded.
    at: [f32; 2],
}

/// A sample that a piece covers, in front of all that is opaque.
#[derive(Clone, Copy, Debug, Default)]
struct Hit {
    place: u32,
    sample: u32,
    depth: f32,
    /// The triangle's name, by which equal depths are decided.
    name: u32,
    piece: u32,
}

/// The blended surfaces of a tile.
#[derive(Debug, Default)]
pub(crate) struct TransparencyBuffer {
    pieces: Vec<Piece>,
    /// Colour and opacity of each piece, and the fraction that it lets through nevertheless, per channel.
    colors: Vec<[f32; 7]>,
    hits: Vec<Hit>,
    sorted: Vec<Hit>,
    /// The last piece of each pixel.
    latest: Vec<u32>,
    /// What is let through at each sample, sample after sample, per channel, and the greatest of the channels.
    transmittance: [Vec<f32>; 4],
    /// Premultiplied colour and coverage of the blended surfaces of each pixel.
    light: [Vec<f32>; 4],
}

/// The greatest of the channels.
fn most(channels: [f32; 3]) -> f32 {
    channels.into_iter().fold(0.0, f32::max)
}

impl TransparencyBuffer {
    /// Forgets everything.
    pub(crate) fn clear(&mut self, samples: usize) {
        self.pieces.clear();
        self.colors.clear();
        self.hits.clear();
        self.latest.resize(TILE_PIXELS, 0);
        for plane in &mut self.transmittance {
            plane.clear();
            plane.resize(samples * TILE_PIXELS, 1.0);
        }
        for plane in &mut self.light {
            plane.clear();
            plane.resize(TILE_PIXELS, 0.0);
        }
    }

    /// Notes where a blended triangle is in front of what is opaque.
    #[inline(always)]
    pub(crate) fn collect<S: Simd>(
        &mut self,
        simd: S,
        frame: &FrameView,
        projected: &Projected,
        (visible, setups): (&Visible, &mut TriangleSetups),
        grid: &Grid,
        (chunk, key): (usize, u32),
    ) {
        let triangle = triangle(frame, projected, chunk, key);
        let view = &frame.objects[object_of(frame, triangle.name)];
        let setup = setups.list.len() as u32;
        let hits = self.hits.len();
        for (sample, &position) in frame.samples.iter().enumerate() {
            let grid = Grid { sample: position, ..*grid };
            cover(
                simd,
                &triangle,
                view.cull_back,
                &grid,
                #[inline(always)]
                |start, inside, z| {
                    let opaque = Lanes::load(simd, visible.depths(sample * TILE_PIXELS + start));
                    let bits = (inside & opaque.lt(z)).bits();
                    if bits != 0 {
                        let mut depths = [0.0; BLOCK];
                        z.store(&mut depths);
                        let hit = Hit { sample: sample as u32, name: triangle.name, ..Hit::default() };
                        self.note(frame, setup, start, (bits, &depths), hit);
                    }
                },
            );
        }
        if self.hits.len() > hits {
            setups.add(frame, projected, chunk, &triangle);
        }
    }

    fn note(
        &mut self,
        frame: &FrameView,
        setup: u32,
        start: usize,
        (mut bits, depths): (u32, &[f32; BLOCK]),
        hit: Hit,
    ) {
        let at = match frame.options.supersample {
            true => frame.samples[hit.sample as usize].map(|s| s as f32 / SUBPIXEL as f32),
            false => [0.5; 2],
        };
        while bits != 0 {
            let lane = bits.trailing_zeros() as usize;
            bits &= bits - 1;
            let place = (start + lane) as u32;
            let latest = &mut self.latest[start + lane];
            let same = |piece: &Piece| piece.place == place && piece.setup == setup && piece.at == at;
            if !self.pieces.get(*latest as usize).is_some_and(same) {
                *latest = self.pieces.len() as u32;
                self.pieces.push(Piece { place, setup, at });
            }
            self.hits.push(Hit { place, depth: depths[lane], piece: *latest, ..hit });
        }
    }

    /// Shades what was collected, and lays it over one another.
    #[inline(always)]
    pub(crate) fn blend<S: Simd>(
        &mut self,
        simd: S,
        frame: &FrameView,
        setups: &TriangleSetups,
        grid: &Grid,
    ) {
        self.shade(simd, frame, setups, grid);
        self.sort();
        let fraction = 1.0 / frame.samples.len() as f32;
        for hits in self.sorted.chunk_by(|a, b| a.place == b.place && a.sample == b.sample) {
            let mut transmittance = [1.0f32; 3];
            let place = hits[0].place as usize;
            for hit in hits {
                let [r, g, b, alpha, passed @ ..] = self.colors[hit.piece as usize];
                for (c, color) in [r, g, b].into_iter().enumerate() {
                    self.light[c][place] += color * (transmittance[c] * alpha) * fraction;
                }
                let before = most(transmittance);
                for (transmittance, passed) in transmittance.iter_mut().zip(passed) {
                    *transmittance *= 1.0 - alpha + alpha * passed;
                }
                self.light[3][place] += match passed {
                    [0.0, 0.0, 0.0] => before * alpha * fraction,
                    _ => (before - most(transmittance)) * fraction,
                };
            }
            let [r, g, b] = transmittance;
            let transmittance = [r, g, b, most(transmittance)];
            for (plane, transmittance) in self.transmittance.iter_mut().zip(transmittance) {
                plane[hits[0].sample as usize * TILE_PIXELS + place] = transmittance;
            }
        }
    }

    /// Shades the pieces, sixteen at a time.
    #[inline(always)]
    fn shade<S: Simd>(&mut self, simd: S, frame: &FrameView, setups: &TriangleSetups, grid: &Grid) {
        for sixteen in self.pieces.chunks(BLOCK) {
            let (mut px, mut py) = ([0.0; BLOCK], [0.0; BLOCK]);
            let mut runs = [Run { setup: 0, bits: 0 }; BLOCK];
            let mut count = 0;
            for (lane, piece) in sixteen.iter().enumerate() {
                let [column, row] = block::pixel(piece.place as usize);
                px[lane] = (grid.origin[0] + column) as f32 + piece.at[0];
                py[lane] = (grid.origin[1] + row) as f32 + piece.at[1];
                if count == 0 || runs[count - 1].setup != piece.setup {
                    runs[count] = Run { setup: piece.setup, bits: 0 };
                    count += 1;
                }
                runs[count - 1].bits |= 1 << lane;
            }
            let place = [Lanes::load(simd, &px), Lanes::load(simd, &py)];
            let mut shaded = Shaded::nothing(simd);
            shade::shade(simd, frame, setups, &runs[..count], place, &mut shaded);
            let mut lanes = [[0.0; BLOCK]; 7];
            let ([r, g, b], [x, y, z]) = (shaded.rgb, shaded.transmittance);
            for (array, value) in lanes.iter_mut().zip([r, g, b, shaded.alpha.clamp(0.0, 1.0), x, y, z]) {
                value.store(array);
            }
            self.colors.extend((0..sixteen.len()).map(|lane| lanes.map(|array| array[lane])));
        }
    }

    /// Sorts the hits by pixel and sample, and there from the nearest to the farthest.
    fn sort(&mut self) {
        let mut starts = vec![0u32; TILE_PIXELS + 1];
        for hit in &self.hits {
            starts[hit.place as usize + 1] += 1;
        }
        for place in 0..TILE_PIXELS {
            starts[place + 1] += starts[place];
        }
        self.sorted.clear();
        self.sorted.resize(self.hits.len(), Hit::default());
        for hit in &self.hits {
            let next = &mut starts[hit.place as usize];
            self.sorted[*next as usize] = *hit;
            *next += 1;
        }
        for hits in self.sorted.chunk_by_mut(|a, b| a.place == b.place) {
            hits.sort_unstable_by(|a, b| {
                let order = a.sample.cmp(&b.sample).then(b.depth.total_cmp(&a.depth));
                order.then(a.name.cmp(&b.name)).then(a.piece.cmp(&b.piece))
            });
        }
    }

    /// How much of what is behind is seen in a channel, or of its coverage (3), at the samples of the block at a place of the planes.
    #[inline(always)]
    pub(crate) fn transmittance(&self, channel: usize, at: usize) -> &[f32; BLOCK] {
        self.transmittance[channel][at..].first_chunk().expect("planes are whole blocks")
    }

    /// Premultiplied colour and coverage in the block at a place.
    #[inline(always)]
    pub(crate) fn light<S: Simd>(&self, simd: S, place: usize) -> [Lanes<S>; 4] {
        let load = |plane: &Vec<f32>| {
            Lanes::load(simd, plane[place..].first_chunk().expect("planes are whole blocks"))
        };
        let [r, g, b, alpha] = &self.light;
        [load(r), load(g), load(b), load(alpha)]
    }
}
