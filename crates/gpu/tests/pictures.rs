//! Pictures of programs by every device that there is, against the CPU's. Without any device this says loudly that
//! nothing was tried.

use glanz_gpu::{Choice, Gpu, GpuError, devices};
use glanz_render::{Aovs, DrawOptions, Shot, ShotError};
use glanz_scene::{Background, Program, ProgramText, Scene};
use glanz_shader::{DefaultProgram, Stage};

/// A ball and a cube under a light of each kind that programs know.
const SCENE: &str = r#"
    [image]
    width = 160
    height = 120
    samples = 1
    [camera]
    eye = [0.5, 0.8, 5.0]
    fov_deg = 40.0
    [ambient]
    color = [0.2, 0.25, 0.3]
    [[lights]]
    kind = "directional"
    direction = [-1.0, -1.0, -2.0]
    diffuse = [0.5, 0.4, 0.3]
    specular = [0.6, 0.6, 0.5]
    [[lights]]
    kind = "point"
    position = [2.0, 1.0, 2.5]
    color = [0.3, 0.5, 0.4]
    attenuation = { constant = 0.5, linear = 0.1, quadratic = 0.02 }
    [[lights]]
    kind = "spot"
    position = [-2.0, 2.0, 3.0]
    direction = [2.0, -2.0, -3.0]
    cutoff_deg = 17.0
    exponent = 3.0
    color = [0.9, 0.8, 0.2]
    [materials.own]
    lobes = [
        { shape = "ambient", tint = [0.2, 0.3, 0.4] },
        { shape = "lambert", tint = [0.7, 0.3, 0.2] },
        { shape = "phong", tint = [0.4, 0.35, 0.3], shininess = 12.0 },
    ]
    [[objects]]
    mesh = "sphere"
    material = "own"
    [[objects]]
    mesh = "cube"
    material = "own"
    translate = [1.6, 0.2, -0.5]
    scale = [0.5, 0.7, 0.6]
    rotate_deg = { axis = [1.0, 2.0, 0.3], angle = 40.0 }
"#;

fn scene(program: Program) -> Scene {
    let opened = glanz_scene::file::parse_str(SCENE, "".as_ref(), &Default::default());
    let mut scene = opened.expect("it is right").scene;
    scene.set_program(program);
    scene
}

fn program(vertex: Option<&str>, fragment: &str, ending: &str) -> Program {
    let text = |stage: &str, text: &str| ProgramText::new(format!("own.{stage}{ending}"), text);
    Program { vertex: vertex.map(|own| text("vert", own)), ..Program::of_fragment(text("frag", fragment)) }
}

/// Every device, by what only it is called.
fn all() -> Vec<Choice> {
    let found = devices();
    if found.is_empty() {
        eprintln!(
            "\n!!! SKIPPED: no device answers by Vulkan, Metal, DirectX 12 or OpenGL; nothing was drawn by a GPU\n"
        );
    }
    found.iter().map(|info| Choice::Named(format!("{} {}", info.name, info.api))).collect()
}

/// A scene by the CPU and by a device, as codes: the greatest difference where both show the same surface, and how many
/// pixels differ by more than that at the borders of surfaces.
fn compare(scene: &Scene, choice: &Choice) -> (u8, usize) {
    let shot = || Shot::new(scene).unwrap_or_else(|error| panic!("{error}"));
    let cpu = shot().rgba8().expect("the CPU draws it");
    let gpu = Gpu::open(choice).expect("it was listed");
    let gpu = shot().on(Box::new(gpu)).rgba8().unwrap_or_else(|error| panic!("{error}"));
    let (width, height) = (shot().view().width as usize, shot().view().height as usize);
    let objects = shot()
        .frame_in_steps(Aovs { object: true, ..Aovs::default() }, &mut |_| ())
        .expect("the CPU draws it")
        .object;
    let at = |x: usize, y: usize| objects[y * width + x];
    let (mut most, mut beyond) = (0, 0);
    for y in 0..height {
        for x in 0..width {
            let pixel = 4 * (y * width + x);
            let apart = (0..4).map(|c| cpu[pixel + c].abs_diff(gpu[pixel + c])).max().unwrap_or(0);
            let own = at(x, y);
            let inside = [(x.wrapping_sub(1), y), (x + 1, y), (x, y.wrapping_sub(1)), (x, y + 1)]
                .into_iter()
                .all(|(x, y)| x >= width || y >= height || at(x, y) == own);
            match inside {
                true => most = most.max(apart),
                false => beyond += usize::from(apart > 2),
            }
        }
    }
    (most, beyond)
}

