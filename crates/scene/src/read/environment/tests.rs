#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::io::Cursor;

use ::exr::prelude::{WritableImage, f16};
use proptest::prelude::*;

use glanz_math::MemoryBudget;

use super::*;

type Rgbe = [u8; 4];

/// A Radiance file with this header and size and these bytes.
fn radiance(header: &str, size: &str, bytes: &[u8]) -> Vec<u8> {
    let mut file = format!("#?RADIANCE\n{header}FORMAT=32-bit_rle_rgbe\n\n{size}\n").into_bytes();
    file.extend_from_slice(bytes);
    file
}

fn flat(pixels: &[Rgbe]) -> Vec<u8> {
    pixels.concat()
}

/// A line in the new encoding: each channel as runs of one, or as it is.
fn new_line(pixels: &[Rgbe], runs: bool) -> Vec<u8> {
    let mut bytes = vec![2, 2, (pixels.len() >> 8) as u8, pixels.len() as u8];
    for channel in 0..4 {
        let values: Vec<u8> = pixels.iter().map(|pixel| pixel[channel]).collect();
        if runs {
            values.iter().for_each(|value| bytes.extend([129, *value]));
        } else {
            values.chunks(128).for_each(|part| {
                bytes.push(part.len() as u8);
                bytes.extend(part);
            });
        }
    }
    bytes
}

/// An OpenEXR file of 16-bit channels with these values.
fn exr(width: usize, height: usize, of: impl Fn(usize, usize) -> [f32; 3] + Sync) -> Vec<u8> {
    let channels = ::exr::prelude::SpecificChannels::rgb(|p: ::exr::prelude::Vec2<usize>| {
        let [r, g, b] = of(p.0, p.1).map(f16::from_f32);
        (r, g, b)
    });
    let mut bytes = Cursor::new(Vec::new());
    let image = ::exr::prelude::Image::from_channels((width, height), channels);
    image.write().non_parallel().to_buffered(&mut bytes).unwrap();
    bytes.into_inner()
}

/// Files of all kinds.
pub(in crate::read) fn samples() -> Vec<Vec<u8>> {
    let pixels: Vec<Rgbe> = (0..16u8).map(|i| [i, 3 * i, 200 - i, 120 + i]).collect();
    vec![
        radiance("EXPOSURE=2\n", "-Y 1 +X 16", &new_line(&pixels, false)),
        radiance("", "+X 4 -Y 4", &flat(&pixels)),
        exr(8, 4, |x, y| [x as f32, y as f32, 0.25]),
    ]
}

fn read(bytes: &[u8]) -> (EnvironmentMap, Vec<String>) {
    read_environment(bytes, "sky", &ReadOptions::default()).unwrap_or_else(|error| panic!("{error}"))
}

fn error(bytes: &[u8]) -> String {
    read_environment(bytes, "sky", &ReadOptions::default()).expect_err("damaged").to_string()
}

const FOUR: [Rgbe; 2] = [[128, 64, 32, 129], [0, 0, 0, 0]];

#[test]
fn radiance_pixels_are_mantissas_and_an_exponent() {
    let (map, notes) = read(&radiance("", "-Y 1 +X 2", &flat(&FOUR)));
    assert_eq!((map.width, map.height, notes), (2, 1, vec![]));
    assert_eq!(map.pixels, [[1.0, 0.5, 0.25], [0.0; 3]]);
}

#[test]
fn all_encodings_of_radiance_give_the_same() {
    // One pixel, then the same again 259 times, then another.
    let pixels: Vec<Rgbe> =
        (0..261).map(|i| if i < 260 { [128, 64, 32, 130] } else { [9, 8, 7, 128] }).collect();
    let mut old = flat(&pixels[..1]);
    // 259 = 3 + 256.
    old.extend([1, 1, 1, 3, 1, 1, 1, 1]);
    old.extend(pixels[260]);
    let expected = read(&radiance("", "-Y 1 +X 261", &flat(&pixels))).0;
    for bytes in [old, new_line(&pixels, true), new_line(&pixels, false)] {
        assert_eq!(read(&radiance("", "-Y 1 +X 261", &bytes)).0, expected);
    }
}

