//! The heading of a page.

use crate::page::style::{GRAY, INK, LABEL, TITLE};
use crate::page::{Anchor, Page, letters};

/// The space to the right of the heading, in points.
const MARGIN: f64 = 12.0;

/// Writes the title, and what there is to say more, in smaller letters where the page is narrow.
pub(crate) fn heading(page: &mut Page, x: f64, title: &str, subtitle: &str) {
    let space = f64::from(page.width) - x - MARGIN;
    let fitting = |text: &str, size: f64| size * (space / letters::width(text, size).max(1.0)).min(1.0);
    page.text(title, (x, 40.0), Anchor::Start, fitting(title, TITLE), INK);
    page.text(subtitle, (x, 66.0), Anchor::Start, fitting(subtitle, LABEL), GRAY);
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
}
