//! Tables that must be tables.
//!
//! serde would also fill a struct from a list, field by field; in a scene file that is a mistake.

use std::collections::BTreeMap;
use std::fmt;
use std::marker::PhantomData;

use serde::de::value::MapAccessDeserializer;
use serde::de::{MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};

use super::values::At;

/// For `default`: true.
pub(crate) fn yes() -> bool {
    true
}

/// Reads a `T` from a table only.
struct Table<T>(T);

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Table<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(TableVisitor(PhantomData))
    }
}

struct TableVisitor<T>(PhantomData<T>);

impl<'de, T: Deserialize<'de>> Visitor<'de> for TableVisitor<T> {
    type Value = Table<T>;
    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a table")
    }
    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Table<T>, A::Error> {
        T::deserialize(MapAccessDeserializer::new(map)).map(Table)
    }
}

/// For `deserialize_with`: a table.
pub(crate) fn table<'de, T: Deserialize<'de>, D: Deserializer<'de>>(deserializer: D) -> Result<T, D::Error> {
    Table::deserialize(deserializer).map(|table| table.0)
}

/// For `deserialize_with`: a table that may be missing, with its place.
pub(crate) fn optional<'de, T, D>(deserializer: D) -> Result<Option<At<T>>, D::Error>
where
    T: Deserialize<'de>,
    D: Deserializer<'de>,
{
    At::<Table<T>>::deserialize(deserializer).map(|table| Some(bare(table)))
}

/// For `deserialize_with`: a list of tables, each with its place.
pub(crate) fn placed_list<'de, T, D>(deserializer: D) -> Result<Vec<At<T>>, D::Error>
where
    T: Deserialize<'de>,
    D: Deserializer<'de>,
{
    let tables = Vec::<At<Table<T>>>::deserialize(deserializer)?;
    Ok(tables.into_iter().map(bare).collect())
}

/// For `deserialize_with`: tables by name, each with its place.
pub(crate) fn placed_map<'de, T, D>(deserializer: D) -> Result<BTreeMap<String, At<T>>, D::Error>
where
    T: Deserialize<'de>,
    D: Deserializer<'de>,
{
    let tables = BTreeMap::<String, At<Table<T>>>::deserialize(deserializer)?;
    Ok(tables.into_iter().map(|(name, table)| (name, bare(table))).collect())
}

fn bare<T>(table: At<Table<T>>) -> At<T> {
    At { value: table.value.0, span: table.span }
}

/// For `deserialize_with`: a list of tables.
pub(crate) fn list<'de, T: Deserialize<'de>, D: Deserializer<'de>>(
    deserializer: D,
) -> Result<Vec<T>, D::Error> {
    deserializer.deserialize_any(ListVisitor(PhantomData))
}

struct ListVisitor<T>(PhantomData<T>);

impl<'de, T: Deserialize<'de>> Visitor<'de> for ListVisitor<T> {
    type Value = Vec<T>;
    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list of tables")
    }
    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Vec<T>, A::Error> {
        let mut list = Vec::new();
        while let Some(Table(value)) = seq.next_element()? {
            list.push(value);
        }
        Ok(list)
    }
}
