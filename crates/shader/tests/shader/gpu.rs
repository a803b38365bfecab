//! Stages as WGSL: what a GPU would be given is WGSL by itself.

use glanz_shader::gpu::GpuStage;
use glanz_shader::{DefaultProgram, Language, Pair, Shader, ShaderError, Stage};
use naga::valid::{Capabilities, ValidationFlags, Validator};

/// Reads a stage as a driver would.
fn check(stage: &GpuStage, what: &str) {
    let module = naga::front::wgsl::parse_str(&stage.text)
        .unwrap_or_else(|error| panic!("{what}: {}\n{}", error.emit_to_string(&stage.text), stage.text));
    Validator::new(ValidationFlags::all(), Capabilities::default())
        .validate(&module)
        .unwrap_or_else(|error| panic!("{what}: {error:?}\n{}", stage.text));
}

fn pair(vertex: Option<&str>, fragment: Option<&str>, language: Language) -> Result<Pair, ShaderError> {
    let shader = |stage, text: &str| Shader::new(stage, text).language(language);
    let vertex = vertex.map(|text| shader(Stage::Vertex, text));
    let fragment = fragment.map(|text| shader(Stage::Fragment, text));
    Pair::new(vertex.as_ref(), fragment.as_ref())
}

fn check_pair(pair: &Pair, what: &str) {
    let gpu = pair.to_gpu(0).unwrap_or_else(|error| panic!("{what}: {error}"));
    check(&gpu.vertex, what);
    check(&gpu.fragment, what);
}

#[test]
fn default_programs_are_wgsl() {
    for program in DefaultProgram::all() {
        let language = if program.is_wgsl() { Language::Wgsl } else { Language::Glsl };
        let [vertex, fragment] = [Stage::Vertex, Stage::Fragment].map(|stage| program.text(stage));
        let pair = pair(Some(&vertex), Some(&fragment), language).unwrap();
        check_pair(&pair, program.name);
    }
}

#[test]
fn structs_arrays_matrices_and_truth_values_go_to_the_gpu() {
    let vertex = "#version 330
        in vec3 position; in vec3 normal; in vec2 uv;
        uniform mat4 mvp; uniform mat3 normals; uniform mat2 turn; uniform bool mirrored; uniform float weights[3];
        struct Light { vec3 at; float power; bool on; };
        uniform Light lights[2];
        out Given { vec3 n; } given; out mat2 m; flat out int kind; out float sums[2]; noperspective out vec2 where;
        void main() {
            given.n = normals * normal; m = turn; kind = mirrored ? 3 : 4; where = uv;
            sums[0] = weights[0] + lights[1].power; sums[1] = lights[0].on ? 1.0 : weights[2];
            gl_Position = mvp * vec4(position, 1.0);
        }";
    let fragment = "#version 330
        in Given { vec3 n; } given; in mat2 m; flat in int kind; in float sums[2]; noperspective in vec2 where;
        uniform sampler2D image; uniform vec3 tint = vec3(1.0, 0.5, 0.25);
        out vec4 color;
        float look(sampler2D s, vec2 at) { return texture(s, at).x; }
        void main() {
            if (gl_FragCoord.x > 1000.0) discard;
            color = vec4(given.n * tint + sums[0] * sums[1], look(image, m * where) * float(kind));
            gl_FragDepth = gl_FrontFacing ? gl_FragCoord.z : 1.0;
        }";
    let pair = pair(Some(vertex), Some(fragment), Language::Glsl).unwrap();
    check_pair(&pair, "all kinds");
    let gpu = pair.to_gpu(0).unwrap();
    let words = pair.vertex.uniforms().words().len();
    assert_eq!((gpu.vertex.rows, gpu.vertex.attributes.len()), (1 + words.div_ceil(4), 3));
    let samplers: Vec<_> = gpu.fragment.bindings.iter().map(|own| (own.texture, own.is_sampler)).collect();
    assert_eq!(samplers, [(Some(0), false), (Some(0), true)]);
}

#[test]
fn wgsl_goes_to_the_gpu_with_its_blocks_and_structs() {
    let text = "struct Given { @builtin(position) place: vec4f, @location(0) normal: vec3f }
        struct Settings { model: mat4x4f, tint: vec3f, on: u32 }
        @group(0) @binding(0) var<uniform> settings: Settings;
        @group(0) @binding(1) var image: texture_2d<f32>;
        @group(0) @binding(2) var how: sampler;
        @vertex fn vs(@location(0) position: vec3f, @location(1) normal: vec3f) -> Given {
            return Given(settings.model * vec4f(position, 1.0), normal);
        }
        @fragment fn fs(given: Given) -> @location(0) vec4f {
            return vec4f(settings.tint * given.normal, 1.0) + textureSample(image, how, given.place.xy);
        }";
    check_pair(&pair(Some(text), Some(text), Language::Wgsl).unwrap(), "WGSL");
}

#[test]
fn what_gpus_do_not_have_is_refused_in_words() {
    let text = "#version 330\nout vec4 c; void main() { c = vec4(float(gl_PrimitiveID)); }";
    let error = pair(None, Some(text), Language::Glsl).unwrap().to_gpu(0).unwrap_err();
    assert_eq!(error.to_string(), "gl_PrimitiveID is not there on GPUs");
}
