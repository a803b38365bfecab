//! Wavefront OBJ: polygons, with materials in MTL files beside them.
//!
//! Read: `v` (also with a colour after the coordinates, taken as sRGB codes), `vt`, `vn`, `f`, `o`, `s`,
//! `usemtl`, `mtllib`. Faces stay polygons. Corners with the same position, texture coordinate and
//! normal become one vertex; there is one mesh per object (`o`) and material. Groups are not kept apart;
//! smoothing groups (`s`) count where a mesh has no normals. Texture coordinates are turned, since OBJ counts v upwards.
//!
//! Numbers of vertices may be negative (from the end) but must name what was read before. That is what an error is for,
//! beside vertices that are no numbers: anything else that is odd is left out or replaced, with a remark.

mod corner;
mod data;
mod libraries;
mod maps;
mod mtl;
mod parts;

use std::io::BufRead;

use glanz_color::read::{ReadError, excerpt};

use super::context::Context;
use super::lines::{Lines, rest, values, words};
use super::model::Model;
use corner::Corner;
use data::Data;
use libraries::Libraries;
use parts::{Added, Parts};

/// The keywords of the format that are known but not used, and what they are.
const IGNORED: &[(&[u8], &str)] = &[
    (b"g", "groups (g) are not kept apart"),
    (b"p", "points (p) are ignored"),
    (b"l", "lines (l) are ignored"),
    (b"mg", "merging groups (mg) are ignored"),
    (b"vp", "free-form geometry is ignored"),
    (b"deg", "free-form geometry is ignored"),
    (b"bmat", "free-form geometry is ignored"),
    (b"step", "free-form geometry is ignored"),
    (b"cstype", "free-form geometry is ignored"),
    (b"curv", "free-form geometry is ignored"),
    (b"curv2", "free-form geometry is ignored"),
    (b"surf", "free-form geometry is ignored"),
    (b"parm", "free-form geometry is ignored"),
    (b"trim", "free-form geometry is ignored"),
    (b"hole", "free-form geometry is ignored"),
    (b"scrv", "free-form geometry is ignored"),
    (b"sp", "free-form geometry is ignored"),
    (b"end", "free-form geometry is ignored"),
    (b"con", "free-form geometry is ignored"),
    (b"ctech", "free-form geometry is ignored"),
    (b"stech", "free-form geometry is ignored"),
    (b"bevel", "display attributes are ignored"),
    (b"c_interp", "display attributes are ignored"),
    (b"d_interp", "display attributes are ignored"),
    (b"lod", "display attributes are ignored"),
    (b"shadow_obj", "display attributes are ignored"),
    (b"trace_obj", "display attributes are ignored"),
    (b"usemap", "texture maps outside of materials are ignored"),
    (b"maplib", "texture maps outside of materials are ignored"),
];

/// The most characters of an object's name, which every one of its meshes carries.
const MAX_NAME: usize = 256;

/// Reads a file.
pub(super) fn read(reader: impl BufRead, context: &mut Context<'_>) -> Result<Model, ReadError> {
    let mut lines = Lines::new(reader, context.file);
    let mut file = File::default();
    while lines.advance_joined()? {
        file.statement(&lines, context)?;
    }
    if file.data.positions.is_empty() {
        let end = || ReadError::malformed(context.file, lines.place(), "vertices (v)", "the end of the file");
        return Err(file.unknown.unwrap_or_else(end));
    }
    file.build(context)
}

/// A file as far as it is read.
#[derive(Default)]
struct File {
    data: Data,
    parts: Parts,
    libraries: Libraries,
    /// What is said of the first line that was not understood, if nothing else was.
    unknown: Option<ReadError>,
}

impl File {
    /// Takes a line in.
    fn statement<R: BufRead>(
        &mut self,
        lines: &Lines<'_, R>,
        context: &mut Context<'_>,
    ) -> Result<(), ReadError> {
        let line = lines.line();
        let Some(keyword) = words(line).next() else { return Ok(()) };
        let (numbers, notes) = (values(line).skip(1), &mut context.notes);
        match keyword {
            b"v" => {
                let vertex = self.data.vertex(numbers, lines.place(), notes);
                vertex.ok_or_else(|| lines.expected("'v' and three finite numbers"))?;
            }
            b"vt" => self.data.texture_coordinate(numbers, lines.place(), notes),
            b"vn" => self.data.normal(numbers, lines.place(), notes),
            b"f" | b"fo" => self.face(lines, context)?,
            b"s" => self.parts.use_smoothing(numbers.into_iter().next().unwrap_or_default()),
            b"o" => self.parts.begin_object(rest(line).chars().take(MAX_NAME).collect()),
            b"usemtl" => self.parts.use_material(rest(line)),
            b"mtllib" => self.libraries.read(line, lines.place(), context)?,
            _ if keyword.starts_with(b"#") => {}
            _ => match ignored(keyword) {
                Some(note) => notes.add(note),
                None => self.unknown(keyword, lines, context),
            },
        }
        Ok(())
    }

    fn face<R: BufRead>(&mut self, lines: &Lines<'_, R>, context: &mut Context<'_>) -> Result<(), ReadError> {
        let (data, notes, place) = (&self.data, &mut context.notes, lines.place());
        let corners = values(lines.line()).skip(1).map(|word| Corner::parse(word, data, &place, notes));
        match self.parts.add_face(corners, data).map_err(|what| lines.expected(what))? {
            Added::Face => {}
            Added::TooFew => {
                context.notes.add_at("faces of fewer than three corners are ignored", place);
            }
            Added::NotFinite => {
                context.notes.add_at("faces with positions that are no finite numbers are left out", place);
            }
        }
        Ok(())
    }

    /// Passes a line over.
    fn unknown<R: BufRead>(&mut self, keyword: &[u8], lines: &Lines<'_, R>, context: &mut Context<'_>) {
        let keyword = excerpt(keyword);
        context.notes.add_kind_at(&format!("OBJ: {keyword}"), lines.place(), || {
            format!(
                "OBJ: lines that begin with {keyword} are not understood: {} is passed over",
                excerpt(lines.line())
            )
        });
        self.unknown.get_or_insert_with(|| lines.expected("a keyword of OBJ such as v, vt, vn or f"));
    }

    /// The model of the parts and the materials that they use.
    fn build(self, context: &mut Context<'_>) -> Result<Model, ReadError> {
        drop(self.data);
        let (meshes, objects, names) = self.parts.finish(&mut context.notes);
        let (materials, textures) = self.libraries.build(&names, context)?;
        if objects.is_empty() {
            context.notes.add("the file holds no faces: nothing can be drawn");
        }
        Ok(Model { meshes, objects, materials, textures, ..Model::default() })
    }
}

/// What is said of a keyword that is known and ignored.
fn ignored(keyword: &[u8]) -> Option<&'static str> {
    IGNORED.iter().find(|(known, _)| *known == keyword).map(|(_, note)| *note)
}

#[cfg(test)]
pub(in crate::read) mod tests;
