//! The one way in which a command fails, and how that is told.

use std::fmt;
use std::io::{self, IsTerminal, Write};
use std::path::Path;
use std::process::ExitCode;

use clap::error::ErrorKind;
use clap::{Command, CommandFactory};
use glanz_picture::output::OutputError;
use glanz_render::{PrepareError, ShotError};
use glanz_scene::read::{Place, ReadError};
use miette::{
    Diagnostic, GraphicalReportHandler, GraphicalTheme, LabeledSpan, NamedSource, SourceCode, SourceSpan,
};
use schemars::JsonSchema;
use serde::Serialize;

use super::document::versioned;
use super::stdout::Format;
use super::text::harmless;
use crate::input::shader_text::Texts;

/// Shown after the help of the whole command.
pub(crate) const EXIT_CODES: &str = "\
Exit codes:
  0  done
  1  judged and failed: a bound of compare is broken, a law fails in check
  2  usage: the command line makes no sense
  3  could not: a file that cannot be read or written, a scene with an error, pictures of two sizes";

/// Why a command ends early. The kind alone decides the exit code.
#[derive(Debug)]
pub(crate) enum Failure {
    /// The work is done, and what it judged has failed.
    Judged(Box<Report>),
    /// The command line makes no sense.
    Usage(String),
    /// The command line sets a value that the scene cannot have.
    WrongValue(Box<Report>),
    /// The work could not be done.
    CouldNot(Box<Report>),
    /// Whoever read our output has had enough. Not an error.
    Closed,
}

impl Failure {
    /// The exit code, as [`EXIT_CODES`] tells it.
    pub(crate) fn code(&self) -> u8 {
        match self {
            Self::Closed => 0,
            Self::Judged(_) => 1,
            Self::Usage(_) | Self::WrongValue(_) => 2,
            Self::CouldNot(_) => 3,
        }
    }

    /// Work that could not be done, told by its message alone.
    pub(crate) fn new(message: impl fmt::Display) -> Self {
        Report::new(message).into()
    }

    /// The same, with the file of the scene that is drawn where it is about that.
    pub(crate) fn of_scene(self, path: &Path) -> Self {
        match self {
            Self::CouldNot(report) if report.is_of_scene => report.file(path).into(),
            other => other,
        }
    }

    /// Tells the failure on stderr; the program goes on.
    pub(crate) fn tell(self) {
        // Nothing is left to be done where what is told cannot be written.
        let _ = match self {
            Self::Usage(message) => Report::new(message).print(),
            Self::Judged(report) | Self::WrongValue(report) | Self::CouldNot(report) => report.print(),
            Self::Closed => Ok(()),
        };
    }

    /// Tells the failure, on stderr for people and on stdout for programs, and the exit code.
    pub(crate) fn report<C: CommandFactory>(self, command: &[&str], format: Format) -> ExitCode {
        let code = ExitCode::from(self.code());
        // Nothing is left to be done where what is told cannot be written.
        let _ = match (self, format) {
            (Self::Usage(message), _) => {
                let mut root = C::command();
                root.build();
                let error = subcommand(&mut root, command).error(ErrorKind::ValueValidation, message);
                return wrong_use(&error, format);
            }
            (Self::Judged(report) | Self::WrongValue(report) | Self::CouldNot(report), Format::Text) => {
                report.print()
            }
            (Self::WrongValue(report) | Self::CouldNot(report), Format::Json) => tell(report.facts()),
            // What was judged is on stdout, and the error in it.
            (Self::Judged(_), Format::Json) | (Self::Closed, _) => Ok(()),
        };
        code
    }
}

/// Tells that the command line makes no sense, and the exit code.
pub(crate) fn wrong_use(error: &clap::Error, format: Format) -> ExitCode {
    let _ = match format {
        Format::Text => error.print(),
        Format::Json => tell(ErrorFacts::of_usage(error)),
    };
    ExitCode::from(Failure::Usage(String::new()).code())
}

/// Writes an error to stdout, for programs.
fn tell(error: ErrorFacts) -> io::Result<()> {
    let mut stdout = io::stdout().lock();
    writeln!(stdout, "{:#}", versioned(&ErrorDocument { error }))?;
    stdout.flush()
}

/// What a command prints with `--format json` in place of its own document when it fails.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct ErrorDocument {
    /// Why the command failed
    error: ErrorFacts,
}

