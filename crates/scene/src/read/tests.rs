//! What holds for all readers: no bytes do harm, and every error names file, place and expectation.

use std::collections::HashMap;
use std::path::Path;

use proptest::prelude::*;

use super::models::{gltf, obj, ply, stl};
use super::*;

/// Reads bytes of this format under the name `file`.
pub(super) fn read_bytes(bytes: &[u8], format: Format) -> Result<Model, ReadError> {
    read_model_bytes(bytes, format, "file", &NoFiles, &ReadOptions::default())
}

/// The message of the one error that reading must give, which begins with the file's name.
pub(super) fn error_of(bytes: &[u8], format: Format) -> String {
    let message = read_bytes(bytes, format).expect_err("the file is broken").to_string();
    assert!(message.starts_with("file: "), "{message}");
    assert!(message.contains("expected"), "{message}");
    message
}

/// Checks what all other code relies on.
pub(super) fn check(model: &Model) {
    for mesh in &model.meshes {
        assert_eq!(mesh.validate(), Ok(()));
        let unit = |length: f32| (length - 1.0).abs() < 1e-5;
        assert!(mesh.normals.iter().all(|normal| unit(normal.length())));
        assert!(mesh.tangents.iter().all(|tangent| unit(tangent.truncate().length())));
    }
    for object in &model.objects {
        assert!(object.mesh < model.meshes.len() && object.material < model.materials.len());
        assert!(object.transform.is_finite());
    }
    for material in &model.materials {
        for map in [material.base_color, material.normal_map, material.emission_map].iter().flatten() {
            assert!(map.texture < model.textures.len());
        }
    }
    for texture in &model.textures {
        assert_eq!(texture.rgba.len(), texture.width as usize * texture.height as usize * 4);
        assert!(!texture.rgba.is_empty());
    }
}

/// The files that samples refer to.
fn companions() -> HashMap<String, Vec<u8>> {
    HashMap::from([
        ("m.mtl".to_owned(), obj::tests::MTL.as_bytes().to_vec()),
        ("wood.png".to_owned(), texture::tests::png(2, 2, &[200; 16])),
    ])
}

/// Valid files of all formats and encodings.
fn samples() -> Vec<(Format, Vec<u8>)> {
    let mut samples = vec![
        (Format::Gltf, gltf::tests::sample_glb()),
        (Format::Gltf, gltf::tests::sample_json().into_bytes()),
        (Format::Obj, obj::tests::SAMPLE.as_bytes().to_vec()),
        (Format::Stl, stl::tests::TEXT.as_bytes().to_vec()),
        (Format::Stl, stl::tests::binary()),
    ];
    samples.extend(ply::tests::samples().map(|bytes| (Format::Ply, bytes)));
    samples.extend(gltf::tests::compressed_samples().map(|bytes| (Format::Gltf, bytes)));
    samples
}

#[test]
fn all_samples_are_valid() {
    for (format, bytes) in samples() {
        let model = read_model_bytes(&bytes, format, "file", &companions(), &ReadOptions::default());
        let model = model.unwrap_or_else(|error| panic!("{format:?}: {error}"));
        check(&model);
        assert!(model.triangle_count() > 0, "{format:?}");
    }
}

#[test]
#[ignore = "writes the seeds of the fuzz targets to fuzz/seeds"]
fn write_fuzz_seeds() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/seeds");
    let write = |target: &str, number: usize, bytes: &[u8]| {
        std::fs::create_dir_all(folder.join(target)).unwrap();
        std::fs::write(folder.join(target).join(format!("{number}")), bytes).unwrap();
    };
    for (number, (format, bytes)) in samples().into_iter().enumerate() {
        match format {
            Format::Gltf => write("gltf", number, &bytes),
            Format::Ply => write("ply", number, &bytes),
            Format::Stl => write("stl", number, &bytes),
            // The fuzz target takes all files of a model in one.
            Format::Obj => {
                let [mtl, png] = ["m.mtl", "wood.png"].map(|name| companions()[name].clone());
                write("obj", number, &[&bytes[..], &mtl, &png].join(&0));
            }
        }
    }
    for (number, bytes) in texture::tests::samples().into_iter().enumerate() {
        write("texture", number, &bytes);
    }
    for (number, (text, file)) in profile::tests::samples().into_iter().enumerate() {
        // The fuzz target chooses the format by the first byte.
        let first = u8::from(file.ends_with(".ldt"));
        write("profile", number, &[&[first], text.as_bytes()].concat());
    }
    for (number, bytes) in environment::tests::samples().into_iter().enumerate() {
        write("environment", number, &bytes);
    }
}

