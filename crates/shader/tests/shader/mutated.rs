//! Damaged texts are errors, not panics.

use glanz_shader::{Language, Shader, ShaderError, Stage};

use crate::common::Numbers;

const GLSL: [&str; 5] = [
    include_str!("texts/loops.frag"),
    include_str!("texts/specular.frag"),
    "#version 330\n#define K(a) (a*2.0)\n#if defined(X)\n#else\nuniform sampler2D s; in vec2 uv; out vec4 c;\nlayout(std140) uniform B { vec4 a; } b;\nvoid main() { c = texture(s, K(uv)) + b.a; switch (int(uv.x)) { case 1: discard; default: break; } }\n#endif\n",
    "in VS { vec3 n[2]; } i; struct S { sampler2D t; float k; }; uniform S m; vec4 f(sampler2D t) { return texture2D(t, vec2(0)); }\nvoid main() { gl_FragColor = f(m.t) * m.k; for (int j = 0; j < 3; j++) if (i.n[j & 1].x > 0.) continue; }",
    "analytic\n::begin parameters\nfloat n 1 2 3\n::end parameters\n::begin shader\nvec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) { return vec3(n); }\n::end shader\n",
];

const WGSL: &str = "fn f(x: f32) -> f32 { var s = x; for (var i = 0; i < 4; i++) { s += f32(i); if (s > 3.0) { break; } } return s; }
@group(0) @binding(0) var<uniform> u: mat4x4<f32>;
@fragment fn main(@location(0) v: vec2<f32>) -> @location(0) vec4<f32> { return u * vec4(f(v.x), v, 1.0); }";

const SPICE: [&str; 24] = [
    "(",
    ")",
    "{",
    "}",
    "[",
    "]",
    ";",
    ",",
    "#",
    "\\\n",
    "\"",
    "uniform",
    "struct",
    "in",
    "1",
    "-",
    "layout",
    "é",
    "##",
    "=",
    "#define F(x) x\n",
    "F(",
    "sampler2D",
    ".",
];

fn pieces(text: &str) -> Vec<&str> {
    let mut all = Vec::new();
    let mut start = 0;
    for (i, c) in text.char_indices() {
        if !c.is_alphanumeric() && c != '_' {
            all.extend([&text[start..i], &text[i..i + c.len_utf8()]]);
            start = i + c.len_utf8();
        }
    }
    all.push(&text[start..]);
    all.retain(|piece| !piece.is_empty());
    all
}

fn mutated(text: &str, numbers: &mut Numbers) -> String {
    let mut all = pieces(text);
    for _ in 0..=numbers.below(3) {
        let (i, j) = (numbers.below(all.len()), numbers.below(all.len()));
        match numbers.below(6) {
            0 => drop(all.remove(i)),
            1 => all.insert(i, all[j]),
            2 => all.swap(i, j),
            3 => all[i] = SPICE[numbers.below(SPICE.len())],
            4 => all.insert(i, SPICE[numbers.below(SPICE.len())]),
            _ => all.truncate(i.max(2)),
        }
    }
    all.concat()
}

#[test]
fn thousands_of_damaged_texts_panic_nowhere_in_our_code() {
    let mut numbers = Numbers(3);
    let (mut passed, mut wrong, mut broken) = (0, 0, Vec::new());
    // More, for a longer search: `GLANZ_MUTATIONS=100000 cargo test …`
    let rounds = std::env::var("GLANZ_MUTATIONS").ok().and_then(|n| n.parse().ok()).unwrap_or(2400);
    // And others to begin with: those of a folder, as in `wild`.
    let mut seeds: Vec<String> = GLSL.iter().map(|text| (*text).to_owned()).collect();
    seeds.extend(crate::wild::texts());
    for round in 0..rounds {
        let which = round % (seeds.len() + 1);
        let (text, language) = match seeds.get(which) {
            Some(text) => (mutated(text, &mut numbers), Language::Glsl),
            None => (mutated(WGSL, &mut numbers), Language::Wgsl),
        };
        match Shader::fragment(&text).language(language).compile() {
            Ok(_) => passed += 1,
            Err(ShaderError::Broken) => broken.push(text),
            Err(_) => wrong += 1,
        }
    }
    assert!(passed > 100 && wrong > 1000, "{passed} passed, {wrong} were wrong");
    // A few panics are naga's own, and are contained.
    assert!(broken.len() <= rounds / 800, "{}: {}", broken.len(), broken[0]);
}

#[test]
fn what_nests_too_deeply_or_grows_without_end_is_an_error() {
    let nested = |open: &str, close: &str, n: usize| {
        format!("void main() {{ float x = {}1.0{}; }}", open.repeat(n), close.repeat(n))
    };
    let doubling: String = (0..40).map(|i| format!("#define M{}(x) M{i}(x) M{i}(x)\n", i + 1)).collect();
    let calls: String = (0..40)
        .map(|i| format!("float f{}(float x) {{ return f{i}(x) + f{i}(x * 2.0); }}\n", i + 1))
        .collect();
    let include = |_: &str, _: &str| Some("#include \"again\"\n".to_owned());
    for text in [
        nested("(", ")", 20_000),
        nested("-", "", 20_000),
        nested("vec3(", ").x", 5000),
        nested("1.0+", "", 20_000),
        format!("void main() {{ {} }}", "if (true) ".repeat(5000)),
        format!("{doubling} #define M0(x) x\nM40(1)"),
        format!(
            "float f0(float x) {{ return sin(x); }}\n{calls} void main() {{ gl_FragColor = vec4(f40(1.0)); }}"
        ),
        "#include \"again\"\n".to_owned(),
        format!("#if {}1\n#endif\n", "!".repeat(10_000)),
        "float a[277803737]; void main() { gl_FragColor = vec4(a[3]); }".to_owned(),
    ] {
        let result = Shader::new(Stage::Fragment, &*text).include(&include).compile();
        assert!(result.is_err(), "{}", &text[..text.len().min(100)]);
        assert_ne!(result.unwrap_err(), ShaderError::Broken);
    }
}
