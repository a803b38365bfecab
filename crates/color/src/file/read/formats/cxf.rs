//! Spectral values of CxF3 (ISO 17972-1), the XML of colour exchange: `.cxf`.
//!
//! Every element `…Spectrum` of an object's `ColorValues` is a spectrum: its first wavelength is
//! its own `StartWL` or that of the colour specification it refers to, the step that specification's
//! `Increment`; a `CustomSpectrum` has a wavelength at each value, and is what the specification's `MeasurementType` says. It is named by its object; if an object has several, by its specification too.

use super::xml;
use crate::file::read::error::{clean, excerpt};
use crate::file::read::named::note;
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
    let specifications = specifications(root, file)?;
    let mut spectra = Vec::new();
    for object in root.descendants().filter(|node| node.tag_name().name() == "Object") {
        let values = xml::children(object, "ColorValues").flat_map(|values| values.children());
        let found: Vec<Node<'_, '_>> =
            values.filter(|node| node.is_element() && node.tag_name().name().ends_with("Spectrum")).collect();
        for node in &found {
            let name = name(object, *node, found.len() > 1, file, spectra.len());
            spectra.push(spectrum(*node, name, &specifications, file)?);
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

/// What a colour specification tells of its spectra.
#[derive(Clone, Copy, Default)]
struct Specification {
    /// The first wavelength.
    start: Option<f64>,
    step: Option<f64>,
    quantity: Quantity,
}

/// All colour specifications, by their names.
fn specifications<'a>(root: Node<'a, '_>, file: &str) -> Result<HashMap<&'a str, Specification>, ReadError> {
    let mut found = HashMap::new();
    for node in root.descendants().filter(|node| node.tag_name().name() == "ColorSpecification") {
        let Some(id) = node.attribute("Id") else { continue };
        let part = |name: &str| node.descendants().find(|node| node.tag_name().name() == name);
        let mut told = Specification::default();
        if let Some(range) = part("WavelengthRange") {
            told.start = xml::attribute(range, "StartWL", file)?;
            told.step = xml::attribute(range, "Increment", file)?;
        }
        told.quantity = match part("MeasurementType").and_then(|node| node.text()).map(str::trim) {
            Some("Spectrum_Reflectance") => Quantity::Reflectance,
            Some("Spectrum_Transmittance" | "Spectrum_TotalTransmittance") => Quantity::Transmittance,
            Some("Spectrum_Emissive") => Quantity::Light,
            _ => Quantity::Unknown,
        };
        found.insert(id, told);
    }
    Ok(found)
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
    specifications: &HashMap<&str, Specification>,
    file: &str,
) -> Result<NamedSpectrum, ReadError> {
    let id = node.attribute("ColorSpecification");
    let told = id.and_then(|id| specifications.get(id)).copied().unwrap_or_default();
    let quantity = match node.tag_name().name() {
        "ReflectanceSpectrum" => Quantity::Reflectance,
        "TransmittanceSpectrum" => Quantity::Transmittance,
        "EmissiveSpectrum" | "EmissionSpectrum" => Quantity::Light,
        _ => told.quantity,
    };
    let mut spectrum = NamedSpectrum { name, quantity, ..Default::default() };
    let points = match node.tag_name().name() {
        "CustomSpectrum" => points(node, file, &mut spectrum.notes)?,
        _ => steps(node, told, file)?,
    };
    (spectrum.nm, spectrum.values) = points.into_iter().unzip();
    match spectrum.nm.is_empty() {
        true => Err(ReadError::malformed(file, xml::place(node), "values", "none")),
        false => Ok(spectrum),
    }
}

/// Values at equal steps of wavelength.
fn steps(node: Node<'_, '_>, told: Specification, file: &str) -> Result<Vec<(f64, f64)>, ReadError> {
    let start = xml::attribute(node, "StartWL", file)?.or(told.start);
    let step = xml::attribute(node, "Increment", file)?.or(told.step);
    let missing = |what: &str| {
        let of = excerpt(node.attribute("ColorSpecification").unwrap_or(""));
        let expected = format!("{what} here or in the colour specification {of}");
        ReadError::malformed(file, xml::place(node), expected, "none")
    };
    let (start, step) = (start.ok_or_else(|| missing("StartWL"))?, step.ok_or_else(|| missing("Increment"))?);
    if step <= 0.0 {
        return Err(ReadError::malformed(file, xml::place(node), "an Increment above 0", format!("{step}")));
    }
    let words = node.text().unwrap_or("").split_whitespace().enumerate();
    let point = |(index, word): (usize, &str)| {
        let nm = Scale::Nanometres.nm(start + step * index as f64, file, || xml::place(node))?;
        Ok((nm, expect_number(word, false, file, || xml::place(node))?))
    };
    words.map(point).collect()
}

/// The points of a `CustomSpectrum`, each with its wavelength, in any order; of a wavelength that stands there more than once, the
/// mean of its values.
fn points(node: Node<'_, '_>, file: &str, notes: &mut Vec<String>) -> Result<Vec<(f64, f64)>, ReadError> {
    let mut points: Vec<(f64, f64)> = Vec::new();
    for point in xml::children(node, "SpectralPoint") {
        let place = || xml::place(point);
        let nm = xml::attribute(point, "WL", file)?
            .ok_or_else(|| ReadError::malformed(file, place(), "an attribute 'WL'", "none"))?;
        let nm = Scale::Nanometres.nm(nm, file, place)?;
        points.push((nm, expect_number(point.text().unwrap_or("").trim(), false, file, place)?));
    }
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let count = points.len();
    let groups = points.chunk_by(|a, b| a.0 == b.0);
    let mean = |group: &[(f64, f64)]| group.iter().map(|point| point.1).sum::<f64>() / group.len() as f64;
    let merged: Vec<_> = groups.map(|group| (group[0].0, mean(group))).collect();
    if merged.len() < count {
        let twice = count - merged.len();
        note(
            notes,
            format!("{twice} wavelengths stand there more than once: the mean of their values is taken"),
        );
    }
    Ok(merged)
}
