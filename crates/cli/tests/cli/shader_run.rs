//! `glanz shader run`: a fragment shader alone.

use crate::folder::Folder;

const TOY: &str = "\
void mainImage(out vec4 color, in vec2 at) {
    color = vec4(at / iResolution.xy, fract(iTime), 1.0);
}
";

fn folder() -> Folder {
    let folder = Folder::new();
    folder.write("toy.frag", TOY);
    folder
}

/// Size and RGB codes of a PNG.
fn pixels(bytes: &[u8]) -> (u32, u32, Vec<[u8; 3]>) {
    let mut decoder = png::Decoder::new(std::io::Cursor::new(bytes));
    decoder.set_transformations(png::Transformations::EXPAND);
    let mut reader = decoder.read_info().unwrap();
    let mut codes = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut codes).unwrap();
    let n = info.color_type.samples();
    (info.width, info.height, codes.chunks_exact(n).map(|c| [c[0], c[1], c[2]]).collect())
}

#[test]
fn a_picture_is_bottom_up_and_as_it_is() {
    let folder = folder();
    let run = folder.glanz(&["shader", "run", "toy.frag", "--size", "4x2", "--time", "0.5", "-o", "toy.png"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, "wrote toy.png\n"));
    let (width, height, codes) = pixels(&folder.read("toy.png"));
    assert_eq!((width, height), (4, 2));
    assert_eq!(codes[0], [32, 191, 128], "the upper left pixel: (0.5, 1.5) / (4, 2), not decoded or encoded");
    assert_eq!(codes[7], [223, 64, 128]);
}

#[test]
fn the_picture_is_the_same_for_every_number_of_threads() {
    let folder = folder();
    folder.write("noise.frag", "void main() { vec2 p = gl_FragCoord.xy; gl_FragColor = vec4(fract(sin(dot(p, vec2(12.9898, 78.233))) * 43758.5453), fwidth(p.x * p.y) * 0.01, sin(p)); }");
    for threads in ["1", "2", "3"] {
        let name = format!("{threads}.png");
        folder
            .glanz(&["shader", "run", "noise.frag", "--size", "83x61", "--threads", threads, "-o", &name])
            .text();
        assert_eq!(folder.read(&name), folder.read("1.png"), "{threads} threads");
    }
}

#[test]
fn a_film_goes_on_in_time() {
    let folder = folder();
    let run = folder.glanz(&[
        "shader",
        "run",
        "toy.frag",
        "--size",
        "4x2",
        "--frames",
        "0..3",
        "--fps",
        "4",
        "-o",
        "t{frame}.png",
    ]);
    assert_eq!(run.stderr, "wrote 3 files, t0.png to t2.png\n");
    let blue = |name: &str| pixels(&folder.read(name)).2[0][2];
    assert_eq!(["t0.png", "t1.png", "t2.png"].map(blue), [0, 64, 128]);
    folder.glanz(&["shader", "run", "toy.frag", "--size", "4x2", "--frames", "0..3", "-o", "t.gif"]).text();
    assert!(folder.read("t.gif").starts_with(b"GIF89a"));
}

#[test]
fn a_texture_stands_upright_and_its_size_is_told() {
    let folder = folder();
    folder.glanz(&["shader", "run", "toy.frag", "--size", "4x2", "--time", "0.5", "-o", "toy.png"]).text();
    folder.write(
        "look.frag",
        "void mainImage(out vec4 c, vec2 p) { c = texture(iChannel0, p / iChannelResolution[0].xy); }",
    );
    let words = ["shader", "run", "look.frag", "--size", "4x2", "--channel0", "toy.png", "-o", "look.png"];
    assert_eq!(folder.glanz(&words).stderr, "wrote look.png\n");
    assert_eq!(pixels(&folder.read("look.png")), pixels(&folder.read("toy.png")));
    let run = folder.glanz(&["shader", "run", "look.frag", "--size", "4x2", "-o", "look.png"]);
    assert!(run.stderr.contains("no picture is given for 'iChannel0'"), "{}", run.stderr);
    assert!(run.stderr.contains("all pixels are black"), "{}", run.stderr);
}

