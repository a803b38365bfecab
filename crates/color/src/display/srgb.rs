//! The transfer function of IEC 61966-2-1 (sRGB).

/// Linear light from an sRGB code value in 0 … 1. Odd-symmetric below zero.
pub fn srgb_decode(code: f32) -> f32 {
    let magnitude = f64::from(code.abs());
    let linear =
        if magnitude <= 0.04045 { magnitude / 12.92 } else { libm::pow((magnitude + 0.055) / 1.055, 2.4) };
    linear.copysign(f64::from(code)) as f32
}

/// Linear light from an 8-bit sRGB code value.
pub fn srgb_decode_u8(code: u8) -> f32 {
    srgb_decode(f32::from(code) / 255.0)
}

/// The sRGB code value of linear light. Odd-symmetric below zero, not clipped above one.
///
/// ```
/// use glanz_color::{srgb_decode_u8, srgb_encode};
///
/// // Middle grey, which reflects 18 %, and half of the light.
/// assert!((srgb_encode(0.18) - 0.4614).abs() < 1e-4 && (srgb_encode(0.5) - 0.7354).abs() < 1e-4);
/// assert!((srgb_decode_u8(128) - 0.2159).abs() < 1e-4);
/// ```
pub fn srgb_encode(linear: f32) -> f32 {
    let magnitude = f64::from(linear.abs());
    let code = if magnitude <= 0.003_130_8 {
        magnitude * 12.92
    } else {
        1.055 * libm::pow(magnitude, 1.0 / 2.4) - 0.055
    };
    code.copysign(f64::from(linear)) as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_8_bit_code_survives_the_round_trip() {
        for code in 0..=255u8 {
            let back = srgb_encode(srgb_decode_u8(code)) * 255.0;
            assert!((back - f32::from(code)).abs() < 1e-3);
        }
    }

    #[test]
    fn known_values() {
        assert!((srgb_encode(0.5) - 0.735_357).abs() < 1e-6);
        assert!((srgb_encode(0.18) - 0.461_356).abs() < 1e-6);
        assert!((srgb_decode_u8(128) - 0.215_861).abs() < 1e-6);
    }
}
