//! Colour for Glanz: spectra, lights, observers, surfaces, colour models, and the numbers that are made of
//! them.
//!
//! One grid for all spectra that are drawn, 300 to 780 nm by 5 nm ([`Spectrum`]); numbers of a spectrum are summed by 1 nm
//! ([`FineSpectrum`]). f64 throughout; only pure-Rust functions, so that numbers are the same on every machine.
//!
//! ```
//! use glanz_color::colorimetry::DisplayColor;
//! use glanz_color::difference::ciede2000;
//! use glanz_color::models::{Lab, Xyz};
//! use glanz_color::{Observer, ior, light, xyz_of_light, xyz_of_reflectance};
//!
//! // Gold along the normal under a tungsten lamp, for the CIE 1931 observer.
//! let (a, observer) = (light("A")?, Observer::default());
//! let white = xyz_of_light(&a, &observer);
//! let gold = xyz_of_reflectance(&ior("gold")?.normal_reflectance(), &a, &observer);
//! // As it looks to an eye that is adapted to the lamp, on a display.
//! let color = DisplayColor::adapted(gold, white).expect("the lamp is seen by all cones");
//! assert_eq!(color.hex(), "#ffe1a1");
//! // It is far from white.
//! let difference = ciede2000(Lab::for_white(Xyz(gold), Xyz(white)), Lab([100.0, 0.0, 0.0]));
//! assert!(difference > 20.0);
//! # Ok::<_, glanz_color::UnknownName>(())
//! ```

mod algebra;
mod catalog;
mod display;
mod feature_off;
mod file;
mod lights;
mod measures;
pub mod models;
mod names;
mod observers;
mod sampling;
mod spectra;
mod surfaces;

pub use algebra::Matrix3;
pub use catalog::{CatalogSpectrum, SpectrumKind, catalog_spectrum};
pub use display::encoding::Encoding;
pub use display::mixing;
pub use display::rgb::Rgb;
pub use display::srgb::{srgb_decode, srgb_decode_u8, srgb_encode};
pub use display::tone_map::ToneMap;
pub use feature_off::FeatureOff;
pub use file::{exr, read, write};
pub use lights::{
    DAYLIGHT_RANGE_K, KelvinError, LightInfo, PLANCK_RANGE_K, daylight, fine_light, light, lights, planck,
};
pub use measures::adaptation::{Adaptation, AdaptationError};
pub use measures::{
    adaptation, chromaticity, colorimetry, cri, difference, dominant, photometry, ssi, temperature, tm30,
    whiteness, yellowness,
};
pub use models::Xyz;
pub use names::UnknownName;
pub use observers::{
    Channel, Observer, ObserverInfo, ObserverKind, cie1931_by_1_nm, observer, observers, xyz_of_light,
    xyz_of_reflectance,
};
pub use sampling::{efficiency, meyer, rgb_spectra, upsample};
pub use spectra::{
    FINE_LAST_NM, FINE_SAMPLES, FIRST_NM, FineSpectrum, Interpolation, LAST_NM, Outside, SAMPLES, STEP_NM,
    Sampled, Spectrum, TableError, lambda_nm, units,
};
pub use surfaces::dyes;
pub use surfaces::fluorescent::{FluorescentInfo, fluorescent, fluorescents};
pub use surfaces::fluorophore::{Fluorophore, FluorophoreError, FluorophoreParameter};
pub use surfaces::ior::{Dispersion, Ior, IorInfo, IorKind, ior, iors};
pub use surfaces::paper_notes::{PaperNote, paper_notes};
pub use surfaces::reflectances::{
    ReflectanceInfo, colorchecker, fine_reflectance, reflectance, reflectances,
};
pub use surfaces::reradiation::{EnergyReport, MeasuredError, Reradiation};
