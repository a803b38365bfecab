//! The sensitivities of an eye's cones and rods, and the eye as an observer.

use glanz_color::{Channel, Observer, ObserverKind, SAMPLES, Spectrum, lambda_nm, observer};
use libm::{pow, round};

use crate::curves::{lens_density_cie170, lens_density_cie203};
use crate::eye::{Eye, Lens};
use crate::media::{FIRST, FIRST_APHAKIC, MEDIA, macular_density, pigment_density, template};

/// The names of the channels; rods are the fourth where they are asked for.
const NAMES: [&str; 4] = ["L", "M", "S", "R"];

impl Eye {
    /// The eye as an observer with the channels L, M, S.
    ///
    /// Its reference is the standard observer's eye: by its responses the channels are scaled, by its way to a screen they are
    /// shown, so that what this eye sees otherwise stays visible.
    pub fn observer(&self) -> Observer {
        self.seen_by(3)
    }

    /// The same with the rods as a fourth channel, R.
    pub fn observer_with_rods(&self) -> Observer {
        self.seen_by(4)
    }

    fn seen_by(&self, count: usize) -> Observer {
        let standard = self.standard();
        let reference = (*self != standard).then(|| Box::new(standard.seen_by(count)));
        let sensitivity = |channel: usize| match channel {
            3 => self.rods(),
            cone => self.cone(cone),
        };
        let channel =
            |(i, name): (usize, &&str)| Channel { name: (*name).to_owned(), sensitivity: sensitivity(i) };
        Observer {
            name: self.to_string(),
            title: format!("eye, {self}, {}°", self.field_deg),
            channels: NAMES[..count].iter().enumerate().map(channel).collect(),
            kind: ObserverKind::Lms,
            reference,
        }
    }

    /// The sensitivity of L, M or S (0, 1, 2) to energy that reaches the cornea, on the scale on which that of the standard eye
    /// with the same field is 1 at its peak.
    ///
    /// 0 below 390 nm, where CIE 170-1 begins; without a lens, below 360 nm.
    pub fn cone(&self, channel: usize) -> Spectrum {
        let peak = standard_peak(channel, self.field_deg);
        self.unscaled_cone(channel) * (1.0 / peak)
    }

    /// The sensitivity of the rods: V′(λ) of CIE 1951 through this eye's lens.
    pub fn rods(&self) -> Spectrum {
        let mut rods = observer("scotopic").expect("the rods are in the list").channels[0].sensitivity;
        let standard = Self::default();
        for (sample, value) in rods.0.iter_mut().enumerate().skip(FIRST) {
            *value *= pow(10.0, standard.lens_density(sample) - self.lens_density(sample));
        }
        rods
    }

    /// V_F(λ) of CIE 170-2:2015, by which luminance follows from L and M: of 2° for fields up to 6°, of 10° for wider ones.
    pub(crate) fn luminosity(&self) -> Spectrum {
        let [l, m] = if self.field_deg > 6.0 { [0.69283932, 0.34967567] } else { [0.68990272, 0.34832189] };
        self.cone(0) * l + self.cone(1) * m
    }

    /// λ in nm times the part of the light at the cornea that the pigment of L, M or S of the standard eye catches, at the
    /// wavelength where that is greatest.
    pub(crate) fn catch_at_peak(&self, channel: usize) -> f64 {
        standard_peak(channel, self.field_deg)
    }

    /// What the lens lets through at each wavelength of the grid; 0 below 390 nm.
    ///
    /// ```
    /// use glanz_eye::Eye;
    ///
    /// let old: Eye = "age:80".parse()?;
    /// assert!((old.lens_transmittance().at(450.0) - 0.1768).abs() < 1e-4);
    /// # Ok::<(), glanz_eye::EyeError>(())
    /// ```
    pub fn lens_transmittance(&self) -> Spectrum {
        let mut transmittance = Spectrum::ZERO;
        for sample in self.first_sample()..SAMPLES {
            transmittance.0[sample] = pow(10.0, -self.lens_density(sample));
        }
        transmittance
    }

    /// The first sample of the grid that it sees.
    fn first_sample(&self) -> usize {
        match self.lens {
            Lens::None => FIRST_APHAKIC,
            Lens::Cie170 | Lens::Cie203 => FIRST,
        }
    }

    /// The density of the lens at a sample of the grid.
    fn lens_density(&self, sample: usize) -> f64 {
        let nm = lambda_nm(sample);
        let density = match self.lens {
            Lens::None => return 0.0,
            Lens::Cie170 => lens_density_cie170(nm, self.age),
            Lens::Cie203 => {
                let change = lens_density_cie203(nm, self.age) - lens_density_cie203(nm, 32.0);
                lens_density_cie170(nm, 32.0) + change
            }
        };
        density.max(0.0) * self.lens_density
    }

    /// λ · absorptance · transmittance of macula and lens.
    fn unscaled_cone(&self, channel: usize) -> Spectrum {
        let [lm, s] = pigment_density(self.field_deg);
        let density = to_standard_digits(if channel == 2 { s } else { lm }) * self.pigment_density[channel];
        let macula = to_standard_digits(macular_density(self.field_deg)) / 0.35 * self.macula_density;
        let mut sensitivity = Spectrum::ZERO;
        for sample in self.first_sample()..SAMPLES {
            let nm = lambda_nm(sample);
            let absorbed = 1.0 - pow(10.0, -density * pow(10.0, self.log_absorbance(channel, sample)));
            let before = MEDIA.macula[sample] * macula + self.lens_density(sample);
            sensitivity.0[sample] = nm * absorbed * pow(10.0, -before);
        }
        sensitivity
    }

    /// log10 of the absorbance of a pigment: the table of CIE 170-1, moved as the closed form of it moves.
    fn log_absorbance(&self, channel: usize, sample: usize) -> f64 {
        let (table, shift) = (MEDIA.absorbance[channel][sample], self.shift_nm[channel]);
        match shift == 0.0 {
            true => table,
            false => {
                let nm = lambda_nm(sample);
                table + template(channel, nm, shift) - template(channel, nm, 0.0)
            }
        }
    }
}

/// CIE 170-1 has the densities of its observers by three decimals.
fn to_standard_digits(density: f64) -> f64 {
    round(density * 1000.0) / 1000.0
}

/// The peak of a cone of the standard eye before it is scaled to 1: that of the standard's tables for 2° and 10°, else the
/// greatest of the grid's values and of the parabola through it and its neighbours.
fn standard_peak(channel: usize, field_deg: f64) -> f64 {
    const TWO: [f64; 3] = [326.646497, 287.313805, 55.638646];
    const TEN: [f64; 3] = [277.057347, 245.240951, 75.530627];
    if field_deg == 2.0 {
        return TWO[channel];
    }
    if field_deg == 10.0 {
        return TEN[channel];
    }
    let curve = Eye { field_deg, ..Eye::default() }.unscaled_cone(channel).0;
    let at = (1..SAMPLES - 1).max_by(|a, b| curve[*a].total_cmp(&curve[*b])).expect("the grid has samples");
    let [before, top, after] = [curve[at - 1], curve[at], curve[at + 1]];
    let slope = after - before;
    top + slope * slope / (8.0 * (2.0 * top - before - after))
}
