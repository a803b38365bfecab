//! What stands before the receptors, by age: the lens, and the rods through it.

use glanz_color::{UnknownName, observer};
use glanz_eye::curves::{lens_density_cie170, lens_density_cie203};

use super::EyePlot;
use crate::Error;
use crate::chart::{Curve, WavelengthChart};
use crate::page::dash;
use crate::words::Word;

/// The wavelengths of the tables of CIE 170-1, and of CIE 203, in nm.
const CIE170_NM: (i32, i32) = (390, 780);
const CIE203_NM: (i32, i32) = (300, 780);
/// The age of the standard observer.
const STANDARD_AGE: f64 = 32.0;

impl EyePlot {
    /// The transmittance of the lens for each age, by CIE 170-1 and by CIE 203.
    ///
    /// # Errors
    /// [`Error::Age`] for an age that is not 20 to 80 years, [`Error::TooManyLobes`] for too many.
    pub fn lens(&self) -> Result<WavelengthChart, Error> {
        let transmittances = |(from, to): (i32, i32), density: fn(f64, f64) -> f64, age: f64| {
            let points = (from..=to).step_by(5).map(f64::from);
            points.map(|nm| (nm, libm::exp10(-density(nm, age)))).collect::<Vec<_>>()
        };
        let lens = self.by_age(|age| transmittances(CIE170_NM, lens_density_cie170, age))?;
        let media = self.by_age(|age| transmittances(CIE203_NM, lens_density_cie203, age))?;
        let pairs = lens.into_iter().zip(media).flat_map(|(lens, media)| {
            let named = |curve: Curve, standard: &str, dash| Curve {
                name: format!("{}, {standard}", curve.name),
                dash,
                ..curve
            };
            [named(lens, "CIE 170-1", None), named(media, "CIE 203", dash(1))]
        });
        Ok(WavelengthChart {
            title: self.say(Word::LensByAge),
            subtitle: self.say(Word::LensSource),
            label: self.say(Word::Transmittance),
            range_nm: (f64::from(CIE203_NM.0), f64::from(CIE203_NM.1)),
            curves: pairs.collect(),
            marked: Vec::new(),
            lang: self.lang,
        })
    }

    /// The sensitivity of the rods for each age: V′(λ), which is taken for that of 32 years, times what the lens of CIE 170-1 passes more
    /// or less than at that age.
    ///
    /// # Errors
    /// [`Error::Age`] for an age that is not 20 to 80 years, [`Error::TooManyLobes`] for too many.
    pub fn rods(&self) -> Result<WavelengthChart, Error> {
        let standard = sensitivity()?;
        let curves = self.by_age(|age| {
            let through = |(nm, value): &(f64, f64)| {
                let denser = lens_density_cie170(*nm, age) - lens_density_cie170(*nm, STANDARD_AGE);
                (*nm, value * libm::exp10(-denser))
            };
            standard.iter().map(through).collect()
        })?;
        Ok(WavelengthChart {
            title: self.say(Word::RodsByAge),
            subtitle: self.say(Word::RodsSource),
            label: self.say(Word::Sensitivity),
            range_nm: (f64::from(CIE170_NM.0), 700.0),
            curves,
            marked: Vec::new(),
            lang: self.lang,
        })
    }
}

/// V′ where CIE 170-1 has the lens.
fn sensitivity() -> Result<Vec<(f64, f64)>, UnknownName> {
    let rods = observer("scotopic")?;
    let points = rods.channels.iter().flat_map(|channel| channel.sensitivity.points());
    Ok(points.filter(|(nm, _)| *nm >= f64::from(CIE170_NM.0)).collect())
}
