//! The pigments of the cones and of the macula: CIE 170-1:2006.

use std::sync::LazyLock;

use glanz_color::{FIRST_NM, SAMPLES, STEP_NM, lambda_nm};
use libm::{cos, exp, log10, pow, sin};

/// The number of the first sample of the grid that CIE 170-1 covers: 390 nm.
pub(crate) const FIRST: usize = ((390.0 - FIRST_NM) / STEP_NM) as usize;

/// The number of the first sample that an eye without a lens sees: 360 nm.
pub(crate) const FIRST_APHAKIC: usize = ((360.0 - FIRST_NM) / STEP_NM) as usize;

/// Tables on the grid; below 390 nm the absorbances are those of Stockman and Rider's curves.
pub(crate) struct Media {
    /// log10 of the absorbance of the pigments of L, M, S, 0 at their peaks.
    pub absorbance: [[f64; SAMPLES]; 3],
    /// The density of the macular pigment, 0.35 at its peak.
    pub macula: [f64; SAMPLES],
}

/// The tables.
pub(crate) static MEDIA: LazyLock<Media> = LazyLock::new(Media::read);

impl Media {
    fn read() -> Self {
        let text = include_str!("../data/media.csv");
        let mut media = Self { absorbance: [[0.0; SAMPLES]; 3], macula: [0.0; SAMPLES] };
        for line in text.lines().filter(|line| line.starts_with(|c: char| c.is_ascii_digit())) {
            let number = |field: &str| field.parse::<f64>().expect("the table holds numbers");
            let row: Vec<f64> = line.split(',').map(number).collect();
            let sample = ((row[0] - FIRST_NM) / STEP_NM) as usize;
            if sample >= SAMPLES {
                break;
            }
            for (channel, table) in media.absorbance.iter_mut().enumerate() {
                table[sample] = row[1 + channel];
            }
            media.macula[sample] = row[4];
        }
        media.extend_down();
        media
    }

    /// Fills 360 to 385 nm: the curves of Stockman and Rider, moved so that they meet the tables at 390 nm.
    fn extend_down(&mut self) {
        for (channel, table) in self.absorbance.iter_mut().enumerate() {
            let curve = |sample: usize| template(channel, lambda_nm(sample), 0.0);
            let offset = table[FIRST] - curve(FIRST);
            for (sample, value) in table.iter_mut().enumerate().take(FIRST).skip(FIRST_APHAKIC) {
                *value = curve(sample) + offset;
            }
        }
        // The macular pigment hardly absorbs there; its edge is continued as it falls from 395 to 390 nm.
        let fall = self.macula[FIRST] / self.macula[FIRST + 1];
        for sample in (FIRST_APHAKIC..FIRST).rev() {
            self.macula[sample] = self.macula[sample + 1] * fall;
        }
    }
}

/// The wavelengths in nm at which the curves of the pigments of L (serine), M, S peak.
const PEAKS_NM: [f64; 3] = [553.1, 529.8, 417.0];

/// The coefficients of those curves: a constant, then cosine and sine of each harmonic, then another constant.
const COEFFICIENTS: [[f64; 18]; 3] = [
    [
        -42.417608560,
        -2.656791612,
        75.011093607,
        56.477062776,
        7.509397607,
        9.061442173,
        -38.068488495,
        -20.974610259,
        -6.642746250,
        -3.785039126,
        9.322071459,
        3.134494745,
        1.603799055,
        0.439302358,
        -0.676958684,
        -0.072988371,
        -0.078857510,
        -0.004264105,
    ],
    [
        -210.6568853069,
        -0.1458073553,
        386.7319763250,
        305.4710584670,
        5.0218382813,
        6.8386224350,
        -208.2062335724,
        -118.4890200521,
        -5.7625866330,
        -3.7973553168,
        55.1803460639,
        19.9728512548,
        1.8990456325,
        0.6913410864,
        -5.0891806213,
        -0.7070689492,
        -0.1419926703,
        0.0005894876,
    ],
    [
        207.3880950935,
        -6.3065623516,
        -393.7100478026,
        -315.6650602846,
        19.2917535553,
        19.6414743488,
        214.2211570447,
        121.8584683485,
        -15.1820737886,
        -8.6774057156,
        -56.7596380441,
        -20.6318720369,
        3.6934875040,
        1.0483022480,
        5.3656615075,
        0.7898783086,
        -0.1480357836,
        0.0002358232,
    ],
];

/// log10 of the absorbance of the pigment of a cone whose peak is moved by `shift_nm`. L is the mean of people: 56 % have serine at
/// place 180 of its protein, the others alanine, by which it peaks 2.7 nm lower. The closed form of A. Stockman and A. T. Rider, "Formulae for generating standard and individual human cone spectral sensitivities", 2023, over 360 to 850 nm.
///
/// It differs from the tables by up to 0.013 (L, M) and 0.021 (S): differences of it are taken, not itself.
pub(crate) fn template(channel: usize, nm: f64, shift_nm: f64) -> f64 {
    const SERINE: f64 = 0.56;
    const TO_ALANINE_NM: f64 = -2.7;
    let own = curve(channel, nm, shift_nm);
    match channel {
        0 => {
            let alanine = curve(channel, nm, shift_nm + TO_ALANINE_NM);
            log10(SERINE * pow(10.0, own) + (1.0 - SERINE) * pow(10.0, alanine))
        }
        _ => own,
    }
}

/// One curve of that form.
fn curve(channel: usize, nm: f64, shift_nm: f64) -> f64 {
    // 360 to 850 nm as 0 to π of the logarithm.
    const SPAN: f64 = 0.118_766_646_758_184_23;
    const ORIGIN: f64 = 2.556_302_500_767_287_3;
    let peak = PEAKS_NM[channel];
    let x = (log10(nm) - ORIGIN + log10(peak / (peak + shift_nm))) / SPAN;
    let [constant, waves @ .., last] = &COEFFICIENTS[channel];
    let harmonics = waves.chunks_exact(2).enumerate().map(|(n, wave)| {
        let angle = (n + 1) as f64 * x;
        wave[0] * cos(angle) + wave[1] * sin(angle)
    });
    constant + harmonics.sum::<f64>() + last
}

/// The optical density at the peak of L and M, and of S, for a field of `field_deg` degrees: CIE 170-1.
///
/// ```
/// let [lm, s] = glanz_eye::pigment_density(2.0);
/// assert!((lm - 0.50045).abs() < 5e-6 && (s - 0.40037).abs() < 5e-6);
/// ```
pub fn pigment_density(field_deg: f64) -> [f64; 2] {
    let fall = exp(-field_deg / 1.333);
    [0.38 + 0.54 * fall, 0.30 + 0.45 * fall]
}

/// The density of the macular pigment at its peak for a field of `field_deg` degrees: CIE 170-1.
///
/// ```
/// assert!((glanz_eye::macular_density(10.0) - 0.09495).abs() < 5e-6);
/// ```
pub fn macular_density(field_deg: f64) -> f64 {
    0.485 * exp(-field_deg / 6.132)
}
