//! How scene files fail.

use std::path::Path;

use super::{full, parse, scene, set};

/// The message, and the text that it points at.
fn error(text: &str) -> (String, String) {
    let error = parse(text).expect_err(text);
    let span = error.span.expect("every error in a text has a place");
    (error.message, error.text[span].to_owned())
}

#[test]
fn an_unknown_key_is_refused_with_its_table_and_the_nearest_key() {
    let text = full().replace("shininess =", "shinines =");
    let (message, place) = error(&text);
    assert_eq!(message, "unknown key 'shinines' in [materials.red]; did you mean 'shininess'?");
    assert_eq!(place, "shinines");
    let error = parse(&text).expect_err("unknown key");
    assert_eq!((error.line, error.column), (51, 1));
    assert!(error.to_string().starts_with("scene:51:1: unknown key"), "{error}");
}

/// Texts, the message that they give, and what it points at.
#[test]
fn errors_say_what_was_expected_and_point_at_the_value() {
    let light = |keys: &str| format!("[[lights]]\n{keys}\n");
    let object = |keys: &str| format!("[[objects]]\nmesh = 'quad'\n{keys}\n");
    let cases = [
        ("[image]\nwidht = 3".into(), "unknown key 'widht' in [image]; did you mean 'width'?", "widht"),
        ("[imag]\n".into(), "unknown key 'imag'; did you mean 'image'?", "imag"),
        ("[image]\nwidth = 0".into(), "expected between 1 and 16384 pixels, found 0", "0"),
        ("[image]\nwidth = 1.5".into(), "expected a whole number, found floating point 1.5", "1.5"),
        ("[image]\nsamples = 3".into(), "expected 1, 2, 4, 8 or 16 samples, found 3", "3"),
        ("image = [1, 2]".into(), "expected a table, found a list", "[1, 2]"),
        ("[[image]]\nwidth = 3".into(), "expected a table, found a list", "[[image]]"),
        (
            "[image]\nbackground = 'clear'".into(),
            "expected a colour, \"transparent\" or \"environment\", found \"clear\"",
            "'clear'",
        ),
        ("[render]\nshading = 'gourad'".into(), "unknown name 'gourad'; did you mean 'gouraud'?", "'gourad'"),
        ("[ambient]\n".into(), "'color' is missing in [ambient]", "[ambient]"),
        (
            "[ambient]\ncolor = [1, 1]".into(),
            "expected three amounts of red, green and blue, found 2",
            "[1, 1]",
        ),
        (
            "[ambient]\ncolor = [1, -2.5, 1]".into(),
            "expected a number between 0 and 1e12, found -2.5",
            "-2.5",
        ),
        (
            "[camera]\neye = [0, 0, 1e30]".into(),
            "expected a finite number of at most 1e12, found 1e30",
            "1e30",
        ),
        (
            "[camera]\neye = [0, 0, 1]\ntarget = [0, 0, 1]".into(),
            "'eye' and 'target' are the same point; they must differ",
            "[0, 0, 1]",
        ),
        ("[camera]\neye = [0, 0, 1]\nheight = 2".into(), "'height' needs projection = \"orthographic\"", "2"),
        (
            "[camera]\neye = [0, 0, 1]\nfov_deg = 180".into(),
            "expected degrees between 0.001 and 179.999, found 180",
            "180",
        ),
        ("camera = 'Eye'".into(), "unknown camera 'Eye'", "'Eye'"),
        (light("kind = 'lamp'"), "unknown name 'lamp'; did you mean 'point'?", "'lamp'"),
        (light("direction = [0, 0, 1]"), "'kind' is missing in [lights.0]", "[[lights]]"),
        (
            light("kind = 'spot'\nposition = [0, 0, 1]"),
            "a spot light needs 'direction', which is missing",
            "[[lights]]",
        ),
        (
            light("kind = 'point'\nposition = [0, 0, 1]\ncutoff_deg = 3"),
            "a point light has no 'cutoff_deg'",
            "3",
        ),
        (
            light("kind = 'spot'\nposition = [0, 0, 1]\ndirection = [0, 0, 0]"),
            "expected a direction, found three zeros",
            "[0, 0, 0]",
        ),
        (
            light("kind = 'point'\nposition = [0, 0, 1]\nattenuation = { linear = 0 }"),
            "constant, linear and quadratic are all 0, which divides by 0",
            "{ linear = 0 }",
        ),
        (
            light("kind = 'point'\nposition = [0, 0, 1]\nattenuation = 'fysical'"),
            "unknown name 'fysical'; did you mean 'physical'?",
            "'fysical'",
        ),
        ("[materials.a]\nmodel = 'blinn'".into(), "unknown model 'blinn'", "'blinn'"),
        ("[materials.a]\nshininess = -1".into(), "expected an exponent between 0 and 100000, found -1", "-1"),
        ("[materials.a]\nlobes = []\ndiffuse = [1, 1, 1]".into(), "'diffuse' beside 'lobes'", "[1, 1, 1]"),
        (
            "[materials.a]\nlobes = [{ shape = 'lambart' }]".into(),
            "unknown shape 'lambart'; did you mean 'lambert'?",
            "'lambart'",
        ),
        (
            "[materials.a]\nlobes = [{ shape = 'phong', shinyness = 3 }]".into(),
            "unknown key 'shinyness' in a lobe of shape 'phong'; did you mean 'shininess'?",
            "shinyness",
        ),
        (
            "[materials.a]\nlobes = [{ shape = 'phong', shininess = 2e5 }]".into(),
            "parameter 'shininess' of model 'phong' is 200000, but must be between 0 and 100000",
            "2e5",
        ),
        ("[materials.a]\nlobes = [[1]]".into(), "expected a table, found a list", "[1]"),
        ("materials.a = [1]".into(), "expected a table, found a list", "[1]"),
        (
            "[materials.red]\n[[objects]]\nmesh = 'cube'\nmaterial = 'rad'".into(),
            "unknown material 'rad'; did you mean 'red'?",
            "'rad'",
        ),
        ("[[objects]]\nmesh = 'spere'".into(), "unknown mesh 'spere'; did you mean 'sphere'?", "'spere'"),
        (
            "[[objects]]\nmesh = { spere = {} }".into(),
            "unknown name 'spere'; did you mean 'sphere'?",
            "{ spere = {} }",
        ),
        (
            "[[objects]]\nmesh = 'a.glb'".into(),
            "unknown mesh 'a.glb'; for a file, write { file = \"..\" }",
            "'a.glb'",
        ),
        (
            "[[objects]]\nmesh = { sphere = { slizes = 3 } }".into(),
            "unknown key 'slizes' in [objects.0.mesh.sphere]; did you mean 'slices'?",
            "slizes",
        ),
        (
            "[[objects]]\nmesh = { sphere = { slices = 1 } }".into(),
            "sphere: slices must be at least 3, but is 1",
            "{ sphere = { slices = 1 } }",
        ),
        (
            "[[objects]]\nmesh = { sphere = {}, cube = {} }".into(),
            "expected one mesh, found 'sphere' as well",
            "{ sphere = {}, cube = {} }",
        ),
        ("[[objects]]\nmesh = { file = 'none.glb' }".into(), "there is no file 'none.glb'", "'none.glb'"),
        (
            "[[objects]]\nmesh = { file = '../README.glb' }".into(),
            "'../README.glb' leaves the folder of the scene file",
            "'../README.glb'",
        ),
        (
            object("scale = [1, 0, 1]"),
            "expected factors whose size is between 1e-9 and 1e9, found [1, 0, 1]; 0 would leave nothing",
            "[1, 0, 1]",
        ),
        (
            object("scale = 2\nmatrix = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]"),
            "'matrix' beside 'translate', 'rotate_deg' or 'scale'",
            "[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]",
        ),
        (
            object("matrix = [[1, 0, 0, 0], [0, 1, 0, 0], [1, 1, 0, 0]]"),
            "the matrix is singular, or scales by more than 1e9",
            "[[1, 0, 0, 0], [0, 1, 0, 0], [1, 1, 0, 0]]",
        ),
        (
            object("rotate_deg = { axis = [0, 0, 1] }"),
            "'angle' is missing in [objects.0.rotate_deg]",
            "{ axis = [0, 0, 1] }",
        ),
        (object("normals = 'facet'\ncrease_deg = 30"), "'crease_deg' needs normals = \"smooth\"", "30"),
        (object("subdivide = 11"), "expected between 0 and 10 subdivisions, found 11", "11"),
        (object("colors = ['#ff0000']"), "expected 4 colours, one for each vertex, found 1", "['#ff0000']"),
        (object("lights = true"), "a built-in mesh has no lights", "true"),
        ("[image\n".into(), "unclosed table, expected `]`", ""),
        ("a = 1\na = 2".into(), "duplicate key", "a"),
    ];
    for (text, message, place) in &cases {
        let (found, at) = error(text);
        assert_eq!((found.as_str(), at.as_str()), (*message, *place), "{text}");
    }
}

