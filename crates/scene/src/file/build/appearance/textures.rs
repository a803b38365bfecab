//! Textures.

use std::ops::Range;

use crate::file::build::builder::{Builder, in_order};
use crate::file::build::files::unresolved;
use crate::file::error::Problem;
use crate::file::near::{did_you_mean, list};
use crate::file::tables::appearance::textures::{MaskTable, RoughValue, TextureValue};
use crate::file::tables::scene::SceneTable;
use crate::file::tables::values::{At, Fraction};
use crate::memory::texture_bytes;
use crate::read::{FolderFiles, Resolver, read_texture, remark_of_texture};
use crate::{ChannelUse, Mask, RoughnessMap, Texture, TextureChannel, TextureFilter, TextureUse, Wrap};

/// The picture of a texture and how it is taken. Its `Debug` text names it.
#[derive(Debug)]
struct TextureSource<'a> {
    file: &'a str,
    wrap: [Wrap; 2],
    filter: TextureFilter,
    srgb: bool,
}

impl Builder {
    pub(in crate::file::build) fn named_textures(&mut self, table: &SceneTable) -> Result<(), Problem> {
        for (name, texture) in in_order(&table.textures) {
            let (wrap, filter, srgb) = (texture.wrap.0, texture.filter, texture.srgb);
            let source = TextureSource { file: &texture.file, wrap, filter, srgb };
            let read = self.texture(&source, &texture.file.span)?;
            let people_call_it = texture.name.clone().unwrap_or_else(|| name.clone());
            self.names.textures.insert(name.clone(), self.scene.textures.len());
            self.scene.textures.push(Texture { name: people_call_it, ..read });
        }
        Ok(())
    }

    pub(in crate::file::build) fn texture_use(
        &mut self,
        value: Option<&At<TextureValue>>,
        srgb: bool,
    ) -> Result<Option<TextureUse>, Problem> {
        let Some(value) = value else { return Ok(None) };
        let table = &value.0;
        let texture = match (&table.texture, &table.file) {
            (Some(name), None) => self.named_texture(name, value)?,
            (None, Some(file)) => {
                let source = TextureSource {
                    file,
                    wrap: table.wrap.as_ref().map_or([Wrap::default(); 2], |wrap| wrap.value.0),
                    filter: table.filter.as_ref().map_or(TextureFilter::default(), |filter| filter.value),
                    srgb,
                };
                self.texture_of_file(&source, &value.span)?
            }
            _ => return Err(Problem::at(&value.span, "a texture needs 'file', or 'texture' in its place")),
        };
        let mut texture_use = TextureUse::plain(texture);
        if let Some([u, v]) = table.repeat.as_ref().map(|repeat| repeat.value) {
            texture_use.transform = [[u.0 as f32, 0.0, 0.0], [0.0, v.0 as f32, 0.0]];
        }
        if let Some(transform) = &table.transform {
            if table.repeat.is_some() {
                return Err(Problem::at(&transform.span, "'transform' beside 'repeat'"));
            }
            texture_use.transform = transform.value.map(|row| row.map(|number| number.0 as f32));
        }
        texture_use.second_uvs = table.uv_set.0 == 1;
        texture_use.scale = table.scale.map_or(1.0, |scale| scale.0 as f32);
        Ok(Some(texture_use))
    }

    /// A channel of a picture.
    pub(in crate::file::build) fn channel(
        &mut self,
        picture: &At<TextureValue>,
        channel: TextureChannel,
    ) -> Result<ChannelUse, Problem> {
        let map = self.texture_use(Some(picture), false)?.expect("there is a picture");
        let found = ChannelUse { map, channel };
        let (channels, most) = (&mut self.made.channels, ChannelUse::MOST);
        if !channels.contains(&found) {
            channels.push(found);
        }
        match channels.len() > most {
            true => {
                let message =
                    format!("a material has at most {most} channels of pictures, and this is one more");
                Err(Problem::at(&picture.span, message))
            }
            false => Ok(found),
        }
    }

    /// A factor that a picture says.
    pub(in crate::file::build) fn mask(&mut self, table: &MaskTable) -> Result<Mask, Problem> {
        let of = self.channel(&table.picture, table.channel)?;
        let number = |value: &Option<At<Fraction>>, default| value.as_ref().map_or(default, |own| own.0);
        Ok(Mask { of, from: number(&table.from, 0.0), to: number(&table.to, 1.0) })
    }

    /// What says how rough a lobe is.
    pub(in crate::file::build) fn roughness(
        &mut self,
        value: Option<&RoughValue>,
    ) -> Result<RoughnessMap, Problem> {
        Ok(match value {
            None => RoughnessMap::Material,
            Some(RoughValue::Never) => RoughnessMap::Uniform,
            Some(RoughValue::Own(table)) => RoughnessMap::Own(self.channel(&table.picture, table.channel)?),
        })
    }

    /// The number of one of the scene's own textures.
    fn named_texture(&self, name: &str, value: &At<TextureValue>) -> Result<usize, Problem> {
        if let Some(wrap) = &value.0.wrap {
            return Err(Problem::at(&wrap.span, "'wrap' beside 'texture': it belongs into [textures]"));
        }
        if let Some(filter) = &value.0.filter {
            return Err(Problem::at(&filter.span, "'filter' beside 'texture': it belongs into [textures]"));
        }
        self.names.textures.get(name).copied().ok_or_else(|| {
            let known = || self.names.textures.keys().map(String::as_str);
            let message = format!("unknown texture '{name}'{}", did_you_mean(name, known()));
            Problem::at(&value.span, message).help(format!("the textures are: {}", list(known())))
        })
    }

    /// The number of a texture by its name among the scene's, or else by its file.
    pub(in crate::file::build) fn picture(
        &mut self,
        name: &str,
        span: &Range<usize>,
    ) -> Result<usize, Problem> {
        if let Some(texture) = self.names.textures.get(name) {
            return Ok(*texture);
        }
        let (wrap, filter) = ([Wrap::default(); 2], TextureFilter::default());
        self.texture_of_file(&TextureSource { file: name, wrap, filter, srgb: true }, span)
    }

    /// The number of the texture of a file, read once.
    fn texture_of_file(&mut self, source: &TextureSource, span: &Range<usize>) -> Result<usize, Problem> {
        let key = format!("{source:?}");
        if let Some(texture) = self.made.textures.get(&key) {
            return Ok(*texture);
        }
        let texture = self.texture(source, span)?;
        self.scene.textures.push(texture);
        self.made.textures.insert(key, self.scene.textures.len() - 1);
        Ok(self.scene.textures.len() - 1)
    }

    fn texture(&mut self, source: &TextureSource, span: &Range<usize>) -> Result<Texture, Problem> {
        let TextureSource { file, wrap, filter, srgb } = *source;
        let bytes = FolderFiles::new(&self.input.base, &self.input.options)
            .read(file)
            .map_err(|error| unresolved(file, &error, span))?;
        let texture = read_texture(&bytes, file, &self.input.options)
            .map_err(|error| Problem::at(span, error.to_string()))?;
        if let Some(remark) = remark_of_texture(&bytes, file) {
            self.input.notes.push(remark);
        }
        let bytes = texture_bytes(texture.width, texture.height);
        self.take(format_args!("'{file}'"), bytes, span)?;
        Ok(Texture { wrap, filter, srgb, ..texture })
    }
}
