//! Signals: each ends the command with its own exit code, and nothing half-written is left behind.

use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

use crate::folder::{Folder, command};

/// Signals that ask a program to end, and the exit codes that shells tell of them.
const SIGNALS: [(&str, i32); 4] = [("HUP", 129), ("INT", 130), ("QUIT", 131), ("TERM", 143)];

/// Moments of a run at which it is interrupted, in milliseconds.
const MOMENTS: [u64; 6] = [60, 75, 90, 110, 140, 180];

fn begin(folder: &Folder, words: &[&str]) -> Child {
    let mut command = command(&folder.path(""));
    command.args(words).stdout(Stdio::null()).stderr(Stdio::null());
    command.spawn().unwrap()
}

/// The exit code of a run that gets a signal after so many milliseconds.
fn interrupted(folder: &Folder, words: &[&str], signal: &str, after: u64) -> i32 {
    let mut child = begin(folder, words);
    sleep(Duration::from_millis(after));
    let kill = Command::new("kill").args([&format!("-{signal}"), &child.id().to_string()]).status();
    assert!(kill.unwrap().success());
    child.wait().unwrap().code().expect("ends by itself")
}

#[test]
fn every_signal_has_its_exit_code_and_leaves_no_temporary_file() {
    let folder = Folder::with_scene();
    let words = ["render", "scene.toml", "--frames", "0..20000", "--turntable", "-o", "o_{frame}.png"];
    for ((signal, code), after) in SIGNALS.iter().cycle().zip(MOMENTS) {
        // A slow machine is still about to begin; a signal that comes before the handler is there kills.
        let found = interrupted(&folder, &words, signal, 2 * after);
        assert_eq!(found, *code, "SIG{signal}");
        let left: Vec<_> = folder.names().into_iter().filter(|name| name.starts_with('.')).collect();
        assert!(left.is_empty(), "SIG{signal} leaves {left:?}");
    }
}

#[test]
fn to_be_interrupted_is_the_way_to_end_watching() {
    let folder = Folder::with_scene();
    let mut child = begin(&folder, &["render", "scene.toml", "--watch", "-o", "a.png"]);
    for _ in 0..600 {
        if folder.names().contains(&"a.png".to_owned()) {
            break;
        }
        sleep(Duration::from_millis(50));
    }
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    assert_eq!(child.wait().unwrap().code(), Some(0));
    assert_eq!(folder.names(), ["a.png", "scene.toml"]);
}
