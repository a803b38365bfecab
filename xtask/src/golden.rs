//! Gold pictures: drawn once by the path with the narrowest vectors, kept in `tests/golden/`, compared exactly.
//!
//! `tests/golden/list.txt` names them: a name, a scene and the options of `glanz render` on each
//! line. Every other path (SIMD level, number of threads) must give the same pixels.

use std::path::{Path, PathBuf};

use crate::picture::Picture;
use crate::workspace::{Profile, Workspace, run_quietly};
use crate::{Failure, Result};

/// Which paths are compared with the gold pictures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Paths {
    /// The one that drew them.
    Narrowest,
    /// All that this machine has.
    All,
}

/// SIMD level and number of threads of the path that draws gold pictures.
const NARROWEST: (&str, u32) = (if cfg!(target_arch = "x86_64") { "sse2" } else { "scalar" }, 1);

/// All other paths; `""` is the machine's best level.
const OTHERS: &[(&str, u32)] =
    &[("", 1), ("", 2), ("", 7), ("scalar", 2), ("sse2", 2), ("avx2", 2), ("avx512", 2), ("neon", 2)];

/// How much differences are enlarged on the sheet.
const AMPLIFIED: u8 = 8;

/// One line of the list.
#[derive(Debug, PartialEq)]
struct Gold {
    name: String,
    scene: String,
    options: Vec<String>,
}

/// What is needed to draw gold pictures.
struct Studio<'a> {
    workspace: &'a Workspace,
    glanz: PathBuf,
    folder: PathBuf,
    golds: Vec<Gold>,
}

/// The task `golden`.
pub(crate) fn run(workspace: &Workspace) -> Result<()> {
    compare(workspace, Paths::All)
}

/// Draws all gold pictures and compares them with the kept ones.
pub(crate) fn compare(workspace: &Workspace, paths: Paths) -> Result<()> {
    let studio = Studio::open(workspace)?;
    let mut complaints = studio.orphans()?;
    let mut rows = Vec::new();
    for gold in &studio.golds {
        let kept_path = studio.kept(gold);
        if !kept_path.is_file() {
            complaints.push(format!("{}: no picture is kept yet (cargo xtask golden --renew)", gold.name));
            continue;
        }
        let kept = Picture::read(&kept_path)?;
        let drawn = studio.draw(gold, NARROWEST)?;
        if let Some(complaint) = complaint(&kept, &drawn) {
            complaints.push(format!("{}: {complaint}", gold.name));
            rows.push(row(&kept, drawn));
        }
    }
    println!("{} gold pictures compared, drawn by the narrowest path", studio.golds.len());
    studio.sheet(&rows)?;
    if paths == Paths::All && complaints.is_empty() {
        complaints = studio.compare_paths()?;
    }
    match complaints.is_empty() {
        true => Ok(()),
        false => Err(Failure::new(format!("gold pictures differ:\n  {}", complaints.join("\n  ")))),
    }
}

/// Writes all gold pictures anew and shows what changed.
pub(crate) fn renew(workspace: &Workspace) -> Result<()> {
    let studio = Studio::open(workspace)?;
    let mut rows = Vec::new();
    for gold in &studio.golds {
        let path = studio.kept(gold);
        let drawn = studio.draw(gold, NARROWEST)?;
        let kept = path.is_file().then(|| Picture::read(&path)).transpose()?;
        match &kept {
            Some(kept) if *kept == drawn => continue,
            Some(_) => println!("changed  {}", gold.name),
            None => println!("new      {}", gold.name),
        }
        drawn.write(&path)?;
        rows.push(kept.map_or_else(|| vec![drawn.clone()], |kept| row(&kept, drawn.clone())));
    }
    for orphan in studio.orphans()? {
        println!("{orphan}");
    }
    println!("{} of {} gold pictures written", rows.len(), studio.golds.len());
    studio.sheet(&rows)
}

impl<'a> Studio<'a> {
    fn open(workspace: &'a Workspace) -> Result<Self> {
        let list = workspace.path("tests/golden/list.txt");
        let text = std::fs::read_to_string(&list).map_err(Failure::during(list.display()))?;
        let golds = parse(&text)?;
        Ok(Self {
            workspace,
            glanz: workspace.glanz(Profile::Dev)?,
            folder: workspace.target_folder("golden")?,
            golds,
        })
    }

    fn kept(&self, gold: &Gold) -> PathBuf {
        self.workspace.path("tests/golden").join(format!("{}.png", gold.name))
    }

    /// Pictures in the folder that the list does not name.
    fn orphans(&self) -> Result<Vec<String>> {
        let folder = self.workspace.path("tests/golden");
        let entries = std::fs::read_dir(&folder).map_err(Failure::during(folder.display()))?;
        let names = entries.flatten().map(|entry| entry.file_name().to_string_lossy().into_owned());
        let listed = |name: &str| self.golds.iter().any(|gold| name == format!("{}.png", gold.name));
        Ok(names
            .filter(|name| name.ends_with(".png") && !listed(name))
            .map(|name| format!("tests/golden/{name} is not in the list"))
            .collect())
    }

