//! Fluorescent materials that come with the library, by name.

use glanz_color::{Reradiation, paper_notes};

/// What is known about a fluorescent material.
#[derive(Clone, Debug, PartialEq)]
pub struct FluorescentInfo {
    /// The name.
    pub name: &'static str,
    /// What it is, in a few words.
    pub title: &'static str,
    /// Where its numbers come from.
    pub source: &'static str,
    /// The wavelengths in nm that were measured.
    pub range_nm: (f64, f64),
}

/// All fluorescent materials.
pub fn fluorescents() -> Vec<FluorescentInfo> {
    let info = |note: glanz_color::PaperNote| FluorescentInfo {
        name: note.name,
        title: "a paper note",
        source: "Labsphere, published by Fichet, Pacanowski, Wilkie 2021",
        range_nm: (note.first_nm, note.first_nm + note.step_nm * (note.rows.len() - 1) as f64),
    };
    paper_notes().into_iter().map(info).collect()
}

/// The re-radiation matrix of a name.
pub fn fluorescent(name: &str) -> Option<Reradiation> {
    let note = paper_notes().into_iter().find(|note| note.name == name.to_lowercase())?;
    let nm: Vec<f64> = (0..note.rows.len()).map(|i| note.first_nm + note.step_nm * i as f64).collect();
    let values: Vec<f64> = note.rows.concat();
    Reradiation::from_measured(&nm, &nm, &values, note.step_nm).ok()
}
