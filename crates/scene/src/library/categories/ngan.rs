//! Fits of Cook and Torrance's model to measurements of the MERL data base: A. Ngan, F. Durand and W. Matusik,
//! "Experimental analysis of BRDF models", Eurographics Symposium on Rendering 2005.
//!
//! Their lobe is ks · F with Schlick's F from the reflectance F0. Schlick's form in a scene file goes up to 1 at
//! grazing angles, so ks is a weight there where it is grey, and a tint where it is coloured. For chrome F lies between
//! 0.991 and 1: it is left out, which errs by 0.9 %. For PVC the weight is the greatest of the three ks, and the
//! colour is in F0: at normal incidence that is the fit, at grazing angles the reflection is grey where the fit's is
//! not.
//!
//! The factor of the lobe is taken to be that of Cook and Torrance's paper, which is ours; a fit that left out the 4 of
//! that paper's D would be four times as strong. The figures are taken to be in the units of the MERL files, whose
//! reader multiplies red, green and blue by 1, 1.15 and 1.66 (over 1500): as printed both materials would be olive,
//! times these factors the matte part of chrome is grey.

use crate::library::entry::{self, Entry};
use crate::library::{Category, MaterialInfo};

const ENTRIES: &[Entry] = &[
    Entry {
        name: "ngan-chrome",
        title: "chrome, as fitted to MERL",
        source: "A. Ngan, F. Durand, W. Matusik, Experimental Analysis of BRDF Models, EGSR 2005: \
                 kd .0116 .00995 .00796, ks .0428 .0298 .0143, F0 .991, m .00935; times 1, 1.15, 1.66 for the units of \
                 the MERL files; F is taken as 1",
        toml: r#"
lobes = [
  { shape = "lambert", tint = [0.0116, 0.0114425, 0.0132136] },
  { shape = "cook-torrance", m = 0.00935, tint = [0.0428, 0.03427, 0.023738] },
]"#,
    },
    Entry {
        name: "ngan-pvc",
        title: "PVC, as fitted to MERL",
        source: "A. Ngan, F. Durand, W. Matusik, Experimental Analysis of BRDF Models, EGSR 2005: \
                 kd .0362 .0348 .0262, ks .16 .11 .0752, F0 .0277, m .0387; times 1, 1.15, 1.66 for the units \
                 of the MERL files; F's rise to grazing angles is grey here",
        // F0 · ks / 0.16, ks = .16, .1265, .124832.
        toml: r#"
lobes = [
  { shape = "lambert", tint = [0.0362, 0.04002, 0.043492] },
  { shape = "cook-torrance", m = 0.0387, weight = 0.16, fresnel = "schlick", tint = [0.0277, 0.0219003, 0.0216115] },
]"#,
    },
];

pub(super) fn infos() -> Vec<MaterialInfo> {
    entry::infos(Category::Ngan2005, ENTRIES)
}
