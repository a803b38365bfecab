//! Textures with their mip levels.

use super::{Packer, Section};
use crate::prepare::data::{MipLevel, Mipmap};

impl Packer {
    pub(super) fn texture(&mut self, texture: &Mipmap) {
        let first = self.next(Section::Levels);
        texture.levels.iter().for_each(|level| self.level(level));
        let [u, v] = texture.wrap.map(|wrap| wrap as u32);
        let levels = texture.levels.len() as u32;
        self.words(Section::Textures, &[first, levels, u, v, texture.filter as u32]);
        self.floats(Section::Decode, &texture.decode);
    }

    fn level(&mut self, level: &MipLevel) {
        let texels: Vec<u32> = level.rgba.iter().map(|codes| u32::from_le_bytes(*codes)).collect();
        let first = self.words(Section::Texels, &texels);
        self.words(Section::Levels, &[level.width as u32, level.height as u32, first]);
    }
}
