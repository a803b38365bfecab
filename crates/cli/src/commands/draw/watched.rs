//! The files that a picture is made of, and whether they change.
//!
//! The system tells when a file of their folders was written to its end. Where it does not, on network folders for
//! instance, the files are asked for their time and size a few times a second, which costs nothing that could be measured.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::thread::sleep;
use std::time::{Duration, Instant, SystemTime};

use notify::event::{AccessKind, AccessMode, Event, EventKind, ModifyKind, RenameMode};
use notify::{RecommendedWatcher, RecursiveMode, Watcher};

/// How often the files are looked at without being told.
const INTERVAL: Duration = Duration::from_millis(150);
/// The most files of a model's folder that are looked at.
const MOST_FILES: usize = 256;

/// Time and size of a file; none where there is none.
type Stamp = Option<(SystemTime, u64)>;

/// The files that a picture is made of, as they were when it was drawn.
pub(super) struct Watched<'a> {
    scene: PathBuf,
    /// What is written, which would else be seen to change.
    target: Option<PathBuf>,
    /// Files that the command line names, which may name more.
    more: &'a dyn Fn() -> Vec<PathBuf>,
    stamps: BTreeMap<PathBuf, Stamp>,
    /// What tells of changes; none where the system cannot.
    watcher: Option<RecommendedWatcher>,
    events: Receiver<notify::Result<Event>>,
    folders: BTreeSet<PathBuf>,
}

impl<'a> Watched<'a> {
    /// The files of `scene`, and `more`; `target` is the picture.
    pub(super) fn new(scene: &Path, target: Option<&Path>, more: &'a dyn Fn() -> Vec<PathBuf>) -> Self {
        let (tell, events) = mpsc::channel();
        let mut watched = Self {
            scene: scene.to_owned(),
            target: target.map(Path::to_owned),
            more,
            stamps: BTreeMap::new(),
            watcher: notify::recommended_watcher(tell).ok(),
            events,
            folders: BTreeSet::new(),
        };
        watched.look();
        watched
    }

    /// How many files there are.
    pub(super) fn count(&self) -> usize {
        self.stamps.len()
    }

    /// Notes how the files are now, and which there are.
    pub(super) fn look(&mut self) {
        let files = files_of(&self.scene).into_iter().chain((self.more)());
        let is_other = |path: &PathBuf| self.target.as_ref() != Some(path);
        self.stamps = files.filter(is_other).map(|path| (path.clone(), stamp(&path))).collect();
        for folder in self.stamps.keys().map(|path| parent(path).to_owned()).collect::<Vec<_>>() {
            if let Some(watcher) = &mut self.watcher
                && self.folders.insert(folder.clone())
            {
                // Folders that cannot be watched are asked.
                let _ = watcher.watch(&folder, RecursiveMode::NonRecursive);
            }
        }
    }

    /// Waits until one of the files is another than when they were looked at, and is not being written any more.
    pub(super) fn wait(&self) {
        let mut asked = Instant::now();
        loop {
            match self.events.recv_timeout(INTERVAL) {
                Ok(Ok(event)) if is_whole(&event) && self.is_changed() && stamp(&self.scene).is_some() => {
                    return;
                }
                Err(RecvTimeoutError::Disconnected) => sleep(INTERVAL),
                _ => {}
            }
            // What goes on beside the files must not keep them from being asked.
            if asked.elapsed() >= INTERVAL {
                if self.is_changed() {
                    return self.settle();
                }
                asked = Instant::now();
            }
        }
    }

    /// Whether one of the files is another than when they were looked at.
    fn is_changed(&self) -> bool {
        self.stamps.iter().any(|(path, before)| stamp(path) != *before)
    }

    /// Waits until no file changes any more.
    fn settle(&self) {
        let now = || self.stamps.keys().map(|path| stamp(path)).collect::<Vec<_>>();
        let mut last = now();
        loop {
            sleep(INTERVAL / 3);
            let next = now();
            // An editor may replace a file by removing it first.
            if next == last && stamp(&self.scene).is_some() {
                return;
            }
            last = next;
        }
    }
}

