//! The pictures that MTL statements name.

use std::collections::HashMap;
use std::rc::Rc;

use glanz_color::read::{Place, ReadError};
use glanz_math::MemoryBudget;

use super::super::context::Context;
use super::super::lines::{Lines, float, without_comment, words};
use crate::read::texture;
use crate::{Texture, TextureUse, Wrap};

/// How far white is above black in a picture of heights, in texels: slopes as programs make them of such pictures by default.
const HEIGHT: f32 = 2.0;

/// How far the means of red and green may be from a half, of 255, for a picture to be of normals.
const NORMAL_MIDDLE: f64 = 30.0;
/// The least mean of blue, of 255, of a picture of normals.
const NORMAL_BLUE: f64 = 190.0;

/// A texture as a statement gives it.
#[derive(Clone)]
pub(super) struct Map {
    reference: String,
    /// The MTL file that names it.
    file: Rc<str>,
    line: Place,
    transform: [[f32; 3]; 2],
    clamp: bool,
    scale: f32,
}

impl Map {
    /// `map_Kd -option value … file name`.
    pub(super) fn parse(lines: &Lines<'_, &[u8]>, file: &Rc<str>) -> Option<Self> {
        let (mut scale, mut offset) = ([1.0f32; 2], [0.0f32; 2]);
        let (mut clamp, mut bump) = (false, 1.0);
        let line = lines.line().trim_ascii();
        let start = line.iter().position(u8::is_ascii_whitespace)?;
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
            return None;
        }
        // v is turned (see the module's docs): 1 − (s·(1 − v) + o).
        let transform = [[scale[0], 0.0, offset[0]], [0.0, scale[1], 1.0 - scale[1] - offset[1]]];
        let reference = String::from_utf8_lossy(left).into_owned();
        Some(Self { reference, file: file.clone(), line: lines.place(), transform, clamp, scale: bump })
    }

    /// What the picture's name may be: beside the MTL file, or else beside the OBJ file.
    fn candidates(&self) -> Vec<String> {
        let folder = self.file.rfind(['/', '\\']).map_or("", |end| &self.file[..=end]);
        let names = [Some(self.reference.as_str()), without_comment(&self.reference)];
        let mut all: Vec<String> = names.iter().flatten().map(|name| format!("{folder}{name}")).collect();
        if !folder.is_empty() {
            all.extend(names.into_iter().flatten().rev().map(str::to_owned));
        }
        all
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

/// What a picture is used for.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Use {
    /// Colours.
    Color,
    /// Numbers: normals, opacity.
    Numbers,
    /// What `map_Bump` names: normals, or else heights.
    Bump,
}

/// The textures of a model, each decoded once per way of use.
pub(super) struct Pictures {
    pub(super) textures: Vec<Texture>,
    /// By name, use and clamp; `None` for those that cannot be used.
    known: HashMap<(String, Use, bool), Option<usize>>,
    memory: MemoryBudget,
}

impl Pictures {
    /// None yet, and so many bytes that they may take.
    pub(super) fn new(memory: MemoryBudget) -> Self {
        Self { textures: Vec::new(), known: HashMap::new(), memory }
    }

    /// The texture of a statement, if it can be used.
    pub(super) fn load(
        &mut self,
        map: Option<&Map>,
        purpose: Use,
        context: &mut Context<'_>,
    ) -> Result<Option<TextureUse>, ReadError> {
        let Some(map) = map else { return Ok(None) };
        let key = (map.reference.clone(), purpose, map.clamp);
        let texture = match self.known.get(&key) {
            Some(known) => *known,
            None => {
                let loaded = self.decode(map, purpose, context)?.map(|texture| {
                    self.textures.push(texture);
                    self.textures.len() - 1
                });
                *self.known.entry(key).or_insert(loaded)
            }
        };
        let (transform, scale) = (map.transform, if purpose == Use::Color { 1.0 } else { map.scale });
        Ok(texture.map(|texture| TextureUse { transform, scale, ..TextureUse::plain(texture) }))
    }

    /// The colours of one statement with the opacity of another as their alpha, and whether that is less than 1
    /// anywhere. Without colours they are white.
    pub(super) fn load_with_opacity(
        &mut self,
        color: Option<&Map>,
        opacity: Option<&Map>,
        context: &mut Context<'_>,
    ) -> Result<(Option<TextureUse>, bool), ReadError> {
        let colored = self.load(color, Use::Color, context)?;
        let Some(opacity) = opacity else { return Ok((colored, false)) };
        let Some(mask) = self.decode(opacity, Use::Numbers, context)? else { return Ok((colored, false)) };
        let base = match &colored {
            Some(colored) if colored.transform != opacity.transform => {
                let note = "MTL: map_d is ignored where its options differ from those of map_Kd";
                context.notes.add_at(note, opacity.line.clone());
                return Ok((Some(*colored), false));
            }
            Some(colored) => self.textures[colored.texture].clone(),
            None => Texture { rgba: vec![255; mask.rgba.len()], srgb: true, ..mask.clone() },
        };
        texture::spend((base.width, base.height), context.file, &opacity.line, &mut self.memory)?;
        self.textures.push(with_alpha(base, &mask));
        let texture = self.textures.len() - 1;
        Ok((Some(TextureUse { transform: opacity.transform, ..TextureUse::plain(texture) }), true))
    }

