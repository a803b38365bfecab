//! Leaves: light is scattered back and through, under a waxy skin.

use crate::library::entry::{self, CHOSEN, Entry};
use crate::library::{Category, MaterialInfo};

const ENTRIES: &[Entry] = &[
    Entry {
        name: "leaf-green",
        title: "leaf, green",
        source: "reflection: CIE 13.3-1995, test colour sample 14 (leaf green); what passes, and the skin, are chosen",
        toml: r#"
lobes = [
  { shape = "lambert", tint = { spectrum = "tcs14" } },
  { shape = "lambert-transmission", tint = [0.16, 0.26, 0.02] },
  { shape = "ggx", alpha = 0.25, tint = { ior = 1.45 } },
]"#,
    },
    Entry {
        name: "leaf-autumn",
        title: "leaf, in autumn",
        source: CHOSEN,
        toml: r#"
lobes = [
  { shape = "lambert", tint = [0.4, 0.14, 0.02] },
  { shape = "lambert-transmission", tint = [0.42, 0.16, 0.01] },
  { shape = "ggx", alpha = 0.35, tint = { ior = 1.45 } },
]"#,
    },
    Entry {
        name: "petal-white",
        title: "petal, white",
        source: CHOSEN,
        toml: r#"
lobes = [
  { shape = "lambert", tint = [0.62, 0.6, 0.56] },
  { shape = "lambert-transmission", tint = [0.3, 0.28, 0.24] },
]"#,
    },
];

pub(super) fn infos() -> Vec<MaterialInfo> {
    entry::infos(Category::Plant, ENTRIES)
}