#[test]
fn overrides_that_set_nothing_are_refused_where_they_stand() {
    let cases = [
        (
            "materials.rad.shininess",
            "3",
            "unknown path 'materials.rad.shininess': there is no 'rad'; did you mean 'red'?",
            "materials.rad.shininess",
        ),
        (
            "materials.red.shinines",
            "3",
            "unknown key 'shinines' in [materials.red]; did you mean 'shininess'?",
            "materials.red.shinines",
        ),
        ("lights.3.color", "[1, 1, 1]", "unknown path 'lights.3.color': there is no '3'", "lights.3.color"),
        ("lights.0.color.r", "1", "unknown path 'lights.0.color.r': there is no 'r'", "lights.0.color.r"),
        ("image.width.x", "1", "there is no 'x' in 'image.width', which is of type integer", "image.width.x"),
        (
            "image..width",
            "1",
            "expected a path such as materials.ball.shininess, found 'image..width'",
            "image..width",
        ),
        ("image.width", "many", "expected a whole number, found string \"many\"", "many"),
        ("image.width", "1\nx = 2", "expected a whole number, found string \"1\\nx = 2\"", "1\nx = 2"),
        ("materials.red.shininess", "-1", "expected an exponent between 0 and 100000, found -1", "-1"),
        (
            "render.shadings",
            "flat",
            "unknown key 'shadings' in [render]; did you mean 'shading'?",
            "render.shadings",
        ),
        ("lights.0.color", "[1, 1, -7]", "expected a number between 0 and 1e12, found -7", "-7"),
    ];
    for (path, value, message, place) in cases {
        let error = set(&full(), &[("image.height", "99"), (path, value)]).expect_err(path);
        let span = error.span.clone().expect("a place");
        assert_eq!((error.message.as_str(), &error.text[span]), (message, place));
        assert_eq!((error.path.as_path(), error.line), (Path::new("override"), 1), "{path}={value}");
    }
}

