//! Both passes over a frame, in parallel where the feature `rayon` is on.

use std::sync::{Arc, Mutex, PoisonError};

use glanz_math::{SimdLevel, at_level};

use crate::cpu::frame::FrameView;
use crate::cpu::geometry::bins::{TILE_HEIGHT, columns};
use crate::cpu::geometry::chunk::ChunkOutput;
use crate::cpu::geometry::process;
use crate::cpu::geometry::screen::Screen;
use crate::cpu::probe::Record;
use crate::cpu::program::inspect::{Findings, Wanted};
use crate::cpu::program::{self, FramePrograms, Machines};
use crate::cpu::shading::background::ViewBackground;
use crate::cpu::shading::gouraud::{Lit, Made};
use crate::cpu::shading::triangle_setup::Projected;
use crate::cpu::threads;
use crate::cpu::tile::draw;
use crate::cpu::tile::state::{TilePlace, TileScratch};
use crate::cpu::tile::target::{Band, Codes, PlaneBand, empty_block};
use crate::{Aovs, Backend, DrawOptions, Prepared, Samples, View};
use crate::{BackendError, DrawMeter};
use glanz_picture::DevelopKernel;
use glanz_picture::{ChannelError, Channels, Develop, Frame};
use glanz_scene::Background;
use glanz_shader::{Pair, RunError, Trace};

/// Draws frames, and keeps its working memory from one to the next.
#[derive(Debug, Default)]
pub struct Renderer {
    level: SimdLevel,
    screen: Vec<Screen>,
    lit: Vec<Lit>,
    lit_mix: Vec<Lit>,
    /// What programs make of vertices, in rows of the frame's stride.
    varyings: Vec<f32>,
    failed: Option<RunError>,
    chunks: Vec<ChunkOutput>,
    tiles: Vec<Mutex<TileScratch>>,
    meter: Arc<DrawMeter>,
}

/// Chunks of clusters per thread: enough that culled ones do not leave threads idle.
const CHUNKS_PER_THREAD: usize = 4;

impl Renderer {
    /// A renderer without working memory yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// A renderer on chosen SIMD instructions; pictures do not depend on them.
    pub fn with_level(level: SimdLevel) -> Self {
        Self { level, ..Self::default() }
    }

    /// What is behind all surfaces, without these: for back ends that draw surfaces alone.
    pub fn background(&mut self, prepared: &Prepared, view: &View, options: &DrawOptions) -> Frame {
        let mut out = Frame::default();
        let frame = FrameView::new(prepared, view, options, None);
        shape_frame(&mut out, prepared, view, options);
        let bands = plane_bands(&mut out, ViewBackground::of(&frame).fixed());
        self.chunks.clear();
        threads::enter(|| self.draw_bands(&frame, bands));
        out
    }
}

impl Backend for Renderer {
    fn draw(&mut self, prepared: &Prepared, view: &View, options: &DrawOptions) -> Frame {
        let mut frame = Frame::default();
        self.draw_into(prepared, view, options, &mut frame);
        frame
    }

    fn draw_into(&mut self, prepared: &Prepared, view: &View, options: &DrawOptions, out: &mut Frame) {
        let programs = FramePrograms::new(prepared, view, options, self.level);
        let machines = Machines::new(&programs);
        let frame = FrameView::new(prepared, view, options, programs.with(&machines));
        shape_frame(out, prepared, view, options);
        let bands = plane_bands(out, ViewBackground::of(&frame).fixed());
        self.draw_all(&frame, bands);
        self.failed = programs.into_error();
    }

    fn take_error(&mut self) -> Option<BackendError> {
        self.failed.take().map(BackendError::from)
    }

    fn meter(&self) -> Option<Arc<DrawMeter>> {
        Some(Arc::clone(&self.meter))
    }

    fn draw_rgba8(
        &mut self,
        prepared: &Prepared,
        view: &View,
        options: &DrawOptions,
        develop: &Develop,
        out: &mut [u8],
    ) -> Result<(), ChannelError> {
        shown(prepared, options).expect(develop.expects())?;
        let (width, height) = (view.width as usize, view.height as usize);
        assert_eq!(out.len(), 4 * width * height, "four bytes for each pixel");
        let programs = FramePrograms::new(prepared, view, options, self.level);
        let machines = Machines::new(&programs);
        let frame = FrameView::new(prepared, view, options, programs.with(&machines));
        let kernel = DevelopKernel::new(develop);
        let opaque = options.background != Background::Transparent;
        let empty = empty_block(develop, &kernel, &ViewBackground::of(&frame));
        let bands = out
            .chunks_mut(4 * width * TILE_HEIGHT)
            .map(|out| Band::Codes(Codes { out, kernel: &kernel, opaque, empty }))
            .collect();
        self.draw_all(&frame, bands);
        self.failed = programs.into_error();
        Ok(())
    }
}

