use std::io::Cursor;

use ::exr::meta::attribute::Chromaticities;
use ::exr::prelude::{
    AnyChannel, AnyChannels, Blocks, Compression, Encoding, FlatSamples, Image, ImageAttributes,
    IntegerBounds, Layer, LayerAttributes, LineOrder, SmallVec, Vec2, WritableImage, f16,
};
use ::png::{BitDepth, ColorType};
use glanz_color::{srgb_decode, srgb_decode_u8};
use proptest::prelude::*;

use super::super::Scale;
use super::*;

fn png(size: (u32, u32), color: ColorType, depth: BitDepth, data: &[u8]) -> Vec<u8> {
    let mut file = Vec::new();
    let mut encoder = ::png::Encoder::new(&mut file, size.0, size.1);
    encoder.set_color(color);
    encoder.set_depth(depth);
    if color == ColorType::Indexed {
        encoder.set_palette(&[0, 0, 0, 10, 20, 30][..]);
    }
    encoder.write_header().unwrap().write_image_data(data).unwrap();
    file
}

/// An OpenEXR file of one part per list of channels, 3×2 pixels.
fn exr(parts: &[&[(&str, FlatSamples)]], compression: Compression, blocks: Blocks) -> Vec<u8> {
    let layers: SmallVec<_> = parts
        .iter()
        .enumerate()
        .map(|(number, channels)| {
            let channels: SmallVec<_> =
                channels.iter().map(|(name, samples)| AnyChannel::new(*name, samples.clone())).collect();
            let encoding = Encoding { compression, blocks, line_order: LineOrder::Increasing };
            let attributes = LayerAttributes::named(format!("part{number}").as_str());
            Layer::new((3, 2), attributes, encoding, AnyChannels::sort(channels))
        })
        .collect();
    let mut file = Cursor::new(Vec::new());
    let attributes = ImageAttributes::new(IntegerBounds::from_dimensions((3, 2)));
    Image { attributes, layer_data: layers }.write().non_parallel().to_buffered(&mut file).unwrap();
    file.into_inner()
}

fn f32s(first: f32) -> FlatSamples {
    FlatSamples::F32((0..6).map(|i| first + i as f32).collect())
}

fn f16s(first: f32) -> FlatSamples {
    FlatSamples::F16((0..6).map(|i| f16::from_f32(first + i as f32)).collect())
}

fn plane(first: f32) -> Vec<f32> {
    (0..6).map(|i| first + i as f32).collect()
}

fn rgb_file() -> Vec<u8> {
    exr(
        &[&[("R", f32s(0.5)), ("G", f16s(10.0)), ("B", f32s(-3.0)), ("A", f32s(0.0))]],
        Compression::ZIP16,
        Blocks::ScanLines,
    )
}

fn message(bytes: &[u8]) -> String {
    decode_picture(bytes, "a").unwrap_err().to_string()
}

#[test]
fn codes_of_every_kind_become_light() {
    let light = srgb_decode_u8;
    let cases: [(ColorType, BitDepth, &[u8], [f32; 3]); 7] = [
        (ColorType::Rgb, BitDepth::Eight, &[10, 20, 30], [light(10), light(20), light(30)]),
        (ColorType::Grayscale, BitDepth::Eight, &[77], [light(77); 3]),
        (ColorType::Grayscale, BitDepth::One, &[0x80], [1.0; 3]),
        (ColorType::Indexed, BitDepth::Eight, &[1], [light(10), light(20), light(30)]),
        (ColorType::Rgba, BitDepth::Eight, &[255, 0, 20, 51], [0.2, 0.0, light(20) * 0.2]),
        (ColorType::GrayscaleAlpha, BitDepth::Eight, &[255, 0], [0.0; 3]),
        (
            ColorType::Rgb,
            BitDepth::Sixteen,
            &[1, 2, 0, 0, 255, 255],
            [srgb_decode(258.0 / 65535.0), 0.0, 1.0],
        ),
    ];
    for (color, depth, data, expected) in cases {
        let picture = decode_picture(&png((1, 1), color, depth, data), "a.png").unwrap();
        assert_eq!((picture.width, picture.height, picture.scale), (1, 1, Scale::Codes));
        for (plane, expected) in picture.rgb.iter().zip(expected) {
            assert!((plane[0] - expected).abs() < 1e-7, "{color:?} {depth:?} {:?}", picture.rgb);
        }
        assert!(picture.notes.is_empty());
    }
}

#[test]
fn rows_and_columns_stay_where_they_are() {
    let picture =
        decode_picture(&png((3, 2), ColorType::Grayscale, BitDepth::Eight, &[1, 2, 3, 4, 5, 6]), "a")
            .unwrap();
    let expected: Vec<f32> = (1..=6).map(srgb_decode_u8).collect();
    assert_eq!((picture.width, picture.height, &picture.rgb[2]), (3, 2, &expected));
}

