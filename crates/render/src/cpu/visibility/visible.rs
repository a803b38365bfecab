//! Visibility: which triangle is nearest at each sample of a tile.

use fearless_simd::{Select, Simd, SimdBase, u32x16};
use glanz_math::{Lanes, LanesMask, Real};
use glanz_scene::AlphaMode;

use crate::cpu::block::Grid;
use crate::cpu::block::{self, BLOCK};
use crate::cpu::frame::FrameView;
use crate::cpu::geometry::bins::TILE_PIXELS;
use crate::cpu::geometry::clip::EXTRA;
use crate::cpu::geometry::micro_triangles::MicroSample;
use crate::cpu::program;
use crate::cpu::shading::shade;
use crate::cpu::shading::shade_block::Shaded;
use crate::cpu::shading::triangle_setup::{Projected, TriangleSetups};
use crate::cpu::visibility::coverage_layers::Run;
use crate::cpu::visibility::raster::{Triangle, cover};
use crate::view::objects::Pass;
use glanz_math::inline::inlined;
use glanz_math::inline::three;

/// No triangle.
pub(crate) const NONE: u32 = u32::MAX;

/// An owner with this bit is the name of a triangle, else its number in the tile's list.
const NAMED: u32 = 1 << 31;

/// A triangle that is or was nearest somewhere in the tile.
#[derive(Clone, Copy, Debug)]
struct Seen {
    name: u32,
    /// The same, or the name of the extra triangle that it is, in this chunk.
    key: u32,
    chunk: u32,
    object: u32,
    /// Its number among the records, or [`NONE`] as long as it is not set up.
    setup: u32,
}

/// The depth buffer of a tile, sample after sample, and who owns each of its places.
#[derive(Debug, Default)]
pub(crate) struct Visible {
    depth: Vec<f32>,
    owners: Vec<u32>,
    seen: Vec<Seen>,
}

/// Who owns sixteen neighbouring samples.
#[derive(Debug)]
pub(crate) struct Owners {
    /// Each owner once, with the samples that it owns.
    pub runs: [Run; BLOCK],
    pub count: usize,
    /// Which samples are owned at all.
    pub bits: u32,
    /// Whether there are no more owners than these.
    pub all: bool,
}

impl Default for Owners {
    fn default() -> Self {
        Self { runs: [Run { setup: 0, bits: 0 }; BLOCK], count: 0, bits: 0, all: true }
    }
}

impl Visible {
    /// Forgets everything.
    pub(crate) fn clear(&mut self, samples: usize) {
        self.depth.clear();
        self.depth.resize(samples * TILE_PIXELS, f32::NEG_INFINITY);
        self.owners.clear();
        self.owners.resize(samples * TILE_PIXELS, NONE);
        self.seen.clear();
    }

    /// Depth-tests a sample that the first pass found covered.
    #[inline(always)]
    pub(crate) fn point(&mut self, point: &MicroSample) {
        let at = point.place as usize;
        let before = self.depth[at];
        if before < point.depth
            || before == point.depth
                && name(&self.seen, self.owners[at]).is_some_and(|other| point.name < other)
        {
            self.depth[at] = point.depth;
            self.owners[at] = NAMED | point.name;
        }
    }

    /// Depth-tests an opaque or masked triangle.
    #[inline(always)]
    pub(crate) fn triangle<S: Simd>(
        &mut self,
        simd: S,
        frame: &FrameView,
        projected: &Projected,
        setups: &mut TriangleSetups,
        grid: &Grid,
        (chunk, key): (usize, u32),
    ) {
        let triangle = triangle(frame, projected, chunk, key);
        let object = object_of(frame, triangle.name);
        let view = &frame.objects[object];
        let masked = view.pass == Pass::Masked;
        let setup = if masked { setups.add(frame, projected, chunk, &triangle) } else { NONE };
        let number = self.seen.len() as u32;
        let mut used = false;
        for (sample, &position) in frame.samples.iter().enumerate() {
            let grid = Grid { sample: position, ..*grid };
            let plane = sample * TILE_PIXELS;
            cover(
                simd,
                &triangle,
                view.cull_back,
                &grid,
                #[inline(always)]
                |place, inside, z| {
                    let keep = masked.then_some((frame, &*setups, setup, &grid));
                    if masked && view.depth_by_program {
                        let run = Run { setup, bits: inside.bits() };
                        let names = [triangle.name, number];
                        used |= self.test_by_program(simd, frame, setups, &run, &grid, [plane, place], names);
                        return;
                    }
                    used |= self.test(simd, plane + place, inside, z, [triangle.name, number], keep);
                },
            );
        }
        if used {
            let (chunk, object) = (chunk as u32, object as u32);
            self.seen.push(Seen { name: triangle.name, key, chunk, object, setup });
        }
    }

