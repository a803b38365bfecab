//! Radiance's and WINDOW's XML of a BSDF: matrices over Klems' patches, or tensor trees.
//!
//! A file has up to four parts: light that is reflected or transmitted at the front or at the back. `Reflection Back` is
//! what Radiance takes as the front of a surface, and it is read where it is there.

mod klems;
mod patches;
mod tree;

use roxmltree::{Document, Node};

use super::{Data, Format, Measured, ReadOptions};
use crate::{Channels, ReadError};

pub use klems::{Klems, write_klems};
pub use tree::TensorTree;

/// Whether a text is XML with the element that all these files have. What genBSDF says of itself may stand above it.
pub(super) fn is_radiance(text: &str) -> bool {
    beginning(text).is_some()
}

/// Where the XML begins.
fn beginning(text: &str) -> Option<usize> {
    let element = text.find("<WindowElement")?;
    Some(text[..element].find("<?xml").unwrap_or(element))
}

/// The numbers of a part, for one range of wavelengths.
struct Block<'a, 'input> {
    /// `Visible`, `Solar`, `CIE-X` and so on, or a wavelength.
    wavelength: String,
    /// Where it is a wavelength, in nm.
    nm: Option<f64>,
    is_back: bool,
    node: Node<'a, 'input>,
}

pub(super) fn read(text: &str, options: &ReadOptions) -> Result<Measured, ReadError> {
    let (above, xml) = text.split_at(beginning(text).unwrap_or(0));
    let mut measured = read_xml(xml, options).map_err(|error| match error {
        ReadError::Broken { message, line } => {
            ReadError::Broken { message, line: line.map(|line| line + above.matches('\n').count() as u32) }
        }
        other => other,
    })?;
    if !above.trim().is_empty() {
        measured.notes.push("what stands above the XML was left out".to_owned());
    }
    Ok(measured)
}

fn read_xml(text: &str, options: &ReadOptions) -> Result<Measured, ReadError> {
    let document = Document::parse(text)
        .map_err(|error| ReadError::at(error.pos().row, format!("the XML cannot be read: {error}")))?;
    let quantity = options.quantity.unwrap_or_default();
    let root = document.root_element();
    let definition = element(root, "DataDefinition")?;
    let structure = words(element(definition, "IncidentDataStructure")?);
    let mut notes = Vec::new();
    let (channels, blocks, is_yuv) = chosen(&document, &mut notes)?;
    let (format, data) = match structure.to_lowercase().as_str() {
        "columns" | "rows" => {
            let klems =
                Klems::read(definition, structure.eq_ignore_ascii_case("Rows"), channels, &blocks, quantity)?;
            (Format::Klems, Data::Klems(Box::new(klems.of_yuv(is_yuv))))
        }
        "tensortree3" => (
            Format::TensorTree,
            Data::Tree(Box::new(TensorTree::read(3, channels, &blocks, is_yuv, quantity)?)),
        ),
        "tensortree4" => (
            Format::TensorTree,
            Data::Tree(Box::new(TensorTree::read(4, channels, &blocks, is_yuv, quantity)?)),
        ),
        _ => {
            let expected = "Columns, Rows, TensorTree3 or TensorTree4";
            return Err(at(
                definition,
                format!("IncidentDataStructure must be {expected}, found '{structure}'"),
            ));
        }
    };
    let description =
        root.descendants().find(|node| is(*node, "Name")).map(words).unwrap_or_default().to_owned();
    Ok(Measured { format, quantity, description, data, notes })
}

fn is(node: Node, name: &str) -> bool {
    node.is_element() && node.tag_name().name() == name
}

/// What stands in an element, without space around.
fn words<'a>(node: Node<'a, '_>) -> &'a str {
    node.text().unwrap_or_default().trim()
}

fn element<'a, 'input>(node: Node<'a, 'input>, name: &str) -> Result<Node<'a, 'input>, ReadError> {
    let found = node.descendants().find(|own| is(*own, name));
    found.ok_or_else(|| at(node, format!("there is no element <{name}>")))
}

/// An error at an element.
fn at(node: Node, message: impl Into<String>) -> ReadError {
    ReadError::at(line(node), message)
}

fn line(node: Node) -> u32 {
    node.document().text_pos_at(node.range().start).row
}

/// Where the numbers of a block begin.
fn line_of_text(node: Node) -> u32 {
    node.first_child().map_or_else(|| line(node), line)
}

