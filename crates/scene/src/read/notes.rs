//! What a reader left out, in words for people.

use glanz_color::read::Place;

/// The most different notes that are kept; a file of nonsense would else fill the memory.
const MAX_NOTES: usize = 64;
/// The most characters of a note, which may hold a name from a file.
const MAX_LENGTH: usize = 300;

/// A list of remarks in which repetitions are counted.
#[derive(Debug, Default)]
pub(super) struct Notes {
    entries: Vec<Entry>,
    dropped: u64,
}

/// A remark.
#[derive(Debug)]
struct Entry {
    /// What repetitions have in common.
    key: String,
    text: String,
    count: u64,
    /// Where it held first, if that is told.
    place: Option<Place>,
}

impl Notes {
    /// Adds a remark, or counts it once more.
    pub(super) fn add(&mut self, text: &str) {
        self.add_times(text, 1);
    }

    /// Adds a remark that holds `times` times; nothing for zero.
    pub(super) fn add_times(&mut self, text: &str, times: u64) {
        self.add_entry(text, times, None, || text.to_owned());
    }

    /// Adds a remark with the place where it holds; of repetitions the first is told.
    pub(super) fn add_at(&mut self, text: &str, place: Place) {
        self.add_entry(text, 1, Some(place), || text.to_owned());
    }

    /// The same where the text differs between what counts as repetitions, which have the `key` in common.
    pub(super) fn add_kind_at(&mut self, key: &str, place: Place, text: impl FnOnce() -> String) {
        self.add_entry(key, 1, Some(place), text);
    }

    fn add_entry(&mut self, key: &str, times: u64, place: Option<Place>, text: impl FnOnce() -> String) {
        if times == 0 {
            return;
        }
        if let Some(entry) = self.entries.iter_mut().find(|entry| entry.key == key) {
            entry.count += times;
        } else if self.entries.len() < MAX_NOTES {
            let clean =
                text().chars().take(MAX_LENGTH).map(|c| if c.is_control() { '?' } else { c }).collect();
            self.entries.push(Entry { key: key.to_owned(), text: clean, count: times, place });
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
            .map(|Entry { text, count, place, .. }| match (count, place) {
                (1, None) => text,
                (1, Some(place)) => format!("{text} ({place})"),
                (count, None) => format!("{text} ({count} times)"),
                (count, Some(place)) => format!("{text} ({count} times, first at {place})"),
            })
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
    fn the_first_place_of_a_remark_is_told() {
        let mut notes = Notes::default();
        notes.add_at("a", Place::Line(3));
        notes.add_kind_at("key", Place::Line(4), || "b 1".to_owned());
        notes.add_kind_at("key", Place::Line(5), || "b 2".to_owned());
        assert_eq!(notes.into_strings(), ["a (line 3)", "b 1 (2 times, first at line 4)"]);
    }

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
