//! What a reader left out, in words for people.

/// The most different notes that are kept; a file of nonsense would else fill the memory.
const MAX_NOTES: usize = 64;
/// The most characters of a note, which may hold a name from a file.
const MAX_LENGTH: usize = 300;

/// A list of remarks in which repetitions are counted.
#[derive(Debug, Default)]
pub(super) struct Notes {
    entries: Vec<(String, u64)>,
    dropped: u64,
}

impl Notes {
    /// Adds a remark, or counts it once more.
    pub(super) fn add(&mut self, text: &str) {
        self.add_times(text, 1);
    }

    /// Adds a remark that holds `times` times; nothing for zero.
    pub(super) fn add_times(&mut self, text: &str, times: u64) {
        if times == 0 {
            return;
        }
        if let Some((_, count)) = self.entries.iter_mut().find(|(known, _)| known == text) {
            *count += times;
        } else if self.entries.len() < MAX_NOTES {
            let clean = text.chars().take(MAX_LENGTH).map(|c| if c.is_control() { '?' } else { c });
            self.entries.push((clean.collect(), times));
        } else {
            self.dropped += times;
        }
    }

    /// The remarks in the order of their first occurrence, each with how often it holds.
    pub(super) fn into_strings(self) -> Vec<String> {
        let dropped = self.dropped;
        let mut lines: Vec<String> = self
            .entries
            .into_iter()
            .map(|(text, count)| if count == 1 { text } else { format!("{text} ({count} times)") })
            .collect();
        if dropped > 0 {
            lines.push(format!("and {dropped} more remarks of other kinds"));
        }
        lines
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn repetitions_are_counted_and_kinds_are_limited() {
        let mut notes = Notes::default();
        notes.add("a");
        notes.add("b");
        notes.add("a");
        notes.add_times("never", 0);
        assert_eq!(notes.into_strings(), ["a (2 times)", "b"]);
        let mut many = Notes::default();
        (0..1000).for_each(|i| many.add(&i.to_string()));
        let lines = many.into_strings();
        assert_eq!(lines.len(), MAX_NOTES + 1);
        assert_eq!(lines[MAX_NOTES], "and 936 more remarks of other kinds");
    }
}
