//! A sheet with all there is to see of two reflectances: balls, differences, slices and polar cuts.

use core::f64::consts::PI;

use glanz_color::Observer;
use glanz_math::Vec3;
use glanz_measure::{PlaneSlice, Readings};
use glanz_plot::chart::sampled;
use glanz_plot::figure::{ComparisonSheet, Ray};
use glanz_plot::page::{Rgb8, curve_color};
use glanz_plot::{Axis, Curve, Lang, PolarChart, RegressionChart};
use glanz_render::MaterialResponse;

use super::balls::Balls;
use super::surface::Surface;
use crate::input::spectra::Source;

/// Angles of incidence where no readings tell some, in degrees.
const INCIDENCES_DEG: [f64; 3] = [15.0, 45.0, 75.0];

/// Slices beside each other: as many as pictures of a row.
const COLUMNS: usize = 3;

/// Light and detector are shown up to this angle from the normal: nearer to the horizon there are no data.
const MOST_THETA_DEG: f64 = 85.0;

/// Powers of ten that are shown below the greatest value.
const DECADES: i32 = 4;

/// The colour of directions, which are of no curve alone.
const RAY: Rgb8 = [0x5b, 0x63, 0x6e];

/// Readings are darker than lines, which may run through them.
const DARK: f64 = 0.55;

/// Where light comes from without readings of a grain: along x, as tables have it.
const AZIMUTH_DEG: f64 = 180.0;

/// Two surfaces, and what they reflect of a light.
pub(super) struct Pair<'a> {
    pub(super) names: [&'a str; 2],
    pub(super) surfaces: &'a [Surface; 2],
    pub(super) responses: &'a [MaterialResponse; 2],
    pub(super) light: &'a Source,
    pub(super) observer: &'a Observer,
}

/// A slice of one angle of incidence.
struct Incidence {
    theta_deg: f64,
    /// Readings of each surface: the detector's angle, and Y.
    readings: [Vec<(f64, f64)>; 2],
    /// Y of each surface by the detector's angle.
    lines: [Vec<(f64, f64)>; 2],
}

