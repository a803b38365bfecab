//! Objects that a program of the user's draws: its vertex stage in the first pass, its fragment stage where the tiles are
//! shaded, by the same visibility as everything else.
//!
//! A fragment shader runs for a whole block and one triangle at a time: pixels of the block beside the triangle see its
//! plane go on, so that derivatives are those of the triangle, and what they give is dropped.

mod clip;
mod fragment;
pub(crate) mod inspect;
mod pool;
mod textures;
mod vertex;

pub(crate) use clip::clip;
pub(crate) use fragment::{depths, passes, shade};
pub(crate) use vertex::{run as run_vertices, trace as trace_vertex};

use std::sync::{Mutex, OnceLock, PoisonError};

use glanz_math::SimdLevel;
use glanz_shader::{Interpolation, Machine, Pair, Port, RunError, Source, Specialized, Stage};

use crate::cpu::threads;
use crate::prepare::{Prepared, PreparedProgram};
use crate::view::program::{FrameUniforms, MeshAttributes, ProgramPicture, StageValues};
use crate::view::{DebugView, DrawOptions, View};
use inspect::{Findings, Inspection, Wanted};
use pool::Pool;
use textures::ProgramTextures;

/// The programs of a frame.
pub(crate) struct FramePrograms<'a> {
    /// Of each object that has one.
    pub list: Vec<Option<ObjectProgram<'a>>>,
    /// Floats of a vertex: the most that any program needs.
    pub stride: usize,
    /// The frame's channels of linear red, green and blue.
    pub primaries: [[f32; 3]; 3],
    /// From z/w of clip space to the depth of the tiles: factor and summand.
    pub depth_of_ndc: [f32; 2],
    pub level: SimdLevel,
    /// What to look for in the frame, if it is looked into.
    inspection: Option<Inspection<'a>>,
    failed: OnceLock<RunError>,
}

/// The program of an object, with all that it is told.
pub(crate) struct ObjectProgram<'a> {
    pub pair: &'a Pair,
    /// Its number in the scene.
    number: usize,
    /// The number of the output that is the colour.
    pub color: usize,
    pub values: StageValues<'a>,
    /// The stages with their uniforms, once a machine is made.
    specialized_vertex: OnceLock<Specialized>,
    specialized_fragment: OnceLock<Specialized>,
    specialized_traced: OnceLock<Specialized>,
    vertex_textures: ProgramTextures<'a>,
    fragment_textures: ProgramTextures<'a>,
    /// What vertices are given.
    pub attributes: MeshAttributes,
}

impl<'a> FramePrograms<'a> {
    /// What the frame's objects run; nothing where the picture shows something else than light.
    pub(crate) fn new(
        prepared: &'a Prepared,
        view: &'a View,
        options: &DrawOptions,
        level: SimdLevel,
    ) -> Self {
        let shown = options.show == DebugView::Shaded && !prepared.programs.is_empty();
        let mut all = Self {
            list: Vec::new(),
            stride: 0,
            // Colours are three channels: an observer's further ones get nothing.
            primaries: if prepared.source.first_channel == 0 { options.primaries } else { [[0.0; 3]; 3] },
            depth_of_ndc: [0.0; 2],
            level,
            inspection: None,
            failed: OnceLock::new(),
        };
        if !shown {
            return all;
        }
        let told = FrameUniforms::new(prepared, view, options.moment);
        all.depth_of_ndc = told.range.depth_of_ndc().map(|number| number as f32);
        all.list = prepared
            .objects
            .iter()
            .map(|object| {
                let number = object.program?;
                let program = prepared.programs.get(number)?;
                ObjectProgram::new(program, number, told.values(object, program), object)
            })
            .collect();
        let floats = |program: &ObjectProgram| program.floats();
        all.stride = all.list.iter().flatten().map(floats).max().unwrap_or(0);
        all
    }

    /// The same, looked into.
    pub(crate) fn inspected(mut self, wanted: Wanted, pairs: &'a [Pair]) -> Self {
        self.inspection = Some(Inspection::new(wanted, pairs));
        self
    }

    /// What was found.
    pub(crate) fn into_findings(self) -> Option<Findings> {
        self.inspection.map(Inspection::into_findings)
    }

    /// With what runs them; nothing where there are none.
    pub(crate) fn with(&'a self, machines: &'a dyn Runs) -> Option<Programs<'a>> {
        (!self.list.is_empty()).then_some(Programs { all: self, machines })
    }

    /// Why a program did not come to its end, at the end.
    pub(crate) fn into_error(self) -> Option<RunError> {
        self.failed.into_inner()
    }

    /// The program of an object.
    pub(crate) fn of(&self, object: usize) -> Option<&ObjectProgram<'a>> {
        self.list.get(object)?.as_ref()
    }

    /// Why a program did not come to its end, if one did not.
    pub(crate) fn error(&self) -> Option<&RunError> {
        self.failed.get()
    }
}

