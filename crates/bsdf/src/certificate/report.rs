//! What a certificate says.

use crate::{Law, ModelInfo};

/// A law that is looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Check {
    /// Both ways are the same.
    Reciprocity,
    /// No more light leaves than arrives.
    Energy,
    /// No light is negative, and none comes through from the wrong side.
    Positivity,
    /// All values are finite, up to 89.999° from the normal.
    Grazing,
    /// The facets cover the surface: ∫ D cosθ dω = 1.
    Normalization,
    /// What becomes of it at the ends of its parameters.
    Limits,
    /// `f32` gives what `f64` gives.
    Precision,
}

impl Check {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Reciprocity => "reciprocity",
            Self::Energy => "energy",
            Self::Positivity => "positivity",
            Self::Grazing => "grazing",
            Self::Normalization => "normalization",
            Self::Limits => "limits",
            Self::Precision => "precision",
        }
    }

    /// The law by which a model may be exempt from it.
    fn law(self) -> Option<Law> {
        match self {
            Self::Reciprocity => Some(Law::Reciprocity),
            Self::Energy => Some(Law::Energy),
            _ => None,
        }
    }
}

/// How a check ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The law holds.
    Holds,
    /// The law is broken.
    Broken {
        /// The reason that the model gives, if it knows of it.
        known: Option<&'static str>,
    },
    /// The law says nothing of such a shape, for this reason.
    NotApplicable(&'static str),
}

/// The outcome of one check.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// What was looked at.
    pub check: Check,
    /// How it ended.
    pub verdict: Verdict,
    /// The number that was judged, at its worst; none where nothing was measured.
    pub value: Option<f64>,
    /// What was found and where, for people; may be empty.
    pub detail: String,
}

impl Finding {
    /// A finding of something measured.
    pub(super) fn judged(check: Check, info: &ModelInfo, holds: bool, value: f64, detail: String) -> Self {
        let excuse = |law: Law| info.exempt.iter().find(|(exempt, _)| *exempt == law).map(|(_, why)| *why);
        let verdict = match holds {
            true => Verdict::Holds,
            false => Verdict::Broken { known: check.law().and_then(excuse) },
        };
        Self { check, verdict, value: Some(value), detail }
    }

    /// A finding that there is nothing to measure.
    pub(super) fn not_applicable(check: Check, reason: &'static str) -> Self {
        Self { check, verdict: Verdict::NotApplicable(reason), value: None, detail: String::new() }
    }

    /// Whether the law is broken, known or not.
    pub fn is_broken(&self) -> bool {
        matches!(self.verdict, Verdict::Broken { .. })
    }
}

/// The health certificate of a shape.
#[derive(Clone, Debug, PartialEq)]
pub struct Certificate {
    /// The model's name.
    pub model: &'static str,
    /// The parameters it was looked at with.
    pub params: Vec<(&'static str, f64)>,
    /// The outcomes, one per check.
    pub findings: Vec<Finding>,
}

impl Certificate {
    /// Whether no law is broken, not even one that is known to be.
    pub fn is_healthy(&self) -> bool {
        !self.findings.iter().any(Finding::is_broken)
    }

    /// The outcome of a check.
    pub fn finding(&self, check: Check) -> &Finding {
        self.findings.iter().find(|finding| finding.check == check).expect("a certificate holds every check")
    }
}