/// A grid of a million triangles in this format.
fn million(format: Format) -> Vec<u8> {
    const SIDE: u32 = 708;
    let points = || (0..SIDE * SIDE).map(|i| [(i % SIDE) as f32, (i / SIDE) as f32, (i % 7) as f32]);
    let first = (0..SIDE - 1).flat_map(|y| (0..SIDE - 1).map(move |x| y * SIDE + x));
    let triangles: Vec<[u32; 3]> =
        first.flat_map(|i| [[i, i + 1, i + SIDE], [i + 1, i + SIDE + 1, i + SIDE]]).collect();
    let mut bytes = Vec::new();
    match format {
        Format::Gltf => {
            points().flatten().for_each(|value| bytes.extend(value.to_le_bytes()));
            triangles.iter().flatten().for_each(|index| bytes.extend(index.to_le_bytes()));
            return gltf::tests::grid(SIDE * SIDE, triangles.len() as u32, &bytes);
        }
        Format::Obj => {
            points().for_each(|[x, y, z]| bytes.extend(format!("v {x} {y} {z}.25\n").bytes()));
            let corners = |[a, b, c]: [u32; 3]| format!("f {} {} {}\n", a + 1, b + 1, c + 1);
            triangles.iter().for_each(|&triangle| bytes.extend(corners(triangle).bytes()));
        }
        Format::Ply => {
            let header = "ply\nformat binary_little_endian 1.0\nelement vertex COUNT\nproperty float x\n\
                          property float y\nproperty float z\nelement face FACES\n\
                          property list uchar int vertex_indices\nend_header\n";
            let header = header.replace("COUNT", &(SIDE * SIDE).to_string());
            bytes.extend(header.replace("FACES", &triangles.len().to_string()).bytes());
            points().flatten().for_each(|value| bytes.extend(value.to_le_bytes()));
            for triangle in &triangles {
                bytes.push(3);
                triangle.iter().for_each(|index| bytes.extend(index.to_le_bytes()));
            }
        }
        Format::Stl => {
            let points: Vec<[f32; 3]> = points().collect();
            bytes.resize(80, 0);
            bytes.extend((triangles.len() as u32).to_le_bytes());
            for triangle in &triangles {
                bytes.extend([0; 12]);
                let corners = triangle.iter().flat_map(|&index| points[index as usize]);
                corners.for_each(|value| bytes.extend(value.to_le_bytes()));
                bytes.extend([0; 2]);
            }
        }
    }
    bytes
}

#[test]
#[ignore = "measures time: run with --release --ignored --nocapture"]
fn a_million_triangles_are_read_in_under_a_second() {
    for format in [Format::Gltf, Format::Obj, Format::Ply, Format::Stl] {
        let bytes = million(format);
        let start = std::time::Instant::now();
        let model = read_bytes(&bytes, format).unwrap();
        let seconds = start.elapsed().as_secs_f64();
        println!("{format:?}: {} MB in {:.0} ms", bytes.len() / 1_000_000, seconds * 1e3);
        assert_eq!(model.triangle_count(), 707 * 707 * 2);
        assert!(seconds < 1.0);
    }
}

