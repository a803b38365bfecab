//! IES TM-27-14.

use std::io::{self, Write};

use crate::file::read::Quantity;
use crate::spectra::Spectrum;

/// Writes a spectrum as a TM-27-14 file, with its name as the description.
///
/// The standard knows no light without more said: [`Quantity::Light`] is written as `radiance`,
/// [`Quantity::Unknown`] as `other`. Other fields that it demands say `N/A`.
///
/// # Errors
///
/// Those of the writer.
pub fn write_spdx(
    mut out: impl Write,
    name: &str,
    quantity: Quantity,
    spectrum: &Spectrum,
) -> io::Result<()> {
    let quantity = match quantity {
        Quantity::Reflectance => "reflectance",
        Quantity::Transmittance => "transmittance",
        Quantity::Absorptance => "absorptance",
        Quantity::Light => "radiance",
        Quantity::Relative => "relative",
        Quantity::Absorbance | Quantity::Unknown => "other",
    };
    writeln!(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>")?;
    writeln!(out, "<IESTM2714 xmlns=\"iestm2714\" version=\"1.0\">\n  <Header>")?;
    for (tag, text) in [
        ("Manufacturer", "N/A"),
        ("CatalogNumber", "N/A"),
        ("Description", name),
        ("DocumentCreator", "glanz"),
        ("Laboratory", "N/A"),
        ("UniqueIdentifier", "N/A"),
        ("ReportNumber", "N/A"),
        ("ReportDate", "N/A"),
        ("DocumentCreationDate", "N/A"),
    ] {
        writeln!(out, "    <{tag}>{}</{tag}>", escape(text))?;
    }
    writeln!(out, "  </Header>\n  <SpectralDistribution>")?;
    writeln!(out, "    <SpectralQuantity>{quantity}</SpectralQuantity>")?;
    for (nm, value) in spectrum.points() {
        writeln!(out, "    <SpectralData wavelength=\"{nm}\">{value}</SpectralData>")?;
    }
    writeln!(out, "  </SpectralDistribution>\n</IESTM2714>")
}

/// Text without what XML takes for its own.
fn escape(text: &str) -> String {
    let clean = text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect::<String>();
    clean.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
