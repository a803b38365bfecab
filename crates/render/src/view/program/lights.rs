//! The scene's lights as programs of courses have them: places, directions, colours, how they fade.

use glam::DVec3;
use glanz_scene::{LightKind, Space as LightSpace};
use glanz_shader::{Role, Space};

use super::matrices::Matrices;
use crate::prepare::color::in_rgb;
use crate::prepare::{LightShape, Prepared, PreparedLight};
use crate::view::View;

/// A light that is far away is so many times as far as the scene is large.
const FAR: f64 = 1e3;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Directional,
    Point,
    Spot,
    Other,
}

/// A light in the world.
#[derive(Clone, Debug)]
struct ProgramLight {
    kind: Kind,
    position: DVec3,
    /// Unit vector towards it, or against its axis.
    towards: DVec3,
    attenuation: [f64; 3],
    cos_cutoff: f64,
    exponent: f64,
    ambient: [f64; 3],
    diffuse: [f64; 3],
    specular: [f64; 3],
}

/// All lights with a direction, and the sum of those without.
#[derive(Clone, Debug)]
pub(super) struct ProgramLights {
    list: Vec<ProgramLight>,
    ambient: [f64; 3],
}

impl ProgramLights {
    pub(super) fn new(prepared: &Prepared, view: &View) -> Self {
        let sources = &prepared.source.colors.lights;
        let size = prepared.objects.iter().fold(1.0_f64, |size, object| {
            let [low, high] = object.bounds.map(DVec3::from_array);
            size.max((DVec3::from_array(object.anchor)).length() + low.length().max(high.length()))
        });
        let directed = sources.iter().filter(|light| light.kind != LightKind::Ambient);
        // What shines from more than one direction is nothing that these programs know.
        let punctual = prepared.lights.iter().zip(directed).filter(|(light, _)| light.shape.is_punctual());
        let list = punctual.map(|(light, source)| {
            let [ambient, diffuse, specular] =
                [&source.colors.ambient, &source.colors.diffuse, &source.colors.specular].map(in_rgb::light);
            ProgramLight { ambient, diffuse, specular, ..geometry(light, view, FAR * size) }
        });
        let undirected = sources.iter().filter(|light| light.kind == LightKind::Ambient);
        let ambient = undirected.fold([0.0; 3], |sum, light| {
            let own = in_rgb::light(&light.colors.ambient);
            core::array::from_fn(|c| sum[c] + own[c])
        });
        Self { list: list.collect(), ambient }
    }

    /// What a role of a light is; what there is no light for is dark.
    pub(super) fn of(&self, role: Role, name: &str, space: Space, matrices: &Matrices) -> Option<Vec<f64>> {
        let light = self.named(name);
        if light.is_none() {
            return self.of_none(role, name);
        }
        let light = light?;
        let rgb = |color: [f64; 3]| vec![color[0], color[1], color[2], 1.0];
        Some(match role {
            Role::LightCount => vec![self.list.len() as f64],
            Role::LightPosition if light.kind == Kind::Directional && wants_direction(name) => {
                matrices.direction(light.towards, space).to_vec()
            }
            Role::LightPosition => matrices.point(light.position, space).to_vec(),
            Role::LightDirection => {
                // A member is the way of the light, as in OpenGL; a name by itself mostly leads to the light.
                let sign = if name.contains('.') { -1.0 } else { 1.0 };
                matrices.direction(light.towards * sign, space).to_vec()
            }
            Role::LightColor => rgb(light.diffuse),
            Role::LightSpecular => rgb(light.specular),
            // Light from everywhere is told once, with the first of them.
            Role::LightAmbient if self.is_first(light) => {
                rgb(core::array::from_fn(|c| light.ambient[c] + self.ambient[c]))
            }
            Role::LightAmbient => rgb(light.ambient),
            Role::AttenuationConstant => vec![light.attenuation[0]],
            Role::AttenuationLinear => vec![light.attenuation[1]],
            Role::AttenuationQuadratic => vec![light.attenuation[2]],
            Role::SpotDirection => matrices.direction(-light.towards, space).to_vec(),
            Role::SpotCutoff if light.kind != Kind::Spot => vec![180.0],
            Role::SpotCutoff => vec![libm::acos(light.cos_cutoff).to_degrees()],
            Role::SpotCosCutoff => vec![light.cos_cutoff],
            Role::SpotExponent => vec![light.exponent],
            _ => return None,
        })
    }

