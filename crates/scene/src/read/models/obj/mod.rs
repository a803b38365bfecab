//! Wavefront OBJ: polygons, with materials in MTL files beside them.
//!
//! Read: `v` (also with a colour after the coordinates, taken as sRGB codes), `vt`, `vn`, `f`, `o`,
//! `usemtl`, `mtllib`. Faces stay polygons. Corners with the same position, texture coordinate and
//! normal become one vertex; there is one mesh per object (`o`) and material. Groups and smoothing
//! groups are not kept apart. Texture coordinates are turned, since OBJ counts v upwards.
//!
//! Numbers of vertices may be negative (from the end) but must name what was read before.

mod data;
mod mtl;
mod parts;

use std::collections::HashMap;
use std::io::BufRead;

use glam::{Vec2, Vec3};
use glanz_color::read::{Place, ReadError};
use glanz_color::srgb_decode;

use super::context::Context;
use super::lines::{Lines, float, rest, words};
use super::model::Model;
use crate::read::ResolveError;
use data::Data;
use mtl::Library;
use parts::{Corner, NONE, Parts};

/// The keywords of the format that are known but not used, and what they are.
const IGNORED: &[(&[u8], &str)] = &[
    (b"g", "groups (g) are not kept apart"),
    (b"s", "smoothing groups (s) are ignored"),
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
    let (mut data, mut parts) = (Data::default(), Parts::default());
    let (mut library, mut libraries) = (Library::default(), HashMap::new());
    while lines.advance_joined()? {
        let mut words = words(lines.line());
        let Some(keyword) = words.next() else { continue };
        match keyword {
            b"v" => vertex(words, &mut data).ok_or_else(|| lines.expected("'v' and three finite numbers"))?,
            b"vt" => {
                let uv = texture_coordinate(words);
                data.uvs.push(uv.ok_or_else(|| lines.expected("'vt' and one to three finite numbers"))?);
            }
            b"vn" => {
                let normal = three(&mut words);
                data.normals.push(normal.ok_or_else(|| lines.expected("'vn' and three finite numbers"))?);
            }
            b"f" | b"fo" => {
                let corners = words.map(|word| corner(word, &data));
                let added = parts.add_face(corners, &data).map_err(|what| lines.expected(what))?;
                context.notes.add_times("faces of fewer than three corners are ignored", u64::from(!added));
            }
            b"o" => parts.begin_object(rest(lines.line()).chars().take(MAX_NAME).collect()),
            b"usemtl" => parts.use_material(rest(lines.line())),
            b"mtllib" => {
                read_libraries(lines.line(), lines.place(), &mut library, &mut libraries, context)?;
            }
            _ if keyword.starts_with(b"#") => {}
            _ => {
                let expected = || lines.expected("a keyword of OBJ such as v, vt, vn or f");
                context.notes.add(ignored(keyword).ok_or_else(expected)?);
            }
        }
    }
    if data.positions.is_empty() {
        return Err(ReadError::malformed(context.file, lines.place(), "vertices (v)", "the end of the file"));
    }
    drop(data);
    build(parts, library, context)
}

/// What is said of a keyword that is known and ignored.
fn ignored(keyword: &[u8]) -> Option<&'static str> {
    IGNORED.iter().find(|(known, _)| *known == keyword).map(|(_, note)| *note)
}

/// The model of the parts and the materials that they use.
fn build(parts: Parts, library: Library, context: &mut Context<'_>) -> Result<Model, ReadError> {
    let (meshes, objects, names) = parts.finish(&mut context.notes);
    let (materials, textures) = library.build(&names, context)?;
    if objects.is_empty() {
        context.notes.add("the file holds no faces: nothing can be drawn");
    }
    Ok(Model { meshes, objects, materials, textures, ..Model::default() })
}

fn three<'a>(words: &mut impl Iterator<Item = &'a [u8]>) -> Option<Vec3> {
    let mut next = || words.next().and_then(float);
    Some(Vec3::new(next()?, next()?, next()?))
}

