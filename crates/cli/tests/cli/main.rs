//! The command as a user types it: what it prints, what it writes, and how it fails.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on has failed")]

mod brdfs;
mod bytes;
mod color;
mod comparisons;
mod devices;
mod effects;
mod errors;
mod exits;
mod eye;
mod first_hour;
mod folder;
mod help;
#[cfg(unix)]
mod interrupts;
mod lessons;
mod library;
mod lobes;
mod materials;
mod measure;
mod measure_geometry;
mod measure_sheet;
mod memory;
mod models;
mod models_of_files;
mod numbers;
mod outputs;
mod pictures;
mod plots;
mod probe;
mod schemas;
mod shader;
mod shader_docs;
mod shader_run;
mod spectra;