#[test]
fn a_cube_map_is_a_panorama_six_files_or_a_pattern_of_their_names() {
    let folder = folder();
    for (number, face) in ["px", "nx", "py", "ny", "pz", "nz"].into_iter().enumerate() {
        let text = format!("void main() {{ gl_FragColor = vec4({number}.0 / 5.0, 0.5, 1.0, 1.0); }}");
        folder.write("face.frag", &text);
        let file = format!("sky_{face}.png");
        folder.glanz(&["shader", "run", "face.frag", "--size", "4x4", "-o", &file]).text();
    }
    folder.write(
        "look.frag",
        "uniform samplerCube sky; uniform vec3 d; void main() { gl_FragColor = textureCube(sky, d); }",
    );
    let red = |texture: &str, d: &str| {
        let (texture, d) = (format!("sky={texture}"), format!("d={d}"));
        let words = ["shader", "run", "look.frag", "--size", "1x1", "--texture", &texture, "--uniform", &d];
        let run = folder.glanz(&[&words[..], &["-o", "look.png"]].concat());
        assert_eq!(run.code, 0, "{}", run.stderr);
        pixels(&folder.read("look.png")).2[0][0]
    };
    assert_eq!([red("sky_*.png", "0,-1,0.2"), red("sky_*.png", "0,0.4,1")], [153, 204]);
    let files = ["px", "nx", "py", "ny", "pz", "nz"].map(|face| format!("sky_{face}.png"));
    assert_eq!(red(&files.join(","), "-1,0.3,0.3"), 51);
    folder.write("band.frag", "void main() { gl_FragColor = vec4(gl_FragCoord.x / 8.0); }");
    folder.glanz(&["shader", "run", "band.frag", "--size", "8x4", "-o", "band.png"]).text();
    assert_eq!(red("band.png", "1,0,-1"), 159, "+X is to the right of -Z, which is in the middle");
    folder.glanz(&["shader", "run", "band.frag", "--size", "8x8", "-o", "sky_px.png"]).text();
    let words =
        ["shader", "run", "look.frag", "--size", "1x1", "--texture", "sky=sky_*.png", "-o", "look.png"];
    let run = folder.glanz(&words);
    assert!(run.code == 2 && run.stderr.contains("squares of one size"), "{}", run.stderr);
}

#[test]
fn what_is_odd_is_told() {
    let folder = folder();
    folder.write("k.frag", "uniform float k; uniform sampler2D u_buffer0; void main() { gl_FragColor = vec4(sqrt(k - gl_FragCoord.x + 2.0)); }");
    let run = folder.glanz(&["shader", "run", "k.frag", "--size", "4x2", "-o", "k.png"]);
    assert_eq!(run.code, 0, "a texture that is not looked into is none: {}", run.stderr);
    assert!(run.stderr.contains("nothing fills 'k'"), "{}", run.stderr);
    assert!(
        run.stderr.contains("4 pixels are not a number (NaN) and magenta, the first at 2,0"),
        "{}",
        run.stderr
    );
    let run = folder.glanz(&["shader", "run", "k.frag", "--size", "4x2", "--uniform", "k=9", "-o", "k.png"]);
    assert_eq!(run.stderr, "wrote k.png\n");
    folder.write(
        "pass.frag",
        "uniform sampler2D u_buffer0; void main() { gl_FragColor = texture2D(u_buffer0, gl_FragCoord.xy); }",
    );
    let run = folder.glanz(&["shader", "run", "pass.frag", "--size", "4x2", "-o", "k.png"]);
    assert!(run.code == 3 && run.stderr.contains("another pass"), "{}", run.stderr);
    folder.write("black.frag", "void main() { gl_FragColor = vec4(0.0, 0.0, 0.0, 1.0); }");
    let run = folder.glanz(&["shader", "run", "black.frag", "--size", "4x2", "-o", "k.png"]);
    assert!(run.stderr.contains("all pixels are black"), "{}", run.stderr);
}

#[test]
fn an_endless_loop_is_an_error_with_its_line_and_leaves_no_file() {
    let folder = folder();
    folder.write(
        "e.frag",
        "void main() {\n  float x = 0.0;\n  for (;;) { x += 1.0; if (x < 0.0) break; }\n  gl_FragColor = vec4(x);\n}\n",
    );
    for output in ["e.png", "e.gif"] {
        let words = ["shader", "run", "e.frag", "--size", "8x8", "--frames", "0..1", "-o", output];
        let words = if output == "e.png" { [&words[..5], &words[7..]].concat() } else { words.to_vec() };
        let run = folder.glanz(&words);
        assert!(run.code == 3 && run.stderr.contains("e.frag:3:"), "{}", run.stderr);
        assert!(!folder.path(output).exists());
    }
}