impl Renderer {
    /// A frame of one sample in the middle of each pixel, lit as the pixels of another with these options are.
    pub(crate) fn middle(
        &mut self,
        prepared: &Prepared,
        view: &View,
        options: &DrawOptions,
        of: &DrawOptions,
    ) -> Frame {
        let mut out = Frame::default();
        let programs = FramePrograms::new(prepared, view, options, self.level);
        let machines = Machines::new(&programs);
        let frame = FrameView::new(prepared, view, options, programs.with(&machines)).with_rims_of(of);
        shape_frame(&mut out, prepared, view, options);
        let bands = plane_bands(&mut out, ViewBackground::of(&frame).fixed());
        self.draw_all(&frame, bands);
        out
    }

    /// A frame that holds what lies behind the light of its pixels.
    pub(crate) fn record(
        &mut self,
        prepared: &Prepared,
        view: &View,
        options: &DrawOptions,
        record: Record,
    ) -> Frame {
        let mut out = Frame::default();
        let frame = FrameView::new(prepared, view, options, None).recording(record);
        shape_frame(&mut out, prepared, view, options);
        let bands = plane_bands(&mut out, None);
        self.draw_all(&frame, bands);
        out
    }

    /// A frame that is looked into.
    pub(crate) fn inspect(
        &mut self,
        prepared: &Prepared,
        view: &View,
        options: &DrawOptions,
        wanted: Wanted,
        pairs: &[Pair],
    ) -> (Frame, Findings) {
        let mut out = Frame::default();
        let programs = FramePrograms::new(prepared, view, options, self.level).inspected(wanted, pairs);
        let machines = Machines::new(&programs);
        let frame = FrameView::new(prepared, view, options, programs.with(&machines));
        shape_frame(&mut out, prepared, view, options);
        let bands = plane_bands(&mut out, ViewBackground::of(&frame).fixed());
        self.draw_all(&frame, bands);
        drop(frame);
        drop(machines);
        let findings = programs.into_findings();
        (out, findings.unwrap_or(Findings { pixel: None, met: Default::default() }))
    }

    /// What happened for a vertex of an object: none where no program draws it, none within where it has no such vertex.
    pub(crate) fn vertex_trace(
        &self,
        prepared: &Prepared,
        view: &View,
        options: &DrawOptions,
        pairs: &[Pair],
        (object, vertex): (usize, u32),
    ) -> Option<Option<(usize, Trace)>> {
        let own = prepared.objects.get(object)?;
        let pair = pairs.get(own.program?)?;
        let programs = FramePrograms::new(prepared, view, options, self.level);
        let clusters = &prepared.geometry.clusters[own.clusters.clone()];
        Some(program::trace_vertex(&programs, &prepared.geometry, clusters, pair, (object, vertex)))
    }

    /// Both passes. The threads are entered once for both: to be woken up takes longer than a small task.
    fn draw_all(&mut self, frame: &FrameView, bands: Vec<Band>) {
        threads::enter(|| {
            self.project(frame);
            self.draw_bands(frame, bands);
        });
    }

    /// The first pass.
    fn project(&mut self, frame: &FrameView) {
        let geometry = &frame.prepared.geometry;
        let vertices = geometry.position[0].len();
        self.screen.resize(vertices, [0.0; 4]);
        self.lit.resize(if frame.any_gouraud { vertices } else { 0 }, Lit::default());
        self.lit_mix.resize(if frame.any_mix { vertices } else { 0 }, Lit::default());
        let stride = frame.programs.map_or(0, |programs| programs.all.stride);
        self.varyings.resize(stride * vertices, 0.0);
        let clusters = geometry.clusters.len();
        let wanted = threads::count() * CHUNKS_PER_THREAD;
        let size = clusters.div_ceil(wanted).max(8);
        let count = clusters.div_ceil(size);
        self.chunks.resize_with(count, ChunkOutput::default);
        let first_vertex = |cluster: usize| {
            geometry.clusters.get(cluster).map_or(vertices, |cluster| cluster.first_vertex as usize)
        };
        let (mut screen, mut lit) = (&mut self.screen[..], &mut self.lit[..]);
        let (mut lit_mix, mut varyings) = (&mut self.lit_mix[..], &mut self.varyings[..]);
        let mut tasks = Vec::with_capacity(count);
        for (number, output) in self.chunks.iter_mut().enumerate() {
            let range = number * size..((number + 1) * size).min(clusters);
            let length = first_vertex(range.end) - first_vertex(range.start);
            let (own, rest) = screen.split_at_mut(length);
            screen = rest;
            let (own_lit, rest) = lit.split_at_mut(length.min(lit.len()));
            lit = rest;
            let (own_mix, rest) = lit_mix.split_at_mut(length.min(lit_mix.len()));
            lit_mix = rest;
            let (own_varyings, rest) = varyings.split_at_mut(stride * length);
            varyings = rest;
            let made = Made { lit: own_lit, mix: own_mix, varyings: own_varyings };
            tasks.push((range, own, made, output));
        }
        let level = self.level;
        threads::for_each(tasks, |(range, screen, lit, output)| {
            output.solid.reset(frame.camera.width, frame.camera.height);
            output.points.reset(frame.camera.width, frame.camera.height);
            output.blended.reset(frame.camera.width, frame.camera.height);
            output.clipped_triangles.clear();
            process(level, frame, range, screen, lit, output);
        });
    }

