//! What is drawn.

use std::path::PathBuf;

use clap::{Args, ValueHint};

use super::values;

/// The scene or model, and what to change of it.
#[derive(Args, Clone, Debug)]
pub(crate) struct InputArgs {
    /// A scene (.toml) or a model (.glb, .gltf, .obj, .ply, .stl)
    #[arg(value_name = "SCENE", value_hint = ValueHint::FilePath)]
    pub input: PathBuf,

    /// Change a value of the scene, such as materials.red.shininess=64 (for a model:
    /// materials.default.shininess=64); may be repeated
    #[arg(long, value_name = "PATH=VALUE", value_parser = values::assignment, help_heading = "Scene")]
    pub set: Vec<(String, String)>,

    /// Let the scene name files outside its own folder
    #[arg(long, help_heading = "Scene")]
    pub allow_outside: bool,
}
