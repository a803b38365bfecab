//! The files in which gold pictures are kept.

use std::collections::BTreeMap;
use std::path::PathBuf;

/// The folder of this test.
pub(crate) fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/golden")
}

/// Whether the files are to be written rather than compared.
fn renews() -> bool {
    std::env::var_os("GLANZ_RENEW").is_some()
}

/// Compares a group of pictures, each a name, a size, its 8-bit codes and its hash, with those that are kept in
/// `folder/GROUP/`; or writes them.
pub(crate) fn compare(group: &str, pictures: Vec<(String, [usize; 2], Vec<u8>, u64)>) {
    let folder = folder().join(group);
    let list = folder.join("hashes.txt");
    if renews() {
        std::fs::create_dir_all(&folder).unwrap();
        for (name, size, rgba, _) in &pictures {
            write(&folder.join(format!("{name}.png")), *size, rgba);
        }
        let lines = pictures.iter().map(|(name, .., hash)| format!("{hash:016x}  {name}\n"));
        std::fs::write(&list, lines.collect::<String>()).unwrap();
        return;
    }
    let kept: BTreeMap<String, String> = std::fs::read_to_string(&list)
        .unwrap_or_default()
        .lines()
        .filter_map(|line| line.split_once("  "))
        .map(|(hash, name)| (name.to_owned(), hash.to_owned()))
        .collect();
    let mut complaints = Vec::new();
    for (name, size, rgba, hash) in &pictures {
        let path = folder.join(format!("{name}.png"));
        if !path.is_file() || !kept.contains_key(name) {
            complaints.push(format!("{name}: none is kept yet"));
        } else if read(&path) != (*size, rgba.clone()) {
            complaints.push(format!("{name}: the picture differs"));
        } else if kept[name] != format!("{hash:016x}") {
            complaints.push(format!("{name}: the picture is the same, but the linear planes differ"));
        }
    }
    let drawn = |name: &String| pictures.iter().any(|(own, ..)| own == name);
    complaints.extend(kept.keys().filter(|name| !drawn(name)).map(|name| format!("{name}: no longer drawn")));
    assert!(
        complaints.is_empty(),
        "gold pictures of {group} differ (GLANZ_RENEW=1 writes them anew):\n  {}",
        complaints.join("\n  ")
    );
}

fn write(path: &std::path::Path, [width, height]: [usize; 2], rgba: &[u8]) {
    let file = std::fs::File::create(path).unwrap();
    let mut encoder = png::Encoder::new(file, width as u32, height as u32);
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.write_header().unwrap().write_image_data(rgba).unwrap();
}

fn read(path: &std::path::Path) -> ([usize; 2], Vec<u8>) {
    let file = std::io::BufReader::new(std::fs::File::open(path).unwrap());
    let mut reader = png::Decoder::new(file).read_info().unwrap();
    let mut rgba = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut rgba).unwrap();
    ([info.width as usize, info.height as usize], rgba)
}
