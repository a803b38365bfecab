//! One pixel of a picture, taken apart.

use glanz_scene::ColorMode;

use super::{Shot, ShotError};
use crate::cpu::probe::{Probe, pixel_of, probe};
use crate::view::{Aovs, DebugView};

impl Shot {
    /// Takes a pixel of the picture apart: what is there, and what each light and each lobe gives.
    ///
    /// ```
    /// use glanz_render::Shot;
    /// use glanz_scene::{Light, Mesh, Scene, library};
    ///
    /// let scene = Scene::new()
    ///     .with_mesh(Mesh::builtin("sphere")?, library::material("gold")?)
    ///     .with_light(Light::directional([0.0, 0.0, -1.0], [1.0; 3]))
    ///     .with_size(33, 33);
    /// let probe = Shot::new(&scene)?.probe(16, 16)?;
    /// let surface = probe.surface.expect("the sphere is in the middle");
    /// let point = &surface.points[0];
    /// assert!(point.cos_view > 0.9 && point.lights[0].arrival.is_some());
    /// assert!((surface.light[0] - probe.middle[0]).abs() < 1e-5);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`ShotError::Pixel`] for a pixel that the picture does not have, [`ShotError::ByProgram`] for one that a program draws, [`ShotError::NoTable`] for pictures that are not made
    /// of the tint table, or not of light; else as [`Shot::frame`].
    pub fn probe(&mut self, x: u32, y: u32) -> Result<Probe, ShotError> {
        let (width, height) = (self.sight.view.width, self.sight.view.height);
        if x >= width || y >= height {
            return Err(ShotError::Pixel { x, y, width, height });
        }
        let is_table = self.prepared.observation().mode() != ColorMode::Reference;
        if !is_table || self.sight.draw.show != DebugView::Shaded {
            return Err(ShotError::NoTable);
        }
        let frame = self.frame_in_steps(Aovs::default(), &mut |_| ())?;
        let index = y as usize * frame.width + x as usize;
        let picture = frame.rgb.each_ref().map(|plane| plane[index]);
        let codes = self.codes8(frame.clone())?;
        let code = core::array::from_fn(|c| codes[4 * index + c]);
        let screen = self.on_screen(frame)?;
        let screen = screen.rgb.each_ref().map(|plane| plane[index]);
        let Self { prepared, sight, .. } = self;
        let (middle, surface) = probe(prepared, &sight.view, &sight.draw, (x, y));
        let object = surface.as_ref().and_then(|surface| prepared.objects.get(surface.object));
        if object.is_some_and(|object| object.program.is_some()) {
            return Err(ShotError::ByProgram { x, y });
        }
        Ok(Probe { pixel: (x, y), picture, screen, code, middle, surface })
    }

    /// The pixel in whose middle an object of that number shows the texture coordinates nearest to these, and those that it
    /// shows; `None` if the object is not seen, or has none.
    pub fn pixel_of(&self, object: usize, uv: [f32; 2]) -> Option<((u32, u32), [f32; 2])> {
        pixel_of(&self.prepared, &self.sight.view, object, uv)
    }
}
