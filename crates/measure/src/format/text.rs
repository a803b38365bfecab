//! What the readers of texts share: words with their lines, and numbers as programs and people write them.

use crate::ReadError;

/// The words of a text, one after the other; lines that begin with `#` and blank ones are left out.
#[derive(Clone)]
pub(super) struct Words<'a> {
    lines: std::str::Lines<'a>,
    /// The rest of the line.
    words: std::str::Split<'a, fn(char) -> bool>,
    /// Whether a comma in the line is that of a decimal.
    has_decimal_commas: bool,
    /// The number of the line, counted from 1.
    pub(super) line: u32,
}

impl<'a> Words<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        let words = "".split(is_space as fn(char) -> bool);
        Self { lines: text.lines(), words, has_decimal_commas: false, line: 0 }
    }

    /// The next word, on whatever line; nothing at the end.
    pub(super) fn next(&mut self) -> Option<&'a str> {
        loop {
            if let Some(word) = self.words.find(|word| !word.is_empty()) {
                return Some(word);
            }
            let line = self.lines.next()?;
            self.line += 1;
            if !line.trim_start().starts_with('#') {
                self.has_decimal_commas = has_decimal_commas(line);
                self.words = line.split(separator(self.has_decimal_commas));
            }
        }
    }

    /// The next word, which must be there.
    pub(super) fn word(&mut self, what: &str) -> Result<&'a str, ReadError> {
        let next = self.next();
        next.ok_or_else(|| ReadError::at(self.line.max(1), format!("the file ends where {what} is expected")))
    }

    /// The next word, which must be a number.
    pub(super) fn number(&mut self, what: &str) -> Result<f64, ReadError> {
        let word = self.word(what)?;
        let value = number(word, self.has_decimal_commas);
        value.ok_or_else(|| ReadError::at(self.line, format!("expected {what}, found '{word}'")))
    }

    /// The next word, which must count something.
    pub(super) fn count(&mut self, what: &str) -> Result<usize, ReadError> {
        let word = self.word(what)?;
        let count = word.parse::<usize>().ok().filter(|count| *count > 0);
        count.ok_or_else(|| ReadError::at(self.line, format!("expected {what}, found '{word}'")))
    }

    /// The numbers up to the next word that is none. A count stands before them; where it is another one, which readers
    /// can do without, that is noted.
    pub(super) fn list(&mut self, what: &str, notes: &mut Vec<String>) -> Result<Vec<f64>, ReadError> {
        let count = self.count(&format!("the number of {what}"))?;
        let mut list = Vec::new();
        loop {
            let mut ahead = self.clone();
            let Some(value) = ahead.next().and_then(|word| number(word, ahead.has_decimal_commas)) else {
                break;
            };
            list.push(value);
            *self = ahead;
        }
        if list.is_empty() {
            return Err(ReadError::at(self.line, format!("there are no {what} below their number")));
        }
        if list.len() != count {
            notes.push(format!("{count} {what} are announced, and {} are there", list.len()));
        }
        Ok(list)
    }
}

/// The numbers of a row.
pub(super) fn row(number_of_line: u32, line: &str) -> Result<Vec<f64>, ReadError> {
    let has_decimal_commas = has_decimal_commas(line);
    let words = line.split(separator(has_decimal_commas)).filter(|word| !word.is_empty());
    words
        .map(|word| {
            number(word, has_decimal_commas).ok_or_else(|| {
                ReadError::at(number_of_line, format!("expected a row of numbers, found '{word}'"))
            })
        })
        .collect()
}

fn is_space(c: char) -> bool {
    c.is_whitespace() || c == ';'
}

fn is_space_or_comma(c: char) -> bool {
    is_space(c) || c == ','
}

fn separator(has_decimal_commas: bool) -> fn(char) -> bool {
    if has_decimal_commas { is_space } else { is_space_or_comma }
}

/// Whether commas in a line are those of decimals: other signs stand between its words, no word has more than one comma,
/// each of them between digits, and no point occurs.
fn has_decimal_commas(line: &str) -> bool {
    if !line.contains(',') || line.contains('.') {
        return false;
    }
    let words = || line.split(is_space).filter(|word| !word.is_empty());
    let is_decimal = |word: &str| match word.split_once(',') {
        Some((before, after)) => {
            before.ends_with(|c: char| c.is_ascii_digit()) && after.starts_with(|c: char| c.is_ascii_digit())
        }
        None => true,
    };
    words().count() > 1 && words().all(|word| is_decimal(word) && word.matches(',').count() < 2)
}

/// A number; the exponent may be Fortran's D, and what Windows writes for no number is NaN.
fn number(word: &str, has_decimal_commas: bool) -> Option<f64> {
    if let Ok(value) = word.parse::<f64>() {
        return Some(value);
    }
    if word.contains("#IND") || word.contains("#QNAN") {
        return Some(f64::NAN);
    }
    let point = if has_decimal_commas { word.replace(',', ".") } else { word.to_owned() };
    point.replace(['d', 'D'], "e").parse::<f64>().ok()
}

/// The first words of a comment, which say what a file is of.
pub(super) fn first_comment(text: &str) -> String {
    let mut comments = text.lines().filter_map(|line| line.trim().strip_prefix('#')).map(str::trim);
    comments.find(|words| !words.is_empty()).unwrap_or_default().to_owned()
}

/// Whether a line of the text begins with a word, in whatever case.
pub(super) fn has_keyword(text: &str, keyword: &str) -> bool {
    text.lines().any(|line| {
        let word = line.split_whitespace().next();
        word.is_some_and(|word| word.eq_ignore_ascii_case(keyword))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_as_people_write_them() {
        let read = |line: &str| row(1, line);
        assert_eq!(read("1 2.5\t-3e2; 4D-1,"), Ok(vec![1.0, 2.5, -300.0, 0.4]));
        assert_eq!(read("1,5 2,25"), Ok(vec![1.5, 2.25]));
        // Commas that could be either stand between numbers.
        assert_eq!(read("1,5"), Ok(vec![1.0, 5.0]));
        assert_eq!(read("1,2 , 3"), Ok(vec![1.0, 2.0, 3.0]));
        assert_eq!(read("1.5,2 3,4"), Ok(vec![1.5, 2.0, 3.0, 4.0]));
        assert!(read("1.#QNAN").is_ok_and(|row| row[0].is_nan()));
        let error = read("1 two").map_err(|error| error.to_string());
        assert_eq!(error, Err("expected a row of numbers, found 'two'".to_owned()));
    }
}