/// Within 2 of 255, but for a few pixels at borders, where rounding decides on which side their middle lies.
fn assert_same(what: &str, scene: &Scene, choice: &Choice) {
    let (most, beyond) = compare(scene, choice);
    assert!(most <= 2 && beyond <= 4, "{what} by {choice:?}: {most} of 255, and {beyond} pixels at borders");
}

#[test]
fn default_programs_are_drawn_as_by_the_cpu() {
    for choice in all() {
        for own in DefaultProgram::all() {
            let text = |stage| Some(ProgramText::new(own.file_name(stage), own.text(stage)));
            let program = Program {
                vertex: text(Stage::Vertex),
                fragment: text(Stage::Fragment),
                ..Program::default()
            };
            assert_same(own.name, &scene(program), &choice);
        }
    }
}

#[test]
fn what_goes_between_the_stages_arrives() {
    let vertex = "#version 330
        in vec3 position; in vec3 normal; in vec2 uv;
        uniform mat4 mvp; uniform mat3 normalMatrix; uniform bool mirrored; uniform float weights[3];
        out vec3 n; out mat2 turn; flat out int kind; flat out float first; noperspective out vec2 where;
        void main() {
            n = normalMatrix * normal; turn = mat2(0.6, 0.8, -0.8, 0.6); kind = mirrored ? 3 : 4;
            first = position.x; where = uv * weights[1] + weights[2];
            gl_Position = mvp * vec4(position * (gl_VertexID >= 0 ? 1.0 : 0.0), 1.0);
        }";
    let fragment = "#version 330
        in vec3 n; in mat2 turn; flat in int kind; flat in float first; noperspective in vec2 where;
        out vec4 color;
        void main() {
            if (fract(where.x * 4.0) < 0.3) discard;
            float front = gl_FrontFacing ? 1.0 : 0.5;
            color = vec4(front * abs(normalize(n)).xy, 0.25 * float(kind - 3) + abs(first) * 0.5, 1.0);
            color.rg += 0.1 * turn * fract(where);
        }";
    let own = program(Some(vertex), fragment, "").with_uniform("weights", &[0.0, 0.7, 0.1]);
    all().iter().for_each(|choice| assert_same("varyings", &scene(own.clone()), choice));
}

#[test]
fn rows_count_from_the_bottom_and_derivatives_go_up() {
    let fragment = "#version 330
        in vec3 position; out vec4 color;
        void main() {
            vec2 place = gl_FragCoord.xy / vec2(160.0, 120.0);
            vec3 facet = normalize(cross(dFdx(position), dFdy(position)));
            color = vec4(place, 0.5, 1.0) * 0.5 + vec4(0.5 * facet + 0.5, 1.0) * 0.5;
        }";
    all().iter().for_each(|choice| assert_same("places", &scene(program(None, fragment, "")), choice));
}

#[test]
fn a_program_may_say_how_deep_its_fragments_are() {
    // The cube, which is behind the ball's right side, comes before it.
    let fragment = "#version 330
        in vec3 position; in vec3 normal; out vec4 color;
        void main() { color = vec4(0.5 * normalize(normal) + 0.5, 1.0); gl_FragDepth = 1.0 - gl_FragCoord.z; }";
    all().iter().for_each(|choice| assert_same("depths", &scene(program(None, fragment, "")), choice));
}

