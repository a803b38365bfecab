//! Programs of the user's own: each to begin with equals the model that it is written after, and the pipeline around
//! them does what OpenGL's does.

use glanz_math::SimdLevel;
use glanz_render::cpu::Renderer;
use glanz_render::{
    Backend, Change, DrawOptions, NOT_REACHED, PrepareError, PrepareOptions, Prepared, Samples, Shot,
    ShotError, View, prepare,
};
use glanz_scene::{Background, Program, ProgramText, Scene};
use glanz_shader::{DefaultProgram, Stage};

const LIGHTS: &str = r#"
    [ambient]
    color = [0.2, 0.25, 0.3]
    [[lights]]
    kind = "directional"
    direction = [-1.0, -1.0, -2.0]
    diffuse = [0.5, 0.4, 0.3]
    specular = [0.6, 0.6, 0.5]
    ambient = [0.1, 0.0, 0.05]
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
"#;

/// A ball and a cube of a material of this highlight, under a light of each kind.
fn scene(highlight: &str) -> Scene {
    let text = format!(
        r#"
        [image]
        width = 160
        height = 120
        samples = 1
        [camera]
        eye = [0.5, 0.8, 5.0]
        fov_deg = 40.0
        {LIGHTS}
        [materials.own]
        lobes = [
            {{ shape = "ambient", tint = [0.2, 0.3, 0.4] }},
            {{ shape = "lambert", tint = [0.7, 0.3, 0.2] }},
            {highlight}
            {{ shape = "emission", tint = [0.01, 0.02, 0.0] }},
        ]
        [[objects]]
        mesh = "sphere"
        material = "own"
        [[objects]]
        mesh = "cube"
        material = "own"
        translate = [1.6, 0.2, -0.5]
        scale = [0.5, 0.7, 0.6]
        rotate_deg = {{ axis = [1.0, 2.0, 0.3], angle = 40.0 }}
        "#
    );
    glanz_scene::file::parse_str(&text, "".as_ref(), &Default::default()).expect("it is right").scene
}

/// The exponent of the spot.
const SPOT_EXPONENT: f32 = 3.0;
/// The exponent of highlights, and about that of the widths below.
const EXPONENT: f32 = 12.0;

fn highlight(model: &str) -> String {
    let parameter = match model {
        "lambert" => return String::new(),
        "cook-torrance" => "m = 0.3",
        "ggx" => "alpha = 0.35, multiscatter = 0.0",
        "ward" => "alpha = 0.2",
        _ => "shininess = 12.0",
    };
    format!("{{ shape = \"{model}\", tint = [0.4, 0.35, 0.3], {parameter} }},")
}

fn with_program(mut scene: Scene, program: Program) -> Scene {
    scene.set_program(program);
    scene
}

fn prepared(scene: &Scene) -> Prepared {
    prepare(scene, &PrepareOptions::default()).unwrap_or_else(|error| panic!("{error}"))
}

fn text(program: &DefaultProgram, stage: Stage) -> ProgramText {
    ProgramText::new(program.file_name(stage), program.text(stage))
}

fn of_fragment(text: &str) -> Program {
    Program::of_fragment(ProgramText::new("own.frag", text))
}

/// The greatest difference of two frames where both show something, by the light or by 1 where that is more, and how many pixels show something in one alone.
fn difference(a: &Scene, b: &Scene) -> (f32, usize) {
    let [a, b] = [a, b].map(|scene| {
        let mut shot = Shot::new(scene).unwrap_or_else(|error| panic!("{error}"));
        shot.frame().unwrap_or_else(|error| panic!("{error}"))
    });
    let (mut most, mut alone) = (0.0_f32, 0);
    for y in 0..a.height {
        for x in 0..a.width {
            let (p, q) = (a.pixel(x, y), b.pixel(x, y));
            match (p[3] > 0.0, q[3] > 0.0) {
                (true, true) => (0..3).for_each(|c| most = most.max((p[c] - q[c]).abs() / p[c].max(1.0))),
                (false, false) => {}
                _ => alone += 1,
            }
        }
    }
    (most, alone)
}

