//! Signals: each ends the command with its own exit code, and nothing half-written is left behind.

use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

use crate::folder::{Folder, command};

/// Signals that ask a program to end, and the exit codes that shells tell of them.
const SIGNALS: [(&str, i32); 4] = [("HUP", 129), ("INT", 130), ("QUIT", 131), ("TERM", 143)];

/// Moments after the first file at which a run is interrupted, in milliseconds.
const MOMENTS: [u64; 12] = [0, 1, 2, 3, 5, 8, 13, 21, 34, 40, 55, 89];

fn begin(folder: &Folder, words: &[&str]) -> Child {
    let mut command = command(&folder.path(""));
    command.args(words).stdout(Stdio::null()).stderr(Stdio::null());
    command.spawn().unwrap()
}

/// Waits until a run has written a file.
fn wait_for(folder: &Folder, name: &str) {
    for _ in 0..6000 {
        if folder.path(name).exists() {
            return;
        }
        sleep(Duration::from_millis(5));
    }
    panic!("{name} is not written");
}

/// Sends a signal; the exit code after it.
fn end(mut child: Child, signal: &str) -> i32 {
    let kill = Command::new("kill").args([&format!("-{signal}"), &child.id().to_string()]).status();
    assert!(kill.unwrap().success());
    child.wait().unwrap().code().expect("ends by itself")
}

#[test]
fn every_signal_has_its_exit_code_and_leaves_no_temporary_file() {
    let folder = Folder::with_scene();
    let words = ["render", "scene.toml", "--frames", "0..20000", "--turntable", "-o", "o_{frame}.png"];
    for ((signal, code), after) in SIGNALS.iter().cycle().zip(MOMENTS) {
        let child = begin(&folder, &words);
        wait_for(&folder, "o_0.png");
        sleep(Duration::from_millis(after));
        assert_eq!(end(child, signal), *code, "SIG{signal}");
        let left: Vec<_> = folder.names().into_iter().filter(|name| name.starts_with('.')).collect();
        assert!(left.is_empty(), "SIG{signal} leaves {left:?}");
        std::fs::remove_file(folder.path("o_0.png")).unwrap();
    }
}

#[test]
fn to_be_interrupted_is_the_way_to_end_watching() {
    let folder = Folder::with_scene();
    let child = begin(&folder, &["render", "scene.toml", "--watch", "-o", "a.png"]);
    wait_for(&folder, "a.png");
    assert_eq!(end(child, "INT"), 0);
    assert_eq!(folder.names(), ["a.png", "scene.toml"]);
}
