//! What plots of lobes have in common: which lobes, seen from where, and what is plotted.

use glanz_bsdf::{DirectionPair, LightTerm, Shape, Side};
use glanz_math::Vec3;

use super::factor::Factor;
use super::lobe::Lobe;
use crate::Error;
use crate::page::Figure;
use crate::words::{Lang, Word};

/// The most curves of a plot.
pub(super) const MOST_CURVES: usize = 64;
/// The most bodies or maps of a plot.
pub(super) const MOST_PANELS: usize = 12;
/// The wavelength where none is given, in nm: near the greatest sensitivity of the eye.
pub const DEFAULT_NM: f64 = 550.0;

/// What is plotted of a lobe.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Quantity {
    /// The BSDF in 1/sr.
    F,
    /// The BSDF times the incident cosine, in 1/sr.
    #[default]
    FCos,
}

/// Models whose `f_cos` is at most 1/π, and 1 in the course's unit.
const CLASSIC: [&str; 3] = ["lambert", "phong", "blinn-phong"];

/// The unit of values.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Unit {
    /// Per steradian.
    #[default]
    PerSr,
    /// That of the classic lighting equation, in which the greatest value of Lambert's and Phong's models is 1: π times
    /// the value per steradian.
    Course,
}

impl Unit {
    /// What values per steradian are multiplied with.
    pub fn scale(self) -> f64 {
        match self {
            Self::PerSr => 1.0,
            Self::Course => std::f64::consts::PI,
        }
    }
}

/// Lobes to plot. Each kind of plot is a method that gives a figure: [`polar`](Self::polar),
/// [`cartesian`](Self::cartesian), [`lobe3d`](Self::lobe3d), [`albedo`](Self::albedo), [`slice`](Self::slice),
/// [`terms`](Self::terms).
///
/// The light is in the plane of the viewer and the normal, at positive angles on the other side of the normal.
#[derive(Clone, Debug, PartialEq)]
pub struct LobePlot {
    /// The lobes.
    pub lobes: Vec<Lobe>,
    /// Angles of the viewer from the normal, in degrees.
    pub theta_deg: Vec<f64>,
    /// Azimuth of the viewer from the tangent in degrees, which anisotropic models depend on.
    pub phi_deg: f64,
    /// What is plotted.
    pub quantity: Quantity,
    /// Whether the axis of the values is logarithmic.
    pub log: bool,
    /// What lobes are multiplied with.
    pub factor: Factor,
    /// The wavelength of the factor in nm.
    pub lambda_nm: f64,
    /// The unit of the values.
    pub unit: Unit,
    /// The language of the words.
    pub lang: Lang,
}

/// Plots lobes with the viewer at 30° from the normal.
///
/// ```
/// use glanz_bsdf::Shape;
///
/// let svg = glanz_plot::lobe(&[Shape::named("phong", &[("shininess", 32.0)])?]).svg()?;
/// assert!(svg.starts_with("<svg"));
/// # Ok::<_, glanz_plot::Error>(())
/// ```
pub fn lobe(shapes: &[Shape]) -> LobePlot {
    LobePlot::new(shapes.iter().cloned().map(Lobe::from).collect())
}

impl LobePlot {
    /// A plot of `f_cos` on linear axes, with the viewer at 30° from the normal.
    pub fn new(lobes: Vec<Lobe>) -> Self {
        Self {
            lobes,
            theta_deg: vec![30.0],
            phi_deg: 0.0,
            quantity: Quantity::FCos,
            log: false,
            factor: Factor::One,
            lambda_nm: DEFAULT_NM,
            unit: Unit::PerSr,
            lang: Lang::En,
        }
    }

    /// The [`polar`](Self::polar) plot as SVG.
    ///
    /// # Errors
    /// Those of [`polar`](Self::polar).
    pub fn svg(&self) -> Result<String, Error> {
        self.polar()?.svg()
    }

    /// That every lobe answers to light from a direction with values, and a plot of all in `views` directions can
    /// be read.
    pub(super) fn check_lobes(&self, views: usize, most: usize) -> Result<(), Error> {
        for lobe in &self.lobes {
            let info = lobe.shape.info();
            if matches!(info.term, LightTerm::Ambient | LightTerm::Emission) {
                return Err(Error::NoDirection { model: info.name });
            }
            if info.delta {
                return Err(Error::SingleDirection { model: info.name });
            }
        }
        self.check_count(views, most)
    }

    /// The same for plots in which each view has a place of its own.
    pub(super) fn check_views(&self, most: usize) -> Result<(), Error> {
        self.check_angles()?;
        self.check_lobes(self.theta_deg.len(), most)
    }

    pub(super) fn check_angles(&self) -> Result<(), Error> {
        match self.theta_deg.iter().find(|theta| !(0.0..90.0).contains(*theta)) {
            Some(wrong) => Err(Error::ViewAngle { theta_deg: *wrong }),
            None => Ok(()),
        }
    }

    pub(super) fn check_count(&self, views: usize, most: usize) -> Result<(), Error> {
        if !self.phi_deg.is_finite() {
            return Err(Error::Azimuth { phi_deg: self.phi_deg });
        }
        let found = self.lobes.len() * views;
        if found > most { Err(Error::TooManyLobes { found, most }) } else { Ok(()) }
    }

    /// The value for two directions.
    pub(super) fn value(&self, lobe: &Lobe, wo: Vec3<f64>, wi: Vec3<f64>) -> f64 {
        let f_cos = self.factor.f_cos(&lobe.shape, &DirectionPair::new(wo, wi));
        let value = match self.quantity {
            Quantity::FCos => f_cos,
            Quantity::F if f_cos == 0.0 => 0.0,
            Quantity::F => f_cos / wi.z.abs().max(1e-12),
        };
        value * self.unit.scale()
    }

