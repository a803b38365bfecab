//! Small inputs with the right answers beside them: what the command makes of each.
//!
//! Each case is a folder with `expectation.txt` and one input: a scene `s.toml`, or else a model. What is right is a
//! sentence for people; what of it can be judged here is: whether the input is read or refused, and whether there is a
//! remark where one is asked for. The rest stands side by side.

use std::path::{Path, PathBuf};
use std::process::Output;

use serde_json::Value;

use crate::picture::Picture;
use crate::workspace::{Profile, Workspace};
use crate::{Failure, Result};

/// Width and height of the pictures.
const SIZE: &str = "240x180";
/// Endings of models, after those of scenes.
const MODELS: [&str; 5] = ["obj", "ply", "stl", "gltf", "glb"];
/// The exit code for files that cannot be used.
const REFUSED: i32 = 3;
/// A pixel whose channels are all within this of the first pixel's shows the background.
const BACKGROUND: u8 = 2;

/// Runs the command on every case in a folder and prints a table; fails if a case is clearly not as it should be.
pub(crate) fn run(workspace: &Workspace, folder: &Path) -> Result<()> {
    let mut cases: Vec<PathBuf> = std::fs::read_dir(folder)
        .map_err(Failure::during(folder.display()))?
        .filter_map(|entry| Some(entry.ok()?.path()))
        .filter(|path| path.join("expectation.txt").is_file())
        .collect();
    cases.sort();
    let (glanz, pictures) = (workspace.glanz(Profile::Dev)?, workspace.target_folder("cases")?);
    println!(
        "\n{:<28} {:>4} {:>9} {:>7}  {:<15} verdict",
        "case", "exit", "triangles", "covered", "mean colour"
    );
    let mut wrong = 0;
    for folder in &cases {
        let case = Case::of(folder)?;
        let Some(input) = &case.input else {
            println!("{:<28} to be run by hand: {}\n", case.name, case.expected.replace('\n', "\n    "));
            continue;
        };
        let picture = pictures.join(format!("{}.png", case.name));
        let run = |words: &[&str]| {
            let mut command = workspace.command(&glanz);
            command
                .args(words)
                .arg(input)
                .args(["--format", "json"])
                .output()
                .map_err(Failure::during("glanz"))
        };
        let output = picture.to_string_lossy();
        let render = run(&["render", "--force", "--size", SIZE, "-o", &output])?;
        let found = Found::of(&render, &run(&["info"])?, &picture);
        wrong += u32::from(!case.tell(&found));
    }
    println!(
        "{} cases, {wrong} of them clearly wrong; the pictures are in {}",
        cases.len(),
        pictures.display()
    );
    match wrong {
        0 => Ok(()),
        _ => Err(Failure::new(format!("{wrong} cases are not as they should be"))),
    }
}

/// A folder with an input and what is right.
struct Case {
    name: String,
    expected: String,
    /// None where the expectation names commands of its own.
    input: Option<PathBuf>,
}

impl Case {
    fn of(folder: &Path) -> Result<Self> {
        let path = folder.join("expectation.txt");
        let expected = std::fs::read_to_string(&path).map_err(Failure::during(path.display()))?;
        let name = folder.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        let by_hand = expected.contains("EXPECTED");
        let input = if by_hand { None } else { input(folder).or_else(|| input(&folder.join("model"))) };
        Ok(Self { name, expected: expected.trim().to_owned(), input })
    }

    /// Prints a row and what stands side by side; whether it is not clearly wrong.
    fn tell(&self, found: &Found) -> bool {
        let wrong = self.wrong(found);
        let verdict = wrong.map_or("look".to_owned(), |why| format!("WRONG: {why}"));
        let (covered, color) = found.covered.map_or((String::new(), String::new()), |(share, mean)| {
            (format!("{:.1} %", 100.0 * share), format!("{mean:?}"))
        });
        let triangles = found.triangles.map(|count| count.to_string()).unwrap_or_default();
        println!("{:<28} {:>4} {triangles:>9} {covered:>7}  {color:<15} {verdict}", self.name, found.exit);
        println!("    expected: {}", self.expected.replace('\n', "\n    "));
        for remark in &found.remarks {
            println!("    found:    {remark}");
        }
        wrong.is_none()
    }

