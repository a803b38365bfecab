//! From an observer's channels to linear sRGB.

use glanz_color::Matrix3;

use crate::Meaning;

/// A linear map from three channels to linear sRGB, white adaptation included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScreenMatrix {
    /// What the channels are.
    pub from: Meaning,
    /// By rows.
    pub rows: [[f32; 3]; 3],
}

/// A linear map from any number of channels to linear sRGB, white adaptation included.
///
/// Colours outside of the screen's gamut get components below 0 or above 1; they are clipped when codes
/// are made, and kept in linear pictures.
///
/// ```
/// use glanz_picture::{Meaning, ToScreen};
///
/// // An eye with one channel, which a screen shows as grey.
/// let gray = ToScreen::of_columns(Meaning::Receptors, [[1.0, 1.0, 1.0]].into_iter());
/// assert_eq!(gray.apply([0.5].into_iter()), [0.5, 0.5, 0.5]);
/// let [channel, ..] = gray.channels_of([0.25, 0.25, 0.25]);
/// assert!((channel - 0.25).abs() < 1e-6);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ToScreen {
    /// What the channels are.
    from: Meaning,
    /// The linear sRGB of one unit of each channel.
    columns: Vec<[f64; 3]>,
}

impl ToScreen {
    /// From three channels.
    pub fn of_matrix(from: Meaning, matrix: Matrix3) -> Self {
        Self { from, columns: matrix.transposed().0.to_vec() }
    }

    /// From the linear sRGB of one unit of each channel.
    pub fn of_columns(from: Meaning, columns: impl Iterator<Item = [f64; 3]>) -> Self {
        Self { from, columns: columns.collect() }
    }

    /// What the channels are that it takes to the screen.
    pub fn from(&self) -> Meaning {
        self.from
    }

    /// The linear sRGB of one unit of each channel.
    pub(super) fn columns(&self) -> &[[f64; 3]] {
        &self.columns
    }

    /// The matrix for a frame of three channels, of which those that the observer does not have count for
    /// nothing.
    ///
    /// None for more than three channels, which no single frame holds.
    pub fn matrix(&self) -> Option<ScreenMatrix> {
        if self.columns.len() > 3 {
            return None;
        }
        let column = |c: usize| self.columns.get(c).copied().unwrap_or_default();
        let rows = core::array::from_fn(|row| core::array::from_fn(|c| column(c)[row] as f32));
        Some(ScreenMatrix { from: self.from, rows })
    }

    /// The linear sRGB of the channels of one pixel.
    pub fn apply(&self, channels: impl Iterator<Item = f32>) -> [f32; 3] {
        let mut rgb = [0.0; 3];
        for (column, value) in self.columns.iter().zip(channels) {
            rgb.iter_mut().zip(column).for_each(|(sum, c)| *sum += c * f64::from(value));
        }
        rgb.map(|c| c as f32)
    }

    /// The channels that show as this linear sRGB, or as near to it as up to three channels can: one channel
    /// shows its luminance. Channels beyond the third are left at 0.
    pub fn channels_of(&self, rgb: [f32; 3]) -> [f32; 3] {
        let wanted = rgb.map(f64::from);
        let channels = match *self.columns {
            [only] => {
                let luminance = |[r, g, b]: [f64; 3]| 0.2126 * r + 0.7152 * g + 0.0722 * b;
                [luminance(wanted) / luminance(only), 0.0, 0.0]
            }
            [a, b] => {
                let [aa, ab, bb] = [dot(a, a), dot(a, b), dot(b, b)];
                let (a, b) = (dot(a, wanted), dot(b, wanted));
                let by = 1.0 / (aa * bb - ab * ab);
                [(a * bb - b * ab) * by, (b * aa - a * ab) * by, 0.0]
            }
            [a, b, c, ..] => Matrix3::from_columns([a, b, c]).inverse().apply(wanted),
            [] => wanted,
        };
        if channels.iter().all(|c| c.is_finite()) { channels.map(|c| c as f32) } else { rgb }
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    const M: Matrix3 = Matrix3([[1.0, 2.0, 0.0], [0.0, 0.5, 0.25], [-1.0, 0.0, 4.0]]);

    #[test]
    fn a_frames_matrix_has_the_columns_of_the_channels() {
        let map = ToScreen::of_matrix(Meaning::Xyz, M);
        assert_eq!(
            map.matrix().map(|map| map.rows),
            Some([[1.0, 2.0, 0.0], [0.0, 0.5, 0.25], [-1.0, 0.0, 4.0]])
        );
        assert_eq!(map.apply([1.0, 10.0, 100.0].into_iter()), [21.0, 30.0, 399.0]);
        assert_eq!(map.channels_of(map.apply([3.0, 2.0, 1.0].into_iter())), [3.0, 2.0, 1.0]);
    }

    #[test]
    fn one_channel_is_a_gray_and_five_need_more_than_a_frame() {
        let gray = ToScreen::of_columns(Meaning::Receptors, [[1.0; 3]].into_iter());
        assert_eq!(gray.matrix().map(|map| map.rows), Some([[1.0, 0.0, 0.0]; 3]));
        assert!((gray.channels_of([1.0, 0.0, 0.0])[0] - 0.2126).abs() < 1e-7, "red as a grey");
        let two = ToScreen::of_columns(Meaning::Receptors, [[1.0, 0.0, 0.0], [1.0, 1.0, 1.0]].into_iter());
        assert_eq!(two.channels_of([0.75, 0.25, 0.25]), [0.5, 0.25, 0.0]);
        assert_eq!(ToScreen::of_columns(Meaning::Receptors, [[1.0; 3]; 5].into_iter()).matrix(), None);
    }
}
