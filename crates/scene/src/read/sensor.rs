//! Sensors: a file with one curve for each channel.

use glanz_color::read::read_spectra;
use glanz_color::{Channel, Observer, Outside, rgb_spectra};

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
    let channel = |spectrum: &glanz_color::read::NamedSpectrum| {
        let (sensitivity, _) =
            spectrum.to_spectrum(Some(Outside::Zero)).map_err(|error| error.to_string())?;
        // It must answer to daylight, by which its channels are scaled.
        match sensitivity.dot(&rgb_spectra::daylight()) > 0.0 {
            true => Ok(Channel { name: spectrum.name.clone(), sensitivity }),
            false => {
                Err(format!("channel '{}' of '{file}' sees nothing between 300 and 780 nm", spectrum.name))
            }
        }
    };
    let channels = spectra.iter().map(channel).collect::<Result<Vec<_>, _>>()?;
    let stem = file.rsplit(['/', '\\']).next().unwrap_or(file);
    Ok(Observer::from_channels(stem.strip_suffix(".csv").unwrap_or(stem), channels))
}
