//! The planes of a picture.

/// The three channels of a picture of linear light.
pub(super) type Planes = [Vec<f32>; 3];

/// The channels of one pixel.
pub(super) fn pixel(planes: &Planes, i: usize) -> [f32; 3] {
    [planes[0][i], planes[1][i], planes[2][i]]
}
