//! What sees: standard observers, cones and rods by name, and any other sensor from its curves.
//!
//! Sums over spectra are taken at the samples of the grid, every 5 nm, as CIE 15 has it for practical
//! use; the curves are CIE's values at these wavelengths, not means. Sums over a [`FineSpectrum`] are taken every nm, with the
//! CIE's values by 1 nm.

mod list;

use std::borrow::Cow;
use std::sync::LazyLock;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::names::{UnknownName, plain};
use crate::spectra::table::Table;
use crate::spectra::{FineSpectrum, Outside, Sampled, Spectrum};

pub use list::{ObserverInfo, observers};

/// Who looks: one response per channel.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Observer {
    /// The name, such as `cie1931`.
    pub name: String,
    /// What it is, in a few words.
    pub title: String,
    /// The channels in their order.
    pub channels: Vec<Channel>,
    /// What the channels are.
    pub kind: ObserverKind,
    /// The observer by whose responses the channels are scaled in pictures, and by whose way to a screen they are shown; none: by its
    /// own. Where the two differ, as an old eye does from a young one, the difference is seen.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reference: Option<Box<Observer>>,
}

/// One kind of receptor, or one colour-matching function.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Channel {
    /// The name, such as `x` or `L`.
    pub name: String,
    /// The response to a unit of light at each wavelength.
    pub sensitivity: Spectrum,
}

/// What the channels of an observer are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ObserverKind {
    /// x, y, z: colour-matching functions of which y is a luminous efficiency.
    Xyz,
    /// L, M, S: the cones.
    Lms,
    /// V: the eye by day.
    Photopic,
    /// V′: the eye at night.
    Scotopic,
    /// Anything else, such as a camera.
    Other,
}

static TABLE: LazyLock<Table> = LazyLock::new(|| Table::parse(include_str!("../../data/observers.csv")));

/// The observer of that name; [`observers`] lists them.
///
/// ```
/// use glanz_color::{light, observer};
///
/// let eye = observer("cie1964")?;
/// assert_eq!(eye.channels[1].name, "y");
/// // X, Y and Z of the equal-energy light are the same, up to the sums by 5 nm.
/// let response = eye.response(&light("E")?);
/// assert!((response[0] / response[1] - 1.0).abs() < 1e-3 && (response[2] / response[1] - 1.0).abs() < 1e-3);
/// // The cones see the red end with L far more than with M.
/// let cones = observer("lms2")?;
/// let red = cones.response(&light("line(650)")?);
/// assert!(red[0] > 5.0 * red[1]);
/// # Ok::<_, glanz_color::UnknownName>(())
/// ```
///
/// # Errors
///
/// [`UnknownName`] suggests near names.
pub fn observer(name: &str) -> Result<Observer, UnknownName> {
    let wanted = plain(name);
    let info = observers().iter().find(|info| info.name == wanted).ok_or_else(|| {
        UnknownName::not_found("observer", name.trim(), observers().iter().map(|info| info.name))
    })?;
    let channels = TABLE.names().filter_map(|column| {
        let (owner, channel) = column.split_once(':')?;
        let sensitivity = TABLE.spectrum(column, Outside::Zero)?;
        (owner == info.name).then(|| Channel { name: channel.to_owned(), sensitivity })
    });
    Ok(Observer {
        name: info.name.to_owned(),
        title: info.title.to_owned(),
        channels: channels.collect(),
        kind: info.kind,
        reference: None,
    })
}

/// The observer that comes with the crate, and its curves by 1 nm.
struct Known {
    observer: Observer,
    fine: Vec<FineSpectrum>,
}

static KNOWN: LazyLock<Vec<Known>> = LazyLock::new(|| {
    let table = Table::parse(include_str!("../../data/observers_1nm.csv"));
    let known = |info: &ObserverInfo| {
        let observer = observer(info.name).expect("a listed observer loads");
        let fine = |channel: &Channel| match info.name {
            "cie1931" => fine_1931(&channel.name),
            // V is y of CIE 1931.
            "photopic" => fine_1931("y"),
            name => table
                .sampled(&format!("{name}:{}", channel.name), Outside::Zero)
                .expect("the table has all channels of the other observers"),
        };
        let fine = observer.channels.iter().map(fine).collect();
        Known { observer, fine }
    };
    observers().iter().map(known).collect()
});

/// A colour-matching function of CIE 1931 by 1 nm.
fn fine_1931(name: &str) -> FineSpectrum {
    let axis = ["x", "y", "z"].iter().position(|axis| *axis == name).expect("an axis of CIE 1931");
    let (nm, values): (Vec<f64>, Vec<f64>) =
        cie1931_by_1_nm().iter().map(|(nm, xyz)| (*nm, xyz[axis])).unzip();
    FineSpectrum::from_table(&nm, &values, Outside::Zero).expect("the functions are a table")
}

