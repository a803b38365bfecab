//! A re-radiation matrix as a heat map, and what it makes of lights.

use glanz_color::{FIRST_NM, LAST_NM, Reradiation, SAMPLES, STEP_NM};

use super::spectra::NamedSpectrum;
use crate::chart::{Axes, Axis, Curve, band, draw, extent, heading, magma, names, panel};
use crate::data::{DataCurve, DataPanel, PlotData};
use crate::page::style::{GRAY, INK, LABEL, NUMBER, Rgb8};
use crate::page::{Anchor, Figure, Page, Raster, Rect, curve_color, curve_dash};
use crate::words::{Lang, Word};

/// The values at the ends of the colour scale; lower ones are white.
const RANGE: (f64, f64) = (1e-3, 1.0);

/// A re-radiation matrix as a heat map.
#[derive(Clone, Debug, PartialEq)]
pub struct ReradiationMap {
    /// The material's name.
    pub name: String,
    /// The matrix.
    pub matrix: Reradiation,
    /// The total radiance factors that stand beside it, by the names of the lights; none for the matrix alone.
    pub factors: Option<Vec<NamedSpectrum>>,
    /// The language of the axes.
    pub lang: Lang,
}

impl Figure for ReradiationMap {
    fn layout(&self, _size: Option<(f64, f64)>) -> Page {
        let mut page = Page::new(if self.factors.is_some() { 1460 } else { 790 }, 740);
        self.heat_map(&mut page);
        if let Some(factors) = &self.factors {
            radiance_factors(&mut page, factors, self.lang);
        }
        page
    }

    fn data(&self) -> PlotData {
        let words = |words: &[Word]| words.iter().map(|word| self.lang.say(*word, &[])).collect();
        let nm = |index: usize| FIRST_NM + STEP_NM * index as f64;
        let entries = (0..SAMPLES).flat_map(|input| (0..SAMPLES).map(move |out| (input, out)));
        let entry = |(input, out): (usize, usize)| vec![nm(input), nm(out), self.matrix.get(out, input)];
        let matrix = DataPanel {
            title: self.lang.say(Word::Reradiation, &[]),
            columns: words(&[Word::Incidence, Word::Emission, Word::Fraction]),
            curves: vec![DataCurve { name: self.name.clone(), points: entries.map(entry).collect() }],
        };
        let factors = self.factors.as_deref().map(|factors| {
            let [title, x, y] = [Word::RadianceFactor, Word::Wavelength, Word::LeavingOverArriving]
                .map(|word| self.lang.say(word, &[]));
            panel(&title, &x, &y, &curves(factors))
        });
        let subtitle = self.lang.say(Word::Reradiation, &[]);
        PlotData::new(&self.name, subtitle, std::iter::once(matrix).chain(factors).collect())
    }

    fn title_mut(&mut self) -> &mut String {
        &mut self.name
    }

    fn lang(&self) -> Lang {
        self.lang
    }
}

fn curves(factors: &[NamedSpectrum]) -> Vec<Curve> {
    factors
        .iter()
        .enumerate()
        .map(|(index, factor)| Curve {
            name: factor.name.clone(),
            points: factor.spectrum.points().collect(),
            color: curve_color(index),
            dash: curve_dash(index),
        })
        .collect()
}

fn radiance_factors(page: &mut Page, factors: &[NamedSpectrum], lang: Lang) {
    let curves = curves(factors);
    let rect = Rect { x: 860.0, y: 96.0, width: 430.0, height: 560.0 };
    let x = Axis::exact(lang.say(Word::Wavelength, &[]), (FIRST_NM, LAST_NM), 5);
    let y = Axis::round(lang.say(Word::LeavingOverArriving, &[]), (0.0, extent(&curves).1), 6);
    let axes = Axes { rect, x, y, gap: band::HEIGHT };
    page.text(lang.say(Word::RadianceFactor, &[]), (rect.x, 66.0), Anchor::Start, LABEL, GRAY);
    draw(page, &axes, &curves, lang);
    names(page, (rect.right() + 20.0, rect.y + 12.0), &curves);
}

impl ReradiationMap {
    fn heat_map(&self, page: &mut Page) {
        let rect = Rect { x: 116.0, y: 96.0, width: 560.0, height: 560.0 };
        heading(page, 96.0, &self.name, &self.lang.say(Word::Reradiation, &[]));
        let axis = |label: String| Axis::exact(label, (FIRST_NM, LAST_NM), 5);
        let (x, y) = (axis(self.lang.say(Word::Incidence, &[])), axis(String::new()));
        let axes = Axes { rect, x, y, gap: band::HEIGHT };
        page.rasters.push(cells(&self.matrix, rect));
        // The numbers of y stand beside the band.
        Axes { y: Axis { ticks: Vec::new(), ..axes.y.clone() }, ..axes.clone() }.frame(page);
        band::below(page, &axes, self.lang);
        band::beside(page, &axes);
        for tick in &axes.y.ticks {
            let at = axes.at(axes.x.range.0, *tick);
            let at = (at.0 - band::HEIGHT - 6.0, at.1 + 0.36 * NUMBER);
            page.text(format!("{tick}"), at, Anchor::End, NUMBER, GRAY);
        }
        let middle = (46.0, rect.y + 0.5 * rect.height);
        page.text_upwards(self.lang.say(Word::Emission, &[]), middle, LABEL, INK);
        scale_bar(page, Rect { x: rect.right() + 24.0, width: 18.0, ..rect });
    }
}

/// A cell per entry, emission upwards.
fn cells(matrix: &Reradiation, rect: Rect) -> Raster {
    let rgb =
        (0..SAMPLES).rev().flat_map(|out| (0..SAMPLES).flat_map(move |input| color(matrix.get(out, input))));
    Raster { rect, columns: SAMPLES, rows: SAMPLES, rgb: rgb.collect() }
}

fn color(value: f64) -> Rgb8 {
    if value < RANGE.0 || value.is_nan() {
        return [0xff; 3];
    }
    magma(libm::log(value / RANGE.0) / libm::log(RANGE.1 / RANGE.0))
}

/// The colours with their values.
fn scale_bar(page: &mut Page, rect: Rect) {
    let decades = libm::log10(RANGE.1 / RANGE.0);
    let rows = rect.height as usize;
    let value = |part: f64| RANGE.0 * libm::exp10(decades * part);
    let rgb = (0..rows).rev().flat_map(|row| color(value((row as f64 + 0.5) / rows as f64)));
    page.rasters.push(Raster { rect, columns: 1, rows, rgb: rgb.collect() });
    page.outline(rect, GRAY, 1.2);
    for decade in 0..=decades.round() as i32 {
        let y = rect.bottom() - rect.height * f64::from(decade) / decades;
        page.line([(rect.right(), y), (rect.right() + 5.0, y)], GRAY, 1.2);
        let text = format!("{}", RANGE.0 * libm::exp10(f64::from(decade)));
        page.text(
            &text[..text.len().min(6)],
            (rect.right() + 9.0, y + 0.36 * NUMBER),
            Anchor::Start,
            NUMBER,
            GRAY,
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn greater_entries_are_darker_and_nothing_is_white() {
        assert_eq!(color(0.0), [0xff; 3]);
        assert_eq!(color(f64::NAN), [0xff; 3]);
        assert_eq!((color(RANGE.0), color(2.0)), (magma(0.0), magma(1.0)));
        let sum = |value| color(value).into_iter().map(u32::from).sum::<u32>();
        assert!(sum(1e-3) > sum(1e-2) && sum(1e-2) > sum(1e-1));
    }
}