/// The blocks of reflected light that are read, what their numbers belong to, and whether these are Y, u′ and v′.
fn chosen<'a, 'input>(
    document: &'a Document<'input>,
    notes: &mut Vec<String>,
) -> Result<(Channels, Vec<Block<'a, 'input>>, bool), ReadError> {
    let mut blocks = all(document.root_element())?;
    if blocks.is_empty() {
        return Err(ReadError::broken("the file has no reflected light, and transmitted light is not read"));
    }
    let has_back = blocks.iter().any(|block| block.is_back);
    if has_back && blocks.iter().any(|block| !block.is_back) {
        notes.push("'Reflection Back' is read, Radiance's front; 'Reflection Front' is left out".to_owned());
    }
    blocks.retain(|block| block.is_back == has_back);
    let (channels, order, is_yuv) = order(&blocks).unwrap_or_else(|| {
        notes.push(format!("the numbers are those of '{}'", blocks[0].wavelength));
        (Channels::Luminance, vec![0], false)
    });
    let mut left: Vec<&str> =
        (0..blocks.len()).filter(|i| !order.contains(i)).map(|i| blocks[i].wavelength.as_str()).collect();
    left.dedup();
    if !left.is_empty() {
        notes.push(format!("left out: {}", left.join(", ")));
    }
    let mut blocks: Vec<Option<Block>> = blocks.into_iter().map(Some).collect();
    let chosen = order.into_iter().filter_map(|i| blocks[i].take()).collect();
    Ok((channels, chosen, is_yuv))
}

/// The channels that are read and their blocks, and whether these are Y, u′ and v′; nothing where no block is of visible
/// light or of a wavelength.
fn order(blocks: &[Block]) -> Option<(Channels, Vec<usize>, bool)> {
    let named = |names: &[&str]| -> Option<Vec<usize>> {
        let find = |name: &&str| blocks.iter().position(|block| block.wavelength.eq_ignore_ascii_case(name));
        names.iter().map(find).collect()
    };
    if let Some(order) = named(&["CIE-X", "Visible", "CIE-Z"]) {
        return Some((Channels::Xyz, order, false));
    }
    if let Some(order) = named(&["Visible", "CIE-u", "CIE-v"]) {
        return Some((Channels::Xyz, order, true));
    }
    if let Some(order) = named(&["Visible"]) {
        return Some((Channels::Luminance, order, false));
    }
    let mut list: Vec<(f64, usize)> =
        blocks.iter().enumerate().filter_map(|(i, block)| Some((block.nm?, i))).collect();
    list.sort_by(|a, b| a.0.total_cmp(&b.0));
    list.dedup_by(|a, b| a.0.total_cmp(&b.0).is_eq());
    let (nm, order) = list.into_iter().unzip::<f64, usize, Vec<f64>, Vec<usize>>();
    (!nm.is_empty()).then_some((Channels::Wavelengths(nm), order, false))
}

/// All blocks of reflected light.
fn all<'a, 'input>(root: Node<'a, 'input>) -> Result<Vec<Block<'a, 'input>>, ReadError> {
    let mut blocks = Vec::new();
    for data in root.descendants().filter(|node| is(*node, "WavelengthData")) {
        let wavelength = element(data, "Wavelength")?;
        let scale = match wavelength.attribute("unit").unwrap_or_default().to_lowercase().as_str() {
            unit if unit.starts_with("nano") || unit == "nm" => Some(1.0),
            unit if unit.starts_with("micro") || unit == "um" => Some(1000.0),
            _ => None,
        };
        let number = words(wavelength).parse::<f64>().ok().filter(|nm| nm.is_finite());
        for node in data.children().filter(|node| is(*node, "WavelengthDataBlock")) {
            let direction = words(element(node, "WavelengthDataDirection")?).to_lowercase();
            if direction.starts_with("reflection") {
                blocks.push(Block {
                    wavelength: words(wavelength).to_owned(),
                    nm: scale.zip(number).map(|(scale, number)| scale * number),
                    is_back: direction.ends_with("back"),
                    node,
                });
            }
        }
    }
    Ok(blocks)
}

/// X, Y and Z of Y and the chromaticity u′, v′ (CIE 1976).
fn xyz_of_yuv([y, u, v]: [f64; 3]) -> [f64; 3] {
    let scale = if v > 0.0 { y / (4.0 * v) } else { 0.0 };
    [9.0 * u * scale, y, (12.0 - 3.0 * u - 20.0 * v) * scale]
}
