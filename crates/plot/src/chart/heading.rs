//! The heading of a page.

use crate::page::style::{GRAY, INK, LABEL, TITLE};
use crate::page::{Anchor, Page, letters};

/// The space to the right of the heading, in points.
const MARGIN: f64 = 12.0;

/// How small letters may become before a line is broken in two, in parts of their size.
const SMALLEST: f64 = 0.8;

/// Writes the title, and what there is to say more; where the page is narrow in smaller letters or two lines.
pub(crate) fn heading(page: &mut Page, x: f64, title: &str, subtitle: &str) {
    let space = f64::from(page.width) - x - MARGIN;
    let part = |text: &str, size: f64| (space / letters::width(text, size).max(1.0)).min(1.0);
    page.text(title, (x, 40.0), Anchor::Start, TITLE * part(title, TITLE), INK);
    match halves(subtitle).filter(|_| part(subtitle, LABEL) < SMALLEST) {
        Some((first, second)) => {
            let size = LABEL * part(first, LABEL).min(part(second, LABEL)).min(SMALLEST);
            page.text(first, (x, 61.0), Anchor::Start, size, GRAY);
            page.text(second, (x, 77.0), Anchor::Start, size, GRAY);
        }
        None => page.text(subtitle, (x, 66.0), Anchor::Start, LABEL * part(subtitle, LABEL), GRAY),
    }
}

/// The text before and after the semicolon that is nearest to its middle.
fn halves(text: &str) -> Option<(&str, &str)> {
    let middle = text.len() / 2;
    let (place, _) = text.match_indices("; ").min_by_key(|(place, _)| place.abs_diff(middle))?;
    Some((text[..place].trim_end(), &text[place + 2..]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_title_stays_on_the_page() {
        let mut page = Page::new(300, 100);
        heading(&mut page, 40.0, &"wide ".repeat(40), "short");
        let ends: Vec<_> =
            page.texts().map(|text| text.at.0 + letters::width(&text.text, text.size)).collect();
        assert!(ends.iter().all(|end| *end < 300.0), "{ends:?}");
        assert_eq!(page.texts().nth(1).map(|text| text.size), Some(LABEL));
    }

    #[test]
    fn a_long_subtitle_is_broken_at_a_semicolon() {
        let mut page = Page::new(300, 100);
        heading(&mut page, 40.0, "title", "what is plotted here ; and where its peak is; more");
        let texts: Vec<_> = page.texts().map(|text| text.text.as_str()).collect();
        assert_eq!(texts, ["title", "what is plotted here", "and where its peak is; more"]);
    }
}
