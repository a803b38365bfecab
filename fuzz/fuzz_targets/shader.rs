//! GLSL and WGSL from a text to numbers: preprocessor, pre-pass, front end, lowering, machine.
//!
//! The first byte says the language and the stage. A panic of the front end (naga) is contained by the library, so here
//! it is passed over; one of our own code ends the run.

#![no_main]

use std::sync::Once;

use glanz_shader::{Language, Machine, NoTextures, Shader, Stage};
use libfuzzer_sys::fuzz_target;

static HOOK: Once = Once::new();

/// Turns of loops that a text may take: enough to enter and leave them.
const FUEL: u32 = 4096;

fuzz_target!(|bytes: &[u8]| {
    HOOK.call_once(|| {
        let usual = std::panic::take_hook();
        std::panic::set_hook(Box::new(move |info| {
            if !info.location().is_some_and(|place| place.file().contains("naga")) {
                usual(info);
            }
        }));
    });
    let Some((first, rest)) = bytes.split_first() else { return };
    let Ok(text) = std::str::from_utf8(rest) else { return };
    let stage = if first & 1 == 0 { Stage::Fragment } else { Stage::Vertex };
    let language = if first & 2 == 0 { Language::Glsl } else { Language::Wgsl };
    let include = |path: &str, _: &str| {
        (path == "a.glsl").then(|| "float included(float x) { return x; }\n".to_owned())
    };
    let Ok(program) = Shader::new(stage, text).language(language).include(&include).compile() else { return };
    let uniforms = program.uniforms();
    let mut machine = Machine::<1>::new(&program, &uniforms, &NoTextures, Default::default());
    machine.set_fuel(FUEL);
    let _ = machine.run();
});