#[test]
fn wrong_options_are_refused() {
    let folder = folder();
    for (more, said) in [
        (&["--uniform", "k=1"][..], "there is no uniform 'k'"),
        (&["--uniform", "iTime=1,2"], "1 numbers, not 2"),
        (&["--texture", "wood=a.png"], "looks into no texture 'wood'"),
        (&["--channel1", "a.png"], "'iChannel1' or 'u_tex1'"),
        (&["--mouse", "1"], "two numbers"),
        (&["--fps", "0"], "above 0"),
        (&["--frames", "0..2"], "no place for the number"),
    ] {
        let run = folder.glanz(&[&["shader", "run", "toy.frag", "-o", "a.png"], more].concat());
        assert!(run.code == 2 && run.stderr.contains(said), "{more:?}: {}", run.stderr);
    }
    let run = folder.glanz(&["shader", "run", "toy.frag", "-o", "a.exr"]);
    assert!(run.code == 2 && run.stderr.contains("not light"), "{}", run.stderr);
}

#[test]
fn the_example_without_a_scene_is_drawn() {
    let folder = Folder::new();
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/shaders/toy.frag");
    folder.write("toy.frag", std::fs::read(file).unwrap());
    let run = folder.glanz(&["shader", "run", "toy.frag", "--size", "64x36", "-o", "toy.png"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let (width, _, pixels) = pixels(&folder.read("toy.png"));
    let [ball, sky, floor] = [[32, 18], [32, 0], [8, 34]].map(|[x, y]| pixels[y * width as usize + x]);
    assert!(ball[0] > ball[2] + 40, "the ball is red: {ball:?}");
    assert!(sky[2] > sky[0] + 20, "the sky is blue: {sky:?}");
    assert!(floor[0].abs_diff(floor[2]) < 10, "the floor is grey: {floor:?}");
}

/// Adds a quarter to itself in each frame.
const SUM: &str = "
void mainImage(out vec4 c, in vec2 at) { c = texelFetch(iChannel0, ivec2(at), 0) + vec4(0.25, at.x, at.y, 0.0); }";

/// The upper left pixel of the picture at half a second, two frames in a second: frame 1.
fn pixel_of(folder: &Folder, words: &[&str]) -> [u8; 3] {
    let size = ["--size", "4x2", "--time", "0.5", "--fps", "2", "-o", "pass.png"];
    folder.glanz(&[&["shader", "run"], words, &size].concat()).text();
    pixels(&folder.read("pass.png")).2[0]
}

#[test]
fn passes_draw_for_others_and_for_themselves_in_the_next_frame() {
    let folder = folder();
    folder.write("sum.frag", SUM);
    folder.write("show.frag", "void mainImage(out vec4 c, in vec2 at) { c = texelFetch(iChannel0, ivec2(at), 0) * vec4(1.0, 0.25, 0.25, 1.0); }");
    let own = pixel_of(&folder, &["sum.frag", "--channel0", "self"]);
    assert_eq!(own, [128, 255, 255], "two frames of a quarter");
    // Numbers above 1 are kept: 2 · 0.5 · 0.25 and 2 · 1.5 · 0.25.
    let shown = pixel_of(&folder, &["show.frag", "--pass", "a=sum.frag,0=self", "--channel0", "a"]);
    assert_eq!(shown, [128, 64, 191]);
    // A pass that stands before the one that it reads has what that drew a frame ago; a file may be several passes.
    let passes = ["show.frag", "--pass", "b=sum.frag,0=a", "--pass", "a=sum.frag,0=a", "--channel0", "b"];
    assert_eq!(pixel_of(&folder, &passes)[0], 128, "a quarter of a frame ago and its own");
}

#[test]
fn texts_name_their_passes_and_pictures_themselves() {
    let folder = folder();
    folder.write("sum.glsl", format!("#iChannel0 \"self\"\n{SUM}"));
    folder.write(
        "show.glsl",
        "#iChannel0 \"file://sum.glsl\"\n#iChannel1 \"file://toy.png\"\n#iChannel1::WrapMode \"Clamp\"\n#iKeyboard\n\
         #iUniform float part = 0.5 in { 0.0, 1.0 }\n\
         void mainImage(out vec4 c, in vec2 at) {\n\
         c = vec4(texelFetch(iChannel0, ivec2(at), 0).r, texture(iChannel1, vec2(-3.0, 9.0)).g, part, 1.0); }",
    );
    folder.glanz(&["shader", "run", "toy.frag", "--size", "4x2", "-o", "toy.png"]).text();
    assert_eq!(pixel_of(&folder, &["show.glsl"]), [128, 191, 128]);
    assert_eq!(pixel_of(&folder, &["show.glsl", "--uniform", "part=1"]), [128, 191, 255]);
    let run = folder.glanz(&["shader", "run", "show.glsl", "--size", "4x2", "-o", "a.png"]);
    assert!(run.stderr.contains("show.glsl:4: '#iKeyboard' means nothing here"), "{}", run.stderr);
    folder.write("wrong.glsl", "#iChannel0 \"https://example.org/a.png\"\nvoid mainImage(out vec4 c, vec2 at) {\n c = texture(iChannel0, at) + nix; }");
    let run = folder.glanz(&["shader", "run", "wrong.glsl"]);
    assert!(run.stderr.contains("wrong.glsl:3:31"), "lines are counted as they are: {}", run.stderr);
    folder.write("wrong.glsl", "#iChannel0 \"https://example.org/a.png\"\nvoid mainImage(out vec4 c, vec2 at) { c = texture(iChannel0, at); }");
    let run = folder.glanz(&["shader", "run", "wrong.glsl"]);
    assert!(run.stderr.contains("is not fetched") && run.stderr.contains("wrong.glsl:1"), "{}", run.stderr);
}

#[test]
fn buffers_of_one_text_are_those_of_glsl_viewer() {
    let folder = folder();
    folder.write(
        "buffers.frag",
        "uniform sampler2D u_buffer0; uniform sampler2D u_doubleBuffer0; uniform vec2 u_resolution;
         void main() {
             vec2 at = gl_FragCoord.xy / u_resolution;
         #if defined(BUFFER_0)
             gl_FragColor = vec4(0.5);
         #elif defined(DOUBLE_BUFFER_0)
             gl_FragColor = texture2D(u_doubleBuffer0, at) + texture2D(u_buffer0, at) * 0.25;
         #else
             gl_FragColor = vec4(texture2D(u_doubleBuffer0, at).r, texture2D(u_buffer0, at).r, 1.0, 1.0);
         #endif
         }",
    );
    assert_eq!(pixel_of(&folder, &["buffers.frag"]), [64, 128, 255]);
    folder.write("back.frag", "uniform sampler2D backbuffer; void main() { gl_FragColor = texture2D(backbuffer, gl_FragCoord.xy / vec2(4.0, 2.0)) + 0.25; }");
    assert_eq!(pixel_of(&folder, &["back.frag"]), [128; 3]);
}

#[test]
fn a_film_that_begins_later_has_the_frames_of_the_whole_one() {
    let folder = folder();
    folder.write("sum.glsl", format!("#iChannel0 \"self\"\n{SUM}"));
    let film = |frames: &str, name: &str| {
        folder.glanz(&["shader", "run", "sum.glsl", "--size", "4x2", "--frames", frames, "-o", name]).text();
    };
    film("0..3", "whole_{frame}.png");
    film("2..3", "part_{frame}.png");
    assert_eq!(folder.read("whole_2.png"), folder.read("part_2.png"));
    assert_eq!(pixels(&folder.read("part_2.png")).2[0][0], 191);
}

#[test]
fn what_is_common_stands_in_front_of_all_passes() {
    let folder = folder();
    folder.write("common.glsl", "const float PART = 0.25;\nfloat part() { return PART; }\n");
    folder.write("a.glsl", "void mainImage(out vec4 c, in vec2 at) { c = vec4(part()); }");
    folder.write(
        "b.glsl",
        "void mainImage(out vec4 c, in vec2 at) { c = texture(iChannel0, vec2(0.5)) + vec4(part()); }",
    );
    let words = ["b.glsl", "--common", "common.glsl", "--pass", "a=a.glsl", "--channel0", "a"];
    assert_eq!(pixel_of(&folder, &words), [128; 3]);
    folder.write("common.glsl", "float part() { return 1.0 }\n");
    let run = folder.glanz(&[&["shader", "run"], &words[..]].concat());
    assert!(run.stderr.contains("common.glsl:1:23"), "{}", run.stderr);
    for (more, expected) in [
        (&["--pass", "a=a.glsl,7=self"][..], "'7=self' is no channel"),
        (&["--channel0", "c"], "'c' is neither a pass, self, nor a file"),
        (&["--pass", "self=a.glsl"], "the name is taken"),
    ] {
        folder.write("common.glsl", "float part() { return 1.0; }\n");
        let run = folder.glanz(&[&["shader", "run", "b.glsl", "--common", "common.glsl"], more].concat());
        assert!(run.code != 0 && run.stderr.contains(expected), "{}", run.stderr);
    }
}

#[test]
fn the_example_with_two_passes_is_drawn() {
    let folder = Folder::new();
    let file = |name: &str| format!("{}/../../examples/shaders/{name}", env!("CARGO_MANIFEST_DIR"));
    for name in ["pond.glsl", "ripples.glsl"] {
        folder.write(name, std::fs::read(file(name)).unwrap());
    }
    let run =
        folder.glanz(&["shader", "run", "pond.glsl", "--size", "64x36", "--time", "2", "-o", "pond.png"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, "wrote pond.png\n"));
    let (_, _, codes) = pixels(&folder.read("pond.png"));
    let bright = codes.iter().filter(|code| code[0] > 150).count();
    assert!((20..1000).contains(&bright), "the lamp is mirrored: {bright}");
}

#[test]
fn texts_of_editors_have_a_main_and_include_from_where_they_are() {
    let folder = folder();
    folder.write("math/one.glsl", "#pragma once\nfloat one() { return 1.0; }\n");
    folder.write("noise/part.glsl", "#include \"../math/one.glsl\"\nfloat part() { return 0.25 * one(); }\n");
    folder.write(
        "main.glsl",
        "#iChannel0 \"file://self\"\n#include './noise/part.glsl'\n#include \"math/one.glsl\"\n\
         void main() { gl_FragColor = texture(iChannel0, gl_FragCoord.xy / iResolution.xy) + part() * one(); }",
    );
    assert_eq!(pixel_of(&folder, &["main.glsl"]), [128; 3]);
    folder.write("wrong.glsl", "#include \"../toy.frag\"\nvoid main() {}\n");
    let run = folder.glanz(&["shader", "run", "wrong.glsl"]);
    assert!(run.stderr.contains("'../toy.frag' is not there to be included"), "{}", run.stderr);
}

#[test]
fn a_shadow_sampler_compares_with_a_picture_of_depths() {
    let folder = folder();
    // Four columns of depths: 0.125, 0.375, 0.625, 0.875.
    folder.write("depth.frag", "void mainImage(out vec4 c, vec2 at) { c = vec4(at.x / iResolution.x); }");
    folder.glanz(&["shader", "run", "depth.frag", "--size", "4x1", "-o", "depth.png"]).text();
    folder.write(
        "shadow.frag",
        "#version 330\nuniform sampler2DShadow map; out vec4 c;\n\
         void main() { c = vec4(texture(map, vec3(0.625, 0.5, 0.5)), texture(map, vec3(0.5, 0.5, 0.5)), \
         texture(map, vec3(0.125, 0.5, 0.5)), 1.0); }",
    );
    let words =
        ["shader", "run", "shadow.frag", "--texture", "map=depth.png", "--size", "1x1", "-o", "a.png"];
    folder.glanz(&words).text();
    assert_eq!(pixels(&folder.read("a.png")).2[0], [255, 128, 0], "seen, half of the filter, in shadow");
    // The same on a mesh.
    folder.write(
        "scene.toml",
        "[image]\nwidth = 8\nheight = 8\n[camera]\neye = [0, 0, 3]\n[[objects]]\nmesh = \"quad\"\n",
    );
    let words = [
        "render",
        "scene.toml",
        "--fs",
        "shadow.frag",
        "--uniform",
        "map=depth.png",
        "--encoding",
        "raw",
        "-o",
        "b.png",
    ];
    folder.glanz(&words).text();
    let (_, _, codes) = pixels(&folder.read("b.png"));
    assert_eq!(codes[8 * 4 + 4], [255, 128, 0]);
}
