//! STL: triangles without connection, as text or binary; their content tells which.
//!
//! Corners at equal positions become one vertex, so that smooth normals are possible. The facet normals of the file are
//! not used: they follow from the corners, and files often leave them zero. Facets that meet at less than 30° are
//! smooth, and where one of their flat faces is much larger than the others, it keeps its normal to its rim. The two
//! bytes after each binary facet are read as colours, where they are some.

mod binary;
mod text;
mod weld;

use std::io::{self, BufRead, Read};

use glanz_color::read::{Place, ReadError};

use super::context::Context;
use super::finish::finish_mesh;
use super::model::Model;
use crate::{Material, Object};
use weld::Weld;

/// The bytes of the header of a binary file, with the number of facets at its end.
const HEADER: usize = 84;
/// The bytes of a binary facet: normal, three corners, two bytes.
const FACET: usize = 50;
/// What is said of facets that are left out.
const NOT_FINITE: &str = "facets with positions that are no finite numbers are left out";
/// How far into a file it is looked for what tells text from bytes.
const HEAD: usize = 512;
/// Facets that meet at this angle, in radians (30°), or a greater one have a sharp edge between them.
const CREASE: f64 = core::f64::consts::FRAC_PI_6;

/// Reads a file of `len` bytes.
pub(super) fn read(
    mut reader: impl BufRead,
    len: u64,
    context: &mut Context<'_>,
) -> Result<Model, ReadError> {
    let mut head = Vec::with_capacity(HEAD);
    (&mut reader).take(HEAD as u64).read_to_end(&mut head).map_err(|error| io_error(context.file, error))?;
    let is_binary = is_binary(&head, len);
    let reader = io::Cursor::new(&head).chain(reader);
    let solids = match is_binary {
        true => vec![binary::read(reader, &head, len, context)?],
        false => text::read(reader, context)?,
    };
    let (mut meshes, mut objects) = (Vec::new(), Vec::new());
    for Weld { mut mesh, anchor, .. } in solids {
        if is_binary {
            anchor.tell_of_steps(&mesh, &mut context.notes);
        }
        finish_mesh(&mut mesh, &mut context.notes);
        objects.push(Object {
            name: mesh.name.clone(),
            mesh: meshes.len(),
            material: 0,
            transform: anchor.transform(),
            shading: None,
            interpolation: None,
            program: None,
        });
        meshes.push(mesh.with_normals_of_flat_faces(CREASE));
    }
    context.notes.add("STL holds neither unit nor upward direction: taken as metres, +Y up");
    context.notes.add("STL holds no vertex normals: facets that meet at less than 30° are smooth");
    Ok(Model { objects, meshes, materials: vec![Material::default_gray()], ..Model::default() })
}

fn io_error(file: &str, source: io::Error) -> ReadError {
    ReadError::Io { file: file.to_owned(), place: Place::File, source }
}

/// Whether the file is binary: its length fits the count, or its first bytes are not those of a text.
fn is_binary(head: &[u8], len: u64) -> bool {
    let fits = binary::claimed(head).is_some_and(|count| len == HEADER as u64 + FACET as u64 * count);
    // Some binary files begin with "solid", too; bytes that no text has give them away.
    fits || head.contains(&0) || !text::begins(head)
}

/// The printable beginning of a name.
fn name_of(name: &[u8]) -> String {
    let text: Vec<u8> = name.iter().copied().take_while(|byte| (0x20..0x7f).contains(byte)).collect();
    String::from_utf8_lossy(text.trim_ascii()).into_owned()
}

#[cfg(test)]
pub(in crate::read) mod tests;
