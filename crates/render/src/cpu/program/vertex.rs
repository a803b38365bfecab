//! The vertex stage: of each vertex its place in clip space, and what goes to the fragments.

use glanz_shader::{Machine, Row, Stage};

use super::{CLIP, ObjectProgram, builtin};
use crate::cpu::frame::FrameView;
use crate::prepare::{Cluster, Geometry};

/// Runs an object's vertex shader for the vertices of a cluster; `out` has the frame's stride of floats for each.
pub(crate) fn run(frame: &FrameView, cluster: &Cluster, out: &mut [f32]) {
    let object = cluster.object as usize;
    let Some((programs, program)) = frame.programs.and_then(|all| Some((all, all.all.of(object)?))) else {
        return;
    };
    let stride = programs.all.stride;
    programs.machines.with(object, Stage::Vertex, &mut |machine| {
        for (row, out) in out.chunks_mut(16 * stride).enumerate() {
            let first = cluster.first_vertex as usize + 16 * row;
            fill(machine, program, &frame.prepared.geometry, first);
            programs.run(machine);
            take(machine, program, stride, out);
        }
    });
}

/// Gives the machine sixteen vertices.
fn fill(machine: &mut Machine<'_, 1>, program: &ObjectProgram, geometry: &Geometry, first: usize) {
    let inputs = &program.pair.vertex.interface().inputs;
    for (number, port) in inputs.iter().enumerate() {
        for component in 0..port.ty.scalars() {
            let mut row = Row::splat(0.0);
            for (lane, value) in row.0.iter_mut().enumerate() {
                *value = program.attributes.of(port, component, geometry, first + lane);
            }
            machine.input(number, component)[0] = row;
        }
    }
}

/// Takes what the machine gives for sixteen vertices.
fn take(machine: &Machine<'_, 1>, program: &ObjectProgram, stride: usize, out: &mut [f32]) {
    let mut put = |float: usize, row: &Row| {
        for (vertex, value) in out.chunks_mut(stride).zip(row.0) {
            vertex[float] = value;
        }
    };
    if let Some(position) = builtin(&program.pair.vertex.interface().outputs, "gl_Position") {
        (0..CLIP).for_each(|component| put(component, &machine.output(position, component)[0]));
    }
    let mut float = CLIP;
    for varying in &program.pair.varyings {
        for component in 0..varying.components {
            put(float, &machine.output(varying.output, component)[0]);
            float += 1;
        }
    }
}

/// What happened for a vertex of an object's mesh: the lane, and the trace; none where there is no such vertex.
pub(crate) fn trace(
    programs: &super::FramePrograms,
    geometry: &Geometry,
    clusters: &[Cluster],
    pair: &glanz_shader::Pair,
    (object, vertex): (usize, u32),
) -> Option<(usize, glanz_shader::Trace)> {
    let program = programs.of(object)?;
    let of_mesh = |cluster: &Cluster| {
        let first = cluster.first_vertex as usize;
        geometry.sources[first..first + cluster.vertices as usize]
            .iter()
            .position(|source| *source == vertex)
            .map(|at| first + at)
    };
    let at = clusters.iter().find_map(of_mesh)?;
    let values = &program.values.vertex;
    let mut machine = Machine::<1>::new(&pair.vertex, values, &program.vertex_textures, programs.level);
    fill(&mut machine, program, geometry, at - at % 16);
    Some((at % 16, machine.trace()))
}
