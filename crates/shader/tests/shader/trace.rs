//! Traces tell what happened.

use glanz_math::SimdLevel;
use glanz_shader::{Machine, NoTextures, RecordKind, Row, Shader, Trace};

fn trace(text: &str, input: [f32; 16]) -> (Trace, Vec<u32>) {
    let shader = Shader::fragment(text);
    let plain = shader.compile().expect("it compiles");
    let traced = shader.traced().compile().expect("it compiles");
    let uniforms = plain.uniforms();
    let mut machine = Machine::<1>::new(&traced, &uniforms, &NoTextures, SimdLevel::best());
    machine.input(0, 0)[0] = Row(input);
    let trace = machine.trace();
    let mut other = Machine::<1>::new(&plain, &uniforms, &NoTextures, SimdLevel::best());
    other.input(0, 0)[0] = Row(input);
    other.run().expect("it ends");
    let bits = |m: &Machine<'_, 1>| m.output(0, 0)[0].0.map(f32::to_bits).to_vec();
    assert_eq!(bits(&machine), bits(&other), "a trace changes nothing");
    (trace, bits(&machine))
}

const TEXT: &str = "#version 330
in float x;
out vec4 color;
float twice(float v) {
    return v * 2.0;
}
void main() {
    float s = 1.0;
    for (int i = 0; i < 3; i++) {
        s += twice(x) * float(i);
        if (s > 4.0) {
            break;
        }
    }
    vec3 n = vec3(s, 0.0, sqrt(4.0 - s));
    color = vec4(n, 1.0);
}";

#[test]
fn values_stand_with_line_name_and_turn() {
    let (trace, _) = trace(TEXT, std::array::from_fn(|lane| lane as f32 * 0.25));
    let of = |name: &str| trace.records().iter().filter(|r| r.name == name).collect::<Vec<_>>();
    // Lane 2: x = 0.5, s = 1, 2, 4; lane 12: x = 3, s = 1, 7 and out.
    let turns: Vec<f32> = of("s")
        .iter()
        .filter(|r| r.is_here(2) && r.place.as_ref().is_some_and(|p| p.line == 10))
        .map(|r| r.values(2)[0])
        .collect();
    assert_eq!(turns, [1.0, 2.0, 4.0]);
    let turns: Vec<f32> = of("s")
        .iter()
        .filter(|r| r.is_here(12) && r.place.as_ref().is_some_and(|p| p.line == 10))
        .map(|r| r.values(12)[0])
        .collect();
    assert_eq!(turns, [1.0, 7.0]);
    let branches: Vec<_> = trace
        .of_lane(12)
        .filter(|r| r.kind == RecordKind::Branch && r.place.as_ref().is_some_and(|p| p.line == 11))
        .collect();
    assert_eq!(branches.iter().map(|r| r.taken() >> 12 & 1).collect::<Vec<_>>(), [0, 1]);
    assert!(trace.of_lane(12).any(|r| r.name == "break"));
    assert!(!trace.of_lane(0).any(|r| r.name == "break" && r.place.as_ref().is_some_and(|p| p.line == 12)));
    let n = of("n")[0];
    assert_eq!((n.ty.to_string().as_str(), n.place.as_ref().unwrap().line), ("vec3", 15));
    assert!(of("return").iter().any(|r| r.place.as_ref().is_some_and(|p| p.line == 5)));
}

#[test]
fn the_first_nan_and_the_extent_are_told() {
    let (trace, _) = trace(TEXT, [3.0; 16]);
    let nan = trace.first_nan().expect("√(4 − 7) is none");
    assert_eq!((nan.name.as_str(), nan.nan_lanes(), nan.place.as_ref().unwrap().line), ("n", u16::MAX, 15));
    assert_eq!(nan.extent(), Some((0.0, 7.0)));
}
