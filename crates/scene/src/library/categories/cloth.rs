//! Cloth: a sheen of fibres that stand up, over a matte ground.

use crate::library::entry::{self, CHOSEN, Entry};
use crate::library::{Category, MaterialInfo};

const ENTRIES: &[Entry] = &[
    Entry {
        name: "cotton-white",
        title: "cotton, white",
        source: CHOSEN,
        toml: r#"
lobes = [
  { shape = "eon", roughness = 0.8, tint = 0.72 },
  { shape = "charlie", alpha = 0.6, tint = 0.08 },
]"#,
    },
    Entry {
        name: "denim",
        title: "denim, indigo",
        source: CHOSEN,
        toml: r#"
lobes = [
  { shape = "oren-nayar", sigma_deg = 35, rho = 0.08, tint = [0.035, 0.06, 0.16] },
  { shape = "charlie", alpha = 0.7, tint = [0.06, 0.07, 0.1] },
]"#,
    },
    Entry {
        name: "velvet-red",
        title: "velvet, red",
        source: CHOSEN,
        toml: r#"
lobes = [
  { shape = "eon", roughness = 1, tint = [0.09, 0.004, 0.008] },
  { shape = "charlie", alpha = 0.25, tint = [0.85, 0.12, 0.15] },
]"#,
    },
    Entry {
        name: "velvet-black",
        title: "velvet, black",
        source: CHOSEN,
        toml: r#"
lobes = [
  { shape = "eon", roughness = 1, tint = 0.006 },
  { shape = "charlie", alpha = 0.25, tint = 0.25 },
]"#,
    },
    Entry {
        name: "felt-green",
        title: "felt, green",
        source: CHOSEN,
        toml: r#"
lobes = [
  { shape = "oren-nayar", sigma_deg = 40, rho = 0.1, tint = [0.03, 0.16, 0.06] },
  { shape = "charlie", alpha = 0.8, tint = [0.05, 0.12, 0.06] },
]"#,
    },
    Entry {
        name: "satin-blue",
        title: "satin, blue: threads that shine across",
        source: CHOSEN,
        toml: r#"
lobes = [
  { shape = "lambert", tint = [0.02, 0.05, 0.2] },
  { shape = "ggx", alpha = 0.15, alpha_y = 0.5, tint = [0.1, 0.16, 0.4] },
]"#,
    },
];

pub(super) fn infos() -> Vec<MaterialInfo> {
    entry::infos(Category::Cloth, ENTRIES)
}
