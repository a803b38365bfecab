//! Text: solids of facets, as words separated by any white space.

use std::io::BufRead;

use glam::DVec3;
use glanz_color::read::{ReadError, excerpt};

use super::super::context::Context;
use super::super::lines::{Lines, coordinate};
use super::weld::{Added, Weld};
use super::{NOT_FINITE, name_of};

/// Whether a file that begins with these bytes is text: with a keyword, behind a byte order mark and blanks.
pub(super) fn begins(head: &[u8]) -> bool {
    let head = head.strip_prefix(b"\xef\xbb\xbf").unwrap_or(head).trim_ascii_start();
    let begins = |word: &[u8]| head.get(..word.len()).is_some_and(|start| start.eq_ignore_ascii_case(word));
    begins(b"solid") || begins(b"facet")
}

/// Reads a file: a mesh for each solid.
pub(super) fn read(reader: impl BufRead, context: &mut Context<'_>) -> Result<Vec<Weld>, ReadError> {
    let mut words = Words { lines: Lines::new(reader, context.file), used: 0, len: 0, begun: false };
    let (mut meshes, mut solid) = (Vec::new(), None::<Weld>);
    while words.advance()? {
        let is_closed = words.is(b"endsolid") || words.is_end_of(b"solid")?;
        if is_closed || words.is(b"solid") {
            meshes.extend(solid.take());
            match is_closed {
                true => words.skip_name(),
                false => solid = Some(named(words.name())),
            }
        } else if words.is(b"facet") {
            if solid.is_none() {
                context.notes.add_at("STL: a solid does not begin with 'solid'", words.lines.place());
            }
            facet(&mut words, solid.get_or_insert_default(), context)?;
        } else {
            words.pass_over(context);
        }
    }
    if let Some(solid) = solid {
        context.notes.add("STL: the last solid has no 'endsolid'");
        meshes.push(solid);
    }
    Ok(meshes)
}

fn named(name: String) -> Weld {
    let mut solid = Weld::default();
    solid.mesh.name = name;
    solid
}

/// Reads a facet after its first word.
fn facet<R: BufRead>(
    words: &mut Words<'_, R>,
    solid: &mut Weld,
    context: &mut Context<'_>,
) -> Result<(), ReadError> {
    let place = words.lines.place();
    words.need("'outer loop'")?;
    if words.is(b"normal") {
        // What it says follows from the corners.
        words.need("'outer loop'")?;
        for _ in 0..3 {
            if coordinate(words.word()).is_some() {
                words.need("'outer loop'")?;
            }
        }
    }
    if words.is(b"outer") {
        words.need("'outer loop'")?;
        words.expect(b"loop", "'outer loop'")?;
    } else {
        words.expect(b"outerloop", "'outer loop'")?;
    }
    let mut corners = Vec::with_capacity(3);
    loop {
        words.need("'vertex' or 'endloop'")?;
        if words.is(b"endloop") || words.is_end_of(b"loop")? {
            break;
        }
        words.expect(b"vertex", "'vertex' or 'endloop'")?;
        corners.push(words.point()?);
    }
    if corners.len() < 3 {
        return Err(words.expected("three or more 'vertex'"));
    }
    words.need("'endfacet'")?;
    if !words.is_end_of(b"facet")? {
        words.expect(b"endfacet", "'endfacet'")?;
    }
    match solid.facet(&corners, None) {
        Added::Facet => Ok(()),
        Added::NotFinite => {
            context.notes.add_at(NOT_FINITE, place);
            Ok(())
        }
        Added::Full => Err(words.expected("at most 2^32 corners")),
    }
}

/// A reader of words.
struct Words<'a, R> {
    lines: Lines<'a, R>,
    /// How much of the line has been read.
    used: usize,
    /// The length of the word that ends there.
    len: usize,
    begun: bool,
}

impl<R: BufRead> Words<'_, R> {
    /// Goes to the next word; `false` at the end of the file.
    fn advance(&mut self) -> Result<bool, ReadError> {
        loop {
            if self.begun && self.advance_in_line() {
                return Ok(true);
            }
            self.begun = true;
            (self.used, self.len) = (0, 0);
            if !self.lines.advance()? {
                return Ok(false);
            }
        }
    }

    /// Goes to the next word of this line; `false` at its end.
    fn advance_in_line(&mut self) -> bool {
        let left = &self.lines.line()[self.used..];
        let Some(start) = left.iter().position(|byte| !byte.is_ascii_whitespace()) else { return false };
        let word = &left[start..];
        self.len = word.iter().position(u8::is_ascii_whitespace).unwrap_or(word.len());
        self.used += start + self.len;
        true
    }

    /// The word.
    fn word(&self) -> &[u8] {
        &self.lines.line()[self.used - self.len..self.used]
    }

    fn is(&self, word: &[u8]) -> bool {
        self.word().eq_ignore_ascii_case(word)
    }

    /// Whether this word and the next are `end` and this; goes to that one.
    fn is_end_of(&mut self, word: &[u8]) -> Result<bool, ReadError> {
        Ok(self.is(b"end") && self.advance()? && self.is(word))
    }

    /// Goes to the next word, which must be there.
    fn need(&mut self, what: &str) -> Result<(), ReadError> {
        match self.advance()? {
            true => Ok(()),
            false => Err(self.expected(what)),
        }
    }

    fn expect(&self, word: &[u8], what: &str) -> Result<(), ReadError> {
        if self.is(word) { Ok(()) } else { Err(self.expected(what)) }
    }

    /// Three numbers after `vertex`.
    fn point(&mut self) -> Result<DVec3, ReadError> {
        const WHAT: &str = "three numbers after 'vertex'";
        let mut point = DVec3::ZERO;
        for axis in 0..3 {
            self.need(WHAT)?;
            point[axis] = coordinate(self.word()).ok_or_else(|| self.expected(WHAT))?;
        }
        Ok(point)
    }

    /// An error at the word.
    fn expected(&self, what: &str) -> ReadError {
        let word = self.word();
        let found = if word.is_empty() { "the end of the file".to_owned() } else { excerpt(word) };
        let expected = format!("{what} (read as text, since it begins with a word of STL)");
        self.lines.malformed(expected, found)
    }

    /// The name of a solid: what follows in its line, up to its first facet.
    fn name(&mut self) -> String {
        let start = self.used;
        loop {
            let before = (self.used, self.len);
            let at_end = !self.advance_in_line();
            if at_end || self.is(b"facet") || self.is(b"endsolid") {
                let end = if at_end { self.used } else { self.used - self.len };
                let name = name_of(self.lines.line()[start..end].trim_ascii());
                (self.used, self.len) = before;
                return name;
            }
        }
    }

    /// Passes over the name after `endsolid`: what follows in its line, up to the next solid.
    fn skip_name(&mut self) {
        loop {
            let before = (self.used, self.len);
            if !self.advance_in_line() {
                return;
            }
            if self.is(b"solid") {
                (self.used, self.len) = before;
                return;
            }
        }
    }

    /// Passes over the rest of a line that is not understood.
    fn pass_over(&mut self, context: &mut Context<'_>) {
        let word = excerpt(self.word());
        let line = &self.lines.line()[self.used - self.len..];
        context.notes.add_kind_at(&format!("STL: {word}"), self.lines.place(), || {
            format!("STL: {word} is not understood: {} is passed over", excerpt(line))
        });
        self.used = self.lines.line().len();
    }
}
