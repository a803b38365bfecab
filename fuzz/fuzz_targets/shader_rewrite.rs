//! What GLSL is rewritten to before the front end takes it: the reader of top-level items and all rewriting, of any tokens.
//!
//! The first byte says the stage.

#![no_main]

use glanz_shader::Stage;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let Some((first, rest)) = bytes.split_first() else { return };
    let Ok(text) = std::str::from_utf8(rest) else { return };
    let stage = if first & 1 == 0 { Stage::Fragment } else { Stage::Vertex };
    glanz_shader::fuzz::rewrite(text, stage);
});
