//! MTL: the materials of OBJ files.
//!
//! `Ka`, `Kd`, `Ks`, `Ke` (linear RGB, or `xyz`), `Ns`, `d` or `Tr`, `illum`, `map_Kd`, `map_Ke`, `map_d`, `norm` and
//! `map_Bump` become a classic material. The highlight of illumination model 2 is Blinn's: the
//! format defines it by the half vector. Models 0 and 1 have no highlight; those above 2, which ask
//! for reflections, are taken as 2. So has none an exponent below 1, which would paint the whole surface. `d` says the
//! opacity; without it, 1 − `Tr` does, but a `Tr` of 1 is taken as opaque, which programs that write it mean. A
//! `map_Bump` is of heights, which become normals, unless it looks like the normals that many programs write there.
//!
//! A statement that makes no sense is passed over, with a remark.

use std::collections::BTreeMap;
use std::rc::Rc;

use glanz_color::Rgb;
use glanz_color::models::RgbSpace;
use glanz_color::read::{Place, ReadError, excerpt};

use super::super::context::Context;
use super::super::lines::{Lines, float, rest, values, without_comment, words};
use super::maps::{Map, Pictures, Use};
use crate::read::notes::Notes;
use crate::{AlphaMode, ClassicMaterial, Material, Texture, Tint};

/// The least exponent of a highlight: below it is as wide as the surface.
const MIN_SHININESS: f64 = 1.0;
/// The greatest exponent that the shapes take.
const MAX_SHININESS: f64 = 1e5;

/// The materials of all MTL files of an OBJ file.
#[derive(Default)]
pub(super) struct Library {
    definitions: BTreeMap<String, Definition>,
}

/// A `newmtl` block.
#[derive(Clone)]
struct Definition {
    block: ClassicMaterial,
    /// `d`: the opacity.
    dissolve: Option<f32>,
    /// `Tr`: 1 less the opacity, or the opacity.
    transparency: Option<f32>,
    illumination: f32,
    base_color: Option<Map>,
    opacity: Option<Map>,
    normal: Option<Map>,
    /// Whether `normal` comes from `map_Bump`, which may hold heights.
    bump: bool,
    emission: Option<Map>,
}

impl Default for Definition {
    fn default() -> Self {
        // The initial values that the format gives, where it gives any.
        let block = ClassicMaterial {
            ambient: Rgb::gray(0.2).into(),
            diffuse: Rgb::gray(0.8).into(),
            shininess: 0.0,
            model: "blinn-phong".to_owned(),
            ..ClassicMaterial::default()
        };
        let (dissolve, transparency) = (None, None);
        let (base_color, opacity, normal, emission) = (None, None, None, None);
        let (illumination, bump) = (2.0, false);
        Self { block, dissolve, transparency, illumination, base_color, opacity, normal, bump, emission }
    }
}

impl Library {
    /// Adds the materials of an MTL file.
    pub(super) fn read(
        &mut self,
        bytes: &[u8],
        file: &str,
        context: &mut Context<'_>,
    ) -> Result<(), ReadError> {
        let mut lines = Lines::new(bytes, file);
        let shared: Rc<str> = file.into();
        let mut current: Option<(String, Definition)> = None;
        while lines.advance_joined()? {
            let Some(keyword) = words(lines.line()).next() else { continue };
            if keyword == b"newmtl" {
                let begun = (rest(lines.line()), Definition::default());
                self.definitions.extend(current.replace(begun));
            } else if !keyword.starts_with(b"#") {
                match &mut current {
                    Some((_, definition)) => definition.take(&lines, &shared, &mut context.notes),
                    None => context
                        .notes
                        .add_at("MTL: lines before the first 'newmtl' are ignored", lines.place()),
                }
            }
        }
        self.definitions.extend(current);
        Ok(())
    }

