//! The fragment stage: a block of pixels of one triangle.

use fearless_simd::Simd;
use glanz_math::inline::{inlined, nine};
use glanz_math::{Lanes, LanesMask, Real, Vec3};
use glanz_scene::AlphaMode;
use glanz_shader::{Interpolation, Machine, Port, Row, Stage};

use super::ObjectProgram;
use super::inspect::{self, Block};
use crate::cpu::frame::FrameView;
use crate::cpu::shading::shade_block::Shaded;
use crate::cpu::shading::triangle_setup::{GROUP, TriangleSetup, TriangleSetups};
use crate::cpu::visibility::coverage_layers::Run;

/// Where sixteen pixels are on a triangle's plane.
struct Spot<S: Simd> {
    px: Lanes<S>,
    py: Lanes<S>,
    /// Barycentric coordinates on the screen, beyond the triangle too.
    screen: [Lanes<S>; 2],
    /// The same on the surface.
    surface: [Lanes<S>; 2],
    /// 1/w.
    inverse_w: Lanes<S>,
    /// The depth of the tiles.
    depth: Lanes<S>,
}

/// Runs an object's fragment shader for the pixels of a block and one of its triangles.
#[inline(always)]
pub(crate) fn shade<S: Simd>(
    simd: S,
    frame: &FrameView,
    setups: &TriangleSetups,
    run: &Run,
    [px, py]: [Lanes<S>; 2],
    out: &mut Shaded<S>,
) {
    let setup = &setups.list[run.setup as usize];
    let object = setup.object as usize;
    let Some((programs, program)) = frame.programs.and_then(|all| Some((all, all.all.of(object)?))) else {
        return;
    };
    let at = Spot::new(simd, setups, run, [px, py]);
    programs.machines.with(object, Stage::Fragment, &mut |machine| {
        // What is called by way of a trait object is compiled for no level by itself.
        simd.vectorize(
            #[inline(always)]
            || fill(machine, simd, frame, setups, run, program, &at),
        );
        programs.run(machine);
        simd.vectorize(
            #[inline(always)]
            || *out = taken(machine, simd, frame, program, setup, &at),
        );
        if programs.all.inspection.is_some() {
            let block = Block { place: [px, py], bits: run.bits, object };
            let mut fill = |traced: &mut Machine<'_, 1>| fill(traced, simd, frame, setups, run, program, &at);
            inspect::look(&programs, program, &block, &mut fill, out);
        }
    });
}

/// Where a program says how deep its fragments are: the depths of a block of a triangle, in the tiles' own measure, and at
/// which pixels they are not discarded.
pub(crate) fn depths<S: Simd>(
    simd: S,
    frame: &FrameView,
    setups: &TriangleSetups,
    run: &Run,
    place: [Lanes<S>; 2],
) -> (u32, Lanes<S>) {
    let mut found = (0, Lanes::splat(simd, f32::NEG_INFINITY));
    let object = setups.list[run.setup as usize].object as usize;
    let Some((programs, program)) = frame.programs.and_then(|all| Some((all, all.all.of(object)?))) else {
        return found;
    };
    let outputs = &program.pair.fragment.interface().outputs;
    let Some(depth) = super::builtin(outputs, "gl_FragDepth") else { return found };
    let at = Spot::new(simd, setups, run, place);
    programs.machines.with(object, Stage::Fragment, &mut |machine| {
        fill(machine, simd, frame, setups, run, program, &at);
        programs.run(machine);
        let [factor, summand] = programs.all.depth_of_ndc.map(|number| Lanes::splat(simd, number));
        let window = Lanes::load(simd, &machine.output(depth, 0)[0].0).clamp(0.0, 1.0);
        let ndc = window + window - window.one();
        found = (!u32::from(machine.discarded()[0]) & run.bits, ndc * factor + summand);
    });
    found
}

/// At which pixels of a block a triangle's fragments are not discarded.
pub(crate) fn passes<S: Simd>(
    simd: S,
    frame: &FrameView,
    setups: &TriangleSetups,
    run: &Run,
    place: [Lanes<S>; 2],
) -> u32 {
    let mut shaded = Shaded::nothing(simd);
    shade(simd, frame, setups, run, place, &mut shaded);
    Lanes::splat(simd, 0.0).le(shaded.alpha).bits()
}

impl<S: Simd> Spot<S> {
    #[inline(always)]
    fn new(simd: S, setups: &TriangleSetups, run: &Run, [px, py]: [Lanes<S>; 2]) -> Self {
        let rows = inlined(
            #[inline(always)]
            |part: usize| {
                let row = setups.row(run, part);
                nine(
                    #[inline(always)]
                    |i| Lanes::splat(simd, row[i]),
                )
            },
        );
        let [x0, y0, ux, uy, vx, vy, q0, dq1, dq2] = rows(0);
        let (dx, dy) = (px - x0, py - y0);
        let (u, v) = (dx * ux + dy * uy, dx * vx + dy * vy);
        // Pixels that the triangle covers in part, but not in their middle, are brought to its border, as everywhere else;
        // the others see its plane go on.
        let covered = LanesMask::from_bits(simd, run.bits);
        let on_it = u.clamp(0.0, 1.0);
        let u = on_it.select(covered, u);
        let v = v.clamp(0.0, 1.0).min(on_it.one() - on_it).select(covered, v);
        let [w0, .., w1, _, _, w2, _, _] = rows(1);
        let inverse_w = w0 + u * w1 + v * w2;
        let w = inverse_w.one() / inverse_w;
        Self {
            px,
            py,
            screen: [u, v],
            surface: [u * (w0 + w1) * w, v * (w0 + w2) * w],
            inverse_w,
            depth: q0 + u * dq1 + v * dq2,
        }
    }

