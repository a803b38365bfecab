//! Materials.

use std::ops::Range;

use glanz_bsdf::{LightTerm, MODELS};

use super::layers::transmittance;
use crate::file::build::builder::Builder;
use crate::file::error::Problem;
use crate::file::near::{did_you_mean, list};
use crate::file::tables::appearance::materials::{AlphaModeName, MaterialTable, highlight_names};
use crate::file::tables::appearance::measured::MeasuredTable;
use crate::file::tables::colors::ColorValue;
use crate::file::tables::values::At;
use crate::{AlphaMode, ClassicMaterial, Lobe, Material, Tint};

impl Builder {
    pub(in crate::file::build) fn material(
        &mut self,
        name: &str,
        table: &MaterialTable,
    ) -> Result<Material, Problem> {
        self.made.channels.clear();
        let mut material = table.build(name, self)?;
        if let (Some(library), Some(_)) = (&table.library, &table.base_color_texture)
            && !material.lobes.iter().any(|lobe| lobe.textured)
        {
            let library = &library.value;
            self.input.notes.push(format!(
                "material '{name}': no term of '{library}' takes a texture; only the texture's alpha counts"
            ));
        }
        material.base_color = self.texture_use(table.base_color_texture.as_ref(), true)?;
        material.normal_map = self.texture_use(table.normal_texture.as_ref(), false)?;
        material.metal_rough_map = self.texture_use(table.metal_rough_texture.as_ref(), false)?;
        material.emission_map = self.texture_use(table.emission_texture.as_ref(), true)?;
        if let Some(occlusion) = &table.occlusion_texture {
            let glows = |lobe: &Lobe| lobe.textured && lobe.shape.info().term == LightTerm::Emission;
            if material.lobes.iter().any(glows) {
                return Err(Problem::at(
                    &occlusion.span,
                    "'occlusion_texture' beside light of its own that is 'textured'",
                ));
            }
            material.occlusion = Some(self.mask(occlusion)?);
        }
        Ok(material)
    }
}

fn place<T>(value: &Option<At<T>>) -> Option<&Range<usize>> {
    value.as_ref().map(|v| &v.span)
}

impl MaterialTable {
    /// The material without its textures.
    pub(crate) fn build(&self, name: &str, builder: &mut Builder) -> Result<Material, Problem> {
        let mut material = self.surface(name, builder)?;
        self.add_transmittance(&mut material, name, builder)?;
        if let Some(coat) = &self.coat {
            if material.transmittance.is_some() {
                return Err(Problem::at(
                    &coat.span,
                    "a 'coat' over a surface with a transmittance: give the 'pane' its colour instead",
                ));
            }
            material = coat.build(material, builder, &coat.span)?;
        }
        // An oblique grain of measured reflectance is turned with the sample.
        material.aniso = if self.measured.is_some() { material.aniso } else { 0.0 } + self.aniso()?;
        material.name = self.name.clone().unwrap_or_else(|| name.to_owned());
        material.two_sided = self.two_sided;
        material.cull_back = self.cull_back;
        material.opacity = self.opacity(name, builder)?.map_or(1.0, |opacity| opacity as f32);
        material.alpha_mode = self.alpha_mode(material.opacity)?;
        Ok(material)
    }

    /// The lobes: those of a material of the library, those that are listed, or the classic terms.
    fn surface(&self, name: &str, builder: &mut Builder) -> Result<Material, Problem> {
        if let Some(measured) = &self.measured {
            return self.measured(name, measured, builder);
        }
        match (&self.library, &self.lobes) {
            (Some(library), _) => {
                self.refuse_terms(library)?;
                self.refuse_others(name)?;
                Ok(Material { name: name.to_owned(), ..builder.library_material(library)? })
            }
            (None, Some(lobes)) => {
                self.refuse_classic_keys()?;
                self.refuse_others(name)?;
                let lobes = lobes.iter().map(|lobe| lobe.build(builder)).collect::<Result<_, _>>()?;
                Ok(Material::of_lobes(name, lobes))
            }
            (None, None) => self.classic(name, builder),
        }
    }

    /// Measured reflectance, and the lobes that are listed beside it.
    fn measured(
        &self,
        name: &str,
        measured: &At<MeasuredTable>,
        builder: &mut Builder,
    ) -> Result<Material, Problem> {
        let others = self.classic_keys().into_iter().chain([("library", place(&self.library))]);
        if let Some((key, span)) = others.into_iter().find_map(|(key, span)| Some((key, span?))) {
            return Err(Problem::at(span, format!("'{key}' beside 'measured'"))
                .help("terms beside measured reflectance are 'lobes'"));
        }
        self.refuse_others(name)?;
        let Material { mut lobes, aniso, .. } = measured.build(name, builder)?;
        for lobe in self.lobes.iter().flat_map(|lobes| &lobes.value) {
            lobes.push(lobe.build(builder)?);
        }
        Ok(Material { aniso, ..Material::of_lobes(name, lobes) })
    }

    /// What passes through: a pane, or a transmittance by itself.
    fn add_transmittance(
        &self,
        material: &mut Material,
        name: &str,
        builder: &mut Builder,
    ) -> Result<(), Problem> {
        if let Some(pane) = &self.pane {
            pane.build(material, builder, &pane.span)?;
        }
        if let Some(value) = self.transmittance(name, builder)? {
            if let Some(pane) = &self.pane {
                let message = "'pane' beside 'transmittance': a pane has its own";
                return Err(Problem::at(&pane.span, message));
            }
            material.transmittance = Some(transmittance(value, builder)?);
        }
        Ok(())
    }

