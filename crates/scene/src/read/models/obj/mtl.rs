//! MTL: the materials of OBJ files.
//!
//! `Ka`, `Kd`, `Ks`, `Ke` (linear RGB), `Ns`, `d` or `Tr`, `illum`, `map_Kd`, `map_Ke`, `norm` and
//! `map_Bump` become a classic material. The highlight of illumination model 2 is Blinn's: the
//! format defines it by the half vector. Models 0 and 1 have no highlight; those above 2, which ask
//! for reflections, are taken as 2. A grey `map_Bump` is a height map, which is not supported; a
//! coloured one is taken for the normal map that many programs write there.

use std::collections::HashMap;
use std::rc::Rc;

use glanz_color::Rgb;
use glanz_color::read::{Place, ReadError};

use super::super::context::Context;
use super::super::lines::{Lines, float, rest, words};
use crate::read::{ResolveError, texture};
use crate::{AlphaMode, ClassicMaterial, Material, Texture, TextureUse, Tint, Wrap};

/// The most MTL files that one OBJ file may name.
pub(super) const MAX_LIBRARIES: usize = 1024;
/// The greatest exponent that the shapes take.
const MAX_SHININESS: f64 = 1e5;

/// The materials of all MTL files of an OBJ file.
#[derive(Default)]
pub(super) struct Library {
    definitions: HashMap<String, Definition>,
}

/// A `newmtl` block.
#[derive(Clone)]
struct Definition {
    block: ClassicMaterial,
    alpha: f32,
    illumination: f32,
    base_color: Option<Map>,
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
        let (base_color, normal, emission) = (None, None, None);
        Self { block, alpha: 1.0, illumination: 2.0, base_color, normal, bump: false, emission }
    }
}

