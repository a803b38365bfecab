//! XML, bounded.

use roxmltree::{Document, Node, ParsingOptions};

use crate::file::read::error::excerpt;
use crate::file::read::text::expect_number;
use crate::file::read::{Place, ReadError};

/// The most elements and texts of a file.
const MOST_NODES: u32 = 1 << 20;
/// The most attributes of an element, and namespaces of a file. The parser compares each with all others.
const MOST_ATTRIBUTES: usize = 256;

/// Parses XML without document types, whose entities could grow without bound.
pub(in crate::file::read) fn parse<'a>(text: &'a str, file: &str) -> Result<Document<'a>, ReadError> {
    check_attributes(text, file)?;
    let options = ParsingOptions { allow_dtd: false, nodes_limit: MOST_NODES, ..ParsingOptions::default() };
    Document::parse_with_options(text, options).map_err(|error| {
        let at = error.pos();
        let place = Place::Column { line: at.row.into(), column: at.col.into() };
        ReadError::malformed(file, place, "well-formed XML", error.to_string())
    })
}

/// Refuses elements with very many attributes, and files with very many namespaces, before the parser
/// sees them: an attribute needs a `=`, and no `<` can be within one.
fn check_attributes(text: &str, file: &str) -> Result<(), ReadError> {
    let most = |count: usize, unit: &'static str| {
        let (file, limit, found) = (file.to_owned(), MOST_ATTRIBUTES as u64, count as u64);
        if count <= MOST_ATTRIBUTES {
            return Ok(());
        }
        Err(ReadError::TooLarge { file, place: Place::File, limit, unit, found })
    };
    most(text.matches("xmlns").count(), "namespaces")?;
    for tag in text.split('<').filter(|tag| !tag.starts_with(['!', '?'])) {
        most(tag.bytes().filter(|byte| *byte == b'=').count(), "attributes of an element")?;
    }
    Ok(())
}

/// The place where an element begins.
pub(in crate::file::read) fn place(node: Node<'_, '_>) -> Place {
    let at = node.document().text_pos_at(node.range().start);
    Place::Column { line: at.row.into(), column: at.col.into() }
}

/// The root element, which must have this name in whatever namespace.
pub(in crate::file::read) fn root<'a>(
    document: &'a Document<'_>,
    name: &str,
    file: &str,
) -> Result<Node<'a, 'a>, ReadError> {
    let root = document.root_element();
    match root.tag_name().name() {
        found if found == name => Ok(root),
        found => Err(ReadError::malformed(file, place(root), format!("an element '{name}'"), excerpt(found))),
    }
}

/// The child elements of this name, in whatever namespace.
pub(in crate::file::read) fn children<'a, 'b>(
    node: Node<'a, 'b>,
    name: &'static str,
) -> impl Iterator<Item = Node<'a, 'b>> {
    node.children().filter(move |child| child.is_element() && child.tag_name().name() == name)
}

/// The text of the first child element of this name, without blanks around it.
pub(in crate::file::read) fn child_text<'a>(node: Node<'a, '_>, name: &'static str) -> Option<&'a str> {
    children(node, name).next()?.text().map(str::trim).filter(|text| !text.is_empty())
}

/// The number in an attribute, if it is there.
pub(in crate::file::read) fn attribute(
    node: Node<'_, '_>,
    name: &str,
    file: &str,
) -> Result<Option<f64>, ReadError> {
    node.attribute(name).map(|text| expect_number(text, false, file, || place(node))).transpose()
}
