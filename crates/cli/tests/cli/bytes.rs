//! Files are the same to the byte from run to run.

use glanz_color::Spectrum;
use glanz_color::read::Quantity;
use glanz_color::write::write_spdx;

use crate::folder::Folder;
use crate::spectra::PATCHES;

/// Files, and the words that make them.
const FILES: [(&str, &str); 16] = [
    ("8.png", "render scene.toml -o"),
    ("16.png", "render scene.toml --bit-depth 16 -o"),
    ("rgb.exr", "render scene.toml --mode rgb -o"),
    ("spectral.exr", "render scene.toml -o"),
    ("cie1964.exr", "render scene.toml --observer cie1964 --white scene -o"),
    ("meyer.exr", "render scene.toml --mode meyer -o"),
    ("meyer-adapted.exr", "render scene.toml --mode meyer-adapted -o"),
    ("sampled.exr", "render scene.toml --mode sampled:5 -o"),
    ("reference.exr", "render scene.toml --mode reference -o"),
    ("spectra.exr", "render scene.toml --spectral-exr -o"),
    ("still.gif", "render scene.toml -o"),
    ("film.gif", "render scene.toml --frames 0..3 --turntable -o"),
    ("film.apng", "render scene.toml --frames 0..3 --turntable -o"),
    ("plot.svg", "color plot spectra D65 A FL11 -o"),
    ("plot.png", "color plot spectra D65 A FL11 -o"),
    ("light.csv", "color spectrum FL11 --csv"),
];

/// Each run is a process of its own: the state of hash maps differs from one to the next.
#[test]
fn files_are_the_same_from_run_to_run() {
    let folder = Folder::new();
    folder.write("scene.toml", PATCHES);
    let mut differ = Vec::new();
    for (name, words) in FILES {
        let run = || {
            let words: Vec<&str> = words.split(' ').chain([name]).collect();
            let run = folder.glanz(&words);
            assert_eq!(run.code, 0, "{name}: {}", run.stderr);
            let bytes = folder.read(name);
            std::fs::remove_file(folder.path(name)).unwrap();
            bytes
        };
        let first = run();
        // Two entries of a map are in the same order in every other run.
        if !(0..3).all(|_| run() == first) {
            differ.push(name);
        }
    }
    let spdx = || {
        let mut bytes = Vec::new();
        write_spdx(&mut bytes, "lamp", Quantity::Relative, &Spectrum::from_fn(|nm| nm)).unwrap();
        bytes
    };
    if spdx() != spdx() {
        differ.push("lamp.spdx");
    }
    assert!(differ.is_empty(), "{differ:?}");
}