    /// The direction to the viewer.
    pub(super) fn wo(&self, theta: f64) -> Vec3<f64> {
        Vec3::from_angles(theta.to_radians(), self.phi_deg.to_radians())
    }

    /// The light in the plane of incidence, at positive angles on the other side of the normal.
    pub(super) fn in_plane(&self, degrees: f64) -> Vec3<f64> {
        Vec3::from_angles(degrees.to_radians(), (self.phi_deg + 180.0).to_radians())
    }

    /// The name of what is plotted.
    pub(super) fn quantity_name(&self) -> String {
        let word = match (self.quantity, self.unit) {
            (Quantity::F, Unit::PerSr) => Word::F,
            (Quantity::FCos, Unit::PerSr) => Word::FCos,
            (Quantity::F, Unit::Course) => Word::CourseF,
            (Quantity::FCos, Unit::Course) => Word::CourseFCos,
        };
        self.lang.say(word, &[])
    }

    /// Where the peak of the classic models lies in the unit of the plot, for the subtitle; nothing for others.
    pub(super) fn peak(&self) -> String {
        let classic = |lobe: &Lobe| CLASSIC.contains(&lobe.shape.info().name);
        let shown = self.quantity == Quantity::FCos && self.factor == Factor::One;
        match (shown && self.lobes.iter().any(classic), self.unit) {
            (true, Unit::PerSr) => self.lang.say(Word::PeakOverPi, &[]),
            (true, Unit::Course) => self.lang.say(Word::PeakOne, &[]),
            (false, _) => String::new(),
        }
    }

    /// The same, with where the peak of classic models lies.
    pub(super) fn subtitle_of_values(&self, more: &str) -> String {
        let peak = self.peak();
        let parts = [more.to_owned(), peak];
        let parts: Vec<_> = parts.into_iter().filter(|part| !part.is_empty()).collect();
        self.subtitle(&self.lang.join(&parts))
    }

    /// Models, azimuth and factor in one line, for below the title.
    pub(super) fn subtitle(&self, more: &str) -> String {
        let mut parts = vec![more.to_owned()];
        if self.lobes.iter().any(|lobe| lobe.shape.info().anisotropic) {
            parts.push(self.lang.say(Word::ViewerAtPhi, &[&self.lang.number(self.phi_deg)]));
        }
        match &self.factor {
            Factor::One => {}
            Factor::Reflectance(name, _) => {
                parts.push(self.lang.say(Word::TimesReflectance, &[name, &self.lang.number(self.lambda_nm)]));
            }
            Factor::Fresnel(medium) => {
                parts.push(
                    self.lang.say(Word::TimesFresnel, &[&medium.name, &self.lang.number(self.lambda_nm)]),
                );
            }
        }
        parts.retain(|part| !part.is_empty());
        self.lang.join(&parts)
    }

    /// The title: the model's, if there is one only.
    pub(super) fn title(&self, several: Word) -> String {
        let first = self.lobes.first().map_or("", |lobe| lobe.shape.info().title);
        match self.lobes.iter().all(|lobe| lobe.shape.info().title == first) {
            true => self.lang.name(first).to_owned(),
            false => self.lang.say(several, &[]),
        }
    }

    /// Whether any of the lobes has a mirror direction.
    pub(super) fn reflects(&self) -> bool {
        self.lobes.iter().any(|lobe| lobe.shape.info().side == Side::Reflection)
    }

    pub(super) fn transmits(&self) -> bool {
        self.lobes.iter().any(|lobe| lobe.shape.info().side == Side::Transmission)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plot(model: &str) -> LobePlot {
        LobePlot::new(vec![Lobe::named(model, &[]).unwrap()])
    }

    #[test]
    fn what_has_no_lobe_is_refused() {
        assert!(matches!(plot("ambient").polar(), Err(Error::NoDirection { .. })));
        assert!(matches!(plot("mirror").albedo(), Err(Error::SingleDirection { .. })));
        let beside = LobePlot { theta_deg: vec![90.0], ..plot("phong") };
        assert!(matches!(beside.cartesian(), Err(Error::ViewAngle { theta_deg: 90.0 })));
        // The albedo has no viewer of its own.
        assert!(beside.albedo().is_ok());
        let many = LobePlot { theta_deg: vec![30.0; 13], ..plot("phong") };
        assert!(matches!(many.lobe3d(), Err(Error::TooManyLobes { found: 13, most: 12 })));
        let nowhere = LobePlot { phi_deg: f64::NAN, ..plot("ward") };
        assert!(matches!(nowhere.slice(), Err(Error::Azimuth { .. })));
    }

    #[test]
    fn f_is_f_cos_over_the_cosine() {
        let chart = plot("lambert").cartesian().unwrap();
        let over = LobePlot { quantity: Quantity::F, ..plot("lambert") }.cartesian().unwrap();
        let (a, b) = (&chart.curves[0].points, &over.curves[0].points);
        let at_0 = |points: &[(f64, f64)]| points.iter().find(|(x, _)| *x == 0.0).map(|(_, y)| *y);
        assert!((at_0(a).unwrap() - std::f64::consts::FRAC_1_PI).abs() < 1e-12);
        assert!((at_0(b).unwrap() - std::f64::consts::FRAC_1_PI).abs() < 1e-12);
        assert!(
            b.iter()
                .filter(|(x, _)| x.abs() < 80.0)
                .all(|(_, y)| (y * std::f64::consts::PI - 1.0).abs() < 1e-9)
        );
    }
}
