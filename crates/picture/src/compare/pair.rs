//! Two pictures of one size.

use core::ops::Range;
use std::borrow::Cow;

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
            return Ok(Self { width, height, scale: Scale::Light, light });
        }
        for value in light.iter_mut().flatten().flatten() {
            *value = value.clamp(0.0, 1.0);
        }
        Ok(Self { width, height, scale: Scale::Codes, light })
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

    /// What the scale says of these rows: codes or light. Codes are made anew each time: kept, they would double what a pair takes.
    pub(super) fn values(&self, rows: Range<usize>) -> [[Cow<'_, [f32]>; 3]; 2] {
        let pixels = rows.start * self.width..rows.end * self.width;
        self.light.each_ref().map(|rgb| match self.scale {
            Scale::Light => rgb.each_ref().map(|plane| Cow::Borrowed(&plane[pixels.clone()])),
            Scale::Codes => {
                let light = rgb.each_ref().map(|plane| &plane[pixels.clone()]);
                let encode = |i: usize| light.map(|plane| srgb_encode(plane[i]));
                three_planes(self.width, rows.len(), encode).map(Cow::Owned)
            }
        })
    }
}
