//! What is told of eyes and their pictures.

use glanz_eye::Viewer;
use schemars::JsonSchema;
use serde::Serialize;

use super::draw::Drawn;
use super::patches::Patches;

/// A scene as eyes see it.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    /// The sheet of pictures, or the film
    pub(super) file: String,
    /// In the order of the pictures
    pub(super) eyes: Vec<EyeFacts>,
    /// What is lost between objects, for each eye against the first
    pub(super) patches: Patches,
    /// What was ignored or changed of the scene's file
    pub(super) notes: Vec<String>,
}

#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct EyeFacts {
    /// What it is called on the sheet
    label: String,
    /// The eye, as --observer takes it
    observer: String,
    /// How far it is adapted to its own white
    adapted: f64,
    /// The luminance of white in cd/m², where the scene has none of its own
    #[serde(skip_serializing_if = "Option::is_none")]
    level_cd_m2: Option<f64>,
    /// What it is adapted to, its pupil, and what it resolves; none where the picture went through no stage
    #[serde(skip_serializing_if = "Option::is_none")]
    seen: Option<SeenFacts>,
    /// How far what the ways of --against show is from it
    #[serde(skip_serializing_if = "Vec::is_empty")]
    against: Vec<WayFacts>,
}

/// How far what another way shows is from what true cones show.
#[derive(Debug, Serialize, JsonSchema)]
struct WayFacts {
    /// What it is called on the sheet
    way: &'static str,
    #[serde(flatten)]
    spread: SpreadFacts,
}

/// ΔE00 over the pixels that show a surface.
#[derive(Debug, Serialize, JsonSchema)]
struct SpreadFacts {
    mean: f64,
    median: f64,
    p95: f64,
    max: f64,
}

/// What an eye made of its picture.
#[derive(Debug, Serialize, JsonSchema)]
struct SeenFacts {
    /// The photopic luminance that it is adapted to, in cd/m²
    adaptation_cd_m2: f64,
    /// The part that cones have in seeing, m of CIE 191
    cones: f64,
    /// The mesopic luminance, in cd/m²
    mesopic_cd_m2: f64,
    /// The diameter of the pupil
    pupil_mm: f64,
    /// The light on the retina, in trolands
    trolands: f64,
    /// The finest grating that is resolved, in cycles per degree
    cutoff_cpd: f64,
}

impl EyeFacts {
    pub(super) fn of(label: &str, viewer: &Viewer, drawn: &Drawn) -> Self {
        Self {
            label: label.replace('\n', ", "),
            observer: viewer.eye.to_string(),
            adapted: viewer.viewing.adapted,
            level_cd_m2: viewer.viewing.level_cd_m2,
            against: drawn
                .against
                .iter()
                .map(|(way, spread)| WayFacts {
                    way: way.title(),
                    spread: SpreadFacts {
                        mean: spread.mean,
                        median: spread.median,
                        p95: spread.p95,
                        max: spread.max,
                    },
                })
                .collect(),
            seen: drawn.seen.map(|seen| SeenFacts {
                adaptation_cd_m2: seen.adaptation_cd_m2,
                cones: seen.cones,
                mesopic_cd_m2: seen.mesopic_cd_m2,
                pupil_mm: seen.pupil_mm,
                trolands: seen.trolands,
                cutoff_cpd: seen.cutoff_cpd,
            }),
        }
    }
}