    /// The picture, or `None` with a remark where it is missing or of a kind that cannot be used.
    fn decode(
        &mut self,
        map: &Map,
        purpose: Use,
        context: &mut Context<'_>,
    ) -> Result<Option<Texture>, ReadError> {
        let reference = &map.reference;
        let Some(bytes) = context.find_picture(&map.candidates(), &map.line) else { return Ok(None) };
        let Some(texture) = context.decode_picture(&bytes, reference, &map.line, &mut self.memory)? else {
            return Ok(None);
        };
        let wrap = [if map.clamp { Wrap::Clamp } else { Wrap::Repeat }; 2];
        if purpose == Use::Bump && !holds_normals(&texture) {
            let note = "MTL: map_Bump is of heights, whose unit nothing says: white is taken as 2 texels above black, times -bm";
            context.notes.add_at(note, map.line.clone());
            return Ok(Some(Texture { wrap, ..normals_of_heights(&texture, reference, map.clamp) }));
        }
        Ok(Some(Texture { name: reference.clone(), srgb: purpose == Use::Color, wrap, ..texture }))
    }
}

/// The picture with the opacity that another one holds in its alpha, or, if that is 1 everywhere, in its colours.
fn with_alpha(mut base: Texture, mask: &Texture) -> Texture {
    let by_alpha = mask.rgba.chunks_exact(4).any(|texel| texel[3] < 255);
    let (width, height) = (base.width as usize, base.height as usize);
    for (number, texel) in base.rgba.chunks_exact_mut(4).enumerate() {
        // The texel of the mask in whose middle that of the colours is nearest.
        let x = (2 * (number % width) + 1) * mask.width as usize / (2 * width);
        let y = (2 * (number / width) + 1) * mask.height as usize / (2 * height);
        let at = 4 * (y * mask.width as usize + x);
        let [r, g, b, a] = [0, 1, 2, 3].map(|channel| u16::from(mask.rgba[at + channel]));
        texel[3] = if by_alpha { a } else { (r + g + b) / 3 } as u8;
    }
    base
}

/// The tangent-space normals of a picture of heights, by the difference of the texels on either side.
fn normals_of_heights(heights: &Texture, name: &str, clamp: bool) -> Texture {
    let (width, height) = (heights.width as usize, heights.height as usize);
    let at = |x: usize, y: usize| {
        let texel = &heights.rgba[4 * (y * width + x)..][..3];
        texel.iter().map(|code| f32::from(*code)).sum::<f32>() / (3.0 * 255.0)
    };
    let next = |i: usize, count: usize| {
        if i + 1 < count {
            i + 1
        } else if clamp {
            i
        } else {
            0
        }
    };
    let last = |i: usize, count: usize| {
        if i > 0 {
            i - 1
        } else if clamp {
            0
        } else {
            count - 1
        }
    };
    let code = |value: f32| libm::roundf((value * 0.5 + 0.5) * 255.0) as u8;
    let texel = |number: usize| {
        let (x, y) = (number % width, number / width);
        let across = at(next(x, width), y) - at(last(x, width), y);
        // Rows go down, and the y axis of normals up.
        let up = at(x, last(y, height)) - at(x, next(y, height));
        let [x, y] = [across, up].map(|difference| -0.5 * HEIGHT * difference);
        let length = libm::sqrtf(x * x + y * y + 1.0);
        [code(x / length), code(y / length), code(1.0 / length), 255]
    };
    Texture {
        name: name.to_owned(),
        srgb: false,
        rgba: (0..width * height).flat_map(texel).collect(),
        ..*heights
    }
}

/// Whether a picture is of tangent-space normals: in the mean they point away from the surface.
fn holds_normals(texture: &Texture) -> bool {
    let mut sums = [0u64; 3];
    for texel in texture.rgba.chunks_exact(4) {
        (0..3).for_each(|channel| sums[channel] += u64::from(texel[channel]));
    }
    let [r, g, b] = sums.map(|sum| sum as f64 * 4.0 / texture.rgba.len() as f64);
    let is_middle = |mean: f64| (mean - 127.5).abs() <= NORMAL_MIDDLE;
    is_middle(r) && is_middle(g) && b >= NORMAL_BLUE
}