#[test]
fn all_orientations_of_radiance_are_turned_upright() {
    // a b c above d e f.
    let [a, b, c, d, e, f] = [1, 2, 3, 4, 5, 6].map(|value| [value, 0, 0, 136]);
    let expected = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
    let cases = [
        ("-Y 2 +X 3", [a, b, c, d, e, f]),
        ("-Y 2 -X 3", [c, b, a, f, e, d]),
        ("+Y 2 +X 3", [d, e, f, a, b, c]),
        ("+Y 2 -X 3", [f, e, d, c, b, a]),
        ("+X 3 -Y 2", [a, d, b, e, c, f]),
        ("-X 3 +Y 2", [f, c, e, b, d, a]),
    ];
    for (size, pixels) in cases {
        let (map, _) = read(&radiance("", size, &flat(&pixels)));
        let reds: Vec<f32> = map.pixels.iter().map(|pixel| pixel[0]).collect();
        assert_eq!((map.width, map.height, reds.as_slice()), (3, 2, &expected[..]), "{size}");
    }
}

#[test]
fn exposure_and_colour_correction_of_radiance_are_undone() {
    let header = "EXPOSURE=4\n# a note\nEXPOSURE= 0.5\nCOLORCORR= 1 2 0.5\nSOFTWARE=none\n";
    let (map, notes) = read(&radiance(header, "-Y 1 +X 2", &flat(&FOUR)));
    assert_eq!((map.pixels[0], notes.len()), ([0.5, 0.125, 0.25], 1));
}

#[test]
fn headers_of_other_pictures_within_the_header_of_radiance_do_not_count() {
    let header = "pcomb a.hdr b.hdr\n\tEXPOSURE=4\n\tPRIMARIES=0.64 0.33 0.29 0.6 0.15 0.06 0.333 0.333\n";
    let (map, notes) = read(&radiance(header, "-Y 1 +X 2", &flat(&FOUR)));
    assert_eq!((map.pixels[0], notes), ([1.0, 0.5, 0.25], vec![]));
}

#[test]
fn radiance_pixels_as_they_are_may_look_like_runs() {
    let gray: Rgbe = [1, 1, 1, 136];
    let (map, _) = read(&radiance("", "-Y 2 +X 2", &flat(&[gray; 4])));
    assert_eq!(map.pixels, [[1.0; 3]; 4]);
}

#[test]
fn a_radiance_picture_may_begin_with_another_line() {
    let bytes = radiance("", "-Y 1 +X 2", &flat(&FOUR));
    let rest = bytes.iter().position(|byte| *byte == b'\n').unwrap();
    let (map, _) = read(&[&b"Xim format conversion by:"[..], &bytes[rest..]].concat());
    assert_eq!(map.pixels[0], [1.0, 0.5, 0.25]);
}

#[test]
fn other_primaries_are_converted_and_white_stays_white() {
    let gray = [128, 128, 128, 129];
    // Radiance's own: those of CRTs with the white E.
    let header = "PRIMARIES=0.640 0.330 0.290 0.600 0.150 0.060 0.333 0.333\n";
    let (map, notes) = read(&radiance(header, "-Y 1 +X 2", &flat(&[gray, [128, 0, 0, 129]])));
    assert_eq!(notes.len(), 1);
    // The factors of a matrix in f64, rounded to f32.
    assert!(map.pixels[0].iter().all(|value| (value - 1.0).abs() < 1e-6), "{:?}", map.pixels);
    // Calculated apart from the chromaticities and Bradford's matrix.
    let red = [1.163_705, 0.007_548, 0.003_449];
    assert!(map.pixels[1].iter().zip(red).all(|(a, b)| (a - b).abs() < 2e-6), "{:?}", map.pixels);
    let srgb = "PRIMARIES=0.640 0.330 0.300 0.600 0.150 0.060 0.3127 0.3290\n";
    let (map, notes) = read(&radiance(srgb, "-Y 1 +X 2", &flat(&[gray, gray])));
    assert_eq!((map.pixels[0], notes), ([1.0; 3], vec![]));
}

#[test]
fn openexr_is_read_as_it_is() {
    let (map, notes) = read(&exr(4, 2, |x, y| [x as f32, y as f32, 0.5]));
    assert_eq!((map.width, map.height, notes), (4, 2, vec![]));
    assert_eq!(map.pixels[6], [2.0, 1.0, 0.5]);
}

