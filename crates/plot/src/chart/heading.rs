//! The heading of a page.

use crate::page::style::{GRAY, INK, LABEL, TITLE};
use crate::page::{Anchor, Page};

/// Writes the title, and what there is to say more.
pub(crate) fn heading(page: &mut Page, x: f64, title: &str, subtitle: &str) {
    page.text(title, (x, 40.0), Anchor::Start, TITLE, INK);
    page.text(subtitle, (x, 66.0), Anchor::Start, LABEL, GRAY);
}