    /// Draws one picture on one path.
    fn draw(&self, gold: &Gold, (level, threads): (&str, u32)) -> Result<Picture> {
        let path = self.folder.join(format!("{}.png", gold.name));
        let mut command = self.workspace.command(&self.glanz);
        command.args(["render", &gold.scene, "--force", "--threads", &threads.to_string(), "-o"]);
        command.arg(&path).args(&gold.options).env("GLANZ_SIMD", level);
        run_quietly(&mut command)?;
        Picture::read(&path)
    }

    /// Compares all other paths with the kept pictures. Levels that this machine lacks are left out.
    fn compare_paths(&self) -> Result<Vec<String>> {
        let mut complaints = Vec::new();
        for &(level, threads) in OTHERS {
            let name = if level.is_empty() { "best" } else { level };
            if let Some(first) = self.golds.first()
                && let Err(failure) = self.draw(first, (level, threads))
            {
                match failure.to_string().contains("GLANZ_SIMD") {
                    true => println!("{name}: not on this processor"),
                    false => return Err(failure),
                }
                continue;
            }
            for gold in &self.golds {
                let kept = Picture::read(&self.kept(gold))?;
                if let Some(complaint) = complaint(&kept, &self.draw(gold, (level, threads))?) {
                    complaints.push(format!("{} ({name}, {threads} threads): {complaint}", gold.name));
                }
            }
            println!("{name}, {threads} threads: compared");
        }
        Ok(complaints)
    }

    /// Writes the difference sheet, or removes an old one where there is nothing to show.
    fn sheet(&self, rows: &[Vec<Picture>]) -> Result<()> {
        let path = self.folder.join("diff.png");
        if rows.is_empty() {
            if path.exists() {
                std::fs::remove_file(&path).map_err(Failure::during(path.display()))?;
            }
            return Ok(());
        }
        Picture::sheet(rows).write(&path)?;
        println!("{}: old | new | difference × {AMPLIFIED}", shown(self.workspace, &path));
        Ok(())
    }
}

/// A path below the root, for people.
fn shown(workspace: &Workspace, path: &Path) -> String {
    path.strip_prefix(workspace.path("")).unwrap_or(path).display().to_string()
}

/// Old, new and the difference between them.
fn row(kept: &Picture, drawn: Picture) -> Vec<Picture> {
    let same_size = (kept.width, kept.height) == (drawn.width, drawn.height);
    let difference = same_size.then(|| kept.amplified_difference(&drawn, AMPLIFIED));
    [Some(kept.clone()), Some(drawn), difference].into_iter().flatten().collect()
}

/// What is wrong with a drawn picture, if anything is.
fn complaint(kept: &Picture, drawn: &Picture) -> Option<String> {
    match kept.difference(drawn) {
        Err(failure) => Some(failure.to_string()),
        Ok(None) => None,
        Ok(Some(found)) => Some(format!(
            "{} pixels differ, by up to {} codes, the first at column {}, row {}",
            found.pixels, found.largest, found.first.0, found.first.1
        )),
    }
}

/// Reads the list. Blank lines and lines that begin with '#' say nothing.
fn parse(text: &str) -> Result<Vec<Gold>> {
    let mut golds: Vec<Gold> = Vec::new();
    for (number, line) in text.lines().enumerate() {
        let mut words = line.split_whitespace().map(str::to_owned);
        let Some(name) = words.next().filter(|word| !word.starts_with('#')) else { continue };
        let place = format!("tests/golden/list.txt, line {}", number + 1);
        let Some(scene) = words.next() else {
            return Err(Failure::new(format!("{place}: '{name}' names no scene")));
        };
        if golds.iter().any(|gold| gold.name == name) {
            return Err(Failure::new(format!("{place}: a second '{name}'")));
        }
        golds.push(Gold { name, scene, options: words.collect() });
    }
    match golds.is_empty() {
        true => Err(Failure::new("tests/golden/list.txt names no picture")),
        false => Ok(golds),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_list_is_read_line_by_line() {
        let golds = parse("# a comment\n\nkite  examples/kite.toml --size 16x12\n").expect("a good list");
        assert_eq!(golds.len(), 1);
        assert_eq!((golds[0].name.as_str(), golds[0].scene.as_str()), ("kite", "examples/kite.toml"));
        assert_eq!(golds[0].options, ["--size", "16x12"]);
    }

    #[test]
    fn a_bad_list_is_refused_with_its_line() {
        let message = |text| parse(text).expect_err("a bad list").to_string();
        assert!(message("kite a\nkite b").contains("line 2: a second 'kite'"));
        assert!(message("# nothing\nkite").contains("line 2: 'kite' names no scene"));
        assert!(message("# nothing").contains("names no picture"));
    }

    #[test]
    fn a_changed_pixel_is_a_complaint() {
        let kept = Picture::plain(4, 4, [9, 9, 9, 255]);
        let mut drawn = kept.clone();
        assert_eq!(complaint(&kept, &drawn), None);
        drawn.rgba[20] = 11;
        let text = complaint(&kept, &drawn).expect("it differs");
        assert!(text.contains("1 pixels differ, by up to 2 codes, the first at column 1, row 1"), "{text}");
        assert_eq!(row(&kept, drawn).len(), 3);
    }
}