#[test]
fn unusable_pixels_are_replaced_and_told() {
    let values = [f32::NAN, f32::INFINITY, -2.0, 3.0];
    let (map, notes) = read(&exr(4, 2, |x, _| [values[x], 1.0, -0.0]));
    assert_eq!(map.pixels[..4], [[0.0; 3], [65504.0, 1.0, 0.0], [0.0, 1.0, 0.0], [3.0, 1.0, 0.0]]);
    assert_eq!(
        notes,
        [
            "an infinite value is taken as 65504 (2 times)",
            "a pixel that is not finite is taken as black (2 times)",
            "a pixel below 0 is taken as 0 in that channel (2 times)"
        ]
    );
    assert!(map.pixels.iter().flatten().all(|value| value.is_sign_positive()));
    let (map, notes) = read(&radiance("", "-Y 1 +X 2", &flat(&[[255, 1, 1, 255], [1, 2, 3, 128]])));
    assert_eq!((map.pixels[0][0], notes.len()), (MAX_VALUE, 1));
}

#[test]
fn a_picture_of_another_shape_is_read_with_a_remark() {
    let (map, notes) = read(&exr(4, 3, |_, _| [1.0; 3]));
    assert_eq!((map.width, map.height), (4, 3));
    assert!(notes[0].contains("4×3"), "{notes:?}");
}

#[test]
fn lines_of_radiance_that_say_nothing_are_as_if_absent() {
    let plain = read(&radiance("", "-Y 1 +X 2", &flat(&FOUR))).0;
    let lines = [
        "PRIMARIES=0 0 0 0 0 0 0 0",
        "PRIMARIES= 1 2",
        "PRIMARIES=0.64 0.33 0.3 0.6 0.15 0.06 0 0",
        "PRIMARIES=0.3 0.3 0.3 0.3 0.3 0.3 0.3127 0.329",
        "PRIMARIES=64 33 30 60 15 6 31 33",
        "PRIMARIES=nan 0 0 0 0 0 0 0",
        "EXPOSURE=0",
        "EXPOSURE=-1",
        "EXPOSURE=much",
        "COLORCORR=0 0 0",
        "COLORCORR=1 1",
    ];
    for line in lines {
        let (map, notes) = read(&radiance(&format!("{line}\n"), "-Y 1 +X 2", &flat(&FOUR)));
        assert_eq!(map, plain, "{line}");
        assert!(notes.len() == 1 && notes[0].contains("says nothing"), "{line}: {notes:?}");
    }
}

#[test]
fn pixels_of_cie_xyz_are_converted_with_their_white() {
    let xyz = String::from_utf8_lossy(&radiance("", "-Y 1 +X 2", &[])).replace("rgbe", "xyze");
    let bytes = [xyz.as_bytes(), &flat(&[[128, 128, 128, 129], [128, 0, 0, 129]])].concat();
    let (map, notes) = read(&bytes);
    assert!(notes[0].contains("are converted"), "{notes:?}");
    // The white E becomes that of sRGB; the factors are those of a matrix in f64.
    assert!(map.pixels[0].iter().all(|value| (value - 1.0).abs() < 1e-6), "{:?}", map.pixels);
    assert!(map.pixels[1][0] > 1.0, "{:?}", map.pixels);
    let header = "PRIMARIES=1 0 0 1 0 0 0.33333333 0.33333333\n";
    let (same, _) = read(&radiance(header, "-Y 1 +X 2", &flat(&[[128, 128, 128, 129], [128, 0, 0, 129]])));
    let pairs = map.pixels.as_flattened().iter().zip(same.pixels.as_flattened());
    assert!(pairs.into_iter().all(|(a, b)| (a - b).abs() < 1e-5), "{map:?} {same:?}");
}

/// An OpenEXR file of these 32-bit channels, each of which has the value of each pixel.
fn exr_of(
    channels: &[(&str, f32)],
    change: impl Fn(&mut ::exr::meta::header::ImageAttributes, &mut ::exr::meta::header::LayerAttributes),
) -> Vec<u8> {
    use ::exr::prelude::{AnyChannel, AnyChannels, Encoding, FlatSamples, Image, Layer, LayerAttributes};
    let size = (4, 2);
    let all = channels.iter().map(|(name, value)| AnyChannel::new(*name, FlatSamples::F32(vec![*value; 8])));
    let mut layer =
        Layer::new(size, LayerAttributes::default(), Encoding::default(), AnyChannels::sort(all.collect()));
    let mut attributes = ::exr::meta::header::ImageAttributes::with_size(size);
    change(&mut attributes, &mut layer.attributes);
    let mut image = Image::from_layer(layer);
    image.attributes = attributes;
    let mut bytes = Cursor::new(Vec::new());
    image.write().non_parallel().to_buffered(&mut bytes).unwrap();
    bytes.into_inner()
}