/// Whether a file was written to its end, or put in its place as a whole.
fn is_whole(event: &Event) -> bool {
    matches!(
        event.kind,
        EventKind::Access(AccessKind::Close(AccessMode::Write))
            | EventKind::Modify(ModifyKind::Name(RenameMode::To | RenameMode::Both))
    )
}

/// The folder that a file is in.
fn parent(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

fn stamp(path: &Path) -> Stamp {
    let metadata = std::fs::metadata(path).ok()?;
    Some((metadata.modified().ok()?, metadata.len()))
}

/// The scene, the files whose names stand in it, and what lies beside models, which name more files themselves.
fn files_of(scene: &Path) -> Vec<PathBuf> {
    let mut files = named_by(scene);
    let beside: Vec<PathBuf> =
        files.iter().filter(|path| names_files(path)).flat_map(|path| folder_of(path)).collect();
    files.extend(beside);
    files
}

/// Whether a scene file names this file: a picture there would be written over what it is drawn from.
pub(super) fn is_read_by(scene: &Path, picture: &Path) -> bool {
    let Ok(picture) = picture.canonicalize() else { return false };
    if !glanz_scene::is_scene_file(scene) {
        return scene.canonicalize().is_ok_and(|scene| scene == picture);
    }
    let named = named_by(scene);
    named.iter().any(|path| path.canonicalize().is_ok_and(|path| path == picture))
}

/// The scene, and the files whose names stand in it.
fn named_by(scene: &Path) -> Vec<PathBuf> {
    let folder = scene.parent().unwrap_or(Path::new(""));
    let text =
        std::fs::read(scene).map(|bytes| String::from_utf8_lossy(&bytes).into_owned()).unwrap_or_default();
    let is_scene = glanz_scene::is_scene_file(scene);
    let named = strings(&text).into_iter().filter(|name| is_scene && name.contains('.'));
    let named = named.map(|name| folder.join(name)).filter(|path| path.is_file());
    std::iter::once(scene.to_owned()).chain(named).collect()
}

/// All that stands between quotation marks on one line of a scene file, whether that makes sense or not.
fn strings(text: &str) -> Vec<&str> {
    let of_line =
        |line| ['"', '\''].into_iter().flat_map(move |mark: char| str::split(line, mark).skip(1).step_by(2));
    text.lines().flat_map(of_line).collect()
}

/// Whether a file of this name may name others.
fn names_files(path: &Path) -> bool {
    ["gltf", "obj", "vert", "frag", "vs", "fs", "glsl", "wgsl"]
        .iter()
        .any(|ending| path.extension().is_some_and(|own| own.eq_ignore_ascii_case(ending)))
}

/// The files of the folder that a file is in.
fn folder_of(path: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(parent(path)).into_iter().flatten().flatten().take(MOST_FILES);
    entries.map(|entry| entry.path()).filter(|path| path.is_file()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_between_marks_are_found_in_any_text() {
        let text = "mesh = { file = \"a.glb\" }\nx = 'b.csv' # 'c.png'\nbroken = \"d";
        assert_eq!(strings(text), ["a.glb", "b.csv", "c.png", "d"]);
    }

    #[test]
    fn a_scene_is_watched_with_the_files_that_it_names_but_not_its_picture() {
        let folder = std::env::temp_dir().join(format!("glanz-watched-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let (scene, picture) = (folder.join("a.toml"), folder.join("a.png"));
        for name in ["a.png", "b.csv", "unnamed.csv"] {
            std::fs::write(folder.join(name), "1").unwrap();
        }
        std::fs::write(&scene, "diffuse = { file = 'b.csv' }\nother = 'missing.csv'\nown = 'a.png'").unwrap();
        let mut watched = Watched::new(&scene, Some(&picture), &Vec::new);
        assert_eq!(watched.stamps.keys().cloned().collect::<Vec<_>>(), [scene.clone(), folder.join("b.csv")]);
        std::fs::write(folder.join("b.csv"), "12").unwrap();
        watched.wait();
        watched.look();
        assert_eq!(watched.count(), 2);
        std::fs::remove_dir_all(folder).unwrap();
    }
}
