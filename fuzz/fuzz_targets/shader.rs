//! GLSL and WGSL from a text to numbers: all of the intake, lowering and machine. Lowered for a trace, a program gives the
//! same numbers.
//!
//! The first byte says the language and the stage. A panic of the front end (naga) is contained by the library, so here
//! it is passed over; one of our own code ends the run.

#![no_main]

use std::sync::Once;

use glanz_shader::{Language, Machine, NoTextures, Program, Row, Shader, Stage};
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
    let shader = Shader::new(stage, text).language(language).include(&include);
    let Ok(program) = shader.clone().compile() else { return };
    let plain = outputs(&program);
    // A trace keeps all values, so it may need more registers than there are.
    if let (Some(plain), Some(traced)) = (plain, shader.traced().compile().ok().and_then(|own| outputs(&own)))
    {
        assert_eq!(plain, traced);
    }
});

/// The bits of all outputs, those that are not a number all the same; `None` if a loop does not end.
fn outputs(program: &Program) -> Option<Vec<u32>> {
    let uniforms = program.uniforms();
    let mut machine = Machine::<1>::new(program, &uniforms, &NoTextures, Default::default());
    machine.set_fuel(FUEL);
    for (number, port) in program.interface().inputs.iter().enumerate() {
        for component in 0..port.ty.scalars() {
            machine.input(number, component)[0] = Row(std::array::from_fn(|lane| lane as f32 * 0.5 - 2.0));
        }
    }
    machine.run().ok()?;
    let outputs = program.interface().outputs.iter().enumerate();
    let rows = outputs.flat_map(|(number, port)| (0..port.ty.scalars()).map(move |k| (number, k)));
    let bits = rows.flat_map(|(number, k)| machine.output(number, k)[0].0);
    Some(bits.map(|value| if value.is_nan() { 1 } else { value.to_bits() }).collect())
}
