//! The vertex stage: of each vertex its place in clip space, and what goes to the fragments.

use glanz_shader::{Machine, Port, Role, Row, Stage};

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
                *value = attribute(port, component, program, geometry, first + lane);
            }
            machine.input(number, component)[0] = row;
        }
    }
}

/// A component of what a vertex has.
fn attribute(
    port: &Port,
    component: usize,
    program: &ObjectProgram,
    geometry: &Geometry,
    vertex: usize,
) -> f32 {
    if port.builtin {
        let source = geometry.sources.get(vertex).copied().unwrap_or(0);
        return if port.name == "gl_VertexID" { f32::from_bits(source) } else { 0.0 };
    }
    let of_three = |v: [f32; 3], fourth: f32| if component < 3 { v[component] } else { fourth };
    match port.role {
        Some(Role::Position) => {
            let at = geometry.position.each_ref().map(|axis| axis[vertex]);
            let own = program.to_mesh.map(|row| row[0] * at[0] + row[1] * at[1] + row[2] * at[2] + row[3]);
            of_three(own, 1.0)
        }
        Some(Role::Normal) => of_three(to_mesh(program, geometry.normals[vertex]), 0.0),
        Some(Role::TexCoord) => {
            let [u, v] = geometry.uvs.get(vertex).copied().unwrap_or_default();
            [u, v, 0.0, 1.0][component.min(3)]
        }
        Some(Role::Color) => geometry.colors.get(vertex).copied().unwrap_or([1.0; 4])[component.min(3)],
        Some(Role::Tangent) => {
            let [x, y, z, sign] = geometry.tangents.get(vertex).copied().unwrap_or_default();
            of_three([x, y, z], sign)
        }
        Some(Role::Bitangent) => {
            let [x, y, z, sign] = geometry.tangents.get(vertex).copied().unwrap_or_default();
            let (normal, tangent) = (glam::Vec3::from(geometry.normals[vertex]), glam::Vec3::new(x, y, z));
            of_three((normal.cross(tangent).normalize_or_zero() * sign).to_array(), 0.0)
        }
        _ => 0.0,
    }
}

/// A normal of the world as the mesh has it.
fn to_mesh(program: &ObjectProgram, normal: [f32; 3]) -> [f32; 3] {
    let [nx, ny, nz] = normal;
    program.normal_to_mesh.map(|column| column[0] * nx + column[1] * ny + column[2] * nz)
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
