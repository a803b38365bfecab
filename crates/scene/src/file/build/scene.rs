//! A scene file as a whole, and its settings.

use super::builder::{Builder, in_order};
use crate::file::error::Problem;
use crate::file::tables::scene::SceneTable;
use crate::{Image, Light, LightColors, LightKind, RenderSettings};

impl Builder {
    /// Fills the scene.
    pub(crate) fn build(&mut self, table: &SceneTable) -> Result<(), Problem> {
        self.settings(table);
        self.looks(table)?;
        if let Some(ambient) = &table.ambient {
            let colors = LightColors::ambient(self.ambient(ambient)?);
            let light = Light::new(LightKind::Ambient, colors);
            self.scene.lights.push(Light { name: "ambient".to_owned(), ..light });
        }
        for light in &table.lights {
            let light = light.build(&light.span, self)?;
            self.scene.lights.push(light);
        }
        self.check_background(table.image.background.as_ref())?;
        self.named_textures(table)?;
        self.named_meshes(table)?;
        for (name, material) in in_order(&table.materials) {
            let built = self.material(name, material)?;
            self.names.materials.insert(name.clone(), self.scene.materials.len());
            self.scene.materials.push(built);
        }
        self.scene.program = table.program.as_ref().map(|program| self.program(program)).transpose()?;
        for object in &table.objects {
            self.object(object)?;
        }
        self.scene.photometric = self.one_kind_of_unit(table.render.photometric.as_ref())?;
        self.drop_unused_meshes();
        self.check_scales(table)?;
        self.remarks(table);
        // Last, since it may be a camera of an object's file.
        self.scene.camera = table.camera.as_ref().map(|camera| self.camera(camera)).transpose()?;
        Ok(())
    }

    fn settings(&mut self, table: &SceneTable) {
        self.scene.image = Image {
            width: table.image.width.0,
            height: table.image.height.0,
            samples: table.image.samples.0,
            supersample: table.image.supersample,
            background: table.image.background.as_ref().map_or(Image::default().background, |b| b.0),
        };
        self.scene.render = RenderSettings {
            shading: table.render.shading,
            interpolation: table.render.interpolation,
            show: table.render.show,
            tone_map: table.render.tone_map,
            ev: table.render.ev.map_or(0.0, |ev| ev.0),
            encoding: table.render.encoding,
            mode: table.render.mode.0,
            white: table.render.white.0,
            shadows: table.render.shadows,
            lighting: table.render.lighting,
            light_samples: table.render.light_samples.as_ref().map(|samples| samples.0),
            mistake: table.render.mistake,
        };
    }
}
