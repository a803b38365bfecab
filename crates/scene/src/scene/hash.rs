//! A number for the content of a scene.
//!
//! FNV-1a over 64-bit words (G. Fowler, L. C. Noll, K.-P. Vo, 1991), with a final mix so that all bits depend on all
//! bytes. It names versions of a scene; it is no protection against forgery.

use core::fmt;

use serde::ser::{self, Serialize, Serializer};

use crate::Scene;

const OFFSET: u64 = 0xcbf2_9ce4_8422_2325;
const PRIME: u64 = 0x0000_0100_0000_01b3;

impl Scene {
    /// A number for all that the scene holds: equal scenes have the same one, on every machine, whether they come
    /// from a file or were made in code. A model of the program's own counts by its name and its parameters.
    ///
    /// ```
    /// use glanz_scene::{Light, Scene};
    ///
    /// let dark = Scene::new();
    /// let lit = Scene::new().with_light(Light::ambient([1.0; 3]));
    /// assert_eq!(lit.content_hash(), lit.clone().content_hash());
    /// assert_ne!(lit.content_hash(), dark.content_hash());
    /// ```
    pub fn content_hash(&self) -> u64 {
        hash_of(self)
    }
}

fn hash_of(value: &impl Serialize) -> u64 {
    let mut hash = Hash::new();
    value.serialize(&mut hash).expect("a hash takes every value");
    hash.finish()
}

/// A running hash, which takes bytes, and what is serialised into it.
pub(crate) struct Hash(u64);

impl Hash {
    pub(crate) const fn new() -> Self {
        Self(OFFSET)
    }

    #[inline]
    fn word(&mut self, word: u64) {
        // A word is more than a byte: the shift brings its upper bits down, which a product does not.
        self.0 = (self.0 ^ word).wrapping_mul(PRIME);
        self.0 ^= self.0 >> 29;
    }

    /// Adds bytes and how many they are.
    pub(crate) fn bytes(&mut self, bytes: &[u8]) {
        let mut words = bytes.chunks_exact(8);
        for word in &mut words {
            self.word(u64::from_le_bytes(word.try_into().expect("chunks of eight")));
        }
        let mut last = [0; 8];
        last[..words.remainder().len()].copy_from_slice(words.remainder());
        self.word(u64::from_le_bytes(last));
        self.word(bytes.len() as u64);
    }

    /// The number.
    pub(crate) const fn finish(self) -> u64 {
        // The finaliser of SplitMix64 (S. Vigna).
        let mut x = self.0;
        x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        x ^ (x >> 31)
    }
}

/// What cannot happen: a value that serialises to an error.
#[derive(Debug)]
pub(crate) struct Refused(String);

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Refused {}

impl ser::Error for Refused {
    fn custom<T: fmt::Display>(message: T) -> Self {
        Self(message.to_string())
    }
}

type Done = Result<(), Refused>;

macro_rules! words {
    ($($name:ident($number:ty) => $to_word:expr;)+) => {
        $(
            #[inline]
            fn $name(self, value: $number) -> Done {
                let to_word: fn($number) -> u64 = $to_word;
                self.word(to_word(value));
                Ok(())
            }
        )+
    };
}

/// Lists say how long they are, enums which variant it is; names of fields say nothing more.
impl Serializer for &mut Hash {
    type Ok = ();
    type Error = Refused;
    type SerializeSeq = Self;
    type SerializeTuple = Self;
    type SerializeTupleStruct = Self;
    type SerializeTupleVariant = Self;
    type SerializeMap = Self;
    type SerializeStruct = Self;
    type SerializeStructVariant = Self;

    words! {
        serialize_bool(bool) => u64::from;
        serialize_i8(i8) => |value| value as u64;
        serialize_i16(i16) => |value| value as u64;
        serialize_i32(i32) => |value| value as u64;
        serialize_i64(i64) => |value| value as u64;
        serialize_u8(u8) => u64::from;
        serialize_u16(u16) => u64::from;
        serialize_u32(u32) => u64::from;
        serialize_u64(u64) => |value| value;
        serialize_f32(f32) => |value| u64::from(value.to_bits());
        serialize_f64(f64) => f64::to_bits;
        serialize_char(char) => u64::from;
    }

