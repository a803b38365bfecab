//! Values for a table of directions, line by line: a table may be longer than memory.

use std::fs::File;
use std::io::{self, BufRead, BufReader, BufWriter, Read, Write};
use std::path::Path;

use glanz_math::Vec3;
use glanz_picture::output::{OutputError, write_atomically};

use super::directions::{Columns, TableError};
use crate::args::check_folder;
use crate::print;
use crate::print::failure::{Failure, Report, without_number};

/// The longest line, in bytes.
const MAX_LINE: u64 = 1 << 20;

/// Reads directions from a file, or from stdin for `-`, and writes them with `values` of them in columns of these names.
pub(super) fn run(
    input: &Path,
    output: Option<&Path>,
    names: [&str; 2],
    values: impl Fn(Vec3<f64>, Vec3<f64>) -> (f64, Option<f64>),
) -> Result<(), Failure> {
    let is_stream = |path: &Path| path.as_os_str() == "-";
    let name = if is_stream(input) { "stdin".to_owned() } else { input.display().to_string() };
    let output = output.filter(|path| !is_stream(path));
    output.map_or(Ok(()), check_folder)?;
    let mut reader: Box<dyn BufRead> = match is_stream(input) {
        true => Box::new(io::stdin().lock()),
        false => Box::new(BufReader::new(open(input, &name)?)),
    };
    let Some(output) = output else {
        let mut out = BufWriter::new(io::stdout().lock());
        return convert(&mut reader, &name, &mut out, names, &values)
            .and_then(|()| out.flush().map_err(unwritten));
    };
    write_atomically(output, |out| -> Result<(), Wrapped> {
        let mut out = BufWriter::new(out);
        convert(&mut reader, &name, &mut out, names, &values).map_err(Wrapped)?;
        out.flush().map_err(|error| Wrapped(OutputError::Stream(error).into()))
    })
    .map_err(|Wrapped(failure)| failure)?;
    print::note(format_args!("wrote {}", output.display()));
    Ok(())
}

/// A failure that a writer of files may pass on.
struct Wrapped(Failure);

impl From<OutputError> for Wrapped {
    fn from(error: OutputError) -> Self {
        Self(error.into())
    }
}

fn open(path: &Path, name: &str) -> Result<File, Failure> {
    if path.is_dir() {
        return Err(Report::new(format_args!("cannot read '{name}': it is a folder")).file(path).into());
    }
    File::open(path).map_err(|error| unreadable(name, &error))
}

fn unreadable(name: &str, error: &io::Error) -> Failure {
    let message = format!("cannot read '{name}': {}", without_number(&error.to_string()));
    Report::new(message).file(Path::new(name)).into()
}

fn malformed(name: &str, error: &TableError) -> Failure {
    let report = Report::new(format_args!("{name}: {error}")).file(Path::new(name));
    match error.line() {
        Some(line) => report.line(line as u64).into(),
        None => report.into(),
    }
}

fn unwritten(error: io::Error) -> Failure {
    match error.kind() {
        io::ErrorKind::BrokenPipe => Failure::Closed,
        _ => OutputError::Stream(error).into(),
    }
}

/// Copies the table with two more columns.
fn convert(
    reader: &mut dyn BufRead,
    name: &str,
    out: &mut impl Write,
    [first, second]: [&str; 2],
    values: &impl Fn(Vec3<f64>, Vec3<f64>) -> (f64, Option<f64>),
) -> Result<(), Failure> {
    let failed = |error: TableError| malformed(name, &error);
    let (mut number, mut columns) = (0, None);
    while let Some(line) = next_line(reader, name, &mut number)? {
        if line.trim().is_empty() {
            continue;
        }
        let Some(known) = &columns else {
            let found = Columns::of_header(&line, number).map_err(failed)?;
            writeln!(out, "{line}{0}{first}{0}{second}", found.separator()).map_err(unwritten)?;
            columns = Some(found);
            continue;
        };
        let (wo, wi) = known.directions(&line, number).map_err(failed)?;
        let (f_cos, f) = values(wo, wi);
        // The shortest digits that are this number and no other.
        let f = f.map_or(String::new(), |f| format!("{f}"));
        writeln!(out, "{line}{0}{f_cos}{0}{f}", known.separator()).map_err(unwritten)?;
    }
    match columns {
        Some(_) => Ok(()),
        None => Err(failed(TableError::Empty)),
    }
}

/// The next line without its end, and its number; none at the end.
fn next_line(reader: &mut dyn BufRead, name: &str, number: &mut usize) -> Result<Option<String>, Failure> {
    let mut bytes = Vec::new();
    let read = reader.take(MAX_LINE + 1).read_until(b'\n', &mut bytes);
    if read.map_err(|error| unreadable(name, &error))? == 0 {
        return Ok(None);
    }
    *number += 1;
    let failed = |error: TableError| malformed(name, &error);
    if bytes.len() as u64 > MAX_LINE {
        return Err(failed(TableError::LongLine { line: *number, most: MAX_LINE }));
    }
    let text = String::from_utf8(bytes).map_err(|_| failed(TableError::NoText { line: *number }))?;
    let text = text.trim_end_matches(['\n', '\r']);
    let text = if *number == 1 { text.trim_start_matches('\u{feff}') } else { text };
    Ok(Some(text.to_owned()))
}
