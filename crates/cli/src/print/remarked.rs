//! What is odd about pictures of which many are drawn.

use glanz_picture::output::PictureData;
use glanz_render::{Remark, RemarkKind, Shot};
use glanz_scene::Scene;

use super::failure::Failure;
use super::stdout::note;

/// As many frames of a film are looked at, for a look can take as long as the frame.
const MOST_FRAMES: usize = 8;

/// What is odd about the pictures that were looked at, each kind once.
#[derive(Debug, Default)]
pub(crate) struct Remarked {
    looked: usize,
    found: Vec<Found>,
}

/// A kind of remark, in the words of the first picture that has it.
#[derive(Debug)]
struct Found {
    kind: RemarkKind,
    text: String,
    /// What the first picture is called.
    first: String,
    count: usize,
}

impl Remarked {
    /// Whether frame `index` of a film of `count` frames is one of those to look at, which lie evenly in it.
    pub(crate) fn wants(index: usize, count: usize) -> bool {
        index.is_multiple_of(count.div_ceil(MOST_FRAMES).max(1))
    }

    /// Looks at the picture that `shot` drew last, whose place in the work is called `name`.
    pub(crate) fn look(
        &mut self,
        shot: &mut Shot,
        scene: &Scene,
        picture: &PictureData,
        name: impl FnOnce() -> String,
    ) -> Result<(), Failure> {
        let remarks = shot.remarks(scene, picture)?;
        self.add(remarks, name);
        Ok(())
    }

    fn add(&mut self, remarks: Vec<Remark>, name: impl FnOnce() -> String) {
        self.looked += 1;
        let name = if remarks.is_empty() { String::new() } else { name() };
        for Remark { kind, text } in remarks {
            match self.found.iter_mut().find(|found| found.kind == kind) {
                Some(found) => found.count += 1,
                None => self.found.push(Found { kind, text, first: name.clone(), count: 1 }),
            }
        }
    }

    /// Each kind of remark, with where it holds if not in all pictures; tells them, too.
    pub(crate) fn tell(&self) -> Vec<String> {
        let lines: Vec<String> = self.found.iter().map(|found| self.line(found)).collect();
        lines.iter().for_each(|line| note(format_args!("note: {line}")));
        lines
    }

    fn line(&self, Found { text, first, count, .. }: &Found) -> String {
        match count - 1 {
            _ if *count == self.looked => text.clone(),
            0 => format!("{first}: {text}"),
            more => format!("{first} and {more} more of the {} looked at: {text}", self.looked),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn remark(text: &str) -> Remark {
        Remark { kind: RemarkKind::Clipped, text: text.to_owned() }
    }

    #[test]
    fn a_kind_is_told_once_with_where_it_holds() {
        let mut remarked = Remarked::default();
        let name = |number: usize| move || format!("frame {number}");
        remarked.add(vec![], name(0));
        remarked.add(vec![remark("5 % are clipped")], name(5));
        assert_eq!(remarked.tell(), ["frame 5: 5 % are clipped"]);
        remarked.add(vec![remark("7 % are clipped")], name(10));
        assert_eq!(remarked.tell(), ["frame 5 and 1 more of the 3 looked at: 5 % are clipped"]);
    }

    #[test]
    fn what_holds_everywhere_names_no_place() {
        let mut remarked = Remarked::default();
        remarked.add(vec![remark("all is clipped")], || "frame 0".to_owned());
        remarked.add(vec![remark("all is clipped")], || "frame 1".to_owned());
        assert_eq!(remarked.tell(), ["all is clipped"]);
    }

    #[test]
    fn eight_frames_of_a_long_film_are_looked_at() {
        let looked = |count| (0..count).filter(|&index| Remarked::wants(index, count)).collect::<Vec<_>>();
        assert_eq!(looked(3), [0, 1, 2]);
        assert_eq!(looked(80), [0, 10, 20, 30, 40, 50, 60, 70]);
        assert!(looked(81).len() <= MOST_FRAMES);
    }
}