    fn serialize_str(self, text: &str) -> Done {
        self.serialize_bytes(text.as_bytes())
    }
    fn serialize_bytes(self, bytes: &[u8]) -> Done {
        self.bytes(bytes);
        Ok(())
    }
    fn serialize_none(self) -> Done {
        self.serialize_bool(false)
    }
    fn serialize_some<T: Serialize + ?Sized>(self, value: &T) -> Done {
        self.word(1);
        value.serialize(self)
    }
    fn serialize_unit(self) -> Done {
        Ok(())
    }
    fn serialize_unit_struct(self, _: &'static str) -> Done {
        Ok(())
    }
    fn serialize_unit_variant(self, _: &'static str, variant: u32, _: &'static str) -> Done {
        self.serialize_u32(variant)
    }
    fn serialize_newtype_struct<T: Serialize + ?Sized>(self, _: &'static str, value: &T) -> Done {
        value.serialize(self)
    }
    fn serialize_newtype_variant<T: Serialize + ?Sized>(
        self,
        _: &'static str,
        variant: u32,
        _: &'static str,
        value: &T,
    ) -> Done {
        self.word(variant.into());
        value.serialize(self)
    }
    fn serialize_seq(self, length: Option<usize>) -> Result<Self, Refused> {
        self.word(length.map_or(u64::MAX, |length| length as u64));
        Ok(self)
    }
    fn serialize_tuple(self, _: usize) -> Result<Self, Refused> {
        Ok(self)
    }
    fn serialize_tuple_struct(self, _: &'static str, _: usize) -> Result<Self, Refused> {
        Ok(self)
    }
    fn serialize_tuple_variant(
        self,
        _: &'static str,
        variant: u32,
        _: &'static str,
        _: usize,
    ) -> Result<Self, Refused> {
        self.word(variant.into());
        Ok(self)
    }
    fn serialize_map(self, length: Option<usize>) -> Result<Self, Refused> {
        self.serialize_seq(length)
    }
    fn serialize_struct(self, _: &'static str, _: usize) -> Result<Self, Refused> {
        Ok(self)
    }
    fn serialize_struct_variant(
        self,
        _: &'static str,
        variant: u32,
        _: &'static str,
        _: usize,
    ) -> Result<Self, Refused> {
        self.word(variant.into());
        Ok(self)
    }
    fn is_human_readable(&self) -> bool {
        false
    }
}

macro_rules! compound {
    ($($kind:ident::$method:ident($($key:ident)?);)+) => {
        $(impl ser::$kind for &mut Hash {
            type Ok = ();
            type Error = Refused;

            #[inline]
            fn $method<T: Serialize + ?Sized>(&mut self, $($key: &'static str,)? value: &T) -> Done {
                $(let _ = $key;)?
                value.serialize(&mut **self)
            }
            fn end(self) -> Done {
                Ok(())
            }
        })+
    };
}

compound! {
    SerializeSeq::serialize_element();
    SerializeTuple::serialize_element();
    SerializeTupleStruct::serialize_field();
    SerializeTupleVariant::serialize_field();
    SerializeStruct::serialize_field(key);
    SerializeStructVariant::serialize_field(key);
}

impl ser::SerializeMap for &mut Hash {
    type Ok = ();
    type Error = Refused;

    fn serialize_key<T: Serialize + ?Sized>(&mut self, key: &T) -> Done {
        key.serialize(&mut **self)
    }
    fn serialize_value<T: Serialize + ?Sized>(&mut self, value: &T) -> Done {
        value.serialize(&mut **self)
    }
    fn end(self) -> Done {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Mesh, library};

    #[test]
    fn every_part_counts() {
        let scene = Scene::new().with_mesh(
            Mesh::builtin("cube").expect("it is listed"),
            library::material("gold").expect("it is listed"),
        );
        let changes: [fn(&mut Scene); 8] = [
            |scene| scene.meshes[0].positions[3].x += 1e-6,
            |scene| scene.meshes[0].name.push('s'),
            |scene| scene.meshes[0].corners.swap(0, 1),
            |scene| scene.materials[0].opacity = 0.5,
            |scene| scene.materials[0].lobes[0].textured ^= true,
            |scene| scene.objects[0].shading = Some(crate::Shading::Flat),
            |scene| scene.image.samples = 8,
            |scene| scene.render.ev = -0.0,
        ];
        let mut hashes = vec![scene.content_hash()];
        for change in changes {
            let mut changed = scene.clone();
            change(&mut changed);
            hashes.push(changed.content_hash());
        }
        let count = hashes.len();
        hashes.sort_unstable();
        hashes.dedup();
        assert_eq!(hashes.len(), count);
    }

    #[test]
    fn the_number_is_the_same_on_every_machine() {
        // By hand: the words 0x61 and 1, the bits of 1.5, a length and two numbers, and two for the last.
        let value = ("a", 1.5_f32, vec![1_u32, 2], Some(true));
        assert_eq!(hash_of(&value), 0x08e3_29fc_651f_54dc);
    }

    #[test]
    fn the_number_of_bytes_is_the_same_everywhere() {
        let mut hash = Hash::new();
        hash.bytes(b"glanz scene");
        // From a separate calculation with Python's integers.
        assert_eq!(hash.finish(), 0x55b2_f184_1c3b_8da9);
    }
}