    /// The materials of these names, the default one for `None`, and their textures.
    pub(super) fn build(
        self,
        names: &[Option<String>],
        context: &mut Context<'_>,
    ) -> Result<(Vec<Material>, Vec<Texture>), ReadError> {
        let mut pictures = Pictures::new(context.options.memory);
        let mut materials = Vec::with_capacity(names.len());
        for name in names {
            materials.push(match name.as_ref().and_then(|name| self.find(name)) {
                Some((name, definition)) => definition.build(name, &mut pictures, context)?,
                None => {
                    if let Some(name) = name {
                        context.notes.add(&format!("material '{name}' is not defined; the default is used"));
                    }
                    Material::default_gray()
                }
            });
        }
        Ok((materials, pictures.textures))
    }

    /// The material of this name; what looks like a comment behind either name counts only if it must.
    fn find(&self, name: &str) -> Option<(&String, &Definition)> {
        let plain = without_comment(name).unwrap_or(name);
        let exact = self.definitions.get_key_value(name).or_else(|| self.definitions.get_key_value(plain));
        exact.or_else(|| self.definitions.iter().find(|(known, _)| without_comment(known) == Some(plain)))
    }
}

impl Definition {
    /// Takes a line in, or says that it cannot be understood.
    fn take(&mut self, lines: &Lines<'_, &[u8]>, file: &Rc<str>, notes: &mut Notes) {
        let keyword = words(lines.line()).next().unwrap_or_default().to_ascii_lowercase();
        let place = || Place::Path(format!("{file}, {}", lines.place()));
        if self.statement(&keyword, lines, file, notes).is_none() {
            let key = format!("MTL: {}", excerpt(&keyword));
            notes.add_kind_at(&key, place(), || {
                format!("MTL: {} is not understood and passed over", excerpt(lines.line()))
            });
        }
    }

    /// Takes a statement in; `None` if its values are not what they must be.
    fn statement(
        &mut self,
        keyword: &[u8],
        lines: &Lines<'_, &[u8]>,
        file: &Rc<str>,
        notes: &mut Notes,
    ) -> Option<()> {
        let mut words = values(lines.line()).skip(1);
        let halo = words.clone().next() == Some(b"-halo");
        let mut value = || words.next().and_then(float);
        let map = || Map::parse(lines, file);
        match keyword {
            b"ka" => self.block.ambient = color(lines, notes)?.into(),
            b"kd" => self.block.diffuse = color(lines, notes)?.into(),
            b"ks" => self.block.specular = color(lines, notes)?.into(),
            b"ke" => self.block.emission = color(lines, notes)?.into(),
            b"ns" => self.block.shininess = f64::from(value()?).clamp(0.0, MAX_SHININESS),
            b"tr" => self.transparency = Some(value()?.clamp(0.0, 1.0)),
            b"d" if halo => notes.add("MTL: 'd -halo' is ignored"),
            b"d" => self.dissolve = Some(value()?.clamp(0.0, 1.0)),
            b"illum" => self.illumination = value()?,
            b"map_kd" => self.base_color = Some(map()?),
            b"map_ke" => self.emission = Some(map()?),
            b"map_d" => self.opacity = Some(map()?),
            b"norm" | b"map_kn" => (self.normal, self.bump) = (Some(map()?), false),
            b"map_bump" | b"bump" if self.normal.is_none() => (self.normal, self.bump) = (Some(map()?), true),
            b"map_bump" | b"bump" | b"ni" => {}
            other => {
                let name = String::from_utf8_lossy(&other[..other.len().min(16)]).into_owned();
                notes.add(&format!("MTL: '{name}' is ignored"));
            }
        }
        Some(())
    }

