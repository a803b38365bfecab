//! Remarks on pictures that programs draw.

use std::collections::BTreeSet;

use glanz_scene::DebugView;
use glanz_shader::{Program, Role, Source, TextureInfo};

use super::{Remark, RemarkKind, Shot, ShotError};
use crate::cpu::inspect_colors;
use crate::prepare::PreparedProgram;
use crate::view::program::{has_picture, is_cube, is_flat};

impl Shot {
    /// Whether programs draw everything.
    pub(super) fn is_drawn_by_programs(&self) -> bool {
        let objects = &self.prepared.objects;
        self.sight.draw.show == DebugView::Shaded
            && !objects.is_empty()
            && objects.iter().all(|object| object.program.is_some())
    }

    /// What nobody sets, and what is not a number.
    pub(super) fn program_remarks(&mut self) -> Result<Vec<Remark>, ShotError> {
        let mut texts = BTreeSet::new();
        if self.sight.draw.show == DebugView::Shaded {
            for object in &self.prepared.objects {
                let Some(program) = object.program.and_then(|own| self.prepared.programs.get(own)) else {
                    continue;
                };
                let material = &self.prepared.materials[object.material];
                texts.extend(unset(program, &|texture| has_picture(texture, &self.prepared, material)));
                texts.extend(self.unknown_lights(program));
            }
        }
        let mut remarks: Vec<_> =
            texts.into_iter().map(|text| Remark::new(RemarkKind::Program, text)).collect();
        if let Some(text) = self.not_numbers()? {
            remarks.push(Remark::new(RemarkKind::Program, text));
        }
        Ok(remarks)
    }

    /// That a program takes lights, and knows nothing of some.
    fn unknown_lights(&self, program: &PreparedProgram) -> Option<String> {
        let pair = &program.pair;
        let takes = |stage: &Program| {
            let uniforms = stage.interface().uniforms.iter();
            uniforms
                .filter_map(|own| own.role)
                .any(|role| matches!(role, Role::LightPosition | Role::LightDirection))
        };
        let left_out = self.prepared.lights.iter().filter(|light| !light.shape.is_punctual()).count();
        (left_out > 0 && (takes(&pair.vertex) || takes(&pair.fragment))).then(|| {
            let lights = if left_out == 1 { "light" } else { "lights" };
            format!("programs know lights that shine from one point or direction: {left_out} {lights} with an area or around all are left out")
        })
    }

    /// How many pixels are not a number, in a picture of one sample for each.
    fn not_numbers(&mut self) -> Result<Option<String>, ShotError> {
        if self.prepared.objects.iter().all(|object| object.program.is_none()) {
            return Ok(None);
        }
        let frame = inspect_colors(&self.prepared, &self.sight.view, &self.sight.draw);
        let is_odd = |at: &usize| frame.rgb.iter().any(|plane| !plane[*at].is_finite());
        let mut odd = (0..frame.width * frame.height).filter(is_odd);
        let Some(first) = odd.next() else { return Ok(None) };
        let (x, y) = (first % frame.width, first / frame.width);
        let count = 1 + odd.count();
        let (pixels, are) = if count == 1 { ("pixel", "is") } else { ("pixels", "are") };
        Ok(Some(format!(
            "{count} {pixels} {are} not finite, the first is {x},{y}: `glanz shader xray … --pixel {x},{y}` tells which \
             value is so first"
        )))
    }
}

/// Uniforms and pictures that neither the user nor the host sets.
fn unset(program: &PreparedProgram, has_picture: &dyn Fn(&TextureInfo) -> bool) -> Vec<String> {
    let pair = &program.pair;
    let stages = [(&pair.vertex, pair.vertex_source), (&pair.fragment, pair.fragment_source)];
    let own = stages.into_iter().filter(|(_, source)| *source == Source::Own);
    own.flat_map(|(stage, _)| unset_of(stage, program, has_picture)).collect()
}

fn unset_of(
    stage: &Program,
    program: &PreparedProgram,
    has_picture: &dyn Fn(&TextureInfo) -> bool,
) -> Vec<String> {
    let set = &program.source.uniforms;
    let is_set = |name: &str| {
        set.keys()
            .any(|own| own == name || name.strip_prefix(&**own).is_some_and(|rest| rest.starts_with('[')))
    };
    let values = stage.uniforms();
    let is_zero = |name: &str| values.get(name).is_none_or(|own| own.iter().all(|value| *value == 0.0));
    let mut texts = Vec::new();
    for uniform in &stage.interface().uniforms {
        if uniform.role.is_none() && !is_set(&uniform.name) && is_zero(&uniform.name) {
            let name = &uniform.name;
            texts.push(format!("nobody sets the uniform '{name}', so it is 0: --uniform {name}=… sets it"));
        }
    }
    for texture in &stage.interface().textures {
        let name = &texture.name;
        let is_set = set.get(name).is_some_and(|value| !value.textures().is_empty());
        if is_set || has_picture(texture) {
            continue;
        }
        texts.push(if is_cube(texture) {
            format!(
                "nobody gives the sampler '{name}' a cube map, so it is black: --uniform {name}=FILE does, with a panorama, \
                 or {name}=sky_*.png with six faces"
            )
        } else if is_flat(texture) {
            format!("nobody gives the sampler '{name}' a picture, so it is black: --uniform {name}=FILE does")
        } else {
            format!("the sampler '{name}' is black: only sampler2D, sampler2DShadow and samplerCube are given pictures")
        });
    }
    texts
}
