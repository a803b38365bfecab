//! Table 1 of G. J. Ward, "Measuring and modeling anisotropic reflection", SIGGRAPH 1992.
//!
//! The paper's lobes with the paper's figures: `ward` times ρs beside Lambert's times ρd. The table holds no colours:
//! everything is grey.

use crate::library::{Category, MaterialInfo};

/// A row: name, title, ρd, ρs, αx, αy.
type Row = (&'static str, &'static str, [f64; 4]);

const TABLE: [Row; 10] = [
    ("ward-rolled-brass", "rolled brass", [0.10, 0.33, 0.050, 0.16]),
    ("ward-rolled-aluminium", "rolled aluminium", [0.1, 0.21, 0.04, 0.09]),
    ("ward-brushed-aluminium", "lightly brushed aluminium", [0.15, 0.19, 0.088, 0.13]),
    ("ward-varnished-plywood", "varnished plywood", [0.33, 0.025, 0.04, 0.11]),
    ("ward-enamelled-metal", "enamel finished metal", [0.25, 0.047, 0.080, 0.096]),
    ("ward-painted-cardboard", "painted cardboard box", [0.19, 0.043, 0.076, 0.085]),
    ("ward-ceramic-tile", "white ceramic tile", [0.70, 0.050, 0.071, 0.071]),
    ("ward-glossy-paper", "glossy grey paper", [0.29, 0.083, 0.082, 0.082]),
    ("ward-computer-plastic", "ivory computer plastic", [0.45, 0.043, 0.13, 0.13]),
    ("ward-plastic-laminate", "plastic laminate", [0.67, 0.070, 0.092, 0.092]),
];

pub(super) fn infos() -> Vec<MaterialInfo> {
    TABLE.iter().map(info).collect()
}

fn info((name, title, [diffuse, specular, alpha_x, alpha_y]): &Row) -> MaterialInfo {
    MaterialInfo {
        name: (*name).to_owned(),
        title: (*title).to_owned(),
        category: Category::Ward1992,
        source: "G. J. Ward, Measuring and Modeling Anisotropic Reflection, SIGGRAPH 1992, table 1; it has no colours"
            .to_owned(),
        toml: format!(
            "lobes = [\n  {{ shape = \"lambert\", tint = {diffuse} }},\n  \
             {{ shape = \"ward\", alpha = {alpha_x}, alpha_y = {alpha_y}, tint = {specular} }},\n]\n"
        ),
    }
}
