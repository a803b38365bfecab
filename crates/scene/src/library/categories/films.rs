//! Films as thin as a wavelength: soap, oil on water, the oxide of anodised titanium.
//!
//! Thicknesses are chosen for their colours. The oxide's index is a round value for amorphous TiO2 in visible light.

use crate::library::entry::{self, Entry};
use crate::library::{Category, MaterialInfo};

const SOAP: &str = "interference of a clear film of index 1.33 in air; the thickness is chosen";
const OIL: &str =
    "interference of a film of index 1.47 on water (Daimon and Masumura 2007); the thickness is chosen";
const ANODISED: &str = "interference of an oxide of index 2.4 (chosen, near that of amorphous TiO2) on titanium \
                        (Johnson and Christy 1974); thickness and width are chosen";

const ENTRIES: &[Entry] = &[
    Entry {
        name: "soap-film",
        title: "soap film, 300 nm",
        source: SOAP,
        toml: r#"
lobes = [{ shape = "mirror", tint = { film_nm = 300, film_ior = 1.33 } }]
transmittance = { film_nm = 300, film_ior = 1.33 }"#,
    },
    Entry {
        name: "soap-film-thick",
        title: "soap film, 650 nm",
        source: SOAP,
        toml: r#"
lobes = [{ shape = "mirror", tint = { film_nm = 650, film_ior = 1.33 } }]
transmittance = { film_nm = 650, film_ior = 1.33 }"#,
    },
    Entry {
        name: "oil-on-water",
        title: "film of oil on water, 400 nm",
        source: OIL,
        toml: r#"lobes = [{ shape = "mirror", tint = { film_nm = 400, film_ior = 1.47, ior = "water" } }]"#,
    },
    Entry {
        name: "titanium-gold",
        title: "anodised titanium, 30 nm of oxide",
        source: ANODISED,
        toml: r#"
lobes = [{ shape = "ggx", alpha = 0.12, tint = { film_nm = 30, film_ior = 2.4, ior = "Ti" } }]"#,
    },
    Entry {
        name: "titanium-blue",
        title: "anodised titanium, 55 nm of oxide",
        source: ANODISED,
        toml: r#"
lobes = [{ shape = "ggx", alpha = 0.12, tint = { film_nm = 55, film_ior = 2.4, ior = "Ti" } }]"#,
    },
    Entry {
        name: "titanium-violet",
        title: "anodised titanium, 140 nm of oxide",
        source: ANODISED,
        toml: r#"
lobes = [{ shape = "ggx", alpha = 0.12, tint = { film_nm = 140, film_ior = 2.4, ior = "Ti" } }]"#,
    },
];

pub(super) fn infos() -> Vec<MaterialInfo> {
    entry::infos(Category::Film, ENTRIES)
}
