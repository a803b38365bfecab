//! A ball of every model, under lamps, an area light and an environment.

use glanz_bsdf::{MODELS, ModelInfo};
use glanz_scene::Scene;
use glanz_scene::file::{LoadOptions, parse_str};

use super::{drawn, hash, shelf};

/// Side of a picture.
const SIDE: usize = 48;

/// The three kinds of light: in front and behind, since some lobes are lit from one side and some from the other.
const LIGHTS: [&str; 3] = [
    r#"
[ambient]
color = [0.10, 0.12, 0.15]
[[lights]]
kind = "point"
position = [-2.0, 2.0, 3.0]
ambient = 1.0
attenuation = { constant = 0.3, quadratic = 0.06 }
[[lights]]
kind = "directional"
direction = [-0.6, -0.2, 1.0]
color = [1.0, 0.7, 0.4]
ambient = [1.0, 0.7, 0.4]
"#,
    r#"
[[lights]]
kind = "rectangle"
position = [-1.5, 1.5, 2.5]
target = [0.0, 0.0, 0.0]
width = 1.2
height = 1.8
intensity = 4.0
[[lights]]
kind = "sphere"
position = [1.2, 0.4, -2.0]
radius = 0.4
color = [1.0, 0.7, 0.4]
intensity = 4.0
"#,
    r#"
[[lights]]
kind = "environment"
file = "room.hdr"
"#,
];

/// Parameters beside the defaults: wide enough to be seen, and different along the two axes.
const SET: &[(&str, f64)] = &[("alpha", 0.25), ("alpha_y", 0.45)];

#[test]
fn every_model_draws_its_gold_picture() {
    let pictures = MODELS.iter().map(|info| {
        let balls: Vec<_> = LIGHTS.iter().map(|lights| drawn(&ball(info, lights))).collect();
        let rows = (0..SIDE).flat_map(|row| {
            balls.iter().flat_map(move |ball| ball.rgba[4 * SIDE * row..][..4 * SIDE].iter().copied())
        });
        let hash = balls.iter().fold(0u64, |all, ball| all.rotate_left(21) ^ hash::of(&ball.frame));
        (info.name.to_owned(), [LIGHTS.len() * SIDE, SIDE], rows.collect(), hash)
    });
    shelf::compare("models", pictures.collect());
}

fn ball(info: &ModelInfo, lights: &str) -> Scene {
    let set = SET.iter().filter(|(name, _)| info.params.iter().any(|param| param.name == *name));
    let params: String = set.map(|(name, value)| format!(", {name} = {value}")).collect();
    let text = format!(
        "[image]\nwidth = {SIDE}\nheight = {SIDE}\nsamples = 1\n\
         [camera]\neye = [0.0, 0.5, 4.0]\nfov_deg = 34.0\n{lights}\n\
         [materials.ball]\nlobes = [{{ shape = \"{}\", tint = [0.9, 0.7, 0.5]{params} }}]\n\
         [[objects]]\nmesh = {{ sphere = {{ slices = 32, stacks = 16 }} }}\nmaterial = \"ball\"\n",
        info.name
    );
    parse_str(&text, &shelf::folder().join("scenes"), &LoadOptions::default()).unwrap().scene
}