#[test]
fn programs_to_begin_with_are_their_models() {
    for program in DefaultProgram::all() {
        let Some(model) = program.model else { continue };
        let mut built_in = scene(&highlight(model));
        built_in.image.background = Background::Transparent;
        let fragment = Program::of_fragment(text(program, Stage::Fragment));
        let (most, alone) = difference(&built_in, &with_program(built_in.clone(), fragment));
        // Rounding of a cosine counts as often as its exponent says.
        let bound = 1e-6 * if model == "lambert" { SPOT_EXPONENT } else { EXPONENT };
        // Where the vertex shader is ours, the pixels are the same ones.
        assert_eq!(alone, 0, "{}", program.name);
        assert!(most <= bound, "{}: {most:e}", program.name);
        let both = Program {
            vertex: Some(text(program, Stage::Vertex)),
            ..Program::of_fragment(text(program, Stage::Fragment))
        };
        let (most, alone) = difference(&built_in, &with_program(built_in.clone(), both));
        // Where it is the user's, rounding may move a silhouette by a step of 1/256 pixel.
        assert!(alone <= 2 && most <= bound, "{}: {most:e}, {alone}", program.name);
    }
}

#[test]
fn without_exponents_a_program_is_its_model_to_1e_6() {
    let mut built_in = scene("");
    built_in.image.background = Background::Transparent;
    built_in.lights.retain(|light| !matches!(light.kind, glanz_scene::LightKind::Spot { .. }));
    let lambert = DefaultProgram::named("lambert-330").expect("it is listed");
    let fragment = Program::of_fragment(text(lambert, Stage::Fragment));
    let (most, alone) = difference(&built_in, &with_program(built_in.clone(), fragment));
    assert!(alone == 0 && most <= 1e-6, "{most:e}, {alone}");
}

/// Pictures of a small scene with this fragment shader, transparent behind it.
fn drawn(fragment: &str) -> glanz_render::Frame {
    let mut scene = with_program(scene(""), of_fragment(fragment));
    scene.image.background = Background::Transparent;
    Shot::new(&scene)
        .unwrap_or_else(|error| panic!("{error}"))
        .frame()
        .unwrap_or_else(|error| panic!("{error}"))
}

const GOURAUD_LIKE: &str = "#version 330\nin vec3 pos; in vec3 normal; uniform mat4 mvp; uniform mat3 normalMatrix;\n\
    out vec3 smoothed; flat out vec3 faceted; noperspective out vec2 linear;\n\
    void main() { smoothed = normalMatrix * normal; faceted = smoothed; linear = pos.xy; gl_Position = mvp * vec4(pos, 1.0); }";

/// A scene with texture, blending, discard and an own vertex shader, for the same bits everywhere.
fn busy() -> Scene {
    let fragment = "#version 330\nin vec3 smoothed; flat in vec3 faceted; noperspective in vec2 linear; out vec4 c;\n\
        void main() { if (fract(8.0 * linear.x) < 0.3) discard; vec2 d = vec2(dFdx(linear.x), dFdy(linear.y));\n\
        c = vec4(0.5 + 0.5 * mix(normalize(smoothed), faceted, 0.3), 1.0) + vec4(abs(d) * 5.0, gl_FragCoord.z, 0.0); }";
    let program = Program {
        vertex: Some(ProgramText::new("own.vert", GOURAUD_LIKE)),
        ..Program::of_fragment(ProgramText::new("own.frag", fragment))
    };
    with_program(scene(&highlight("phong")), program)
}

#[test]
fn every_simd_level_gives_the_same_bits() {
    for samples in [Samples::One, Samples::Four] {
        let prepared = prepared(&busy());
        let camera = busy().camera.expect("it has one");
        let view = View::new(&camera, 160, 120).expect("it can be drawn");
        let options = DrawOptions { samples, ..DrawOptions::new(Background::Transparent) };
        let mut frames = SimdLevel::available()
            .into_iter()
            .map(|(name, level)| (name, Renderer::with_level(level).draw(&prepared, &view, &options)));
        let (_, first) = frames.next().expect("there is a narrowest level");
        assert!(first.alpha.iter().any(|alpha| *alpha > 0.0));
        for (name, frame) in frames {
            let bits = |frame: &glanz_render::Frame| {
                frame.rgb.each_ref().map(|p| p.iter().map(|v| v.to_bits()).collect::<Vec<_>>())
            };
            assert_eq!(bits(&first), bits(&frame), "{name}");
        }
    }
}

