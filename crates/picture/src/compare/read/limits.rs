//! How large a picture may be.

/// The widest and highest picture, in pixels.
pub const MAX_SIDE: usize = 16_384;
/// The most pixels of a picture: 8192×8192.
pub const MAX_PIXELS: usize = 1 << 26;
