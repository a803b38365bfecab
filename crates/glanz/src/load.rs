//! Scenes from files and texts.

use std::path::Path;

use crate::scene::file::{LoadOptions, parse_str};
use crate::{Error, Scene, scene};

/// Reads a scene file (`.toml`), or a model (glTF, OBJ, PLY, STL), which gets light where it has none.
///
/// What a file names beside itself must be in its folder; [`scene::open`] has the options.
///
/// # Errors
/// If the file cannot be read, or does not say what it should. The message has the file and the place.
pub fn load(path: impl AsRef<Path>) -> Result<Scene, Error> {
    Ok(load_with_remarks(path)?.0)
}

/// The same with what was ignored, replaced or approximated, in words for people.
///
/// ```
/// let path = std::env::temp_dir().join("glanz-doc-remarks.toml");
/// std::fs::write(&path, "[materials.a]\nmodel = \"lambert\"\nspecular = [1, 1, 1]\n")?;
/// let (scene, remarks) = glanz::load_with_remarks(&path)?;
/// assert_eq!(scene.materials[0].name, "a");
/// assert_eq!(remarks, ["material 'a': 'lambert' has no highlight; 'specular' is not used"]);
/// # std::fs::remove_file(path)?;
/// # Ok::<(), glanz::Error>(())
/// ```
///
/// # Errors
/// As [`load`].
pub fn load_with_remarks(path: impl AsRef<Path>) -> Result<(Scene, Vec<String>), Error> {
    let opened = scene::open(path.as_ref(), &LoadOptions::default())?;
    Ok((opened.scene, opened.notes))
}

/// Reads a scene from a text in the words of scene files. Files that it names are looked for in the current folder.
///
/// ```
/// let scene = glanz::parse("[[lights]]\nkind = \"point\"\nposition = [1, 2, 3]")?;
/// assert_eq!(scene.lights.len(), 1);
/// let error = glanz::parse("[image]\nwidht = 3").unwrap_err();
/// assert!(error.to_string().starts_with("scene:2:1: "), "by line and column");
/// # Ok::<(), glanz::Error>(())
/// ```
///
/// # Errors
/// If the text does not say what it should.
pub fn parse(text: &str) -> Result<Scene, Error> {
    Ok(parse_str(text, Path::new(""), &LoadOptions::default())?.scene)
}