/// Where a program put the vertices of a cluster.
#[derive(Clone, Copy)]
pub(crate) struct ProgramClip<'a> {
    pub screen: &'a [crate::cpu::geometry::screen::Screen],
    pub clip: &'a [[f32; 4]],
    pub depth_of_ndc: [f32; 2],
}

/// Floats of a vertex before its varyings: its place in clip space.
pub(crate) const CLIP: usize = 4;

impl<'a> ObjectProgram<'a> {
    fn new(
        program: &'a PreparedProgram,
        number: usize,
        values: StageValues<'a>,
        object: &crate::prepare::PreparedObject,
    ) -> Option<Self> {
        let textures = |list: &[Option<ProgramPicture<'a>>]| ProgramTextures(list.to_vec());
        Some(Self {
            pair: &program.pair,
            number,
            color: program.color?,
            specialized_vertex: OnceLock::new(),
            specialized_fragment: OnceLock::new(),
            specialized_traced: OnceLock::new(),
            vertex_textures: textures(&values.vertex_textures),
            fragment_textures: textures(&values.fragment_textures),
            values,
            attributes: MeshAttributes::new(object),
        })
    }

    /// A stage with its uniforms, which all threads share.
    fn specialized(&self, stage: Stage) -> &Specialized {
        let values = &self.values;
        match stage {
            Stage::Vertex => {
                self.specialized_vertex.get_or_init(|| self.pair.vertex.specialize(&values.vertex))
            }
            Stage::Fragment => {
                self.specialized_fragment.get_or_init(|| self.pair.fragment.specialize(&values.fragment))
            }
        }
    }

    /// The traced fragment stage with the uniforms.
    fn traced(&self, pair: &Pair) -> &Specialized {
        self.specialized_traced.get_or_init(|| pair.fragment.specialize(&self.values.fragment))
    }

    /// Whether the vertex shader is the user's, and says where vertices are.
    pub(crate) fn places_vertices(&self) -> bool {
        self.pair.vertex_source == Source::Own
    }

    /// Whether fragments may be dropped.
    pub(crate) fn discards(&self) -> bool {
        self.pair.fragment.discards()
    }

    /// Whether the fragment shader says how deep fragments are.
    pub(crate) fn places_fragments(&self) -> bool {
        builtin(&self.pair.fragment.interface().outputs, "gl_FragDepth").is_some()
    }

    /// Floats of a vertex.
    fn floats(&self) -> usize {
        CLIP + self.pair.varyings.iter().map(|varying| varying.components).sum::<usize>()
    }

    /// Each number that goes to the fragments: its float among those of the vertex, and how it goes there.
    pub(crate) fn numbers(&self) -> impl Iterator<Item = (usize, Interpolation)> + '_ {
        let all = self.pair.varyings.iter();
        let each = all.flat_map(|varying| (0..varying.components).map(|_| varying.interpolation));
        each.enumerate().map(|(number, interpolation)| (CLIP + number, interpolation))
    }
}

/// The number of a stage's port of the pipeline's own.
fn builtin(ports: &[Port], name: &str) -> Option<usize> {
    ports.iter().position(|port| port.builtin && port.name == name)
}

/// What runs the stages of the frame's programs. Behind a trait, so that what a frame holds lives as long as any of its
/// parts and no longer.
pub(crate) trait Runs: Sync {
    /// Lets work be done with the machine of a stage of an object's program; nothing, where it has none.
    fn with(&self, object: usize, stage: Stage, work: &mut dyn FnMut(&mut Machine<'_, 1>));
}

/// The machines of the threads.
pub(crate) struct Machines<'a> {
    programs: &'a FramePrograms<'a>,
    pools: Vec<Mutex<Pool<'a>>>,
}

impl<'a> Machines<'a> {
    /// Those for a frame's programs; made when they are asked for.
    pub(crate) fn new(programs: &'a FramePrograms<'a>) -> Self {
        let threads = if programs.list.is_empty() { 0 } else { threads::count() + 1 };
        Self { programs, pools: (0..threads).map(|_| Mutex::default()).collect() }
    }
}

impl Runs for Machines<'_> {
    fn with(&self, object: usize, stage: Stage, work: &mut dyn FnMut(&mut Machine<'_, 1>)) {
        // No two threads have the same number, so none ever waits here.
        let number = threads::number().min(self.pools.len().saturating_sub(1));
        let Some((program, pool)) = self.programs.of(object).zip(self.pools.get(number)) else { return };
        let mut pool = pool.lock().unwrap_or_else(PoisonError::into_inner);
        work(pool.machine(object, stage, program, self.programs.level));
    }
}

/// The programs of a frame with what runs them.
#[derive(Clone, Copy)]
pub(crate) struct Programs<'a> {
    pub all: &'a FramePrograms<'a>,
    pub machines: &'a dyn Runs,
}

impl Programs<'_> {
    /// Runs a machine, unless a program of the frame has failed already.
    fn run(&self, machine: &mut Machine<'_, 1>) {
        if self.all.error().is_none()
            && let Err(error) = machine.run()
        {
            // The first one counts.
            let _ = self.all.failed.set(error);
        }
    }
}