    fn build(
        &self,
        name: &str,
        pictures: &mut Pictures,
        context: &mut Context<'_>,
    ) -> Result<Material, ReadError> {
        let mut block = self.block.clone();
        block.specular = self.highlight(name, &mut context.notes);
        if self.base_color.is_some() && block.diffuse.is_black() {
            let note =
                "MTL: 'Kd 0 0 0' beside 'map_Kd' would leave nothing of the picture: it is taken as 1 1 1";
            context.notes.add_at(note, of_material(name));
            block.diffuse = Rgb::gray(1.0).into();
        }
        if self.emission.is_some() && block.emission.is_black() {
            block.emission = Rgb::gray(1.0).into();
        }
        let mut material = block.build(name).expect("the shape and its exponent were chosen within range");
        let (base, masked) =
            pictures.load_with_opacity(self.base_color.as_ref(), self.opacity.as_ref(), context)?;
        material.base_color = base;
        material.emission_map = pictures.load(self.emission.as_ref(), Use::Color, context)?;
        let normals = if self.bump { Use::Bump } else { Use::Numbers };
        material.normal_map = pictures.load(self.normal.as_ref(), normals, context)?;
        material.opacity = self.alpha(name, &mut context.notes);
        if material.opacity < 1.0 || masked {
            material.alpha_mode = AlphaMode::Blend;
        }
        Ok(material)
    }

    /// The tint of the highlight, black where there is none.
    fn highlight(&self, name: &str, notes: &mut Notes) -> Tint {
        if self.illumination == 0.0 {
            notes.add("MTL: illumination model 0 (plain colour) is taken as 1 (diffuse)");
        } else if self.illumination > 2.0 {
            notes.add("MTL: illumination models above 2 are taken as 2, without reflections");
        }
        if self.illumination < 2.0 || self.block.specular.is_black() {
            return Tint::BLACK;
        }
        if self.block.shininess < MIN_SHININESS {
            let note = "MTL: a highlight (Ks) whose exponent (Ns) is missing or below 1 is left out";
            notes.add_at(note, of_material(name));
            return Tint::BLACK;
        }
        self.block.specular.clone()
    }

    /// The opacity, by `d`, or else by `Tr`.
    fn alpha(&self, name: &str, notes: &mut Notes) -> f32 {
        let alpha = match (self.dissolve, self.transparency) {
            (Some(dissolve), _) => dissolve,
            (None, None | Some(0.0)) => 1.0,
            (None, Some(1.0)) => {
                let note = "MTL: 'Tr 1' without 'd' is taken as opaque; 'd 0' says transparent";
                notes.add_at(note, of_material(name));
                1.0
            }
            (None, Some(transparency)) => {
                let note = "MTL: 'Tr' without 'd' is taken as 1 less the opacity; 'd' says the opacity";
                notes.add_at(note, of_material(name));
                1.0 - transparency
            }
        };
        if alpha <= 0.0 {
            notes.add_at(
                "MTL: a material is fully transparent (d 0): nothing of it is seen",
                of_material(name),
            );
        }
        alpha
    }
}

fn of_material(name: &str) -> Place {
    Place::Path(format!("material '{name}'"))
}

/// The colour of a statement: one number for grey or three, of linear RGB or of CIE XYZ. `None` for anything else.
fn color(lines: &Lines<'_, &[u8]>, notes: &mut Notes) -> Option<Rgb> {
    let mut words = values(lines.line()).skip(1).peekable();
    let is_xyz = words.next_if_eq(&&b"xyz"[..]).is_some();
    let mut channel = |missing: Option<f32>| words.next().map_or(missing, float);
    let first = channel(None)?;
    let color = [first, channel(Some(first))?, channel(Some(first))?];
    let color = match (is_xyz, RgbSpace::LINEAR_SRGB.from_xyz_matrix()) {
        (true, matrix) => {
            notes.add_at("MTL: colours in xyz are converted to linear sRGB", lines.place());
            matrix.apply(color.map(f64::from)).map(|channel| channel as f32)
        }
        (false, _) => color,
    };
    if color.iter().any(|channel| *channel < 0.0) {
        notes.add_at("MTL: colours below 0 are taken as 0", lines.place());
    }
    Some(Rgb(color.map(|channel| channel.max(0.0))))
}
