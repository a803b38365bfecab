//! The machines that a thread has at hand.

use glanz_math::SimdLevel;
use glanz_shader::{Machine, Stage};

use super::ObjectProgram;

/// The most machines that a thread keeps; each has 64 KB of registers.
const MOST: usize = 16;

/// Machines by object and stage, those used last at the end.
#[derive(Default)]
pub(crate) struct Pool<'a>(Vec<(usize, Stage, Machine<'a, 1>)>);

impl<'a> Pool<'a> {
    /// The machine of a stage of an object's program, with all that is the same for the draw computed.
    pub(super) fn machine(
        &mut self,
        object: usize,
        stage: Stage,
        program: &'a ObjectProgram<'a>,
        level: SimdLevel,
    ) -> &mut Machine<'a, 1> {
        let list = &mut self.0;
        let known = list.iter().rposition(|(number, own, _)| (*number, *own) == (object, stage));
        if let Some(known) = known {
            return &mut list[known].2;
        }
        if list.len() == MOST {
            list.remove(0);
        }
        let textures = match stage {
            Stage::Vertex => &program.vertex_textures,
            Stage::Fragment => &program.fragment_textures,
        };
        let machine = Machine::<1>::of(program.specialized(stage), textures, level).with_rows_down();
        list.push((object, stage, machine));
        let last = list.len() - 1;
        &mut list[last].2
    }
}
