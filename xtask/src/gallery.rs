//! Examples drawn: small to see that they work, large to look at.

use std::path::{Path, PathBuf};

use crate::picture::Picture;
use crate::workspace::{Profile, Workspace, run_quietly};
use crate::{Failure, Result};

/// The README's pictures, and the commands that draw them.
const README_PICTURES: [(&str, &str); 3] = [
    ("docs/picture.png", "render examples/teapot.toml --size 960x540 --samples 16"),
    ("docs/metals.png", "sheet cook-torrance --vary ior=Au,Cu,Al --vary m=0.1:0.6:6 --size 100x100"),
    (
        "docs/lights.png",
        "relight examples/fluorescence.toml --light A --light D65 --light UV365 --size 300x205",
    ),
];

/// The pictures of docs/EYE.md, and the commands that draw them.
const EYE_PICTURES: [(&str, &str); 10] = [
    ("docs/eye/ages.png", "eye examples/colorchecker.toml --age 20,80 --size 300x200"),
    (
        "docs/eye/black-light.png",
        "eye examples/black-light.toml --age 10,32,80 --adapted 0 --ev 2 --size 300x200",
    ),
    ("docs/eye/aphakic.png", "eye examples/black-light.toml --observer aphakic --adapted 0 --size 300x200"),
    (
        "docs/eye/lights.png",
        "eye examples/traffic-lights.toml --deficiency none,deutan:10,deutan,protan,tritan --size 180x220",
    ),
    (
        "docs/eye/plate.png",
        "eye examples/plate.toml --deficiency none,deutan:10,deutan,protan,tritan --size 200x200",
    ),
    ("docs/eye/dusk.png", "eye examples/street-at-dusk.toml --age 25,75 --glare --size 400x267"),
    ("docs/eye/flowers.png", "eye examples/flowers.toml --level day,dusk,0.1,moon --size 240x180"),
    ("docs/eye/mach.svg", "eye examples/mach-bands.toml --mach y=250 --gain 10"),
    ("docs/eye/opponent.png", "eye examples/full.toml --show opponent --size 240x180"),
    ("docs/eye/photons.png", "eye examples/flowers.toml --level moon,stars --noise --acuity --size 300x225"),
];

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

/// Draws all examples at their own size into `target/gallery/`, then those of the documents.
pub(crate) fn run(workspace: &Workspace, only_readme: bool) -> Result<()> {
    let glanz = workspace.glanz(Profile::Release)?;
    if !only_readme {
        let folder = workspace.target_folder("gallery")?;
        for scene in workspace.examples()? {
            println!("{}", draw(workspace, &glanz, &scene, &folder, &[])?.display());
        }
    }
    std::fs::create_dir_all(workspace.path("docs/eye")).map_err(Failure::during("docs/eye"))?;
    for (picture, words) in README_PICTURES.into_iter().chain(EYE_PICTURES) {
        let mut command = workspace.command(&glanz);
        run_quietly(command.args(words.split_whitespace()).args(["--force", "-o", picture]))?;
        println!("{picture}");
    }
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