/// Why a command failed.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, JsonSchema)]
pub(crate) struct ErrorFacts {
    /// What is wrong, in one line where it can be said in one
    message: String,
    /// The file that it is about
    file: Option<String>,
    /// The line of the file, from 1
    line: Option<u64>,
    /// The column of the line, from 1
    column: Option<u64>,
    /// What could be done about it
    help: Option<String>,
}

impl ErrorFacts {
    /// What the parser of command lines says: its first paragraph is the message, the rest helps.
    fn of_usage(error: &clap::Error) -> Self {
        let text = error.render().to_string();
        let text = text.trim();
        let (message, help) = match error.kind() {
            ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => ("a command is missing", text),
            _ => text.split_once("\n\n").unwrap_or((text, "")),
        };
        let message = message.trim_start_matches("error: ").trim().to_owned();
        let help = Some(help.trim()).filter(|help| !help.is_empty()).map(str::to_owned);
        Self { message, help, ..Self::default() }
    }
}

impl From<Report> for Failure {
    fn from(report: Report) -> Self {
        Self::CouldNot(Box::new(report))
    }
}

impl From<OutputError> for Failure {
    fn from(error: OutputError) -> Self {
        let report = Report::new(without_number(&error.to_string()));
        match &error {
            OutputError::File { path, .. }
            | OutputError::UnknownExtension { path }
            | OutputError::Input { path } => report.file(path).into(),
            _ => report.into(),
        }
    }
}

impl From<&ReadError> for Report {
    fn from(error: &ReadError) -> Self {
        let report = Self::new(without_number(&error.to_string())).file(Path::new(error.file()));
        match error.place() {
            Place::Column { line, column } => report.place(*line, *column),
            // The characters before a field are not counted; the message tells which field it is.
            Place::Line(line) | Place::Field { line, .. } => report.line(*line),
            _ => report,
        }
    }
}

impl From<ReadError> for Failure {
    fn from(error: ReadError) -> Self {
        Report::from(&error).into()
    }
}

impl From<glanz_plot::Error> for Failure {
    fn from(error: glanz_plot::Error) -> Self {
        use glanz_plot::Error;
        match error {
            Error::Output(error) => error.into(),
            Error::ViewAngle { .. } | Error::Azimuth { .. } => Self::Usage(format!("--{error}")),
            Error::Distance { .. } => Self::Usage(format!("--distance: {error}")),
            Error::Age { .. } => Self::Usage(format!("--age: {error}")),
            Error::Luminance { .. } => Self::Usage(format!("--luminance: {error}")),
            Error::Pigment { .. } => Self::Usage(format!("--pigment: {error}")),
            Error::SingleDirection { .. } => {
                let help = "--kind fresnel shows its reflectance, --kind vectors its direction, 'glanz bsdf eval' both as numbers";
                Report::new(error).help(help).wrong_value()
            }
            Error::EmptyLobe { .. } => Self::new(error),
            Error::NoFacets { .. } => Report::new(error).help("--kind polar shows its lobe").into(),
            Error::SheetSize { .. } => Report::new(error).help("draw smaller pictures, or fewer").into(),
            _ => Self::Usage(error.to_string()),
        }
    }
}

impl From<ShotError> for Failure {
    fn from(error: ShotError) -> Self {
        if let ShotError::Prepare(PrepareError::Program(error)) = &error {
            return Texts::known(&error.texts).failure(&error.error);
        }
        Report::new(error).about_scene().into()
    }
}

/// A message without the operating system's number of the error, which helps nobody.
pub(crate) fn without_number(message: &str) -> String {
    match message.split_once(" (os error ") {
        Some((before, after)) => format!("{before}{}", after.split_once(')').map_or("", |(_, rest)| rest)),
        None => message.to_owned(),
    }
}

/// A text whose lines have at most about so many bytes.
fn shortened(text: &str, longest: usize) -> String {
    let cut = |line: &str| match line.len() <= longest {
        true => line.to_owned(),
        false => {
            let boundary = (0..longest - 4).rev().find(|at| line.is_char_boundary(*at)).unwrap_or(0);
            let end = if line.ends_with('\n') { "\n" } else { "" };
            format!("{} …{end}", &line[..boundary])
        }
    };
    text.split_inclusive('\n').map(cut).collect()
}