#[test]
fn places_of_fragments_count_from_the_lower_left() {
    let frame = drawn(
        "#version 330\nout vec4 c; void main() { c = vec4(gl_FragCoord.xy, gl_FrontFacing ? 1.0 : 0.0, 1.0); }",
    );
    let [x, y] = [70, 50];
    assert_eq!(frame.pixel(x, y), [70.5, 120.0 - 50.5, 1.0, 1.0]);
}

#[test]
fn derivatives_are_those_of_the_triangle_and_do_not_see_its_neighbours() {
    // Steps of the place on the screen are 1, on edges of triangles and of objects too.
    let frame = drawn(
        "#version 330\nout vec4 c; void main() { c = vec4(dFdx(gl_FragCoord.x), dFdy(gl_FragCoord.y), 0.0, 1.0); }",
    );
    let seen = (0..frame.width * frame.height).filter(|at| frame.alpha[*at] > 0.0);
    assert!(seen.clone().count() > 2000);
    for at in seen {
        assert_eq!([frame.rgb[0][at], frame.rgb[1][at]], [1.0, 1.0]);
    }
}

#[test]
fn discarded_fragments_show_what_is_behind() {
    let holes = "#version 330\nout vec4 c; void main() { if (mod(gl_FragCoord.x, 8.0) < 4.0) discard; c = vec4(1.0); }";
    let frame = drawn(holes);
    let row = 60 * frame.width;
    for x in 60..90 {
        let expected = if x % 8 < 4 { 0.0 } else { 1.0 };
        assert_eq!(frame.alpha[row + x], expected, "column {x}");
    }
}

#[test]
fn triangles_beyond_the_near_plane_are_clipped_with_their_varyings() {
    // A plane on which one walks, from behind the eye to the horizon.
    let text = r#"
        [image]
        width = 64
        height = 48
        samples = 1
        [camera]
        eye = [0.0, 1.0, 0.0]
        target = [0.0, 0.0, -3.0]
        [[objects]]
        mesh = "plane"
        scale = 40.0
    "#;
    let scene =
        glanz_scene::file::parse_str(text, "".as_ref(), &Default::default()).expect("it is right").scene;
    let vertex = "#version 330\nin vec3 pos; uniform mat4 model; uniform mat4 mvp; out vec3 world;\n\
        void main() { world = (model * vec4(pos, 1.0)).xyz; gl_Position = mvp * vec4(pos, 1.0); }";
    let fragment = "#version 330\nin vec3 world; out vec4 c; void main() { c = vec4(world, 1.0); }";
    let own = Program {
        vertex: Some(ProgramText::new("own.vert", vertex)),
        ..Program::of_fragment(ProgramText::new("own.frag", fragment))
    };
    let stand_in =
        of_fragment("#version 330\nin vec3 position; out vec4 c; void main() { c = vec4(position, 1.0); }");
    let mut both = [own, stand_in].map(|program| with_program(scene.clone(), program));
    both.iter_mut().for_each(|scene| scene.image.background = Background::Transparent);
    let frame = Shot::new(&both[0]).expect("it can be drawn").frame().expect("it ends");
    assert!(frame.alpha[47 * 64..].iter().all(|alpha| *alpha == 1.0), "the plane goes on below the eye");
    let other = Shot::new(&both[1]).expect("it can be drawn").frame().expect("it ends");
    for y in 20..48 {
        for x in 0..64 {
            let (p, q) = (frame.pixel(x, y), other.pixel(x, y));
            // A pixel shows distance² / 60 of the plane: a hundredth of that.
            let squared = p[0] * p[0] + 1.0 + p[2] * p[2];
            let error = (0..3).map(|c| (p[c] - q[c]).abs()).fold(0.0, f32::max);
            assert!(p[3] == q[3] && error <= 2e-4 * squared, "{x},{y}: {p:?} {q:?}");
        }
    }
}