#[test]
fn layers_and_luminance_of_exr_are_pictures() {
    let (map, notes) =
        read(&exr_of(&[("sky.R", 1.0), ("sky.G", 2.0), ("sky.B", 3.0), ("depth.Z", 9.0)], |_, _| ()));
    assert_eq!(
        (map.pixels[0], &notes[0][..]),
        ([1.0, 2.0, 3.0], "the channels R, G and B of the layer 'sky' are taken")
    );
    let (map, notes) = read(&exr_of(&[("Y", 0.5)], |_, _| ()));
    assert_eq!((map.pixels[7], notes.len()), ([0.5; 3], 1));
    let (map, notes) = read(&exr_of(&[("BY", 0.1), ("RY", 0.2), ("Y", 0.5)], |_, _| ()));
    assert_eq!((map.pixels[7], notes.len()), ([0.5; 3], 1));
    let error = error(&exr_of(&[("Z", 0.5)], |_, _| ()));
    assert!(error.contains("expected channels R, G and B, or Y, found Z"), "{error}");
}

#[test]
fn infinite_light_of_exr_is_the_largest_and_a_cube_is_told() {
    let channels = [("R", f32::INFINITY), ("G", 2.0), ("B", 1e6)];
    let (map, notes) = read(&exr_of(&channels, |_, _| ()));
    assert_eq!(
        (map.pixels[0], &notes[0][..]),
        ([1e6, 2.0, 1e6], "an infinite value is taken as 1000000 (8 times)")
    );
    let bytes = exr_of(&[("R", 1.0), ("G", 1.0), ("B", 1.0)], |_, layer| {
        layer.environment_map = Some(::exr::meta::attribute::EnvironmentMap::Cube);
    });
    assert!(error(&bytes).contains("found the six sides of a cube (envmap)"), "{}", error(&bytes));
}

#[test]
fn chromaticities_of_exr_may_be_those_of_xyz_or_none() {
    let pixel = [("R", 1.0), ("G", 1.0), ("B", 1.0)];
    let with = |blue: (f32, f32), white: (f32, f32)| {
        read(&exr_of(&pixel, |image, _| {
            image.chromaticities = Some(::exr::meta::attribute::Chromaticities {
                red: ::exr::prelude::Vec2(1.0, 0.0),
                green: ::exr::prelude::Vec2(0.0, 1.0),
                blue: ::exr::prelude::Vec2(blue.0, blue.1),
                white: ::exr::prelude::Vec2(white.0, white.1),
            });
        }))
    };
    let (map, notes) = with((0.0, 0.0), (1.0 / 3.0, 1.0 / 3.0));
    assert!(notes[0].contains("are converted"), "{notes:?}");
    // X = Y = Z = 1 by the matrix of IEC 61966-2-1: a colour as it is, not a white that becomes D65.
    let expected = [1.2048, 0.9483, 0.9089];
    assert!(map.pixels[0].iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-3), "{:?}", map.pixels[0]);
    let (map, notes) = with((0.0, 1.0), (0.0, 0.0));
    assert_eq!(map.pixels[0], [1.0; 3]);
    assert!(notes[0].contains("span no colours and are ignored"), "{notes:?}");
}