/// A text in which the line at fault is short enough to be shown, and where the fault is in it.
fn short_line(text: String, span: std::ops::Range<usize>) -> (String, std::ops::Range<usize>) {
    /// Bytes of a line that are shown whole, and on either side of the fault where it is longer.
    const LONGEST: usize = 400;
    const AROUND: usize = 80;
    let boundary =
        |at: usize| (0..=at.min(text.len())).rev().find(|at| text.is_char_boundary(*at)).unwrap_or(0);
    let (start, end) = (boundary(span.start), boundary(span.end.max(span.start)));
    let line_start = text[..start].rfind('\n').map_or(0, |at| at + 1);
    let line_end = text[start..].find('\n').map_or(text.len(), |at| start + at);
    // The lines around it are shown, too.
    let longest_around = |text: &str| text.lines().map(str::len).max().unwrap_or(0) <= LONGEST;
    if !(longest_around(&text[..line_start]) && longest_around(&text[line_end..])) {
        let moved = shortened(&text[..line_start], LONGEST);
        let by = moved.len();
        let after = shortened(&text[line_end..], LONGEST);
        let text = format!("{moved}{}{after}", &text[line_start..line_end]);
        return short_line(text, by + span.start - line_start..by + span.end.max(span.start) - line_start);
    }
    if line_end - line_start <= LONGEST {
        return (text, span);
    }
    let end = end.min(boundary(start + AROUND)).min(line_end);
    let from = boundary(start.saturating_sub(AROUND)).max(line_start);
    let to = boundary(end + AROUND).min(line_end).max(end);
    let (before, after) = (if from > line_start { "… " } else { "" }, if to < line_end { " …" } else { "" });
    let cut = format!("{}{before}{}{after}{}", &text[..line_start], &text[from..to], &text[line_end..]);
    let moved = line_start + before.len() + (start - from);
    (cut, moved..moved + (end - start))
}

/// The subcommand of `root` that `path` leads to.
fn subcommand<'a>(root: &'a mut Command, path: &[&str]) -> &'a mut Command {
    path.iter().fold(root, |command, name| {
        command.find_subcommand_mut(name).expect("a running command is a subcommand of the root")
    })
}

/// A failure with all that helps to mend it.
#[derive(Debug, Default)]
pub(crate) struct Report {
    message: String,
    help: Option<String>,
    file: Option<String>,
    line: Option<u64>,
    column: Option<u64>,
    source: Option<NamedSource<String>>,
    label: Option<LabeledSpan>,
    /// Whether it is about the scene that is drawn, whose file only the command knows.
    is_of_scene: bool,
}

impl Report {
    /// A report of this message.
    pub(crate) fn new(message: impl fmt::Display) -> Self {
        Self { message: harmless(&message.to_string()).into_owned(), ..Self::default() }
    }

    /// The failure of what was judged, once it is told; it is one, too, where nobody reads what is told.
    pub(crate) fn of_judged(error: Option<Self>, told: Result<(), Failure>) -> Result<(), Failure> {
        match (told, error) {
            (Ok(()) | Err(Failure::Closed), Some(error)) => Err(error.judged()),
            (told, _) => told,
        }
    }

    /// The failure of something that was judged.
    pub(crate) fn judged(self) -> Failure {
        Failure::Judged(Box::new(self))
    }

    /// The failure of a command line that sets a value wrongly.
    pub(crate) fn wrong_value(self) -> Failure {
        Failure::WrongValue(Box::new(self))
    }

    /// Adds what could be done about it.
    pub(crate) fn help(mut self, help: impl fmt::Display) -> Self {
        self.help = Some(harmless(&help.to_string()).into_owned());
        self
    }

    /// Adds the file that it is about, for programs; the message names it for people.
    pub(crate) fn file(mut self, file: &Path) -> Self {
        self.file = Some(file.display().to_string());
        self
    }

    /// That it is about the scene that is drawn, whose file [`Failure::of_scene`] adds.
    pub(crate) fn about_scene(self) -> Self {
        Self { is_of_scene: true, ..self }
    }

    /// Adds the line of the file, from 1, for programs.
    pub(crate) fn line(self, line: u64) -> Self {
        Self { line: Some(line), ..self }
    }

