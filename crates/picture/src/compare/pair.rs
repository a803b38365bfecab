//! Two pictures of one size.

use glanz_color::srgb_encode;

use super::rows::three_planes;
use super::{CompareError, Picture, Scale};

/// Two pictures of one size, on one scale.
#[derive(Clone, Debug)]
pub struct Pair {
    pub(super) width: usize,
    pub(super) height: usize,
    pub(super) scale: Scale,
    /// Linear light of the reference and of the other.
    pub(super) light: [[Vec<f32>; 3]; 2],
    /// sRGB codes of both, where the scale is that.
    pub(super) codes: Option<[[Vec<f32>; 3]; 2]>,
}

impl Pair {
    /// Two pictures, compared as light if both hold light and `as_shown` is false, else as a screen shows
    /// them: clipped to 0 … 1.
    pub fn new(reference: Picture, test: Picture, as_shown: bool) -> Result<Self, CompareError> {
        let size = |picture: &Picture| (picture.width, picture.height);
        if size(&reference) != size(&test) {
            return Err(CompareError::Sizes { reference: size(&reference), test: size(&test) });
        }
        let (width, height) = size(&reference);
        let is_light = !as_shown && [&reference, &test].iter().all(|picture| picture.scale == Scale::Light);
        let mut light = [reference.rgb, test.rgb];
        for plane in light.iter().flatten() {
            if plane.len() != width * height || plane.is_empty() {
                return Err(CompareError::Values { expected: width * height, found: plane.len() });
            }
        }
        if is_light {
            return Ok(Self { width, height, scale: Scale::Light, light, codes: None });
        }
        for value in light.iter_mut().flatten().flatten() {
            *value = value.clamp(0.0, 1.0);
        }
        let encode = |rgb: &[Vec<f32>; 3]| {
            three_planes(width, height, |i| [0, 1, 2].map(|channel: usize| srgb_encode(rgb[channel][i])))
        };
        let codes = Some([encode(&light[0]), encode(&light[1])]);
        Ok(Self { width, height, scale: Scale::Codes, light, codes })
    }

    /// Width and height in pixels.
    pub fn size(&self) -> (usize, usize) {
        (self.width, self.height)
    }

    /// Whether light or codes are compared.
    pub fn scale(&self) -> Scale {
        self.scale
    }

    /// Linear light of the reference and of the other picture, as it is compared.
    pub fn light(&self) -> &[[Vec<f32>; 3]; 2] {
        &self.light
    }

    /// What the scale says: codes or light.
    pub(super) fn values(&self) -> &[[Vec<f32>; 3]; 2] {
        self.codes.as_ref().unwrap_or(&self.light)
    }
}
