//! What is odd about a program and what it drew.

use glanz_shader::{Pass, Screen, ScreenPicture};

use super::super::check::told;
use crate::print::note;

/// As many names are told of a kind.
const MOST_NAMES: usize = 6;

/// What was found so far.
#[derive(Debug, Default)]
pub(super) struct Remarks {
    lines: Vec<String>,
    frames: usize,
    black: usize,
    /// The first frame with pixels that are not a number: its number, how many, the first one's place; and how many
    /// frames have any.
    not_numbers: Option<(u32, usize, [usize; 2])>,
    with_not_numbers: usize,
}

impl Remarks {
    /// What is known already.
    pub(super) fn lines(&mut self, lines: impl Iterator<Item = String>) {
        self.lines.extend(lines);
    }

    /// What a pass alone tells; its name, where there are several.
    pub(super) fn program(
        &mut self,
        name: Option<&str>,
        pass: &Pass,
        unfilled: &[String],
        screen: &Screen<'_>,
    ) {
        let program = &pass.program;
        let of = name.map(|name| format!("{name}: ")).unwrap_or_default();
        self.lines.extend(program.warnings().iter().map(told));
        if let Some(names) = listed(unfilled.iter().map(String::as_str)) {
            self.lines.push(format!("{of}nothing fills {names}: 0, unless --uniform NAME=VALUE sets it"));
        }
        if let Some(names) = listed(screen.unfilled_inputs()) {
            self.lines.push(format!("{of}without a mesh nothing fills the input {names}: 0"));
        }
        let textures = program.interface().textures.iter().zip(&pass.textures).enumerate();
        let empty = textures
            .filter(|(index, (_, picture))| picture.is_none() && program.looks_into(*index))
            .map(|(_, (own, _))| own.name.as_str());
        if let Some(names) = listed(empty) {
            self.lines.push(format!(
                "{of}no picture is given for {names}: every look into it is opaque black; see --texture, --channel0"
            ));
        }
    }

    /// Looks at a frame.
    pub(super) fn picture(&mut self, picture: &ScreenPicture, index: usize, frame: u32) {
        self.frames = index + 1;
        if let Some((count, place)) = picture.not_numbers() {
            self.with_not_numbers += 1;
            self.not_numbers.get_or_insert((frame, count, place));
        } else if picture.is_black() {
            self.black += 1;
        }
    }

    /// Tells everything, and gives it as lines.
    pub(super) fn tell(mut self) -> Vec<String> {
        let of_frames = |n: usize, frames: usize| {
            if frames > 1 { format!(" in {n} of {frames} frames") } else { String::new() }
        };
        if let Some((frame, count, [x, y])) = self.not_numbers {
            let first = if self.frames > 1 { format!("frame {frame}: ") } else { String::new() };
            let rest = of_frames(self.with_not_numbers, self.frames);
            let pixels = if count == 1 { "pixel is" } else { "pixels are" };
            self.lines.push(format!(
                "{first}{count} {pixels} not a number (NaN) and magenta, the first at {x},{y} from the top left{rest}"
            ));
        }
        if self.black > 0 {
            self.lines.push(format!("all pixels are black{}", of_frames(self.black, self.frames)));
        }
        self.lines.iter().for_each(|line| note(format_args!("note: {line}")));
        self.lines
    }
}

/// Names in quotes, the first few of them; `None` if there are none.
fn listed<'a>(names: impl Iterator<Item = &'a str>) -> Option<String> {
    let all: Vec<String> = names.map(|name| format!("'{name}'")).collect();
    let more = all.len().saturating_sub(MOST_NAMES);
    let few = all.iter().take(MOST_NAMES).cloned().collect::<Vec<_>>().join(", ");
    match (all.len(), more) {
        (0, _) => None,
        (_, 0) => Some(few),
        _ => Some(format!("{few} and {more} more")),
    }
}