    /// The same where a program says how deep its fragments are.
    #[expect(clippy::too_many_arguments, reason = "out of the loop over blocks, whose code it would double")]
    #[inline(never)]
    fn test_by_program<S: Simd>(
        &mut self,
        simd: S,
        frame: &FrameView,
        setups: &TriangleSetups,
        run: &Run,
        grid: &Grid,
        [plane, place]: [usize; 2],
        names: [u32; 2],
    ) -> bool {
        let (bits, z) = depths(simd, frame, setups, run, grid, place);
        self.test(simd, plane + place, LanesMask::from_bits(simd, bits), z, names, None)
    }

    /// Depth-tests sixteen samples; returns whether any is won. `masked` names the record of a triangle
    /// whose texture may be clear there.
    #[inline(always)]
    fn test<S: Simd>(
        &mut self,
        simd: S,
        at: usize,
        inside: LanesMask<S>,
        z: Lanes<S>,
        [name, number]: [u32; 2],
        masked: Option<(&FrameView, &TriangleSetups, u32, &Grid)>,
    ) -> bool {
        let old = self.depth[at..].first_chunk_mut().expect("planes are whole blocks");
        let owners: &mut [u32; BLOCK] = self.owners[at..].first_chunk_mut().expect("planes are whole blocks");
        let before = Lanes::load(simd, old);
        let mut won = inside & before.le(z);
        let mut bits = won.bits();
        let equal = bits & !before.lt(z).bits();
        if equal != 0 {
            bits &= !equal | ties(&self.seen, owners, equal, name);
            won = LanesMask::from_bits(simd, bits);
        }
        if bits == 0 {
            return false;
        }
        if let Some((frame, setups, setup, grid)) = masked {
            bits &= opaque_enough(simd, frame, setups, Run { setup, bits }, grid, at % TILE_PIXELS);
            won = LanesMask::from_bits(simd, bits);
        }
        z.select(won, before).store(old);
        let new: u32x16<S> = won.0.select(simd.splat_u32x16(number), u32x16::from_slice(simd, owners));
        new.store_slice(owners);
        bits != 0
    }

    /// The depths of the block at a place of the planes.
    #[inline(always)]
    pub(crate) fn depths(&self, at: usize) -> &[f32; BLOCK] {
        self.depth[at..].first_chunk().expect("planes are whole blocks")
    }

    /// Who owns each sample of the block at a place of the planes.
    #[inline(always)]
    pub(crate) fn each(&self, at: usize) -> &[u32; BLOCK] {
        self.owners[at..].first_chunk().expect("planes are whole blocks")
    }

    /// Finds who owns the block at a place of the planes; the first so many where there are more.
    #[inline(always)]
    pub(crate) fn owners<S: Simd>(&self, simd: S, at: usize, most: usize, found: &mut Owners) {
        let each = self.each(at);
        let lanes = u32x16::from_slice(simd, each);
        let same = inlined(
            #[inline(always)]
            |owner: u32| LanesMask(simd.simd_eq_u32x16(lanes, simd.splat_u32x16(owner))).bits(),
        );
        let first = same(each[0]);
        if first == 0xffff {
            // Most blocks: one owner, or none.
            found.runs[0] = Run { setup: each[0], bits: first };
            (found.count, found.bits, found.all) =
                if each[0] == NONE { (0, 0, true) } else { (1, first, true) };
            return;
        }
        found.count = 0;
        found.bits = !same(NONE) & 0xffff;
        let mut left = found.bits;
        while left != 0 && found.count < most {
            let owner = each[left.trailing_zeros() as usize & (BLOCK - 1)];
            let bits = same(owner);
            left &= !bits;
            found.runs[found.count & (BLOCK - 1)] = Run { setup: owner, bits };
            found.count += 1;
        }
        found.all = left == 0;
    }

    /// The number of an owner's object.
    #[inline(always)]
    pub(crate) fn object(&self, frame: &FrameView, owner: u32) -> usize {
        match owner & NAMED {
            0 => self.seen[owner as usize].object as usize,
            _ => object_of(frame, owner & !NAMED),
        }
    }

    /// The name of an owner that is no part of a clipped triangle.
    #[inline(always)]
    pub(crate) fn whole(&self, owner: u32) -> Option<u32> {
        match owner & NAMED {
            0 => self.seen.get(owner as usize).map(|seen| seen.key).filter(|key| key & EXTRA == 0),
            _ => Some(owner & !NAMED),
        }
    }

    /// Makes runs of owners runs of records: sets up those that are new.
    #[inline(always)]
    pub(crate) fn set_up(
        &mut self,
        frame: &FrameView,
        projected: &Projected,
        setups: &mut TriangleSetups,
        runs: &mut [Run],
    ) {
        for run in runs {
            run.setup = self.record(frame, projected, setups, run.setup);
        }
    }