    /// The angle of anisotropy, in radians.
    fn aniso(&self) -> Result<f64, Problem> {
        if let (Some(_), Some(radians)) = (&self.aniso_deg, &self.aniso_rad) {
            return Err(Problem::at(&radians.span, "'aniso_rad' beside 'aniso_deg'"));
        }
        let radians = self.aniso_rad.as_ref().map_or(0.0, |angle| angle.0);
        Ok(self.aniso_deg.map_or(radians, |angle| angle.0.to_radians()))
    }

    fn transmittance(&self, name: &str, builder: &mut Builder) -> Result<Option<&At<ColorValue>>, Problem> {
        if let (Some(_), Some(old)) = (&self.transmittance, &self.see_through) {
            return Err(Problem::at(
                &old.span,
                "'see_through' beside 'transmittance', which is its new name",
            ));
        }
        if self.see_through.is_some() {
            builder.input.notes.push(format!("material '{name}': 'see_through' is now 'transmittance'"));
        }
        Ok(self.transmittance.as_ref().or(self.see_through.as_ref()))
    }

    fn alpha_mode(&self, opacity: f32) -> Result<AlphaMode, Problem> {
        let translucent = opacity < 1.0;
        let default = if translucent { AlphaModeName::Blend } else { AlphaModeName::Opaque };
        let mode = self.alpha_mode.unwrap_or(default);
        if let (Some(cutoff), false) = (&self.alpha_cutoff, mode == AlphaModeName::Mask) {
            return Err(Problem::at(&cutoff.span, "'alpha_cutoff' needs alpha_mode = \"mask\""));
        }
        Ok(match mode {
            AlphaModeName::Opaque => AlphaMode::Opaque,
            AlphaModeName::Blend => AlphaMode::Blend,
            AlphaModeName::Mask => {
                AlphaMode::Mask { cutoff: self.alpha_cutoff.as_ref().map_or(0.5, |c| c.0 as f32) }
            }
        })
    }

    fn classic(&self, name: &str, builder: &mut Builder) -> Result<Material, Problem> {
        let mut tint = |color: &Option<At<ColorValue>>| {
            color.as_ref().map_or(Ok(Tint::BLACK), |color| builder.tint(color))
        };
        let defaults = ClassicMaterial::default();
        let mut classic = ClassicMaterial {
            ambient: tint(&self.ambient)?,
            diffuse: tint(&self.diffuse)?,
            specular: tint(&self.specular)?,
            emission: self.emission.as_ref().map_or(Ok(Tint::BLACK), |color| builder.emission(color))?,
            shininess: self.shininess.as_ref().map_or(defaults.shininess, |s| s.0),
            model: self.model.as_ref().map_or(defaults.model, |m| m.value.clone()),
            parameters: Vec::new(),
        };
        if let Some(model) = &self.model {
            let Some(info) =
                MODELS.iter().find(|info| highlight_names().any(|n| n == info.name && n == **model))
            else {
                let near = did_you_mean(model, highlight_names());
                let known = format!("the models are: {}", list(highlight_names()));
                return Err(
                    Problem::at(&model.span, format!("unknown model '{}'{near}", model.value)).help(known)
                );
            };
            if info.term != LightTerm::Specular && !classic.specular.is_black() {
                classic.specular = Tint::BLACK;
                builder.input.notes.push(format!(
                    "material '{name}': '{}' has no highlight; 'specular' is not used",
                    info.name
                ));
            }
        }
        classic.parameters = self.parameters(name, &classic.model)?;
        classic.build(name).map_err(|error| Problem {
            span: self.place_of(&error).cloned(),
            message: error.to_string(),
            help: None,
        })
    }

    fn classic_keys(&self) -> [(&'static str, Option<&Range<usize>>); 6] {
        [
            ("model", place(&self.model)),
            ("ambient", place(&self.ambient)),
            ("diffuse", place(&self.diffuse)),
            ("specular", place(&self.specular)),
            ("emission", place(&self.emission)),
            ("shininess", place(&self.shininess)),
        ]
    }

    /// That nothing stands beside `library` that would say again what the material is made of.
    fn refuse_terms(&self, library: &At<String>) -> Result<(), Problem> {
        let others = [
            ("lobes", place(&self.lobes)),
            ("pane", place(&self.pane)),
            ("transmittance", place(&self.transmittance)),
            ("see_through", place(&self.see_through)),
        ];
        match self.classic_keys().into_iter().chain(others).find_map(|(key, span)| Some((key, span?))) {
            Some((key, span)) => {
                let name = &library.value;
                let help = format!(
                    "`glanz material show {name}` prints the keys of '{name}', to be changed in its place"
                );
                Err(Problem::at(span, format!("'{key}' beside 'library'")).help(help))
            }
            None => Ok(()),
        }
    }

    fn refuse_classic_keys(&self) -> Result<(), Problem> {
        match self.classic_keys().into_iter().find_map(|(key, span)| Some((key, span?))) {
            Some((key, span)) => {
                let help = "give the classic block or the lobes; a term such as 'ambient' is a lobe too";
                Err(Problem::at(span, format!("'{key}' beside 'lobes'")).help(help))
            }
            None => Ok(()),
        }
    }
}
