//! Tests of the shader crate as a whole.

mod brdfs;
mod common;
mod flow;
mod gpu;
mod languages;
mod mutated;
mod numbers;
mod phong;
mod places;
mod trace;
mod twins;
mod warnings;
mod wild;