    /// Where there is no such light: as if it were there and dark.
    fn of_none(&self, role: Role, name: &str) -> Option<Vec<f64>> {
        let [r, g, b] = self.ambient;
        Some(match role {
            Role::LightCount => vec![self.list.len() as f64],
            Role::LightAmbient if self.list.is_empty() && index_of(name) == 0 => vec![r, g, b, 1.0],
            Role::LightPosition | Role::LightDirection | Role::SpotDirection => vec![0.0, 1.0, 0.0, 0.0],
            Role::LightColor | Role::LightSpecular | Role::LightAmbient => vec![0.0, 0.0, 0.0, 1.0],
            Role::AttenuationConstant => vec![1.0],
            Role::SpotCutoff => vec![180.0],
            Role::SpotCosCutoff => vec![-1.0],
            Role::AttenuationLinear | Role::AttenuationQuadratic | Role::SpotExponent => vec![0.0],
            _ => return None,
        })
    }

    fn is_first(&self, light: &ProgramLight) -> bool {
        self.list.first().is_some_and(|first| core::ptr::eq(first, light))
    }

    /// The light that a name means: `lights[2].position` the third, `pointLights[0]` the first of that kind.
    fn named(&self, name: &str) -> Option<&ProgramLight> {
        let words = name.to_ascii_lowercase();
        let kind = if words.contains("pointlight") {
            Some(Kind::Point)
        } else if words.contains("spotlight") {
            Some(Kind::Spot)
        } else {
            (words.contains("dirlight") || words.contains("directionallight")).then_some(Kind::Directional)
        };
        self.list.iter().filter(|light| kind.is_none_or(|kind| light.kind == kind)).nth(index_of(name))
    }
}

/// The last index of a path, 0 without any.
fn index_of(name: &str) -> usize {
    let last = name.rsplit_once('[').and_then(|(_, rest)| rest.split_once(']'));
    last.and_then(|(index, _)| index.parse().ok()).unwrap_or(0)
}

/// Whether a place of four numbers may also be a direction, whose fourth is 0.
fn wants_direction(name: &str) -> bool {
    let name = name.to_ascii_lowercase();
    name.contains("posdir") || name.ends_with(".position")
}

/// Where a light's own directions and places are in the world.
struct Placed<'a> {
    view: &'a View,
    space: LightSpace,
}

impl Placed<'_> {
    fn direction(&self, d: [f64; 3]) -> DVec3 {
        let axes = self.view.axes.map(DVec3::from_array);
        match self.space {
            LightSpace::World => DVec3::from_array(d),
            LightSpace::Camera => axes[0] * d[0] + axes[1] * d[1] + axes[2] * d[2],
        }
    }

    fn point(&self, p: [f64; 3]) -> DVec3 {
        match self.space {
            LightSpace::World => DVec3::from_array(p),
            LightSpace::Camera => DVec3::from_array(self.view.eye) + self.direction(p),
        }
    }
}

/// A light without a place, far above.
fn plain(far: f64) -> ProgramLight {
    ProgramLight {
        kind: Kind::Other,
        position: DVec3::Y * far,
        towards: DVec3::Y,
        attenuation: [1.0, 0.0, 0.0],
        cos_cutoff: -1.0,
        exponent: 0.0,
        ambient: [0.0; 3],
        diffuse: [0.0; 3],
        specular: [0.0; 3],
    }
}

fn geometry(light: &PreparedLight, view: &View, far: f64) -> ProgramLight {
    let (placed, plain) = (Placed { view, space: light.space }, plain(far));
    match &light.shape {
        LightShape::Directional { towards } => {
            let towards = placed.direction(*towards);
            ProgramLight { kind: Kind::Directional, position: towards * far, towards, ..plain }
        }
        LightShape::Point { position, attenuation } => {
            let position = placed.point(*position);
            let attenuation = attenuation.unwrap_or(plain.attenuation);
            let towards = position.normalize_or(DVec3::Y);
            ProgramLight { kind: Kind::Point, position, towards, attenuation, ..plain }
        }
        LightShape::Spot { position, axis, cos_cutoff, exponent, attenuation, .. } => ProgramLight {
            kind: Kind::Spot,
            position: placed.point(*position),
            towards: -placed.direction(*axis),
            attenuation: attenuation.unwrap_or(plain.attenuation),
            cos_cutoff: *cos_cutoff,
            exponent: *exponent,
            ..plain
        },
        LightShape::Area { position, axes, .. } => {
            ProgramLight { position: placed.point(*position), towards: -placed.direction(axes[2]), ..plain }
        }
        LightShape::Environment(_) => plain,
    }
}