/// `x y z`, `x y z w` or `x y z r g b`.
fn vertex<'a>(mut words: impl Iterator<Item = &'a [u8]>, data: &mut Data) -> Option<()> {
    let position = three(&mut words)?;
    let (mut more, mut count) = ([0.0; 4], 0);
    for word in words {
        *more.get_mut(count)? = float(word)?;
        count += 1;
    }
    if count >= 3 {
        // Vertices before the first coloured one are white.
        data.colors.resize(data.positions.len(), Vec3::ONE);
        let [r, g, b, _] = more.map(|code| srgb_decode(code.clamp(0.0, 1.0)));
        data.colors.push(Vec3::new(r, g, b));
    } else if !data.colors.is_empty() {
        data.colors.push(Vec3::ONE);
    }
    data.positions.push(position);
    Some(())
}

fn texture_coordinate<'a>(mut words: impl Iterator<Item = &'a [u8]>) -> Option<Vec2> {
    let u = float(words.next()?)?;
    let v = words.next().map_or(Some(0.0), float)?;
    // OBJ counts v from the bottom, textures are stored from the top.
    Some(Vec2::new(u, 1.0 - v))
}

/// A corner of a face: `v`, `v/vt`, `v//vn` or `v/vt/vn`.
fn corner(word: &[u8], data: &Data) -> Result<Corner, String> {
    let mut fields = word.split(|byte| *byte == b'/');
    let position = index(fields.next().unwrap_or_default(), data.positions.len(), "v")?;
    let mut optional = |len, keyword| match fields.next() {
        None | Some(b"") => Ok(NONE),
        Some(field) => index(field, len, keyword),
    };
    let uv = optional(data.uvs.len(), "vt")?;
    let normal = optional(data.normals.len(), "vn")?;
    match fields.next() {
        None => Ok(Corner { position, uv, normal }),
        Some(_) => Err("at most three numbers in a corner".to_owned()),
    }
}

/// The index, from zero, that a field names: from 1 on, or from −1 backwards.
fn index(field: &[u8], len: usize, keyword: &str) -> Result<u32, String> {
    let (negative, digits) = match field.strip_prefix(b"-") {
        Some(digits) => (true, digits),
        None => (false, field.strip_prefix(b"+").unwrap_or(field)),
    };
    let value = (!digits.is_empty()).then_some(()).and_then(|()| {
        digits.iter().try_fold(0usize, |value, digit| {
            let digit = digit.is_ascii_digit().then(|| usize::from(digit - b'0'))?;
            value.checked_mul(10)?.checked_add(digit)
        })
    });
    let index = match (value, negative) {
        (Some(value), false) => value.checked_sub(1),
        (Some(value @ 1..), true) => len.checked_sub(value),
        _ => None,
    };
    match index.filter(|&index| index < len.min(NONE as usize)) {
        Some(index) => Ok(index as u32),
        None => Err(format!("the number of one of the {len} {keyword} lines before")),
    }
}

/// Reads the files that an `mtllib` line names: one name with spaces in it, or several.
fn read_libraries(
    line: &[u8],
    place: Place,
    library: &mut Library,
    known: &mut HashMap<String, bool>,
    context: &mut Context<'_>,
) -> Result<(), ReadError> {
    let whole = rest(line);
    if whole.is_empty() || read_library(&whole, &place, library, known, context)? {
        return Ok(());
    }
    for name in whole.split_ascii_whitespace() {
        if !read_library(name, &place, library, known, context)? {
            context.notes.add(&format!("the material file '{name}' is missing"));
        }
    }
    Ok(())
}

/// Reads a material file, once; `false` if it is missing.
fn read_library(
    name: &str,
    place: &Place,
    library: &mut Library,
    known: &mut HashMap<String, bool>,
    context: &mut Context<'_>,
) -> Result<bool, ReadError> {
    if let Some(found) = known.get(name) {
        return Ok(*found);
    }
    if known.len() >= mtl::MAX_LIBRARIES {
        let (file, limit, found) =
            (context.file.to_owned(), mtl::MAX_LIBRARIES as u64, known.len() as u64 + 1);
        return Err(ReadError::TooLarge { file, place: place.clone(), limit, unit: "material files", found });
    }
    let found = match context.resolver.read(name) {
        Ok(bytes) => library.read(&bytes, name, context).map(|()| true)?,
        Err(ResolveError::Missing) => false,
        Err(error) => return Err(error.at(context.file, place.clone(), name)),
    };
    known.insert(name.to_owned(), found);
    Ok(found)
}

#[cfg(test)]
pub(in crate::read) mod tests;
