//! Glass and other clear media: panes, which transmit the scene, and solids, which refract the environment.

use crate::library::entry::{self, Entry};
use crate::library::{Category, MaterialInfo};

const ENTRIES: &[Entry] = &[
    Entry {
        name: "glass-pane",
        title: "pane of crown glass, 4 mm",
        source: "index of N-BK7 (Schott 2017); the thickness is chosen",
        toml: r#"pane = { ior = "BK7", thickness_mm = 4 }"#,
    },
    Entry {
        name: "glass-bottle",
        title: "pane of green bottle glass, 4 mm",
        source: "index 1.52 of soda-lime glass; what passes is chosen",
        toml: r#"pane = { ior = 1.52, thickness_mm = 4, transmittance_1mm = [0.8, 0.94, 0.83] }"#,
    },
    Entry {
        name: "glass-smoked",
        title: "pane of smoked glass, 6 mm",
        source: "index 1.52 of soda-lime glass; what passes is chosen",
        toml: r#"pane = { ior = 1.52, thickness_mm = 6, transmittance_1mm = [0.91, 0.9, 0.885] }"#,
    },
    Entry {
        name: "acrylic-pane",
        title: "pane of acrylic, 3 mm, orange",
        source: "index of PMMA (Sultanova 2009); what passes is chosen",
        toml: r#"pane = { ior = "PMMA", thickness_mm = 3, transmittance_1mm = [0.98, 0.8, 0.5] }"#,
    },
    Entry {
        name: "glass-solid",
        title: "body of crown glass, one boundary",
        source: "index of N-BK7 (Schott 2017); it shows the environment, bent by 1.52 at all \
                 wavelengths",
        toml: r#"
lobes = [
  { shape = "mirror", tint = { ior = "BK7" } },
  { shape = "refraction", eta = 1.52, tint = { ior = "BK7" } },
]"#,
    },
    Entry {
        name: "glass-frosted",
        title: "body of frosted glass, one boundary",
        source: "index 1.52 of soda-lime glass; the width is chosen",
        toml: r#"
lobes = [
  { shape = "ggx", alpha = 0.3, tint = { ior = 1.52 } },
  { shape = "ggx-transmission", alpha = 0.3, eta = 1.52, tint = { ior = 1.52 } },
]"#,
    },
    Entry {
        name: "water",
        title: "water, one boundary",
        source: "index by Daimon and Masumura 2007; bent by 1.333 at all wavelengths",
        toml: r#"
lobes = [
  { shape = "mirror", tint = { ior = "water" } },
  { shape = "refraction", eta = 1.333, tint = { ior = "water" } },
]"#,
    },
    Entry {
        name: "diamond",
        title: "diamond, one boundary",
        source: "index by Peter 1923; bent by 2.42 at all wavelengths",
        toml: r#"
lobes = [
  { shape = "mirror", tint = { ior = "diamond" } },
  { shape = "refraction", eta = 2.42, tint = { ior = "diamond" } },
]"#,
    },
    Entry {
        name: "mirror",
        title: "perfectly smooth silver",
        source: "η and k: P. B. Johnson and R. W. Christy, Phys. Rev. B 6, 4370 (1972)",
        toml: r#"lobes = [{ shape = "mirror", tint = { ior = "Ag" } }]"#,
    },
];

pub(super) fn infos() -> Vec<MaterialInfo> {
    entry::infos(Category::Glass, ENTRIES)
}
