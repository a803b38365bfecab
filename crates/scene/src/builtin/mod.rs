//! Meshes that need no file.
