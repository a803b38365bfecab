//! All of a prepared scene in two flat pools, for upload to a device.
//!
//! [`Prepared::pack`] gives a pool of `u32` and one of `f32`. Each pool is cut into [sections](Section), and each
//! section into records of one size: the table of [`Section`] has the pool, the size and the order of the fields. Record `i`
//! of a section begins at `offset + i · stride` of its [span](Span). What has fields of both types is in two sections
//! with the same numbers, such as [`Section::Clusters`] and [`Section::ClusterBounds`].
//!
//! - A reference to another record is its number in that record's section; [`NO_RECORD`] where there is none. A run of
//!   records is the number of the first and, where nothing else tells it, how many there are.
//! - What several share, such as an environment map or an LTC table, is there once.
//! - Places in the world are pairs of `f32`: the number rounded, then what rounding left. Their sum has 48 bits.
//! - Enumerations of the scene are numbers in the order of their variants, from 0.
//!
//! ```
//! use glanz_render::prepare::{PrepareOptions, Section, prepare};
//!
//! let text = "[[lights]]\nkind = \"point\"\nposition = [1, 2, 3]";
//! let scene = glanz_scene::file::parse_str(text, "".as_ref(), &Default::default())?.scene;
//! let packed = prepare(&scene, &PrepareOptions::default())?.pack();
//! let light = packed.span(Section::Lights);
//! assert_eq!((light.len, packed.words(Section::Lights, 0)[0]), (1, 1));
//! assert_eq!(packed.floats[packed.span(Section::LightValues).offset..][..3], [1.0, 2.0, 3.0]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod geometry;
mod lights;
mod materials;
mod objects;
mod section;
mod series;
mod textures;

use std::collections::HashMap;
use std::sync::Arc;

pub use section::{Pool, Section};

use super::Prepared;

/// Instead of the number of a record that is not there.
pub const NO_RECORD: u32 = u32::MAX;

/// A prepared scene in two pools.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Packed {
    /// All numbers of records, counts, kinds and flags.
    pub words: Vec<u32>,
    /// All values.
    pub floats: Vec<f32>,
    /// Where the sections are, in the order of [`Section::ALL`].
    pub sections: Vec<Span>,
}

/// Where a section is in its pool.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Span {
    /// The first number of the first record.
    pub offset: usize,
    /// How many records there are.
    pub len: usize,
    /// How many numbers a record has.
    pub stride: usize,
}

impl Packed {
    /// Where a section is in its pool.
    pub fn span(&self, section: Section) -> Span {
        self.sections[section as usize]
    }

    /// A record of words.
    ///
    /// # Panics
    /// If the section is of floats, or there is no such record.
    pub fn words(&self, section: Section, number: usize) -> &[u32] {
        assert_eq!(section.pool(), Pool::Words, "{section:?} has floats");
        &self.words[self.record(section, number)]
    }

    /// A record of floats.
    ///
    /// # Panics
    /// If the section is of words, or there is no such record.
    pub fn floats(&self, section: Section, number: usize) -> &[f32] {
        assert_eq!(section.pool(), Pool::Floats, "{section:?} has words");
        &self.floats[self.record(section, number)]
    }

    fn record(&self, section: Section, number: usize) -> core::ops::Range<usize> {
        let Span { offset, len, stride } = self.span(section);
        assert!(number < len, "{section:?} has {len} records, not one of number {number}");
        let first = offset + number * stride;
        first..first + stride
    }
}

impl Prepared {
    /// The scene in two pools; see [`pack`](self).
    pub fn pack(&self) -> Packed {
        let mut packer = Packer::new();
        packer.geometry(&self.geometry);
        self.objects.iter().for_each(|object| packer.object(object));
        self.lights.iter().for_each(|light| packer.light(light));
        if let Some([a, b, c]) = self.environment_tint {
            packer.floats(Section::EnvironmentTint, &[a, b, c].concat());
        }
        self.materials.iter().for_each(|material| packer.material(material));
        self.textures.iter().for_each(|texture| packer.texture(texture));
        if let Some(bvh) = &self.bvh {
            packer.bvh(bvh);
        }
        packer.finish()
    }
}

/// Sections as they grow. Those of one pool leave the other's vector empty.
struct Packer {
    sections: Vec<(Vec<u32>, Vec<f32>)>,
    /// The records of what is shared, by its address.
    known: HashMap<usize, u32>,
    /// How many lights of the tint table the lights so far are.
    lights_of_table: u32,
}

impl Packer {
    fn new() -> Self {
        Self {
            sections: vec![Default::default(); Section::ALL.len()],
            known: HashMap::new(),
            lights_of_table: 0,
        }
    }

    /// The number that the next record of a section gets.
    fn next(&self, section: Section) -> u32 {
        let (words, floats) = &self.sections[section as usize];
        ((words.len() + floats.len()) / section.stride()) as u32
    }

    /// Adds records of words; the number of the first.
    fn words(&mut self, section: Section, records: &[u32]) -> u32 {
        debug_assert!(section.pool() == Pool::Words && records.len().is_multiple_of(section.stride()));
        let number = self.next(section);
        self.sections[section as usize].0.extend_from_slice(records);
        number
    }

    /// Adds records of floats; the number of the first.
    fn floats(&mut self, section: Section, records: &[f32]) -> u32 {
        debug_assert!(section.pool() == Pool::Floats && records.len().is_multiple_of(section.stride()));
        let number = self.next(section);
        self.sections[section as usize].1.extend_from_slice(records);
        number
    }

    /// The record of something shared, which is added where it is not there yet.
    fn once<T>(&mut self, shared: &Arc<T>, add: impl FnOnce(&mut Self, &T) -> u32) -> u32 {
        let address = Arc::as_ptr(shared) as usize;
        if let Some(number) = self.known.get(&address) {
            return *number;
        }
        let number = add(self, shared);
        self.known.insert(address, number);
        number
    }

    fn finish(self) -> Packed {
        let mut packed = Packed::default();
        for (section, (words, floats)) in Section::ALL.iter().zip(self.sections) {
            let (offset, stride) = match section.pool() {
                Pool::Words => (packed.words.len(), section.stride()),
                Pool::Floats => (packed.floats.len(), section.stride()),
            };
            packed.sections.push(Span { offset, len: (words.len() + floats.len()) / stride, stride });
            packed.words.extend(words);
            packed.floats.extend(floats);
        }
        packed
    }
}

/// A number as a pair of `f32`.
fn pair(x: f64) -> (f32, f32) {
    let rounded = x as f32;
    (rounded, (x - f64::from(rounded)) as f32)
}

/// A place in the world: the rounded coordinates, then what rounding left of each.
fn place(point: [f64; 3]) -> [f32; 6] {
    let [(a, x), (b, y), (c, z)] = point.map(pair);
    [a, b, c, x, y, z]
}

/// A vector as `f32`.
fn short<const N: usize>(vector: [f64; N]) -> [f32; N] {
    vector.map(|x| x as f32)
}
