//! What is right but probably not meant.

use crate::intake::{Front, Sources};
use crate::{Place, Stage};

/// Something that courses get wrong.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Warning {
    /// Where.
    pub place: Option<Place>,
    /// What, and why it matters.
    pub message: String,
}

pub(crate) fn warnings(front: &Front, _stage: Stage, sources: &Sources) -> Vec<Warning> {
    let given = front.given.remarks.iter().map(|(message, origin)| (message.clone(), Some(*origin)));
    let mut all: Vec<Warning> = given
        .map(|(message, origin)| Warning { place: origin.map(|origin| sources.place(origin)), message })
        .collect();
    all.sort_by(|a, b| (&a.place, &a.message).cmp(&(&b.place, &b.message)));
    all.dedup();
    all
}