#[test]
fn another_gamma_is_told() {
    let mut file = Vec::new();
    let mut encoder = ::png::Encoder::new(&mut file, 1, 1);
    encoder.set_source_gamma(::png::ScaledFloat::new(1.0));
    encoder.write_header().unwrap().write_image_data(&[7]).unwrap();
    let notes = decode_picture(&file, "a").unwrap().notes;
    assert!(notes.len() == 1 && notes[0].contains("gamma"), "{notes:?}");
}

#[test]
fn light_comes_back_to_the_bit_in_every_compression() {
    for compression in
        [Compression::Uncompressed, Compression::RLE, Compression::ZIP1, Compression::ZIP16, Compression::PIZ]
    {
        for blocks in [Blocks::ScanLines, Blocks::Tiles(Vec2(2, 2))] {
            let channels =
                [("R", f32s(0.5)), ("G", f16s(10.0)), ("B", f32s(-3.0)), ("A", f32s(0.0)), ("id", f32s(9.0))];
            let picture = decode_picture(&exr(&[&channels], compression, blocks), "a").unwrap();
            assert_eq!((picture.width, picture.height, picture.scale), (3, 2, Scale::Light));
            assert_eq!(picture.rgb, [plane(0.5), plane(10.0), plane(-3.0)], "{compression:?} {blocks:?}");
            assert!(picture.notes.is_empty(), "{:?}", picture.notes);
        }
    }
}

#[test]
fn colours_in_a_layer_or_a_part_are_found() {
    let layer =
        [("beauty.R", f32s(1.0)), ("beauty.G", f32s(2.0)), ("beauty.B", f32s(3.0)), ("depth.Z", f32s(4.0))];
    let picture = decode_picture(&exr(&[&layer], Compression::ZIP16, Blocks::ScanLines), "a").unwrap();
    assert_eq!(picture.rgb, [plane(1.0), plane(2.0), plane(3.0)]);
    assert_eq!(picture.notes, ["the layer 'beauty' is compared"]);
    let plain = [("R", f32s(5.0)), ("G", f32s(6.0)), ("B", f32s(7.0))];
    let picture =
        decode_picture(&exr(&[&layer, &plain], Compression::ZIP16, Blocks::ScanLines), "a").unwrap();
    assert_eq!(picture.rgb, [plane(5.0), plane(6.0), plane(7.0)]);
    assert_eq!(picture.notes, ["part 1 (part1) is compared"]);
}

#[test]
fn other_primaries_are_converted() {
    let file = |white: Vec2<f32>| {
        let channels = ["R", "G", "B"].map(|name| AnyChannel::new(name, FlatSamples::F32(vec![0.5; 6])));
        let layer = Layer::new(
            (3, 2),
            LayerAttributes::default(),
            Encoding::UNCOMPRESSED,
            AnyChannels::sort(channels.into_iter().collect()),
        );
        let mut image = Image::from_layer(layer);
        image.attributes.chromaticities = Some(Chromaticities {
            red: Vec2(0.713, 0.293),
            green: Vec2(0.165, 0.83),
            blue: Vec2(0.128, 0.044),
            white,
        });
        let mut file = Cursor::new(Vec::new());
        image.write().non_parallel().to_buffered(&mut file).unwrap();
        file.into_inner()
    };
    let picture = decode_picture(&file(Vec2(0.321_68, 0.337_67)), "a").unwrap();
    // White stays white.
    assert!(picture.rgb.iter().flatten().all(|value| (value - 0.5).abs() < 1e-6), "{:?}", picture.rgb);
    assert!(picture.notes[0].contains("converted"), "{:?}", picture.notes);
    assert!(message(&file(Vec2(0.3, 0.0))).contains("expected chromaticities"));
}

#[test]
fn what_is_no_picture_of_colours_is_one_error() {
    let blocks = Blocks::ScanLines;
    let depth = exr(&[&[("Z", f32s(1.0)), ("G", f32s(1.0))]], Compression::ZIP16, blocks);
    assert_eq!(message(&depth), "a: expected channels R, G and B, found G, Z");
    let whole = FlatSamples::U32(vec![1; 6]);
    let ids = exr(&[&[("R", whole.clone()), ("G", whole.clone()), ("B", whole)]], Compression::ZIP16, blocks);
    assert_eq!(message(&ids), "a: expected half or float samples, found whole numbers in channel R");
    let nan =
        exr(&[&[("R", f32s(1.0)), ("G", f32s(f32::NAN)), ("B", f32s(1.0))]], Compression::ZIP16, blocks);
    assert_eq!(message(&nan), "a: expected finite values, found NaN at pixel 0, 0");
    assert_eq!(
        message(b"GIF89a"),
        "a: expected a PNG or OpenEXR picture, found a file that begins as neither"
    );
}

