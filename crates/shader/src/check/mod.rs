//! What is right but probably not meant.

mod stages;
mod values;

use crate::intake::{Front, Sources};
use crate::{Place, Stage};

pub use stages::check_stages;

/// Something that courses get wrong.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Warning {
    /// Where.
    pub place: Option<Place>,
    /// What, and why it matters.
    pub message: String,
}

/// The warnings of a text, in its order.
pub(crate) fn warnings(front: &Front, stage: Stage, sources: &Sources) -> Vec<Warning> {
    let mut found = front.given.remarks.clone();
    found.extend(values::outputs_never_written(front));
    if stage == Stage::Fragment {
        found.extend(values::raw_normals(front));
    }
    let mut all: Vec<Warning> = found
        .into_iter()
        .map(|(message, origin)| Warning { place: Some(sources.place(origin)), message })
        .collect();
    all.sort_by(|a, b| (&a.place, &a.message).cmp(&(&b.place, &b.message)));
    all.dedup();
    all
}
