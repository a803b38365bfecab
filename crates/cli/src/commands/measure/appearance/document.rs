//! The numbers as a document.

use glanz_color::colorimetry::lab;
use glanz_color::models::Lab;
use glanz_color::whiteness::{self, Field};
use glanz_color::yellowness::{E313, d1925};
use glanz_color::{Observer, observer};
use glanz_measure::{
    GlossMeter, HazeMeter, MultiAngle, SPHERE_DEG, flop_index, forty_five_zero, haze_of_gloss, log_haze,
    multi_angle, sphere,
};
use schemars::JsonSchema;
use serde::Serialize;

use super::subject::{Numbers, Subject};
use crate::input::spectra::{Source, light_source};
use crate::print::failure::Failure;

/// Half the angle of the sphere's port, in degrees.
const PORT_DEG: f64 = 4.1;

/// What of these numbers rests on memory: no standard or sheet of an instrument that tells it could be read.
const NOT_VERIFIED: [&str; 6] = [
    "apertures of gloss meters, but for the 1.8° at 20°",
    "apertures of haze meters; that ISO 13803 adds both receptors; the formula of the logarithmic scale",
    "formula and constants of the flop index",
    "the angles of ASTM E2194 and E2539",
    "the size of the sphere's port, which differs between instruments",
    "the limits of W and T within which the CIE calls its whiteness valid",
];

/// Numbers of an appearance.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    /// The file, model or material
    pub(super) name: String,
    /// Names of the channels
    pub(super) channels: Vec<String>,
    /// Gloss units at 20°, per channel
    pub(super) gloss_20: Vec<f64>,
    /// Gloss units at 60°
    pub(super) gloss_60: Vec<f64>,
    /// Gloss units at 85°
    pub(super) gloss_85: Vec<f64>,
    /// The geometry that tells such surfaces apart best, by the greatest channel
    pub(super) gloss_chosen_deg: f64,
    /// Haze units of ISO 13803, per channel
    pub(super) haze_iso_13803: Vec<f64>,
    /// The same on the logarithmic scale
    pub(super) log_haze: Vec<f64>,
    /// Haze of ASTM E430, method A, at 28° and 32°
    pub(super) haze_e430_narrow: Vec<f64>,
    /// Haze of ASTM E430, method A, at 25° and 35°
    pub(super) haze_e430_wide: Vec<f64>,
    /// The haze index of ASTM D4039; null up to 70 gloss units at 60°
    pub(super) haze_d4039: Vec<Option<f64>>,
    /// The radiance factor of 45°/0°
    pub(super) factor_45_0: Vec<f64>,
    /// Radiance factors with light at 45°
    pub(super) multi_angle: Vec<AngleFacts>,
    /// Radiance factors with light at 15°
    pub(super) multi_angle_15: Vec<AngleFacts>,
    /// 8°/d with all light
    pub(super) sphere_included: Vec<f64>,
    /// 8°/d without the light within `port_deg` of the mirror direction
    pub(super) sphere_excluded: Vec<f64>,
    /// Half the angle of the port
    pub(super) port_deg: f64,
    /// The light of the colours
    pub(super) light: String,
    /// The observer of the colours
    pub(super) observer: String,
    /// X, Y and Z of the perfect diffuser
    pub(super) white: Option<[f64; 3]>,
    /// The colour in each geometry
    pub(super) colors: Vec<ColorFacts>,
    /// Standards and instruments, with their geometries among these
    pub(super) lists: Vec<ListFacts>,
    /// The flop index; null for what is darkest near the mirror direction
    pub(super) flop_index: Option<f64>,
    /// Whiteness of the colour at 45°/0°; null for observers of neither 2° nor 10°
    pub(super) whiteness: Option<WhitenessFacts>,
    /// Yellowness of the colour at 45°/0°
    pub(super) yellowness: Vec<YellownessFacts>,
    /// What a reader of these numbers should know
    pub(super) notes: Vec<String>,
    /// What rests on memory, since no standard or sheet of an instrument could be read that tells it
    pub(super) not_verified: Vec<String>,
}

/// A radiance factor.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct AngleFacts {
    /// From the mirror direction towards the light
    pub(super) aspecular_deg: f64,
    /// πf, per channel
    pub(super) factor: Vec<f64>,
}

