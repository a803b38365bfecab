//! Bare metals: Fresnel's law of their measured η and k, polished, satin and brushed.

use glanz_color::{IorInfo, IorKind, iors};

use crate::library::{Category, MaterialInfo};

/// A finish of a metal.
struct Finish {
    /// What follows the metal's name; nothing where it is polished.
    suffix: &'static str,
    /// In words.
    title: &'static str,
    /// The parameters of the shape `ggx`.
    widths: &'static str,
}

/// The widths are chosen. A brush leaves scratches along the tangent: slopes are wide across them.
const FINISHES: [Finish; 3] = [
    Finish { suffix: "", title: "polished", widths: "alpha = 0.02" },
    Finish { suffix: "-satin", title: "satin finish", widths: "alpha = 0.2" },
    Finish { suffix: "-brushed", title: "brushed", widths: "alpha = 0.06, alpha_y = 0.3" },
];

pub(super) fn infos() -> Vec<MaterialInfo> {
    let metals = iors().iter().filter(|info| info.kind == IorKind::Metal);
    metals.flat_map(|metal| FINISHES.iter().map(move |finish| info(metal, finish))).collect()
}

fn info(metal: &IorInfo, finish: &Finish) -> MaterialInfo {
    // An alloy's title is what it is made of.
    let word = if metal.name.len() > 2 { metal.name } else { metal.title };
    MaterialInfo {
        name: format!("{word}{}", finish.suffix),
        title: format!("{word}, {}", finish.title),
        category: Category::Metal,
        source: format!("η and k: {}; the width of the lobe is chosen", metal.source),
        toml: format!(
            "lobes = [{{ shape = \"ggx\", {}, tint = {{ ior = \"{}\" }} }}]\n",
            finish.widths, metal.name
        ),
    }
}