impl Pair<'_> {
    /// The sheet.
    pub(super) fn sheet(&self, balls: Balls) -> ComparisonSheet {
        let azimuth = self.azimuth_deg();
        let incidences = self.incidences(azimuth);
        let [a, b] = self.names;
        let grain = azimuth.map(|azimuth| format!("; light from the azimuth {azimuth}°"));
        let (light, observer) = (&self.light.name, &self.observer.name);
        ComparisonSheet {
            title: format!("{a} and {b}"),
            subtitle: format!("Y under {light} for {observer}{}", grain.unwrap_or_default()),
            columns: vec![a.to_owned(), b.to_owned(), "ΔE₀₀".to_owned()],
            rows: balls.rows(),
            slices_heading: "In the plane of incidence".to_owned(),
            slices: self.slices(&incidences),
            cuts_heading:
                "Polar cuts in the plane of incidence: the dot is the light, dashes are the mirror direction"
                    .to_owned(),
            cuts: incidences.iter().map(|one| self.cut(one)).collect(),
            lang: Lang::En,
        }
    }

    /// The azimuth of the light where a surface has a grain: that of readings, if there are some.
    fn azimuth_deg(&self) -> Option<f64> {
        if !self.responses.iter().any(has_grain) {
            return None;
        }
        let mut read = self.surfaces.iter().filter_map(|surface| surface.readings.as_ref());
        Some(read.find_map(Readings::commonest_azimuth_deg).unwrap_or(AZIMUTH_DEG))
    }

    /// Those of the readings, or such as lie far apart.
    fn incidences(&self, azimuth: Option<f64>) -> Vec<Incidence> {
        let slices = |surface: &Surface| {
            let all = surface.readings.as_ref().map(|readings| readings.plane_slices(usize::MAX, azimuth));
            all.unwrap_or_default()
        };
        let of_both = [slices(&self.surfaces[0]), slices(&self.surfaces[1])];
        let told = of_both.iter().find(|slices| !slices.is_empty());
        let angles = told.map_or(INCIDENCES_DEG.to_vec(), |slices| spread(slices));
        angles.into_iter().map(|theta| self.incidence(theta, azimuth, &of_both)).collect()
    }

    fn incidence(&self, theta_deg: f64, azimuth: Option<f64>, slices: &[Vec<PlaneSlice>; 2]) -> Incidence {
        let readings = |side: usize| {
            let slice = slices[side].iter().find(|slice| slice.theta_i_deg == theta_deg);
            let points = slice.map_or(&[][..], |slice| &slice.points);
            points.iter().filter_map(|(theta_o, index)| Some((*theta_o, self.read(side, *index)?))).collect()
        };
        let phi = azimuth.unwrap_or(AZIMUTH_DEG).to_radians();
        let wi = Vec3::from_angles(theta_deg.to_radians(), phi);
        let line = |side: usize| {
            let y = |theta: f64| {
                let around = if theta < 0.0 { phi } else { phi + PI };
                self.responses[side].brdf(wi, Vec3::from_angles(theta.abs().to_radians(), around))[1]
            };
            let height = |y: f64| libm::log10(y.max(1e-6));
            sampled(y, (-MOST_THETA_DEG, MOST_THETA_DEG), &[theta_deg, -theta_deg], height)
        };
        Incidence { theta_deg, readings: [readings(0), readings(1)], lines: [line(0), line(1)] }
    }

    /// Y of a reading, in 1/sr.
    fn read(&self, side: usize, index: usize) -> Option<f64> {
        let readings = self.surfaces[side].readings.as_ref()?;
        let factors: Vec<f64> = readings.values(index).iter().map(|value| f64::from(*value) * PI).collect();
        let [_, y, _] = readings.channels().xyz(&factors, &self.light.fine, self.observer)?;
        Some(y / PI)
    }

    /// Charts that share the axis of values.
    fn slices(&self, incidences: &[Incidence]) -> Vec<RegressionChart> {
        let values = || incidences.iter().flat_map(Incidence::values).map(|(_, value)| value);
        let most = values().fold(0.0, f64::max);
        let high = if most > 0.0 { libm::ceil(libm::log10(most) - 1e-9) as i32 } else { 0 };
        let least = values().filter(|value| *value > 0.0).fold(most.max(f64::MIN_POSITIVE), f64::min);
        let low = (libm::floor(libm::log10(least)) as i32).clamp(high - DECADES, high - 1);
        let chart = |(column, one): (usize, &Incidence)| RegressionChart {
            title: one.title(),
            subtitle: String::new(),
            x: Axis {
                decimals: 0,
                ticks: ticks(),
                ..Axis::exact("θo of the detector in °", (-90.0, 90.0), 6)
            },
            y: Axis::decades(if column == 0 { "f in 1/sr" } else { "" }, (low, high)),
            clouds: self.clouds(one, |_, y| y),
            lines: self.lines(one, |_, y| y),
            lang: Lang::En,
        };
        incidences.iter().enumerate().map(chart).collect()
    }

    fn cut(&self, one: &Incidence) -> PolarChart {
        let outwards = |theta: f64, y: f64| y * libm::cos(theta.to_radians());
        let most = one.values().map(|(theta, y)| outwards(theta, y)).fold(0.0, f64::max);
        let ray = |degrees: f64, label: &str, dashed: bool| Ray {
            degrees,
            label: label.to_owned(),
            color: RAY,
            dashed,
        };
        let (light, mirror) = (ray(-one.theta_deg, "", false), ray(one.theta_deg, "", true));
        PolarChart {
            title: one.title(),
            subtitle: String::new(),
            radius: Axis::round("f · cosθo in 1/sr", (0.0, most), 3),
            curves: self.lines(one, outwards),
            clouds: self.clouds(one, outwards),
            rays: if one.theta_deg < 1.0 { vec![light] } else { vec![light, mirror] },
            whole: false,
            lang: Lang::En,
        }
    }

    fn lines(&self, one: &Incidence, value: impl Fn(f64, f64) -> f64) -> Vec<Curve> {
        // Where both are the same, the first shows between dashes of the second.
        let dashes = [None, Some((7.0, 5.0))];
        let line = |side: usize| {
            let line = curve(side, self.names[side].to_owned(), &one.lines[side], &value);
            Curve { dash: dashes[side], ..line }
        };
        vec![line(0), line(1)]
    }

    /// Of each surface that was read one by one.
    fn clouds(&self, one: &Incidence, value: impl Fn(f64, f64) -> f64) -> Vec<Curve> {
        let is_read = |side: &usize| self.surfaces[*side].readings.is_some();
        let name = |side: usize| format!("readings of {}", self.names[side]);
        let cloud = |side: usize| {
            let cloud = curve(side, name(side), &one.readings[side], &value);
            Curve { color: cloud.color.map(|code| (DARK * f64::from(code)) as u8), ..cloud }
        };
        (0..2).filter(is_read).map(cloud).collect()
    }
}

/// Whether turning both directions changes Y, by more than the rounding of f32.
fn has_grain(response: &MaterialResponse) -> bool {
    let y = |turn: f64| {
        let [wi, wo] = [(0.6, 2.9), (0.4, 0.3)].map(|(theta, phi)| Vec3::from_angles(theta, phi + turn));
        response.brdf(wi, wo)[1]
    };
    let first = y(0.0);
    [0.5, 1.0, 1.5].iter().any(|turn| (y(*turn) - first).abs() > 1e-4 * first.abs())
}

impl Incidence {
    fn title(&self) -> String {
        format!("light at {}°", self.theta_deg)
    }

    fn values(&self) -> impl Iterator<Item = (f64, f64)> {
        let all = self.readings.iter().chain(&self.lines).flatten();
        all.copied().filter(|(_, value)| value.is_finite())
    }
}

fn curve(side: usize, name: String, points: &[(f64, f64)], value: &impl Fn(f64, f64) -> f64) -> Curve {
    let points = points.iter().map(|(theta, y)| (*theta, value(*theta, *y))).collect();
    Curve { name, points, color: curve_color(side), dash: None }
}

fn ticks() -> Vec<f64> {
    (-3..=3).map(|i| 30.0 * f64::from(i)).collect()
}

/// Angles of incidence that are shown: the least, the greatest and one between them.
fn spread(slices: &[PlaneSlice]) -> Vec<f64> {
    let angles: Vec<f64> =
        slices.iter().map(|slice| slice.theta_i_deg).filter(|theta| *theta <= MOST_THETA_DEG).collect();
    // Light along the normal shows least.
    let from = usize::from(angles.len() > COLUMNS && angles.first().is_some_and(|theta| *theta < 1.0));
    let angles = &angles[from..];
    let count = angles.len().min(COLUMNS);
    (0..count).map(|k| angles[k * (angles.len() - 1) / (count - 1).max(1)]).collect()
}
