//! Fluorescent materials by name.
//!
//! Two are measurements, the paper notes. The others are *models*: one band of absorption and one of
//! emission over a smooth base, made by [`Fluorophore`] with wavelengths and quantum yields as the literature
//! tells them for the substance. They look as such a material does, and obey the conservation of energy;
//! they are no measurement of any sample. How strongly they absorb, and their bases, are chosen.

use std::sync::LazyLock;

use crate::names::{UnknownName, plain};
use crate::spectra::Spectrum;
use crate::surfaces::fluorophore::Fluorophore;
use crate::surfaces::paper_notes::{PaperNote, paper_notes};
use crate::surfaces::reradiation::Reradiation;

/// What is known about a fluorescent material.
#[derive(Clone, Debug, PartialEq)]
pub struct FluorescentInfo {
    /// The name as [`fluorescent`] knows it.
    pub name: &'static str,
    /// What it is, in a few words.
    pub title: &'static str,
    /// Where its numbers come from.
    pub source: &'static str,
    /// Whether it was measured; else it is a model.
    pub measured: bool,
}

/// The re-radiation of a material; [`fluorescents`] lists the names.
///
/// # Errors
///
/// [`UnknownName`] suggests near names.
pub fn fluorescent(name: &str) -> Result<Reradiation, UnknownName> {
    let wanted = plain(name);
    if let Some(model) = MODELS.iter().find(|model| model.info.name == wanted) {
        let matrix = model.fluorophore.over(&Spectrum::from_fn(model.base));
        return Ok(matrix.expect("the parameters of all models are in range"));
    }
    if let Some(note) = paper_notes().iter().find(|note| note.name == wanted) {
        return Ok(measured(note));
    }
    let known = fluorescents().iter().map(|info| info.name);
    Err(UnknownName::not_found("fluorescent material", name.trim(), known))
}

/// All fluorescent materials by name.
pub fn fluorescents() -> &'static [FluorescentInfo] {
    static LIST: LazyLock<Vec<FluorescentInfo>> = LazyLock::new(|| {
        let notes = paper_notes().into_iter().map(|note| FluorescentInfo {
            name: note.name,
            title: "a fluorescent paper note, excited by 380 nm and more",
            source: "measured by Labsphere, published with Fichet, Pacanowski and Wilkie, JCGT 10(3), 2021",
            measured: true,
        });
        MODELS.iter().map(|model| model.info.clone()).chain(notes).collect()
    });
    &LIST
}

/// A note's figures on the grid. Nothing is known of ultraviolet on it: it is black there.
fn measured(note: &PaperNote) -> Reradiation {
    let nm: Vec<f64> = (0..note.rows.len()).map(|i| note.first_nm + note.step_nm * i as f64).collect();
    Reradiation::from_measured(&nm, &nm, &note.rows.concat(), note.step_nm)
        .expect("the notes are square and their values fractions")
}

/// A material that is made, not measured.
struct Model {
    info: FluorescentInfo,
    fluorophore: Fluorophore,
    base: fn(f64) -> f64,
}

/// Paper without brightener: near white, darker in the ultraviolet, where lignin and fillers absorb.
fn paper(nm: f64) -> f64 {
    0.62 + 0.26 * rise(nm, 395.0, 15.0)
}

/// A matt white film or card that reflects ultraviolet too.
fn white_card(nm: f64) -> f64 {
    0.70 + 0.22 * rise(nm, 380.0, 15.0)
}

/// From 0 to 1 around a wavelength, over some four widths.
fn rise(nm: f64, middle: f64, width: f64) -> f64 {
    1.0 / (1.0 + libm::exp((middle - nm) / width))
}

