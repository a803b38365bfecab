//! What a law says of a lobe.

use core::fmt;

use glanz_math::Vec3;

use super::grid::Place;
use crate::ModelInfo;

/// A law that lobes are judged by. A model may be exempt from a law, with a reason
/// ([`ModelInfo::exempt`](crate::ModelInfo::exempt)).
///
/// ```
/// use glanz_bsdf::Shape;
/// use glanz_bsdf::laws::{Law, judge};
///
/// // Below the exponent 1 Phong's highlight reflects more than arrives: 2/(n+1) along the normal.
/// let finding = judge(Law::Energy, &Shape::named("phong", &[("shininess", 0.5)])?);
/// assert!(finding.is_broken());
/// assert!((finding.value.expect("it was measured") - 4.0 / 3.0).abs() < 1e-3);
/// # Ok::<(), glanz_bsdf::ParamError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Law {
    /// f(wo, wi) = f(wi, wo).
    Reciprocity,
    /// No more light leaves than arrives, for any view direction.
    Energy,
    /// f_cos is not negative.
    Positivity,
    /// f_cos is 0 for light on the other side of the surface than the model's.
    Side,
    /// f_cos is finite for all directions.
    Grazing,
    /// The microfacets cover the surface: ∫ D cosθ dω = 1.
    Normalization,
    /// What the lobe becomes at the ends of its parameters.
    Limits,
    /// `f32` gives what `f64` gives.
    Precision,
    /// Vectors of 16 lanes give the bits of scalar `f32`.
    Lanes,
}

impl Law {
    /// All laws, in the order of a certificate.
    pub const ALL: [Self; 9] = [
        Self::Reciprocity,
        Self::Energy,
        Self::Positivity,
        Self::Side,
        Self::Grazing,
        Self::Normalization,
        Self::Limits,
        Self::Precision,
        Self::Lanes,
    ];

    /// Its name in certificates.
    pub fn name(self) -> &'static str {
        match self {
            Self::Reciprocity => "reciprocity",
            Self::Energy => "energy",
            Self::Positivity => "positivity",
            Self::Side => "side",
            Self::Grazing => "grazing",
            Self::Normalization => "normalization",
            Self::Limits => "limits",
            Self::Precision => "precision",
            Self::Lanes => "lanes",
        }
    }
}

/// How a judgement ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The law holds.
    Holds,
    /// The law is broken.
    Broken {
        /// The reason that the model gives for its exemption, if it has one.
        known: Option<&'static str>,
    },
    /// The law says nothing about such a lobe, for this reason.
    NotApplicable(&'static str),
}

impl Verdict {
    /// In a word, for tables.
    pub fn word(self) -> &'static str {
        match self {
            Self::Holds => "holds",
            Self::Broken { known: None } => "FAILS",
            Self::Broken { known: Some(_) } => "FAILS, known",
            Self::NotApplicable(_) => "-",
        }
    }
}

/// What one law says of a lobe.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// The law.
    pub law: Law,
    /// How the judgement ended.
    pub verdict: Verdict,
    /// The number that was judged, in the worst case found; none where the law does not apply.
    pub value: Option<f64>,
    /// What was found and where, for people; empty where the law does not apply.
    pub detail: String,
    /// The view direction of the worst case, in the local frame, if it has one.
    pub wo: Option<Vec3<f64>>,
    /// Its light direction. Energy has none: it is about light from everywhere.
    pub wi: Option<Vec3<f64>>,
}

impl Finding {
    /// A finding of something measured.
    pub(super) fn judged(law: Law, info: &ModelInfo, holds: bool, value: f64, detail: String) -> Self {
        let exemption = info.exempt.iter().find(|(exempt, _)| *exempt == law);
        let verdict = match holds {
            true => Verdict::Holds,
            false => Verdict::Broken { known: exemption.map(|(_, reason)| *reason) },
        };
        Self { law, verdict, value: Some(value), detail, wo: None, wi: None }
    }

    /// The same, found there.
    pub(super) fn at(self, place: Option<Place>) -> Self {
        Self { wo: place.map(|place| place.wo), wi: place.map(|place| place.wi), ..self }
    }

    /// A finding that there is nothing to measure.
    pub(super) fn not_applicable(law: Law, reason: &'static str) -> Self {
        let verdict = Verdict::NotApplicable(reason);
        Self { law, verdict, value: None, detail: String::new(), wo: None, wi: None }
    }

    /// Whether the law is broken, known or not.
    pub fn is_broken(&self) -> bool {
        matches!(self.verdict, Verdict::Broken { .. })
    }
}

/// One row of a table, two where the model is known to break the law.
impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = match self.verdict {
            Verdict::NotApplicable(reason) => reason,
            _ => self.detail.as_str(),
        };
        write!(f, "{:<13}  {:<12}  {text}", self.law.name(), self.verdict.word())?;
        if let Verdict::Broken { known: Some(reason) } = self.verdict {
            write!(f, "\n{:<13}  {:<12}  {reason}", "", "")?;
        }
        Ok(())
    }
}

/// What all laws say of a lobe.
#[derive(Clone, Debug, PartialEq)]
pub struct Certificate {
    /// The model's name.
    pub model: &'static str,
    /// The parameters it was judged with.
    pub params: Vec<(&'static str, f64)>,
    /// One finding per law, in the order of [`Law::ALL`].
    pub findings: Vec<Finding>,
}

impl Certificate {
    /// Whether no law is broken, not even one that the model is known to break.
    pub fn is_healthy(&self) -> bool {
        !self.findings.iter().any(Finding::is_broken)
    }

    /// What a law says.
    pub fn finding(&self, law: Law) -> &Finding {
        self.findings.iter().find(|finding| finding.law == law).expect("a certificate holds every law")
    }
}

/// The table of findings, a line per row without an end of line after the last. The alternate form (`{:#}`) starts
/// with a line of the model's name and parameters.
impl fmt::Display for Certificate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut rows: Vec<String> = Vec::new();
        if f.alternate() {
            let params: String = self.params.iter().map(|(name, value)| format!(" {name}={value}")).collect();
            rows.push(format!("{}{params}", self.model));
        }
        for finding in &self.findings {
            rows.extend(finding.to_string().lines().map(|line| format!("  {line}")));
        }
        f.write_str(&rows.join("\n"))
    }
}
