//! Rods, cones and midget ganglion cells across the retina.

use glanz_eye::curves::{
    Meridian, cone_density_deg2, eccentricity_mm, midget_field_density_deg2, retinal_area_mm2,
    rod_density_mm2,
};

use super::EyePlot;
use crate::chart::{Axis, Curve, LineChart};
use crate::page::style::Rgb8;
use crate::page::{curve_color, dash};
use crate::words::Word;

/// The greatest eccentricity shown, in degrees.
const EDGE_DEG: f64 = 60.0;
/// Grey for rods.
const RODS: Rgb8 = [0x8a, 0x93, 0x9e];

impl EyePlot {
    /// The density of rods, cones and midget fields over eccentricity, per deg² of the field.
    pub fn mosaic(&self) -> LineChart {
        let rods = |e: f64| rod_density_mm2(eccentricity_mm(e)) * retinal_area_mm2(e);
        let midget = |meridian| move |e: f64| midget_field_density_deg2(e, meridian);
        let curve = |word: Word, color, dash, f: &dyn Fn(f64) -> f64| Curve {
            name: self.say(word),
            points: places().map(|e| (e, f(e))).collect(),
            color,
            dash,
        };
        LineChart {
            title: self.say(Word::Mosaic),
            subtitle: self.say(Word::MosaicSource),
            x: Axis::exact(self.say(Word::Eccentricity), (0.0, EDGE_DEG), 6),
            y: Axis::decades(self.say(Word::PerSquareDegree), (1, 5)),
            curves: vec![
                curve(Word::RodCells, RODS, None, &rods),
                curve(Word::ConeCells, curve_color(1), None, &cone_density_deg2),
                curve(Word::MidgetTemporal, curve_color(0), None, &midget(Meridian::Temporal)),
                curve(Word::MidgetNasal, curve_color(0), dash(1), &midget(Meridian::Nasal)),
            ],
            marks: Vec::new(),
            lang: self.lang,
        }
    }
}

/// Eccentricities: every 0.02° in the fovea, every 0.25° outside.
fn places() -> impl Iterator<Item = f64> {
    let fovea = (0..100).map(|i| 0.02 * f64::from(i));
    fovea.chain((8..=240).map(|i| 0.25 * f64::from(i)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_fovea_has_no_rods_and_the_most_cones() {
        let chart = EyePlot::default().mosaic();
        let [rods, cones] = [0, 1].map(|index| &chart.curves[index].points);
        assert_eq!(rods[0], (0.0, 0.0));
        assert!(cones.windows(2).all(|pair| pair[1].1 < pair[0].1) && cones[0].1 > 20_000.0);
        // Where both are as many: about 1° from the fovea (Curcio 1990: 0.4 to 0.5 mm, 1.6°).
        let crossing = rods.iter().zip(cones).find(|(rod, cone)| rod.1 > cone.1);
        let (at, _) = crossing.expect("rods outnumber cones outside of the fovea").0;
        assert!((0.8..2.5).contains(at), "{at}");
    }
}