    /// Adds line and column in the file, from 1, for programs.
    pub(crate) fn place(self, line: u64, column: u64) -> Self {
        Self { line: Some(line), column: Some(column), ..self }
    }

    /// Adds the text of a file, or of an argument, and the bytes of it that are at fault.
    pub(crate) fn source(mut self, file: &str, text: String, span: std::ops::Range<usize>) -> Self {
        let (text, span) = short_line(harmless(&text).into_owned(), span);
        let start = span.start.min(text.len());
        let length = span.end.clamp(start, text.len()) - start;
        self.label =
            Some(LabeledSpan::new_with_span(Some("here".to_owned()), SourceSpan::from((start, length))));
        self.source = Some(NamedSource::new(harmless(file), text));
        self
    }

    /// What programs are told.
    pub(crate) fn facts(&self) -> ErrorFacts {
        ErrorFacts {
            message: self.message.clone(),
            file: self.file.clone(),
            line: self.line,
            column: self.column,
            help: self.help.clone(),
        }
    }

    /// Writes the report to stderr: with colours and frames on a terminal, plain elsewhere.
    fn print(&self) -> io::Result<()> {
        let mut stderr = io::stderr().lock();
        if !stderr.is_terminal() {
            return writeln!(stderr, "{}", self.plain().map_err(io::Error::other)?);
        }
        let colored = std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty());
        let theme = if colored { GraphicalTheme::unicode() } else { GraphicalTheme::unicode_nocolor() };
        let mut text = String::new();
        GraphicalReportHandler::new_themed(theme).render_report(&mut text, self).map_err(io::Error::other)?;
        write!(stderr, "{text}")
    }

    /// The report in ASCII, with the message in one line after `error:`, wherever it may be searched
    /// or compared.
    fn plain(&self) -> Result<String, fmt::Error> {
        let handler = GraphicalReportHandler::new_themed(GraphicalTheme::none()).with_width(10_000);
        let mut text = String::new();
        handler.render_report(&mut text, self)?;
        let text = text.lines().map(str::trim_end).collect::<Vec<_>>().join("\n");
        // The frame begins with a cross, which the word replaces.
        Ok(format!("error: {}", text.trim_start().trim_start_matches('x').trim()))
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Report {}

impl Diagnostic for Report {
    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        self.help.as_ref().map(|help| Box::new(help) as Box<dyn fmt::Display>)
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        self.source.as_ref().map(|source| source as &dyn SourceCode)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        self.label.clone().map(|label| Box::new(std::iter::once(label)) as Box<dyn Iterator<Item = _>>)
    }
}

#[cfg(test)]
mod tests {
    use glanz_scene::ColorMode;

    use super::*;

    #[test]
    fn of_a_long_line_only_what_is_about_the_fault_is_shown() {
        let text = format!("first\n{}fault{}\nlast", "ä".repeat(3000), "b".repeat(5000));
        let start = text.find("fault").unwrap();
        let (cut, span) = short_line(text.clone(), start..start + 5);
        assert_eq!(&cut[span], "fault");
        assert!(cut.len() < 300 && cut.starts_with("first\n… ä") && cut.ends_with("b …\nlast"), "{cut}");
        let (cut, span) = short_line(text.clone(), start..text.len());
        assert!(cut.len() < 400 && cut[span].starts_with("faultb"), "{cut}");
        let beside = format!("{}\nfault\n{}\n", "ä".repeat(3000), "b".repeat(5000));
        let start = beside.find("fault").unwrap();
        let (cut, span) = short_line(beside, start..start + 5);
        assert!(&cut[span] == "fault" && cut.len() < 900 && cut.ends_with("bb …\n"), "{cut}");
        let (same, span) = short_line("short".to_owned(), 2..9);
        assert_eq!((same.as_str(), span), ("short", 2..9));
    }

    #[test]
    fn what_fails_while_it_is_drawn_is_the_scenes() {
        let file = |failure: Failure| match failure.of_scene(Path::new("ball.toml")) {
            Failure::CouldNot(report) => report.facts().file,
            other => panic!("{other:?}"),
        };
        assert_eq!(file(ShotError::NoSpectra { mode: ColorMode::Rgb }.into()).as_deref(), Some("ball.toml"));
        assert_eq!(file(Failure::new("the disk is full")), None);
    }
}
