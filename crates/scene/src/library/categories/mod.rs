//! A file for each category of materials.

mod cloth;
mod films;
mod glass;
mod metals;
mod minerals;
mod ngan;
mod opengl;
mod paints;
mod paper;
mod plants;
mod plastics;
mod ward;
mod wood;

use crate::library::MaterialInfo;

/// All materials, by categories.
pub(super) fn infos() -> Vec<MaterialInfo> {
    let parts = [
        metals::infos(),
        films::infos(),
        paints::infos(),
        plastics::infos(),
        cloth::infos(),
        paper::infos(),
        plants::infos(),
        wood::infos(),
        minerals::infos(),
        glass::infos(),
        ward::infos(),
        ngan::infos(),
        opengl::infos(),
    ];
    parts.into_iter().flatten().collect()
}
