//! What a block of DWA may claim: its decoder takes memory by counts that a damaged file makes up.

use ::exr::block::chunk::{Chunk, CompressedBlock, CompressedScanLineBlock, CompressedTileBlock};
use ::exr::compression::Compression;
use ::exr::meta::header::Header;

use super::part::ExrReadError;

/// The eleven numbers before every block, by OpenEXR's `DataSizesSingle`.
const NUMBERS: usize = 11;

/// That a block claims no more than its pixels can need; blocks of other compressions claim nothing.
pub(super) fn check(chunk: &Chunk, header: &Header) -> Result<(), ExrReadError> {
    if !matches!(header.compression, Compression::DWAA(_) | Compression::DWAB(_)) {
        return Ok(());
    }
    let (CompressedBlock::ScanLine(CompressedScanLineBlock { compressed_pixels_le: bytes, .. })
    | CompressedBlock::Tile(CompressedTileBlock { compressed_pixels_le: bytes, .. })) =
        &chunk.compressed_block
    else {
        return Ok(());
    };
    let place = header.get_block_data_indices(&chunk.compressed_block)?;
    let size = header.get_absolute_block_pixel_coordinates(place)?.size;
    let plain = size.area() * header.channels.bytes_per_pixel;
    if bytes.is_empty() || bytes.len() == plain {
        return Ok(());
    }
    let number =
        |i: usize| -> Option<u64> { bytes.get(8 * i..8 * i + 8)?.try_into().ok().map(u64::from_le_bytes) };
    let numbers: Option<Vec<u64>> = (0..NUMBERS).map(number).collect();
    let Some(numbers) = numbers else {
        return Err(ExrReadError::malformed("a whole block of DWA", format_args!("{} bytes", bytes.len())));
    };
    // Squares of 8 × 8 pixels of a channel: one mean, and 63 more numbers.
    let squares = size.x().div_ceil(8) as u64 * size.y().div_ceil(8) as u64;
    let squares = squares * header.channels.list.len() as u64;
    let (plain, held) = (plain as u64, bytes.len() as u64);
    let most = [plain, held, held, held, held, 2 * plain + 64, plain, 64 * squares, squares];
    let names = [
        "bytes as they are",
        "compressed bytes",
        "compressed bytes of differences",
        "compressed bytes of means",
        "compressed bytes of runs",
        "bytes of runs",
        "bytes in runs",
        "differences",
        "means",
    ];
    for ((name, most), found) in names.into_iter().zip(most).zip(&numbers[1..]) {
        if *found > most {
            let expected = format!("at most {most} {name} in a block of DWA");
            return Err(ExrReadError::malformed(expected, format_args!("a claim of {found}")));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use ::exr::prelude::*;

    use super::super::ExrFile;

    /// A picture of smooth colours, 40 by 36 pixels, as DWAA.
    fn picture() -> Vec<u8> {
        let color = |Vec2(x, y): Vec2<usize>| {
            let [x, y] = [x, y].map(|i| i as f32 / 40.0);
            (f16::from_f32(x), f16::from_f32(y * y), f16::from_f32(0.3 + 0.2 * libm::sinf(9.0 * x * y)))
        };
        let encoding = Encoding { compression: Compression::DWAA(None), ..Encoding::FAST_LOSSLESS };
        let layer =
            Layer::new((40, 36), LayerAttributes::named("main"), encoding, SpecificChannels::rgb(color));
        let mut file = Cursor::new(Vec::new());
        Image::from_layer(layer).write().to_buffered(&mut file).unwrap();
        file.into_inner()
    }

    fn planes(file: &[u8]) -> Option<Vec<Vec<f32>>> {
        let opened = ExrFile::open(file).ok()?;
        // Damage can take channels away; asking for one that is not there is a mistake of the caller.
        (opened.parts()[0].channels.len() >= 3).then(|| opened.planes(0, &[0, 1, 2]).ok()).flatten()
    }

    #[test]
    fn whole_blocks_are_read() {
        let planes = planes(&picture()).unwrap();
        // B, G, R by their names; lossy.
        assert!((planes[2][20] - 0.5).abs() < 0.02 && (planes[1][20 * 40] - 0.25).abs() < 0.02);
    }

    #[test]
    fn numbers_that_a_block_makes_up_are_refused() {
        let file = picture();
        let whole = planes(&file).unwrap();
        let mut refused = 0;
        for at in 0..file.len() {
            for (change, width) in [(0xff_u8, 1), (0xff, 5), (0x00, 1), (0x80, 1)] {
                let mut damaged = file.clone();
                let end = (at + width).min(file.len());
                damaged[at..end].fill(change);
                // No panic, and no memory beyond what the file can hold; what is read has the size of the picture.
                match planes(&damaged) {
                    None => refused += 1,
                    Some(planes) => assert_eq!(planes.len(), whole.len()),
                }
            }
        }
        assert!(refused > 100, "{refused}");
    }
}
