//! A program for one draw: its uniforms are numbers now, so branches on them are taken or gone, and what follows from them
//! is a constant.
//!
//! The program is read once from its first instruction to its last ([`values`]). A register that is written anew becomes a
//! new one, so copies and sums that are known cost nothing and what is computed twice is computed once; only where control
//! flow may jump do registers stay what they are. Every number keeps its bits: nothing is reordered, and only what is exact
//! for any number is left out.

mod branches;
mod evaluate;
mod narrow;
mod simplify;
mod values;

use std::sync::Arc;

use glanz_math::SimdLevel;
use naga::Span;

use crate::lower::{Draft, Placed};
use crate::machine::{Code, OutOfFuel};
use crate::run::{begin, endless};
use crate::trace::PlacedPoint;
use crate::{Place, Program, RunError, UniformValues};

/// A program with the values of its uniforms: what machines run.
///
/// Machines of several threads share one; see [`Machine::of`](crate::Machine::of).
///
/// ```
/// use glanz_shader::{Machine, NoTextures, Shader};
///
/// let text = "#version 330
/// uniform int n; in float x; out vec4 color;
/// void main() { if (n > 2) color = vec4(1.0); else color = vec4(x * float(n)); }";
/// let program = Shader::fragment(text).compile()?;
/// let mut uniforms = program.uniforms();
/// uniforms.set("n", &[2.0])?;
/// let specialized = program.specialize(&uniforms);
/// assert!(specialized.instructions() < program.size().0);
/// let mut machine = Machine::<1>::of(&specialized, &NoTextures, Default::default());
/// machine.input(0, 0)[0].0 = [0.25; 16];
/// machine.run()?;
/// assert_eq!(machine.output(0, 0)[0].0, [0.5; 16]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Specialized(pub(crate) Arc<SpecializedCode>);

#[derive(Debug)]
pub(crate) struct SpecializedCode {
    pub(crate) placed: Placed,
    /// The uniforms, a word per scalar: what is picked by an index that differs between lanes.
    pub(crate) words: Vec<u32>,
    loop_places: Arc<[(Span, Place)]>,
    /// Of each event of a trace.
    pub(crate) points: Vec<PlacedPoint>,
}

impl SpecializedCode {
    /// The error of a run that was stopped.
    pub(crate) fn endless(&self, stopped: OutOfFuel, turns: u32) -> RunError {
        endless(&self.placed, &self.loop_places, stopped, turns)
    }
}

/// How often a program is read anew, when numbers that were found decide on further branches.
const ROUNDS: usize = 3;

impl Specialized {
    pub(crate) fn new(program: &Program, uniforms: &UniformValues) -> Self {
        let words = uniforms.words.clone();
        let placed = specialized(program, uniforms).unwrap_or_else(|| program.lowered.placed.clone());
        let events = placed.events.iter().zip(&program.event_places);
        let points = events.map(|(event, place)| PlacedPoint::new(event, place.clone())).collect();
        let loop_places = Arc::clone(&program.loop_places);
        Self(Arc::new(SpecializedCode { placed, words, loop_places, points }))
    }

    /// How many instructions run for each fragment, loops once.
    pub fn instructions(&self) -> usize {
        self.0.placed.ops.len()
    }
}

/// Nothing, where the program must stay as it is.
fn specialized(program: &Program, uniforms: &UniformValues) -> Option<Placed> {
    let (draft, places) = program.lowered.draft.as_ref()?;
    let level = SimdLevel::best();
    let file = begin(level, program, uniforms);
    let mut known = vec![None; draft.state.groups.len()];
    for op in &draft.state.prologue {
        // The sizes of textures are not known here, nor what follows from them.
        if op.code == Code::Texture || op.reads().any(|r| known[r as usize].is_none()) {
            continue;
        }
        for r in op.d..op.d + op.written() {
            known[r as usize] = Some(file.get(places[r as usize])[0].0[0].to_bits());
        }
    }
    let mut draft = draft.clone();
    let mut evaluator = evaluate::Evaluator::new(level, &uniforms.words);
    for round in 0..ROUNDS {
        let decided = branches::decide(&mut draft.state, &known);
        if round > 0 && !decided {
            break;
        }
        (draft, known) = values::rewrite(&draft, &known, &mut evaluator);
        draft.remove_dead();
    }
    narrow(&mut draft);
    Some(draft.place().ok()?.0)
}

fn narrow(draft: &mut Draft) {
    let kept = draft.kept();
    narrow::narrow(&mut draft.state, &kept);
}
