//! The preprocessor of GLSL alone: directives, macros, includes, and the places of tokens.

#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| glanz_shader::fuzz::preprocess(text));
