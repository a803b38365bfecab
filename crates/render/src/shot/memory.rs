//! What a picture takes of memory.

use glanz_picture::output::PictureKind;
use glanz_scene::ColorMode;

use super::{Shot, ShotError};

/// The least channels of a frame: three colours and alpha.
const CHANNELS: u64 = 4;
/// Depth, normal and object number.
const SURFACES: u64 = 5;
/// The wavelengths of a spectrum, and a picture to look at.
const SPECTRUM: u64 = glanz_color::SAMPLES as u64 + 2 * CHANNELS;

/// What the reference holds of a pixel while it sums: the frame of one wavelength, and a sum and a plane of each channel.
/// Measured: 44 bytes for three channels.
const REFERENCE: u64 = 4 * CHANNELS;
const REFERENCE_CHANNEL: u64 = 8 + 4;

impl Shot {
    /// That there is memory for a picture of this kind beside the scene. [`Shot::picture`] asks by itself.
    ///
    /// # Errors
    /// [`ShotError::Memory`].
    pub fn check_memory(&self, kind: PictureKind) -> Result<(), ShotError> {
        let (width, height) = (self.sight.view.width, self.sight.view.height);
        let more = (self.prepared.observation().channel_count() as u64).saturating_sub(3);
        // A frame that an eye looks at, or of more channels, is there beside what the screen shows of it.
        let is_frame = more > 0 || self.sight.seeing.is_some();
        let seen = if is_frame { CHANNELS + more } else { 0 };
        // Files of light hold the channels of an observer beside what the screen shows.
        let observer = self.prepared.observation().observer();
        let copies = observer.map_or(0, |_| CHANNELS + 3 + more);
        let (floats, codes, what) = match kind {
            // The codes, and rows on their way into the file. Measured: 7.1 bytes.
            PictureKind::Codes8 if !is_frame => (0, 8, "in 8 bits"),
            PictureKind::Codes8 => (CHANNELS + seen, 4, "in 8 bits"),
            PictureKind::Codes16 => (CHANNELS + seen, 8, "in 16 bits"),
            PictureKind::Light => (CHANNELS + SURFACES + more + copies.max(seen), 0, "of linear light"),
            PictureKind::Spectrum => (SPECTRUM, 0, "of spectra"),
        };
        let sums = match self.prepared.observation().mode() {
            ColorMode::Reference => REFERENCE + REFERENCE_CHANNEL * (more + 3),
            _ => 0,
        };
        let bytes = u64::from(width) * u64::from(height) * (4 * floats + codes + sums);
        self.memory.check(format_args!("a picture of {width}×{height} pixels {what}"), bytes)?;
        Ok(())
    }
}