    /// Why what was found cannot be right.
    fn wrong(&self, found: &Found) -> Option<&'static str> {
        let says = |words: &[&str]| words.iter().any(|word| self.expected.contains(word));
        match found.exit {
            0 if self.expected.starts_with("The error") => Some("it is read"),
            0 if says(&["remark"])
                && !says(&["at most", " or ", "at least", "today"])
                && found.remarks.is_empty() =>
            {
                Some("there is no remark")
            }
            0 => None,
            REFUSED if says(&["error", "refusal"]) => None,
            REFUSED => Some("it is refused"),
            _ => Some("the command did not end as it should"),
        }
    }
}

/// The scene of a folder, or else its model.
fn input(folder: &Path) -> Option<PathBuf> {
    let scene = folder.join("s.toml");
    if scene.is_file() {
        return Some(scene);
    }
    let files = std::fs::read_dir(folder).ok()?.filter_map(|entry| Some(entry.ok()?.path()));
    let ending = |path: &Path| path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
    let mut models: Vec<PathBuf> =
        files.filter(|path| ending(path).is_some_and(|ending| MODELS.contains(&ending.as_str()))).collect();
    models.sort();
    models.into_iter().next()
}

/// What the command made of an input.
struct Found {
    exit: i32,
    triangles: Option<u64>,
    /// The share of pixels that do not show the background, and their mean colour.
    covered: Option<(f64, [u8; 3])>,
    /// Remarks, or the error.
    remarks: Vec<String>,
}

impl Found {
    fn of(render: &Output, info: &Output, picture: &Path) -> Self {
        let exit = render.status.code().unwrap_or(-1);
        let document = |output: &Output| serde_json::from_slice::<Value>(&output.stdout).unwrap_or_default();
        let notes = document(render)["notes"].as_array().cloned().unwrap_or_default();
        let mut remarks: Vec<String> =
            notes.iter().filter_map(|note| note.as_str().map(str::to_owned)).collect();
        remarks.extend(document(render)["error"]["message"].as_str().map(str::to_owned));
        let covered =
            (exit == 0).then(|| Picture::read(picture).ok()).flatten().map(|picture| covered(&picture));
        Self { exit, triangles: document(info)["triangles"].as_u64(), covered, remarks }
    }
}

/// The share of pixels unlike the first one, and their mean colour.
fn covered(picture: &Picture) -> (f64, [u8; 3]) {
    let first = [picture.rgba[0], picture.rgba[1], picture.rgba[2]];
    let (mut count, mut sum) = (0u64, [0u64; 3]);
    for pixel in picture.rgba.chunks_exact(4) {
        if (0..3).any(|channel| pixel[channel].abs_diff(first[channel]) > BACKGROUND) {
            count += 1;
            (0..3).for_each(|channel| sum[channel] += u64::from(pixel[channel]));
        }
    }
    let mean = sum.map(|sum| (sum / count.max(1)) as u8);
    (count as f64 / (picture.width * picture.height) as f64, mean)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn case(expected: &str) -> Case {
        Case { name: String::new(), expected: expected.to_owned(), input: None }
    }

    fn found(exit: i32, remarks: &[&str]) -> Found {
        let remarks = remarks.iter().map(|&remark| remark.to_owned()).collect();
        Found { exit, triangles: None, covered: None, remarks }
    }

    #[test]
    fn what_can_be_judged_is_judged() {
        assert_eq!(case("A box.").wrong(&found(0, &[])), None);
        assert_eq!(case("A box.").wrong(&found(3, &["error"])), Some("it is refused"));
        assert_eq!(case("A box, with a remark.").wrong(&found(0, &[])), Some("there is no remark"));
        assert_eq!(case("A box, with a remark.").wrong(&found(0, &["note"])), None);
        assert_eq!(case("A picture, or a refusal.").wrong(&found(3, &["error"])), None);
        assert_eq!(case("The error says why.").wrong(&found(0, &[])), Some("it is read"));
        assert!(case("The error says why.").wrong(&found(101, &[])).is_some());
    }

    #[test]
    fn covered_are_the_pixels_that_differ_from_the_first() {
        let mut picture = Picture::plain(2, 2, [10, 10, 10, 255]);
        picture.rgba[12..15].copy_from_slice(&[200, 100, 0]);
        picture.rgba[8] = 12;
        assert_eq!(covered(&picture), (0.25, [200, 100, 0]));
    }
}
