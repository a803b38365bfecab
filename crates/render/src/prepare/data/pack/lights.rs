//! Lights, luminaires, environments.

use std::sync::Arc;

use glanz_scene::{AreaShape, Space};

use super::{NO_RECORD, Packer, Section, place, short};
use crate::prepare::data::{
    EnvironmentChain, EnvironmentLight, EnvironmentMap, IntensityGrid, LightShape, PreparedLight,
    PreparedLuminaire,
};

/// The values of a light, each at 0 where its kind has none.
#[derive(Default)]
struct Values {
    position: [f64; 3],
    direction: [f64; 3],
    axes: [[f64; 3]; 3],
    fading: [f64; 3],
    cone: [f64; 4],
    size: [f64; 2],
}

impl Packer {
    pub(super) fn light(&mut self, light: &PreparedLight) {
        let camera = u32::from(light.space == Space::Camera);
        let (kind, flags, form) = kind(&light.shape);
        let row = self.lights_of_table;
        self.lights_of_table += light.shape.rows() as u32;
        let luminaire = light.luminaire.as_ref().map_or(NO_RECORD, |luminaire| self.luminaire(luminaire));
        let environment = match &light.shape {
            LightShape::Environment(environment) => self.environment(environment),
            _ => NO_RECORD,
        };
        self.words(Section::Lights, &[kind, camera | flags, form, row, luminaire, environment]);
        let Values { position, direction, axes, fading, cone, size } = values(&light.shape);
        let others = [direction.as_slice(), axes.as_flattened(), &fading, &cone, &size].concat();
        let others = others.iter().map(|x| *x as f32);
        self.floats(Section::LightValues, &place(position).into_iter().chain(others).collect::<Vec<_>>());
    }

    fn luminaire(&mut self, luminaire: &PreparedLuminaire) -> u32 {
        let first = self.once(&luminaire.intensities, |packer, grid: &IntensityGrid| {
            packer.floats(Section::Intensities, &grid.values)
        });
        self.floats(Section::LuminaireFrames, luminaire.frame.map(short).as_flattened());
        self.words(Section::Luminaires, &[first])
    }

    fn environment(&mut self, environment: &EnvironmentLight) -> u32 {
        let map = environment.map.as_ref().map_or(NO_RECORD, |map| self.map(map));
        let rotation = environment.rotation.map(short);
        let values = [environment.irradiance.terms.as_flattened(), rotation.as_flattened()].concat();
        self.floats(Section::EnvironmentValues, &values);
        let chain =
            environment.map.as_ref().and_then(|map| map.chain()).map_or(NO_RECORD, |chain| self.chain(chain));
        self.words(Section::Environments, &[map, chain])
    }

    fn chain(&mut self, chain: &EnvironmentChain) -> u32 {
        let first = self.next(Section::ChainLevels);
        let pixels = self.floats(Section::ChainPixels, chain.pixels.as_flattened());
        for level in &chain.levels {
            let own = pixels + level.first as u32;
            self.words(Section::ChainLevels, &[level.width as u32, level.height as u32, own]);
        }
        first
    }

    fn map(&mut self, map: &Arc<EnvironmentMap>) -> u32 {
        self.once(map, |packer, map| {
            let first = packer.floats(Section::Pixels, map.pixels.as_flattened());
            packer.words(Section::Maps, &[map.width as u32, map.height as u32, first])
        })
    }
}

/// Kind, flags and form of an area.
fn kind(shape: &LightShape) -> (u32, u32, u32) {
    let fades = |attenuation: &Option<[f64; 3]>| u32::from(attenuation.is_some()) << 1;
    match shape {
        LightShape::Directional { .. } => (0, 0, 0),
        LightShape::Point { attenuation, .. } => (1, fades(attenuation), 0),
        LightShape::Spot { attenuation, smooth_edge, .. } => {
            (2, fades(attenuation) | u32::from(smooth_edge.is_some()) << 2, 0)
        }
        LightShape::Area { form, two_sided, .. } => (
            3,
            u32::from(*two_sided) << 3,
            match form {
                AreaShape::Rectangle { .. } => 0,
                AreaShape::Disk { .. } => 1,
                AreaShape::Sphere { .. } => 2,
            },
        ),
        LightShape::Environment(_) => (4, 0, 0),
    }
}

fn values(shape: &LightShape) -> Values {
    let none = Values::default();
    match *shape {
        LightShape::Directional { towards } => Values { direction: towards, ..none },
        LightShape::Point { position, attenuation } => {
            Values { position, fading: attenuation.unwrap_or_default(), ..none }
        }
        LightShape::Spot { position, axis, cos_cutoff, exponent, smooth_edge, attenuation } => {
            let (inner, outer) = smooth_edge.unwrap_or_default();
            let cone = [cos_cutoff, exponent, inner, outer];
            Values { position, direction: axis, cone, fading: attenuation.unwrap_or_default(), ..none }
        }
        LightShape::Area { form, position, axes, .. } => {
            let size = match form {
                AreaShape::Rectangle { width, height } => [width, height],
                AreaShape::Disk { radius } | AreaShape::Sphere { radius } => [radius, 0.0],
            };
            Values { position, axes, size, ..none }
        }
        LightShape::Environment(_) => none,
    }
}
