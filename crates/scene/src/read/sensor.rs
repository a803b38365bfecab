//! Sensors: a file with one curve for each channel.

use glanz_color::read::{NamedSpectrum, read_spectra};
use glanz_color::{Channel, Observer, rgb_spectra};

/// The most channels of a sensor.
const MOST: usize = 97;

/// Reads a sensor from a table of spectra, one per channel; `file` is its name. The error says what was
/// expected.
pub fn read_sensor(bytes: &[u8], file: &str) -> Result<Observer, String> {
    let spectra = read_spectra(bytes, file).map_err(|error| error.to_string())?;
    if spectra.is_empty() || spectra.len() > MOST {
        return Err(format!(
            "expected a sensor of 1 to {MOST} channels in '{file}', found {}",
            spectra.len()
        ));
    }
    let channel = |spectrum: &NamedSpectrum| {
        let failed =
            |error: glanz_color::TableError| format!("channel '{}' of '{file}': {error}", spectrum.name);
        let (sensitivity, _) = spectrum.to_sensitivity().map_err(failed)?;
        // It must answer to daylight, by which its channels are scaled.
        match sensitivity.dot(&rgb_spectra::daylight()) > 0.0 {
            true => Ok(Channel { name: spectrum.name.clone(), sensitivity }),
            false => Err(format!("channel '{}' of '{file}' answers to no daylight", spectrum.name)),
        }
    };
    let channels = spectra.iter().map(channel).collect::<Result<Vec<_>, _>>()?;
    let stem = file.rsplit(['/', '\\']).next().unwrap_or(file);
    Ok(Observer::from_channels(stem.strip_suffix(".csv").unwrap_or(stem), channels))
}
