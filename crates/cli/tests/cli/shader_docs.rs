//! docs/SHADERS.md and docs/MEASURED.md: their files and their commands, as a reader would try them. `GLANZ_RENEW_DOCS=1` writes what is printed anew.

use std::path::{Path, PathBuf};

use crate::folder::Folder;

fn page(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs").join(name)
}

/// A fenced block: what stands behind its marks, and its lines.
struct Block<'a> {
    head: &'a str,
    lines: Vec<&'a str>,
}

fn blocks(text: &str) -> Vec<Block<'_>> {
    let mut all: Vec<Block<'_>> = Vec::new();
    let mut open = false;
    for line in text.lines() {
        match line.strip_prefix("```") {
            Some(_) if open => open = false,
            Some(head) => {
                open = true;
                all.push(Block { head, lines: Vec::new() });
            }
            None if open => all.last_mut().unwrap().lines.push(line),
            None => {}
        }
    }
    all
}

#[test]
fn every_command_of_the_page_of_shaders_does_what_it_says() {
    every_command_does_what_the_page_says("SHADERS.md", 15);
}

#[test]
fn every_command_of_the_page_of_measured_reflectance_does_what_it_says() {
    every_command_does_what_the_page_says("MEASURED.md", 5);
}

fn every_command_does_what_the_page_says(name: &str, least: usize) {
    let text = std::fs::read_to_string(page(name)).expect("the page is there");
    let folder = Folder::new();
    let all = blocks(&text);
    for block in &all {
        if let Some((_, name)) = block.head.split_once(' ') {
            folder.write(name, block.lines.join("\n") + "\n");
        }
    }
    let mut renewed = text.clone();
    let mut commands = 0;
    for block in all.iter().filter(|block| block.head == "console") {
        for part in block.lines.join("\n").split("$ ").filter(|part| !part.is_empty()) {
            let (command, expected) = part.split_once('\n').unwrap_or((part, ""));
            let words: Vec<_> = command.split_whitespace().skip(1).collect();
            let run = folder.glanz(&words);
            assert_eq!(run.code, 0, "{command}: {}", run.stderr);
            commands += 1;
            if expected.trim().is_empty() {
                continue;
            }
            let printed = run.text().trim_end();
            renewed = renewed
                .replace(&format!("{command}\n{}", expected.trim_end()), &format!("{command}\n{printed}"));
        }
    }
    assert!(commands >= least, "{commands} commands");
    if std::env::var_os("GLANZ_RENEW_DOCS").is_some() {
        std::fs::write(page(name), renewed).expect("it can be written");
        return;
    }
    assert_eq!(renewed, text, "GLANZ_RENEW_DOCS=1 writes the page anew");
}
