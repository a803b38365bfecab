//! Whether what the README shows works: its commands, made small, and its scene.

use std::path::Path;

use crate::picture::Picture;
use crate::workspace::{Profile, Workspace, run_quietly};
use crate::{Failure, Result};

/// Values that would take long, and what is tried instead.
const SMALLER: &[(&str, &str)] = &[("--size", "160x120"), ("--frames", "0..3"), ("--repeat", "2")];

/// Runs every line of the README that begins with `glanz`, then draws its scene.
pub(crate) fn run(workspace: &Workspace) -> Result<()> {
    let path = workspace.path("README.md");
    let readme = std::fs::read_to_string(&path).map_err(Failure::during(path.display()))?;
    let glanz = workspace.glanz(Profile::Dev)?;
    let folder = workspace.target_folder("tour")?;
    copy(&workspace.path("examples"), &folder.join("examples"))?;
    let commands = commands(&readme);
    for words in &commands {
        run_quietly(workspace.command(&glanz).args(smaller(words)).current_dir(&folder))?;
    }
    let scene = scene(&readme).ok_or_else(|| Failure::new("README.md shows no scene file"))?;
    let file = folder.join("readme.toml");
    std::fs::write(&file, scene).map_err(Failure::during(file.display()))?;
    let picture = folder.join("readme.png");
    run_quietly(workspace.command(&glanz).arg("render").arg(&file).arg("-o").arg(&picture))?;
    if Picture::read(&picture)?.is_uniform() {
        return Err(Failure::new("the README's scene shows nothing"));
    }
    let library = workspace.path("crates/glanz/README.md");
    let compiled = std::fs::read_to_string(&library).map_err(Failure::during(library.display()))?;
    if program(&readme).is_none() || program(&readme) != program(&compiled) {
        return Err(Failure::new(
            "README.md and crates/glanz/README.md, which is compiled, show two programs",
        ));
    }
    println!("{} commands of the README run, its scene drawn", commands.len());
    Ok(())
}

/// The commands in indented lines, without the program's name.
fn commands(readme: &str) -> Vec<Vec<&str>> {
    let lines = readme.lines().filter_map(|line| line.strip_prefix("    glanz "));
    lines.map(|line| line.split_whitespace().map(|word| word.trim_matches('\'')).collect()).collect()
}

/// The same command on small pictures, and writing over those of the last time.
fn smaller<'a>(words: &[&'a str]) -> Vec<&'a str> {
    let mut result: Vec<&str> = Vec::new();
    for &word in words {
        let instead = result.last().and_then(|option| SMALLER.iter().find(|(name, _)| name == option));
        result.push(instead.map_or(word, |(_, value)| value));
    }
    if matches!(words.first(), Some(&("render" | "shade-compare" | "modes" | "relight"))) {
        if !words.contains(&"--size") {
            result.extend(["--size", "160x120"]);
        }
        result.push("--force");
    }
    result
}

/// The first block of TOML.
fn scene(readme: &str) -> Option<&str> {
    readme.split_once("```toml\n")?.1.split_once("```").map(|(scene, _)| scene)
}

/// The first block of Rust, without the lines that documentation hides.
fn program(readme: &str) -> Option<Vec<&str>> {
    let (_, block) = readme.split_once("```rust")?;
    let (_, code) = block.split_once('\n')?;
    let (code, _) = code.split_once("```")?;
    Some(code.lines().filter(|line| !line.starts_with("# ")).collect())
}

/// Copies a folder with all that is in it.
fn copy(from: &Path, to: &Path) -> Result<()> {
    let failed = || Failure::during::<std::io::Error>(from.display());
    std::fs::create_dir_all(to).map_err(failed())?;
    for entry in std::fs::read_dir(from).map_err(failed())? {
        let path = entry.map_err(failed())?.path();
        let target = to.join(path.file_name().expect("an entry of a folder has a name"));
        if path.is_dir() {
            copy(&path, &target)?;
        } else {
            std::fs::copy(&path, &target).map_err(Failure::during(path.display()))?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commands_are_the_indented_lines() {
        let readme =
            "Draw:\n\n    glanz render a.toml -o 'b_{frame:04}.png'\n    cargo xtask test\n\n`glanz help`\n";
        assert_eq!(commands(readme), [["render", "a.toml", "-o", "b_{frame:04}.png"]]);
    }

    #[test]
    fn long_work_is_made_small() {
        let words = ["render", "a.toml", "--size", "3840x2160", "--frames", "0..120"];
        let expected = ["render", "a.toml", "--size", "160x120", "--frames", "0..3", "--force"];
        assert_eq!(smaller(&words), expected);
        assert_eq!(smaller(&["info", "a.glb"]), ["info", "a.glb"]);
    }

    #[test]
    fn the_program_is_the_first_block_of_rust() {
        let shown = program("a\n```rust\nlet a = 1;\n```\n").expect("there is a block");
        assert_eq!(Some(shown), program("```rust,no_run\nlet a = 1;\n# Ok::<(), ()>(())\n```\n"));
        assert_eq!(program("no block"), None);
    }

    #[test]
    fn the_scene_is_the_first_block_of_toml() {
        assert_eq!(scene("a\n```toml\nx = 1\n```\n```toml\ny = 2\n```\n"), Some("x = 1\n"));
        assert_eq!(scene("no block"), None);
    }
}
