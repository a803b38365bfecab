//! Plaster, clay, stone; and glazes, which are coloured coats.

use crate::library::entry::{self, CHOSEN, Entry};
use crate::library::{Category, MaterialInfo};

const ENTRIES: &[Entry] = &[
    Entry {
        name: "plaster",
        title: "plaster, white",
        source: CHOSEN,
        toml: r#"lobes = [{ shape = "oren-nayar", sigma_deg = 30, rho = 0.85, tint = 0.85 }]"#,
    },
    Entry {
        name: "terracotta",
        title: "fired clay, without glaze",
        source: CHOSEN,
        toml: r#"lobes = [{ shape = "oren-nayar", sigma_deg = 30, rho = 0.3, tint = [0.5, 0.2, 0.1] }]"#,
    },
    Entry {
        name: "glaze-white",
        title: "white clay under a clear glaze",
        source: CHOSEN,
        toml: r#"
lobes = [{ shape = "lambert", tint = 0.85, textured = false }]
coat = { ior = 1.55, alpha = 0.02, thickness_mm = 0.3 }"#,
    },
    Entry {
        name: "glaze-celadon",
        title: "clay under a green glaze",
        source: CHOSEN,
        toml: r#"
lobes = [{ shape = "lambert", tint = 0.75, textured = false }]
coat = { ior = 1.55, alpha = 0.04, thickness_mm = 0.5, transmittance_1mm = [0.5, 0.72, 0.6] }"#,
    },
    Entry {
        name: "glaze-cobalt",
        title: "clay under a blue glaze",
        source: CHOSEN,
        toml: r#"
lobes = [{ shape = "lambert", tint = 0.75, textured = false }]
coat = { ior = 1.55, alpha = 0.03, thickness_mm = 0.5, transmittance_1mm = [0.02, 0.06, 0.5] }"#,
    },
    Entry {
        name: "moon-dust",
        title: "dust that is nearly as bright at the edge as in the middle",
        source: CHOSEN,
        toml: r#"lobes = [{ shape = "minnaert", k = 0.7, tint = [0.16, 0.15, 0.135] }]"#,
    },
    Entry {
        name: "slate",
        title: "slate, split",
        source: CHOSEN,
        toml: r#"
lobes = [
  { shape = "oren-nayar", sigma_deg = 15, rho = 0.08, tint = [0.07, 0.08, 0.09] },
  { shape = "ggx", alpha = 0.4, tint = { ior = 1.55 } },
]"#,
    },
];

pub(super) fn infos() -> Vec<MaterialInfo> {
    entry::infos(Category::Mineral, ENTRIES)
}
