//! Errors that know their place in a scene file.

use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use thiserror::Error;

/// Why a scene file cannot be used: what was expected, what was found, and where.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{}: {message}", self.place())]
pub struct FileError {
    /// The file, or `override` if the value in question was given from outside.
    pub path: PathBuf,
    /// What is wrong.
    pub message: String,
    /// Bytes of `text` that it is about; `None` where it is about the file as a whole.
    pub span: Option<Range<usize>>,
    /// Line of the span's begin, from 1; 0 without a span.
    pub line: u32,
    /// Column of the span's begin in characters, from 1; 0 without a span.
    pub column: u32,
    /// What to do about it.
    pub help: Option<String>,
    /// The text that `span` points into: the scene file, or the override.
    pub text: Arc<str>,
}

impl FileError {
    /// An error about a file as a whole.
    pub(crate) fn whole(path: &Path, message: String) -> Self {
        let text = Arc::from("");
        Self { path: path.to_owned(), message, span: None, line: 0, column: 0, help: None, text }
    }

    fn place(&self) -> String {
        match self.span {
            Some(_) => format!("{}:{}:{}", self.path.display(), self.line, self.column),
            None => self.path.display().to_string(),
        }
    }
}

/// Something wrong at a place of the document.
///
/// Places are bytes of the *extended document*: the file's text, followed by the overrides; see
/// [`Source`].
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Problem {
    pub span: Option<Range<usize>>,
    pub message: String,
    pub help: Option<String>,
}

impl Problem {
    pub(super) fn at(span: &Range<usize>, message: impl Into<String>) -> Self {
        Self { span: Some(span.clone()), message: message.into(), help: None }
    }

    pub(super) fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }
}

/// The texts that a document comes from, laid out one after the other in one range of bytes.
#[derive(Debug)]
pub(crate) struct Source {
    path: PathBuf,
    text: Arc<str>,
    /// Where each override begins, and its text.
    overrides: Vec<(usize, Arc<str>)>,
    end: usize,
}

impl Source {
    pub(super) fn new(path: &Path, text: &str) -> Self {
        Self { path: path.to_owned(), text: text.into(), overrides: Vec::new(), end: text.len() + 1 }
    }

    /// Adds an override; the answer is the byte where it begins.
    pub(super) fn add_override(&mut self, text: &str) -> usize {
        let begin = self.end;
        self.overrides.push((begin, text.into()));
        self.end += text.len() + 1;
        begin
    }

    /// The error as people see it.
    pub(super) fn error(&self, problem: Problem) -> FileError {
        let Problem { span, message, help } = problem;
        let begin = span.as_ref().map_or(0, |span| span.start);
        let (path, text, offset) = match self.overrides.iter().rfind(|(from, _)| *from <= begin) {
            Some((from, text)) => (PathBuf::from("override"), text.clone(), *from),
            None => (self.path.clone(), self.text.clone(), 0),
        };
        let span = span.map(|span| {
            let clip = |byte: usize| floor_char(&text, byte.saturating_sub(offset));
            clip(span.start)..clip(span.end).max(clip(span.start))
        });
        let (line, column) = span.as_ref().map_or((0, 0), |span| line_column(&text, span.start));
        let (message, help) = (cut(message), help.map(cut));
        FileError { path, message, span, line, column, help, text }
    }
}

/// The most bytes of a message: it may quote a value of the file, however long that is.
const MAX_MESSAGE: usize = 2000;

/// A message, without its middle where it is too long to be read.
fn cut(message: String) -> String {
    if message.len() <= MAX_MESSAGE {
        return message;
    }
    let begin = floor_char(&message, MAX_MESSAGE / 10);
    let end = floor_char(&message, message.len() - MAX_MESSAGE / 10);
    format!("{} … {}", &message[..begin], &message[end..])
}

/// The begin of the character that holds `byte`, or the end of the text.
fn floor_char(text: &str, byte: usize) -> usize {
    let mut byte = byte.min(text.len());
    while !text.is_char_boundary(byte) {
        byte -= 1;
    }
    byte
}

fn line_column(text: &str, byte: usize) -> (u32, u32) {
    let before = &text[..byte];
    let line = before.bytes().filter(|b| *b == b'\n').count() + 1;
    let column = before.rsplit('\n').next().unwrap_or("").chars().count() + 1;
    (line as u32, column as u32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_and_columns_count_from_one_in_characters() {
        let text = "a\nß = é";
        assert_eq!(line_column(text, 0), (1, 1));
        assert_eq!(line_column(text, 2), (2, 1));
        assert_eq!(line_column(text, text.len()), (2, 6));
    }

    #[test]
    fn places_after_the_text_are_in_the_overrides() {
        let mut source = Source::new(Path::new("a.toml"), "x = 1\n");
        source.add_override("first=1");
        let begin = source.add_override("second=2");
        let error = source.error(Problem::at(&(begin + 7..begin + 8), "no"));
        assert_eq!(error.to_string(), "override:1:8: no");
        assert_eq!(&error.text[error.span.expect("given")], "2");
        let error = source.error(Problem::at(&(4..5), "no"));
        assert_eq!(error.to_string(), "a.toml:1:5: no");
    }

    #[test]
    fn of_a_long_message_begin_and_end_are_told() {
        let source = Source::new(Path::new("a.toml"), "x = 1\n");
        let long = format!("begin {} end", "ä".repeat(5000));
        let error = source.error(Problem::at(&(0..1), long.clone()).help(long));
        for text in [Some(error.message), error.help] {
            let text = text.expect("given");
            assert!(text.starts_with("begin ä") && text.ends_with("ä end") && text.contains(" … "), "{text}");
            assert!(text.len() < MAX_MESSAGE, "{}", text.len());
        }
        let short = "x".repeat(MAX_MESSAGE);
        assert_eq!(source.error(Problem::at(&(0..1), short.clone())).message, short);
    }

    #[test]
    fn spans_inside_characters_or_past_the_end_are_clipped() {
        let source = Source::new(Path::new("a.toml"), "é");
        let error = source.error(Problem::at(&(1..1), "no"));
        assert_eq!(error.span, Some(0..0));
        assert_eq!(floor_char("é", 99), 2);
    }
}
