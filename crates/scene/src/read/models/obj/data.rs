//! The vertex data of a file.

use glam::{DVec3, Vec2, Vec3};
use glanz_color::read::Place;
use glanz_color::srgb_decode;

use super::super::lines::{coordinate, real};
use crate::read::notes::Notes;

/// The vertex data of the whole file, which faces refer to.
#[derive(Default)]
pub(super) struct Data {
    /// Those that are no numbers are NaN: no face may use them.
    pub(super) positions: Vec<DVec3>,
    /// Empty until a vertex has a colour.
    pub(super) colors: Vec<Vec3>,
    pub(super) uvs: Vec<Vec2>,
    /// Of length zero where the file has none.
    pub(super) normals: Vec<Vec3>,
}

impl Data {
    /// `x y z`, `x y z w` or `x y z r g b`; `None` where these are no numbers.
    pub(super) fn vertex<'a>(
        &mut self,
        mut words: impl Iterator<Item = &'a [u8]>,
        place: Place,
        notes: &mut Notes,
    ) -> Option<()> {
        let mut next = || words.next().and_then(coordinate);
        let position = DVec3::new(next()?, next()?, next()?);
        let more: Vec<f32> = words.by_ref().map_while(real).take(4).collect();
        if words.next().is_some() {
            notes.add_at("OBJ: what follows the numbers of a vertex is ignored", place.clone());
        }
        if more.len() >= 3 {
            // Vertices before the first coloured one are white.
            self.colors.resize(self.positions.len(), Vec3::ONE);
            self.colors.push(color([more[0], more[1], more[2]], place, notes));
        } else if !self.colors.is_empty() {
            self.colors.push(Vec3::ONE);
        }
        let is_held = position.as_vec3().is_finite();
        self.positions.push(if is_held { position } else { DVec3::NAN });
        Some(())
    }

    /// `u`, `u v` or `u v w`.
    pub(super) fn texture_coordinate<'a>(
        &mut self,
        mut words: impl Iterator<Item = &'a [u8]>,
        place: Place,
        notes: &mut Notes,
    ) {
        let u = words.next().and_then(real);
        let v = words.next().map_or(Some(0.0), real);
        let uv = u.zip(v).map(|(u, v)| Vec2::new(u, v)).filter(|uv| uv.is_finite());
        if uv.is_none() {
            notes.add_at("OBJ: texture coordinates that are no finite numbers are taken as 0", place);
        }
        let uv = uv.unwrap_or(Vec2::ZERO);
        // OBJ counts v from the bottom, textures are stored from the top.
        self.uvs.push(Vec2::new(uv.x, 1.0 - uv.y));
    }

    /// `x y z`.
    pub(super) fn normal<'a>(
        &mut self,
        mut words: impl Iterator<Item = &'a [u8]>,
        place: Place,
        notes: &mut Notes,
    ) {
        let normal = three(&mut words).filter(|normal| normal.is_finite());
        if normal.is_none() {
            notes.add_at("OBJ: normals that are no finite numbers are computed from the faces", place);
        }
        self.normals.push(normal.unwrap_or(Vec3::ZERO));
    }
}

fn three<'a>(words: &mut impl Iterator<Item = &'a [u8]>) -> Option<Vec3> {
    let mut next = || words.next().and_then(real);
    Some(Vec3::new(next()?, next()?, next()?))
}

/// A colour from sRGB codes.
fn color(codes: [f32; 3], place: Place, notes: &mut Notes) -> Vec3 {
    if !codes.iter().all(|code| code.is_finite()) {
        notes.add_at("OBJ: colours of vertices that are no finite numbers are taken as white", place);
        return Vec3::ONE;
    }
    if !codes.iter().all(|code| (0.0..=1.0).contains(code)) {
        notes.add_at("OBJ: colours of vertices beyond 0 to 1 are taken as 0 or 1", place);
    }
    Vec3::from(codes.map(|code| srgb_decode(code.clamp(0.0, 1.0))))
}
