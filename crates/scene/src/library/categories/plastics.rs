//! Plastics, which scatter light below a smooth boundary, and rubber, whose boundary is rough.

use crate::library::entry::{self, CHOSEN, Entry};
use crate::library::{Category, MaterialInfo};

const ENTRIES: &[Entry] = &[
    Entry {
        name: "plastic-white",
        title: "shiny plastic, white",
        source: CHOSEN,
        toml: r#"
lobes = [{ shape = "lambert", tint = 0.78, textured = false }]
coat = { ior = 1.49, alpha = 0.06 }"#,
    },
    Entry {
        name: "plastic-red",
        title: "shiny plastic, red",
        source: CHOSEN,
        toml: r#"
lobes = [{ shape = "lambert", tint = [0.55, 0.02, 0.015], textured = false }]
coat = { ior = 1.49, alpha = 0.06 }"#,
    },
    Entry {
        name: "plastic-matt-blue",
        title: "dull plastic, blue",
        source: CHOSEN,
        toml: r#"
lobes = [{ shape = "lambert", tint = [0.04, 0.12, 0.45], textured = false }]
coat = { ior = 1.49, alpha = 0.3 }"#,
    },
    Entry {
        name: "rubber-black",
        title: "rubber, black",
        source: "index 1.52 of natural rubber; all else is chosen",
        toml: r#"
lobes = [{ shape = "oren-nayar", sigma_deg = 25, rho = 0.03, tint = 0.03, textured = false }]
coat = { ior = 1.52, alpha = 0.5 }"#,
    },
    Entry {
        name: "rubber-red",
        title: "rubber, red",
        source: "index 1.52 of natural rubber; all else is chosen",
        toml: r#"
lobes = [{ shape = "oren-nayar", sigma_deg = 25, rho = 0.15, tint = [0.4, 0.05, 0.04], textured = false }]
coat = { ior = 1.52, alpha = 0.5 }"#,
    },
];

pub(super) fn infos() -> Vec<MaterialInfo> {
    entry::infos(Category::Plastic, ENTRIES)
}
