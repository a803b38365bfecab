//! What stands in for reader and writer where the crate is built without its feature `exr`.

use std::convert::Infallible;
use std::io::{Seek, Write};
use std::marker::PhantomData;

use super::{Attribute, ExrPart, ExrReadError, ExrWriteError, OFF};

/// An OpenEXR file, which needs the feature `exr`: without it there is none.
#[derive(Debug)]
pub struct ExrFile<'a> {
    never: Infallible,
    bytes: PhantomData<&'a [u8]>,
}

impl<'a> ExrFile<'a> {
    /// Reads the headers, with the feature `exr`.
    ///
    /// # Errors
    ///
    /// [`ExrReadError::FeatureOff`].
    pub fn open(_bytes: &'a [u8]) -> Result<Self, ExrReadError> {
        Err(OFF.into())
    }

    /// The parts, at least one.
    pub fn parts(&self) -> &[ExrPart] {
        match self.never {}
    }

    /// The names of all channels, as many as a message can bear.
    pub fn channel_names(&self) -> String {
        match self.never {}
    }

    /// The samples of some channels of a part.
    ///
    /// # Errors
    ///
    /// None: there is no such file.
    pub fn planes(self, _part: usize, _channels: &[usize]) -> Result<Vec<Vec<f32>>, ExrReadError> {
        match self.never {}
    }
}

/// Writes named planes, with the feature `exr`.
///
/// # Errors
///
/// [`ExrWriteError::FeatureOff`].
pub fn write_planes(
    _out: impl Write + Seek,
    _size: (usize, usize),
    _planes: impl IntoIterator<Item = (String, Vec<f32>)>,
    _attributes: &[(&str, Attribute)],
) -> Result<(), ExrWriteError> {
    Err(OFF.into())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::read::read_reradiation;

    #[test]
    fn errors_name_the_feature() {
        let expected = "OpenEXR: Glanz was built without the feature `exr`; add features = [\"exr\"]";
        assert_eq!(ExrFile::open(&[]).unwrap_err().to_string(), expected);
        let error = write_planes(std::io::Cursor::new(Vec::new()), (1, 1), [], &[]).unwrap_err();
        assert_eq!(error.to_string(), expected);
        let error = read_reradiation(&[0x76, 0x2f, 0x31, 0x01], "dye.exr").unwrap_err();
        assert_eq!(error.to_string(), format!("dye.exr: the file: {expected}"));
    }
}
