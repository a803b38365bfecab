//! A number for all planes of a frame.

use glanz_render::Frame;

/// FNV-1a over the bits of every plane (Fowler, Noll and Vo 1991). All NaNs count as one.
pub(crate) fn of(frame: &Frame) -> u64 {
    let planes = frame.rgb.iter().chain(&frame.more).chain([&frame.alpha, &frame.depth]).chain(&frame.normal);
    let floats = planes.flatten().map(|value| if value.is_nan() { u32::MAX } else { value.to_bits() });
    let words = floats.chain(frame.object.iter().copied());
    words
        .flat_map(u32::to_le_bytes)
        .fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}