/// A colour.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct ColorFacts {
    /// 45/0, sci, sce, or the light's angle and the detector's from the mirror direction, as 45as-15
    pub(super) geometry: String,
    /// X, Y, Z; Y of the perfect diffuser is 100
    pub(super) xyz: [f64; 3],
    /// L*, a*, b*
    pub(super) lab: [f64; 3],
}

/// The geometries of a standard or an instrument.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct ListFacts {
    pub(super) name: &'static str,
    pub(super) geometries: Vec<String>,
}

/// Whiteness of CIE 15:2004.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct WhitenessFacts {
    /// W
    pub(super) whiteness: f64,
    /// T
    pub(super) tint: f64,
    /// Whether W and T are within the limits of the formula
    pub(super) is_valid: bool,
}

/// A yellowness.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct YellownessFacts {
    /// astm-e313 or astm-d1925
    pub(super) standard: &'static str,
    pub(super) light: String,
    pub(super) observer: String,
    pub(super) yellowness: f64,
}

impl Document {
    /// Measures.
    pub(super) fn new(
        name: &str,
        subject: &Subject,
        light: &Source,
        observer: &Observer,
    ) -> Result<Self, Failure> {
        let numbers = Numbers::new(subject, light, observer)?;
        let channels = subject.channels();
        let mut document = Self::of_gloss(name, channels.clone(), &numbers);
        let mut colors = Colors::new(&numbers, channels.len());
        document.factor_45_0 = colors.take("45/0", forty_five_zero);
        let pairs = MultiAngle::E2539.pairs_deg.iter().copied();
        for ((light_deg, aspecular_deg), geometry) in pairs.zip(MultiAngle::E2539.geometries()) {
            let factor = colors.take(&geometry, |f| multi_angle(f, light_deg, aspecular_deg));
            let list =
                if light_deg == 45.0 { &mut document.multi_angle } else { &mut document.multi_angle_15 };
            list.push(AngleFacts { aspecular_deg, factor });
        }
        let [included, excluded] = sphere(&mut *numbers.all(), PORT_DEG);
        let included = sums(included, &numbers.all_mirror(SPHERE_DEG));
        document.sphere_included = colors.add("sci", included);
        document.sphere_excluded = colors.add("sce", excluded);
        document.colors = colors.found;
        document.light.clone_from(&light.name);
        document.observer.clone_from(&observer.name);
        document.white = numbers.white();
        document.notes = numbers.notes();
        document.add_indices(subject, light, observer);
        Ok(document)
    }

    /// Gloss and haze; the rest is empty.
    fn of_gloss(name: &str, channels: Vec<String>, numbers: &Numbers<'_>) -> Self {
        let f = &mut *numbers.shown();
        let [gloss_20, gloss_60, gloss_85] =
            [GlossMeter::AT_20, GlossMeter::AT_60, GlossMeter::AT_85].map(|meter| {
                let mirror = numbers.shown_mirror(meter.angle_deg);
                sums(meter.gloss(f), &mirror.iter().map(|part| meter.of_mirror(*part)).collect::<Vec<_>>())
            });
        let [haze, narrow, wide] = [HazeMeter::ISO_13803, HazeMeter::E430_A_NARROW, HazeMeter::E430_A_WIDE]
            .map(|meter| meter.haze(f));
        let most = gloss_60.iter().copied().fold(0.0, f64::max);
        Self {
            name: name.to_owned(),
            channels,
            gloss_chosen_deg: GlossMeter::chosen(most).angle_deg,
            log_haze: haze.iter().map(|haze| log_haze(*haze)).collect(),
            haze_d4039: gloss_60.iter().zip(&gloss_20).map(|(g60, g20)| haze_of_gloss(*g60, *g20)).collect(),
            haze_iso_13803: haze,
            haze_e430_narrow: narrow,
            haze_e430_wide: wide,
            gloss_20,
            gloss_60,
            gloss_85,
            factor_45_0: Vec::new(),
            multi_angle: Vec::new(),
            multi_angle_15: Vec::new(),
            sphere_included: Vec::new(),
            sphere_excluded: Vec::new(),
            port_deg: PORT_DEG,
            light: String::new(),
            observer: String::new(),
            white: None,
            colors: Vec::new(),
            lists: MultiAngle::ALL.iter().map(ListFacts::of).collect(),
            flop_index: None,
            whiteness: None,
            yellowness: Vec::new(),
            notes: Vec::new(),
            not_verified: NOT_VERIFIED.map(str::to_owned).to_vec(),
        }
    }

