//! Spectra in IES TM-27-14, the XML of lamp makers: `.spdx`.
//!
//! Wavelengths are in nm, as the standard says. The spectrum is named by the header's description, else
//! its catalogue number. What the values are comes from `SpectralQuantity`.

use super::xml;
use crate::file::read::error::clean;
use crate::file::read::named::note;
use crate::file::read::table::stem;
use crate::file::read::text::expect_number;
use crate::file::read::units::{MAX_NAME, Scale};
use crate::file::read::{NamedSpectrum, Quantity, ReadError, read_as};

/// The root element.
pub(in crate::file::read) const ROOT: &str = "IESTM2714";
/// Texts by which files say that there is nothing to say.
const NOTHING: [&str; 4] = ["unknown", "n/a", "none", "-"];

/// Reads the spectra of a TM-27-14 file, as a rule one. `file` is its name for messages.
///
/// # Errors
///
/// [`ReadError`] tells the line and column that is not as the standard says.
pub fn read_spdx(bytes: &[u8], file: &str) -> Result<Vec<NamedSpectrum>, ReadError> {
    read_as(bytes, file, parse)
}

/// The spectra of a text as the file has them, before their scale is settled.
pub(in crate::file::read) fn parse(text: &str, file: &str) -> Result<Vec<NamedSpectrum>, ReadError> {
    let document = xml::parse(text, file)?;
    let root = xml::root(&document, ROOT, file)?;
    let header = xml::children(root, "Header").next();
    let name = header.and_then(|header| {
        ["Description", "CatalogNumber"]
            .into_iter()
            .filter_map(|name| xml::child_text(header, name))
            .find(|text| !NOTHING.contains(&text.to_lowercase().as_str()))
    });
    let name = name.map_or_else(|| stem(file), |name| clean(name, MAX_NAME));
    let mut spectra = Vec::new();
    for part in xml::children(root, "SpectralDistribution") {
        let number = spectra.len() + 1;
        let name = if number == 1 { name.clone() } else { format!("{name} {number}") };
        spectra.push(distribution(part, name, file)?);
    }
    if spectra.is_empty() {
        let place = xml::place(root);
        return Err(ReadError::malformed(file, place, "an element 'SpectralDistribution'", "none"));
    }
    Ok(spectra)
}

/// Reads one distribution.
fn distribution(node: roxmltree::Node<'_, '_>, name: String, file: &str) -> Result<NamedSpectrum, ReadError> {
    let told = xml::child_text(node, "SpectralQuantity").unwrap_or("");
    let mut spectrum =
        NamedSpectrum { name, quantity: quantity(told), unit: unit(told).to_owned(), ..Default::default() };
    if told.is_empty() {
        note(&mut spectrum.notes, "the file does not say what its values are");
    }
    if xml::child_text(node, "BandwidthCorrected") == Some("false") {
        note(&mut spectrum.notes, "the values are not corrected for the bandwidth of the instrument");
    }
    for point in xml::children(node, "SpectralData") {
        let place = || xml::place(point);
        let Some(nm) = xml::attribute(point, "wavelength", file)? else {
            return Err(ReadError::malformed(file, place(), "an attribute 'wavelength'", "none"));
        };
        let nm = Scale::Nanometres.nm(nm, file, place)?;
        let value = expect_number(point.text().unwrap_or(""), false, file, place)?;
        if let Some(before) = spectrum.nm.last().filter(|before| nm <= **before) {
            let found = format!("{nm} nm after {before} nm");
            return Err(ReadError::malformed(file, place(), "rising wavelengths", found));
        }
        spectrum.nm.push(nm);
        spectrum.values.push(value);
    }
    match spectrum.nm.is_empty() {
        true => Err(ReadError::malformed(file, xml::place(node), "elements 'SpectralData'", "none")),
        false => Ok(spectrum),
    }
}

/// The quantities that the standard names.
fn quantity(told: &str) -> Quantity {
    match told.to_lowercase().as_str() {
        "reflectance" | "r-value" | "radiancefactor" => Quantity::Reflectance,
        "transmittance" | "t-value" => Quantity::Transmittance,
        "absorptance" => Quantity::Absorptance,
        "flux" | "intensity" | "irradiance" | "radiance" | "exitance" => Quantity::Light,
        "relative" => Quantity::Relative,
        _ => Quantity::Unknown,
    }
}

/// The SI units that the standard has for its quantities.
fn unit(told: &str) -> &'static str {
    match told.to_lowercase().as_str() {
        "flux" => "W/nm",
        "intensity" => "W/sr/nm",
        "irradiance" | "exitance" => "W/m²/nm",
        "radiance" => "W/sr/m²/nm",
        _ => "",
    }
}
