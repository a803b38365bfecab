//! Paper, and what light passes of it.

use crate::library::entry::{self, CHOSEN, Entry};
use crate::library::{Category, MaterialInfo};

const ENTRIES: &[Entry] = &[
    Entry {
        name: "paper-white",
        title: "writing paper, white",
        source: CHOSEN,
        toml: r#"
lobes = [
  { shape = "eon", roughness = 0.5, tint = 0.8 },
  { shape = "lambert-transmission", tint = 0.08 },
]"#,
    },
    Entry {
        name: "newsprint",
        title: "newsprint",
        source: CHOSEN,
        toml: r#"
lobes = [
  { shape = "eon", roughness = 0.7, tint = [0.6, 0.56, 0.48] },
  { shape = "lambert-transmission", tint = [0.14, 0.12, 0.08] },
]"#,
    },
    Entry {
        name: "paper-glossy",
        title: "coated paper, white",
        source: CHOSEN,
        toml: r#"
lobes = [{ shape = "lambert", tint = 0.85, textured = false }]
coat = { ior = 1.5, alpha = 0.12 }"#,
    },
    Entry {
        name: "tracing-paper",
        title: "tracing paper: light passes, and is scattered",
        source: CHOSEN,
        toml: r#"
lobes = [
  { shape = "lambert", tint = 0.32 },
  { shape = "lambert-transmission", tint = 0.5 },
  { shape = "ggx", alpha = 0.35, tint = { ior = 1.5 } },
]"#,
    },
    Entry {
        name: "kraft-card",
        title: "brown card",
        source: CHOSEN,
        toml: r#"lobes = [{ shape = "oren-nayar", sigma_deg = 20, rho = 0.3, tint = [0.42, 0.27, 0.15] }]"#,
    },
    Entry {
        name: "lampshade",
        title: "lampshade of parchment",
        source: CHOSEN,
        toml: r#"
lobes = [
  { shape = "lambert", tint = [0.5, 0.42, 0.3] },
  { shape = "lambert-transmission", tint = [0.4, 0.3, 0.16] },
]"#,
    },
];

pub(super) fn infos() -> Vec<MaterialInfo> {
    entry::infos(Category::Paper, ENTRIES)
}
