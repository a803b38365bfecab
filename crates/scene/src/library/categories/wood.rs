//! Timber, raw and under varnish. Colours are those of plain wood: the figure is a texture's.

use crate::library::entry::{self, CHOSEN, Entry};
use crate::library::{Category, MaterialInfo};

const ENTRIES: &[Entry] = &[
    Entry {
        name: "wood-raw",
        title: "pine, planed",
        source: CHOSEN,
        toml: r#"lobes = [{ shape = "oren-nayar", sigma_deg = 20, rho = 0.45, tint = [0.62, 0.43, 0.25] }]"#,
    },
    Entry {
        name: "wood-varnished",
        title: "oak under a yellowish varnish",
        source: CHOSEN,
        toml: r#"
lobes = [
  { shape = "lambert", tint = [0.4, 0.24, 0.12], textured = false },
  { shape = "ggx", alpha = 0.2, alpha_y = 0.6, tint = [0.06, 0.045, 0.03] },
]
coat = { ior = 1.52, alpha = 0.04, thickness_mm = 0.1, transmittance_1mm = [0.6, 0.35, 0.1] }"#,
    },
    Entry {
        name: "wood-ebony",
        title: "ebony, polished",
        source: CHOSEN,
        toml: r#"
lobes = [{ shape = "lambert", tint = [0.022, 0.016, 0.013], textured = false }]
coat = { ior = 1.5, alpha = 0.1 }"#,
    },
];

pub(super) fn infos() -> Vec<MaterialInfo> {
    entry::infos(Category::Wood, ENTRIES)
}
