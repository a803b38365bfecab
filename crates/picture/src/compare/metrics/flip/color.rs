//! The colour side of ꟻLIP: opponent channels, the space where distance is measured, the error 0 … 1.

use glanz_color::models::{D65_XYZ, RgbSpace};

/// The power of the distance; section 4.1.3 of the paper of 2020.
const Q_C: f32 = 0.7;
/// The part of the greatest distance up to which errors are stretched, and how far.
const P_C: f32 = 0.4;
const P_T: f32 = 0.95;
/// Where the cube root of CIELAB becomes a line: (6/29)³, of slope 1/(3 (6/29)²) from 4/29.
const EDGE: f32 = 6.0 / 29.0;

/// Linear RGB to XYZ relative to white.
const TO_XYZ: [[f32; 3]; 3] = relative_to_white();
/// The inverse.
const FROM_XYZ: [[f32; 3]; 3] = from_relative();

const fn relative_to_white() -> [[f32; 3]; 3] {
    let mut out = [[0.0; 3]; 3];
    let mut i = 0;
    while i < 9 {
        out[i / 3][i % 3] = (RgbSpace::LINEAR_SRGB.to_xyz_matrix().0[i / 3][i % 3] / D65_XYZ[i / 3]) as f32;
        i += 1;
    }
    out
}

const fn from_relative() -> [[f32; 3]; 3] {
    let mut out = [[0.0; 3]; 3];
    let mut i = 0;
    while i < 9 {
        out[i / 3][i % 3] = (RgbSpace::LINEAR_SRGB.from_xyz_matrix().0[i / 3][i % 3] * D65_XYZ[i % 3]) as f32;
        i += 1;
    }
    out
}

fn apply(matrix: &[[f32; 3]; 3], [a, b, c]: [f32; 3]) -> [f32; 3] {
    matrix.map(|row| row[0] * a + row[1] * b + row[2] * c)
}

/// Linear RGB in the opponent space Y Cx Cz, which is linear in light.
pub(super) fn to_ycxcz(rgb: [f32; 3]) -> [f32; 3] {
    let [x, y, z] = apply(&TO_XYZ, rgb);
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

/// A blurred colour of Y Cx Cz, cut to the gamut of sRGB, as L*, a*, b* in which a dark colour has less
/// chroma, as Hunt found.
pub(super) fn perceived([y, cx, cz]: [f32; 3]) -> [f32; 3] {
    let y = (y + 16.0) / 116.0;
    let rgb = apply(&FROM_XYZ, [y + cx / 500.0, y, y - cz / 200.0]);
    adjusted_lab(rgb.map(|channel| channel.clamp(0.0, 1.0)))
}

fn adjusted_lab(rgb: [f32; 3]) -> [f32; 3] {
    let root = |t: f32| match t > EDGE * EDGE * EDGE {
        true => libm::cbrtf(t),
        false => t / (3.0 * EDGE * EDGE) + 4.0 / 29.0,
    };
    let [x, y, z] = apply(&TO_XYZ, rgb).map(root);
    let lightness = 116.0 * y - 16.0;
    let hunt = 0.01 * lightness;
    [lightness, hunt * 500.0 * (x - y), hunt * 200.0 * (y - z)]
}

/// HyAB: differences in lightness and in chroma, summed (Abasi, Amani Tehran, Fairchild 2020).
fn hyab(first: [f32; 3], second: [f32; 3]) -> f32 {
    let [l, a, b] = core::array::from_fn(|i| first[i] - second[i]);
    l.abs() + (a * a + b * b).sqrt()
}

/// The error 0 … 1 between two colours as [`perceived`]: 1 for green and blue, the greatest distance in
/// the gamut. Small distances are stretched over most of the range.
pub(super) fn color_error(first: [f32; 3], second: [f32; 3]) -> f32 {
    let distance = hyab(first, second);
    if distance == 0.0 {
        return 0.0;
    }
    let (distance, greatest) = (libm::powf(distance, Q_C), greatest_distance());
    let bend = P_C * greatest;
    match distance < bend {
        true => P_T / bend * distance,
        false => (P_T + (distance - bend) / (greatest - bend) * (1.0 - P_T)).min(1.0),
    }
}

/// The distance of green and blue to the power of [`Q_C`].
fn greatest_distance() -> f32 {
    /// Kept, since it takes a power and two times three roots: [`hyab`] of the two is 308.2.
    static GREATEST: std::sync::LazyLock<f32> = std::sync::LazyLock::new(|| {
        libm::powf(hyab(adjusted_lab([0.0, 1.0, 0.0]), adjusted_lab([0.0, 0.0, 1.0])), Q_C)
    });
    *GREATEST
}
