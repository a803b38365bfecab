use std::io::Cursor;

use proptest::prelude::*;

use super::*;
use crate::spectra::Spectrum;
use crate::surfaces::fluorophore::Fluorophore;

pub(crate) fn bytes_of(image: SpectralImage) -> Vec<u8> {
    let mut file = Cursor::new(Vec::new());
    write_spectral_exr(&mut file, image).unwrap();
    file.into_inner()
}

fn read(bytes: &[u8]) -> Result<SpectralImage, crate::file::read::error::ReadError> {
    read_spectral_exr(bytes, "file", 1 << 20)
}

/// A picture with all that there can be.
pub(crate) fn sample() -> SpectralImage {
    let plane = |k: f32| (0..6).map(|i| k + i as f32 * 0.125).collect::<Vec<_>>();
    SpectralImage {
        width: 3,
        height: 2,
        emissive: vec![Band { nm: 400.0, values: plane(1.0) }, Band { nm: 500.5, values: plane(1e-7) }],
        reflective: vec![Band { nm: 380.0, values: plane(0.5) }, Band { nm: 390.0, values: plane(0.25) }],
        reradiation: vec![ReradiationBand { in_nm: 380.0, out_nm: 390.0, values: plane(0.1) }],
        rgb: Some([plane(0.3), plane(0.6), plane(0.9)]),
        emissive_units: "W.m^-2.sr^-1.nm^-1".to_owned(),
        exposure_ev: 1.5,
        texts: vec![("scene".to_owned(), "kite.toml".to_owned())],
        notes: Vec::new(),
    }
}

#[test]
fn everything_comes_back_to_the_bit() {
    assert_eq!(read(&bytes_of(sample())).unwrap(), sample());
}

#[test]
fn spectra_of_pixels_come_back() {
    let spectra: Vec<Spectrum> = (0..2).map(|i| Spectrum::from_fn(|nm| nm + i as f64)).collect();
    let image = read(&bytes_of(SpectralImage::of_light(2, 1, &spectra))).unwrap();
    let pixel = image.light_at(1, 0).unwrap();
    assert_eq!(pixel.to_spectrum(None).unwrap(), (spectra[1], Vec::new()));
    assert_eq!(pixel.unit, "W.m^-2.sr^-1");
    assert_eq!(image.light_at(2, 0), None);
    assert_eq!(image.reflectance_at(0, 0), None);
    assert_eq!(image.reradiation_at(0, 0), None);
}

#[test]
fn re_radiation_of_a_pixel_comes_back() {
    let dye = Fluorophore {
        absorption_nm: 450.0,
        absorption_fwhm_nm: 60.0,
        absorptance: 0.8,
        emission_nm: 520.0,
        emission_fwhm_nm: 50.0,
        quantum_yield: 0.9,
    };
    let matrix = dye.over(&Spectrum::constant(0.75)).unwrap();
    let image = SpectralImage::of_reradiation(1, 1, core::slice::from_ref(&matrix));
    assert!(image.reradiation.iter().all(|band| band.values[0] > 0.0 && band.in_nm < band.out_nm));
    let named = read(&bytes_of(image)).unwrap().reradiation_at(0, 0).unwrap();
    assert_eq!(named.band_nm, 5.0);
    let back = named.to_reradiation().unwrap();
    for (out, input) in (0..97).flat_map(|out| (0..97).map(move |input| (out, input))) {
        // The file holds 32-bit floats.
        assert!((back.get(out, input) - matrix.get(out, input)).abs() < 1e-7, "{out} {input}");
    }
}

#[test]
fn other_channels_are_left_out_with_a_remark() {
    let mut image = sample();
    image.rgb = None;
    // The writer knows spectral channels only: make an odd one by renaming in the file.
    let mut bytes = bytes_of(image);
    let name = b"T.390,000000nm\0";
    let at = bytes.windows(name.len()).position(|part| part == name).unwrap();
    bytes[at] = b'U';
    let image = read(&bytes).unwrap();
    assert_eq!(image.reflective.len(), 1);
    assert_eq!(image.notes, ["channel 'U.390,000000nm' left out: it is not spectral"]);
}

#[test]
fn what_cannot_be_written_or_read_is_an_error() {
    let write = |image| write_spectral_exr(Cursor::new(Vec::new()), image).unwrap_err().to_string();
    let mut short = sample();
    short.reflective[1].values.pop();
    let text = "channel T.390,000000nm: expected 6 values, one for each pixel, found 5";
    assert_eq!(write(short), text);
    let mut twice = sample();
    twice.emissive[1].nm = 400.0;
    assert_eq!(write(twice), "expected each channel once, found channel S0.400,000000nm twice");
    assert_eq!(write(SpectralImage::default()), "expected at least one pixel, found 0×0");
    let bare = SpectralImage { rgb: sample().rgb, width: 3, height: 2, ..SpectralImage::default() };
    let error = read(&bytes_of(bare)).unwrap_err().to_string();
    assert!(error.starts_with("file: the file: expected channels such as"), "{error}");
    let error = read_spectral_exr(&bytes_of(sample()), "file", 100).unwrap_err().to_string();
    assert_eq!(error, "file: the file: expected at most 100 bytes of pixels, found 192");
}

#[test]
fn a_small_file_cannot_claim_a_great_picture() {
    let mut bytes = bytes_of(sample());
    let mut set = |name: &[u8], at: usize, value: i32| {
        let found = bytes.windows(name.len()).position(|part| part == name).unwrap();
        let start = found + name.len() + 4 + at;
        bytes[start..start + 4].copy_from_slice(&value.to_le_bytes());
    };
    set(b"dataWindow\0box2i\0", 8, 100_000);
    set(b"dataWindow\0box2i\0", 12, 100_000);
    // Blocks of 16 lines.
    set(b"chunkCount\0int\0", 0, 6251);
    let error = read_spectral_exr(&bytes, "file", u64::MAX).unwrap_err().to_string();
    assert!(error.ends_with("bytes can hold, found a claim of 100001×100001"), "{error}");
    let error = read_spectral_exr(&bytes, "file", 1 << 30).unwrap_err();
    assert!(matches!(error, crate::file::read::error::ReadError::TooLarge { .. }), "{error}");
}

proptest! {
    #[test]
    fn broken_files_are_errors_and_no_more(
        cut in 0.0..1.0f64, flips in proptest::collection::vec((0.0..1.0f64, any::<u8>()), 0..8),
    ) {
        let mut bytes = bytes_of(sample());
        for (place, byte) in flips {
            let at = (place * bytes.len() as f64) as usize;
            bytes[at] = byte;
        }
        let length = if cut < 0.5 { bytes.len() } else { (cut * bytes.len() as f64) as usize };
        match read(&bytes[..length]) {
            Ok(image) => {
                let pixels = image.width * image.height;
                prop_assert!(image.emissive.iter().all(|band| band.values.len() == pixels));
                let _ = image.reradiation_at(0, 0).map(|named| named.to_reradiation());
            }
            Err(error) => prop_assert!(error.to_string().starts_with("file: "), "{error}"),
        }
    }
}