const MODELS: [Model; 4] = [
    Model {
        info: FluorescentInfo {
            name: "paper-brightened",
            title: "office paper with a stilbene brightener (model)",
            source: "bands of stilbene brighteners as in K. Hunger (ed.), Industrial Dyes, Wiley-VCH, 2003; \
                     absorption and base chosen",
            measured: false,
        },
        fluorophore: Fluorophore {
            absorption_nm: 365.0,
            absorption_fwhm_nm: 60.0,
            absorptance: 0.95,
            emission_nm: 437.0,
            emission_fwhm_nm: 60.0,
            quantum_yield: 0.85,
        },
        base: paper,
    },
    Model {
        info: FluorescentInfo {
            name: "highlighter-yellow",
            title: "marker ink of pyranine on white card (model)",
            source: "pyranine in its alkaline form: absorption at 454 nm, emission at 511 nm, O. S. Wolfbeis et \
                     al., Fresenius Z. Anal. Chem. 314, 1983; widths, absorption and base chosen",
            measured: false,
        },
        fluorophore: Fluorophore {
            absorption_nm: 454.0,
            absorption_fwhm_nm: 75.0,
            absorptance: 0.95,
            emission_nm: 511.0,
            emission_fwhm_nm: 50.0,
            quantum_yield: 0.85,
        },
        base: white_card,
    },
    Model {
        info: FluorescentInfo {
            name: "day-glow-orange",
            title: "pigment of rhodamines in resin on white card (model)",
            source: "yield of rhodamine 6G, 0.95, R. F. Kubin and A. N. Fletcher, J. Luminescence 27, 1982; one \
                     wide band for the several dyes of a pigment; widths, absorption and base chosen",
            measured: false,
        },
        fluorophore: Fluorophore {
            absorption_nm: 500.0,
            absorption_fwhm_nm: 150.0,
            absorptance: 0.97,
            emission_nm: 602.0,
            emission_fwhm_nm: 45.0,
            quantum_yield: 0.9,
        },
        base: white_card,
    },
    Model {
        info: FluorescentInfo {
            name: "quinine",
            title: "quinine sulphate in dilute sulphuric acid before white card (model)",
            source: "absorption at 347.5 nm, emission at 450 nm, yield 0.546, W. H. Melhuish, J. Phys. Chem. 65, \
                     1961; widths, absorption and base chosen",
            measured: false,
        },
        fluorophore: Fluorophore {
            absorption_nm: 347.5,
            absorption_fwhm_nm: 55.0,
            absorptance: 0.8,
            emission_nm: 450.0,
            emission_fwhm_nm: 90.0,
            quantum_yield: 0.546,
        },
        base: white_card,
    },
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lights::light;
    use crate::measures::difference::ciede2000;
    use crate::models::Lab;
    use crate::observers::{observer, xyz_of_light, xyz_of_reflectance};

    fn xyz(matrix: &Reradiation, light: &Spectrum) -> [f64; 3] {
        let observer = observer("cie1931").unwrap();
        xyz_of_reflectance(&matrix.total_radiance_factor(light), light, &observer)
    }

    /// CIELAB of a colour before this white.
    fn lab(xyz: [f64; 3], white: [f64; 3]) -> [f64; 3] {
        let f = |i: usize| (xyz[i] / white[i]).cbrt();
        [116.0 * f(1) - 16.0, 500.0 * (f(0) - f(1)), 200.0 * (f(1) - f(2))]
    }

    fn xy(light: &Spectrum) -> [f64; 2] {
        let [x, y, z] = xyz_of_light(light, &observer("cie1931").unwrap());
        [x / (x + y + z), y / (x + y + z)]
    }

    #[test]
    fn every_name_gives_a_material_that_glows_and_obeys_energy() {
        assert_eq!(fluorescents().len(), 6);
        for info in fluorescents() {
            let matrix = fluorescent(info.name).unwrap();
            let report = matrix.energy();
            assert!(report.ok, "{}: {report:?}", info.name);
            let glow = matrix.off_diagonal().apply(&Spectrum::ONE).max();
            assert!(glow > 0.05, "{} emits {glow} under equal energy", info.name);
        }
        let message = fluorescent("Quinin").unwrap_err().to_string();
        assert_eq!(message, "there is no fluorescent material 'Quinin'; did you mean 'quinine'?");
        assert!(fluorescent("Day_glow Orange").is_ok());
    }

    #[test]
    fn a_highlighter_is_brighter_than_the_perfect_diffuser() {
        let highlighter = fluorescent("highlighter-yellow").unwrap();
        let d65 = light("D65").unwrap();
        let y = xyz(&highlighter, &d65)[1];
        assert!(y > 1.05, "Y = {y}");
        assert!(xyz(&highlighter.without_reradiation(), &d65)[1] < 0.9);
    }

    #[test]
    fn brightened_paper_is_blue_under_black_light() {
        let paper = fluorescent("paper-brightened").unwrap();
        let [x, y] = xy(&paper.apply(&light("UV365").unwrap()));
        assert!(x < 0.2 && y < 0.15, "{x} {y}");
    }

    #[test]
    fn brightened_paper_yellows_when_ultraviolet_is_cut() {
        let paper = fluorescent("paper-brightened").unwrap();
        let d65 = light("D65").unwrap();
        let cut = Spectrum::from_fn(|nm| if nm < 380.0 { 0.0 } else { d65.at(nm) });
        let white = xyz(&Reradiation::diagonal(&Spectrum::ONE), &d65);
        let (with, without) = (lab(xyz(&paper, &d65), white), lab(xyz(&paper, &cut), white));
        assert!(without[2] - with[2] > 4.0, "b* from {} to {}", with[2], without[2]);
        let apart = ciede2000(Lab(with), Lab(without));
        assert!(apart > 3.0, "ΔE00 {apart}");
    }

    #[test]
    fn quinine_glows_blue_under_black_light_only() {
        let quinine = fluorescent("quinine").unwrap();
        let [x, y] = xy(&quinine.apply(&light("UV365").unwrap()));
        assert!(x < 0.2 && y < 0.2, "{x} {y}");
        let glow = xyz(&quinine, &light("A").unwrap())[2]
            / xyz(&quinine.without_reradiation(), &light("A").unwrap())[2];
        assert!(glow < 1.1, "Z under A grows by {glow}");
    }
}