#[test]
fn textures_are_looked_into_with_their_wraps() {
    let fragment = "#version 330
        in vec2 uv; uniform sampler2D image; out vec4 color;
        void main() { color = texture(image, uv * 3.0) + textureLod(image, uv * 2.0, 1.0) * 0.25; }";
    let mut scene = scene(program(None, fragment, ""));
    let rgba: Vec<u8> = (0..32 * 32u32)
        .flat_map(|texel| [(texel % 32 * 8) as u8, (texel / 32 * 8) as u8, (texel * 3 % 256) as u8 / 2, 255])
        .collect();
    let texture = glanz_scene::Texture { width: 32, height: 32, rgba, ..Default::default() };
    scene.textures.push(texture);
    let own = glanz_scene::UniformValue::Texture(scene.textures.len() - 1);
    scene.programs[0].uniforms.insert("image".to_owned(), own);
    for choice in all() {
        // Devices find the level of detail by approximations of their own, and at grazing borders it changes most.
        let (most, _) = compare(&scene, &choice);
        assert!(most <= 6, "{choice:?}: {most} of 255");
    }
}

#[test]
fn wgsl_keeps_its_blocks() {
    let text = "struct Given { @builtin(position) place: vec4f, @location(0) normal: vec3f }
        struct Settings { mvp: mat4x4f, tint: vec3f, power: f32 }
        @group(1) @binding(7) var<uniform> settings: Settings;
        @vertex fn vs(@location(0) position: vec3f, @location(1) normal: vec3f) -> Given {
            return Given(settings.mvp * vec4f(position, 1.0), normal);
        }
        @fragment fn fs(given: Given) -> @location(0) vec4f {
            return vec4f(settings.tint * pow(abs(normalize(given.normal)), vec3f(settings.power)), 1.0);
        }";
    let own = program(Some(text), text, ".wgsl")
        .with_uniform("settings.tint", &[0.9, 0.6, 0.3])
        .with_uniform("settings.power", &[2.5]);
    all().iter().for_each(|choice| assert_same("WGSL", &scene(own.clone()), choice));
}

#[test]
fn several_samples_cover_borders_as_the_cpus_do() {
    let fragment = "#version 330\nout vec4 color; void main() { color = vec4(0.8, 0.4, 0.2, 1.0); }";
    let mut scene = scene(program(None, fragment, ""));
    scene.image.samples = 8;
    scene.image.background = Background::Transparent;
    for choice in all() {
        let cpu = Shot::new(&scene).unwrap().frame().unwrap();
        let gpu = Gpu::open(&choice).unwrap();
        let gpu = Shot::new(&scene).unwrap().on(Box::new(gpu)).frame().unwrap();
        let apart = |a: &[f32], b: &[f32]| a.iter().zip(b).filter(|(a, b)| (*a - *b).abs() > 2e-3).count();
        let partly = cpu.alpha.iter().filter(|alpha| **alpha > 0.0 && **alpha < 1.0).count();
        assert!(partly > 100, "borders are there");
        // A sample may lie on the very edge.
        assert!(apart(&cpu.alpha, &gpu.alpha) <= 4, "{} of {partly}", apart(&cpu.alpha, &gpu.alpha));
        assert!(apart(&cpu.rgb[0], &gpu.rgb[0]) <= 4, "premultiplied");
    }
}

#[test]
fn what_is_not_drawn_is_said() {
    let fragment = "#version 330\nout vec4 color; void main() { color = vec4(float(gl_PrimitiveID)); }";
    let own = scene(program(None, fragment, ""));
    for choice in all() {
        let gpu = Gpu::open(&choice).unwrap();
        let error = Shot::new(&own).unwrap().on(Box::new(gpu)).rgba8().unwrap_err();
        assert!(
            matches!(&error, ShotError::Backend(_)) && error.to_string().contains("gl_PrimitiveID"),
            "{error}"
        );
    }
    let mut materials = own;
    (materials.program, materials.programs) = (None, Vec::new());
    let shot = Shot::new(&materials).unwrap();
    let error = Gpu::check(shot.prepared(), &DrawOptions::new(Background::Transparent)).unwrap_err();
    assert!(error.to_string().contains("object 1 of the scene has none"), "{error}");
}

#[test]
fn devices_that_are_not_there_are_named_with_those_that_are() {
    let error = Gpu::open(&Choice::Named("warp drive".to_owned())).err().expect("there is none");
    match devices().first() {
        Some(first) => assert!(error.to_string().contains(&first.to_string()), "{error}"),
        None => assert_eq!(error, GpuError::None),
    }
}