#[test]
fn errors_say_where_and_what_was_expected() {
    let good = radiance("", "-Y 2 +X 4", &flat(&[[1, 2, 3, 128]; 8]));
    let text = |from: &str, to: &str| {
        let at = good.windows(from.len()).position(|part| part == from.as_bytes()).expect("it is there");
        [&good[..at], to.as_bytes(), &good[at + from.len()..]].concat()
    };
    let cases = [
        (b"PNG".to_vec(), "sky: the file: expected a Radiance HDR or OpenEXR picture, found 'PNG'"),
        (good[..good.len() - 1].to_vec(), "scan line 1: expected 4 pixels, found damage or the end"),
        (text("rgbe", "luve"), "or 32-bit_rle_xyze, found '32-bit_rle_luve', which is not supported"),
        (text("-Y 2 +X 4", "-Y 2 +Y 4"), "byte 35: expected a size such as '-Y 512 +X 1024', found"),
        (text("-Y 2", "-Y 0"), "expected a picture of 1 to 16384 pixels along each side, found 4×0"),
        (text("+X 4", "+X 99999"), "along each side, found 99999×2"),
        (text("\n\n", "\n"), "an empty line ends, found none"),
    ];
    for (bytes, expected) in cases {
        let found = error(&bytes);
        assert!(found.contains(expected), "{found}\n{expected}");
    }
    let mut short = exr(8, 8, |_, _| [1.0; 3]);
    short.truncate(short.len() - 4);
    assert!(error(&short).contains("expected an OpenEXR picture"), "{}", error(&short));
}

#[test]
fn runs_that_do_not_fit_are_refused() {
    let line = |bytes: &[u8]| error(&radiance("", "-Y 1 +X 8", bytes));
    let new = [2, 2, 0, 8];
    let cases = [
        [&new[..], &[137, 5]].concat(),
        [&new[..], &[0; 99]].concat(),
        [1, 1, 1, 3].to_vec(),
        flat(&[[5, 5, 5, 128], [1, 1, 1, 200]]),
        flat(&[[5, 5, 5, 128]].iter().copied().chain([[1, 1, 1, 0]; 40]).collect::<Vec<_>>()),
    ];
    for bytes in cases {
        assert!(line(&bytes).contains("scan line 0: expected 8 pixels"), "{bytes:?}");
    }
}

#[test]
fn limits_of_side_and_memory_hold() {
    let bytes = exr(8, 4, |_, _| [1.0; 3]);
    let read = |options: ReadOptions| read_environment(&bytes, "sky", &options).map(|_| ());
    assert!(read(ReadOptions { max_texture_side: 7, ..ReadOptions::default() }).is_err());
    let with = |bytes: u64| ReadOptions {
        memory: MemoryBudget::of_bytes(bytes),
        max_texture_side: 8,
        ..ReadOptions::default()
    };
    assert!(matches!(read(with(8 * 4 * 28 - 1)), Err(ReadError::Memory { .. })));
    assert!(read(with(8 * 4 * 28)).is_ok());
    let claim = radiance("", "-Y 16384 +X 16384", &[]);
    let found = read_environment(
        &claim,
        "sky",
        &ReadOptions { memory: MemoryBudget::of_bytes(6_000_000_000), ..ReadOptions::default() },
    );
    let found = found.unwrap_err().to_string();
    assert!(
        found.contains("expected at most 6 GB of memory, found 7.52 GB for an environment of 16384×16384"),
        "{found}"
    );
}

/// What holds of every answer.
fn check(bytes: &[u8]) -> Result<(), TestCaseError> {
    let options = ReadOptions { memory: MemoryBudget::of_bytes(1 << 20), ..ReadOptions::default() };
    match read_environment(bytes, "sky", &options) {
        Ok((map, _)) => {
            prop_assert!(map.width > 0 && map.height > 0);
            prop_assert_eq!(map.pixels.len(), map.width * map.height);
            let mut values = map.pixels.iter().flatten();
            prop_assert!(values.all(|value| (0.0..=MAX_VALUE).contains(value)));
        }
        Err(error) => prop_assert!(error.to_string().contains(": expected ")),
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(300) })]

    #[test]
    fn any_bytes_after_the_first_are_read_or_refused(
        bytes in prop::collection::vec(any::<u8>(), 0..300),
        is_exr in any::<bool>(),
        size in "[-+][XY] [0-9]{1,5} [-+][XY] [0-9]{1,2}",
    ) {
        let file = if is_exr { [EXR, &bytes].concat() } else { radiance("", &size, &bytes) };
        check(&file)?;
        check(&bytes)?;
    }

    #[test]
    fn damaged_files_are_read_or_refused(
        which in 0usize..3,
        edits in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..5),
        keep in 0.0..1.5,
    ) {
        let mut bytes = samples().swap_remove(which);
        for (place, value) in edits {
            let at = place.index(bytes.len());
            bytes[at] = value;
        }
        bytes.truncate((keep * bytes.len() as f64) as usize);
        check(&bytes)?;
    }
}