    /// The number of an owner's record, which is set up if it is new.
    #[inline(always)]
    pub(crate) fn record(
        &mut self,
        frame: &FrameView,
        projected: &Projected,
        setups: &mut TriangleSetups,
        owner: u32,
    ) -> u32 {
        match self.seen.get_mut(owner as usize) {
            Some(seen) if seen.setup != NONE => seen.setup,
            Some(seen) => {
                let chunk = seen.chunk as usize;
                let triangle = triangle(frame, projected, chunk, seen.key);
                seen.setup = setups.add(frame, projected, chunk, &triangle);
                seen.setup
            }
            None => {
                let triangle = triangle(frame, projected, 0, owner & !NAMED);
                setups.add(frame, projected, 0, &triangle)
            }
        }
    }
}

/// The triangle behind a key of a bin.
pub(crate) fn triangle(frame: &FrameView, projected: &Projected, chunk: usize, key: u32) -> Triangle {
    if key & EXTRA != 0 {
        let extra = &projected.chunks[chunk].clipped_triangles[(key & !EXTRA) as usize];
        return Triangle { screen: extra.screen, name: extra.original, key };
    }
    let corners = corners(frame, key);
    Triangle {
        screen: three(
            corners,
            #[inline(always)]
            |v| projected.screen[v],
        ),
        name: key,
        key,
    }
}

/// The vertices of a triangle.
#[inline(always)]
fn corners(frame: &FrameView, name: u32) -> [usize; 3] {
    let geometry = &frame.prepared.geometry;
    let cluster = &geometry.clusters[(name >> 7) as usize];
    let first = cluster.first_vertex as usize;
    three(
        geometry.triangles[cluster.first_triangle as usize + (name & 127) as usize],
        #[inline(always)]
        |v| first + v as usize,
    )
}

/// The number of a triangle's object.
#[inline(always)]
pub(crate) fn object_of(frame: &FrameView, name: u32) -> usize {
    frame.prepared.geometry.clusters[(name >> 7) as usize].object as usize
}

/// Whether the owner is a tiny triangle, which no other block is likely to see.
#[inline(always)]
pub(crate) fn is_named(owner: u32) -> bool {
    owner & NAMED != 0
}

#[inline(always)]
fn name(seen: &[Seen], owner: u32) -> Option<u32> {
    match owner {
        NONE => None,
        _ if owner & NAMED != 0 => Some(owner & !NAMED),
        // A triangle is not in the list while it is being drawn.
        _ => seen.get(owner as usize).map(|seen| seen.name),
    }
}

/// Of samples at which two triangles are equally deep, those where the new one has the smaller name.
fn ties(seen: &[Seen], owners: &[u32; BLOCK], mut equal: u32, new: u32) -> u32 {
    let mut won = 0;
    while equal != 0 {
        let lane = equal.trailing_zeros();
        equal &= equal - 1;
        won |= u32::from(name(seen, owners[lane as usize]).is_some_and(|other| new < other)) << lane;
    }
    won
}

/// How deep the fragments of a program are that says so itself, and at which of sixteen pixels they are at all.
#[inline(never)]
fn depths<S: Simd>(
    simd: S,
    frame: &FrameView,
    setups: &TriangleSetups,
    run: &Run,
    grid: &Grid,
    place: usize,
) -> (u32, Lanes<S>) {
    let at = block::coordinates(simd, grid, place, [0.5, 0.5]);
    program::depths(simd, frame, setups, run, at)
}

/// At which of sixteen pixels a masked triangle is opaque enough to be seen.
#[inline(never)]
fn opaque_enough<S: Simd>(
    simd: S,
    frame: &FrameView,
    setups: &TriangleSetups,
    Run { setup, bits }: Run,
    grid: &Grid,
    place: usize,
) -> u32 {
    let object = &frame.objects[setups.list[setup as usize].object as usize];
    if object.program {
        let at = block::coordinates(simd, grid, place, [0.5, 0.5]);
        return program::passes(simd, frame, setups, &Run { setup, bits }, at);
    }
    let AlphaMode::Mask { cutoff } = frame.materials[object.material].alpha_mode else { return u32::MAX };
    simd.vectorize(
        #[inline(always)]
        || {
            let at = block::coordinates(simd, grid, place, [0.5, 0.5]);
            let mut shaded = Shaded::nothing(simd);
            shade::shade(simd, frame, setups, &[Run { setup, bits: 0xffff }], at, &mut shaded);
            Lanes::splat(simd, cutoff).le(shaded.alpha).bits()
        },
    )
}