#[test]
fn a_loop_without_end_is_an_error_with_its_line() {
    let endless = "#version 330\nuniform float zero; out vec4 c;\nvoid main() {\n  float x = 1.0;\n  while (x > zero) { x += 0.5; }\n  c = vec4(x);\n}";
    let scene = with_program(scene(""), of_fragment(endless));
    let error = Shot::new(&scene).expect("it compiles").frame().expect_err("it does not end");
    assert!(matches!(error, ShotError::Backend(_)) && error.to_string().starts_with("own.frag:5"), "{error}");
}

#[test]
fn uniforms_that_are_not_there_are_refused_with_near_names() {
    let text = "#version 330\nuniform float exposure = 2.0; out vec4 c; void main() { c = vec4(exposure); }";
    let program = |name: &str, values: &[f64]| of_fragment(text).with_uniform(name, values);
    let error = |program| match prepare(&with_program(scene(""), program), &PrepareOptions::default()) {
        Err(PrepareError::Program(error)) => error.to_string(),
        other => panic!("{other:?}"),
    };
    assert!(error(program("exposur", &[1.0])).contains("did you mean 'exposure'"));
    assert!(error(program("exposure", &[1.0, 2.0])).contains("float of 1 numbers, not 2"));
    // The source's own value, and the user's.
    let value = |program| {
        let frame =
            Shot::new(&with_program(scene(""), program)).expect("it is right").frame().expect("it ends");
        frame.pixel(75, 60)[0]
    };
    assert_eq!([value(of_fragment(text)), value(program("exposure", &[0.25]))], [2.0, 0.25]);
}

#[test]
fn programs_of_objects_come_before_that_of_the_scene() {
    let color =
        |value: &str| of_fragment(&format!("#version 330\nout vec4 c; void main() {{ c = vec4({value}); }}"));
    let mut scene = with_program(scene(""), color("0.25"));
    scene.programs.push(color("0.75"));
    scene.objects[1].program = Some(1);
    let mut prepared = prepared(&scene);
    let camera = scene.camera.expect("it has one");
    let view = View::new(&camera, 160, 120).expect("it can be drawn");
    let options = DrawOptions::new(Background::Transparent);
    let colors = |prepared: &Prepared| {
        let frame = Renderer::new().draw(prepared, &view, &options);
        let seen: std::collections::BTreeSet<u32> = frame.rgb[0]
            .iter()
            .zip(&frame.alpha)
            .filter(|(_, alpha)| **alpha > 0.0)
            .map(|(v, _)| v.to_bits())
            .collect();
        seen.into_iter().map(f32::from_bits).collect::<Vec<_>>()
    };
    assert_eq!(colors(&prepared), [0.25, 0.75]);
    // A new text, and nothing else is prepared anew; a wrong one changes nothing.
    let old = scene.clone();
    scene.set_program(color("0.5"));
    assert_eq!(Change::between(&old, &scene), [Change::Programs]);
    prepared.update(&scene, &[Change::Programs]).expect("it compiles");
    assert_eq!(colors(&prepared), [0.5, 0.75]);
    scene.set_program(color("0.5 +"));
    assert!(prepared.update(&scene, &[Change::Programs]).is_err());
    assert_eq!(colors(&prepared), [0.5, 0.75]);
}