#[test]
fn a_claim_beyond_the_file_is_refused_before_memory_is_taken() {
    let mut small = png((1, 1), ColorType::Grayscale, BitDepth::Eight, &[1]);
    let claim = |side: u32, small: &mut Vec<u8>| {
        small[16..20].copy_from_slice(&side.to_be_bytes());
        small[20..24].copy_from_slice(&side.to_be_bytes());
        let crc = crc32(&small[12..29]);
        small[29..33].copy_from_slice(&crc.to_be_bytes());
        message(small)
    };
    assert!(claim(8192, &mut small).contains("bytes can hold, found a claim of 8192×8192"));
    assert!(claim(20_000, &mut small).contains("at most 16384 pixels along each side"));
    let mut light = rgb_file();
    let place = |name: &[u8]| light.windows(name.len()).position(|found| found == name).unwrap() + name.len();
    // After name and type comes the length of the value, in four bytes.
    let (window, chunks) = (place(b"dataWindow\0box2i\0") + 4, place(b"chunkCount\0int\0") + 4);
    let mut set = |at: usize, value: i32| light[at..at + 4].copy_from_slice(&value.to_le_bytes());
    set(window + 8, 3999);
    set(window + 12, 3999);
    set(chunks, 4000 / 16);
    let found = message(&light);
    assert!(found.contains("bytes can hold, found a claim of 4000×4000"), "{found}");
}

/// The sum that ends a chunk of a PNG (ISO/IEC 15948, annex D).
fn crc32(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(u32::MAX, |crc, byte| {
        (0..8).fold(crc ^ u32::from(*byte), |crc, _| (crc >> 1) ^ if crc & 1 == 1 { 0xedb8_8320 } else { 0 })
    })
}

#[test]
fn a_missing_file_and_a_device_without_end_are_errors() {
    assert!(read_picture("no/such.png").unwrap_err().to_string().starts_with("no/such.png: cannot read: "));
    #[cfg(unix)]
    assert!(matches!(read_picture("/dev/zero"), Err(ReadError::Format { .. })));
}

#[test]
fn a_file_that_ends_too_soon_is_an_error() {
    let pngs = [png((5, 4), ColorType::Rgb, BitDepth::Eight, &[9; 60]), rgb_file()];
    for file in pngs {
        for length in 0..file.len() - 1 {
            // A PNG is whole when its pixels are: what follows is 12 bytes that say so.
            let whole = file.starts_with(&PNG) && length + 16 >= file.len();
            assert!(whole || decode_picture(&file[..length], "a").is_err(), "{length} of {}", file.len());
        }
    }
}

/// Good files of every kind.
fn good() -> Vec<Vec<u8>> {
    let of = |compression, blocks| {
        let channels = [("R", f32s(0.5)), ("G", f16s(10.0)), ("B", f32s(-3.0))];
        exr(&[&channels], compression, blocks)
    };
    vec![
        png((5, 4), ColorType::Rgba, BitDepth::Eight, &[99; 80]),
        png((4, 2), ColorType::Indexed, BitDepth::One, &[0x50, 0xa0]),
        of(Compression::ZIP16, Blocks::ScanLines),
        of(Compression::PIZ, Blocks::Tiles(Vec2(2, 2))),
        of(Compression::RLE, Blocks::ScanLines),
        of(Compression::B44, Blocks::ScanLines),
        of(Compression::PXR24, Blocks::Tiles(Vec2(1, 1))),
        exr(
            &[&[("a.R", f32s(1.0)), ("a.G", f32s(1.0)), ("a.B", f32s(1.0))], &[("Z", f32s(1.0))]],
            Compression::Uncompressed,
            Blocks::ScanLines,
        ),
    ]
}

#[test]
#[ignore = "writes the seeds of the fuzz target to fuzz/seeds"]
fn write_fuzz_seeds() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/seeds/picture");
    std::fs::create_dir_all(&folder).unwrap();
    for (number, bytes) in good().into_iter().enumerate() {
        std::fs::write(folder.join(number.to_string()), bytes).unwrap();
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn damaged_files_do_not_panic(
        file in prop::sample::select(good()),
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 0..6),
        extreme in prop::option::of((
            any::<prop::sample::Index>(),
            prop::sample::select(vec![i32::MAX, i32::MIN, -1, 0, 1 << 30, 16_384, 65_536]),
        )),
        end in prop::option::of(any::<prop::sample::Index>()),
    ) {
        let mut file = file;
        for (at, byte) in changes {
            let at = at.index(file.len());
            file[at] = byte;
        }
        if let Some((at, number)) = extreme {
            let at = at.index(file.len() - 3);
            file[at..at + 4].copy_from_slice(&number.to_le_bytes());
        }
        if let Some(end) = end {
            file.truncate(end.index(file.len()));
        }
        if let Ok(picture) = decode_picture(&file, "a") {
            prop_assert!(picture.rgb.iter().all(|plane| plane.len() == picture.width * picture.height));
        }
    }

    #[test]
    fn bytes_that_are_no_file_do_not_panic(start in prop_oneof![Just(&PNG[..]), Just(&EXR[..])], rest in prop::collection::vec(any::<u8>(), 0..300)) {
        prop_assert!(decode_picture(&[start, &rest].concat(), "a").is_err());
    }
}