/// A texture as a statement gives it.
#[derive(Clone)]
struct Map {
    reference: String,
    /// The MTL file that names it.
    file: Rc<str>,
    line: Place,
    transform: [[f32; 3]; 2],
    clamp: bool,
    scale: f32,
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
                let Some((_, definition)) = &mut current else {
                    return Err(lines.expected("'newmtl' before all other statements"));
                };
                definition.statement(&lines, &shared, context)?;
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
        let left = context.options.max_texture_bytes;
        let mut pictures = Pictures { textures: Vec::new(), known: HashMap::new(), left };
        let mut materials = Vec::with_capacity(names.len());
        for name in names {
            materials.push(match name.as_ref().and_then(|name| self.definitions.get_key_value(name)) {
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
}

impl Definition {
    /// Takes one statement in.
    fn statement(
        &mut self,
        lines: &Lines<'_, &[u8]>,
        file: &Rc<str>,
        context: &mut Context<'_>,
    ) -> Result<(), ReadError> {
        let mut words = words(lines.line());
        let keyword = words.next().unwrap_or_default().to_ascii_lowercase();
        let halo = words.clone().next() == Some(b"-halo");
        let mut value = || words.next().and_then(float).ok_or_else(|| lines.expected("a finite number"));
        let map = || Map::parse(lines, file);
        match keyword.as_slice() {
            b"ka" => self.block.ambient = color(lines)?.into(),
            b"kd" => self.block.diffuse = color(lines)?.into(),
            b"ks" => self.block.specular = color(lines)?.into(),
            b"ke" => self.block.emission = color(lines)?.into(),
            b"ns" => self.block.shininess = f64::from(value()?).clamp(0.0, MAX_SHININESS),
            b"tr" => self.alpha = (1.0 - value()?).clamp(0.0, 1.0),
            b"d" if halo => context.notes.add("MTL: 'd -halo' is ignored"),
            b"d" => self.alpha = value()?.clamp(0.0, 1.0),
            b"illum" => self.illumination = value()?,
            b"map_kd" => self.base_color = Some(map()?),
            b"map_ke" => self.emission = Some(map()?),
            b"norm" | b"map_kn" => (self.normal, self.bump) = (Some(map()?), false),
            b"map_bump" | b"bump" if self.normal.is_none() => (self.normal, self.bump) = (Some(map()?), true),
            b"map_bump" | b"bump" | b"ni" => {}
            other => {
                let name = String::from_utf8_lossy(&other[..other.len().min(16)]).into_owned();
                context.notes.add(&format!("MTL: '{name}' is ignored"));
            }
        }
        Ok(())
    }

    fn build(
        &self,
        name: &str,
        pictures: &mut Pictures,
        context: &mut Context<'_>,
    ) -> Result<Material, ReadError> {
        let mut block = self.block.clone();
        if self.illumination < 2.0 {
            block.specular = Tint::BLACK;
        }
        if self.illumination == 0.0 {
            context.notes.add("MTL: illumination model 0 (plain colour) is taken as 1 (diffuse)");
        } else if self.illumination > 2.0 {
            context.notes.add("MTL: illumination models above 2 are taken as 2, without reflections");
        }
        if self.emission.is_some() && block.emission.is_black() {
            block.emission = Rgb::gray(1.0).into();
        }
        let mut material = block.build(name).expect("the shape and its exponent were chosen within range");
        material.base_color = pictures.load(self.base_color.as_ref(), true, false, context)?;
        material.emission_map = pictures.load(self.emission.as_ref(), true, false, context)?;
        material.normal_map = pictures.load(self.normal.as_ref(), false, self.bump, context)?;
        if self.alpha < 1.0 {
            material.opacity = self.alpha;
            material.alpha_mode = AlphaMode::Blend;
        }
        Ok(material)
    }
}

/// The colour of a statement: one number for grey or three.
fn color(lines: &Lines<'_, &[u8]>) -> Result<Rgb, ReadError> {
    let mut words = words(lines.line()).skip(1).peekable();
    if matches!(words.peek(), Some(&b"spectral" | &b"xyz")) {
        return Err(lines.expected("a colour as one or three numbers (no spectrum, no XYZ)"));
    }
    let mut channel = |missing: Option<f32>| match words.next() {
        Some(word) => float(word).filter(|value| *value >= 0.0),
        None => missing,
    };
    let color = channel(None).and_then(|r| Some(Rgb([r, channel(Some(r))?, channel(Some(r))?])));
    color.ok_or_else(|| lines.expected("one or three finite numbers from 0 on"))
}

impl Map {
    /// `map_Kd -option value … file name`.
    fn parse(lines: &Lines<'_, &[u8]>, file: &Rc<str>) -> Result<Self, ReadError> {
        let name_expected = || lines.expected("the name of a picture");
        let (mut scale, mut offset) = ([1.0f32; 2], [0.0f32; 2]);
        let (mut clamp, mut bump) = (false, 1.0);
        let line = lines.line().trim_ascii();
        let start = line.iter().position(u8::is_ascii_whitespace).ok_or_else(name_expected)?;
        let mut left = line[start..].trim_ascii_start();
        while left.first() == Some(&b'-') {
            let mut all = words(left);
            let option = all.next().unwrap_or_default();
            let numbers: Vec<f32> = all.clone().map_while(float).take(3).collect();
            let used = match option {
                b"-s" | b"-o" | b"-t" => numbers.len(),
                b"-mm" => numbers.len().min(2),
                _ => 1,
            };
            match option {
                b"-s" => scale = [0, 1].map(|i| numbers.get(i).copied().unwrap_or(1.0)),
                b"-o" => offset = [0, 1].map(|i| numbers.get(i).copied().unwrap_or(0.0)),
                b"-bm" => bump = numbers.first().copied().unwrap_or(1.0),
                b"-clamp" => clamp = all.next() == Some(b"on"),
                _ => {}
            }
            left = skip_words(left, 1 + used);
        }
        if left.is_empty() {
            return Err(name_expected());
        }
        // v is turned (see the module's docs): 1 − (s·(1 − v) + o).
        let transform = [[scale[0], 0.0, offset[0]], [0.0, scale[1], 1.0 - scale[1] - offset[1]]];
        let reference = String::from_utf8_lossy(left).into_owned();
        Ok(Self { reference, file: file.clone(), line: lines.place(), transform, clamp, scale: bump })
    }
}

/// What follows after this many words.
fn skip_words(mut text: &[u8], count: usize) -> &[u8] {
    for _ in 0..count {
        let end = text.iter().position(u8::is_ascii_whitespace).unwrap_or(text.len());
        text = text[end..].trim_ascii_start();
    }
    text
}

/// The textures of a model, each decoded once per way of use.
struct Pictures {
    textures: Vec<Texture>,
    /// By name, sRGB, clamp and whether heights are possible; `None` for those that cannot be used.
    known: HashMap<(String, bool, bool, bool), Option<usize>>,
    left: u64,
}

impl Pictures {
    fn load(
        &mut self,
        map: Option<&Map>,
        srgb: bool,
        bump: bool,
        context: &mut Context<'_>,
    ) -> Result<Option<TextureUse>, ReadError> {
        let Some(map) = map else { return Ok(None) };
        let key = (map.reference.clone(), srgb, map.clamp, bump);
        let texture = match self.known.get(&key) {
            Some(known) => *known,
            None => {
                let loaded = self.decode(map, bump, context)?.map(|texture| {
                    let wrap = [if map.clamp { Wrap::Clamp } else { Wrap::Repeat }; 2];
                    self.textures.push(Texture { name: map.reference.clone(), srgb, wrap, ..texture });
                    self.textures.len() - 1
                });
                *self.known.entry(key).or_insert(loaded)
            }
        };
        let (transform, scale) = (map.transform, if srgb { 1.0 } else { map.scale });
        Ok(texture.map(|texture| TextureUse { texture, transform, scale }))
    }

    /// The picture, or `None` with a note where it is missing or of a kind that cannot be used.
    fn decode(
        &mut self,
        map: &Map,
        bump: bool,
        context: &mut Context<'_>,
    ) -> Result<Option<Texture>, ReadError> {
        let (reference, options) = (&map.reference, context.options);
        let Some(bytes) = find(map, context)? else {
            context.notes.add(&format!("the picture '{reference}' is missing"));
            return Ok(None);
        };
        let texture = match texture::decode(&bytes, reference, Place::File, options, &mut self.left) {
            Err(ReadError::Unsupported { .. }) => {
                context.notes.add(&format!("the picture '{reference}' is neither PNG nor JPEG: ignored"));
                return Ok(None);
            }
            other => other?,
        };
        if bump && texture.rgba.chunks_exact(4).all(|texel| texel[0] == texel[1] && texel[1] == texel[2]) {
            context.notes.add(&format!("the height map '{reference}' is ignored"));
            return Ok(None);
        }
        Ok(Some(texture))
    }
}

/// The bytes of a picture that lies beside the MTL file, or else beside the OBJ file.
fn find(map: &Map, context: &Context<'_>) -> Result<Option<Vec<u8>>, ReadError> {
    let folder = map.file.rfind(['/', '\\']).map(|end| &map.file[..=end]);
    let beside = folder.map(|folder| format!("{folder}{}", map.reference));
    for reference in beside.iter().chain([&map.reference]) {
        match context.resolver.read(reference) {
            Ok(bytes) => return Ok(Some(bytes)),
            Err(ResolveError::Missing) => {}
            Err(error) => return Err(error.at(&map.file, map.line.clone(), reference)),
        }
    }
    Ok(None)
}
