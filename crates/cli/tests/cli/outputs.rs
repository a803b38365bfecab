//! Files that one command writes: each is its own, whatever it is called, and none is one that the command reads.

use crate::folder::Folder;

/// Commands that write two files: what they are without these, and the options that name them.
const TWO: [(&[&str], [&str; 2]); 3] = [
    (&["color", "spectrum", "D65"], ["--csv", "--plot"]),
    (&["color", "fluorescence", "paper-note-pink"], ["--csv", "--plot"]),
    (&["measure", "fit", "tile.csv"], ["-o", "--report"]),
];

fn folder() -> Folder {
    let folder = Folder::new();
    folder.write("tile.csv", crate::measure::TILE);
    folder.write("sub/old.svg", "mine");
    folder
}

#[test]
fn two_files_of_one_command_are_not_the_same() {
    let folder = folder();
    let before = folder.names();
    for (words, [first, second]) in TWO {
        for (a, b) in [("same.svg", "same.svg"), ("./same.svg", "same.svg"), ("sub/../same.svg", "same.svg")]
        {
            let run = folder.glanz(&[words, &[first, a, second, b]].concat());
            assert_eq!(run.code, 2, "{words:?} {a}: {}", run.stderr);
            assert!(
                run.stderr.contains(&format!("{first} and {second} name the same file")),
                "{}",
                run.stderr
            );
            assert_eq!(folder.names(), before);
        }
    }
}

#[cfg(unix)]
#[test]
fn two_files_of_one_command_are_not_the_same_by_a_link() {
    let folder = folder();
    for link in ["link.svg", "to_be.svg"] {
        let target = if link == "link.svg" { "sub/old.svg" } else { "sub/new.svg" };
        std::os::unix::fs::symlink(target, folder.path(link)).unwrap();
        for (words, [first, second]) in TWO {
            let run = folder.glanz(&[words, &[first, link, second, target]].concat());
            assert_eq!(run.code, 2, "{words:?} {link}: {}", run.stderr);
        }
    }
    assert_eq!(folder.read("sub/old.svg"), b"mine");
}

#[test]
fn a_table_beside_numbers_does_not_go_to_stdout() {
    let folder = folder();
    let before = folder.names();
    for (words, [first, _]) in TWO {
        let run = folder.glanz(&[words, &[first, "-"]].concat());
        assert_eq!(run.code, 2, "{words:?}: {}", run.stderr);
        assert!(run.stderr.contains(&format!("name a file with {first}")), "{}", run.stderr);
        assert_eq!(folder.names(), before);
    }
}

#[test]
fn programs_go_to_stdout_one_by_one() {
    let folder = Folder::with_scene();
    let print = ["shader", "print", "phong-330", "--stage", "fragment"];
    let run = folder.glanz(&[&print[..], &["-o", "-"]].concat());
    assert_eq!(run.text(), folder.glanz(&print).text());
    let run = folder.glanz(&["shader", "export", "scene.toml", "-o", "-"]);
    assert_eq!(run.code, 2, "{}", run.stderr);
    assert_eq!(folder.names(), ["scene.toml"]);
}

#[cfg(unix)]
#[test]
fn links_in_a_circle_are_no_output() {
    let folder = Folder::with_scene();
    std::os::unix::fs::symlink("b.png", folder.path("a.png")).unwrap();
    std::os::unix::fs::symlink("a.png", folder.path("b.png")).unwrap();
    let run = folder.glanz(&["render", "scene.toml", "-o", "a.png"]);
    assert_eq!(run.code, 3, "{}", run.stderr);
    assert!(run.stderr.contains("a.png: cannot follow it: its links lead to no file"), "{}", run.stderr);
    assert!(std::fs::symlink_metadata(folder.path("a.png")).unwrap().is_symlink());
}

/// A folder with files of every kind that commands read beside a scene, and a scene with a texture.
fn inputs() -> Folder {
    let folder = folder();
    folder.write("scene.toml", crate::folder::SCENE);
    folder.glanz(&["render", "scene.toml", "-o", "a.png"]).text();
    folder.glanz(&["render", "scene.toml", "-o", "wood.png"]).text();
    folder.glanz(&["color", "spectrum", "D65", "--csv", "lamp.csv"]).text();
    folder.write("dirs.csv", "theta_o_deg,phi_o_deg,theta_i_deg,phi_i_deg\n30,0,45,180\n");
    folder.write(
        "textured.toml",
        "[materials.a]\nbase_color_texture = \"wood.png\"\n[[objects]]\nmesh = \"quad\"\nmaterial = \"a\"\n",
    );
    folder
}

/// Commands that read a file and write one, without the name of the latter; the file that they read comes first.
const READERS: [(&str, &[&str]); 6] = [
    ("lamp.csv", &["color", "spectrum", "lamp.csv", "--as", "light", "--csv"]),
    ("tile.csv", &["measure", "smooth", "tile.csv", "--to", "csv", "-o"]),
    ("tile.csv", &["measure", "convert", "tile.csv", "--to", "csv", "-o"]),
    ("dirs.csv", &["bsdf", "eval", "phong", "--directions", "dirs.csv", "-o"]),
    ("wood.png", &["compare", "a.png", "wood.png", "-o"]),
    ("wood.png", &["render", "textured.toml", "-o"]),
];

#[test]
fn a_file_that_is_read_is_not_written_over() {
    let folder = inputs();
    for (input, words) in READERS {
        let before = folder.read(input);
        for name in [input.to_owned(), format!("./{input}"), format!("sub/../{input}")] {
            let run = folder.glanz(&[words, &[name.as_str()]].concat());
            assert!(matches!(run.code, 2 | 3), "{words:?} {name}: {}", run.stderr);
            assert!(
                run.stderr.contains("read") || run.stderr.contains("which is compared"),
                "{}",
                run.stderr
            );
            assert_eq!(folder.read(input), before, "{words:?} {name}");
        }
    }
}

#[cfg(unix)]
#[test]
fn a_file_that_is_read_is_not_written_over_by_a_link() {
    let folder = inputs();
    for (input, words) in READERS {
        let ending = input.rsplit('.').next().unwrap();
        let (soft, hard) = (format!("soft.{ending}"), format!("hard.{ending}"));
        std::os::unix::fs::symlink(input, folder.path(&soft)).unwrap();
        std::fs::hard_link(folder.path(input), folder.path(&hard)).unwrap();
        let before = folder.read(input);
        for link in [&soft, &hard] {
            let run = folder.glanz(&[words, &[link.as_str()]].concat());
            assert!(matches!(run.code, 2 | 3), "{words:?} {link}: {}", run.stderr);
            assert_eq!(folder.read(input), before, "{words:?} {link}");
            std::fs::remove_file(folder.path(link)).unwrap();
        }
    }
}

#[cfg(unix)]
#[test]
fn a_pattern_of_names_need_not_be_utf_8() {
    use std::os::unix::ffi::OsStrExt;
    let folder = Folder::with_scene();
    let name = std::ffi::OsStr::from_bytes(b"\xff{frame:02}\xfe.png");
    let words = ["render", "scene.toml", "--size", "8x8", "--frames", "0..2", "--turntable", "-o"];
    let output = crate::folder::command(&folder.path("")).args(words).arg(name).output().unwrap();
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    for name in [&b"\xff00\xfe.png"[..], b"\xff01\xfe.png"] {
        assert!(folder.path("").join(std::ffi::OsStr::from_bytes(name)).is_file(), "{name:?}");
    }
}