    /// A number of the vertices at the pixels: its value at the first, and the differences of the others from it.
    #[inline(always)]
    fn interpolated(&self, [first, second, third]: [f32; 3], how: Interpolation) -> Lanes<S> {
        let splat = inlined(
            #[inline(always)]
            |value: f32| self.px.lit(f64::from(value)),
        );
        let [u, v] = if how == Interpolation::Linear { self.screen } else { self.surface };
        splat(first) + u * splat(second) + v * splat(third)
    }
}

#[inline(always)]
fn row_of<S: Simd>(lanes: Lanes<S>) -> Row {
    let mut row = Row::splat(0.0);
    lanes.store(&mut row.0);
    row
}

/// Gives the machine sixteen fragments.
#[inline(always)]
fn fill<S: Simd>(
    machine: &mut Machine<'_, 1>,
    simd: S,
    frame: &FrameView,
    setups: &TriangleSetups,
    run: &Run,
    program: &ObjectProgram,
    at: &Spot<S>,
) {
    let mut numbers = program.numbers().enumerate();
    for varying in &program.pair.varyings {
        for component in 0..varying.components {
            let Some((number, (_, how))) = numbers.next() else { return };
            // Groups of three: the first has 1/w.
            let row: &[f32; GROUP] = setups.row(run, 2 + number / 3);
            let c = number % 3;
            let value = match how {
                Interpolation::Flat => Row::splat(row[c]),
                _ => row_of(at.interpolated([row[c], row[3 + c], row[6 + c]], how)),
            };
            machine.input(varying.input, component)[0] = value;
        }
    }
    let setup = &setups.list[run.setup as usize];
    for (number, port) in program.pair.fragment.interface().inputs.iter().enumerate() {
        let given = program.pair.varyings.iter().any(|varying| varying.input == number);
        for component in (0..port.ty.scalars()).filter(|_| !given) {
            machine.input(number, component)[0] = of_pipeline(simd, frame, setup, port, component, at);
        }
    }
}

/// What the pipeline itself gives a fragment.
#[inline(always)]
fn of_pipeline<S: Simd>(
    simd: S,
    frame: &FrameView,
    setup: &TriangleSetup,
    port: &Port,
    component: usize,
    at: &Spot<S>,
) -> Row {
    match (port.name.as_str(), component) {
        ("gl_FragCoord", 0) => row_of(at.px),
        // From the lower edge up.
        ("gl_FragCoord", 1) => row_of(Lanes::splat(simd, frame.camera.height as f32) - at.py),
        ("gl_FragCoord", 2) => {
            let [factor, summand] = frame.programs.map_or([1.0, 0.0], |programs| programs.all.depth_of_ndc);
            let ndc = (at.depth - Lanes::splat(simd, summand)) * Lanes::splat(simd, 1.0 / factor);
            let half = Lanes::splat(simd, 0.5);
            row_of(ndc * half + half)
        }
        ("gl_FragCoord", _) => row_of(at.inverse_w),
        ("gl_FrontFacing", _) => Row::splat(f32::from_bits(if setup.back { 0 } else { u32::MAX })),
        ("gl_PrimitiveID", _) => Row::splat(f32::from_bits(setup.facet)),
        _ => Row::splat(0.0),
    }
}

/// Takes the colour of sixteen fragments; that of discarded ones has an alpha below 0.
#[inline(always)]
fn taken<S: Simd>(
    machine: &Machine<'_, 1>,
    simd: S,
    frame: &FrameView,
    program: &ObjectProgram,
    setup: &TriangleSetup,
    at: &Spot<S>,
) -> Shaded<S> {
    let load = inlined(
        #[inline(always)]
        |component: usize| Lanes::load(simd, &machine.output(program.color, component)[0].0),
    );
    let rgb = [load(0), load(1), load(2)];
    let port = &program.pair.fragment.interface().outputs[program.color];
    let material = &frame.materials[frame.objects[setup.object as usize].material];
    let one = Lanes::splat(simd, 1.0);
    let blends = matches!(material.alpha_mode, AlphaMode::Blend) && port.ty.rows > 3;
    let alpha = if blends { load(3) } else { one };
    let discarded = LanesMask::from_bits(simd, u32::from(machine.discarded()[0]));
    let zero = one.zero();
    let primaries = frame.programs.map_or(frame.options.primaries, |programs| programs.all.primaries);
    Shaded {
        rgb: in_channels(rgb, &primaries),
        alpha: (-one).select(discarded, alpha.max(zero)),
        transmittance: [zero; 3],
        distance: if frame.camera.perspective { one / at.depth } else { -at.depth },
        normal: Vec3::new(zero, zero, zero),
    }
}

/// Linear sRGB in the channels of the frame.
#[inline(always)]
fn in_channels<S: Simd>(rgb: [Lanes<S>; 3], primaries: &[[f32; 3]; 3]) -> [Lanes<S>; 3] {
    let is_srgb = primaries
        .iter()
        .enumerate()
        .all(|(c, own)| own.iter().enumerate().all(|(i, value)| *value == if i == c { 1.0 } else { 0.0 }));
    if is_srgb {
        return rgb;
    }
    core::array::from_fn(|c| {
        let part = |i: usize| rgb[i] * rgb[i].lit(f64::from(primaries[i][c]));
        part(0) + part(1) + part(2)
    })
}
