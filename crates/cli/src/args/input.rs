//! What is drawn.

use std::path::{Path, PathBuf};

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueHint};
use glanz_math::MemoryBudget;
use glanz_scene::DefaultLights;

use super::{ProgramArgs, values};

/// What stands for stdin in the place of a file.
pub(crate) const STDIN: &str = "-";

/// The scene or model, and what to change of it.
#[derive(Args, Clone, Debug)]
pub(crate) struct InputArgs {
    /// A scene (.toml) or a model (.glb, .gltf, .obj, .ply, .stl); - for a scene from stdin, whose files are relative to
    /// the current folder
    #[arg(value_name = "SCENE", value_hint = ValueHint::FilePath)]
    pub input: PathBuf,

    /// Change a value of the scene, such as materials.red.shininess=64 (for a model:
    /// materials.default.shininess=64); may be repeated
    #[arg(long, value_name = "PATH=VALUE", value_parser = values::assignment, help_heading = "Scene")]
    pub set: Vec<(String, String)>,

    /// Let the scene name files outside its own folder
    #[arg(long, help_heading = "Scene")]
    pub allow_outside: bool,

    /// The lights of a model, in place of its own: none, three-point (what one without lights gets) or studio, a room
    /// with windows
    #[arg(long, value_name = "WHICH", value_parser = lights(), help_heading = "Scene")]
    pub lights: Option<DefaultLights>,

    /// The variant of a glTF model whose materials it has; glanz info names them
    #[arg(long, value_name = "NAME", help_heading = "Scene")]
    pub variant: Option<String>,

    /// How much memory the scene and its picture may take, in B, kB, MB, GB or GiB: more is refused beforehand
    #[arg(long, value_name = "SIZE", default_value_t, help_heading = "Machine")]
    pub memory: MemoryBudget,

    #[command(flatten)]
    pub program: ProgramArgs,
}

fn lights() -> impl TypedValueParser<Value = DefaultLights> {
    let names = DefaultLights::NAMES.map(|(name, _)| name);
    PossibleValuesParser::new(names)
        .map(|name| DefaultLights::named(&name).expect("the parser lets only known names through"))
}

impl InputArgs {
    /// Whether the scene comes from stdin.
    pub(crate) fn is_stdin(&self) -> bool {
        self.input == Path::new(STDIN)
    }

    /// What the input is called.
    pub(crate) fn name(&self) -> &Path {
        if self.is_stdin() { Path::new("stdin") } else { &self.input }
    }
}
