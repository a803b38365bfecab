//! Examples drawn: small to see that they work, large to look at.

use std::path::{Path, PathBuf};

use crate::picture::Picture;
use crate::workspace::{Profile, Workspace, run_quietly};
use crate::{Failure, Result};

/// The README's picture, its scene and the options that it is drawn with.
const README_PICTURE: (&str, &str, &[&str]) =
    ("docs/picture.png", "examples/teapot.toml", &["--size", "960x540", "--samples", "16"]);

/// Draws every example small and checks that each shows something.
pub(crate) fn try_examples(workspace: &Workspace) -> Result<()> {
    let glanz = workspace.glanz(Profile::Dev)?;
    let folder = workspace.target_folder("examples-drawn")?;
    let scenes = workspace.examples()?;
    for scene in &scenes {
        let path = draw(workspace, &glanz, scene, &folder, &["--size", "160x120"])?;
        if Picture::read(&path)?.is_uniform() {
            return Err(Failure::new(format!("{} shows nothing: all pixels are the same", scene.display())));
        }
    }
    println!("{} examples drawn", scenes.len());
    Ok(())
}

/// Draws all examples at their own size into `target/gallery/`, then the README's picture.
pub(crate) fn run(workspace: &Workspace, only_readme: bool) -> Result<()> {
    let glanz = workspace.glanz(Profile::Release)?;
    if !only_readme {
        let folder = workspace.target_folder("gallery")?;
        for scene in workspace.examples()? {
            println!("{}", draw(workspace, &glanz, &scene, &folder, &[])?.display());
        }
    }
    let (picture, scene, options) = README_PICTURE;
    let mut command = workspace.command(&glanz);
    command.args(["render", scene, "--force", "-o", picture]).args(options);
    run_quietly(&mut command)?;
    println!("{picture}");
    Ok(())
}

/// Draws a scene into a folder and tells the picture's path.
fn draw(
    workspace: &Workspace,
    glanz: &Path,
    scene: &Path,
    folder: &Path,
    options: &[&str],
) -> Result<PathBuf> {
    let name = scene.file_stem().expect("a scene file has a name");
    let path = folder.join(name).with_extension("png");
    let mut command = workspace.command(glanz);
    command.arg("render").arg(scene).args(["--force", "-o"]).arg(&path).args(options);
    run_quietly(&mut command)?;
    Ok(path)
}