#[test]
fn x_rays_are_the_pictures_own_values() {
    let text = "#version 330\nin vec3 normal; out vec4 c;\nvoid main() {\n  vec3 n = normalize(normal);\n  \
        float up = n.y;\n  float seen = 0.0;\n  if (up > 0.0) {\n    seen = sqrt(up);\n  }\n  c = vec4(n.xy, seen, 1.0);\n}";
    let mut scene = with_program(scene(""), of_fragment(text));
    scene.image.background = Background::Transparent;
    let mut shot = Shot::new(&scene).expect("it compiles");
    let picture = shot.frame().expect("it ends");
    let values = shot.value_frame("up", Some(5)).expect("it has a program").frame;
    let branch = shot.value_frame("seen", Some(8)).expect("it has a program");
    assert!(branch.met.keys().any(|(line, name)| (*line, name.as_str()) == (8, "seen")));
    let mut skipped = 0;
    for at in (0..picture.width * picture.height).filter(|at| picture.alpha[*at] > 0.0) {
        assert_eq!(values.rgb[0][at].to_bits(), picture.rgb[1][at].to_bits());
        let seen = branch.frame.rgb[0][at];
        skipped += usize::from(seen == NOT_REACHED);
        assert!(seen == NOT_REACHED || seen.to_bits() == picture.rgb[2][at].to_bits());
    }
    assert!(skipped > 1000, "the lower half does not come there");
    let xray = shot.xray(75, 60).expect("it has a program").expect("the sphere is there");
    let c = xray.trace.of_lane(xray.lane).filter(|record| record.name == "c").last().expect("it is written");
    assert_eq!(c.values(xray.lane)[..3], picture.pixel(75, 60)[..3]);
    assert!(shot.xray(1, 1).expect("it has a program").is_none(), "nothing is there");
    let vertex = shot.xray_vertex(0, 3).expect("it has a program").expect("a sphere has more vertices");
    assert!(vertex.trace.of_lane(vertex.lane).count() > 0);
    assert!(shot.xray_vertex(0, 1 << 20).expect("it has a program").is_none());
}

#[test]
fn colours_of_programs_are_linear_srgb_in_every_mode() {
    let text = "#version 330\nout vec4 c; void main() { c = vec4(0.25, 0.5, 0.75, 1.0); }";
    let mut scene = with_program(scene(""), of_fragment(text));
    scene.render.mode = glanz_scene::ColorMode::Spectral;
    let mut shot = Shot::new(&scene).expect("it compiles");
    let frame = shot.frame().expect("it ends");
    let [r, g, b, _] = shot.on_screen(frame).expect("it is this observer's").pixel(75, 60);
    for (found, wanted) in [r, g, b].into_iter().zip([0.25, 0.5, 0.75]) {
        assert!((found - wanted).abs() < 1e-5, "{found} {wanted}");
    }
    scene.render.mode = glanz_scene::ColorMode::Reference;
    assert!(Shot::new(&scene).is_err_and(|error| error.to_string().contains("no spectra")));
}

#[test]
fn a_program_may_say_how_deep_its_fragments_are() {
    // The sphere in front would hide the cube; told to be far away, it hides nothing.
    let near = "#version 330\nout vec4 c; void main() { c = vec4(0.25); gl_FragDepth = gl_FragCoord.z; }";
    let far = near.replace("gl_FragDepth = gl_FragCoord.z", "gl_FragDepth = 1.0");
    let picture = |text: &str| {
        let mut scene =
            with_program(scene(""), of_fragment("#version 330\nout vec4 c; void main() { c = vec4(0.75); }"));
        scene.image.background = Background::Transparent;
        scene.objects[1].transform = glam::DMat4::from_translation([0.0, 0.0, -2.0].into());
        scene.programs.push(of_fragment(text));
        scene.objects[0].program = Some(1);
        Shot::new(&scene).expect("it compiles").frame().expect("it ends").pixel(72, 62)[0]
    };
    assert_eq!([picture(near), picture(&far)], [0.25, 0.75]);
}

#[test]
fn what_a_program_draws_has_no_lobes_to_be_told_apart() {
    let scene =
        with_program(scene(""), of_fragment("#version 330\nout vec4 c; void main() { c = vec4(0.5); }"));
    let mut shot = Shot::new(&scene).expect("it compiles");
    assert!(matches!(shot.probe(75, 60), Err(ShotError::ByProgram { x: 75, y: 60 })));
    assert!(shot.probe(1, 1).expect("nothing is there").surface.is_none());
}
