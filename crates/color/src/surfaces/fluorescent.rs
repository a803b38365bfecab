//! Fluorescent materials by name.
//!
//! Two are measurements, the paper notes. The others are *models*: a layer of a dye with its measured bands of absorption and
//! emission ([`dyes`](crate::dyes)) over a smooth base. They look as such a material does, and obey the conservation of energy;
//! they are no measurement of any sample. How strong the layers are, and their bases, are chosen, so that excitation from 300 nm
//! on, peak and amount of emission are near those of yellow fibres, index card and pigments that were measured with a
//! bispectrometer (S. Gonzalez and M. Fairchild, RIT, 1999).

use std::sync::LazyLock;

use crate::names::{UnknownName, plain};
use crate::spectra::Spectrum;
use crate::surfaces::dyes::{Dye, dye};
use crate::surfaces::fluorophore::band;
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
        let matrix = (model.dye)().over(&Spectrum::from_fn(model.base), model.absorbance);
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
    dye: fn() -> Dye,
    /// The greatest absorbance of the layer.
    absorbance: f64,
    base: fn(f64) -> f64,
}

/// A dye that comes with the crate.
fn known(name: &str) -> Dye {
    dye(name).expect("the name of a listed dye")
}

/// The dyes of an orange pigment: what coumarin 6 and rhodamine 6G absorb, rhodamine B emits. In the resin of such pigments it
/// emits some 35 nm further to the red than in ethanol: a band at 602 nm, 45 nm wide.
fn day_glow() -> Dye {
    let rhodamine = known("rhodamine-b");
    let emission = Spectrum::from_fn(|nm| band(nm, 602.0, 45.0));
    let resin = Dye::from_spectra(rhodamine.absorption(), &emission, rhodamine.quantum_yield());
    let resin = resin.expect("the band lies above the absorption");
    resin.sensitised_by(&[(&known("coumarin-6"), 0.9), (&known("rhodamine-6g"), 0.8)])
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

/// Where the numbers of the models come from.
const SOURCE: &str = "measured bands of the dye (PhotochemCAD, 2018), over a base; strength and base chosen";

const MODELS: [Model; 7] = [
    Model {
        info: FluorescentInfo {
            name: "paper-brightened",
            title: "office paper with a stilbene brightener (model)",
            source: "bands of brightener 28 (McNamara et al., Cytometry A 69, 2006), over a base; yield, strength and base chosen",
            measured: false,
        },
        dye: || known("brightener-28"),
        absorbance: 0.9,
        base: paper,
    },
    Model {
        info: FluorescentInfo {
            name: "highlighter-yellow",
            title: "marker ink of pyranine on white card (model)",
            source: SOURCE,
            measured: false,
        },
        dye: || known("pyranine"),
        absorbance: 1.3,
        base: white_card,
    },
    Model {
        info: FluorescentInfo {
            name: "highlighter-green",
            title: "marker ink of coumarin 6 on white card (model)",
            source: SOURCE,
            measured: false,
        },
        dye: || known("coumarin-6"),
        absorbance: 1.3,
        base: white_card,
    },
    Model {
        info: FluorescentInfo {
            name: "highlighter-pink",
            title: "marker ink of rhodamine B on white card (model)",
            source: SOURCE,
            measured: false,
        },
        dye: || known("rhodamine-b"),
        absorbance: 1.0,
        base: white_card,
    },
    Model {
        info: FluorescentInfo {
            name: "rhodamine-6g",
            title: "rhodamine 6G on white card (model)",
            source: SOURCE,
            measured: false,
        },
        dye: || known("rhodamine-6g"),
        absorbance: 1.0,
        base: white_card,
    },
    Model {
        info: FluorescentInfo {
            name: "day-glow-orange",
            title: "pigment of rhodamines and a coumarin in resin on white card (model)",
            source: "bands absorbed of three dyes (PhotochemCAD, 2018); emission, strength and base chosen",
            measured: false,
        },
        dye: day_glow,
        absorbance: 1.5,
        base: white_card,
    },
    Model {
        info: FluorescentInfo {
            name: "quinine",
            title: "quinine sulphate in dilute sulphuric acid before white card (model)",
            source: SOURCE,
            measured: false,
        },
        dye: || known("quinine-sulphate"),
        absorbance: 0.7,
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
        assert_eq!(fluorescents().len(), 9);
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
    fn markers_glow_as_measured_fibres_and_pigments_do() {
        // Yellow textile and an orange pigment (Hercules), BFC-450 matrices of RIT, 1999: the fraction of light that leaves at
        // longer wavelengths for light at these, the peak of emission, and the greatest total radiance factor under equal
        // energy. Another dye of another strength, so to a few tenths of the fraction.
        let yellow = [
            (300.0, 0.22),
            (320.0, 0.20),
            (360.0, 0.15),
            (400.0, 0.46),
            (440.0, 0.57),
            (480.0, 0.41),
            (520.0, 0.0),
        ];
        let orange = [
            (320.0, 0.11),
            (360.0, 0.18),
            (400.0, 0.32),
            (440.0, 0.41),
            (500.0, 0.48),
            (540.0, 0.56),
            (620.0, 0.0),
        ];
        for (name, known, peak_nm, most) in
            [("highlighter-yellow", yellow, 510.0, 1.78), ("day-glow-orange", orange, 600.0, 2.36)]
        {
            let material = fluorescent(name).unwrap();
            let glow = material.off_diagonal();
            for (nm, fraction) in known {
                let line = light(&format!("line({nm})")).unwrap();
                let found = glow.apply(&line).integral() / line.integral();
                assert!(
                    (found - fraction).abs() < 0.2 && (found > 0.05 || fraction < 0.1),
                    "{name} {nm} nm: {found}"
                );
            }
            let sent = glow.apply(&Spectrum::ONE);
            let (found, _) = sent.points().max_by(|a, b| a.1.total_cmp(&b.1)).unwrap();
            assert!((found - peak_nm).abs() <= 5.0, "{name}: {found} nm");
            let factor = material.total_radiance_factor(&Spectrum::ONE).max();
            assert!((factor / most - 1.0).abs() < 0.3, "{name}: {factor}");
        }
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
