//! Paints: those of cars are pigment and flakes of metal under a clear coat.

use crate::library::entry::{self, CHOSEN, Entry};
use crate::library::{Category, MaterialInfo};

const ENTRIES: &[Entry] = &[
    Entry {
        name: "car-paint-red",
        title: "car paint, metallic red",
        source: CHOSEN,
        toml: r#"
lobes = [
  { shape = "lambert", tint = [0.22, 0.006, 0.008], textured = false },
  { shape = "ggx", alpha = 0.35, tint = [0.45, 0.03, 0.025] },
]
coat = { ior = 1.5, alpha = 0.02 }"#,
    },
    Entry {
        name: "car-paint-blue",
        title: "car paint, metallic blue",
        source: CHOSEN,
        toml: r#"
lobes = [
  { shape = "lambert", tint = [0.008, 0.03, 0.16], textured = false },
  { shape = "ggx", alpha = 0.35, tint = [0.05, 0.14, 0.45] },
]
coat = { ior = 1.5, alpha = 0.02 }"#,
    },
    Entry {
        name: "car-paint-silver",
        title: "car paint, flakes of aluminium",
        source: "flakes by the η and k of aluminium (Rakić 1995); all else is chosen",
        toml: r#"
lobes = [
  { shape = "lambert", tint = 0.12, textured = false },
  { shape = "ggx", alpha = 0.4, weight = 0.6, tint = { ior = "Al" } },
]
coat = { ior = 1.5, alpha = 0.02 }"#,
    },
    Entry {
        name: "car-paint-black",
        title: "car paint, plain black",
        source: CHOSEN,
        toml: r#"
lobes = [{ shape = "lambert", tint = 0.012, textured = false }]
coat = { ior = 1.5, alpha = 0.02 }"#,
    },
    Entry {
        name: "gloss-paint-green",
        title: "gloss paint, green",
        source: CHOSEN,
        toml: r#"
lobes = [{ shape = "lambert", tint = [0.03, 0.22, 0.09], textured = false }]
coat = { ior = 1.5, alpha = 0.08 }"#,
    },
    Entry {
        name: "wall-paint-white",
        title: "emulsion paint on a wall, white",
        source: CHOSEN,
        toml: r#"lobes = [{ shape = "eon", roughness = 0.6, tint = 0.82 }]"#,
    },
    Entry {
        name: "highlighter-yellow",
        title: "highlighter, which glows",
        source: "a model of a fluorescent dye: see 'highlighter-yellow' among the fluorescent materials",
        toml: r#"lobes = [{ shape = "lambert", tint = { reradiation = "highlighter-yellow" } }]"#,
    },
];

pub(super) fn infos() -> Vec<MaterialInfo> {
    entry::infos(Category::Paint, ENTRIES)
}