#[test]
fn more_triangles_than_can_be_drawn_are_not_made() {
    let too_many = [
        "expected at most 500000000 triangles in a scene, found ",
        "expected at most 8 GB of memory, found ",
    ];
    let sphere = |slices: u32, stacks: u32| {
        format!("[[objects]]\nmesh = {{ sphere = {{ slices = {slices}, stacks = {stacks} }} }}\n")
    };
    let texts = [
        sphere(4_000_000_000, 4_000_000_000),
        format!("{}subdivide = 10\n", sphere(16, 18)),
        // One mesh of 99 800 triangles, 1700 times.
        sphere(100, 500).repeat(1700),
    ];
    for text in texts {
        let (message, _) = error(&text);
        assert!(too_many.iter().any(|start| message.starts_with(start)), "{message}");
    }
    assert_eq!(scene(&sphere(100, 500).repeat(501)).meshes.len(), 1);
}

#[test]
fn deep_and_wide_texts_end_with_an_error_or_a_scene() {
    for (open, close) in [("[", "]"), ("{a=", "}")] {
        let deep = format!("x = {}{}", open.repeat(100_000), close.repeat(100_000));
        error(&deep);
    }
    error(&format!("{}x = 1", "a.".repeat(100_000)));
    let many = "[[objects]]\nmesh = 'quad'\n".repeat(20_000);
    assert_eq!(scene(&many).objects.len(), 20_000);
    let different: String =
        (1..5000).map(|i| format!("[[objects]]\nmesh = {{ cube = {{ size = {i} }} }}\n")).collect();
    assert_eq!(scene(&different).meshes.len(), 4999);
}