/// Reads damaged bytes, and checks what comes out whichever it is.
fn read_damaged(bytes: &[u8], format: Format) {
    match read_model_bytes(bytes, format, "file", &companions(), &ReadOptions::default()) {
        Ok(model) => check(&model),
        Err(error) => {
            let message = error.to_string();
            assert!(message.contains(": expected "), "{message}");
            assert!(
                ["file: ", "m.mtl: ", "wood.png: "].iter().any(|name| message.starts_with(name)),
                "{message}"
            );
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn truncated_and_flipped_files_do_no_harm(
        sample in any::<prop::sample::Index>(),
        keep in any::<prop::sample::Index>(),
        cut in any::<bool>(),
        flips in proptest::collection::vec((any::<prop::sample::Index>(), 0u8..8), 0..4),
    ) {
        let samples = samples();
        let (format, mut bytes) = samples[sample.index(samples.len())].clone();
        for (byte, bit) in flips {
            let byte = byte.index(bytes.len());
            bytes[byte] ^= 1 << bit;
        }
        if cut {
            bytes.truncate(keep.index(bytes.len()));
        }
        read_damaged(&bytes, format);
    }

    #[test]
    fn numbers_replaced_by_absurd_ones_do_no_harm(
        sample in any::<prop::sample::Index>(),
        place in any::<prop::sample::Index>(),
        absurd in prop::sample::select(vec!["-1", "4294967296", "1000000000", "nan", "1e400", "0", "18446744073709551615"]),
    ) {
        let samples: Vec<(Format, Vec<u8>)> =
            samples().into_iter().filter(|(_, bytes)| bytes.iter().any(u8::is_ascii_digit)).collect();
        let (format, bytes) = samples[sample.index(samples.len())].clone();
        let digits: Vec<usize> = (0..bytes.len()).filter(|&i| bytes[i].is_ascii_digit()).collect();
        let at = digits[place.index(digits.len())];
        let end = at + bytes[at..].iter().take_while(|byte| byte.is_ascii_digit()).count();
        let damaged = [&bytes[..at], absurd.as_bytes(), &bytes[end..]].concat();
        read_damaged(&damaged, format);
    }

    #[test]
    fn random_bytes_do_no_harm(
        format in prop::sample::select(vec![Format::Gltf, Format::Obj, Format::Ply, Format::Stl]),
        bytes in proptest::collection::vec(any::<u8>(), 0..200),
        magic in any::<bool>(),
    ) {
        let head: &[u8] = match (magic, format) {
            (false, _) => b"",
            (_, Format::Gltf) => b"glTF\x02\0\0\0\xa0\0\0\0",
            (_, Format::Obj) => b"v 0 0 0\nf 1 ",
            (_, Format::Ply) => b"ply\nformat ascii 1.0\n",
            (_, Format::Stl) => b"solid\nfacet ",
        };
        read_damaged(&[head, &bytes].concat(), format);
    }
}

#[test]
fn formats_are_known_by_first_bytes_and_names() {
    let detect = |name: &str, head: &[u8]| Format::detect(Path::new(name), head);
    assert_eq!(detect("a.obj", b"glTF\x02"), Some(Format::Gltf));
    assert_eq!(detect("a", b"ply\nformat"), Some(Format::Ply));
    assert_eq!(detect("a.OBJ", b"# x"), Some(Format::Obj));
    assert_eq!(detect("a.stl", b"\0\0"), Some(Format::Stl));
    assert_eq!(detect("a", b" {\"asset\""), Some(Format::Gltf));
    assert_eq!(detect("a", b"solid x"), Some(Format::Stl));
    assert_eq!(detect("a.txt", b"hello"), None);
}

/// A folder of its own for one test, removed at its end.
struct Scratch(std::path::PathBuf);

impl Scratch {
    fn new(name: &str, files: &[(&str, &[u8])]) -> Self {
        let path = std::env::temp_dir().join(format!("glanz-read-{name}-{}", std::process::id()));
        std::fs::create_dir_all(path.join("inner")).unwrap();
        for (name, bytes) in files {
            std::fs::write(path.join(name), bytes).unwrap();
        }
        Self(path)
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

#[test]
fn files_are_read_with_what_they_refer_to() {
    let wood = texture::tests::png(2, 2, &[200; 16]);
    let files: [(&str, &[u8]); 3] = [
        ("a.obj", obj::tests::SAMPLE.as_bytes()),
        ("m.mtl", obj::tests::MTL.as_bytes()),
        ("wood.png", &wood),
    ];
    let scratch = Scratch::new("refer", &files);
    let model = read_model(&scratch.0.join("a.obj"), &ReadOptions::default()).unwrap();
    check(&model);
    assert_eq!(model.textures.len(), 1);
}

#[test]
fn references_out_of_the_folder_are_remarks_but_of_buffers_errors() {
    let obj = b"mtllib ../m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n";
    let gltf = br#"{"asset":{"version":"2.0"},"buffers":[{"byteLength":1,"uri":"..%2Fm.mtl"}]}"#;
    let mtl = b"newmtl a\nmap_Kd ../wood.png\n";
    let uses = b"mtllib b.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n";
    let wood = texture::tests::png(1, 1, &[200; 4]);
    let files: [(&str, &[u8]); 6] = [
        ("m.mtl", b"newmtl a\nKd 1 0 0\n"),
        ("wood.png", &wood),
        ("inner/a.obj", obj),
        ("inner/a.gltf", gltf),
        ("inner/b.mtl", mtl),
        ("inner/b.obj", uses),
    ];
    let scratch = Scratch::new("outside", &files);
    let read = |file: &str, options: &ReadOptions| read_model(&scratch.0.join("inner").join(file), options);
    let strict = ReadOptions::default();
    for (file, what) in [
        ("a.obj", "the material file '../m.mtl' lies outside"),
        ("b.obj", "the picture '../wood.png' lies outside"),
    ] {
        let model = read(file, &strict).unwrap();
        let is_told = |note: &String| note.contains(what) && note.contains("--allow-outside permits");
        assert!(model.notes.iter().any(is_told), "{:?}", model.notes);
        assert!(model.textures.is_empty() && model.triangle_count() == 1);
    }
    let error = read("a.gltf", &strict).unwrap_err();
    assert!(
        matches!(error, ReadError::Outside { .. }) && error.to_string().contains("--allow-outside"),
        "{error}"
    );
    assert_eq!(error.place().to_string(), "buffers[0]");
    let free = ReadOptions { allow_outside: true, ..ReadOptions::default() };
    let wider = ReadOptions { root: Some(scratch.0.clone()), ..ReadOptions::default() };
    for options in [free, wider] {
        assert_eq!(read("a.obj", &options).unwrap().materials[0].name, "a");
        assert_eq!(read("b.obj", &options).unwrap().textures.len(), 1);
    }
    let elsewhere = ReadOptions { root: Some(scratch.0.join("inner")), ..ReadOptions::default() };
    assert!(matches!(read_model(&scratch.0.join("m.mtl"), &elsewhere), Err(ReadError::Outside { .. })));
}

#[test]
fn missing_unknown_and_oversized_files_give_one_error() {
    let scratch = Scratch::new("missing", &[("a.txt", b"hello"), ("a.obj", b"v 0 0 0\n")]);
    let read = |name: &str, options| read_model(&scratch.0.join(name), options).unwrap_err();
    let options = ReadOptions::default();
    assert!(matches!(read("none.obj", &options), ReadError::Missing { .. }));
    assert!(matches!(read("a.txt", &options), ReadError::Unsupported { .. }));
    assert!(matches!(read("inner", &options), ReadError::Io { .. }));
    let small = ReadOptions { max_bytes: 7, ..ReadOptions::default() };
    assert!(matches!(read("a.obj", &small), ReadError::TooLarge { limit: 7, found: 8, .. }));
}
