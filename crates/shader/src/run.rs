//! Running a program.

use std::sync::Arc;

use glanz_math::{SimdLevel, at_level};
use naga::Span;

use crate::lower::Placed;
use crate::machine::{
    Host, NoTextures, Op, OutOfFuel, Recorder, RegisterFile, Row, Silent, Textures, execute,
};
use crate::specialize::SpecializedCode;
use crate::trace::TraceRecorder;
use crate::{Place, Program, RunError, Specialized, Trace, UniformValues};

/// Turns of loops in one run. A shader that takes more is taken for endless.
const FUEL: u32 = 1 << 20;

/// Runs a [`Program`] for 16·`G` vertices or fragments at a time; `G` is 1 or 4. See the [crate](crate)'s example.
///
/// In a fragment shader 16 lanes are 4×4 pixels, row by row, so that derivatives are differences in the quads of 2×2;
/// with `G` = 4 each row of the register is such a block.
pub struct Machine<'a, const G: usize> {
    code: Arc<SpecializedCode>,
    textures: &'a dyn Textures,
    level: SimdLevel,
    file: RegisterFile<G>,
    fuel: u32,
    down: bool,
}

/// One copy of the loop per level and width, made in this crate.
macro_rules! executors {
    ($($name:ident $g:literal),*) => {$(
        #[inline(never)]
        pub(crate) fn $name(
            level: SimdLevel,
            ops: &[Op],
            file: &mut RegisterFile<$g>,
            host: &Host<'_>,
            recorder: &mut dyn Recorder,
        ) -> Result<(), OutOfFuel> {
            at_level!(level, simd => execute(simd, ops, file, host, recorder))
        }

        impl<'a> Machine<'a, $g> {
            /// A machine for a draw: what is the same for all fragments is computed here.
            pub fn new(
                program: &Program,
                uniforms: &UniformValues,
                textures: &'a dyn Textures,
                level: SimdLevel,
            ) -> Self {
                Self::of(&program.specialize(uniforms), textures, level)
            }

            /// A machine for a draw that several machines do together.
            pub fn of(specialized: &Specialized, textures: &'a dyn Textures, level: SimdLevel) -> Self {
                let code = Arc::clone(&specialized.0);
                let mut file = RegisterFile::<$g>::new();
                let (uniforms, looks) = (&code.words[..], &code.placed.looks[..]);
                let host = Host { uniforms, textures, looks, fuel: FUEL, down: false };
                // The prologue has no loops, so its fuel lasts.
                let _ = $name(level, &code.placed.prologue, &mut file, &host, &mut Silent);
                Self { code, textures, level, file, fuel: FUEL, down: false }
            }

            /// Runs the program for what the inputs hold. Inputs must be written anew for each run.
            pub fn run(&mut self) -> Result<(), RunError> {
                self.run_with(&mut Silent)
            }

            fn run_with(&mut self, recorder: &mut dyn Recorder) -> Result<(), RunError> {
                let (words, placed) = (&self.code.words[..], &self.code.placed);
                let looks = &placed.looks[..];
                let host = Host { uniforms: words, textures: self.textures, looks, fuel: self.fuel, down: self.down };
                let done = $name(self.level, &placed.ops, &mut self.file, &host, recorder);
                done.map_err(|stopped| self.code.endless(stopped, self.fuel))
            }
        }
    )*};
}
executors!(execute_16 1, execute_64 4);

/// Registers after the prologue, for runs by [`proceed`]: a machine's, without the borrows.
pub(crate) fn begin(level: SimdLevel, program: &Program, uniforms: &UniformValues) -> RegisterFile<1> {
    let mut file = RegisterFile::<1>::new();
    let placed = &program.lowered.placed;
    let (uniforms, looks) = (&uniforms.words[..], &placed.looks[..]);
    let host = Host { uniforms, textures: &NoTextures, looks, fuel: FUEL, down: false };
    // The prologue has no loops, so its fuel lasts.
    let _ = execute_16(level, &placed.prologue, &mut file, &host, &mut Silent);
    file
}

/// Runs a program without textures for the inputs in registers that are from [`begin`].
pub(crate) fn proceed(
    level: SimdLevel,
    program: &Program,
    uniforms: &UniformValues,
    file: &mut RegisterFile<1>,
    fuel: u32,
) -> Result<(), RunError> {
    let placed = &program.lowered.placed;
    let (uniforms, looks) = (&uniforms.words[..], &placed.looks[..]);
    let host = Host { uniforms, textures: &NoTextures, looks, fuel, down: false };
    let done = execute_16(level, &placed.ops, file, &host, &mut Silent);
    done.map_err(|stopped| endless(placed, &program.loop_places, stopped, fuel))
}

/// The error of a run that was stopped.
pub(crate) fn endless(placed: &Placed, places: &[(Span, Place)], stopped: OutOfFuel, turns: u32) -> RunError {
    let span = placed.loops.get(&stopped.at);
    let place = span.and_then(|span| places.iter().find(|(own, _)| own == span));
    RunError::EndlessLoop { place: place.map(|(_, place)| place.clone()), turns }
}

impl<const G: usize> Machine<'_, G> {
    /// The same for blocks whose rows are given from the top down: derivatives along y are those upwards, as OpenGL has
    /// them. By default rows go up.
    #[must_use]
    pub fn with_rows_down(self) -> Self {
        Self { down: true, ..self }
    }

    /// Sets how many turns all loops of a run may take together.
    pub fn set_fuel(&mut self, turns: u32) {
        self.fuel = turns;
    }

    /// The lanes of a component of an input, to be written. Whole numbers are their bits.
    ///
    /// # Panics
    ///
    /// If there is no such input or component.
    pub fn input(&mut self, input: usize, component: usize) -> &mut [Row; G] {
        self.file.get_mut(self.code.placed.inputs[input][component])
    }

    /// The lanes of a component of an output.
    ///
    /// # Panics
    ///
    /// If there is no such output or component.
    pub fn output(&self, output: usize, component: usize) -> &[Row; G] {
        self.file.get(self.code.placed.outputs[output][component])
    }

    /// Which lanes were discarded: bit i of element g is lane i of row g.
    pub fn discarded(&self) -> [u16; G] {
        let Some(register) = self.code.placed.discarded else { return [0; G] };
        self.file.get(register).map(|row| {
            let bit = |(lane, x): (usize, &f32)| u16::from(x.to_bits() != 0) << lane;
            row.0.iter().enumerate().map(bit).fold(0, |all, bit| all | bit)
        })
    }
}

impl Machine<'_, 1> {
    /// Runs the program and records what happened. It must be [`traced`](crate::Shader::traced); else the trace is empty.
    ///
    /// The trace of an endless loop ends where it was stopped.
    pub fn trace(&mut self) -> Trace {
        let code = Arc::clone(&self.code);
        let mut recorder = TraceRecorder::new(&code.points);
        let end = self.run_with(&mut recorder);
        recorder.into_trace(end)
    }
}
