//! Tables with keys that only what is read later tells the meaning of.

use std::fmt;

use serde::de::{DeserializeSeed, Error, IgnoredAny, IntoDeserializer, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer, forward_to_deserialize_any};

use crate::file::tables::values::At;

/// A key that is no field of the struct, and its value if that is a number.
pub(crate) type Other = (At<String>, At<Option<f64>>);

/// Reads a struct from a table and sets the keys aside that are none of its fields, with their places.
pub(super) struct SetAside<'a, D> {
    pub inner: D,
    pub others: &'a mut Vec<Other>,
    /// Becomes the names of the struct's fields.
    pub fields: &'a mut &'static [&'static str],
}

impl<'de, D: Deserializer<'de>> Deserializer<'de> for SetAside<'_, D> {
    type Error = D::Error;
    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, D::Error> {
        self.inner.deserialize_any(visitor)
    }
    fn deserialize_struct<V: Visitor<'de>>(
        self,
        name: &'static str,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, D::Error> {
        *self.fields = fields;
        let visitor = StructVisitor { inner: visitor, fields, others: self.others };
        self.inner.deserialize_struct(name, fields, visitor)
    }
    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf option unit unit_struct
        newtype_struct seq tuple tuple_struct map enum identifier ignored_any
    }
}

struct StructVisitor<'a, V> {
    inner: V,
    fields: &'static [&'static str],
    others: &'a mut Vec<Other>,
}

impl<'de, V: Visitor<'de>> Visitor<'de> for StructVisitor<'_, V> {
    type Value = V::Value;
    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.inner.expecting(f)
    }
    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<V::Value, A::Error> {
        self.inner.visit_map(Fields { inner: map, fields: self.fields, others: self.others })
    }
}

/// The entries of the table that are fields of the struct.
struct Fields<'a, A> {
    inner: A,
    fields: &'static [&'static str],
    others: &'a mut Vec<Other>,
}

impl<'de, A: MapAccess<'de>> MapAccess<'de> for Fields<'_, A> {
    type Error = A::Error;
    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, A::Error> {
        while let Some(key) = self.inner.next_key::<At<String>>()? {
            if self.fields.contains(&key.as_str()) {
                return seed.deserialize(key.value.into_deserializer()).map(Some);
            }
            let At { value: Plain(value), span } = self.inner.next_value()?;
            self.others.push((key, At { value, span }));
        }
        Ok(None)
    }
    fn next_value_seed<S: DeserializeSeed<'de>>(&mut self, seed: S) -> Result<S::Value, A::Error> {
        self.inner.next_value_seed(seed)
    }
}

/// Any value; a number is kept.
struct Plain(Option<f64>);

impl<'de> Deserialize<'de> for Plain {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Any;
        impl<'de> Visitor<'de> for Any {
            type Value = Plain;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a value")
            }
            fn visit_f64<E: Error>(self, value: f64) -> Result<Plain, E> {
                Ok(Plain(Some(value)))
            }
            fn visit_i64<E: Error>(self, value: i64) -> Result<Plain, E> {
                Ok(Plain(Some(value as f64)))
            }
            fn visit_bool<E: Error>(self, _: bool) -> Result<Plain, E> {
                Ok(Plain(None))
            }
            fn visit_str<E: Error>(self, _: &str) -> Result<Plain, E> {
                Ok(Plain(None))
            }
            fn visit_seq<S: SeqAccess<'de>>(self, mut seq: S) -> Result<Plain, S::Error> {
                while seq.next_element::<IgnoredAny>()?.is_some() {}
                Ok(Plain(None))
            }
            fn visit_map<M: MapAccess<'de>>(self, mut map: M) -> Result<Plain, M::Error> {
                while map.next_entry::<IgnoredAny, IgnoredAny>()?.is_some() {}
                Ok(Plain(None))
            }
        }
        deserializer.deserialize_any(Any)
    }
}