/// An observer that comes with the crate, kept.
pub(crate) fn kept(name: &str) -> &'static Observer {
    let found = KNOWN.iter().find(|known| known.observer.name == name);
    &found.expect("the name of a listed observer").observer
}

impl Default for Observer {
    /// The CIE 1931 standard observer.
    fn default() -> Self {
        observer("cie1931").expect("the list of observers has the CIE 1931 standard observer")
    }
}

impl Observer {
    /// A camera or any other sensor, from the curves of its channels.
    pub fn from_channels(name: impl Into<String>, channels: Vec<Channel>) -> Self {
        let name = name.into();
        Self { title: name.clone(), name, channels, kind: ObserverKind::Other, reference: None }
    }

    /// The response of each channel: Σ s(λ) E(λ) · 5 nm, in the unit of the light's values times nm.
    pub fn response(&self, light: &Spectrum) -> Vec<f64> {
        self.channels.iter().map(|channel| channel.sensitivity.dot(light)).collect()
    }

    /// The curves of the channels by 1 nm: those of the CIE for observers that come with the crate, interpolated (Sprague,
    /// CIE 167:2005) for others.
    pub fn fine_sensitivities(&self) -> Cow<'static, [FineSpectrum]> {
        match KNOWN.iter().find(|known| known.observer.channels == self.channels) {
            Some(known) => Cow::Borrowed(&known.fine),
            None => self.channels.iter().map(|channel| channel.sensitivity.to_fine(Outside::Zero)).collect(),
        }
    }

    /// The first three responses; 0 where there are fewer channels.
    fn first_three<S: Sampled>(&self, light: &S) -> [f64; 3] {
        let responses = light.responses(self);
        core::array::from_fn(|i| responses.get(i).copied().unwrap_or(0.0))
    }

    /// The response by which XYZ are divided: Y, or the only channel of an efficiency.
    ///
    /// NaN for observers that have no luminance.
    fn luminance<S: Sampled>(&self, light: &S) -> f64 {
        let [first, second, _] = self.first_three(light);
        match self.kind {
            ObserverKind::Xyz => second,
            ObserverKind::Photopic | ObserverKind::Scotopic => first,
            ObserverKind::Lms | ObserverKind::Other => f64::NAN,
        }
    }
}

/// XYZ of a light, scaled so that its Y is 1.
///
/// For an observer of kind `Xyz`. The efficiencies V and V′ give `[1, 0, 0]`. All three are NaN where there
/// is nothing to scale by: light that the observer does not see, or an observer without luminance (take
/// [`Observer::response`] there).
pub fn xyz_of_light<S: Sampled>(light: &S, observer: &Observer) -> [f64; 3] {
    let luminance = observer.luminance(light);
    observer.first_three(light).map(|response| response / luminance)
}

/// XYZ of a surface under a light, scaled so that the perfect diffuser has Y = 1.
///
/// For an observer of kind `Xyz`; what others give, and when all is NaN, [`xyz_of_light`] says.
///
/// ```
/// use glanz_color::{Observer, Spectrum, light, reflectance, xyz_of_reflectance};
///
/// let (d65, observer) = (light("D65")?, Observer::default());
/// let [x, y, z] = xyz_of_reflectance(&Spectrum::ONE, &d65, &observer);
/// assert!((x - 0.9505).abs() < 2e-4 && y == 1.0 && (z - 1.0888).abs() < 2e-4);
/// // The grey of the ColorChecker that reflects a fifth.
/// let [_, y, _] = xyz_of_reflectance(&reflectance("neutral-5")?, &d65, &observer);
/// assert!((y - 0.2).abs() < 0.01);
/// # Ok::<_, glanz_color::UnknownName>(())
/// ```
pub fn xyz_of_reflectance<S: Sampled>(reflectance: &S, light: &S, observer: &Observer) -> [f64; 3] {
    let luminance = observer.luminance(light);
    observer.first_three(&reflectance.times(light)).map(|response| response / luminance)
}

/// The CIE 1931 functions by 1 nm, 360 … 830 nm: wavelengths and x, y, z.
///
/// For the spectral locus and for sums at full precision; spectra on the grid are summed with
/// [`observer`]`("cie1931")`.
pub fn cie1931_by_1_nm() -> &'static [(f64, [f64; 3])] {
    static FINE: LazyLock<Vec<(f64, [f64; 3])>> = LazyLock::new(|| {
        let table = Table::parse(include_str!("../../data/cie1931_1nm.csv"));
        let [x, y, z] = ["x", "y", "z"].map(|name| table.points(name).expect("the table has x, y and z"));
        (0..x.0.len()).map(|i| (x.0[i], [x.1[i], y.1[i], z.1[i]])).collect()
    });
    &FINE
}

#[cfg(test)]
mod tests;
