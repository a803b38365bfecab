//! Tables of factors as files beside a scene file: a line that says what it is, sizes and ranks as `u32`, then the factors
//! of each node as `f32`, little-endian.

use glanz_bsdf::FactorTable;

const HEAD: &[u8] = b"glanz factors 1\n";

/// Numbers before the factors.
const COUNTS: usize = 5;

/// The file of a table.
pub(super) fn bytes(table: &FactorTable) -> Vec<u8> {
    let counts = table.sizes().into_iter().chain([table.ranks()]).map(|count| count as u32);
    let words = counts.chain(table.values().into_iter().map(f32::to_bits));
    HEAD.iter().copied().chain(words.flat_map(u32::to_le_bytes)).collect()
}

/// The table of a file.
pub(super) fn table(bytes: &[u8]) -> Result<FactorTable, String> {
    let rest =
        bytes.strip_prefix(HEAD).ok_or("it is no table of factors, which begins with 'glanz factors 1'")?;
    let (words, after) = rest.as_chunks::<4>();
    let numbers: Vec<u32> = words.iter().map(|word| u32::from_le_bytes(*word)).collect();
    let (Some((counts, values)), []) = (numbers.split_at_checked(COUNTS), after) else {
        return Err(format!("a table of factors ends after {} bytes", bytes.len()));
    };
    let [x, y, z, w, ranks] = core::array::from_fn(|i| counts[i] as usize);
    let values = values.iter().map(|bits| f32::from_bits(*bits)).collect();
    FactorTable::new([x, y, z, w], ranks, values).map_err(|error| error.to_string())
}
