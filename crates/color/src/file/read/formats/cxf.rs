//! Spectral values of CxF3 (ISO 17972-1), the XML of colour exchange: `.cxf`.
//!
//! Every element `…Spectrum` of an object's `ColorValues` is a spectrum: its first wavelength is
//! its own `StartWL` or that of the colour specification it refers to, the step that specification's
//! `Increment`. It is named by its object; if an object has several, by its specification too.

use super::xml;
use crate::file::read::error::{clean, excerpt};
use crate::file::read::table::{MOST_SPECTRA, stem};
use crate::file::read::text::expect_number;
use crate::file::read::units::{MAX_NAME, Scale};
use crate::file::read::{NamedSpectrum, Quantity, ReadError, read_as};
use roxmltree::Node;
use std::collections::HashMap;

/// The root element.
pub(in crate::file::read) const ROOT: &str = "CxF";

/// Reads the spectra of a CxF3 file. `file` is its name for messages.
///
/// # Errors
///
/// [`ReadError`] tells the line and column that is not as this module says, or that the file holds no spectra.
pub fn read_cxf(bytes: &[u8], file: &str) -> Result<Vec<NamedSpectrum>, ReadError> {
    read_as(bytes, file, parse)
}

/// The spectra of a text as the file has them, before their scale is settled.
pub(in crate::file::read) fn parse(text: &str, file: &str) -> Result<Vec<NamedSpectrum>, ReadError> {
    let document = xml::parse(text, file)?;
    let root = xml::root(&document, ROOT, file)?;
    let ranges = ranges(root, file)?;
    let mut spectra = Vec::new();
    for object in root.descendants().filter(|node| node.tag_name().name() == "Object") {
        let values = xml::children(object, "ColorValues").flat_map(|values| values.children());
        let found: Vec<Node<'_, '_>> =
            values.filter(|node| node.is_element() && node.tag_name().name().ends_with("Spectrum")).collect();
        for node in &found {
            let name = name(object, *node, found.len() > 1, file, spectra.len());
            spectra.push(spectrum(*node, name, &ranges, file)?);
            if spectra.len() > MOST_SPECTRA {
                let (file, place) = (file.to_owned(), xml::place(*node));
                let (limit, found) = (MOST_SPECTRA as u64, spectra.len() as u64);
                return Err(ReadError::TooLarge { file, place, limit, unit: "spectra", found });
            }
        }
    }
    if spectra.is_empty() {
        let expected = "an object with spectral values, such as 'ReflectanceSpectrum'";
        return Err(ReadError::malformed(file, xml::place(root), expected, "none"));
    }
    Ok(spectra)
}

/// The first wavelength and the step that a colour specification tells.
type Range = (Option<f64>, Option<f64>);

/// The ranges of all colour specifications, by their names.
fn ranges<'a>(root: Node<'a, '_>, file: &str) -> Result<HashMap<&'a str, Range>, ReadError> {
    let mut ranges = HashMap::new();
    for node in root.descendants().filter(|node| node.tag_name().name() == "ColorSpecification") {
        let range = node.descendants().find(|node| node.tag_name().name() == "WavelengthRange");
        if let (Some(id), Some(range)) = (node.attribute("Id"), range) {
            let range = (xml::attribute(range, "StartWL", file)?, xml::attribute(range, "Increment", file)?);
            ranges.insert(id, range);
        }
    }
    Ok(ranges)
}

/// The name of a spectrum: its object's, or what stands in for it.
fn name(object: Node<'_, '_>, node: Node<'_, '_>, several: bool, file: &str, index: usize) -> String {
    let text = |name: &str| object.attribute(name).map(str::trim).filter(|text| !text.is_empty());
    let name = match text("Name").or(text("Id")) {
        Some(name) => clean(name, MAX_NAME),
        None => format!("{} {}", stem(file), index + 1),
    };
    match node.attribute("Name").or(node.attribute("ColorSpecification")).filter(|_| several) {
        Some(part) => format!("{name} / {}", clean(part, MAX_NAME)),
        None => name,
    }
}

/// Reads the values of one spectrum.
fn spectrum(
    node: Node<'_, '_>,
    name: String,
    ranges: &HashMap<&str, Range>,
    file: &str,
) -> Result<NamedSpectrum, ReadError> {
    let specification = node.attribute("ColorSpecification");
    let (start, step) = specification.and_then(|id| ranges.get(id)).copied().unwrap_or((None, None));
    let start = xml::attribute(node, "StartWL", file)?.or(start);
    let step = xml::attribute(node, "Increment", file)?.or(step);
    let missing = |what: &str| {
        let of = excerpt(specification.unwrap_or(""));
        let expected = format!("{what} here or in the colour specification {of}");
        ReadError::malformed(file, xml::place(node), expected, "none")
    };
    let (start, step) = (start.ok_or_else(|| missing("StartWL"))?, step.ok_or_else(|| missing("Increment"))?);
    if step <= 0.0 {
        return Err(ReadError::malformed(file, xml::place(node), "an Increment above 0", format!("{step}")));
    }
    let quantity = match node.tag_name().name() {
        "ReflectanceSpectrum" => Quantity::Reflectance,
        "TransmittanceSpectrum" => Quantity::Transmittance,
        "EmissiveSpectrum" | "EmissionSpectrum" => Quantity::Light,
        _ => Quantity::Unknown,
    };
    let mut spectrum = NamedSpectrum { name, quantity, ..Default::default() };
    for (index, word) in node.text().unwrap_or("").split_whitespace().enumerate() {
        let nm = Scale::Nanometres.nm(start + step * index as f64, file, || xml::place(node))?;
        spectrum.nm.push(nm);
        spectrum.values.push(expect_number(word, false, file, || xml::place(node))?);
    }
    match spectrum.nm.is_empty() {
        true => Err(ReadError::malformed(file, xml::place(node), "values", "none")),
        false => Ok(spectrum),
    }
}
