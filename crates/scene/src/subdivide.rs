//! Loop subdivision.
