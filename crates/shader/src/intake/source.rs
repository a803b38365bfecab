//! Files and places in them.

use crate::Place;

/// Bytes of a file that something stems from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub(crate) struct Origin {
    pub(crate) file: u32,
    pub(crate) start: u32,
    pub(crate) end: u32,
}

#[derive(Clone, Debug)]
struct SourceFile {
    name: String,
    text: String,
    /// After byte `.0` lines count on from `.1`, as `#line` says.
    marks: Vec<(u32, u32)>,
}

/// All files of a shader: its own and those it includes.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sources {
    files: Vec<SourceFile>,
}

impl Sources {
    pub(crate) fn add(&mut self, name: &str, text: String) -> u32 {
        self.files.push(SourceFile { name: name.to_owned(), text, marks: Vec::new() });
        self.files.len() as u32 - 1
    }

    pub(crate) fn text(&self, file: u32) -> &str {
        self.files.get(file as usize).map_or("", |file| &file.text)
    }

    /// Lines after byte `at` count from `line` on.
    pub(super) fn mark(&mut self, file: u32, at: u32, line: u32) {
        if let Some(file) = self.files.get_mut(file as usize) {
            file.marks.push((at, line));
        }
    }

    pub(crate) fn place(&self, origin: Origin) -> Place {
        let Some(file) = self.files.get(origin.file as usize) else {
            return Place { file: String::new(), line: 1, column: 1, start: 0, end: 0 };
        };
        let mut start = (origin.start as usize).min(file.text.len());
        while !file.text.is_char_boundary(start) {
            start -= 1;
        }
        let before = &file.text[..start];
        let line_start = before.rfind('\n').map_or(0, |i| i + 1);
        let newlines = |from: usize| before.bytes().skip(from).filter(|b| *b == b'\n').count() as u32;
        let line = match file.marks.iter().rev().find(|(at, _)| *at as usize <= start) {
            None => 1 + newlines(0),
            // The newline that ends the directive's own line does not count.
            Some((at, line)) => (line + newlines(*at as usize)).saturating_sub(1),
        };
        let column = before[line_start..].chars().count() as u32 + 1;
        Place { file: file.name.clone(), line, column, start, end: (origin.end as usize).max(start) }
    }
}

/// What became of the user's text: bytes of the output and where they stem from.
#[derive(Clone, Debug, Default)]
pub(crate) struct Map {
    /// Start and end in the output, in rising order.
    segments: Vec<(u32, u32, Origin)>,
}

impl Map {
    pub(super) fn push(&mut self, start: usize, end: usize, origin: Origin) {
        self.segments.push((start as u32, end as u32, origin));
    }

    /// What stands before a byte of the output.
    pub(super) fn before(&self, at: usize) -> Option<Origin> {
        let next = self.segments.partition_point(|s| (s.1 as usize) <= at);
        next.checked_sub(1).and_then(|i| self.segments.get(i)).map(|s| s.2)
    }

    /// The user's text behind bytes of the output: from what stands at their start to what stands at their end.
    pub(crate) fn origin(&self, start: usize, end: usize) -> Option<Origin> {
        let first = self.segments.partition_point(|s| (s.1 as usize) <= start);
        let (from, to, mut origin) = *self.segments.get(first).or(self.segments.last())?;
        // One segment may hold the whole text, as that of WGSL does.
        if origin.end - origin.start == to - from {
            let inside = (start.max(from as usize) as u32 - from).min(to - from);
            let last = (end as u32).clamp(from + inside, to) - from;
            origin = Origin { start: origin.start + inside, end: origin.start + last, ..origin };
        }
        let last = self.segments.partition_point(|s| (s.0 as usize) < end);
        if let Some((_, _, other)) = last.checked_sub(1).and_then(|i| self.segments.get(i))
            && last > first + 1
            && other.file == origin.file
        {
            origin.end = origin.end.max(other.end);
        }
        Some(origin)
    }
}
