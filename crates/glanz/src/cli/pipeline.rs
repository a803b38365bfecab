//! From a prepared scene to a picture.

use glanz_render::{
    Develop, DrawOptions, Frame, Layers, Prepared, View, develop, develop16, draw, draw_rgba8,
};
use glanz_scene::Camera;

use super::args::{CameraArgs, DevelopArgs, LookArgs};
use super::canvas::Canvas;
use super::difference::Developed;
use super::failure::Failure;
use super::frames::turned;
use super::load::Input;
use super::timings::{Stage, Timings};

/// What is kept of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// 8-bit codes.
    Codes8,
    /// 16-bit codes.
    Codes16,
    /// Linear light, with depth, normals and object numbers.
    Light,
}

/// A drawn picture.
#[derive(Clone, Debug)]
pub enum Picture {
    /// 8-bit codes.
    Codes8(Canvas),
    /// 16-bit codes, straight RGBA.
    Codes16 {
        /// Width in pixels.
        width: usize,
        /// Height in pixels.
        height: usize,
        /// `4·width·height` codes, rows from the top.
        rgba: Vec<u16>,
    },
    /// Linear light.
    Light(Frame),
}

/// How pictures of one prepared scene are made.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The camera.
    pub camera: Camera,
    /// Camera and size, as the rasteriser wants them.
    pub view: View,
    /// How to draw.
    pub options: DrawOptions,
    /// How to develop.
    pub develop: Develop,
}

impl Plan {
    /// How the pictures of `input` are made, in this size if not in the scene's own.
    pub fn new(
        input: &Input,
        size: Option<(u32, u32)>,
        look: &LookArgs,
        camera: &CameraArgs,
        develop: DevelopArgs,
    ) -> Result<Self, Failure> {
        let image = look.image(&input.scene, size);
        let camera = camera.resolve(input, (image.width, image.height))?;
        Ok(Self {
            view: View::new(&camera, image.width, image.height).map_err(Failure::new)?,
            camera,
            options: look.draw_options(&image, input.show)?,
            develop: develop.resolve(input)?,
        })
    }

    /// The same from a camera turned around its target, by a part of a full turn.
    pub fn turned(&self, part: f64) -> Result<Self, Failure> {
        let camera = turned(&self.camera, part);
        let view = View::new(&camera, self.view.width, self.view.height).map_err(Failure::new)?;
        Ok(Self { view, camera, ..self.clone() })
    }

    /// Draws a picture.
    pub fn picture(&self, prepared: &Prepared, kind: Kind, timings: &mut Timings) -> Picture {
        let (width, height) = (self.view.width as usize, self.view.height as usize);
        match kind {
            Kind::Codes8 => Picture::Codes8(self.codes(prepared, timings)),
            Kind::Codes16 => {
                let frame = timings.measure(Stage::Draw, || draw(prepared, &self.view, &self.options));
                let rgba = timings.measure(Stage::Develop, || develop16(&frame, &self.develop));
                Picture::Codes16 { width, height, rgba }
            }
            Kind::Light => {
                let layers = Layers { depth: true, normal: true, object: true };
                let options = DrawOptions { layers, ..self.options };
                Picture::Light(timings.measure(Stage::Draw, || draw(prepared, &self.view, &options)))
            }
        }
    }

    /// Draws straight into 8-bit codes; development is part of the drawing.
    pub fn codes(&self, prepared: &Prepared, timings: &mut Timings) -> Canvas {
        let (width, height) = (self.view.width as usize, self.view.height as usize);
        let mut rgba = vec![0; 4 * width * height];
        timings.measure(Stage::Draw, || {
            draw_rgba8(prepared, &self.view, &self.options, &self.develop, &mut rgba);
        });
        Canvas { width, height, rgba }
    }

    /// Draws linear light with object numbers, and develops it.
    pub fn developed(&self, prepared: &Prepared) -> Developed {
        let layers = Layers { object: true, ..Layers::default() };
        let frame = draw(prepared, &self.view, &DrawOptions { layers, ..self.options });
        let codes = develop(&frame, &self.develop);
        Developed { frame, codes }
    }

    /// The picture as a screen shows it.
    pub fn on_screen(&self, picture: &Picture) -> Canvas {
        match picture {
            Picture::Codes8(canvas) => canvas.clone(),
            Picture::Codes16 { width, height, rgba } => {
                let rgba = rgba.iter().map(|code| (code >> 8) as u8).collect();
                Canvas { width: *width, height: *height, rgba }
            }
            Picture::Light(frame) => {
                Canvas { width: frame.width, height: frame.height, rgba: develop(frame, &self.develop) }
            }
        }
    }
}
