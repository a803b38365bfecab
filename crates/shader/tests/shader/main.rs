//! Tests of the shader crate as a whole.

mod brdfs;
mod circuit;
mod common;
mod flow;
mod gpu;
mod languages;
mod mutated;
mod numbers;
mod phong;
mod places;
mod samplers;
mod specialized;
mod trace;
mod twins;
mod warnings;
mod wild;
