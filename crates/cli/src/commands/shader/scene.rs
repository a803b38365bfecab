//! The scene that commands on programs look into.

use clap::Args;
use glanz_render::Shot;
use glanz_scene::Scene;

use crate::args::{CameraArgs, DevelopArgs, InputArgs, LookArgs, SizeArgs};
use crate::load::More;
use crate::pipeline::Plan;
use crate::print::failure::Failure;

/// A scene, and how it is looked at.
#[derive(Args, Debug)]
pub(crate) struct SceneArgs {
    #[command(flatten)]
    pub input: InputArgs,
    #[command(flatten)]
    size: SizeArgs,
    #[command(flatten)]
    look: LookArgs,
    #[command(flatten)]
    camera: CameraArgs,
}

impl SceneArgs {
    /// Reads and prepares it.
    pub(super) fn shot(&self) -> Result<(Scene, Shot), Failure> {
        let input = self.input.load(Some(&self.camera), More::default())?;
        let plan = Plan::new(&input, self.size.size, &self.look, &self.camera, DevelopArgs::default())?;
        let plan = plan.at(self.input.program.moment());
        let shot = plan.shot(&input.scene).map_err(|failure| failure.of_scene(&self.input.input))?;
        Ok((input.scene, shot))
    }
}

/// The line of a text of a scene's programs.
pub(super) fn line_of(scene: &Scene, file: &str, line: u32) -> Option<String> {
    let texts = scene.programs.iter().flat_map(|program| [&program.vertex, &program.fragment]).flatten();
    let text = texts.into_iter().find_map(|text| match text.name == file {
        true => Some(text.text.as_str()),
        false => text.includes.get(file).map(String::as_str),
    })?;
    text.lines().nth((line as usize).checked_sub(1)?).map(|line| line.trim().to_owned())
}