    /// The colour in a geometry.
    fn color(&self, geometry: &str) -> Option<&ColorFacts> {
        self.colors.iter().find(|color| color.geometry == geometry)
    }

    /// Flop, whiteness and yellowness.
    fn add_indices(&mut self, subject: &Subject, light: &Source, observer: &Observer) {
        let lightness = |geometry: &str| self.color(geometry).map(|color| color.lab[0]);
        let three = [lightness("45as15"), lightness("45as45"), lightness("45as110")];
        if let [Some(near), Some(face), Some(flop)] = three {
            self.flop_index = flop_index(near, face, flop);
        }
        let own = subject.xyz_under(light, observer).is_none();
        let seen = self.color("45/0").map(|color| color.xyz.map(|value| 0.01 * value));
        let field = if own { Some(Field::Two) } else { Field::of(observer) };
        if let (Some(xyz), Some(white), Some(field)) = (seen, self.white, field) {
            self.whiteness = whiteness::whiteness(xyz, white, field).map(WhitenessFacts::of);
            if !own && light.name != "D65" {
                self.notes.push(format!(
                    "whiteness is defined for D65: under {} it compares samples only",
                    light.name
                ));
            }
        }
        self.yellowness = yellowness(subject, own.then_some(seen).flatten());
    }
}

/// The numbers of channels, with more of each.
fn sums(mut values: Vec<f64>, more: &[f64]) -> Vec<f64> {
    values.iter_mut().zip(more).for_each(|(value, more)| *value += more);
    values
}

impl ListFacts {
    fn of(list: &MultiAngle) -> Self {
        Self { name: list.name, geometries: list.geometries().collect() }
    }
}

impl WhitenessFacts {
    fn of(found: whiteness::Whiteness) -> Self {
        Self { whiteness: found.whiteness, tint: found.tint, is_valid: found.is_valid }
    }
}

/// The yellowness under each light and observer that it is defined for. What has the colours of D65 and cie1931 alone, which are
/// `own`, has one.
fn yellowness(subject: &Subject, own: Option<[f64; 3]>) -> Vec<YellownessFacts> {
    let facts = |standard, light: &str, observer: &str, yellowness: f64| {
        let (light, observer) = (light.to_owned(), observer.to_owned());
        yellowness.is_finite().then_some(YellownessFacts { standard, light, observer, yellowness })
    };
    let mut all = Vec::new();
    for pair in E313 {
        let is_own = (pair.light, pair.observer) == ("D65", "cie1931");
        let known = light_source(pair.light).ok().zip(observer(pair.observer).ok());
        let seen = known.and_then(|(light, observer)| subject.xyz_under(&light, &observer));
        let Some(xyz) = seen.or(own.filter(|_| is_own)) else { continue };
        all.extend(facts("astm-e313", pair.light, pair.observer, pair.yellowness(xyz)));
        if seen.is_some() && (pair.light, pair.observer) == ("C", "cie1931") {
            all.extend(facts("astm-d1925", pair.light, pair.observer, d1925(xyz)));
        }
    }
    all
}

/// Radiance factors as they are taken, with their colours.
struct Colors<'a, 'b> {
    numbers: &'a Numbers<'b>,
    /// How many of the channels are shown.
    shown: usize,
    found: Vec<ColorFacts>,
}

impl<'a, 'b> Colors<'a, 'b> {
    fn new(numbers: &'a Numbers<'b>, shown: usize) -> Self {
        Self { numbers, shown, found: Vec::new() }
    }

    /// Takes the factors of a geometry.
    fn take(
        &mut self,
        geometry: &str,
        of: impl FnOnce(&mut glanz_measure::Function<'_>) -> Vec<f64>,
    ) -> Vec<f64> {
        let factors = of(&mut *self.numbers.all());
        self.add(geometry, factors)
    }

    /// Keeps their colour; what is left are the channels that are shown.
    fn add(&mut self, geometry: &str, mut factors: Vec<f64>) -> Vec<f64> {
        if let Some((xyz, white)) = self.numbers.xyz(&factors).zip(self.numbers.white()) {
            let Lab(lab) = lab(xyz, white);
            let xyz = xyz.map(|value| 100.0 * value);
            self.found.push(ColorFacts { geometry: geometry.to_owned(), xyz, lab });
        }
        factors.truncate(self.shown);
        factors
    }
}