    /// The second pass.
    fn draw_bands(&mut self, frame: &FrameView, bands: Vec<Band>) {
        self.tiles.resize_with(threads::count() + 1, Mutex::default);
        let projected = Projected {
            screen: &self.screen,
            lit: &self.lit,
            lit_mix: &self.lit_mix,
            varyings: &self.varyings,
            chunks: &self.chunks,
        };
        let columns = columns(frame.camera.width);
        let level = self.level;
        let mut tasks: Vec<_> = bands.into_iter().enumerate().collect();
        // From the middle of the picture outwards: there is most to do there, and what comes last should be short.
        let middle = tasks.len() / 2;
        tasks.sort_by_key(|(row, _)| row.abs_diff(middle));
        self.meter.begin(tasks.len());
        threads::for_each(tasks, |(row, mut band)| {
            // No two threads have the same number, so none ever waits here.
            let own = self.tiles[threads::number().min(self.tiles.len() - 1)].lock();
            let mut scratch = own.unwrap_or_else(PoisonError::into_inner);
            let mut column = 0;
            while column < columns {
                let place = TilePlace { column, row };
                column += draw_tile(level, frame, &projected, place, &mut scratch, &mut band);
            }
            self.meter.step();
        });
    }
}

/// One dispatch per chunk: everything below is compiled for the level.
fn process(
    level: SimdLevel,
    frame: &FrameView,
    range: core::ops::Range<usize>,
    screen: &mut [Screen],
    lit: Made,
    output: &mut ChunkOutput,
) {
    at_level!(level, simd => process::process(simd, frame, range, screen, lit, output));
}

/// One dispatch per tile; gives how many are done.
fn draw_tile(
    level: SimdLevel,
    frame: &FrameView,
    projected: &Projected,
    place: TilePlace,
    scratch: &mut TileScratch,
    band: &mut Band,
) -> usize {
    at_level!(level, simd => draw::draw(simd, frame, projected, place, scratch, band))
}

/// The frame with one sample in the middle of each pixel, before nothing: the numbers that programs give.
pub(crate) fn inspect_colors(prepared: &Prepared, view: &View, options: &DrawOptions) -> Frame {
    let (samples, background) = (Samples::One, Background::Transparent);
    let options = DrawOptions { samples, supersample: false, background, aovs: Aovs::default(), ..*options };
    Renderer::new().draw(prepared, view, &options)
}

/// What the channels of a frame will be.
fn shown(prepared: &Prepared, options: &DrawOptions) -> Channels {
    if options.show.is_light() { prepared.channels.clone() } else { Channels::display() }
}

/// Gives a frame its size, its channels and the planes that are asked for, whatever is in them.
fn shape_frame(frame: &mut Frame, prepared: &Prepared, view: &View, options: &DrawOptions) {
    let Aovs { depth, normal, object } = options.aovs;
    (frame.width, frame.height) = (view.width as usize, view.height as usize);
    frame.channels = shown(prepared, options);
    frame.more.clear();
    let count = frame.width * frame.height;
    let of = |wanted: bool| if wanted { count } else { 0 };
    frame.rgb.iter_mut().for_each(|plane| shape_plane(plane, count));
    shape_plane(&mut frame.alpha, count);
    shape_plane(&mut frame.depth, of(depth));
    frame.normal.iter_mut().for_each(|plane| shape_plane(plane, of(normal)));
    shape_plane(&mut frame.object, of(object));
}

/// Gives a plane its length. A new one comes from the system, whose zeros cost nothing before they are touched, which
/// is by the threads that draw.
fn shape_plane<T: Copy + Default>(plane: &mut Vec<T>, count: usize) {
    match plane.capacity() < count {
        true => *plane = vec![T::default(); count],
        false => plane.resize(count, T::default()),
    }
}

/// The frame's planes, cut into bands; `empty` is the background where it is the same everywhere.
fn plane_bands(frame: &mut Frame, empty: Option<([f32; 3], f32)>) -> Vec<Band<'_>> {
    fn next<'a, T>(rest: &mut &'a mut [T], length: usize) -> &'a mut [T] {
        let length = length.min(rest.len());
        let (own, others) = core::mem::take(rest).split_at_mut(length);
        *rest = others;
        own
    }
    let mut rgb = frame.rgb.each_mut().map(|plane| &mut plane[..]);
    let mut normal = frame.normal.each_mut().map(|plane| &mut plane[..]);
    let (mut alpha, mut depth) = (&mut frame.alpha[..], &mut frame.depth[..]);
    let mut object = &mut frame.object[..];
    let length = frame.width * TILE_HEIGHT;
    (0..frame.height.div_ceil(TILE_HEIGHT))
        .map(|_| {
            Band::Planes(PlaneBand {
                rgb: rgb.each_mut().map(|plane| next(plane, length)),
                alpha: next(&mut alpha, length),
                depth: next(&mut depth, length),
                normal: normal.each_mut().map(|plane| next(plane, length)),
                object: next(&mut object, length),
                empty,
            })
        })
        .collect()
}
